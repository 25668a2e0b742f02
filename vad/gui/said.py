"""Errors in the language of the window.

The program says what is wrong in English.  The window says it in its own language, where the table
``ERRORS`` of that language has the sentence: each English sentence with its gaps, and what is said
in its place.  Of several that fit, it is the one with the longest fixed text.  A gap may be such a
sentence itself.  What the table has not is left as it is.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import fields
from functools import lru_cache, reduce
from string import Formatter

from vad.mechanisms import Mechanism
from vad.strokes.parameter_names import parameter_name
from vad.words import Language, all_languages

_POINT = re.compile(r"(?<=\d)\.(?=\d)")
#: What parts two numbers, where a comma would begin decimals.
_COMMA = re.compile(r"(?<=\d),(?= -?\d)")
#: What parts names of which one is meant, as in "the crank or the rocker"; no word within quotes.
_OR = re.compile(r" or (?:the )?(?=[^']*$)")
#: Gaps that are lines of a file or of a command: there a decimal sign is a point.
_CODE = ("example", "examples", "last", "line", "table")
#: Where something stands in a file.
_LINE = re.compile(r".+, line \d+")


def labels(kind: type[Mechanism] | None, say: Language) -> dict[str, str]:
    """Return what the parameters and the inputs of a mechanism are called."""
    if kind is None:
        return {}
    inputs = {name: say.page("WINDOW")[name] for name in (*kind.inputs, "assembly")}
    return {each.name: parameter_name(kind, each.name, say) for each in fields(kind)} | inputs


def translated(sentence: str, names: Mapping[str, str], say: Language) -> str:
    """Return what an error says in a language; ``names`` is what parameters are called in it.

    Examples
    --------
    >>> translated("rod: must be positive, got -4.5", {"rod": "Pleuel"}, Language("de"))
    'Pleuel: muss positiv sein, nicht -4,5'
    """
    return _said(sentence, names, say, within=True)


def _said(sentence: str, names: Mapping[str, str], say: Language, *, within: bool) -> str:
    """Return what a sentence says; ``within`` its gaps there may be sentences, but no deeper."""
    name, colon, rest = sentence.partition(": ")
    if colon and (name in names or _LINE.fullmatch(name)):
        place = names.get(name) or _said(name, names, say, within=False)
        return place + say.say("colon") + _said(rest, names, say, within=within)
    table = say.page("ERRORS")
    for english in _longest_first(tuple(table)):
        said, found = table[english], _pattern(english).fullmatch(sentence)
        if found:
            texts = found.groupdict().items()
            gaps = {
                gap: text if gap in _CODE else _gap(text, names, say, within=within)
                for gap, text in texts
            }
            return said.format(**gaps)
    if colon:
        parts = [_said(each, names, say, within=within) for each in (name, rest)]
        return say.say("colon").join(parts) if parts != [name, rest] else sentence
    first, semicolon, last = sentence.partition("; ")
    if semicolon:
        return "; ".join(_said(each, names, say, within=within) for each in (first, last))
    return sentence


def sayer(accepted: str) -> Callable[[str], str]:
    """Return how sentences are said to a browser, by the language that it accepts first."""
    code = accepted[:2].lower()
    if code not in all_languages():
        return str
    say = Language(code)
    return lambda sentence: translated(sentence, {}, say)


def _gap(text: str, names: Mapping[str, str], say: Language, *, within: bool) -> str:
    """Return the text of a gap: a name, numbers, a sentence of the table, or several of them."""
    either = say.page("HAND")["or"]

    def own(part: str) -> str:
        return names.get(part) or (_said(part, names, say, within=False) if within else part)

    found = own(text)
    if found == text:
        parts = (either.join(map(own, _OR.split(part))) for part in text.split(" and "))
        found = reduce(lambda first, last: say.say("and", first=first, last=last), parts)
    if say.point != "." and _POINT.search(found) and "[" not in found:
        found = _COMMA.sub(";", found)
    return _POINT.sub(say.point, found)


@lru_cache(maxsize=8)
def _longest_first(sentences: tuple[str, ...]) -> list[str]:
    """Return sentences in the order of their fixed texts, the longest first."""
    return sorted(sentences, key=lambda each: -len(re.sub(r"{\w+}", "", each)))


@lru_cache(maxsize=512)
def _pattern(english: str) -> re.Pattern[str]:
    """Return what finds the gaps of a sentence; a gap that stands twice has one text."""
    found, known = "", set[str]()
    for text, gap, *_ in Formatter().parse(english):
        found += re.escape(text)
        if gap:
            own = ".+?" if found else r"(?:(?!: ).)+?(?<!:)"  # what is before a colon comes later
            found += f"(?P={gap})" if gap in known else f"(?P<{gap}>{own})"
            known.add(gap)
    return re.compile(found)
