"""One calculation, played in four ways: the same bits, and nothing that was not asked for."""

from __future__ import annotations

import importlib.util
import json
import math
import operator
import sys
from collections import Counter
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import vad
from tests.invariants.test_motion import defaults, factors, optional
from tests.kinds import PLANE
from vad.batches.sweep import _result
from vad.kinematics import any_solver, program
from vad.kinematics.any_solver import Evaluation, Result, order_of
from vad.kinematics.compiled import compiled
from vad.kinematics.program import Blocks, Program
from vad.kinematics.recording import OPERATIONS, Tape, function_of, key_of, lines_of
from vad.kinematics.solver import Solver, guide_of, solver_of

llvmlite = pytest.mark.skipif(
    importlib.util.find_spec("llvmlite") is None, reason="llvmlite, the extra 'fast', is missing"
)


def results(mechanism: Any) -> list[Result]:
    """Return all that can be read of a mechanism."""
    motion = vad.solve(mechanism)
    quantities = {
        "link": ("angle", "omega", "alpha"),
        "point": ("position", "velocity", "acceleration"),
        "slide": ("position", "velocity", "acceleration", "coriolis"),
    }
    parts = {"link": motion.links, "point": motion.points, "slide": motion.slides}
    return [
        (kind, name, quantity)
        for kind, names in parts.items()
        for name in names
        for quantity in quantities[kind]
        if quantity != "coriolis" or guide_of(motion.linkage, name)
    ]


def alone(program: Program, *inputs: float) -> tuple[float, ...]:
    """Return the outputs of a program for one pose."""
    uses = Counter(key_of(x) for step in program.steps for x in step.operands)
    uses.update(key_of(x) for x in program.outputs for _ in range(2))
    lines = lines_of(program.steps, uses)
    lines.append(f"return ({''.join(f'{x}, ' for x in program.outputs)})")
    found: tuple[float, ...] = function_of([x.name for x in program.inputs], lines)(*inputs)
    return found


def bits(value: Any) -> bytes:
    """Return the bits of a number, one NaN like another, no zero negative."""
    parts = np.array([np.real(value), np.imag(value)], float)
    return (np.full(2, np.nan) if np.isnan(parts).any() else parts + 0.0).tobytes()


@st.composite
def mechanisms(draw: Any, name: str) -> tuple[Any, dict[str, Any]]:
    """Draw a mechanism and a few poses, most of which close."""
    cls = PLANE[name]
    numbers = {**defaults(cls), **(optional(cls) if draw(st.booleans()) else {})}
    parameters = {key: value * draw(factors) for key, value in numbers.items()}
    mechanism = cls(**parameters, assembly=draw(st.sampled_from(["open", "crossed"])))
    first, second, third = cls.inputs
    places = st.floats(-720, 720) | st.sampled_from([0.0, 30.0, 90.0, 120.0, 180.0, -90.0, 1e17])
    if first == "position":
        places = factors.map(lambda factor: factor * cls.inputs[first])
    inputs = {first: np.array(draw(st.lists(places, min_size=4, max_size=4)))}
    inputs |= {second: draw(st.floats(-10, 10)), third: draw(st.floats(-10, 10))}
    return mechanism, inputs


def direct(mechanism: Any, inputs: tuple[float, ...], result: Result) -> Any:
    """Return a result by the solver's own code, on floats."""
    try:
        evaluation = Evaluation(solver_of(mechanism), inputs)
        evaluation.pose  # noqa: B018  # of a pose that does not close nothing is known
        value = evaluation.solver.evaluate(result, evaluation)
    except vad.AssemblyError:
        return math.nan
    return value if np.isfinite(value) else math.nan


def poses(inputs: dict[str, Any]) -> Iterator[tuple[float, ...]]:
    place, rate, second_rate = inputs.values()
    return ((float(value), rate, second_rate) for value in place)


