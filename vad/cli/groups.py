"""``vad VERB NAME``: the command of one verb for one mechanism.

The command for a mechanism is made when its name has been read, with that mechanism's options.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise
from typing import Any

import click
from click.shell_completion import CompletionItem

from vad.cli.options import build, kind_of, mechanism_options, own_option
from vad.errors import UsageError, VadError, quoted, unknown
from vad.files.examples import EXTENSION
from vad.mechanisms import Mechanism, mechanism_names

#: Under what name click's context holds the options of the format that is written.
_OWN_OPTIONS = "vad.cli.own_options"
# Called with the mechanism, its inputs and the verb's own options.
Action = Callable[..., None]


class HelpfulCommand(click.Command):
    """A command that answers a misspelt option with the nearest one."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Read the options."""
        words = list(args)
        try:
            return super().parse_args(ctx, args)
        except click.NoSuchOption as error:
            name = error.option_name
            if not name.startswith("--"):
                # click reads -crank as -c -r …; the message quotes the word as it was written.
                name = next((word for word in words if word.startswith(name)), name)
            name = name.partition("=")[0]
            verb = ctx.parent.command if ctx.parent else None
            others = verb.formats_by_option() if isinstance(verb, MechanismGroup) else {}
            if name in others:
                raise _of_another_format(name, others[name], words) from None
            names = [each for option in self.get_params(ctx) for each in option.opts]
            wrong = unknown("option", name, [*names, *others])
            verbs = _verbs_with(ctx, name)
            if verbs:
                wrong.hint = f"{name} is an option of {' and of '.join(verbs)}"
            raise wrong from None


def _of_another_format(name: str, extensions: Sequence[str], words: Sequence[str]) -> UsageError:
    """Return the error for an option that the format of the file in ``-o`` does not have."""
    kinds = " and ".join(extensions)
    message = f"{name} is for {kinds}, not for {quoted(_output(words) or '')}"
    return UsageError(message, f"as in -o FILE{extensions[0]}")


def _verbs_with(ctx: click.Context, name: str) -> list[str]:
    """Return the verbs with an option of that name: "vad animate"."""
    root = ctx.find_root().command
    if not isinstance(root, click.Group):
        return []
    for verb in root.list_commands(ctx):
        root.get_command(ctx, verb)  # some verbs are imported only when they are asked for
    return [
        f"vad {verb.name}"
        for verb in root.commands.values()
        if isinstance(verb, MechanismGroup) and any(name in each.opts for each in verb.options)
    ]


