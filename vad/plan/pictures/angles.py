"""Given rates: the arrows of a given ω or v.

Each arrow gets a place at which it meets nothing that is drawn already.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from vad.kinematics.numbers import direction, fold
from vad.plan.anchors import RIGHT, Anchor, Arch, Area, Hung, Solved, Term
from vad.plan.items import Level
from vad.plan.labels.choices import RATE, MovingLabels
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.placing import APART, CLEARANCE, Placed, beside, beyond_circle
from vad.plan.labels.vertices import text_beside
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import symbols
from vad.plan.marks import Bow, Mark, area
from vad.plan.pictures import machine
from vad.plan.pictures.sense_places import Bar, distances
from vad.plan.pictures.vectors import HEAD_HALF_WIDTH, HEAD_NOTCH, Vector
from vad.plan.sketch import Sketch, Tag
from vad.strokes.sheet import Arc, Arrow, Ellipse, Stroke

SENSE_SIZES = (  # radius and span, the best first
    (0.062, 78.0),
    (0.074, 78.0),
    (0.062, 60.0),
    (0.074, 60.0),
    (0.088, 60.0),
    (0.050, 70.0),
    (0.062, 46.0),
    (0.074, 46.0),
    (0.104, 46.0),
    (0.120, 40.0),
)
#: Beyond the circle on which a crank runs, where it is drawn.
WIDER = ((0.135, 38.0), (0.150, 34.0), (0.170, 30.0))
#: About a crank that is drawn small, in a view.
CLOSER = ((0.042, 80.0), (0.034, 90.0))
SENSE_LEAD = 63.0
SENSE_HEAD = 0.018
CLEAR = 0.010  # about an arrow that stands still while the driver moves
SPEED_LENGTH = 0.072
SPEED_CLEAR = 0.009  # to either side of the arrow
#: How far aside from the edge of what moves, and how far along it, the nearest first.
SPEED_PLACES = sorted(
    itertools.product((0.016, 0.026, 0.040, 0.056), [0.015 * step for step in range(-10, 11)]),
    key=lambda place: place[0] + 0.5 * abs(place[1]),
)


@dataclass(frozen=True, slots=True)
class SensePlace:
    """Where the arrow of ω stands about its pivot: radius, span and middle, in degrees."""

    radius: float
    span: float
    middle: float

    def line(self, centre: complex) -> list[complex]:
        """Return points along the arrow."""
        return Bow(centre, self.radius, self.middle - self.span / 2, self.span).line()

    def letter(self, centre: complex, name: str = "ω") -> Placed:
        """Return the place of its ω, or of another name."""
        wide, high = ink_size(symbols(name), RATE)
        out = cmath.exp(1j * math.radians(self.middle))
        return Placed(centre + beyond_circle(out, self.radius + 0.010, wide, high), wide, high)


def free_place(
    obstacles: Obstacles,
    centre: complex,
    crank: float,
    sense: float,
    name: str = "ω",
    largest: float = math.inf,
    sizes: Sequence[tuple[float, float]] = SENSE_SIZES,
    apt: Callable[[SensePlace], bool] = lambda _: True,
) -> SensePlace | None:
    """Return a free place for the arrow of ω, best ahead of a crank that stands at so many degrees.

    ``sense`` is ±1, the sense in which it turns, ``name`` what is written beside it, ``largest``
    the largest radius, ``sizes`` its radii and spans, ``apt`` tells which places are allowed.
    Where all places are on strokes, it is the one that is the least so; None where none is free of
    labels.
    """
    every = _ahead(crank, sense, sizes)
    places = [place for place in every if place.radius <= largest and apt(place)]
    if not places:
        return None
    letters = [place.letter(centre, name) for place in places]
    spots, first = [letter.centre for letter in letters], letters[0]
    clear = obstacles.free(spots, first.wide, first.high, CLEARANCE, APART)
    crossing: list[tuple[int, SensePlace]] = []
    for number in np.flatnonzero(clear):
        line = places[number].line(centre)
        if not all(obstacles.edge.holds(point, -0.006) for point in line):
            continue
        if not obstacles.clear_of_labels(list(itertools.pairwise(line)), 0.004).all():
            continue
        crossed = int((~obstacles.free(line, 0.0, 0.0, 0.008)).sum())
        if not crossed:
            return places[number]
        crossing.append((crossed, places[number]))
    return min(crossing, key=lambda each: each[0], default=(0, None))[1]


def least_crossing(obstacles: Obstacles, centre: complex, crank: float, sense: float) -> SensePlace:
    """Return the place at which a curved arrow crosses the fewest labels, and then strokes.

    See `free_place`; here it needs no room for its name.
    """

    def crossed(place: SensePlace) -> tuple[int, int, int]:
        line = place.line(centre)
        outside = sum(not obstacles.edge.holds(point, -0.006) for point in line)
        labels = ~obstacles.clear_of_labels(list(itertools.pairwise(line)), 0.004)
        strokes = ~obstacles.free(line, 0.0, 0.0, 0.004)
        return outside, int(labels.sum()), int(strokes.sum())

    return min(_ahead(crank, sense), key=crossed)


def beside_own(sketch: Sketch, angle: Stroke, place: SensePlace) -> bool:
    """Tell whether an arrow stands nearer to the bar that an angle turns than to another link.

    On a ball that a view shows it seems to belong to this, wherever the bars are.
    """
    bars: dict[bool, list[Bar]] = {True: [], False: []}
    centre = sketch.solved.place(Anchor.of(angle.name, "centre"))
    line = np.array(place.line(centre))
    for stroke in sketch.setting.panel.strokes:
        if isinstance(stroke.shape, Arrow) and stroke.link:
            ends = sketch.scale(stroke.shape.start), sketch.scale(stroke.shape.end)
            bars[stroke.link == angle.link].append(ends)
        elif isinstance(stroke.shape, Ellipse) and stroke.kind == "fixed":
            away = np.abs(line - sketch.scale(stroke.shape.centre))
            if away.min() < abs(stroke.shape.first) * sketch.scale.factor + CLEAR:
                return False
    own, others = (distances(line, bars[mine]) for mine in (True, False))
    return not bars[True] or bool((own <= others).all())


def _ahead(
    crank: float, sense: float, sizes: Sequence[tuple[float, float]] = SENSE_SIZES
) -> list[SensePlace]:
    """Return places for a curved arrow, the best first: small ones ahead of a crank."""
    turns = sorted(range(0, 360, 15), key=lambda t: min(t, 360 - t))
    return [
        SensePlace(radius, span, crank + sense * (SENSE_LEAD + turn))
        for (radius, span), turn in itertools.product(sizes, turns)
    ]


def calm_place(poses: Iterable[tuple[complex, Obstacles]], name: str = "ω") -> SensePlace:
    """Return the place at which the arrow of ω, or of another name, is free in the most poses."""
    places = [
        SensePlace(radius, span, float(middle))
        for (radius, span), middle in itertools.product(SENSE_SIZES[::2], range(0, 360, 30))
    ]
    points, ends = [], [0]
    for place in places:
        points += [*place.line(0j), place.letter(0j, name).centre]
        ends.append(len(points))
    met = np.zeros(len(places))
    for centre, obstacles in poses:
        hit = ~obstacles.free([centre + point for point in points], 0.0, 0.0, CLEAR)
        met += np.add.reduceat(hit, ends[:-1]) > 0
    return places[int(met.argmin())]


def add_free_sense(
    sketch: Sketch,
    index: int | None,
    angle: Stroke,
    sizes: Sequence[tuple[float, float]],
) -> None:
    """Add the arrow of the given ω, if there is one, where it meets nothing of this one pose.

    It comes with stroke number ``index``, and stands about the centre of an ``angle``; ``sizes``
    are the radii and spans that it may have.  Where it has no room there, it is placed with the
    arrows of the other rates.
    """
    omega, shape = sketch.setting.sheet.driver.omega, angle.shape
    if omega and index is not None and isinstance(shape, Arc):
        crank, sense = shape.start + shape.sweep, math.copysign(1.0, omega)
        name = rate_of(sketch)
        centre = sketch.scale(shape.centre)
        apt = partial(beside_own, sketch, angle)
        place = free_place(sketch.obstacles, centre, crank, sense, name, sizes=sizes, apt=apt)
        if place:
            add_sense(sketch, index, angle, place)
            block_sense(sketch, angle, place)


def rate_of(sketch: Sketch) -> str:
    """Return the symbol of the given ω, ω₂; in a still with that of the given α in its sense."""
    sheet = sketch.setting.sheet
    rows = [row for row in sheet.rows if row.key == sheet.driver.row]
    panels = ("velocity",) if sketch.finished else ("velocity", "acceleration")
    cells = [row.cells[panel][0] for row in rows for panel in panels if row.cells.get(panel)]
    alike = [cell.symbol for cell in cells if cell.given and cell.value * sheet.driver.omega > 0.0]
    return ", ".join(alike) or "ω"


def add_sense(
    sketch: Sketch,
    index: int | None,
    angle: Stroke,
    place: SensePlace,
    labels: MovingLabels | None = None,
) -> None:
    """Add the arrow of the given ω, if there is one, at its place about the centre of an angle.

    Its name stands outside of it, or where ``labels`` have room for it.
    """
    setting, driver = sketch.setting, sketch.setting.sheet.driver
    if index is None or not driver.omega:
        return
    centre, row = Anchor.of(angle.name, "centre"), setting.row(setting.panel.strokes[index].link)
    sense = driver.omega / abs(driver.omega)  # no number at rest: then nothing of it is anywhere
    at, sweep = sketch.solved.place(centre) * abs(sense), place.span * sense
    name = rate_of(sketch)
    bow, head = curved_arrow(place.radius, place.middle, sweep)
    arrow = [
        Hung(Arch(centre, bow.radius, bow.start, bow.sweep), "sense", row),
        Hung(Area(tuple(centre + RIGHT * corner for corner in head)), "head", row),
    ]
    posed = (mark.posed(sketch.solved) for mark in arrow)
    marks = [mark for mark in posed if mark]
    if labels is None:
        letter = place.letter(at, name)
        marks.append(text_beside(centre, at, symbols(name), letter.centre, RATE, "tag", row))
        sketch.tags.append(Tag(name, letter.box))
        sketch.obstacles.box(letter.box)
    sketch.add(setting.panel.strokes[index], Level.LABEL, setting.after(index), marks)
    if labels:
        whole = Bow(at, place.radius, place.middle - place.span / 2, place.span)
        labels.rate(sketch, index, centre, whole, name)


def block_sense(sketch: Sketch, angle: Stroke, place: SensePlace) -> None:
    """Let labels keep clear of the arrow of ω, and not only of its letter.

    Under the hand it is two chords: a page has the numbers of each.
    """
    centre = sketch.solved.place(Anchor.of(angle.name, "centre"))
    bow = Bow(centre, place.radius, place.middle - place.span / 2, place.span)
    line = bow.line(place.span / 2) if sketch.finished else bow.line()
    sketch.obstacles.line(line, 0.004)


def sense_arrow(
    centre: complex,
    radius: float,
    middle: float,
    sweep: float,
    row: int | None,
    role: str = "sense",
    size: float = 1.0,
) -> list[Mark]:
    """Return a curved arrow about ``centre``, ``sweep`` degrees with its middle at ``middle``."""
    bow, head = curved_arrow(radius, middle, sweep, size)
    return [
        Mark(replace(bow, centre=centre), role, row),
        area([centre + corner for corner in head], "head", row),
    ]


def curved_arrow(
    radius: float, middle: float, sweep: float, size: float = 1.0
) -> tuple[Bow, list[complex]]:
    """Return the arc of a curved arrow about the origin, and the corners of its head."""
    head = SENSE_HEAD * size
    turn = math.degrees(0.8 * head / radius) * (sweep / abs(sweep))
    start, end = middle - sweep / 2, middle + sweep / 2
    tip = radius * direction(fold(end))
    root = radius * direction(fold(end - turn / 0.8))
    way = (tip - root) / abs(tip - root)
    half, notch = HEAD_HALF_WIDTH * 1j * head * way, root + HEAD_NOTCH * head * way
    return Bow(0j, radius, start, sweep - turn), [tip, root + half, notch, root - half]


def add_speed(sketch: Sketch, size: float, poses: Iterable[tuple[Solved, Obstacles]] = ()) -> None:
    """Add the arrow of the given velocity beside the block or actuator that is driven.

    Under the hand it is where it meets the least of what is drawn in some ``poses``.
    """
    setting, obstacles, driver = sketch.setting, sketch.obstacles, sketch.setting.sheet.driver
    number = setting.panel.find(driver.stroke)
    if number is None or not driver.speed:
        return
    stroke = setting.panel.strokes[number]
    shape, row, along = stroke.shape, setting.row(driver.row), Term(stroke.name)
    if isinstance(shape, Arrow):  # beside the rod of an actuator
        half = machine.CYLINDER / 2 * size
        middle = Anchor(((stroke.name, "foot"), (stroke.name, "end")))
    else:
        half, middle = machine.BLOCK[1] / 2 * size, Anchor.of(stroke.name, "at")
    sense = driver.speed / abs(driver.speed)  # no number at rest
    solved = sketch.solved
    way, place = solved.way(stroke.name), solved.place(middle) * abs(sense)
    name = _speed_of(sketch)
    runs = symbols(name)
    wide, high = ink_size(runs, RATE)
    places = [(half + aside, past, left) for aside, past in SPEED_PLACES for left in (1j, -1j)]
    met = np.zeros(len(places))
    steps = np.linspace(-SPEED_LENGTH / 2, SPEED_LENGTH / 2, 9)
    for posed, drawn in poses:
        offs = np.array([aside * left + past for aside, past, left in places])[:, np.newaxis]
        points = posed.place(middle) + (offs + steps) * posed.way(stroke.name)
        met += (
            (~drawn.free(points.ravel().tolist(), 0.0, 0.0, SPEED_CLEAR))
            .reshape(points.shape)
            .any(1)
        )
    for aside, past, left in (places[number] for number in met.argsort(kind="stable")):
        off = aside * left * along + past * along
        at = place + aside * left * way + past * way
        ahead = SPEED_LENGTH / 2 * sense * way
        start, end = at - ahead, at + ahead
        line = [start + (end - start) * step / 8 for step in range(9)]
        spots = [
            beside(foot, out, SPEED_CLEAR + CLEARANCE, wide, high)
            for foot, out in ((at, left * way), (end, sense * way), (start, -sense * way))
        ]
        if not obstacles.free(line, 0.0, 0.0, SPEED_CLEAR).all():
            continue
        if not obstacles.clear_of_labels([(start, end)], SPEED_CLEAR).all():
            continue
        free = obstacles.free(spots, wide, high, CLEARANCE, APART)
        if free.any():
            spot = spots[int(free.argmax())]
            tail = middle + (off - SPEED_LENGTH / 2 * sense * along)
            arrow = Vector(tail, tail + SPEED_LENGTH * sense * along, whole=True)
            marks = arrow.marks(solved, row, "speed", grows=False)
            marks.append(text_beside(middle, place, runs, spot, RATE, "tag", row))
            sketch.add(stroke, Level.LABEL, setting.after(number), marks)
            placed = Placed(spot, wide, high)
            sketch.tags.append(Tag(name, placed.box))
            obstacles.box(placed.box)
            obstacles.line([start, end], SPEED_CLEAR)
            return


def _speed_of(sketch: Sketch) -> str:
    """Return the symbol of the given velocity as the table has it: v_A where A is not alone."""
    sheet = sketch.setting.sheet
    rows = (row for row in sheet.rows if row.key == sheet.driver.row)
    cells = (cell for row in rows for cell in row.cells.get("velocity", ()))
    return next((cell.symbol for cell in cells if cell.given), "v")
