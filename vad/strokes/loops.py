"""The loops of a linkage as vector equations, and the equations that are written under a panel.

Every step of a loop is a vector with its components.  A polygon draws the equation; the equation
under its panel is written from the vectors that are drawn.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, cast

from vad.kinematics.linkage import Bar, Loop, Scalar, Slide, Step, scalar_of
from vad.strokes.members import Members
from vad.strokes.scene import Scene, image_letter
from vad.strokes.sentences import Sentence, Text, Voice
from vad.strokes.sheet import Component, Equation, Plate, Stroke, Term
from vad.strokes.vector_equations import Chain, Part, Side, Vector, VectorEquation

SUBSCRIPT_N = "ₙ"


@dataclass(frozen=True, eq=False, kw_only=True)
class StepVector(Vector):
    """The vector of a step of the linkage."""

    step: Step


@dataclass(frozen=True, eq=False)
class _Outline:
    """The part of one side of a loop equation that is the same in all poses.

    ``forms`` holds, for each vector and the name of each component, the fields of its `Part` from
    ``unknown`` on.  ``late`` are the vectors whose Coriolis component is laid last.
    """

    start: str
    end: str
    forms: Mapping[StepVector, Mapping[str, tuple[Any, ...]]]
    late: tuple[StepVector, ...]


def equations_of(scene: Scene, order: int) -> list[VectorEquation[StepVector]]:
    """Return the equations of all loops of an order."""
    found = []
    for loop, sides in zip(
        scene.members.linkage.loops,
        _outlines(scene.members, scene.language.code, order),
        strict=True,
    ):
        first, second = (_chain(scene, side, order) for side in sides)
        found.append(VectorEquation(first, second, loop.first[-1].end))
    return found


def chain_of(scene: Scene, step: Step, order: int) -> Chain[StepVector]:
    """Return the chain of a step that is wholly known."""
    outline = _outline(scene.members, scene.voice, (step,), (), order)
    return _chain(scene, outline, order)


def owner(step: Step) -> str:
    """Return the row of the results table whose colour a step has."""
    return scalar_of(step).name


def _chain(scene: Scene, outline: _Outline, order: int) -> Chain[StepVector]:
    """Return one side of a loop equation in a pose."""
    frame, pose, rates = scene.members.frame, scene.pose, scene.orders(order)
    parts = []
    for vector, forms in outline.forms.items():
        for name, line, amount in frame.components(vector.step, pose, rates):
            direction = scene.heading(line)
            size = cast(float, amount) * frame.scale
            parts.append(Part(vector, name, size * direction, direction, *forms[name]))
    if outline.late:
        parts.sort(key=lambda part: part.name == "coriolis" and part.of in outline.late)
    return Chain(outline.start, outline.end, tuple(outline.forms), tuple(parts))


@lru_cache(maxsize=256)
def _outlines(members: Members, code: str, order: int) -> list[tuple[_Outline, _Outline]]:
    """Return both sides of the equation of every loop in a language."""
    voice = Voice(code, names=members.names)
    return [
        (
            _outline(members, voice, loop.first, unknowns, order),
            _outline(members, voice, loop.second, unknowns, order),
        )
        for loop, unknowns in zip(members.linkage.loops, members.linkage.unknowns, strict=True)
    ]


def _outline(
    members: Members,
    voice: Voice,
    steps: tuple[Step, ...],
    unknowns: tuple[Scalar, ...],
    order: int,
) -> _Outline:
    start, end = (image_letter(each, order) for each in (steps[0].start, steps[-1].end))
    vectors = [_vector(members, step, order) for step in steps]
    forms = {vector: _forms(members, voice, vector, unknowns, order) for vector in vectors}
    return _Outline(start, end, forms, _coriolis_last(vectors))


def _vector(members: Members, step: Step, order: int) -> StepVector:
    tail, head = (image_letter(each, order) for each in (step.tail, step.head))
    measured = order > 1 and isinstance(step, Bar) and not _is_driving_strut(members, step)
    still = step.tail in members.fixed
    whole: Component | None = ("absolute" if still else "relative") if measured else None
    return StepVector(
        step.ends,
        tail,
        head,
        owner(step),
        step.reverse,
        arrives=not _on_link(step),
        lettered=step.head in members.points,
        whole=whole,
        step=step,
    )


def _forms(
    members: Members,
    voice: Voice,
    vector: StepVector,
    unknowns: tuple[Scalar, ...],
    order: int,
) -> dict[str, tuple[Any, ...]]:
    """Return what is the same in every pose for the components of a step, by their names."""
    step, found = vector.step, scalar_of(vector.step) in unknowns
    label, square_to = _line(members, voice, step) if found else ("", None)
    forms = {}
    for name in ("normal", "tangential", "coriolis", "sliding"):
        coriolis = name == "coriolis"
        forms[name] = (
            found and name in ("tangential", "sliding"),
            "absolute" if members.is_guide(step) else name,
            "z" if coriolis else _stage(members, vector, found),
            members.drives(step) and not coriolis,  # it needs a link that is found
            label,
            square_to,
        )
    return forms


def _line(members: Members, voice: Voice, step: Step) -> tuple[str, str | None]:
    """Return the label of a step's construction line, and the letters it is perpendicular to."""
    if isinstance(step, Slide):
        return Text.of(Sentence("parallel", {"line": members.line(step)}), voice), None
    square_to = members.letters(step)
    return f"⟂ {square_to}", square_to


