"""A sheet as JSON and back: strokes in drawing order, and all else that a sheet holds.

The JSON of a `Sheet` is an object with a panel for each diagram.  Nothing is lost when it is read
again.  Coordinates are ``[x, y]`` in the panel's unit, printed in full.
"""

from __future__ import annotations

import json
import os
from collections import Counter
from collections.abc import Mapping
from typing import Any, BinaryIO

from vad import gate
from vad.errors import InputError
from vad.export.data.old_sheets import with_facts
from vad.export.data.records import within
from vad.export.data.sheet_form import SHEET
from vad.strokes.sheet import BELOW, Sheet
from vad.strokes.translation import as_written, translated

#: No sheet is longer; the longest that ships takes a hundredth of it.
_MOST_BYTES = 20_000_000


def write(
    sheet: Sheet,
    stream: BinaryIO,
    size: tuple[int, int] | None = None,
    style: str | None = None,
) -> None:
    """Write ``sheet`` to ``stream``, a stroke a line; how pictures look makes no difference."""
    stream.write(to_text(sheet).encode())


def to_dict(sheet: Sheet) -> dict[str, Any]:
    """Return ``sheet`` as dictionaries, lists, strings and numbers."""
    held: dict[str, Any] = SHEET.write(sheet)
    return held


def to_text(sheet: Sheet) -> str:
    """Return ``sheet`` as JSON with one stroke a line."""
    return _laid(to_dict(sheet), "\n ") + "\n"


def _laid(value: Any, line: str) -> str:
    """Return JSON in which every object of a list has a line of its own."""
    if _is_list(value):
        return "[" + ",".join(line + _text(each) for each in value) + "]"
    if isinstance(value, dict) and any(_is_list(v) or isinstance(v, dict) for v in value.values()):
        entries = (f"{_text(key)}: {_laid(each, line + ' ')}" for key, each in value.items())
        return "{" + ("," + line).join(entries) + "}"
    return _text(value)


def _is_list(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)


def _text(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def sheet_from_json(
    source: str | os.PathLike[str] | Mapping[str, Any], language: str | None = None
) -> Sheet:
    """Return the sheet that was saved as JSON.

    Parameters
    ----------
    source
        The name of a file, its text, or what ``json.load`` makes of it.
    language
        The language in which it is to be read, as a two-letter code; its own if None.  Texts that
        were saved without their sentences, or edited since, stay as they are.

    Raises
    ------
    vad.errors.UsageError
        For an unknown language.
    vad.errors.InputError
        If there is no such file, or it holds no whole sheet: the message says where.

    Examples
    --------
    >>> import vad
    >>> sheet = vad.draw(vad.solve(vad.FourBar()))
    >>> sheet_from_json(to_text(sheet)) == sheet
    True
    >>> sheet_from_json(to_text(sheet), language="de").title
    'Gelenkviereck'
    """
    name, data = _loaded(source)
    try:
        sheet: Sheet = as_written(SHEET.read(data, ""))
        _check(sheet)
    except RecursionError:
        raise InputError(f"{name}: sentences within sentences without an end") from None
    except InputError as error:
        raise InputError(f"{name}: {error}", hint="as vad draw … -o sheet.json writes it") from None
    sheet = sheet if "driver" in data else with_facts(sheet)
    return sheet if language is None else translated(sheet, language)


def _loaded(source: str | os.PathLike[str] | Mapping[str, Any]) -> tuple[str, Any]:
    """Return what a source is called, and what it holds."""
    if isinstance(source, Mapping):
        return "sheet", source
    written = gate.path("sheet", source, "file, or its text")
    is_text = isinstance(source, str) and written.lstrip().startswith(("{", "["))
    name = "sheet" if is_text else written
    try:
        text = written if is_text else _read(name)
        if len(text) > _MOST_BYTES:
            raise InputError(f"{name}: too long for a sheet: at most {_MOST_BYTES} bytes are read")
        return name, json.loads(text)
    except OSError as error:
        raise InputError(f"{name}: {error.strerror or 'cannot be read'}") from None
    except (ValueError, RecursionError) as error:  # no JSON, no UTF-8, or no name of a file
        raise InputError(f"{name}: not JSON: {error}".splitlines()[0]) from None


def _read(name: str) -> str:
    """Return the text of a file, and of a longer one than a sheet's no more than its beginning."""
    with open(name, "rb") as file:
        held = file.read(_MOST_BYTES + 1)
    return held.decode("utf-8") if len(held) <= _MOST_BYTES else held.decode("latin-1")


def _check(sheet: Sheet) -> None:
    """Raise an error if a stroke is referred to by a name that no stroke has."""
    if not sheet.panels:
        raise InputError("panels: there is none")
    for panel in sheet.halves:
        place = within("panels", panel.name)
        if panel.below and panel.below.name != panel.name + BELOW:
            raise InputError(f"{place}.below.name: must be {panel.name + BELOW!r}")
        times = Counter(stroke.name for stroke in (*panel.strokes, *panel.zeros))
        for name in times:
            if times[name] > 1:
                raise InputError(f"{place}: two strokes are called {name!r}")
        drawn = {stroke.name for stroke in panel.strokes}
        sums = [terms for each in panel.equations for terms in (each.left, each.right)]
        called = [term.stroke for terms in sums for term in terms if term.stroke is not None]
        for name in called + ([panel.inset.stroke] if panel.inset else []):
            if name not in drawn:
                raise InputError(f"{place}: no stroke is called {name!r}")
