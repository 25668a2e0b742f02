"""The verb `draw`: from a motion to the sheet with its panels and its table of results."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from vad import gate
from vad.errors import InputError, UsageError, one_of, quoted
from vad.kinematics.linkage import Linkage, points_of
from vad.kinematics.motion import Motion, solve
from vad.kinematics.solver import Solver
from vad.strokes.arithmetic import with_digits
from vad.strokes.centrodes import pair_of
from vad.strokes.construct import construct
from vad.strokes.diagram import ACCELERATION, VELOCITY, Drawing, Order
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.finishing import canonical, finished, without_noise
from vad.strokes.notation import Notation, in_metres
from vad.strokes.parameter_names import is_borne, word_of
from vad.strokes.pin_rows import with_pins
from vad.strokes.polygon import polygon
from vad.strokes.scene import Scene
from vad.strokes.sentences import Voice, called
from vad.strokes.sheet import (
    TWIST,
    Arrow,
    Panel,
    Row,
    Sheet,
    Source,
    driver_of,
)
from vad.strokes.titling import own_titles
from vad.words import Language

if TYPE_CHECKING:
    from vad.balancing.balance import Balance
    from vad.balancing.engine import Engine
    from vad.mechanisms.mechanism import Mechanism
    from vad.statics.burden import Burden
    from vad.statics.forces import Forces
    from vad.strokes.balancing.scene import BalancingScene
    from vad.strokes.space.scene import SceneInSpace

    AnyScene = Scene | SceneInSpace | BalancingScene

#: The ending of the name of the angle between two axes.  The name without it is that of their
#: distance.
_TWIST = "_twist"
#: The panels of forces that are drawn where nobody asks for others.
OF_FORCES = "position", "force", "drive"
#: The poles of force polygons in one pose: each stands beside the last one.
NO_POLES: Mapping[int, complex] = MappingProxyType({})
#: What has no pins whose velocities of rubbing are asked for.
NO_PINS: Mapping[str, Any] = MappingProxyType({})
#: Of more parameters the coordinates come last.
FEW = 8
#: The most further points on links: with their number, the time to place their letters grows by its
#: square.  Solving takes as many as there are names.
MOST_POINTS = 60


def draw(
    motion: Motion | Forces[Any, Any, Any] | Balance | Engine,
    panels: Sequence[str] | str | None = None,
    language: str = "en",
    superpose: bool = False,
    centrode: str | None = None,
    pins: Mapping[str, Any] | None = None,
    title: str | None = None,
    subtitle: str | None = None,
) -> Sheet:
    """Draw one pose: the strokes of its panels in the order in which a teacher draws them.

    Parameters
    ----------
    motion
        One pose, the forces in one, or what is balanced, a shaft or an engine; rates are solved
        only as far as the panels need them.
    panels
        Which of "position", "velocity", "acceleration" and, for forces, "force" and "drive", in any
        order; if None, those of a motion, or the position and what is of forces: with masses that
        move the accelerations, too.
    language
        The language of the captions, as a two-letter code.
    superpose
        Whether forces are drawn by superposition: load by load, and then their sums.
    centrode
        The body whose centrodes the panel "centres" shows: "coupler", or "rocker on crank" for the
        curves on which it rolls on another body than the frame.  None draws none.
    pins
        Diameters of pins by their points, as for `vad.merit`: how fast they rub stands in the
        table, beside the velocities.
    title, subtitle
        A title of one's own instead of the name of the mechanism, and what stands below it: lines
        of at most 120 letters.  A page that has less room for them is refused when it is made.

    Raises
    ------
    vad.errors.UsageError
        For an unknown panel or language, or a panel that does not apply to the mechanism.
    vad.errors.InputError
        For a motion of many poses, or more further points on links than a page has room for; for a
        title that is empty, or no line of text.
    vad.errors.AssemblyError, vad.errors.DeadCentreError
        For a pose that does not exist, or has no rates.

    Examples
    --------
    >>> import vad
    >>> sheet = vad.draw(vad.solve(vad.FourBar()), panels=("velocity",))
    >>> [stroke.label for stroke in sheet.panel("velocity").strokes]
    ['a,d', 'ab', '⟂ BC', '⟂ DC', 'c', 'bc', 'dc']
    """
    own = own_titles(title, subtitle)
    motion, forces = parted(motion)
    if motion.many or (forces is not None and forces.many):
        raise InputError("motion: a sheet shows one pose, got arrays of poses")
    if gate.flag("superpose", superpose) and forces is None:
        raise InputError("superpose: there are no loads", "as in --load '80 N @ 150 at E'")
    if pins is not None:
        _check_pins(motion, pins)
    names = chosen(panels, motion, forces)
    if centrode is not None:
        pair_of(motion, centrode, names)
    more: dict[str, Any] = {"superpose": superpose, "centrode": centrode, "pins": pins or {}}
    return replace(sheet_of(scene_of(motion, Language(language), forces, **more), names), **own)


def _check_pins(motion: Motion[Any, Any, Any], pins: Mapping[str, Any]) -> None:
    """Check that there are pins at these points, with positive diameters."""
    from vad.merits.pins import rubbing  # most drawings have none

    if motion.mechanism.is_rotor:
        raise InputError("pins: a shaft or an engine has none", "leave them out")
    rubbing(motion, pins)


def parted(
    given: Motion | Forces[Any, Any, Any] | Balance | Engine,
) -> tuple[Motion, Forces[Any, Any, Any] | None]:
    """Return a motion and the forces in it, None where a motion alone is given.

    Raises
    ------
    vad.errors.InputError
        For anything else.
    """
    forces = None if isinstance(given, Motion) else _forces(given)
    motion = given if forces is None else forces.motion
    if forces is None and not isinstance(given, Motion):
        motion = _balanced(given)
    if not isinstance(motion, Motion):
        raise InputError(f"motion: must be what vad.solve returns, got {quoted(given)}")
    motion.check_one()
    return motion, forces


def started(
    given: Mechanism | Motion | Forces[Any, Any, Any], what: str
) -> tuple[Motion, Forces[Any, Any, Any] | None]:
    """Return one pose with which something starts, and the forces in it, None without any.

    A mechanism starts as it moves usually.

    Raises
    ------
    vad.errors.InputError
        For many poses, of which the message says what is done with one; and for no mechanism.
    """
    alone = isinstance(given, Motion) or _forces(given)
    motion, forces = parted(given if alone else solve(given))  # type: ignore[arg-type]
    if motion.many or (forces is not None and forces.many):
        raise InputError(f"motion: {what}, got arrays of poses")
    return motion, forces


def sheet_of(scene: AnyScene, panels: Sequence[str]) -> Sheet:
    """Return the sheet of a scene of one pose, with panels that apply to it.

    Raises
    ------
    vad.errors.AssemblyError, vad.errors.DeadCentreError
        For a pose that does not exist, or has no rates.
    """
    motion, diagrams = scene.motion, [DIAGRAMS[name] for name in panels]
    language, forces = scene.language.code, scene.forces
    drawn = tuple(diagram.panel(scene) for diagram in diagrams)
    if isinstance(scene, Scene) and scene.pins:
        drawn = tuple(with_pins(panel, scene.rubs) for panel in drawn)
    rows = scene.rows(diagrams)
    largest = _largest(rows, drawn)
    for half in (half for panel in drawn for half in panel.halves):
        gate.check_drawn(half.name, largest[half.unit], half.unit)
    rates = [largest.get(order.unit_of(scene.unit), 0.0) for order in (VELOCITY, ACCELERATION)]
    notation = Notation(scene.language.point, in_metres(rates))
    scene.voice.notation = notation
    for sentence, parts in zip(
        scene.calculated, with_digits(scene.calculated, notation), strict=True
    ):
        sentence.parts = parts
    mechanism, clean = motion.mechanism, without_noise(rows, largest)
    return Sheet(
        mechanism=mechanism.name,
        title=scene.name(mechanism.title),
        parameters=parameters_of(mechanism, language),
        rows=clean,
        panels=tuple(finished(panel, scene.voice) for panel in drawn),
        language=language,
        notation=notation,
        names=mechanism.own_names,
        driver=driver_of(scene.driver.name, scene.driver.kind == "angle", clean, drawn),
        source=Source(
            mechanism,
            dict(motion.inputs),
            forces.burden if forces else None,
            dict(getattr(scene, "pins", ())) or None,
        ),
        output=mechanism.output_point,
    )


def chosen(
    panels: Sequence[str] | str | None,
    motion: Motion[Any, Any, Any] | None = None,
    forces: Forces[Any, Any, Any] | None = None,
) -> tuple[str, ...]:
    """Return the names of panels in the order of the page, each once.

    Parameters
    ----------
    panels
        Names, or None for the usual ones that apply.
    motion
        The motion that is to be drawn, if it is known.
    forces
        The forces in it, if there are any.

    Raises
    ------
    vad.errors.UsageError
        For an unknown name, or none; for a diagram that does not apply to the mechanism.
    """
    fitting = [name for name, each in DIAGRAMS.items() if motion is None or each.applies(motion)]
    names = usual_of(forces) if forces else [n for n in fitting if DIAGRAMS[n].usual]
    if motion is not None and motion.mechanism.is_rotor:
        names = motion.mechanism.usual_diagrams
    usual = tuple(name for name in fitting if name in names)
    given = usual if panels is None else gate.several("panels", panels, "names of panels")
    asked = [one_of("panel", name, DIAGRAMS) for name in given]
    if not asked:
        raise UsageError("panels: none given", hint="known: " + ", ".join(fitting))
    for name in (name for name in asked if name not in fitting):
        mechanism = motion.mechanism.name if motion else ""
        hint = f"known for {mechanism}: {', '.join(fitting)}"
        raise UsageError(f"panel {name!r} does not apply to {mechanism}", hint)
    return tuple(name for name in DIAGRAMS if name in asked)


def turning(
    panels: Sequence[str] | str | None, motion: Motion[Any, Any, Any]
) -> Sequence[str] | str:
    """Return the panels of a turn of an engine: the given ones, or those that change.

    Raises
    ------
    vad.errors.InputError
        For a shaft, whose polygons turn with it and do not change.
    """
    usual = motion.mechanism.turning_diagrams
    if not usual:
        raise InputError(
            "turn: the masses of a shaft and their polygons turn with it; nothing else changes",
            "an engine has forces that change over a turn; vad draw shows the shaft",
        )
    return usual if panels is None else panels


#: Name, value and unit of parameters.
Named = tuple[tuple[str, float, str], ...]


@lru_cache(maxsize=64)
def parameters_of(mechanism: Mechanism, language: str) -> Named:
    """Return the parameters that the title lists as far as it has room, the last ones least.

    They are all lengths and arcs, and another angle unless that is 0, or a default that is a
    multiple of 90°.
    """
    plain, unit = type(mechanism), mechanism.length_unit
    voice = Voice(language, names=mechanism.own_names)
    shown: list[tuple[str, float, str]] = []
    values = mechanism.parameters()
    for name, value in values.items():
        metadata = plain.__dataclass_fields__[name].metadata
        if name.endswith(_TWIST) or (mechanism.is_rotor and "_" in name):
            continue  # it follows its length, or is that of a mass, which stands in the table
        if is_borne(plain, name):
            continue
        if metadata["quantity"] != "angle":
            shown.append(
                (
                    called(word_of(plain, name), voice),
                    value,
                    unit if metadata.get("measures", metadata["quantity"]) == "length" else "",
                )
            )
            if name + _TWIST in values:
                alone = sum(each.endswith(_TWIST) for each in values) == 1
                twist = name + _TWIST
                shown.append((called(twist, voice) if alone else TWIST, values[twist], "°"))
            continue
        usual = value == plain.__dataclass_fields__[name].default and not value % 90.0
        if "between" in metadata or (value and not usual):
            shown.append((called(name, voice), value, "°"))
    for name, (link, distance, *angle) in mechanism.points.items():
        tail, head = points_of(mechanism.links.get(link) or _rod_ends(mechanism, link))
        shown.append((tail + name, distance, unit))
        shown += [(head + tail + name, each, "°") for each in angle if each]
    if len(shown) > FEW:
        coordinates = {point + axis for point in solve(mechanism).points for axis in "xy"}
        shown.sort(key=lambda each: each[0] in coordinates)
    found: Named = canonical(tuple(shown))
    return found


def _rod_ends(mechanism: Mechanism, rod: str) -> str:
    """Return the points by which the rod of a cylinder is named: its outer end first."""
    linkage = mechanism.marked()
    assert isinstance(linkage, Linkage)
    barrel, end = next((b, e) for b, e in linkage.cylinders.items() if e.name == rod)
    other = next(point for point in points_of(mechanism.links[barrel]) if point != end.point)
    return end.point + other


def _largest(rows: list[Row], panels: tuple[Panel, ...]) -> dict[str, float]:
    """Return the largest size of each unit, in the table and of the vectors."""
    largest: dict[str, float] = {}
    for row in rows:
        for cells in row.cells.values():
            for cell in cells:
                largest[cell.unit] = max(abs(cell.value), largest.get(cell.unit, 0.0))
    for half in (half for panel in panels for half in panel.halves):
        size = largest.get(half.unit, 0.0)
        for stroke in half.strokes:
            if isinstance(stroke.shape, Arrow):
                size = max(size, abs(stroke.shape.end - stroke.shape.start))
        largest[half.unit] = size
    turning = largest.get("rad/s", 0.0)
    largest["rad/s²"] = max(largest.get("rad/s²", 0.0), turning * turning)
    return largest


class PlaneScene(Scene):
    """One pose of a mechanism in the plane, with what is drawn of it."""

    def drawing(self, order: Order) -> Drawing:
        """Return the construction of the mechanism, or a polygon."""
        return polygon(self, order.number) if order.number else construct(self)


def with_forces(
    motion: Motion[Any, Any, Any], burden: Burden | None
) -> Motion[Any, Any, Any] | Forces[Any, Any, Any]:
    """Return the forces in a motion, where there is a burden beside that of its mechanism.

    Without one, not even an empty one, return the motion.
    """
    if burden is None:
        return motion
    from vad.statics.forces import forces  # most drawings have none

    return forces(motion, *burden)


def usual_of(forces: Forces[Any, Any, Any]) -> tuple[str, ...]:
    """Return the panels of forces where nobody asks for others, in the order of the page.

    Where masses move, and so have inertia forces, the polygon of the accelerations comes before.
    """
    _, *rates = forces.motion.inputs.values()
    masses = any(each.kind == "inertia" for each in forces.acting)
    if masses and any(rate.any() if hasattr(rate, "any") else rate for rate in rates):
        return (OF_FORCES[0], ACCELERATION.panel, *OF_FORCES[1:])
    return OF_FORCES


def _forces(given: Any) -> Forces[Any, Any, Any] | None:
    """Return forces that are to be drawn; None for anything else."""
    from vad.statics.forces import Forces  # most drawings have none

    return given if isinstance(given, Forces) else None


def _balanced(given: Any) -> Any:
    """Return the motion of what is balanced; anything else as it is."""
    from vad.balancing.balance import Balance  # most drawings have neither shaft nor engine
    from vad.balancing.engine import Engine

    return given.motion if isinstance(given, Balance | Engine) else given


def scene_of(
    motion: Motion[Any, Any, Any],
    language: Language,
    forces: Forces[Any, Any, Any] | None = None,
    poles: Mapping[int, complex] = NO_POLES,
    largest: float = 0.0,
    superpose: bool = False,
    centrode: str | None = None,
    pins: Mapping[str, Any] = NO_PINS,
) -> AnyScene:
    """Return the scene of a motion, in the plane or in space, and of the forces in it.

    The ``poles`` of the force polygons and the ``largest`` force on the driven body are those of a
    whole turn.  The ``centrode`` is one that `pair_of` has read.

    Raises
    ------
    vad.errors.InputError
        For more further points on links than a page has room for.
    """
    if motion.mechanism.is_rotor:
        from vad.strokes.balancing.scene import BalancingScene

        return BalancingScene(motion, language)
    if isinstance(motion.solver, Solver):
        count = len(motion.solver.linkage.images)
        if count > MOST_POINTS:
            raise InputError(
                f"points: a drawing has room for {MOST_POINTS} on links, got {count}",
                hint="leave some out; vad solve and vad sweep take them all",
            )
        more: dict[str, Any] = {"poles": poles, "largest": largest, "centrode": centrode}
        more |= {"superpose": superpose, "pins": pins}
        return PlaneScene(motion, language, forces=forces, **more)
    from vad.strokes.space.scene import SceneInSpace  # the plane does not need it

    in_space: Any = motion
    return SceneInSpace(in_space, language)
