"""What a beginner asks at the board: which crossing, whence ω in rad/s, and what ″ and s mean."""

from __future__ import annotations

import cmath
import re

import pytest

import vad
from tests.kinds import PLANE
from vad.files.examples import example_names, example_path
from vad.strokes.sheet import Arc, Arrow, Dot, Panel, Sheet

#: What each word says of the way from the other crossing to the one that is meant.
WAYS = {"right": 1.0, "left": -1.0, "upper": 1j, "lower": -1j}
EVERY = [*PLANE, *example_names()]


def sheet_of(name: str, **options: str) -> Sheet:
    kind = vad.MECHANISMS.get(name) or vad.load(example_path(name))
    return vad.draw(vad.solve(kind()), **options)


def captions(panel: Panel) -> list[str]:
    return [stroke.caption for stroke in panel.strokes]


@pytest.mark.exhaustive(16)
@pytest.mark.parametrize("name", EVERY)
def test_a_caption_says_which_of_two_crossings_is_meant(name: str) -> None:
    position = sheet_of(name).panel("position")
    arcs: list[Arc] = []
    for stroke in position.strokes:
        if isinstance(stroke.shape, Arc) and stroke.kind == "construction":
            arcs.append(stroke.shape)
        said = re.search(r"is the (\w+ )?crossing of both arcs", stroke.caption)
        if said:
            assert isinstance(stroke.shape, Dot)
            (one, other), at = arcs[-2:], stroke.shape.at
            # The other crossing is as far from both centres.
            line = other.centre - one.centre
            mirrored = one.centre + ((at - one.centre) / line).conjugate() * line
            assert abs(mirrored - other.centre) == pytest.approx(other.radius)
            way = at - mirrored
            if said[1]:
                part = (way / WAYS[said[1].strip()]).real
                assert part > 0.7 * abs(way)
            else:
                assert abs(way) < 0.02 * one.radius
    assert "where both arcs cross." not in " ".join(captions(position))


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("beam-engine", "At 20 rpm, ω₂ = 2π·n/60 = 2.0944 rad/s."),
        ("sewing-machine", "At 900 rpm, ω₂ = 2π·n/60 = 94.2478 rad/s."),
        ("jansen-leg", ""),
    ],
)
def test_a_number_of_turns_becomes_an_angular_velocity_at_the_pole(name: str, said: str) -> None:
    sheet = sheet_of(name)
    pole = captions(sheet.panel("velocity"))[0]
    assert pole.endswith(f"lie here. {said}".rstrip())
    assert "rpm" not in captions(sheet.panel("acceleration"))[0]
    # The next step calculates with the same digits.
    assert not said or said.split()[-2] in captions(sheet.panel("velocity"))[1].replace(
        "(94.2478 rad/s)", "94.2478"
    )


@pytest.mark.exhaustive(16)
@pytest.mark.parametrize("name", EVERY)
def test_the_first_double_prime_is_told_from_the_single_one(name: str) -> None:
    sheet = sheet_of(name)
    for panel in sheet.panels:
        ends = {s.shape.head for s in panel.strokes if isinstance(s.shape, Arrow)}
        pairs = [(each, each.replace("″", "")) for each in ends if "″" in each]
        told = [re.search(r"; ″ tells (\w+″ₙ) from (\w+ₙ)\.$", each) for each in captions(panel)]
        found = [each.groups() for each in told if each]
        assert len(found) == any(one in ends for _, one in pairs)
        assert set(found) <= {pair for pair in pairs if pair[1] in ends}


def test_the_length_of_a_cylinder_is_called_so_and_has_the_ink_of_its_link() -> None:
    for language, title in (("en", "length"), ("de", "Länge"), ("fr", "longueur")):
        sheet = sheet_of("excavator-bucket", language=language)
        link, length = (row for row in sheet.rows if row.letters == "OB")
        assert link.inked
        assert (length.title, length.inked) == (title, False)
    velocity = captions(sheet_of("excavator-bucket").panel("velocity"))
    assert velocity[1].endswith(": given, as if OB did not turn.")


def test_ends_of_both_ways_from_the_pole_are_told() -> None:
    """With its word for the crossing, the assembly of the other branch is told otherwise."""
    usual, crossed = (
        " ".join(captions(vad.draw(vad.solve(vad.FourBar(assembly=each))).panel("position")))
        for each in ("open", "crossed")
    )
    words = [re.findall(r"is the (\w+) crossing", each) for each in (usual, crossed)]
    assert words[0] != words[1]
    assert cmath.isclose(WAYS[words[0][0]], -WAYS[words[1][0]])
