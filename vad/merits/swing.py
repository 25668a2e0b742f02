"""What a mechanism's output does over a turn: its stroke, and how long it takes for each way."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from vad.errors import one_of
from vad.kinematics.any_solver import Result
from vad.kinematics.linkage import Bar, Scalar, Slide
from vad.kinematics.motion import Motion
from vad.kinematics.solver import Solver
from vad.merits.courses import Piece, extremes

_TURN = 360.0


class Swing(NamedTuple):
    """How far an output goes to and fro, and the angles of the driver for both ways.

    Attributes
    ----------
    stroke
        A length, or degrees.
    forward_angle, return_angle
        The longer and the shorter one; None where the driver does not turn fully.
    """

    stroke: float | None
    forward_angle: float | None
    return_angle: float | None

    @property
    def time_ratio(self) -> float | None:
        """The longer angle over the shorter one: of times, for a driver that turns evenly."""
        if self.forward_angle is None or not self.return_angle:
            return None
        return self.forward_angle / self.return_angle


#: What has no stroke.
NONE = Swing(None, None, None)


def swing(found: Sequence[Piece], driven_by_angle: bool) -> Swing:
    """Return how an output goes to and fro, of its course over a range of the driver.

    A link that goes round and round has no stroke.
    """
    most = None if any(map(goes_round, found)) else extremes(found)
    if most is None or most.least is None or most.largest is None:
        return NONE
    stroke = most.largest - most.least
    if not (driven_by_angle and found[0].whole and stroke > 0.0):
        return Swing(stroke, None, None)
    there = (most.largest_at - most.least_at) % _TURN
    back = (most.least_at - most.largest_at) % _TURN
    return Swing(stroke, max(there, back), min(there, back))


def goes_round(piece: Piece) -> bool:
    """Tell whether an angle is a turn further after a whole turn of the driver.

    A length is the same after a turn, and so is the angle of what goes to and fro.
    """
    return piece.turns and piece.whole and abs(piece.values[-1] - piece.values[0]) > 0.5 * _TURN


def output_of(motion: Motion[Any, Any, Any], name: str | None) -> Result | None:
    """Return the result that counts as the output: a slide's position, or a link's angle.

    Parameters
    ----------
    motion
        The motion.
    name
        The name of a link or a slide; None for the last one found that the frame guides: a slide on
        a line of the frame, or a link that turns about a fixed point.

    Raises
    ------
    vad.errors.UsageError
        For a name that no link with an angle, and no slide, has.
    """
    links = [each for each in motion.links if each not in motion.solver.bodies]
    if name is not None:
        if one_of("output", name, [*links, *motion.slides]) in motion.slides:
            return "slide", name, "position"
        return "link", name, "angle"
    solver = motion.solver
    if not isinstance(solver, Solver):
        others = [each for each in links if each != solver.driver.name]
        return ("link", others[-1], "angle") if others else None
    for pair in reversed(solver.linkage.unknowns):
        for scalar in sorted(pair, key=lambda each: each.kind == "angle"):
            if _is_guided(solver, scalar):
                kind = "link" if scalar.kind == "angle" else "slide"
                return kind, scalar.name, "angle" if kind == "link" else "position"
    return None


def _is_guided(solver: Solver, scalar: Scalar) -> bool:
    """Tell whether a slide is on a line of the frame, or a link turns about a fixed point."""
    fixed = solver.frame.fixed
    for step in solver.frame.steps:
        if scalar.kind == "angle" and isinstance(step, Bar) and step.link == scalar.name:
            if {step.tail, step.head} & fixed.keys():
                return True
        elif isinstance(step, Slide) and step.name == scalar.name:
            return isinstance(step.along, float) and step.tail in fixed
    return False
