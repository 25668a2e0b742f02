"""Poses of the mechanisms in space, and the truth about them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, replace
from functools import lru_cache
from typing import Any, NamedTuple

import gmpy2
import numpy as np

import vad
from benchmarks.errors.draws import Deep, Few
from benchmarks.errors.tally import Pose, Tally, read_all
from benchmarks.errors.truth import BITS, MORE_BITS, Drive, Truth
from tests.kinematics.families import Draw
from tests.oracle import STEP, Key, difference, solve_linear
from vad.kinematics.closed_forms import OpenLoopError
from vad.kinematics.linkage import Scalar
from vad.kinematics.solver import solver_of
from vad.kinematics.space.linkages import BallJointed, CrossedShafts, DualAngle
from vad.methods import closed_form, loops_in_space
from vad.methods.loops_in_space import Arithmetic, LoopInSpace, Walk
from vad.methods.problem import FOUR_AXES, HOOKE, SLIDES, Jet, SpaceProblem, problem_of

Numbers = dict[str, Any]
Place = dict[Scalar, Any]
#: A step smaller than that ends the iteration; after so many steps it has not converged.
CONVERGED, MOST_STEPS = 1e-75, 12


class Drawn(NamedTuple):
    """A pose: the mechanism's name, its parameters, its assembly and its inputs."""

    name: str
    sizes: Numbers
    inputs: Numbers
    assembly: str

    @property
    def mechanism(self) -> vad.Mechanism:
        return vad.MECHANISMS[self.name](**self.sizes, assembly=self.assembly)

    @property
    def given(self) -> Numbers:
        return {**self.sizes, **self.inputs, "assembly": self.assembly}


def again(name: str, numbers: Mapping[str, Any]) -> tuple[str, Drawn]:
    """Return the pose of which `Drawn.given` told."""
    inputs = ("angle", "omega", "alpha")
    sizes = {key: x for key, x in numbers.items() if key not in (*inputs, "assembly")}
    return "known", Drawn(name, sizes, {key: numbers[key] for key in inputs}, numbers["assembly"])


# --- what is drawn ----------------------------------------------------------------------------

Angles = Callable[[Draw], float]


def _usual(draw: Draw) -> float:
    return draw.uniform(5.0, 175.0)


def _near(draw: Draw) -> float:
    """Return an arc between axes that are parallel, but for a little; or any."""
    little = 10.0 ** draw.uniform(-12, 0.5)
    return draw.choice((_usual(draw), _usual(draw), little, 180.0 - little))


def _even(draw: Draw) -> float:
    return draw.choice((30.0, 45.0, 60.0, 90.0, 90.0, 120.0, 150.0)) + draw.choice(
        (0.0, 0.0, draw.tiny(14.0))
    )


def _hooke(draw: Draw, angle: Angles) -> Numbers:
    size = 90.0 - angle(draw)
    return {"shaft_angle": size if abs(size) < 90.0 else 30.0}


def _spherical(draw: Draw, angle: Angles, factor: float = 1.0) -> Numbers:
    return {name: angle(draw) * factor for name in ("ground", "crank", "coupler", "rocker")}


def _spatial(draw: Draw, angle: Angles) -> Numbers:
    arcs = {f"{name}_twist": arc for name, arc in _spherical(draw, angle).items()}
    lengths = {
        name: draw.choice((0.0, *[draw.sign() * draw.length()] * 4))
        for name in ("ground", "crank", "coupler", "rocker")
    }
    return lengths | arcs


def _rssr(draw: Draw, angle: Angles) -> Numbers:
    lengths = {name: draw.length() for name in ("crank", "coupler", "rocker")}
    for name in ("ground", "crank_offset", "rocker_offset"):
        lengths[name] = draw.choice((0.0, *[draw.sign() * draw.length()] * 4))
    return lengths | {"ground_twist": draw.sign() * angle(draw)}


KINDS: dict[str, Callable[[Draw, Angles], Numbers]] = {
    "hooke-joint": _hooke,
    "spherical-four-bar": _spherical,
    "spatial-four-bar": _spatial,
    "rssr": _rssr,
}
FAMILIES: dict[str, Angles] = {
    "random": _usual,
    "near dead centre": _usual,
    "axes nearly parallel": _near,
    "coincidence": _even,
    "short arcs": _usual,
}


