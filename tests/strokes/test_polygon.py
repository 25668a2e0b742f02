"""What a polygon draws beside its loops: the velocity and the acceleration of the output point."""

from __future__ import annotations

import pytest

import vad
from vad.files.examples import example_path
from vad.strokes.sheet import Arrow


@pytest.mark.parametrize("panel", ["velocity", "acceleration"])
def test_the_vector_of_the_output_point_is_inked_where_two_moving_bars_find_it(panel):
    """P of Peaucellier's inversor runs along a straight line, square to the frame."""
    motion = vad.solve(vad.load(example_path("peaucellier"))())
    found = getattr(motion.point("P"), panel)
    vector = next(s for s in vad.draw(motion).panel(panel).strokes if s.name == "P.absolute")
    assert isinstance(vector.shape, Arrow)
    assert vector.shape.start == 0j
    assert vector.shape.end == pytest.approx(found)
    assert abs(vector.shape.end.real) < 1e-9 * abs(found)
    assert vector.label == {"velocity": "op", "acceleration": "o′p′"}[panel]
    assert f"the {panel} of P" in vector.caption


def test_the_vector_of_an_output_point_is_inked_once():
    sheet = vad.draw(vad.solve(vad.load(example_path("chebyshev"))()))
    heads = [getattr(s.shape, "head", "") for s in sheet.panel("velocity").strokes]
    assert heads.count("p") == 1
