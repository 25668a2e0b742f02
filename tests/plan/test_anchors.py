"""Every mark of a picture hangs where it says, in any pose: a still, a turn, under the hand.

What a mark states is read here as plain data, and its place worked out anew: from the points of
`vad.solve` and the scale, not by the picture's own code.
"""

from __future__ import annotations

import cmath
import functools
import json
import math
import random
from collections.abc import Iterator
from dataclasses import asdict
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import vad
from tests.kinds import SPACE
from tests.plan.solved_points import SolvedPoints, letters_of, points_in
from vad.errors import VadError
from vad.kinematics.motion import Motion
from vad.kinematics.reach import closing_range
from vad.mechanisms import Mechanism
from vad.plan.board import plan, rows_of
from vad.plan.format import screen
from vad.plan.geometry import Rect
from vad.plan.labels.named import NamedLabels
from vad.plan.lens import BAND, Seen
from vad.plan.marks import Bow, Disc, Lettering, Mark, Polygon, Polyline
from vad.plan.pictures import over_reach
from vad.plan.pictures.polygon import Polygon as VectorPolygon
from vad.plan.reach import corners
from vad.plan.scale import Scale, fill
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Arc, Arrow, Block, Dot, Guide, Panel, Plate, Sheet, Stroke

EXAMPLES = {
    path.stem: vad.load(str(path))
    for path in (Path(vad.__file__).parent / "examples").glob("*.toml")
}
KINDS: dict[str, Any] = {**vad.MECHANISMS, **dict(sorted(EXAMPLES.items()))}
POSES, FEW = 200, 4
#: Of so many poses one is laid out as a still, too, which takes most of the time.
STILLS = 5
ROOM = Rect(0.05, 0.15, 0.60, 0.80)
#: On the page; a pixel is a 720th.
CLOSE = 1e-9
#: Of what a letter stands for, where that was worked out in another way than the sheet does.
SOLVED = 2e-7


def driven(mechanism: Mechanism, count: int, seed: int) -> list[Motion]:
    """Return poses at random places of the driver, away from where it must turn back."""
    place, rng = next(iter(mechanism.inputs)), random.Random(seed)
    found: list[Motion] = []
    while len(found) < count:
        low, high = rng.choice(closing_range(mechanism))
        share = 0.02 + 0.96 * rng.random()
        motion = vad.solve(mechanism, **{place: low + share * (high - low)})
        try:
            motion.to_dict()
        except VadError:
            continue
        found.append(motion)
    return found


@functools.cache
def reach_of(name: str) -> tuple[Mechanism, list[Panel], Sheet]:
    """Return a mechanism, its panel in poses over its reach, and a sheet of it."""
    mechanism: Mechanism = KINDS[name]()
    sheets = [vad.draw(motion) for motion in driven(mechanism, 8, 1)]
    return mechanism, [sheet.panel("position") for sheet in sheets], sheets[0]


def pictures(name: str) -> Any:
    """Return what poses a mechanism under the hand, at one scale for its whole reach."""
    _, panels, sheet = reach_of(name)
    return over_reach(Setting(sheet, panels[0], ROOM, rows_of(sheet)), panels)


def sketches(picture: Any, sheet: Sheet, still: bool) -> Iterator[tuple[Panel, Sketch]]:
    """Yield all panels of a pose: in a turn and under the hand, and of a ``still``."""
    rows = rows_of(sheet)
    for panel in sheet.halves:
        setting = Setting(sheet, panel, ROOM, rows)
        if panel.picture == "vectors":
            own: Any = VectorPolygon(setting, fill(corners(panel), ROOM, False))
        else:
            own = picture
        yield panel, own.still
        yield panel, own.pose(panel)
        yield panel, own.under_hand(setting, NamedLabels(panel.name))
    if still:
        board = plan(sheet, screen((1280, 720)), 0.058)
        for panel in sheet.halves:
            yield panel, board.sketches[panel.name]


