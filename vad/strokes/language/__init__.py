"""The sentences of the captions: one file per language, chosen by its two-letter code."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cache
from importlib import import_module
from typing import Any

from vad.errors import one_of
from vad.found import names_in

#: The parts of a phrase that are names, and what each is where a language knows no more of it.
_GENERIC = {"link": "link", "slide": "slider"}
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
        self._names = _merged("NAMES", code)
        self._genders = _merged("GENDERS", code)
        self._articles: dict[str, dict[str, str]] = table.ARTICLES
        self.point: str = table.POINT
        self.upright: str = _upright(code)

    def say(self, phrase: str, **parts: Any) -> str:
        """Fill in one phrase; the names of links and slides are translated."""
        return self.filled(phrase, parts)

    def filled(self, phrase: str, parts: Mapping[str, Any]) -> str:
        """Fill in one phrase with parts by name, as `say` does."""
        nouns = {
            key: self.noun(parts[key], generic=generic)
            for key, generic in _GENERIC.items()
            if key in parts
        }
        return self._phrases[phrase].format_map({**parts, **nouns} if nouns else parts)

    def name(self, name: str) -> str:
        """Return a name or title in this language; one that it does not translate stays itself."""
        return self._names.get(name, name.replace("_", " "))

    def noun(self, name: str, of: str = "", generic: str = "link") -> Noun:
        """Return a name as sentences have it; one of unknown gender stands behind what it is."""
        if name in self._genders or not self._articles:
            return Noun(self.name(name), self._articles.get(self._genders.get(name, ""), {}), of)
        what = self.name(generic), self._articles[self._genders[generic]]
        return Noun(*what, f"{self.name(name)} {of}".rstrip())
