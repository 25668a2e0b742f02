"""The loop equation under a panel, put together from the vectors as they are drawn."""

from __future__ import annotations

from dataclasses import dataclass, field

from vad.kinematics.linkage import Loop, Step
from vad.strokes.sheet import Equation, Term


@dataclass
class Side:
    """The vectors of one chain in the order in which they were drawn."""

    entries: list[tuple[Step, Term]] = field(default_factory=list)

    def add(self, step: Step, term: Term) -> None:
        """Append one vector of a step."""
        self.entries.append((step, term))

    def has(self, step: Step) -> bool:
        """Tell whether a vector of ``step`` has been drawn."""
        return any(other is step for other, _ in self.entries)

    def forward(self) -> list[Term]:
        """Return the vectors that run with the chain."""
        return [term for step, term in self.entries if not step.reverse]

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