class MechanismGroup(click.Group):
    """One verb, with a command for every mechanism.

    Parameters
    ----------
    name, help
        The verb and what it does.
    action
        What is done with the mechanism, its inputs and the values of ``options``.
    options
        The verb's own options.
    ranged
        Whether the input runs over a range instead of standing at one place.
    usual
        The mechanism where no NAME is given; without it, a NAME is needed.
    formats
        The modules of the formats that it writes, by extension.  Options that a format has of its
        own are read from the one that ``-o`` names; help lists those of all.
    """

    def __init__(
        self,
        name: str,
        help: str,
        action: Action,
        options: Sequence[click.Option],
        ranged: bool = False,
        usual: str = "",
        formats: Mapping[str, str] | None = None,
    ) -> None:
        metavar = "[NAME] [OPTIONS]" if usual else "NAME [OPTIONS]"
        super().__init__(name, help=help, subcommand_metavar=metavar)
        self.action = action
        self.options = options
        self.ranged = ranged
        self.usual = usual
        self.formats = formats or {}

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Bring NAME to the front, wherever it stands among the options."""
        own = [] if ctx.resilient_parsing else self._own_options(_output(args))
        ctx.meta[_OWN_OPTIONS] = own
        place = first_word(args, [*self.options, *own])
        if place is None and _output(args):  # after an option of another format, which is refused
            place = first_word(args, [*self.options, *self._own_options(None)])
        helped = ctx.resilient_parsing or {"-h", "--help"}.intersection(args)
        if place is None and self.usual and not helped:
            args = [self.usual, *args]
        elif place is None:
            if not helped:
                raise UsageError(
                    f"{self.name} needs the name of a mechanism",
                    hint=f"vad {self.name} slider-crank; vad list names them all",
                )
        else:
            args = [args[place], *args[:place], *args[place + 1 :]]
            over = any(word.startswith("--over") for word in args)
            if args[0].endswith(EXTENSION):
                from vad.cli.sheet_words import with_sheet  # most names are those of no file

                args = with_sheet(args, moved=self.ranged and not over)
        return super().parse_args(ctx, args)

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Return what a shell may offer before NAME is given."""
        own = click.Command(self.name, params=list(self.options), add_help_option=False)
        return [
            *super().shell_complete(ctx, incomplete),
            *click.Command.shell_complete(own, ctx, incomplete),
        ]

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of all mechanisms."""
        return list(mechanism_names())

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the options that a verb has for every mechanism, and then the mechanisms."""
        own = [*self.options, *self._own_options(None), *self.get_params(ctx)]
        records = (option.get_help_record(ctx) for option in own)
        with formatter.section("Options, for every NAME"):
            formatter.write_dl([record for record in records if record])
        self.format_commands(ctx, formatter)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write what NAME may be."""
        names = self.list_commands(ctx)
        titles = {name: getattr(self._found(name), "title", "") for name in names}
        with formatter.section("NAME"):
            formatter.write_dl(
                [*titles.items(), ("press.toml", "A file; vad example prints some to begin with")]
            )
        with formatter.section("Dimensions and inputs"):
            verb = ctx.command_path
            formatter.write_text(f"{verb} NAME --help names those of a mechanism or a file.")

    @staticmethod
    def _found(name: str) -> type[Mechanism] | None:
        """Return a mechanism's class; None for one of another package that cannot be loaded."""
        try:
            return kind_of(name)
        except VadError:
            return None

    def _own_options(self, output: str | None) -> list[click.Option]:
        """Return the options of the format of a file; those of all formats where none is named."""
        if not self.formats:
            return []
        from vad.export import own_options

        named, file = self.formats.items(), (output or "").lower()
        modules = [module for end, module in named if output is None or file.endswith(end)]
        return [own_option(each) for each in own_options(modules).values()]

    def formats_by_option(self) -> dict[str, list[str]]:
        """Return the extensions of the formats that have an option of their own, by its name."""
        found: dict[str, list[str]] = {}
        for extension in self.formats:
            for option in self._own_options(extension):
                found.setdefault(option.opts[0], []).append(extension)
        return found

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command:
        """Return the command for the mechanism called ``cmd_name``."""
        kind = kind_of(cmd_name)

        def act(**values: Any) -> None:
            mechanism, inputs, own = build(kind, values)
            self.action(mechanism, inputs, **own)

        return HelpfulCommand(
            cmd_name,
            params=[
                *mechanism_options(kind, self.ranged),
                *self.options,
                *ctx.meta.get(_OWN_OPTIONS, ()),
            ],
            callback=act,
            help=kind.__doc__,
            short_help=kind.title,
        )


def _output(args: Sequence[str]) -> str | None:
    """Return the name of the file that ``-o`` gives; None where it is absent."""
    for word, following in pairwise((*args, "")):
        if word in ("-o", "--output"):
            return following
        for start in ("--output=", "-o=", "-o"):
            if word.startswith(start):
                return word.removeprefix(start)
    return None


def first_word(args: Sequence[str], options: Iterable[click.Option]) -> int | None:
    """Return the place of the first word that is neither an option nor an option's value."""
    alone = {name for option in options if option.is_flag for name in option.opts}
    alone |= {"-h", "--help"}
    skip = False
    for place, word in enumerate(args):
        if skip:
            skip = False
        elif not word.startswith("-"):
            return place
        elif word == "-o" or (word.startswith("--") and word != "--"):
            skip = "=" not in word and word not in alone
    return None
