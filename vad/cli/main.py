"""The command as a process: its signals, its streams and its exit code.

It carries out the words of its command line, or answers a shell that asks how a word may go on.
"""

from __future__ import annotations

import gc
import os
import sys

from vad.cli import process

#: So many new objects make Python search for garbage; of its own accord, 700.  A pose in the window
#: takes 0.92 of the time, and at worst 9 ms instead of 32.
SEARCH_AFTER = 10_000


def main() -> int:
    """Run the command line of this process and return its exit code."""
    gc.set_threshold(SEARCH_AFTER)
    process.open_standard_streams()
    try:
        process.raise_on_signals()
        # From here on a signal ends the process in good order, even while modules are imported.
        code = _carried_out()
        process.ignore_signals()
    except process.Interrupted as stop:
        process.ignore_signals()
        process.say("error: interrupted")
        code = stop.exit_code
    process.end_despite_threads(code)
    return code


def _carried_out() -> int:
    """Carry out the words of the command line, or answer a shell; return the exit code."""
    try:
        process.quieten()
        from vad.cli import completion
        from vad.cli.run import run

        question = os.environ.get(completion.VARIABLE)
        code = answer(question) if question else run(sys.argv[1:])
        if sys.stdout is not None:
            sys.stdout.flush()
        # Python would search all that is left for garbage before it ends: a tenth of `vad draw`.
        gc.freeze()
        return code
    except BrokenPipeError:
        process.abandon_stdout()
        return process.BROKEN_PIPE
    except OSError as error:
        process.abandon_stdout()
        process.say(f"error: cannot write: {error.strerror or error}")
        return 1
    except Exception:
        process.check_interrupt()  # Python makes other errors of one that comes during an import
        raise


def answer(question: str) -> int:
    """Print what may follow the words that a shell has put into the environment.

    If the words are wrong already, nothing may follow.  The exit code is 1 if this is no question.

    Parameters
    ----------
    question
        What `vad.cli.completion.VARIABLE` holds.
    """
    from click.shell_completion import shell_complete

    from vad.cli.app import app
    from vad.cli.completion import VARIABLE
    from vad.errors import VadError

    try:
        return shell_complete(app, {}, "vad", VARIABLE, question)
    except (VadError, UnicodeError):  # or they are no text
        return 0
