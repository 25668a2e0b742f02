"""A crank-rocker from the swing of its rocker and its time ratio, by its dead centres.

At the dead centres the rocker's pin C is at b + a and at b - a from the crank's pivot A.  Between
these two lines is δ, so A is on a circle through both places of C, on one side of their chord or on
the other (H. Alt, *Über die Totlagen des Gelenkvierecks*, 1925).  With the rocker c as the unit,
h = sin(ψ/2), p = cos(ψ/2), t = tan(δ/2), σ = ±1 for the two sides, and one number v that is free,

    a² = h² (1 + t² (1 - v)),    b² = h² v,    d² = (p - σ h t)² + v (h² (1 - t²) + 2 σ p h t).

So any two lengths give v by a linear equation.  The crank turns fully, and the rocker does not jump
into the other assembly, while 1 < v < cos²((δ + σψ)/2) / sin²(δ/2).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from vad.designs.dead_centres import TIME_RATIO, corner, imbalance, place, time_ratio_of
from vad.designs.task import Answer, Demand, Task, above, below
from vad.errors import InputError, UsageError
from vad.mechanisms import Mechanism
from vad.mechanisms.four_bar import FourBar

_LENGTHS = ("ground", "crank", "coupler", "rocker")
#: The ground without a choice.
_GROUND = 100.0
#: The coupler over the rocker where a longer one always is better: for the time ratio 1.
_USUAL_COUPLER = 2.0
#: How often the interval of a root is halved: then its ends are neighbours.
_HALVINGS = 200


@dataclass(frozen=True)
class _Side:
    """The four-bars with A on one side of the chord, all with a rocker of length 1.

    The squares of their lengths are linear in v: pairs of a constant and a factor.
    """

    away: bool
    squares: Mapping[str, tuple[float, float]]
    most: float
    slope: float

    def length(self, name: str, v: float) -> float:
        """Return a length for v."""
        constant, factor = self.squares[name]
        return math.sqrt(max(constant + factor * v, 0.0))

    def steepness(self, v: float) -> float:
        """Return a number with the sign of the slope of the worst |cos μ| over v.

        That is (slope (v - 1) + 2 a d) / (2 b) where the crank is along the ground.
        """
        (ground, more), (crank, less) = self.squares["ground"], self.squares["crank"]
        falls = (crank * ground / v**2 + -less * more) / 2.0
        flat = self.slope / 4.0 * (1.0 + 1.0 / v) / math.sqrt(v)
        steep = self.length("ground", v) * self.length("crank", v) / math.sqrt(v)
        return flat * steep - falls

    def best(self) -> float:
        """Return v where the transmission angle stays as near to 90° as it can.

        It is bad at both ends, and between them it is best once.
        """
        if math.isinf(self.most):
            return (_USUAL_COUPLER / self.length("coupler", 1.0)) ** 2
        low, high = 0.0, 1.0
        for _ in range(_HALVINGS):
            middle = (low + high) / 2.0
            low, high = (middle, high) if self.steepness(self._at(middle)) < 0.0 else (low, middle)
        return self._at((low + high) / 2.0)

    def _at(self, share: float) -> float:
        return float(self.most**share)


def _sides(swing: float, delta: float) -> list[_Side]:
    """Return the sides of the chord on which A can be; both are one where its circle is a line."""
    h, p, t = math.sin(swing / 2.0), math.cos(swing / 2.0), math.tan(delta / 2.0)
    found = []
    for sign in (1.0, -1.0) if delta else (1.0,):
        half = (delta + sign * swing) / 2.0
        reach = math.cos(half) / math.sin(delta / 2.0) if delta else math.inf
        if half < math.pi / 2.0 and reach > 1.0:
            squares = {
                "ground": ((p - sign * h * t) ** 2, h * (h * (1.0 - t * t) + 2.0 * sign * p * t)),
                "crank": (h * h * (1.0 + t * t), -((h * t) ** 2)),
                "coupler": (0.0, h * h),
                "rocker": (1.0, 0.0),
            }
            slope = 2.0 * h * t * abs(p - sign * h * t)
            found.append(_Side(sign > 0.0, squares, reach**2, slope))
    return found


def solve(
    swing: float,
    time_ratio: float,
    ground: float | None = None,
    crank: float | None = None,
    coupler: float | None = None,
    rocker: float | None = None,
    length_unit: str = "mm",
) -> list[Answer]:
    """Return the crank-rockers with this swing and time ratio: at most one for each side.

    One length sets the size.  A second one chooses among them; without it, the transmission angle
    stays as near to 90° as it can.
    """
    lengths = dict(zip(_LENGTHS, (ground, crank, coupler, rocker), strict=True))
    given = {name: value for name, value in lengths.items() if value is not None}
    if len(given) > 2:
        raise UsageError(f"{', '.join(given)}: give two of them at most", "the others follow")
    turned, delta = math.radians(swing), imbalance(time_ratio)
    sides = _sides(turned, delta)
    if not sides:
        most = below(time_ratio_of(math.pi / 2.0 + turned / 2.0))
        raise InputError(
            f"time_ratio: {time_ratio:g} with a swing of {swing:g}° gives no crank-rocker, it must "
            f"be below {most}",
            _more_swing(delta),
        )
    size = next(iter(given), "ground")
    measure = given.get(size, _GROUND)
    free = next((name for name in given if name != size), None)
    found = []
    for side in sides:
        v = side.best() if free is None else _chosen(side, given, size, free)
        if v is not None and 1.0 < v < side.most:
            found.append(_answer(side, v, {size: measure, **given}, size, length_unit))
    if not found and free is not None:
        raise _refused(sides, given, size, free)
    return sorted(found, key=lambda answer: _worst(answer.mechanism))


def _more_swing(delta: float) -> str:
    least = math.degrees(2.0 * delta - math.pi)
    return f"a smaller time ratio, or a swing of more than {above(least)}°"


def _chosen(side: _Side, given: Mapping[str, float], size: str, free: str) -> float | None:
    """Return v for two lengths: their squares are linear in it."""
    (one, more), (other, less) = side.squares[size], side.squares[free]
    ratio = (given[free] / given[size]) ** 2
    under = ratio * more - less
    return (other - ratio * one) / under if under else None


def _refused(sides: list[_Side], given: Mapping[str, float], size: str, free: str) -> InputError:
    """Return the error for two lengths that no crank-rocker has; it says which ones are had."""
    ranges = []
    for side in sides:
        end = min(side.most, 1e300)
        ratios = [side.length(free, v) / side.length(size, v) for v in (1.0, end)]
        low, high = (given[size] * ratio for ratio in sorted(ratios))
        ranges.append(f"between {above(low)} and {below(high)}")
    return InputError(
        f"{free}: with the {size} {given[size]:g} it must be {' or '.join(dict.fromkeys(ranges))}, "
        f"got {given[free]:g}"
    )


def _worst(mechanism: Mechanism) -> float:
    """Return the largest |cos μ|, with the crank along the ground."""
    d, a, b, c = (mechanism.parameters()[name] for name in _LENGTHS)
    straight = (b * b + c * c - a * a - d * d) / 2.0
    return (abs(straight) + a * d) / (b * c)


def _answer(side: _Side, v: float, given: Mapping[str, float], size: str, unit: str) -> Answer:
    """Return the answer with its two dead centres: crank and coupler in line, then folded."""
    scale = given[size] / side.length(size, v)
    found = {name: given.get(name, scale * side.length(name, v)) for name in _LENGTHS}
    d, a, b, c = (found[name] for name in _LENGTHS)
    places = (corner(c, d, b + a), corner(c, d, b - a) + math.pi)
    notes: tuple[str, ...] = ()
    if side.squares["crank"][1]:
        notes = ("slow against",) if side.away else ("slow with",)
    mechanism = FourBar(ground=d, crank=a, coupler=b, rocker=c, length_unit=unit)
    return Answer(mechanism, tuple(map(place, places)), notes=notes)


#: The task.
TASK = Task(
    "crank-rocker",
    "Crank–rocker from the swing of its rocker and its time ratio",
    (
        Demand(
            "swing",
            "angle",
            "of the rocker",
            needed=True,
            least=0.0,
            most=180.0,
            example="60",
        ),
        TIME_RATIO,
        Demand("ground", "length", "its size: one of its four lengths", example="100"),
        Demand("crank", "length", "or the crank", example="30"),
        Demand("coupler", "length", "or the coupler", example="90"),
        Demand("rocker", "length", "or the rocker; a second length is a free choice", example="70"),
    ),
    solve,
    "the ground is 100, and the transmission angle stays as near to 90° as it can; for the time "
    "ratio 1 the coupler has two lengths of the rocker",
)
