"""The window in a real browser: by hand, by keyboard, with mistakes, and with a slow server."""

from __future__ import annotations

import math
import re
import time
import webbrowser
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit
from urllib.request import url2pathname

import av
import pytest
from PIL import Image

from tests.browser import opened, until, violations
from vad.gui.answers import pose
from vad.gui.messages import ExportQuestion, PoseQuestion
from vad.gui.server import served
from vad.gui.visit import visited
from vad.mechanisms import MECHANISMS
from vad.words import languages

if TYPE_CHECKING:
    from playwright.sync_api import Browser, JSHandle, Page

START = ExportQuestion("slider-crank", size=(320, 240), fps=2)


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    with served(START) as key:
        yield key.address


@pytest.fixture(scope="module")
def window(browser: Browser, address: str) -> Iterator[Page]:
    """Return the page of all tests of this module."""
    home = address.partition("?")[0]
    options = {"viewport": {"width": 1280, "height": 800}, "has_touch": True}
    with opened(browser, server=home, **options) as page:
        page.goto(address)
        assert page.url.startswith(home)
        assert "token" not in page.url
        still(page)
        yield page


def still(page: Page) -> None:
    """Wait until nothing moves and nothing is asked."""
    until(page, lambda: page.locator(".window:not(.moving) .control:not([hidden])").count())


def load(page: Page, mechanism: str, **values: object) -> None:
    """Set a mechanism as a link does."""
    kept = "&".join([f"m={mechanism}", *(f"{name}={value}" for name, value in values.items())])
    title = MECHANISMS[mechanism].title
    for address in (f"{kept}&step=0", kept):  # or else the address may be the same
        with page.expect_response("**/api/lesson"):
            page.evaluate(f"location.hash = '{address}'")
    until(page, lambda: page.locator("header h1").inner_text() == title)
    still(page)


def value(page: Page, name: str) -> float:
    return float(page.locator(f"#field-{name}").input_value())


def cell(page: Page, row: int, column: int) -> str:
    return page.locator(".results tbody tr").nth(row).locator("td").nth(column).inner_text()


def middle(page: Page, selector: str = ".handle") -> tuple[float, float]:
    box = page.locator(selector).bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def pivot(page: Page, mechanism: str) -> tuple[float, float]:
    """Return where the driver's motion is measured from."""
    place = pose(PoseQuestion(mechanism))["handle"]["about"]
    x, y = (
        page.locator(".panel")
        .first.locator("svg")
        .evaluate(
            "(svg, at) => { const p = new DOMPoint(...at).matrixTransform(svg.getScreenCTM());"
            " return [p.x, p.y]; }",
            place,
        )
    )
    return x, y


def about(centre: tuple[float, float], degrees: float, radius: float) -> tuple[float, float]:
    turn = math.radians(degrees)
    return centre[0] + radius * math.cos(turn), centre[1] - radius * math.sin(turn)


@pytest.mark.parametrize(
    ("mechanism", "moves"), [("slider-crank", 1), ("slider-crank", 20), ("hooke-joint", 20)]
)
def test_the_crank_follows_the_hand(window: Page, mechanism, moves):
    load(window, mechanism)
    centre = pivot(window, mechanism)
    window.mouse.move(*middle(window))
    window.mouse.down()
    window.mouse.move(*about(centre, 130, 90), steps=moves)
    until(window, lambda: value(window, "angle") == pytest.approx(130, abs=1))
    window.mouse.move(-50, centre[1])  # out of the window, to the left
    until(window, lambda: value(window, "angle") == pytest.approx(180, abs=1))
    window.mouse.up()
    window.mouse.move(*about(centre, 20, 90))
    still(window)
    assert value(window, "angle") == pytest.approx(180, abs=1)
    until(window, lambda: middle(window)[1] == pytest.approx(centre[1], abs=3))
    assert middle(window)[0] < centre[0] - 20
    assert "180" in cell(window, 0, 0)


