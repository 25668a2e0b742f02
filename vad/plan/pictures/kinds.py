"""Which picture a panel is: in comes a panel in its setting, out goes its sketch."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from vad.plan.pictures import skeleton, vectors, views
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Picture

#: What draws a panel, by the picture that it says it is.
PICTURES: Mapping[Picture, Callable[[Setting], Sketch]] = {
    "skeleton": skeleton.draw,
    "vectors": vectors.draw,
    "views": views.draw,
}


def sketched(setting: Setting) -> Sketch:
    """Return the sketch of a panel."""
    return PICTURES[setting.panel.picture](setting)
