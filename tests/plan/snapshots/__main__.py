"""Write the snapshots anew: ``python -m tests.plan.snapshots [SCENE ...]``."""

from __future__ import annotations

import sys

from tests.plan.snapshots import HERE, KINDS, SCENES

for scene in sys.argv[1:] or SCENES:
    for kind, shown in KINDS.items():
        text = "\n".join(shown(scene)) + "\n"
        (HERE / f"{scene}-{kind}.txt").write_text(text, encoding="utf-8")
