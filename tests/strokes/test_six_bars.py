"""Mechanisms of several dyads: the order of drawing, images of ternary links, equations, plates."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from importlib.resources import files
from typing import Any

import pytest

import vad
from tests.strokes.motions import in_every_language
from vad.strokes.description import parameters
from vad.strokes.sheet import Arrow, Dot, Equation, Line, Panel, Plate, Sheet, Term
from vad.words import text_of

EXAMPLES = sorted(each.name for each in (files("vad") / "examples").iterdir() if each.is_file())
every_example = pytest.mark.parametrize("name", EXAMPLES)


@cache
def kind(name: str) -> Any:
    """Return the class of an example."""
    return vad.load(str(files("vad") / "examples" / name))


@cache
def drawn(name: str) -> tuple[tuple[vad.Motion, Sheet], ...]:
    """Return an example in its own pose, and in another one clockwise and speeding up."""
    mechanism = kind(name)()
    (place, at), (rate, given), (second, _) = mechanism.inputs.items()
    step = 7.0 if place == "angle" else 0.01 * abs(at)
    found = []
    for by, sense in ((0, 1), (1, -1)):
        inputs = {place: at + by * step, rate: sense * given, second: by * 0.7 * given}
        motion = vad.solve(mechanism, **inputs)
        found.append((motion, vad.draw(motion)))
    return tuple(found)


def panels(name: str, *which: str) -> Iterator[tuple[vad.Motion, Panel]]:
    for motion, sheet in drawn(name):
        yield from ((motion, panel) for panel in sheet.panels if panel.name in which)


def labels(name: str, panel: str) -> list[str]:
    return [stroke.label for stroke in drawn(name)[0][1].panel(panel).strokes]


def written(equation: Equation) -> str:
    sides = (" + ".join(term.label for term in side) for side in (equation.left, equation.right))
    return " = ".join(sides)


# --- order ------------------------------------------------------------------------------------


def test_an_image_is_drawn_directly_before_the_dyad_that_needs_it():
    first, second = "a,d ab ⟂BC ⟂DC c bc dc", "⟂BE ⟂CE e ae ⟂DF ⟂CF f df ⟂EG ⟂FG g eg fg"
    found = [label.replace(" ", "") for label in labels("watt-1.toml", "velocity")]
    assert found == [*first.split(), *second.split()]


def test_further_points_of_the_driver_follow_it_and_tracers_come_last():
    assert labels("shaper.toml", "velocity")[:3] == ["a,d,h", "ab", "af"]
    assert labels("jansen-leg.toml", "velocity")[-4:] == ["⟂ FH", "⟂ GH", "h", "ah"]


def test_the_pole_has_all_fixed_points_in_the_order_of_the_file():
    assert labels("landing-gear.toml", "velocity")[0] == "d,a,g"
    assert labels("beam-engine.toml", "acceleration")[0] == "o′,c′,r′"


# --- images -----------------------------------------------------------------------------------


@every_example
def test_the_image_of_a_link_is_similar_to_it_and_lettered_in_the_same_sense(name: str):
    """Similar in the same sense: the two sides at a corner have the same complex ratio."""
    for motion, panel in panels(name, "velocity", "acceleration"):
        for triangle in panel.triangles:
            one, other, third = (motion.point(letter).position for letter in triangle.points)
            p, q, r = triangle.corners
            assert (r - p) / (q - p) == pytest.approx((third - one) / (other - one), rel=1e-12)
            rates = [motion.point(letter) for letter in triangle.points]
            true = [x.velocity if panel.name == "velocity" else x.acceleration for x in rates]
            largest = max(map(abs, true))
            assert all(abs(a - b) <= 1e-12 * largest for a, b in zip((p, q, r), true, strict=True))


def test_ternary_links_have_images():
    assert [t.link for t in drawn("watt-1.toml")[0][1].panels[1].triangles] == ["coupler", "rocker"]
    assert not drawn("toggle-press.toml")[0][1].panels[1].triangles


def test_velocity_lines_are_square_to_the_link_and_acceleration_lines_at_its_angles():
    motion, sheet = drawn("watt-1.toml")[1]
    strokes = {stroke.name: stroke for stroke in sheet.panel("velocity").strokes}
    side = motion.point("E").position - motion.point("B").position
    square: Any = strokes["BE.line"].shape
    assert abs((square.direction.conjugate() * side).real) <= 1e-12 * abs(side)
    strokes = {stroke.name: stroke for stroke in sheet.panel("acceleration").strokes}
    line: Any = strokes["BE.line"].shape
    base = motion.point("C").acceleration - motion.point("B").acceleration
    turned = line.direction / base * abs(base)
    assert turned.imag == pytest.approx(0.5, rel=1e-12)  # 30° from BC, as in the file
    assert strokes["BE.line"].label == "∠ CBE"
    assert "∠CBE = 30°, counter-clockwise from b′c′" in strokes["BE.line"].caption


@pytest.mark.parametrize(
    ("code", "said"),
    [
        ("en", "b′c′e′ is directly similar to BCE: b′e′ = b′c′·BE/BC = "),
        ("de", "b′c′e′ gleichsinnig ähnlich zu BCE: b′e′ = b′c′·BE/BC = "),
        ("fr", "b′c′e′ est directement semblable à BCE : b′e′ = b′c′·BE/BC = "),
    ],
)
def test_the_image_is_said(code: str, said: str):
    sheet = vad.draw(drawn("watt-1.toml")[0][0], panels="acceleration", language=code)
    caption = sheet.panels[0].strokes[sheet.panels[0].number("E.crossing")].caption
    assert said in caption.replace("\N{NO-BREAK SPACE}", " ")


@in_every_language
def test_every_example_is_told_in_every_language(code: str):
    for name in EXAMPLES:
        sheet = vad.draw(drawn(name)[0][0], language=code)
        assert all(stroke.caption for panel in sheet.panels for stroke in panel.strokes)


def test_a_link_that_does_not_turn_has_one_image_for_all_its_points():
    """A parallelogram's coupler: p falls on b, and its lines are not drawn."""
    lengths = {"ground": 100, "crank": 40, "coupler": 100, "rocker": 40}
    points: Any = {"P": ("coupler", 60, 30)}
    motion = vad.solve(vad.FourBar(**lengths, points=points, assembly="parallel"), alpha=3.0)
    turning = vad.draw(vad.solve(vad.FourBar(points=points)))
    for panel in vad.draw(motion).panels[1:]:
        found = panel.strokes[panel.number("P.crossing")]
        assert isinstance(found.shape, Dot) and not panel.triangles
        b = (
            motion.point("B").velocity
            if panel.name == "velocity"
            else motion.point("B").acceleration
        )
        assert found.shape.at == pytest.approx(b, rel=1e-12)
        assert found.caption.startswith("p′ falls on b′" if "′" in found.label else "p falls on b")
        assert {"BP.line", "CP.line"} <= {stroke.name for stroke in panel.zeros}
        names = {stroke.name for stroke in (*panel.strokes, *panel.zeros)}
        other = turning.panel(panel.name)
        assert names == {stroke.name for stroke in (*other.strokes, *other.zeros)}


