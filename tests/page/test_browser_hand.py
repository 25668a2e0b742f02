"""The mechanism of a lesson's page in the hand: taken, turned, stopped, asked, and given back."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator
from html import escape
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect

import vad
from tests.browser import opened, painted, until, violations
from tests.page.lessons import at, page_of, press, show, written
from vad.files.examples import example_path
from vad.kinematics.reach import closing_range
from vad.page.dimensions import readable
from vad.units import read

STEP = 14  # Velocity 5
LIMITED = vad.FourBar(crank=130)


@pytest.fixture(scope="module")
def turned(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    """Return a four-bar's page, opened once; its glides take no time."""
    size = {"width": 1280, "height": 720}
    with opened(browser, viewport=size, reduced_motion="reduce") as page:
        show(page, tmp_path_factory.mktemp("hand"), page_of("four-bar"))
        yield page


@pytest.fixture
def page(turned: Page) -> Page:
    """Return the page in the lesson at Velocity 5."""
    turned.set_viewport_size({"width": 1280, "height": 720})
    turned.evaluate("document.activeElement.blur()")
    turned.evaluate(f"() => void vad.step({STEP})")
    return turned


def angle(page: Page) -> float:
    return float(page.evaluate("() => vad.state.angle"))


def middle(page: Page, selector: str) -> tuple[float, float]:
    box = page.locator(selector).bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def about(page: Page, degrees: float, radius: float) -> tuple[float, float]:
    """Return the place of the pointer at an angle of the crank, about its pivot A."""
    x, y = middle(page, "[data-vad-grip]")
    turn = math.radians(angle(page))
    pivot = x - radius * math.cos(turn), y + radius * math.sin(turn)
    new = math.radians(degrees)
    return pivot[0] + radius * math.cos(new), pivot[1] - radius * math.sin(new)


def crank(page: Page) -> float:
    """Return the length of the crank in the window."""
    return 40.0 * float(
        page.evaluate(
            """() => {
              const svg = document.querySelector('.drawing > svg');
              const bar = document.querySelector('.scale .bar');
              const bigger = svg.getBoundingClientRect().width / svg.viewBox.baseVal.width;
              const long = bigger * bar.style.getPropertyValue('--n');
              return long / parseFloat(bar.parentNode.textContent);
            }"""
        )
    )


def test_a_pointer_takes_the_crank_and_the_page_stands_still(page: Page) -> None:
    places = """() => [...document.querySelectorAll('header, .panel, .results, .buttons')]
      .map((each) => JSON.stringify(each.getBoundingClientRect()))"""
    for width, height in ((1280, 720), (640, 700), (390, 844)):
        page.set_viewport_size({"width": width, "height": height})
        painted(page)
        before, length = page.evaluate(places), crank(page)
        start, end = about(page, 60, length), about(page, 150, length)
        page.mouse.move(*start)
        page.mouse.down()
        page.mouse.move(*about(page, 100, length), steps=5)
        page.mouse.move(*end, steps=5)
        page.mouse.up()
        assert angle(page) == pytest.approx(150, abs=1.5), width
        assert page.evaluate(places) == before, width
        assert page.evaluate("scrollY") == 0
        press(page, "Escape")
        assert at(page) == STEP
        expect(page.locator(".vad")).not_to_have_class(re.compile("turned"))


def test_the_table_follows_and_comes_back(page: Page) -> None:
    table = page.locator(".results tbody")
    before = table.inner_html()
    page.evaluate("() => vad.pose({ angle: 128.4, omega: 5 })")
    truth = vad.solve(vad.FourBar(), angle=128.4, omega=5.0)
    text = table.text_content()
    assert f"{truth.link('rocker').angle:.1f}°" in text and "128.4°" in text
    assert page.locator(".turned .label:visible").count() > 3
    page.locator("[data-do=return]").click()
    assert table.inner_html() == before


def test_the_lesson_keeps_its_own_numbers(browser: Browser, tmp_path: Path) -> None:
    """A lesson writes so many digits that its equations hold, a hand always four."""
    cells = "() => [...document.querySelectorAll('.cell')].map((each) => each.innerHTML)"
    html = written(vad.GateActuator())
    with opened(browser, java_script_enabled=False) as page:
        show(page, tmp_path, html)
        own = page.evaluate(cells)
    with opened(browser) as page:
        show(page, tmp_path, html)
        assert page.evaluate(cells) == own
        page.evaluate("() => void vad.pose({ position: 4.2 })")
        assert page.evaluate(cells) != own
        press(page, "Escape")
        expect(page.locator(".vad")).not_to_have_class(re.compile("turned"))
        page.wait_for_timeout(300)  # labels glide on
        assert page.evaluate(cells) == own


def test_only_what_is_drawn_is_shown_until_all_is_asked_for(page: Page) -> None:
    press(page, "h")
    expect(page.locator(".said p")).to_have_text(
        "You turn the crank. Shown is what is drawn up to Velocity 5."
    )
    expect(page.locator("[data-do=return]")).to_have_text(re.compile("Back to Velocity 5"))
    shown = page.locator(".panel:nth-child(3) .hand [data-m]:visible")
    assert shown.count() == 0
    page.locator("[data-do=all]").click()
    assert shown.count() > 3
    assert page.locator(".panel:nth-child(3) .hand .label:visible").count() > 3
    press(page, "h")
    assert at(page) == STEP


