"""Whatever is typed: exit code 0, 1 or 2, and one line with perhaps a hint where it is not 0."""

from __future__ import annotations

import random

import pytest

from tests.cli import hostile_lines


@pytest.mark.parametrize("seed", range(3))
def test_no_line_breaks_the_promise(vad, seed, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    dice = random.Random(seed)
    for _ in range(100):
        words = hostile_lines.line(dice)
        result = vad(*words)
        told = f"{[word[:60] for word in words]}: {result.err[:600]}"
        lines = result.err.splitlines()
        assert [each.partition(" ")[0] for each in lines] in (
            [[]] if result.code == 0 else [["error:"], ["error:", "hint:"]]
        ), told
        assert result.code in (0, 1, 2), told
        assert all(len(each) < 520 and each.isprintable() for each in lines), told
        assert "internal fault" not in result.err, told
    assert not list(tmp_path.rglob(".vad-*"))
