"""The gallery: every mechanism has a card with a picture, and a page that is turned by hand."""

from __future__ import annotations

import re
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread

import pytest
from playwright.sync_api import Browser, Frame, Page

import vad
from docs.card import card
from docs.examples import run_examples
from docs.gallery import Piece, pieces, write_gallery
from tests.browser import opened, until
from tests.docs.conftest import EVERY
from vad.files.examples import example_names, example_path

SOME = [Piece("slider-crank", False), Piece("rssr", False), Piece("four-bar", True)]


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


@pytest.mark.parametrize("piece", SOME, ids=lambda piece: piece.place)
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


@pytest.mark.parametrize("piece", SOME, ids=lambda piece: piece.place)
def test_the_command_on_a_page_writes_the_page_that_is_downloaded(
    piece: Piece, gallery: Path, tmp_path: Path
):
    run_examples(f"```sh\n{piece.command}\n```\n", tmp_path)
    written = (tmp_path / f"{piece.name}.html").read_bytes()
    assert written == (gallery / "lessons" / f"{piece.place}.html").read_bytes()


@pytest.mark.exhaustive(32)
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


def test_every_page_of_the_site_opens_and_turns(site: Path, browser: Browser):
    for piece in pieces()[::EVERY]:
        with opened(browser, viewport={"width": 1280, "height": 820}) as page:
            page.goto((site / "gallery" / f"{piece.place}.html").as_uri())
            _turn(page, piece)


def test_a_card_leads_to_a_page_that_turns_under_any_path_of_a_server(
    site: Path, browser: Browser, tmp_path: Path
):
    class Quiet(SimpleHTTPRequestHandler):
        def __init__(self, *given: object) -> None:
            super().__init__(*given, directory=str(tmp_path))  # type: ignore[arg-type]

        def log_message(self, format: str, *words: object) -> None:
            pass

    (tmp_path / "some").mkdir()
    (tmp_path / "some" / "course").symlink_to(site)
    piece = pieces()[-1 - (len(pieces()) - 1) % EVERY]
    with ThreadingHTTPServer(("127.0.0.1", 0), Quiet) as server:
        Thread(target=server.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{server.server_port}/some/course/"
        with opened(browser, server=address, viewport={"width": 390, "height": 844}) as page:
            page.goto(address + "gallery/index.html")
            page.locator(f'.cards a[href="{piece.place}.html"]').click()
            _turn(page, piece)
            with page.expect_download() as download:
                page.get_by_role("link", name="Download this page").click()
            assert download.value.suggested_filename == f"{piece.name}.html"
            kept = site / "gallery" / "lessons" / f"{piece.place}.html"
            assert download.value.path().read_bytes() == kept.read_bytes()
        server.shutdown()


def test_the_gallery_fits_a_phone_and_a_laptop(site: Path, page: Page):
    for width, columns in ((390, 1), (1280, 4)):
        page.set_viewport_size({"width": width, "height": 820})
        page.goto((site / "gallery" / "index.html").as_uri())
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        cards = page.locator(".cards").last.locator("a")
        widths = [box["width"] for each in cards.all() if (box := each.bounding_box())]
        assert min(widths) >= 248.0
        tracks = page.locator(".cards").last.evaluate(
            "(e) => getComputedStyle(e).gridTemplateColumns"
        )
        assert len(tracks.split()) == columns


def _turn(page: Page, piece: Piece) -> None:
    """Turn the mechanism on a page, and see that its picture follows, beside its buttons."""
    element = page.locator("iframe.lesson").element_handle()
    frame = element.content_frame()
    assert frame is not None
    until(page, lambda: frame.evaluate("'vad' in window && 'state' in window.vad"))
    name, before = next(iter(frame.evaluate("vad.state").items()))
    seen = _picture(frame)
    answer = frame.evaluate("(asked) => vad.pose(asked)", {name: before + 1.0 / 64.0})
    assert answer.get(name) == before + 1.0 / 64.0, (piece, answer)
    until(page, lambda: _picture(frame) != seen)
    page.locator("iframe.lesson").scroll_into_view_if_needed()
    box, play = page.locator("iframe.lesson").bounding_box(), frame.locator("[data-do=play]")
    assert box and box["height"] <= page.viewport_size["height"]
    assert box["y"] + box["height"] >= play.bounding_box()["y"] + 20.0


def _picture(frame: Frame) -> str:
    return str(frame.locator(".drawing svg").first.evaluate("(svg) => svg.outerHTML"))