def test_names_of_views_and_bars_come_with_what_is_drawn(browser: Browser, tmp_path: Path) -> None:
    seen = """() => [...document.querySelectorAll('.hand text')]
      .filter((each) => each.getBoundingClientRect().width).map((each) => each.textContent)"""
    with opened(browser, reduced_motion="reduce") as page:
        show(page, tmp_path, page_of("spatial-four-bar"), "#step=position:14")
        press(page, "h")
        found = page.evaluate(seen)
        assert "along A" in found and "along D" not in found
        assert not any("mm/s" in each for each in found)
        page.locator("[data-do=all]").click()
        found = page.evaluate(seen)
        assert "along D" in found and sum("mm/s" in each for each in found) == 2


def test_a_hand_that_takes_the_whole_page_sees_no_panel_larger_than_another(page: Page) -> None:
    press(page, "Home", "h")
    expect(page.locator(".vad")).to_have_class(re.compile("turned"))
    expect(page.locator(".vad")).not_to_have_class(re.compile("staged"))


def test_every_key_of_the_hand(page: Page) -> None:
    press(page, "h", "ArrowRight", "ArrowRight")
    assert angle(page) == 62
    press(page, "Shift+ArrowLeft")
    assert angle(page) == pytest.approx(61.9)
    press(page, "PageDown", "End")
    assert angle(page) == pytest.approx(166.9)
    press(page, "Home", "PageUp", "ArrowLeft")
    assert angle(page) == pytest.approx(60.9)
    track = page.locator(".turner")
    assert float(track.input_value()) == pytest.approx(60.9)
    expect(track).to_have_attribute("aria-valuetext", "60.9 degrees")
    press(page, "2")
    assert at(page) == 9
    expect(page.locator(".vad")).not_to_have_class(re.compile("turned"))


def test_the_list_of_keys_opens_over_the_hand(page: Page) -> None:
    press(page, "h", "?")
    expect(page.locator("dialog")).to_be_visible()
    press(page, "Escape")
    expect(page.locator("dialog")).not_to_be_visible()
    expect(page.locator(".vad")).to_have_class(re.compile("turned"))


def test_the_hand_gives_back_a_chapter_that_was_chosen(page: Page) -> None:
    press(page, "3")
    count, chapter = page.locator(".count"), page.locator(".chapters [aria-current=true]")
    expect(count).to_have_text("0 / 13")
    press(page, "h")
    expect(page.locator("[data-do=return]")).to_contain_text("Back to the lesson")
    press(page, "Escape")
    expect(count).to_have_text("0 / 13")
    expect(chapter).to_have_text("Acceleration")
    press(page, "h", "2")
    expect(count).to_have_text("0 / 7")
    expect(chapter).to_have_text("Velocity")


def test_play_turns_the_crank(page: Page) -> None:
    press(page, "h", " ")
    until(page, lambda: angle(page) > 63)
    expect(page.locator(".said p")).to_contain_text("The mechanism runs by itself.")
    press(page, " ")
    expect(page.locator(".said p")).to_contain_text("You turn the crank.")
    stopped = angle(page)
    assert len(str(stopped)) <= 5, "it goes in tenths"
    page.wait_for_timeout(100)
    assert angle(page) == stopped


def test_undo_has_one_entry_for_a_gesture(page: Page) -> None:
    press(page, "h")
    page.evaluate("() => vad.pose({ angle: 100 })")
    page.evaluate("() => vad.pose({ angle: 170, omega: 3 })")
    press(page, "Control+z")
    assert page.evaluate("() => [vad.state.angle, vad.state.omega]") == [100, 10]
    press(page, "Control+z", "Control+z")
    assert angle(page) == 60
    press(page, "Control+Shift+z", "Control+Shift+z")
    assert page.evaluate("() => vad.state.omega") == 3
    expect(page.locator("[data-do=redo]")).to_be_disabled()


def test_the_box_reads_numbers_and_refuses_the_rest(page: Page) -> None:
    press(page, "h")
    box = page.locator(".said input")
    box.fill("200.25")
    press(page, "Enter")
    assert angle(page) == 200.25
    box.fill("")
    press(page, "Enter")
    expect(box).to_have_attribute("aria-invalid", "true")
    expect(page.locator(".said p")).to_contain_text("must be a finite number")
    assert angle(page) == 200.25


def test_what_was_refused_is_marked_until_something_else_is_done(page: Page) -> None:
    press(page, "h")
    crank, rocker = page.locator("[name=crank]"), page.locator("[name=rocker]")
    for after in ("drag", "type", "leave"):
        crank.fill("1/3")
        press(page, "Enter")
        expect(crank).to_have_attribute("aria-invalid", "true")
        if after == "drag":
            page.mouse.move(*middle(page, "[data-vad-grip]"))
            page.mouse.down()
            page.mouse.move(*about(page, 70, 80), steps=3)
            page.mouse.up()
        elif after == "type":
            rocker.fill("85")
            press(page, "Enter")
        else:
            crank.blur()
            press(page, "Escape", "h")
        expect(crank).not_to_have_attribute("aria-invalid", "true")
        expect(crank).to_have_value("40")


def test_every_way_to_a_pose_hatches_where_the_links_do_not_close(page: Page) -> None:
    press(page, "h")
    hatched = page.locator(".ticks s")
    expect(hatched).to_have_count(0)
    page.evaluate("() => void vad.pose({ crank: 60, coupler: 72 })")
    expect(hatched).to_have_count(1)
    press(page, "Control+z")
    expect(hatched).to_have_count(0)


