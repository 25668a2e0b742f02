"""An output point of a turn: how it is found, when it stands, and what is drawn."""

from __future__ import annotations

import numpy as np
import pytest

import vad
from vad.errors import InputError, UsageError
from vad.files.examples import example_path
from vad.files.loading import load_text
from vad.strokes.shapes import Arrow


def jansen() -> type:
    return vad.load(example_path("jansen-leg"))


def test_a_leg_is_followed_by_its_foot_though_its_file_does_not_say_so():
    text = example_path("jansen-leg").read_text()
    silent = load_text(text.replace('output = "H"\n', "").encode(), "leg.toml")
    for leg in (jansen(), silent):
        found = vad.turn(leg()).followed
        assert found is not None
        assert (found.point, found.row) == ("H", "foot")
        assert found.stance is not None


@pytest.mark.parametrize("name", ["four-bar", "slider-crank", "whitworth"])
def test_mechanisms_without_a_foot_follow_no_point(name: str):
    assert vad.turn(vad.MECHANISMS[name]()).followed is None


def unnamed(name: str) -> str:
    """Return an example without the name of its output point."""
    lines = example_path(name).read_text().splitlines(keepends=True)
    return "".join(line for line in lines if not line.startswith("output ="))


def test_a_straight_line_is_no_foot_but_can_be_followed():
    hoeken = load_text(unnamed("hoeken").encode(), "hoeken.toml")()
    assert vad.turn(hoeken).followed is None
    found = vad.turn(hoeken, follow="P").followed
    assert found is not None
    assert found.row == "coupler"


def test_the_stance_is_where_the_foot_is_within_six_hundredths_of_its_lift():
    turn = vad.turn(jansen()())
    assert turn.followed is not None
    stance = turn.followed.stance
    assert stance is not None
    motion = vad.solve(turn.mechanism, angle=np.linspace(0, 360, 3601), omega=-6.0)
    height = motion.point("H").position.imag
    low = height < height.min() + 0.06 * np.ptp(height)
    assert stance.part == pytest.approx(low[:-1].mean(), abs=1e-3)
    assert stance.lift == pytest.approx(np.ptp(height), rel=1e-4)
    # At touch-down the foot comes down through that height, and at lift-off it goes up.
    curve = turn.cycle.curves["position"].values
    assert curve[0] == pytest.approx(0.06 * stance.lift, rel=1e-3)
    assert curve[1] < curve[0]
    assert np.interp(stance.part, turn.cycle.shares, curve) == pytest.approx(curve[0], rel=1e-3)


def test_the_curves_are_those_of_the_foot():
    cycle = vad.turn(jansen()()).cycle
    foot = vad.solve(jansen()(), angle=np.linspace(0, 360, 3601), omega=-6.0).point("H")
    found = {name: (each.symbol, each.values) for name, each in cycle.curves.items()}
    assert [symbol for symbol, _ in found.values()] == ["y_H", "v_Hₓ", "a_H"]
    assert found["velocity"][1].max() == pytest.approx(foot.velocity.real.max(), rel=1e-3)
    assert found["acceleration"][1].max() == pytest.approx(abs(foot.acceleration).max(), rel=1e-3)


def test_the_polygons_have_the_vector_of_the_point_alone():
    turn = vad.turn(jansen()())
    for frame in (0, 100):
        sheet = turn.pose(frame)
        angle = turn.course.inputs(frame / turn.frames)["angle"]
        foot = vad.solve(turn.mechanism, angle=angle, omega=-6.0).point("H")
        for name, value in (("velocity", foot.velocity), ("acceleration", foot.acceleration)):
            panel = sheet.panel(name)
            assert [stroke.kind for stroke in panel.strokes] == ["pole", "result"]
            shape = panel.strokes[1].shape
            assert isinstance(shape, Arrow)
            assert shape.end == pytest.approx(value)


def test_arrows_at_the_point_are_those_of_the_polygons_at_lengths_that_never_change():
    turn = vad.turn(jansen()())
    lengths: dict[str, list[complex]] = {"velocity": [], "acceleration": []}
    size = 0.0
    for frame in range(0, turn.frames, 5):
        sheet = turn.pose(frame)
        strokes = {stroke.name: stroke for stroke in sheet.panel("position").strokes}
        places = [s.shape.end for s in strokes.values() if isinstance(s.shape, Arrow)]
        size = max(size, *(abs(place) for place in places))
        for name, ratios in lengths.items():
            stroke, vector = strokes[f"H.{name}"], sheet.panel(name).strokes[1].shape
            arrow = stroke.shape
            assert isinstance(arrow, Arrow)
            assert isinstance(vector, Arrow)
            assert stroke.label == name[0]
            assert arrow.start == pytest.approx(strokes["H.found"].shape.at)
            ratios.append((arrow.end - arrow.start) / (vector.end - vector.start))
    for ratios in lengths.values():
        assert ratios == pytest.approx([ratios[0]] * len(ratios))
        assert ratios[0].imag == pytest.approx(0.0)
    longest = abs(turn.cycle.curves["acceleration"].values).max() * lengths["acceleration"][0].real
    assert 0.2 * size < longest < 0.5 * size


def test_without_the_polygon_of_a_rate_it_has_no_arrow():
    turn = vad.turn(jansen()(), panels=("position", "velocity"))
    names = {stroke.name for stroke in turn.pose(100).panel("position").strokes}
    assert "H.velocity" in names
    assert "H.acceleration" not in names


def test_all_points_are_shown_on_demand():
    turn = vad.turn(jansen()(), follow="all")
    assert turn.followed is None
    assert len(turn.pose(0).panel("velocity").strokes) > 10


def test_a_point_that_cannot_be_followed_is_refused():
    with pytest.raises(UsageError, match="unknown follow"):
        vad.turn(jansen()(), follow="Z")
    with pytest.raises(UsageError, match="follow: A stands still"):
        vad.turn(jansen()(), follow="A")
    with pytest.raises(UsageError, match="no panel shows a point"):
        vad.turn(vad.FourBar(), follow="C", panels="turned")


def test_a_file_can_name_a_point_that_it_has():
    text = f'output = "P"\n{unnamed("hoeken")}'
    found = vad.turn(load_text(text.encode(), "hoeken.toml")()).followed
    assert found is not None
    assert found.point == "P"
    with pytest.raises(InputError, match=r"hoeken.toml, line \d+: output: unknown point 'Z'"):
        load_text(text.replace('output = "P"', 'output = "Z"').encode(), "hoeken.toml")
