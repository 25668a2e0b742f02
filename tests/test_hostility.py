"""Whatever is called with whatever: one line of a `VadError`, or an answer."""

from __future__ import annotations

import pytest

from tests import hostile


@pytest.mark.parametrize("seed", range(4))
def test_no_call_breaks_the_promise(seed, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert list(hostile.calls(150, seed)) == []
    assert not list(tmp_path.glob(".vad-*"))
