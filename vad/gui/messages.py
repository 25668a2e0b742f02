"""The questions of the browser, and the errors that answer questions that cannot be.

A question is JSON that anybody may have written.  It becomes a dataclass, whose fields are checked
one by one, and this gives a mechanism with its inputs, or an error that names the field.  `problem`
makes JSON of an error.
"""

from __future__ import annotations

import dataclasses
import json
import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from typing import Any, Self, TypeVar

from vad import gate, units
from vad.errors import (
    AssemblyError,
    DeadCentreError,
    ExportError,
    InputError,
    UsageError,
    VadError,
    one_of,
    quoted,
    unknown,
)
from vad.files.examples import EXTENSION
from vad.gui.said import labels, translated
from vad.gui.work import BusyError
from vad.kinematics.motion import Motion, solve
from vad.lecture.lesson import check_size
from vad.mechanisms import MECHANISMS, Mechanism
from vad.mechanisms.mechanism import NUMBERS
from vad.statics.burden import NOTHING, Burden, beside_own
from vad.statics.loads import listed_loads
from vad.words import ENGLISH, Language, all_languages

#: The largest picture and the most frames a second that the page saves.
LARGEST, MOST_FPS = (3840, 2160), 60.0
#: The longest question, in bytes.
LONGEST = 16 * 1024
#: The most further points: the time of a lesson grows with the cube of their number.
MOST_POINTS = 40
#: The most loads beside those of a file.
MOST_LOADS = 40

Asked = TypeVar("Asked", bound="Question")
#: A number in the scene's unit, or a text that has a unit of its own: "6 cm".
NumberOrText = float | str
#: The mechanisms that may be asked for, by name.
Kinds = Mapping[str, type[Mechanism]]
#: The scale of each panel: x and y of its origin on the page, and its factor.
Scales = Mapping[str, tuple[float, float, float]]
_KINDS: dict[type[VadError], str] = {
    BusyError: "busy",
    UsageError: "usage",
    InputError: "input",
    AssemblyError: "assembly",
    DeadCentreError: "dead-centre",
    ExportError: "export",
}
_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
#: "angle 15.46", "coupler 100 and rocker 40", "--rod 100 --ram-height 180".
_PAIR = re.compile(rf"(?:--)?([a-z][a-z_-]*) ({_NUMBER})(?![\w.])")
_ALONE = re.compile(rf"try ({_NUMBER})")


