"""Lenses: when there is one, what it shows, and that it hides nothing."""

from __future__ import annotations

import cmath
import math
from itertools import combinations, pairwise

import numpy as np
import pytest

import vad
from tests.plan.knots import (
    LEAST,
    SHORTEST,
    TINY,
    is_led,
    points_of,
    told_apart,
    unequal,
    vectors_of,
)
from tests.plan.overlaps import KEY, overlaps, planned
from tests.plan.test_overlaps import still
from vad.files.examples import example_names, example_path
from vad.plan.board import Plan, reach
from vad.plan.format import screen
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER, Item, Level
from vad.plan.labels.close import MOST
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.placing import distance
from vad.plan.lens import BAND, Lens
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import plain
from vad.plan.marks import Bow, Disc, Lettering, Mark, Outline, Polygon, Polyline
from vad.plan.page.free_places import meet
from vad.plan.pictures import lensed
from vad.plan.pictures.lenses import Spot, Words
from vad.plan.problem_sheet import blank_panels, problem
from vad.plan.roles import ROLES
from vad.plan.sketch import Sketch
from vad.plan.stage import Stage

PIXEL = 1 / 720
HD = (1280, 720)
PANELS = ("position", "velocity", "acceleration")
#: Roles that a lens may lie on, and those of its own frame.
FRAME = {"lens", "lens band", "lens rim", "lens place", "leader", "notes", "scale bar"}


@pytest.fixture(scope="module")
def quick_return() -> Plan:
    """The acceleration of the ram is ten pixels long, and that from c′ to eₙ one and a half."""
    return planned(vad.draw(vad.solve(vad.Whitworth(rod=300), angle=120)))


def ink(shape: Outline) -> np.ndarray:
    """Return points close together all over the lines of a shape."""
    match shape:
        case Disc(centre, radius):
            return np.array([centre, *(centre + radius * cmath.rect(1, k) for k in range(6))])
        case Polyline(pieces):
            lines = pieces
        case Polygon(rings):
            lines = tuple((*ring, ring[0]) for ring in rings)
        case Bow():
            lines = (tuple(shape.line(2.0)),)
        case Lettering(runs, at, size):
            wide, high = ink_size(runs, size)
            low = at + 0.2j * high
            return np.array([low, low + wide / 2, low + wide])
    shares = np.linspace(0.0, 1.0, 60)
    ends = [pair for line in lines for pair in pairwise(line)]
    return np.concatenate([a + shares * (b - a) for a, b in ends] or [np.array([])])


def standing(sketch: Sketch, lens: bool) -> list[Mark]:
    """Return the marks that stay, of lenses or of all else."""
    return [
        mark
        for item in sketch.items
        if item.until == FOREVER and (item.level is Level.LENS) == lens
        for mark in item.marks
    ]


def letters_in(sketch: Sketch, lens: Lens) -> set[str]:
    """Return the labels that stay in a lens."""
    stay = (tag for tag in sketch.tags if tag.span[1] == FOREVER)
    return {tag.text for tag in stay if abs(tag.box.centre - lens.at) < lens.radius}