def test_the_crank_follows_where_the_page_is_scrolled(window: Page):
    window.set_viewport_size({"width": 700, "height": 600})
    load(window, "slider-crank")
    window.mouse.move(*middle(window))
    window.mouse.down()
    window.mouse.wheel(0, 60)
    until(window, lambda: window.evaluate("scrollY") == 60)
    window.mouse.move(*about(pivot(window, "slider-crank"), 130, 90))
    until(window, lambda: value(window, "angle") == pytest.approx(130, abs=1))
    window.mouse.up()
    window.set_viewport_size({"width": 1280, "height": 800})
    still(window)


def test_from_pose_to_pose_the_page_is_patched(window: Page):
    load(window, "hooke-joint")
    window.evaluate(
        "() => { own = setTimeout; setTimeout = (what, wait) => own(what, 50 * wait); }"
    )
    drawn: list[JSHandle] = []
    for key in ("PageUp", "PageUp", "PageUp", "ArrowRight"):  # with no rest between them
        with window.expect_response("**/api/pose") as asked:
            window.locator(".handle").press(key)
        answer = asked.value.json()
        until(window, lambda answer=answer: shows(window, answer))
        drawn.append(window.evaluate_handle("[...document.querySelectorAll('.drawing *')]"))
    window.evaluate("() => { setTimeout = own; }")
    kept = "([old, now]) => now.filter((each) => old.includes(each)).length / now.length"
    assert window.evaluate(kept, drawn[-2:]) > 0.8
    window.locator(".handle").press("Home")
    still(window)


def shows(page: Page, answer: dict[str, Any]) -> bool:
    """Tell whether drawings, scales and cells are those of an answer, whatever was there before."""
    panels, rows = zip(*(each[1:] for each in answer["panels"]), strict=True), answer["rows"]
    html = ["".join(each) for each in (*panels, *rows)]
    return page.evaluate(
        """(html) => {
          const all = (selector) => [...document.querySelectorAll(selector)];
          const rows = all(".results tbody tr").map((row) => [...row.cells].slice(1));
          const there = [all(".scale"), all(".drawing"), ...rows];
          return html.every((text, i) => {
            const made = document.createElement(i < 2 ? "div" : "tr");
            made.innerHTML = text;
            return made.childElementCount === there[i].length
              && there[i].every((each, k) => each.isEqualNode(made.children[k]));
          });
        }""",
        html,
    )


def test_a_finger_turns_it_too(window: Page):
    load(window, "slider-crank")
    centre, (x, y) = pivot(window, "slider-crank"), middle(window)
    touch = window.context.new_cdp_session(window)

    def send(kind: str, *at: float) -> None:
        points = [{"x": at[0], "y": at[1]}] if at else []
        touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    send("touchStart", x, y)
    for degrees in range(70, 161, 10):
        send("touchMove", *about(centre, degrees, 80))
    send("touchEnd")
    touch.detach()
    until(window, lambda: value(window, "angle") == pytest.approx(160, abs=1))
    still(window)


def test_the_keyboard_turns_it_and_keeps_its_place(window: Page):
    load(window, "four-bar")
    handle = window.locator(".handle")
    handle.focus()
    for _ in range(50):
        handle.press("ArrowRight")
    handle.press("Shift+ArrowLeft")
    handle.press("PageUp")
    for key, change in (
        ("ArrowUp", 1.0),
        ("ArrowDown", -1.0),
        ("PageDown", -15.0),
        ("PageUp", 15.0),
    ):
        before = float(handle.get_attribute("aria-valuenow"))
        handle.press(key)
        assert float(handle.get_attribute("aria-valuenow")) == pytest.approx(before + change)
    until(window, lambda: "124.9" in cell(window, 0, 0))
    still(window)
    assert value(window, "angle") == 124.9
    assert window.evaluate("document.activeElement.className") == "handle"
    assert handle.get_attribute("role") == "slider"
    assert handle.get_attribute("aria-valuenow") == "124.9"
    assert handle.get_attribute("aria-valuetext") == "124.9 °"


