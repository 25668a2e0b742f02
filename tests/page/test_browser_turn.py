"""The page of a turn: the mechanism runs, its curves are seen, and a hand takes it."""

from __future__ import annotations

from pathlib import Path

from playwright.sync_api import Browser

import vad
from tests.browser import opened

SIZE = {"width": 1280, "height": 820}
#: Left and right of a drawing, and of its hodographs.
EXTENTS = """(number) => {
  const drawing = document.querySelectorAll(".drawing")[number];
  return [drawing, ...drawing.querySelectorAll(".hodograph")].map((each) => {
    const box = each.getBoundingClientRect();
    return [box.left, box.right];
  });
}"""


def saved(tmp_path: Path, mechanism: object = None, **inputs: float) -> str:
    path = tmp_path / "turn.html"
    vad.save(vad.turn(vad.solve(mechanism or vad.FourBar(), **inputs)), path)
    return path.as_uri()


def test_it_runs_until_it_is_stopped(browser: Browser, tmp_path: Path) -> None:
    with opened(browser, viewport=SIZE) as page:
        page.goto(saved(tmp_path, omega=10.0))
        page.wait_for_function("() => vad.state.angle > 75")
        assert page.locator(".plots").is_visible()
        page.keyboard.press("k")
        angle = page.evaluate("() => vad.state.angle")
        page.wait_for_timeout(200)
        assert page.evaluate("() => vad.state.angle") == angle


def test_it_turns_as_it_was_given(browser: Browser, tmp_path: Path) -> None:
    """Clockwise, from the pose that was given."""
    with opened(browser, viewport=SIZE) as page:
        page.goto(saved(tmp_path, angle=200.0, omega=-5.0))
        page.wait_for_function("() => vad.state.angle < 190")
        assert page.evaluate("() => vad.state.omega") == -5.0


def test_who_wants_no_motion_gets_none(browser: Browser, tmp_path: Path) -> None:
    with opened(browser, viewport=SIZE, reduced_motion="reduce") as page:
        page.goto(saved(tmp_path, angle=200.0))
        page.wait_for_timeout(300)
        assert page.evaluate("() => vad.state.angle") == 200.0
        assert page.locator(".plots").is_visible()


def test_what_cannot_go_round_swings_and_its_scale_gives_way(
    browser: Browser, tmp_path: Path
) -> None:
    """It turns back at its limits, near which the acceleration grows without end, and is whole."""
    with opened(browser, viewport=SIZE) as page:
        page.clock.install()  # a busy machine would show too few frames
        page.goto(saved(tmp_path, vad.DoubleSlider()))
        page.select_option(".speed", "4")
        page.evaluate(
            """(strokes) => {
              [window.ways, window.bars, window.outside] = [new Set(), [], 0];
              const drawing = document.querySelectorAll(".drawing")[2];
              const scale = drawing.closest(".panel").querySelector(".scale.hand");
              let before = vad.state.position;
              vad.addEventListener("pose", () => {
                ways.add(Math.sign(vad.state.position - before));
                before = vad.state.position;
                if (bars.at(-1) !== scale.textContent) bars.push(scale.textContent);
                const room = drawing.getBoundingClientRect();
                for (const path of drawing.querySelectorAll(strokes)) {
                  const box = path.getBoundingClientRect();
                  outside += box.width > 0 && (box.top < room.top || box.bottom > room.bottom);
                }
              });
            }""",
            ".hand:not(.ways) path",
        )
        page.clock.run_for(2_000)
        assert page.evaluate("() => ways.has(1) && ways.has(-1)")
        assert page.evaluate("() => bars.lastIndexOf(bars[1]) > 2")
        assert page.evaluate("() => outside") == 0


def test_no_polygon_is_ever_cut(browser: Browser, tmp_path: Path) -> None:
    """During the quick return the ram is three times as fast as in the pose that was given."""
    lever = vad.CrankSlottedLever(rod=100, ram_height=180)
    with opened(browser, viewport=SIZE) as page:
        page.goto(saved(tmp_path, lever))
        page.wait_for_function("() => vad.state.angle > 255 && vad.state.angle < 290")
        for number in (1, 2):
            room, *ways = page.evaluate(EXTENTS, number)
            left, right = min(way[0] for way in ways), max(way[1] for way in ways)
            assert room[0] < left
            assert right < room[1]
            assert right - left > 0.4 * (room[1] - room[0])
