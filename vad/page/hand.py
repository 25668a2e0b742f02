"""A mechanism that is turned on a page: what is drawn of it, and the program that moves it.

A page carries, for each panel, what a hand moves as SVG, and the numbers of its attributes as
outputs of one program (`vad.page.solver`).  The script ``hand.js`` plays that program.
"""

from __future__ import annotations

import cmath
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from itertools import groupby
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from vad.gate import FASTEST
from vad.kinematics.numbers import vector
from vad.kinematics.program import Program
from vad.kinematics.reach import closing_range
from vad.kinematics.traced import Traced, plain
from vad.lecture.followed import Followed
from vad.lecture.moment import drawing
from vad.page.curves import curves
from vad.page.dimensions import dimensions, readable
from vad.page.ink import Inker, attributed, when
from vad.page.large import Large
from vad.page.outputs import Outputs
from vad.page.scaled import Scaled, edges
from vad.page.solved import proofs, template
from vad.page.solver import solver_data
from vad.page.spoken import names_of_loads, spelled
from vad.page.ways import ways
from vad.painting.svg_elements import number
from vad.plan.board import Plan
from vad.plan.geometry import Rect
from vad.plan.hand_board import HandBoard, scale_inputs
from vad.plan.items import FOREVER, Item, in_painting_order
from vad.plan.labels.named import Label
from vad.plan.labels.vertices import text_at
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs, roman, symbols
from vad.plan.marks import Bow, Disc, Lettering, Mark, Outline, Polygon, Polyline, line
from vad.plan.pictures.skeleton import GRIP
from vad.plan.scale import (
    LEAST_POLYGON,
    LONGEST_BAR,
    SCALE_GAP,
    SCALE_RISE,
    SCALE_SIZE,
    SCALE_TICK,
    SHORTEST_BAR,
    SPARE,
)
from vad.strokes.diagram import ORDERS, VELOCITY
from vad.strokes.parameter_names import parameter_name
from vad.strokes.sheet import Sheet
from vad.words import Language
from vad.written import THIN_SPACE

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism

#: How much farther than at their best place labels with a leader may stand.
_FAR = (0.030, 0.044, 0.058)
#: What is farther than this from what it names has a leader.
_BESIDE = 0.04
#: The attributes of a shape that are set before it is seen.
_SET = re.compile(r' (?:d|cx|cy)="[^"]*"')
#: Elements of lines in one piece: other than a path, they are not styled anew when they move.
_LINES = {"l": "polyline", "a": "polygon"}
#: What tells a letter from the same one in another view.
_AGAIN = re.compile(r" \d+$")
#: Of the signs in a scale bar's number, and of the bar itself, in page units.
_SIGNS = {
    "wide": {sign: round(width(roman(sign), SCALE_SIZE), 5) for sign in f"0.,{THIN_SPACE}×"},
    "longest": LONGEST_BAR,
    "shortest": SHORTEST_BAR,
    "gap": SCALE_GAP,
    "rise": SCALE_RISE,
    "tick": SCALE_TICK,
}


@dataclass(frozen=True)
class Hand:
    """What a page needs to be turned.

    Attributes
    ----------
    layers
        What is drawn in each panel while it is turned, and the ring of the handle, as SVG.
    program
        The data of `vad.page.solver.solver_data`.
    data
        For ``hand.js``: see there.
    """

    layers: Mapping[str, str]
    program: Mapping[str, Any]
    data: Mapping[str, Any]


def fast(mechanism: Mechanism, regions: Sequence[str]) -> int:
    """Return the number of the panel that is never cut over a turn: a quick return is fast.

    -1 where a driver that cannot go round has rates without end at its dead centres.
    """
    goes_round = closing_range(mechanism) == [(0.0, 360.0)] and "angle" in mechanism.inputs
    return regions.index(VELOCITY.panel) if goes_round and VELOCITY.panel in regions else -1