# --- equations --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "last"),
    [
        ("watt-1.toml", "ae + eg = df + fg"),
        ("jansen-leg.toml", "ce + eg = cf + fg"),
        ("toggle-press.toml", "cb + bd = od"),
        ("shaper.toml", "af + fg = hg"),
        ("pin-on-rocker.toml", "gh = dq + qh"),
        ("trunnion.toml", "ab + bq + qd = 0"),
    ],
)
def test_later_equations_begin_at_vertices_of_the_board(name: str, last: str):
    assert written(drawn(name)[0][1].panel("velocity").equations[-1]) == last


@every_example
def test_every_equation_holds_for_the_vectors_that_are_drawn(name: str):
    for _, panel in panels(name, "velocity", "acceleration"):
        drawn_by = {stroke.name: stroke.shape for stroke in panel.strokes}
        arrows = [shape for shape in drawn_by.values() if isinstance(shape, Arrow)]
        largest = max(abs(arrow.end - arrow.start) for arrow in arrows)

        def vector(term: Term, shapes: Any = drawn_by) -> complex:
            if term.label == "0":
                return 0j
            arrow = shapes[term.stroke]
            assert arrow.tail + arrow.head == term.label
            return complex(arrow.end - arrow.start)

        for equation in panel.equations:
            gap = sum(map(vector, equation.left)) - sum(map(vector, equation.right))
            assert abs(gap) <= 1e-12 * largest, written(equation)


