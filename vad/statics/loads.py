"""Loads, masses, gravity and friction as a user gives them, checked against the bodies."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from vad import gate
from vad.errors import InputError, UsageError, quoted, unknown
from vad.kinematics.bodies import Bodies
from vad.kinematics.linkage import points_of
from vad.kinematics.motion import checked
from vad.kinematics.numbers import Number, traced
from vad.statics.burden import load_of
from vad.statics.solver import Acting
from vad.statics.tables import at_table, checked_table, unit_of
from vad.units import metres_of, number_of

_LOAD = ("name", "at", "on", "force", "angle", "couple", "table", "unit")
_SIZES = ("force", "couple", "table")
_MASS = ("mass", "at", "inertia", "radius")
_AS_LOAD = 'as in {"at": "E", "on": "rocker", "force": 80, "angle": 150}'
_AS_MASS = 'as in {"coupler": {"mass": 2, "at": "G", "inertia": 0.01}}'


class Given:
    """What acts on the bodies, with its numbers.

    Attributes
    ----------
    acting
        What acts, in the order in which it was given: loads, then for each mass its weight, its
        inertia force and its couple.
    rough
        The slides with friction.
    numbers
        The numbers by the names of inputs: floats, or arrays.

    Raises
    ------
    vad.errors.InputError
        For what acts nowhere, or is no number.
    """

    def __init__(
        self,
        bodies: Bodies,
        links: Mapping[str, str],
        slides: Mapping[str, str],
        unit: str,
        place: Number,
    ) -> None:
        self.bodies = bodies
        self.acting: list[Acting] = []
        self.rough: list[str] = []
        self.numbers: dict[str, Number] = {}
        self._first = {name: points_of(ends) for name, ends in links.items()}
        self._slides = {bodies.rods.get(name, name): point for name, point in slides.items()}
        self._unit = unit
        self._place = place
        self._order = {name: number for number, name in enumerate(bodies.bodies)}

    def loads(self, loads: Iterable[Any]) -> None:
        """Add loads: forces at points, and couples."""
        for number, load in enumerate(loads):
            what = f"load {number + 1}"
            self._load(what, load_of(load, what) if isinstance(load, str) else load)

    def _load(self, what: str, load: Any) -> None:
        what = _known(what, load, _LOAD, _AS_LOAD)
        sizes = [word for word in _SIZES if word in load]
        if len(sizes) != 1:
            raise InputError(f"{what}: must have a force or a couple", _AS_LOAD)
        size = sizes[0]
        kind = size if size != "table" else "force" if "at" in load else "couple"
        name = gate.line(what, load.get("name", ""))
        if "unit" in load and size != "table":
            raise InputError(f"{what}: unit: is that of a table", f"as in '{size}': '2 kN'")
        if size == "table":
            number = self._over_place(what, load, kind)
        else:
            number = self._number(f"{what}: {kind}", load[kind], kind)
        if kind == "couple":
            for word in ("at", "angle"):
                if word in load:
                    raise InputError(f"{what}: a couple has no '{word}'", 'as in "on": "rocker"')
            self._add("couple", self._turning(what, load.get("on")), "", name, couple=number)
            return
        body, point = self._site(what, load.get("at"), load.get("on"))
        angle = self._number(f"{what}: angle", load.get("angle", 0.0), "direction")
        self._add("force", body, point, name, force=number, angle=angle)

    def _over_place(self, what: str, load: Mapping[str, Any], kind: str) -> Number:
        """Return the load of a table at the place of the driver."""
        columns = load["table"]
        if not isinstance(columns, list | tuple | np.ndarray) or len(columns) != 2:
            hint = "as in 'table': ([0, 180, 360], [0, 800, 0])"
            raise InputError(
                f"{what}: table: must be places and loads, got {quoted(columns)}", hint
            )
        table = checked_table(f"{what}: table", *columns)
        factor = unit_of(f"{what}: unit", load["unit"], kind) if "unit" in load else 1.0
        turns = self.bodies.linkage.driver.kind == "angle"
        try:
            return at_table(table, self._place, 360.0 if turns else None) * factor
        except InputError as error:
            raise InputError(f"{what}: {error}", error.hint) from None

    def masses(self, masses: Mapping[str, Any], gravity: tuple[Number, Number] | None) -> None:
        """Add masses by the names of their bodies, with their weights if there is gravity."""
        metres = metres_of(self._unit)
        for body, mass in masses.items():
            what = f"mass of {body}"
            self._check_body("masses", body)
            if metres is None:
                raise InputError(
                    f"{what}: its inertia needs metres, and {self._unit} is no unit of length",
                    'as in length_unit="mm"',
                )
            given = mass if isinstance(mass, Mapping) else {"mass": mass}
            _known(what, given, _MASS, _AS_MASS)
            self._mass(what, body, given, gravity, metres)

    def _mass(
        self,
        what: str,
        body: str,
        given: Mapping[str, Any],
        gravity: tuple[Number, Number] | None,
        metres: float,
    ) -> None:
        at = given.get("at")
        _, point = self._site(what, self._usual(body) if at is None else at, body)
        own = self.bodies.bodies[body]
        if not own.has_fixed(point):
            fixed = [each for each in own.paths if own.has_fixed(each)]
            message = f"{what}: {point} moves along {body}, so that no mass stays there"
            raise InputError(message, f"points of {body}: {', '.join(fixed)}")
        mass = self._number(what, given.get("mass", 0.0), "mass", least=0.0)
        inertia = self._number(f"{what}: inertia", given.get("inertia", 0.0), "inertia", least=0.0)
        if "radius" in given:
            if "inertia" in given:
                raise InputError(f"{what}: has an inertia and a radius of gyration", "one of them")
            radius = self._number(f"{what}: radius", given["radius"], "length", least=0.0)
            inertia = mass * (radius * metres) ** 2
        if not own.link and ("inertia" in given or "radius" in given):
            raise InputError(f"{what}: {body} does not turn, so it has no moment of inertia")
        if gravity:
            x, y = gravity
            self._add("weight", body, point, body, mass=mass, gx=x, gy=y)
        self._add("inertia", body, point, body, mass=mass)
        if "inertia" in given or "radius" in given:
            self._add("spin", body, "", body, inertia=inertia)

    def friction(self, friction: Mapping[str, Any]) -> None:
        """Add coefficients of friction by the names of slides."""
        joints = [joint for joint in self.bodies.joints if joint.slide]
        blocks = {joint.other: joint.slide for joint in joints}
        blocks |= {joint.slide.name: joint.slide for joint in joints if joint.slide}
        for body, value in friction.items():
            slide = blocks.get(body) if isinstance(body, str) else None
            if slide is None:
                wrong = unknown("slide", body, blocks)
                raise UsageError(f"friction: {wrong}", wrong.hint)
            if slide.name in self.rough:
                raise InputError(f"friction: {body} is given twice", "one name of it is enough")
            number = self._number(f"friction of {body}", value, "friction", least=0.0)
            self.numbers[f"mu{len(self.rough)}"] = number
            self.rough.append(slide.name)

    def _add(self, kind: str, body: str, point: str, name: str, **numbers: Number) -> None:
        """Add what acts; each of its numbers becomes an input of its own name."""
        inputs = []
        for quantity, number in numbers.items():
            own = f"{quantity}{len(self.acting)}"
            if quantity in ("gx", "gy"):
                own = quantity
            elif quantity == "mass":  # of the weight and of the inertia force
                own = f"mass_{self._order[body]}"
            self.numbers[own] = number
            inputs.append(own)
        self.acting.append(Acting(kind, body, point, tuple(inputs), name))

    def _site(self, what: str, at: object, on: object) -> tuple[str, str]:
        """Return the body and the point at which something acts."""
        known = self.bodies.at
        if not isinstance(at, str) or at not in known:
            if at is None:
                hint = f"as in 'at': '{next(iter(known), 'E')}'; points: {', '.join(known)}"
                raise InputError(f"{what}: has no point at which it acts", hint)
            wrong = unknown("point", at, known)
            raise UsageError(f"{what}: {wrong}", wrong.hint)
        bodies = known[at]
        if on is not None:
            body = self._check_body(what, on)
            if body not in bodies:
                hint = f"{at} is on {' and '.join(bodies)}"
                raise InputError(f"{what}: {at} is no point of {body}", hint)
            return body, at
        sliding = [body for body in bodies if self._slides.get(body) == at]
        if len(sliding) == 1:
            return sliding[0], at
        if len(bodies) > 1:
            raise InputError(
                f"{what}: {at} is a point of {' and of '.join(bodies)}",
                f"say on which it acts: on {bodies[0]}",
            )
        return bodies[0], at

    def _check_body(self, what: str, body: object) -> str:
        known = self.bodies.bodies
        if not isinstance(body, str) or body not in known:
            wrong = unknown("body", body, known)
            raise UsageError(f"{what}: {wrong}", wrong.hint)
        return body

    def _turning(self, what: str, on: object) -> str:
        """Return a body that takes a couple."""
        turning = [name for name, body in self.bodies.bodies.items() if body.link]
        if on is None:
            raise InputError(f"{what}: a couple needs a body", f"on {' or '.join(turning)}")
        body = self._check_body(what, on)
        if body not in turning:
            guide = f"{what}: {body} does not turn: its guide takes the couple"
            raise InputError(guide, f"a couple acts on {' or '.join(turning)}")
        return body

    def _usual(self, body: str) -> str:
        """Return the point of a mass that is given without one."""
        if body in self._slides:
            return self._slides[body]
        points = self.bodies.bodies[body].paths
        return next((p for p in self._first.get(body, ()) if p in points), next(iter(points)))

    def _number(self, what: str, value: Any, quantity: str, least: float | None = None) -> Number:
        number = _read(what, value, quantity, self._unit)
        if least is not None and not traced([number]) and np.any(number < least):
            hint = f"try {-value:g}" if isinstance(value, float | int) else None
            raise InputError(f"{what}: must not be negative, got {quoted(value)}", hint)
        return number


def _read(what: str, value: Any, quantity: str, unit: str = "mm") -> Number:
    """Return a number, one that is written with a unit, or an array of numbers."""
    if isinstance(value, str):
        return number_of(what, value, quantity, unit)
    return value if traced([value]) else checked(what, value, gate.LARGEST_LOAD)


def listed_loads(loads: Any) -> tuple[Any, ...]:
    """Return loads that are given as a list, or one by one, as a tuple.

    Raises
    ------
    vad.errors.InputError
        For what is no list.
    """
    if isinstance(loads, Mapping | str | bytes) or not isinstance(loads, Iterable):
        raise InputError(f"loads: must be a list of loads, got {quoted(loads)}", _AS_LOAD)
    return tuple(gate.several("loads", loads, "a list of loads"))


def gravity_of(gravity: Any) -> tuple[Number, Number] | None:
    """Return gravity as x and y in m/s²; one number acts along -y.

    Raises
    ------
    vad.errors.InputError
        For what is neither one number nor two.
    """
    if gravity is None:
        return None
    if not isinstance(gravity, list | tuple):
        return 0.0, -_read("gravity", gravity, "gravity")
    if len(gravity) != 2:
        hint = "as in 9.81, or (0, -9.81)"
        raise InputError(f"gravity: must be one number or two, got {quoted(gravity)}", hint)
    x, y = (_read("gravity", each, "gravity") for each in gravity)
    return x, y


def _known(what: str, given: Any, words: Sequence[str], hint: str) -> str:
    """Check that something is a mapping with known words; return how errors call it."""
    if not isinstance(given, Mapping):
        raise InputError(f"{what}: must be named numbers, got {quoted(given)}", hint)
    name = given.get("name")
    called = name if isinstance(name, str) and name else what
    for word in given:
        if word not in words:
            wrong = unknown("word", word, words)
            raise UsageError(f"{called}: {wrong}", wrong.hint)
    return called