def test_the_choice_of_an_assembly_has_a_name(page: Page) -> None:
    press(page, "h")
    expect(page.get_by_role("radiogroup", name="Assembly")).to_have_count(1)


def test_rates_are_set_in_the_rail(page: Page) -> None:
    press(page, "h")
    box, slider = (
        page.locator(f".size input{kind}").first for kind in (":not([type])", "[type=range]")
    )
    box.fill("-25")
    press(page, "Enter")
    assert page.evaluate("() => vad.state.omega") == -25
    slider.evaluate("s => { s.value = 4; s.dispatchEvent(new Event('input')); }")
    assert page.evaluate("() => vad.state.omega") == 4
    slider.dblclick(position={"x": 2, "y": 12})
    assert page.evaluate("() => vad.state.omega") == 10


def test_it_answers_as_the_command_line_does(page: Page) -> None:
    for inputs in ({"angle": 40.0}, {"angle": 200.0, "omega": -3.0, "alpha": 7.0}):
        told = page.evaluate("given => vad.solve(given)", inputs)
        truth = vad.solve(vad.FourBar(), **({"omega": 10.0, "alpha": 3.0} | inputs)).to_dict()
        assert list(told) == list(truth)
        assert json.dumps(_rounded(told)) == json.dumps(_rounded(truth))
    assert at(page) == STEP


def _rounded(data: Any) -> Any:
    if isinstance(data, dict):
        return {name: _rounded(each) for name, each in data.items()}
    if isinstance(data, list):
        return [_rounded(each) for each in data]
    return float(f"{data:.13g}") + 0.0 if isinstance(data, int | float) else data


def test_what_is_wrong_is_said_and_nothing_changes(page: Page) -> None:
    for asked, said in (
        ("{ angl: 3 }", "angl: this page has no such input"),
        ("{ angle: '3' }", "angle: must be a finite number"),
        ("{ angle: NaN }", "angle: must be a finite number, got NaN"),
        ("{ angle: [3] }", "angle: must be a finite number"),
        ("{ omega: 1e61 }", "omega: must be from -1e+60 to 1e+60 rad/s, where numbers are right"),
        (
            "{ assembly: 'parallel' }",
            'assembly: must be "open" or "crossed" in this page, got "parallel"',
        ),
        ("{ assembly: 'left' }", 'assembly: must be "open" or "crossed" in this page, got "left"'),
        ("null", "must be an object"),
        ("[1]", "must be an object"),
        ("{ __proto__: null, constructor: 3 }", "constructor: this page has no such input"),
    ):
        for method in ("solve", "pose"):
            told = page.evaluate(f"() => vad.{method}({asked})")
            assert told["error"].startswith(said), asked
    assert page.evaluate("() => vad.step('flight:1')")["error"].startswith("step: ")
    assert at(page) == STEP


def test_listeners_hear_of_poses_and_steps(page: Page) -> None:
    page.evaluate(
        """() => { window.heard = [];
          vad.addEventListener('pose', (pose) => heard.push(pose.angle));
          vad.addEventListener('step', (step) => heard.push(`step ${step}`)); }"""
    )
    page.evaluate("() => { vad.pose({ angle: 90 }); vad.step('velocity:4'); }")
    heard = page.evaluate("heard")
    assert 90 in heard and f"step {STEP - 1}" in heard


def test_axe_finds_nothing_in_the_hand(page: Page) -> None:
    press(page, "h")
    assert violations(page) == []
    page.set_viewport_size({"width": 640, "height": 700})
    page.locator("[data-do=strokes]").click()
    assert violations(page) == []
    page.locator("[data-do=strokes]").click()


def test_a_phone_has_the_pace_of_a_turn_beside_the_way_back(page: Page) -> None:
    speed = page.locator(".speed")
    page.set_viewport_size({"width": 390, "height": 844})
    expect(speed).to_be_hidden()
    press(page, "h")
    painted(page)
    box, others = speed.bounding_box(), page.locator(".said > :visible, .ticks")
    for other in (each.bounding_box() for each in others.all()):
        apart = [box[a] >= other[a] + other[s] or other[a] >= box[a] + box[s] for a, s in _SIDES]
        assert any(apart), other
    speed.select_option("4")
    speed.select_option("1")


def test_the_region_speaks_when_the_hand_rests(page: Page) -> None:
    press(page, "h", "ArrowRight")
    until(page, lambda: "61.0°" in page.locator("[role=status]").inner_text(), 3)


def test_a_finished_polygon_is_described(page: Page) -> None:
    """By its letters, without those that go with a part of no length."""
    label = page.locator(".drawing > svg").nth(2)
    press(page, "End")
    page.evaluate("() => void vad.pose({ angle: 60, alpha: 0 })")
    wanted = "Acceleration: a prime, d prime is the pole; b prime 4000\u00a0mm/s² at 240.0°; c n "
    expect(label).to_have_attribute("aria-label", re.compile(f"^{wanted}"))
    page.evaluate("() => void vad.pose({ alpha: 30 })")
    expect(label).to_have_attribute("aria-label", re.compile("b prime n 4000"))


