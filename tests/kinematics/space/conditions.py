"""What is true of a pose in space, and how far an honest solver may miss it.

In come a linkage and the motion of its driver, out go the results at sixty digits, each with its
relative condition number: κ = |q| + Σ |p ∂q/∂p| + |∂q/∂θ|, over all dimensions and inputs.  The
truth comes from Newton's method on two walks along the axes, which share nothing with the solver.
"""

from __future__ import annotations

from dataclasses import fields, replace
from typing import Any, NamedTuple

from mpmath import mp, mpf

import vad
from vad.kinematics.linkage import Scalar
from vad.kinematics.solver import solver_of
from vad.kinematics.space.linkages import DualAngle
from vad.methods import closed_form, loops_in_space
from vad.methods.loops_in_space import Arithmetic
from vad.methods.problem import Jet, SpaceProblem

DIGITS = 60
STEP = mpf(10) ** -22
EPSILON = 2.0**-52
#: In ε·κ, by the order of a result; as in the plane, but for α.
BOUNDS = (2.0, 4.0, 8.0)


class Known(NamedTuple):
    """A true result and its condition number, both in radians or lengths."""

    value: Any
    condition: Any


def known(mechanism: vad.Mechanism, inputs: dict[str, float]) -> dict[Scalar, list[Known]]:
    """Return value, rate and second derivative of every unknown."""
    with mp.workdps(DIGITS):
        linkage: Any = mechanism.linkage()
        drive = [mpf(x) for x in ({**mechanism.inputs, **inputs}).values()]
        problem = SpaceProblem(mechanism, linkage.driver, Jet(*drive), _size(mechanism), linkage)
        start = closed_form.positions(replace(problem, drive=Jet(*map(float, drive))))
        true = _solved(problem, start)
        near = {scalar: jet.value for scalar, jet in true.items()}
        sums = {scalar: [abs(x) for x in jet] for scalar, jet in true.items()}
        for other in _varied(problem):
            for scalar, jet in _solved(other, near).items():
                for order in range(3):
                    change = (jet[order] - true[scalar][order]) / STEP
                    sums[scalar][order] += abs(change)
        return {
            scalar: [Known(*pair) for pair in zip(jet, sums[scalar], strict=True)]
            for scalar, jet in true.items()
        }


def errors(mechanism: vad.Mechanism, inputs: dict[str, float]) -> dict[tuple[Scalar, int], float]:
    """Return by how many ε·κ the program misses each result."""
    motion: Any = vad.solve(mechanism, **inputs)
    found = {}
    with mp.workdps(DIGITS):
        for scalar, truths in known(mechanism, inputs).items():
            if scalar.kind == "length":
                part = motion.slide(scalar.name)
                mine = part.position, part.velocity, part.acceleration
            else:
                part = (motion.joint if scalar.kind == "joint" else motion.link)(scalar.name)
                mine = mpf(part.angle) * mp.pi / 180, part.omega, part.alpha
            for order, (value, truth) in enumerate(zip(mine, truths, strict=True)):
                miss = value - truth.value
                if order == 0 and scalar.kind != "length":
                    miss -= 2 * mp.pi * mp.nint(miss / (2 * mp.pi))
                # What is zero by symmetry, and moves with nothing, is measured by the driver.
                pace = max(abs(x) ** (1 / n) for n, x in enumerate(list(inputs.values())[1:], 1))
                least = pace**order * (_size(mechanism) if scalar.kind == "length" else 1)
                zero = abs(truth.condition) < least * mpf(10) ** -20
                scale = EPSILON * (least if zero else truth.condition)
                found[scalar, order] = float(abs(miss) / scale)
    return found


def limit_of(mechanism: vad.Mechanism) -> float:
    """Return the first angle at which a mechanism just closes."""
    return float(solver_of(mechanism).limits()[0])


def _size(mechanism: vad.Mechanism) -> float:
    quantities = {each.name: each.metadata["quantity"] for each in fields(mechanism)}
    lengths = [x for name, x in mechanism.parameters().items() if quantities[name] == "length"]
    return max(map(abs, lengths), default=1.0)


def _solved(problem: SpaceProblem, start: Any) -> dict[Scalar, Jet]:
    return loops_in_space.solve(problem, _PRECISE, start, mpf(10) ** (25 - DIGITS))


def _varied(problem: SpaceProblem) -> list[SpaceProblem]:
    """Return the same problem with each of its numbers changed a little, by itself."""
    linkage: Any = problem.linkage
    found = []
    for each in fields(linkage):
        value = getattr(linkage, each.name)
        if isinstance(value, DualAngle):
            others = [
                value._replace(**{part: mpf(x) * (1 + STEP)})
                for part, x in value._asdict().items()
                if x
            ]
        else:
            others = [] if isinstance(value, bool) or not value else [mpf(value) * (1 + STEP)]
        found += [replace(problem, linkage=replace(linkage, **{each.name: x})) for x in others]
    angle, rate, second = problem.drive
    degrees = (1 + abs(angle)) * STEP + 180 * STEP / mp.pi
    drives = [(angle + degrees, rate, second), (angle, rate * (1 + STEP), second)]
    drives += [(angle, rate, second * (1 + STEP))]
    return found + [replace(problem, drive=Jet(*drive)) for drive in drives]


def _linear(columns: list[list[Any]], right: list[Any]) -> list[Any]:
    return list(mp.lu_solve(mp.matrix(columns).T, mp.matrix(right)))


_PRECISE = Arithmetic(mpf, mp.cos, mp.sin, mp.pi, _linear)
