"""The lettered points of a panel while its mechanism moves.

In come the sheets of a turn, out go groups of letters that always share a dot, and where each
group is in any pose.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field, replace

from vad.plan.geometry import direction_of
from vad.plan.labels.vertices import COINCIDENT
from vad.plan.scale import Scale
from vad.strokes.sheet import Arrow, Dot, Panel

CORIOLIS = "2ωv"


@dataclass
class Spot:
    """One letter in one pose: its place, and the directions of the strokes that meet there."""

    at: complex
    ways: list[complex] = field(default_factory=list)


Spots = dict[str, Spot]


def spots(panel: Panel, scale: Scale, lasting: Collection[str] = ()) -> Spots:
    """Return the place of every letter on the page; `CORIOLIS` is amid the vector it names.

    Letters in ``lasting`` keep their place where their vectors are zero.
    """
    found: Spots = {}

    def meet(letters: str, z: complex, way: complex = 0j) -> None:
        for letter in (part.strip() for part in letters.split(",")):
            if letter:
                found.setdefault(letter, Spot(scale(z))).ways.append(way)

    for stroke in panel.strokes:
        shape = stroke.shape
        if isinstance(shape, Dot):
            meet(stroke.label, shape.at)
        elif isinstance(shape, Arrow):
            way = direction_of(shape.start, shape.end)
            meet(shape.tail, shape.start, way)
            meet(shape.head, shape.end, -way)
            if stroke.component == "coriolis":
                middle = scale((shape.start + shape.end) / 2)
                found[CORIOLIS] = Spot(middle, [-1j * way])
    kept = replace(panel, strokes=panel.zeros, zeros=())
    for letter, spot in spots(kept, scale).items() if lasting else ():
        if letter in lasting:
            found.setdefault(letter, Spot(spot.at, [0j]))
    return found


def groups(poses: Sequence[Spots]) -> list[tuple[str, ...]]:
    """Return the letters in groups that are in one place, as seen, in all poses."""
    letters = list(dict.fromkeys(letter for pose in poses for letter in pose))
    found: list[list[str]] = []
    for letter in letters:
        for group in found:
            if letter != CORIOLIS and _together(poses, group[0], letter):
                group.append(letter)
                break
        else:
            found.append([letter])
    return [tuple(group) for group in found]


def _together(poses: Sequence[Spots], one: str, other: str) -> bool:
    return one != CORIOLIS and all(
        abs(pose[one].at - pose[other].at) < COINCIDENT
        for pose in poses
        if one in pose and other in pose
    )


def grouped(pose: Spots, group: Sequence[str]) -> Spot | None:
    """Return where a group is in a pose, None where all its letters are missing."""
    here = [pose[letter] for letter in group if letter in pose]
    if not here:
        return None
    apart = list(dict.fromkeys(spot.at for spot in here))
    return Spot(sum(apart, 0j) / len(apart), [way for spot in here for way in spot.ways])