def test_the_links_stop_where_they_part(browser: Browser, tmp_path: Path) -> None:
    html = written(LIMITED, angle=60.0)
    with opened(browser, viewport={"width": 1280, "height": 720}, reduced_motion="reduce") as page:
        show(page, tmp_path, html, "#step=99")
        press(page, "End", "h", "End")
        assert angle(page) == pytest.approx(120.25478740083423, abs=1e-9)
        expect(page.locator(".said p")).to_have_text(
            "Limit position at 120.255°: BC and DC are in line."
        )
        expect(page.locator(".said input")).to_have_value("120.255")
        assert "120.255°" in page.locator(".results").inner_text()
        assert "ω3= –" in page.locator(".results").inner_text()
        assert "10" in page.locator(".results tr").nth(1).inner_text()
        assert violations(page) == []
        assert page.locator(".ticks s").count() == 3
        press(page, "ArrowRight")
        assert angle(page) == pytest.approx(120.25478740083423, abs=1e-9)
        press(page, "ArrowLeft")
        assert angle(page) == pytest.approx(119.25478740083423, abs=1e-9)
        # A pointer that is led all round stays in the stretch.
        x, y = middle(page, "[data-vad-grip]")
        turn, length = math.radians(angle(page)), 130 * crank(page) / 40
        pivot = x - length * math.cos(turn), y + length * math.sin(turn)
        page.mouse.move(x, y)
        page.mouse.down()
        for degrees in range(120, 490, 5):
            new = math.radians(degrees)
            page.mouse.move(pivot[0] + length * math.cos(new), pivot[1] - length * math.sin(new))
            assert 13.3 < angle(page) < 120.3
        page.mouse.up()
        told = page.evaluate("() => vad.solve({ angle: 200 })")
        assert told["error"] == (
            "angle 200°: the links do not close; they close for 13.3254° … 120.255° and "
            "239.745° … 346.675°"
        )
        assert "error" not in page.evaluate(
            "angle => vad.solve({ angle })", float(told["hint"].split()[-1])
        )
        # Beyond the limit the links go on in the other assembly, at a scale of now.
        press(page, "End", "End")
        page.locator("[data-do=other]").click()
        assert page.evaluate("() => vad.state.assembly") == "crossed"
        bars = page.locator(".scale:visible").all_inner_texts()
        assert bars[2] == "200\u202f000\u00a0mm/s²"


@pytest.mark.parametrize(("length", "place"), [(250, 347.75), (130, 300.0), (130, 60.0)])
def test_a_lesson_stands_in_any_stretch(
    browser: Browser, tmp_path: Path, length: float, place: float
) -> None:
    """One that runs through 0° begins below it, and another one is not the first."""
    with opened(browser, viewport={"width": 1280, "height": 720}) as page:
        show(page, tmp_path, written(vad.FourBar(crank=length), angle=place))
        press(page, "End", "h")
        expect(page.locator(".said p")).to_have_text("You turn the crank.")
        press(page, "ArrowRight")
        assert angle(page) == place + 1.0
        page.evaluate(
            """() => { window.seen = [];
              vad.addEventListener('pose', ({ angle }) => seen.push(angle)); }"""
        )
        press(page, "Escape")
        expect(page.locator(".vad")).not_to_have_class(re.compile("turned"))
        assert all(place <= each <= place + 1.0 for each in page.evaluate("seen"))


def test_a_turn_begins_and_ends_at_0(page: Page) -> None:
    for end in (0.0, 360.0):
        page.evaluate("(angle) => void vad.pose({ angle })", end)
        assert angle(page) == 0.0
        assert page.locator(".results .cell").first.text_content().endswith("= 0°")


_COVERED = """() => {
  const { top } = document.querySelector(".control").getBoundingClientRect();
  return [...document.querySelectorAll(".foot p")].map((each) => each.getBoundingClientRect())
    .map(({ bottom }) => bottom - top);
}"""
_LOWEST = """() => Math.min(...[...document.querySelectorAll(".other, .hides")]
  .filter((each) => each.checkVisibility()).map((each) => each.offsetHeight))"""


def test_a_finger_turns_the_crank_in_a_page_that_scrolls(browser: Browser, tmp_path: Path) -> None:
    """On a phone, where both equations are seen, and each name can be touched."""
    size = {"width": 390, "height": 844}
    with opened(browser, viewport=size, has_touch=True, reduced_motion="reduce") as page:
        show(page, tmp_path, written(vad.load(example_path("jansen-leg"))()), "#hand")
        assert max(page.evaluate(_COVERED)) <= 0 and page.evaluate(_LOWEST) >= 44
        page.goto("about:blank")
        page.set_viewport_size({"width": 390, "height": 500})
        show(page, tmp_path, page_of("four-bar"), f"#step={STEP}")
        client, length = page.context.new_cdp_session(page), crank(page)
        places = [about(page, degrees, length) for degrees in range(60, 200, 10)]
        for kind, spots in (
            ("touchStart", places[:1]),
            *(("touchMove", [spot]) for spot in places[1:]),
            ("touchEnd", []),
        ):
            points = [{"x": x, "y": y} for x, y in spots]
            client.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        assert angle(page) == pytest.approx(190, abs=2)
        assert page.evaluate("scrollY") == 0


_SIDES = (("x", "width"), ("y", "height"))
_HIGH = "heard.findLast(({ height }) => height).height"


