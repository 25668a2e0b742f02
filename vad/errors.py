"""Everything that can go wrong, each with one line for the user.

::

    VadError
    ├── InputError          a value, name or unit that cannot be
    │   └── UsageError      … because it is not one of a fixed set (a misspelt name, a format)
    ├── AssemblyError       the links do not close at this pose
    ├── DeadCentreError     the pose exists, but its rates (or one of its angles) do not
    └── ExportError         a file or folder that cannot be written
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable

#: The most characters of a message, of a value in it, and how many of them are those of its end.
_LONGEST, _LONGEST_VALUE = (500, 150), (60, 20)
#: For a name of so few letters nearly every other one is near: all known names are listed.
_SHORTEST_GUESSED = 2


class VadError(Exception):
    """Base of all errors of this package.

    Parameters
    ----------
    message
        One line that names the parameter and says what is wrong with it.  Line breaks and control
        characters are removed, and the middle of a very long message.
    hint
        One line that says what would work, where that can be said.

    Examples
    --------
    >>> error = VadError("crank: must be positive, got -4", hint="try --crank 40")
    >>> str(error), error.hint
    ('crank: must be positive, got -4', 'try --crank 40')
    """

    def __init__(self, message: str, hint: str | None = None) -> None:
        super().__init__(one_line(message))
        self.hint = None if hint is None else one_line(hint)

    def _render_traceback_(self) -> list[str]:
        """Return what IPython shows in place of frames: what is wrong, and what would work."""
        said = [f"{type(self).__name__}: {self}"]
        return [*said, f"hint: {self.hint}"] if self.hint else said


class InputError(VadError):
    """A value that cannot be: zero, negative or infinite where that has no meaning."""


class UsageError(InputError):
    """A name, unit, format or range that the program does not know."""


class AssemblyError(VadError):
    """The links cannot close at this pose."""


class DeadCentreError(VadError):
    """A dead centre: the pose exists, but the two construction lines do not cross."""


class ExportError(VadError):
    """A file or folder that cannot be written."""


def unknown(what: str, given: object, known: Iterable[str]) -> UsageError:
    """Return the error for a name that is not one of ``known``.

    The hint has the names that begin like it, or else the nearest one; where none is known, there
    is no hint.

    Examples
    --------
    >>> error = unknown("mechanism", "slidercrank", ["four-bar", "slider-crank"])
    >>> print(error, "-", error.hint)
    unknown mechanism 'slidercrank' - did you mean 'slider-crank'?
    """
    names = {name.lstrip("-"): name for name in known}  # dashes make no option like another
    text = given.lower().lstrip("-") if isinstance(given, str) else ""
    near = [name for name in names if text and name.startswith(text)]
    if len(text) > _SHORTEST_GUESSED:
        near = near or difflib.get_close_matches(text, names, n=1, cutoff=0.5)
    hint: str | None = None
    if near:
        hint = "did you mean " + " or ".join(f"'{names[name]}'" for name in near) + "?"
    elif names:
        hint = "known: " + ", ".join(names.values())
    return UsageError(f"unknown {what} {quoted(given)}", hint)


def one_of(what: str, given: object, known: Iterable[str]) -> str:
    """Return ``given`` if it is one of ``known`` names.

    Raises
    ------
    UsageError
        If it is not.

    Examples
    --------
    >>> one_of("style", "chalk", ["chalk", "paper"])
    'chalk'
    """
    names = list(known)
    if not isinstance(given, str) or given not in names:
        raise unknown(what, given, names)
    return given


def quoted(value: object) -> str:
    """Return a value as a message quotes it: a long one without its middle.

    Examples
    --------
    >>> quoted("6_"), quoted(10**80), quoted(10**5000)
    ("'6_'", '1000000000000000000000000000000000000000…0000000000000000000', 'an int')
    """
    try:
        text = f"'{value}'" if isinstance(value, str) else repr(value)
    except Exception:  # its class has a faulty repr, or it has more digits than Python writes
        name = type(value).__name__
        text = f"an {name}" if name[0] in "aeiou" else f"a {name}"
    return _without_middle(text, *_LONGEST_VALUE)


def one_line(text: str) -> str:
    r"""Return a message on one line, without control characters and of limited length.

    Examples
    --------
    >>> one_line("four\nbar\x1b[31m")
    'four bar?[31m'
    """
    text = _without_middle(" ".join(text.split()), *_LONGEST)
    return "".join(each if each.isprintable() else "?" for each in text)


def _without_middle(text: str, most: int, end: int) -> str:
    if len(text) <= most:
        return text
    return f"{text[: most - end]}…{text[len(text) - end + 1 :]}"