def hung(sketch: Sketch) -> Iterator[tuple[str, Mark]]:
    """Yield the marks that stay, with the names of their strokes."""
    for item in sketch.items:
        if item.until > sketch.setting.end:
            for mark in item.marks:
                yield item.stroke, mark


class Places:
    """Works out where anchors are: from solved points, and directions that solved links turn."""

    def __init__(self, motion: Motion, sheet: Sheet, panel: Panel, scale: Scale) -> None:
        self.motion, self.panel, self.scale = motion, panel, scale
        self.is_polygon = panel.picture == "vectors"
        self.strokes = {each.name: each for each in (*panel.zeros, *panel.strokes)}
        plane = sheet.mechanism not in SPACE
        self.solved = SolvedPoints(motion, sheet, panel).letters if plane else {}
        self.largest = max([*map(abs, self.solved.values()), 1e-300])

    def point(self, stroke: str, vertex: str | int) -> complex:
        """Return a point of a stroke: that of its letter, where it has one."""
        drawn, letter = self.strokes[stroke], self.letter(self.strokes[stroke], vertex)
        stated = self.stated(drawn, vertex)
        if letter is None or letter not in self.solved:
            return stated
        found = self.solved[letter]
        assert abs(found - stated) <= SOLVED * self.largest, (stroke, vertex, letter)
        return found

    def letter(self, stroke: Stroke, vertex: str | int) -> str | None:
        """Return the letter of a point."""
        shape = stroke.shape
        match shape:
            case Arrow(tail=tail, head=head):
                return {"start": tail, "end": head}.get(str(vertex))
            case Plate(letters=letters):
                return letters[int(vertex)]
            case Dot() | Block():
                return letters_of(stroke)[0]
            case Arc() | Guide(side=None):  # about the first point of its step, or through it
                names = points_in(self.motion, stroke.part.of)
                return names[0] if names and self.panel.picture == "skeleton" else None
        return None

    def stated(self, stroke: Stroke, vertex: str | int) -> complex:
        """Return a point as the sheet states it."""
        shape: Any = stroke.shape
        if vertex == "foot":
            return complex(shape.start + shape.cylinder * unit(shape.end - shape.start))
        if isinstance(vertex, int):
            return complex((shape.corners if isinstance(shape, Plate) else shape.points)[vertex])
        return complex(getattr(shape, vertex))

    def way(self, stroke: str) -> complex:
        """Return the direction of a stroke."""
        if not stroke:
            return 1.0 + 0j
        shape: Any = self.strokes[stroke].shape
        if isinstance(shape, Arrow):
            return unit(self.point(stroke, "end") - self.point(stroke, "start"))
        return complex(shape.direction)

    def __call__(self, anchor: Any) -> complex:
        """Return where an anchor is on the page; it comes as plain data."""
        points = [self.scale.origin + self.scale.factor * self.point(*p) for p in anchor["points"]]
        at = sum(points, 0j) / len(points)
        for term in anchor["terms"]:
            length = complex(*term["page"]) + self.scale.factor * complex(*term["panel"])
            at += length * self.way(term["stroke"])
        return at


def unit(z: complex) -> complex:
    return z / abs(z) if z else 0j


@functools.lru_cache(maxsize=50_000)
def as_data(statement: Any) -> dict[str, Any]:
    """Return what a mark states as another language reads it."""

    def plain(value: Any) -> Any:
        if isinstance(value, complex):
            return [value.real, value.imag]
        raise TypeError(value)

    read = json.loads(json.dumps(asdict(statement), default=plain))
    return {"kind": type(statement).__name__, **read}


def vertices(mark: Mark) -> list[complex]:
    """Return the points by which a shape is given."""
    match mark.shape:
        case Polyline(pieces):
            return [z for piece in pieces for z in piece]
        case Polygon(rings):
            return [z for ring in rings for z in ring]
        case Disc(centre) | Bow(centre):
            return [centre]
        case Lettering(at=at):
            return [at]