def test_a_page_around_it_drives_it_and_hears_of_it(browser: Browser, tmp_path: Path) -> None:
    """In a sandbox without an origin; it makes the frame as high as the page says."""
    inner = escape(page_of("four-bar"))
    frame = f'<iframe sandbox="allow-scripts" width="800" height="200" srcdoc="{inner}"></iframe>'
    heard = """<script>var heard=[];onmessage=({data:{vad}})=>{
      heard.push(vad);if(vad.height)document.querySelector("iframe").height=vad.height}</script>"""
    send = "said => document.querySelector('iframe').contentWindow.postMessage(said, '*')"
    with opened(browser) as page:
        show(page, tmp_path, f"<!doctype html><meta charset=utf-8>{heard}{frame}")
        board = page.frame_locator("iframe").locator(".board")
        until(page, lambda: board.bounding_box()["width"] > 720)
        assert 400 < page.evaluate("heard.at(-1).height") < 600
        page.evaluate(send, {"vad": {"step": "velocity:4"}})
        until(page, lambda: page.evaluate(f"heard.at(-1).step === {STEP - 1}"))
        # What panels in work take of a higher frame they give back.
        for width, least, most in ((800, 400, 600), (400, 900, 1400), (800, 400, 600)):
            before = page.evaluate("heard.length")
            page.locator("iframe").evaluate("(frame, width) => { frame.width = width; }", width)
            until(page, lambda ends=(least, most): ends[0] < page.evaluate(_HIGH) < ends[1])
            page.wait_for_timeout(300)
            assert page.evaluate("heard.length") <= before + 3  # of which two follow the first
        page.evaluate(send, {"vad": {"pose": {"angle": 90}}})
        until(page, lambda: page.evaluate("heard.at(-1).pose?.angle === 90"))
        for nonsense in (3, None, {"vad": 3}, {"vad": {"pose": 3}}, {"vad": {"pose": {"x": 1}}}):
            page.evaluate(send, nonsense)
        until(page, lambda: page.evaluate("heard.filter(({ error }) => error).length === 2"))
        inside = page.frame_locator("iframe")
        expect(inside.locator(".said input")).to_have_value("90.0")


def test_it_prints_from_the_hand(page: Page, tmp_path: Path) -> None:
    from pypdf import PdfReader

    page.evaluate("() => vad.pose({ angle: 128.4 })")
    page.pdf(path=tmp_path / "a.pdf", prefer_css_page_size=True)
    pages = [each.extract_text() for each in PdfReader(tmp_path / "a.pdf").pages]
    assert "100.5°" in pages[0] and "Back to" not in pages[0] and "Dimensions" not in pages[0]
    assert angle(page) == 128.4
    assert len(pages) == 1  # the captions are of another pose
    page.evaluate("() => void vad.step(7)")
    page.pdf(path=tmp_path / "a.pdf", prefer_css_page_size=True)
    assert len(PdfReader(tmp_path / "a.pdf").pages) > 1


def test_a_german_page_reads_its_own_numbers(browser: Browser, tmp_path: Path) -> None:
    with opened(browser, reduced_motion="reduce") as page:
        show(page, tmp_path, page_of("four-bar", "de"))
        press(page, "End", "h")
        box = page.locator(".said input")
        box.fill("40,5")
        press(page, "Enter")
        assert angle(page) == 40.5
        expect(box).to_have_value("40,5")
        expect(page.locator("[data-do=return]")).to_have_text(re.compile("Zurück zur Lektion"))


def test_the_address_keeps_the_hand(browser: Browser, tmp_path: Path) -> None:
    with opened(browser, reduced_motion="reduce") as page:
        show(page, tmp_path, page_of("four-bar"), "#hand&angle=128.4&omega=5&x=3&alpha=")
        assert page.evaluate("() => [vad.state.angle, vad.state.omega]") == [128.4, 5]
        press(page, "ArrowRight")
        until(page, lambda: page.url.endswith("#hand&angle=129.4&omega=5"))
        press(page, "t")
        until(page, lambda: page.url.endswith("#hand&angle=129.4&omega=5&theme=chalk"))
        page.reload()
        expect(page.locator(".vad")).to_have_attribute("data-theme", "chalk")
        press(page, "Escape")
        until(page, lambda: "#step=" in page.url)


def test_who_likes_the_dark_sees_the_board(browser: Browser, tmp_path: Path) -> None:
    for scheme, theme in (("dark", "chalk"), ("light", "paper")):
        with opened(browser, color_scheme=scheme) as page:
            show(page, tmp_path, page_of("four-bar"))
            expect(page.locator(".vad")).to_have_attribute("data-theme", theme)


def test_dimensions_are_set_in_the_rail(page: Page) -> None:
    press(page, "h")
    page.locator("[data-do=all]").click()
    box = page.get_by_label("crank, mm").first
    box.fill("64")
    press(page, "Enter")
    expect(page.locator("header p")).to_have_text(re.compile("crank\u00a064\u00a0mm"))
    told = page.evaluate("() => vad.solve({ angle: 100 })")
    truth = vad.solve(vad.FourBar(crank=64), angle=100.0, omega=10.0, alpha=3.0).to_dict()
    assert told["parameters"] == truth["parameters"]
    assert told["links"]["rocker"] == pytest.approx(truth["links"]["rocker"], rel=1e-12)
    # With this crank the links do not close everywhere.
    ends = sorted(x % 360 for x in closing_range(vad.FourBar(crank=64))[0])
    assert page.locator(".ticks s").count() == 2
    page.evaluate("() => vad.pose({ angle: 20 })")
    page.locator(".turner").focus()
    press(page, "Home")
    assert angle(page) == pytest.approx(ends[0], abs=1e-9)
    assert violations(page) == []
    press(page, "Escape")
    expect(page.locator("header p")).to_have_text(re.compile("crank\u00a040\u00a0mm"))
    assert page.evaluate("() => vad.state.crank") == 40


