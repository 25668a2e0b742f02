"""How every role looks: against the table beside it, and what a look has to say.

``python -m tests.style.looks`` writes ``looks.txt`` anew; its diff shows a reviewer what became
wider, darker or solid.
"""

from __future__ import annotations

from itertools import zip_longest

import pytest

from tests.style.colours import contrast
from tests.style.looks import TABLE, written
from vad.plan.roles import ROLES
from vad.style import LineStyle, Style, load_style, style_names

every_style = pytest.mark.parametrize("name", style_names())


def ink(style: Style, role: str) -> float:
    """Return how much of the background the line of a role takes away, on its own pixels."""
    look = style.look(role, 0)
    return look.alpha if look.pen else 0.0


def width(style: Style, role: str, row: int | None = 0) -> float:
    pen = style.look(role, row).pen
    assert pen is not None
    return pen.width


def test_roles_look_as_they_looked():
    kept, now = TABLE.read_text(encoding="utf-8").splitlines(), list(written())
    different = [f"is  {a}\nwas {b}" for a, b in zip_longest(now, kept) if a != b]
    assert not different, "\n".join(different[:5])


@every_style
def test_what_is_passing_looks_so(name: str):
    """A construction is dashed and thinner than a result, and faint when it is done.

    A compass arc is too short for dashes: two that cross would not meet in their gaps.
    """
    style = load_style(name)
    for role in ("construction", "construction done", "axis"):
        pen = style.look(role, None).pen
        assert pen is not None and pen.dash, role
    arc = style.look("compass arc", None).pen
    assert arc is not None and not arc.dash
    assert width(style, "compass arc") < width(style, "construction") < width(style, "vector")
    assert width(style, "construction done") < 0.6 * width(style, "construction")
    assert ink(style, "construction done") <= 0.5 < ink(style, "construction")
    assert style.look("pending term", 0).alpha <= 0.5 < style.look("term", 0).alpha
    assert style.look("term", 0).fill == style.look("pending term", 0).fill


@every_style
def test_light_and_tools_let_through_what_lies_beneath(name: str):
    style = load_style(name)
    for role in ROLES:
        if role.endswith("light"):
            assert 0.1 <= style.look(role, 0).alpha <= 0.3, role
            lit = role.removesuffix(" light")
            assert width(style, role, None) > 2.5 * width(style, lit, None), role
    for role in ("set square", "set square edge", "compass leg"):
        assert style.look(role, None).alpha <= 0.6, role


@every_style
def test_letters_stand_out_from_strokes_that_pass_beneath(name: str):
    style = load_style(name)
    for role in ("letter", "tag", "value"):
        under = style.look(role, 0).under
        assert under is not None and under.colour == style.background
        assert under.width >= 0.008
    for role in ("joint", "pivot"):  # bars end beneath them
        assert style.look(role, None).fill == style.background
    for row in range(len(style.inks)):  # letters may stand on a block, and on no rim
        tint = style.look("block", row).fill
        assert tint is not None and contrast(tint, style.text) >= 7.0
        assert contrast(tint, style.background) <= 1.5


def test_in_print_a_dash_is_cleared_of_what_lies_beneath_and_rows_keep_their_lines():
    style = load_style("print")
    assert style.lines[1:] and all(line.dash for line in style.lines[1:])
    assert len({line.dash for line in style.lines}) == len(style.lines)
    for row, line in enumerate(style.lines):
        look = style.look("vector", row)
        assert look.pen is not None
        assert look.pen.width == pytest.approx(ROLES["vector"].width * line.weight)
        assert look.pen.dash == pytest.approx([part * look.pen.width for part in line.dash])
        assert (look.under is not None) == bool(line.dash)
        if look.under:
            assert look.under.colour == style.background
            assert look.under.width >= look.pen.width + 0.002
            assert look.pen.cap == "butt"  # round caps would close the gaps


def test_chalk_has_the_hues_of_paper_row_by_row():
    """A link that is blue on the slide is blue on the board: see the first two rows."""
    for row, (blue, red) in enumerate(((True, False), (False, True))):
        for name in ("paper", "chalk"):
            ink = load_style(name).inks[row]
            r, _, b = (int(ink[i : i + 2], 16) for i in (1, 3, 5))
            assert (b > r, r > b) == (blue, red), (name, row)


@every_style
def test_keys_are_longer_than_the_dash_that_they_show(name: str):
    style = load_style(name)
    for row in range(len(style.lines)):
        pen = style.look("key", row).pen
        assert pen is not None
        assert style.key >= 1.2 * sum(pen.dash)


def test_a_line_without_a_style_of_its_own_is_solid():
    assert LineStyle() == LineStyle(1.0, ())