def hand(
    board: HandBoard,
    plan: Plan,
    inker: Inker,
    write: Callable[[Runs], str],
    large: Mapping[str, Large] = MappingProxyType({}),
    follow: Followed | None = None,
) -> Hand:
    """Return a mechanism that is turned on a page.

    Parameters
    ----------
    board
        The mechanism.
    plan
        The board of the page: the mechanism stands first as it does there.
    inker
        The inker of the page.
    write
        The function that writes runs as HTML.
    large
        The panels as they are drawn while they are in work.
    follow
        The point whose path and hodographs alone are shown; those of all points if None.
    """
    sheet, outputs, traced = plan.sheet, Outputs(), board.traced
    begun = Begun(sheet)
    halves = [half.name for half in traced.sheet.halves]
    layers: dict[str, str] = {}
    moves: list[list[Any]] = []
    moving = [item for sketch in board.sketches.values() for item in sketch.items]
    regions = [panel.name for panel in traced.sheet.panels]
    for region in regions:
        shown = [item for item in (*board.still, *moving) if item.region == region]
        layers[region] = "".join(
            _grouped(_layer(items, inker, outputs, moves), begun.of(*named))
            for named, items in groupby(
                in_painting_order(shown, regions), key=lambda item: _named(item.stroke, region)
            )
        )
    polygons, boxes = [], list[list[float]]()
    for half in traced.sheet.halves:
        if f"{half.name} scale" in traced.inputs:
            polygon = Scaled(board, plan, half)
            polygons.append({"half": halves.index(half.name), **polygon.data(outputs)})
            if large:
                polygons[-1]["large"] = polygon.placed(large[half.column].sketches[half.name])
            if half.name != half.column:
                since = begun.of(half.name, half.strokes[0].name)
                layers[half.column] += polygon.lower_bar(halves.index(half.name), inker, since)
                boxes.append([halves.index(half.name), *_box(polygon.bar_box, outputs)])
    polygons.sort(key=lambda polygon: polygon["mechanism"])
    labels, nears = [], dict[tuple[tuple[float, ...], int, bool], int]()
    for label in board.labels:
        column = traced.sheet.panel(label.panel).column
        element = inker.mark(text_at(label.runs, label.runs, 0j, label.size, label.role, label.row))
        since = begun.of(label.panel, label.stroke)
        layers[column] += f'<g class="label"{since}>{element}</g>'
        near = tuple(round(gap + label.radius, 5) for gap in label.near)
        beside = sum(gap <= _BESIDE for gap in label.near) if label.led else len(near)
        wish = _wish(label, nears.setdefault((near, beside, label.led), len(nears)), outputs)
        labels.append([halves.index(label.panel), *wish])
    blocks = [
        [halves.index(name), *outputs.listed(map(_rounded, (start, end))), round(half, 5)]
        for name, sketch in board.sketches.items()
        for start, end, half, _ in sketch.obstacles.lines[_above(board, name)[0] :]
    ]
    boxes += [
        [halves.index(name), *_box(box, outputs)]
        for name, sketch in board.sketches.items()
        for box, _ in sketch.obstacles.boxes[_above(board, name)[1] :]
    ]
    grip, ring = board.grip, ""
    if grip:
        radius = number(GRIP * inker.frame[0])
        place = f'cx="0" cy="0" r="{radius}" data-vad-grip'
        since = begun.of(regions[0], traced.sheet.driver.stroke)
        ring = f'<g class="grip"{since}><circle class="ring" {place}/></g>'
    names = names_of_loads(sheet)
    data = {
        "inputs": list(traced.inputs),
        "start": _start(board, plan),
        "grip": grip
        and {
            "kind": grip.kind,
            "at": outputs.place(grip.at),
            "about": outputs.place(grip.about),
            "way": [grip.way.real, -grip.way.imag],
            "factor": float(grip.factor),
        },
        "ranges": closing_range(board.mechanism),
        "fast": fast(board.mechanism, regions),
        "moves": moves,
        "labels": labels,
        "spelled": [
            spelled(_AGAIN.sub("", label.name), sheet.language, names) for label in board.labels
        ],
        "nears": [
            [[*near, *(near[0] + far for far in _FAR if led)], beside]
            for near, beside, led in nears
        ],
        "leader": inker.name(line([0j, 1.0 + 0j], "leader")),
        "blocks": blocks,
        "boxes": boxes,
        "rooms": [edges(board.live.page.panels[panel].drawing) for panel in regions],
        "halves": [
            [
                regions.index(half.column),
                *edges(board.live.room(half, sheet)),
                *(edges(large[half.column].sketches[half.name].setting.room) if large else []),
            ]
            for half in traced.sheet.halves
        ],
        "polygons": polygons,
        "least": LEAST_POLYGON,
        "spare": SPARE,
        "signs": _SIGNS,
        "point": sheet.notation.point,
        "cells": _cells(board, sheet, outputs),
        "page": inker.frame,
    }
    layers = {region: f'<g class="hand">{layer}</g>' for region, layer in layers.items()}
    layers[regions[0]] += ring
    data |= _described(board, sheet, outputs, write)
    data["curves"] = curves(board, sheet, outputs.of, follow)
    data |= ways(board, sheet.language, outputs.of)
    program, count = traced.program(outputs.numbers), len(traced.guards)
    last = [*program.outputs[count:], *program.outputs[:count]]
    program = Program(program.inputs, last, len(last))
    data["size"] = len(last)
    data["guards"] = [
        [len(outputs.numbers) + place, int(guard.value)]
        for place, guard in enumerate(traced.guards)
    ]
    return Hand(layers, solver_data(program, len(traced.inputs) - 3), data)