@pytest.mark.exhaustive(8)
@pytest.mark.parametrize("name", PLANE)
@settings(max_examples=4, deadline=None, suppress_health_check=list(HealthCheck))
@given(data=st.data())
def test_all_ways_give_the_same_bits(name: str, data: Any) -> None:
    mechanism, inputs = data.draw(mechanisms(name))
    many = vad.solve(mechanism, **inputs)
    for result in results(mechanism):
        array = many.read(result)
        for number, pose in enumerate(poses(inputs)):
            wanted = bits(direct(mechanism, pose, result))
            assert bits(array[number]) == wanted, (result, pose)
            single = vad.solve(mechanism, **dict(zip(inputs, pose, strict=True)))
            solver = solver_of(mechanism)
            solver.often = solver.recorded.pose([result])
            try:
                assert bits(single.read(result)) == wanted, (result, pose)
            except vad.VadError:
                assert wanted == bits(math.nan)


@llvmlite
@pytest.mark.parametrize(
    "mechanism",
    [
        vad.FourBar(130.0, ground_angle=20.0),
        vad.GateActuator(),
        vad.Whitworth(rod=200.0),
        vad.HookeJoint(),
        vad.RSSR(),
        vad.SpatialFourBar(),
    ],
    ids=lambda mechanism: mechanism.name,
)
@pytest.mark.parametrize("kind", ["place", "all"])
def test_a_compiled_loop_gives_the_same_bits(mechanism: Any, kind: str, monkeypatch: Any) -> None:
    """Of one result after the other, and of all at once; whatever differs from pose to pose."""
    first, second, third = mechanism.inputs
    places = np.random.default_rng(1).uniform(-400, 400, 20_003)
    places[:20_000:1000] = [4e17, 1e16, 30.0, -180.0, 540.0] * 4
    if first == "position":
        places = 3.0 + places / 400
    rates = np.linspace(-1, 1, places.size) if kind == "all" else 0.5
    inputs = {first: places, second: rates, third: rates}
    last = mechanism.letters[-1]
    letter = last if last in vad.solve(mechanism).points else "C"
    asked = [("point", letter, quantity) for quantity in ("position", "velocity", "acceleration")]
    turning = [x for x in vad.solve(mechanism).links if x not in solver_of(mechanism).bodies]
    asked += [("link", link, "angle") for link in turning[-2:]]
    wanted = [vad.solve(mechanism, **inputs).read(result) for result in asked]
    monkeypatch.setattr(program, "OFTEN", 0)
    found = vad.solve(mechanism, **inputs)
    for result, values in zip(asked, wanted, strict=True):
        assert found.read(result).tobytes() == values.tobytes()
    names = [f"{part}.{quantity}" for _, part, quantity in asked]
    swept = vad.sweep(mechanism, names, **inputs)
    for name, values in zip(names, wanted, strict=True):
        assert swept[name].tobytes() == values.tobytes()
    programs = solver_of(mechanism).recorded._programs.values()
    loops = [loop for each in programs for loop in each._compiled.values()]
    assert len(loops) >= 4
    assert all(loops)


def test_without_a_compiler_numpy_calculates(monkeypatch: Any) -> None:
    mechanism = vad.ScotchYoke(crank=51.0)
    wanted = vad.sweep(mechanism, "yoke.velocity", angle=[1.0, 2.0])
    monkeypatch.setitem(sys.modules, "llvmlite.binding", None)
    monkeypatch.setattr(program, "OFTEN", 0)
    found = vad.sweep(vad.ScotchYoke(crank=51.0), "yoke.velocity", angle=[1.0, 2.0])
    assert found.tobytes() == wanted.tobytes()


# --- only what is asked for -------------------------------------------------------------------


@pytest.mark.parametrize("angle", [60.0, np.array([60.0, 61.0])], ids=["one", "many"])
@pytest.mark.parametrize("orders", [0, 1])
def test_a_position_costs_no_velocity(angle: Any, orders: int, monkeypatch: Any) -> None:
    """Neither when it is recorded, nor when it is played."""
    asked = []
    rates = Solver.rates

    def counted(self: Solver, pose: Any, lower: tuple[Any, ...], value: Any) -> Any:
        asked.append(len(lower) + 1)
        return rates(self, pose, lower, value)

    monkeypatch.setattr(Solver, "rates", counted)
    mechanism = vad.FourBar(coupler=121.0 + orders, rocker=80.0 + np.size(angle))
    for _ in range(any_solver.OFTEN + 2):
        link = vad.solve(mechanism, angle=angle).link("rocker")
        assert np.all(link.omega if orders else link.angle)
    assert set(asked) == set(range(1, orders + 1))