def test_the_line_beside_the_title_has_what_is_no_longer_usual(page: Page) -> None:
    line = page.locator("header p")
    before = line.text_content()
    page.evaluate("() => void vad.pose({ ground_angle: -20.5, rocker: 75 })")
    now = f"{before}, ground angle from x −20.5°".replace("80", "75").replace(" ", "\u00a0")
    assert line.text_content().replace(" ", "\u00a0") == now
    assert page.evaluate("() => document.documentElement.scrollHeight <= innerHeight")
    press(page, "Escape")
    assert line.text_content() == before


def test_the_ring_and_the_ground_follow_a_new_scale(browser: Browser, tmp_path: Path) -> None:
    with opened(browser) as page:
        show(page, tmp_path, page_of("elliptical-trammel"))
        page.evaluate("() => void vad.pose({ link: 120 })")
        page.wait_for_timeout(800)  # the picture glides to its new scale
        x, y = middle(page, "[data-vad-grip]")
        pins = page.evaluate(
            """() => [...document.querySelectorAll('.panel:first-child .hand circle')]
              .map((each) => each.getBoundingClientRect())
              .map((box) => [box.x + box.width / 2, box.y + box.height / 2])"""
        )
        assert min(math.hypot(x - u, y - v) for u, v in pins) < 1.0
        # Ground that would lie on the table is cut off at the edge of the panel.
        assert (
            page.locator(".panel:first-child .drawing > svg").evaluate(
                "(each) => getComputedStyle(each).overflow"
            )
            == "hidden"
        )


def test_a_mechanism_with_other_dimensions_fits_its_panel_in_all_poses(
    browser: Browser, tmp_path: Path
) -> None:
    """A scale is chosen for all poses: it stands while the driver moves, and fills the panel."""
    ends = """() => [document.querySelector('.scale.hand').textContent,
      ...['.drawing', '.hand [data-m][r]'].map((each) => {
        const found = [...document.querySelectorAll(`.panel:first-child ${each}`)];
        const boxes = found.map((one) => one.getBoundingClientRect());
        return [Math.min(...boxes.map(({ top }) => top)),
          Math.max(...boxes.map(({ bottom }) => bottom))];
      })]"""
    with opened(browser, viewport={"width": 1280, "height": 720}, reduced_motion="reduce") as page:
        show(page, tmp_path, page_of("four-bar"))
        for size, most in ((0.6, 0.3), (1.5, 0.2)):
            lengths = {"ground": 100, "crank": 40, "coupler": 120, "rocker": 80}
            pose = {name: size * each for name, each in lengths.items()}
            bars, filled = set(), 0.0
            for place in range(0, 360, 20):
                page.evaluate("(pose) => void vad.pose(pose)", {**pose, "angle": place})
                bar, (top, bottom), (high, low) = page.evaluate(ends)
                bars.add(bar)
                assert top - 1 <= high and low <= bottom + 1, (size, place)
                filled = max(filled, (low - high) / (bottom - top))
            assert len(bars) == 1 and filled > most


def test_an_angle_of_many_turns_is_folded(page: Page) -> None:
    for asked, found in (
        (-370.0, 350.0),
        (1000.0, 280.0),
        (1e9, 280.0),
        (1e99, 96.0),
        (360.0, 0.0),
        (40.5, 40.5),
    ):
        page.evaluate("(angle) => void vad.pose({ angle })", asked)
        assert angle(page) % 360.0 == pytest.approx(found, abs=1e-6), asked
    box = page.locator(".place input")
    box.fill("abc")
    box.press("Enter")
    expect(page.locator(".said p")).to_have_text("θ2: must be a finite number, got abc")
    box.fill("60")
    box.press("Enter")
    press(page, "Escape")


def test_what_is_typed_is_not_rounded_away(browser: Browser, tmp_path: Path) -> None:
    with opened(browser) as page:
        show(page, tmp_path, written(vad.DoubleSlider()))
        press(page, "h")
        box = page.locator(".place input")
        box.fill("0.5")
        box.press("Enter")
        assert page.evaluate("() => vad.state.position") == 0.5
        assert box.input_value() == "0.5"
        page.evaluate("() => void vad.pose({ position: 100 / 3 })")
        expect(box).not_to_have_value(re.compile("33333"))
        expect(page.locator(".place")).to_contain_text("\u00a0mm", use_inner_text=False)
        expect(page.locator(".said p")).to_have_text("You move the driver.")


def test_a_slider_stops_where_the_links_close_nowhere(page: Page) -> None:
    press(page, "h")
    box = page.get_by_label("coupler, mm").first
    box.fill("900")
    press(page, "Enter")
    assert 200 < page.evaluate("() => vad.state.coupler") < 221
    expect(page.locator(".said p")).to_have_text(
        "coupler 900 mm: the links close nowhere with these dimensions"
    )
    box.fill("-3")
    press(page, "Enter")
    expect(page.locator(".said p")).to_contain_text("must be positive")
    box.fill("1e9")
    press(page, "Enter")
    right = "must be from 1.2 to 12000 mm, where numbers are right, got 1e9"
    expect(page.locator(".said p")).to_have_text(f"coupler: {right}")
    told = page.evaluate("() => vad.solve({ coupler: 1e9 }).error")
    assert told == f"coupler: {right.replace('1e9', '1000000000')}"
    press(page, "Escape")


