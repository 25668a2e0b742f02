"""What the parameters of a mechanism are called in a language, on pages and in the window."""

from __future__ import annotations

from typing import TYPE_CHECKING

from vad.units import DIMENSIONS
from vad.words import Language

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism


def is_borne(kind: type[Mechanism], name: str) -> bool:
    """Tell whether a parameter is a number of a load or a mass: its radius of gyration, too."""
    known = kind.__dataclass_fields__
    owner, _, what = name.rpartition("_")
    gyration = not kind.is_rotor and what == "radius" and f"{owner}_mass" in known
    return gyration or (name in known and known[name].metadata["quantity"] not in DIMENSIONS)


def word_of(kind: type[Mechanism], name: str) -> str:
    """Return the word for a parameter: the radius of an engine is that of its crank."""
    return "crank" if kind.is_rotor and name == "radius" else name


def parameter_name(kind: type[Mechanism], name: str, say: Language) -> str:
    """Return what a parameter is called: of a load or a mass, whose it is and what.

    Examples
    --------
    >>> from vad.mechanisms import MECHANISMS
    >>> parameter_name(MECHANISMS["slider-crank"], "rod", Language("fr"))
    'bielle'
    """
    owner, _, what = name.rpartition("_")
    if owner and not kind.is_rotor and is_borne(kind, name):
        return say.name(owner) + say.say("colon") + say.name(what)
    return say.name(word_of(kind, name))