def test_one_pose_runs_only_as_far_as_it_is_asked() -> None:
    """What a result does not need has not been calculated: it is no local variable yet."""
    recorded = solver_of(vad.FourBar()).recorded
    asked = [
        ("point", "C", "position"),
        ("link", "coupler", "omega"),
        ("point", "C", "velocity"),
        ("link", "rocker", "alpha"),
    ]
    function, numbers = recorded.pose(asked)
    assert [numbers[result] for result in asked] == [0, 1, 2, 3]
    names = [{number.name for number in recorded.numbers(order)} for order in range(3)]
    steps = function(60.0, 10.0, 5.0)
    assert next(steps)
    sizes = []
    for result in asked:
        steps.send(numbers[result])
        known = set(steps.gi_frame.f_locals)
        sizes.append(len(known))
        beyond = [number for order in range(order_of(result) + 1, 3) for number in names[order]]
        assert not known.intersection(beyond)
        assert known.intersection(names[order_of(result)])
    assert sizes == sorted(set(sizes))


def test_a_program_has_no_input_beyond_its_order() -> None:
    recorded = solver_of(vad.FourBar()).recorded
    for count, quantity in enumerate(("position", "velocity", "acceleration"), start=1):
        assert len(recorded.program((("point", "C", quantity),)).inputs) == count
    later = recorded.program((("link", "rocker", "omega"),), known=1)
    assert len(later.steps) < len(recorded.program((("link", "rocker", "omega"),)).steps)
    assert "fold" not in {step.operation for step in later.steps}


ALL = vad.MECHANISMS


@pytest.mark.parametrize("name", ALL)
@settings(max_examples=3, deadline=None)
@given(data=st.data())
def test_all_results_at_once_are_those_one_by_one(name: str, data: Any) -> None:
    """Whatever is asked for beside a result, and before it: the same bits."""
    mechanism = ALL[name]()
    listed = vad.solve(mechanism).to_dict()
    names = [
        f"{part}.{quantity}"
        for kind in ("links", "joints", "points", "slides")
        for part, found in listed.get(kind, {}).items()
        for quantity in found
    ]
    asked = data.draw(st.lists(st.sampled_from(names), min_size=1, max_size=6, unique=True))
    first, second, third = mechanism.inputs
    places = mechanism.inputs[first] * np.linspace(-0.5, 3.0, 50)[:, None]
    inputs = {first: places, second: np.array([1.0, -2.5]), third: data.draw(st.floats(-9, 9))}
    swept = vad.sweep(mechanism, asked, **inputs)
    motion = vad.solve(mechanism, **inputs)
    for result in data.draw(st.permutations(asked)):
        alone = vad.sweep(mechanism, result, **inputs)[result]
        read = motion.read(_result(motion, result))
        assert swept[result].tobytes() == alone.tobytes() == np.asarray(read).tobytes(), result


# A player in another language has such a table; here it shares nothing with the program's own.
PLAYED = {
    "fold": lambda x: math.remainder(x, 360.0) + 0.0,
    "add": lambda x, y: x + y,
    "subtract": lambda x, y: x - y,
    "multiply": lambda x, y: x * y,
    "divide": lambda x, y: x / y,
    "negative": lambda x: -x,
    "absolute": abs,
    "minimum": lambda x, y: x if x < y else y,
    "maximum": lambda x, y: x if x > y else y,
    "sqrt": math.sqrt,
    "copysign": math.copysign,
    "arctan2": lambda y, x: float(np.arctan2(y, x)),
    "round": lambda x: float(round(x)),
    "place": int,
    "choose": lambda place, constants: constants[place],
    "less": lambda x, y: x < y,
    "greater": lambda x, y: x > y,
    "equal": lambda x, y: x == y,
    "both": lambda x, y: x and y,
    "either": lambda x, y: x or y,
    "select": lambda condition, rare, usual: rare if condition else usual,
}


