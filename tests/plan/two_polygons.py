"""A sheet made by hand: in one column a polygon of angular velocities, and below it one of speeds.

The numbers are those of a spatial four-bar; nothing of a mechanism is asked.
"""

from __future__ import annotations

import cmath
import math

from vad.strokes.sheet import (
    Arrow,
    Cell,
    Dot,
    Equation,
    Line,
    Panel,
    PolarInset,
    Row,
    Sheet,
    Stroke,
    StrokePart,
    Term,
)


def _way(degrees: float) -> complex:
    return cmath.rect(1.0, math.radians(degrees))


A, I, D = _way(-120.0), _way(-137.3), _way(-60.0)  # noqa: E741 — the axis is called so
TWO, FOUR = 10.0 * A, 3.05 * D
Y, Z = 329.9 * I * -1j, 305.0 * D * 1j
A4 = Y - 386.9 * I


def _line(name: str, label: str, through: complex, way: complex, until: complex, link: str):
    shape = Line(through, way, until)
    return Stroke(
        "construction", label, shape, f"{label}: a line.", link, part=StrokePart.named(name)
    )


def _arrow(kind, name, label, ends, letters, caption, link, **more):
    return Stroke(
        kind, label, Arrow(*ends, *letters), caption, link, part=StrokePart.named(name), **more
    )


UPPER = (
    Stroke(
        "pole",
        "1",
        Dot(0j),
        "The pole: the frame, 1, does not turn.",
        part=StrokePart.named("pole"),
    ),
    _arrow("known", "2.known", "ω₂", (0j, TWO), "12", "12 = ω₂ = 10 rad/s.", "crank"),
    _line("I.line", "∥ OI", TWO, -I, FOUR, "axis"),
    _line("D.line", "∥ OD", 0j, D, FOUR, "rocker"),
    Stroke(
        "intersection",
        "4",
        Dot(FOUR),
        "4 is where the two lines cross.",
        part=StrokePart.named("4.crossing"),
    ),
    _arrow(
        "result", "42", "ω₄₂", (TWO, FOUR), "24", "ω₄₂ = 8.877 rad/s.", "axis", reveals=("axis",)
    ),
    _arrow(
        "result", "4", "ω₄", (0j, FOUR), "14", "ω₄ = 3.050 rad/s.", "rocker", reveals=("rocker",)
    ),
)
LOWER = (
    Stroke(
        "pole", "a,d", Dot(0j), "A and D of the frame stand still.", part=StrokePart.named("pole")
    ),
    _arrow("known", "y.known", "", (0j, Y), ("a", "y"), "ay = 8.877 × 37.16 mm/s.", "axis"),
    _line("I.line", "∥ OI", Y, -I, A4, "axis"),
    _arrow("known", "z.known", "", (0j, Z), ("d", "z"), "dz = 3.050 × 100 mm/s.", "rocker"),
    _line("D.line", "∥ OD", Z, -D, A4, "rocker"),
    Stroke(
        "intersection",
        "a₄",
        Dot(A4),
        "a₄ is where the two lines cross.",
        part=StrokePart.named("a4.crossing"),
    ),
    _arrow(
        "result",
        "v42",
        "v₄₂",
        (Y, A4),
        ("y", "a₄"),
        "ya₄ = 386.9 mm/s.",
        "axis",
        reveals=("axis",),
    ),
    _arrow(
        "result",
        "sD",
        "ṡ_D",
        (Z, A4),
        ("z", "a₄"),
        "ṡ_D = −406.8 mm/s.",
        "rocker",
        reveals=("rocker",),
    ),
)


def equation(left: str, right: str, links: str) -> Equation:
    """Return an equation by the labels, and the links, of its terms."""
    keys = {"c": "crank", "i": "axis", "r": "rocker", "-": None}
    labels = [*left.split(), *right.split()]
    terms = [Term(label, keys[key], None) for label, key in zip(labels, links, strict=True)]
    return Equation(tuple(terms[: len(left.split())]), tuple(terms[len(left.split()) :]))


def sheet(inset: PolarInset | None = None, remark: str = "") -> Sheet:
    """Return the sheet: three columns, of which the second has two polygons."""
    below = Panel(
        "velocity.below",
        "mm/s",
        LOWER,
        (equation("ay ya₄", "dz za₄", "iirr"),),
        title="Velocity",
    )
    velocity = Panel(
        "velocity",
        "rad/s",
        UPPER,
        (equation("ω₂ ω₄₂", "ω₄", "cir"),),
        title="Velocity",
        below=below,
    )
    single = Panel(
        "acceleration",
        "rad/s²",
        UPPER,
        (equation("α₂ ω₄₂τ̇ α₄₂ₜ", "α₄", "ciir"),),
        inset,
        title="Acceleration",
        remark=remark,
    )
    rows = (
        Row("crank", "crank", "A", {"velocity": (Cell("ω₂", 10.0, "rad/s", True),)}),
        Row(
            "axis",
            "axis",
            "I",
            {
                "velocity": (Cell("ω₄₂", -8.877, "rad/s"), Cell("v₄₂", -386.9, "mm/s", below=True)),
                "acceleration": (
                    Cell("ω₄₂τ̇", 21.19, "rad/s²"),
                    Cell("α₄₂ₜ", 17.69, "rad/s²"),
                ),
            },
        ),
        Row(
            "rocker",
            "rocker",
            "D",
            {"velocity": (Cell("ω₄", 3.05, "rad/s"), Cell("ṡ", -406.8, "mm/s", below=True))},
        ),
    )
    return Sheet(
        "spatial-four-bar",
        "Spatial four-bar",
        (("ground", 100.0, "mm"), ("∠", 60.0, "°"), ("crank", 40.0, "mm"), ("∠", 30.0, "°")),
        rows,
        (velocity, single),
    )
