"""The gallery on the site: its pages open and are turned by hand."""

from __future__ import annotations

from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread

from playwright.sync_api import Browser, Frame, Page

from docs.gallery import Piece, pieces
from tests.browser import opened, until
from tests.docs.conftest import EVERY


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
    return str(frame.locator(".drawing > svg").first.evaluate("(svg) => svg.outerHTML"))
