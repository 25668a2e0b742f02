"""The recorded calculation in a real browser: the bits of Python, but for the arc tangent."""

from __future__ import annotations

import json
import math
import random
from base64 import b64decode, b64encode
from collections.abc import Iterator
from hashlib import sha256
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from numpy.typing import NDArray

import vad
from tests.browser import opened
from tests.kinds import PLANE
from tests.kinematics.test_played import PLAYED, SPECIAL
from tests.page.lessons import PARTS
from vad.batches.sweep import _result
from vad.files.examples import example_names, example_path
from vad.kinematics.any_solver import Result, order_of
from vad.kinematics.linkage import Linkage
from vad.kinematics.program import Program
from vad.kinematics.reach import closing_range
from vad.kinematics.recording import Operand, Recorded, Tape, kind_of
from vad.kinematics.refined import is_refined
from vad.kinematics.solver import solver_of
from vad.page.document import asset
from vad.page.solver import solver_data

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

Array = NDArray[np.float64]

MECHANISMS = {name: (kind, {}) for name, kind in vad.MECHANISMS.items()}
MECHANISMS |= {f"{name} crossed": (kind, {"assembly": "crossed"}) for name, kind in PLANE.items()}
MECHANISMS |= {f"{name} whole": (vad.MECHANISMS[name], PARTS[name]) for name in PARTS}
MECHANISMS |= {
    "parallelogram": (
        vad.FourBar,
        {"crank": 60, "coupler": 100, "rocker": 60, "assembly": "parallel"},
    ),
    "antiparallelogram": (vad.FourBar, {"crank": 60, "coupler": 100, "rocker": 60}),
    "turned": (vad.FourBar, {"ground_angle": -180}),
    "aslant": (vad.Whitworth, {"ground_angle": 37.3, "rod": 200}),
    "skew": (vad.RSSR, {"ground": 130, "assembly": "crossed"}),
}
CASES = [*MECHANISMS, *(f"{name}.toml" for name in example_names())]

# What the page does: it plays a table of poses, whose numbers come and go as they are in memory.
PLAYER = """
const bytes = (text) => Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));
const text = (floats) => {
  const all = new Uint8Array(floats.buffer);
  let signs = "";
  for (let i = 0; i < all.length; i += 9999)
    signs += String.fromCharCode(...all.subarray(i, i + 9999));
  return btoa(signs);
};
window.play = (number, given, width, columns, upto) => {
  const table = new Float64Array(bytes(given).buffer), size = table.length / width;
  const found = new Float64Array(size * columns), out = new Float64Array(columns);
  for (let i = 0; i < size; i++) {
    out.fill(-77);
    solvers[number](...table.subarray(i * width, (i + 1) * width), out, upto);
    found.set(out, i * columns);
  }
  return text(found);
};
"""
UNTOUCHED = -77.0


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    """Return an empty page for all tests of this module."""
    with opened(browser) as empty:
        yield empty


def script(program: Program, fixed: int = 0) -> str:
    return json.dumps(solver_data(program, fixed), separators=(",", ":"))


def load(page: Page, *programs: str) -> None:
    """Open a page with programs, under the policy of a lesson."""
    played = f"const solvers = [{','.join(programs)}].map(solver);"
    script = f"{asset('solver.js')}\n{played}{PLAYER}"
    proof = b64encode(sha256(script.encode()).digest()).decode()
    policy = f"default-src 'none'; script-src 'sha256-{proof}'"
    page.goto("about:blank")
    page.set_content(
        f'<!DOCTYPE html><meta http-equiv="Content-Security-Policy" content="{policy}">'
        f'<script type="module">{script}</script>'
    )


def play(page: Page, program: Program, table: Array, upto: int = 2, number: int = 0) -> Array:
    """Return the outputs of a function of the page as columns, for inputs as columns."""
    given = b64encode(np.ascontiguousarray(table).tobytes()).decode()
    columns = len(program.outputs)
    found = page.evaluate("all => play(...all)", [number, given, table.shape[1], columns, upto])
    return np.frombuffer(b64decode(found)).reshape(len(table), columns).copy()


def mechanism(case: str) -> Any:
    """Return a mechanism by its name here."""
    if case.endswith(".toml"):
        return vad.load(example_path(case.removesuffix(".toml")))()
    kind, parameters = MECHANISMS[case]
    return kind(**parameters)


