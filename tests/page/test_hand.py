"""The data of a page's hand."""

from __future__ import annotations

from typing import Any

import pytest

import vad
from tests.page.hands import EXAMPLES, NAMES, made
from vad.kinematics.reach import closing_range


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_every_number_of_the_table_that_changes_follows(name: str) -> None:
    mechanism: Any = vad.MECHANISMS.get(name) or vad.load(str(EXAMPLES[name]))
    mechanism = mechanism()
    low, high = closing_range(mechanism)[0]
    driver = next(iter(mechanism.inputs))
    sheets = [
        vad.draw(vad.solve(mechanism, **{driver: low + share * (high - low)}))
        for share in (0.37, 0.59)
    ]
    follows = {tuple(cell[:3]) for cell in made(name)[-1]["cells"]}
    for number, rows in enumerate(zip(*(sheet.rows for sheet in sheets), strict=True)):
        for column, panel in enumerate(sheets[0].panels):
            cells = zip(*(row.cells.get(panel.name, ()) for row in rows), strict=True)
            for place, (one, other) in enumerate(cells):
                if abs(one.value - other.value) > 1e-6 * abs(one.value):
                    assert (number, column, place) in follows, (one.symbol, panel.name)