def check(sketch: Sketch) -> None:
    """Check the lenses of a panel: nothing lies beneath, and all that is within is told apart."""
    assert len(sketch.lenses) <= 4
    room = sketch.setting.room
    outside = standing(sketch, lens=False)
    around = [ink(mark.shape) for mark in outside if mark.role != "construction done"]
    all_ink = np.concatenate(around)
    for close, lens in zip(sketch.close, sketch.lenses, strict=True):
        little = lens.radius < 0.068 - 1e-9  # as of one more lens, for which little room is left
        assert 0.056 - 1e-9 <= lens.radius <= 0.135 + 1e-9
        assert lens.factor in (4, 8, 12, 20, 50, 100, 200)
        assert np.abs(all_ink - lens.at).min() > lens.radius + BAND, lens
        box = lens.box.inside(BAND)
        # The gutter is 0.046 wide: lenses of two panels leave a band between each other.
        assert room.holds(complex(box.left, box.bottom), 0.0135 if little else 0.009)
        assert room.holds(complex(box.right, box.top), 0.0135 if little else 0.009)
        dots = [
            mark.shape.centre
            for mark in standing(sketch, lens=True)
            if mark.role in ("dot", "joint", "point")
            if isinstance(mark.shape, Disc) and abs(mark.shape.centre - lens.at) < lens.radius
        ]
        assert len(dots) >= 2
        shown = [each for each in sketch.vertices if abs(lens(each.at) - lens.at) < lens.radius]
        assert letters_in(sketch, lens) == {each.label for each in shown}
        beside = {
            tag.text: tag
            for tag in sketch.tags
            if tag.span[1] == FOREVER and abs(tag.box.centre - lens.at) < lens.radius
        }
        for each in shown:
            box = beside[each.label].box
            off = distance(box, lens(each.at))
            if not is_led(sketch, beside[each.label]):
                assert off < 0.040, lens
                assert all(off <= distance(box, lens(other.at)) for other in shown), lens
        start, end = lens.leader
        for mark in standing(sketch, lens=True):
            if mark.role in ("notes", "scale bar"):
                across = ((ink(mark.shape) - start) / (end - start)).astype(complex)
                along = np.clip(across.real, 0.0, 1.0)
                assert np.abs((across - along) * (end - start)).min() > 0.002, lens
        for tag in sketch.tags:
            if tag.span[1] <= close.since:
                continue
            corners = [
                complex(x, y)
                for x in (tag.box.left, tag.box.right)
                for y in (tag.box.bottom, tag.box.top)
            ]
            within = [abs(corner - lens.at) < lens.radius for corner in corners]
            assert all(within) or not any(within), (tag.text, lens)
    for mark in standing(sketch, lens=True):
        assert mark.role not in ("value", "tag")
        if mark.role not in FRAME and not isinstance(mark.shape, Disc):
            spots = ink(mark.shape)
            off = min(np.abs(spots - lens.at).max() - lens.radius for lens in sketch.lenses)
            assert off < BAND - ROLES[mark.role].width / 2 + 1e-3, mark


def test_what_cannot_be_told_apart_is_enlarged(quick_return: Plan):
    assert not quick_return.sketches["position"].lenses
    assert not quick_return.sketches["velocity"].lenses
    sketch = quick_return.sketches["acceleration"]
    check(sketch)
    near, far = sorted(sketch.lenses, key=lambda lens: lens.factor)
    assert (near.factor, far.factor) == (4, 20)
    assert letters_in(sketch, near) == {"e′", "a′, d′"}
    assert letters_in(sketch, far) == {"eₙ", "c′"}
    outside = {
        tag.text
        for tag in sketch.tags
        if tag.span[1] == FOREVER
        if all(abs(tag.box.centre - lens.at) > lens.radius for lens in sketch.lenses)
    }
    assert outside >= {"b′", "q′", "qₙ", "z"}
    assert not outside & {"e′", "a′, d′", "eₙ", "c′"}


def test_a_lens_shows_vectors_in_their_usual_width_at_its_scale(quick_return: Plan):
    sketch = quick_return.sketches["acceleration"]
    near = min(sketch.lenses, key=lambda lens: lens.factor)
    spots = {letter: vertex.at for vertex in sketch.vertices for letter in vertex.letters}
    length = near.factor * abs(spots["e′"] - spots["a′"])
    dots = [
        m.shape.centre
        for m in standing(sketch, lens=True)
        if m.role == "dot" and isinstance(m.shape, Disc) and abs(m.shape.centre - near.at) < 0.05
    ]
    assert max(abs(a - b) for a in dots for b in dots) == pytest.approx(length)
    assert {m.width for m in standing(sketch, lens=True) if m.role == "vector"} == {1.0}


