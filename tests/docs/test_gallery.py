"""The gallery: every mechanism has a card with a picture, and a page of its own."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page

import vad
from docs.card import card
from docs.examples import run_examples
from docs.gallery import Piece, pieces, write_gallery
from vad.files.examples import example_names, example_path

SOME = [Piece("slider-crank", False), Piece("hooke-joint", False), Piece("four-bar", True)]


@pytest.fixture(scope="module")
def gallery(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of a gallery of three mechanisms, whose pages are still Markdown."""
    pages = tmp_path_factory.mktemp("pages")
    write_gallery(pages, SOME)
    return pages / "gallery"


def test_it_has_every_built_in_mechanism_and_every_example():
    shown = {(piece.name, piece.example) for piece in pieces()}
    assert len(pieces()) == len(shown)
    built_in = {(name, False) for name in vad.MECHANISMS}
    assert shown == built_in | {(name, True) for name in example_names()}


def test_an_example_and_a_built_in_mechanism_of_the_same_name_have_pages_of_their_own():
    places = [piece.place for piece in pieces()]
    assert len(set(places)) == len(places)
    assert {"four-bar", "examples/four-bar"} <= set(places)


def test_each_has_its_card_and_its_page(gallery: Path):
    index = (gallery / "index.md").read_text("utf-8")
    assert re.findall(r'<a href="([^"]+)\.html">', index) == [piece.place for piece in SOME]
    for piece in SOME:
        page = (gallery / f"{piece.place}.md").read_text("utf-8")
        assert f"```sh\n{piece.command}\n```" in page
        frame = re.search(r'<iframe [^>]*src="([^"]+)"', page)
        down = re.search(r"\[Download this page\]\(([^)]+)\)", page)
        assert frame and down and frame[1] == down[1]
        lesson = (gallery / piece.place).parent / frame[1]
        assert lesson.resolve() == gallery / "lessons" / f"{piece.place}.html"
        assert lesson.read_text("utf-8").startswith("<!DOCTYPE html>")


@pytest.mark.exhaustive
@pytest.mark.parametrize("piece", SOME[::-1], ids=lambda piece: piece.place)
def test_a_page_shows_and_offers_the_file_that_draws_it(
    piece: Piece, gallery: Path, tmp_path: Path
):
    text = (gallery / f"{piece.place}.toml").read_text("utf-8")
    assert f"\n{text.strip()}\n```" in (gallery / f"{piece.place}.md").read_text("utf-8")
    if piece.example:
        assert text == example_path(piece.name).read_text("utf-8")
    (tmp_path / "own.toml").write_text(text, encoding="utf-8")
    run_examples("```sh\nvad draw own.toml -o own.html\n```\n", tmp_path)
    drawn = (tmp_path / "own.html").read_bytes()
    lesson = (gallery / "lessons" / f"{piece.place}.html").read_bytes()
    assert drawn == lesson or piece.example  # which is called by the name of its file


@pytest.mark.exhaustive
@pytest.mark.parametrize("piece", SOME, ids=lambda piece: piece.place)
def test_the_command_on_a_page_writes_the_page_that_is_downloaded(
    piece: Piece, gallery: Path, tmp_path: Path
):
    run_examples(f"```sh\n{piece.command}\n```\n", tmp_path)
    written = (tmp_path / f"{piece.name}.html").read_bytes()
    assert written == (gallery / "lessons" / f"{piece.place}.html").read_bytes()


@pytest.mark.exhaustive(128)
@pytest.mark.parametrize("piece", pieces(), ids=lambda piece: piece.place)
def test_the_picture_of_a_card_is_full_of_ink_and_has_no_letters(piece: Piece, page: Page):
    page.set_content(card(piece.sheet(), "paper"))
    assert page.locator("text, use").count() == 0
    assert page.locator("svg g").count() >= 3
    width, height, left, top, right, bottom = page.evaluate(
        """() => {
            const svg = document.querySelector("svg"), { width, height } = svg.viewBox.baseVal;
            const boxes = [...svg.querySelectorAll("g")].map((each) => each.getBBox());
            const ends = (side, extent) => boxes.map((b) => b[side] + (extent ? b[extent] : 0));
            return [width, height, Math.min(...ends("x")), Math.min(...ends("y")),
                Math.max(...ends("x", "width")), Math.max(...ends("y", "height"))];
        }"""
    )
    assert width > 80.0
    assert height > 30.0
    # As much stays free around the ink on every side, for half of a line.
    assert [left, top, width - right, height - bottom] == pytest.approx([3.84] * 4, abs=1.0)
