"""What every mark is for, and what it looks like unless a style says otherwise.

A mark bears the name of a role; a style turns the role into colours, and may give the lines of
links a weight and a dash of their own.  Widths are in page units, dashes in line widths.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

#: A colour by its purpose: ``row`` is the ink of a row of the results, ``tint`` that ink in pale,
#: ``ground`` the background, ``pale`` the words of a panel that is not begun.
Ink = Literal["text", "grey", "hairline", "ground", "pale", "row", "tint"]


@dataclass(frozen=True, slots=True)
class Role:
    """The look of a mark: filled with ``fill``, drawn along its edge with ``line``, or both.

    Attributes
    ----------
    fill, line
        The inks of area and line.
    width
        Of the line.
    dash
        On and off in turn, in line widths; empty for a solid line.
    cap, join
        Of the line's ends and corners.
    alpha
        How much of the ink covers what lies beneath.
    linked
        Whether a style tells links apart by the weight and dash of this line.
    halo
        Width of a line of background beneath the mark.
    """

    fill: Ink | None = None
    line: Ink | None = None
    width: float = 0.0
    dash: tuple[float, ...] = ()
    cap: Literal["butt", "round"] = "butt"
    join: Literal["miter", "round"] = "miter"
    alpha: float = 1.0
    linked: bool = False
    halo: float = 0.0


BAR = 0.0092
VECTOR = 0.0060
WHOLE = 0.0040  # a vector beside its own parts, or found by an image
CONSTRUCTION = 0.0046
BLOCK_RIM = 0.0042
PLATE_EDGE = 0.0046
JOINT_RIM = 0.0036
DOT_RIM = 0.0022
AXIS = 0.0019
PATH = 0.0026  # on which a point of a mechanism in space runs
LIGHT = 3.4  # beneath a growing stroke, in its widths
HALO = 0.009


#: What a vector in flight leaves behind, and what that is where there are no colours.
GHOSTS = {"ghost": "dashed ghost", "ghost head": "outlined ghost"}


def _light(width: float) -> Role:
    return Role(line="row", width=LIGHT * width, alpha=0.20)


ROLES: dict[str, Role] = {
    # words
    "words": Role(fill="text"),
    "notes": Role(fill="grey"),
    "pale words": Role(fill="pale"),
    "term": Role(fill="row"),
    "pending term": Role(fill="row", alpha=0.42),
    "letter": Role(fill="text", halo=HALO),
    "tag": Role(fill="row", halo=HALO),
    "value": Role(fill="grey", halo=HALO),
    "leader": Role(line="grey", width=0.0018),
    # the page
    "rule": Role(line="text", width=0.0020),
    "pale rule": Role(line="hairline", width=0.0020),
    "hairline": Role(line="hairline", width=0.0015),
    "chapter": Role(line="text", width=0.0060),
    "chapter done": Role(line="grey", width=0.0060),
    "chapter ahead": Role(line="hairline", width=0.0060),
    "writing line": Role(line="grey", width=0.0015),
    "scale bar": Role(line="grey", width=0.0028),
    "key": Role(line="row", width=0.85 * BAR, linked=True),
    # the mechanism
    "bar": Role(line="row", width=BAR, cap="round", linked=True),
    "bar light": _light(BAR),
    "bar casing": Role(line="ground", width=0.68 * BAR, cap="round"),
    "piston rod": Role(line="row", width=0.0052, linked=True),
    "slit": Role(fill="ground", line="row", width=0.0030, join="round"),
    "plate": Role(fill="row", alpha=0.15),
    "plate edge": Role(line="row", width=PLATE_EDGE, join="round"),
    "plate edge light": Role(line="row", width=LIGHT * 2 * PLATE_EDGE, join="round", alpha=0.20),
    "block": Role(fill="tint", line="row", width=BLOCK_RIM),
    "block light": Role(line="row", width=LIGHT * 1.3 * BLOCK_RIM, join="round", alpha=0.20),
    "slot": Role(line="row", width=BLOCK_RIM, join="round"),
    "joint": Role(fill="ground", line="text", width=JOINT_RIM),
    "point": Role(fill="text", line="ground", width=DOT_RIM),
    "pivot": Role(fill="ground", line="text", width=0.0026),
    "rail": Role(line="grey", width=0.0026),
    "hatching": Role(line="grey", width=0.0022),
    "axis": Role(line="grey", width=AXIS, dash=(7.5, 2.2, 1.4, 2.2)),
    "gap": Role(line="ground", width=3 * AXIS),
    "angle": Role(line="grey", width=0.0024),
    "sense": Role(line="row", width=0.0032),
    "speed": Role(line="row", width=0.0032),
    "couple": Role(line="row", width=0.0050),
    # figures upon a mechanism
    "circle": Role(line="grey", width=0.0022, dash=(7.0, 5.0)),
    "edge": Role(line="row", width=0.0036, linked=True),
    # a mechanism in space
    "bar far": Role(line="row", width=0.6 * BAR, dash=(2.6, 1.6)),
    "path": Role(line="row", width=PATH, join="round"),
    "path far": Role(line="row", width=0.6 * PATH, dash=(7.0, 5.0)),
    "ball": Role(fill="hairline", alpha=0.16),
    "bearing": Role(fill="ground", line="text", width=0.0019),
    # the polygons
    "vector": Role(line="row", width=VECTOR, linked=True),
    "vector light": _light(VECTOR),
    "whole": Role(line="row", width=WHOLE, linked=True),
    "whole light": _light(WHOLE),
    "head": Role(fill="row"),
    "break": Role(line="row", width=0.0032),
    "ghost": Role(line="row", width=VECTOR, linked=True),
    "ghost head": Role(fill="row"),
    "dashed ghost": Role(line="grey", width=0.0024, dash=(4.0, 2.6)),
    "outlined ghost": Role(line="grey", width=0.0020),
    "flight path": Role(line="grey", width=0.0034, dash=(0.1, 2.6), cap="round"),
    "ring": Role(line="grey", width=0.0028),
    "dot": Role(fill="text", line="ground", width=DOT_RIM),
    "construction": Role(line="row", width=CONSTRUCTION, dash=(5.0, 3.2)),
    "construction light": _light(CONSTRUCTION),
    "construction done": Role(line="row", width=0.0022, dash=(7.0, 5.0), alpha=0.45),
    "compass arc": Role(line="row", width=0.6 * CONSTRUCTION),
    "right angle": Role(line="row", width=0.0022),
    "stub": Role(line="row", width=0.0022, alpha=0.7),
    # a turn
    "hodograph": Role(line="row", width=0.0026, join="round", alpha=0.40),
    "tail": Role(line="row", width=0.0046, join="round"),
    "return way": Role(line="text", width=0.0040, join="round", alpha=0.85),
    "position": Role(fill="row"),
    "numeral": Role(fill="row", halo=0.6 * HALO),
    "dimension": Role(line="grey", width=0.0020),
    "return": Role(fill="hairline", alpha=0.30),
    "excess": Role(fill="tint"),
    "mean": Role(line="grey", width=0.0024, dash=(6.0, 3.0)),
    "curve": Role(line="text", width=0.0046, join="round"),
    "curve ahead": Role(line="grey", width=0.0026, join="round", alpha=0.60),
    "axis line": Role(line="grey", width=0.0018),
    "cursor": Role(line="row", width=0.0026),
    # the Coriolis inset
    "inset lever": Role(line="row", width=0.0066, cap="round"),
    "inset block": Role(fill="tint", line="row", width=0.0030),
    "inset arrow": Role(line="row", width=WHOLE),
    "inset sense": Role(line="row", width=0.0030),
    # a lens
    "lens": Role(fill="ground"),
    "lens band": Role(line="ground", width=0.009),
    "lens rim": Role(line="grey", width=0.0032),
    "lens place": Role(line="grey", width=0.0022),
    # the tools
    "pencil": Role(fill="row"),
    "set square": Role(fill="grey", alpha=0.16),
    "set square edge": Role(line="grey", width=0.0020, join="round", alpha=0.55),
    "compass leg": Role(line="grey", width=0.0075, cap="round", join="round", alpha=0.30),
    "compass hinge": Role(fill="grey", alpha=0.75),
}