def test_a_lens_comes_with_the_last_stroke_that_it_tells_apart(quick_return: Plan):
    sketch = quick_return.sketches["acceleration"]
    setting = sketch.setting
    for close, lens in zip(sketch.close, sketch.lenses, strict=True):
        vertices = [sketch.vertices[number] for number in close.members[:2]]
        since = max(setting.after(vertex.since) for vertex in vertices)
        shown = [
            item
            for item in quick_return.items
            if item.level is Level.LENS
            and item.region == "acceleration"
            and any(abs(ink(m.shape) - lens.at).min() < lens.radius for m in item.marks)
        ]
        assert min(item.since for item in shown) == since
        assert all(item.since > since for item in shown if item.grows)
        for vertex in vertices:  # until then its letters stand beside its dot
            for letter in vertex.letters:
                spans = [tag.span for tag in sketch.tags if letter in tag.text.split(", ")]
                assert max(end for _, end in spans) == FOREVER
                assert min(start for start, _ in spans) <= setting.after(vertex.letters[letter])


def test_a_problem_gives_nothing_away():
    sheet = vad.draw(vad.solve(vad.Whitworth(rod=300), angle=120))
    key = planned(sheet)
    board = problem(key, blank_panels(sheet, "acceleration"), 0.058)
    assert any(item.level is Level.LENS for item in key.items)
    assert not any(item.level is Level.LENS for item in board.items)
    letters = [
        plain(mark.shape.runs)
        for item in board.items
        for mark in item.marks
        if item.region == "acceleration" and mark.role == "letter"
        if isinstance(mark.shape, Lettering)
    ]
    assert letters == ["a′, d′"]


@pytest.mark.exhaustive(12)
@pytest.mark.parametrize(
    ("name", "pose"),
    [
        # A larger lens of c″ₙ and f″ₙ would show a third dot, without its letter.
        ("watt-2", {"angle": 215.0, "alpha": 20.0}),
        (
            "landing-gear",
            {
                "position": 196.2685500589963,
                "velocity": 35.69778678316446,
                "acceleration": 27.781263695507896,
            },
        ),
        ("watt-2", {"angle": 30.0, "omega": 10.0, "alpha": -20.0}),
        (
            "double-slider",
            {
                "position": -814.0638795573723,
                "velocity": 1180.9194329295744,
                "acceleration": 5139.292168922805,
            },
        ),
    ],
)
def test_all_that_a_lens_shows_has_its_letters_there(name: str, pose: dict[str, float]):
    mechanism = vad.MECHANISMS.get(name) or vad.load(example_path(name))
    sketches = planned(vad.draw(vad.solve(mechanism(), **pose))).sketches.values()
    assert any(sketch.lenses for sketch in sketches)
    for sketch in sketches:
        check(sketch)


#: A sewing machine with a short crank.
SEWING = {"AB": 14.0, "AC": 12.0, "rod": 42.0, "CE": 28.0, "rocker": 26.0, "Gx": 34.0, "Gy": 22.0}


