"""What is true of every mechanism: no test names one, so that a new one is tested by itself."""

from __future__ import annotations

import dataclasses
import json
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

import vad
from tests.kinds import PLANE, SPACE
from tests.oracle import MECHANISMS as KNOWN_TO_THE_ORACLE
from tests.oracle import reference

pytestmark = pytest.mark.exhaustive

COINCIDENT = "Q"
"""The lever's point where the pin is now: a moment later another one has taken its place."""

everything = pytest.mark.parametrize("name", list(vad.MECHANISMS))
in_the_plane = pytest.mark.parametrize("name", PLANE)
drawn = settings(
    max_examples=8,
    deadline=None,
    suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow],
)
few = settings(drawn, max_examples=3)
factors = st.floats(0.8, 1.25)


def defaults(cls: Any) -> dict[str, float]:
    """Return the numbers that a mechanism has when nothing is said, optional ones left out."""
    fields = [f for f in dataclasses.fields(cls) if f.metadata["quantity"] in ("length", "angle")]
    values = {field.name: getattr(cls(), field.name) for field in fields}
    return {name: value for name, value in values.items() if value is not None}


def optional(cls: Any) -> dict[str, float]:
    """Return lengths for the parameters that may be left out, ample enough to assemble."""
    reach = sum(abs(x) for n, x in defaults(cls).items() if not n.endswith("angle"))
    fields = [f.name for f in dataclasses.fields(cls) if getattr(cls(), f.name) is None]
    return {name: reach * (2 if name == "rod" else 0.1) for name in fields}


@st.composite
def motions(draw: Any, name: str) -> tuple[Any, dict[str, float]]:
    """Draw a mechanism and an input that can be assembled."""
    cls = vad.MECHANISMS[name]
    numbers = {**defaults(cls), **(optional(cls) if draw(st.booleans()) else {})}
    parameters = {key: value * draw(factors) for key, value in numbers.items()}
    mechanism = cls(**parameters, assembly=draw(st.sampled_from(["open", "crossed"])))
    first, second, third = cls.inputs
    size = abs(cls.inputs[second]) or 1.0
    inputs = {
        first: draw(st.floats(-720, 720))
        if first == "angle"
        else cls.inputs[first] * draw(factors),
        second: size * draw(st.sampled_from([-1, 1])) * draw(st.floats(0.1, 10)),
        third: draw(st.sampled_from([0.0, 1.0, -1.0])) * size * draw(st.floats(0.1, 10)),
    }
    assume(well_away_from_a_dead_centre(mechanism, inputs))
    return mechanism, inputs


def well_away_from_a_dead_centre(mechanism: Any, inputs: dict[str, float]) -> bool:
    """Say whether the pose and its neighbourhood assemble, with moderate rates."""
    first = next(iter(inputs))
    around = inputs[first] + 0.02 * (57.3 if first == "angle" else inputs[first]) * np.arange(-2, 3)
    motion = vad.solve(mechanism, **{**inputs, first: around})
    if not motion.assembled.all():
        return False
    turns = [np.unwrap(np.radians(motion.link(name).angle)) for name in with_angles(motion)]
    return all(np.isfinite(turn).all() and abs(np.diff(turn, 2)).max() < 0.01 for turn in turns)


def with_angles(motion: Any) -> list[str]:
    """Return the links that turn about a fixed line."""
    return [name for name in motion.links if name not in motion.solver.bodies]


def check(name: str, test: Any) -> None:
    """Run a property over drawn motions of one mechanism, over few in space."""

    @(drawn if name in PLANE else few)
    @given(case=motions(name))
    def run(case: tuple[Any, dict[str, float]]) -> None:
        test(*case)

    run()


# --- rates are derivatives --------------------------------------------------------------------


def along_the_motion(inputs: dict[str, float], times: np.ndarray) -> dict[str, Any]:
    """Return the input at other times of the same motion."""
    first, second, third = inputs
    unit = 180 / math.pi if first == "angle" else 1.0
    path = inputs[second] * times + inputs[third] * times**2 / 2
    return {
        first: inputs[first] + unit * path,
        second: inputs[second] + inputs[third] * times,
        third: np.full(times.shape, inputs[third]),
    }


FIRST = np.array([1, -8, 0, 8, -1]) / 12
SECOND = np.array([-1, 16, -30, 16, -1]) / 12


