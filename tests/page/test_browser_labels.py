"""The picture that a hand moves, in a real browser: labels stay readable, scales stay calm.

What takes time is counted: attributes that are set, places that are tried.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Browser, Page

from tests.browser import opened
from tests.page.hands import NAMES, made, open_picture, prepare, walked

#: Pixels of a page 720 high.
STEP = 11.0
#: In this share of the poses, a label has no room, at most; of all examples together, and of one.
HIDDEN, MOST_HIDDEN = 0.08, 0.25
USUAL = ["four-bar", "slider-crank", "whitworth", "watt-1", "hooke-joint", "excavator-bucket"]


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    """Return the page of all pictures of this module."""
    with opened(browser, viewport={"width": 1280, "height": 720}) as empty:
        prepare(empty)
        yield empty


def check(found: dict[str, Any]) -> None:
    """Assert what holds for the labels of every mechanism."""
    assert found["covering"] == []
    assert found["astray"] == []
    assert 0.0 < found["step"] <= STEP + 0.2  # places are written in tenths of a pixel
    assert found["hidden"] <= MOST_HIDDEN * found["labels"]
    assert found["attributes"] < 8 * found["labels"]
    assert found["candidates"] < 1500


@pytest.mark.exhaustive(12)
@pytest.mark.parametrize("name", USUAL)
def test_labels_stay_readable(name: str, page: Page) -> None:
    check(walked(page, name, 90))


def test_labels_of_all_mechanisms_stay_readable_in_360_poses(page: Page, exhaustive: bool) -> None:
    """In a usual run one mechanism in eighteen is looked at."""
    hidden, labels = 0.0, 0
    for name in NAMES if exhaustive else NAMES[::18]:
        found = walked(page, name, 360)
        check(found)
        hidden, labels = hidden + found["hidden"], labels + found["labels"]
    assert hidden < HIDDEN * labels


def paint(page: Page, **inputs: float) -> None:
    """Show a pose, with everything at rest."""
    page.evaluate(
        """inputs => {
          for (const name in inputs) view.state[given.inputs.indexOf(name)] = inputs[name];
          for (let n = 0; n < 60; n++) view.paint();
          view.write();
        }""",
        inputs,
    )


def texts(page: Page) -> dict[int, list[str]]:
    """Return what the visible labels say, by panel; a label of several dots as one text."""
    return {
        column: page.evaluate(
            """column => [...view.names.groups.values()]
              .filter(each => each.visible && each.column === column)
              .map(each => each.members.map(one => one.text.textContent).join("+"))""",
            column,
        )
        for column in range(3)
    }


def scales(page: Page) -> list[float]:
    """Return the scales of the polygons, and then that of the mechanism."""
    found: list[float] = page.evaluate("given.polygons.map(each => view.state[each.input + 2])")
    return found


def bars(page: Page) -> list[str]:
    found: list[str] = page.evaluate(
        "[...document.querySelectorAll('.scale.hand')].map(each => each.textContent)"
    )
    return [*found[1:], *found[:1]]


def test_a_letter_within_a_step_vanishes_with_its_part(page: Page) -> None:
    """Without α the crank has no tangential part, and b′ₙ is b′."""
    open_picture(page, "four-bar")
    paint(page, angle=60, omega=10, alpha=50)
    letters = "+".join(texts(page)[2])
    assert "b′n" in letters
    paint(page, alpha=0)
    assert "b′n" not in "+".join(texts(page)[2])
    assert "b′" in "+".join(texts(page)[2])


def test_dots_that_lie_close_together_share_a_label(page: Page) -> None:
    open_picture(page, "four-bar")
    paint(page, angle=60, omega=10, alpha=50)
    assert "b′n+b′" not in texts(page)[2]
    paint(page, alpha=0.5)
    assert any("b′n+b′" in each for each in texts(page)[2])


def test_a_label_is_seen_with_its_stroke(page: Page) -> None:
    """The player marks what is not drawn yet; the others have room as if it were not there."""
    open_picture(page, "four-bar")
    paint(page, angle=60, omega=10, alpha=50)
    assert "c′" in "+".join(texts(page)[2])
    page.evaluate(
        "document.querySelectorAll('.label[data-s]').forEach(each => each.classList.add('off'))"
    )
    paint(page)
    assert texts(page)[2] == []
    assert page.evaluate("view.hidden") == 0


def test_the_angle_and_the_sense_follow(page: Page) -> None:
    open_picture(page, "four-bar")
    paint(page, angle=75.04, omega=10)
    assert "75.0°" in texts(page)[0]
    arrow = """() => {
      const bow = given.moves.findLastIndex(([kind]) => kind === "b");
      const element = document.querySelectorAll("[data-m]")[bow];
      return [element.style.visibility, element.getAttribute("d")];
    }"""
    shown, forward = page.evaluate(arrow)
    assert shown == ""
    paint(page, omega=-10)
    assert page.evaluate(arrow)[1] != forward
    paint(page, omega=0)
    assert page.evaluate(arrow)[0] == "hidden"


@pytest.mark.parametrize("name", ["double-slider", "spatial-four-bar"])
def test_the_halo_of_a_text_moves_with_it(name: str, page: Page) -> None:
    open_picture(page, name)
    places = """() => [...document.querySelectorAll(".hand g > use")].map((halo) =>
      [halo, halo.nextElementSibling].map((each) => {
        const { left, right, top, bottom } = each.getBoundingClientRect();
        return [(left + right) / 2, (top + bottom) / 2];
      }))"""
    seen = []
    for place in (0.1, 0.9):
        low, high = page.evaluate("given.ranges[0]")
        driver = page.evaluate("given.inputs[0]")
        paint(page, **{driver: low + place * (high - low)})
        seen.append(page.evaluate(places))
        assert seen[-1]
        for halo, text in seen[-1]:
            assert halo == pytest.approx(text, abs=0.5)
    if name == "double-slider":
        assert seen[0] != seen[1]


def test_a_cell_keeps_its_unit(page: Page) -> None:
    open_picture(page, "four-bar")
    before = page.locator(".results .cell").all_inner_texts()
    paint(page, angle=75, omega=10, alpha=3)
    after = page.locator(".results .cell").all_inner_texts()
    assert [one.endswith("s") for one in before] == [one.endswith("s") for one in after]
    assert sum("rad/s²" in one for one in after) == sum("rad/s2" in one for one in before) > 0


def test_a_polygon_keeps_its_scale_while_it_fits(page: Page) -> None:
    open_picture(page, "four-bar")
    paint(page, angle=60, omega=10)
    before, said = scales(page), bars(page)
    paint(page, omega=9)
    assert scales(page) == before
    paint(page, omega=100)
    larger = scales(page)
    assert larger[0] < before[0] / 8
    assert larger[1] < before[1] / 64
    assert bars(page) != said
    paint(page, omega=1)
    assert scales(page)[0] > 50 * larger[0]


def test_what_is_new_glides(page: Page) -> None:
    open_picture(page, "four-bar")
    paint(page, angle=60, omega=10)
    path = page.evaluate(
        """() => {
          view.state[1] = 40;
          const at = given.polygons[0].input + 2, found = [view.state[at]];
          for (let n = 0; n < 40; n++) { view.paint(); found.push(view.state[at]); }
          return found;
        }"""
    )
    assert path[0] > path[1] > path[2] > path[-2] == path[-1]
    assert path[1] > 1.5 * path[-1]


def test_a_bar_states_the_scale(page: Page) -> None:
    """Its length and the number beside it give the scale."""
    open_picture(page, "four-bar")
    for omega in (0.03, 1.0, 10.0, 4321.0):
        paint(page, angle=60, omega=omega, alpha=0)
        for number, text in enumerate(bars(page)[:2]):
            size = page.evaluate(
                "n => +[...document.querySelectorAll('.scale.hand .bar')][n + 1]"
                ".style.getPropertyValue('--n')",
                number,
            )
            words = text.split("\u00a0")[0].replace("\u202f", "").replace("×10", "e")
            value = float(words.translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")))
            factor = made("four-bar")[4]["polygons"][number]["bar"]["factor"]
            assert size == pytest.approx(value / factor * 720 * scales(page)[number], abs=0.01)
            assert 20.0 < size < 90.0


def test_one_scale_holds_for_a_turn(page: Page) -> None:
    """It fits the largest polygon, but makes none much smaller than its own."""
    open_picture(page, "four-bar")
    paint(page, angle=60, omega=10, alpha=0)
    page.evaluate("view.steady(Array.from({ length: 72 }, (_, n) => 5 * n))")
    paint(page)
    held = scales(page)
    for angle in range(0, 360, 30):
        paint(page, angle=angle)
        assert scales(page) == held
    page.evaluate("view.steady(null)")
    paint(page, angle=100)
    assert scales(page) != held


def test_what_rests_costs_nothing(page: Page) -> None:
    open_picture(page, "four-bar")
    paint(page, angle=60)
    before = page.evaluate("({ ...view.counts })")
    page.evaluate("view.paint()")
    after = page.evaluate("view.counts")
    assert after["attributes"] == before["attributes"]
    assert after["candidates"] - before["candidates"] < 40


def test_labels_of_many_poses_in_a_row_follow_in_every_second_frame(page: Page) -> None:
    open_picture(page, "four-bar")
    paint(page, angle=60, omega=10, alpha=0)
    moved = page.evaluate(
        """async () => {
          const looks = () => view.names.all.map((each) => each.shell.style.transform).join();
          let before = "";
          const moved = () => before !== (before = looks());
          const to = (angle) => { view.state[0] = angle; view.paint(view.state, true); };
          const frame = () => new Promise(requestAnimationFrame);
          view.paint(), moved();
          const row = [61, 62, 63, 64].map((angle) => (to(angle), moved()));
          to(65), view.settle();
          const settled = [moved(), (view.settle(), moved())];
          view.paint(), moved(), to(66);
          const late = [moved()];
          for (let n = 0; n < 3; n++) await frame();
          return [row, settled, late.concat(moved())];
        }"""
    )
    assert moved == [[False, True, False, True], [True, False], [False, True]]
