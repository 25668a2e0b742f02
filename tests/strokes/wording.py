"""How each language says a direction, written down apart from the captions.

A new language takes an entry here; without one, its captions are not understood.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from re import Pattern


@dataclass(frozen=True)
class Wording:
    """The words of one language, and the clauses in which they stand.

    ``ways`` and ``senses`` are words with what they mean.  Of the clauses, ``towards`` names the
    points between which a normal part runs, ``seen``, ``own`` and ``sideways`` a point that moves
    some way, as seen from another one, by itself or across a bar, ``square`` a bar, ``with_it``
    the rate in whose sense a vector points, ``turned`` says Coriolis' rule, ``slotted`` names two
    points on a line along the slot, ``whose`` the points of a whole vector, ``bound`` who can
    move no other way relative to whom, and ``carried`` the lever or slot on which a block can
    move no other way.
    """

    ways: Mapping[str, complex]
    senses: Mapping[str, int]
    towards: Pattern[str]
    seen: Pattern[str]
    own: Pattern[str]
    sideways: Pattern[str]
    square: Pattern[str]
    with_it: Pattern[str]
    turned: Pattern[str]
    slotted: Pattern[str]
    whose: Pattern[str]
    bound: Pattern[str]
    carried: Pattern[str]
    guide: Pattern[str]
    slot: str
    other_side: str

    def way(self, text: str) -> complex:
        """Return the one direction that a text names."""
        (found,) = _found(self.ways, text)
        return self.ways[found]

    def sense(self, text: str) -> int:
        """Return the one sense that a text names."""
        (found,) = _found(self.senses, text)
        return self.senses[found]

    def count(self, text: str) -> tuple[int, int]:
        """Return how many directions and how many senses a text names."""
        return len(_found(self.ways, text)), len(_found(self.senses, text))


def _found(words: Mapping[str, object], text: str) -> list[str]:
    # "clockwise" is the end of "counter-clockwise": the longest word is tried first.
    return re.findall("|".join(sorted(words, key=len, reverse=True)), text)


WORDING = {
    "en": Wording(
        ways={"to the right": 1, "to the left": -1, "upwards": 1j, "downwards": -1j},
        senses={"counter-clockwise": 1, "clockwise": -1},
        towards=re.compile("from (?P<tail>[A-Z]) towards (?P<head>[A-Z])"),
        seen=re.compile("(?P<head>[A-Z]) moves (?P<way>.+) as seen from (?P<tail>[A-Z])"),
        own=re.compile(": (?P<head>[A-Z]) moves (?P<way>[^:]+)[.]$"),
        sideways=re.compile("across (?P<bar>[A-Z]{2}), (?P<head>[A-Z]) moves (?P<way>.+)[.]"),
        square=re.compile("(?:perpendicular to|⟂) (?P<bar>[A-Z]{2})"),
        with_it=re.compile("in the sense of (?P<rate>[ωα])"),
        turned=re.compile("Coriolis acceleration: v turned 90° in the sense of (?P<omega>ω.)"),
        slotted=re.compile("passes through (?P<tail>[A-Z]), and (?P<head>[A-Z]) lies on its line"),
        whose=re.compile(
            "the (?:velocity|acceleration) of (?P<head>[A-Z])(?: relative to (?P<tail>[A-Z]))?"
        ),
        bound=re.compile("relative to (?P<tail>[A-Z]), (?P<head>[A-Z]) can move no other way"),
        carried=re.compile(r"(?:on|in) the (?P<carrier>\w+) the \w+ [A-Z] can move no other way"),
        guide=re.compile("guide(?: of (?P<head>[A-Z]))?$"),
        slot="slot",
        other_side="beyond",
    ),
    "de": Wording(
        ways={"nach rechts": 1, "nach links": -1, "nach oben": 1j, "nach unten": -1j},
        senses={"gegen den Uhrzeigersinn": 1, "im Uhrzeigersinn": -1},
        towards=re.compile("von (?P<tail>[A-Z]) nach (?P<head>[A-Z])"),
        seen=re.compile("von (?P<tail>[A-Z]) aus gesehen läuft (?P<head>[A-Z]) (?P<way>.+)[.]"),
        own=re.compile(": (?P<head>[A-Z]) läuft (?P<way>[^:]+)[.]$"),
        sideways=re.compile("quer zu (?P<bar>[A-Z]{2}) läuft (?P<head>[A-Z]) (?P<way>.+)[.]"),
        square=re.compile("(?:senkrecht zu|⟂) (?P<bar>[A-Z]{2})"),
        with_it=re.compile("im Drehsinn von (?P<rate>[ωα])"),
        turned=re.compile("Coriolisbeschleunigung: v um 90° im Drehsinn von (?P<omega>ω.) gedreht"),
        slotted=re.compile(
            "geht durch (?P<tail>[A-Z]), und (?P<head>[A-Z]) liegt auf seiner Geraden"
        ),
        whose=re.compile(
            "die (?:Geschwindigkeit|Beschleunigung) von (?P<head>[A-Z])"
            "(?: relativ zu (?P<tail>[A-Z]))?"
        ),
        bound=re.compile("relativ zu (?P<tail>[A-Z]) bewegt sich (?P<head>[A-Z]) nur so"),
        carried=re.compile(r"(?:auf der|im) (?P<carrier>\w+) kann der \w+ [A-Z] nur so gleiten"),
        guide=re.compile("Führung(?: von (?P<head>[A-Z]))?$"),
        slot="Schlitz",
        other_side="jenseits von",
    ),
    "fr": Wording(
        ways={"vers la droite": 1, "vers la gauche": -1, "vers le haut": 1j, "vers le bas": -1j},
        senses={"dans le sens trigonométrique": 1, "dans le sens horaire": -1},
        towards=re.compile("de (?P<tail>[A-Z]) vers (?P<head>[A-Z])"),
        seen=re.compile("vu de (?P<tail>[A-Z]), (?P<head>[A-Z]) se déplace (?P<way>.+)[.]"),
        own=re.compile(r"\s: (?P<head>[A-Z]) se déplace (?P<way>[^:]+)[.]$"),
        sideways=re.compile(
            "perpendiculairement à (?P<bar>[A-Z]{2}), (?P<head>[A-Z]) se déplace (?P<way>.+)[.]"
        ),
        square=re.compile("(?:perpendiculairement à|perpendiculaire à|⟂) (?P<bar>[A-Z]{2})"),
        with_it=re.compile("dans le sens de (?P<rate>[ωα])"),
        turned=re.compile(
            r"accélération de Coriolis\s: v tournée de 90° dans le sens de (?P<omega>ω.)"
        ),
        slotted=re.compile("passe par (?P<tail>[A-Z]), et (?P<head>[A-Z]) est sur son axe"),
        whose=re.compile(
            "(?:la vitesse|l’accélération) de (?P<head>[A-Z])(?: par rapport à (?P<tail>[A-Z]))?"
        ),
        bound=re.compile(
            "par rapport à (?P<tail>[A-Z]), (?P<head>[A-Z]) ne peut pas se déplacer autrement"
        ),
        carried=re.compile(
            r"(?:sur|dans) la (?P<carrier>\w+), le \w+ [A-Z] ne peut pas se déplacer autrement"
        ),
        guide=re.compile("glissière(?: de (?P<head>[A-Z]))?$"),
        slot="rainure",
        other_side="au-delà de",
    ),
}