def test_a_box_reads_a_number_with_its_unit(page: Page) -> None:
    press(page, "h")
    for label, typed, name, value in (
        ("coupler, mm", "11.55 cm", "coupler", 115.5),
        ("ω2, rad/s", "120 rpm", "omega", math.tau * 2),
    ):
        box = page.get_by_label(label).first
        box.fill(typed)
        press(page, "Enter")
        assert page.evaluate(f"() => vad.state.{name}") == pytest.approx(value, rel=1e-12)
        assert box.input_value() == f"{value:.6g}"
    box.fill("120 kg")
    press(page, "Enter")
    expect(page.locator(".said p")).to_contain_text("120 kg")
    press(page, "Escape")


def test_the_units_of_boxes_are_those_of_the_program() -> None:
    quantities = {"°": "angle", "rad/s": "omega", "rad/s²": "alpha", "N": "force", "N m": "couple"}
    for length in ("mm", "ft"):
        ends = {"": "length", "/s": "velocity", "/s²": "acceleration"}
        kinds = quantities | {length + end: each for end, each in ends.items()}
        for own, factors in readable(length).items():
            for unit, factor in factors.items():
                said = read(f"1 {unit.replace('²', '^2')}", kinds[own], length)
                assert factor == pytest.approx(said, rel=1e-9), unit


def test_dimensions_in_space_are_set_in_the_rail(browser: Browser, tmp_path: Path) -> None:
    """Axes stay apart: no box takes a twist at which they are parallel."""
    with opened(browser, reduced_motion="reduce") as page:
        show(page, tmp_path, written(vad.SpatialFourBar()))
        own, other = vad.SpatialFourBar(), {"crank": 50.0, "crank_twist": 40.0}
        assert set(own.parameters()) <= set(page.evaluate("() => Object.keys(vad.state)"))
        page.evaluate("sizes => void vad.pose({ angle: 100, ...sizes })", other)
        expect(page.locator("header p")).to_have_text(re.compile("crank\u00a050\u00a0mm ∠ 40°"))
        told = page.evaluate("() => vad.solve()")
        truth = vad.solve(vad.SpatialFourBar(**other), angle=100.0, omega=10.0, alpha=0.0)
        assert told["parameters"] == truth.to_dict()["parameters"]
        for kind in ("links", "slides"):
            for name, wanted in truth.to_dict()[kind].items():
                for what, value in wanted.items():
                    assert told[kind][name][what] == pytest.approx(value, rel=1e-11, abs=1e-11)
        assert "error" in page.evaluate("() => vad.solve({ coupler_twist: 181 })")
        page.locator(".set summary").click()
        box = page.locator("input[name=ground_twist]")
        box.fill("200")
        press(page, "Enter")
        expect(page.locator(".said p")).to_contain_text("must be from 0 to 180 °")
        assert page.evaluate("() => vad.state.ground_twist") == 60.0


def test_guides_on_one_line_are_refused(browser: Browser, tmp_path: Path) -> None:
    with opened(browser, reduced_motion="reduce") as page:
        show(page, tmp_path, written(vad.DoubleSlider()))
        for turn in (-90, 90, 270):
            with pytest.raises(vad.VadError):
                vad.solve(vad.DoubleSlider(guide_a=turn)).to_dict()
            assert "error" in page.evaluate("turn => vad.solve({ guide_a: turn })", turn)
        press(page, "End", "h")
        box = page.locator("[name=guide_a]")
        for typed, stands in (("90", (89.9, 90.0)), ("135", (135.0, 135.1))):
            box.fill(typed)
            box.press("Enter")
            assert stands[0] <= page.evaluate("() => vad.state.guide_a") < stands[1]


def test_a_page_without_sliders(browser: Browser, tmp_path: Path) -> None:
    vad.save(vad.animate(vad.draw(vad.solve(vad.FourBar()))), tmp_path / "a.html", no_sliders=True)
    with opened(browser) as page:
        page.goto((tmp_path / "a.html").as_uri())
        press(page, "End", "h")
        assert page.locator(".size").count() == 0
        assert page.evaluate("() => vad.pose({ crank: 30 }).crank") == 30
        expect(page.locator("header p")).to_have_text(re.compile("crank\u00a030\u00a0mm"))


def test_the_crank_glides_back_the_shorter_way(browser: Browser, tmp_path: Path) -> None:
    with opened(browser) as page:
        show(page, tmp_path, page_of("four-bar"), f"#step={STEP}")
        page.evaluate(
            """() => { window.seen = [];
              vad.addEventListener('pose', ({ angle }) => seen.push(angle)); }"""
        )
        page.evaluate("() => vad.pose({ angle: 300 })")
        press(page, "Escape")
        until(page, lambda: at(page) == STEP and not page.locator(".turned").count())
        between = [angle for angle in page.evaluate("seen")[1:] if angle != 60]
        assert all(angle > 299 or angle < 61 for angle in between)
        # A hand that comes back meanwhile is not lost.
        page.evaluate("() => vad.pose({ angle: 300 })")
        for by_key in (True, False):
            page.evaluate(
                """byKey => {
                  const press = (key) => document.body.dispatchEvent(
                    new KeyboardEvent("keydown", { key, bubbles: true }));
                  press("Escape");
                  if (byKey) press("h");
                  else document.querySelector("[data-do=hand]").click();
                }""",
                by_key,
            )
            page.wait_for_timeout(600)
            assert page.locator(".turned").count() == 1 and angle(page) == pytest.approx(300)


