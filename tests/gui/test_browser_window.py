"""The window in a real browser: by hand, by keyboard, with mistakes, with a server that stops."""

from __future__ import annotations

import math
import re
import webbrowser
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import urlsplit
from urllib.request import url2pathname

import av
import pytest
from PIL import Image

import vad
from tests.browser import opened, until, violations
from vad.files.examples import example_path
from vad.gui.answers import pose
from vad.gui.messages import LONGEST, ExportQuestion, PoseQuestion
from vad.gui.server import served
from vad.gui.visit import visited
from vad.mechanisms import MECHANISMS
from vad.words import languages

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

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
    """Wait until nothing is asked, and a page stands."""
    until(page, lambda: page.locator(".window:not(.moving) .control:not([hidden])").count())


def load(page: Page, mechanism: str, **values: object) -> None:
    """Set a mechanism as a link does."""
    kept = "&".join([f"m={mechanism}", *(f"{name}={value}" for name, value in values.items())])
    same = page.evaluate("location.hash") == f"#{kept}"
    for address in (f"{kept}&step=0", kept) if same else (kept,):
        with page.expect_response("**/api/lesson"):
            page.evaluate(f"location.hash = '{address}'")
        still(page)
    assert page.evaluate("location.hash").startswith(f"#m={mechanism}")


def state(page: Page, name: str = "angle") -> float:
    """Return an input of the pose that is shown."""
    return page.evaluate(f"vad.state['{name}']")


def cell(page: Page, row: int, column: int) -> str:
    return page.locator(".results tbody tr").nth(row).locator("td").nth(column).inner_text()


def middle(page: Page, selector: str = "[data-vad-grip]") -> tuple[float, float]:
    box = page.locator(selector).bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def pivot(page: Page, mechanism: str) -> tuple[float, float]:
    """Return where the driver's motion is measured from."""
    place = pose(PoseQuestion(mechanism))["handle"]["about"]
    x, y = (
        page.locator(".panel")
        .first.locator("svg")
        .first.evaluate(
            "(svg, at) => { const p = new DOMPoint(...at).matrixTransform(svg.getScreenCTM());"
            " return [p.x, p.y]; }",
            place,
        )
    )
    return x, y


def about(centre: tuple[float, float], degrees: float, radius: float) -> tuple[float, float]:
    turn = math.radians(degrees)
    return centre[0] + radius * math.cos(turn), centre[1] - radius * math.sin(turn)


def asked(page: Page) -> list[str]:
    """Return a list that grows by the path of each question."""
    paths: list[str] = []
    page.on("request", lambda request: paths.append(request.url.rpartition("/api/")[2]))
    return paths


@pytest.mark.parametrize(
    ("mechanism", "moves"), [("slider-crank", 1), ("slider-crank", 20), ("hooke-joint", 20)]
)
def test_the_crank_follows_the_hand_without_python(window: Page, mechanism, moves):
    load(window, mechanism)
    centre, paths = pivot(window, mechanism), asked(window)
    window.mouse.move(*middle(window))
    window.mouse.down()
    window.evaluate("() => { own = setTimeout; setTimeout = (what, wait) => own(what, 50 * wait) }")
    window.mouse.move(*about(centre, 130, 90), steps=moves)
    assert state(window) == pytest.approx(130, abs=1.5)
    assert window.locator(".window.turned.moving:not(.copied)").count() == 1
    assert paths == []
    window.evaluate("() => { setTimeout = own }")
    window.mouse.move(*about(centre, 131, 90))
    window.mouse.up()
    still(window)
    assert paths == ["lesson"]
    assert window.locator(".window.turned.copied").count() == 1
    mechanism_ = MECHANISMS[mechanism]()
    motion = vad.solve(mechanism_, angle=state(window))
    assert f"{state(window):g}" in cell(window, 0, 0)
    assert motion.assembled


def test_the_fair_copy_keeps_step_and_scales(window: Page):
    load(window, "four-bar", step=9)
    before = window.locator(".panel .drawing > svg > g.hand:not(.ways)").count()
    window.keyboard.press("h")
    window.keyboard.press("ArrowRight")
    still(window)
    assert state(window) == 61
    assert window.locator(".copied").count() == 1
    assert window.locator(".panel .drawing > svg > g.hand:not(.ways)").count() == before == 3
    bar = window.locator(".scale.hand").first
    assert (
        bar.is_visible() and bar.evaluate("each => getComputedStyle(each).visibility") == "visible"
    )
    window.keyboard.press("Escape")
    until(window, lambda: not window.locator(".turned").count())
    assert window.locator(".scrub").input_value() == "9"
    assert "61" in window.locator(".steps").inner_text()


