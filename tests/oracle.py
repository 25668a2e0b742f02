"""A high-precision reference: numbers go in, true quantities and their conditions come out.

Written from the loop equations alone.  A mechanism is its unknowns and the equations that close its
loops, in plain coordinates; the position is their root by Newton's method at 100 digits, and
the rates follow from the same equations with truncated power series in time for the unknowns.  No
textbook formula for a velocity or an acceleration is used, and nothing of the program is imported.

>>> truth = reference("scotch-yoke", {"crank": 2}, {"angle": 30, "omega": 1, "alpha": 0})
>>> print(mp.nstr(truth["point", "B", "position"].value, 12))
(1.73205080757 + 1.0j)
>>> print(mp.nstr(truth["slide", "yoke", "velocity"].value, 12))
-1.0
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from types import SimpleNamespace
from typing import Any

from mpmath import mp, mpf

from tests.precise import arg, expj, fold, pi_like, sqrt

DIGITS = 100
STEP = 1e-45
"""Relative step of the one-sided differences for the condition numbers (they need few digits)."""

Key = tuple[str, str, str]
"""("link", "rod", "omega"), ("point", "C", "velocity"), ("slide", "ram", "position") …"""


class UnassemblableError(Exception):
    """The exact equations have no real root for these numbers."""


# --- power series in time ---------------------------------------------------------------------


class Series:
    """c0 + c1·t + c2·t², real or complex, cut off there."""

    __slots__ = ("c0", "c1", "c2")  # millions of them are made

    def __init__(self, c0: Any, c1: Any = 0, c2: Any = 0) -> None:
        self.c0, self.c1, self.c2 = c0, c1, c2

    def __add__(self, other: Any) -> Series:
        other = series(other)
        return Series(self.c0 + other.c0, self.c1 + other.c1, self.c2 + other.c2)

    def __mul__(self, other: Any) -> Series:
        if not isinstance(other, Series):
            return Series(self.c0 * other, self.c1 * other, self.c2 * other)
        if other is self:
            double = 2 * self.c0
            return Series(self.c0 * self.c0, double * self.c1, double * self.c2 + self.c1 * self.c1)
        return Series(
            self.c0 * other.c0,
            self.c0 * other.c1 + self.c1 * other.c0,
            self.c0 * other.c2 + self.c1 * other.c1 + self.c2 * other.c0,
        )

    def __neg__(self) -> Series:
        return self * -1

    def __sub__(self, other: Any) -> Series:
        return self + -series(other)

    def __rsub__(self, other: Any) -> Series:
        return -self + other

    __radd__ = __add__
    __rmul__ = __mul__

    def each(self, function: Callable[[Any], Any]) -> Series:
        """Apply a real-linear function to every coefficient."""
        return Series(function(self.c0), function(self.c1), function(self.c2))

    @property
    def rates(self) -> tuple[Any, Any]:
        """First and second derivative at t = 0."""
        return self.c1, 2 * self.c2


def series(value: Any) -> Series:
    """Return a number as a constant series, a series as it is."""
    return value if isinstance(value, Series) else Series(value)


def turning(angle: Any, omega: Any, alpha: Any) -> Series:
    """Return exp(i·θ(t)) for θ = angle + omega·t + alpha·t²/2."""
    start = expj(angle)
    first = 1j * omega
    return Series(start, start * first, start * (first * first + 1j * alpha) / 2)


def turning_rates(vector: Series) -> tuple[Any, Any]:
    """Return ω and α of a turning vector: the imaginary part of its logarithmic derivative."""
    first = vector.c1 / vector.c0
    second = (2 * vector.c2 - first * vector.c1) / vector.c0
    return first.imag, second.imag


def real(vector: Any) -> Series:
    return series(vector).each(lambda z: z.real)


def imag(vector: Any) -> Series:
    return series(vector).each(lambda z: z.imag)


def dot(a: Any, b: Any) -> Series:
    return real(a) * real(b) + imag(a) * imag(b)


def cross(a: Any, b: Any) -> Series:
    return real(a) * imag(b) - imag(a) * real(b)


def square(vector: Any) -> Series:
    x, y = real(vector), imag(vector)
    return x * x + y * y


# --- mechanisms -------------------------------------------------------------------------------


@dataclass
class Pose:
    """What a mechanism's unknowns mean: equations that vanish, and all that follows from them."""

    equations: list[Series]
    links: dict[str, Any]
    points: dict[str, Any]
    slides: dict[str, Any]
    turning: dict[str, str] = field(default_factory=dict)
    """Slide → the turning link that carries its line."""
    sides: list[Series] = field(default_factory=list)
    """All positive in the open assembly, all negative in the crossed one."""


