"""The sentences of the captions: one file per language, chosen by its two-letter code."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from vad.errors import one_of
from vad.found import names_in


def languages() -> tuple[str, ...]:
    """Return the codes of the languages that there are."""
    return names_in("strokes", "language")


class Language:
    """The phrases of one language.

    ``article`` is the word that is also the name of a point: "a" in English.

    Examples
    --------
    >>> Language("en").say("found", letter="C")
    'C is where they meet.'
    """

    def __init__(self, code: str) -> None:
        table = import_module(f"{__name__}.{one_of('language', code, languages())}")
        self.code = code
        self._phrases: dict[str, str] = table.PHRASES
        self._names: dict[str, str] = table.NAMES
        self.article: str = table.ARTICLE

    def say(self, phrase: str, **parts: Any) -> str:
        """Fill in one phrase; the names of links and slides are translated."""
        for key in ("link", "slide"):
            if key in parts:
                parts[key] = self.name(parts[key])
        return self._phrases[phrase].format(**parts)

    def name(self, name: str) -> str:
        """Return a name or title in this language; one that it does not translate stays itself."""
        return self._names.get(name, name.replace("_", " "))
