"""Write the snapshots anew: ``python -m tests.plan.snapshots [SCENE ...]``."""

from __future__ import annotations

import sys

from tests.plan.snapshots import HERE, KINDS, SNAPSHOTS

for scene, kind in SNAPSHOTS:
    if scene in (sys.argv[1:] or [scene]):
        text = "\n".join(KINDS[kind](scene)) + "\n"
        (HERE / f"{scene}-{kind}.txt").write_text(text, encoding="utf-8")
