"""What a scene says, in the plane and in space alike: phrases, and captions if they are wanted."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from vad.strokes.figures import Figures
from vad.strokes.language import Language


@dataclass(frozen=True)
class Saying:
    """A motion, the language of what is said of it, and the figures in that."""

    motion: Any
    language: Language
    captioned: bool = True
    figures: Figures = field(default_factory=Figures)

    def say(self, phrase: str, **parts: object) -> str:
        """Fill in a phrase, in which the places of numbers and units are kept."""
        return self.language.say(phrase, **parts)

    def caption(self, phrase: str, **parts: object) -> str:
        """Return the sentence that goes with a stroke; none where captions are not wanted."""
        return self.say(phrase, **parts) if self.captioned else ""
