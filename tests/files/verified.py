"""Mechanisms with figures that were found without the program.

Their equations were written from the text of the file alone, in coordinates, and solved at 60
digits by Newton's method, followed round the range from the place that the file says; the rates are
differences.
"""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

from vad.files.loading import WrittenMechanism, class_of
from vad.files.tables import read_text

CASES: list[dict[str, Any]] = json.loads(Path(__file__).with_name("cases.json").read_text("utf-8"))
BY_NAME = {case["id"]: case for case in CASES}


@cache
def verified(name: str) -> type[WrittenMechanism]:
    """Return the mechanism of a case."""
    return class_of(read_text(BY_NAME[name]["toml"], f"{name}.toml"))


def written(text: str) -> type[WrittenMechanism]:
    """Return the mechanism that a text describes, in a file called lesson.toml."""
    return class_of(read_text(text, "lesson.toml"))