def expected(stated: dict[str, Any], places: Places, mark: Mark) -> list[complex]:
    """Return where the vertices of a mark belong."""
    shape: Any = mark.shape
    match stated["kind"]:
        case "Chains":
            return [places(anchor) for piece in stated["pieces"] for anchor in piece]
        case "Area":
            return [places(anchor) for anchor in stated["corners"]]
        case "Circle":
            assert shape.radius == stated["radius"]
            return [places(stated["centre"])]
        case "Arch":
            assert (shape.radius, shape.start) == (stated["radius"], stated["start"])
            return [places(stated["centre"])]
        case "Beside":
            return [places(stated["anchor"]) + complex(*stated["offset"])]
        case "Strip":
            return strip(stated, places, closed=isinstance(shape, Polygon))
        case "AngleArc":
            return [angle(stated, places, shape)]
        case "Vector":
            return vector(stated, *ends(stated, places))
        case "Cut":
            return cut(stated, *ends(stated["vector"], places), vertices(mark))
        case "Ray":
            return ray(stated, places, vertices(mark))
        case "CompassArc":
            arc = places.strokes[stated["stroke"]].shape
            assert isinstance(arc, Arc)
            assert shape.radius == pytest.approx(arc.radius * places.scale.factor)
            return [places.scale(places.point(stated["stroke"], "centre"))]
        case "Stretch":
            return stretch(stated, places, mark)
        case "Ball":
            return [places.scale(places.point(stated["stroke"], "centre"))]
        case "Speed":
            return speed(stated, places, vertices(mark))
        case "OnPage":
            return vertices(mark)
    raise AssertionError(stated["kind"])


def ends(stated: dict[str, Any], places: Places) -> tuple[complex, complex]:
    """Return where the vertices of a vector are."""
    return places(stated["start"]), places(stated["end"])


def vector(stated: dict[str, Any], start: complex, end: complex) -> list[complex]:
    """Return the shaft of a vector, or its head, in its lane."""
    way, length = unit(end - start), abs(end - start)
    lane, head = stated["lane"], min(0.026 * (0.75 if stated["whole"] else 1.0), 0.6 * length)
    aside = complex(*lane["aside"])
    assert abs((aside * way.conjugate()).real) < CLOSE
    tip = end - min(0.006, 0.15 * length) * way + aside
    if stated["part"] == "shaft":
        return [start + aside, tip - 0.66 * head * way]
    left, right = (min(0.4 * head, lane[side]) * 1j * way for side in ("left", "right"))
    return [tip, tip - head * way + left, tip - 0.76 * head * way, tip - head * way - right]


def cut(
    stated: dict[str, Any], start: complex, end: complex, found: list[complex]
) -> list[complex]:
    """Check that part of a vector lies on its line and in its room."""
    way, aside = unit(end - start), complex(*stated["vector"]["lane"]["aside"])
    room = Rect(**stated["room"])
    assert all(room.holds(spot - aside, CLOSE) for spot in found)
    across = [((z - aside - start) * way.conjugate()).imag for z in found]
    if stated["breaks"]:
        across = [sum(pair) for pair in zip(across[::2], across[1::2], strict=True)]
    if stated["vector"]["part"] == "shaft":
        assert max(map(abs, across)) < CLOSE
    return found


def ray(stated: dict[str, Any], places: Places, found: list[complex]) -> list[complex]:
    """Check that a construction line leads in its direction, and return its beginning."""
    line: Any = places.strokes[stated["stroke"]].shape
    start = places.scale(line.through)
    way = line.direction
    assert abs(((found[1] - start) * way.conjugate()).imag) < CLOSE
    assert Rect(**stated["room"]).holds(found[1], CLOSE)
    return [start, found[1]]


