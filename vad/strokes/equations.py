"""The loop equation under a panel, put together from the vectors as they are drawn."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from vad.kinematics.linkage import Bar, Loop, Slide, Step, scalar_of
from vad.strokes.scene import Scene
from vad.strokes.sheet import Equation, Plate, Stroke, Term
from vad.strokes.vector_equations import Vector


@dataclass
class Side:
    """The vectors of one chain in the order in which they were drawn.

    ``start`` is the one from the pole to the vertex from which it begins, if that is another.
    """

    start: Term | None = None
    entries: list[tuple[Step | Vector, Term]] = field(default_factory=list)

    def add(self, step: Step | Vector, term: Term) -> None:
        """Append one vector of a step."""
        self.entries.append((step, term))

    def has(self, step: Step | Vector) -> bool:
        """Tell whether a vector of ``step`` has been drawn."""
        return any(other is step for other, _ in self.entries)

    def forward(self) -> list[Term]:
        """Return the vectors that run with the chain."""
        begun = [self.start] if self.start else []
        return begun + [term for step, term in self.entries if not step.reverse]

    def backward(self) -> list[Term]:
        """Return the vectors that run against it, so that each begins where the last ended."""
        return [term for step, term in reversed(self.entries) if step.reverse]


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


def of_chains(first: Side, second: Side) -> Equation:
    """Return ``first = second`` of chains whose vectors all run with them."""
    nothing = [Term("0", None, None)]
    return Equation(tuple(first.forward() or nothing), tuple(second.forward() or nothing))


def of_position(scene: Scene, loop: Loop, strokes: Sequence[Stroke]) -> Equation:
    """Return the equation of a loop of the mechanism itself as drawn, a ground link added."""
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
                continue  # the bar carries its length
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
