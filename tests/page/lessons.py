"""Lessons for the tests of the page, written once and opened in the browser."""

from __future__ import annotations

import json
import lzma
import re
import string
from functools import cache, lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import vad
from vad.lecture.lesson import Lesson
from vad.mechanisms.mechanism import Mechanism
from vad.page.document import _LZMA, document
from vad.words import Language

if TYPE_CHECKING:
    from playwright.sync_api import Page

#: With all that can be: a rod and a ram besides the mechanism.
PARTS = {"crank-slotted-lever": {"rod": 120, "ram_height": 140}, "whitworth": {"rod": 120}}
LESSONS = [(name, {}) for name in vad.MECHANISMS] + list(PARTS.items())


#: The signs of what is packed.
SIGNS = "".join(sign for sign in string.printable if sign not in "\"&'<" and not sign.isspace())
SIGNS = "".join(sorted(SIGNS + " "))


@cache
def lesson_of(name: str, code: str = "en", style: str = "paper", whole: bool = False) -> Lesson:
    """Return the lesson of a mechanism; ``whole`` is with its rod and ram."""
    mechanism = vad.MECHANISMS[name](**(PARTS.get(name, {}) if whole else {}))
    rates = {"alpha": 3.0} if "alpha" in mechanism.inputs else {}
    return vad.animate(vad.draw(vad.solve(mechanism, **rates), language=code), style=style)


@cache
def page_of(name: str, code: str = "en", style: str = "paper", whole: bool = False) -> str:
    """Return its page."""
    return document(lesson_of(name, code, style, whole))


@lru_cache(maxsize=16)
def written(mechanism: Mechanism, code: str = "en", **inputs: float) -> str:
    """Return the page of a mechanism of any dimensions in any pose."""
    return document(vad.animate(vad.draw(vad.solve(mechanism, **inputs), language=code)))


def bundle_of(html: str) -> tuple[str, dict[str, Any], list[str], str, list[str]]:
    """Return what a page has packed: script, data, what a hand moves in each panel, rules, parts.

    The parts are those that are seen only where scripts run.
    """
    text = re.search(r'<script type="text/plain" id="data">(.*?)</script>', html).group(1)
    values = [SIGNS.index(sign) for sign in text]
    pairs = zip(values[::2], values[1::2], strict=True)
    bits = "".join(f"{91 * high + low:013b}"[::-1] for high, low in pairs)
    data = bytes(int(bits[at : at + 8][::-1], 2) for at in range(0, len(bits), 8))
    script, rules, layers, late, told = json.loads(
        lzma.LZMADecompressor(lzma.FORMAT_RAW, filters=[_LZMA]).decompress(data)
    )
    return script, told, layers, rules, late


#: The lesson that is played, how many strokes it has, and the first of each panel.
LESSON = lesson_of("slider-crank")
STROKES = len(LESSON.steps)
FIRST = [0, 8, 15]
WORDS = Language("en").page("PLAYER")


def show(page: Page, folder: Path, html: str, hash_: str = "") -> None:
    """Open a page from a file."""
    file = folder / "lesson.html"
    file.write_text(html, "utf-8")
    page.goto(file.as_uri() + hash_)


def press(page: Page, *keys: str) -> None:
    """Press one key after another."""
    for key in keys:
        page.keyboard.press(key)


def scrub(page: Page, x: float) -> None:
    """Move the scrubber, as a pointer that holds it does."""
    page.evaluate(
        "x => { const s = document.querySelector('.scrub'); s.value = x;"
        " s.dispatchEvent(new Event('input')); }",
        x,
    )


def at(page: Page) -> float:
    """Return how many strokes are drawn."""
    return float(page.locator(".scrub").input_value())


def pixels(page: Page) -> NDArray[np.uint8]:
    """Return what the window shows."""
    import io

    from PIL import Image

    return np.asarray(Image.open(io.BytesIO(page.screenshot())).convert("RGB"))
