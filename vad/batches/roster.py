"""A roster: columns of a table of sheets that are no options, such as the names of students.

They are carried into the names of files, the titles of sheets and the answers.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Mapping
from unicodedata import normalize

from vad.errors import unknown

#: From this likeness on a column is a misspelt option, and no column of a roster.
_NEAR = 0.78
#: The most bytes of a roster in the name of a file, which with its number and the longest name that
#: sheets may have is still one for every system.
_LONGEST = 46
#: A table of answers, which is a table of sheets, too, has its results with units in brackets.
_RESULT = re.compile(r".* \[.*\]")
_NUMBER = "number"


def roster_columns(columns: Iterable[str], known: Iterable[str]) -> tuple[str, ...]:
    """Return the columns that are a roster.

    Parameters
    ----------
    columns
        The names of all columns.
    known
        Those that are options of one of the mechanisms, or words of sheets.

    Raises
    ------
    vad.errors.UsageError
        For a name that is nearly that of an option.

    Examples
    --------
    >>> roster_columns(["mechanism", "crank", "name", "group"], ["mechanism", "crank", "ground"])
    ('name', 'group')
    """
    options, found = set(known), []
    for column in columns:
        if column in options:
            continue
        if any(_alike(column.lower(), option) for option in options):
            raise unknown("column", column, sorted(options))
        if column and column != _NUMBER and not _RESULT.fullmatch(column):
            found.append(column)
    return tuple(found)


def _alike(name: str, option: str) -> bool:
    """Tell whether a name is an option's with a slip: a letter more or less, or two exchanged."""
    ratio = difflib.SequenceMatcher(None, name, option).ratio()
    return ratio >= _NEAR or sorted(name) == sorted(option)


def in_file_name(roster: Mapping[str, str]) -> str:
    """Return a roster as it stands in the name of a file: letters, digits and dashes.

    Examples
    --------
    >>> in_file_name({"name": "Ada King, Lovelace", "group": "B/2"})
    'Ada-King-Lovelace-B-2'
    """
    text = normalize("NFC", " ".join(roster.values()))
    words = re.findall(r"\w+", text)
    cut = "-".join(words).encode("utf-8", "ignore")[:_LONGEST].decode("utf-8", "ignore")
    return cut.rstrip("-")


def in_title(roster: Mapping[str, str]) -> str:
    """Return a roster as it stands behind a title.

    Examples
    --------
    >>> in_title({"name": "Ada King", "group": "B"})
    'Ada King, B'
    """
    return ", ".join(roster.values())
