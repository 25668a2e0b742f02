"""A turn with forces: the polygons about their poles, the torque and what the drive gives."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import vad
from vad.errors import InputError
from vad.files.examples import example_path
from vad.lecture.cycle import FLUCTUATION
from vad.strokes.diagram import Spot
from vad.strokes.sheet import Arrow

PHASES = [0.0, 0.13, 0.41, 0.77]


def four_bar(omega: float = 10.0) -> Any:
    machine = vad.FourBar(ground=500, crank=150, coupler=450, rocker=400)
    masses = {"coupler": {"mass": 20, "inertia": 0.1}, "rocker": 5}
    return vad.forces(vad.solve(machine, omega=omega), ["80 N @ 150 at C on rocker"], masses)


def engine() -> Any:
    gas = {"at": "C", "table": ([0, 90, 180, 270], [6000, 800, 300, 2000]), "angle": 180}
    return vad.forces(vad.solve(vad.SliderCrank(), omega=-100), [gas], {"slider": 0.5})


def watt() -> Any:
    kind = vad.load(example_path("watt-1"))
    return vad.forces(vad.solve(kind()), ["50 N @ 20 at G on link"], {"arm": 2})


MACHINES = {"four-bar": four_bar, "engine": engine, "watt": watt}


@pytest.fixture(scope="module", params=MACHINES)
def turn(request: pytest.FixtureRequest) -> Any:
    return vad.turn(MACHINES[request.param]())


@pytest.mark.parametrize("phase", PHASES)
def test_polygons_close_on_the_hodographs(turn: Any, phase: float):
    """The vertex at which a polygon closes is drawn where the forces of the solver say."""
    panel = turn.at(phase).panel("force")
    found = vad.forces(vad.solve(turn.mechanism, **turn.course.inputs(phase)), *turn.burden)
    ends = [s.shape.end for s in panel.strokes if isinstance(s.shape, Arrow)]
    size = max(map(abs, ends))
    for dyad in found.dyads:
        closes = turn.poles[dyad.number] - dyad.first.outer.force
        assert min(abs(closes - end) for end in ends) < 1e-12 * size


def test_every_track_passes_where_an_arrow_ends(turn: Any):
    """Heads of loads, too: they are laid one after the other from the pole."""
    cycle = turn.cycle
    for place in (0, cycle.shares.size // 3, cycle.shares.size // 2):
        panel = turn.at(turn.course.opening + cycle.shares[place]).panel("force")
        ends = [s.shape.end for s in panel.strokes if isinstance(s.shape, Arrow)]
        size = max(map(abs, ends))
        for way in cycle.tracks["force"].values():
            at = np.broadcast_to(way, cycle.shares.shape)[place]
            assert min(abs(at - end) for end in ends) < 1e-9 * size


def test_the_hodographs_are_the_forces_of_the_whole_turn(turn: Any):
    cycle = turn.cycle
    angles = np.array(
        [turn.course.inputs(turn.course.opening + share)["angle"] for share in cycle.shares]
    )
    rates = {name: turn.course.given[k] for k, name in enumerate(turn.course.names) if k}
    found = vad.forces(vad.solve(turn.mechanism, angle=angles, **rates), *turn.burden)
    for number, pole in turn.poles.items():
        way = cycle.tracks["force"][Spot(f"{number}:X", lettered=False, row=_row(cycle, number))]
        dyad = next(each for each in found.bodies.dyads if each.loop == number)
        joint = found.bodies.bodies[dyad.first.bodies[0]].joint
        force = next(
            each.force
            for made, each in zip(found.bodies.joints, found.joints, strict=True)
            if made == joint
        )
        assert np.abs(way - (pole - force)).max() < 1e-12 * np.abs(force).max()


def _row(cycle: Any, number: int) -> str | None:
    return next(s.row for s in cycle.tracks["force"] if s.letter == f"{number}:X")


def test_the_torque_over_a_turn_is_that_of_the_solver(turn: Any):
    work, torque = turn.cycle.work, turn.cycle.curves["drive"]
    angles = np.linspace(0.0, 360.0, 721)
    rates = {name: turn.course.given[k] for k, name in enumerate(turn.course.names) if k}
    found = vad.forces(vad.solve(turn.mechanism, angle=angles, **rates), *turn.burden)
    most = np.abs(found.drive).max()
    assert np.sort(torque.values) == pytest.approx(np.sort(found.drive), abs=1e-9 * most)
    assert work.mean == pytest.approx(found.mean_drive, abs=1e-9 * most)
    assert work.energy == pytest.approx(found.fluctuation, rel=1e-9)
    assert work.flywheel == pytest.approx(found.flywheel(FLUCTUATION, rates["omega"]), rel=1e-9)


def test_the_excess_energy_is_the_area_that_is_marked(turn: Any):
    """By the trapezoidal rule over time: between the two shares it is the energy."""
    cycle = turn.cycle
    work, torque = cycle.work, cycle.curves["drive"].values
    end = work.greatest + (work.greatest < work.least)
    shares = np.linspace(work.least, end, 4001)
    values = np.interp(shares % 1.0, cycle.shares, torque) - work.mean
    sense = np.sign(turn.course.given[1])
    area = sense * np.trapezoid(values, shares) * 2.0 * np.pi
    assert area == pytest.approx(work.energy, rel=2e-3)


def test_work_over_part_of_a_turn_is_the_change_of_kinetic_energy():
    """Without loads, the drive does nothing but move masses."""
    machine = vad.FourBar(
        ground=500, crank=150, coupler=450, rocker=400, points={"G": ("coupler", 200)}
    )
    angles = np.linspace(20.0, 200.0, 2001)
    motion = vad.solve(machine, angle=angles, omega=10.0)
    found = vad.forces(motion, masses={"coupler": {"mass": 3, "at": "G", "inertia": 0.05}})
    speed, spin = np.abs(motion.point("G").velocity) / 1000.0, motion.link("coupler").omega
    energy = 0.5 * 3 * speed**2 + 0.5 * 0.05 * spin**2
    weights = np.r_[1.0, np.tile([4.0, 2.0], 999), 4.0, 1.0] / 3.0  # of Simpson's rule
    work = float(weights @ found.drive) * np.radians(angles[1] - angles[0])
    assert work == pytest.approx(energy[-1] - energy[0], rel=1e-9)


def test_arrows_on_the_driven_body_grow_with_the_forces(turn: Any):
    """One length stands for one force in all poses, and the largest one fills its room."""
    scales, longest = [], 0.0
    crank = turn.at(0.0).panel("drive")
    for phase in np.linspace(0.0, 1.0, 24, endpoint=False):
        panel = turn.at(phase).panel("drive")
        found = vad.forces(vad.solve(turn.mechanism, **turn.course.inputs(phase)), *turn.burden)
        size = max(abs(j.force) for j in found.joints if "crank" in (j.one, j.other))
        arrows = [s.shape for s in panel.strokes if s.component == "action"]
        drawn = max(abs(a.end - a.start) for a in arrows if isinstance(a, Arrow))
        scales.append(drawn / size)
        longest = max(longest, drawn)
    assert scales == pytest.approx([scales[0]] * len(scales), rel=1e-9)
    body = next(s.shape for s in crank.strokes if s.link == "crank" and isinstance(s.shape, Arrow))
    assert 0.5 < longest / abs(body.end - body.start) < 0.8


def test_a_dyad_on_which_nothing_acts_leaves_no_track():
    shaper = vad.load(example_path("shaper"))
    film = vad.turn(vad.forces(vad.solve(shaper()), ["1 kN @ 0 at E"]))
    numbers = {spot.letter.partition(":")[0] for spot in film.cycle.tracks["force"]}
    assert len(numbers) == len(film.poles) - 1


def test_polygons_of_two_dyads_keep_apart():
    turn = vad.turn(watt())
    first, second = sorted(turn.poles.values(), key=lambda pole: pole.real)
    assert second.real > first.real
    boxes: dict[int, list[float]] = {number: [] for number in turn.poles}
    for spot, way in turn.cycle.tracks["force"].items():
        boxes[int(spot.letter.partition(":")[0])] += way.real.tolist()
    (_, high), (low, _) = sorted((min(box), max(box)) for box in boxes.values())
    assert high < low


def test_a_clockwise_turn_gives_the_same_energy():
    one, other = vad.turn(four_bar(10.0)).cycle.work, vad.turn(four_bar(-10.0)).cycle.work
    assert one.energy == pytest.approx(other.energy, rel=1e-9)
    assert one.flywheel == pytest.approx(other.flywheel, rel=1e-9)


def test_a_turn_of_a_motion_has_no_forces():
    film = vad.turn(vad.solve(vad.FourBar()))
    assert film.burden is None
    assert film.cycle.work is None


def test_a_turn_begins_with_one_pose_of_forces():
    load = {"at": "C", "force": np.array([1.0, 2.0]), "angle": 180}
    with pytest.raises(InputError, match="a turn begins with one pose"):
        vad.turn(vad.forces(vad.solve(vad.SliderCrank()), [load]))


def test_poses_side_by_side_have_the_loads_of_the_first():
    found = vad.multiples(vad.forces(vad.solve(vad.SliderCrank()), ["800 N @ 180 at C"]), (30, 60))
    for sheet, angle in zip(found.sheets, (30, 60), strict=True):
        torque = vad.forces(vad.solve(vad.SliderCrank(), angle=angle), ["800 N @ 180 at C"]).drive
        cells = [c for row in sheet.rows for c in row.cells["drive"]]
        assert [cell.value for cell in cells] == [torque]
