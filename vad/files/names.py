"""The names of a file in other languages: ``[names.de]`` with ``link_rod = "das Nebenpleuel"``.

The title is one of them.  An article says the gender, where a language has one.  Keys of results
and options stay as they are in the file.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from vad import gate
from vad.errors import quoted, unknown
from vad.files.tables import LONGEST_NAME, Source

TABLE = "names"
#: The key of the title.
TITLE = "title"
#: The most letters of a name, and of a title.
LONGEST, LONGEST_TITLE = LONGEST_NAME, 80
_CODE = re.compile("[a-z]{2}")


def own_names(source: Source, title: str, known: Iterable[str]) -> dict[str, dict[str, str]]:
    """Return the names of a file by language and by what they are in the file.

    Parameters
    ----------
    source
        The file.
    title
        Its title, which has a name under the key "title".
    known
        What can have a name: links, slides, dimensions.

    Raises
    ------
    vad.errors.InputError
        With its place, for a language that is none, and for a name that is not in the file.
    """
    words = dict.fromkeys([TITLE, *known])
    found = {code: _of(source, code, table, words) for code, table in source.table(TABLE).items()}
    return {
        code: {title if name == TITLE else name: said for name, said in names.items()}
        for code, names in found.items()
    }


def _of(source: Source, code: str, table: object, known: Iterable[str]) -> dict[str, str]:
    if not _CODE.fullmatch(code):
        hint = "the two letters of a language, as in [names.de]"
        raise source.error(TABLE, code, f"names: {quoted(code)} is no language", hint)
    if not isinstance(table, Mapping):
        message = f"names.{code}: must be a table, got {quoted(table)}"
        raise source.error(TABLE, code, message, f"write [names.{code}] and below it crank = '…'")
    names: dict[str, str] = {}
    for name, said in table.items():
        place = f"{TABLE}.{code}"
        if name not in known:
            wrong = unknown(f"name in names.{code}", name, known)
            raise source.error(place, name, str(wrong), wrong.hint)
        with source.at(place, name):
            text = gate.line(name, said, LONGEST_TITLE if name == TITLE else LONGEST)
        if not text.strip():
            raise source.error(place, name, f"{name}: is empty", "write a name, or leave it out")
        names[name] = text.strip()
    return names
