"""An output point of a turn: its path, its velocity and its acceleration, and when it stands.

A foot is a point that stays near the lowest place of its path for a good part of the turn.  While
it does so it is in stance, and else in swing; the cycle then begins at touch-down.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from vad.errors import UsageError, one_of
from vad.strokes.diagram import ACCELERATION, ORDERS, POSITION, VELOCITY, Spot, in_plane
from vad.strokes.scene import image_letter
from vad.strokes.shapes import Arrow
from vad.strokes.sheet import Panel, Sheet, Stroke, StrokePart
from vad.written import LOW

if TYPE_CHECKING:
    from vad.lecture.turn import Turn
    from vad.strokes.scene import Scene

#: What is given instead of a point where no point is to be followed.
ALL = "all"
#: Height below which a foot stands, as a share of its lift; the least part of a turn.
STANDS, LEAST_STANCE = 0.06, 0.25
#: A leg has two loops at least: of a four-bar, such a point is to draw a straight line.
LOOPS_OF_LEGS = 2
#: The symbols of its rates, and the length of the largest of each in the size of the mechanism.
RATES, LONGEST = ("v", "a"), 0.33
#: A point moves if its path is larger than this share of the mechanism.
_MOVES = 1e-9
#: The panels in which it is followed.
PANELS = tuple(order.panel for order in ORDERS)

Reals = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Stance:
    """When a foot stands.

    Attributes
    ----------
    touch_down
        The share of the course's cycle at which it begins.
    part
        The share of the turn that it lasts.
    lift
        The height of the path.
    lowest
        The height of the ground.
    """

    touch_down: float
    part: float
    lift: float
    lowest: float


@dataclass(frozen=True, slots=True)
class Followed:
    """A point that is followed over a turn.

    Attributes
    ----------
    point
        Its letter.
    row
        The link or slide whose ink it has.
    stance
        When it stands, if it is a foot.
    lengths
        The length in the mechanism of a unit of its velocity, and of its acceleration.
    """

    point: str
    row: str
    stance: Stance | None = None
    lengths: tuple[float, float] = (0.0, 0.0)

    def image(self, panel: str) -> str:
        """Return its letter in a panel."""
        return image_letter(self.point, PANELS.index(panel))

    def tracks(self, panel: str, tracks: Mapping[Spot, Any]) -> dict[Spot, Any]:
        """Return the points of a panel: of a polygon the pole and the image of the point.

        In the mechanism the path of the point alone is drawn.
        """
        if panel not in PANELS:
            return dict(tracks)
        own, found = self.image(panel), {}
        for spot, way in tracks.items():
            if spot.letter == own:
                found[spot._replace(row=self.row)] = way
            elif panel == POSITION.panel:
                found[spot._replace(path="none")] = way
            elif not np.ptp(way):
                found[spot] = way
        return found

    def curve(self, scene: Scene, panel: str) -> tuple[str, str, Reals] | None:
        """Return what a panel measures of the point: symbol, unit and values; None for others.

        That of a foot is its height, its speed along the ground and the size of its acceleration;
        of another point the coordinate that changes most, and the sizes of both.
        """
        if panel not in PANELS:
            return None
        order = ORDERS[PANELS.index(panel)]
        at = np.asarray(scene.motion.point(self.point).position)
        value = np.asarray(getattr(scene.motion.point(self.point), panel))
        unit = scene.unit_of(order)
        index = f"_{self.point[0]}" + "".join(self.point[1:]).translate(LOW)
        if order is POSITION:
            upright = self.stance is not None or np.ptp(at.imag) > np.ptp(at.real)
            values = value.imag - (self.stance.lowest if self.stance else 0.0)
            return ("y" if upright else "x") + index, unit, values if upright else value.real
        if order is VELOCITY and self.stance:
            return f"v{index}ₓ", unit, value.real
        return ("v" if order is VELOCITY else "a") + index, unit, np.abs(value)

    def shown(self, sheet: Sheet) -> Sheet:
        """Return a sheet of which the polygons show the vector of the point alone.

        In the mechanism the arrows of its velocity and acceleration begin at the point.
        """
        arrows = tuple(self._arrows(sheet))
        panels = (
            replace(panel, strokes=(*panel.strokes, *arrows))
            if panel.name == POSITION.panel
            else self._shown(panel)
            for panel in sheet.panels
        )
        return replace(sheet, panels=tuple(panels))

    def _arrows(self, sheet: Sheet) -> Iterator[Stroke]:
        """Yield the arrows at the point, of the rates whose polygons are on the sheet."""
        ways = {panel.name: (*panel.strokes, *panel.zeros) for panel in sheet.panels}
        at = place_of(ways.get(POSITION.panel, ()), self.point)
        for order, symbol, length in zip(ORDERS[1:], RATES, self.lengths, strict=True):
            rate = place_of(ways.get(order.panel, ()), self.image(order.panel))
            if at is not None and rate:
                yield Stroke(
                    "result",
                    symbol,
                    Arrow(at, at + length * rate, self.point, ""),
                    "",
                    link=self.row,
                    component="absolute",
                    part=StrokePart(self.point, order.panel),
                )

    def _shown(self, panel: Panel) -> Panel:
        if panel.name not in (VELOCITY.panel, ACCELERATION.panel):
            return panel
        strokes = (*panel.strokes, *panel.zeros)
        pole = next((stroke for stroke in strokes if stroke.kind == "pole"), None)
        end = place_of(strokes, self.image(panel.name))
        if pole is None or end is None:
            return panel
        tail, head = pole.label.split(",")[0].strip(), self.image(panel.name)
        arrow = Stroke(
            "result",
            tail + head,
            Arrow(0j, end, tail, head),
            "",
            link=self.row,
            component="absolute",
            part=StrokePart(self.point, "followed"),
        )
        drawn = (pole, arrow) if abs(end) else (pole,)
        return Panel(
            panel.name,
            panel.unit,
            drawn,
            zeros=() if abs(end) else (arrow,),
            title=panel.title,
        )


def place_of(strokes: Sequence[Stroke], letter: str) -> complex | None:
    """Return where the strokes of a polygon have a letter."""
    for stroke in strokes:
        shape: Any = stroke.shape
        if isinstance(shape, Arrow):
            if shape.head == letter:
                return shape.end
            if shape.tail == letter:
                return shape.start
        elif hasattr(shape, "at") and letter in map(str.strip, stroke.label.split(",")):
            return complex(shape.at)
    return None


def followed(turn: Turn, point: str | None) -> Followed | None:
    """Return the point that a turn follows; None where it follows none.

    Parameters
    ----------
    turn
        The turn, which follows none yet.
    point
        The point; `ALL` for none.  If it is None, the point that the mechanism's file names, else
        the foot of a leg: a point that one link alone has, of two loops without a slide as output.

    Raises
    ------
    vad.errors.UsageError
        For a point that the mechanism does not have, or that stands still; where no panel shows it.
    """
    from vad.lecture.cycle import whole_turn

    if isinstance(point, str) and point == ALL:
        return None
    if point is None and not set(turn.panels) <= set(PANELS):
        return None
    scene: Any = whole_turn(turn)
    if not in_plane(scene.motion):
        if point is None:
            return None
        raise UsageError("follow: points are followed in the plane alone")
    if point is not None:
        one_of("follow", point, [*scene.motion.points, ALL])
        if not set(turn.panels) & set(PANELS):
            raise UsageError("follow: no panel shows a point", f"add one of {', '.join(PANELS)}")
        if not _moves(scene, point):
            moving = [each for each in scene.motion.points if _moves(scene, each)]
            raise UsageError(
                f"follow: {point} stands still", f"points that move: {', '.join(moving)}"
            )
        return _followed(turn, scene, point)
    own = turn.mechanism.output_point
    if own:
        return _followed(turn, scene, own) if _moves(scene, own) else None
    if scene.output in scene.motion.slides or len(scene.motion.linkage.loops) < LOOPS_OF_LEGS:
        return None
    for each in reversed(scene.motion.points):
        if len(_links_with(scene, each)) == 1 and _moves(scene, each):
            found = _followed(turn, scene, each)
            if found.stance and found.row != scene.driver.name:
                return found
    return None


def _links_with(scene: Scene, point: str) -> list[str]:
    """Return the links on which a point keeps its place; none for one that slides."""
    if point in scene.members.fixed or point in scene.motion.mechanism.slides.values():
        return []
    return [link for link in scene.motion.links if point in scene.members.points_on(link)]


def _moves(scene: Scene, point: str) -> bool:
    at = np.asarray(scene.motion.point(point).position)
    least = _MOVES * _size(scene)
    return bool(np.ptp(at[np.isfinite(at)]) and np.nanmax(np.abs(at - at.flat[0])) > least)


def _size(scene: Scene) -> float:
    """Return how far the points of a mechanism get from the first one."""
    every = [np.asarray(scene.motion.point(each).position) for each in scene.motion.points]
    return max(float(np.nanmax(np.abs(each - every[0]))) for each in every)


def _followed(turn: Turn, scene: Scene, point: str) -> Followed:
    """Return the point with its row: the last link that has it, but not the driver if it can be."""
    driver = scene.driver.name
    links = [each for each in scene.motion.links if point in scene.members.points_on(each)]
    slides = [name for name, at in scene.motion.mechanism.slides.items() if at == point]
    rows = [each for each in (*slides, *links) if each != driver]
    height = np.asarray(scene.motion.point(point).position).imag
    stance = _stance(height) if turn.course.swing is None else None
    rates = (getattr(scene.motion.point(point), order.panel) for order in ORDERS[1:])
    largest = (float(np.nanmax(np.abs(rate))) for rate in rates)
    velocity, acceleration = (LONGEST * _size(scene) / each if each else 0.0 for each in largest)
    return Followed(point, (rows or [driver])[-1], stance, (velocity, acceleration))


def _stance(height: Reals) -> Stance | None:
    """Return when a point stands: low in one run, for a good part of the turn."""
    height = height[:-1]
    if not np.isfinite(height).all():
        return None
    low, lift = float(height.min()), float(np.ptp(height))
    below = height < low + STANDS * lift
    begins = np.flatnonzero(below & ~np.roll(below, 1))
    if len(begins) != 1 or below.mean() < LEAST_STANCE:
        return None
    first, edge, count = int(begins[0]), low + STANDS * lift, len(height)
    before, here = float(height[first - 1]), float(height[first])
    down = (first - 1 + (before - edge) / (before - here)) / count
    last = (first + int(below.sum()) - 1) % count
    here, after = float(height[last]), float(height[(last + 1) % count])
    up = (last + (edge - here) / (after - here)) / count
    return Stance(math.fmod(down + 1.0, 1.0), (up - down) % 1.0, lift, low)