@pytest.mark.parametrize(
    ("name", "lengths", "angle", "letters"),
    [
        ("atkinson-engine", {}, 275.0, [{"bₙ", "p′", "pₙ"}, {"b″ₙ", "o′, c′"}, {"a′", "a′ₙ"}]),
        # The third has no room for a scale bar.
        ("sewing-machine", SEWING, 35.0, [{"a′, g′", "e″ₙ"}, {"c′", "c′ₙ"}, {"b′", "b′ₙ"}]),
    ],
)
def test_a_third_lens_stands_where_two_leave_points_that_look_like_one(
    name: str, lengths: dict[str, float], angle: float, letters: list[set[str]]
):
    mechanism = vad.load(example_path(name))(**lengths)
    sketch = planned(vad.draw(vad.solve(mechanism, angle=angle, alpha=20.0))).sketches[
        "acceleration"
    ]
    assert len(sketch.lenses) == 3
    check(sketch)
    for one, other in combinations(sketch.lenses, 2):
        assert abs(one.at - other.at) > one.radius + other.radius + 2 * BAND
    assert [letters_in(sketch, lens) for lens in sketch.lenses] == letters


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    ("name", "scene", "points"),
    [
        ("sewing-machine", 2, ("e′", "n′")),  # the head at one reaches to the other
        ("shaper", 0, ("A", "F")),  # two joints of the mechanism
        ("beam-engine", 2, ("a′", "bₙ")),  # two lenses stand already
    ],
)
def test_what_has_a_lens_in_a_still_has_one_in_the_lesson(
    name: str, scene: int, points: tuple[str, str]
):
    sheet = vad.draw(vad.solve(vad.load(example_path(name))()))
    stage = Stage(sheet, screen(HD), KEY)
    sketches = stage.scene(scene).sketches
    for sketch in (sketches[stage.layout(scene).large], planned(sheet).sketches[PANELS[scene]]):
        at = {letter: at for letter, at in points_of(sketch)}
        assert told_apart(sketch, *(at[letter] for letter in points))


@pytest.mark.exhaustive(18)
@pytest.mark.parametrize("name", ["watt-2", "pantograph", "pin-on-rocker", *example_names()])
def test_the_large_panels_of_a_lesson_hide_no_vector_and_join_no_points(name: str):
    sheet = vad.draw(vad.solve(vad.load(example_path(name))()))
    stage = Stage(sheet, screen((1280, 720)), KEY)
    for number in range(stage.count):
        large = sheet.panel(stage.layout(number).large)
        for sketch in (stage.scene(number).sketches[half.name] for half in large.halves):
            lettered = unequal([at for letter, at in points_of(sketch) if letter])
            pairs = [ends for ends in combinations(lettered, 2) if abs(ends[0] - ends[1]) < LEAST]
            if len(sketch.lenses) <= MOST:  # a fourth is there for points that look like one
                pairs += [ends for ends in vectors_of(sketch) if abs(ends[0] - ends[1]) < SHORTEST]
            pairs = [ends for ends in pairs if abs(ends[0] - ends[1]) > TINY]
            assert all(told_apart(sketch, *ends) for ends in pairs), sketch.setting.panel.name


def test_a_fourth_lens_stands_where_there_is_room_for_it():
    sheet = vad.draw(vad.solve(vad.load(example_path("pantograph"))(), angle=60.0))
    stage = Stage(sheet, screen((1280, 720)), KEY)
    lenses = stage.scene(stage.count - 1).sketches["acceleration"].lenses
    assert len(lenses) == 4
    for one, other in combinations(lenses, 2):
        assert abs(one.at - other.at) > one.radius + other.radius + 2 * BAND


def test_a_lens_of_points_very_close_may_have_its_leader_across_strokes():
    """Of two points half a pixel apart, the only free corner is on the other side of a vector."""
    sheet = vad.draw(vad.solve(vad.load(example_path("excavator-bucket"))()))
    sketch = planned(sheet).sketches["acceleration"]
    check(sketch)
    assert {"b′", "cₙ"} in [letters_in(sketch, lens) for lens in sketch.lenses]


def test_a_drawing_is_smaller_where_points_that_look_like_one_would_have_no_lens():
    """A lens of a vector that is short, but seen, has room in the larger one; that is no reason."""
    mechanism = vad.load(example_path("stephenson-3"))()
    sheet = vad.draw(vad.solve(mechanism, angle=275.0, alpha=20.0))
    sketch = planned(sheet).sketches["acceleration"]
    shown = sorted(map(sorted, (letters_in(sketch, lens) for lens in sketch.lenses)))
    assert shown == [["a′, d′, g′", "f″ₙ"], ["e′", "fₙ"]]
    check(sketch)