@everything
def test_rates_are_derivatives_of_the_position(name: str) -> None:
    def test(mechanism: Any, inputs: dict[str, float]) -> None:
        first, second, third = inputs
        scale = 1.0 if first == "angle" else abs(inputs[first])
        speed = abs(inputs[second]) + math.sqrt(abs(inputs[third]) * scale)
        step = 1e-3 * scale / speed
        times = step * np.arange(-2, 3)
        path = vad.solve(mechanism, **along_the_motion(inputs, times))
        now = vad.solve(mechanism, **inputs)
        listed = now.to_dict()
        lengths = max(math.hypot(*p["position"]) for p in listed["points"].values())
        for kind, size in (("point", lengths), ("slide", lengths)):
            for item in listed[kind + "s"]:
                if item == COINCIDENT and name in PLANE:
                    continue
                places = getattr(path, kind)(item).position
                true = getattr(now, kind)(item)
                close(FIRST @ places / step, true.velocity, size * speed / scale)
                close(SECOND @ places / step**2, true.acceleration, size * (speed / scale) ** 2)
        for item in with_angles(now):
            turned = np.unwrap(np.radians(path.link(item).angle))
            true = now.link(item)
            close(FIRST @ turned / step, true.omega, speed / scale)
            close(SECOND @ turned / step**2, true.alpha, (speed / scale) ** 2)
        for body in now.solver.bodies:
            true = now.link(body)
            close(FIRST @ path.link(body).omega / step, true.alpha, (speed / scale) ** 2)

    check(name, test)


def close(measured: Any, true: Any, size: float) -> None:
    measured, true = np.atleast_1d(measured), np.atleast_1d(true)
    assert np.linalg.norm(measured - true) <= 1e-6 * (np.linalg.norm(true) + 30 * size)


@pytest.mark.parametrize("name", KNOWN_TO_THE_ORACLE)
def test_rates_agree_with_the_oracle(name: str) -> None:
    def test(mechanism: Any, inputs: dict[str, float]) -> None:
        numbers, assembly = mechanism.parameters(), mechanism.assembly
        motion = vad.solve(mechanism, **inputs)
        for (kind, item, attribute), quantity in reference(name, numbers, inputs, assembly).items():
            found = getattr(getattr(motion, kind)(item), attribute)
            if attribute != "angle":
                gap = abs(complex(found) - complex(quantity.value))
                assert gap <= 1e-13 * float(quantity.kappa())

    check(name, test)


# --- links are rigid --------------------------------------------------------------------------


def rigid_pairs(motion: vad.Motion, listed: dict[str, Any]) -> list[tuple[str, str, str]]:
    """Return (link, point, point) where the two points keep their place on the link."""
    return [
        (link, a, b)
        for link in listed["links"]
        for a in listed["points"]
        for b in listed["points"]
        if a != b and COINCIDENT not in (a, b) and lies_along(motion, link, a, b)
    ]


def lies_along(motion: vad.Motion, link: str, a: str, b: str) -> bool:
    """Say whether b − a keeps its length and its angle to the link over all poses of an array."""
    arm = motion.point(b).position - motion.point(a).position
    length = abs(arm)
    if not length.min() > 1e-9 * length.max() or np.ptp(length) > 1e-9 * length.max():
        return False
    relative = arm * np.exp(-1j * np.radians(motion.link(link).angle)) / length
    return bool(abs(relative - relative[0]).max() < 1e-8)


@in_the_plane
def test_points_of_a_link_move_with_it(name: str) -> None:
    def test(mechanism: Any, inputs: dict[str, float]) -> None:
        first = next(iter(inputs))
        spread = inputs[first] + 0.02 * (57.3 if first == "angle" else inputs[first]) * np.arange(
            -2, 3
        )
        sweep = vad.solve(mechanism, **{**inputs, first: spread})
        now = vad.solve(mechanism, **inputs)
        pairs = rigid_pairs(sweep, now.to_dict())
        assert {link for link, _, _ in pairs}, "no link carries two points"
        for link, a, b in pairs:
            turning, start, end = now.link(link), now.point(a), now.point(b)
            arm = end.position - start.position
            velocity = 1j * turning.omega * arm
            acceleration = (1j * turning.alpha - turning.omega**2) * arm
            size = abs(velocity) + abs(start.velocity) + abs(end.velocity)
            assert abs(end.velocity - start.velocity - velocity) <= 1e-11 * size
            size = abs(acceleration) + abs(start.acceleration) + abs(end.acceleration)
            assert abs(end.acceleration - start.acceleration - acceleration) <= 1e-11 * size

    check(name, test)