def results(mechanism: Any) -> list[Result]:
    """Return all that can be read of a mechanism."""
    motion = vad.solve(mechanism)
    listed = motion.to_dict()
    return [
        _result(motion, f"{part}.{quantity}")
        for kind in ("links", "joints", "points", "slides")
        for part, found in listed.get(kind, {}).items()
        for quantity in found
    ]


def poses(mechanism: Any, size: int) -> Array:
    """Return poses: half of them usual, the others at the limits, at dead centres and beyond."""
    rng = np.random.default_rng(size)
    solver = solver_of(mechanism)
    place = next(iter(mechanism.inputs))
    ends = np.array([end for ends in closing_range(mechanism) for end in ends] + [0.0])
    ends = np.concatenate([ends, solver.limits()])
    near = ends[:, None] * (1.0 + np.array([-1e-9, -(2.0**-52), 0.0, 2.0**-52, 1e-9]))
    if place == "angle":
        usual = rng.uniform(-400.0, 800.0, size)
        whole = np.arange(-1080.0, 1081.0, 15.0)
        half = 180.0 * (2.0 * rng.integers(-(2**44), 2**44, 40) + 1.0)
        rare = [whole, whole + 1e-13, half, half * 2.0**9, 10.0 ** rng.uniform(14.0, 300.0, 40)]
    else:
        low, high = ends.min(), ends.max()
        usual = rng.uniform(low - 0.2 * (high - low), high + 0.2 * (high - low), size)
        rare = [10.0 ** rng.uniform(-300.0, 300.0, 80)]
    rare = np.concatenate([near.ravel(), *rare, [0.0, -0.0, 5e-324, -1e-300]])
    rare = rare * rng.choice([1.0, 1.0, -1.0], rare.size)
    table = np.empty((size, 3))
    table[:, 0] = usual
    table[1::2, 0] = rng.choice(rare, size // 2, replace=size // 2 > rare.size)
    table[:, 1:] = rng.uniform(-30.0, 30.0, (size, 2))
    extreme = np.array([0.0, -0.0, 1.0, 5e-324, 1e-200, -1e160, 1e300])
    table[::5, 1:] = rng.choice(extreme, table[::5, 1:].shape)
    return table


def played(program: Program, table: Array) -> Array:
    """Return what numpy finds, as columns."""
    return np.stack(np.broadcast_arrays(*program.many([*table.T], len(table))), 1).astype(float)


def differ(found: Array, wanted: Array) -> NDArray[np.bool_]:
    """Tell which numbers have other bits; one NaN is like another."""
    same = (found == wanted) & (np.signbit(found) == np.signbit(wanted))
    return ~(same | (np.isnan(found) & np.isnan(wanted)))


def calculation(case: str) -> tuple[Program, list[int]]:
    """Return the program of all results of a mechanism, and of each output its order."""
    asked = mechanism(case)
    recorded, listed = solver_of(asked).recorded, results(asked)
    orders = [order_of(result) for result in listed for _ in recorded.parts(result)]
    return recorded.program(tuple(listed)), [0, *orders]


@pytest.mark.exhaustive(16)
@pytest.mark.parametrize("case", CASES)
def test_a_browser_finds_the_bits_of_python(case: str, page: Page, exhaustive: Any) -> None:
    """The arc tangents may differ in the last place; with them, all other numbers are Python's."""
    program, _ = calculation(case)
    arcs = [step for step in program.steps if step.operation == "arctan2"]
    table = poses(mechanism(case), 10_000 if exhaustive else 300)
    whole = Program(program.inputs, [*program.outputs, *arcs])
    load(page, script(whole), script(program))
    found = play(page, whole, table[:, : len(program.inputs)])
    shipped = play(page, program, table[:, : len(program.inputs)], number=1)
    width = len(program.outputs)
    assert not differ(shipped, found[:, :width]).any()
    own = found[:, width:]
    arc = played(Program(program.inputs, arcs), table) if arcs else own
    exists = ~np.isnan(arc)
    assert np.array_equal(~np.isnan(own), exists)
    assert np.array_equal(np.signbit(own[exists]), np.signbit(arc[exists]))
    assert (np.abs(own - arc) <= np.spacing(np.abs(arc)))[exists].all()
    after = Program([*program.inputs, *arcs], program.outputs)
    wanted = played(after, np.hstack([table, own]))
    for name, wrong in zip(range(width), differ(shipped, wanted).T, strict=True):
        assert not wrong.any(), (name, table[wrong][0])


@pytest.mark.exhaustive
@pytest.mark.parametrize("case", CASES)
def test_a_stage_finds_all_of_its_order_and_nothing_beyond(case: str, page: Page) -> None:
    program, orders = calculation(case)
    table = poses(mechanism(case), 20)
    load(page, script(program))
    whole = play(page, program, table)
    assert not (whole == UNTOUCHED).any()
    for upto in (0, 1):
        found = play(page, program, table, upto)
        left = (found == UNTOUCHED).all(axis=0)
        assert not differ(found[:, ~left], whole[:, ~left]).any()
        assert left.sum() > 3
        assert all(order > upto for order, each in zip(orders, left, strict=True) if each)


def test_a_function_is_short() -> None:
    """A page of 140 kB is to hold it beside all else.

    Those of linkages with three loops or more are the longest: their places have twice the digits.
    """
    lengths: dict[bool, list[int]] = {False: [], True: []}
    for case in CASES:
        linkage = mechanism(case).marked()
        refined = isinstance(linkage, Linkage) and is_refined(linkage)
        lengths[refined].append(len(script(calculation(case)[0])))
    assert 2000 < max(lengths[False]) < 5000
    assert 5000 < max(lengths[True]) < 8500


# --- operations -------------------------------------------------------------------------------


def divided(x: float, y: float) -> float:
    with np.errstate(all="ignore"):
        return float(np.divide(x, y))


# On floats, where Python's own text refuses what has no result.
OPERATIONS = {
    **PLAYED,
    "fold": lambda x: math.remainder(x, 360.0) + 0.0 if math.isfinite(x) else math.nan,
    "copy": float,
    # A browser gives no sign to what is no number.
    "copysign": lambda x, y: math.copysign(x, y) if y == y else abs(x),
    "divide": divided,
    "sqrt": lambda x: math.sqrt(x) if x >= 0.0 else math.nan,
    "round": lambda x: 1.0 if x > 0.5 else -1.0 if x < -0.5 else 0.0,
    "place": lambda x: x,
    "choose": lambda x, of: of[0] if x < 0.5 else of[2] if x > 1.5 else of[1],
}
TRUTHS = ["less", "greater", "equal", "both", "either"]


def value_of(program: Program, given: Array) -> list[float]:
    """Return the outputs for one pose, operation by operation."""
    numbers: dict[str, Any] = {
        each.name: value for each, value in zip(program.inputs, given.tolist(), strict=True)
    }

    def value(operand: Operand) -> Any:
        return numbers[operand.name] if isinstance(operand, Recorded) else operand

    for step in program.steps:
        numbers[step.name] = OPERATIONS[step.operation](*map(value, step.operands))
    return [float(value(output)) for output in program.outputs]


def drawn(rng: random.Random) -> Program:
    """Draw a program in which any operation may follow any other one; its last input is fixed."""
    tape = Tape()
    inputs = [tape.input(name) for name in ("place", "rate", "length")]
    known: list[Operand] = [*inputs, 0.0, -0.0, 1.0, -0.5, -1.0 / 3.0, 400.0]
    truths: list[Operand] = []
    for _ in range(rng.randrange(5, 60)):
        operation = rng.choice([name for name in OPERATIONS if name != "arctan2"])
        a, b = rng.choice(known[-12:]), rng.choice(known)
        operands = {
            "choose": (a, (2.5, -7.0, 1.0)),
            "both": rng.choices(truths, k=2) if truths else None,
            "either": rng.choices(truths, k=2) if truths else None,
            "select": (rng.choice(truths), a, b) if truths else None,
            "multiply": (rng.choice([a, *truths]), b),
        }.get(operation, (a,) if operation in ONE else (a, b))
        if operands and any(isinstance(operand, Recorded) for operand in operands):
            number = tape.note(operation, *operands)
            (truths if kind_of(number) is bool else known).append(number)
    outputs = rng.sample([*known, *truths], rng.randrange(1, len(known)))
    return Program(inputs, [*outputs, known[-1], known[-1], *truths[-1:]])


ONE = ["fold", "negative", "absolute", "copy", "sqrt", "round", "place"]


def test_any_operation_may_stand_in_any_other(page: Page) -> None:
    rng = random.Random(1)
    programs = [drawn(rng) for _ in range(300)]
    load(page, *(script(program, fixed=1) for program in programs))
    signs = np.array([[x, y, 2.0] for x in (-200.5, -0.0, 0.3, 1e17) for y in (-3.0, 0.0, 180.0)])
    for number, program in enumerate(programs):
        found = play(page, program, signs, number=number)
        wanted = np.array([value_of(program, pose) for pose in signs])
        assert not differ(found, wanted).any(), script(program, fixed=1)


def test_each_operation_of_special_numbers(page: Page) -> None:
    """Of zeros, of what is no number, of the least and the largest."""
    tape = Tape()
    x, y = tape.input("x"), tape.input("y")
    truth = tape.note("less", x, y)
    operands = {"choose": (x, (1.0, 2.0, 3.0)), "both": (truth, truth), "either": (truth, truth)}
    operands["select"] = (truth, x, y)
    names = list(OPERATIONS)
    outputs = [
        tape.note(name, *operands.get(name, (x,) if name in ONE else (x, y))) for name in names
    ]
    program = Program([x, y], outputs)
    load(page, script(program))
    table = np.array([(a, b) for a in SPECIAL for b in SPECIAL])
    found = play(page, program, table)
    wanted = np.array([value_of(program, pose) for pose in table])
    arc = names.index("arctan2")
    assert np.abs(found[:, arc] - wanted[:, arc])[~np.isnan(wanted[:, arc])].max() < 1e-15
    found[:, arc] = wanted[:, arc]
    wrong = differ(found, wanted)
    assert not wrong.any(), [(names[place], table[pose]) for pose, place in np.argwhere(wrong)]


def test_angles_are_folded_as_by_ieee_754(page: Page) -> None:
    rng = np.random.default_rng(7)
    halves = 180.0 * rng.integers(-(2**45), 2**45, 5000)
    angles = np.concatenate(
        [
            halves * 2.0 ** rng.integers(0, 60, halves.size),
            np.nextafter(halves, np.inf),
            np.nextafter(halves, -np.inf),
            10.0 ** rng.uniform(-320.0, 308.0, 5000) * rng.choice([-1.0, 1.0], 5000),
            90.0 * np.arange(-20.0, 21.0),
            [-0.0, 5e-324, -5e-324, 1.7976931348623157e308],
        ]
    )
    tape = Tape()
    x = tape.input("x")
    program = Program([x], [tape.note("fold", x)])
    load(page, script(program))
    found = play(page, program, angles[:, None])[:, 0]
    wanted = np.array([math.remainder(angle, 360.0) + 0.0 for angle in angles])
    assert not differ(found, wanted).any()


def test_a_constant_keeps_all_its_bits(page: Page) -> None:
    rng = np.random.default_rng(3)
    plain = [0.0, -0.0, 0.5, -0.05, 100.0, 1234000.0, 1e21, 123e-7, 5e-324, math.nan, -math.inf]
    drawn = rng.integers(-(2**63), 2**63 - 1, 500).view(np.float64)
    constants = [*plain, *drawn[np.isfinite(drawn)].tolist(), *rng.uniform(-9, 9, 100).tolist()]
    constants += [float(f"{x:.3g}") for x in constants if math.isfinite(x)]
    program = Program([Tape().input("x")], constants)
    load(page, script(program))
    found = play(page, program, np.zeros((1, 1)))
    assert not differ(found, np.array([constants])).any()


def test_what_does_not_move_is_found_at_once(page: Page) -> None:
    length = Tape().input("length")
    program = Program([length], [length > 2.0])
    assert solver_data(program, fixed=1)["ends"] == [1]
    load(page, script(program, fixed=1))
    assert play(page, program, np.array([[1.0], [3.0]]), upto=0).tolist() == [[0.0], [1.0]]


def test_an_operand_far_back_is_found() -> None:
    """A place of more than five bits takes two digits, and one of more than ten takes three."""
    tape = Tape()
    x = tape.input("x")
    sums = [x + 0.5]
    for _ in range(1100):
        sums.append(sums[-1] * sums[-1])
    far = Program([x], [sums[0] + sums[-1]])
    code = str(solver_data(far)["code"])
    assert code.endswith("bdLcb") or len(code) == 3 * 1101 + 5