@every_example
def test_letters_in_a_polygon_are_those_of_one_place(name: str):
    """A letter that stands for two places would make the drawing unreadable."""
    for _, panel in panels(name, "velocity", "acceleration"):
        places: dict[str, complex] = {}
        arrows = [stroke.shape for stroke in panel.strokes if isinstance(stroke.shape, Arrow)]
        largest = max(abs(arrow.end - arrow.start) for arrow in arrows)
        for arrow in arrows:
            for letter, at in ((arrow.tail, arrow.start), (arrow.head, arrow.end)):
                assert abs(places.setdefault(letter, at) - at) <= 1e-12 * largest, letter


# --- the position -----------------------------------------------------------------------------


@every_example
def test_plates_have_their_corners_at_their_points(name: str):
    for motion, panel in panels(name, "position"):
        for stroke in panel.strokes:
            if isinstance(stroke.shape, Plate):
                points = [motion.point(letter).position for letter in stroke.shape.letters]
                assert stroke.shape.corners == pytest.approx(points, rel=1e-12)
                assert len(points) >= 3


@pytest.mark.parametrize(
    ("name", "plates"),
    [
        ("watt-1.toml", {"coupler": {*"BCE"}, "rocker": {*"DCF"}}),
        ("jansen-leg.toml", {"upper_plate": {*"CDE"}, "foot": {*"FGH"}}),
        ("toggle-press.toml", {}),
        ("beam-engine.toml", {}),  # its beam has four points in line
    ],
)
def test_a_link_of_three_points_is_a_plate(name: str, plates: dict[str, set[str]]):
    strokes = drawn(name)[0][1].panel("position").strokes
    found = {s.link: {*s.shape.letters} for s in strokes if isinstance(s.shape, Plate)}
    assert found == plates


@every_example
def test_every_point_is_found_once_and_every_row_is_revealed(name: str):
    motion, sheet = drawn(name)[0]
    for panel in sheet.panels:
        names = [stroke.name for stroke in panel.strokes]
        assert len({*names}) == len(names)
        told = {key for stroke in panel.strokes for key in stroke.reveals}
        given = {row.key for row in sheet.rows for c in row.cells[panel.name] if c.given}
        assert {row.key for row in sheet.rows} == told | given, panel.name
    letters = {
        v for s in sheet.panels[0].strokes for v in (s.label, *getattr(s.shape, "letters", ()))
    }
    shapes = [stroke.shape for stroke in sheet.panels[0].strokes]
    letters |= {end for s in shapes if isinstance(s, Arrow) for end in (s.tail, s.head)}
    assert {*motion.points} <= letters


@every_example
def test_a_title_names_lengths_by_what_the_drawing_shows(name: str):
    _, sheet = drawn(name)[0]
    rows = {row.title for row in sheet.rows}
    for item in parameters(sheet):
        is_lettered = any(piece.kind == "symbol" for piece in item)
        assert is_lettered or item[0].text in rows, text_of(item)


