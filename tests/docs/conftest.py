"""The site, built once for all tests that look at it."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest

from docs.site import ROOT

#: One in so many mechanisms is in the gallery: in the plane and from files.
EVERY = 20


@pytest.fixture(scope="session")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the site, which is built in a process of its own, without a warning."""
    if importlib.util.find_spec("mkdocs") is None:
        pytest.skip("mkdocs comes with the extra docs")
    folder = tmp_path_factory.mktemp("site")
    done = subprocess.run(
        [sys.executable, "-m", "docs", str(folder), "--every", str(EVERY)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr
    assert "WARNING" not in done.stderr
    return folder
