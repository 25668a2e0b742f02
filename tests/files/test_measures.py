"""Which free dimensions of a file are lengths."""

from __future__ import annotations

import pytest

import vad
from vad.files.description import Expression
from vad.files.examples import example_path
from vad.files.measures import lengths
from vad.strokes.description import parameters
from vad.words import text_of


@pytest.mark.parametrize(
    ("texts", "found"),
    [
        (["4*u", "u"], {"u"}),
        (["a", "n*a", "(n - 1)*a"], {"a"}),
        (["a + 20"], {"a"}),
        (["hypot(a, b)", "sqrt(a*b)"], {"a", "b"}),
        (["a*n"], set()),
        (["n*sin(b)", "a^2/a"], {"a", "n"}),
        (["a + n*20"], {"a", "n"}),
        (["20"], set()),
    ],
)
def test_uses_tell_what_a_dimension_is(texts, found):
    names = list("abnu")
    uses = [(Expression.of(text, names), "length") for text in texts]
    assert lengths(names, uses) == found


def test_an_angle_is_no_length():
    uses = [(Expression.of("2*a", ["a"]), "angle"), (Expression.of("20", []), "length")]
    assert lengths(["a"], uses) == set()


@pytest.mark.parametrize(
    ("name", "head"),
    [
        ("chebyshev", "BP 20 mm"),
        (
            "pantograph",
            "ratio OB/OA 2, OA 150 mm, AT 100 mm, Mx 180 mm, My 40 mm, crank 25 mm",
        ),
        (
            "drag-link",
            "Dx 30 mm, crank 60 mm, coupler 70 mm, DC 75 mm, DE 90 mm, ∠CDE 40°, rod 260 mm",
        ),
        ("whitworth-ram", "O₄y −0.5 in, crank 1.2 in, arm 0.8 in, rod 3 in, Cy −0.5 in"),
    ],
)
def test_a_title_has_units_and_the_names_of_points(name, head):
    sheet = vad.draw(vad.solve(vad.load(example_path(name))()), panels="position")
    assert ", ".join(map(text_of, parameters(sheet))) == head
