"""Three forces on a member meet in a point, which the mechanism shows and the polygon uses."""

from __future__ import annotations

import pytest

import vad
from tests.statics.machines import MACHINES
from vad.strokes.sheet import Arrow, Dot, Line


def four_bar(angle=120.0):
    machine = vad.FourBar(
        ground=500, crank=400, coupler=1000, rocker=750, points={"E": ("rocker", 350)}
    )
    return vad.forces(vad.solve(machine, angle=angle), ["F = 80 N @ 150 at E"])


def shaper():
    return vad.forces(vad.solve(MACHINES["slotted lever with ram"](), angle=155), ["1 kN @ 0 at E"])


def engine():
    machine = vad.SliderCrank(points={"G": ("rod", 60, 20)})
    return vad.forces(vad.solve(machine), ["500 N @ 200 at G"])


def excavator():
    return vad.forces(vad.solve(MACHINES["excavator-bucket.toml"]()), ["5 kN @ 200 at T"])


CASES = [
    (four_bar, "dyad1", "O", "D", "C", "E"),
    (shaper, "dyad1", "O", "D", "B", "C"),
    (engine, "dyad1", "O", "B", "C", "G"),
    (excavator, "dyad2", "S", "A", "C", "T"),
]


def cross(one, other):
    return (one.conjugate() * other).imag


@pytest.mark.parametrize(("make", "of", "letter", "pin", "joint", "loaded"), CASES)
def test_the_three_lines_meet(make, of, letter, pin, joint, loaded):
    found = make()
    sheet = vad.draw(found)
    strokes = {stroke.name: stroke for stroke in sheet.panel("position").strokes}
    meeting = strokes[f"{of}.meeting"]
    assert isinstance(meeting.shape, Dot) and meeting.label == letter
    at = meeting.shape.at
    for which, point in (("load line", loaded), ("known line", joint), ("line", pin)):
        line = strokes[f"{of}.{which}"].shape
        assert isinstance(line, Line)
        assert line.through == found.motion.point(point).position and line.until == at
        assert abs(abs(line.direction) - 1.0) < 1e-12
    # What the solver finds without this point acts along the line to it.
    (held,) = [
        half.outer
        for dyad in found.dyads
        for half in (dyad.first, dyad.second)
        if f"dyad{dyad.number + 1}" == of and half.outer.point == pin
    ]
    arm = at - found.motion.point(pin).position
    assert abs(cross(arm, held.force)) < 1e-12 * abs(arm) * abs(held.force)


@pytest.mark.parametrize(("make", "of", "letter", "pin", "joint", "loaded"), CASES)
def test_the_polygon_is_a_triangle(make, of, letter, pin, joint, loaded):
    panel = vad.draw(make()).panel("force")
    number = int(of[-1]) - 1
    begins = [*panel.loops, len(panel.strokes)]
    order = [dyad.number for dyad in make().dyads]
    place = order.index(number)
    own = panel.strokes[begins[place] : begins[place + 1]]
    arrows = [stroke for stroke in own if isinstance(stroke.shape, Arrow)]
    lines = [stroke.label for stroke in own if isinstance(stroke.shape, Line)]
    assert len(arrows) == 3
    assert f"∥ {pin}{letter}" in lines
    total = sum(abs(stroke.shape.end - stroke.shape.start) for stroke in arrows)
    ends = [end for stroke in arrows for end in (stroke.shape.start, stroke.shape.end)]
    for end in ends:
        assert sum(abs(end - other) < 1e-12 * total for other in ends) == 2


def test_where_the_lines_meet_far_away_moments_are_taken():
    machine = vad.FourBar(
        ground=500, crank=400, coupler=1000, rocker=750, points={"E": ("rocker", 350)}
    )
    motion = vad.solve(machine, angle=120)
    along = motion.link("coupler").angle + 0.3
    sheet = vad.draw(vad.forces(motion, [f"80 N @ {along} at E"]))
    assert "F14D.tangential" in [stroke.name for stroke in sheet.panel("force").strokes]
    assert "dyad1.meeting" in [stroke.name for stroke in sheet.panel("position").zeros]


def test_names_are_those_of_every_pose():
    names = []
    for angle in (120.0, 200.0, 290.0):
        sheet = vad.draw(four_bar(angle))
        names.append([sorted(s.name for s in (*p.strokes, *p.zeros)) for p in sheet.panels])
    assert names[0] == names[1] == names[2]


def test_captions_name_the_lines_and_the_point():
    said = [stroke.caption for stroke in vad.draw(four_bar()).panel("position").strokes[-5:]]
    assert said == [
        "F = 80 N, the load on the rocker at E.",
        "The line of action of F.",
        "The line of action of F₂₃.",
        "Three forces in equilibrium meet in a point: on the rocker F and F₃₄ meet in O.",
        "F₁₄ passes through D and O, too.",
    ]
