"""SVG as other programs read it: names, words, text and fonts."""

from __future__ import annotations

import io
import re
from collections import Counter
from dataclasses import replace
from itertools import cycle
from xml.etree import ElementTree

import pytest

import vad
from tests.painting.readers import fonts
from tests.painting.test_same_picture import sheet_of
from vad.errors import UsageError
from vad.export import picture_svg
from vad.lecture.lesson import Still
from vad.painting.posed import posed
from vad.painting.svg_painter import SvgPainter
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Run
from vad.strokes.sheet import Fold, Sheet
from vad.style import style_names
from vad.written import THIN_SPACE, with_unit

SPACE = "{http://www.w3.org/2000/svg}"
TEXTS = ("glyphs", "letters")


def written(thing: Sheet | Still, **options: object) -> bytes:
    target = io.BytesIO()
    picture_svg.write(thing, target, **options)
    return target.getvalue()


def groups(data: bytes) -> dict[str, list[ElementTree.Element]]:
    """Return the groups of every stroke by its name."""
    found: dict[str, list[ElementTree.Element]] = {}
    for each in ElementTree.fromstring(data).iter(SPACE + "g"):
        if "data-stroke" in each.attrib:
            found.setdefault(each.get("data-stroke"), []).append(each)
    return found


@pytest.mark.parametrize("text", TEXTS)
def test_the_same_sheet_gives_the_same_bytes(text: str) -> None:
    sheet = sheet_of("four-bar")
    assert written(sheet, text=text) == written(replace(sheet), text=text, size=None)


@pytest.mark.parametrize("text", TEXTS)
def test_a_sheet_is_small(text: str) -> None:
    assert len(written(sheet_of("slider-crank"), text=text)) < 50_000


@pytest.mark.parametrize("size", [(1280, 720), (640, 480)])
def test_a_pixel_is_a_unit(size: tuple[int, int]) -> None:
    root = ElementTree.fromstring(written(sheet_of("four-bar"), size=size))
    assert (float(root.get("width")), float(root.get("height"))) == size
    assert root.get("viewBox") == f"0 0 {size[0]} {size[1]}"


@pytest.mark.parametrize("code", ["en", "de"])
def test_it_says_what_it_shows(code: str) -> None:
    sheet = vad.draw(vad.solve(vad.SliderCrank()), language=code)
    root = ElementTree.fromstring(written(sheet))
    assert root.get("role") == "img"
    assert root.get("lang") == code
    assert root.find(SPACE + "title").text.startswith(sheet.title)
    description = root.find(SPACE + "desc").text
    assert all(s.caption.rstrip(".") in description for p in sheet.panels for s in p.strokes)
    assert "ω₃ = −2.308 rad/s".replace(".", sheet.notation.point) in description


@pytest.mark.exhaustive(8)
@pytest.mark.parametrize("name", vad.MECHANISMS)
def test_every_stroke_has_a_group_with_its_name_and_caption(name: str) -> None:
    sheet = sheet_of(name)
    found = groups(written(sheet))
    strokes = {p.full(s.name): (p, s) for p in sheet.halves for s in p.strokes}
    assert set(found) <= set(strokes)
    for full, (panel, stroke) in strokes.items():
        if panel.picture == "skeleton" and stroke.kind == "construction":
            continue  # wiped off when its crossing is found
        if isinstance(stroke.shape, Fold):
            continue  # a move, which leaves no ink
        if stroke.component == "relative" and full not in found:
            continue  # a whole vector that lies upon its one part
        titles = [title.text for each in found[full] for title in each.findall(SPACE + "title")]
        assert titles == [stroke.caption]
        main = next(each for each in found[full] if each.find(SPACE + "title") is not None)
        assert main.get("id") == full.replace(":", "-")


def test_a_whole_vector_beside_its_parts_has_a_group() -> None:
    assert "acceleration:BC.whole" in groups(written(sheet_of("slider-crank")))


def test_a_step_has_the_group_of_its_stroke(exhaustive: bool) -> None:
    """Usually one in four is looked at."""
    lesson = vad.animate(sheet_of("slider-crank"))
    for number, step in [*enumerate(lesson.steps, 1)][:: 1 if exhaustive else 4]:
        found = groups(written(vad.still(lesson, number)))
        assert f"{step.panel.name}:{step.stroke.name}" in found
        later = {f"{each.panel.name}:{each.stroke.name}" for each in lesson.steps[number:]}
        pending = set(found) & later  # its term of the equation is there, pale
        assert not [each for name in pending for each in found[name] if each.find(SPACE + "path")]


@pytest.mark.parametrize("text", TEXTS)
def test_ids_are_unique_and_what_is_used_is_there(text: str) -> None:
    root = ElementTree.fromstring(written(sheet_of("crank-slotted-lever"), text=text))
    ids = Counter(each.get("id") for each in root.iter() if "id" in each.attrib)
    assert set(ids.values()) == {1}
    used = {each.get("href") for each in root.iter(SPACE + "use")}
    assert used and {each.removeprefix("#") for each in used} <= set(ids)


def test_pictures_on_one_page_do_not_disturb_each_other(exhaustive: bool) -> None:
    """Classes, glyphs and texts of the same name are the same, whatever the picture."""
    names = vad.MECHANISMS if exhaustive else ("whitworth", "rssr", "slider-crank")
    said: dict[str, set[str]] = {}
    for name, style in zip(names, cycle(style_names()), strict=False):
        page = written(sheet_of(name), style=style).decode()
        page += written(sheet_of(name), style=style, text="letters").decode()
        for rule in re.findall(r"\n(\.\w+\{.*?\})", page):
            said.setdefault(rule.partition("{")[0], set()).add(rule)
        for glyph in re.findall(r'<path id="\w+" d=".*?"/>', page):
            said.setdefault(glyph.split('"')[1], set()).add(glyph)
        for text in re.findall(r'<text id="\w+".*?</text>', page):
            said.setdefault(text.split('"')[1], set()).add(text)
    assert len(said) > 100
    assert all(len(meanings) == 1 for meanings in said.values())