@everything
def test_reversing_the_input_reverses_velocities_alone(name: str) -> None:
    def test(mechanism: Any, inputs: dict[str, float]) -> None:
        _, second, _ = inputs
        forth = vad.solve(mechanism, **inputs).to_dict()
        back = vad.solve(mechanism, **{**inputs, second: -inputs[second]}).to_dict()
        for link, found in forth["links"].items():
            assert back["links"][link]["omega"] == (-np.array(found["omega"])).tolist()
            assert back["links"][link]["alpha"] == found["alpha"]
        for point, found in forth["points"].items():
            assert back["points"][point]["velocity"] == [-x for x in found["velocity"]]
            assert back["points"][point]["acceleration"] == found["acceleration"]

    check(name, test)


# --- what is written out ----------------------------------------------------------------------


@everything
def test_the_dictionary_survives_json(name: str) -> None:
    def test(mechanism: Any, inputs: dict[str, float]) -> None:
        motion = vad.solve(mechanism, **inputs)
        listed = motion.to_dict()
        assert json.loads(json.dumps(listed, allow_nan=False)) == listed
        assert list(listed) == [
            "mechanism",
            "parameters",
            "input",
            "assembly",
            "units",
            "links",
            *(["joints"] if name in SPACE else []),
            "points",
            "slides",
        ]
        assert listed["mechanism"] == name
        assert listed["input"] == inputs
        assert listed["assembly"] in (mechanism.assembly, None)
        for link, found in listed["links"].items():
            about_a_line = link in with_angles(motion)
            assert set(found) == {"omega", "alpha", *(["angle"] if about_a_line else [])}
            if about_a_line:
                assert found["angle"] == motion.link(link).angle
                assert 0 <= found["angle"] < 360
        for point, found in listed["points"].items():
            acceleration = motion.point(point).acceleration
            if name in PLANE:
                acceleration = [acceleration.real, acceleration.imag]
            assert found["acceleration"] == [*acceleration]
        for slide, found in listed["slides"].items():
            assert set(found) - {"coriolis"} == {"position", "velocity", "acceleration"}
            assert found["velocity"] == motion.slide(slide).velocity

    check(name, test)


@everything
def test_the_dictionary_makes_the_same_motion_again(name: str) -> None:
    def test(mechanism: Any, inputs: dict[str, float]) -> None:
        listed = json.loads(json.dumps(vad.solve(mechanism, **inputs).to_dict()))
        numbers = {key: value for key, value in listed["parameters"].items() if value is not None}
        if listed["assembly"]:
            numbers["assembly"] = listed["assembly"]
        again = vad.MECHANISMS[listed["mechanism"]](**numbers)
        assert vad.solve(again, **listed["input"]).to_dict() == listed

    check(name, test)


@everything
def test_the_table_names_all_links_and_units(name: str) -> None:
    motion = vad.solve(vad.MECHANISMS[name]())
    table, listed = motion.table(), motion.to_dict()
    for item in (*listed["links"], *listed["points"], *listed["slides"]):
        assert item in table
    units = {"omega": ("rad/s",), "alpha": ("rad/s²", "rad/s^2"), "angle": ("°", "deg")}
    length = listed["units"]["length"]
    units |= {"velocity": (f"{length}/s",), "acceleration": (f"{length}/s²", f"{length}/s^2")}
    for spellings in units.values():
        assert any(spelling in table for spelling in spellings)


@everything
def test_mechanisms_describe_themselves(name: str) -> None:
    cls = vad.MECHANISMS[name]
    assert cls.name == name
    assert cls.title
    assert len(cls.inputs) == 3
    for field in dataclasses.fields(cls):
        assert field.metadata["quantity"] in ("length", "angle", "choice", "unit", "points")
        assert field.metadata["help"]
    with pytest.raises(dataclasses.FrozenInstanceError):
        cls().length_unit = "in"