@dataclass(frozen=True)
class Question:
    """A mechanism with its dimensions and its input.

    Attributes
    ----------
    mechanism
        Its name.
    parameters, inputs
        Numbers, or texts with a unit; what is left out has its default.
    assembly
        Which way it is assembled, or the places of points; None for the default.
    points
        Further points on links, as a mechanism has them.
    length_unit
        The unit that labels lengths; None for the mechanism's own.
    burden
        What the mechanism has to bear beside its own.
    panels
        Which panels are drawn; empty for the usual ones.
    language
        The language of all words.
    style
        How it looks.
    kinds
        The mechanisms that may be asked for.  They do not come from the browser.
    """

    mechanism: str
    parameters: Mapping[str, NumberOrText] = field(default_factory=dict)
    inputs: Mapping[str, NumberOrText] = field(default_factory=dict)
    assembly: Any = None
    points: Mapping[str, Any] = field(default_factory=dict)
    length_unit: str | None = None
    burden: Burden = NOTHING
    panels: tuple[str, ...] = ()
    language: str = "en"
    style: str = "paper"
    kinds: Kinds = field(default_factory=lambda: MECHANISMS, repr=False)

    @classmethod
    def of(
        cls,
        mechanism: Mechanism,
        inputs: Mapping[str, NumberOrText],
        burden: Burden = NOTHING,
        **options: Any,
    ) -> Self:
        """Return the question of a mechanism; an input that is left out has its default.

        One that a file describes is asked for by the name of the file, and may be asked for beside
        the program's own.

        Raises
        ------
        vad.errors.UsageError
            For more further points, or loads, than a window takes; for a shaft or an engine.
        """
        kind, name = type(mechanism), mechanism.name
        if MECHANISMS.get(name) is not kind:
            name += EXTENSION
        check_turned(kind, name)
        return cls(
            name,
            mechanism.parameters(),
            {**mechanism.inputs, **inputs},
            mechanism.assembly,
            _points("points", {name: tuple(place) for name, place in mechanism.points.items()}),
            mechanism.length_unit,
            _burden("burden", json.loads(json.dumps(vars(burden), default=_plain))),
            kinds={**MECHANISMS, name: kind},
            **options,
        )

    @property
    def fields(self) -> tuple[str, ...]:
        """The names of the mechanism's parameters and inputs; none of a mechanism that is not."""
        kind = self.kinds.get(self.mechanism)
        return (*(each.name for each in dataclasses.fields(kind)), *kind.inputs) if kind else ()

    def problem(self, error: VadError) -> dict[str, Any]:
        """Return the object of an error, in the language of the question."""
        if self.language == ENGLISH or self.language not in all_languages():
            return problem(error, self.fields)
        say = Language(self.language)
        names = labels(self.kinds.get(self.mechanism), say)
        return problem(error, self.fields, lambda text: translated(text, names, say))

    def build(self) -> tuple[Mechanism, dict[str, float]]:
        """Return the mechanism and its inputs.

        Raises
        ------
        vad.errors.VadError
            For a value that cannot be; the message begins with its name.
        """
        mechanism = self.with_dimensions(self.parameters)
        driven = {name: name for name in mechanism.inputs}
        return mechanism, self._numbers("input", self.inputs, driven, mechanism.length_unit)

    def solved(self) -> tuple[Motion, Burden | None]:
        """Return the motion, and what the mechanism bears beside its own; None if nothing loads it.

        Raises
        ------
        vad.errors.VadError
            As for `build`.
        """
        mechanism, inputs = self.build()
        return solve(mechanism, **inputs), beside_own(mechanism.burden, self.burden)

    def with_dimensions(self, parameters: Mapping[str, NumberOrText]) -> Mechanism:
        """Return the mechanism with these parameters; errors are those of `build`."""
        kind = self.kinds[one_of("mechanism", self.mechanism, self.kinds)]
        known = {each.name: each for each in dataclasses.fields(kind)}
        unit = str(known["length_unit"].default)
        if self.length_unit is not None:
            unit = units.check_length_unit(self.length_unit)
        quantities = {name: each.metadata["quantity"] for name, each in known.items()}
        numbers = {name: each for name, each in quantities.items() if each in NUMBERS}
        given: dict[str, Any] = self._numbers("parameter", parameters, numbers, unit)
        if self.assembly is not None:
            given["assembly"] = self.assembly
        return kind(**given, points=self.points, length_unit=unit)

    def _numbers(
        self, what: str, given: Mapping[str, NumberOrText], known: Mapping[str, str], unit: str
    ) -> dict[str, float]:
        """Return numbers in the scene's units; ``known`` says of each name what it measures.

        A text may have the decimal sign of its language.
        """
        found: dict[str, float] = {}
        point = Language(self.language).point
        for name, value in given.items():
            if name not in known:
                raise unknown(what, name, known)
            read = value.replace(point, ".") if isinstance(value, str) else value
            found[name] = units.number_of(name, read, known[name], unit)
        return found


@dataclass(frozen=True)
class EntryQuestion(Question):
    """What can be set of a mechanism, of one that a file describes if there is the file's text."""

    text: str | None = None


