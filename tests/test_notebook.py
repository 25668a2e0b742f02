"""What a notebook shows of a thing, and a browser where there is no notebook."""

from __future__ import annotations

import base64
import io
import os
import sys
import time
import webbrowser
from dataclasses import replace
from html import escape
from pathlib import Path
from types import ModuleType, SimpleNamespace
from urllib.parse import quote
from xml.etree import ElementTree

import pytest
from PIL import Image

import vad
from tests.browser import until
from vad import showing
from vad.errors import ExportError, UsageError
from vad.strokes.description import describe, title

SHEET = vad.draw(vad.solve(vad.SliderCrank()))
OTHER = vad.draw(vad.solve(vad.SliderCrank(rod=150), angle=100))
LESSON = vad.animate(SHEET, style="chalk", size=(800, 600))
TURN = vad.turn(vad.ScotchYoke(), fps=1, size=(1920, 1080))
THINGS = {
    "sheet": SHEET,
    "lesson": LESSON,
    "still": vad.still(LESSON, "velocity:4"),
    "multiples": vad.multiples(vad.FourBar(), at=(30, 60)),
}


def page_of(*forms: str) -> str:
    """Return outputs as an exported notebook has them, all in one page."""
    outputs = "".join(f'<div class="output_subarea">{form}</div>' for form in forms)
    style = "svg{max-width:100%;height:auto} text{font-family:monospace}"
    return (
        f"<!doctype html><meta charset=utf-8><title>Notebook</title><style>{style}</style>{outputs}"
    )


def shell(monkeypatch: pytest.MonkeyPatch, **traits: object) -> list[object]:
    """Let an interactive shell run the tests, and return what is displayed in it."""
    displayed: list[object] = []
    python, display = ModuleType("IPython"), ModuleType("IPython.display")
    python.get_ipython = lambda: SimpleNamespace(**traits)
    display.display = displayed.append
    monkeypatch.setitem(sys.modules, "IPython", python)
    monkeypatch.setitem(sys.modules, "IPython.display", display)
    return displayed


@pytest.mark.parametrize("name", THINGS)
def test_a_thing_shows_itself_in_pixels_and_words(name):
    thing = THINGS[name]
    forms = thing._repr_mimebundle_(include={"image/png", "text/plain"})
    picture = Image.open(io.BytesIO(base64.b64decode(forms["image/png"])))
    assert picture.size == ((800, 600) if name in ("lesson", "still") else (1280, 720))
    assert forms["text/plain"].startswith(("Slider–crank: crank 60 mm", "Four-bar: ground 100 mm"))


def test_the_words_are_those_of_the_sheet():
    assert SHEET._repr_mimebundle_(include={"text/plain"}) == {
        "text/plain": f"{title(SHEET)}\n{describe(SHEET)}"
    }


def test_a_form_that_nobody_wants_is_left_out():
    assert set(SHEET._repr_mimebundle_(exclude={"image/png"})) == {"text/plain", "image/svg+xml"}


def test_the_same_drawing_has_the_same_bytes_and_another_has_other_names():
    one, same, other = (
        thing._repr_mimebundle_(include={"image/svg+xml"})["image/svg+xml"]
        for thing in (SHEET, replace(SHEET), OTHER)
    )
    assert one == same
    names = [
        {each.get("id") for each in ElementTree.fromstring(svg).iter() if each.get("id")}
        for svg in (one, other)
    ]
    assert len(names[0]) > 50 and not names[0] & names[1]


def test_outputs_in_one_page_do_not_disturb_each_other(page):
    """Each looks as it does alone: one after the other is seen, while all others are there."""
    things = (SHEET, OTHER, THINGS["still"])
    forms = [each._repr_mimebundle_()["image/svg+xml"] for each in things]
    alone = []
    for form in forms:
        page.set_content(page_of(form))
        alone.append(page.locator("svg").screenshot())
    assert len(set(alone)) == len(forms)
    page.set_content(page_of(*forms))
    for place, expected in enumerate(alone):
        page.evaluate(
            "one => document.querySelectorAll('div').forEach((each, i) => each.hidden = i != one)",
            place,
        )
        assert page.locator("svg").nth(place).screenshot() == expected


def test_a_drawing_is_as_wide_as_its_cell_at_most(page):
    """Also as an image of its own, which is what JupyterLab makes of it, and says no size."""
    form = SHEET._repr_mimebundle_(include={"image/svg+xml"})["image/svg+xml"]
    image = f'<img alt="" src="data:image/svg+xml,{quote(form)}">'
    widths = {640: form, 1500: form, 600: image}
    page.set_content(
        "".join(f'<div style="width:{w}px">{each}</div>' for w, each in widths.items())
    )
    until(page, lambda: page.evaluate("document.querySelector('img').complete"))
    sizes = [each.bounding_box() for each in page.locator("svg, img").all()]
    assert [box["width"] for box in sizes] == [640, 1280, 600]
    assert [box["height"] for box in sizes] == pytest.approx([360, 720, 337.5], abs=0.01)