def test_a_leader_is_broken_where_it_crosses_a_stroke():
    mechanism = vad.load(example_path("drag-link"))()
    sheet = vad.draw(vad.solve(mechanism, angle=215.0, alpha=20.0))
    sketch = planned(sheet).sketches["acceleration"]
    vectors = [
        piece
        for mark in standing(sketch, lens=False)
        if mark.role.startswith("vector") and isinstance(mark.shape, Polyline)
        for piece in mark.shape.pieces
    ]
    leaders = [
        mark.shape.pieces
        for mark in standing(sketch, lens=True)
        if mark.role == "leader" and isinstance(mark.shape, Polyline)
    ]
    assert max(map(len, leaders)) > 2
    for first, last in (piece for pieces in leaders for piece in pieces):
        for start, end in vectors:
            off, ways = (start - first) / (last - first), (end - start) / (last - first)
            share = -off.imag / ways.imag
            assert not (0.0 < share < 1.0 and 0.0 < (off + share * ways).real < 1.0)


def test_leaders_of_lenses_do_not_cross_each_other():
    sheet = vad.draw(vad.solve(vad.Whitworth(rod=300), angle=120))
    sketch = planned(sheet, (1024, 768)).sketches["acceleration"]
    assert len(sketch.lenses) > 1
    for one, other in combinations(sketch.lenses, 2):
        (start, end), (first, last) = one.leader, other.leader
        off, way = (first - start) / (end - start), (last - first) / (end - start)
        share = -off.imag / way.imag
        assert not (0.0 < share < 1.0 and 0.0 < (off + share * way).real < 1.0)


@pytest.mark.parametrize("name", ["four-bar", "slider-crank", "crank-slotted-lever", "whitworth"])
def test_a_page_without_such_a_place_has_no_lens(name: str):
    sheet = vad.draw(vad.solve(vad.MECHANISMS[name](), angle=140))
    assert not any(sketch.lenses for sketch in planned(sheet).sketches.values())


def test_no_lens_is_looked_for_where_one_would_not_help(monkeypatch: pytest.MonkeyPatch):
    """Of points that lie close together in a long row, no lens shows all."""
    tried, once = [], lensed._tried
    monkeypatch.setattr(lensed, "_tried", lambda *given: tried.append(1) or once(*given))
    points = {f"E{number}": ("coupler", 10.0 + number, 7.0 * number) for number in range(6)}
    planned(vad.draw(vad.solve(vad.FourBar(points=points)), panels=("velocity",)))
    assert len(tried) <= 2


@pytest.mark.exhaustive(192, of="stills")
@pytest.mark.parametrize("step", range(12))
@pytest.mark.parametrize("name", [*vad.MECHANISMS, *example_names()])
def test_lenses_of_all_mechanisms(name: str, step: int):
    for sheet in still(name, step):
        size = (1024, 768) if step % 3 == 2 else (1280, 720)
        for sketch in planned(sheet, size).sketches.values():
            if sketch.lenses:
                check(sketch)
        assert overlaps(sheet, size) == []


@pytest.mark.parametrize("degrees", [0, 30, 110, 200])
def test_what_is_cut_ends_at_the_rim(degrees: int):
    lens = Lens(0j, 0.02, 4.0, 1 + 1j, 0.1)
    way = cmath.rect(1.0, math.radians(degrees))
    chord = lens.cut(Polyline(((lens.at - way, lens.at + way),)))
    assert isinstance(chord, Polyline)
    assert chord.length == pytest.approx(2 * (0.1 + BAND / 2))
    assert lens.cut(Polyline(((lens.at + 0.2j * way - way, lens.at + 0.2j * way + way),))) is None
    square = [lens.at + corner * way for corner in (1 + 1j, -1 + 1j, -1 - 1j, 1 - 1j)]
    area = lens.cut(Polygon((tuple(square),)))
    assert isinstance(area, Polygon)
    ring = np.array(area.rings[0]) - lens.at
    found = abs((ring.conj() * np.roll(ring, -1)).imag.sum()) / 2
    assert found == pytest.approx(math.pi * (0.1 + BAND / 2) ** 2, rel=2e-3)
    assert lens(0.01 * way) == pytest.approx(lens.at + 0.04 * way)


