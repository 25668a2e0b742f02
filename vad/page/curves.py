"""What a page shows of a whole turn: curves of the table's values, hodographs and paths of points.

The script ``curves.js`` finds them with the program that moves the picture.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from vad.kinematics.traced import Traced
from vad.lecture.followed import PANELS, Followed
from vad.plan.board import rows_of
from vad.plan.hand_board import HandBoard
from vad.plan.turn_panel import owner_of
from vad.strokes.diagram import Spot
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.sheet import BELOW, Panel, Sheet


def curves(
    board: HandBoard,
    sheet: Sheet,
    output: Callable[[float], int],
    follow: Followed | None = None,
) -> dict[str, Any]:
    """Return the values and the points that are followed over a turn.

    Parameters
    ----------
    board
        The mechanism.
    sheet
        The sheet of the page.
    output
        The number of an output.
    follow
        The point whose path and hodographs alone are found, if there is one.

    Returns
    -------
    dict
        ``columns``: of each panel its values, each with row, output, factor, unit and symbol;
        those first that have the unit of a result.
        ``tracks``: of each panel its points, each with the row whose ink it has or None, the
        outputs of x and y, and the place of its scale among the inputs, None where that stays.
        ``on``: the names of what is shown from the start.
    """
    traced, notation = board.traced.sheet, sheet.notation
    columns = [
        [
            [index, output(cell.value), notation.scaled(1.0, cell.unit), unit, cell.symbol]
            for index, row in enumerate(traced.rows)
            for cell in row.cells.get(panel.name, ())
            if isinstance(cell.value, Traced)
            for unit in [notation.unit(cell.unit)]
        ]
        for panel in traced.panels
    ]
    # The page begins with the first unit: not with one that the given place or rate alone has.
    for number, panel in enumerate(traced.panels):
        cells = (cell for row in traced.rows for cell in row.cells.get(panel.name, ()))
        results = {notation.unit(cell.unit) for cell in cells if not cell.given}
        columns[number].sort(key=lambda value: value[3] not in results)
    names, tracks = list(board.traced.inputs), []
    for panel in traced.panels:
        found: list[list[Any]] = []
        spots = DIAGRAMS[panel.name].tracks(board.traced.scene)
        letter = follow.image(panel.name) if follow and panel.name in PANELS else ""
        still = {spot.letter for spot, at in spots.items() if not _moves(board, at)}
        for spot, at in spots.items():
            half = traced.panel(panel.name + BELOW) if spot.below else panel
            place = _followed(board, half, at)
            if place is None or (letter and spot.letter != letter):
                continue
            scale = names.index(f"{half.name} x") if f"{half.name} x" in names else None
            row = (
                rows_of(sheet)[follow.row] if follow and letter else _row(half, spot, still, sheet)
            )
            found.append([row, output(place.real), output(place.imag), scale])
        tracks.append(found)
    return {"columns": columns, "tracks": tracks, "on": ["paths"] if follow else []}


def _followed(board: HandBoard, panel: Panel, at: Any) -> complex | None:
    """Return where a point is: in its panel's unit, or on the page where the scale never changes.

    None if it stands still.
    """
    if not _moves(board, at):
        return None
    if isinstance(board.scales[panel.name].factor, Traced):
        place: complex = at
        return place
    return board.scales[panel.name](at)


def _moves(board: HandBoard, at: Any) -> bool:
    return any(board.traced.moves(part) for part in (at.real, at.imag))


def _row(panel: Panel, spot: Spot, still: set[str], sheet: Sheet) -> int | None:
    """Return the row of the link or slide whose vector ends at a point."""
    return rows_of(sheet).get(spot.row or owner_of(spot.letter, still, [panel]) or "")
