"""The command line as a whole: the card, the lists and all verbs with their options."""

from __future__ import annotations

import dataclasses
import inspect
import json
import textwrap
from collections.abc import Iterable, Iterator
from itertools import zip_longest
from typing import Any

import click

import vad
from vad import __version__
from vad.cli import actions, check, compare, completion
from vad.cli.groups import HelpfulCommand, MechanismGroup
from vad.cli.options import NamedOption, flag, length_unit_of, path, places, several, size
from vad.cli.process import say
from vad.errors import InputError, UsageError, unknown
from vad.export import FOLDER, FORMATS, formats
from vad.files.examples import example_names, example_path, example_title
from vad.lecture.lesson import Lesson
from vad.lecture.still import Still
from vad.mechanisms import MECHANISMS, Mechanism, mechanism_named, mechanism_names
from vad.plan.format import paper_names
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.language import languages
from vad.strokes.sheet import Sheet
from vad.style import GROUP as STYLES
from vad.style import style_names
from vad.units import scene_unit
from vad.written import typed

CARD = """\
vad draws velocity and acceleration polygons: as numbers, as a picture, as a film.

Try
  vad solve slider-crank --angle 116.9
  vad draw four-bar --crank "4 cm" --omega "120 rpm" -o four-bar.png
  vad animate slider-crank -o lecture.mp4

vad list names the mechanisms; vad solve NAME --help shows their dimensions."""


_WIDTH = 100


def table() -> str:
    """Return the mechanisms with what they are and their inputs, as text for a terminal."""
    indent = max(map(len, mechanism_names())) + 2
    lines: list[str] = []
    for name, kind in _listed():
        if isinstance(kind, InputError):
            what = textwrap.wrap(f"cannot be loaded: {kind}", _WIDTH - indent)
        else:
            what = [*textwrap.wrap(_what(kind), _WIDTH - indent), _inputs(kind)]
        lines += [
            f"{label:{indent}}{line}" for label, line in zip_longest([name], what, fillvalue="")
        ]
    how = "Mechanisms from files; vad example NAME prints one:"
    names = textwrap.wrap(", ".join(example_names()), _WIDTH - 2, break_on_hyphens=False)
    return "\n".join([*lines, "", how, *(f"  {line}" for line in names)])


def examples() -> str:
    """Return the names of the examples with what they are, as text for a terminal."""
    indent = max(map(len, example_names())) + 2
    return "\n".join(f"{name:{indent}}{example_title(name)}" for name in example_names())


def entries() -> list[dict[str, Any]]:
    """Return the mechanisms as data: name, title, parameters and inputs with their defaults.

    A mechanism of another package that cannot be loaded has a name and a problem.
    """
    return [
        {"name": name, "problem": str(kind)}
        if isinstance(kind, InputError)
        else {
            "name": name,
            "title": kind.title,
            "description": _what(kind),
            "parameters": {
                field.name: field.default
                for field in dataclasses.fields(kind)
                if field.metadata["quantity"] in ("length", "angle")
            },
            "inputs": dict(kind.inputs),
            "length_unit": length_unit_of(kind),
        }
        for name, kind in _listed()
    ]


def _listed() -> Iterator[tuple[str, type[Mechanism] | InputError]]:
    """Yield every mechanism with its name; in place of one that cannot be loaded, the reason."""
    for name in mechanism_names():
        try:
            yield name, mechanism_named(name)
        except InputError as error:
            yield name, error


def _inputs(kind: type[Mechanism]) -> str:
    """Return the inputs of a mechanism as options, with their defaults and units."""
    unit = length_unit_of(kind)
    return "  ".join(
        f"{flag(key)} {typed(value)} {scene_unit(key, unit)}" for key, value in kind.inputs.items()
    )


def _what(kind: type[Mechanism]) -> str:
    """Return the first sentence of a mechanism's docstring."""
    return (inspect.getdoc(kind) or kind.title).partition("\n")[0]


class App(click.Group):
    """The commands; a misspelt one is answered with the nearest."""

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the command that ``args`` begins with."""
        name = args[0]
        if name not in self.commands:
            wrong = unknown("command", name, self.commands)
            if name in MECHANISMS:
                wrong.hint = f"vad solve {name}"
            raise wrong
        return super().resolve_command(ctx, args)

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Read the options before the command."""
        try:
            return super().parse_args(ctx, args)
        except click.NoSuchOption as error:
            wrong = unknown("option", error.option_name, ["--help", "--version", "--completion"])
            if not error.option_name.startswith(("--h", "--v", "--c")):
                wrong.hint = "other options stand after the command; see vad --help"
            raise wrong from None


def _print_completion(ctx: click.Context, _: click.Parameter, shell: str | None) -> None:
    if shell is not None and not ctx.resilient_parsing:
        click.echo(completion.script(shell))
        ctx.exit()


@click.group(
    "vad",
    cls=App,
    invoke_without_command=True,
    epilog="NAME is one that vad list has, or a file such as press.toml; vad example prints some.",
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)
@click.version_option(__version__, message="vad %(version)s")
@click.option(
    "--completion",
    metavar="|".join(completion.SHELLS),
    is_eager=True,
    expose_value=False,
    callback=_print_completion,
    shell_complete=completion.one_of(completion.SHELLS),
    help="Print the script that completes words in a shell.",
)
@click.pass_context
def app(ctx: click.Context) -> None:
    """Velocity and acceleration polygons of mechanisms, solved, drawn and animated."""
    if ctx.invoked_subcommand is None:
        click.echo(CARD)


@app.command("list", cls=HelpfulCommand)
@click.option("--json", "as_json", is_flag=True, help="As JSON, with every default.")
def list_mechanisms(as_json: bool) -> None:
    """Name the mechanisms."""
    if as_json:
        click.echo(json.dumps(entries(), ensure_ascii=False, indent=1))
    else:
        click.echo(table())


@app.command("example", cls=HelpfulCommand)
@click.argument("name", required=False, shell_complete=completion.one_of(example_names()))
def print_example(name: str | None) -> None:
    """Print an example of a mechanism's file; without NAME, name them all."""
    text = examples() if name is None else example_path(name).read_text("utf-8")
    click.echo(text.rstrip())


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
    NamedOption("language", "language", languages(), "of titles and captions  [en]"),
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


for verb in (
    MechanismGroup(
        "solve",
        "Print the numbers of one pose.",
        actions.solve,
        [click.Option(["--json", "as_json"], is_flag=True, help="as JSON, with all digits")],
    ),
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
):
    app.add_command(verb)
app.add_command(compare.command)
app.add_command(make_batch)
app.add_command(check.command)
