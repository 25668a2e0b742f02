"""What is placed where: the plans of all mechanisms against the snapshots beside them.

A number may differ by one in its last place, a thousandth of the page, which is a matter of
rounding; everything else must be as it was.  A change that is wanted is shown by the diff of the
snapshots, once ``python -m tests.plan.snapshots`` has written them anew.
"""

from __future__ import annotations

import re
from itertools import zip_longest

import pytest

from tests.plan.snapshots import HERE, KINDS, SNAPSHOTS

pytestmark = pytest.mark.exhaustive

NUMBER = re.compile(r"(?<![\w.\[])[−-]?\d+(?:\.\d+)?(?![\w.])")
MOST = 5  # differences that are shown


def same(line: str | None, kept: str | None) -> bool:
    if line is None or kept is None:
        return False
    if line == kept:
        return True
    if not line.startswith("  ") or NUMBER.sub("#", line) != NUMBER.sub("#", kept):
        return False
    words, numbers = line.rpartition("»"), kept.rpartition("»")
    if words[0] != numbers[0]:  # a number that is written, not placed
        return False
    pairs = zip(NUMBER.findall(words[2]), NUMBER.findall(numbers[2]), strict=True)
    return all(abs(float(a) - float(b)) <= 1.0 for a, b in pairs)


@pytest.mark.parametrize(("scene", "kind"), SNAPSHOTS)
def test_everything_stands_where_it_stood(scene: str, kind: str):
    kept = (HERE / f"{scene}-{kind}.txt").read_text(encoding="utf-8").splitlines()
    item, different = "", []
    for line, before in zip_longest(KINDS[kind](scene), kept):
        if line and not line.startswith("  "):
            item = line
        if not same(line, before):
            different.append(f"{item}\n  is  {line}\n  was {before}")
    assert not different, "\n".join([f"{len(different)} differences:", *different[:MOST]])


def test_a_snapshot_tells_a_thousandth_from_a_difference():
    line = "  bar [1] 100,200 300,400 trim"
    assert same(line, line.replace("300", "301"))
    assert not same(line, line.replace("300", "302"))
    assert not same(line, line.replace("[1]", "[2]"))
    assert not same(line, line.replace("bar", "vector"))
    written = "  words «v = 490» roman 33 at 10,20"
    assert not same(written, written.replace("490", "491"))


def test_every_snapshot_has_a_scene():
    names = {path.stem for path in HERE.glob("*.txt")}
    assert names == {f"{scene}-{kind}" for scene, kind in SNAPSHOTS}
