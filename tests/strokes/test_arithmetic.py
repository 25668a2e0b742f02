"""Digits for calculations: there is an end, even where no number of digits makes them hold."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

import vad
from tests.limits import within
from vad.files.examples import example_path
from vad.strokes.arithmetic import Figure, product, total, with_digits
from vad.strokes.notation import Notation
from vad.strokes.sentences import Sentence

VALUES = st.sampled_from([0.0, 5e-324, 1e-151, 1 / 3, 12.0, 99999.5, 2e5, 5e151, 1e250])
FIGURES = st.builds(Figure, VALUES, st.sampled_from(["mm", "°", "mm/s²"]), st.booleans())


@given(st.lists(st.tuples(FIGURES, FIGURES, FIGURES), min_size=1, max_size=4))
def test_there_is_an_end(triples):
    said = [
        Sentence("", dict(zip("abc", triple, strict=True)), (calculate("a", "b", "c"),))
        for triple in triples
        for calculate in (product, total)
    ]
    with within(5.0):
        notation = with_digits(Notation(metres=True), said)
    assert all(0 < digits <= 15 for digits in notation.digits.values())


@pytest.mark.parametrize(("name", "lengths"), [("trunnion", {"crank": 5e151}), ("roberts", None)])
def test_a_drawing_with_lengths_far_apart_is_made(name, lengths):
    kind = vad.load(example_path(name))
    lengths = lengths or {"side": 1e150 * kind().side}
    with within(20.0):
        vad.draw(vad.solve(kind(**lengths)))