@pytest.mark.parametrize(("out", "into"), [(0, 0), (40, 0), (-30, 25)])
def test_a_leader_that_is_turned_still_ends_at_both_circles(out: int, into: int):
    turned = (cmath.rect(1.0, math.radians(out)), cmath.rect(1.0, math.radians(into)))
    lens = Lens(0j, 0.02, 4.0, 0.2 + 0.1j, 0.08, turned=turned)
    start, end = lens.leader
    assert abs(start - lens.place) == pytest.approx(lens.ring)
    assert abs(end - lens.at) == pytest.approx(lens.radius)
    assert lens.leaves(0.6)
    assert lens.mapped(2.0, 1j).leader == pytest.approx((2.0 * start + 1j, 2.0 * end + 1j))


def test_a_leader_across_a_circle_is_seen():
    behind = (-1.0 + 0j, 1.0 + 0j)
    assert not Lens(0j, 0.02, 4.0, 0.2 + 0.1j, 0.08, turned=behind).leaves(0.6)
    assert not Lens(0j, 0.02, 4.0, 0.2 + 0.1j, 0.08, turned=behind[::-1]).leaves(0.6)


def test_a_lens_shows_construction_lines_until_they_are_inked_over():
    sheet = vad.draw(vad.solve(vad.load(example_path("trunnion"))()))
    stage = Stage(sheet, screen((1280, 720)), KEY)
    scene = stage.scene(2)
    found: dict[str, list[tuple[int, int]]] = {"construction": [], "construction done": []}
    for item in scene.items:
        for mark in item.marks if item.level is Level.LENS else ():
            if mark.role in found:
                found[mark.role].append((item.since, item.until))
                (piece,) = mark.shape.pieces
                lenses = scene.sketches["acceleration"].lenses
                assert any(
                    all(abs(z - lens.at) < lens.radius + BAND for z in piece) for lens in lenses
                )
    heavy, faint = found.values()
    assert heavy
    assert sorted(until for _, until in heavy) == sorted(since for since, _ in faint)
    assert all(since < until < stage.finished for since, until in heavy)
    assert {until for _, until in faint} == {FOREVER}


def test_a_lens_shows_a_short_vector_between_its_dots():
    sheet = vad.draw(vad.solve(vad.load(example_path("trunnion"))()))
    sketch = Stage(sheet, screen((1280, 720)), KEY).scene(2).sketches["acceleration"]
    ends = {letter: at for letter, at in points_of(sketch) if letter in ("b′", "qₙ")}
    length = abs(ends["b′"] - ends["qₙ"])
    assert length < PIXEL
    factors = [lens.factor for lens in sketch.lenses if {"b′", "qₙ"} <= letters_in(sketch, lens)]
    assert [factor * length > 17 * PIXEL for factor in factors] == [True]


