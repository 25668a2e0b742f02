"""The polygons of the ball-jointed four-bar in its third view: letter by letter the four-bar's.

In comes the scene of a pose, out goes a polygon.  What b stands above the paper is told where it
counts: BC keeps its length, so that c lies in a plane that this view sees as a line.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vad.kinematics.space.numbers import difference, dot
from vad.strokes.diagram import ORDERS, Drawing
from vad.strokes.player import Pencil, Player
from vad.strokes.scene import image_letter
from vad.strokes.space.balls_said import BallWords
from vad.strokes.space.balls_seen import TILT, Seen
from vad.strokes.space.body_rates import place
from vad.strokes.vector_equations import Chain, Part, Vector, VectorEquation, of_chains

if TYPE_CHECKING:
    from vad.strokes.sheet import Component
    from vad.strokes.space.scene_in_space import SceneInSpace

_NORMAL = "ₙ"


def tracks(seen: Seen, order: int) -> Mapping[str, Any]:
    """Return where the vertices of a polygon are."""
    quantity = ORDERS[order].panel
    found = {letter: seen.third(place(seen.motion, letter, quantity)) for letter in "ABCD"}
    return {image_letter(letter, order): at for letter, at in found.items()}


def polygon(scene: SceneInSpace, seen: Seen, order: int) -> Drawing:
    """Return the velocity (order 1) or acceleration (order 2) polygon of a pose."""
    places = tracks(seen, order)
    equation = _equation(scene, seen, order, places)
    a, d = (image_letter(letter, order) for letter in "AD")
    words = BallWords(scene, seen, order)
    pencil: Pencil[Vector] = Pencil(words, places.__getitem__, equation.longest, [a, d])
    pencil.begin(words.pole(pencil.resting), tuple(scene.headings) if pencil.resting else ())
    player: Player[Vector] = Player(pencil)
    first, second = player.play(equation)
    return Drawing(
        tuple(pencil.strokes),
        tuple(pencil.zeros),
        () if pencil.resting else (of_chains(first.side, second.side),),
        loops=tuple(player.begins),
        remark=scene.write("balls remark"),
        coincident=pencil.coincident,
    )


def _equation(
    scene: SceneInSpace, seen: Seen, order: int, places: Mapping[str, complex]
) -> VectorEquation[Vector]:
    """Return ab + bc = dc with the parts of each vector."""
    a, b, c, d = (image_letter(letter, order) for letter in "ABCD")
    wholes: tuple[Component | None, ...] = (None,) * 3
    if order == 2:
        wholes = "absolute", "relative", "absolute"
    ab = Vector("AB", a, b, "crank", whole=wholes[0])
    bc = Vector("BC", b, c, "coupler", whole=wholes[1])
    dc = Vector("DC", d, c, "rocker", whole=wholes[2])
    path = seen.third(seen.path)
    across = 1j * TILT
    along_path = scene.write("parallel", line=scene.say("balls path"))
    normals = dict.fromkeys("BC", 0j) if order == 1 else _normals(seen)
    relative = dict.fromkeys(("AB", "BC", "DC"), 0j)
    relative |= {"AB": places[b], "BC": places[c] - places[b], "DC": places[c]}
    parts = []
    for vector, direction, label in (
        (ab, None, ""),
        (bc, across, "⟂ BC"),
        (dc, path, along_path),
    ):
        unknown = direction is not None
        normal = normals.get(vector.name, 0j)
        rest = relative[vector.name] - normal
        if order == 2:
            stage = (c[:1] if unknown else b) + _NORMAL
            parts.append(_part(vector, "normal", normal, _way(normal), stage))
        stage = vector.head
        parts.append(
            _part(
                vector,
                "tangential",
                rest,
                _way(rest) if direction is None else direction,
                stage,
                unknown=unknown,
                label=label,
                square_to="BC" if vector is bc else None,
            )
        )
    first = [part for part in parts if part.of is not dc]
    second = [part for part in parts if part.of is dc]
    return VectorEquation(
        Chain(a, c, (ab, bc), tuple(first)), Chain(d, c, (dc,), tuple(second)), "C"
    )


def _part(
    vector: Vector,
    name: Component,
    value: complex,
    direction: complex,
    stage: str,
    unknown: bool = False,
    label: str = "",
    square_to: str | None = None,
) -> Part[Vector]:
    return Part(
        vector,
        name,
        value,
        direction,
        unknown,
        name,
        stage,
        dictated=vector.name == "AB",
        label=label,
        square_to=square_to,
    )


def _way(vector: complex) -> complex:
    return vector / abs(vector) if vector else 1.0 + 0j


def _normals(seen: Seen) -> dict[str, complex]:
    """Return the normal components as the third view sees them."""
    motion = seen.motion
    at, turning = seen.at, {name: motion.link(name).omega for name in ("crank", "rocker")}
    crank, coupler, rocker = (difference(at[b], at[a]) for a, b in ("AB", "BC", "DC"))
    relative = difference(place(motion, "C", "velocity"), place(motion, "B", "velocity"))
    return {
        "AB": -(turning["crank"] ** 2) * seen.third(crank),
        "BC": -TILT * dot(relative, relative) / math.sqrt(dot(coupler, coupler)),
        "DC": -(turning["rocker"] ** 2) * seen.third(rocker),
    }
