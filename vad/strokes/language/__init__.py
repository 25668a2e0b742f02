"""The sentences of the captions: one file per language, chosen by its two-letter code."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from functools import cache, lru_cache
from importlib import import_module
from operator import itemgetter
from string import Formatter
from typing import Any

from vad.errors import one_of
from vad.found import names_in

#: The parts of a phrase that are names, and what each is where a language knows no more of it.
_GENERIC = {"link": "link", "slide": "slider"}
#: A part as it stands in a pattern, its name and its form.
_Formed = tuple[str, str, str]
#: Where the words for mechanisms in space are.
_SPACE = ("strokes", "space", "words")


def languages() -> tuple[str, ...]:
    """Return the codes of the languages that there are."""
    return names_in("strokes", "language")


@cache
def _tables(code: str) -> tuple[Any, ...]:
    """Return the words of a language: its own file, and one for each mechanism in space."""
    names = [name for name in names_in(*_SPACE) if name.endswith(f"_{code}")]
    in_space = (".".join(("vad", *_SPACE, name)) for name in names)
    return tuple(map(import_module, (f"{__name__}.{code}", *in_space)))


@cache
def _upright(code: str) -> str:
    """Return the pattern of the words of a language that are also names of points or vectors."""
    short = _short(_merged("PHRASES", code).values())
    return "|".join(filter(None, (_tables(code)[0].UPRIGHT, short)))


@cache
def _merged(name: str, code: str) -> Mapping[str, str]:
    """Return a table of words of a language, those of the mechanisms in space included."""
    return {key: value for table in _tables(code) for key, value in getattr(table, name).items()}


@cache
def _pattern(phrase: str) -> tuple[str, Callable[[Mapping[str, Any]], object], list[_Formed]]:
    """Return a phrase as a pattern, what picks its parts, and those that are put in a form first.

    Filling in a pattern takes a fraction of what `str.format` takes.
    """
    pattern, names, formed = "", [], []
    for text, name, form, _ in Formatter().parse(phrase):
        pattern += text.replace("%", "%%")
        if name is None:
            continue
        pattern += "%s"
        plain = not form and name not in _GENERIC
        names.append(name if plain else f"{name}:{form}")
        if not plain:
            formed.append((names[-1], name, form or ""))
    return pattern, itemgetter(*names) if names else lambda parts: (), formed


def _short(phrases: Iterable[str]) -> str:
    """Return the pattern of the short words of a language, where they name no vector."""
    bare = " ".join(re.sub(r"{.*?}", "", phrase) for phrase in phrases)
    words = "|".join(sorted(set(re.findall(r"\b[a-z]{2,3}\b", bare))))
    return rf"(?:{words})\b(?! =|[·/′]| (?:is|ist|est)\b)"


class Noun:
    """A name in a sentence: a phrase asks by ``{link:Der}`` for it with the article that it takes.

    Parameters
    ----------
    name
        The name alone.
    forms
        What becomes of it by the article that a phrase asks for: ``{"der": "die {}"}``.
    of
        What follows it, whatever its form: "of A".
    """

    def __init__(self, name: str, forms: Mapping[str, str], of: str = "") -> None:
        self._name, self._forms, self._of = name, forms, of

    def __format__(self, form: str) -> str:
        text = self._forms[form.lower()].format(self._name) if form else self._name
        text = text[0].upper() + text[1:] if form[:1].isupper() else text
        return f"{text} {self._of}" if self._of else text

    def __str__(self) -> str:
        return format(self)


@lru_cache(maxsize=256)
def _name(code: str, name: str) -> str:
    return _merged("NAMES", code).get(name, name.replace("_", " "))


@lru_cache(maxsize=256)
def _noun(code: str, name: str, of: str, generic: str) -> Noun:
    genders = _merged("GENDERS", code)
    articles: Mapping[str, Mapping[str, str]] = _tables(code)[0].ARTICLES
    if name in genders or not articles:
        return Noun(_name(code, name), articles.get(genders.get(name, ""), {}), of)
    of = f"{_name(code, name)} {of}".rstrip()
    return Noun(_name(code, generic), articles[genders[generic]], of)


class Language:
    """The phrases of one language.

    ``point`` is its decimal sign, ``upright`` the pattern of words that are also names of points
    or vectors: "a" in English.

    Examples
    --------
    >>> Language("en").say("crossing", letter="c")
    'c is where the two lines cross.'
    >>> Language("de").say("bar", link="rod", bar="BC", symbol="θ₃", angle="18,4")
    'Die Stange BC steht bei θ₃ = 18,4°.'
    """

    def __init__(self, code: str) -> None:
        table = _tables(one_of("language", code, languages()))[0]
        self.code = code
        self._phrases = _merged("PHRASES", code)
        self.point: str = table.POINT
        self.upright: str = _upright(code)

    def say(self, phrase: str, **parts: Any) -> str:
        """Fill in one phrase; the names of links and slides are translated."""
        pattern, wanted, formed = _pattern(self._phrases[phrase])
        for key, name, form in formed:
            part = parts[name]
            if name in _GENERIC:
                part = self.noun(part, generic=_GENERIC[name])
            parts[key] = format(part, form)
        return pattern % wanted(parts)

    def name(self, name: str) -> str:
        """Return a name or title in this language; one that it does not translate stays itself."""
        return _name(self.code, name)

    def noun(self, name: str, of: str = "", generic: str = "link") -> Noun:
        """Return a name as sentences have it; one of unknown gender stands behind what it is."""
        return _noun(self.code, name, of, generic)
