"""The plane of the coupler is rotated to one side in all poses: nothing that is drawn jumps."""

from __future__ import annotations

import numpy as np
import pytest

import vad
from tests.kinds import SPACE
from tests.strokes.test_traced_sheet import numbers
from vad.mechanisms import Mechanism
from vad.strokes.diagram import VELOCITY
from vad.strokes.space.body_polygons import BodyScript
from vad.strokes.space.layout import over_its_range
from vad.strokes.traced_sheet import traced_sheet

MECHANISMS: dict[str, Mechanism] = {
    **{name: vad.MECHANISMS[name]() for name in SPACE},
    "crossed": vad.SphericalFourBar(assembly="crossed"),
    "double crank": vad.SphericalFourBar(ground=25, crank=80, coupler=60, rocker=75),
    "long rocker": vad.SphericalFourBar(ground=100, crank=30, coupler=90, rocker=110),
}
TURNING = ("crossed", "double crank", "long rocker", "spherical-four-bar", "hooke-joint")
STEPS = 720
#: A step is a jump if it is longer than so many times both of its neighbours, and than that share
#: of what is drawn in its panel.
TIMES, SHARE = 3.0, 0.01
#: Lines whose ends are chosen anew where others suit better: the line of Hooke's joint through T
#: has an end of each arm on it, and a link that lies partly behind another is cut there.
CHOSEN = {"PQ.line", "BC.coupler", "DC.rocker"}


def _jumps(way: np.ndarray, size: float) -> list[int]:
    """Return the steps of a closed way that its motion does not explain."""
    steps = np.abs(np.roll(way, -1) - way)
    about = np.fmax(np.roll(steps, 1), np.roll(steps, -1))
    found: list[int] = np.flatnonzero(steps > TIMES * about + SHARE * size).tolist()
    return found


@pytest.mark.parametrize("name", MECHANISMS)
def test_no_point_jumps_while_the_crank_goes_round(name: str) -> None:
    """The program of a page finds them; the film of a turn has the same sheets."""
    mechanism = MECHANISMS[name]
    place, *rates = mechanism.inputs
    given = {place: 60.0, **dict(zip(rates, (10.0, 30.0), strict=True))}
    traced = traced_sheet(mechanism, given)
    places = {key: z for key, z in numbers(traced.sheet) if key[-1] in ("x", "y")}
    turned = [np.arange(STEPS) * 360.0 / STEPS, *(np.full(STEPS, given[rate]) for rate in rates)]
    table = dict(zip(places, traced.program(places.values()).many(turned, STEPS), strict=True))
    sizes: dict[str, float] = {}
    for (panel, *_), values in table.items():
        sizes[panel] = max(sizes.get(panel, 0.0), float(np.nanmax(np.abs(values))))
    checked = 0
    for key, values in table.items():
        panel, stroke, field, *_ = key
        if stroke in CHOSEN or field == "direction" or not np.isfinite(values).all():
            continue
        assert _jumps(np.asarray(values), sizes[panel]) == [], key
        checked += 1
    assert checked > 0.8 * len(places)


@pytest.mark.parametrize("name", TURNING)
def test_the_triangles_lie_apart_in_most_poses(name: str) -> None:
    script = over_its_range(MECHANISMS[name], 90)
    assert isinstance(script, BodyScript)
    places = script.bodies.vertices(VELOCITY)
    line = (places["4"] - places["2"]).conjugate()
    one, three = ((line * (places[letter] - places["2"])).imag for letter in "13")
    apart, over = (int((sign * one * three < -1e-9).sum()) for sign in (1.0, -1.0))
    assert apart >= over
