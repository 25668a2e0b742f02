"""A four-bar whose rocker follows its crank as a function asks, by Freudenstein's equation.

With φ the angle of the crank and ψ that of the rocker, both from the ground's direction,

    K₁ cos ψ - K₂ cos φ + K₃ = cos(φ - ψ),    K₁ = d/a,    K₂ = d/c

(F. Freudenstein, *Approximate Synthesis of Four-Bar Linkages*, Transactions of the ASME 77, 1955).
Three pairs of angles are three linear equations.  Where a or c is negative, the link points away
from its angle.  For a function y = f(x) the pairs are those of Chebyshev's spacing.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from vad import gate
from vad.designs.placed import four_bar
from vad.designs.task import Answer, Demand, Task
from vad.errors import InputError, UsageError
from vad.files.description import Expression
from vad.kinematics.numbers import ray

#: The ground without a choice.
_GROUND = 100.0
#: The sine of the smallest angle between the two equations that are solved.
_LEAST_SINE = 1e-6
#: The longest link over the ground.
_LONGEST = 1000.0
_SPACED = ("y", "x", "crank_range", "rocker_range")

Row = Sequence[float]
Function = Callable[[float], object]


def solve(
    pairs: Sequence[Row] | None = None,
    y: str | Function | None = None,
    x: Sequence[Row] | None = None,
    crank_range: Sequence[Row] | None = None,
    rocker_range: Sequence[Row] | None = None,
    ground: float = _GROUND,
    length_unit: str = "mm",
) -> list[Answer]:
    """Return the one four-bar that has three pairs of angles of its crank and its rocker."""
    spaced = dict(zip(_SPACED, (y, x, crank_range, rocker_range), strict=True))
    missing = [name for name, value in spaced.items() if value is None]
    if pairs is not None and len(missing) < len(spaced):
        raise UsageError("pairs and y: give one of them", "y takes x, crank_range, rocker_range")
    if pairs is None:
        if missing:
            hint = "as in --pairs '40 70, 60 82, 80 97'; or --y, --x, --crank-range, --rocker-range"
            said = "pairs: is" if len(missing) == len(spaced) else f"{missing[0]}: is"
            raise UsageError(f"{said} missing", hint)
        assert y is not None and x is not None and crank_range is not None
        assert rocker_range is not None
        pairs = spaced_pairs(y, x[0], crank_range[0], rocker_range[0])
    crank, rocker = _links(pairs)
    pins = [(crank * ground * ray(phi), (1.0 + rocker * ray(psi)) * ground) for phi, psi in pairs]
    notes = {(True, True): ("back both",), (True, False): ("back crank",)}
    notes[False, True] = ("back rocker",)
    pointing = notes.get((crank < 0.0, rocker < 0.0), ())
    return [four_bar((0j, complex(ground)), pins, length_unit, notes=pointing)]


def spaced_pairs(
    y: str | Function, x: Row, crank: Row, rocker: Row
) -> tuple[tuple[float, float], ...]:
    """Return the pairs of angles at Chebyshev's three places of a range of x.

    Both angles run evenly with x and y, from the first to the last one of their ranges.

    Examples
    --------
    >>> pairs = spaced_pairs("x^2", (0.0, 1.0), (0.0, 90.0), (0.0, 90.0))
    >>> [(round(phi, 3), round(psi, 3)) for phi, psi in pairs]
    [(6.029, 0.404), (45.0, 22.5), (83.971, 78.346)]
    """
    middle, half = (x[0] + x[1]) / 2.0, (x[1] - x[0]) / 2.0
    spread = math.cos(math.pi / 6.0)
    low, high = _value(y, x[0]), _value(y, x[1])
    if x[0] == x[1] or low == high:
        name = "x" if x[0] == x[1] else "y"
        raise InputError(f"{name}: must differ at both ends of the range, got {(x[0], low)} twice")
    found = []
    for share in (-spread, 0.0, spread):
        done = (_value(y, middle + share * half) - low) / (high - low)
        phi = crank[0] + (crank[1] - crank[0]) * (1.0 + share) / 2.0
        found.append((phi, rocker[0] + (rocker[1] - rocker[0]) * done))
    return tuple(found)


def _value(y: str | Function, x: float) -> float:
    """Return y at x."""
    if isinstance(y, str):
        try:
            return Expression.of(y, ["x"])({"x": x})
        except InputError as error:
            raise InputError(
                f"y: {error} at x = {x:g}", "as in x^1.5 or sin(x), in degrees"
            ) from None
    try:
        found = y(x)
    except Exception as error:  # a function of a user may raise anything
        raise InputError(f"y: {type(error).__name__} at x = {x:g}: {error}") from error
    return gate.number("y", found)


def _links(pairs: Sequence[Row]) -> tuple[float, float]:
    """Return crank and rocker over the ground, with their signs."""
    (phi, psi), *others = pairs
    rows = [
        (
            _less(psi, other_psi),
            -_less(phi, other_phi),
            _less(phi - psi, other_phi - other_psi),
        )
        for other_phi, other_psi in others
    ]
    (a, b, e), (c, d, f) = rows
    under = a * d - b * c
    if abs(under) <= _LEAST_SINE * math.hypot(a, b) * math.hypot(c, d):
        raise InputError(
            "pairs: these three pairs determine no four-bar", "change one of the angles"
        )
    k1, k2 = (e * d - b * f) / under, (a * f - e * c) / under
    for name, k in (("crank", k1), ("rocker", k2)):
        if abs(k) * _LONGEST <= 1.0:
            raise InputError(
                f"pairs: the {name} would be more than {_LONGEST:g} times as long as the ground",
                "change one of the angles",
            )
    return 1.0 / k1, 1.0 / k2


def _less(angle: float, other: float) -> float:
    """Return cos(angle) - cos(other), in degrees, exact where they are near each other."""
    return float(-2.0 * ray((angle + other) / 2.0).imag * ray((angle - other) / 2.0).imag)


#: The task.
TASK = Task(
    "function",
    "Four-bar for three pairs of angles, or for a function",
    (
        Demand(
            "pairs",
            "angle angle",
            "angles of crank and rocker from the ground's direction, three times",
            rows=3,
            example="'40 70, 60 82, 80 97'",
        ),
        Demand(
            "y",
            "function",
            "or a function of x; Chebyshev's spacing chooses three places",
            example="'x^1.5'",
        ),
        Demand("x", "number number", "the range of x", example="'1 4'"),
        Demand(
            "crank_range",
            "angle angle",
            "the angles of the crank at the ends of that range",
            example="'30 120'",
        ),
        Demand(
            "rocker_range",
            "angle angle",
            "the angles of the rocker at the ends of that range",
            example="'60 150'",
        ),
        Demand("ground", "length", "the length of the ground, which sets the size", example="100"),
    ),
    solve,
    "the ground is 100",
)
