"""Faults that are planted in the solver are noticed by the sums on the bodies, or by the power."""

from __future__ import annotations

import pytest

import vad
from tests.statics.machines import EPSILON, MACHINES, Sums, burden
from tests.statics.test_equilibrium import pose
from vad.statics import equilibrium
from vad.statics.equilibrium import Equilibrium
from vad.statics.forces import Forces
from vad.statics.solver import ForceEvaluation

#: One dyad, two dyads, a cylinder and a lever.
NAMES = ["four-bar", "watt-1.toml", "excavator-bucket.toml", "slotted lever with ram"]


def noticed(name):
    """Tell whether equilibrium or power fails by more than their bounds."""
    machine = MACHINES[name]()
    forces = vad.forces(pose(machine, 0.3), **burden(machine, 1))
    total, sizes = forces.power
    return Sums(forces).worst > 4.0 or abs(total) > 1e4 * EPSILON * sizes


@pytest.mark.parametrize("name", NAMES)
def test_nothing_is_noticed_without_a_fault(name):
    assert not noticed(name)


def with_spin_reversed(monkeypatch):
    """I·α with the wrong sign acts, but its work is done with the right one."""
    right = ForceEvaluation.acting

    def wrong(self, number):
        value = right(self, number)
        return -value if self.solver.acting[int(number)].kind == "spin" else value

    def balance(self, evaluation):
        monkeypatch.setattr(ForceEvaluation, "acting", wrong)
        begin(self, evaluation)
        monkeypatch.setattr(ForceEvaluation, "acting", right)

    begin = Equilibrium.__init__
    monkeypatch.setattr(Equilibrium, "__init__", balance)


def with_reactions_exchanged(monkeypatch):
    """F₃₄ stands for F₄₃."""
    right = Forces._pair
    monkeypatch.setattr(Forces, "_pair", lambda self, number: right(self, number)[::-1])


def with_moments_about_another_joint(monkeypatch):
    """Arms are counted from the joint beyond."""
    right = Equilibrium.arm

    def wrong(self, body, point):
        paths = self.tree.bodies[body].paths
        arm = right(self, body, point)
        other = next((right(self, body, each) for each in paths if each != point), None)
        return other if arm is None else arm if other is None else arm - other

    monkeypatch.setattr(Equilibrium, "arm", wrong)


def with_the_first_dyad_first(monkeypatch):
    """The dyads come in the order of the rates."""
    monkeypatch.setattr(equilibrium, "reversed", lambda items: items, raising=False)


def with_the_dyad_reversed(monkeypatch):
    """λ acts the other way round."""
    right = Equilibrium.crossing
    monkeypatch.setattr(Equilibrium, "crossing", lambda self, *lines: -right(self, *lines))


@pytest.mark.parametrize(
    "plant",
    [
        with_spin_reversed,
        with_reactions_exchanged,
        with_moments_about_another_joint,
        with_the_first_dyad_first,
        with_the_dyad_reversed,
    ],
)
def test_a_fault_is_noticed(plant, monkeypatch):
    plant(monkeypatch)
    assert any(noticed(name) for name in NAMES)
