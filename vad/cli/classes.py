"""The verbs for a class: sheets by the hundred, and question banks."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

import vad
from vad.cli import completion
from vad.cli.groups import HelpfulCommand
from vad.cli.options import burden_options, given_burden, path
from vad.cli.output import progress, say_written
from vad.cli.process import say
from vad.errors import UsageError

_Command = TypeVar("_Command", bound=Callable[..., Any])
_HELP = """\
Make problem sheets for a class, each with its key.

SHEETS is a .csv file with one row a sheet, or a .toml file such as

\b
  [sheet]
  mechanism = "four-bar"               # or a .toml file that lies beside this one
  count = 30
  files = ["problem.pdf", "key.pdf"]   # also png, svg, json, mp4, gif
  blank = ["velocity", "acceleration"]
  [vary]
  crank = { share = 0.25 }             # nice numbers about the default
  angle = { from = 0, to = 355, step = 5 }
  omega = ["60 rpm", "90 rpm"]
  [keep]
  sine = 0.35                          # sine of the least angle at which lines cross

[sheet] also takes title, subtitle, seed, panels, points, language, style, paper, size, fps,
speed, length_unit, and load, mass, inertia, gravity, friction, superpose, as these options
have them.
A column of a .csv file that is no option, such as name, is part of a roster: its texts go into
the names of the files, the titles and the answers.

A sheet that is in FOLDER already, made from the same settings, is not made again.
"""


def _output(metavar: str, help: str) -> Callable[[_Command], _Command]:
    """Return the option that says where to write."""
    return click.option(
        "-o",
        "--output",
        required=True,
        callback=path(),
        shell_complete=completion.a_file,
        metavar=metavar,
        help=help,
    )


@click.command("batch", cls=HelpfulCommand, help=_HELP)
@click.argument("sheets", metavar="SHEETS", required=False, shell_complete=completion.a_file)
@_output("FOLDER", "FOLDER/ for the sheets and answers.csv, answers.json")
@click.option("--jobs", type=int, help="how many sheets are made at a time  [1]")
@click.option("--cluster", metavar="ADDRESS", help="of a Dask scheduler, as in tcp://host:8786")
@click.option("--only", type=int, metavar="K", help="make sheet K again  [all]")
@click.option("--merge", metavar="FILE.pdf", help="one PDF of all sheets, with bookmarks  [none]")
@click.option("--excel", is_flag=True, help="answers.xlsx, too, a sheet of Excel")
@click.pass_context
def make_batch(
    ctx: click.Context,
    /,
    sheets: str | None,
    output: str,
    jobs: int | None,
    cluster: str | None,
    only: int | None,
    merge: str | None,
    excel: bool,
    **given: Any,
) -> None:
    """Make problem sheets for a class, each with its key."""
    if sheets is None:
        raise UsageError("batch needs a file of sheets", "vad batch sheets.toml -o sheets/")
    with progress(output) as moved:
        made = vad.batch(
            sheets,
            output,
            **vars(given_burden(given)),
            jobs=1 if jobs is None else jobs,
            cluster=cluster,
            only=only,
            merge=merge,
            excel=excel,
            progress=moved,
        )
    rosters = (each.answers.get("roster", {}) for each in made)
    if roster := dict.fromkeys(name for each in rosters for name in each):
        say(f"note: carried into names, titles and answers: {', '.join(roster)}")
    failed = [each for each in made if each.error is not None]
    for each in failed:
        hint = f" ({each.error.hint})" if each.error and each.error.hint else ""
        say(f"error: sheet {each.number}: {each.error}{hint}")
    say_written(output, f"{len(made) - len(failed)} sheets")
    if failed:
        ctx.exit(1)


@click.command("quiz", cls=HelpfulCommand)
@click.argument("sheets", metavar="SHEETS", required=False, shell_complete=completion.a_file)
@_output("FILE", "FILE.xml (Moodle), FILE.gift, FILE.zip (QTI 2.1) or FILE.md")
def make_quiz(sheets: str | None, output: str, **given: Any) -> None:
    """Make a question bank for a learning platform, with pictures and numerical answers.

    SHEETS is a file as for vad batch; in [sheet], ask = ["rocker.omega"] names what is asked for,
    and tolerance = 0.03 says how far off an answer may be.
    """
    if sheets is None:
        raise UsageError("quiz needs a file of sheets", "vad quiz sheets.toml -o bank.xml")
    with progress(output) as moved:
        made = vad.quiz(sheets, output, progress=moved, **vars(given_burden(given)))
    say_written(output, f"{len(made)} questions")


for _verb in (make_batch, make_quiz):
    _verb.params += burden_options()

#: These verbs by name.
VERBS: tuple[click.Command, ...] = (make_batch, make_quiz)
