"""A sheet of a mechanism in space that is drawn once with traced dimensions is that of others.

Where its views stand is chosen for the traced dimensions; they move apart as the lengths grow.  So
mechanisms that are drawn anew have their views there, too.
"""

from __future__ import annotations

from typing import Any

import pytest

import vad
from tests.kinds import SPACE
from tests.strokes.test_traced_dimensions import (
    DIGITS,
    OWN,
    condition,
    drawn,
    farthest,
    played,
    sets_of,
)
from tests.strokes.test_traced_sheet import CLOSE, numbers, poses
from vad.mechanisms import Mechanism
from vad.strokes.scripts import rssr, spatial_four_bar
from vad.strokes.space import bodies
from vad.strokes.space.layout import Corners, Layout
from vad.strokes.traced_dimensions import sides_of, traced_dimensions
from vad.strokes.traced_sheet import traced_sheet

VARIANTS: dict[str, Mechanism] = {
    **{name: vad.MECHANISMS[name]() for name in SPACE},
    "crossed spherical four-bar": vad.SphericalFourBar(assembly="crossed"),
    "crossed rssr": vad.RSSR(ground=130, assembly="crossed"),
    "nearly coaxial rssr": vad.RSSR(
        5, 100, 80, 110, ground_twist=2, crank_offset=9, rocker_offset=4
    ),
    "short crank": vad.SphericalFourBar(crank=12),
    "double crank": vad.SphericalFourBar(ground=25, crank=80, coupler=60, rocker=75),
    "crossed spatial four-bar": vad.SpatialFourBar(assembly="crossed"),
}
LENGTHS = ("ground", "crank", "coupler", "rocker", "crank_offset", "rocker_offset")
#: The path of C is drawn as far as the rocker reaches: an arc that goes on to C itself.
PATH = ("position", "C.path")


def length(mechanism: Mechanism) -> float:
    """Return the sum of all lengths."""
    return sum(abs(x) for name, x in mechanism.parameters().items() if name in LENGTHS)


@pytest.fixture
def kept_views(monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest) -> Mechanism:
    """Return a mechanism; views stand as its own do, farther apart where lengths are larger.

    Planes are rotated to the same side.
    """
    own: Mechanism = VARIANTS[request.param]

    def grown(mechanism: Mechanism) -> float:
        return length(mechanism) / length(own)

    if isinstance(own, vad.RSSR):
        (drop, aside), swing = rssr._layout(own)
        monkeypatch.setattr(
            rssr,
            "_layout",
            lambda other: (Layout(grown(other) * drop, grown(other) * aside), swing),
        )
    if isinstance(own, vad.SpatialFourBar):
        low, high = spatial_four_bar._reach(own)
        monkeypatch.setattr(
            spatial_four_bar,
            "_reach",
            lambda other: Corners(grown(other) * low, grown(other) * high),
        )
    if isinstance(own, vad.SphericalFourBar | vad.HookeJoint):
        side = bodies._side(own)
        monkeypatch.setattr(bodies, "_side", lambda other: side)
    return own


@pytest.mark.parametrize("name", VARIANTS)
def test_every_dimension_is_an_input(name: str) -> None:
    """The only guard says that axes that have an angle between them are apart."""
    mechanism = VARIANTS[name]
    traced = traced_dimensions(mechanism, poses(mechanism, 1)[0], tuple(mechanism.dimensions()))
    assert tuple(traced.sizes) == (*mechanism.dimensions(), *sides_of(mechanism))
    assert len(traced.guards) == (0 if isinstance(mechanism, vad.RSSR) else 1)


@pytest.mark.exhaustive
@pytest.mark.parametrize("kept_views", VARIANTS, indirect=True)
def test_one_sheet_is_that_of_other_dimensions(kept_views: Mechanism, exhaustive: bool) -> None:
    mechanism = kept_views
    sets = sets_of(mechanism, 300 if exhaustive else 30)
    names = tuple(mechanism.dimensions())
    traced = traced_sheet(mechanism, poses(mechanism, 1)[0], dimensions=names)
    right = 0
    for number, (values, found) in enumerate(zip(sets, played(traced, sets), strict=True)):
        wanted = drawn(mechanism, values)
        if wanted is None:
            assert found is None or any(value != value for value in found.values())
            continue
        assert found
        assert number >= OWN or wanted.keys() <= found.keys()
        wanted = {key: value for key, value in wanted.items() if key[:2] != PATH}
        difference = farthest(found, wanted)
        assert difference <= CLOSE or difference <= DIGITS * condition(mechanism, values), values
        right += 1
    assert right > len(sets) / 4


def test_the_path_of_c_goes_on_to_c() -> None:
    mechanism = vad.RSSR()
    sets = sets_of(mechanism, 30)
    traced = traced_sheet(mechanism, poses(mechanism, 1)[0], dimensions=("crank", "rocker"))
    beyond = 0
    own = float(dict(numbers(traced.sheet))["position", "C.path", "sweep", 0])
    for found in played(traced, sets):
        if not found or any(value != value for value in found.values()):
            continue
        start, sweep = (found["position", "C.path", name, 0] for name in ("start", "sweep"))
        (at,) = [value for key, value in found.items() if key[:3] == ("row", "rocker", "position")]
        assert (at - start) % 360.0 <= sweep <= 360.0
        beyond += sweep > own + 1.0
    assert beyond > 3


@pytest.mark.parametrize(
    ("name", "dimension", "wrong"),
    [
        ("hooke-joint", "shaft_angle", 90.5),
        ("hooke-joint", "shaft_angle", -91.0),
        ("spherical-four-bar", "rocker", 181.0),
        ("spatial-four-bar", "crank_twist", -1.0),
    ],
)
def test_axes_that_are_not_apart_are_behind_a_guard(
    name: str, dimension: str, wrong: float
) -> None:
    mechanism: Any = VARIANTS[name]
    first = poses(mechanism, 1)[0]
    traced = traced_sheet(mechanism, first, dimensions=tuple(mechanism.dimensions()))
    values = {**first, **mechanism.dimensions()}
    right, refused = played(traced, [values, {**values, dimension: wrong}])
    assert right
    assert refused is None
