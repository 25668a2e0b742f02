"""Errors in the language of the window.

The program says what is wrong in English.  The window says it in its own language, where the table
``ERRORS`` of that language has the sentence: each English sentence with its gaps, and what is said
in its place.  A sentence that it has not is left as it is.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import Field, fields
from functools import lru_cache, reduce
from string import Formatter
from typing import Any

from vad.mechanisms import Mechanism
from vad.units import DIMENSIONS
from vad.words import Language, all_languages

_POINT = re.compile(r"(?<=\d)\.(?=\d)")
#: Where something stands in a file, and what it is about there.
_LINE, _NAME = re.compile(r".+, line \d+"), re.compile(r"[\w.\[\]]+")


def label(field: Field[Any], say: Language) -> str:
    """Return what a parameter is called: of a load or a mass, whose it is and what."""
    owner, _, what = field.name.rpartition("_")
    if field.metadata["quantity"] in DIMENSIONS or not owner:
        return say.name(field.name)
    return say.name(owner) + say.say("colon") + say.name(what)


def labels(kind: type[Mechanism] | None, say: Language) -> dict[str, str]:
    """Return what the parameters and the inputs of a mechanism are called."""
    if kind is None:
        return {}
    inputs = {name: say.page("WINDOW")[name] for name in (*kind.inputs, "assembly")}
    return {field.name: label(field, say) for field in fields(kind)} | inputs


def translated(sentence: str, names: Mapping[str, str], say: Language) -> str:
    """Return what an error says in a language; ``names`` is what parameters are called in it.

    Examples
    --------
    >>> translated("rod: must be positive, got -4.5", {"rod": "Pleuel"}, Language("de"))
    'Pleuel: muss positiv sein, nicht -4,5'
    """
    name, colon, rest = sentence.partition(": ")
    if colon and (name in names or _LINE.fullmatch(name)):
        place = names.get(name) or translated(name, names, say)
        return place + say.say("colon") + translated(rest, names, say)
    for english, said in say.page("ERRORS").items():
        found = _pattern(english).fullmatch(sentence)
        if found:
            gaps = {gap: _gap(text, names, say) for gap, text in found.groupdict().items()}
            return said.format(**gaps)
    if colon and _NAME.fullmatch(name):
        return name + say.say("colon") + translated(rest, names, say)
    return sentence


def sayer(accepted: str) -> Callable[[str], str]:
    """Return how sentences are said to a browser, by the language that it accepts first."""
    code = accepted[:2].lower()
    if code not in all_languages():
        return str
    say = Language(code)
    return lambda sentence: translated(sentence, {}, say)


def _gap(text: str, names: Mapping[str, str], say: Language) -> str:
    """Return the text of a gap: a name, numbers, or several parts."""
    parts = [names.get(part, part) for part in text.split(" and ")]
    found = reduce(lambda first, last: say.say("and", first=first, last=last), parts)
    return _POINT.sub(say.point, found)


@lru_cache(maxsize=256)
def _pattern(english: str) -> re.Pattern[str]:
    """Return what finds the gaps of a sentence; a gap that stands twice has one text."""
    found, known = "", set[str]()
    for text, gap, *_ in Formatter().parse(english):
        found += re.escape(text)
        if gap:
            found += f"(?P={gap})" if gap in known else f"(?P<{gap}>.+?)"
            known.add(gap)
    return re.compile(found)
