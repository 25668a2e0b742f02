"""A real browser: Debian's chromium, driven through playwright.

Where ``chromium-headless-shell`` is installed, that is what runs: the same engine without the
windows round a page, which take as much processor time as our pages do.

The fixture ``browser`` of `tests.conftest` starts it, once a worker; `opened` gives a test, or a
module of tests, an empty page in it, ``page`` one for a single test.  Our pages forbid ``eval``,
on which playwright's ``wait_for_function`` rests: wait with its ``expect``, or with `until`.
While it runs, the main thread has an event loop, so that ``asyncio.run`` needs another thread.
"""

from __future__ import annotations

import os
import re
import shutil
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, NoReturn

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Browser, ConsoleMessage, Page, Request

MISSING = "no browser: needs playwright and chromium (or VAD_BROWSER=/path)"
BROWSERS = ("chromium-headless-shell", "chromium")  # the first that is found


@contextmanager
def launched() -> Iterator[Browser]:
    """Run the browser; without one, skip and say why, and fail where `CI` is set."""
    named = os.environ.get("VAD_BROWSER")
    path = next(filter(None, map(shutil.which, [named] if named else BROWSERS)), None)
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        path = None
    if path is None:
        missing()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=path,
            headless=True,
            chromium_sandbox=os.geteuid() != 0,  # it refuses to start as root with a sandbox
            args=[
                "--disable-background-networking",
                # Of its own accord the shell has letters that are as wide as whole pixels, and
                # scrolls nothing on a full screen that is outside of a window of 800 by 600.
                "--font-render-hinting=none",
                "--window-size=1920,1080",
            ],
        )
        yield browser
        browser.close()


def missing() -> NoReturn:
    """End a test that finds no browser."""
    if os.environ.get("CI"):
        pytest.fail(MISSING, pytrace=False)
    pytest.skip(MISSING)


@contextmanager
def opened(
    browser: Browser, *, server: str = "file:", expected: str = "(?!)", **options: object
) -> Iterator[Page]:
    """Give an empty page in a context of its own, as with nobody else's cookies.

    When it is closed, nothing may have gone wrong in it, and nothing may have been asked of anyone
    but ``server``, the beginning of its addresses ("http://127.0.0.1:8000/").  A test that provokes
    errors on the console gives a pattern that finds them, ``expected``.  ``options`` are
    playwright's: ``viewport``, ``java_script_enabled``, ``reduced_motion``, ``forced_colors`` …
    """
    faults: list[str] = []

    def said(message: ConsoleMessage) -> None:
        if message.type == "error" and not re.search(expected, message.text):
            faults.append(f"console: {message.text}")

    def asked(request: Request) -> None:
        if not request.url.startswith((server, "file:", "data:")):
            faults.append(f"request: {request.url}")

    context = browser.new_context(**options)
    context.on("console", said)
    context.on("weberror", lambda fault: faults.append(f"script: {fault.error}"))
    context.on("request", asked)
    try:
        yield context.new_page()
    finally:
        context.close()
    assert not faults, faults


def until(page: Page, holds: Callable[[], object], seconds: float = 30.0) -> None:
    """Wait until ``holds()`` is true, which may take long on a machine that has much to do."""
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end, f"not so within {seconds:g} s"
        page.wait_for_timeout(20)


def painted(page: Page) -> None:
    """Wait until a frame is painted: not before is all laid out for a window of another size."""
    page.evaluate(
        "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
    )


def violations(page: Page) -> list[str]:
    """Return what axe-core has against a page at rest: the rule and the element."""
    from axe_playwright_python.sync_playwright import Axe

    moving = "document.getAnimations().some((each) => each.playState === 'running')"
    until(page, lambda: not page.evaluate(moving))
    return [
        f"{rule['id']}: {node['html']}"
        for rule in Axe().run(page).response["violations"]
        for node in rule["nodes"]
    ]
