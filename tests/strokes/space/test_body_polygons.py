"""What captions of a polygon of bodies say: where numbers come from that no other stroke has."""

from __future__ import annotations

import math

import numpy as np
import pytest

import vad
from vad.strokes.sentences import Sentence
from vad.strokes.space.body_polygons import BodyScript
from vad.strokes.space.scene import SceneInSpace
from vad.words import Language

KINDS = ("spherical-four-bar", "hooke-joint", "spatial-four-bar")
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
            for each in ("part", "delta", "pace", "value", "omega")
            if each in sentence.parts
        }
        if "pace" in figures:  # a formula of its own
            assert figures["pace"] == pytest.approx(part / sine)
        else:
            assert figures["part"] == pytest.approx(part)
            assert math.sin(math.radians(figures["delta"])) == pytest.approx(sine)
        assert figures["value"] == pytest.approx(figures["omega"] * part / sine)


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