@dataclass(frozen=True)
class PoseQuestion(Question):
    """One pose while something is dragged.

    Attributes
    ----------
    scales
        Those of the pose before.
    ways
        Where each label of each panel stood from its dot in the pose before: degrees.
    stands
        The parameters of the last lesson: supports and other marks that stand still stay where that
        lesson has them.  None stands for the parameters of this question.
    known
        The classes whose rules the page has.
    """

    scales: Scales = field(default_factory=dict)
    ways: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    stands: Mapping[str, NumberOrText] | None = None
    known: tuple[str, ...] = ()

    def of_last_lesson(self, mechanism: Mechanism) -> Mechanism:
        """Return the mechanism of the last lesson, or the ``mechanism`` that is asked for."""
        if self.stands is None or self.stands == self.parameters:
            return mechanism
        return self.with_dimensions(self.stands)


@dataclass(frozen=True)
class LessonQuestion(Question):
    """The lesson of the present settings.

    Attributes
    ----------
    scales
        Those of polygons to be kept.
    key
        That of the answer whose mechanism stands on the page; see `vad.gui.answers.lesson`.
    known
        The classes whose rules the page has.
    """

    scales: Scales = field(default_factory=dict)
    key: str = ""
    known: tuple[str, ...] = ()


@dataclass(frozen=True)
class ExportQuestion(Question):
    """A file of the present settings; ``fps`` and ``speed`` are those of a film."""

    size: tuple[int, int] = (1280, 720)
    fps: float = 30.0
    speed: float = 1.0


def read(kind: type[Asked], data: object, kinds: Kinds = MECHANISMS) -> Asked:
    """Return the question that JSON data ask of the mechanisms in ``kinds``.

    Raises
    ------
    vad.errors.UsageError
        For a field that is unknown, missing or of the wrong kind.
    """
    if not isinstance(data, dict):
        raise UsageError(f"the question must be an object, got {quoted(data)}")
    known = {each.name for each in dataclasses.fields(kind)} & set(_CHECKS)
    for name in data:
        if name not in known:
            raise unknown("field", name, sorted(known))
    if "mechanism" not in data:
        raise UsageError("mechanism: is missing", hint="vad list names them all")
    return kind(**{name: _CHECKS[name](name, value) for name, value in data.items()}, kinds=kinds)


def check_turned(kind: type[Mechanism], file: str) -> None:
    """Refuse a shaft or an engine that a file describes: no hand turns it.

    Raises
    ------
    vad.errors.UsageError
        With the command that shows it.
    """
    if kind.is_rotor:
        raise UsageError(
            f"{file}: a window turns a mechanism by hand, which a shaft or an engine is not",
            f"vad draw {file} -o {kind.name}.png shows it",
        )


def _text(name: str, value: object) -> str:
    if not isinstance(value, str):
        raise UsageError(f"{name}: must be a text, got {quoted(value)}")
    return value


def _optional_text(name: str, value: object) -> str | None:
    return None if value is None else _text(name, value)


def _texts(name: str, value: object) -> tuple[str, ...]:
    if not isinstance(value, list):
        raise UsageError(f"{name}: must be a list, got {quoted(value)}")
    return tuple(_text(name, each) for each in value)


def _object(name: str, value: object) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise UsageError(f"{name}: must be an object, got {quoted(value)}")
    return value


def _values(name: str, value: object) -> dict[str, NumberOrText]:
    """Read numbers and texts by name; None stands for the default, and what is left out does."""
    return {
        key: each if isinstance(each, str) else gate.number(key, each)
        for key, each in _object(name, value).items()
        if each is not None
    }


def _points(name: str, value: object) -> dict[str, Any]:
    points = _object(name, value)
    if len(points) > MOST_POINTS:
        raise UsageError(f"{name}: a window takes at most {MOST_POINTS}, got {len(points)}")
    return points


def _burden(name: str, value: object) -> Burden:
    """Read loads, masses, gravity and friction; what is in them is checked with the mechanism."""
    given = _object(name, value)
    known = [each.name for each in dataclasses.fields(Burden)]
    for word in given:
        if word not in known:
            raise unknown("word of a burden", word, known)
    loads = listed_loads(given.get("loads", ()))
    if len(loads) > MOST_LOADS:
        raise UsageError(f"{name}: a window takes at most {MOST_LOADS} loads, got {len(loads)}")
    masses, friction = (_object(word, given.get(word, {})) for word in ("masses", "friction"))
    return Burden(loads, masses, given.get("gravity"), friction)


