"""Vectors that travel on a page: from the link, or the velocity, that they come from."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page

import vad
from tests.browser import opened, until
from tests.page.lessons import at, bundle_of, lesson_of, page_of, press, scrub, show, written
from vad.files.examples import example_path
from vad.page.parts import parts

NAME = "crank-slotted-lever"
LESSON = lesson_of(NAME, whole=True)
#: So many vectors fly in it; that they do, its page has to be made for.
FLIGHTS = 8
#: Where the arrow is that flies, and whether its own is seen: its tail, its tip.
_AIR = """() => {
  document.getAnimations().forEach((each) => each.finish());
  const group = document.querySelector(".air g:last-child");
  if (!group) return null;
  const [shaft, head] = group.children;
  const [x, y] = shaft.getAttribute("d").match(/-?[\\d.e-]+/g).map(Number);
  const [p, q] = /translate\\((\\S+) (\\S+)\\)/.exec(head.getAttribute("transform")).slice(1);
  return [[x, y], [+p, +q], document.querySelectorAll(".aloft").length > 0];
}"""
#: Places of a panel in the window.
_WINDOW = """([panel, ...places]) => {
  const matrix = document.querySelectorAll(".drawing > svg")[panel].getScreenCTM();
  return [0, 2].map((n) => new DOMPoint(places[n], places[n + 1]).matrixTransform(matrix))
    .map(({ x, y }) => [x, y]);
}"""
#: The width and the height of a panel in the window.
_SIZE = """(panel) => {
  const box = document.querySelectorAll(".drawing > svg")[panel].getBoundingClientRect();
  return [box.width, box.height];
}"""
#: The arrow of a stroke as it is drawn: where its shaft begins, and the tip of its head.
_DRAWN = """(beat) => {
  const group = [...document.querySelectorAll(`[data-s="${beat}"]`)]
    .find((each) => each.closest(".drawing") && each.children.length > 1);
  const marks = [...group.children].filter((each) => each.localName === "path");
  const tip = marks.find((each) => getComputedStyle(each).fill !== "none");
  const matrix = group.ownerSVGElement.getScreenCTM();
  return [tip.previousElementSibling, tip].map((each) => {
    const [x, y] = each.getAttribute("d").match(/-?[\\d.]+/g).map(Number);
    const place = new DOMPoint(x, y).matrixTransform(matrix);
    return [place.x, place.y];
  });
}"""


#: The dotted way of what flies, its first and its last place, and the ring in which a head docks.
_TRAIL = """() => {
  const path = document.querySelector(".air > g > path:only-of-type");
  if (!path) return null;
  const place = ({ x, y }) => [x, y], matrix = path.getScreenCTM(), long = path.getTotalLength();
  const ring = path.parentNode.querySelector("circle")?.getBoundingClientRect();
  return [[0, long].map((each) => place(path.getPointAtLength(each).matrixTransform(matrix))),
    ring && [ring.x + ring.width / 2, ring.y + ring.height / 2]];
}"""
#: The middle of a number that flies, of that in the caption, and of the name of its sense.
_NUMBERS = """(beat) => {
  const sense = [...document.querySelectorAll(`[data-s="${beat}"] > text`)].find((each) =>
    !each.closest(".scene, .hand, .grand"));
  return [document.querySelector(".sent"), document.querySelector(".caption data"), sense]
    .map((each) => each?.getBoundingClientRect())
    .map((box) => box && [box.x + box.width / 2, box.y + box.height / 2]);
}"""
#: Stops the flight of a number at a share of its time.
_STOPPED = """(share) => document.getAnimations().forEach((each) => {
  const { delay, duration } = each.effect.getTiming();
  each.pause();
  each.currentTime = delay + share * duration;
})"""


@pytest.fixture(scope="module")
def lever(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    with opened(browser, viewport={"width": 1280, "height": 720}) as page:
        show(page, tmp_path_factory.mktemp("flights"), page_of(NAME, whole=True))
        yield page


def flying(page: Page, x: float) -> tuple[complex, complex, bool] | None:
    """Return tail and tip of what flies, upwards positive, and whether it is not drawn yet."""
    scrub(page, x)
    page.evaluate(_AIR)  # all panels have come to rest
    scrub(page, x)
    found = page.evaluate(_AIR)
    return found and (*(complex(u, -v) for u, v in found[:2]), found[2])


def ends(found: list[list[float]]) -> list[complex]:
    return [complex(u, -v) for u, v in found]


@pytest.fixture(scope="module")
def known() -> dict[str, Any]:
    """Return what the page knows."""
    return bundle_of(page_of(NAME, whole=True))[1]


@pytest.fixture(scope="module")
def flights(known: dict[str, Any]) -> dict[int, Any]:
    """Return what it knows of each flight, by the number of its stroke."""
    found = {int(number): each for number, each in known["flights"].items()}
    assert len(found) == FLIGHTS
    return found


@pytest.mark.parametrize("order", range(FLIGHTS))
def test_a_vector_leaves_its_source_and_lands_in_its_place(
    lever: Page, flights: dict[int, Any], order: int
) -> None:
    number, flight = list(flights.items())[order]
    _, kind, phases, source, turn, _, *places = flight
    scrub(lever, number + 0.5)
    tail, tip, aloft = flying(lever, number + 1e-6)
    assert aloft
    start, end = ends(lever.evaluate(_WINDOW, [source, *places[:4]]))
    assert abs(tail - start) < 1.0 and abs(tip - end) < 1.0
    lifted = flying(lever, number + phases[0] / sum(phases))
    if kind != "area":
        assert math.degrees(abs(cmath.phase((lifted[1] - lifted[0]) / (end - start)))) < 0.5
    trail = lever.evaluate(_TRAIL)
    short = math.hypot(places[6] - places[4], places[7] - places[5]) < 25.2
    landing = flying(lever, number + 1.0 - 1e-6)
    long = abs(landing[1] - landing[0]) > max(lever.evaluate(_SIZE, source))
    begins = phases[:-2] if short or long else phases[:-1]  # it changes its size where it lands
    assert trail is None or len(begins) == 1
    before = flying(lever, number + sum(begins) / sum(phases))
    turned = math.degrees(cmath.phase((before[1] - before[0]) / (end - start)))
    assert turned == pytest.approx(turn, abs=0.5)
    flying(lever, number + 1.0 - 1e-6)
    (begun, over), ring = lever.evaluate(_TRAIL)
    end = kind == "coriolis"  # its head docks
    assert abs(complex(begun[0], -begun[1]) - before[end]) < 1.5
    assert abs(complex(over[0], -over[1]) - landing[end]) < 1.5
    assert (ring is not None) is end and (not end or math.dist(ring, over) < 1.5)
    assert flying(lever, number + 1.0) is None
    drawn = ends(lever.evaluate(_DRAWN, 2 * number + 1))
    # An arrow on one line with another is drawn beside it, an image from where it is seen alone.
    lane, tail = 6.0, abs(landing[0] - drawn[0])
    assert abs(landing[1] - drawn[1]) < lane and (kind == "point" or tail < lane)


def test_the_image_of_a_link_with_three_points_lands_on_its_triangle(
    browser: Browser, tmp_path: Path
) -> None:
    html = written(vad.load(example_path("stephenson-3"))())
    flights = bundle_of(html)[1]["flights"].items()
    number = next(int(place) for place, each in flights if each[1] == "area")
    with opened(browser, viewport={"width": 1280, "height": 720}) as page:
        show(page, tmp_path, html, f"#step={number}")
        boxes = []
        for x, place in (
            (1.0 - 1e-6, ".air g:last-child path"),
            (1.0, f'[data-s="{2 * number + 2}"] path'),
        ):
            scrub(page, number + x)
            boxes.append(page.locator(place).first.bounding_box())
        one, other = ([box[key] for key in ("x", "y", "width", "height")] for box in boxes)
        assert one == pytest.approx(other, abs=6.0) and min(one[2:]) > 30  # with its rim


def test_the_image_of_a_link_grows_where_it_lands(browser: Browser, tmp_path: Path) -> None:
    """While it flies it is as large as its link, so that it does not cover what is beside it."""
    html = written(vad.load(example_path("stephenson-3"))())
    flights = bundle_of(html)[1]["flights"].items()
    number, phases = next((int(place), each[2]) for place, each in flights if each[1] == "area")
    turn, _, fly = (seconds / sum(phases) for seconds in phases)
    with opened(browser, viewport={"width": 1280, "height": 720}) as page:
        show(page, tmp_path, html, f"#step={number}")
        boxes = []
        for x in (turn, turn + fly / 2, turn + fly, 1.0 - 1e-6):
            scrub(page, number + x)
            boxes.append(page.locator(".air g:last-child path").first.bounding_box())
    sizes = [(box["width"], box["height"]) for box in boxes]
    assert sizes[1] == pytest.approx(sizes[0], abs=2.0)
    assert sizes[2] == pytest.approx(sizes[0], abs=2.0)
    assert sizes[3][0] > 1.2 * sizes[0][0]
    small, large = boxes[2:]
    for low, size in (("x", "width"), ("y", "height")):
        assert large[low] - 3.0 < small[low]
        assert small[low] + small[size] < large[low] + large[size] + 3.0


def test_what_flies_has_a_layer_only_while_it_flies(lever: Page, flights: dict[int, Any]) -> None:
    """All that a browser paints in front of the layer would need one, too."""
    number = next(iter(flights))
    boxes = "air => air.getClientRects().length"
    assert flying(lever, number + 0.5) and lever.locator(".air").evaluate(boxes) == 1
    assert flying(lever, number + 1.0) is None and lever.locator(".air").evaluate(boxes) == 0


def test_each_kind_flies_from_its_panel(flights: dict[int, Any]) -> None:
    found = {each[1]: each[3] for each in flights.values()}
    assert found == {"tangential": 0, "normal": 0, "point": 0, "coriolis": 1}
    omega = LESSON.sheet.driver.omega
    first = next(each for each in flights.values() if each[1] == "tangential")
    assert first[4] == math.copysign(90.0, omega)
    plain = vad.animate(LESSON.sheet, plain=True)
    assert parts(plain).data["flights"] == {}


def test_the_next_key_lands_it_and_a_switch_lets_a_pencil_draw(
    lever: Page, flights: dict[int, Any]
) -> None:
    number = min(flights)
    scrub(lever, number)
    press(lever, "ArrowRight")
    until(lever, lambda: lever.evaluate(_AIR) is not None)
    press(lever, "ArrowRight")
    assert at(lever) == number + 1 and lever.evaluate(_AIR) is None
    assert lever.locator(".aloft").count() == 0
    press(lever, "?")
    lever.locator(".travels").uncheck()
    press(lever, "Escape")
    assert flying(lever, number + 0.5) is None
    lever.locator(".travels").evaluate("(each) => { each.checked = true; }")


def test_links_that_it_does_not_come_from_are_pale(lever: Page, flights: dict[int, Any]) -> None:
    number = next(place for place, each in flights.items() if each[1] == "normal")
    inks = """(pale) => [...new Set([...document.querySelectorAll(
      `.drawing > svg :is(path, circle, text)${pale ? ".pale" : ":not(.pale)"}`)]
      .filter((each) => !each.closest(".hand") && each.getBoundingClientRect().width)
      .map((each) => getComputedStyle(each).stroke))]"""
    keys = (
        "() => [...document.querySelectorAll('.key path')].map((e) => getComputedStyle(e).stroke)"
    )
    scrub(lever, number + 0.4)
    own = lever.locator(".air g:last-child > path").first.evaluate(
        "(each) => getComputedStyle(each).stroke"
    )
    pale, rows = lever.evaluate(inks, True), lever.evaluate(keys)
    assert own in rows and own not in pale and len({*rows} & {*pale}) >= 2
    scrub(lever, number)
    assert lever.locator(".pale").count() == 0


def test_a_rate_that_is_found_flies_to_its_sense(lever: Page, known: dict[str, Any]) -> None:
    number, (_, seconds) = next((int(key), each) for key, each in known["sent"].items())
    assert seconds == 1.6
    scrub(lever, number + 0.9)
    until(lever, lambda: not lever.evaluate("document.getAnimations().length"))  # panels stand
    press(lever, "ArrowRight")
    until(lever, lambda: lever.locator(".sent").count() == 1)
    seen = []
    for share in (0.05, 0.3, 0.6):
        lever.evaluate(_STOPPED, share)
        sent, said, sense = lever.evaluate(_NUMBERS, 2 * number + 2)
        seen.append(sent)
    assert math.dist(seen[0], said) < 1.0 and math.dist(seen[2], sense) < 1.5
    assert math.dist(seen[1], said) > 50 and math.dist(seen[1], sense) > 50
    lever.evaluate("() => document.getAnimations().forEach((each) => each.finish())")
    until(lever, lambda: lever.locator(".sent").count() == 0)


def test_where_the_source_is_not_seen_a_pencil_draws(lever: Page, flights: dict[int, Any]) -> None:
    number = next(place for place, each in flights.items() if each[1] == "coriolis")
    lever.set_viewport_size({"width": 640, "height": 600})
    narrow: Any = flying(lever, number + 0.5)
    lever.set_viewport_size({"width": 1280, "height": 720})
    assert narrow is None and flying(lever, number + 0.5) is not None
