"""What is given of a sheet: the driver's place and rates, loads, and the numbers of bodies."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from vad.kinematics.motion import Motion, solve
from vad.strokes.diagram import ORDERS
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.draw import OF_FORCES, parted, scene_of, usual_of, with_forces
from vad.strokes.force_names import ForceNames
from vad.strokes.scene import Scene
from vad.strokes.sheet import Cell, Row, Sheet
from vad.words import Gap, Language, TextPiece
from vad.written import subscript, with_unit

Pieces = tuple[TextPiece, ...]

#: The figures upon the mechanism from which rates of an order follow.
FIGURES: Mapping[int, tuple[str, ...]] = {1: ("centres", "klein", "turned"), 2: ("klein",)}
#: The letters of the numbers of a mass on a shaft, and of a cylinder.
_SYMBOLS = {"mass": "m", "radius": "r", "angle": "θ", "plane": "l", "crank": "φ", "line": "ψ"}


def given(sheet: Sheet, panels: Collection[str] = ()) -> list[Pieces]:
    """Return all that is given for the panels of a sheet, and for further ``panels``.

    A sheet without a source gives what stands in its table.
    """
    if sheet.source is None:
        return tabled(sheet)
    mechanism, inputs, burden, _ = sheet.source
    motion, forces = parted(with_forces(solve(mechanism, **inputs), burden))
    if mechanism.is_rotor:
        rows = [row for row in sheet.rows if row.key == sheet.driver.row]
        place = [c for row in rows for cells in row.cells.values() for c in cells if c.given]
        return [_written(sheet, cell) for cell in (*_of_rotor(motion), *place)]
    needed = {half.name for half in sheet.halves} | {*panels}
    loaded = needed & {*OF_FORCES[1:]}
    if forces and loaded:
        needed |= {*usual_of(forces)}
    most = 0
    for order in ORDERS:
        if needed & {order.panel, *FIGURES.get(order.number, ())}:
            most = order.number
    scene = scene_of(motion, Language(sheet.language, sheet.names), forces)
    shown = [DIAGRAMS[order.panel] for order in ORDERS[: most + 1]]
    cells = [cell for row in scene.rows(shown) for each in row.cells.values() for cell in each]
    items = [_written(sheet, cell) for cell in cells if cell.given]
    if loaded and isinstance(scene, Scene) and forces:
        items += _of_bodies(sheet, scene.force_names)
    return items


def tabled(sheet: Sheet) -> list[Pieces]:
    """Return what is given in the table of a sheet, each once."""
    named = [own for row in sheet.rows for each in row.cells.values() for own in owned(row, each)]
    return list(dict.fromkeys(_written(sheet, cell) for cell in named if cell.given))


def owned(row: Row, cells: Iterable[Cell]) -> Iterator[Cell]:
    """Yield cells of a row; those of a mass on a shaft, and of a cylinder, have its name: m_A."""
    for cell in cells:
        own = f"{cell.symbol}_{row.letters}" if row.key == row.letters else ""
        yield replace(cell, symbol=own or cell.symbol)


def _of_rotor(motion: Motion[Any, Any, Any]) -> Iterator[Cell]:
    """Yield the numbers of masses, cylinders and wheels with their names: m_A, r_A."""
    length = motion.mechanism.length_unit
    units = {"mass": "kg", "radius": length, "plane": length}
    numbers = motion.mechanism.parameters()
    for name, number in numbers.items():
        letter, _, what = name.rpartition("_")
        if what in _SYMBOLS and name != "balance_radius" and letter:
            yield Cell(f"{_SYMBOLS[what]}_{letter}", number, units.get(what, "°"), given=True)
    locomotive = getattr(motion.mechanism.balancing(motion), "locomotive", None)
    if locomotive:
        yield Cell("c", locomotive.share, "", given=True)
        yield Cell("m", locomotive.rotating, "kg", given=True)
        yield Cell("r", locomotive.balance_radius, length, given=True)
        for wheel, plane in zip(locomotive.names, locomotive.wheels, strict=True):
            yield Cell(f"l_{wheel}", plane, length, given=True)
    yield Cell("ω", float(motion.inputs["omega"]), "rad/s", given=True)


def _of_bodies(sheet: Sheet, names: ForceNames) -> Iterator[Pieces]:
    """Yield loads, masses and moments of inertia with their points, gravity and friction."""
    forces = names.forces
    for cell in (*names.given_loads, *names.given_couples):
        yield _written(sheet, cell)
    points = {each.body: each.point for each in forces.acting if each.kind == "inertia"}
    for each in forces.acting:
        if each.kind in ("inertia", "spin"):
            letter, unit = ("m", "kg") if each.kind == "inertia" else ("I", "kg m²")
            value = float(forces.inputs[each.inputs[0]])
            if value:
                cell = Cell(letter + subscript(names.numbers[each.body]), value, unit, given=True)
                yield _written(sheet, cell, f"given {each.kind}", points[each.body])
    if any(each.kind == "weight" for each in forces.acting):
        size = abs(complex(forces.inputs["gx"], forces.inputs["gy"]))
        yield _written(sheet, Cell("g", size, "m/s²", given=True))
    blocks = {j.slide.name: j.other for j in forces.bodies.joints if j.slide}
    for number, slide in enumerate(forces.solver.rough):
        symbol = "μ" + subscript(names.numbers[blocks[slide]])
        yield _written(sheet, Cell(symbol, float(forces.inputs[f"mu{number}"]), "", given=True))


def _written(sheet: Sheet, cell: Cell, phrase: str = "", point: str = "") -> Pieces:
    """Return a cell as θ₂ = 60°, in a phrase perhaps with a point."""
    value = with_unit(*sheet.notation.cell(cell.value, cell.unit, given=True))
    parts: dict[str, Pieces] = {
        "size": (TextPiece(cell.symbol, "symbol"), TextPiece(f" = {value}")),
        "point": (TextPiece(point, "symbol"),),
    }
    return phrased(Language(sheet.language), phrase, **parts) if phrase else parts["size"]


def phrased(language: Language, phrase: str, **parts: Pieces) -> Pieces:
    """Return a phrase whose gaps are filled with pieces."""
    found: list[TextPiece] = []
    for each in language.template(phrase):
        found += parts[each.name] if isinstance(each, Gap) else (each,)
    return tuple(found)
