"""What captions of a polygon of bodies say: where numbers come from that no other stroke has."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest

import vad
from tests.strokes.named import dot, vector
from vad.strokes.sentences import Sentence
from vad.strokes.sheet import Arrow, Curve, Dot, Panel
from vad.strokes.space.body_polygons import BodyScript
from vad.strokes.space.scene import SceneInSpace
from vad.words import Language

KINDS = ("spherical-four-bar", "hooke-joint", "spatial-four-bar")
#: The vectors of the polygon of velocities that begin or end at 2: to 1, to 3 and along 2 4.
FROM_TWO = (("12", "absolute"), ("23", "relative"), ("24", "relative"))
ANGLES = (25.0, 140.0, 250.0)


def scene(name: str, **inputs: float) -> SceneInSpace:
    return SceneInSpace(vad.solve(vad.MECHANISMS[name](), **inputs), Language("en"))


def said(drawn: SceneInSpace, word: str) -> list[Sentence]:
    """Return the sentences of the polygon of accelerations whose phrase has a word."""
    strokes = vad.draw(drawn.motion).panel("acceleration").strokes
    sentences = [stroke.said for stroke in strokes if isinstance(stroke.said, Sentence)]
    return [each for each in sentences if word in each.phrase]


@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("name", KINDS)
def test_the_rate_at_which_oi_turns_is_a_part_of_the_coupler_s_over_a_sine(
    name: str, angle: float
) -> None:
    drawn = scene(name, angle=angle)
    script = drawn.script
    assert isinstance(script, BodyScript)
    axis = script.bodies.axis
    coupler = drawn.motion.link("cross" if name == "hooke-joint" else "coupler").omega
    normals = np.cross(axis.b, axis.c), np.array([1.0, 0.0, 0.0])  # of the coupler, of the frame
    first, second = (each / np.linalg.norm(each) for each in normals)
    sine = np.linalg.norm(np.cross(first, second))
    found = said(drawn, " turned ")
    assert len(found) == (2 if name == "spherical-four-bar" else 1)
    for sentence, normal in zip(found, (first, second), strict=False):
        across = np.cross(normal, axis.i)  # in the other plane, perpendicular to OI
        part = abs(np.dot(coupler, across))
        figures = {
            each: next(sentence.figures((each,))).value
            for each in ("delta", "pace", "value", "omega")
            if each in sentence.parts
        }
        if "pace" in figures:  # a formula of its own
            assert figures["pace"] == pytest.approx(part / sine)
        else:
            delta = math.radians(figures["delta"])
            assert math.sin(delta) == pytest.approx(sine)
            own, other = (each.value for each in sentence.figures(("apart",)))
            assert own + other * math.cos(delta) == pytest.approx(part)
            measured = from_line(drawn)
            order = "31" if normal is first else "13"
            assert [abs(own), abs(other)] == pytest.approx([measured[each] for each in order])
        assert figures["value"] == pytest.approx(figures["omega"] * part / sine)


def from_line(drawn: SceneInSpace) -> dict[str, float]:
    """Return how far 1 and 3 are from the line 2 4 in the polygon of velocities, as it is drawn."""
    polygon = vad.draw(drawn.motion).panel("velocity")
    one, three, line = (vector(polygon, f"{each}.{kind}") for each, kind in FROM_TWO)
    return {name: abs((way / line).imag) * abs(line) for name, way in (("1", one), ("3", three))}


def axis_drawn(views: Panel, name: str) -> complex:
    """Return the direction in which the axis OX is drawn from O on; those of shafts are given."""
    shafts = {"O2": -1j, "O4": cmath.rect(1.0, math.radians(-60.0))}
    if name in shafts:
        return shafts[name]
    strokes = {each.name: each.shape for each in views.strokes}
    for curve in (f"{name}.laid", f"star.{name[1]}"):  # the one ends at O, the other begins there
        if isinstance(shape := strokes.get(curve), Curve):
            ends = shape.points[0], shape.points[-1]
            return ends[0] - ends[1] if curve.endswith("laid") else ends[1] - ends[0]
    if name == "OT":
        line = strokes["OT.line"]
        assert isinstance(line, Curve)
        return dot(views, "T.plan") - sum(line.points) / 2.0
    at = {s.part.of: s.shape.at for s in views.strokes if isinstance(s.shape, Dot)}
    return at[name[1]] - at["O"]


@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("name", KINDS)
def test_a_rate_has_the_sign_of_its_vector_along_the_axis_that_is_drawn(
    name: str, angle: float
) -> None:
    """In the table and in all that is said, so that the numbers of a sum add up as it is drawn."""
    drawn = vad.draw(scene(name, angle=angle, alpha=20.0).motion)
    views, hooke = drawn.panel("position"), name == "hooke-joint"
    letters = "24TPQ" if hooke else "ADIBC"
    axes = dict(zip(("₂", "₄", "₄₂", "₃₂", "₃₄"), letters, strict=True))
    tabled = {x.symbol: x.value for row in drawn.rows for each in row.cells.values() for x in each}
    seen = set()
    for panel in ("velocity", "acceleration"):
        for stroke in drawn.panel(panel).strokes:
            symbol, shape = stroke.label, stroke.shape
            axis = axes.get(symbol[1:].rstrip("ₜ"))
            if axis is None or not isinstance(shape, Arrow):
                continue
            way = axis_drawn(views, f"O{axis}")
            along = ((shape.end - shape.start) * way.conjugate() / abs(way)).real
            assert abs(along) == pytest.approx(abs(shape.end - shape.start)), symbol
            stated = [tabled[symbol]] if symbol in tabled else []
            if isinstance(stroke.said, Sentence) and stroke.said.parts.get("symbol") == symbol:
                stated += [each.value for each in stroke.said.figures(("value",))]
            for value in stated:
                assert value == pytest.approx(along), symbol
                seen.add(symbol)
    assert {"ω₂", "ω₄", "ω₄₂", "α₂", "α₄", "α₄₂ₜ"} <= seen


@pytest.mark.parametrize("name", KINDS)
def test_a_caption_names_2_at_the_pole_only_where_it_lies_there(name: str) -> None:
    axis = "shaft 2" if name == "hooke-joint" else "OA"
    for alpha, text in (
        (0.0, "The pole: the frame, 1′, and 2′, as α₂ = 0 is given."),
        (20.0, f"The pole is the frame, 1′; α₂ = 20 rad/s², along {axis}."),
    ):
        poles = said(scene(name, angle=60.0, alpha=alpha), "bodies pole")
        assert [str(each) for each in poles] == [text] * (2 if alpha else 1)
        drawn = vad.draw(vad.solve(vad.MECHANISMS[name](), angle=60.0, alpha=alpha))
        dot = drawn.panel("acceleration").strokes[0]
        assert ("2′" in dot.label.split(",")) == (not alpha)