@pytest.mark.parametrize(("name", "beyond"), [("pantograph.toml", True), ("chebyshev.toml", False)])
def test_a_line_leads_to_an_image_beyond_the_known_points(name: str, beyond: bool):
    for _, panel in panels(name, "velocity", "acceleration"):
        *before, image = panel.strokes
        lines = [each for each in before if each.name == "BP.line"]
        assert bool(lines) == beyond
        for line in lines:
            assert isinstance(line.shape, Line) and isinstance(image.shape, Arrow)
            assert line is before[-1] and line.said == image.said
            assert line.shape.until == image.shape.end
            (b,) = {
                each.shape.start
                for each in before
                if isinstance(each.shape, Arrow) and each.shape.tail.strip("′") == "b"
            }
            assert line.shape.through == b


@pytest.mark.parametrize(
    ("motion", "said"),
    [
        (
            vad.solve(kind("sewing-machine.toml")()),
            ["BC = 15.87 mm (from ∠BAC)", "ET = 32.22 mm (from ∠ECT)"],
        ),
        (vad.solve(kind("jansen-leg.toml")()), []),
        (vad.solve(vad.FourBar(points={"E": ("coupler", 60, 30)})), ["CE = 74.36 mm (from ∠CBE)"]),
    ],
)
def test_a_side_that_is_not_given_follows_from_an_angle(motion: vad.Motion, said: list[str]):
    told = [stroke.caption for stroke in vad.draw(motion, ["position"]).panels[0].strokes]
    found = [each.partition("radius ")[2].rstrip(".") for each in told if "∠" in each]
    assert found == said


def test_signs_of_an_arm_whose_block_lies_behind_its_pivot_are_told():
    told = {s.name: s.caption for s in drawn("whitworth-ram.toml")[0][1].panels[0].strokes}
    assert told["O4Q.bar"].endswith(": B is on the other side of O4.")
    assert told["QA.block"].endswith("s = −1.513 in, measured from O4 towards B.")


def test_of_many_parameters_the_coordinates_come_last():
    names = [name for name, _, _ in drawn("jansen-leg.toml")[0][1].parameters]
    lengths = ["crank", "link j", "CD", "CE", "DE", "link k", "link c", "link f", "FG", "FH", "GH"]
    assert names == [*lengths, "Cx", "Cy"]


# --- blocks and cylinders ---------------------------------------------------------------------


def captions(name: str, panel: str = "position") -> str:
    return " ".join(stroke.caption for stroke in drawn(name)[0][1].panel(panel).strokes)


def test_a_rod_through_a_fixed_block_is_found_by_a_line_not_by_its_unknown_length():
    said = captions("trunnion.toml")
    assert "The rod from B passes through D. Q is the point of the rod that is now under D" in said
    assert "circle" not in said


def test_an_arm_whose_block_lies_behind_its_pivot_is_named_by_its_own_ends():
    motion, sheet = drawn("whitworth-ram.toml")[0]
    assert motion.slide("block").position < 0.0
    angle = sheet.notation.number(motion.link("arm").angle, "°")
    assert f"The arm O4B stands at θ₄ = {angle}°:" in captions("whitworth-ram.toml")


def test_what_slides_in_a_cylinder_is_its_piston():
    said = captions("oscillating-cylinder.toml", "velocity")
    assert "in the cylinder the piston B can move no other way" in said
    assert "the piston B slides upwards along the cylinder" in said


def test_a_point_beside_a_cylinder_stands_out_from_it():
    """There is no plate: of the cylinder's points only the pivot keeps its place."""
    sheet = vad.draw(
        vad.solve(kind("oscillating-cylinder.toml")(points={"W": ("cylinder", 50, 30)}))
    )
    strokes = sheet.panel("position").strokes
    assert not any(isinstance(stroke.shape, Plate) for stroke in strokes)
    assert strokes[-1].caption == "W lies on the cylinder, 50 mm from D."
    arrow = strokes[-1].shape
    assert isinstance(arrow, Arrow) and (arrow.tail, arrow.head) == ("D", "W")
