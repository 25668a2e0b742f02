"""The command line as a whole: the card, the lists and all verbs with their options."""

from __future__ import annotations

import dataclasses
import inspect
import json
import textwrap
from collections.abc import Iterator
from itertools import zip_longest
from typing import TYPE_CHECKING, Any

import click

import vad
from vad import __version__
from vad.cli import check, compare, completion, exercise
from vad.cli.groups import HelpfulCommand, MechanismGroup
from vad.cli.options import (
    NamedOption,
    burden_options,
    flag,
    length_unit_of,
    pin_option,
    results,
    take_burden,
)
from vad.discovery import names_in
from vad.errors import InputError, UsageError, unknown
from vad.files.examples import all_names, example_names, example_path, example_title, rotor_names
from vad.mechanisms import MECHANISMS, Mechanism, mechanism_named, mechanism_names
from vad.units import scene_unit
from vad.written import DIGITS, typed

if TYPE_CHECKING:
    from vad.statics.burden import Burden

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
    rotors = f"Shafts and engines, likewise: {', '.join(rotor_names())}"
    more = textwrap.wrap(rotors, _WIDTH, subsequent_indent="  ", break_on_hyphens=False)
    return "\n".join([*lines, "", how, *(f"  {line}" for line in names), *more])


def examples() -> str:
    """Return the names of the examples with what they are, as text for a terminal."""
    indent = max(map(len, all_names())) + 2
    return "\n".join(f"{name:{indent}}{example_title(name)}" for name in all_names())


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


#: The verbs that draw, which `vad.cli.verbs` has.
_DRAWING = ("draw", "animate", "sweep", "gui", "batch", "quiz")
#: The verb that designs, which `vad.cli.design` has.
_DESIGN = "design"


class App(click.Group):
    """The commands; a misspelt one is answered with the nearest."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of all commands."""
        return sorted({*self.commands, *_DRAWING, _DESIGN})

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Return a command; some are imported when they are asked for."""
        if cmd_name not in self.commands:
            if cmd_name in _DRAWING:
                self._import_drawing()
            elif cmd_name == _DESIGN:
                self._import_design()
        return super().get_command(ctx, cmd_name)

    def all_commands(self) -> dict[str, click.Command]:
        """Return every command by its name, in the order of the documentation."""
        self._import_drawing()
        self._import_design()
        first = ("list", "example", "solve", "draw", "animate", "sweep", "gui", "compare")
        order = (*first, _DESIGN, "batch")
        return {name: self.commands[name] for name in dict.fromkeys((*order, *self.commands))}

    def _import_drawing(self) -> None:
        from vad.cli import classes, verbs

        for verb in (*verbs.VERBS, *classes.VERBS):
            self.add_command(verb)

    def _import_design(self) -> None:
        from vad.cli import design

        self.add_command(design.command)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the command that ``args`` begins with."""
        name, known = args[0], self.list_commands(ctx)
        if name not in known:
            wrong = unknown("command", name, known)
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
    epilog="NAME is a name from vad list, or a file such as press.toml; vad example prints some.",
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


@app.command("help", cls=HelpfulCommand)
@click.argument("words", nargs=-1, metavar="[VERB] [NAME]")
@click.pass_context
def show_help(ctx: click.Context, words: tuple[str, ...]) -> None:
    """Show the help of all commands, or of one: vad help draw four-bar."""
    root = ctx.find_root()
    with app.make_context(str(root.info_name), [*words, "--help"]) as asked:
        app.invoke(asked)


@app.command("list", cls=HelpfulCommand)
@click.option("--json", "as_json", is_flag=True, help="As JSON, with every default.")
def list_mechanisms(as_json: bool) -> None:
    """Name the mechanisms."""
    if as_json:
        click.echo(json.dumps(entries(), ensure_ascii=False, indent=1))
    else:
        click.echo(table())


@app.command("example", cls=HelpfulCommand)
@click.argument("name", required=False, shell_complete=completion.one_of(all_names()))
def print_example(name: str | None) -> None:
    """Print an example of a mechanism's file; without NAME, name them all."""
    text = examples() if name is None else example_path(name).read_text("utf-8")
    click.echo(text.rstrip())


def _solve(
    mechanism: Mechanism,
    inputs: dict[str, Any],
    as_json: bool = False,
    digits: int = DIGITS,
    **given: Any,
) -> None:
    """Print the numbers of one pose, its forces if anything makes some, and what is balanced."""
    asked = {name: given.pop(name, None) for name in ("merit", "extremes", "pin")}
    figures = {name: value for name, value in asked.items() if value}
    if language := given.pop("language", None):
        if not figures:
            hint = "it goes with --merit, --extremes or --pin"
            raise UsageError("--language: the table of a pose has no words but names", hint)
        figures["language"] = language
    burden = take_burden(mechanism, given)
    motion = vad.solve(mechanism, **inputs)
    found = motion.to_dict()
    texts = [] if as_json else [motion.table(digits)]
    balancing = mechanism.balancing(motion)
    if balancing is not None:
        found |= {balancing.kind: balancing.to_dict()}
        texts += [] if as_json else [balancing.table(digits)]
    if burden is not None:
        forces = vad.forces(motion, *burden)
        found |= {"forces": forces.to_dict()}
        texts += [] if as_json else [forces.table(digits)]
    if figures:
        data, text = _figures(motion, burden, digits, **figures)
        found |= data
        texts.append(text)
    click.echo(json.dumps(found, ensure_ascii=False) if as_json else "\n\n".join(texts))


def _figures(
    motion: vad.Motion,
    burden: Burden | None,
    digits: int,
    merit: bool = False,
    extremes: tuple[str, ...] = (),
    pin: dict[str, float] | None = None,
    language: str = "en",
) -> tuple[dict[str, Any], str]:
    """Return figures of merit, or the rubbing of pins alone, as data and as text."""
    from vad.merits.listing import rubbing_table  # most commands need no figures
    from vad.merits.pins import listed, rubbing

    if not merit and not extremes:
        rubs = listed(rubbing(motion, pin or {}))
        unit = motion.mechanism.length_unit
        return {"rubbing": rubs}, rubbing_table(rubs, unit, digits, language)
    loads, masses, gravity, friction = burden or ((), None, None, None)
    found = vad.merit(
        motion, pins=pin, loads=loads, masses=masses, gravity=gravity, friction=friction
    )
    return {"merit": found.to_dict(extremes)}, found.table(extremes, digits, language)


#: The names of the languages, without their words, which a pose needs not; a help text; a group.
_LANGUAGES = names_in("words"), "language of the figures of merit  [en]", "vad.languages"
app.add_command(
    MechanismGroup(
        "solve",
        "Print the numbers of one pose.",
        _solve,
        [
            click.Option(["--json", "as_json"], is_flag=True, help="as JSON, with all digits"),
            click.Option(["--digits"], type=int, help=f"significant digits  [{DIGITS}]"),
            click.Option(
                ["--merit"],
                is_flag=True,
                help="print the figures of merit, too: stroke, transmission angle …",
            ),
            click.Option(
                ["--extremes"],
                callback=results(),
                multiple=True,
                metavar="RESULT,RESULT",
                help="the least and the largest value of these results, as in rocker.omega  [none]",
            ),
            pin_option(),
            NamedOption("language", "language", *_LANGUAGES),
            *burden_options(),
        ],
    )
)
app.add_command(compare.command)
app.add_command(check.command)
app.add_command(exercise.command)
