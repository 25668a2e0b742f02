"""The page of a turn: hodographs, curves with a cursor, the clock, and the still with numbers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import vad
from tests.plan.turns import LEG, WHITWORTH, board_of
from vad.cli.run import run
from vad.files.examples import example_path
from vad.plan.anchors import Beside
from vad.plan.format import paper, screen
from vad.plan.hodographs import TOLERANCE, thinned
from vad.plan.items import Item
from vad.plan.layout import rooms
from vad.plan.marks import Disc, Lettering, Mark, Polyline
from vad.plan.pictures import over_turn
from vad.plan.pictures.inset import SIZES, draw_inset
from vad.plan.pictures.polygon import Polygon
from vad.plan.turn_board import NumberedTurn, TurnBoard
from vad.plan.turn_layout import lay_out_turn
from vad.plan.turn_panel import FAINT
from vad.strokes.diagram import Spot
from vad.strokes.sheet import Arrow

pytestmark = pytest.mark.exhaustive


@pytest.fixture(scope="module")
def board() -> TurnBoard:
    return board_of(WHITWORTH)


def marks(items: list[Item], role: str, region: str = "") -> list[Mark]:
    return [m for i in items if i.region.startswith(region) for m in i.marks if m.role == role]


def texts(items: list[Item], region: str) -> list[str]:
    shapes = [m.shape for i in items if i.region == region for m in i.marks]
    written = [shape for shape in shapes if isinstance(shape, Lettering)]
    return ["".join(run.text for run in text.runs if run.shown) for text in written]


def points(found: list[Mark]) -> list[complex]:
    shapes = [mark.shape for mark in found if isinstance(mark.shape, Polyline)]
    return [z for shape in shapes for piece in shape.pieces for z in piece]


def test_each_panel_has_its_picture_above_its_curve(board: TurnBoard):
    shown = board.shown(0)
    for name, chart in board.charts.items():
        assert chart.box.top < board.page.panels[name].drawing.bottom
        for role in ("curve", "curve ahead", "cursor", "return"):
            assert marks(shown, role, f"{name} curve"), (name, role)
        assert marks(shown, "hodograph", name)
    assert not marks(shown, "term", "velocity foot")


@pytest.mark.parametrize("frame", [0, 57, 130, 239])
def test_the_dark_curve_ends_at_the_cursor_with_the_value_of_the_pose(board: TurnBoard, frame: int):
    shown, sheet = board.shown(frame), board.turn.pose(frame)
    ram = next(row for row in sheet.rows if row.key == "ram")
    for name, chart in board.charts.items():
        region = f"{name} curve"
        (cursor,) = marks(shown, "cursor", region)
        x = points([cursor])[0].real
        (dot,) = (m.shape for m in marks(shown, "dot", region) if isinstance(m.shape, Disc))
        value = ram.cells[name][0].value
        low, high = chart.box.bottom, chart.box.top
        values = board.cycle.curves[name].values
        share = (value - values.min()) / (values.max() - values.min())
        assert dot.centre == pytest.approx(complex(x, low + share * (high - low)), abs=1e-4)
        dark = points(marks(shown, "curve", region))
        assert dark[-1] == pytest.approx(dot.centre)
        assert max(z.real for z in dark) <= x + 1e-9


def test_the_vertices_leave_the_hodographs_on_which_they_run(board: TurnBoard):
    for frame in (0, 80, 160):
        shown = board.shown(frame)
        for name in board.charts:
            ways = np.array(points(marks(shown, "hodograph", name)))
            tails = marks(shown, "tail", name)
            assert tails
            assert max(m.alpha for m in tails) == 1.0
            for tail in tails:
                for z in points([tail])[1:-1]:
                    assert abs(ways - z).min() < 0.02


def test_the_clock_says_which_way_the_ram_runs(board: TurnBoard):
    """At 60° forward, at 240° back: by the textbook cos 63.6° = 40/90, and 2 · 63.6° = 127°."""
    words = ["forward 233°", "return 127°", "ratio 1.83"]
    for frame, dark in ((0, "forward 233°"), (120, "return 127°")):
        shown = board.shown(frame)
        assert [text for text in texts(shown, "position") if text in words] == words
        roles = {
            "".join(run.text for run in m.shape.runs): m.role
            for i in shown
            for m in i.marks
            if isinstance(m.shape, Lettering)
        }
        assert [word for word in words if roles[word] == "words"] == [dark]
    assert "stroke 120 mm" in texts(board.shown(0), "position")


LAW = {
    "en": "as the sine of the time, not uniformly",
    "de": "als Sinus der Zeit, nicht gleichförmig",
    "fr": "comme le sinus du temps, non uniformément",
}


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "crank AB swings between 16.5° and 117.0°"),
        ("de", "Kurbel AB schwingt zwischen 16,5° und 117,0°"),
        ("fr", "manivelle AB oscille entre 16,5° et 117,0°"),
    ],
)
def test_a_crank_that_cannot_go_round_says_so_and_how_it_moves(language: str, said: str):
    turn = vad.turn(vad.FourBar(crank=130), panels="position", language=language)
    board = TurnBoard(turn)
    written = texts(board.shown(0), "position")
    assert {said, LAW[language]} <= set(written)
    place = board.cycle.place.values
    low, high = turn.course.ends
    swing = (low + high) / 2 - (high - low) / 2 * np.cos(2 * np.pi * board.cycle.shares)
    assert place == pytest.approx(swing)
    notes = [m.shape for m in marks(board.shown(0), "notes", "position")]
    law = next(s for s in notes if isinstance(s, Lettering) and s.runs[0].text == LAW[language])
    assert law.at.imag > board.panels["position"].room.top


@pytest.mark.parametrize(
    ("name", "swings"),
    [("scissor-lift", True), ("peaucellier", True), ("tipper", True), ("shaper", False)],
)
def test_only_a_driver_that_cannot_go_round_moves_as_a_sine(name: str, swings: bool):
    board = TurnBoard(vad.turn(vad.load(example_path(name))(), panels="position"))
    assert (LAW["en"] in texts(board.shown(0), "position")) == swings


def test_units_are_the_same_in_all_poses_of_a_turn():
    """Where 1e5 mm/s² are passed at times only, metres are written all through."""
    turn = vad.turn(vad.solve(vad.SliderCrank(crank=40), omega=50), panels="acceleration")
    board = TurnBoard(turn)
    assert {turn.pose(frame).notation.metres for frame in range(0, 240, 20)} == {True, False}
    for frame in range(0, 240, 20):
        shown = board.shown(frame)
        written = [*texts(shown, "acceleration curve"), *texts(shown, "acceleration head")]
        assert sum(text.endswith("m/s2") for text in written) == 2  # raised, as a run
        assert not any("mm/s" in text for text in written)


def test_a_polygon_shows_whole_vectors_and_few_letters(board: TurnBoard):
    names = {name: {label.text for label in p.labels.names} for name, p in board.panels.items()}
    assert names == {
        "position": {"A", "B", "C", "D", "E"},
        "velocity": {"a, d", "b", "q", "c", "e"},
        "acceleration": {"a′, d′", "b′", "z", "q′", "c′", "e′", "2ωv"},
    }


def test_of_a_leg_the_foot_alone_has_a_path_and_links_without_it_are_pale():
    leg = board_of(LEG)
    shown = leg.shown(40)
    for name, panel in leg.panels.items():
        assert len(marks(shown, "hodograph", name)) == 1, name
        stands, way = points(marks(shown, "return way", name)), panel.hodographs
        (spot,) = panel.ways
        stance = leg.cycle.stance
        assert stance is not None
        assert stands[0] == pytest.approx(way.at(spot, 0.0))
        assert stands[-1] == pytest.approx(way.at(spot, stance.part))
    bars = {i.stroke: m.alpha for i in shown for m in i.marks if m.role == "bar"}
    assert {name for name, alpha in bars.items() if alpha == 1.0} >= {"position:AB.bar"}
    assert {alpha for name, alpha in bars.items() if "BD" in name or "BF" in name} == {FAINT}
    written = texts(shown, "position")
    assert written[-3:] == ["stance 168°", "swing 192°", "lift 22.46 mm"]
    lowest = min(z.imag for z in points(marks(shown, "tail", "position")))
    assert min(z.imag for z in points(marks(shown, "rail", "position"))) < lowest  # the ground
    assert any(text.endswith("after touch-down") for text in texts(shown, "position curve"))


def test_rare_peaks_leave_the_panel_and_the_curve_keeps_them():
    parallelogram = vad.FourBar(ground=100, crank=40, coupler=100, rocker=40)  # it folds
    board = TurnBoard(vad.turn(parallelogram, panels="acceleration"))
    panel, curve = board.panels["acceleration"], board.cycle.curves["acceleration"].values
    ways = np.concatenate(list(panel.hodographs.tracks.values()))
    assert not all(panel.room.holds(z) for z in ways)
    seen = points(marks(board.shown(0), "hodograph", "acceleration"))
    assert all(panel.room.holds(z) for z in seen)
    top = max(z.imag for z in points(marks(board.shown(0), "curve ahead")))
    assert board.charts["acceleration"].at(0.0, curve.max()).imag == pytest.approx(top, abs=2e-4)


@pytest.mark.parametrize("form", [screen((1280, 720)), screen((960, 720)), paper("A4")])
def test_the_still_of_a_turn_numbers_twelve_positions(form):
    turn = vad.turn(vad.SliderCrank(), panels=("velocity", "acceleration"))
    still = NumberedTurn(turn, form)
    shown = still.shown(0)
    numbers = [str(number) for number in range(1, 13)]
    for name in ("velocity", "acceleration"):
        assert set(numbers) <= set(texts(shown, name))
        assert [t for t in texts(shown, f"{name} curve") if t in numbers] == [*numbers, "1"]
        way = still.panels[name].hodographs
        dots = [m.shape for m in marks(shown, "position", name) if isinstance(m.shape, Disc)]
        for number in range(12):
            pose = way.at(Spot("b" if name == "velocity" else "b′"), number / 12)
            assert min(abs(dot.centre - pose) for dot in dots) < 1e-9
    assert not marks(shown, "cursor")


def test_numbers_there_and_back_stand_on_either_side_of_a_straight_way():
    """At 2 and 12, and at 4 and 10, the slider has the same acceleration."""
    still = NumberedTurn(vad.turn(vad.SliderCrank(), panels="acceleration"))
    way = still.panels["acceleration"].hodographs
    (axis,) = {round(way.at(Spot("c′"), k / 12).imag, 9) for k in range(12)}
    numerals = marks(still.shown(0), "numeral", "acceleration")
    row = way.row(Spot("c′"))
    sides = {
        "".join(run.text for run in mark.shape.runs): mark.shape.at.imag - axis
        for mark in numerals
        if mark.row == row
    }
    assert sides["2"] > 0 > sides["12"]
    assert sides["4"] > 0 > sides["10"]


def test_the_page_fits_every_shape():
    for size in ((1280, 720), (960, 720), (720, 720), (720, 960), (2560, 1080)):
        layout = lay_out_turn(screen(size), ["position", "velocity", "acceleration"])
        boxes = [p.drawing for p in layout.page.panels.values()] + list(layout.charts.values())
        for number, box in enumerate(boxes):
            assert 0 < box.left < box.right < layout.page.width
            assert 0 < box.bottom < box.top < layout.page.height
            for other in boxes[:number]:
                apart = box.left >= other.right or other.left >= box.right
                assert apart or box.bottom >= other.top or other.bottom >= box.top
    with pytest.raises(vad.UsageError, match="no room"):
        lay_out_turn(screen((1280, 720)), [str(number) for number in range(60)])


def test_a_thinned_line_is_nowhere_off():
    share = np.linspace(0.0, 1.0, 721)
    line = 0.2 * np.exp(2j * np.pi * share) + 0.01 * np.exp(-6j * np.pi * share)
    kept = thinned(line)
    assert len(kept) < 0.5 * len(line)
    starts, ends = line[kept][:-1], line[kept][1:]
    chords = ends - starts
    along = np.clip(((line[:, None] - starts) * chords.conj()).real / np.abs(chords) ** 2, 0, 1)
    assert abs(line[:, None] - starts - along * chords).min(axis=1).max() <= TOLERANCE


def test_a_turn_is_drawn_on_the_command_line(tmp_path, capsys):
    words = ["draw", "scotch-yoke", "--turn", "--panels", "velocity", "-o"]
    assert run([*words, f"{tmp_path}/turn.pdf", "--paper", "A4"]) == 0
    assert (tmp_path / "turn.pdf").read_bytes().startswith(b"%PDF")
    for wrong, said in (
        ("turn.json", "a turn cannot be saved as"),
        ("turn.mp4", "a picture cannot be saved as"),
        ("turn.pdf --blank velocity", "--blank is for one pose"),
        ("turn.pdf --at 30,60", "choose one of them"),
    ):
        name, *more = wrong.split()
        assert run([*words, f"{tmp_path}/{name}", *more]) == 2
        assert said in capsys.readouterr().err


def test_a_letter_hangs_on_the_point_beside_it_in_each_view():
    board = TurnBoard(vad.turn(vad.RSSR(), fps=10))
    for frame in (0, 25, 50):
        for panel in board.turn.pose(frame).halves:
            sketch = board.panels[panel.name].pose(panel, frame / board.turn.frames)
            letters = [m for i in sketch.items for m in i.marks if m.role == "letter"]
            assert letters
            for mark in letters:
                assert isinstance(mark.hangs, Beside)
                assert abs(mark.hangs.offset) < 0.12


def test_of_two_polygons_in_a_column_none_is_cut_off():
    board = board_of(vad.SpatialFourBar())
    for name, panel in board.panels.items():
        ways = np.concatenate(list(panel.hodographs.tracks.values()))
        assert all(panel.room.holds(z) for z in ways), name
        below = min(z.imag for z in ways) - panel.room.bottom
        assert below > 0.05 or not name.endswith(".below"), name  # above its scale bar


def test_two_polygons_stand_side_by_side_where_they_are_larger_so():
    board = board_of(vad.SpatialFourBar())
    poses = [board.turn.at(number / 24) for number in range(24)]
    for name in ("velocity", "acceleration"):
        first, second = (board.panels[name + each] for each in ("", ".below"))
        assert first.room.right == second.room.left
        whole, size = replace(first.room, right=second.room.right), 1.0
        setting = first.picture.still.setting
        for half, room in rooms(board.sheet.panel(name), whole):  # one above the other
            same = [pose.panel(half.name) for pose in poses]
            size *= over_turn(replace(setting, panel=half, room=room), same).scale.factor
        assert first.scale.factor * second.scale.factor > 1.2 * size


def test_a_polygon_makes_way_for_the_speeds_over_a_turn():
    """They have their full size, and no vector of any pose meets them."""
    board = board_of(vad.HookeJoint())
    polygon = board.panels["velocity"].picture
    assert isinstance(polygon, Polygon)
    place = polygon._inset
    assert place is not None
    assert place.size == max(SIZES)
    panel = board.sheet.panel("velocity")
    assert panel.inset is not None
    setting = polygon.still.setting
    box = draw_inset(panel.inset, setting, place.size, np.inf).box.moved(place.corner.origin)
    assert setting.room.holds(complex(box.left, box.bottom), 1e-6)
    assert setting.room.holds(complex(box.right, box.top), 1e-6)
    for frame in range(0, 240, 20):
        strokes = [
            polygon.scale(end)
            for stroke in board.turn.pose(frame).panel("velocity").strokes
            if isinstance(stroke.shape, Arrow)
            for end in (stroke.shape.start, stroke.shape.end)
        ]
        assert not any(box.holds(end) for end in strokes)


def test_of_many_hodographs_a_film_has_those_of_crank_and_output_and_the_tails_of_all():
    turn = vad.turn(vad.load(example_path("watt-1"))(), panels="velocity")
    film, still = TurnBoard(turn), NumberedTurn(turn)
    panel, shown = film.panels["velocity"], film.shown(0)
    assert {spot.letter for spot in panel.ways} == set("bcefg")
    assert len(marks(still.shown(0), "hodograph", "velocity")) == 5
    drawn = points(marks(shown, "hodograph", "velocity"))
    for spot in panel.ways:
        way = panel.hodographs.tracks[spot]
        seen = all(np.abs(np.array(drawn) - z).min() < 0.01 for z in way[::40])
        assert seen == (spot.letter in "bg"), spot
    tails = {mark.row for mark in marks(shown, "tail", "velocity")}
    assert tails >= {panel.hodographs.row(spot) for spot in panel.ways}
