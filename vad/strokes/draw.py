"""The verb `draw`: from a motion to the sheet with its panels and its table of results."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from vad.errors import InputError, UsageError, unknown
from vad.kinematics.linkage import Slide, angle_of, length_of
from vad.kinematics.motion import Motion
from vad.strokes.chains import NOTHING
from vad.strokes.language import Language
from vad.strokes.polygon import polygon
from vad.strokes.position import position, slide_symbol
from vad.strokes.scene import Scene
from vad.strokes.sheet import PANELS, Arrow, Cell, Panel, PanelName, Row, Sheet


def draw(motion: Motion, panels: Sequence[str] | str = PANELS, language: str = "en") -> Sheet:
    """Draw one pose: the strokes of its panels in the order in which a teacher draws them.

    Parameters
    ----------
    motion
        One pose; its rates are solved only as far as the panels need them.
    panels
        Which of "position", "velocity" and "acceleration", in any order.
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
        raise InputError(f"motion: must be what vad.solve returns, got {motion!r}")
    if motion.many:
        raise InputError("motion: a sheet shows one pose, got arrays of poses")
    wanted = chosen(panels)
    scene = Scene(motion, Language(language))
    drawn = tuple(_panel(scene, name) for name in wanted)
    mechanism = motion.mechanism
    return Sheet(
        mechanism=mechanism.name,
        title=scene.language.name(mechanism.title),
        parameters=_parameters(scene),
        rows=_without_noise(_rows(scene, wanted), drawn),
        panels=drawn,
        language=language,
    )


def chosen(panels: Sequence[str] | str) -> tuple[PanelName, ...]:
    """Return the names of panels in their own order, each once.

    Raises
    ------
    vad.errors.UsageError
        For an unknown name, or none.
    """
    names = (panels,) if isinstance(panels, str) else tuple(panels)
    for name in names:
        if name not in PANELS:
            raise unknown("panel", str(name), PANELS)
    if not names:
        raise UsageError("panels: none given", hint="known: " + ", ".join(PANELS))
    return tuple(name for name in PANELS if name in names)


def _panel(scene: Scene, name: PanelName) -> Panel:
    if name == "position":
        return position(scene)
    return polygon(scene, PANELS.index(name))


def _parameters(scene: Scene) -> tuple[tuple[str, float, str], ...]:
    mechanism = scene.motion.mechanism
    plain = type(mechanism)
    shown = []
    for name, value in mechanism.parameters().items():
        metadata = plain.__dataclass_fields__[name].metadata
        if metadata["quantity"] == "length":
            shown.append((scene.language.name(name), value, scene.unit))
        elif value != plain.__dataclass_fields__[name].default:
            shown.append((scene.language.name(name), value, "°"))
    return tuple(shown)


def _rows(scene: Scene, panels: tuple[PanelName, ...]) -> list[Row]:
    motion = scene.motion
    rows: list[Row] = []
    for name in motion.links:
        link, given = motion.link(name), angle_of(name) == scene.driver
        cells: dict[PanelName, tuple[Cell, ...]] = {}
        for panel in panels:
            symbol, unit, quantity = (
                ("θ", "°", "angle"),
                ("ω", "rad/s", "omega"),
                ("α", "rad/s²", "alpha"),
            )[PANELS.index(panel)]
            cells[panel] = (Cell(symbol, getattr(link, quantity), unit, given),)
        rows.append(Row(name, scene.language.name(name), motion.mechanism.links[name], cells))
    for name in motion.slides:
        rows.append(_slide_row(scene, name, panels))
    return rows


def _without_noise(rows: list[Row], panels: tuple[Panel, ...]) -> tuple[Row, ...]:
    """Write as zero what is zero but for rounding, against the largest of its kind."""
    largest: dict[str, float] = {}
    for row in rows:
        for cell in (cell for cells in row.cells.values() for cell in cells):
            largest[cell.unit] = max(abs(cell.value), largest.get(cell.unit, 0.0))
    for panel in panels:
        arrows = [stroke.shape for stroke in panel.strokes if isinstance(stroke.shape, Arrow)]
        sizes = (abs(arrow.end - arrow.start) for arrow in arrows)
        largest[panel.unit] = max(largest.get(panel.unit, 0.0), *sizes, 0.0)
    largest["rad/s²"] = max(largest.get("rad/s²", 0.0), largest.get("rad/s", 0.0) ** 2)

    def cleaned(cell: Cell) -> Cell:
        noise = abs(cell.value) < NOTHING * largest[cell.unit]
        return replace(cell, value=0.0) if noise and not cell.given else cell

    return tuple(
        replace(row, cells={name: tuple(map(cleaned, cells)) for name, cells in row.cells.items()})
        for row in rows
    )


def _slide_row(scene: Scene, name: str, panels: tuple[PanelName, ...]) -> Row:
    motion = scene.motion
    slide, given = motion.slide(name), length_of(name) == scene.driver
    step = next(s for s in motion.frame.steps if isinstance(s, Slide) and s.name == name)
    symbols = (slide_symbol(scene, step), "v", "a")
    cells: dict[PanelName, tuple[Cell, ...]] = {}
    for panel in panels:
        order = PANELS.index(panel)
        unit = scene.rate_unit(order)
        cells[panel] = (Cell(symbols[order], getattr(slide, panel), unit, given),)
        if panel == "acceleration" and slide.coriolis is not None:
            cells[panel] += (Cell("2ωv", slide.coriolis, unit),)
    title = scene.language.name(name.split("_", maxsplit=1)[0])
    return Row(name, title, motion.mechanism.slides[name], cells)