@dataclass(frozen=True)
class Mechanism:
    """Its pose for given unknowns, and where to start looking for them."""

    pose: Callable[[SimpleNamespace, Any, list[Any]], Pose]
    start: Callable[[SimpleNamespace, Any, int], list[Any]]
    driven: str = ""
    """The driven slide, if it is not a crank that is driven."""


def root(radicand: Any) -> Any:
    if radicand < 0:
        raise UnassemblableError(f"{float(radicand):.5g}")
    return sqrt(radicand)


def two_circles(centre_a: Any, radius_a: Any, centre_b: Any, radius_b: Any, side: int) -> Any:
    """Return the point at both distances, left (+1) or right (−1) of the line from a to b."""
    gap = centre_b - centre_a
    along = (abs(gap) ** 2 + radius_a**2 - radius_b**2) / (2 * abs(gap))
    across = side * root(radius_a**2 - along**2)
    return centre_a + (along + 1j * across) * gap / abs(gap)


def four_bar(p: SimpleNamespace, crank: Any, unknowns: list[Any]) -> Pose:
    a, b, d = 0j, p.crank * crank, p.ground * expj(p.ground_angle)
    c = unknowns[0] + 1j * unknowns[1]
    return Pose(
        equations=[square(c - b) - p.coupler**2, square(c - d) - p.rocker**2],
        links={"crank": b - a, "coupler": c - b, "rocker": c - d},
        points={"A": a, "B": b, "C": c, "D": d},
        slides={},
        sides=[cross(d - b, c - b)],
    )


def four_bar_start(p: SimpleNamespace, crank: Any, side: int) -> list[Any]:
    c = two_circles(p.crank * crank, p.coupler, p.ground * expj(p.ground_angle), p.rocker, side)
    return [c.real, c.imag]


def slider_crank(p: SimpleNamespace, crank: Any, unknowns: list[Any]) -> Pose:
    b, c = p.crank * crank, unknowns[0] + 1j * p.offset
    return Pose(
        equations=[square(c - b) - p.rod**2],
        links={"crank": b, "rod": c - b},
        points={"A": 0j, "B": b, "C": c},
        slides={"slider": unknowns[0]},
        sides=[real(c - b)],
    )


def slider_crank_start(p: SimpleNamespace, crank: Any, side: int) -> list[Any]:
    return [on_line(p.crank * crank, p.rod, p.offset, side)]


def on_line(pin: Any, rod: Any, height: Any, side: int) -> Any:
    """Return the abscissa at distance ``rod`` from the pin on the horizontal line at ``height``."""
    return pin.real + side * root(rod**2 - (height - pin.imag) ** 2)


def slotted(arm: str, sign: int) -> tuple[Callable[..., Pose], Callable[..., list[Any]]]:
    """Return pose and start of a crank pin in the slot of a lever, with a ram if it has a rod."""

    def tip(p: SimpleNamespace, direction: Any) -> Any:
        return p.ground * expj(p.ground_angle) + sign * getattr(p, arm) * direction

    def ram_height(p: SimpleNamespace) -> Any:
        if p.ram_height is None:
            return p.ground * expj(p.ground_angle).imag
        return p.ram_height

    def pose(p: SimpleNamespace, crank: Any, unknowns: list[Any]) -> Pose:
        b, d = p.crank * crank, p.ground * expj(p.ground_angle)
        direction, distance = unknowns[0] + 1j * unknowns[1], unknowns[2]
        c = tip(p, direction)
        q = (
            d + series(distance).c0 * direction
        )  # a point of the lever: it does not slide with the pin
        found = Pose(
            equations=[
                real(d + distance * direction - b),
                imag(d + distance * direction - b),
                square(direction) - 1,
            ],
            links={"crank": b, "lever": direction},
            points={"A": 0j, "B": b, "C": c, "D": d, "Q": q},
            slides={"block": distance},
            turning={"block": "lever"},
        )
        if p.rod is not None:
            e = unknowns[3] + 1j * ram_height(p)
            found.equations.append(square(e - c) - p.rod**2)
            found.links["rod"], found.points["E"], found.slides["ram"] = e - c, e, unknowns[3]
            found.sides.append(real(e - c))
        return found

    def start(p: SimpleNamespace, crank: Any, side: int) -> list[Any]:
        offset = p.crank * crank - p.ground * expj(p.ground_angle)
        direction = offset / abs(offset)
        found = [direction.real, direction.imag, abs(offset)]
        if p.rod is not None:
            found.append(on_line(tip(p, direction), p.rod, ram_height(p), side))
        return found

    return pose, start


