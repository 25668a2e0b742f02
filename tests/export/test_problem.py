"""Problem sheets: what is left to be drawn, and a key on which all stands where it stood."""

from __future__ import annotations

import re
from functools import cache
from itertools import pairwise
from pathlib import Path

import pytest

import vad
from tests.painting.readers import pdf_text
from vad.errors import UsageError, VadError
from vad.files.examples import example_path
from vad.mechanisms import Mechanism
from vad.painting.posed import Posed, posed
from vad.plan.board import reach
from vad.plan.geometry import Rect
from vad.plan.items import TASK, Item, Level
from vad.plan.marks import Bow, Lettering, Mark, Polygon, Polyline
from vad.plan.page.task import SMALLEST
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.sheet import Cell, Sheet
from vad.strokes.task import task
from vad.words import Language

ASKED = ("velocity", "acceleration")
PAGES: dict[str, dict[str, object]] = {
    "wide": {},
    "4:3": {"size": (1024, 768), "style": "print"},
    "A4": {"paper": "A4"},
}
SCENES: dict[str, Mechanism] = {
    "slider-crank": vad.SliderCrank(),
    "four-bar": vad.FourBar(),
    "trammel": vad.EllipticalTrammel(),
    "gate": vad.GateActuator(),
    "shaper": vad.CrankSlottedLever(rod=100, ram_height=180),
}
#: Polygons that begin and that end with their pole, given cells beside asked ones, two loops.
CASES = (("slider-crank", "wide"), ("trammel", "wide"), ("gate", "4:3"), ("shaper", "A4"))


def sheet_of(name: str, **inputs: float) -> Sheet:
    return vad.draw(vad.solve(SCENES[name], **inputs))


@cache
def pair(name: str, page: str) -> tuple[Posed, Posed]:
    """Return a problem and its key."""
    sheet = sheet_of(name)
    return posed(sheet, **PAGES[page], blank=ASKED), posed(sheet, **PAGES[page])


def shown(page: Posed, region: str = "", answers: bool = True) -> list[Mark]:
    """Return the marks of a picture, or of one part of its page; perhaps without those asked for.

    On the mechanism stand the senses of rates that are found.
    """
    items = [item for item in page.board.shown(page.moment.beat) if region in ("", item.region)]
    if not answers:
        items = [item for item in items if item.stroke.partition(":")[0] not in ASKED]
    return [mark for item in items for mark in item.marks]


def words(marks: list[Mark]) -> list[str]:
    shapes = [mark.shape for mark in marks]
    return ["".join(run.text for run in s.runs) for s in shapes if isinstance(s, Lettering)]


def cells_of(sheet: Sheet, *panels: str) -> list[Cell]:
    return [cell for row in sheet.rows for name in panels for cell in row.cells.get(name, ())]


@pytest.mark.parametrize(("name", "page"), CASES)
def test_the_key_has_all_of_the_problem_at_the_same_places(name: str, page: str) -> None:
    problem, whole = pair(name, page)
    key = {(mark.shape, mark.role, mark.row) for mark in shown(whole)}
    own = [mark for mark in shown(problem) if mark.role != "writing line"]
    own = [mark for mark in own if mark not in shown(problem, TASK)]
    assert all((mark.shape, mark.role, mark.row) in key for mark in own)


@pytest.mark.parametrize(("name", "page"), CASES)
def test_a_blank_panel_holds_its_pole_and_its_scale(name: str, page: str) -> None:
    problem, key = pair(name, page)
    for panel in ASKED:
        (pole,) = (
            s.label.replace(",", ", ") for s in key.sheet.panel(panel).strokes if s.name == "pole"
        )
        assert words(shown(problem, panel)) == [pole]
        assert [mark.role for mark in shown(problem, panel)] == ["dot", "letter"]
        assert shown(problem, f"{panel} foot") == []
        assert shown(problem, f"{panel} head") == shown(key, f"{panel} head")
    for region in ("position head", "position foot", "title"):
        assert shown(problem, region) == shown(key, region)
    assert shown(problem, "position") == shown(key, "position", answers=False)


