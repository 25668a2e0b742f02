"""Turns: the course of the driver, and a sheet of `draw` for every frame."""

from __future__ import annotations

import math

import pytest

import vad
from vad.files.examples import example_path
from vad.kinematics import motion
from vad.kinematics.reach import closing_range


@pytest.mark.parametrize("name", sorted(vad.MECHANISMS))
def test_every_mechanism_turns_and_begins_where_it_is_given(name: str):
    mechanism = vad.MECHANISMS[name]()
    turn = vad.turn(mechanism, fps=10)
    assert (turn.frames, turn.duration) == (80, 8.0)
    place, rate, _ = mechanism.inputs
    for key in (place, rate):
        assert turn.course.inputs(0.0)[key] == pytest.approx(mechanism.inputs[key])
    given = vad.draw(vad.solve(mechanism, **turn.course.inputs(0.0)))
    assert turn.pose(0).panels == given.panels


def test_a_crank_goes_once_round_in_its_own_sense():
    turn = vad.turn(vad.solve(vad.FourBar(), angle=350.0, omega=-3.0), fps=9)
    angles = [turn.course.inputs(frame / turn.frames)["angle"] for frame in range(turn.frames)]
    assert angles[:3] == [350.0, 345.0, 340.0]
    assert len({round(angle, 9) for angle in angles}) == turn.frames == 72
    assert angles[-1] == 355.0  # the film begins again one step on


@pytest.mark.parametrize("mechanism", [vad.FourBar(crank=130), vad.DoubleSlider(guide_b=60)])
def test_what_cannot_go_round_swings_within_its_range(mechanism):
    turn = vad.turn(mechanism, fps=20)
    place, rate, second = mechanism.inputs
    unit = math.radians(1) if place == "angle" else 1.0
    inputs = [turn.course.inputs(frame / turn.frames) for frame in range(turn.frames)]
    low, high = min(i[place] for i in inputs), max(i[place] for i in inputs)
    assert any(a < low < high < b for a, b in closing_range(mechanism))
    # Rates are those of the swing itself, by differences.
    _, _, _, speed = turn.course.swing
    step = math.tau / turn.frames / speed
    for before, now, after in zip(inputs, inputs[1:], inputs[2:], strict=False):
        slope = (after[place] - before[place]) / (2 * step) * unit
        bend = (after[place] - 2 * now[place] + before[place]) / step**2 * unit
        biggest = abs(mechanism.inputs[rate]) * 4
        assert slope == pytest.approx(now[rate], abs=2e-3 * biggest)
        assert bend == pytest.approx(now[second], abs=2e-3 * biggest * speed)
    assert not any(c.given for r in turn.pose(3).rows for cells in r.cells.values() for c in cells)


@pytest.mark.parametrize("mechanism", [vad.GateActuator(), vad.FourBar(crank=130)])
def test_a_driver_that_swings_rests_at_the_ends(mechanism):
    """Rounding noise would be drawn as a polygon, at a scale of its own."""
    turn = vad.turn(mechanism)
    _, rate, second = mechanism.inputs
    for half, place in enumerate(turn.course.ends):
        end, middle = (turn.course.inputs(turn.opening + (half + k) / 2) for k in (0.0, 0.5))
        assert [end[rate], middle[second]] == [0.0, 0.0]
        assert math.copysign(1.0, end[rate]) == 1.0
        assert end[next(iter(end))] == pytest.approx(place)
        sheet = vad.draw(vad.solve(mechanism, **end))
        assert [stroke.name for stroke in sheet.panel("velocity").strokes] == ["pole"]
        assert len(sheet.panel("acceleration").strokes) > 5


@pytest.mark.parametrize("place", [30.0, 60.0, 328.183])
def test_a_driver_that_goes_round_stands_at_round_angles(place):
    """At 90.00000000000006° the rounding of what is zero would be drawn."""
    course = vad.turn(vad.solve(vad.HookeJoint(), angle=place)).course
    for step in range(72):
        angle = course.inputs(course.opening + step / 72)["angle"]
        assert angle == 5.0 * step


def test_a_place_outside_the_range_begins_at_its_end():
    turn = vad.turn(vad.solve(vad.FourBar(crank=130), angle=0.0), fps=2)
    assert turn.pose(0).panels


def test_a_frame_is_one_pose_solved_once(monkeypatch: pytest.MonkeyPatch):
    """Where a vector vanishes, too: at 90° the rod does not turn for an instant."""
    turn = vad.turn(vad.solve(vad.SliderCrank(), angle=90.0))
    solved = []

    def counting(mechanism, **inputs):
        solved.append(inputs)
        return solve(mechanism, **inputs)

    solve = motion.solve
    monkeypatch.setattr(motion, "solve", counting)
    assert turn.pose(0).panels == vad.draw(solve(vad.SliderCrank(), angle=90.0)).panels
    assert solved == [turn.course.inputs(0.0)]


