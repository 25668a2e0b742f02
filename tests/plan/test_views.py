"""Views of a mechanism in space: what a hand-made sheet becomes on the page, in a turn and live."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import vad
from tests.plan.overlaps import overlaps, planned
from tests.plan.sheet_of_views import sheet_of_views
from vad.export.sheet_json import sheet_from_json, to_text
from vad.plan.anchors import Anchor
from vad.plan.format import screen
from vad.plan.items import Item, Level
from vad.plan.labels.obstacles import PIXEL
from vad.plan.labels.placing import distance
from vad.plan.layout import TALL_VIEWS_SHARE, VIEWS_SHARE
from vad.plan.lettering.runs import plain
from vad.plan.live_board import LiveBoard
from vad.plan.marks import Bow, Disc, Lettering, Mark, Polygon
from vad.plan.page.changing import caption_lines
from vad.plan.pictures.angles import SensePlace, beside_own
from vad.plan.pictures.curves import curve_of
from vad.plan.pictures.notes import WIDTHS
from vad.plan.pictures.views import Views
from vad.plan.scale import Scale, views_scale
from vad.plan.sketch import Setting, Sketch, Tag
from vad.plan.stage import Stage
from vad.strokes.sheet import Arrow, Curve, Ellipse

POSES = [sheet_of_views(degrees) for degrees in range(5, 365, 30)]


def marks(items: list[Item], name: str, role: str) -> list[Mark]:
    return [
        mark for item in items if item.stroke == name for mark in item.marks if mark.role == role
    ]


def roles(sketch: Sketch, *names: str) -> list[Mark]:
    return [mark for item in sketch.items for mark in item.marks if mark.role in names]


def setting(room_of: Sketch) -> Setting:
    return replace(room_of.setting, panel=POSES[0].panels[0])


@pytest.mark.parametrize(
    "sheet", POSES[::3], ids=lambda s: f"{s.rows[0].cells['position'][0].value:g}"
)
def test_no_letter_lies_on_a_stroke(sheet):
    assert overlaps(sheet, lesson=True) == []
    assert overlaps(sheet, (1024, 768)) == []


def test_a_sheet_of_views_reads_back_from_its_json():
    sheet = sheet_of_views()
    assert sheet_from_json(to_text(sheet)) == sheet


def test_the_far_half_of_a_circle_is_dashed_and_the_near_one_solid():
    sketch = planned(sheet_of_views()).sketches["position"]
    (near,) = marks(sketch.items, "position:circle", "path")
    (far,) = marks(sketch.items, "position:circle", "path far")
    centre, factor = sketch.scale(0j), sketch.scale.factor
    for mark, side in ((near, -1.0), (far, 1.0)):
        ways = [(z - centre) / factor for z in mark.shape.line()]
        assert all(side * way.imag >= -1e-12 for way in ways)
        assert [abs(complex(way.real, way.imag / 0.4)) for way in ways] == pytest.approx(
            [1.0] * len(ways)
        )
        assert {round(ways[0].real), round(ways[-1].real)} == {1, -1}


def test_a_curve_grows_from_its_first_point_through_near_and_far_parts():
    shape = Ellipse(0.5j, 1.0 + 0j, 1j, 90.0, -320.0, ((-30.0, 20.0), (-150.0, -110.0)))
    curve = curve_of(Scale(0j, 0.1), shape)
    for share in (0.125, 0.3, 0.5, 0.8, 1.0):
        grown = [
            shown for mark in curve.marks("path", "path far", None) if (shown := mark.at(share))
        ]
        assert sum(mark.shape.length for mark in grown) == pytest.approx(
            0.1 * math.radians(320.0) * share
        )
        tip = 0.1 * shape.at(90.0 - 320.0 * share)
        assert min(abs(mark.shape.line()[-1] - tip) for mark in grown) < 1e-12
    far = [mark for mark in curve.marks("path", "path far", None) if mark.role == "path far"]
    assert sum(mark.shape.length for mark in far) == pytest.approx(0.1 * math.radians(90.0))


@given(st.complex_numbers(max_magnitude=3.0), *3 * [st.floats(-180.0, 180.0)], st.booleans())
def test_a_bow_runs_through_the_points_of_its_ellipse(first, across, start, sweep, above):
    assume(abs(first) > 0.1 and abs(sweep) > 1.0)
    second = first * cmath.rect(0.7, math.radians(across))
    shape = Ellipse(0.2 + 0.1j, first, second if above else second.conjugate(), start, sweep)
    bow = curve_of(Scale(0.3j, 0.1), shape).shape
    assert isinstance(bow, Bow)
    line = bow.line()
    for number, z in enumerate(line):
        angle = start + sweep * number / (len(line) - 1)
        assert abs(z - (0.3j + 0.1 * shape.at(angle))) < 1e-12
    # No point lies beyond the outermost ones.
    points, outermost = [shape.at(start + sweep * k / 90) for k in range(91)], shape.outermost
    for turn in (1.0, -1.0, 1j, -1j):
        farthest = max((turn * z).real for z in outermost)
        assert farthest >= max((turn * z).real for z in points) - 1e-12


def test_a_curve_is_lifted_over_to_a_break():
    sketch = planned(sheet_of_views()).sketches["position"]
    (projectors,) = marks(sketch.items, "position:P.projector", "path far")
    assert [len(piece) for piece in projectors.shape.pieces] == [2, 2]
    first, second = projectors.shape.pieces
    half = projectors.at(abs(first[1] - first[0]) / projectors.shape.length)
    assert half is not None
    assert half.shape.pieces[0] == pytest.approx(first)
    assert second[0] == sketch.scale(0.7j)


def test_joints_are_open_and_a_crossing_of_no_body_is_a_point():
    sketch = planned(sheet_of_views()).sketches["position"]
    discs = {
        role: {
            mark.shape.centre
            for item in sketch.items
            for mark in item.marks
            if mark.role == role and isinstance(mark.shape, Disc)
        }
        for role in ("joint", "point")
    }
    assert discs["point"] == {sketch.scale(1.2 - 2.6j)}
    assert sketch.scale(0j) in discs["joint"]


def test_the_bushes_of_a_bearing_leave_the_shaft_free():
    sketch = planned(sheet_of_views()).sketches["position"]
    bushes = marks(sketch.items, "position:bearing", "bearing")
    axis = sketch.scale(-2.6j).real
    sides = [
        {z.real > axis for z in mark.shape.rings[0]}
        for mark in bushes
        if isinstance(mark.shape, Polygon)
    ]
    assert sorted(map(list, sides)) == [[False], [True]]


def test_the_scale_is_that_of_the_ball_and_is_not_stated():
    plan = planned(sheet_of_views())
    sketch = plan.sketches["position"]
    (ball,) = marks(sketch.items, "position:ball", "ball")
    assert ball.shape == Disc(sketch.scale(0j), sketch.scale.factor)
    heads = [m for i in plan.items if i.region == "position head" for m in i.marks]
    assert not [mark for mark in heads if mark.role == "scale bar"]


def test_the_notes_are_written_near_what_they_say():
    sketch = planned(sheet_of_views()).sketches["position"]
    tags = {tag.text: tag for tag in sketch.tags}
    front, above = tags["seen from the front"], tags["from above"]
    assert front.box.centre.imag > sketch.scale(0j).imag
    assert above.box.centre.imag < sketch.scale(-1.5j).imag


def test_in_a_turn_only_what_moves_is_drawn_again():
    here = planned(POSES[0]).sketches["position"]
    panels = [sheet.panels[0] for sheet in POSES]
    moving = Views(setting(here), panels, views_scale(setting(here), panels))
    still = {item.stroke for item in moving.still.items}
    assert {"position:ball", "position:bearing", "position:circle", "position:sleeve"} <= still
    moved = {item.stroke for item in moving.pose(panels[3]).items}
    assert {"position:OP.bar", "position:yoke", "position:P.projector"} <= moved
    assert not still & moved - {""}
    assert not {"position:OQ.line", "position:OP.angle"} & (still | moved)
    bars = [s.shape for s in panels[3].strokes if s.name == "OP.bar"]
    (bar,) = marks(moving.pose(panels[3]).items, "position:OP.bar", "bar")
    assert isinstance(bars[0], Arrow)
    assert bar.shape.pieces == ((moving.scale(bars[0].start), moving.scale(bars[0].end)),)


def test_the_notes_of_a_turn_lie_on_no_pose():
    here = planned(POSES[0]).sketches["position"]
    panels = [sheet.panels[0] for sheet in POSES]
    moving = Views(setting(here), panels, views_scale(setting(here), panels))
    poses = [moving.pose(panel).obstacles for panel in panels]
    notes = [box for box, _ in moving.crowd.boxes]
    assert len(notes) == 2
    for box in notes:
        # What stands still has the box itself among its lines.
        lines = [line for pose in poses for line in pose.lines]
        others = [line for line in lines if not box.holds(line[0])]
        poses[0].lines[:] = others
        poses[0].boxes.clear()
        assert poses[0].free([box.centre], box.width, box.height, 0.0)[0]


def test_under_the_hand_the_views_keep_their_scale_and_letters_stand_once_a_view():
    form = screen((1280, 720))
    board = LiveBoard.over(POSES[0], form, 1, POSES)
    ways: dict[str, dict[str, float]] = {}
    scales = set()
    for sheet in POSES[:4]:
        pose = board.pose(sheet, {}, ways)
        ways = {name: dict(each) for name, each in pose.ways.items()}
        scales.add(pose.scales["position"])
        letters = [
            "".join(run.text for run in mark.shape.runs)
            for item in pose.plan.shown(0)
            for mark in item.marks
            if mark.role == "letter"
            and isinstance(mark.shape, Lettering)
            and item.region == "position"
        ]
        assert sorted(letters) == ["O", "P", "P", "Q", "T"]
        assert {"P", "P 1"} <= set(ways["position"])
    assert len(scales) == 1


def place_of(sketch: Sketch, tag: Tag) -> tuple[float, float]:
    """Return how far a letter is from its own dot, and from the nearest other one."""
    dots = {
        mark.shape.centre
        for item in sketch.items
        for mark in item.marks
        if mark.role in ("joint", "point") and isinstance(mark.shape, Disc)
    }
    named = [vertex.at for vertex in sketch.vertices if vertex.label == tag.text]
    own = min(named, key=lambda at: distance(tag.box, at))
    others = [distance(tag.box, at) for at in dots if abs(at - own) > 1e-6]
    return distance(tag.box, own), min(others)


@pytest.mark.parametrize("degrees", [45.0, 210.0, 330.0])
def test_no_letter_of_a_view_seems_to_name_a_joint_without_one(degrees: float):
    sketch = planned(vad.draw(vad.solve(vad.HookeJoint(), angle=degrees))).sketches["position"]
    assert sketch.unnamed
    ends = [end for mark in roles(sketch, "leader") for end in mark.shape.pieces[0]]
    letters = [tag for tag in sketch.tags if tag.text in ("P", "Q", "T", "P, T", "Q, T")]
    assert len(letters) >= 4
    for tag in letters:
        own, other = place_of(sketch, tag)
        led = any(distance(tag.box, end) < 0.008 for end in ends)
        assert led or own < other


@pytest.mark.parametrize("degrees", [120.0, 180.0, 300.0])
def test_the_sense_of_the_driver_lies_on_no_circle(degrees: float):
    sketch = planned(vad.draw(vad.solve(vad.HookeJoint(), angle=degrees))).sketches["position"]
    given_, *_ = roles(sketch, "sense")
    assert isinstance(given_.shape, Bow)
    assert sketch.obstacles.edge.holds(given_.shape.line()[0])
    paths = [mark.shape for mark in roles(sketch, "path", "angle") if isinstance(mark.shape, Bow)]
    assert paths
    off = [abs(at - z) for at in given_.shape.line() for path in paths for z in path.line()]
    assert min(off) > 0.008


@pytest.mark.exhaustive(8)
@pytest.mark.parametrize("size", [(1280, 720), (960, 720)])
@pytest.mark.parametrize("degrees", [15.0, 60.0, 135.0, 150.0, 270.0])
def test_the_note_of_a_view_stands_below_that_view(size: tuple[int, int], degrees: float):
    sheet = vad.draw(vad.solve(vad.SpatialFourBar(), angle=degrees))
    sketch = planned(sheet, size).sketches["position"]
    strokes = {stroke.name: stroke.shape for stroke in sheet.panel("position").strokes}
    star = sketch.scale(strokes["star.A"].points[0])
    roses = [sketch.scale(strokes[f"{name}.angle"].centre) for name in ("rose", "DC")]
    notes = {tag.text: tag.box.centre for tag in sketch.tags if tag.text.startswith("along")}
    own = dict(zip(("along DA", "along A", "along D"), (star, *roses), strict=True))
    assert notes.keys() == own.keys()
    for text, at in notes.items():
        assert at.imag < own[text].imag and abs(at - own[text]) < 0.225  # not in the mechanism
    for at, (this, other) in zip(
        (notes["along A"], notes["along D"]), (roses, roses[::-1]), strict=True
    ):
        assert abs(at - this) < abs(at - other)
        assert abs(at.real - this.real) < abs(at.real - star.real)


def test_on_a_narrow_page_notes_have_short_lines_before_views_are_drawn_smaller():
    sheet = vad.draw(vad.solve(vad.HookeJoint(), angle=30.0))
    panel = planned(sheet, (960, 720)).sketches["position"]
    fitting = views_scale(panel.setting, [panel.setting.panel])
    assert panel.scale.factor > 0.9 * fitting.factor
    notes = {tag.text: tag.box for tag in panel.tags if tag.text.count(" ") > 1}
    assert len(notes) == 2
    assert all(box.width < WIDTHS[0] for box in notes.values())


def test_on_a_narrow_page_views_have_a_wider_column_but_where_they_are_tall():
    for kind, share in ((vad.HookeJoint, TALL_VIEWS_SHARE), (vad.SphericalFourBar, VIEWS_SHARE)):
        page = planned(vad.draw(vad.solve(kind(), angle=60.0)), (960, 720)).page
        widths = [place.drawing.width for place in page.panels.values()]
        assert widths[0] == pytest.approx(share * sum(widths) / 3)
        assert widths[1] == pytest.approx(widths[2])


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    ("kind", "degrees"), [(vad.HookeJoint, 15.0), (vad.HookeJoint, 165.0), (vad.RSSR, 45.0)]
)
def test_on_a_narrow_page_the_senses_of_the_driven_body_have_a_place(kind: type, degrees: float):
    plan = planned(vad.draw(vad.solve(kind(), angle=degrees)), (960, 720))
    marks = [m for i in plan.items if i.region == "position" for m in i.marks if m.role == "term"]
    shown = {plain(mark.shape.runs).removeprefix(", ") for mark in marks}
    # What has no clear room on the views has its sense in the table.
    assert {"ω₄", "α₄"} <= shown | plan.turns.keys()
    assert not shown & plan.turns.keys()


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    "kind", [vad.HookeJoint, vad.RSSR, vad.SpatialFourBar, vad.SphericalFourBar]
)
def test_the_note_of_a_view_comes_with_its_first_stroke(kind: type):
    sheet = vad.draw(vad.solve(kind()))
    sketch, panel = planned(sheet, lesson=True).sketches["position"], sheet.panel("position")
    assert {note.comes for note in panel.notes} <= {stroke.name for stroke in panel.strokes}
    written = [item for item in sketch.items if item.level is Level.LABEL]
    shown = [item.since for item in written if "notes" in {m.role for m in item.marks}]
    assert sorted(shown) == sorted(
        sketch.setting.during(panel.number(note.comes)) for note in panel.notes
    )
    assert max(shown) > 0


def test_joints_of_views_that_look_like_one_stand_under_a_lens():
    sheet = vad.draw(vad.solve(vad.RSSR(), angle=75.0))
    plan = planned(sheet, (960, 720))
    sketch = plan.sketches["position"]
    (lens,) = sketch.lenses
    assert {"A", "B"} == {sketch.vertices[n].label for n in sketch.close[0].members}
    words = [
        "".join(run.text for run in mark.shape.runs)
        for item in plan.items
        for mark in item.marks
        if mark.role == "notes" and isinstance(mark.shape, Lettering)
    ]
    assert "×8" in words and not roles(sketch, "scale bar")
    within = [tag for tag in sketch.tags if abs(tag.box.centre - lens.at) < lens.radius]
    assert {tag.text for tag in within} == {"A", "B"}
    assert overlaps(sheet, (960, 720)) == []


def test_a_small_thumbnail_of_views_has_letters_alone():
    sheet = vad.draw(vad.solve(vad.SphericalFourBar()))
    for size, written in (((1280, 720), True), ((960, 720), False)):
        scene = Stage(sheet, screen(size), 0.058).scene(1)
        texts = {tag.text for tag in scene.sketches["position"].tags}
        assert {"A", "B", "C", "D", "O"} <= texts
        assert ({"OB", "θ₄"} <= texts) == written


def test_in_a_lesson_views_are_large_while_they_are_drawn():
    sheet = sheet_of_views()
    stage = Stage(sheet, screen((1280, 720)), 0.058)
    usual = planned(sheet, lesson=True).sketches["position"].scale.factor
    # The chapters at the foot of the stage take a tenth of the height from it.
    assert stage.scene(0).sketches["position"].scale.factor > 1.15 * usual
    assert caption_lines(sheet, 1.6) >= 1


@pytest.mark.parametrize("size", [(1280, 720), (960, 720)])
def test_what_holds_for_both_polygons_is_said_once(size: tuple[int, int]) -> None:
    sheet = vad.draw(vad.solve(vad.RSSR()))
    lasting = [item for item in planned(sheet, size).items if item.region.endswith("foot")]
    marks = [mark for item in lasting for mark in item.marks if mark.role == "notes"]
    said = " ".join("".join(run.text for run in mark.shape.runs) for mark in marks)
    assert said.startswith("in the plane of BC") and said.count("plane") == 1
    symbols = [cell.symbol for row in sheet.rows for cell in row.cells.get("velocity", ())]
    assert len(set(symbols)) == len(symbols)


@pytest.mark.parametrize("language", ["en", "de", "fr"])
def test_rows_that_need_much_room_keep_their_words_at_four_to_three(language: str) -> None:
    sheet = vad.draw(vad.solve(vad.SpatialFourBar()), language=language)
    items = [item for item in planned(sheet, (960, 720)).items if item.region == "results"]
    shapes = [mark.shape for item in items for mark in item.marks]
    texts = [
        "".join(run.text for run in shape.runs) for shape in shapes if isinstance(shape, Lettering)
    ]
    for row in sheet.rows:
        assert any(text.startswith(f"{row.title} {row.letters}") for text in texts)


def test_a_leader_ends_at_the_rim_of_a_point():
    sketch = planned(vad.draw(vad.solve(vad.HookeJoint()))).sketches["position"]
    found = {}
    for name in ("T.found", "T.plan"):
        own = [m for item in sketch.items if item.stroke == f"position:{name}" for m in item.marks]
        dots = [m.shape for m in own if m.role == "point" and isinstance(m.shape, Disc)]
        for end in (m.shape.pieces[0][0] for m in own if m.role == "leader"):
            found[name] = abs(end - dots[-1].centre) - dots[-1].radius
    assert "T.plan" in found
    assert all(abs(gap) < 1.5 * PIXEL for gap in found.values()), found


def test_the_arrow_of_omega_keeps_off_a_ball():
    sheet = vad.draw(vad.solve(vad.SphericalFourBar()))
    sketch = planned(sheet).sketches["position"]
    angle = next(s for s in sketch.setting.panel.strokes if s.name == "AB.angle")
    ball = next(s.shape for s in sketch.setting.panel.strokes if s.name == "outline")
    assert isinstance(ball, Ellipse)
    rose = sketch.solved.place(Anchor.of(angle.name, "centre"))
    middle = sketch.scale(ball.centre)
    toward = math.degrees(cmath.phase(middle - rose))
    beyond = abs(middle - rose) - abs(ball.first) * sketch.scale.factor
    for turn, apt in ((0.0, False), (180.0, True)):
        place = SensePlace(beyond + 0.01, 40.0, toward + turn)
        assert beside_own(sketch, angle, place) == apt


def test_the_name_of_an_axis_stands_at_its_own_end():
    sketch = planned(vad.draw(vad.solve(vad.SpatialFourBar()))).sketches["position"]
    tips, origin = {}, next(vertex.at for vertex in sketch.vertices if "O" in vertex.letters)
    for stroke in sketch.setting.panel.strokes:
        if stroke.label in ("OA", "OB", "OC", "OD") and isinstance(stroke.shape, Curve):
            ends = map(sketch.scale, stroke.shape.points)
            tips[stroke.label] = max(ends, key=lambda end: abs(end - origin))
    assert len(tips) == 4
    for label in ("OA", "OB", "OD"):
        (tag,) = (tag for tag in sketch.tags if tag.text == label)
        assert min(tips, key=lambda each: distance(tag.box, tips[each])) == label
