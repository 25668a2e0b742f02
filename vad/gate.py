"""The gate: each kind of value from outside is checked by one function, with its limits here.

Files, the command line, the window, JSON and calls from Python pass through it.  A value may be of
any type; what is refused is an `InputError` that begins with the name of the value.
"""

from __future__ import annotations

import math
import numbers
import os
import sys
import unicodedata
from collections.abc import Callable, Iterable
from decimal import Decimal
from itertools import islice
from typing import TYPE_CHECKING, Any

from vad.errors import InputError, UsageError, quoted

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

#: The ends of what a length may be: scaled products of four of them stay in the range of doubles.
SHORTEST, LONGEST = 1e-200, 1e200
#: The largest rate of a driver: squares of rates times lengths stay in the range of doubles.
FASTEST = 1e60
#: The largest force, couple, mass or moment of inertia: products with lengths are doubles, too.
LARGEST_LOAD = 1e60
#: The ends of what the longest vector of a drawing may have: so its scale is a double, too.
SMALLEST_DRAWN, LARGEST_DRAWN = 1e-250, 1e250
#: The most things in a list of names: more than there are names of anything.
MOST_NAMES = 1000
#: The most characters of a line of text: a title, the name of a unit.
LONGEST_LINE = 1000

# Python and numpy make numbers of these, but nobody means a number by them.
_NO_NUMBERS = (bool, str, bytes, bytearray, memoryview)


def number(name: str, value: object) -> float:
    """Return a value as a finite float.

    Raises
    ------
    vad.errors.InputError
        If it is no real number, several of them, or not finite.

    Examples
    --------
    >>> number("crank", 60)
    60.0
    >>> number("crank", float("nan"))
    Traceback (most recent call last):
    vad.errors.InputError: crank: must be a finite number, got nan
    """
    found = real(name, value)
    if not math.isfinite(found):
        raise InputError(f"{_start(name)}must be a finite number, got {quoted(value)}")
    return found


def real(name: str, value: Any) -> float:
    """Return a value as a float, which may be NaN or infinite.

    Raises
    ------
    vad.errors.InputError
        If it is no real number, or several of them.

    Examples
    --------
    >>> real("crank", 10**400), real("crank", float("nan"))
    (inf, nan)
    """
    if type(value) is float:
        return value  # the usual case
    several = isinstance(value, list | tuple)
    try:
        if isinstance(value, _NO_NUMBERS):
            raise TypeError
        kind = getattr(value, "dtype", None)  # numpy's: spans of time, truth values, arrays …
        if kind is not None and value.shape != ():
            several = True
            raise TypeError
        if kind is not None and kind.kind not in "iuf":
            raise TypeError
        return float(value)
    except OverflowError:  # a whole number or a fraction beyond every float
        return math.inf
    except ValueError:  # what signals that it is no number
        return math.nan
    except Exception:  # a class may raise anything when it is asked for a number
        got = quoted(value)
        wrong = f"must be one number, got {got}" if several else f"must be a number, got {got}"
        raise InputError(f"{_start(name)}{wrong}") from None


def array(name: str, value: object) -> NDArray[np.float64]:
    """Return a new array of floats; text and dates are refused, though numpy makes numbers of them.

    Raises
    ------
    vad.errors.InputError
        If it is neither a number nor an array of them, or a masked array.

    Examples
    --------
    >>> array("angle", [30, 60.5])
    array([30. , 60.5])
    """
    import numpy as np  # what reads names and files alone does not need it

    try:
        if isinstance(value, str | bytes | bytearray):
            raise TypeError
        masked = np.ma.is_masked(value)
        given = np.asarray(value)
        kind = given.dtype.kind
        if kind not in "iufO" or (kind == "O" and not all(map(is_number, given.flat))):
            raise TypeError
        found = np.array(given, dtype=float)
    except Exception as error:  # whatever a class says that is asked for an array
        if isinstance(error, MemoryError):
            raise
        wanted = "must be a number or an array of numbers"
        raise InputError(f"{name}: {wanted}, got {quoted(value)}") from None
    if masked:
        hint = "array.filled(numpy.nan) gives NaN, which is answered with NaN"
        raise InputError(f"{name}: must not be masked, for a mask would be lost", hint)
    return found


def is_number(value: object) -> bool:
    """Tell whether a value is a real number.

    In Python a truth value counts as a number, and in numpy a span of time does, too.
    """
    return isinstance(value, numbers.Real | Decimal) and not (
        isinstance(value, bool) or getattr(getattr(value, "dtype", None), "kind", "") == "m"
    )


def is_many(value: object) -> bool:
    """Tell whether a value has the shape of several numbers: a list, a numpy or a Dask array."""
    return isinstance(value, list | tuple) or getattr(value, "shape", ()) != ()


def is_lazy(value: object) -> bool:
    """Tell whether a value is a Dask array, without loading Dask for one that is not."""
    dask = sys.modules.get("dask.array")
    return dask is not None and isinstance(value, dask.Array)