def poses(seed: int) -> Iterator[tuple[str, Drawn]]:
    """Yield families and poses without end; some may not close."""
    draw, deep, few = (cls(f"{cls.__name__} in space {seed}") for cls in (Draw, Deep, Few))
    while True:
        family, name = draw.choice(list(FAMILIES)), draw.choice(list(KINDS))
        source = {"axes nearly parallel": deep, "coincidence": few}.get(family, draw)
        if family == "short arcs":
            if name != "spherical-four-bar":
                continue
            sizes = _spherical(draw, _usual, 10.0 ** draw.uniform(-6, 0))
        else:
            sizes = KINDS[name](source, FAMILIES[family])
        pose = Drawn(
            name, sizes, {"angle": source.angle(), **draw.rates()}, draw.choice(("open", "crossed"))
        )
        if family == "near dead centre":
            limits = solver_of(pose.mechanism).limits()
            if not len(limits):
                continue
            pose.inputs["angle"] = float(deep.choice(list(limits))) + deep.tiny(14.0)
        yield family, pose


# --- the truth --------------------------------------------------------------------------------


def _linear(columns: list[list[Any]], right: list[Any]) -> list[Any]:
    return solve_linear([list(row) for row in zip(*columns, strict=True)], right)


@lru_cache(maxsize=64)
def _sin_cos(angle: Any, bits: int) -> tuple[Any, Any]:
    """Return sine and cosine: the same few angles are walked over again and again."""
    return gmpy2.sin_cos(angle)


def _arithmetic() -> Arithmetic:
    bits = gmpy2.get_context().precision
    cos, sin = (lambda x, k=k: _sin_cos(gmpy2.mpfr(x), bits)[k] for k in (1, 0))
    return Arithmetic(gmpy2.mpfr, cos, sin, gmpy2.const_pi(), _linear)


class SpaceTruth(Truth):
    """Two walks along the axes that end alike, or two balls that keep their distance."""

    def __init__(self, pose: Drawn) -> None:
        plain: Any = problem_of(pose.mechanism, pose.inputs)
        start = closed_form.positions(plain)
        self._problem = replace(plain, drive=Jet(*map(gmpy2.mpfr, plain.drive)))
        try:
            near = _Near(self._problem, start)
            place = near.place(self._problem, start)
        except ArithmeticError:  # next to a dead centre its steps do not shrink
            found = loops_in_space.solve(self._problem, _arithmetic(), start, CONVERGED)
            place = {scalar: jet.value for scalar, jet in found.items()}
        self._place, self._near = place, _Near(self._problem, place)
        self.values = _results(self._problem, self._near.motion(self._problem, place))
        self.drive = Drive(1, *self._problem.drive[1:])

    def changes(self) -> Iterator[tuple[str, dict[Key, Any]]]:
        """Yield the differences between this problem and its neighbours."""
        for name, other in _varied(self._problem):
            moved = self._near.motion(other, self._near.place(other, self._place))
            values = _results(other, moved)
            yield name, {k: difference(k, x, self.values[k]) / STEP for k, x in values.items()}


