from __future__ import annotations

import sys
from pathlib import Path

import pytest

from tests.export.synthetic import as_filming_module


@pytest.fixture
def painter(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let lessons be painted by the small synthetic painter."""
    monkeypatch.setitem(sys.modules, "vad.painting.filming", as_filming_module())


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return an empty folder that is the current one."""
    monkeypatch.chdir(tmp_path)
    return tmp_path
