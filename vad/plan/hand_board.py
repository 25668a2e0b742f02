"""The board of a mechanism that a hand turns: marks and labels that follow from the inputs.

One pose is drawn with traced numbers (`vad.strokes.traced_sheet`) and laid out with them, too.  So
each place on the page is known as a program of the driver's motion and of the scales of polygons,
which a player runs for every other pose.  Labels have no places yet: the player finds them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.errors import AssemblyError, VadError
from vad.kinematics.motion import solve
from vad.kinematics.reach import closing_range
from vad.kinematics.traced import TracedVector
from vad.lecture.poles import HandPoles, hand_poles
from vad.plan.format import Format
from vad.plan.items import Item
from vad.plan.labels.named import Label, NamedLabels
from vad.plan.live_board import LiveBoard
from vad.plan.pictures.lanes import ALONE
from vad.plan.pictures.polygon import Polygon
from vad.plan.pictures.shared_lines import SharedLine, shared_lines
from vad.plan.pictures.skeleton import Skeleton
from vad.plan.pictures.vectors import place_vectors
from vad.plan.pictures.views import held_arc, tip_of
from vad.plan.scale import Scale, calm_scale
from vad.plan.sketch import Sketch
from vad.strokes.draw import NO_PINS, parted, scene_of, sheet_of, with_forces
from vad.strokes.sheet import Arrow, Block, Sheet
from vad.strokes.traced_sheet import TracedSheet, nothing_held, traced_sheet
from vad.words import Language

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism
    from vad.statics.burden import Burden

#: In how many poses the mechanism is drawn to find out how much room it needs.
_POSES = 12
#: These poses lie closer together near the ends of a range, where links turn fastest: as evenly
#: spaced points of a half circle do when they are projected on its diameter.  The first and the
#: last point are this angle from the ends, in radians.
_END = 0.05
_TURN = (0.0, 360.0)
#: The first pose of a whole turn is this share of a step from 0°, where many poses are special.
_ASIDE = 0.37
#: The panels of forces.
OF_FORCES = {"force", "drive"}
#: Rates with which no vector vanishes.
_RATES = (1.0, 0.37)


@dataclass(frozen=True, slots=True)
class Grip:
    """The handle on the pin, strut or block that is driven, on the page.

    Attributes
    ----------
    kind
        An "angle" is measured at ``about``; a "length" from there; a "slide" along ``way`` from
        there.
    at, about
        Where it is, and the place from which it is measured: traced places.
    way
        The direction of a slide.
    factor
        The length on the page of a unit.
    """

    kind: str
    at: complex
    about: complex
    way: complex
    factor: float


@dataclass(frozen=True)
class HandBoard:
    """The page of a mechanism, with what moves as traced marks.

    Attributes
    ----------
    mechanism
        The mechanism.
    poses
        Its sheets over the whole range of the driver.
    live
        The page, and what stands still on it.
    traced
        The traced sheet.
    scales
        The scale of each panel; it is an input, but that of views of a sphere of radius 1.
    shared
        The lanes of the vectors of each polygon.
    sketches
        What moves in each panel.
    labels
        The labels of all panels.
    """

    mechanism: Mechanism
    poses: Sequence[Sheet]
    live: LiveBoard
    traced: TracedSheet
    scales: Mapping[str, Scale]
    shared: Mapping[str, Mapping[str, SharedLine]]
    sketches: Mapping[str, Sketch]
    labels: Sequence[Label]

    @property
    def grip(self) -> Grip | None:
        """The handle; None where what is driven is not drawn.

        In views it is at the end of the driven angle's arc, where that is seen in true size from
        the right on.
        """
        sheet = self.traced.sheet
        panel, driver = sheet.panels[0], sheet.driver
        scale = self.scales[panel.name]
        if panel.picture == "vectors":
            return None
        arc = held_arc(panel, driver)
        if arc:
            return Grip("angle", scale(tip_of(arc)), scale(arc.centre), 1.0 + 0j, scale.factor)
        index = panel.find(driver.stroke)
        shape = None if index is None else panel.strokes[index].shape
        if isinstance(shape, Arrow):
            kind = "angle" if driver.turns else "length"
            return Grip(kind, scale(shape.end), scale(shape.start), 1.0 + 0j, scale.factor)
        if not isinstance(shape, Block) or index is None:
            return None
        place = next(iter(self.mechanism.inputs))
        way = self._way(panel.strokes[index].label)
        position = self.traced.inputs[place]
        return Grip("slide", scale(shape.at), scale(shape.at - position * way), way, scale.factor)

    def _way(self, letter: str) -> complex:
        """Return the direction in which a driven point moves, as a unit vector."""
        place, rate, *_ = self.mechanism.inputs
        at = float(self.traced.inputs[place])
        moved = solve(self.mechanism, **{place: at, rate: 1.0})
        return complex(moved.point(letter).velocity)

    @property
    def still(self) -> list[Item]:
        """What stands still."""
        return [item for picture in self.live.pictures.values() for item in picture.still.items]


def hand_board(
    mechanism: Mechanism,
    panels: Sequence[str],
    language: str,
    form: Format,
    lines: int,
    burden: Burden | None = None,
    pins: Mapping[str, Any] = NO_PINS,
) -> HandBoard:
    """Return the board of a mechanism for all its poses.

    Parameters
    ----------
    mechanism
        The mechanism.
    panels
        The panels of its sheets.
    language
        Their language.
    form
        The shape of the page.
    lines
        How many lines there are for a caption.
    burden
        What it bears beside its own, if there are forces.
    pins
        The diameters of pins by their points.

    Raises
    ------
    vad.errors.AssemblyError
        If it closes nowhere.
    """
    inputs = poses_over_reach(mechanism)
    poles = hand_poles(mechanism, burden) if OF_FORCES & {*panels} else None
    sheets = list(_drawn(mechanism, inputs, panels, language, burden, poles, pins))
    if not sheets:
        raise AssemblyError("with these lengths the links close nowhere")
    poses = [sheet for _, sheet in sheets]
    live = LiveBoard.over(poses[0], form, lines, poses)
    general = min(sheets, key=lambda each: _specials(live, each[1]))[0]
    names = list(mechanism.dimensions())
    held = poles.traced if poles else nothing_held
    traced = traced_sheet(mechanism, general, panels, language, names, burden, held, pins)
    scales = {
        name: _as_input(traced, name, picture.scale)
        for name, picture in live.pictures.items()
        if isinstance(picture, Skeleton) or traced.sheet.panel(name).unit
    }
    live = live.retraced(traced.sheet, scales)
    shared: dict[str, Mapping[str, SharedLine]] = {}
    sketches: dict[str, Sketch] = {}
    labels: list[Label] = []
    for half in traced.sheet.halves:
        above = sketches.get(half.column)
        setting = live.setting(traced.sheet, half, above.obstacles if above else None)
        picture, named = live.pictures.get(half.name), NamedLabels(half.name)
        if picture:
            scales[half.name] = picture.scale
            sketches[half.name] = picture.under_hand(setting, named)
        else:
            panels_of = [sheet.panel(half.name) for _, sheet in sheets]
            posed = [(each, calm_scale(each, setting.room, None)) for each in panels_of]
            scales[half.name] = _as_input(traced, half.name, posed[0][1])
            polygon, shared[half.name] = Polygon(setting, scales[half.name]), shared_lines(posed)
            sketches[half.name] = polygon.under_hand(setting, named, shared[half.name])
        labels += named.found
    return HandBoard(mechanism, poses, live, traced, scales, shared, sketches, labels)


def poses_over_reach(mechanism: Mechanism) -> list[dict[str, float]]:
    """Return the inputs of poses over the whole range of the driver, with rates that are not 0."""
    place, *rates = mechanism.inputs
    ranges = closing_range(mechanism)
    found = []
    for low, high in ranges:
        count = max(2, _POSES // len(ranges))
        shares = 0.5 - 0.5 * np.cos(np.linspace(_END, math.pi - _END, count))
        if ranges == [_TURN]:
            shares = (np.arange(count) + _ASIDE) / count
        for share in shares.tolist():
            usual = [mechanism.inputs[rate] for rate in rates]
            size = max(map(abs, usual)) or 1.0
            moving = [rate or size * part for rate, part in zip(usual, _RATES, strict=True)]
            moving[1] = usual[1] or moving[0] ** 2 * _RATES[1]
            found.append(
                {place: low + share * (high - low), **dict(zip(rates, moving, strict=True))}
            )
    return found


def _drawn(
    mechanism: Mechanism,
    inputs: Sequence[dict[str, float]],
    panels: Sequence[str],
    language: str,
    burden: Burden | None,
    poles: HandPoles | None,
    pins: Mapping[str, Any],
) -> Iterator[tuple[dict[str, float], Sheet]]:
    """Yield those of the poses that can be drawn, with their sheets."""
    for given in inputs:
        try:
            motion, forces = parted(with_forces(solve(mechanism, **given), burden))
            held = poles.traced(given) if poles else {}
            scene = scene_of(motion, Language(language), forces, **held, pins=pins)
            yield given, sheet_of(scene, panels)
        except VadError:
            continue


def _specials(live: LiveBoard, sheet: Sheet) -> tuple[int, int]:
    """Count what makes a pose special: vertices that coincide, and vectors on one line."""
    vertices, on_a_line = 0, 0
    for half in sheet.halves:
        setting, labels = live.setting(sheet, half), NamedLabels(half.name)
        picture = live.pictures.get(half.name)
        if picture:
            picture.under_hand(setting, labels)
        else:
            scale = calm_scale(half, setting.room, None)
            sketch = Polygon(setting, scale).under_hand(setting, labels)
            on_a_line += sum(each.lane != ALONE for each in place_vectors(sketch).values())
        vertices += len(labels.found)
    return -vertices, on_a_line


def scale_inputs(panel: str, scale: Scale) -> dict[str, float]:
    """Return the three inputs that are the scale of a polygon, by their names."""
    x, y = scale.origin.real, scale.origin.imag
    return {f"{panel} x": x, f"{panel} y": y, f"{panel} scale": scale.factor}


def _as_input(traced: TracedSheet, panel: str, scale: Scale) -> Scale:
    """Return a scale whose origin and factor are inputs of the traced sheet."""
    x, y, factor = (traced.input(*each) for each in scale_inputs(panel, scale).items())
    return Scale(TracedVector(x, y), factor, scale.bare)
