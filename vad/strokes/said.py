"""A phrase with its parts: numbers and units keep their places until it is known how they read."""

from __future__ import annotations

from collections.abc import Mapping

from vad.strokes.figures import Figures
from vad.strokes.language import Language


def filled(language: Language, figures: Figures, phrase: str, parts: Mapping[str, object]) -> str:
    """Return a phrase in which the places of numbers and units are kept."""
    return language.filled(phrase, parts, figures.kept)