def test_it_stops_where_the_links_no_longer_close(window: Page):
    load(window, "four-bar", crank=130)
    window.locator(".handle").press("End")
    still(window)
    assert 345 < value(window, "angle") < 346.675
    assert window.locator(".message.wrong").count() == 0
    load(window, "gate-actuator")
    window.locator(".handle").press("Home")
    still(window)
    assert value(window, "position") == pytest.approx(3.2, abs=0.05)
    assert window.locator(".message.wrong").count() == 0


def test_the_newest_value_wins(window: Page, monkeypatch):
    load(window, "slider-crank")
    build, asked = PoseQuestion.build, []

    def slowly(question: PoseQuestion) -> object:
        if isinstance(question, PoseQuestion):
            asked.append(question.inputs["angle"])
            time.sleep(0.2)
        return build(question)

    monkeypatch.setattr(PoseQuestion, "build", slowly)
    slider = window.locator("#inputs .row input[type=range]").first
    slider.focus()
    for _ in range(40):
        slider.press("ArrowRight")
    until(window, lambda: "100" in cell(window, 0, 0))
    still(window)
    assert asked[-1] == 100
    assert asked == sorted(asked)
    assert len(asked) < 20


def test_boxes_take_units_and_sliders_move_them(window: Page):
    load(window, "slider-crank")
    crank = window.locator("#field-crank")
    crank.fill("7 cm")
    crank.press("Enter")
    until(window, lambda: "crank\u00a070" in window.locator("header p").inner_text())
    crank.blur()
    assert crank.input_value() == "70"
    window.locator("#field-omega").fill("-120 rpm")
    window.locator("#field-omega").press("Enter")
    until(window, lambda: "−12.566" in cell(window, 0, 1))
    slider = window.locator("#parameters .row input[type=range]").nth(1)
    slider.focus()
    still(window)
    with window.expect_request("**/api/pose") as asked:
        slider.press("ArrowRight")
    assert asked.value.post_data_json["stands"]["rod"] == 140
    until(window, lambda: "rod\u00a0141" in window.locator("header p").inner_text())
    still(window)
    assert value(window, "rod") == 141


def test_the_other_assembly(window: Page):
    load(window, "slider-crank")
    before = cell(window, 2, 0)
    window.locator(".choice input[value=crossed]").check()
    until(window, lambda: cell(window, 2, 0) != before)
    still(window)
    assert "assembly=crossed" in window.url
    load(window, "scotch-yoke")
    assert window.locator(".choice input").first.is_disabled()


def test_a_mistake_is_marked_and_its_button_mends_it(window: Page):
    load(window, "four-bar", crank=130)
    angle, before = window.locator("#field-angle"), cell(window, 1, 0)
    angle.fill("10")
    angle.press("Enter")
    assert window.locator("#inputs .row input[type=range]").first.input_value() == "10"
    until(window, lambda: angle.get_attribute("aria-invalid") == "true")
    assert "the links miss by 4.014 mm" in window.locator(".message").inner_text()
    assert cell(window, 1, 0) == before
    assert window.locator(".vad.stale").count() == 1
    assert violations(window) == []
    window.get_by_role("button", name="try angle θ 15.46").click()
    until(window, lambda: not window.locator(".message.wrong").count())
    still(window)
    assert value(window, "angle") == 15.46
    assert angle.get_attribute("aria-invalid") == "false"
    assert window.locator(".stale").count() == 0
    for text, said in (("<b>bold</b>", "<b>bold</b>"), ("1 kg", "'kg' is not a unit")):
        angle.fill(text)
        angle.press("Enter")
        until(window, lambda said=said: said in window.locator(".message").inner_text())
    assert window.locator(".message b").count() == 0
    load(window, "four-bar")