def test_a_page_shows_and_answers_for_the_other_assembly(page: Page) -> None:
    wanted = vad.solve(vad.FourBar(assembly="crossed"), angle=40.0).to_dict()
    found = page.evaluate("() => vad.solve({ assembly: 'crossed', angle: 40, alpha: 0 })")
    assert found["assembly"] == "crossed" and found["parameters"] == wanted["parameters"]
    for name, point in wanted["points"].items():
        for what, vector in point.items():
            assert found["points"][name][what] == pytest.approx(vector, rel=1e-12, abs=1e-9)
    assert page.evaluate("() => vad.pose({ assembly: 'crossed' }).assembly") == "crossed"
    expect(page.locator(".assembly :checked")).to_have_value("crossed")
    page.locator(".assembly [value=open]").check()
    assert page.evaluate("() => vad.state.assembly") == "open"
    press(page, "Control+z")  # the choice has the focus
    assert page.evaluate("() => vad.state.assembly") == "crossed"


def test_a_pin_upon_a_pivot_is_a_dead_centre(browser: Browser, tmp_path: Path) -> None:
    mechanism = vad.Whitworth(ground=40, crank=40)
    with pytest.raises(vad.DeadCentreError):
        vad.solve(mechanism, angle=270.0).to_dict()
    with opened(browser, reduced_motion="reduce") as page:
        show(page, tmp_path, written(mechanism, angle=30.0))
        for method in ("solve", "pose"):
            told = page.evaluate(f"() => vad.{method}({{ angle: 270 }})")
            assert told == {"error": "Dead centre at 270°: here velocities have no value."}
        page.evaluate("() => void vad.pose({ angle: 269 })")
        press(page, "ArrowRight")
        expect(page.locator(".said p")).to_contain_text("Dead centre at 270.0°")


def test_a_row_hides_its_vectors_and_a_key_enlarges_a_panel(page: Page) -> None:
    faint = """() => [...document.querySelectorAll('.hand :is(path, polyline, polygon)')].filter(
      (each) => getComputedStyle(each).opacity === '0.1').length"""
    press(page, "End", "h")
    page.locator(".hides").nth(1).click()
    assert page.evaluate(faint) > 2
    page.locator(".hides").nth(1).click()
    assert page.evaluate(faint) == 0
    page.evaluate("document.activeElement.blur()")
    size = "() => document.querySelectorAll('.drawing > svg')[2].getScreenCTM().a"
    whole = page.evaluate(size)
    press(page, "z")
    assert page.evaluate(size) > 1.3 * whole
    assert page.evaluate("() => document.documentElement.scrollHeight <= innerHeight")
    expect(page.locator(".panel:visible")).to_have_count(1)
    press(page, "z")
    expect(page.locator(".panel:visible")).to_have_count(3)


def test_an_enlarged_panel_keeps_its_scale_bar_right(page: Page) -> None:
    """Wherever it is, it is larger than before; on a phone the table stands beneath it."""
    found = """() => {
      const { a } = document.querySelectorAll('.drawing > svg')[2].getScreenCTM();
      const [bar] = [...document.querySelectorAll('.panel:nth-child(3) .bar')]
        .filter((each) => each.getBoundingClientRect().width);
      return [a, bar.getBoundingClientRect().width / bar.style.getPropertyValue('--n'),
        document.querySelector('.results').getBoundingClientRect().height];
    }"""
    for width, height in ((1280, 720), (640, 700), (640, 360), (844, 390), (390, 844)):
        page.set_viewport_size({"width": width, "height": height})
        press(page, "End")
        for key in ("h", "Escape"):
            painted(page)
            usual, *_ = page.evaluate(found)
            press(page, "z")
            painted(page)
            large, bar, table = page.evaluate(found)
            assert large > 1.1 * usual, (width, height)
            assert bar == pytest.approx(large, rel=0.002), (width, height)
            assert (table > 0) == (width < 480)
            assert page.evaluate("() => document.documentElement.scrollHeight <= innerHeight")
            press(page, "z", key)


def test_forced_colours_show_the_mode_and_the_handle(page: Page) -> None:
    page.emulate_media(forced_colors="active")
    press(page, "h")
    pressed, other = (page.locator(f"[data-do={name}]") for name in ("hand", "lesson"))
    ground = "e => getComputedStyle(e).backgroundColor"
    assert pressed.evaluate(ground) != other.evaluate(ground)
    expect(page.locator("[data-vad-grip]")).to_be_visible()
    for track in (".turner", ".size [type=range] >> nth=0"):
        expect(page.locator(track)).to_have_css("appearance", "auto")
    row = page.locator(".hides").first  # all rows are shown, which is nothing special
    assert row.evaluate(ground) == other.evaluate(ground)
    chip = page.get_by_role("button", name="Letters")
    assert chip.evaluate(ground) == pressed.evaluate(ground)
    page.emulate_media(forced_colors="null")