def elliptical_trammel(p: SimpleNamespace, link: Any, unknowns: list[Any]) -> Pose:
    a, b = series(unknowns[0]) + 0j, 1j * unknowns[1]
    gap = b - a - p.link * link
    return Pose(
        equations=[real(gap), imag(gap)],
        links={"link": b - a},
        points={"O": 0j, "A": a, "B": b, "P": a + p.tracer * link},
        slides={"slider_a": unknowns[0], "slider_b": unknowns[1]},
    )


def elliptical_trammel_start(p: SimpleNamespace, link: Any, side: int) -> list[Any]:
    return [-p.link * link.real, p.link * link.imag]


def scotch_yoke(p: SimpleNamespace, crank: Any, unknowns: list[Any]) -> Pose:
    b = p.crank * crank
    gap = unknowns[0] + 1j * unknowns[1] - b
    return Pose(
        equations=[real(gap), imag(gap)],
        links={"crank": b},
        points={"A": 0j, "B": b, "C": series(unknowns[0]) + 0j},
        slides={"yoke": unknowns[0], "block": unknowns[1]},
    )


def scotch_yoke_start(p: SimpleNamespace, crank: Any, side: int) -> list[Any]:
    return [p.crank * crank.real, p.crank * crank.imag]


def double_slider(p: SimpleNamespace, slide: Any, unknowns: list[Any]) -> Pose:
    guide_b = expj(p.guide_b)
    a, b = slide * expj(p.guide_a), unknowns[0] * guide_b
    return Pose(
        equations=[square(b - a) - p.link**2],
        links={"link": b - a},
        points={"O": 0j, "A": a, "B": b},
        slides={"slider_a": slide, "slider_b": unknowns[0]},
        sides=[dot(guide_b, b - a)],
    )


def double_slider_start(p: SimpleNamespace, slide: Any, side: int) -> list[Any]:
    a = slide * expj(p.guide_a - p.guide_b)
    return [a.real + side * root(p.link**2 - a.imag**2)]


def gate_actuator(p: SimpleNamespace, slide: Any, unknowns: list[Any]) -> Pose:
    d, b = p.ground * expj(p.ground_angle), unknowns[0] + 1j * unknowns[1]
    return Pose(
        equations=[square(b) - p.arm**2, square(b - d) - slide * slide],
        links={"arm": b, "actuator": b - d},
        points={"A": 0j, "B": b, "D": d},
        slides={"actuator": slide},
        turning={"actuator": "actuator"},
        sides=[cross(-d, b - d)],
    )


def gate_actuator_start(p: SimpleNamespace, slide: Any, side: int) -> list[Any]:
    b = two_circles(p.ground * expj(p.ground_angle), slide, 0j, p.arm, side)
    return [b.real, b.imag]


MECHANISMS = {
    "four-bar": Mechanism(four_bar, four_bar_start),
    "slider-crank": Mechanism(slider_crank, slider_crank_start),
    "crank-slotted-lever": Mechanism(*slotted("lever", +1)),
    "whitworth": Mechanism(*slotted("arm", -1)),
    "elliptical-trammel": Mechanism(elliptical_trammel, elliptical_trammel_start),
    "scotch-yoke": Mechanism(scotch_yoke, scotch_yoke_start),
    "double-slider": Mechanism(double_slider, double_slider_start, driven="slider_a"),
    "gate-actuator": Mechanism(gate_actuator, gate_actuator_start, driven="actuator"),
}
DEFAULTS: dict[str, dict[str, Any]] = {
    "four-bar": {"ground_angle": 0},
    "slider-crank": {"offset": 0},
    "crank-slotted-lever": {"ground_angle": -90, "rod": None, "ram_height": None},
    "whitworth": {"ground_angle": -90, "rod": None, "ram_height": None},
    "double-slider": {"guide_a": 0, "guide_b": 90},
}
ANGLES = ("ground_angle", "guide_a", "guide_b", "angle")


