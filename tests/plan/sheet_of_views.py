"""A sheet of a mechanism in space built by hand: a ball, and a shaft from above.

The ball is that of radius 1 about 0, seen from the front; the shaft is seen from above, at 3.
"""

from __future__ import annotations

import cmath
import math

from vad.strokes.sheet import (
    Arc,
    Arrow,
    Bearing,
    Block,
    Cell,
    Curve,
    Dot,
    Driver,
    Ellipse,
    Line,
    Note,
    Panel,
    Row,
    Sheet,
    Stroke,
    StrokePart,
)

#: Behind the ball for 0° to 180°.
ELLIPSE = Ellipse(0j, 1.0 + 0j, 0.4j, far=((0.0, 180.0),))
ABOVE = -2.6j


def sheet_of_views(degrees: float = 60.0) -> Sheet:
    """Return the sheet at one pose; all that moves is the pin P, its bar and its projector."""
    p = cmath.exp(1j * math.radians(degrees))
    down = complex(p.real) + ABOVE
    strokes = (
        Stroke("fixed", "", Ellipse(0j, 1.0 + 0j, 1j), "The ball.", part=StrokePart.named("ball")),
        Stroke("fixed", "O", Dot(0j), "O is its centre.", part=StrokePart.named("O.fixed")),
        Stroke(
            "guide",
            "",
            Curve((ABOVE - 0.9j, ABOVE + 0.3j)),
            "The shaft's axis.",
            part=StrokePart.named("axis"),
        ),
        Stroke(
            "fixed", "", Bearing(ABOVE - 0.6j, 1j), "Its bearing.", part=StrokePart.named("bearing")
        ),
        Stroke("known", "", ELLIPSE, "A circle.", "driving", part=StrokePart.named("circle")),
        Stroke(
            "known",
            "",
            Arrow(0j, p, "O", "P"),
            "P stands at 60°.",
            "driving",
            "link",
            reveals=("driving",),
            part=StrokePart.named("OP.bar"),
        ),
        Stroke(
            "angle",
            f"{degrees:g}°",
            Arc(0j, 0.4, 0.0, degrees),
            "That is 60°.",
            "driving",
            part=StrokePart.named("OP.angle"),
        ),
        Stroke(
            "construction",
            "",
            Arc(0j, 0.7, 100.0, 80.0, 0.7j),
            "The compass.",
            "driven",
            part=StrokePart.named("Q.compass"),
        ),
        Stroke(
            "construction",
            "",
            Line(0j, -1j * p, -0.7j * p),
            "OQ is square to OP.",
            "driven",
            part=StrokePart.named("OQ.line"),
        ),
        Stroke(
            "intersection",
            "Q",
            Dot(-0.7j * p),
            "They meet at Q.",
            "driven",
            part=StrokePart.named("Q.found"),
        ),
        Stroke(
            "construction",
            "",
            Curve((p, down, 0.7j, -2j), breaks=(2,)),
            "P from above.",
            part=StrokePart.named("P.projector"),
        ),
        Stroke(
            "result",
            "2",
            Curve((ABOVE - 0.6j, ABOVE, down)),
            "The yoke.",
            "driving",
            "link",
            part=StrokePart.named("yoke"),
        ),
        Stroke("result", "P", Dot(down), "P.", "driving", part=StrokePart.named("P.above")),
        Stroke(
            "intersection", "T", Dot(ABOVE + 1.2), "T is a point.", part=StrokePart.named("T.found")
        ),
        Stroke(
            "result",
            "",
            Block(ABOVE - 1.2, 1j),
            "A sleeve.",
            "driven",
            reveals=("driven",),
            part=StrokePart.named("sleeve"),
        ),
    )
    position = Panel(
        "position",
        "",
        strokes,
        title="Position",
        picture="views",
        notes=(Note(1.2 + 1j, "seen from the front"), Note(ABOVE + 1.2, "from above")),
    )
    velocity = Panel(
        "velocity",
        "rad/s",
        (
            Stroke("pole", "1", Dot(0j), "The pole.", part=StrokePart.named("pole")),
            Stroke(
                "known",
                "ω₂",
                Arrow(0j, -10j, "1", "2"),
                "12 = ω₂.",
                "driving",
                "absolute",
                reveals=("driving",),
                part=StrokePart.named("2.whole"),
            ),
        ),
        title="Velocity",
    )
    rows = (
        Row(
            "driving",
            "driving shaft",
            "2",
            {
                "position": (Cell("θ", degrees, "°", True),),
                "velocity": (Cell("ω", 10.0, "rad/s", True),),
            },
        ),
        Row("driven", "driven shaft", "4", {"position": (Cell("θ", degrees - 90.0, "°"),)}),
    )
    driver = Driver("driving", rate=10.0, angle="OP.angle")
    parameters = (("shaft angle", 30.0, "°"),)
    return Sheet("ball", "Ball", parameters, rows, (position, velocity), driver=driver)