class Begun:
    """The beats of the lesson of a sheet in which its strokes are begun."""

    def __init__(self, sheet: Sheet) -> None:
        self._beats: dict[tuple[str, str], int] = {}
        self._last: dict[str, int] = {}
        halves = ((panel, half) for panel in sheet.panels for half in panel.halves)
        strokes = ((panel, half, stroke) for panel, half in halves for stroke in half.strokes)
        for index, (panel, half, stroke) in enumerate(strokes):
            self._beats[half.name, stroke.name] = drawing(index)
            self._last[panel.name] = self._last[half.name] = drawing(index)

    def of(self, panel: str, stroke: str | None) -> str:
        """Return the attribute of what is seen from a stroke on.

        A stroke that the lesson has not, as for a vector without a length, comes with the last one
        of its panel; without a name it is there from the start.
        """
        since = self._beats.get((panel, stroke), self._last.get(panel, 0)) if stroke else 0
        return when([(since, FOREVER)])


def _named(stroke: str, region: str) -> tuple[str, str]:
    """Return the panel and the name of a stroke's full name; both for what belongs to none."""
    panel, _, name = stroke.rpartition(":")
    return panel or region, name


def _above(board: HandBoard, name: str) -> tuple[int, int]:
    """Return how many lines and boxes of a half are those of the half above it."""
    taken = board.sketches[name].setting.taken
    return (len(taken.lines), len(taken.boxes)) if taken else (0, 0)


def _box(box: Rect, outputs: Outputs) -> list[float]:
    """Return a box that labels keep clear of: the numbers of its middle, half its size."""
    middle = outputs.place(vector((box.left + box.right) / 2, (box.bottom + box.top) / 2))
    return [*middle, round(float(box.width) / 2, 5), round(float(box.height) / 2, 5)]


def _grouped(elements: Sequence[str], since: str) -> str:
    """Return elements that are seen from a beat on; a single one takes less of a frame alone."""
    text = "".join(elements)
    if len(elements) == 1 and text.startswith("<g"):  # it is a group already
        return text.replace("<g", f"<g{since}", 1)
    return attributed(text, since)


def _layer(
    items: Iterable[Item], inker: Inker, outputs: Outputs, moves: list[list[Any]]
) -> list[str]:
    """Return the elements of items; what moves is noted with the numbers of its attributes."""
    elements = []
    for mark in (mark for item in items for mark in item.marks):
        motion, element = _inked(mark, inker, outputs)
        if motion and element:
            moves.append(motion)
            if motion[0] in _LINES and len(motion) == 2:
                element = element.replace("<path", f"<{_LINES[motion[0]]}")
            element = attributed(element, " data-m")
        if element:
            elements.append(element)
    return elements


def _inked(mark: Mark, inker: Inker, outputs: Outputs) -> tuple[list[Any] | None, str]:
    """Return how a mark moves, and its element; what is set at once is left out of that."""
    shape: Any = mark.shape
    values = {each.name: plain(getattr(shape, each.name)) for each in fields(shape)}
    motion = _motion(shape, outputs)
    element = inker.mark(replace(mark, shape=type(shape)(**values)))
    return motion, _SET.sub("", element) if motion and motion[0] != "t" else element


def _motion(shape: Outline, outputs: Outputs) -> list[Any] | None:
    """Return how a shape moves: a letter, and the numbers of what it is made of; None if it rests.

    "l" and "a" are open and closed lines, "c" a circle, "b" an arc, "t" a text.
    """
    match shape:
        case Polyline(pieces) if _traced(z for piece in pieces for z in piece):
            return ["l", *map(outputs.listed, pieces)]
        case Polygon(rings) if _traced(z for ring in rings for z in ring):
            return ["a", *map(outputs.listed, rings)]
        case Disc(centre, _) if _traced([centre]):
            return ["c", outputs.place(centre)]
        case Bow(centre, radius, start, sweep, axis, narrow):
            if _traced([centre, vector(start, sweep), vector(radius, narrow), axis]):
                round_ = not isinstance(narrow, Traced) and narrow == 1.0
                squeezed = [] if round_ else [*outputs.place(axis), outputs.of(narrow)]
                ends = [outputs.of(each) for each in (radius, start, sweep)]
                return ["b", [*outputs.place(centre), *ends, *squeezed]]
        case Lettering(at=at) if _traced([at]):
            return ["t", outputs.place(at), [round(at.real, 6), round(at.imag, 6)]]
    return None


