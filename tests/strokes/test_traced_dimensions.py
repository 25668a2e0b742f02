"""A sheet that is drawn once with traced dimensions is that of others, or a guard says no.

The numbers are compared with those of a mechanism that is made, solved and drawn anew.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

import vad
from tests.kinds import SPACE
from tests.strokes.test_traced_sheet import CLOSE, KINDS, numbers, poses
from vad.errors import VadError
from vad.files.loading import WrittenMechanism
from vad.kinematics.any_solver import Evaluation
from vad.kinematics.assemblies import assemblies
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of
from vad.kinematics.program import Program
from vad.mechanisms import Mechanism
from vad.mechanisms.mechanism import length
from vad.strokes.traced_dimensions import AROUND_ZERO, RANGE, sides_of, traced_dimensions
from vad.strokes.traced_sheet import TracedSheet, traced_sheet

CRANK = {"crank": {"angle": 30, "omega": 5}}
ROD = {"crank": {"AB": 40}, "rod": {"BC": 150, "BE": 50, "CBE": 20}}
WRITTEN: dict[str, Mechanism] = {
    "expressions": vad.mechanism(
        dimensions={"a": 60, "b": 80, "w": 35, "h": 8, "p": 0.4},
        fixed={"A": (0, 0), "D": ("hypot(a, b) + sqrt(a*b)/3", "h^2/10")},
        links={
            "crank": {"AB": "a*sin(w)"},
            "coupler": {"BC": "b + abs(h)*cos(w)", "BE": "a/2 + atan2(a, b)", "CBE": "asin(p)"},
            "rocker": {"DC": "b*tan(w) + 10*p^2"},
        },
        driver=CRANK,
        assembly={"C": "upper"},
    )(),
    "guide between points": vad.mechanism(
        fixed={"A": (0, 0), "F": (20, -15), "G": (190, 12)},
        links=ROD,
        guides={"C": {"along": "FG", "offset": 12}},
        driver=CRANK,
    )(),
    "guide through a place": vad.mechanism(
        fixed={"A": (0, 0)},
        links=ROD,
        guides={"C": {"through": [10, 20], "angle": 15}},
        driver=CRANK,
    )(),
    "turned ground": vad.mechanism(
        fixed={"A": (10, 5), "D": {"from": "A", "length": 100, "angle": 10}},
        links={"crank": {"AB": 40}, "coupler": {"BC": 120}, "rocker": {"DC": 80, "CE": 30}},
        driver=CRANK,
        assembly={"C": "upper"},
    )(),
    "slot beside three points": vad.mechanism(
        fixed={"A": (0, 0), "D": (0, -120)},
        links={"crank": {"AB": 50}, "lever": {"DC": 250, "DF": 60, "CDF": 20}},
        guides={"B": {"along": "FC", "offset": 9}},
        driver=CRANK,
    )(),
    "two guides": vad.mechanism(
        fixed={"O": (0, 0)},
        links={"link": {"AB": 100}},
        guides={
            "A": {"through": "O", "angle": 20, "name": "pushed"},
            "B": {"through": "O", "angle": 130},
        },
        driver={"pushed": {"position": 50, "velocity": 20}},
    )(),
}
VARIANTS: dict[str, Mechanism] = {
    **WRITTEN,
    **{name: kind() for name, kind in KINDS.items() if name not in SPACE},
    "crossed four-bar": vad.FourBar(assembly="crossed"),
    "parallelogram": vad.FourBar(100, 40, 100, 40, assembly="parallel"),
    "equal rod": vad.SliderCrank(100, 100),
    "offset": vad.SliderCrank(offset=20),
    "points": vad.SliderCrank(points={"D": ("rod", 100, 12), "E": ("crank", 50, -30)}),
    "lever with ram": vad.CrankSlottedLever(rod=100, ram_height=180),
    "level ram": vad.Whitworth(rod=150),
    "turned whitworth": vad.Whitworth(ground_angle=-100, rod=150, ram_height=30),
    "oblique guides": vad.DoubleSlider(guide_a=20, guide_b=130),
}
#: Those that move between two guides, which must not be one line.
TWO_GUIDES = {"double-slider", "oblique guides", "oblique-yoke", "trammel", "two guides"}
OWN = 3
#: How far a slide travels, and with it the length of a cylinder, is that of the traced pose.
TRAVEL = "cylinder"
#: How many times what the last digit of one dimension changes the numbers may differ.
DIGITS = 4.0

Values = Mapping[str, float]


def sets_of(mechanism: Mechanism, count: int) -> list[dict[str, float]]:
    """Return inputs, dimensions over the range of sliders, and factors of loops.

    The first have the own dimensions; of the others every second is assembled at random.
    """
    rng, own = np.random.default_rng(3), mechanism.dimensions()
    aside = AROUND_ZERO * max(map(abs, own.values()))
    places = poses(mechanism, 1)
    sets = []
    for number in range(OWN + count):
        values = dict(own)
        if number >= OWN:
            for name, value in own.items():
                values[name] = rng.uniform(*RANGE) * value or rng.uniform(-aside, aside)
        way = rng.integers(len(assemblies(mechanism))) if number % 2 and number >= OWN else 0
        sides = {name: factors[way] for name, factors in sides_of(mechanism).items()}
        sets.append({**places[number % len(places)], **values, **sides})
    return sets


def assembly(mechanism: Mechanism, values: Values) -> Any:
    """Return what the assembly is called in which the loops have these factors."""
    sides = sides_of(mechanism)
    for way, *factors in zip(assemblies(mechanism), *sides.values(), strict=True):
        if factors == [values[name] for name in sides]:
            return mechanism.assembly if way.name is None else way.name
    raise ValueError(f"there is no such assembly of {mechanism.name}")


def drawn(mechanism: Mechanism, values: Values) -> dict[tuple[Any, ...], float] | None:
    """Return the numbers of a mechanism with these dimensions; None if it cannot be drawn."""
    points = {
        name: (link, values.get(f"{name}.distance", at), values.get(f"{name}.angle", angle))
        for name, (link, at, angle) in dict[str, Any](mechanism.points).items()
    }
    given: dict[str, Any] = {name: values[name] for name in mechanism.parameters()}
    given |= {"assembly": assembly(mechanism, values)} | ({"points": points} if points else {})
    inputs = {name: values[name] for name in mechanism.inputs}
    try:
        return dict(numbers(vad.draw(vad.solve(type(mechanism)(**given), **inputs))))
    except VadError:
        return None


def played(
    traced: TracedSheet, sets: Sequence[Values]
) -> list[dict[tuple[Any, ...], float] | None]:
    """Return the numbers of a traced sheet for each set; None where a guard says no."""
    found = dict(numbers(traced.sheet))
    program = traced.program(found.values())
    sides = dict.fromkeys([name for name in traced.inputs if name.startswith("side ")], 1.0)
    given = [np.array([{**sides, **values}[name] for values in sets]) for name in traced.inputs]
    outputs = program.many(given, len(sets))
    holds = np.ones(len(sets), bool)
    for guard, column in zip(traced.guards, outputs, strict=False):
        holds &= column == guard.value
    rows = np.array(outputs[len(traced.guards) :]).T
    return [
        dict(zip(found, map(float, row), strict=True)) if held else None
        for row, held in zip(rows, holds, strict=True)
    ]


def farthest(found: Mapping[Any, float], wanted: Mapping[Any, float]) -> float:
    """Return the largest difference, as a share of the largest number of its panel."""
    largest: dict[str, float] = {}
    for key, value in wanted.items():
        largest[key[0]] = max(largest.get(key[0], 1.0), abs(value))
    differences = [
        abs(found[key] - value) / largest[key[0]]
        for key, value in wanted.items()
        if key in found and TRAVEL not in key
    ]
    assert all(difference == difference for difference in differences)
    return max(differences)


def condition(mechanism: Mechanism, values: Values) -> float:
    """Return how far the right numbers move if the last digit of one dimension changes."""
    wanted, moved = drawn(mechanism, values), 0.0
    assert wanted
    for name, value in values.items():
        other = drawn(mechanism, {**values, name: math.nextafter(value, math.inf)})
        if other:
            moved = max(moved, farthest(other, wanted))
    return moved


@pytest.mark.exhaustive(16)
@pytest.mark.parametrize("name", VARIANTS)
def test_every_dimension_is_an_input_without_a_guard(name: str) -> None:
    """It is one only if sixty sets of dimensions are solved right.

    Two guides are to be two lines.  Only a file may have numbers without a sign, and then a length
    that is not positive.
    """
    mechanism = VARIANTS[name]
    names = tuple(mechanism.dimensions())
    traced = traced_dimensions(mechanism, poses(mechanism, 1)[0], names)
    alone = ("ground_angle",)  # the sides of a parallelogram change together
    kept = alone if name == "parallelogram" else names
    assert tuple(traced.sizes) == (*kept, *sides_of(mechanism))
    assert bool(traced.lasting) == (name in TWO_GUIDES)
    assert len(traced.guards) == traced.lasting or isinstance(mechanism, WrittenMechanism)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", VARIANTS)
def test_one_sheet_is_that_of_other_dimensions(name: str, exhaustive: bool) -> None:
    mechanism = VARIANTS[name]
    sets = sets_of(mechanism, 300 if exhaustive else 12)
    names = tuple(mechanism.dimensions())
    traced = traced_sheet(mechanism, poses(mechanism, 1)[0], dimensions=names)
    if name == "parallelogram":
        own = mechanism.dimensions() | {"ground_angle": 0.0}
        sets = [{**values, **own, "ground_angle": values["ground_angle"]} for values in sets]
    right = 0
    for number, (values, found) in enumerate(zip(sets, played(traced, sets), strict=True)):
        wanted = drawn(mechanism, values)
        if wanted is None:
            assert found is None or any(value != value for value in found.values())
            continue
        assert found
        # The corners of a plate come in an order that depends on its shape.
        assert all(str(key[1]).endswith(".plate") for key in wanted.keys() - found.keys())
        assert number >= OWN or wanted.keys() <= found.keys()
        difference = farthest(found, wanted)
        assert difference <= CLOSE or difference <= DIGITS * condition(mechanism, values), values
        right += 1
    assert right > len(sets) / 4


@pytest.mark.parametrize("name", ["oblique guides", "two guides"])
def test_guides_stay_on_two_lines(name: str) -> None:
    mechanism = VARIANTS[name]
    guide = next(each for each, value in mechanism.dimensions().items() if value == 130.0)
    traced = traced_sheet(mechanism, mechanism.inputs, dimensions=[guide])
    own = {**mechanism.inputs, **mechanism.dimensions(), **dict.fromkeys(sides_of(mechanism), 1.0)}
    sets = [{**own, guide: angle} for angle in (130.0, 200.0, 201.0, 20.0, 21.0)]
    found = [bool(sheet) for sheet in played(traced, sets)]
    assert found == [True, False, True, False, True]
    assert found == [drawn(mechanism, values) is not None for values in sets]


@pytest.mark.parametrize("lengths", [(100, 40, 100, 40), (100, 40, 40, 100), (50, 90, 90, 50)])
def test_links_that_are_equal_may_become_different(lengths: tuple[float, ...]) -> None:
    """A parallelogram or a kite is solved in a way of its own, and traced as any other four-bar."""
    mechanism = vad.FourBar(*lengths)
    sets = sets_of(mechanism, 30)
    traced = traced_dimensions(mechanism, poses(mechanism, 1)[0], tuple(mechanism.dimensions()))
    assert not traced.guards
    solver, given = traced.solver, {**traced.inputs, **traced.sizes}
    evaluation = Evaluation(solver, tuple(traced.inputs.values()))
    rates = [solver.evaluate(("link", "rocker", name), evaluation) for name in ("omega", "alpha")]
    place = solver.evaluate(("point", "C", "position"), evaluation)
    made: list[Any] = [number.made for number in given.values()]
    program = Program(made, [number.made for number in (place.real, place.imag, *rates)], 4)
    columns = [np.array([values[name] for values in sets]) for name in given]
    right = 0
    for values, *found in zip(sets, *program.many(columns, len(sets)), strict=True):
        sizes = {name: values[name] for name in mechanism.dimensions()}
        other = vad.FourBar(**sizes, assembly=assembly(mechanism, values))
        motion = vad.solve(other, **{name: values[name] for name in mechanism.inputs})
        if not motion.assembled:
            assert all(value != value for value in found)
            continue
        at, rocker = motion.point("C").position, motion.link("rocker")
        wanted = (at.real, at.imag, rocker.omega, rocker.alpha)
        for value, each, size in zip(found, wanted, (100.0, 100.0, 10.0, 300.0), strict=True):
            assert abs(value - each) <= CLOSE * max(size, abs(each))
        right += 1
    assert right > 10


def test_a_point_leaves_the_line_of_its_link() -> None:
    """At an angle of exactly zero nothing is turned: the record holds beyond it, too."""
    mechanism = vad.SliderCrank(points={"D": ("rod", 100)})
    inputs = {"angle": 40.0, "omega": 3.0, "alpha": 5.0}
    traced = traced_sheet(mechanism, inputs, dimensions=["D.distance", "D.angle"])
    values = {**inputs, "D.distance": 90.0, "D.angle": 25.0}
    (found,) = played(traced, [values])
    assert found
    motion = vad.solve(vad.SliderCrank(points={"D": ("rod", 90, 25)}), **inputs)
    for panel, stroke in (("position", "BD.bar"), ("velocity", "D.image")):
        end = complex(*(found[panel, stroke, "end", 0, axis] for axis in "xy"))
        right = getattr(motion.point("D"), panel)
        assert abs(end - right) <= CLOSE * abs(right)


@dataclass(frozen=True)
class _Mixed(Mechanism, listed=False):
    """A slider-crank of which the code makes a constant of one dimension, and reverses another."""

    name = "mixed"
    title = "Mixed"
    letters = "ABC"
    links: ClassVar[dict[str, str]] = {"crank": "AB", "rod": "BC"}
    slides: ClassVar[dict[str, str]] = {"slider": "C"}

    square: float = length(3600.0, "the square of AB")
    rod: float = length(140.0, "length of BC")
    height: float = length(30.0, "twice the height of the guide up to 35, then its negative")

    def linkage(self) -> Linkage:
        """Return the loop of a slider-crank."""
        height = self.height / 2.0 if self.height < 35.0 else -self.height / 2.0
        crank = Bar("AB", "crank", math.sqrt(self.square))
        guide = Slide("DC", "slider", 0.0, origin=height * 1j)
        return Linkage(angle_of("crank"), (Loop((crank, Bar("BC", "rod", self.rod)), (guide,)),))


def test_a_dimension_of_which_code_makes_a_constant_is_no_input() -> None:
    inputs = {"angle": 40.0, "omega": 3.0, "alpha": 5.0}
    traced = traced_sheet(_Mixed(), inputs, dimensions=["square", "rod", "height"])
    assert list(traced.inputs) == [*inputs, "rod", "height", "side 0"]


def test_a_guard_tells_where_the_record_ends() -> None:
    inputs = {"angle": 40.0, "omega": 3.0, "alpha": 5.0}
    traced = traced_sheet(_Mixed(), inputs, dimensions=["rod", "height"])
    assert len(traced.guards) == 1
    sets = [{**inputs, "rod": 120.0, "height": height} for height in (10.0, 34.9, 35.1, 44.0)]
    assert [bool(found) for found in played(traced, sets)] == [True, True, False, False]


def test_a_length_that_an_expression_makes_negative_is_behind_a_guard() -> None:
    mechanism = vad.mechanism(
        dimensions={"a": 60, "b": 25},
        fixed={"A": (0, 0)},
        links={"crank": {"AB": "a - b"}, "rod": {"BC": 150}},
        guides={"C": {"y": 0}},
        driver=CRANK,
    )()
    inputs = {"angle": 40.0, "omega": 3.0, "alpha": 5.0}
    traced = traced_sheet(mechanism, inputs, dimensions=["a", "b"])
    assert len(traced.guards) == 1  # later decisions that say the same are left out
    sets = [{**inputs, "a": 60.0, "b": b} for b in (-40.0, 25.0, 59.0, 61.0, 90.0)]
    assert [bool(found) for found in played(traced, sets)] == [True, True, True, False, False]


def test_the_sheet_differs_from_that_of_the_mechanism_in_last_digits_alone() -> None:
    """The sheet is drawn with dimensions that differ in their last digits alone."""
    mechanism = vad.FourBar()
    pose = {"angle": 40.0, "omega": 3.0, "alpha": 5.0}
    traced = traced_sheet(mechanism, pose, dimensions=tuple(mechanism.dimensions()))
    found, own = dict(numbers(traced.sheet)), dict(numbers(vad.draw(vad.solve(mechanism, **pose))))
    assert found.keys() == own.keys()
    assert 0.0 < farthest(found, own) < 1e-9
