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


class VadError(Exception):
    """Base of all errors of this package.

    Parameters
    ----------
    message
        One line that names the parameter and says what is wrong with it.
    hint
        One line that says what would work, where that can be said.

    Examples
    --------
    >>> error = VadError("crank: must be positive, got -4", hint="try --crank 40")
    >>> str(error), error.hint
    ('crank: must be positive, got -4', 'try --crank 40')
    """

    def __init__(self, message: str, hint: str | None = None) -> None:
        super().__init__(message)
        self.hint = hint


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


def unknown(what: str, given: str, known: Iterable[str]) -> UsageError:
    """Return the error for a name that is not one of ``known``, with the nearest as a hint.

    Examples
    --------
    >>> error = unknown("mechanism", "slidercrank", ["four-bar", "slider-crank"])
    >>> print(error, "-", error.hint)
    unknown mechanism 'slidercrank' - did you mean 'slider-crank'?
    """
    names = list(known)
    nearest = difflib.get_close_matches(given.lower(), names, n=1, cutoff=0.5)
    hint = f"did you mean '{nearest[0]}'?" if nearest else "known: " + ", ".join(names)
    return UsageError(f"unknown {what} '{given}'", hint=hint)
