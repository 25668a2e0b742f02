"""The velocity or acceleration panel: vectors, construction lines, dots and letters.

In come a panel's strokes and its place, out goes a `PanelArt`.
"""

from __future__ import annotations

from vad.plan.arrows import add_vector, vector_growth
from vad.plan.art import FOREVER, Growth, Level, Look, PanelArt
from vad.plan.constructions import add_construction, line_growth, name_construction
from vad.plan.inset import Inset, add_inset, draw_inset, find_spot, reserved
from vad.plan.labels import ALWAYS, Obstacles
from vad.plan.marks import Mark, Pen, disc
from vad.plan.page import Rect
from vad.plan.scale import fill
from vad.plan.tags import SMALL_SIZE, add_tag
from vad.plan.vertices import corners, find_vertices, label_vertices
from vad.strokes.sheet import Arrow, Dot, Line, Panel

DOT = 0.0068
DOT_RIM = 0.0022
NEAR = (0.014, 0.020, 0.027)
INSET_SIZES = (1.0, 0.8, 0.64)


def draw_polygon(panel: Panel, drawing: Rect, look: Look, coriolis: str) -> PanelArt:
    """Return the art of a velocity or acceleration panel.

    ``coriolis`` is the sentence beneath the Coriolis inset.
    """
    art = _sketch(panel, drawing, drawing, look)
    if panel.inset:
        since = panel.number(panel.inset.stroke)
        insets = [draw_inset(panel.inset, since, coriolis, look, size) for size in INSET_SIZES]
        art = _with_inset(panel, drawing, look, insets, art)
    points = [vertex.at for vertex in find_vertices(panel, art.scale, look.unit)]
    for index, stroke in enumerate(panel.strokes):
        if isinstance(stroke.shape, Line):
            name_construction(art, panel, index, points, drawing, look)
    for index in range(len(panel.strokes)):
        art.growths.append(_growth(art, panel, index, points, drawing, look))
    return art


def _sketch(panel: Panel, drawing: Rect, room: Rect, look: Look) -> PanelArt:
    """Return a panel without what comes and goes, at the scale at which it fills ``room``."""
    scale = fill(corners(panel), room, look.unit, position=False, centimetre=look.centimetre)
    art = PanelArt(scale, Obstacles(drawing))
    for index, stroke in enumerate(panel.strokes):
        if isinstance(stroke.shape, Arrow):
            add_vector(art, panel, index, look)
        elif isinstance(stroke.shape, Line):
            add_construction(art, panel, index, drawing, look)
    vertices = find_vertices(panel, scale, look.unit)
    for vertex in vertices:
        since = min(vertex.since)
        art.add(Level.DOT, since, [dot(look, vertex.at)])
        art.obstacles.disc(vertex.at, (DOT + DOT_RIM) * look.unit, (since, FOREVER))
    label_vertices(art, vertices, art.obstacles, look, 0.0, NEAR)
    _name_coriolis(art, panel, look)
    return art


def _with_inset(
    panel: Panel, drawing: Rect, look: Look, insets: list[Inset], full: PanelArt
) -> PanelArt:
    """Return the largest drawing that leaves a corner free for an inset, with the inset in it.

    A smaller inset beside the full drawing comes before a smaller drawing.
    """
    points = corners(panel)
    rooms = reserved(drawing, look.unit)
    rooms.sort(
        key=lambda room: (
            -fill(points, room, look.unit, position=False, centimetre=look.centimetre).factor
        )
    )
    for room in (None, *rooms):
        art = _sketch(panel, drawing, room, look) if room else full
        for inset in insets:
            spot = find_spot(art.obstacles, drawing, inset, look.unit)
            if spot:
                add_inset(art, inset, spot, look)
                return art
    return full


def dot(look: Look, at: complex, grown: float = 1.0) -> Mark:
    """Return the dot of a vertex."""
    # The rim lies around the dot: its pen covers the outermost ring of a larger disc.
    rim = Pen(look.style.background, DOT_RIM * look.unit)
    return disc(at, (DOT + DOT_RIM / 2) * look.unit * grown, look.style.text, rim)


def _name_coriolis(art: PanelArt, panel: Panel, look: Look) -> None:
    """Write 2ωv beside the Coriolis vector: the one name on a side."""
    for index, stroke in enumerate(panel.strokes):
        if stroke.component == "coriolis" and isinstance(stroke.shape, Arrow):
            ends = art.scale(stroke.shape.start), art.scale(stroke.shape.end)
            ink = look.ink(stroke.link)
            add_tag(art, "2ωv", ends, look, ink, SMALL_SIZE, ALWAYS, since=index + 1)


def _growth(
    art: PanelArt, panel: Panel, index: int, points: list[complex], drawing: Rect, look: Look
) -> Growth:
    shape = panel.strokes[index].shape
    if isinstance(shape, Arrow):
        return vector_growth(art, panel, index, look)
    if isinstance(shape, Line):
        return line_growth(art, panel, index, points, drawing, look)
    at = art.scale(shape.at) if isinstance(shape, Dot) else art.scale(0j)
    return Growth(Level.DOT, lambda grown: [dot(look, at, max(grown, 0.05))])