def test_the_keyboard_turns_it_and_keeps_its_place(window: Page):
    load(window, "four-bar")
    track = window.locator(".turner")
    track.focus()
    for key in ("PageUp", "PageUp", "ArrowRight", "Shift+ArrowLeft"):
        window.keyboard.press(key)
    still(window)
    angle = state(window)
    assert angle != 60
    assert window.evaluate("document.activeElement.className") == "turner"
    window.keyboard.press("Control+z")
    still(window)
    assert state(window) == 60


def test_a_finger_turns_it_and_a_narrow_window_does_not_scroll(window: Page):
    for size in ((640, 700), (390, 844)):
        window.set_viewport_size(dict(zip(("width", "height"), size, strict=True)))
        load(window, "slider-crank")
        centre, (x, y) = pivot(window, "slider-crank"), middle(window)
        touch = window.context.new_cdp_session(window)

        def send(kind: str, *at: float, touch=touch) -> None:
            points = [{"x": at[0], "y": at[1]}] if at else []
            touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

        send("touchStart", x, y)
        for degrees in range(70, 161, 10):
            send("touchMove", *about(centre, degrees, 50))
        send("touchEnd")
        touch.detach()
        until(window, lambda: state(window) == pytest.approx(160, abs=1.5))
        still(window)
        assert window.evaluate("scrollY") == 0
        assert window.evaluate("document.documentElement.scrollWidth") <= size[0]
    window.set_viewport_size({"width": 1280, "height": 800})


def test_a_dimension_asks_python_at_once(window: Page):
    load(window, "slider-crank")
    window.keyboard.press("c")  # curves are shown, and go on being shown
    paths = asked(window)
    crank = window.locator("[name=crank]")
    crank.fill("7 cm")
    crank.press("Enter")
    until(window, lambda: "crank\u00a070" in window.locator("header p").inner_text())
    still(window)
    assert paths[-1] == "lesson"
    assert crank.input_value() == "70"
    assert window.locator(".window.turned.curves").count() == 1
    omega = window.locator("[name=omega]")
    omega.fill("-120 rpm")
    omega.press("Enter")
    until(window, lambda: "−12.566" in cell(window, 0, 1))
    still(window)
    assert state(window, "omega") == pytest.approx(-4 * math.pi)


def test_what_was_typed_is_taken_back_after_the_fair_copy(window: Page):
    """The page that Python sends for other dimensions keeps what was done last."""
    load(window, "slider-crank")
    turned = state(window)
    window.locator("[name=crank]").fill("65")
    window.keyboard.press("Enter")
    still(window)
    window.locator("[name=rod]").fill("150")
    window.keyboard.press("Enter")
    still(window)
    undo = window.locator("[data-do=undo]")
    for crank, rod in ((65, 140), (60, 140)):
        undo.click()
        assert (state(window, "crank"), state(window, "rod")) == (crank, rod)
        still(window)
    assert undo.is_disabled()
    assert state(window) == turned


def test_the_list_of_formats_closes(window: Page):
    load(window, "slider-crank")
    formats, opener = window.locator(".save"), window.locator(".save summary")
    for away in ("Escape", "pointer", "Tab"):
        opener.click()
        assert formats.get_attribute("open") is not None
        if away == "pointer":
            window.locator("h1").click()
        else:
            for _ in range(20 if away == "Tab" else 1):
                window.keyboard.press(away)
        assert formats.get_attribute("open") is None, away
    assert window.locator(".turned").count() == 1


def test_the_address_at_a_limit_is_that_of_the_pose(window: Page):
    load(window, "four-bar", crank=60, coupler=72)
    window.locator("[name=angle]").fill("170")
    window.keyboard.press("Enter")
    until(window, lambda: f"angle={state(window)}" in window.evaluate("location.hash"))
    assert state(window) == pytest.approx(142.37, abs=0.01)


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
    load(window, "four-bar")
    window.evaluate("location.hash = 'm=four-bar&crank=130&angle=10'")
    says = window.locator(".message")
    until(window, lambda: "the links miss by 4.014 mm" in says.inner_text())
    assert violations(window) == []
    window.get_by_role("button", name="try angle θ 15.46").click()
    until(window, lambda: not window.locator(".message.wrong").count())
    still(window)
    assert state(window) == 15.46
    crank = window.locator("[name=crank]")
    for text, said in (("<b>bold</b>", "<b>bold</b>"), ("1 kg", "'kg' is not a unit")):
        crank.fill(text)
        crank.press("Enter")
        until(window, lambda said=said: said in says.inner_text())
        assert crank.get_attribute("aria-invalid") is not None
    assert window.locator(".message b").count() == 0
    load(window, "four-bar")
    assert not says.is_visible()


