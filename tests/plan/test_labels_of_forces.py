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

#: Random loads on each mechanism: usually, and where all cases run.
FEW, MANY = 1, 20


@pytest.mark.exhaustive(9)
@pytest.mark.parametrize("name", sorted(MACHINES))
def test_one_load_anywhere(name):
    machine = MACHINES[name]()
    places = [
        (at, on) for at, owners in bodies_of(solver_of(machine).plane).at.items() for on in owners
    ]
    for seed in range(FEW if settings.default.derandomize else MANY):
        random = np.random.default_rng(seed)
        at, on = places[random.integers(len(places))]
        load = {
            "name": "P",
            "at": at,
            "on": on,
            "force": float(10.0 ** random.uniform(0.0, 3.0)),
            "angle": float(random.uniform(0.0, 360.0)),
        }
        share = float(random.uniform(0.05, 0.95))
        try:
            sheet = vad.draw(vad.forces(pose(machine, share, slow=0.0), [load]))
        except VadError:  # at a dead centre
            continue
        assert overlaps(sheet) == [], (share, load)
