"""What a test in a real browser would notice."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests import browser as tool

HEAD = '<!doctype html><html lang="en"><title>A page</title>'


def shown(page, tmp_path: Path, body: str) -> None:
    path = tmp_path / "a.html"
    path.write_text(HEAD + body)
    page.goto(path.as_uri())


@pytest.mark.parametrize(
    ("body", "fault"),
    [
        ("<script>console.error('oh')</script>", "console: oh"),
        ("<script>no.such</script>", "script: .*no is not defined"),
        ('<img src="http://vad.invalid/a.png">', "request: http://vad.invalid/a.png"),
        (
            "<meta http-equiv=Content-Security-Policy content=\"default-src 'none'\">"
            '<img src="http://vad.invalid/a.png">',
            "request: http://vad.invalid/a.png",
        ),
    ],
)
def test_a_fault_of_a_page_fails_its_test(browser, tmp_path, body, fault):
    with pytest.raises(AssertionError, match=fault), tool.opened(browser) as page:
        shown(page, tmp_path, body)


def test_a_provoked_error_is_none(browser, tmp_path):
    with tool.opened(browser, expected="^oh$") as page:
        shown(page, tmp_path, "<script>console.error('oh')</script>")


def test_what_never_comes_is_noticed(page, tmp_path):
    shown(page, tmp_path, "<main><h1>x</h1></main>")
    tool.until(page, lambda: page.title() == "A page")
    with pytest.raises(AssertionError, match=r"not so within 0\.1 s"):
        tool.until(page, lambda: page.title() == "another", seconds=0.1)


def test_what_cannot_be_read_is_noticed(page, tmp_path):
    shown(page, tmp_path, "<main><h1>x</h1><p style='color:#ccc'>pale</p></main>")
    (found,) = tool.violations(page)
    assert found.startswith("color-contrast: <p")


@pytest.mark.parametrize(("ci", "outcome"), [("", pytest.skip), ("true", pytest.fail)])
def test_without_a_browser_a_test_says_so(monkeypatch, ci, outcome):
    monkeypatch.setenv("VAD_BROWSER", "/no/such/browser")
    monkeypatch.setenv("CI", ci)
    with pytest.raises(outcome.Exception, match="no browser: needs playwright and chromium"):
        tool.launched().__enter__()
