"""``vad design TASK``: from what is asked for to the mechanisms that do it."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

import click
from click.shell_completion import CompletionItem

import vad
from vad.cli import completion
from vad.cli.groups import HelpfulCommand, first_word
from vad.cli.options import NamedOption, length_unit, path
from vad.cli.output import say_written
from vad.discovery import names_in
from vad.errors import InputError, UsageError
from vad.units import LENGTH_UNITS
from vad.written import DIGITS

if TYPE_CHECKING:
    from vad.designs.task import Demand

_WIDTH = 100
#: The files of numbers; all others are pictures.
_DATA = (".json", ".toml")


@cache
def own_options() -> list[click.Option]:
    """Return the options that every task has."""
    from vad.style import GROUP as STYLES  # other verbs need no styles and no words
    from vad.style import style_names
    from vad.words import GROUP as LANGUAGES
    from vad.words import languages

    return [
        click.Option(["--json", "as_json"], is_flag=True, help="as JSON, with all digits"),
        click.Option(
            ["--toml", "as_toml"], is_flag=True, help="the solution as a mechanism's file"
        ),
        click.Option(
            ["-o", "--output"],
            callback=path(),
            shell_complete=completion.a_file,
            metavar="FILE",
            help="FILE.toml, FILE.json, or a picture of its positions: .png, .svg, .pdf",
        ),
        click.Option(["--pick"], type=int, metavar="NUMBER", help="which solution is written  [1]"),
        click.Option(["--digits"], type=int, help=f"significant digits of the text  [{DIGITS}]"),
        click.Option(
            ["--length-unit"],
            callback=length_unit(),
            shell_complete=completion.one_of(LENGTH_UNITS),
            metavar="UNIT",
            help="the unit of lengths  [mm]",
        ),
        NamedOption(
            "style", "style", style_names(), "colours and lines of a picture  [paper]", STYLES
        ),
        NamedOption("language", "language", languages(), "language of all words  [en]", LANGUAGES),
    ]


class DesignGroup(click.Group):
    """The verb, with a command for each task."""

    @property
    def options(self) -> Sequence[click.Option]:
        """The options that every task has."""
        return own_options()

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Bring the task to the front, wherever it stands among the options."""
        at = first_word(args, self.options)
        if at is not None:
            args = [args[at], *args[:at], *args[at + 1 :]]
        return super().parse_args(ctx, args)

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of all tasks."""
        return [name.replace("_", "-") for name in names_in("designs", "tasks")]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command:
        """Return the command of a task."""
        from vad.designs.tasks import task_named

        task = task_named(cmd_name)

        def act(**given: Any) -> None:
            answer(task.name, {name: value for name, value in given.items() if value is not None})

        options = [_option(demand) for demand in task.demands]
        return HelpfulCommand(
            task.name,
            params=[*options, *self.options],
            callback=act,
            help=f"{task.title}.\n\nWithout a choice: {task.usual}.",
            short_help=task.title,
        )

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Return what a shell may offer before the task is given."""
        own = click.Command(self.name, params=list(self.options), add_help_option=False)
        return [
            *super().shell_complete(ctx, incomplete),
            *click.Command.shell_complete(own, ctx, incomplete),
        ]


def _option(demand: Demand) -> click.Option:
    """Return the option of a demand; the task itself reads its value."""
    note = "  [needed]" if demand.needed else ""
    metavar = demand.example if demand.is_table or not demand.example else demand.quantity.upper()
    return click.Option(
        [demand.option, demand.name],
        metavar=metavar or demand.quantity.upper(),
        help=f"{demand.help}{note}",
    )


def listed() -> str:
    """Return the tasks with what each needs and what it leaves free, as text for a terminal."""
    from vad.designs.tasks import TASKS

    blocks = []
    for name, task in TASKS.items():
        written = {each: f"  {each.option} {each.example}".rstrip() for each in task.demands}
        width = max(map(len, written.values())) + 2
        lines = [
            f"{words:{width}}{each.help}{'  [needed]' if each.needed else ''}"
            for each, words in written.items()
        ]
        usual = textwrap.wrap(
            f"Without a choice: {task.usual}.", _WIDTH, initial_indent="  ", subsequent_indent="  "
        )
        blocks.append("\n".join([f"{name}: {task.title}", *lines, *usual]))
    return "\n\n".join(blocks)


def _as_data() -> list[dict[str, Any]]:
    """Return the tasks as data."""
    from vad.designs.tasks import TASKS

    return [
        {
            "name": name,
            "title": task.title,
            "needs": {each.name: each.help for each in task.demands if each.needed},
            "free": {each.name: each.help for each in task.demands if not each.needed},
        }
        for name, task in TASKS.items()
    ]


def answer(task: str, demands: dict[str, Any]) -> None:
    """Print the solutions of a task, or write one of them into a file."""
    names = [str(option.name) for option in own_options()]
    own = {name: demands.pop(name) for name in names if name in demands}
    output, language = own.get("output"), own.get("language", "en")
    as_json, as_toml = own.get("as_json", False), own.get("as_toml", False)
    if as_json and as_toml:
        raise UsageError("--json and --toml: choose one of them")
    kind = None if output is None else _kind_of(output)
    unit = {"length_unit": own["length_unit"]} if "length_unit" in own else {}
    found = vad.design(task, **unit, **demands)
    number = own.get("pick", 1)
    if not 1 <= number <= len(found):
        there = "is one solution" if len(found) == 1 else f"are {len(found)} solutions"
        raise UsageError(f"--pick: there {there}, got {number}", "--pick 1")
    solution = found[number - 1]

    def data() -> str:
        return json.dumps(found.to_dict(number - 1), ensure_ascii=False)

    if output is None:
        if as_json:
            click.echo(data())
        elif as_toml:
            click.echo(solution.toml().rstrip())
        else:
            click.echo(found.table(own.get("digits", DIGITS), language))
        return
    if kind in _DATA:
        from vad.export.files import new_file

        with new_file(output) as stream:
            stream.write((solution.toml() if kind == ".toml" else f"{data()}\n").encode())
    else:
        _draw(solution, output, language, own)
    say_written(output)


def _kind_of(output: str) -> str:
    """Return the kind of a file, before anything is calculated."""
    lower = output.lower()
    if lower.endswith(_DATA):
        return lower[-5:]
    from vad.export import format_of
    from vad.strokes.multiples import Multiples

    return format_of(Multiples, output)


def _draw(solution: vad.Solution, output: str, language: str, own: dict[str, Any]) -> None:
    """Draw the mechanism in the positions that were asked for."""
    if "assembly" in solution.faults:
        raise InputError(
            "--pick: this solution changes its assembly between the positions, so no motion shows "
            "them all",
            "-o FILE.toml writes it as it is in the first one",
        )
    drawn = vad.multiples(solution.motions[0], solution.places, "position", language)
    vad.save(drawn, output, **({"style": own["style"]} if "style" in own else {}))


@click.group(
    "design",
    cls=DesignGroup,
    invoke_without_command=True,
    subcommand_metavar="[TASK] [OPTIONS]",
)
@click.option("--json", "as_json", is_flag=True, help="the list of tasks as JSON")
@click.pass_context
def command(ctx: click.Context, as_json: bool) -> None:
    """Find the mechanisms that do what is asked for; without TASK, list the tasks."""
    if ctx.invoked_subcommand is None:
        data = json.dumps(_as_data(), ensure_ascii=False, indent=1) if as_json else listed()
        click.echo(data)
