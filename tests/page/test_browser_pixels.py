"""What the browser shows is what the painter paints, at every instant: pixel by pixel."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Browser

import vad
from tests.browser import opened
from tests.page.lessons import PARTS, lesson_of, page_of, pixels, scrub, show
from vad.lecture.moment import Moment, done, drawing, finished, smooth
from vad.page.parts import page_plan
from vad.painting.film import redraw
from vad.style import load_style

WIDTH, HEIGHT = 1280, 720
#: So many pixels of a panel may be off by a quarter: a browser sets letters on whole pixels.
OFF = 0.01
#: And nowhere may a square of so many pixels differ, be it faintly (of 255 steps).
SQUARE, FAINT = 5, 12
#: All lessons at every stroke take minutes: VAD_FULL=1.
FULL = bool(os.environ.get("VAD_FULL"))
SAMPLE = {
    "crank-slotted-lever": 13,
    "gate-actuator": 17,
    "four-bar": 19,
    "spherical-four-bar": 36,  # with the plane that is laid over
}
LESSONS = (
    [(name, "paper", 1) for name in vad.MECHANISMS]
    + [("four-bar", "print", 1), ("whitworth", "chalk", 1)]
    if FULL
    else [(name, "paper", every) for name, every in SAMPLE.items()] + [("whitworth", "print", 23)]
)
#: Puts the drawings where the painter has them, and all else away; letters are darker on a page.
#: None moves, and nothing flies.
BARE = """() => {
  const home = document.querySelector('.vad');
  const pictures = document.querySelectorAll('.drawing > svg');
  const frame = document.createElement('div');
  frame.className = 'drawing';
  home.append(frame);
  frame.innerHTML = '<svg viewBox="0 0 1280 720"></svg>';
  frame.firstChild.style = 'position:fixed;left:0;top:0;width:1280px;height:720px';
  for (const svg of pictures) {
    const { x, y, width, height } = svg.viewBox.baseVal, place = { x, y, width, height };
    for (const name in place) svg.setAttribute(name, place[name]);
    svg.style = 'overflow:visible';
    frame.firstChild.append(svg);
  }
  Element.prototype.animate = () => {};
  document.querySelector('.travels').checked = false;
  const others = document.querySelectorAll('.board > *, .steps, .grip');
  for (const each of others) each.style.visibility = 'hidden';
  for (let row = 0; row < 9; row++) home.style.setProperty(`--letter${row}`, `var(--ink${row})`);
}"""


def solid(differs: NDArray[np.bool_]) -> bool:
    """Tell whether somewhere a whole square differs, not just edges that are smoothed otherwise."""
    for _ in range(SQUARE - 1):
        differs = differs[1:, 1:] & differs[1:, :-1] & differs[:-1, 1:] & differs[:-1, :-1]
    return bool(differs.any())


def moment(x: float, strokes: int) -> Moment:
    number = int(x)
    if number == strokes:
        return Moment(finished(strokes))
    return Moment(drawing(number), smooth(x - number)) if x > number else Moment(done(number))


@pytest.mark.exhaustive(256)
@pytest.mark.parametrize(("name", "style", "every"), LESSONS)
def test_the_page_shows_what_the_painter_paints(
    name: str, style: str, every: int, browser: Browser, tmp_path: Path
) -> None:
    whole = name in PARTS
    lesson = lesson_of(name, "en", style, whole)
    plan, look, strokes = page_plan(lesson), load_style(style), len(lesson.steps)
    instants = [k + part for k in range(0, strokes, every) for part in (0.35, 0.8)]
    shares: dict[tuple[str, float], float] = {}
    blots: list[tuple[str, float]] = []
    with opened(browser, viewport={"width": WIDTH, "height": HEIGHT}) as page:
        show(page, tmp_path, page_of(name, "en", style, whole))
        page.keyboard.press("z")  # one panel alone: none is larger than on the sheet
        page.evaluate(BARE)
        for x in [*instants, *range(1, strokes + 1, 4 * every), strokes]:
            scrub(page, x)
            found = pixels(page).astype(int)
            expected = redraw(plan, moment(x, strokes), look)[..., :3].astype(int)
            for panel in plan.sheet.panels:
                area = plan.regions[panel.name]
                rows = slice(round(HEIGHT * (1 - area.top)), round(HEIGHT * (1 - area.bottom)))
                columns = slice(round(HEIGHT * area.left), round(HEIGHT * area.right))
                off = np.abs(found - expected)[rows, columns].max(axis=2)
                shares[panel.name, x] = float((off > 255 / 4).mean())
                if solid(off > FAINT):
                    blots.append((panel.name, x))
    print(len(shares), max(shares.values()), np.mean(list(shares.values())))
    assert max(shares.values()) <= OFF, {key: s for key, s in shares.items() if s > OFF}
    assert not blots