@pytest.mark.exhaustive(8)
@pytest.mark.parametrize("name", ["trunnion", "beam-engine", "excavator-bucket"])
def test_a_vector_within_a_lens_grows_there_while_it_is_drawn(name):
    stage, grows = Stage(vad.draw(vad.solve(vad.load(example_path(name))())), screen(HD), KEY), 0
    for number in range(1, stage.count):
        items = [item for item in stage.scene(number).items if item.level is Level.LENS]
        stands = min((i.since for i in items for m in i.marks if m.role == "lens"), default=0)
        for item in items:
            roles = [mark.role for mark in item.marks]
            if roles[-1] != "head" or not item.grows:
                # What is cut at the rim, and what was there before, is there at once.
                assert not item.grows
                continue
            shaft, head = item.marks
            ((tail, neck),) = shaft.shape.pieces
            tips = [head.at(share).shape.rings[0][0] for share in (0.0, 0.5, 1.0)]
            ways = [abs(tip - tail) for tip in tips]
            assert ways[0] < 1e-9 and ways[1] == pytest.approx(ways[2] / 2)
            assert shaft.at(1.0).shape.pieces[0][1] == pytest.approx(neck)
            assert item.since % 2 == 1 and item.since > stands
            grows += 1
    assert grows


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", ["gate-actuator", *example_names()])
def test_a_construction_line_reaches_its_crossing_within_a_lens(name: str):
    """There, too, it goes on past the point that it finds, up to the rim."""
    kind, met = vad.MECHANISMS.get(name) or vad.load(example_path(name)), 0
    for sketch in planned(vad.draw(vad.solve(kind()))).sketches.values():
        for item in (item for item in sketch.items if item.level == Level.LENS):
            for mark in (mark for mark in item.marks if mark.role == "construction"):
                lens, ray = mark.hangs.lens, mark.hangs.shape
                line = sketch.solved.shape(ray.stroke)
                crossing = lens(sketch.scale(line.until))
                if abs(crossing - lens.at) < lens.radius:
                    [(start, end)] = mark.shape.pieces
                    part = (crossing - start) / (end - start)
                    assert -1e-9 < part.real < 1.0, (item.stroke, part)
                    assert abs(part.imag) < 1e-9
                    met += 1
    assert met or name != "gate-actuator"


def test_the_bar_of_a_lens_says_its_unit_where_that_has_room():
    """In the picture of a lecture more often than in a still; it covers nothing."""
    sheet = vad.draw(vad.solve(vad.Whitworth()))
    sketch = planned(sheet).sketches["acceleration"]
    (lens,) = sketch.lenses
    said = [
        mark
        for item in sketch.items
        if item.level == Level.LENS
        for mark in item.marks
        if mark.role == "notes" and isinstance(mark.shape, Lettering)
    ]
    assert [plain(mark.shape.runs) for mark in said] == ["×4", "200 mm/s²"]
    box = reach([Item("", "", Level.LENS, tuple(said))])
    others = [tag.box for tag in sketch.tags]
    assert not any(meet(box, each) for each in others)
    assert sketch.setting.room.holds(complex(box.left, box.bottom))
    assert sketch.setting.room.holds(complex(box.right, box.top))
    assert all(abs(z - lens.at) > lens.radius for z in (box.centre, complex(box.left, box.top)))


def test_a_leader_meets_both_circles_where_a_stroke_lies_beside_one_of_them():
    lens = Lens(0.2 + 0.2j, 0.02, 4.0, 0.6 + 0.2j, 0.1)
    drawn = Obstacles(Rect(0.0, 0.0, 1.0, 1.0))
    for x in (0.222, 0.35, 0.498):
        drawn.line([complex(x, 0.0), complex(x, 0.5)], 0.003)
    marks = Spot(lens, Words(()), 0j).frame(drawn)
    (leader,) = (mark.shape for mark in marks if mark.role == "leader")
    assert len(leader.pieces) == 2
    ends = leader.pieces[0][0], leader.pieces[-1][-1]
    assert ends == lens.leader


def test_a_lens_shows_the_arcs_that_find_its_point_until_the_mechanism_is_finished():
    board = planned(vad.draw(vad.solve(vad.load(example_path("shaper"))()), panels="position"))
    in_lens = [item for item in board.items if item.level == Level.LENS]
    arcs = [item for item in in_lens if any(mark.role == "compass arc" for mark in item.marks)]
    found = next(item for item in in_lens if item.stroke == "position:F.found")
    assert {item.stroke for item in arcs} == {"position:AF.compass", "position:BF.compass"}
    assert all(item.since <= found.since < item.until < FOREVER for item in arcs)
