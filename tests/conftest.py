"""What holds for all tests."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest

from tests.browser import launched, opened

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

# A shell lets what it starts in the background ignore an interrupt, and that is inherited.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """Return a real browser, one a worker."""
    with launched() as running:
        yield running


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """Return an empty page, on which nothing may go wrong."""
    with opened(browser) as empty:
        yield empty
