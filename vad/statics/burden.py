"""What a mechanism has to bear: loads, masses, gravity and friction, and how they are written.

A load is written "80 N @ 150 at E on rocker" or "-6 N m on rocker", a mass "coupler 2 kg at G",
a moment of inertia "coupler 0.01 kg m^2", friction "ram 0.1".
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from vad.errors import UsageError, quoted
from vad.units import number_of

_LOAD = re.compile(
    r"""\s*(?:(?P<name>[^\W\d]\w*)\s*[=:]\s*)?
    (?P<size>[^@=:]+?)
    (?:\s*@\s*(?P<angle>[^@]+?))?
    (?:\s+at\s+(?P<at>\w+))?
    (?:\s+on\s+(?P<on>[\w-]+))?\s*""",
    re.VERBOSE,
)
_OF_BODY = re.compile(r"\s*(?P<body>[^\W\d][\w-]*)\s+(?P<size>\S.*?)(?:\s+at\s+(?P<at>\w+))?\s*")
_AS_OF_BODY = {
    "mass": "coupler 2 kg at G",
    "inertia": "coupler 0.01 kg m^2",
    "friction": "ram 0.1",
}
_AS_LOAD = "as in '80 N @ 150 at E', or '-6 N m on rocker'"


@dataclass(frozen=True)
class Burden:
    """What a mechanism has to bear, as `vad.forces` takes it.

    Attributes
    ----------
    loads
        Forces at points, and couples.
    masses
        By the names of bodies.
    gravity
        In m/s²; None for none.
    friction
        By the names of slides.
    """

    loads: tuple[Any, ...] = ()
    masses: Mapping[str, Any] = field(default_factory=dict)
    gravity: Any = None
    friction: Mapping[str, Any] = field(default_factory=dict)

    def __iter__(self) -> Iterator[Any]:
        """Yield loads, masses, gravity and friction, as `vad.forces` takes them."""
        return iter((self.loads, self.masses, self.gravity, self.friction))

    def __hash__(self) -> int:
        """Return a number that is the same for equal burdens; their numbers do not change it."""
        return hash((len(self.loads), *sorted(self.masses), *sorted(self.friction)))

    def __bool__(self) -> bool:
        """Tell whether there is anything that makes forces."""
        return bool(self.loads or self.masses)

    def beside(self, other: Burden) -> Burden:
        """Return both together; of one body, the other one counts."""
        masses = dict(self.masses)
        for body, mass in other.masses.items():
            known = masses.get(body, {})
            both = isinstance(known, Mapping) and isinstance(mass, Mapping)
            masses[body] = {**known, **mass} if both else mass
        return Burden(
            (*self.loads, *other.loads),
            masses,
            self.gravity if other.gravity is None else other.gravity,
            {**self.friction, **other.friction},
        )


NOTHING = Burden()


def whole(own: Burden | None, more: Burden = NOTHING) -> Burden:
    """Return what a mechanism has to bear of its own, and more beside it."""
    return more if own is None else own.beside(more)


def beside_own(own: Burden | None, more: Burden = NOTHING) -> Burden | None:
    """Return ``more`` where a mechanism has anything to bear, of its own or this; else None."""
    return more if whole(own, more) else None


def check_burden(own: Burden | None, given: Burden) -> None:
    """Check that there is a mass for gravity that is given, and a load for friction.

    Raises
    ------
    vad.errors.UsageError
        Which begins with the option, as those of `burden_of` do.
    """
    both = whole(own, given)
    if given.gravity is not None and not both.masses:
        raise UsageError("--gravity: there is no mass", "as in --mass 'coupler 2 kg at G'")
    if given.friction and not both:
        raise UsageError("--friction: there is no load", "as in --load '80 N @ 150 at E'")


def burden_of(
    load: Iterable[str] = (),
    mass: Iterable[str] = (),
    inertia: Iterable[str] = (),
    gravity: str | None = None,
    friction: Iterable[str] = (),
) -> Burden:
    """Return what is written on a command line, option by option.

    Raises
    ------
    vad.errors.UsageError
        For what cannot be read; the message begins with the option.

    Examples
    --------
    >>> burden_of(load=["80 N @ 150 at E"], mass=["ram 25"], inertia=["rod 0.1 kg m^2"]).masses
    {'ram': {'mass': 25.0}, 'rod': {'inertia': 0.1}}
    """
    masses: dict[str, dict[str, Any]] = {}
    for words, quantity in ((mass, "mass"), (inertia, "inertia")):
        for text in words:
            body, given = _of_body(f"--{quantity}", text, quantity)
            here = masses.setdefault(body, {})
            for word, value in given.items():
                if word in here and (word == quantity or here[word] != value):
                    raise UsageError(f"--{quantity}: {body} has two of '{word}'", "one is enough")
                here[word] = value
    rubbing = [_of_body("--friction", text, "friction") for text in friction]
    return Burden(
        tuple(load_of(text, "--load") for text in load),
        masses,
        None if gravity is None else _gravity(gravity),
        {body: given["friction"] for body, given in rubbing},
    )


def load_of(text: str, what: str = "load") -> dict[str, Any]:
    """Return a load that is written as a text.

    Raises
    ------
    vad.errors.UsageError
        If it cannot be read.

    Examples
    --------
    >>> load_of("P = 2 kN @ 150 at E on rocker")
    {'name': 'P', 'force': 2000.0, 'angle': 150.0, 'at': 'E', 'on': 'rocker'}
    >>> load_of("-6 N m on rocker")
    {'couple': -6.0, 'on': 'rocker'}
    """
    read = _LOAD.fullmatch(text)
    if read is None:
        raise UsageError(f"{what}: {quoted(text)} is no load", _AS_LOAD)
    words = read.groupdict()
    kind = "couple" if words["at"] is None else "force"
    if kind == "couple" and (words["on"] is None or words["angle"] is not None):
        raise UsageError(f"{what}: {quoted(text)} says no point at which it acts", _AS_LOAD)
    load: dict[str, Any] = {"name": words["name"]} if words["name"] else {}
    load[kind] = number_of(what, words["size"], kind)
    if words["angle"] is not None:
        load["angle"] = number_of(what, words["angle"], "direction")
    for word in ("at", "on"):
        if words[word] is not None:
            load[word] = words[word].replace("-", "_")
    return load


def _of_body(option: str, text: str, quantity: str) -> tuple[str, dict[str, Any]]:
    """Read "coupler 2 kg at G": a body, a quantity of it, and perhaps a point."""
    read = _OF_BODY.fullmatch(text)
    hint = f"as in '{_AS_OF_BODY[quantity]}'"
    if read is None or (read["at"] and quantity == "friction"):
        raise UsageError(f"{option}: {quoted(text)} is no {quantity} of a body", hint)
    given: dict[str, Any] = {quantity: number_of(option, read["size"], quantity)}
    if read["at"]:
        given["at"] = read["at"]
    return read["body"].replace("-", "_"), given


def _gravity(text: str) -> Any:
    parts = re.split(r"\s*,\s*|(?<=\d)\s+(?=[-+.\d\N{MINUS SIGN}])", text.strip())
    numbers = [number_of("--gravity", part, "gravity") for part in parts]
    if len(numbers) > 2:
        raise UsageError(f"--gravity: {quoted(text)} is neither one number nor two", "as in 9.81")
    return numbers[0] if len(numbers) == 1 else tuple(numbers)