def test_every_pose_has_the_same_strokes_drawn_or_not():
    turn = vad.turn(vad.solve(vad.SliderCrank(), angle=90.0))
    for panels in zip(*(turn.at(k / 8).panels for k in range(8)), strict=True):
        names = {frozenset(s.name for s in (*panel.strokes, *panel.zeros)) for panel in panels}
        assert len(names) == 1
    assert len({len(turn.at(k / 8).panels[2].strokes) for k in range(8)}) > 1


@pytest.mark.parametrize(
    ("mechanism", "angle"),
    [
        (vad.FourBar(ground=100, crank=40, coupler=100, rocker=40), 180.0),  # it folds flat
        (vad.SliderCrank(crank=60, rod=60), 90.0),
        (vad.CrankSlottedLever(ground=50, crank=50), 270.0),  # the pin on the lever's pivot
    ],
)
def test_a_dead_centre_in_a_turn_is_passed_by_a_hair(mechanism, angle: float):
    turn = vad.turn(vad.solve(mechanism, angle=angle - 90.0))
    with pytest.raises(vad.DeadCentreError):
        vad.draw(vad.solve(mechanism, angle=angle))
    there, before = turn.at(0.25), turn.at(0.25 - 1 / 240)
    crank = there.rows[0].cells["position"][0]
    assert crank.value == pytest.approx(angle, abs=0.1)
    assert crank.value != angle
    for panel, other in zip(there.panels, before.panels, strict=True):
        names = [{s.name for s in (*p.strokes, *p.zeros)} for p in (panel, other)]
        assert names[0] == names[1]


@pytest.mark.parametrize("mechanism", [vad.FourBar(crank=130), vad.DoubleSlider(guide_b=60)])
def test_a_swing_keeps_away_from_its_dead_centres(mechanism):
    turn = vad.turn(mechanism)
    for frame in range(turn.frames):
        vad.draw(vad.solve(mechanism, **turn.course.inputs(frame / turn.frames)))


def test_a_swing_stays_on_its_side_of_a_change_point():
    """Where the legs of a scissor lift lie on each other, it could turn over."""
    lift = vad.load(example_path("scissor-lift"))
    for place, sign in ((1300.0, 1.0), (-1300.0, -1.0)):
        course = vad.turn(vad.solve(lift(), position=place)).course
        assert all(0.0 < sign * end < 1600.0 for end in course.ends)
        heights = [
            sign * vad.solve(lift(), **course.inputs(x / 8)).point("M").position.imag
            for x in range(8)
        ]
        assert min(heights) > 0.0


def test_a_link_that_is_only_moved_along_is_not_what_comes_out():
    film = vad.turn(vad.load(example_path("scissor-lift"))())
    assert film.cycle.output == "outer_leg"


def test_speed_panels_and_language():
    turn = vad.turn(vad.ScotchYoke(), speed=4, panels="velocity", language="de")
    assert turn.duration == 2.0
    assert [panel.name for panel in turn.sheet.panels] == ["velocity"]
    assert turn.sheet.language == "de"


@pytest.mark.parametrize(
    "wrong",
    [{"fps": 0}, {"speed": 0}, {"size": (10, 10)}, {"panels": "speed"}, {"language": "xx"}],
)
def test_values_out_of_range(wrong):
    with pytest.raises(vad.UsageError):
        vad.turn(vad.FourBar(), **wrong)


def test_many_poses_and_no_pose():
    with pytest.raises(vad.InputError, match="one pose"):
        vad.turn(vad.solve(vad.FourBar(), angle=[1.0, 2.0]))
    with pytest.raises(vad.AssemblyError, match="nowhere"):
        vad.turn(vad.FourBar(crank=500))


def test_a_crank_turns_from_0_to_360_degrees_and_the_cycle_closes():
    turn = vad.turn(vad.solve(vad.FourBar(), angle=90.0, omega=-3.0))
    cycle = turn.cycle
    assert (cycle.driver, cycle.output, turn.course.ends) == ("crank", "rocker", (360.0, 180.0))
    assert turn.share(0) == pytest.approx(0.75)  # of a turn the other way round
    assert turn.course.inputs(turn.course.opening)["angle"] == pytest.approx(0.0)
    for tracks in cycle.tracks.values():
        for way in tracks.values():
            assert way[-1] == pytest.approx(way[0], abs=1e-6)
    assert abs(cycle.curves["position"].values[1:] - cycle.curves["position"].values[:-1]).max() < 2


