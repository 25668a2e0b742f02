"""Shafts and engines as mechanisms, and the verbs `balance` and `engine`.

A shaft is a link that turns; its masses are points on it.  An engine is a crank with a rod and a
piston for each cylinder.  A file with a table ``[shaft]`` or ``[engine]`` becomes a class like that
of any other file, and so do the tables that are given to the verbs.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from functools import lru_cache
from typing import Any, ClassVar

import numpy as np

from vad import gate
from vad.balancing.balance import Balance
from vad.balancing.engine import Engine
from vad.balancing.shaft import Balanced, balanced, unknowns
from vad.errors import InputError, UsageError, quoted
from vad.files.description import Values
from vad.files.loading import WrittenMechanism, class_of, declared
from vad.files.names import own_names
from vad.files.rotors import (
    AS_CYLINDER,
    AS_MASS,
    CYLINDERS,
    ENGINE,
    LOCOMOTIVE,
    MASSES,
    SHAFT,
    Rotor,
    read_rotor,
)
from vad.files.tables import Source, sorted_out
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of
from vad.kinematics.motion import Motion, solve
from vad.kinematics.numbers import ray
from vad.units import number_of

#: The letters of cylinders that have no name.
_NAMES = "ABCDEFGHIJKLMNPQRTUVWXYZ"
#: A rod is longer than its crank, or the piston would stop short of a turn.
_LEAST_RATIO = 1.0


def balance(
    masses: Mapping[str, Mapping[str, Any]],
    choice: int = 0,
    *,
    clockwise: bool = False,
    rpm: float = 0.0,
    bearings: Sequence[float] = (),
    length_unit: str = "mm",
    title: str = "Shaft",
) -> Balance:
    """Balance the masses of a shaft: find what is left out of them.

    Parameters
    ----------
    masses
        By name, a capital letter: ``{"A": {"mass": 200, "radius": 80, "angle": 0, "plane": 0}, …}``
        in kg, in the unit of lengths and in degrees.  In one plane, where no mass has a ``plane``,
        two numbers are left out; in several planes four of them.
    choice
        Which of two answers: in the first one, 0, the first unknown vector lies to the left of the
        closing line of its polygon.
    clockwise
        Whether angles are counted clockwise, as some books do.
    rpm
        The speed, for the forces on bearings.
    bearings
        The planes of two bearings.  With bearings nothing need be left out of the masses.
    length_unit
        The unit of radii and planes.
    title
        The heading of its sheet.

    Raises
    ------
    vad.errors.InputError
        Where not two or four numbers are left out, or no numbers balance the shaft.

    Examples
    --------
    Four masses in one plane (R. S. Khurmi and J. K. Gupta, Theory of Machines, ex. 21.1).

    >>> import vad
    >>> found = vad.balance({
    ...     "A": {"mass": 200, "radius": 0.2, "angle": 0},
    ...     "B": {"mass": 300, "radius": 0.15, "angle": 45},
    ...     "C": {"mass": 240, "radius": 0.25, "angle": 120},
    ...     "D": {"mass": 260, "radius": 0.3, "angle": 255},
    ...     "X": {"radius": 0.2},
    ... }, length_unit="m")
    >>> round(found.masses["X"]["mass"], 1), round(found.masses["X"]["angle"], 1)
    (116.1, 201.3)
    """
    words: dict[str, Any] = {"clockwise": clockwise, "choice": choice, "speed": _speed(rpm)}
    if len(gate.several("bearings", bearings, "two planes")):
        words["bearings"] = list(bearings)
    tables = {SHAFT: words | {"masses": dict(table_of_masses(masses))}}
    mechanism = _mechanism(tables, title, length_unit)
    found = mechanism.balancing(solve(mechanism, **mechanism.inputs))
    assert isinstance(found, Balance)
    return found


def engine(
    cylinders: Iterable[Mapping[str, Any]] | Mapping[str, Mapping[str, Any]],
    radius: float,
    ratio: float | None = None,
    rpm: float = 0.0,
    *,
    rod: float | None = None,
    reference: float = 0.0,
    shaft: Mapping[str, Mapping[str, Any]] | None = None,
    locomotive: Mapping[str, Any] | None = None,
    length_unit: str = "mm",
    title: str = "Engine",
) -> Engine:
    """Find the inertia forces of an engine at a speed.

    Parameters
    ----------
    cylinders
        Each with the ``mass`` in kg that goes to and fro, the angles in degrees of its ``crank`` on
        the shaft and of its ``line`` of stroke, and its ``plane``; what is left out is 0.  A list,
        or by name.
    radius
        Of the cranks.
    ratio, rod
        The length of the rods over the radius of the cranks, or that length itself.
    rpm
        The speed.
    reference
        The plane about which couples are.
    shaft
        Masses that turn with the shaft, as for `balance`.
    locomotive
        What is balanced in the wheels of a locomotive: ``{"balanced": 2 / 3, "rotating": 160,
        "wheels": (-750, 750), "balance_radius": 600}``, and perhaps ``wheel_diameter`` and
        ``wheel_load``, in N; of coupled wheels ``coupled``, ``coupling``, ``coupling_radius``,
        ``coupling_angle`` and ``coupling_planes``.
    length_unit
        The unit of lengths.
    title
        The heading of its sheet.

    Raises
    ------
    vad.errors.InputError
        For numbers that cannot be.

    Examples
    --------
    A V-twin at right angles: 11.5 kg, cranks of 75 mm, rods of 300 mm, 500 rpm.

    >>> import vad
    >>> twin = vad.engine([{"mass": 11.5, "line": 45}, {"mass": 11.5, "line": -45}], 75, 4, 500)
    >>> round(twin.largest("primary", "force"), 1), round(twin.least("primary", "force"), 1)
    (2364.6, 2364.6)
    >>> round(twin.largest("secondary", "force"), 1), twin.angles("secondary", "force")
    (836.0, (45.0, 135.0, 225.0, 315.0))
    """
    words: dict[str, Any] = {"radius": radius, "speed": _speed(rpm)}
    words |= {name: each for name, each in (("rod", rod), ("ratio", ratio)) if each is not None}
    if number_of("reference", reference, "length", length_unit):
        words["reference"] = reference
    tables: dict[str, Any] = {
        ENGINE: words,
        CYLINDERS: dict(table_of_masses(cylinders, CYLINDERS)),
    }
    if shaft is not None:
        tables[SHAFT] = {"masses": dict(table_of_masses(shaft, SHAFT))}
    if locomotive is not None:
        tables[LOCOMOTIVE] = locomotive
    mechanism = _mechanism(tables, title, length_unit)
    found = mechanism.balancing(solve(mechanism, **mechanism.inputs))
    assert isinstance(found, Engine)
    return found


def _speed(rpm: object) -> float:
    """Return a speed in rad/s."""
    return gate.number("rpm", rpm) * math.tau / 60.0


def _mechanism(tables: Mapping[str, Any], title: str, length_unit: str) -> RotorMechanism:
    """Return the mechanism of tables."""
    words = {"title": title, "unit": length_unit}
    kind: Any = class_of(sorted_out(Source("", {"": words | dict(tables)})))
    made: RotorMechanism = kind()
    return made


class RotorMechanism(WrittenMechanism):
    """A shaft or an engine; `rotor_class` makes its subclasses."""

    written: ClassVar[Any]
    is_rotor: ClassVar[bool] = True

    @property
    def _values(self) -> dict[str, float]:
        return {name: getattr(self, name) for name in self.written.parameters}

    @property
    def burden(self) -> None:
        """It bears no loads."""
        return

    @property
    def choice(self) -> int:
        """The number of the answer that balances it."""
        return 0 if self.written.is_engine else int(self.assembly)

    def linkage(self) -> Linkage:
        """Return the shaft with its masses, or the engine with its pistons."""
        values = self._values
        answers = answers_of(self.written, values)
        choice = self.choice if self.choice < len(answers) else 0
        return linkage_of(self.written, values, answers, choice)

    def balancing(self, motion: Motion) -> Balance | Engine:
        """Return what is balanced in a motion of it."""
        return balancing_of(self.written, self._values, self.choice, motion)

    def dimensions(self) -> dict[str, float]:
        """Return no dimension: a page turns it as it is."""
        return {}


@lru_cache(maxsize=64)
def rotor_class(text: str) -> type[RotorMechanism]:
    """Return the class of a shaft or an engine, from its packed source.

    Raises
    ------
    vad.errors.InputError
        With its line, for what cannot be.
    """
    source = Source.unpacked(text)
    rotor = read_rotor(source)
    check_rotor(rotor, {name: each.default for name, each in rotor.parameters.items()})
    axis, turns = rotor.axis, "crank" if rotor.is_engine else "shaft"
    first = next(iter(rotor.cylinders or rotor.masses))
    links = {turns: axis + (first.lower() if rotor.is_engine else first)}
    slides = {}
    if "rod" in rotor.numbers or "ratio" in rotor.numbers:
        links |= {f"rod_{name.lower()}": name.lower() + name for name in rotor.cylinders}
        slides = {f"piston_{name.lower()}": name for name in rotor.cylinders}
    pins = [name.lower() for name in rotor.cylinders]
    pistons = [*rotor.cylinders] if slides else []
    names = ("open",) if rotor.is_engine else ("0", "1")
    usual = "open" if rotor.is_engine else str(rotor.settings["choice"])
    choice = {"quantity": "choice", "choices": names, "help": "which of two answers"}
    made: type[RotorMechanism] = declared(
        RotorMechanism,
        rotor,
        title=rotor.title,
        about=str(source.table("").get("about", "")),
        unit=rotor.unit,
        parameters=rotor.parameters.values(),
        assembly=("assembly", str, field(default=usual, metadata=choice)),
        letters=(axis, *pins, *pistons, *rotor.masses),
        links=links,
        slides=slides,
        inputs={"angle": 0.0, "omega": rotor.speed, "alpha": 0.0},
        diagrams=rotor.diagrams,
        usual_diagrams=rotor.usual,
        turning_diagrams=rotor.turning,
        own_names=own_names(source, rotor.title, rotor.parameters),
    )
    with source.at("", ""):
        made()
    return made


def linkage_of(rotor: Rotor, values: Values, answers: tuple[Balanced, ...], choice: int) -> Linkage:
    """Return a shaft with its masses as points, or an engine with its rods and pistons."""
    axis = rotor.axis
    bars = []
    for each in answers[choice].masses if answers else ():
        assert each.radius is not None and each.angle is not None
        if each.radius:
            bars.append(Bar(axis + each.name, "shaft", each.radius, turn=ray(each.angle)))
    if not rotor.is_engine:
        return Linkage(angle_of("shaft"), (), images=tuple(bars), pivot=axis)
    inertia = rotor.inertia(values, 1.0, ())
    pins, loops = [], []
    for cylinder in inertia.cylinders:
        pin = cylinder.name.lower()
        crank = Bar(axis + pin, "crank", inertia.radius, turn=ray(cylinder.crank))
        if inertia.ratio is None:
            pins.append(crank)
            continue
        rod = Bar(pin + cylinder.name, f"rod_{pin}", inertia.ratio * inertia.radius)
        piston = Slide(axis + cylinder.name, f"piston_{pin}", cylinder.line, through_tail=True)
        loops.append(Loop((crank, rod), (piston,)))
    on_crank = [Bar(bar.ends, "crank", bar.length, turn=bar.turn) for bar in bars]
    return Linkage(angle_of("crank"), tuple(loops), images=(*pins, *on_crank), pivot=axis)


def answers_of(rotor: Rotor, values: Values) -> tuple[Balanced, ...]:
    """Return the answers that balance the masses of a shaft; none without masses.

    Raises
    ------
    vad.errors.InputError
        For masses that cannot be balanced.
    """
    masses = rotor.given_masses(values)
    if not masses:
        return ()
    alone = rotor.is_engine or bool(rotor.settings["bearings"])
    found = balanced(masses, rotor.unit, alone)
    if rotor.settings["bearings"] and any(each.plane is None for each in found[0].masses):
        raise UsageError(
            "bearings: the masses have no planes", "say where they are, as in plane = 300"
        )
    return tuple(found)


def balancing_of(rotor: Rotor, values: Values, choice: int, motion: Motion) -> Balance | Engine:
    """Return what is balanced in a motion of a shaft or an engine.

    Raises
    ------
    vad.errors.InputError
        For an engine whose speed changes.
    """
    answers = answers_of(rotor, values)
    balance = None
    if answers:
        balance = Balance(
            motion,
            rotor.given_masses(values),
            answers,
            choice if choice < len(answers) else 0,
            rotor.unit,
            rotor.settings["clockwise"],
            rotor.settings["bearings"],
        )
    if not rotor.is_engine:
        assert balance is not None
        return balance
    if even(motion, "alpha") != 0.0:
        raise InputError(
            f"alpha: an engine is balanced at an even speed, got {even(motion, 'alpha'):g}",
            "leave out alpha",
        )
    rotating = balance.found.masses if balance else ()
    inertia = rotor.inertia(values, even(motion, "omega"), rotating)
    return Engine(motion, inertia, balance, rotor.locomotive(values, inertia))


def even(motion: Motion, name: str) -> float:
    """Return an input of a motion that is the same in all of its poses.

    Raises
    ------
    vad.errors.InputError
        If it changes.
    """
    values = np.ravel(motion.inputs[name])
    if np.ptp(values):
        raise InputError(
            f"{name}: an engine is balanced at an even speed, got an array",
            f"give one {name} for all poses",
        )
    return float(values[0])


def check_rotor(rotor: Rotor, values: Values) -> None:
    """Refuse numbers that cannot be.

    Raises
    ------
    vad.errors.InputError
        With its line.
    """
    source = rotor.source
    with source.at(MASSES, next(iter(rotor.masses), "")):
        loose = unknowns(rotor.given_masses(values)) if rotor.masses else []
    table, key = (MASSES, loose[-1][0]) if loose else (MASSES, "")
    with source.at(table, key):
        answers = answers_of(rotor, values)
        choice = rotor.settings["choice"]
        if answers and choice >= len(answers):
            raise UsageError(f"choice: there is no answer {choice}, only one", "choice = 0")
    if not rotor.is_engine:
        return
    inertia = rotor.inertia(values, rotor.speed, ())
    if inertia.ratio is not None and inertia.ratio <= _LEAST_RATIO:
        word = "rod" if "rod" in rotor.numbers else "ratio"
        with source.at(ENGINE, word):
            raise InputError(
                f"{word}: a rod must be longer than its crank, got {inertia.ratio:g} times its "
                "length",
                "try ratio = 4",
            )
    with source.at(LOCOMOTIVE, "balanced"):
        found = rotor.locomotive(values, inertia)
        if found and not 0.0 <= found.share <= 1.0:
            message = f"balanced: must be between 0 and 1, got {found.share:g}"
            raise InputError(message, 'as in balanced = "2/3"')
        if found and (found.coupled < 1.0 or found.coupled != round(found.coupled)):
            message = f"coupled: must be a number of pairs of wheels, got {found.coupled:g}"
            raise InputError(message, "as in coupled = 2")
        if found:
            found.balance  # noqa: B018  # raises where it cannot be balanced


def table_of_masses(masses: Any, what: str = "masses") -> Mapping[str, Any]:
    """Return masses or cylinders by name, from a mapping, or a list whose entries get letters.

    Raises
    ------
    vad.errors.InputError
        For anything else.
    """
    if isinstance(masses, Mapping):
        return masses
    if isinstance(masses, str | bytes) or not isinstance(masses, Iterable):
        hint = AS_CYLINDER if what == "cylinders" else AS_MASS
        raise InputError(f"{what}: must be tables by name, got {quoted(masses)}", hint)
    listed = gate.several(what, masses, "tables")
    if len(listed) > len(_NAMES):
        raise InputError(f"{what}: there are {len(listed)}, more than letters", "give them names")
    return dict(zip(_NAMES, listed, strict=False))
