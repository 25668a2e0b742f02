"""One page of a lesson, for all tests that only play it."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page

from tests.browser import opened
from tests.page.lessons import page_of, show


@pytest.fixture(scope="session")
def shared(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    """Return the page, opened once a worker."""
    with opened(browser, viewport={"width": 1280, "height": 720}) as page:
        show(page, tmp_path_factory.mktemp("page"), page_of("slider-crank"))
        yield page


@pytest.fixture
def lesson(shared: Page) -> Page:
    """Return the page of a lesson at its beginning, with the focus nowhere."""
    shared.evaluate("document.activeElement.blur()")
    shared.keyboard.press("Home")
    return shared