@pytest.mark.parametrize("name", ALL)
def test_the_listing_of_a_program_is_played_by_any_reader(name: str) -> None:
    mechanism = ALL[name]()
    motion = vad.solve(mechanism)
    listed = motion.to_dict()
    asked = [
        _result(motion, f"{part}.{quantity}")
        for kind in ("links", "points", "slides")
        for part, found in listed[kind].items()
        for quantity in found
    ]
    text = json.dumps(
        solver_of(mechanism).recorded.program(tuple(asked)).listing(), allow_nan=False
    )
    program = json.loads(text)
    numbers: dict[Any, Any] = dict(zip(program["inputs"], mechanism.inputs.values(), strict=True))

    def value(operand: Any) -> Any:
        if isinstance(operand, str):
            return numbers[operand]
        return math.nan if operand is None else operand

    for result, operation, *operands in program["operations"]:
        numbers[result] = PLAYED[operation](*map(value, operands))
    closes, *found = map(value, program["outputs"])
    assert closes
    wanted = [part for result in asked for part in parts_of(motion.read(result))]
    assert list(map(float.hex, found)) == list(map(float.hex, wanted))


def parts_of(value: Any) -> list[float]:
    if isinstance(value, complex):
        return [value.real, value.imag]
    return list(map(float, np.atleast_1d(value)))


def test_a_program_holds_what_is_asked_for_alone() -> None:
    tape = Tape()
    x, y = tape.input("x"), tape.input("y")
    total, _ = x + y, x / y
    assert [step.operation for step in Program([x, y], [total * total]).steps] == [
        "add",
        "multiply",
    ]


def test_the_same_operation_is_recorded_once() -> None:
    tape = Tape()
    x, y = tape.input("x"), tape.input("y")
    assert x * y + 1.0 is x * y + 1.0
    assert x - -y is x + y
    assert -x * y + 1.0 is 1.0 - x * y


def test_a_recorded_number_decides_nothing() -> None:
    with pytest.raises(TypeError, match="use select"):
        bool(Tape().input("x") > 0.0)


# --- operations -------------------------------------------------------------------------------

SPECIAL = [0.0, 1.0, -1.0, 0.5, -0.5, 30.0, -180.0, 5e-324, 1e-160, -7.25, 1e300, math.nan]
REALS = ["add", "subtract", "multiply", "minimum", "maximum", "copysign", "arctan2"]
REALS += ["less", "greater", "equal"]


@pytest.mark.parametrize("operation", REALS)
def test_an_operation_is_the_same_on_floats_and_on_blocks(operation: str) -> None:
    x, y = (part.ravel() for part in np.meshgrid(SPECIAL, SPECIAL))
    if operation in ("minimum", "maximum"):  # of NaN neither is asked, but what is above it
        asked = ~np.isnan(y if operation == "maximum" else x + y)
        x, y = x[asked], y[asked]
    text, _, on_floats, on_blocks, kind, _ = OPERATIONS[operation]
    out = np.empty(x.size, kind)
    with np.errstate(all="ignore"):
        on_blocks(x, y, out)
    written = function_of(
        ["x", "y"],
        [f"return {text.format('x', 'y')}"],
    )
    for a, b, found in zip(x.tolist(), y.tolist(), out.tolist(), strict=True):
        assert bits(written(a, b)) == bits(on_floats(a, b)) == bits(found)


@pytest.mark.parametrize("operation", ["minimum", "maximum"])
@pytest.mark.parametrize("size", [1, 2, 9, 33])
@pytest.mark.parametrize("pair", [(0.0, -0.0), (-0.0, 0.0)])
def test_of_two_zeros_it_is_the_same_everywhere(operation: str, size: int, pair: Any) -> None:
    one, other = pair
    form = OPERATIONS[operation]
    wanted = function_of(["x", "y"], [f"return {form.text.format('x', 'y')}"])(one, other)
    assert repr(form.on_floats(one, other)) == repr(wanted)
    for y in (np.full(size, other), np.array(other)):
        found = np.full(size, one)
        form.on_blocks(found, y, found)
        assert set(map(repr, found.tolist())) == {repr(wanted)}


