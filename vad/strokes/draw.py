"""The verb `draw`: from a motion to the sheet with its panels and its table of results."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from vad.errors import InputError, UsageError, one_of, shown
from vad.kinematics.linkage import points_of
from vad.kinematics.motion import Motion
from vad.strokes.canonical import canonical
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.figures import Writer
from vad.strokes.language import Language
from vad.strokes.notation import Notation, in_metres
from vad.strokes.scenes import AnyScene, scene_of
from vad.strokes.sheet import TWIST, Arrow, Cell, Equation, Panel, Row, Sheet, Stroke, Term
from vad.strokes.vector_equations import NOTHING

#: Ends the name of the angle between two axes, whose distance bears the name before it.
_TWIST = "_twist"
#: So many parameters a title has at most.
MOST = 8


def draw(motion: Motion, panels: Sequence[str] | str | None = None, language: str = "en") -> Sheet:
    """Draw one pose: the strokes of its panels in the order in which a teacher draws them.

    Parameters
    ----------
    motion
        One pose; its rates are solved only as far as the panels need them.
    panels
        Which of "position", "velocity" and "acceleration", in any order; the usual ones if None.
    language
        The language of the captions, as a two-letter code.

    Raises
    ------
    vad.errors.UsageError
        For an unknown panel or language.
    vad.errors.InputError
        For a motion of many poses.
    vad.errors.AssemblyError, vad.errors.DeadCentreError
        For a pose that does not exist, or has no rates.

    Examples
    --------
    >>> import vad
    >>> sheet = vad.draw(vad.solve(vad.FourBar()), panels=("velocity",))
    >>> [stroke.label for stroke in sheet.panel("velocity").strokes]
    ['a,d', 'ab', '⟂ BC', '⟂ DC', 'c', 'bc', 'dc']
    """
    if not isinstance(motion, Motion):
        raise InputError(f"motion: must be what vad.solve returns, got {shown(motion)}")
    if motion.many:
        raise InputError("motion: a sheet shows one pose, got arrays of poses")
    diagrams = [DIAGRAMS[name] for name in chosen(panels)]
    scene = scene_of(motion, Language(language))
    drawn = tuple(diagram.panel(scene) for diagram in diagrams)
    rows = scene.rows(diagrams)
    largest = _largest(rows, drawn)
    rates = [size for unit, size in largest.items() if unit.startswith(f"{scene.unit}/s")]
    notation = scene.figures.settled(Notation(scene.language.point, in_metres(rates)))
    fill = Writer(notation).fill
    mechanism = motion.mechanism
    return Sheet(
        mechanism=mechanism.name,
        title=scene.language.name(mechanism.title),
        parameters=canonical(_parameters(scene)),
        rows=_without_noise(rows, largest),
        panels=tuple(_finished(panel, fill) for panel in drawn),
        language=language,
        notation=notation,
    )


def chosen(panels: Sequence[str] | str | None) -> tuple[str, ...]:
    """Return the names of panels in the order of the page, each once; None are the usual ones.

    Raises
    ------
    vad.errors.UsageError
        For an unknown name, or none.
    """
    usual = tuple(name for name, diagram in DIAGRAMS.items() if diagram.usual)
    given = usual if panels is None else panels
    try:
        given = (given,) if isinstance(given, str) else tuple(given)
    except TypeError:
        raise UsageError(f"panels: must be names of panels, got {shown(given)}") from None
    names = [one_of("panel", name, DIAGRAMS) for name in given]
    if not names:
        raise UsageError("panels: none given", hint="known: " + ", ".join(DIAGRAMS))
    return tuple(name for name in DIAGRAMS if name in names)


def _parameters(scene: AnyScene) -> tuple[tuple[str, float, str], ...]:
    """Return all lengths and arcs, and other angles but for 0 and a mechanism's own along axes.

    Where they are too many for a line, coordinates are left out first, and then the last.
    """
    mechanism = scene.motion.mechanism
    plain = type(mechanism)
    shown, values = [], mechanism.parameters()
    for name, value in values.items():
        metadata = plain.__dataclass_fields__[name].metadata
        if name.endswith(_TWIST):
            continue  # behind its length
        if metadata["quantity"] != "angle":
            unit = scene.unit if metadata["quantity"] == "length" else ""
            shown.append((scene.language.name(name), value, unit))
            if name + _TWIST in values:
                shown.append((TWIST, values[name + _TWIST], "°"))
            continue
        usual = value == plain.__dataclass_fields__[name].default and not value % 90.0
        if "between" in metadata or (value and not usual):
            shown.append((scene.language.name(name), value, "°"))
    for name, (link, distance, *angle) in mechanism.points.items():
        tail, head = points_of(mechanism.links[link])
        shown.append((tail + name, distance, scene.unit))
        shown += [(head + tail + name, each, "°") for each in angle if each]
    if len(shown) > MOST:
        coordinates = {point + axis for point in scene.motion.points for axis in "xy"}
        shown = [each for each in shown if each[0] not in coordinates]
    return tuple(shown[:MOST])


def _finished(panel: Panel, fill: Callable[[str], str]) -> Panel:
    """Return a panel with the numbers in its captions, labels and equations, and all canonical."""

    def strokes(raw: tuple[Stroke, ...]) -> tuple[Stroke, ...]:
        return tuple([_finished_stroke(stroke, fill) for stroke in raw])

    def term(raw: Term) -> Term:
        label = fill(raw.label)
        return raw if label is raw.label else replace(raw, label=label)

    def terms(raw: tuple[Term, ...]) -> tuple[Term, ...]:
        return tuple(map(term, raw))

    return replace(
        panel,
        strokes=strokes(panel.strokes),
        zeros=strokes(panel.zeros),
        equations=tuple(
            [Equation(terms(each.left), terms(each.right)) for each in panel.equations]
        ),
        inset=canonical(panel.inset),
        triangles=canonical(panel.triangles),
        notes=canonical(panel.notes),
        below=panel.below and _finished(panel.below, fill),
    )


def _finished_stroke(raw: Stroke, fill: Callable[[str], str]) -> Stroke:
    label, caption, shape = fill(raw.label), fill(raw.caption), canonical(raw.shape)
    if label is raw.label and caption is raw.caption and shape is raw.shape:
        return raw
    more = raw.link, raw.component, raw.image, raw.reveals, raw.name
    return Stroke(raw.kind, label, shape, caption, *more)


def _largest(rows: list[Row], panels: tuple[Panel, ...]) -> dict[str, float]:
    """Return the largest size of each unit, in the table and of the vectors."""
    largest: dict[str, float] = {}
    for row in rows:
        for cell in (cell for cells in row.cells.values() for cell in cells):
            largest[cell.unit] = max(abs(cell.value), largest.get(cell.unit, 0.0))
    for half in (half for panel in panels for half in panel.halves):
        arrows = [stroke.shape for stroke in half.strokes if isinstance(stroke.shape, Arrow)]
        sizes = (abs(arrow.end - arrow.start) for arrow in arrows)
        largest[half.unit] = max(largest.get(half.unit, 0.0), *sizes, 0.0)
    largest["rad/s²"] = max(largest.get("rad/s²", 0.0), largest.get("rad/s", 0.0) ** 2)
    return largest


def _without_noise(rows: list[Row], largest: dict[str, float]) -> tuple[Row, ...]:
    """Write as zero what is zero but for rounding, against the largest of its kind."""

    def cleaned(cell: Cell) -> Cell:
        noise = abs(cell.value) < NOTHING * largest[cell.unit]
        return replace(cell, value=0.0) if noise and not cell.given else canonical(cell)

    return tuple(
        Row(
            row.key,
            row.title,
            row.letters,
            {name: tuple([cleaned(cell) for cell in cells]) for name, cells in row.cells.items()},
        )
        for row in rows
    )
