from __future__ import annotations

from pathlib import Path

import pytest

from tests.export.synthetic import filmed


@pytest.fixture
def painter(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let lessons be painted by the small synthetic painter."""
    monkeypatch.setattr("vad.painting.film.filmed", filmed())


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return an empty folder that is the current one."""
    monkeypatch.chdir(tmp_path)
    return tmp_path
