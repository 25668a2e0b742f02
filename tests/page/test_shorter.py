"""Scripts and style sheets as short as they can be sent."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Error, Page

from tests.browser import opened
from vad.page.document import _HAND, asset, packed
from vad.page.shorter import shorter_script, shorter_style

SCRIPT = """
// Long names, /* no comment */ "no text".
const counted = { first: 1, second: [2, /* two */ 3] }, high = 4 - -3;
function summed(values, start) {
  let total = start; // a word
  for (const value of values) total += value;
  return total + + high;
}
const said = (word, count) => `${word} // ${count > 1 ? `${count} times` : "once"} 'x'`;
const found = "a/b//c".split(/\\/+/).length / 1;
answer = [summed(counted.second, counted.first), said("it's", 2), said("", 1), found, high];
"""


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    """Return the page of all tests of this module."""
    with opened(browser) as empty:
        yield empty


def test_a_shorter_script_does_the_same(page: Page) -> None:
    short = shorter_script(SCRIPT, ["answer"])
    assert len(short) < 0.75 * len(SCRIPT)
    assert "counted" not in short and "summed" not in short and "two" not in short
    run = "text => { eval(text.replace('answer', 'window.answer')); return window.answer; }"
    assert page.evaluate(run, short) == page.evaluate(run, SCRIPT)


def test_names_of_properties_stay() -> None:
    short = shorter_script(
        "const wide = 1, tall = 2, data = { wide, high: tall }; data.high += tall;"
    )
    assert short == "const wide=1,a=2,b={wide,high:a};b.high+=a;"


def test_every_word_stays_in_a_style_sheet() -> None:
    whole, short = (
        re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL) for text in (PLAYER, shorter_style(PLAYER))
    )
    assert re.findall(r"[\w.#-]+", short) == re.findall(r"[\w.#-]+", whole)
    assert " and (" in short and "calc(100cqi / " in short and "~ [data-do" not in short


PLAYER = """
/* All of it. */
.vad :is(h1, h2) > p { margin: 0 auto; width: calc(100cqi / 1280 - 2px); }
@media screen and (min-width: 64rem) and (max-height: 30rem) { .a:not(.b) .c { color: red; } }
"""


def test_a_regular_expression_after_a_space_keeps_its_words() -> None:
    short = shorter_script("const step = 3; const found = /^#step=/.test(place + step);", ["place"])
    assert "/^#step=/" in short and short.count("step") == 1


@pytest.mark.parametrize(
    ("script", "unknown"),
    [
        ("const a = fech(3);", "fech"),
        ("const f = (x, { y: z, w = 3 }) => x + z + w; f(high);", "high"),
        ("for (const each of [1, 2]) text(`${each} ${more}`);", "more, text"),
        ("try { go(); } catch (fault) { fault.name; } function go() { went = 1; }", "went"),
    ],
)
def test_a_name_that_nothing_declares_is_refused(script: str, unknown: str) -> None:
    with pytest.raises(ValueError, match=f"known of browsers: {unknown}$"):
        shorter_script(script)


def test_names_in_patterns_methods_and_handlers_are_declared() -> None:
    shorter_script("let [u, v] = [1, 2]; for (const k of u) v(k);")
    shorter_script("const all = { met(a) { return a; }, get here() { return /^a$/.test(all); } };")
    shorter_script("const [[one], { two, three: four = 4 }] = [], five = one + two + four;")


UNPACK = f"(packed) => {{ {asset('unpack.js')}; return unpack(packed); }}"
#: What stands far apart again, in other company, and at distances that were there before.
FAR = "".join(f"{number**3 % 9973:x}" for number in range(60_000))
AGAIN = "".join(FAR[at % 50_000 :][: 3 + at % 40] + str(at % 7) for at in range(0, 400_000, 997))


@pytest.mark.parametrize(
    "text",
    ["", "a", "ä²′" * 1000, "".join(map(str, range(5000))), FAR + AGAIN],
    ids=["nothing", "a sign", "copies", "numbers", "far copies"],
)
def test_what_is_packed_is_unpacked(page: Page, text: str) -> None:
    assert page.evaluate(UNPACK, packed(text)) == text


def test_all_scripts_are_unpacked(page: Page) -> None:
    text = json.dumps({name: asset(name) for name in _HAND})
    assert page.evaluate(UNPACK, packed(text)) == text


def test_what_is_cut_off_is_damaged(page: Page) -> None:
    whole = packed("".join(map(str, range(5000))))
    with pytest.raises(Error, match="the page is damaged"):
        page.evaluate(UNPACK, whole[: len(whole) // 4 * 2])
