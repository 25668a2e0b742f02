"""A phrase with its parts: numbers and units keep their places until it is known how they read."""

from __future__ import annotations

from collections.abc import Mapping

from vad.strokes.figures import PLACED, Figures
from vad.strokes.language import Language


def filled(language: Language, figures: Figures, phrase: str, parts: Mapping[str, object]) -> str:
    """Return a phrase in which the places of numbers and units are kept."""
    kept = {
        name: figures.place(part) if isinstance(part, PLACED) else part
        for name, part in parts.items()
    }
    return language.filled(phrase, kept)