def test_the_letter_of_a_pole_in_an_empty_panel_stands_beside_it() -> None:
    sheet = vad.draw(vad.solve(vad.load(example_path("beam-engine"))()))
    problem, key = (posed(sheet, size=(960, 720), **more) for more in ({"blank": ASKED}, {}))
    for panel in ASKED:
        assert [mark.role for mark in shown(key, panel)].count("leader") > 0
        dot, letter = shown(problem, panel)
        assert (dot.role, letter.role) == ("dot", "letter")
        pole, place = box(dot), box(letter)
        assert apart(pole, place) and not apart(pole.inside(-0.01), place)
        drawing = problem.board.page.panels[panel].drawing
        assert drawing.holds(complex(place.left, place.bottom))
        assert drawing.holds(complex(place.right, place.top))


@pytest.mark.parametrize(("name", "page"), CASES)
def test_what_is_asked_has_a_line_to_be_written_on(name: str, page: str) -> None:
    problem, key = pair(name, page)
    table = shown(problem, "results")
    lines = [mark.shape.pieces[0] for mark in table if mark.role == "writing line"]
    assert len(lines) == sum(not cell.given for cell in cells_of(key.sheet, *ASKED))
    area = problem.board.regions["results"]
    for start, end in lines:
        assert area.holds(start) and area.holds(end)
        assert end.real - start.real > 0.04
    for one, other in pairwise(sorted(lines, key=_reading)):
        assert one[1].real < other[0].real or one[0].imag > other[0].imag


def _reading(line: tuple[complex, complex]) -> tuple[float, float]:
    return -line[0].imag, line[0].real


def box(mark: Mark) -> Rect:
    return reach([Item("", TASK, Level.GROUND, (mark,))])


def apart(one: Rect, other: Rect) -> bool:
    beside = one.right <= other.left or other.right <= one.left
    return beside or one.top <= other.bottom or other.top <= one.bottom


def on(place: Rect, mark: Mark) -> bool:
    """Tell whether a mark reaches into a place: a stroke may run diagonally past it."""
    match mark.shape:
        case Polyline(pieces) | Polygon(pieces):
            segments = [pair for piece in pieces for pair in pairwise((*piece, piece[-1]))]
            return any(place.clipped(*pair) for pair in segments)
        case Bow():
            return any(place.clipped(*pair) for pair in pairwise(mark.shape.curve()))
        case _:
            return not apart(place, box(mark))


@pytest.mark.exhaustive(16)
@pytest.mark.parametrize("language", ["en", "de", "fr"])
@pytest.mark.parametrize("page", [*PAGES, "upright"])
@pytest.mark.parametrize("name", ["slider-crank", "four-bar", "whitworth"])
def test_a_task_and_a_name_stand_where_the_key_is_free(name: str, page: str, language: str) -> None:
    machine = SCENES.get(name, vad.Whitworth(rod=300))
    sheet = vad.draw(vad.solve(machine), language=language)
    look = PAGES.get(page, {"paper": "A4-portrait"})
    problem = posed(sheet, **look, blank=ASKED)
    own = shown(problem, TASK)
    say = Language(language).say
    texts = words(own)
    assert texts[0] == say("name") and texts[1] == say("class") and len(texts) > 2
    assert sum(mark.role == "writing line" for mark in own) == 2
    whole = Rect(0.0, 0.0, problem.board.form.width, problem.board.form.height)
    others = [mark for mark in shown(problem) if mark not in own]
    asked = [problem.board.page.panels[panel].drawing for panel in ASKED]
    assert (
        min(whole.top - box(m).top for m in own) > 0.008 and min(box(m).bottom for m in own) > 0.01
    )
    for mark in own:
        place = box(mark)
        assert whole.left <= place.left and place.right <= whole.right
        assert whole.bottom <= place.bottom and place.top <= whole.top
        assert all(apart(place, drawing) for drawing in asked)
        assert not any(on(place, other) for other in others)
    for number, mark in enumerate(own):
        assert all(apart(box(mark), box(other)) for other in own[:number])
    assert say("working") in texts or "paper" not in look
    assert not shown(posed(sheet, **look), TASK)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", ["beam-engine", "pin-on-rocker"])