def test_the_number_that_was_typed_last_is_marked(window: Page):
    """Whatever Python says of it; what the page said of another number is gone."""
    load(window, "four-bar")
    crank = window.locator("[name=crank]")
    crank.fill("-3")
    crank.press("Enter")
    assert "must be positive" in window.locator(".said p").inner_text()
    crank.fill("1e9")
    crank.press("Enter")
    until(window, lambda: "the links miss" in window.locator(".message").inner_text())
    assert crank.get_attribute("aria-invalid") is not None
    assert window.locator("[name=angle]").get_attribute("aria-invalid") is None
    assert window.locator(".said p").inner_text() == "You turn the crank."
    crank.fill("45")
    crank.press("Enter")
    until(window, lambda: not window.locator(".message").is_visible())
    assert crank.get_attribute("aria-invalid") is None


def test_what_cannot_be_shown_leaves_nothing_of_another_mechanism(window: Page):
    load(window, "gate-actuator")
    window.evaluate("location.hash = 'm=double-slider&position=2000'")
    until(window, lambda: "links miss" in window.locator(".message").inner_text())
    assert window.locator("h1").inner_text() == "Double slider"
    assert window.locator(".panel, .results table").count() == 0
    load(window, "double-slider")
    assert window.locator(".panel").count() == 3


def test_a_window_opened_at_a_dead_centre_shows_the_position(window: Page):
    window.evaluate("location.hash = 'm=double-slider&position=1000'")
    until(window, lambda: window.locator(".window.turned.limited").count())
    assert window.locator("h1").inner_text() == "Double slider"
    assert state(window, "position") == 1000
    assert "–" in cell(window, 0, 1)
    assert not window.locator(".message").is_visible()
    assert violations(window) == []
    window.keyboard.press("ArrowLeft")
    still(window)
    assert window.locator(".limited").count() == 0
    assert "–" not in cell(window, 0, 1)


def test_draw_it_plays_the_lecture_of_the_pose(window: Page):
    load(window, "slider-crank")
    window.keyboard.press("ArrowRight")
    window.select_option(".speed", "4")
    window.get_by_role("button", name="Draw it").click()
    until(window, lambda: window.locator("[data-do=play].on").count())
    until(window, lambda: 0 < float(window.locator(".scrub").input_value()) < 3)
    assert window.locator(".turned").count() == 0
    assert "61°" in window.locator(".steps").inner_text()
    window.keyboard.press("Space")
    window.select_option(".speed", "1")


#: Moves the ring until another page stands; how often the table of the one that is gone changes.
_LATE = """(name) => new Promise((done) => {
  const find = (name) => document.querySelector(name), ring = find("[data-vad-grip]");
  const of = ring.getBoundingClientRect(), table = find(".results"), one = find("#mechanism");
  let late = 0, moves = 0;
  const to = (kind) => ring.dispatchEvent(new PointerEvent(kind, { clientX: of.x + moves++ % 40,
    clientY: of.y, bubbles: true, pointerId: 1 }));
  ring.setPointerCapture = () => {};
  new MutationObserver(() => { late += !table.isConnected; })
    .observe(table, { childList: true, subtree: true, characterData: true });
  to("pointerdown");
  one.value = name;
  one.dispatchEvent(new Event("change", { bubbles: true }));
  const step = () => {
    if (!ring.isConnected) return setTimeout(() => done([moves, late]), 200);
    to("pointermove");
    setTimeout(step, 5);
  };
  step();
})"""


def test_a_page_that_is_gone_is_written_no_more(window: Page):
    load(window, "slider-crank", angle=50)
    moves, late = window.evaluate(_LATE, "whitworth")
    still(window)
    assert (moves > 3, late) == (True, 0)


def test_another_mechanism_is_an_entry_of_the_history(window: Page):
    load(window, "four-bar")
    window.select_option("#mechanism", "hoeken.toml")  # an example
    until(window, lambda: "Hoeken" in window.locator("h1").inner_text())
    still(window)
    window.go_back()
    until(window, lambda: window.locator("h1").inner_text() == "Four-bar")
    still(window)
    window.go_forward()
    until(window, lambda: "Hoeken" in window.locator("h1").inner_text())
    still(window)


