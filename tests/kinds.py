"""The program's mechanisms by name: those of the plane, and those in space."""

from __future__ import annotations

import vad
from vad.mechanisms.mechanism import MechanismInSpace

SPACE = {k: kind for k, kind in vad.MECHANISMS.items() if issubclass(kind, MechanismInSpace)}
PLANE = {name: kind for name, kind in vad.MECHANISMS.items() if name not in SPACE}


def all_kinds() -> list[type[vad.Mechanism]]:
    """Return the program's mechanisms, then those of the shipped examples."""
    from vad.files.examples import example_names, example_path

    return [*vad.MECHANISMS.values(), *(vad.load(example_path(each)) for each in example_names())]


KINDS = all_kinds()
