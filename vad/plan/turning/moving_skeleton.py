"""The mechanism in motion: supports that stand still, and bars, blocks and slots that move.

In come the poses of a turn, out go a sketch of what stands still, and the sketch of any pose.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from vad.plan.carriers import is_yoke
from vad.plan.items import Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.vertices import find_vertices
from vad.plan.pictures import machine
from vad.plan.pictures.guides import Rail, add_guide, blocks_on, poles
from vad.plan.pictures.sizes import part_size
from vad.plan.pictures.skeleton import add_stroke, joints, painting_order
from vad.plan.pictures.supports import WAYS, add_axes, block_pivot, fixed_points
from vad.plan.scale import Scale
from vad.plan.sketch import Setting, Sketch
from vad.plan.turning.dimension import add_dimension
from vad.strokes.sheet import Arrow, Block, Guide, Panel, Plate, Stroke

PAST = 0.014  # by which guides are longer than their block's way


@dataclass(frozen=True, slots=True)
class Stands:
    """What is chosen once for all poses, by the names of the strokes.

    Attributes
    ----------
    feet
        Where each fixed pivot points.
    rails
        The side of each guide of the frame, as seen along it, and how far its blocks get, in the
        panel's unit.
    """

    feet: Mapping[str, complex] = field(default_factory=dict)
    rails: Mapping[str, tuple[complex, float, float]] = field(default_factory=dict)


class MovingSkeleton:
    """The mechanism of a turn.

    ``angle`` says whether the axis of its angle is drawn, ``stands`` what is chosen already.

    Attributes
    ----------
    still
        What stands still.
    stands
        What is chosen.
    obstacles
        What stands in each of the poses over which it is chosen.
    size, radius
        That of all parts, and of its joints.
    """

    def __init__(
        self,
        setting: Setting,
        poses: Sequence[Panel],
        scale: Scale,
        angle: bool = False,
        stands: Stands = Stands(),
    ) -> None:
        self._setting, self._angle = setting, angle
        self.scale = scale
        self.size = part_size(setting.panel, scale)
        self.radius = machine.JOINT_REACH * self.size
        frame = tuple(s for s in poses[0].strokes if angle or s.kind != "angle")
        first = replace(setting, panel=replace(poses[0], strokes=frame))
        self.still = Sketch(first, scale, Obstacles(setting.room))
        add_axes(self.still, [])
        guides = [s for s in frame if isinstance(s.shape, Guide) and s.shape.side is not None]
        rails = {each.name: self._travel(poses, each.name, stands.rails) for each in guides}
        self._ways = [self._guide(stroke, *rails[stroke.name]) for stroke in guides]
        points = {frame[index].name: scale(point) for index, point in fixed_points(first.panel)}
        new = [name for name in points if name not in stands.feet]
        unchosen = new or stands == Stands()
        self.obstacles = [self.pose(pose).obstacles for pose in poses] if unchosen else []
        feet = {**stands.feet, **{name: self._foot(points[name]) for name in new}}
        for name, at in points.items():
            self.still.add(None, Level.GROUND, 0, machine.pivot(at, feet[name], self.size, 1.0))
            for each in (self.still.obstacles, *self.obstacles):
                block_pivot(each, at, feet[name], self.size)
        self.stands = Stands(feet, rails)

    def resized(self, setting: Setting, scale: Scale) -> MovingSkeleton:
        """Return the same mechanism with other dimensions, which stands as it stood."""
        return MovingSkeleton(setting, [setting.panel], scale, self._angle, self.stands)

    def add_dimensions(self) -> None:
        """Write along each guide of the frame how far its block gets."""
        for start, end, side in self._ways:
            add_dimension(self.still, start, end, side, self.obstacles)

    def pose(self, panel: Panel) -> Sketch:
        """Return what moves, in one pose; its obstacles hold what stands still, too."""
        setting = replace(self._setting, panel=panel)
        obstacles = Obstacles(setting.room, list(self.still.obstacles.lines))
        sketch = Sketch(setting, self.scale, obstacles)
        for index in painting_order(panel):
            shape = panel.strokes[index].shape
            if isinstance(shape, Arrow | Block | Plate) or (
                isinstance(shape, Guide) and not shape.side
            ):
                add_stroke(sketch, index)
        vertices = find_vertices(panel, self.scale)
        for vertex, mark in zip(vertices, joints(vertices, panel, self.size), strict=True):
            sketch.add(None, Level.DOT, 0, [mark])
            obstacles.disc(vertex.at, self.radius)
        return sketch

    def _foot(self, at: complex) -> complex:
        """Return where a fixed pivot meets the fewest strokes."""
        deep, half = machine.PIVOT_HEIGHT * self.size, machine.PIVOT_GROUND * self.size

        def met(way: complex) -> int:
            size = (2 * half, deep) if way.imag else (deep, 2 * half)
            spot = at + way * 0.7 * deep
            return sum(not pose.free([spot], *size, 0.0)[0] for pose in self.obstacles)

        return min(WAYS, key=met)

    def _along(self, pose: Panel, name: str) -> list[float]:
        """Return how far along a guide its blocks stand in a pose, in the panel's unit."""
        guide = pose.strokes[pose.number(name)].shape
        assert isinstance(guide, Guide)
        through, way = self.scale(guide.through), guide.direction
        sketch = Sketch(replace(self._setting, panel=pose), self.scale, self.still.obstacles)
        return [
            ((spot - through) * way.conjugate()).real / self.scale.factor
            for spot in blocks_on(sketch, through, way)
        ]

    def _travel(
        self,
        poses: Sequence[Panel],
        name: str,
        before: Mapping[str, tuple[complex, float, float]],
    ) -> tuple[complex, float, float]:
        """Return the side of a guide, and how far along it its blocks get, at least as before."""
        travel = [along for pose in poses for along in self._along(pose, name)]
        if name in before:
            across, *ends = before[name]
            return across, min(travel + ends), max(travel + ends)
        guides = [pose.strokes[pose.number(name)].shape for pose in poses]
        sides = [guide.side for guide in guides if isinstance(guide, Guide)]
        shape = guides[0]
        assert isinstance(shape, Guide)
        side = max(sides, key=sides.count) or 0j
        return side / shape.direction, min(travel), max(travel)

    def _guide(
        self, stroke: Stroke, across: complex, low: float, high: float
    ) -> tuple[complex, complex, complex]:
        """Add a guide of the frame; return both ends of its block's way, and its side."""
        shape = stroke.shape
        assert isinstance(shape, Guide)
        through, way = self.scale(shape.through), shape.direction
        side, first, last = across * way, low * self.scale.factor, high * self.scale.factor
        panel = self.still.setting.panel
        if is_yoke(panel, stroke.link):
            add_guide(self.still, panel.number(stroke.name), shape)
        else:
            self._rail(through, way, side, (first, last))
        return through + first * way, through + last * way, side

    def _rail(
        self, through: complex, way: complex, side: complex, travel: tuple[float, float]
    ) -> None:
        """Add a ground line as long as its block's way."""
        foot = through + side * (machine.BLOCK[1] / 2 * self.size)
        low, high = self._setting.room.stretch(foot, way, 0.010)
        past = machine.BLOCK[0] / 2 * self.size + PAST
        first, last = max(travel[0] - past, low), min(travel[1] + past, high)
        ends = min(0.0, first), max(0.0, last)
        axis = (through + ends[0] * way, through + ends[1] * way) if poles(self.still) else None
        rail = Rail(foot + first * way, foot + last * way, side, axis, self.size)
        self.still.add(None, Level.GROUND, 0, rail.marks())
        rail.block(self.still.obstacles)