def test_a_title_as_wide_as_the_page_leaves_lines_for_a_name(name: str) -> None:
    sheet = vad.draw(vad.solve(vad.load(example_path(name))()), language="de")
    problem = posed(sheet, size=(960, 720), blank=ASKED)
    own, others = shown(problem, TASK), shown(problem)
    assert sum(mark.role == "writing line" for mark in own) == 2
    others = [mark for mark in others if mark not in own]
    assert not any(on(box(mark), other) for mark in own for other in others)


def test_a_task_says_what_is_given_drawn_and_found() -> None:
    said = " ".join(words(shown(pair("four-bar", "A4")[0], TASK)))
    assert "Given: θ2 = 60°, ω2 = 10 rad/s and α2 = 0 rad/s2." in said.replace("\xa0", " ")
    assert "Draw the velocity polygon and the acceleration polygon" in said
    assert "find ω3, α3, ω4 and α4." in said.replace("\xa0", " ")


def test_a_task_gives_the_rates_and_all_that_bears_upon_forces() -> None:
    at_g = {"rod": {"mass": 0.8, "at": "G", "inertia": 0.001}, "slider": 0.5}
    motion = vad.solve(vad.SliderCrank(points={"G": ("rod", 50)}), omega=100)
    found = vad.forces(motion, ["800 N @ 180 at C", "2 N m on rod"], at_g, 9.81, {"slider": 0.1})
    asked = ("acceleration", "force", "drive")
    first, *shorter = ("".join(each.text for each in form) for form in task(vad.draw(found), asked))
    bodies = (
        "m₃ = 0.8 kg at G, I₃ = 0.001 kg·m² about G, m₄ = 0.5 kg at C, g = 9.81 m/s² and μ₄ = 0.1."
    )
    assert "Given: θ₂ = 60°, ω₂ = 100 rad/s, α₂ = 0 rad/s², P = 800 N, W₃ = 7.848 N, W₄" in first
    assert bodies in first
    for each in shorter:  # the rest stands in the table
        assert "ω₂ = 100 rad/s, W₄ = 4.905 N, " in each and bodies in each


def test_the_numbers_of_a_shaft_have_the_names_of_its_masses() -> None:
    sheet = vad.draw(vad.solve(vad.load(example_path("shaft-two-planes"))()))
    first, *_, last, _ = (
        "".join(each.text for each in form) for form in task(sheet, ["couple", "force"])
    )
    assert "m_A = 200 kg, r_A = 80 mm, θ_A = 0°, l_A = 0 mm, m_B = 300 kg" in first
    assert "m_D = 200 kg, r_D = 80 mm" in first and "and find M_X, mr_X, M_Y and mr_Y." in first
    assert "Given: r_A = 80 mm, l_A = 0 mm, r_B = 70 mm" in last


def test_a_task_has_the_dimensions_for_which_the_title_has_no_room() -> None:
    sheet = vad.draw(vad.solve(vad.load(example_path("beam-engine"))()), language="fr")
    board = posed(sheet, blank=ASKED)
    said = " ".join(words(shown(board, TASK))).replace("\xa0", " ")
    assert "Autres dimensions : Rx −900 mm et Ry −300 mm." in said
    titled = words(shown(board, "title"))
    assert not any("Rx" in line or "Ry" in line for line in titled)
    assert titled[1].endswith("Oy −1000 mm,   …")