def _stage(members: Members, vector: StepVector, found: bool) -> str:
    """Name the vertex between the components of a step: b′ₙ, cₙ; of a slide it is the head."""
    step = vector.step
    if isinstance(step, Slide):
        return vector.head
    if not found:
        return vector.head + SUBSCRIPT_N
    # For a driven strut it has the letter of the part that slides.
    point = step.tail if _is_driving_strut(members, step) else step.head
    return point.lower() + SUBSCRIPT_N


def _on_link(step: Step) -> bool:
    """Tell whether a step slides on a turning link, so that no point of the link is at its end."""
    return isinstance(step, Slide) and isinstance(step.along, str)


def _is_driving_strut(members: Members, step: Bar) -> bool:
    """Tell whether a bar is a strut that the driver makes longer."""
    return step.length == members.driver.name


def _coriolis_last(vectors: Sequence[StepVector]) -> tuple[StepVector, ...]:
    """Return the vectors whose Coriolis component follows the normal component of their strut."""
    late = tuple(each for each in vectors if _on_link(each.step) and not each.reverse)
    struts = {each.owner for each in late}
    bars = (each.step for each in vectors if isinstance(each.step, Bar))
    return late if any(bar.length in struts for bar in bars) else ()


def equation(loop: Loop, first: Side, second: Side) -> Equation:
    """Return ``first = second`` with every vector on the side on which it counts positive.

    A block that slides on a lever is written as the student reads it: lever, then block, equals
    crank (dq + qb = ab).
    """
    if not loop.first[-1].reverse:
        left, right = first.forward() + second.backward(), second.forward()
    elif loop.second[-1].reverse:
        left = first.backward() + second.forward()
        right = first.forward() + second.backward()
    else:
        left, right = second.forward() + first.backward(), first.forward()
    nothing = [Term("0", None, None)]
    return Equation(tuple(left or nothing), tuple(right or nothing))


def position_equation(scene: Scene, loop: Loop, strokes: Sequence[Stroke]) -> Equation:
    """Return the loop equation of the mechanism as it is drawn, with the ground link."""
    fixed = scene.members.fixed
    sides = Side(), Side()
    start = [chain[0].start for chain in (loop.first, loop.second)]
    second_start = start[1]
    if start[0] != start[1] and start[0] in fixed:
        if fixed[start[0]] == fixed[start[1]]:
            second_start = start[0]
        else:
            sides[1].start = Term(start[0] + start[1], None, None)
    for chain, side in zip((loop.first, loop.second), sides, strict=True):
        for step in chain:
            if isinstance(step, Slide) and isinstance(step.along, str):
                continue  # the bar of the same strut or lever stands for it
            tail, head = scene.members.ends(step)
            if side is sides[1] and step is chain[0] and tail == start[1]:
                tail = second_start
            label = tail + head
            side.add(step, Term(label, scalar_of(step).name, _drawn(step, strokes)))
    return equation(loop, *sides)


def _drawn(step: Step, strokes: Sequence[Stroke]) -> str | None:
    """Return the name of the stroke that draws a step: its own bar or block, or its plate."""
    own = f"{step.ends}.bar" if isinstance(step, Bar) else f"{step.ends}.block"
    link = scalar_of(step).name
    plates = (s.name for s in strokes if isinstance(s.shape, Plate) and s.link == link)
    return next((s.name for s in strokes if s.name == own), next(plates, None))
