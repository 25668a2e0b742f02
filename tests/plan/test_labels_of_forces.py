"""No name of a force lies on a stroke, wherever a load acts and however it is directed."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import settings

import vad
from tests.plan.overlaps import overlaps
from tests.statics.machines import MACHINES
from tests.statics.test_equilibrium import pose
from vad.errors import VadError
from vad.kinematics.bodies import bodies_of
from vad.kinematics.solver import solver_of
from vad.plan.board import plan
from vad.plan.format import screen
from vad.strokes.sheet import Arrow

#: Random loads on each mechanism: usually, and where all cases run.
FEW, MANY = 1, 20


def seeds():
    return range(FEW if settings.default.derandomize else MANY)


def force(random, name, places):
    at, on = places[random.integers(len(places))]
    size, angle = 10.0 ** random.uniform(0.0, 3.0), random.uniform(0.0, 360.0)
    return {"name": name, "at": at, "on": on, "force": float(size), "angle": float(angle)}


def places_on(bodies):
    return [(at, on) for at, owners in bodies.at.items() for on in owners]


@pytest.mark.exhaustive(36)
@pytest.mark.parametrize("name", sorted(MACHINES))
def test_one_load_anywhere(name):
    machine = MACHINES[name]()
    places = places_on(bodies_of(solver_of(machine).plane))
    for seed in seeds():
        random = np.random.default_rng(seed)
        load, share = force(random, "P", places), float(random.uniform(0.05, 0.95))
        try:
            sheet = vad.draw(vad.forces(pose(machine, share, slow=0.0), [load]))
        except VadError:  # at a dead centre
            continue
        assert overlaps(sheet) == [], (share, load)


@pytest.mark.exhaustive(72)
@pytest.mark.parametrize("name", sorted(MACHINES))
def test_a_force_a_couple_and_a_mass_in_motion(name):
    """Four panels are narrow, and the mechanism bears two curved arrows."""
    machine = MACHINES[name]()
    bodies = bodies_of(solver_of(machine).plane)
    places, links = places_on(bodies), [key for key, body in bodies.bodies.items() if body.link]
    for seed in seeds():
        random = np.random.default_rng(seed)
        couple = {"name": "M", "on": links[random.integers(len(links))], "couple": -3.0}
        loads = [force(random, "P", places), couple]
        heavy = links[random.integers(len(links))]
        fixed = [at for at, on in places if on == heavy and bodies.bodies[heavy].has_fixed(at)]
        masses = {heavy: {"mass": 2.0, "at": fixed[-1], "inertia": 0.01}}
        share = float(random.uniform(0.05, 0.95))
        try:
            sheet = vad.draw(vad.forces(pose(machine, share), loads, masses))
        except VadError:  # at a dead centre
            continue
        assert overlaps(sheet) == [], (share, loads, masses)


def test_a_name_stands_on_the_side_of_its_own_arrow():
    """P and F₄₈ are nearly in balance and run side by side, the arrow of P on the left."""
    machine = MACHINES["beam-engine.toml"]()
    found = vad.forces(vad.solve(machine), ["1 kN @ 270 at P on parallel_bar"])
    sketch = plan(vad.draw(found), screen((1280, 720)), 0.04).sketches["force"]
    panel = sketch.setting.panel
    load = panel.strokes[panel.find("P7P.load")].shape
    assert isinstance(load, Arrow)
    names = {tag.text: tag.box.centre.real for tag in sketch.tags}
    assert names["P"] < sketch.scale(load.start).real < names["F₄₈"]
