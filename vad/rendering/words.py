"""The few words that the painter itself writes, per language.

In comes the language of a sheet, out goes a `Words`.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Words:
    """What stands on the page beside the sheet's own text."""

    panels: dict[str, str]
    results: str
    given: str
    coriolis: str
    article: str = ""  # where it is also the name of a point


WORDS = {
    "en": Words(
        {"position": "Position", "velocity": "Velocity", "acceleration": "Acceleration"},
        "Results",
        "given",
        "Coriolis: v turned 90° with ω",
        article="a",
    ),
    "de": Words(
        {
            "position": "Lage",
            "velocity": "Geschwindigkeit",
            "acceleration": "Beschleunigung",
        },
        "Ergebnisse",
        "gegeben",
        "Coriolis: v um 90° mit ω gedreht",
    ),
}


def words(language: str) -> Words:
    """Return the words of a language, English where it is not known."""
    return WORDS.get(language, WORDS["en"])