#: Goes to another address, and changes what the address has before the page hears of it.
_BETWEEN = """(hash) => new Promise((done) => {
  const pushed = [], push = history.pushState;
  history.pushState = (...given) => { pushed.push(given[2]); push.apply(history, given); };
  addEventListener("hashchange", () => { history.pushState = push; done(pushed); }, { once: true });
  location.hash = hash;
  const { dataset } = document.querySelector(".window"), before = dataset.theme;
  dataset.theme = "chalk";
  setTimeout(() => { dataset.theme = before; });
})"""


def test_nothing_is_remembered_between_two_addresses(window: Page):
    load(window, "four-bar")
    assert window.evaluate(_BETWEEN, "#m=whitworth") == []
    until(window, lambda: window.locator("h1").inner_text().startswith("Whitworth"))
    still(window)


def test_a_file_is_opened(window: Page, tmp_path: Path):
    load(window, "four-bar")
    text = example_path("toggle-press").read_text("utf-8").replace('"Toggle', '"My toggle')
    mine, wrong = tmp_path / "mine.toml", tmp_path / "wrong.toml"
    mine.write_text(text)
    window.locator("input[type=file]").set_input_files(mine)
    until(window, lambda: window.locator("h1").inner_text().startswith("My "))
    still(window)
    window.keyboard.press("ArrowRight")
    still(window)
    with window.expect_navigation():
        window.select_option("#language", "de")
    still(window)
    assert window.locator("#mechanism").input_value() == "mine.toml"
    for name, title in (("four-bar", "Gelenkviereck"), ("mine.toml", "Kniehebelpresse")):
        window.select_option("#mechanism", name)
        until(window, lambda title=title: title in window.locator("h1").inner_text())
        still(window)
    with window.expect_navigation():
        window.select_option("#language", "en")
    still(window)
    wrong.write_text("title = 3\n")
    window.locator("input[type=file]").set_input_files(wrong)
    until(window, lambda: "wrong.toml" in window.locator(".message").inner_text())
    paths, large = asked(window), tmp_path / "large.toml"
    for size in (LONGEST, 5 * LONGEST):
        large.write_bytes(b"#" * size)
        window.locator("input[type=file]").set_input_files(large)
        until(window, lambda: "large.toml is too large" in window.locator(".message").inner_text())
    assert paths == []
    wrong.write_text("")
    window.locator("input[type=file]").set_input_files(wrong)
    until(window, lambda: "wrong.toml: is empty" in window.locator(".message").inner_text())


def test_every_kind_of_file(window: Page):
    load(window, "slider-crank")
    window.select_option(".speed", "4")
    for extension in ("png", "svg", "pdf", "mp4", "gif", "html"):
        window.locator(".save summary").click()
        with window.expect_download() as waiting:
            window.locator(f"[data-save={extension}]").click()
        assert waiting.value.suggested_filename == f"slider-crank.{extension}"
        path = waiting.value.path()
        begin = path.read_bytes()[:400]
        if extension == "png":
            with Image.open(path) as image:
                assert image.size == (320, 240)
        elif extension == "mp4":
            with av.open(str(path)) as film:
                assert 5 < film.duration / 1e6 < 60
        else:
            signs = {"svg": b"<svg", "pdf": b"%PDF", "gif": b"GIF89a", "html": b"<!DOCTYPE html>"}
            assert signs[extension] in begin
    window.select_option(".speed", "1")
    for kind, name, sign in (
        ("turn", "slider-crank-turn.html", b"<!DOCTYPE html>"),
        ("problem", "slider-crank-problem.pdf", b"%PDF"),
    ):
        window.locator(".save summary").click()
        with window.expect_download() as waiting:
            window.locator(f"[data-save={kind}]").click()
        assert waiting.value.suggested_filename == name
        assert waiting.value.path().read_bytes().startswith(sign)


def test_the_address_has_all_that_is_set(window: Page, address: str):
    load(window, "four-bar", crank=35, angle=75, assembly="crossed", unit="cm", step=4)
    assert window.locator(".scrub").input_value() == "4"
    window.locator("[data-do=theme]").click()
    window.reload()
    still(window)
    assert state(window) == 75
    assert "crank\u00a035\u00a0cm" in window.locator("header p").inner_text()
    assert window.locator(".choice input[value=crossed]").is_checked()
    assert window.locator(".scrub").input_value() == "4"
    assert window.locator(".vad").get_attribute("data-theme") == "chalk"
    window.locator("[data-do=theme]").click()
    other = window.context.new_page()  # two tabs do not disturb each other
    other.goto(address.partition("?")[0] + "#m=scotch-yoke&colour=red&crank=x")
    until(other, lambda: "'x'" in other.locator(".message").inner_text())
    window.keyboard.press("h")
    window.keyboard.press("ArrowRight")
    still(window)
    assert state(window) == 76
    assert "unit=cm" in window.url
    other.close()


