"""The page of a lesson as text: small, the same twice, asking for nothing, and spelt out."""

from __future__ import annotations

import io
import re
from base64 import b64decode, b64encode
from hashlib import sha256
from html import unescape
from importlib import import_module
from itertools import product
from pathlib import Path

import pytest
from fontTools.ttLib import TTFont

import vad
from tests.page.lessons import PARTS, bundle_of, lesson_of, page_of
from vad.cli.run import run
from vad.errors import UsageError
from vad.files.examples import example_names, example_path
from vad.page.document import document, section
from vad.page.parts import parts
from vad.page.spoken import spoken
from vad.page.themed import CONTRAST, contrast, readable
from vad.strokes.sentences import pieces_of
from vad.style import load_style, style_names
from vad.words import languages

pytestmark = pytest.mark.exhaustive

#: In English; German, which has the longest captions, takes a little more.
LARGEST = 140_000
LARGEST_EXAMPLE = 190_000
EVERY = [(name, False) for name in vad.MECHANISMS] + [(name, True) for name in PARTS]


@pytest.mark.parametrize(("name", "whole"), EVERY)
def test_a_page_is_small(name: str, whole: bool) -> None:
    assert len(page_of(name, whole=whole).encode()) <= LARGEST


@pytest.mark.exhaustive(128)
@pytest.mark.parametrize("name", example_names())
def test_the_page_of_an_example_is_small(name: str) -> None:
    lesson = vad.animate(vad.draw(vad.solve(vad.load(example_path(name))())))
    assert len(document(lesson).encode()) <= LARGEST_EXAMPLE


def test_the_same_lesson_gives_the_same_bytes() -> None:
    lesson = lesson_of("four-bar")
    assert document(lesson) == page_of("four-bar")


def test_it_asks_for_nothing_and_runs_its_own_scripts() -> None:
    html = page_of("four-bar")
    assert not re.search(r"""(?:src|href)=["'](?!#)|url\((?!data:)|@import""", html)
    policy = re.search(r'Security-Policy" content="(.*?)">', html).group(1)
    assert policy.startswith("default-src 'none';")
    (first,) = re.findall(r"<script>(.*?)</script>", html, re.DOTALL)
    scripts = [first, bundle_of(html)[0]]
    proofs = [b64encode(sha256(script.encode()).digest()).decode() for script in scripts]
    allowed = " ".join(f"'sha256-{proof}'" for proof in proofs)
    assert f"script-src {allowed};" in policy and "unsafe-eval" not in policy


TABLES = ("PLAYER", "HAND", "SPOKEN", "WINDOW")


@pytest.mark.parametrize("code", languages())
def test_a_language_has_all_the_words(code: str) -> None:
    english, other = (
        {table: getattr(import_module(f"vad.words.{each}"), table) for table in TABLES}
        for each in ("en", code)
    )
    for table, words in english.items():
        assert set(other[table]) <= set(words)
        lacking = set(words) - set(other[table])
        assert all(len(words[key]) == 1 for key in lacking), lacking  # ω is ω
    gaps = re.compile(r"{\w*}")
    for table, key in ((t, k) for t, keys in english.items() for k in keys):
        own = other[table].get(key, english[table][key])
        assert set(gaps.findall(own)) == set(gaps.findall(english[table][key])), key


@pytest.mark.parametrize(("case", "code"), list(product(EVERY, languages())))
def test_what_is_read_out_has_no_signs(case: tuple[str, bool], code: str) -> None:
    """Screen readers drop them."""
    sheet = lesson_of(case[0], code, whole=case[1]).sheet
    for panel in sheet.panels:
        for stroke in panel.strokes:
            said = spoken(pieces_of(stroke.said), code)
            assert not re.search(r"[^\w\s.,;:’'()\-]|[₀-₉ₐ-ₜ²³Α-ω]|\s\s|\s[.,;]", said), said
            assert re.findall(r"\d+[.,]\d+", said) == re.findall(
                r"\d+[.,]\d+", stroke.caption.replace("\u202f", "\u202f")
            )


def test_letters_are_spelt_and_signs_have_names() -> None:
    sheet = lesson_of("slider-crank").sheet
    panel = sheet.panel("acceleration")
    said = [spoken(pieces_of(stroke.said), "en") for stroke in panel.strokes]
    assert said[1].startswith(
        "a prime b prime n equals omega 2 squared times A B equals 10 squared"
    )
    assert said[1].endswith("6000 mm per second squared, from B towards A.")
    assert any("perpendicular to B C through c n" in each for each in said)


@pytest.mark.parametrize("name", style_names())
def test_inks_can_be_read_as_letters(name: str) -> None:
    style = load_style(name)
    for ink in style.inks:
        letters = readable(ink, style)
        assert contrast(letters, style.background) >= CONTRAST
        assert letters == ink or contrast(ink, style.background) < CONTRAST


def test_a_sheet_opens_finished_and_a_lesson_at_its_first_stroke(tmp_path: Path) -> None:
    lesson = lesson_of("four-bar")
    assert bundle_of(page_of("four-bar"))[1]["start"] == 0
    vad.save(lesson.sheet, tmp_path / "a.html")
    opened = bundle_of((tmp_path / "a.html").read_text("utf-8"))
    assert opened[1]["start"] == len(lesson.steps)