def dimensions(name: str, value: Any, *, signed: bool) -> Any:
    """Return an array of lengths or angles, which no one can change; a Dask array as it is.

    What is NaN in it stays so, and is answered with NaN.

    Raises
    ------
    vad.errors.InputError
        For a number in it that `dimension` refuses.

    Examples
    --------
    >>> dimensions("crank", [40, -4], signed=False)
    Traceback (most recent call last):
    vad.errors.InputError: crank: must be positive, got -4
    """
    if is_lazy(value):
        if value.dtype.kind not in "iuf":
            raise InputError(f"{name}: must be an array of numbers, got one of {value.dtype}")
        return value
    found = array(name, value)
    known = found[found == found]
    for each in (known.min(), known.max(), known[abs(known).argmin()]) if known.size else ():
        dimension(name, float(each), signed=signed)
    found.flags.writeable = False
    return found


def dimension(name: str, value: object, *, signed: bool) -> float:
    """Return a length or an angle as a float; it is positive unless ``signed``.

    Raises
    ------
    vad.errors.InputError
        If it is no finite number, or beyond `SHORTEST` and `LONGEST`; what is ``signed`` may be as
        small as it likes.

    Examples
    --------
    >>> dimension("crank", -4, signed=False)
    Traceback (most recent call last):
    vad.errors.InputError: crank: must be positive, got -4
    """
    found = number(name, value)
    wrong = wrong_dimension(found, signed)
    if wrong:
        hint = None if wrong_dimension(-found, signed) else f"try {-found:g}"
        raise InputError(f"{_start(name)}{wrong}", hint)
    return found


def wrong_dimension(number: float, signed: bool) -> str | None:
    """Return what is wrong with a finite number as a dimension, or None.

    Examples
    --------
    >>> wrong_dimension(1e201, signed=True)
    'must be between 1e-200 and 1e+200, got 1e+201'
    """
    if not signed and number <= 0.0:
        return f"must be positive, got {number:g}"
    if (not signed and float(number) < SHORTEST) or abs(float(number)) > LONGEST:
        return f"must be between {SHORTEST:g} and {LONGEST:g}, got {number:g}"
    return None


def check_drawn(name: str, longest: float, unit: str) -> None:
    """Refuse a drawing whose longest vector no scale brings to a page; nothing at all is drawn.

    Raises
    ------
    vad.errors.InputError
        If it is beyond `SMALLEST_DRAWN` and `LARGEST_DRAWN`.

    Examples
    --------
    >>> check_drawn("velocity", 5e-310, "mm/s")
    Traceback (most recent call last):
    vad.errors.InputError: velocity: cannot be drawn, for its longest vector has 5e-310 mm/s
    """
    if longest and not SMALLEST_DRAWN <= longest <= LARGEST_DRAWN:
        said = f"cannot be drawn, for its longest vector has {longest:g} {unit}"
        raise InputError(f"{name}: {said}", "draw other panels, or with other rates")


def whole(name: str, value: object, least: int, most: int, hint: str | None = None) -> int:
    """Return a whole number between two others.

    Raises
    ------
    vad.errors.UsageError
        If it is none, or beyond them.

    Examples
    --------
    >>> whole("jobs", 0, 1, 64)
    Traceback (most recent call last):
    vad.errors.UsageError: jobs: must be a whole number from 1 to 64, got 0
    """
    found = index(value)
    if found is None or not least <= found <= most:
        wanted = f"must be a whole number from {least} to {most}"
        raise UsageError(f"{_start(name)}{wanted}, got {quoted(value)}", hint)
    return found


def flag(name: str, value: Any) -> bool:
    """Return whether something is wanted.

    Raises
    ------
    vad.errors.UsageError
        If it is neither true nor false.

    Examples
    --------
    >>> flag("subtitles", 1)
    True
    """
    kind = getattr(type(value), "__name__", "")
    found = int(value) if isinstance(value, bool) or kind in ("bool_", "bool") else index(value)
    if found not in (0, 1):
        raise UsageError(f"{_start(name)}must be True or False, got {quoted(value)}")
    return bool(found)


def index(value: Any) -> int | None:
    """Return a whole number of Python or numpy as an int; None for anything else.

    Examples
    --------
    >>> index(3), index(3.0), index(True)
    (3, None, None)
    """
    try:
        kind = getattr(value, "dtype", None)
        if isinstance(value, bool) or (kind is not None and kind.kind not in "iu"):
            return None
        return int(value.__index__())
    except Exception:  # it is no whole number, or its class is faulty
        return None


def line(name: str, value: object, longest: int = LONGEST_LINE) -> str:
    r"""Return a line of text.

    Raises
    ------
    vad.errors.InputError
        If it is no text, too long, or has a character that is not printed, which is named.

    Examples
    --------
    >>> line("title", "cam and\tlever")
    Traceback (most recent call last):
    vad.errors.InputError: title: must be a line of text, without U+0009
    """
    if not isinstance(value, str):
        raise InputError(f"{_start(name)}must be a line of text, got {quoted(value)}")
    if len(value) > longest:
        raise InputError(f"{_start(name)}has {len(value)} letters, and may have {longest}")
    for sign in value:
        if not sign.isprintable():
            raise InputError(f"{_start(name)}must be a line of text, without {_called(sign)}")
    return value