def test_a_task_asks_for_nothing_twice() -> None:
    sheet = vad.draw(vad.solve(vad.FourBar()), panels=("turned", "velocity"))
    (first, *_) = task(sheet, ["turned"])
    said = "".join(piece.text for piece in first)
    assert said.startswith(
        "Given: θ₂ = 60° and ω₂ = 10 rad/s. Draw the turned velocities to the given scale"
    )
    assert said.count("ω₃") == said.count("ω₄") == 1


@pytest.mark.parametrize("language", ["en", "de", "fr"])
@pytest.mark.parametrize("name", DIAGRAMS)
def test_every_kind_of_panel_has_a_name_in_a_task(name: str, language: str) -> None:
    assert Language(language).say(f"task {name}")


@pytest.mark.exhaustive(6)
@pytest.mark.parametrize("name", ["four-bar", "watt-2", "scissor-lift", "gate", "trammel"])
def test_a_problem_at_four_to_three_has_the_page_of_its_key(name: str) -> None:
    machine = SCENES.get(name) or vad.load(example_path(name))()
    sheet = vad.draw(vad.solve(machine))
    asked, key = (posed(sheet, size=(960, 720), **more) for more in ({"blank": ASKED}, {}))
    assert asked.board.page == key.board.page
    task = [mark.shape for mark in shown(asked, TASK) if mark.role == "words"]
    assert task and min(line.size for line in task) >= SMALLEST[-1]


@pytest.mark.exhaustive(12)
@pytest.mark.parametrize("size", [(1280, 720), (960, 720)])
@pytest.mark.parametrize("name", ["toggle-press", "watt-2", "shaper", "beam-engine"])
def test_a_task_is_never_left_out(name: str, size: tuple[int, int]) -> None:
    sheet = vad.draw(vad.solve(vad.load(example_path(name))()))
    texts = words(shown(posed(sheet, size=size, blank=ASKED), TASK))
    assert any(text.startswith(("Draw", "Given", "Further", "Measure")) for text in texts)


def test_a_task_of_ones_own(folder: Path) -> None:
    sheet = sheet_of("slider-crank")
    vad.save(sheet, "own.svg", blank=ASKED, task="Find the speed of C.", text="letters")
    assert "Find the speed of C." in Path("own.svg").read_text("utf-8")
    bare = posed(sheet, blank=ASKED, task=False)
    assert not shown(bare, TASK)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"blank": ASKED, "task": "word " * 80}, "task: has 399 letters; this page has no room"),
        ({"blank": ASKED, "task": "a" * 500}, "task: has 500 letters"),
        ({"blank": ASKED, "task": " "}, "task: is empty"),
        ({"task": "Find v."}, "task: is for a problem sheet"),
    ],
)
def test_a_task_that_cannot_be(folder: Path, options: dict[str, object], message: str) -> None:
    with pytest.raises(VadError, match=re.escape(message)):
        vad.save(sheet_of("slider-crank"), "a.png", **options)
    assert not list(folder.iterdir())


def test_no_answer_is_in_the_file(folder: Path) -> None:
    sheet = sheet_of("slider-crank", alpha=20)
    for name in ("problem.pdf", "problem.svg", "problem.png"):
        vad.save(sheet, name, blank=ASKED)
    answers = [f"{abs(cell.value):.4g}" for cell in cells_of(sheet, *ASKED) if not cell.given]
    svg, pdf = Path("problem.svg").read_text("utf-8"), pdf_text(Path("problem.pdf").read_bytes())
    png = Path("problem.png").read_bytes()
    for answer in answers:
        assert not re.search(rf"(?<![\d.]){re.escape(answer)}(?!\d)", pdf)
        assert f"= {answer}" not in svg and f"= −{answer}" not in svg
        assert f"= {answer}".encode() not in png
    assert "rod BC" in pdf and "20" in pdf
    assert "velocity:BC.line" not in svg and 'data-stroke="velocity:pole"' in svg


