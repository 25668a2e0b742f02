"""A slider-crank sheet built by hand, so that these tests need no solver."""

from __future__ import annotations

import cmath
import math

from vad.strokes.sheet import (
    Arc,
    Arrow,
    Block,
    Body,
    Cell,
    Dot,
    Driver,
    Equation,
    Guide,
    Line,
    Panel,
    Ride,
    Row,
    Sheet,
    Stroke,
    StrokePart,
    Term,
)


def slider_crank(degrees: float = 60.0, omega: float = 10.0, alpha: float = 20.0) -> Sheet:
    """Return the sheet of a slider-crank, crank 60 and rod 140, at one pose."""
    crank, rod = 60.0, 140.0
    theta = math.radians(degrees)
    b = crank * cmath.exp(1j * theta)
    c = complex(b.real + math.sqrt(rod**2 - b.imag**2), 0.0)
    way = (c - b) / rod
    vb = 1j * omega * b
    rod_omega = -vb.imag / (1j * (c - b)).imag
    vc = complex((vb + 1j * rod_omega * (c - b)).real, 0.0)
    ab_n = -(omega**2) * b
    ab = ab_n + 1j * alpha * b
    cn = ab - rod_omega**2 * (c - b)
    rod_alpha = -cn.imag / (1j * (c - b)).imag
    ac = complex((cn + 1j * rod_alpha * (c - b)).real, 0.0)

    def unit(z: complex) -> complex:
        return z / abs(z) if abs(z) > 1e-9 else 1 + 0j

    position = Panel(
        "position",
        "mm",
        (
            Stroke(
                "fixed",
                "A",
                Dot(0j),
                "A is the crank's pivot, fixed in the frame.",
                part=StrokePart.named("A.fixed"),
            ),
            Stroke(
                "guide",
                "",
                Guide(0j, 1 + 0j, -1j),
                "C slides on the guide.",
                "slider",
                part=StrokePart.named("DC.guide"),
            ),
            Stroke(
                "known",
                "AB",
                Arrow(0j, b, "A", "B"),
                "AB, the crank, is 60 mm long.",
                "crank",
                "link",
                part=StrokePart.named("AB.bar"),
            ),
            Stroke(
                "angle",
                f"{degrees:g}°",
                Arc(0j, crank, 0.0, degrees),
                "It stands at 60°.",
                part=StrokePart.named("AB.angle"),
            ),
            Stroke(
                "construction",
                "BC",
                Arc(b, rod, math.degrees(cmath.phase(way)) - 14, 28.0, through=c),
                "C lies on a circle of 140 mm about B.",
                "rod",
                part=StrokePart.named("BC.compass"),
            ),
            Stroke(
                "construction",
                "∥ guide",
                Line(0j, 1 + 0j, c),
                "C lies on the guide.",
                "slider",
                part=StrokePart.named("DC.line"),
            ),
            Stroke(
                "intersection", "C", Dot(c), "They meet at C.", part=StrokePart.named("C.found")
            ),
            Stroke(
                "result",
                "BC",
                Arrow(b, c, "B", "C"),
                "BC is the rod: θ₃ = 338.2°.",
                "rod",
                "link",
                reveals=("rod",),
                part=StrokePart.named("BC.bar"),
            ),
            Stroke(
                "result",
                "C",
                Block(c, 1 + 0j),
                "C is the slider: x = 160.0 mm.",
                "slider",
                reveals=("slider",),
                part=StrokePart.named("DC.block"),
            ),
        ),
        (
            Equation(
                (Term("AB", "crank", "AB.bar"), Term("BC", "rod", "BC.bar")),
                (Term("AC", "slider", "DC.block"),),
            ),
        ),
        title="Position",
        picture="skeleton",
        bodies=(
            Body(None, ("A",), (Ride("DC.block", "DC.guide"),)),
            Body("crank", ("A", "B")),
            Body("rod", ("B", "C")),
            Body("slider", ("C",)),
        ),
    )
    velocity = Panel(
        "velocity",
        "mm/s",
        (
            Stroke(
                "pole",
                "a, d",
                Dot(0j),
                "The fixed points a and d are at the pole.",
                part=StrokePart.named("pole"),
            ),
            Stroke(
                "known",
                "ab",
                Arrow(0j, vb, "a", "b"),
                "ab = ω₂·AB = 10 × 60 = 600.0 mm/s, ⟂ AB",
                "crank",
                "tangential",
                part=StrokePart.named("AB.tangential"),
            ),
            Stroke(
                "construction",
                "⟂ BC",
                Line(vb, unit(vc - vb), vc, "BC"),
                "Through b, perpendicular to BC: C moves about B in a circle.",
                "rod",
                part=StrokePart.named("BC.line"),
            ),
            Stroke(
                "construction",
                "∥ guide",
                Line(0j, unit(vc), vc),
                "Through the pole, parallel to the guide: the slider can move no other way, "
                "so c lies on this line.",
                "slider",
                part=StrokePart.named("DC.line"),
            ),
            Stroke(
                "intersection",
                "c",
                Dot(vc),
                "The lines cross at c.",
                part=StrokePart.named("C.crossing"),
            ),
            Stroke(
                "result",
                "bc",
                Arrow(vb, vc, "b", "c"),
                "bc = 323.2 mm/s, so ω₃ = bc/BC = −2.308 rad/s.",
                "rod",
                "tangential",
                reveals=("rod",),
                part=StrokePart.named("BC.tangential"),
            ),
            Stroke(
                "result",
                "dc",
                Arrow(0j, vc, "d", "c"),
                "dc = 639.5 mm/s is the velocity of C.",
                "slider",
                "absolute",
                reveals=("slider",),
                part=StrokePart.named("DC.sliding"),
            ),
        ),
        (
            Equation(
                (Term("ab", "crank", "AB.tangential"), Term("bc", "rod", "BC.tangential")),
                (Term("dc", "slider", "DC.sliding"),),
            ),
        ),
        title="Velocity",
    )
    acceleration = Panel(
        "acceleration",
        "mm/s²",
        (
            Stroke(
                "pole",
                "a′, d′",
                Dot(0j),
                "The fixed points a′ and d′ are at the pole.",
                part=StrokePart.named("pole"),
            ),
            Stroke(
                "known",
                "a′b′ₙ",
                Arrow(0j, ab_n, "a′", "b′ₙ"),
                "a′b′ₙ = ω₂²·AB = 10² × 60 = 6000 mm/s², from B towards A",
                "crank",
                "normal",
                part=StrokePart.named("AB.normal"),
            ),
            Stroke(
                "known",
                "b′ₙb′",
                Arrow(ab_n, ab, "b′ₙ", "b′"),
                "b′ₙb′ = α₂·AB = 20 × 60 = 1200 mm/s², ⟂ AB",
                "crank",
                "tangential",
                part=StrokePart.named("AB.tangential"),
            ),
            Stroke(
                "result",
                "a′b′",
                Arrow(0j, ab, "a′", "b′"),
                "a′b′ = 6119 mm/s² is the acceleration of B.",
                "crank",
                "relative",
                part=StrokePart.named("AB.whole"),
            ),
            Stroke(
                "known",
                "b′cₙ",
                Arrow(ab, cn, "b′", "cₙ"),
                "b′cₙ = ω₃²·BC = 746.0 mm/s², from C towards B",
                "rod",
                "normal",
                part=StrokePart.named("BC.normal"),
            ),
            Stroke(
                "construction",
                "⟂ BC",
                Line(cn, unit(ac - cn), ac, "BC"),
                "Through cₙ, perpendicular to BC.",
                "rod",
                part=StrokePart.named("BC.line"),
            ),
            Stroke(
                "construction",
                "∥ guide",
                Line(0j, unit(ac), ac),
                "Through the pole, parallel to the guide.",
                "slider",
                part=StrokePart.named("DC.line"),
            ),
            Stroke(
                "intersection",
                "c′",
                Dot(ac),
                "The lines cross at c′.",
                part=StrokePart.named("C.crossing"),
            ),
            Stroke(
                "result",
                "cₙc′",
                Arrow(cn, ac, "cₙ", "c′"),
                "cₙc′ = 4653 mm/s², so α₃ = 33.23 rad/s².",
                "rod",
                "tangential",
                reveals=("rod",),
                part=StrokePart.named("BC.tangential"),
            ),
            Stroke(
                "result",
                "b′c′",
                Arrow(ab, ac, "b′", "c′"),
                "b′c′ is the whole acceleration of C relative to B.",
                "rod",
                "relative",
                part=StrokePart.named("BC.whole"),
            ),
            Stroke(
                "result",
                "d′c′",
                Arrow(0j, ac, "d′", "c′"),
                "d′c′ = 3005 mm/s² is the acceleration of C.",
                "slider",
                "absolute",
                reveals=("slider",),
                part=StrokePart.named("DC.sliding"),
            ),
        ),
        (
            Equation(
                (
                    Term("a′b′ₙ", "crank", "AB.normal"),
                    Term("b′ₙb′", "crank", "AB.tangential"),
                    Term("b′cₙ", "rod", "BC.normal"),
                    Term("cₙc′", "rod", "BC.tangential"),
                ),
                (Term("d′c′", "slider", "DC.sliding"),),
            ),
        ),
        title="Acceleration",
    )
    rows = (
        Row(
            "crank",
            "crank",
            "AB",
            {
                "position": (Cell("θ", degrees, "°", True),),
                "velocity": (Cell("ω", omega, "rad/s", True),),
                "acceleration": (Cell("α", alpha, "rad/s²", True),),
            },
        ),
        Row(
            "rod",
            "rod",
            "BC",
            {
                "position": (Cell("θ", math.degrees(cmath.phase(way)) % 360, "°"),),
                "velocity": (Cell("ω", rod_omega, "rad/s"),),
                "acceleration": (Cell("α", rod_alpha, "rad/s²"),),
            },
        ),
        Row(
            "slider",
            "slider",
            "C",
            {
                "position": (Cell("x", c.real, "mm"),),
                "velocity": (Cell("v", vc.real, "mm/s"),),
                "acceleration": (Cell("a", ac.real, "mm/s²"),),
            },
        ),
    )
    return Sheet(
        "slider-crank",
        "Slider–crank",
        (("crank", crank, "mm"), ("rod", rod, "mm"), ("offset", 0.0, "mm")),
        rows,
        (position, velocity, acceleration),
        driver=Driver("crank", rate=omega, stroke="AB.bar", angle="AB.angle"),
    )