@pytest.mark.parametrize(
    "mechanism", [vad.Whitworth(rod=300), vad.GateActuator(), vad.SpatialFourBar()]
)
def test_the_points_of_a_pose_lie_on_the_ways_of_the_cycle(mechanism):
    turn = vad.turn(mechanism, fps=90)
    for frame in range(0, turn.frames, 45):
        sheet, place = turn.pose(frame), turn.share(frame) * 720
        if abs(place - round(place)) > 1e-6:
            continue
        for panel in sheet.halves:
            ways = turn.cycle.tracks[panel.name]
            arrows = [s.shape for s in panel.strokes if hasattr(s.shape, "head")]
            ends = {a.head: a.end for a in arrows} | {a.tail: a.start for a in arrows}
            size = max(abs(way).max() for way in ways.values())
            first = {spot.letter: way for spot, way in ways.items() if not spot.view}
            assert ends.keys() & first.keys()
            for letter in ends.keys() & first.keys():
                assert abs(first[letter][round(place)] - ends[letter]) < 1e-9 * size, letter


@pytest.mark.parametrize(
    ("mechanism", "output", "ratio"),
    [
        # sin of half the lever's swing is 50 : 120 and 40 : 90; by the textbook's formula.
        (vad.CrankSlottedLever(), "lever", 1.7528),
        (vad.Whitworth(rod=300), "ram", 1.8304),
        (vad.SliderCrank(), "slider", 1.0),
        (vad.SliderCrank(offset=30), "slider", None),
        (vad.ScotchYoke(), "yoke", 1.0),
        (vad.GateActuator(), "arm", 1.0),
        (vad.EllipticalTrammel(), "slider_b", 1.0),
    ],
)
def test_what_comes_out_and_its_quick_return(mechanism, output: str, ratio: float | None):
    cycle = vad.turn(mechanism).cycle
    if ratio is None:  # both dead centres: crank and rod in line, stretched and folded
        stretched, folded = math.asin(30 / 200), math.asin(30 / 80)
        ratio = (math.pi + folded - stretched) / (math.pi - folded + stretched)
    assert cycle.output == output
    assert cycle.ratio == pytest.approx(ratio, abs=1e-3)
    assert (cycle.back is None) == (ratio == 1.0)


def test_the_slope_of_the_position_is_the_velocity():
    """So it is for the eye, too: the curves share their axis."""
    turn = vad.turn(vad.SliderCrank())
    x, v = (turn.cycle.curves[name].values for name in ("position", "velocity"))
    step = math.tau / 720 / 10.0  # seconds from sample to sample at 10 rad/s
    slope = (x[2:] - x[:-2]) / (2 * step)
    assert slope == pytest.approx(v[1:-1], abs=0.2)


@pytest.mark.parametrize("shafts", [20.0, 30.0, 55.0])
def test_extremes_lie_between_samples_as_the_formulas_of_hookes_joint_have_them(shafts: float):
    curves = vad.turn(vad.HookeJoint(shaft_angle=shafts)).cycle.curves
    cosine, sine = math.cos(math.radians(shafts)), math.sin(math.radians(shafts))
    assert curves["velocity"].extremes == pytest.approx((10.0 * cosine, 10.0 / cosine), rel=1e-12)
    # α₄ is greatest where c = cos 2θ solves s²c² + (2 - s²)c - 2s² = 0, with s = sin β.
    square = sine**2
    root = math.sqrt((2.0 - square) ** 2 + 8.0 * square**2)
    twice = math.acos((root - (2.0 - square)) / (2.0 * square))
    below = 1.0 - square * (1.0 + math.cos(twice)) / 2.0
    most = 100.0 * cosine * square * math.sin(twice) / below**2
    assert curves["acceleration"].extremes == pytest.approx((-most, most), rel=1e-9)
    assert max(curves["acceleration"].values) < most


def test_the_least_speed_of_a_point_that_stops_is_nothing():
    curve = vad.turn(vad.load(example_path("beam-engine"))()).cycle.curves["velocity"]
    assert min(curve.values) > 1.0
    assert 0.0 <= curve.extremes[0] < 1e-4


@pytest.mark.parametrize("name", ["open", "crossed"])
def test_links_that_close_at_one_place_alone_do_not_turn(name: str) -> None:
    """The crank is as long as all other links together."""
    with pytest.raises(vad.AssemblyError) as caught:
        vad.turn(vad.FourBar(crank=300, assembly=name))
    assert str(caught.value) == "the links close for angle 0° alone, where nothing moves"