def filled(name: str, value: object, longest: int) -> str:
    """Return a line of text without spaces about it; errors are those of `line`.

    Raises
    ------
    vad.errors.InputError
        If there is nothing in it, too.
    """
    found = line(name, value, longest).strip()
    if not found:
        raise InputError(f"{_start(name)}is empty", "leave it out")
    return found


def check_folded(name: str) -> None:
    r"""Refuse a name that Python's parser would read as another one.

    Raises
    ------
    vad.errors.InputError
        If a letter of it is a form of other letters, as in the ligature of f and i.

    Examples
    --------
    >>> check_folded("\N{MICRO SIGN}")
    Traceback (most recent call last):
    vad.errors.InputError: µ: has U+00B5 MICRO SIGN, as no name may have
    """
    plain = unicodedata.normalize("NFKC", name)
    if plain == name:
        return
    folded = (each for each in name if unicodedata.normalize("NFKC", each) != each)
    odd = next(folded, None) or next(each for each in name if unicodedata.combining(each))
    codes = " ".join(f"U+{ord(each):04X}" for each in plain)
    raise InputError(f"{name}: has {_called(odd)}, as no name may have", f"write {plain} ({codes})")


def _called(sign: str) -> str:
    """Return the number and the name of a character."""
    return f"U+{ord(sign):04X} {unicodedata.name(sign, '')}".strip()


def function(name: str, value: object) -> Any:
    """Return a function, or None for none.

    Raises
    ------
    vad.errors.UsageError
        For anything else.
    """
    if value is not None and not callable(value):
        raise UsageError(f"{_start(name)}must be a function, got {quoted(value)}")
    return value


def several(name: str, value: object, wanted: str, hint: str | None = None) -> list[Any]:
    """Return the things in a list, a tuple or anything else that yields a few of them.

    A text counts as one thing.

    Raises
    ------
    vad.errors.UsageError
        If it yields nothing, or too much; ``wanted`` says in the message what it should be.

    Examples
    --------
    >>> several("panels", "velocity", "names of panels"), several("panels", (), "names of panels")
    (['velocity'], [])
    """
    if isinstance(value, str):
        return [value]
    try:
        if not isinstance(value, Iterable) or isinstance(value, bytes | bytearray | memoryview):
            raise TypeError
        found = list(islice(value, MOST_NAMES + 1))
    except Exception:  # a class may raise anything when it is asked for what is in it
        found = [None] * (MOST_NAMES + 1)
    if len(found) > MOST_NAMES:
        raise UsageError(f"{_start(name)}must be {wanted}, got {quoted(value)}", hint)
    return found


def path(name: str, value: object, wanted: str = "file", hint: str | None = None) -> str:
    """Return the name of a file or folder as a text.

    Raises
    ------
    vad.errors.UsageError
        If it is none.

    Examples
    --------
    >>> from pathlib import PurePosixPath
    >>> path("path", PurePosixPath("a/b.svg"))
    'a/b.svg'
    """
    try:
        found = os.fspath(value) if isinstance(value, str | os.PathLike) else None
    except Exception:  # a class may raise anything when it is asked for a path
        found = None
    if not isinstance(found, str):
        raise UsageError(f"{_start(name)}must be the name of a {wanted}, got {quoted(value)}", hint)
    return found


def text(place: str, longest: int, hint: Callable[[str], str | None] = lambda _: None) -> str:
    """Return the text of the file at a path, of at most so many bytes.

    Parameters
    ----------
    place
        The path, as `path` returns it.
    longest
        The most bytes.
    hint
        What gives the hint of an error from the path, if the file cannot be read.

    Raises
    ------
    vad.errors.InputError
        For a file that cannot be read, or is no text.
    """
    name = os.path.basename(place)
    try:
        with open(place, "rb") as file:
            return decoded(file.read(longest + 1), name, longest)
    except OSError as error:
        raise InputError(f"'{place}': {error.strerror or error}", hint(place)) from None
    except ValueError:
        raise InputError(f"{quoted(place)}: is no name of a file") from None


def decoded(data: bytes, name: str, longest: int) -> str:
    """Return bytes from outside, which errors call ``name``, as text of at most so many bytes.

    Raises
    ------
    vad.errors.InputError
        For more bytes, and for what is no text.

    Examples
    --------
    >>> decoded(b"crank = 40", "press.toml", 100)
    'crank = 40'
    """
    if len(data) > longest:
        raise InputError(f"{name}: is longer than {longest} bytes")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(f"{name}: is no text in UTF-8") from None


def _start(name: str) -> str:
    return f"{name}: " if name else ""