def strip(stated: dict[str, Any], places: Places, closed: bool) -> list[complex]:
    """Return the corners of a slot, as far as it lies in its room."""
    through, way = places(stated["through"]), places.way(stated["stroke"])
    room, inset, low, high = stated["room"], stated["inset"], stated["low"], stated["high"]
    for ahead, at, least, most in (
        (way.real, through.real, room["left"], room["right"]),
        (way.imag, through.imag, room["bottom"] + inset, room["top"] - inset),
    ):
        if abs(ahead) > 1e-9:
            one, two = sorted(((least - at) / ahead, (most - at) / ahead))
            low, high = max(low, one), min(high, two)
    half = stated["wide"] / 2 * -1j * way
    first, last = through + low * way, through + high * way
    ring = [first + half, last + half, last - half, first - half]
    return ring if closed else [*ring, ring[0]]


def angle(stated: dict[str, Any], places: Places, bow: Bow) -> complex:
    """Check the arc of an angle, or of one part the whole, and return its centre."""
    stroke = places.strokes[stated["stroke"]]
    low, high = stated["part"] or (0.0, 1.0)
    bow = bow.part(-low / (high - low), (1.0 - low) / (high - low))
    turned = cmath.rect(1.0, math.radians(bow.start + bow.sweep))
    driver = cmath.rect(1.0, math.radians(places.motion.link(str(stroke.link)).angle))
    assert abs(turned - driver) < 1e-9
    shrunk = math.log(bow.radius / stated["radius"]) / math.log(0.94)
    assert shrunk == pytest.approx(round(shrunk), abs=1e-6)
    room, larger = Rect(**stated["room"]), bow.radius / 0.94
    spots = [cmath.rect(larger, math.radians(bow.start + bow.sweep * i / 200)) for i in range(201)]
    if round(shrunk):  # one size larger would not fit
        assert not all(room.holds(bow.centre + spot, -0.0024) for spot in spots)
    return places.scale(places.point(stroke.name, "centre"))


def stretch(stated: dict[str, Any], places: Places, mark: Mark) -> list[complex]:
    """Return the points of a curve, or check both ends of its stretch and return its centre."""
    shape: Any = places.strokes[stated["stroke"]].shape
    if isinstance(mark.shape, Polyline):
        names = ("start", "end") if isinstance(shape, Arrow) else range(len(shape.points))
        return [places.scale(places.point(stated["stroke"], name)) for name in names]
    assert isinstance(mark.shape, Bow)
    line = mark.shape.line(0.5)
    for share, found in ((stated["start"], line[0]), (stated["end"], line[-1])):
        at = shape.at(shape.start + share * shape.sweep)
        assert abs(places.scale(at) - found) < 1e-8
    return [places.scale(places.point(stated["stroke"], "centre"))]


def speed(stated: dict[str, Any], places: Places, found: list[complex]) -> list[complex]:
    """Check that what moves of the speeds over a turn lies on the ray of the present one."""
    inset: Any = places.panel.inset
    way = unit(inset.ray)
    middle = sum(found, 0j) / len(found) - complex(*stated["origin"])
    assert stated["part"] == 1 or abs((middle * way.conjugate()).imag) < CLOSE
    return found