def test_a_dead_centre_says_what_has_no_rates(window: Page):
    load(window, "double-slider")
    window.locator("#field-position").fill("1000")
    window.locator("#field-position").press("Enter")
    until(window, lambda: "dead centre" in window.locator(".message").inner_text())
    stale = window.locator(".panel").evaluate_all("all => all.map(e => e.matches('.stale'))")
    assert stale == [False, True, True]
    assert middle(window)[0] > pivot(window, "double-slider")[0] + 100
    # Nothing is left of what the lesson before it said of rates.
    assert cell(window, 0, 0) == "θ3= 180.0°"
    assert not window.locator(".results td").nth(2).is_visible()
    assert not window.locator(".caption").is_visible()
    load(window, "double-slider")
    assert window.locator(".stale").count() == 0
    assert window.locator(".caption").is_visible()


def test_a_window_opened_at_a_dead_centre_shows_the_position_alone(window: Page):
    load(window, "gate-actuator", position=4.5)
    assert window.locator("#field-ground").input_value() == "0.6864197"
    window.evaluate("location.hash = 'm=double-slider&position=1000'")
    until(window, lambda: window.locator(".panel.stale").count() == 2)
    until(window, lambda: "dead centre" in window.locator(".message").inner_text())
    assert window.locator("header h1").inner_text() == "Double slider"
    drawings = window.locator(".panel .drawing")
    assert [each.is_visible() for each in drawings.all()] == [True, False, False]
    assert cell(window, 0, 0) == "θ3= 180.0°"
    assert not window.locator(".results td").nth(3).is_visible()
    assert middle(window)[0] > pivot(window, "double-slider")[0] + 100
    assert value(window, "position") == 1000
    assert violations(window) == []
    window.get_by_role("button", name="try position 979.5").click()
    until(window, lambda: not window.locator(".message.wrong").count())
    still(window)
    assert value(window, "position") == 979.5
    assert window.locator(".stale, .bare").count() == 0
    assert window.locator(".control").is_visible()
    assert all(each.is_visible() for each in drawings.all())


def test_what_cannot_be_shown_leaves_nothing_of_another_mechanism(window: Page):
    load(window, "gate-actuator")
    window.evaluate("location.hash = 'm=double-slider&position=2000'")
    until(window, lambda: "links miss" in window.locator(".message").inner_text())
    assert window.locator("header h1").inner_text() == "Double slider"
    assert window.locator(".panel, .results table").count() == 0
    load(window, "double-slider")
    assert window.locator(".panel").count() == 3
    assert window.locator(".control").is_visible()


def test_draw_it_plays_the_lecture(window: Page):
    load(window, "slider-crank")
    window.select_option(".speed", "4")
    window.get_by_role("button", name="Draw it").click()
    until(window, lambda: window.locator("[data-do=play].on").count())
    until(window, lambda: 0 < float(window.locator(".scrub").input_value()) < 3)
    window.locator(".handle").press("ArrowRight")  # who turns the crank wants to see it all
    still(window)
    assert window.locator("[data-do=play].on").count() == 0
    assert window.locator(".panel svg .off:not([data-b])").count() == 0
    assert value(window, "angle") == 61
    window.select_option(".speed", "1")


def test_every_kind_of_file(window: Page):
    load(window, "slider-crank")
    window.select_option(".speed", "4")
    for extension in ("png", "svg", "pdf", "mp4", "gif", "html"):
        with window.expect_download() as waiting:
            window.locator(f"[data-save={extension}]").click()
        assert waiting.value.suggested_filename == f"slider-crank.{extension}"
        path = waiting.value.path()
        start = path.read_bytes()[:400]
        if extension == "png":
            with Image.open(path) as image:
                assert image.size == (320, 240)
        elif extension == "mp4":
            with av.open(str(path)) as film:
                assert 5 < film.duration / 1e6 < 60
        else:
            signs = {"svg": b"<svg", "pdf": b"%PDF", "gif": b"GIF89a", "html": b"<!DOCTYPE html>"}
            assert signs[extension] in start
    window.select_option(".speed", "1")


