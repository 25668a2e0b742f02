"""Klein's construction: the velocity and the acceleration of a slider-crank, found on its drawing.

The crank AB turns evenly.  M is where the line BC crosses the line through A square to the guide:
ABM is the velocity polygon, turned by 90° and divided by ω.  The circle about B through M and the
circle on the diameter BC cross in K and L.  The chord KL cuts BC in Q, and the line through A along
the guide in N: ABQN is the acceleration polygon, turned by 180° and divided by ω².

Source: J. F. Klein, Franklin Institute, 1891; R. S. Khurmi and J. K. Gupta, Theory of Machines,
ch. 15.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from vad.errors import DeadCentreError, InputError, quoted
from vad.kinematics.any_solver import AnySolver, Evaluation
from vad.kinematics.linkage import Bar, Slide, angle_of
from vad.kinematics.motion import Motion
from vad.kinematics.numbers import Number, Real, Truth, Vector, across, dot, select, sqrt
from vad.kinematics.solver import Solver, heading

#: The points of the construction, in the order in which it finds them.
POINTS = ("M", "K", "L", "Q", "N")


class Parts(NamedTuple):
    """The parts of a slider-crank: the names of its points, its bars and its slide."""

    a: str
    b: str
    c: str
    crank: Bar
    rod: Bar
    slide: Slide


def klein(motion: Motion[Real, Vector, Truth]) -> dict[str, Vector]:
    """Return the points M, K, L, Q and N of Klein's construction, by name.

    Parameters
    ----------
    motion
        One pose or many of a slider-crank, in line or offset, whose crank turns evenly.

    Returns
    -------
    Complex numbers x + iy in the mechanism's unit.  With ω of the crank, the velocity of the slider
    is iω·AM, and its acceleration -ω²·AN.  In arrays K and L are NaN where the circles do not meet.

    Raises
    ------
    vad.errors.InputError
        For another mechanism, for a crank with α, and for one pose whose circles do not meet.

    Examples
    --------
    R. S. Khurmi and J. K. Gupta, Theory of Machines, ex. 15.1: OM 127 mm and NO 200 mm are read off
    the drawing.

    >>> import vad
    >>> found = vad.klein(vad.solve(vad.SliderCrank(crank=200, rod=700), angle=30, omega=120))
    >>> round(abs(found["M"]), 2), round(abs(found["N"]), 2)
    (125.0, 202.97)
    """
    if not isinstance(motion, Motion):
        raise InputError(
            f"motion: must be a motion, got {quoted(motion)}",
            "as in vad.klein(vad.solve(vad.SliderCrank()))",
        )
    check(motion)
    try:
        return {name: motion.read(("klein", name, "position")) for name in POINTS}
    except DeadCentreError:
        raise _apart(motion) from None


def check(motion: Motion[Any, Any, Any]) -> None:
    """Refuse a motion for which the construction does not hold.

    Raises
    ------
    vad.errors.InputError
        If it is no slider-crank, or its crank does not turn evenly.
    """
    if parts_of(motion.solver) is None:
        raise InputError(
            f"klein: needs a slider-crank whose crank is driven, got {motion.mechanism.name}",
            "--panels velocity,acceleration draws it",
        )
    alpha = motion.inputs["alpha"]
    if np.any(alpha):
        given = f"{alpha:g}" if np.ndim(alpha) == 0 else "an array"
        raise InputError(
            f"klein: needs a slider-crank with alpha 0, got alpha {given}",
            "--panels acceleration draws it",
        )


def _apart(motion: Motion[Any, Any, Any]) -> InputError:
    found = parts_of(motion.solver)
    assert found is not None
    b, c = (motion.point(letter).position for letter in (found.b, found.c))
    along = motion.read(("klein", "M", "position")) - b
    unit = motion.mechanism.length_unit
    return InputError(
        f"klein: {found.b}M = {abs(along):.6g} {unit} is longer than {found.b}{found.c} = "
        f"{abs(c - b):.6g} {unit}, so that the two circles do not meet",
        "--panels acceleration draws it",
    )


def parts_of(solver: AnySolver) -> Parts | None:
    """Return the parts of a slider-crank whose crank is driven; None for another linkage."""
    if not isinstance(solver, Solver) or len(solver.loops) != 1:
        return None
    linkage, fixed = solver.linkage, solver.frame.fixed
    steps = [step for _, step in linkage.loops[0].steps()]
    bars = [step for step in steps if isinstance(step, Bar)]
    slides = [step for step in steps if isinstance(step, Slide)]
    if len(bars) != 2 or len(slides) != 1 or not isinstance(slides[0].along, float):
        return None
    crank, rod = sorted(bars, key=lambda bar: angle_of(bar.link) != linkage.driver)
    if angle_of(crank.link) != linkage.driver or slides[0].tail not in fixed:
        return None
    ends = {crank.tail, crank.head}
    a = next((point for point in ends if point in fixed), None)
    if a is None:
        return None
    (b,) = ends - {a}
    c = slides[0].head
    return Parts(a, b, c, crank, rod, slides[0]) if {rod.tail, rod.head} == {b, c} else None


def figure_of(evaluation: Evaluation) -> dict[str, Number]:
    """Return all points of the construction; NaN where they do not exist."""
    solver = evaluation.solver.plane
    found = parts_of(solver)
    assert found is not None
    a, b, c = (
        solver.evaluate(("point", letter, "position"), evaluation)
        for letter in (found.a, found.b, found.c)
    )
    guide, rod = heading(found.slide), c - b
    # M = B + m·BC, the crossing with the line through A square to the guide.
    m = dot(a - b, guide) / dot(rod, guide)
    # Q = B + m²·BC, because BM is the mean proportional of BQ and BC.
    q = b + rod * (m * m)
    chord = 1.0 - m * m
    half = m * sqrt(select(chord < 0.0, math.nan, chord))
    half = select(chord < 0.0, math.nan, half)
    upright = across(rod)
    along = dot(q - a, rod) / dot(guide, rod)
    return {
        "M": b + rod * m,
        "K": q - upright * half,
        "L": q + upright * half,
        "Q": q,
        "N": a + guide * along,
    }
