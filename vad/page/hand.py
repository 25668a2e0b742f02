"""A mechanism that is turned on a page: what is drawn of it, and the program that moves it.

A page carries, for each panel, what a hand moves as SVG, and the numbers of its attributes as
outputs of one program (`vad.page.solver`).  The script ``hand.js`` plays that program.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, fields, replace
from itertools import groupby
from typing import Any

from vad.kinematics.numbers import vector
from vad.kinematics.reach import closing_range
from vad.kinematics.traced import Traced, plain
from vad.lecture.moment import drawing
from vad.page.curves import curves
from vad.page.ink import Inker, when
from vad.page.solved import given, proofs, template
from vad.page.solver import solver_data
from vad.painting.svg_elements import number
from vad.plan.hand_board import HandBoard, Label
from vad.plan.items import FOREVER, Item, in_painting_order
from vad.plan.labels.vertices import text_at
from vad.plan.lettering.runs import Runs, symbols
from vad.plan.marks import Bow, Disc, Lettering, Outline, Polygon, Polyline
from vad.plan.pictures.skeleton import GRIP
from vad.strokes.sheet import Sheet
from vad.words import Language


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


class Outputs:
    """The outputs of a program, each once, in the order in which they were first asked for."""

    def __init__(self) -> None:
        self.numbers: list[float] = []
        self._places: dict[str, int] = {}

    def of(self, value: float) -> int:
        """Return the number of an output."""
        key = value.made.name if isinstance(value, Traced) else repr(float(value))
        if key not in self._places:
            self._places[key] = len(self.numbers)
            self.numbers.append(value)
        return self._places[key]

    def place(self, z: complex) -> list[int]:
        """Return the numbers of x and y."""
        return [self.of(z.real), self.of(z.imag)]

    def listed(self, places: Iterable[complex]) -> list[int]:
        """Return the numbers of x and y of several places."""
        return [each for z in places for each in self.place(z)]


def hand(board: HandBoard, sheet: Sheet, inker: Inker, write: Callable[[Runs], str]) -> Hand:
    """Return a mechanism that is turned on the page of a sheet.

    Parameters
    ----------
    board
        The mechanism.
    sheet
        The sheet of the page: in its pose the mechanism stands first.
    inker
        The inker of the page.
    write
        The function that writes runs as HTML.
    """
    outputs, traced = Outputs(), board.traced
    layers: dict[str, str] = {}
    moves: list[list[Any]] = []
    moving = [item for sketch in board.sketches.values() for item in sketch.items]
    regions = [panel.name for panel in traced.sheet.panels]
    begun = Begun(sheet)
    for region in regions:
        shown = [item for item in (*board.still, *moving) if item.region == region]
        layers[region] = "".join(
            f"<g{begun.of(*named)}>{_layer(items, inker, outputs, moves)}</g>"
            for named, items in groupby(
                in_painting_order(shown, regions), key=lambda item: _named(item.stroke, region)
            )
        )
    labels = []
    for label in board.labels:
        column = traced.sheet.panel(label.panel).column
        element = inker.mark(text_at(label.runs, label.runs, 0j, label.size, label.role, label.row))
        since = begun.of(label.panel, label.stroke)
        layers[column] += f'<g class="label"{since}>{element}</g>'
        labels.append([regions.index(column), *_wish(label, outputs)])
    blocks = [
        [regions.index(sketch.setting.panel.column), *outputs.listed((start, end)), round(half, 5)]
        for sketch in board.sketches.values()
        for start, end, half, _ in sketch.obstacles.lines
    ]
    grip, ring = board.grip, ""
    if grip:
        radius = number(GRIP * inker.frame[0])
        place = f'cx="0" cy="0" r="{radius}" data-vad-grip'
        since = begun.of(regions[0], traced.sheet.driver.stroke)
        ring = f'<g class="grip"{since}><circle class="ring" {place}/></g>'
    data = {
        "inputs": list(traced.inputs),
        "start": _start(board, sheet),
        "grip": grip
        and {
            "kind": grip.kind,
            "at": outputs.place(grip.at),
            "about": outputs.place(grip.about),
            "way": [grip.way.real, -grip.way.imag],
            "factor": float(grip.factor),
        },
        "ranges": closing_range(board.mechanism),
        "moves": moves,
        "labels": labels,
        "blocks": blocks,
        "rooms": [_room(board, panel) for panel in regions],
        "cells": _cells(board, sheet, outputs),
        "page": inker.frame,
    }
    layers = {region: f'<g class="hand">{layer}</g>' for region, layer in layers.items()}
    layers[regions[0]] += ring
    data |= _described(board, sheet, outputs, write)
    data["curves"] = curves(board, sheet, outputs.of)
    program = traced.program(outputs.numbers)
    data["size"] = len(outputs.numbers)
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

    def of(self, panel: str, stroke: str) -> str:
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


def _layer(items: Iterable[Item], inker: Inker, outputs: Outputs, moves: list[list[Any]]) -> str:
    """Return the elements of items; what moves is noted with the numbers of its attributes."""
    text = ""
    for mark in (mark for item in items for mark in item.marks):
        shape: Any = mark.shape
        values = {each.name: plain(getattr(shape, each.name)) for each in fields(shape)}
        element = inker.mark(replace(mark, shape=type(shape)(**values)))
        motion = _motion(shape, outputs)
        if motion and element:
            moves.append(motion)
            element = (
                f"<g data-m>{element}</g>"
                if element.count("<") > 1
                else element.replace(" ", " data-m ", 1)
            )
        text += element
    return text


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


def _traced(places: Iterable[complex]) -> bool:
    return any(isinstance(part, Traced) for z in places for part in (z.real, z.imag))


def _wish(label: Label, outputs: Outputs) -> list[Any]:
    """Return a label as the script reads it: its name, half its size, its place, how to stand."""
    half = [round(label.wide / 2, 5), round(label.high / 2, 5)]
    way = [round(label.way.real, 4), round(label.way.imag, 4)]
    near = [round(gap + label.radius, 5) for gap in label.near]
    return [label.name, half, outputs.place(label.at), near, way]


def _described(
    board: HandBoard, sheet: Sheet, outputs: Outputs, write: Callable[[Runs], str]
) -> dict[str, Any]:
    """Return what the page tells of the mechanism, and of what drives it."""
    traced, code = board.traced, Language(sheet.language)
    found = traced.motion.to_dict()
    closes, rates = proofs(found)
    place, *_ = names = list(board.mechanism.inputs)
    cells = {cell.unit: cell for cell in given(sheet)}
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
        "solved": template(found, board.mechanism.parameters(), outputs.of),
        "dimensions": [],
        "turns": kind,
        "turn": said[kind],
        "symbols": [
            write(symbols(cells[unit].symbol)) if unit in cells else name
            for name, unit in zip(names, units, strict=True)
        ],
        "units": units,
        "panels": [panel.title for panel in sheet.panels],
        "point": code.point,
        "words": {**code.page("HAND"), "play": player["play"], "pause": player["pause"]},
    }


def _start(board: HandBoard, sheet: Sheet) -> list[float]:
    """Return the inputs of the page's own pose."""
    given = dict(sheet.source.inputs) if sheet.source else {}
    return [float(given.get(name, value)) for name, value in board.traced.inputs.items()]