class _Near:
    """Solves problems near one: with the derivatives of that one, and what is missing again.

    Each step multiplies the error by the distance from the pose in which the derivatives are true.
    """

    def __init__(self, problem: SpaceProblem, place: Place) -> None:
        loop, place = _loop(problem), {scalar: gmpy2.mpfr(x) for scalar, x in place.items()}
        self._unknowns = problem.unknowns
        unit = ({scalar: int(scalar == one) for scalar in place} for one in self._unknowns)
        columns = [loop.change(place, rates) for rates in unit]
        size = len(columns)
        ones = [[gmpy2.mpfr(int(i == k)) for i in range(size)] for k in range(size)]
        self._inverse = [_linear(columns, one) for one in ones]

    def _step(self, gap: list[Any]) -> Place:
        pairs = enumerate(self._unknowns)
        return {
            scalar: -sum(g * column[k] for g, column in zip(gap, self._inverse, strict=True))
            for k, scalar in pairs
        }

    def place(self, problem: SpaceProblem, start: Place) -> Place:
        """Return the position next to a start."""
        loop, place = _loop(problem), {scalar: gmpy2.mpfr(x) for scalar, x in start.items()}
        for _ in range(MOST_STEPS):
            steps = self._step(loop.gap(place)[0])
            place = {scalar: x + steps[scalar] for scalar, x in place.items()}
            if all(
                abs(step) < CONVERGED * max(problem.unit(scalar), abs(place[scalar]))
                for scalar, step in steps.items()
            ):
                return place
        raise ArithmeticError("the steps do not shrink")

    def motion(self, problem: SpaceProblem, place: Place) -> dict[Scalar, Jet]:
        """Return the position with its two derivatives."""
        loop = _loop(problem)
        rates = self._step(loop.gap(place)[1])
        rates = _sum(rates, self._step(loop.gap(place, rates)[1]))
        known = loop.gap(place, rates)[2]
        seconds = self._step(known)
        missing = [x + y for x, y in zip(known, loop.change(place, seconds), strict=True)]
        seconds = _sum(seconds, self._step(missing))
        return {
            each: Jet(x, problem.sense(each) * rates[each], problem.sense(each) * seconds[each])
            for each, x in place.items()
        }


def _sum(one: Place, other: Place) -> Place:
    return {scalar: x + other[scalar] for scalar, x in one.items()}


def _loop(problem: SpaceProblem) -> LoopInSpace:
    degrees, rate, second = problem.drive
    angle = gmpy2.const_pi() * (degrees % 360) / 180
    return LoopInSpace(problem, _arithmetic(), (angle, rate, second))


def _varied(problem: SpaceProblem) -> Iterator[tuple[str, SpaceProblem]]:
    """Yield the same problem with each of its numbers changed a little, by itself."""
    linkage: Any = problem.linkage
    step = gmpy2.mpfr(STEP)
    more = 1 + step
    for each in fields(linkage):
        value = getattr(linkage, each.name)
        if isinstance(value, DualAngle):
            others: list[Any] = [
                value._replace(**{part: x * more}) for part, x in value._asdict().items() if x
            ]
        else:
            others = [] if isinstance(value, bool) or not value else [value * more]
        for x in others:
            yield each.name, replace(problem, linkage=replace(linkage, **{each.name: x}))
    angle, rate, second = problem.drive
    degrees = 180 * step / gmpy2.const_pi()
    yield "angle", replace(problem, drive=Jet(angle + degrees, rate, second))
    yield "omega", replace(problem, drive=Jet(angle, rate * more, second))
    yield "alpha", replace(problem, drive=Jet(angle, rate, second * more))


def names(kind: str) -> tuple[str, str, str]:
    """Return the names of value, rate and second derivative."""
    slides = ("position", "velocity", "acceleration")
    return slides if kind == "slide" else ("angle", "omega", "alpha")


def _results(problem: SpaceProblem, found: Mapping[Scalar, Jet]) -> dict[Key, Any]:
    """Return every result of a pose from what Newton's method has found."""
    values: dict[Key, Any] = {}
    for scalar, jet in found.items():
        kind = "slide" if scalar.kind == "length" else "joint" if scalar.kind == "joint" else "link"
        values |= {(kind, scalar.name, name): x for name, x in zip(names(kind), jet, strict=True)}
        if kind != "slide":
            values[kind, scalar.name, "angle"] %= 2 * gmpy2.const_pi()
    for key, vector in _vectors(problem, found):
        values[key] = np.array(vector, dtype=object)
    return values