def belongs(stroke: str, mark: Mark, stated: dict[str, Any], places: Places) -> None:
    """Check that a mark hangs on what its stroke is about."""
    name = stroke.partition(":")[2]
    drawn = places.strokes.get(name)
    if isinstance(mark.shape, Lettering) and mark.role == "letter":
        written = "".join(run.text for run in mark.shape.runs).split(",")
        points = stated["anchor"]["points"]
        letters = [places.letter(places.strokes[owner], vertex) for owner, vertex in points]
        # Set in type, what is small and low is a letter of its own size; a long label has two rows.
        plain = [str(each).translate(str.maketrans("ₙ₀₁₂₃₄₅₆", "n0123456")) for each in letters]
        assert None in letters or {each.strip() for each in written} & set(plain), (points, written)
    if stated["kind"] == "Strip":
        holds_its_block(vertices(mark), stated, places)
    if drawn is None or not isinstance(drawn.shape, Arrow) or not drawn.shape.head:
        return
    tail, head = (places.scale(places.point(name, end)) for end in ("start", "end"))
    way = unit(head - tail)
    if stated["kind"] in ("Vector", "Cut") and places.is_polygon:
        own = stated.get("vector", stated)
        assert own["end"]["points"] == [[name, "end"]]
        begun = (places(own["start"]) - tail) * way.conjugate()
        assert abs(begun.imag) < 1e-6 and -CLOSE <= begun.real <= abs(head - tail) + CLOSE
    elif mark.role in ("bar", "piston rod") and stated["kind"] == "Chains":
        first, last = vertices(mark)
        assert abs(((first - tail) * way.conjugate()).imag) < 1e-6
        assert abs(last - head) < CLOSE or stated["pieces"][-1][-1]["terms"]


def holds_its_block(corners: list[complex], stated: dict[str, Any], places: Places) -> None:
    """Check that a slot is about its block, and does not end in it but at the edge of its room."""
    step, room = places.strokes[stated["stroke"]].part.of, Rect(**stated["room"])
    blocks = [
        s for s in places.strokes.values() if isinstance(s.shape, Block) and s.part.of == step
    ]
    way, start, end = places.way(stated["stroke"]), corners[0] + corners[3], corners[1] + corners[2]
    for block in blocks:
        at = places.scale(places.point(block.name, "at"))
        for tip, ahead in ((end / 2, way), (start / 2, -way)):
            assert abs(((at - tip) * way.conjugate()).imag) < CLOSE
            inside = ((tip - at) * ahead.conjugate()).real
            assert inside > 0.019 or not room.holds(tip + 0.01 * ahead)


def check_dots(panel: Panel, sketch: Sketch, places: Places) -> None:
    """Check that there is a dot at every letter, however many share it."""
    roles = ("dot", "joint", "point")
    discs = [mark.shape for _, mark in hung(sketch) if mark.role in roles]
    spots = [disc.centre for disc in discs if isinstance(disc, Disc)]
    for stroke in panel.strokes:
        for vertex in ("start", "end") if isinstance(stroke.shape, Arrow) else ():
            at = places.scale(places.point(stroke.name, vertex))
            # A dot that several share is amid them.
            assert min(abs(at - spot) for spot in spots) < 0.020, (stroke.name, vertex)


def through(seen: Seen, sketch: Sketch) -> Scale:
    """Return the scale at which a lens shows a panel."""
    lens, scale = seen.lens, sketch.scale
    middle = lens.at + lens.aside
    return Scale(middle + lens.factor * (scale.origin - lens.place), lens.factor * scale.factor)


def check_seen(mark: Mark, places: Places) -> None:
    """Check that a lens shows a mark where it belongs at the scale of the lens, cut at its rim."""
    assert isinstance(mark.hangs, Seen)
    lens, stated = mark.hangs.lens, as_data(mark.hangs.shape)
    found, rim = vertices(mark), lens.radius + BAND / 2
    if stated["kind"] == "Ray":
        line: Any = places.strokes[stated["stroke"]].shape
        start = places.scale(line.through)
        assert all(abs(((z - start) * line.direction.conjugate()).imag) < CLOSE for z in found)
    elif stated["kind"] != "Stretch":
        whole = expected(stated, places, mark)
        closed = [*whole, whole[0]]
        for spot in found:
            on_it = min(abs(spot - z) for z in whole) < CLOSE or any(
                abs(abs(spot - one) + abs(spot - other) - abs(one - other)) < 1e-6
                for one, other in pairwise(closed)
            )
            assert on_it or abs(abs(spot - lens.at) - rim) < 0.001, (mark, spot)
    if not isinstance(mark.shape, Disc):
        assert all(abs(spot - lens.at) < rim + 0.001 for spot in found), mark


