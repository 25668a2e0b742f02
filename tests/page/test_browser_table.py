"""The table under the hand: numbers stay in their columns, and rounding noise is zero."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

import vad
from tests.browser import opened, painted
from tests.page.lessons import press, show, written
from vad.files.examples import example_path
from vad.page.document import document

#: Moves the driver over its track; returns by how much cells are too near, and past their panel.
_WALK = """() => {
  const [name] = Object.keys(vad.state), track = document.querySelector(".turner");
  const box = (each) => each.getBoundingClientRect();
  const edges = [...document.querySelectorAll(".panel .top")].map((each) => box(each).right);
  const rows = [...document.querySelectorAll(".results tbody tr")];
  let near = Infinity, past = -Infinity;
  for (let n = 0; n < 36; n++) {
    vad.pose({ [name]: +track.min + (track.max - track.min) * (n + 0.37) / 36 });
    for (const row of rows)
      [...row.querySelectorAll("td")].forEach((column, at) => {
        const cells = [...column.querySelectorAll(".cell")].map(box);
        cells.forEach(({ left, right }, k) => {
          past = Math.max(past, right - edges[at]);
          if (k) near = Math.min(near, left - cells[k - 1].right);
        });
      });
  }
  return [near, past];
}"""


def opened_hand(page: Page, folder: Path, name: str) -> None:
    """Show a mechanism in the hand."""
    kind = vad.MECHANISMS.get(name) or vad.load(example_path(name))
    show(page, folder, written(kind()), "#step=99")
    press(page, "End", "h")
    expect(page.locator(".turned:not(.staged)")).to_have_count(1)


#: How far the number of each row is from the row's name.
_BESIDE = """() => [...document.querySelectorAll(".results tbody tr")].map((row) => {
  const head = row.querySelector("th");
  const words = document.createTreeWalker(head, NodeFilter.SHOW_TEXT), range = new Range();
  let end = 0;
  while (words.nextNode()) {
    range.selectNodeContents(words.currentNode);
    const { right } = range.getBoundingClientRect();
    if (words.currentNode.textContent.trim()) end = Math.max(end, right);
  }
  const cell = [...row.querySelectorAll(".cell")].find((each) => each.offsetWidth);
  return cell ? cell.getBoundingClientRect().left - end : Infinity;
})"""


@pytest.mark.parametrize(
    ("name", "language", "size"),
    [
        ("peaucellier", "fr", (1280, 720)),
        ("shaper", "de", (1280, 720)),
        ("jansen-leg", "fr", (1280, 720)),
        ("whitworth", "en", (640, 360)),
        ("scotch-yoke", "en", (320, 568)),
    ],
)
def test_names_of_rows_stand_apart_from_their_numbers(
    name: str, language: str, size: tuple[int, int], browser: Browser, tmp_path: Path
) -> None:
    kind = vad.MECHANISMS.get(name) or vad.load(example_path(name))
    lesson = vad.animate(vad.draw(vad.solve(kind()), language=language))
    wide, high = size
    with opened(browser, viewport={"width": wide, "height": high}) as page:
        show(page, tmp_path, document(lesson), "#hand")
        expect(page.locator(".turned")).to_have_count(1)
        assert min(page.evaluate(_BESIDE)) > 5.0
        assert page.evaluate("document.documentElement.scrollWidth") <= wide


def test_the_legend_of_a_narrow_column_lies_on_no_number(browser: Browser, tmp_path: Path) -> None:
    forces = vad.forces(
        vad.solve(vad.FourBar()), ["-12.345 kN m on rocker"], masses={"coupler": 2.0}
    )
    panels = ["position", "acceleration", "force", "drive"]
    lesson = vad.animate(vad.draw(forces, panels, language="de"))
    with opened(browser, viewport={"width": 1280, "height": 720}) as page:
        show(page, tmp_path, document(lesson), "#hand")
        expect(page.locator(".legend")).to_be_visible()
        legend = page.locator(".legend").bounding_box()
        boxes = [each.bounding_box() for each in page.locator(".cell:visible").all()]
    assert len(boxes) > 6
    for box in boxes:
        aside = box["x"] + box["width"] <= legend["x"]
        low, high = box["y"] + 0.8 * box["height"], box["y"] + 0.2 * box["height"]
        assert aside or low <= legend["y"] or high >= legend["y"] + legend["height"]


@pytest.mark.exhaustive(12)
@pytest.mark.parametrize("name", ["spatial-four-bar", "oscillating-cylinder", "double-slider"])
def test_numbers_stay_in_their_columns(name: str, browser: Browser, tmp_path: Path) -> None:
    size = {"width": 1280, "height": 720}
    with opened(browser, viewport=size, reduced_motion="reduce") as page:
        opened_hand(page, tmp_path, name)
        near, past = page.evaluate(_WALK)
        assert near > 5.0
        assert past < 1.0
        page.set_viewport_size({"width": 1024, "height": 640})
        painted(page)  # the columns are measured anew when the window has its size
        near, past = page.evaluate(_WALK)
        assert near > 3.0
        assert past < 1.0


#: How far cells are past the table, and how large their letters are at least, beside its own.
_PAST = """() => {
  const table = document.querySelector(".results"), { right } = table.getBoundingClientRect();
  const size = (each) => parseFloat(getComputedStyle(each).fontSize);
  const cells = [...table.querySelectorAll(".cell")].filter((each) => each.offsetWidth);
  return [Math.max(...cells.map((each) => each.getBoundingClientRect().right)) - right,
    Math.min(...cells.map(size)) / size(table)];
}"""


@pytest.mark.exhaustive(3)
@pytest.mark.parametrize("name", ["spatial-four-bar", "hooke-joint", "whitworth"])
def test_numbers_of_a_narrow_page_stand_below_one_another_rather_than_past_it(
    name: str, browser: Browser, tmp_path: Path
) -> None:
    with opened(browser, reduced_motion="reduce") as page:
        opened_hand(page, tmp_path, name)
        for width, height in ((640, 360), (500, 700), (844, 390), (390, 844), (320, 568)):
            page.set_viewport_size({"width": width, "height": height})
            for key in ("Escape", "h"):
                press(page, key)
                painted(page)
                past, letters = page.evaluate(_PAST)
                assert past < 1.0 and letters == 1.0, (width, key)


def test_the_rows_of_a_tablet_end_above_the_dock(browser: Browser, tmp_path: Path) -> None:
    """Beside a large panel they are as high as their letters, whatever touches them."""
    ends = """() => [".results table", ".control"].map(
      (each) => document.querySelector(each).getBoundingClientRect())"""
    size = {"width": 1024, "height": 768}
    with opened(browser, viewport=size, has_touch=True, is_mobile=True) as page:
        show(page, tmp_path, written(vad.load(example_path("jansen-leg"))()), "#step=30")
        painted(page)
        table, dock = page.evaluate(ends)
        assert page.locator(".staged").count() == 1
        assert table["bottom"] <= dock["top"]


def test_rounding_noise_is_zero(browser: Browser, tmp_path: Path) -> None:
    with opened(browser, reduced_motion="reduce") as page:
        opened_hand(page, tmp_path, "scissor-lift")
        page.evaluate("() => vad.pose({ position: 1217.3 })")
        cells = page.locator(".results .cell")
        expect(cells.nth(-2)).to_have_text("a= 0 mm/s²")
        assert not [text for text in cells.all_inner_texts() if "×10⁻" in text]


def test_a_sense_in_the_table_goes_under_the_hand_and_leaves_the_unit(
    browser: Browser, tmp_path: Path
) -> None:
    """A rate has one where the drawing has no clear room for its arrow."""
    said = """() => [...document.querySelectorAll(".cell")].map((each) => each.textContent)
        .filter((each) => each.startsWith("α3"))"""
    with opened(browser, viewport={"width": 1280, "height": 720}, reduced_motion="reduce") as page:
        opened_hand(page, tmp_path, "drag-link")
        press(page, "h")
        expect(page.locator(".turned")).to_have_count(0)
        (before,) = page.evaluate(said)
        assert before.endswith("rad/s2\xa0↻")
        press(page, "h")
        page.evaluate(_WALK)
        (after,) = page.evaluate(said)
        assert after.endswith("rad/s²")