def _rounded(z: complex) -> complex:
    """Return a place that rests with no more digits than labels need."""
    return z if _traced([z]) else vector(round(float(z.real), 5), round(float(z.imag), 5))


def _traced(places: Iterable[complex]) -> bool:
    return any(isinstance(part, Traced) for z in places for part in (z.real, z.imag))


def _wish(label: Label, near: int, outputs: Outputs) -> list[Any]:
    """Return a label as the script reads it.

    That is: whether it names a dot, half its size, its place, the number of its distances, how it
    would best stand, and where it vanishes.  The value of an angle follows.
    """
    half = [round(label.wide / 2, 5), round(label.high / 2, 5)]
    found = [int(label.role == "letter"), *half, outputs.place(label.at), near]
    found += [round(cmath.phase(label.way), 3), outputs.listed(label.apart)]
    return found if label.value is None else [*found, outputs.of(label.value)]


def _described(
    board: HandBoard, sheet: Sheet, outputs: Outputs, write: Callable[[Runs], str]
) -> dict[str, Any]:
    """Return what the page tells of the mechanism, and of what drives it."""
    traced, code = board.traced, Language(sheet.language)
    found = traced.motion.to_dict()
    if traced.forces:
        found["forces"] = traced.forces.to_dict()
    closes, rates = proofs(found)
    place, *_ = names = list(board.mechanism.inputs)
    scene = traced.scene
    slides, key = scene.driver.kind != "angle", scene.driver.name
    kind, length = "slide", board.mechanism.length_unit
    units = [length, f"{length}/s", f"{length}/s²"]
    if place == "angle":
        kind = "crank" if sheet.driver.row == "crank" else "link"
        units = ["°", "rad/s", "rad/s²"]
    said = {"crank": "turn-crank", "link": "turn-link", "slide": "move-slide"}
    player = code.page("PLAYER")
    return {
        "own": [outputs.of(traced.inputs[name]) for name in names],
        "closes": [outputs.of(each) for each in closes],
        "rates": [outputs.of(each) for each in rates],
        "fastest": FASTEST,
        "solved": template(found, board.mechanism.parameters(), outputs.of),
        "dimensions": list(dimensions(board, names)),
        "names": {
            name: parameter_name(type(board.mechanism), name, Language(sheet.language, sheet.names))
            for name in board.mechanism.dimensions()
        },
        "turns": kind,
        "turn": said[kind],
        "symbols": [write(symbols(scene.cells(order, key, slides)[0].symbol)) for order in ORDERS],
        "units": units,
        "readable": readable(length),
        "panels": [panel.title for panel in sheet.panels],
        "point": code.point,
        "words": {**code.page("HAND"), "play": player["play"], "pause": player["pause"]},
    }


def _start(board: HandBoard, plan: Plan) -> list[float]:
    """Return the inputs of the page's own pose, and its scales."""
    given = dict(plan.sheet.source.inputs) if plan.sheet.source else {}
    given |= board.mechanism.dimensions()
    for name, sketch in plan.sketches.items():
        if not sketch.scale.bare:
            given |= scale_inputs(name, sketch.scale)
    return [float(given.get(name, value)) for name, value in board.traced.inputs.items()]


def _cells(board: HandBoard, sheet: Sheet, outputs: Outputs) -> list[list[Any]]:
    """Return the values of the table that change: where they stand, and how they are written."""
    notation, found = sheet.notation, []
    for row, own in zip(board.traced.sheet.rows, sheet.rows, strict=True):
        for column, panel in enumerate(sheet.panels):
            cells = zip(row.cells.get(panel.name, ()), own.cells.get(panel.name, ()), strict=False)
            for place, (cell, shown) in enumerate(cells):
                if cell.unit != shown.unit or not isinstance(cell.value, Traced):
                    continue
                factor, unit = notation.cell_unit(shown.value, cell.unit, shown.given)
                index = sheet.rows.index(own)
                value = _as_given(cell.value, board) if cell.given else cell.value
                how = outputs.of(value), factor, unit, int(shown.given)
                found.append([index, column, place, *how])
    return found


def _as_given(value: float, board: HandBoard) -> float:
    """Return the input of which a value is a copy, so that it has the input's output."""
    inputs = (board.traced.inputs[name] for name in board.mechanism.inputs)
    return next((each for each in inputs if float(each) == float(value)), value)
