"""A slider-crank from its stroke and its time ratio.

At its two dead centres the slider is at b + a and at b - a from the crank's pivot, and between
these two lines is δ.  By the law of cosines

    4 b² sin²(δ/2) + 4 a² cos²(δ/2) = s²

in the triangle of the pivot and the two places of the slider.  The height of the triangle is the
offset, e = (b² - a²) sin δ / s.  With t = tan(δ/2) this is

    a² = s²/4 - s e t / 2,      b² = s²/4 + s e / (2 t),

so one length is free.  The crank turns fully, and the slider does not jump into the other assembly,
while t s/2 < a < s/2.
"""

from __future__ import annotations

import math

from vad.designs.dead_centres import TIME_RATIO, imbalance, place
from vad.designs.task import Answer, Demand, Task, above, below
from vad.errors import InputError, UsageError
from vad.mechanisms.slider_crank import SliderCrank

#: From here on there is none: the two lines of the dead centres would be at right angles.
_MOST = 3.0
#: The length of the rod over that of the crank where any one does: for the time ratio 1.
_USUAL_RATIO = 4.0
_FREE = ("crank", "rod", "offset", "ratio")


def solve(
    stroke: float,
    time_ratio: float,
    crank: float | None = None,
    rod: float | None = None,
    offset: float | None = None,
    ratio: float | None = None,
    length_unit: str = "mm",
) -> list[Answer]:
    """Return the slider-cranks with this stroke and time ratio: one for each sign of the offset.

    At most one of `crank`, `rod`, `offset` and `ratio` (rod over crank) is given.  With none of
    them the transmission angle stays as near to 90° as it can: (a + e) / b is least where
    a = (s/4) (√(4 + 5 t²) - t), for the cubic of its derivative has the root a = t s/2, too.
    """
    chosen = {"crank": crank, "rod": rod, "offset": offset, "ratio": ratio}
    given = {name: value for name, value in chosen.items() if value is not None}
    if len(given) > 1:
        raise UsageError(f"{' and '.join(given)}: give one of them", "the others follow from it")
    if time_ratio >= _MOST:
        raise InputError(
            f"time_ratio: {time_ratio:g} is too large for a slider-crank, it must be below 3",
            "a quick return has more: vad design quick-return",
        )
    if time_ratio == 1.0:
        return [_answer(*_in_line(stroke, given), 0.0, length_unit)]
    delta = imbalance(time_ratio)
    sine, cosine, t = math.sin(delta / 2.0), math.cos(delta / 2.0), math.tan(delta / 2.0)
    ends = {
        "crank": (t * stroke / 2.0, stroke / 2.0),
        "rod": (stroke / 2.0, stroke / t / 2.0),
        "offset": (0.0, stroke / math.tan(delta)),
        "ratio": (1.0, 1.0 / t**2),
    }
    for name, value in given.items():
        low, high = ends[name]
        if not low < (abs(value) if name == "offset" else value) < high:
            between = f"must be between {above(low)} and {below(high)}"
            raise InputError(f"{name}: {between} with these demands, got {value:g}")
    if offset is not None:
        a = math.sqrt((stroke - 2.0 * abs(offset) * t) * stroke) / 2.0
        b = math.sqrt((stroke + 2.0 * abs(offset) / t) * stroke) / 2.0
    elif ratio is not None:
        a = stroke / 2.0 / math.hypot(ratio * sine, cosine)
        b = ratio * a
    elif rod is not None:
        a, b = _other(stroke, rod, sine, cosine), rod
    else:
        a = crank or stroke / 4.0 * (math.sqrt(4.0 + 5.0 * t * t) - t)
        b = _other(stroke, a, cosine, sine)
    height = abs(offset) if offset is not None else (b - a) * (b + a) * math.sin(delta) / stroke
    signs = (1.0, -1.0) if offset is None else (math.copysign(1.0, offset),)
    return [_answer(a, b, sign * height, length_unit) for sign in signs]


def _in_line(stroke: float, given: dict[str, float]) -> tuple[float, float]:
    """Return crank and rod for strokes of the same time, where any rod does."""
    crank = stroke / 2.0
    for name in ("crank", "offset"):
        if name in given:
            only = {"crank": crank, "offset": 0.0}[name]
            raise UsageError(
                f"{name}: is {only:g} for the time ratio 1, and not free", "--rod or --ratio is"
            )
    rod = given.get("rod", given.get("ratio", _USUAL_RATIO) * crank)
    if rod <= crank:
        name, least = ("rod", crank) if "rod" in given else ("ratio", 1.0)
        raise InputError(f"{name}: must be more than {least:g}, got {given[name]:g}")
    return crank, rod


def _other(stroke: float, known: float, factor: float, divisor: float) -> float:
    """Return the side x of (known·factor)² + (x·divisor)² = (stroke/2)²."""
    half = stroke / 2.0
    return math.sqrt((half - known * factor) * (half + known * factor)) / divisor


def _answer(a: float, b: float, offset: float, unit: str) -> Answer:
    """Return the answer with its two dead centres: the slider far from the crank, and near it."""
    height = abs(offset)
    far = math.asin(height / (b + a))
    near = math.asin(height / (b - a))
    places = (far, near + math.pi) if offset >= 0.0 else (-far, math.pi - near)
    # The crank goes counter-clockwise from the near dead centre to the far one.
    notes = () if not offset else ("slow out",) if offset < 0.0 else ("slow in",)
    mechanism = SliderCrank(crank=a, rod=b, offset=offset, length_unit=unit)
    return Answer(mechanism, tuple(map(place, places)), notes=notes)


#: The task.
TASK = Task(
    "slider-crank",
    "Slider–crank from its stroke and time ratio",
    (
        Demand("stroke", "length", "of the slider", needed=True, example="120"),
        TIME_RATIO,
        Demand("crank", "length", "a free choice: the crank", example="58"),
        Demand("rod", "length", "or the rod", example="150"),
        Demand(
            "offset",
            "length",
            "or the offset of the guide, with its sign",
            signed=True,
            example="40",
        ),
        Demand(
            "ratio",
            "number",
            "or the length of the rod over that of the crank",
            example="3",
        ),
    ),
    solve,
    "the transmission angle stays as near to 90° as it can; for the time ratio 1 the rod has four "
    "lengths of the crank",
)
