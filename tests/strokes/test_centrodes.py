"""The centrodes of a drawing: both curves touch in the centre, and each stays on its body."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

import vad
from tests.statics.machines import MACHINES
from tests.statics.test_equilibrium import pose
from vad.errors import InputError, UsageError
from vad.kinematics.kennedy import kennedy_of
from vad.plan.geometry import Rect
from vad.plan.hodographs import Hodographs
from vad.plan.scale import Scale
from vad.strokes.centrodes import Centrodes, centrode_of, pair_of
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.draw import scene_of
from vad.words import Language

#: A frame that nothing leaves.
ALL = (-1e12 - 1e12j, 1e12 + 1e12j)


def pieces(curve):
    stops = (0, *curve.breaks, len(curve.points))
    return [curve.points[start:end] for start, end in pairwise(stops)]


def away(place, curve):
    """Return how far a place is from a curve."""
    found = [np.inf]
    for piece in map(np.array, pieces(curve)):
        steps = np.diff(piece)
        along = ((place - piece[:-1]) * np.conj(steps)).real / np.maximum(abs(steps) ** 2, 1e-30)
        nearest = piece[:-1] + np.clip(along, 0.0, 1.0) * steps
        found.append(abs(nearest - place).min())
    return min(found)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", sorted(MACHINES))
def test_both_curves_pass_the_centre(name):
    motion = pose(MACHINES[name](), 0.31)
    body = centrode_of(motion, None, ("centres",))
    if body is None:
        pytest.skip("every body turns about a pin")
    pair = pair_of(motion, body)
    centre = vad.centres(motion).at(*pair)
    drawn = Centrodes(motion, pair)
    low, high = drawn.extent
    size = abs(high - low)
    for curve in drawn.curves(low - 9 * size * (1 + 1j), high + 9 * size * (1 + 1j)):
        if abs(centre - low) < 5 * size:
            assert away(centre, curve) < 2e-3 * size


@pytest.mark.parametrize("name", ["four-bar", "slider-crank", "watt-1.toml"])
def test_the_moving_curve_keeps_its_form_and_the_fixed_one_its_place(name):
    machine = MACHINES[name]()
    motions = [vad.solve(machine, angle=angle) for angle in (20.0, 75.0)]
    body = centrode_of(motions[0], None, ("centres",))
    pair = pair_of(motions[0], body)
    both = [Centrodes(motion, pair).curves(*ALL) for motion in motions]
    fixed, moving = ([np.array(each[k].points) for each in both] for k in (0, 1))
    size = motions[0].plane.scale
    seen = abs(moving[0]) < 20 * size
    assert fixed[0] == pytest.approx(fixed[1], rel=1e-9)
    turned = np.radians(motions[1].link(body).angle - motions[0].link(body).angle)
    rolled = moving[1] - moving[0] * np.exp(1j * turned)
    assert np.ptp(rolled[seen].real) < 1e-9 * size
    assert np.ptp(rolled[seen].imag) < 1e-9 * size


def test_the_circles_of_cardano():
    motion = vad.solve(vad.EllipticalTrammel(link=200), angle=130)
    fixed, moving = Centrodes(motion, ("link", "frame")).curves(*ALL)
    middle = (motion.point("A").position + motion.point("B").position) / 2
    assert abs(np.array(fixed.points)) == pytest.approx(200.0)
    assert abs(np.array(moving.points) - middle) == pytest.approx(100.0)


def test_a_curve_through_infinity_is_cut():
    motion = vad.solve(vad.SliderCrank(), angle=50)
    drawn = Centrodes(motion, ("rod", "frame"))
    low, high = drawn.extent
    by = 2 * abs(high - low) * (1 + 1j)
    fixed, moving = drawn.curves(low - by, high + by)
    assert len(pieces(fixed)) == 3  # from 0° to 90°, to 270° and to 360°: there it is far away
    for curve in (fixed, moving):
        for piece in pieces(curve):
            places = np.array(piece)
            assert (places.real >= (low - by).real - 1e-6).all()
            assert (places.imag <= (high + by).imag + 1e-6).all()
            assert abs(np.diff(places)).max() < 0.5 * abs(high - low)


def test_a_panel_with_centrodes_shows_their_centre_alone():
    motion = vad.solve(vad.FourBar(), angle=150)
    panel = vad.draw(motion, "centres", centrode="coupler").panel("centres")
    names = [stroke.name for stroke in panel.strokes[panel.given :]]
    assert names == [
        *("pins.known", "I13.first", "I13.second", "I13.found", "I23.rate"),
        *("I13.fixed", "I13.moving"),
    ]
    fixed, moving = (panel.strokes[panel.number(f"I13.{each}")] for each in ("fixed", "moving"))
    assert fixed.link is None
    assert moving.link == "coupler"
    captions = [vad.draw(motion, "centres", code, centrode="coupler") for code in ("de", "fr")]
    said = [sheet.panel("centres").strokes[-1].caption for sheet in captions]
    assert "Gangpolbahn" in said[0]
    assert "roulante" in said[1]


def test_a_body_rolls_on_another_one():
    motion = vad.solve(vad.FourBar(), angle=150)
    panel = vad.draw(motion, "centres", centrode="rocker on crank").panel("centres")
    assert panel.strokes[panel.number("I24.fixed")].link == "crank"
    centre = vad.centres(motion).at("rocker", "crank")
    assert away(centre, panel.strokes[panel.number("I24.moving")].shape) < 0.1


def test_a_turn_numbers_the_fixed_curve():
    turn = vad.turn(vad.FourBar(), panels="centres", fps=4)
    assert turn.centrode == "coupler"
    spots = {spot.letter: spot for spot in turn.cycle.tracks["centres"]}
    assert spots["I₁₃"].path == "numbered"
    assert turn.cycle.curves["centres"].row == "coupler"
    tracks = turn.cycle.tracks["centres"]
    drawn = Hodographs(tracks, {}, Scale(0j, 1e-3), Rect(-9.0, -9.0, 9.0, 9.0)).drawn
    assert spots["I₁₃"] in drawn  # its positions are numbered
    relative = vad.turn(vad.FourBar(), panels="centres", fps=4, centrode="rocker on crank")
    assert {s.letter: s.path for s in relative.cycle.tracks["centres"]}["I₂₄"] == "none"
    assert vad.turn(vad.ScotchYoke(), panels="centres", fps=4).centrode is None


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("rocker", "rocker and frame have the pin D alone, and no curves"),
        ("coupler on ground", "unknown body 'ground'"),
        ("coupler on coupler", "coupler and coupler have no centre, and no curves"),
        ("the long coupler", "'the long coupler' is no body"),
        (3, "3 is no body"),
    ],
)
def test_what_is_refused(words, said):
    with pytest.raises(UsageError, match=said):
        vad.draw(vad.solve(vad.FourBar()), "centres", centrode=words)


def test_what_has_no_centrodes():
    with pytest.raises(UsageError, match="no panel shows centres"):
        vad.draw(vad.solve(vad.FourBar()), centrode="coupler")
    with pytest.raises(UsageError, match="slider and frame is always far away"):
        vad.turn(vad.SliderCrank(), panels="centres", centrode="slider")
    with pytest.raises((UsageError, InputError), match="centres"):
        vad.turn(vad.HookeJoint(), centrode="driven")
    kennedy = kennedy_of(vad.solve(vad.ScotchYoke()).plane)
    assert {"block", "yoke"} <= set(kennedy.names)


def test_a_centre_names_the_arrow_that_leads_to_it_where_it_is_far():
    """Over a turn its letter stands beside that arrow, so each pose draws a dot or the arrow."""
    turned = vad.solve(vad.FourBar(), angle=np.linspace(0, 350, 36))
    spots = DIAGRAMS["centres"].tracks(scene_of(turned, Language("en")))
    arrows = {spot.letter: spot.arrow for spot in spots if spot.arrow}
    assert arrows == {"I₁₃": "I13.found", "I₂₄": "I24.found"}
    for angle in (0.0, 60.0, 145.0, 250.0):
        panel = vad.draw(vad.solve(vad.FourBar(), angle=angle), "centres").panel("centres")
        shown = {stroke.name for stroke in panel.strokes}
        assert set(arrows.values()) <= shown
