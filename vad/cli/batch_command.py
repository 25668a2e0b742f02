"""``vad batch``: in comes a file that says what a class is to get, out goes a folder of sheets."""

from __future__ import annotations

import click

import vad
from vad.cli import completion, values
from vad.cli.groups import HelpfulCommand
from vad.cli.process import say
from vad.cli.progress import progress, written
from vad.errors import UsageError

_HELP = """\
Make problem sheets with their keys by the hundred.

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
  sine = 0.35                          # how steeply all lines cross at least

[sheet] also takes seed, panels, points, language, style, paper, size, fps, speed, length_unit.
What stands in FOLDER already, made from the same settings, is not made again.
"""


@click.command("batch", cls=HelpfulCommand, help=_HELP)
@click.argument("sheets", metavar="SHEETS", required=False, shell_complete=completion.a_file)
@click.option(
    "-o",
    "--output",
    required=True,
    callback=values.path(),
    shell_complete=completion.a_file,
    metavar="FOLDER",
    help="FOLDER/ for the sheets and answers.csv, answers.json",
)
@click.option("--jobs", type=int, help="how many sheets are made at a time  [1]")
@click.option("--cluster", metavar="ADDRESS", help="of a Dask scheduler, as in tcp://host:8786")
@click.option("--only", type=int, metavar="K", help="make sheet K again  [all]")
@click.pass_context
def command(
    ctx: click.Context,
    sheets: str | None,
    output: str,
    jobs: int | None,
    cluster: str | None,
    only: int | None,
) -> None:
    """Make problem sheets with their keys by the hundred."""
    if sheets is None:
        raise UsageError("batch needs a file of sheets", "vad batch sheets.toml -o sheets/")
    with progress(output) as moved:
        made = vad.batch(
            sheets,
            output,
            jobs=1 if jobs is None else jobs,
            cluster=cluster,
            only=only,
            progress=moved,
        )
    failed = [each for each in made if each.error is not None]
    for each in failed:
        hint = f" ({each.error.hint})" if each.error and each.error.hint else ""
        say(f"error: sheet {each.number}: {each.error}{hint}")
    written(output, f"{len(made) - len(failed)} sheets")
    if failed:
        ctx.exit(1)
