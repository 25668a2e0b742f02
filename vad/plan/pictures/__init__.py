"""The pictures in the panels: a skeleton, vectors tip to tail, or views of a mechanism in space.

Each is one picture in different poses: a still or a lesson has one pose; a turn, or a mechanism
that is turned by hand, has many.  Its marks state their anchors (`vad.plan.anchors`).  How its
scale is found is chosen (`vad.plan.scale`), and so is the placement of its labels
(`vad.plan.labels.choices`, `vad.plan.labels.springs`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Protocol, TypeVar

from vad.plan.geometry import Rect
from vad.plan.labels.choices import PLACED, LabelChoice, MovingLabels
from vad.plan.labels.close import has_close
from vad.plan.pictures import polygon
from vad.plan.pictures.lensed import with_lenses
from vad.plan.pictures.skeleton import Skeleton, angle_centre
from vad.plan.pictures.supports import add_dimension
from vad.plan.pictures.views import Views
from vad.plan.reach import corners
from vad.plan.scale import SLACK, Scale, calm_scale, fill, mechanism_scale, views_scale
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Panel


class Picture(Protocol):
    """A panel at one scale: what stands still in all poses, and what moves in any of them.

    Attributes
    ----------
    scale
        That of all poses.
    radius
        That of the dots at its lettered points.
    """

    scale: Scale
    radius: float

    @property
    def still(self) -> Sketch:
        """What stands still."""

    def draw(self, labels: LabelChoice = PLACED) -> Sketch:
        """Return all that a lesson shows of its one pose; the finished part is a still."""

    def pose(self, panel: Panel) -> Sketch:
        """Return what moves, in one pose: a frame of a turn, without its labels."""

    def under_hand(self, setting: Setting, labels: MovingLabels) -> Sketch:
        """Return what moves, in one pose that a hand has set, with its labels."""


#: Farther from its place, a note would seem to belong to another view.  Until none does, views are
#: drawn smaller, and in the middle of their panel, to the left, or to the right.
STRAY = 0.16
SIZES = tuple((share, side) for share in (1.0, 0.92, 0.85, 0.78) for side in (0.0, -1.0, 1.0))


Drawn = TypeVar("Drawn", Sketch, Views)


def sketched(setting: Setting) -> Sketch:
    """Return all that a lesson shows of a panel; the finished part is a still."""
    panel, scale = setting.panel, setting.scale

    def skeleton(room: Rect, labels: LabelChoice) -> Sketch:
        usual = fill(corners(panel), room, True, setting.centimetre)
        return Skeleton(setting, [panel], scale or usual).draw(labels)

    match panel.picture:
        case "skeleton":
            return with_lenses(setting, skeleton)
        case "views":
            return _views(setting)
        case "vectors":
            return polygon.draw(setting)


def _views(setting: Setting) -> Sketch:
    """Return the views of one pose, smaller if their notes have no room beside them.

    Where points cannot be told apart there is a lens, if it has room.
    """
    panel, room = setting.panel, setting.room
    usual = setting.scale or views_scale(setting, [panel])
    fixed = setting.scale or setting.centimetre
    others = () if fixed else _smaller(usual, room)
    best = _roomiest(lambda each: Views(setting, [panel], each).draw(), usual, others)
    if not (setting.lenses and has_close(setting, best.vertices)):
        return best
    scale = best.scale

    def lensed(part: Rect, labels: LabelChoice) -> Sketch | None:
        own = scale if part == room else views_scale(replace(setting, room=part), [panel])
        sketch = Views(setting, [panel], own).draw(labels)
        return sketch if not sketch.lenses or sketch.astray <= max(STRAY, best.astray) else None

    return with_lenses(setting, lensed)


def _smaller(scale: Scale, room: Rect) -> Iterator[Scale]:
    """Yield smaller scales, each with the picture in the middle and at both sides of its room."""
    for share, side in SIZES:
        yield scale.smaller(share, room.centre + side * room.width / 2)


def _roomiest(draw: Callable[[Scale], Drawn], usual: Scale, others: Iterable[Scale]) -> Drawn:
    """Return views at their usual scale, or at that of the others at which notes have room."""
    best = draw(usual)
    for scale in others:
        if best.astray <= STRAY:
            break
        best = min(best, draw(scale), key=lambda each: each.astray)
    return best


def over_turn(setting: Setting, poses: Sequence[Panel]) -> Picture:
    """Return the picture of a panel over a whole turn, at one scale for all of its poses."""
    match setting.panel.picture:
        case "skeleton":
            room = setting.room
            wider = replace(room, left=room.left - SLACK, right=room.right + SLACK)
            scale = mechanism_scale(replace(setting, room=wider), poses)
            skeleton = Skeleton(setting, poses, scale, angle=False)
            for travel in skeleton.travels:
                add_dimension(skeleton.still, *travel, skeleton.crowds)
            return skeleton
        case "views":
            return Views(setting, poses, views_scale(setting, poses))
        case "vectors":
            return polygon.over_turn(setting, poses)


def over_reach(setting: Setting, poses: Sequence[Panel]) -> Skeleton | Views:
    """Return the picture of a mechanism for turning by hand, over the range of its driver."""
    scale = reach_scale(setting, poses)
    if setting.panel.picture == "views":
        others = _smaller(scale, setting.room)
        return _roomiest(lambda each: Views(setting, poses, each), scale, others)
    centres = {angle_centre(pose) for pose in poses} - {None}
    return Skeleton(setting, poses, scale, angle=len(centres) == 1)


def reach_scale(setting: Setting, poses: Sequence[Panel]) -> Scale:
    """Return the scale of a mechanism at which all its poses fit its room."""
    views = setting.panel.picture == "views"
    return (views_scale if views else mechanism_scale)(setting, poses)


def resized(picture: Skeleton | Views, setting: Setting, before: Scale | None) -> Skeleton | Views:
    """Return a mechanism with other dimensions; everything that stands still keeps its place.

    It keeps the scale of the pose before while it fits.
    """
    scale = calm_scale(setting.panel, setting.room, before or picture.scale)
    if isinstance(picture, Views):
        return Views(setting, [setting.panel], replace(scale, bare=True), picture)
    return Skeleton(setting, [setting.panel], scale, picture.angle, picture)