@pytest.mark.parametrize("text", TEXTS)
def test_names_of_a_picture_with_a_scope_are_its_own(text: str) -> None:
    """Its id, all that it names for the page, and the reach of its rules."""
    names = []
    for scope in ("one", "two"):
        shown = posed(sheet_of("four-bar"))
        painter = SvgPainter(shown.sheet, text, scope=scope)
        shown.play(painter)
        root = ElementTree.fromstring(painter.svg)
        assert root.get("id") == scope
        ids = {each.get("id") for each in root.iter() if "id" in each.attrib}
        used = {each.get("href")[1:] for each in root.iter(SPACE + "use")}
        assert used and used <= ids
        rules = root.find(SPACE + "style").text.strip().splitlines()
        fonts = [rule for rule in rules if rule.startswith("@font-face")]
        assert all(rule.startswith(f"#{scope} .") for rule in rules if rule not in fonts)
        families = {re.search("font-family:(.*?);", rule).group(1) for rule in fonts}
        assert len(families) == (text == "letters")
        names.append(ids | families)
    assert not names[0] & names[1]


class TestLetters:
    """Text that can be selected and searched."""

    @pytest.mark.exhaustive(8)
    @pytest.mark.parametrize("name", vad.MECHANISMS)
    def test_results_can_be_read(self, name: str) -> None:
        sheet = sheet_of(name)
        root = ElementTree.fromstring(written(sheet, text="letters"))
        lines = ["".join(each.itertext()) for each in root.iter(SPACE + "text")]
        # Behind a rate whose arrow has no room on the mechanism stands its sense.
        lines = [re.sub("\\s*[↺↻]$", "", line) for line in lines]
        for row in sheet.rows:
            for cells, cell in ((own, each) for own in row.cells.values() for each in own):
                value = with_unit(*sheet.notation.cell(cell.value, cell.unit, cell.given))
                if len(cells) > 1:  # where it is tight, their column has said the unit
                    value = value.partition(" ")[0]
                    assert any(value in line for line in lines), value
                    continue
                value = value.replace("²", "2").replace(THIN_SPACE, "")
                assert any(line.endswith(value) for line in lines), value
        assert any(line == sheet.title for line in lines)

    def test_fonts_hold_the_letters_of_the_text_and_no_others(self) -> None:
        data = written(sheet_of("slider-crank"), text="letters")
        letters = set().union(*(font.getBestCmap() for font in fonts(data.decode())))
        text = "".join(
            "".join(each.itertext()) for each in ElementTree.fromstring(data).iter(SPACE + "text")
        )
        assert {chr(letter) for letter in letters} == set(text)

    def test_fonts_are_renamed_and_keep_their_licence(self) -> None:
        first, *others = (
            {each.nameID: each.toUnicode() for each in font["name"].names}
            for font in fonts(written(sheet_of("slider-crank"), text="letters").decode())
        )
        assert "STI Pub" in first[0]
        assert "Open Font License" in first[13]
        assert first[14].startswith("http")
        for names in (first, *others):
            assert {names[kind] for kind in (1, 3, 4, 6)} == {"vad"}
        assert others and not any({0, 13, 14} & {*names} for names in others)

    def test_letters_are_as_wide_as_on_the_board(self) -> None:
        data = written(sheet_of("slider-crank"), text="letters").decode()
        for font in fonts(data):
            style = font["head"].macStyle
            face = ("roman", "bold", "italic", "bolditalic")[style & 3]
            for letter, glyph in font.getBestCmap().items():
                advance = font["hmtx"][glyph][0] / font["head"].unitsPerEm
                assert advance == pytest.approx(width((Run(chr(letter), face),), 1.0), abs=1e-3)


def test_glyphs_can_be_selected_and_searched() -> None:
    """Their text is not seen, and as wide as they are."""
    root = ElementTree.fromstring(written(sheet_of("slider-crank")))
    texts = {each.text: each for each in root.iter(SPACE + "text")}
    assert {"Slider–crank", "Velocity", "60°", "338.2°", "b′cₙ", "a, d", "−1726 mm/s²"} <= set(
        texts
    )
    assert float(texts["Velocity"].get("textLength")) == pytest.approx(
        1000.0 * width((Run("Velocity", "bold"),), 1.0), abs=1.0
    )
    (unseen,) = {each.get("class") for each in texts.values()}
    rule = re.search(rf"\.{unseen}{{(.*?)}}", root.find(SPACE + "style").text).group(1)
    assert {"fill-opacity:0", "stroke:none"} <= set(rule.split(";"))


def test_text_that_cannot_be() -> None:
    with pytest.raises(UsageError, match="unknown text 'glyph'"):
        written(sheet_of("four-bar"), text="glyph")


@pytest.mark.parametrize("text", TEXTS)
def test_signs_of_markup_in_a_text_are_written_as_text(text: str) -> None:
    sheet = vad.draw(vad.solve(vad.FourBar(length_unit="<b>&x")))
    root = ElementTree.fromstring(written(sheet, text=text))  # or else it is no XML
    assert not [each.tag for each in root.iter() if each.tag.endswith("}b")]
    said = " ".join("".join(each.itertext()) for each in root.iter(SPACE + "text"))
    assert "<b>&x" in said.replace("\N{NO-BREAK SPACE}", " ")