def _vectors(
    problem: SpaceProblem, found: Mapping[Scalar, Jet]
) -> Iterator[tuple[Key, tuple[Any, ...]]]:
    """Yield points, and ω and α of bodies between, by walks to them."""
    linkage, arithmetic = problem.linkage, _arithmetic()
    degrees, rate, second = problem.drive
    crank = (arithmetic.pi * degrees / 180, rate, second)
    frame = Walk(arithmetic)
    if isinstance(linkage, BallJointed):
        b = frame.joint(crank).link(0, linkage.crank)
        foot = frame.joint((0, 0, 0), (-linkage.crank_offset, 0, 0))
        d = foot.link(linkage.ground_twist, linkage.ground)
        c = d.joint(found[FOUR_AXES[0]], (linkage.rocker_offset, 0, 0)).link(0, linkage.rocker)
        yield from _point("B", b.origin, *b.speed)
        yield from _point("C", c.origin, *c.speed)
        way, *rates = (
            loops_in_space.less(x, y)
            for x, y in zip((c.origin, *c.speed), (b.origin, *b.speed), strict=True)
        )
        square = loops_in_space.dot(way, way)
        for name, x in zip(("omega", "alpha"), rates, strict=True):
            turned = loops_in_space.cross(way, x)
            yield ("link", "coupler", name), loops_in_space.scaled(1 / square, turned)
        return
    if isinstance(linkage, CrossedShafts):
        arcs, lead, names = [(linkage.shaft_angle, 0), *[(90, 0)] * 3], -arithmetic.pi / 2, HOOKE
    else:
        arcs = [linkage.ground, linkage.crank, linkage.coupler, linkage.rocker]
        lead, names = 0, FOUR_AXES
    about_d, about_b = (
        (lead + jet.value, problem.sense(name) * jet.rate, problem.sense(name) * jet.second)
        for name, jet in ((name, found[name]) for name in names[:2])
    )
    slides = [found.get(name, (0, 0, 0)) for name in SLIDES]
    b = frame.joint(crank).link(*arcs[1])
    between = b.joint(about_b, slides[1])
    over_frame = frame.link(*arcs[0]).joint(about_d, slides[0]).link(*arcs[3])
    universal = isinstance(linkage, CrossedShafts)
    body = "cross" if universal else "coupler"
    yield ("link", body, "omega"), between.spin[0]
    yield ("link", body, "alpha"), between.spin[1]
    one, other = "PQ" if universal else "BC"
    if names is FOUR_AXES and linkage.slides:
        c = between.link(*arcs[2])
        yield from _point("B", b.origin, *b.speed)
        yield from _point("C", c.origin, *c.speed)
    else:
        yield from _point(one, *_carried(b))
        outward = -1 if universal else 1  # the arm OQ
        arm = (loops_in_space.scaled(outward, x) for x in _carried(over_frame))
        yield from _point(other, *arm)


def _carried(walk: Walk) -> tuple[Any, ...]:
    """Return position, velocity and acceleration of the unit vector along a walk's z."""
    omega, alpha = walk.spin
    cross = loops_in_space.cross
    velocity = cross(omega, walk.z)
    second = loops_in_space.added(cross(alpha, walk.z), cross(omega, velocity))
    return walk.z, velocity, second


def _point(name: str, *orders: Any) -> Iterator[tuple[Key, Any]]:
    for order, x in zip(("position", "velocity", "acceleration"), orders, strict=True):
        yield ("point", name, order), x


def compare(tally: Tally, family: str, drawn: Drawn) -> None:
    """Compare a pose with the truth, if it closes."""
    pose = Pose(drawn.name, family, drawn.given)

    def look(bits: int) -> SpaceTruth:
        gmpy2.get_context().precision = bits
        return SpaceTruth(drawn)

    try:
        mechanism = drawn.mechanism
        solver_of(mechanism).positions(drawn.inputs["angle"])  # what is told of a miss takes long
        truth = look(BITS)
        motion: Any = vad.solve(mechanism, **drawn.inputs)
        measured = read_all(motion, truth.values)
    except OpenLoopError:
        tally.others["does not close", drawn.name] += 1
    except (vad.DeadCentreError, ArithmeticError):  # there Newton's method creeps
        tally.others["dead centre", drawn.name] += 1
    except vad.VadError as error:
        tally.refused(pose, truth, error)
    else:
        tally.compare(pose, measured, truth, lambda: look(MORE_BITS), plain=family == "random")