def check(name: str, motions: list[Motion]) -> int:
    """Pose each picture of a mechanism, and return how many marks hang where they belong."""
    picture, seen = pictures(name), 0
    fixed: dict[tuple[str, str, str, int], Any] = {}
    for pose, motion in enumerate(motions):
        sheet = vad.draw(motion)
        for number, (panel, sketch) in enumerate(sketches(picture, sheet, not pose % STILLS)):
            shown = panel if sketch is not picture.still else sketch.setting.panel
            places, count = Places(motion, sheet, shown, sketch.scale), 0
            for stroke, mark in hung(sketch):
                assert mark.hangs is not None, (stroke, mark.role)
                if isinstance(mark.hangs, Seen):
                    check_seen(mark, Places(motion, sheet, shown, through(mark.hangs, sketch)))
                    continue
                stated = as_data(mark.hangs)
                for spot, place in zip(vertices(mark), expected(stated, places, mark), strict=True):
                    assert abs(spot - place) < CLOSE, (number, stroke, mark.role, stated)
                belongs(stroke, mark, stated, places)
                count += 1
                moving = number == 1 and panel.picture == "skeleton"
                if moving and stated["kind"] in ("Chains", "Area", "Strip") and stroke:
                    key = stroke, mark.role, str(mark.row), len(vertices(mark))
                    known = fixed.setdefault(key, stated)
                    assert same(known, stated), key
            seen += count
            if number % 3 == 2 and count:
                check_dots(shown, sketch, places)
    return seen


def same(one: Any, other: Any) -> bool:
    """Tell whether two statements are alike but for rounding."""
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(same(one[key], other[key]) for key in one)
    if isinstance(one, list):
        return len(one) == len(other) and all(map(same, one, other))
    return one == pytest.approx(other, abs=1e-9) if isinstance(one, float) else bool(one == other)


@pytest.mark.exhaustive(32)
@pytest.mark.parametrize("name", KINDS)
def test_every_vertex_of_a_few_poses_is_where_it_belongs(name):
    mechanism = reach_of(name)[0]
    assert check(name, driven(mechanism, FEW, seed=len(name))) > 100


@pytest.mark.exhaustive(1000)
@pytest.mark.parametrize("name", KINDS)
def test_every_vertex_of_many_poses_is_where_it_belongs(name, exhaustive):
    """In a usual run a fifth of the poses is looked at."""
    poses = POSES if exhaustive else POSES // 5
    assert check(name, driven(reach_of(name)[0], poses, seed=2)) > 50 * poses


@pytest.mark.parametrize("name", SPACE)
def test_a_letter_of_a_view_is_one_projection_of_its_solved_point(name):
    found: dict[tuple[str, str], list[tuple[Any, complex]]] = {}
    for motion in driven(KINDS[name](), 40, seed=3):
        for stroke in vad.draw(motion).panel("position").strokes:
            if stroke.part.which in ("third", "sphere"):  # it turns with BC, or has directions
                continue
            match stroke.shape:
                case Arrow(start, end, tail, head):
                    spots = [(tail, start), (head, end)]
                case Dot(at):
                    spots = [(stroke.label, at)]
                case _:
                    continue
            for letter, spot in spots:
                if letter in motion.points:
                    pair = motion.point(letter).position, spot
                    found.setdefault((stroke.name, letter), []).append(pair)
    assert len(found) > 1
    for pairs in found.values():
        solved = np.array([[1.0, *point] for point, _ in pairs])
        seen = np.array([spot for _, spot in pairs])
        projection, *_ = np.linalg.lstsq(solved, seen, rcond=None)
        largest = max(np.abs(seen).max(), np.abs(solved).max())
        assert np.abs(solved @ projection - seen).max() < 1e-9 * largest