def test_the_command_line_writes_pages(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for verb in ("draw", "animate"):
        file = tmp_path / f"{verb}.html"
        line = [verb, "scotch-yoke", "--style", "chalk", "--language", "fr", "-o", str(file)]
        assert run(line) == 0
        html = file.read_text("utf-8")
        assert '<html lang="fr">' in html and 'data-theme="chalk"' in html
    assert run(["draw", "four-bar", "--blank", "velocity", "-o", str(tmp_path / "b.html")]) == 2
    assert "blank: .html has no such option" in capsys.readouterr().err
    assert not (tmp_path / "b.html").exists()


def test_progress_is_told_of_the_end(tmp_path: Path) -> None:
    calls: list[tuple[int, int]] = []
    lesson = lesson_of("four-bar")
    vad.save(lesson, tmp_path / "a.html", progress=lambda done, total: calls.append((done, total)))
    assert calls == [(lesson.frames, lesson.frames)]
    with pytest.raises(UsageError, match=r"size: \.html has no such option"):
        vad.save(lesson.sheet, tmp_path / "b.html", size=(640, 480))


def test_the_letters_of_new_results_are_there_in_bold_and_of_given_ones_plain():
    """A result is bold while it is new: a page must have those letters in both faces."""
    html = page_of("slider-crank")
    faces = {
        re.findall(r"font-(?:style|weight):\w+", rule)[0]: TTFont(io.BytesIO(b64decode(data)))
        for rule, data in re.findall(
            r"@font-face{(.*?)url\(data:font/woff;base64,([^)]*)\)", html, re.DOTALL
        )
    }
    bold = set(faces["font-weight:bold"].getBestCmap())
    plain = set(faces["font-style:normal"].getBestCmap())
    cells = re.findall(r'<span class="cell( given)?"><span>.*?</span>(.*?)</span>', html)
    values = {
        kind: "".join(re.sub("<.*?>", "", text) for given, text in cells if given == kind)
        for kind in ("", " given")
    }
    letters = set(map(ord, unescape(values[""])))
    assert len(letters) > 10
    assert letters <= bold and letters <= plain
    assert set(map(ord, unescape(values[" given"]))) <= plain


def test_results_that_have_not_the_room_are_smaller():
    html = "".join(page_of(name) for name in ("hooke-joint", "spatial-four-bar"))
    sizes = [int(size) for size in re.findall(r'<div[^>]*style="font-size:(\d+)%"', html)]
    assert len(sizes) > 5
    assert 60 < min(sizes) < 85
    assert max(sizes) <= 100


def test_a_chapter_begins_with_its_panel_and_is_as_long():
    player = bundle_of(page_of("slider-crank"))[4][-1]
    chapters = re.findall(r'<button data-x="(\d+)" style="flex-grow:(\d+)">(.*?)</button>', player)
    panels = lesson_of("slider-crank").sheet.panels
    counts = [len(panel.strokes) for panel in panels]
    starts = [sum(counts[:place]) for place in range(len(counts))]
    assert [(int(x), int(long), title) for x, long, title in chapters] == [
        (start, count, panel.title)
        for start, count, panel in zip(starts, counts, panels, strict=True)
    ]


@pytest.mark.exhaustive(256)
@pytest.mark.parametrize(("name", "whole"), EVERY)
def test_what_is_seen_only_where_scripts_run_is_packed_in_its_order(name: str, whole: bool) -> None:
    lesson, html = lesson_of(name, whole=whole), page_of(name, whole=whole)
    late, empty = bundle_of(html)[4], r'<g data-b="[^"]*">(?=</g>)|<div class="control"[^>]*>'
    body = html.partition("<body>\n")[2].partition('<script type="text/plain"')[0]
    assert len(re.findall(empty, body)) == len(late)
    left = iter(late)
    again = re.sub(empty, lambda found: found[0] + next(left), body)
    assert again == section(lesson, parts(lesson))
    assert body.count('<g data-b="') == len(late) - 1


def test_a_pencil_draws_on_a_page_what_flies_in_a_film():
    lesson = vad.animate(vad.draw(vad.solve(vad.Whitworth(), alpha=20)))
    plain = vad.animate(lesson.sheet, plain=True)
    flown = 0
    for times, step, drawn in zip(
        parts(lesson).data["times"], lesson.steps, plain.steps, strict=True
    ):
        grow, hold = (round(each * lesson.fps) for each in times[:2])
        assert abs(grow - drawn.grow) <= 1
        assert grow + hold == step.frames
        flown += step.grow > 2 * grow
    assert flown > 3


def test_the_name_of_a_load_is_read_as_a_word() -> None:
    load = {"name": "gas", "at": "C", "force": 800.0, "angle": 180.0}
    found = parts(vad.animate(vad.draw(vad.forces(vad.solve(vad.SliderCrank()), [load]))))
    heard = " ".join(found.data["spoken"])
    assert "gas times v C" in heard and "g a s" not in heard and "A B" in heard
    assert found.hand and "gas" in found.hand.data["spelled"]