@pytest.mark.exhaustive(6)
@pytest.mark.parametrize("code", languages())
def test_every_mechanism_in_every_language(window: Page, address: str, code: str, exhaustive: bool):
    """In a usual run one mechanism in six is looked at, and one in the other languages."""
    every = 1 if exhaustive else 6
    window.goto(f"{address.partition('?')[0]}?lang={code}")
    still(window)
    assert window.evaluate("document.documentElement.lang") == code
    names = window.locator("#mechanism optgroup").first.locator("option")
    values = names.evaluate_all("all => all.map(e => e.value)")
    names = [name for name in values if not name.endswith(".toml")]  # of files that were opened
    assert names == list(MECHANISMS)
    for name in names[::every] if code == "de" else names[:1]:
        title = window.locator(f"#mechanism option[value={name}]").inner_text()
        window.select_option("#mechanism", name)
        until(window, lambda title=title: window.locator("header h1").inner_text() == title)
        still(window)
        assert window.locator("[data-vad-grip]").is_visible()
    assert violations(window) == []
    if code == "de":
        assert window.locator("option[value='hoeken.toml']").inner_text() == "Hoekens Geradführung"
        window.select_option("#mechanism", "four-bar")
        still(window)
        for box in (window.locator("[name=angle]"), window.locator("[name=crank]")):
            box.fill("40,5")
            box.press("Enter")
            still(window)
            assert not window.locator(".message").is_visible()
        assert state(window) == 40.5
        assert "Kurbel\u00a040,5" in window.locator("header p").inner_text()


@pytest.mark.exhaustive(8)
@pytest.mark.parametrize("width", [320, 700, 1000])
def test_a_narrow_window_has_all_of_it(window: Page, address: str, width):
    window.goto(address.partition("?")[0])
    window.set_viewport_size({"width": width, "height": 800})
    load(window, "whitworth")
    window.locator("[data-do=theme]").evaluate("button => button.click()")
    assert window.evaluate("document.documentElement.scrollWidth") <= width
    for selector in ("[data-vad-grip]", ".save summary", ".results", "#mechanism"):
        window.locator(selector).first.scroll_into_view_if_needed()
        assert window.locator(selector).first.is_visible()
    assert violations(window) == []
    window.locator("[data-do=strokes]").click()
    window.locator("[name=crank]").scroll_into_view_if_needed()
    assert window.locator("[name=crank]").is_visible()
    window.set_viewport_size({"width": 1280, "height": 800})


def test_a_phone_shows_both_drawings_between_bar_and_dock(window: Page, address: str):
    window.goto(address.partition("?")[0])
    window.set_viewport_size({"width": 390, "height": 844})
    load(window, "four-bar")
    tools, dock = (window.locator(each).bounding_box() for each in (".tools", ".control"))
    equations = [each.bounding_box() for each in window.locator(".panel:not(.far) .foot p").all()]
    assert len(equations) == 2
    assert all(each["y"] + each["height"] <= dock["y"] for each in equations)
    assert window.locator(".board").bounding_box()["y"] == tools["y"] + tools["height"]
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
    page.keyboard.press("ArrowRight")
    until(page, lambda: "vad gui has stopped" in page.locator(".message").inner_text())
    page.keyboard.press("ArrowRight")  # the hand needs no server
    until(page, lambda: "62" in cell(page, 0, 0))
    still(page)
    assert page.locator(".window.alone:not(.stale)").count() == 1
    assert cookies
    with served(START, port) as again:
        page.context.new_page().goto(again.address)  # a new token, in another tab
        page.get_by_role("button", name="Try again").click()
        until(page, lambda: page.locator(".copied:not(.alone)").count())
        context.__exit__(None, None, None)


def test_who_likes_the_dark_sees_the_board(browser: Browser):
    with served(START) as key:
        home = key.address.partition("?")[0]
        with opened(browser, server=home, color_scheme="dark") as page:
            page.goto(key.address)
            still(page)
            assert page.locator(".vad").get_attribute("data-theme") == "chalk"
            assert "theme=" not in page.url
            page.locator("[data-do=theme]").click()
            until(page, lambda: "theme=paper" in page.url)
            page.reload()
            still(page)
            assert page.locator(".vad").get_attribute("data-theme") == "paper"
