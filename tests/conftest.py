"""What holds for all tests.

A test that is marked ``exhaustive`` looks at many mechanisms or poses alike.  Usually one case in
64 of it runs, or one in so many as the mark says; of tests whose marks name the same ``of``,
the same cases run, so that what they look at is made once.  Hypothesis tries the same examples in
each run.  With ``--exhaustive``, as in ``.ci/nightly``, all cases run, and the examples are new.
"""

from __future__ import annotations

import gc
import signal
from collections.abc import Iterator
from typing import TYPE_CHECKING
from zlib import crc32

import pytest
from hypothesis import given, settings
from hypothesis.strategies import none

from tests.browser import launched, opened

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

# A shell lets what it starts in the background ignore an interrupt, and nohup lets it ignore a
# hang-up; programs inherit that.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP") and signal.getsignal(signal.SIGHUP) is signal.SIG_IGN:
    signal.signal(signal.SIGHUP, signal.SIG_DFL)

#: Of the cases of an exhaustive test one in so many runs usually, and always the first.
ONE_IN = 64

# No test has a limit of time: a machine may be busy.
settings.register_profile("the same each time", derandomize=True, deadline=None)
settings.register_profile("new each time", deadline=None)


def pytest_addoption(parser: pytest.Parser) -> None:
    """Let the command line ask for all cases."""
    parser.addoption("--exhaustive", action="store_true", help="run all cases of every test")


def pytest_configure(config: pytest.Config) -> None:
    """Choose the examples of hypothesis."""
    exhaustive = config.getoption("--exhaustive")
    settings.load_profile("new each time" if exhaustive else "the same each time")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out most cases of exhaustive tests: by their names, so that a run repeats another."""
    if config.getoption("--exhaustive"):
        return
    begun: set[str] = set()
    kept, left = [], []
    for item in items:
        test, _, case = item.nodeid.partition("[")
        first = test not in begun
        begun.add(test)
        mark = item.get_closest_marker("exhaustive") if case else None
        one_in = 1 if mark is None else mark.args[0] if mark.args else ONE_IN
        same = f"{mark.kwargs['of']}[{case}" if mark and "of" in mark.kwargs else item.nodeid
        usual = first or crc32(same.encode()) % one_in == 0
        (kept if usual else left).append(item)
    config.hook.pytest_deselected(items=left)
    items[:] = kept


def pytest_collection() -> None:
    """Collect no garbage while tests are collected, which all stay: that takes a fifth longer."""
    gc.disable()


def pytest_collection_finish() -> None:
    """Keep what was collected, which all stays, from the collector of garbage: that takes a tenth.

    Drawings are many small objects that stay, too, so it runs less often.  Films which tests have
    let go must not stay, so it may not wait for long.
    """
    gc.enable()
    gc.collect()
    _nothing()
    gc.freeze()
    gc.set_threshold(4_000, 10, 10)


@settings(max_examples=1, database=None)
@given(none())
def _nothing(_: None) -> None:
    """Let hypothesis look once who holds its random numbers: it would not see what is frozen."""


@pytest.fixture(scope="session")
def exhaustive(request: pytest.FixtureRequest) -> bool:
    """Tell whether all is asked for, to a test that has no cases, but rounds."""
    return bool(request.config.getoption("--exhaustive"))


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