def test_a_position_is_drawn_from_its_fixed_points() -> None:
    problem = posed(sheet_of("four-bar"), blank="position")
    assert sorted(words(shown(problem, "position"))) == ["A", "D"]
    assert {mark.role for mark in shown(problem, "position")}.isdisjoint({"bar", "angle"})
    assert "60°" in words(shown(problem, "results"))


def test_a_driver_that_stands_still_asks_all_the_same() -> None:
    problem = posed(sheet_of("four-bar", omega=0), blank="velocity")
    assert sum(mark.role == "writing line" for mark in shown(problem, "results")) == 2


@pytest.mark.parametrize(
    ("name", "blank", "message"),
    [
        ("a.pdf", ("velocty",), "unknown panel 'velocty'"),
        ("a.png", 3, "blank: must be names of panels, got 3"),
        ("a.json", ("velocity",), "blank: .json has no such option"),
    ],
)
def test_what_cannot_be(folder: Path, name: str, blank: object, message: str) -> None:
    with pytest.raises(UsageError, match=re.escape(message)):
        vad.save(sheet_of("four-bar"), name, blank=blank)
    assert not list(folder.iterdir())


def test_a_panel_that_is_not_on_the_sheet(folder: Path) -> None:
    sheet = vad.draw(vad.solve(vad.FourBar()), panels="position")
    with pytest.raises(UsageError, match="unknown panel 'velocity'"):
        vad.save(sheet, "a.png", blank="velocity")
    still = vad.still(vad.animate(sheet), 2)
    with pytest.raises(UsageError, match="blank: not for a step of a lesson"):
        vad.save(still, "a.png", blank="position")


def strokes_on(panel: str, asked: tuple[str, ...], **masses: object) -> set[str]:
    machine = vad.FourBar(points={"E": ("rocker", 40), "G": ("coupler", 40)})
    sheet = vad.draw(vad.forces(vad.solve(machine), ["80 N @ 150 at E"], masses or None))
    page = posed(sheet, blank=asked)
    items = page.board.shown(page.moment.beat)
    return {item.stroke for item in items if item.region == panel}


def test_lines_of_forces_are_left_to_be_found() -> None:
    there = strokes_on("position", ("force", "drive"))
    assert "position:P3E.load" in there or "position:P4E.load" in there
    assert not [name for name in there if ":dyad" in name]
    assert [name for name in strokes_on("position", ("drive",)) if ":dyad" in name]


def test_inertia_forces_are_left_where_the_accelerations_are() -> None:
    coupler = {"mass": 1, "at": "G", "inertia": 5e-4}
    there = strokes_on("position", ("acceleration", "force", "drive"), coupler=coupler)
    assert "position:P4E.load" in there
    assert not [name for name in there if ":I3G" in name or ":C3" in name]
    assert "position:I3G.load" in strokes_on("position", ("force",), coupler=coupler)


def test_a_batch_writes_the_task_upon_the_problem_alone(folder: Path) -> None:
    lines = ['mechanism = "four-bar"', "count = 1", 'files = ["problem.svg", "key.svg"]']
    own = 'task = "Find the velocity of C."'
    Path("one.toml").write_text("\n".join(["[sheet]", *lines, own]), "utf-8")
    vad.batch("one.toml", "made")
    assert "Find the velocity of C." in Path("made/001-problem.svg").read_text("utf-8")
    assert "Find the velocity of C." not in Path("made/001-key.svg").read_text("utf-8")


def test_lines_to_write_on_do_not_tell_how_long_a_number_is():
    """Numbers stand with their decimal points one below the other, but lines begin together."""
    problem = posed(sheet_of("shaper"), blank=ASKED)
    lines = [m.shape.pieces[0] for m in shown(problem, "results") if m.role == "writing line"]
    lefts = {round(line[0].real, 9) for line in lines}
    firsts = [x for x in lefts if sum(round(line[0].real, 9) == x for line in lines) > 1]
    assert len(lines) == 9 and len(firsts) == 2 and len(lefts) == 3