# --- solving ----------------------------------------------------------------------------------


def solve_linear(matrix: list[list[Any]], right: list[Any]) -> list[Any]:
    """Gaussian elimination with partial pivoting on a handful of equations."""
    rows = [[*row, value] for row, value in zip(matrix, right, strict=True)]
    size = len(rows)
    for k in range(size):
        pivot = max(range(k, size), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(k + 1, size):
            factor = rows[i][k] / rows[k][k]
            rows[i] = [x - factor * y for x, y in zip(rows[i], rows[k], strict=True)]
    found: list[Any] = []
    for k in reversed(range(size)):
        known = sum(x * y for x, y in zip(reversed(rows[k][k + 1 : size]), found, strict=True))
        found.append((rows[k][size] - known) / rows[k][k])
    return found[::-1]


@dataclass(frozen=True)
class Problem:
    """One mechanism with its numbers in multiple precision, angles in radians."""

    mechanism: Mechanism
    numbers: Mapping[str, Any]

    @cached_property
    def drive(self) -> Series:
        n = self.numbers
        if self.mechanism.driven:
            return Series(n["position"], n["velocity"], n["acceleration"] / 2)
        return turning(n["angle"], n["omega"], n["alpha"])

    def pose(self, drive: Any, unknowns: list[Any]) -> Pose:
        return self.mechanism.pose(SimpleNamespace(**self.numbers), drive, unknowns)

    def start(self, side: int) -> list[Any]:
        return self.mechanism.start(SimpleNamespace(**self.numbers), self.drive.c0, side)

    def jacobian(self, unknowns: list[Any]) -> list[list[Any]]:
        """∂(equation)/∂(unknown), as the first coefficient when one unknown grows like t."""
        columns = []
        for k in range(len(unknowns)):
            moved = [Series(value, int(i == k)) for i, value in enumerate(unknowns)]
            columns.append([eq.c1 for eq in self.pose(self.drive.c0, moved).equations])
        return [list(row) for row in zip(*columns, strict=True)]

    def nearer(self, unknowns: list[Any], jacobian: list[list[Any]] | None = None) -> list[Any]:
        """Return what one step of Newton's method makes of a near start: it doubles the digits.

        It does so, too, with the ``jacobian`` of a problem whose root that start is.
        """
        misses = [eq.c0 for eq in self.pose(self.drive.c0, unknowns).equations]
        steps = solve_linear(jacobian or self.jacobian(unknowns), misses)
        return [value - step for value, step in zip(unknowns, steps, strict=True)]

    def position(self, unknowns: list[Any]) -> list[Any]:
        """Return the root next to a near start, to all digits."""
        points = self.pose(self.drive.c0, unknowns).points.values()
        noise = max(abs(series(point).c0) for point in points) * 10.0 ** (25 - DIGITS)
        for _ in range(3):
            before, unknowns = unknowns, self.nearer(unknowns)
            pairs = zip(unknowns, before, strict=True)
            if all(abs(x - last) <= max(abs(x) * 1e-50, noise) for x, last in pairs):
                return unknowns
        raise ArithmeticError("Newton's method has not converged")

    def motion(self, unknowns: list[Any], jacobian: list[list[Any]] | None = None) -> list[Series]:
        """Solve the equations order by order in time, from the position on."""
        jacobian, drive = jacobian or self.jacobian(unknowns), self.drive
        found = [Series(value) for value in unknowns]
        firsts = solve_linear(jacobian, [-eq.c1 for eq in self.pose(drive, found).equations])
        found = [Series(q.c0, first) for q, first in zip(found, firsts, strict=True)]
        seconds = solve_linear(jacobian, [-eq.c2 for eq in self.pose(drive, found).equations])
        return [Series(q.c0, q.c1, second) for q, second in zip(found, seconds, strict=True)]

    def quantities(
        self, unknowns: list[Any], jacobian: list[list[Any]] | None = None
    ) -> dict[Key, Any]:
        pose = self.pose(self.drive, self.motion(unknowns, jacobian))
        found: dict[Key, Any] = {}
        for name, vector in pose.links.items():
            omega, alpha = turning_rates(series(vector))
            angle = arg(series(vector).c0)
            found["link", name, "angle"] = angle % (2 * pi_like(angle))
            found["link", name, "omega"], found["link", name, "alpha"] = omega, alpha
        for kind, places in (("point", pose.points), ("slide", pose.slides)):
            for name, place in places.items():
                velocity, acceleration = series(place).rates
                found[kind, name, "position"] = series(place).c0
                found[kind, name, "velocity"] = velocity
                found[kind, name, "acceleration"] = acceleration
        for name, link in pose.turning.items():
            omega, velocity = found["link", link, "omega"], found["slide", name, "velocity"]
            found["slide", name, "coriolis"] = abs(2 * omega * velocity)
        return found


# --- the reference ----------------------------------------------------------------------------


@dataclass(frozen=True)
class Quantity:
    """A true value (angles in radians) and pᵢ·∂q/∂pᵢ for every number that it depends on."""

    value: Any
    terms: Mapping[str, Any]

    def kappa(self, part: Callable[[Any], Any] = lambda x: x) -> Any:
        """Return the condition number of the value, or of its real or imaginary part."""
        return abs(part(self.value)) + sum(abs(part(term)) for term in self.terms.values())


def exact(name: str, number: Any) -> Any:
    """Return a double or a decimal string as it is, an angle in radians."""
    if number is None:
        return None
    return mpf(number) * mp.pi / 180 if name in ANGLES else mpf(number)


def reference(
    name: str,
    parameters: Mapping[str, Any],
    inputs: Mapping[str, Any],
    assembly: str = "open",
    conditions: bool = True,
) -> dict[Key, Quantity]:
    """Solve one pose.

    Parameters
    ----------
    name, parameters, inputs, assembly
        As in the public contract; doubles and decimal strings are taken exactly.
    conditions
        Whether to differentiate by every parameter and input as well.

    Returns
    -------
    dict
        Every quantity; points are complex, angles in radians within [0, 2π).

    Raises
    ------
    UnassemblableError
        If the exact numbers do not close.
    """
    with mp.workdps(DIGITS):
        given = {**DEFAULTS.get(name, {}), **parameters, **inputs}
        numbers = {key: exact(key, value) for key, value in given.items()}
        problem = Problem(MECHANISMS[name], numbers)
        side = 1 if assembly == "open" else -1
        unknowns = problem.position(problem.start(side))
        check_side(problem, unknowns, side)
        values = problem.quantities(unknowns)
        terms: dict[Key, dict[str, Any]] = {key: {} for key in values}
        jacobian = problem.jacobian(unknowns)
        for number, moved, step in neighbours(problem) if conditions else ():
            for key, value in moved.quantities(moved.nearer(unknowns, jacobian)).items():
                terms[key][number] = difference(key, value, values[key]) / step
        return {key: Quantity(value, terms[key]) for key, value in values.items()}


def check_side(problem: Problem, unknowns: list[Any], side: int) -> None:
    """Refuse a root on the wrong side: the start was to be near the right one."""
    for area in problem.pose(problem.drive.c0, unknowns).sides:
        if area.c0 * side < 0:
            raise ArithmeticError("Newton's method has left its assembly")


def neighbours(problem: Problem) -> Iterator[tuple[str, Problem, Any]]:
    """Yield the problem with one number moved a step: relative to itself, or to 1 rad if driven."""
    for name, value in problem.numbers.items():
        if name == "angle":
            moved = value + STEP
        elif value:
            moved = value + STEP * (fold(value) if name in ANGLES else value)
        else:
            continue
        yield name, Problem(problem.mechanism, {**problem.numbers, name: moved}), STEP


def difference(key: Key, a: Any, b: Any) -> Any:
    """Return a − b, for angles the short way round."""
    return fold(a - b) if key[2] == "angle" else a - b