def test_the_address_has_all_that_is_set(window: Page, address: str):
    load(window, "four-bar", crank=35, angle=75, assembly="crossed", unit="cm", step=4)
    assert window.locator(".scrub").input_value() == "4"
    window.reload()
    still(window)
    assert (value(window, "crank"), value(window, "angle")) == (35, 75)
    assert window.locator(".choice input[value=crossed]").is_checked()
    assert window.locator("#parameters .unit").first.inner_text() == "cm"
    assert window.locator(".scrub").input_value() == "4"
    window.locator(".handle").press("ArrowRight")  # and it is written, not only read
    window.locator(".handle").press("ArrowLeft")
    still(window)
    assert "unit=cm" in window.url
    other = window.context.new_page()  # two tabs do not disturb each other
    other.goto(address.partition("?")[0] + "#m=scotch-yoke&colour=red&crank=x")
    until(other, lambda: "'x'" in other.locator(".message").inner_text())
    window.locator(".handle").press("ArrowRight")
    still(window)
    assert value(window, "angle") == 76
    other.close()


@pytest.mark.parametrize("code", languages())
def test_every_mechanism_in_every_language(window: Page, address: str, code):
    window.goto(f"{address.partition('?')[0]}?lang={code}")
    still(window)
    assert window.evaluate("document.documentElement.lang") == code
    names = window.locator("#mechanism option").evaluate_all("all => all.map(e => e.value)")
    assert names == list(MECHANISMS)
    for name in names[::3] if code == "de" else names[:1]:
        title = window.locator(f"#mechanism option[value={name}]").inner_text()
        window.select_option("#mechanism", name)
        until(window, lambda title=title: window.locator("header h1").inner_text() == title)
        still(window)
        assert window.locator(".handle").is_visible()
    assert violations(window) == []


@pytest.mark.parametrize("width", [320, 700, 1000])
def test_a_narrow_window_has_all_of_it(window: Page, address: str, width):
    window.goto(address.partition("?")[0])
    window.set_viewport_size({"width": width, "height": 800})
    load(window, "whitworth")
    window.locator("[data-do=theme]").click()
    assert window.evaluate("document.documentElement.scrollWidth") <= width
    for selector in ("#field-crank", ".handle", "[data-save=png]", ".results"):
        window.locator(selector).scroll_into_view_if_needed()
        assert window.locator(selector).is_visible()
    assert violations(window) == []
    window.set_viewport_size({"width": 1280, "height": 800})


def test_the_browser_is_led_in_by_a_file(browser: Browser, monkeypatch):
    led: list[str] = []
    monkeypatch.setattr(webbrowser, "open", lambda address: not led.append(address))
    with served(START) as key, visited(key, pytest.fail):
        home = key.address.partition("?")[0]
        with opened(browser, server=home) as page:
            until(page, lambda: led)
            page.goto(led[0], wait_until="commit")
            until(page, lambda: page.url.startswith(home))
            still(page)
            assert "ticket" not in page.url
            page.reload()
            still(page)
            other = page.context.new_page()
            other.goto(home)
            still(other)
            assert not Path(url2pathname(urlsplit(led[0]).path)).exists()
            (cookie,) = page.context.cookies()
            assert (cookie["httpOnly"], cookie["sameSite"]) == (True, "Strict")


def test_a_server_that_stops_and_starts(browser: Browser):
    gone = "Failed to load resource: net::ERR_CONNECTION_REFUSED"
    with served(START) as key:
        address = key.address
        home = address.partition("?")[0]
        context = opened(browser, server=home, expected=gone)
        page = context.__enter__()
        page.goto(address)
        still(page)
        port, cookies = int(re.search(r":(\d+)/", home)[1]), page.context.cookies()
    page.locator(".handle").press("ArrowRight")
    until(page, lambda: "vad gui has stopped" in page.locator(".message").inner_text())
    still(page)
    assert cookies
    with served(START, port) as again:
        page.context.new_page().goto(again.address)  # a new token, in another tab
        page.get_by_role("button", name="Try again").click()
        until(page, lambda: "61" in cell(page, 0, 0))
        context.__exit__(None, None, None)