def _room(board: HandBoard, panel: str) -> list[float]:
    room = board.live.page.panels[panel].drawing
    return [round(each, 5) for each in (room.left, room.bottom, room.right, room.top)]


def _cells(board: HandBoard, sheet: Sheet, outputs: Outputs) -> list[list[Any]]:
    """Return the values of the table that change: where they stand, and how they are written."""
    notation, found = sheet.notation, []
    for row, own in zip(board.traced.sheet.rows, sheet.rows, strict=True):
        for column, panel in enumerate(sheet.panels):
            cells = zip(row.cells.get(panel.name, ()), own.cells.get(panel.name, ()), strict=False)
            for place, (cell, shown) in enumerate(cells):
                if cell.symbol != shown.symbol or not isinstance(cell.value, Traced):
                    continue
                unit = notation.unit(cell.unit)
                factor = notation.scaled(1.0, cell.unit)
                index = sheet.rows.index(own)
                value = _as_given(cell.value, board) if cell.given else cell.value
                found.append([index, column, place, outputs.of(value), factor, unit])
    return found


def _as_given(value: float, board: HandBoard) -> float:
    """Return the input of which a value is a copy, so that it has the input's output."""
    inputs = (board.traced.inputs[name] for name in board.mechanism.inputs)
    return next((each for each in inputs if float(each) == float(value)), value)