def _plain(value: Any) -> object:
    """Return an array or a mapping as JSON can have it."""
    return dict(value) if isinstance(value, Mapping) else value.tolist()


def _scales(name: str, value: object) -> Scales:
    found = {}
    for panel, each in _object(name, value).items():
        if not isinstance(each, list) or len(each) != 3:
            raise UsageError(f"{name}: must have three numbers for {quoted(panel)}")
        x, y, factor = (gate.number(name, number) for number in each)
        if factor <= 0.0:
            raise UsageError(f"{name}: must be positive, got {factor:g}")
        found[panel] = x, y, factor
    return found


def _ways(name: str, value: object) -> dict[str, dict[str, float]]:
    return {
        panel: {label: gate.number(name, way) for label, way in _object(name, each).items()}
        for panel, each in _object(name, value).items()
    }


def _size(name: str, value: object) -> tuple[int, int]:
    if not isinstance(value, list) or len(value) != 2:
        raise UsageError(f"{name}: must be a width and a height, got {quoted(value)}")
    width, height = check_size(tuple(value))
    if width > LARGEST[0] or height > LARGEST[1]:
        most = f"{LARGEST[0]}x{LARGEST[1]}"
        raise UsageError(f"{name}: must be at most {most}, got {width}x{height}")
    return width, height


def _fps(name: str, value: object) -> float:
    fps = gate.number(name, value)
    if fps > MOST_FPS:
        raise UsageError(f"{name}: must be at most {MOST_FPS:g}, got {fps:g}")
    return fps


_CHECKS = {
    "mechanism": _text,
    "parameters": _values,
    "inputs": _values,
    "assembly": lambda name, value: value,
    "points": _points,
    "length_unit": _optional_text,
    "burden": _burden,
    "panels": _texts,
    "language": _text,
    "scales": _scales,
    "ways": _ways,
    "stands": _values,
    "known": _texts,
    "key": _text,
    "text": _text,
    "style": _text,
    "size": _size,
    "fps": _fps,
    "speed": gate.number,
}


def as_json(data: Mapping[str, Any]) -> str:
    """Return an answer as JSON."""
    return json.dumps(data, ensure_ascii=False, allow_nan=False, separators=(",", ":"))


def problem(
    error: VadError, fields: Collection[str] = (), say: Callable[[str], str] = str
) -> dict[str, Any]:
    """Return the object of an error.

    Parameters
    ----------
    error
        What went wrong.
    fields
        The names of the parameters and inputs that there are.
    say
        How its sentences are said.

    Returns
    -------
    dict
        ``message``, ``hint`` and ``kind``; ``field`` where the message begins with the name of one,
        and ``try``, values by field, where the hint is one that can be followed at once.

    Examples
    --------
    >>> error = InputError("crank: must be positive, got -4", hint="try 4")
    >>> problem(error, ["crank"])["try"]
    {'crank': 4.0}
    """
    found: dict[str, Any] = {
        "message": say(str(error)),
        "hint": error.hint and say(error.hint),
        "kind": next(kind for cls, kind in _KINDS.items() if isinstance(error, cls)),
    }
    name = re.split(r"[: ]", str(error), maxsplit=1)[0]
    if name in fields:
        found["field"] = name
    values = _values_to_try(error.hint or "", found.get("field"), fields)
    return found | {"try": values} if values else found


def _values_to_try(hint: str, field: str | None, fields: Collection[str]) -> dict[str, float]:
    """Return the values that a hint names."""
    pairs = ((name.replace("-", "_"), float(value)) for name, value in _PAIR.findall(hint))
    values = {name: value for name, value in pairs if name in fields}
    alone = _ALONE.fullmatch(hint)
    return {field: float(alone[1])} if alone and field else values