def test_a_lesson_plays_in_a_frame_that_knows_nothing_of_the_notebook(page):
    html = LESSON._repr_mimebundle_(include={"text/html"})["text/html"]
    page.set_content(page_of(html, html))
    assert page.locator("iframe").first.get_attribute("title") == title(SHEET)
    lesson, other = (page.frame_locator("iframe").nth(place) for place in (0, 1))
    lesson.get_by_label("To the start").click()
    lesson.locator("body").press("PageDown")
    lesson.locator("body").press("Shift+PageDown")
    count = f"1 / {len(SHEET.panels[0].strokes)}"
    until(page, lambda: lesson.locator(".count").text_content() == count)
    assert other.locator(".count").text_content() == ""
    around = "() => { try { return parent.document.title } catch (error) { return error.name } }"
    assert lesson.locator("body").evaluate(around) == "SecurityError"
    fits = "body => body.ownerDocument.documentElement.scrollHeight <= innerHeight"
    assert lesson.locator("body").evaluate(fits)


def test_a_turn_runs_in_a_frame_of_its_own(page):
    html = TURN._repr_mimebundle_(include={"text/html"})["text/html"]
    page.set_content(page_of(html))
    frame = page.locator("iframe")
    assert frame.get_attribute("title") == title(TURN.sheet)
    assert frame.get_attribute("sandbox") == "allow-scripts"
    inner = frame.element_handle().content_frame()
    inner.wait_for_function("() => window.vad && vad.state.angle > 62")
    assert inner.locator(".plots").is_visible()


def test_a_hostile_title_is_text(page):
    sheet = replace(SHEET, title='"><script>console.error(1)</script>')
    forms = sheet._repr_mimebundle_(exclude={"image/png"})
    page.set_content(page_of(forms["image/svg+xml"], f"<pre>{escape(forms['text/plain'])}</pre>"))
    assert page.locator("svg > title").text_content().startswith(sheet.title)


def test_a_shell_in_a_terminal_gets_words_alone(monkeypatch):
    shell(monkeypatch)
    assert set(TURN._repr_mimebundle_()) == {"text/plain"}


def test_show_in_a_notebook_displays(monkeypatch):
    displayed = shell(monkeypatch, kernel=object())
    vad.show(SHEET)
    assert displayed == [SHEET]
    assert set(SHEET._repr_mimebundle_()) == {"text/plain", "image/png", "image/svg+xml"}


@pytest.mark.parametrize("name", ["still", "multiples"])
def test_show_elsewhere_opens_a_file_in_the_browser(monkeypatch, tmp_path, page, name):
    opened: list[str] = []
    monkeypatch.setattr(webbrowser, "open", lambda uri: not opened.append(uri))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    vad.show(THINGS[name])
    (uri,) = opened
    page.goto(uri)
    words = "Four-bar" if name == "multiples" else "Slider–crank"
    assert page.locator("title").first.text_content().startswith(words)


def test_show_without_a_browser_says_where_the_file_is(monkeypatch, tmp_path):
    monkeypatch.setattr(webbrowser, "open", lambda _: False)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with pytest.raises(ExportError, match="no browser can be started") as error:
        vad.show(SHEET)
    assert Path(error.value.hint.partition(": ")[2]).stat().st_size > 10_000


def test_what_was_shown_is_removed_a_day_later(monkeypatch, tmp_path):
    monkeypatch.setattr(webbrowser, "open", lambda _: True)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    vad.show(SHEET)
    (first,) = tmp_path.iterdir()
    vad.show(SHEET)
    assert first.exists()
    os.utime(first, (time.time() - 90_000,) * 2)
    vad.show(SHEET)
    assert not first.exists()
    assert len(list(tmp_path.iterdir())) == 2


def test_what_cannot_be_saved_leaves_nothing(monkeypatch, tmp_path):
    def full(*_):
        raise OSError

    monkeypatch.setattr(showing, "save", full)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with pytest.raises(OSError):
        vad.show(SHEET)
    assert not list(tmp_path.iterdir())


def test_what_cannot_be_shown():
    with pytest.raises(UsageError, match="thing: cannot be shown, got ") as error:
        vad.show(vad.solve(vad.FourBar()))
    assert error.value.hint == "draw or animate it first"


def test_an_error_is_one_line_and_a_hint(capsys):
    shell = pytest.importorskip("IPython.core.interactiveshell").InteractiveShell.instance()
    shell.run_cell("import vad; vad.solve(vad.FourBar(crank=130), angle=10).link('rocker').angle")
    said = capsys.readouterr().out.strip().splitlines()
    assert len(said) == 2
    assert said[0].startswith("AssemblyError: angle 10°: the links miss by 4.014 mm")
    assert said[1] == "hint: try angle 15.46"
