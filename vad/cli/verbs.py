"""The verbs that draw, with their options: names of panels, styles, languages and formats.

They are imported only when one of them is asked for, because they know all that can be drawn.
"""

from __future__ import annotations

from collections.abc import Iterable

import click

import vad
from vad.cli import actions, completion
from vad.cli.groups import HelpfulCommand, MechanismGroup
from vad.cli.options import NamedOption, path, places, several, size
from vad.cli.process import say
from vad.errors import UsageError
from vad.export import FOLDER, FORMATS, formats
from vad.lecture.lesson import Lesson, Still
from vad.plan.format import paper_names
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.sheet import Sheet
from vad.style import GROUP as STYLES
from vad.style import style_names
from vad.words import GROUP as LANGUAGES
from vad.words import languages

_SHEET = [
    click.Option(
        ["--panels"],
        callback=several("panel", DIAGRAMS),
        shell_complete=completion.several(DIAGRAMS),
        multiple=True,
        metavar="NAME,NAME",
        help=f"some of {', '.join(DIAGRAMS)}  [all]",
    ),
    NamedOption("style", "style", style_names(), "how it looks  [paper]", STYLES),
    NamedOption("language", "language", languages(), "of titles and captions  [en]", LANGUAGES),
]
_SIZE = click.Option(["--size"], callback=size(), metavar="WxH", help="in pixels  [1280x720]")
_PAPER = NamedOption("paper", "paper", paper_names(), "a PDF in true scale, to be measured")
_POSITIONS = click.Option(
    ["--turn"], is_flag=True, help="a full turn: the ways of all points, in twelve positions"
)
_AT = click.Option(
    ["--at"],
    callback=places(),
    metavar="PLACE,PLACE",
    help="two to six poses side by side, at these places of the driver  [one pose]",
)
_BLANK = click.Option(
    ["--blank"],
    callback=several("panel", DIAGRAMS),
    shell_complete=completion.several(DIAGRAMS),
    multiple=True,
    metavar="NAME,NAME",
    help="a problem sheet: these panels are left to be drawn  [none]",
)
_FILM = [
    click.Option(["--fps"], type=float, help="frames per second  [30]"),
    click.Option(["--speed"], type=float, help="2 is twice as fast  [1]"),
    click.Option(
        ["--still"],
        metavar="STEP",
        help="one step as a picture (.png, .svg, .pdf): 4, or velocity:4  [the film]",
    ),
    click.Option(["--turn"], is_flag=True, help="a full turn, and the polygons live with it"),
    click.Option(
        ["--loop"],
        type=int,
        metavar="NUMBER",
        help="the dyad with which the pencil starts; those before it are there  [1]",
    ),
    click.Option(["--subtitles"], is_flag=True, help="FILE.srt and FILE.vtt beside the film, too"),
]


def _output(extensions: Iterable[str]) -> click.Option:
    """Return the option that names the file, with the kinds of file that there are."""
    *names, last = ("FOLDER/" if each == FOLDER else f"FILE{each}" for each in extensions)
    return click.Option(
        ["-o", "--output"],
        required=True,
        callback=path(),
        shell_complete=completion.a_file,
        metavar="FILE",
        help=f"{', '.join(names)} or {last}",
    )


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
    callback=path(),
    shell_complete=completion.a_file,
    metavar="FOLDER",
    help="FOLDER/ for the sheets and answers.csv, answers.json",
)
@click.option("--jobs", type=int, help="how many sheets are made at a time  [1]")
@click.option("--cluster", metavar="ADDRESS", help="of a Dask scheduler, as in tcp://host:8786")
@click.option("--only", type=int, metavar="K", help="make sheet K again  [all]")
@click.pass_context
def make_batch(
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
    with actions.progress(output) as moved:
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
    actions.written(output, f"{len(made) - len(failed)} sheets")
    if failed:
        ctx.exit(1)


#: These verbs by name.
VERBS: tuple[click.Command, ...] = (
    MechanismGroup(
        "draw",
        "Draw the polygons of one pose.",
        actions.draw,
        [_output(FORMATS[Sheet]), *_SHEET, _SIZE, _PAPER, _BLANK, _AT, _POSITIONS],
        formats=FORMATS[Sheet],
    ),
    MechanismGroup(
        "animate",
        "Make a film that draws the polygons stroke by stroke.",
        actions.animate,
        [_output(FORMATS[Lesson]), *_SHEET, _SIZE, *_FILM],
        formats=FORMATS[Lesson] | FORMATS[Still],
    ),
    MechanismGroup(
        "sweep",
        "Write the numbers over a turn, as a table or a plot.",
        actions.sweep,
        [
            _output(formats("sweep")),
            click.Option(["--steps"], type=int, help="number of poses, both ends included  [361]"),
        ],
        ranged=True,
    ),
    MechanismGroup(
        "gui",
        "Open a page on which a mechanism is turned by hand.",
        actions.gui,
        [
            *_SHEET,
            _SIZE,
            click.Option(["--port"], type=int, help="the server's port  [any that is free]"),
            click.Option(["--no-browser"], is_flag=True, help="print the address, open nothing"),
        ],
        usual="slider-crank",
    ),
    make_batch,
)
