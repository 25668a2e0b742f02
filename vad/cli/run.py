"""One call of the command line: errors become two lines on stderr and an exit code."""

from __future__ import annotations

import os
import traceback
from collections.abc import Sequence

import click

from vad.cli.process import check_interrupt, say
from vad.errors import UsageError, VadError, one_line


def run(arguments: Sequence[str]) -> int:
    """Carry out ``arguments`` and return the exit code.

    It is 0, or 1 for a mechanism or file that cannot be, or 2 for wrong usage.

    Examples
    --------
    >>> run(["sovle", "four-bar"])
    2
    """
    from vad.cli.app import app

    try:
        with app.make_context("vad", list(arguments)) as context:
            app.invoke(context)
    except click.exceptions.Exit as done:
        return done.exit_code
    except click.ClickException as error:
        return _report(*_in_words(error), exit_code=2)
    except VadError as error:
        return _report(str(error), error.hint, 2 if isinstance(error, UsageError) else 1)
    except MemoryError:
        return _report("out of memory", "fewer --steps or a smaller --size")
    except OSError as error:
        if error.filename is None:
            raise  # standard output, which the process deals with
        return _report(f"'{os.fsdecode(error.filename)}': {error.strerror}")
    except UnicodeDecodeError:  # that file raises it, and the error does not name it
        return _report("a matplotlibrc, here or in your home folder, is not UTF-8")
    except Exception as error:
        if os.environ.get("VAD_DEBUG"):
            raise
        problem = f"{type(error).__name__}: {error}"
        return _report(f"internal fault ({problem}){_place(error)}", "VAD_DEBUG=1 shows the rest")
    check_interrupt()
    return 0


def _place(error: BaseException) -> str:
    """Return the file and the line in which an error arose; a new file with a fault is found by it.

    Examples
    --------
    >>> _place(ZeroDivisionError())
    ''
    """
    if isinstance(error, SyntaxError):
        return ""  # its text names them
    frames = traceback.extract_tb(error.__traceback__)
    return f" in {frames[-1].filename}, line {frames[-1].lineno}" if frames else ""


def _in_words(error: click.ClickException) -> tuple[str, str | None]:
    """Return click's complaint as a message and a hint, in the form of this program's own."""
    context = getattr(error, "ctx", None)
    hint = f"see {context.command_path} --help" if context else None
    if isinstance(error, click.MissingParameter) and isinstance(error.param, click.Option):
        name = error.param.opts[0]
        return f"{name} is missing", f"{name} {error.param.help}"
    if isinstance(error, click.BadOptionUsage) and "requires" in error.message:
        return f"{error.option_name} needs a value", hint
    if isinstance(error, click.BadParameter) and error.param is not None:
        return f"{error.param.opts[-1]}: {error.message.rstrip('.')}", hint
    message = error.format_message().rstrip(".")
    return message[:1].lower() + message[1:], hint


def _report(message: str, hint: str | None = None, exit_code: int = 1) -> int:
    check_interrupt()
    say(f"error: {one_line(message)}")
    if hint:
        say(f"hint: {one_line(hint)}")
    return exit_code