@st.composite
def programs(draw: Any) -> Program:
    """Draw a program in which any operation may follow any other one."""
    tape = Tape()
    inputs = [tape.input("x"), tape.input("y")]
    known: list[Any] = [*inputs, 0.0, -0.0, 1.0, 400.0]

    def note(operation: str, *operands: Any) -> None:
        if not all(isinstance(operand, float) for operand in operands):
            known.append(tape.note(operation, *operands))

    for operation in draw(st.lists(st.sampled_from([*ONE, *TWO, "select"]), min_size=3)):
        a, b, c, d = (draw(st.sampled_from(known)) for _ in range(4))
        if operation == "select":
            note("select", tape.note("less", inputs[0], a + b), c, d)
        else:
            note(operation, *((a,) if operation in ONE else (a, b)))
    return Program(inputs, known)


ONE = ["fold", "negative", "absolute", "copy"]
TWO = ["add", "subtract", "multiply", "minimum", "maximum", "copysign", "arctan2"]


@given(program=programs(), x=st.floats(-1e4, 1e4), y=st.sampled_from([0.0, -0.0, 180.0, 2.5]))
def test_blocks_play_any_program_as_one_pose_does(program: Program, x: float, y: float) -> None:
    found = np.empty((len(program.outputs), 3))
    Blocks(program, [True, False]).play([np.array([x, -x, y]), y], list(found))
    for number, place in enumerate((x, -x, y)):
        assert list(map(bits, found[:, number])) == list(map(bits, alone(program, place, y)))


@llvmlite
@settings(max_examples=40, deadline=None)
@given(program=programs(), x=st.floats(-1e4, 1e4), y=st.sampled_from([0.0, -0.0, 180.0, 2.5]))
def test_a_compiled_loop_plays_any_program_as_blocks_do(
    program: Program, x: float, y: float
) -> None:
    """With outputs in arrays of their own, and with the last of them in a table."""
    for columns in (0, 3):
        parts = program.inputs, program.steps, program.outputs, columns
        loop = compiled(*parts, [True, False])
        if not loop:  # it folds what it has calculated itself
            return
        wanted, found = (np.empty((len(program.outputs), 17)) for _ in range(2))
        table = np.empty((17, columns))
        places = np.array([x, -x, y, *range(14)])
        Blocks(program, [True, False]).play([places, y], list(wanted))
        single = len(program.outputs) - columns
        loop.play([places, y], [*found[:single], *table.T], lambda _: None)
        found[single:] = table.T
        assert np.where(found == found, found, math.nan).tobytes() == (
            np.where(wanted == wanted, wanted, math.nan).tobytes()
        )


def test_constants_that_are_equal_are_told_apart() -> None:
    tape = Tape()
    x = tape.input("x")
    outputs = [tape.note("copysign", 2.0, 0.0 * x), tape.note("copysign", 2.0, -0.0 * x)]
    outputs += [tape.note("add", x, -0.0), tape.note("add", x, 0.0), tape.note("copy", x)]
    program = Program([x], outputs)
    found = np.empty((5, 2))
    Blocks(program, [True]).play([np.array([-0.0, 1.0])], list(found))
    wanted = [-2.0, 2.0, -0.0, 0.0, -0.0]
    assert list(map(repr, found[:, 0].tolist())) == list(map(repr, wanted))
    assert list(map(repr, alone(program, -0.0))) == list(map(repr, wanted))


def test_no_zero_of_an_array_is_negative() -> None:
    motion = vad.solve(vad.FourBar(100, 40, 120, 80, ground_angle=-180), angle=[-360.0])
    assert math.copysign(1.0, motion.point("B").acceleration.imag[0]) == 1.0


@pytest.mark.parametrize("size", [1, 1000, 12_288, 12_289, 300_000])
def test_blocks_of_any_length(size: int) -> None:
    tape = Tape()
    x, y = tape.input("x"), tape.input("y")
    outputs = [x * y + 2.0, x, 7.0, abs(x) - y, (x > y) * 3.0]
    values = np.linspace(-3.0, 5.0, size)
    found = [np.empty(size) for _ in outputs]
    Blocks(Program([x, y], outputs), [True, False]).play([values, 1.5], found)
    wanted = [values * 1.5 + 2.0, values, np.full(size, 7.0), abs(values) - 1.5]
    wanted.append(3.0 * (values > 1.5))
    assert all(map(operator.eq, map(bytes, found), map(bytes, wanted)))
