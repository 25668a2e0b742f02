"""A recorded calculation as one loop in machine code, where llvmlite is installed.

Each operation is written in the language of LLVM, for vectors of poses.  Nothing is left for LLVM's
optimizer to do, and its translator takes a sixtieth of a second, less than it takes to load: so
little that nothing is kept between processes.  It neither joins nor reorders operations on floats
unless it is told to, so that the bits are the same.
"""

from __future__ import annotations

import ctypes
import math
import struct
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.program import LANES, Blocks, Program
from vad.kinematics.recording import Operand, Recorded, key_of, kind_of, prepared
from vad.kinematics.threads import BLOCK, Work, in_blocks

Array = NDArray[Any]


def _in_all_lanes(value: str) -> str:
    return f"<{', '.join([value] * LANES)}>"


def _constant(number: float) -> str:
    """Return a vector that has all bits of a number in every lane."""
    return _in_all_lanes(f"double 0x{struct.pack('>d', number).hex()}")


# What the texts of the operations have in common: the types of vectors, and constants.
_WORDS = {
    "lanes": LANES,
    "kind": f"v{LANES}f64",
    "reals": f"<{LANES} x double>",
    "truths": f"<{LANES} x i1>",
    "half": _constant(0.5),
    "three_halves": _constant(1.5),
    "half_turn": _constant(180.0),
    "turn": _constant(360.0),
}
# How each operation is written.  The arc tangent is missing: its last bit would not be numpy's.
# numpy finds it, and what follows from it, of each block.
_TEXTS = {
    "fold": """
        {out}.turns = fdiv {reals} {0}, {turn}
        {out}.whole = call {reals} @llvm.rint.{kind}({reals} {out}.turns)
        {out}.removed = fmul {reals} {out}.whole, {turn}
        {out}.rest = fsub {reals} {0}, {out}.removed
        {out}.size = call {reals} @llvm.fabs.{kind}({reals} {out}.rest)
        {out}.beyond = fcmp ogt {reals} {out}.size, {half_turn}
        {out}.turn = call {reals} @llvm.copysign.{kind}({reals} {turn}, {reals} {out}.rest)
        {out}.back = fsub {reals} {out}.rest, {out}.turn
        {out} = select {truths} {out}.beyond, {reals} {out}.back, {reals} {out}.rest""",
    "add": "{out} = fadd {reals} {0}, {1}",
    "subtract": "{out} = fsub {reals} {0}, {1}",
    "multiply": "{out} = fmul {reals} {0}, {1}",
    "divide": "{out} = fdiv {reals} {0}, {1}",
    "negative": "{out} = fneg {reals} {0}",
    "absolute": "{out} = call {reals} @llvm.fabs.{kind}({reals} {0})",
    "copy": "{out} = bitcast {reals} {0} to {reals}",
    "minimum": """
        {out}.less = fcmp olt {reals} {0}, {1}
        {out} = select {truths} {out}.less, {reals} {0}, {reals} {1}""",
    "maximum": """
        {out}.more = fcmp ogt {reals} {0}, {1}
        {out} = select {truths} {out}.more, {reals} {0}, {reals} {1}""",
    "sqrt": "{out} = call {reals} @llvm.sqrt.{kind}({reals} {0})",
    "copysign": "{out} = call {reals} @llvm.copysign.{kind}({reals} {0}, {reals} {1})",
    "round": "{out} = call {reals} @llvm.rint.{kind}({reals} {0})",
    "place": "{out} = bitcast {reals} {0} to {reals}",
    "choose": """
        {out}.low = fcmp olt {reals} {0}, {half}
        {out}.high = fcmp ogt {reals} {0}, {three_halves}
        {out}.upper = select {truths} {out}.high, {reals} {1[2]}, {reals} {1[1]}
        {out} = select {truths} {out}.low, {reals} {1[0]}, {reals} {out}.upper""",
    "less": "{out} = fcmp olt {reals} {0}, {1}",
    "greater": "{out} = fcmp ogt {reals} {0}, {1}",
    "equal": "{out} = fcmp oeq {reals} {0}, {1}",
    "both": "{out} = and {truths} {0}, {1}",
    "either": "{out} = or {truths} {0}, {1}",
    "select": "{out} = select {truths} {0}, {reals} {1}, {reals} {2}",
}
# The operands that are truth values; everywhere else a truth value counts as 0.0 or 1.0.
_TRUTHS = {"both": (0, 1), "either": (0, 1), "select": (0,)}

# The last vector begins where it ends with the last pose: some poses are calculated twice.
_FRAME = """
define void @program(i64 %poses, {arguments}) nounwind "prefer-vector-width"="512" {{
begin:
  %last = sub nsw i64 %poses, {lanes}
{before}
  br label %loop
loop:
  %count = phi i64 [0, %begin], [%next, %loop]
  %beyond = icmp sgt i64 %count, %last
  %pose = select i1 %beyond, i64 %last, i64 %count
{lines}
  %next = add nuw nsw i64 %count, {lanes}
  %more = icmp slt i64 %next, %poses
  br i1 %more, label %loop, label %end
end:
  ret void
}}
declare {reals} @llvm.fabs.{kind}({reals})
declare {reals} @llvm.sqrt.{kind}({reals})
declare {reals} @llvm.rint.{kind}({reals})
declare {reals} @llvm.copysign.{kind}({reals}, {reals})
"""


class Compiled:
    """A loop in machine code.

    Parameters
    ----------
    inputs, steps, outputs
        What is given, the operations, and what is wanted.
    columns
        How many of the outputs, the last ones, are the columns of one table.
    many
        For each input whether it differs from pose to pose.
    """

    def __init__(
        self,
        inputs: Sequence[Recorded],
        steps: Sequence[Recorded],
        outputs: Sequence[Operand],
        columns: int,
        many: Sequence[bool],
    ) -> None:
        names = [number.name for number in inputs]
        late = _late(steps)
        self._folded = [names.index(x.name) for x in _folded(steps, late)]
        between = _between(steps, late)
        single = len(outputs) - columns
        self._late = [place for place, x in enumerate(outputs) if key_of(x) in late]
        self._early = [place for place in range(single) if place not in self._late]
        # A table has one address, that of its first column.
        self._table = slice(single, single + min(columns, 1))
        self._between = [kind_of(x) for x in between]
        self._after = Blocks(
            Program(between, [outputs[place] for place in self._late]), [True] * len(between)
        )
        found = [outputs[place] for place in self._early] + between
        kinds = [ctypes.c_void_p if each else ctypes.c_double for each in many]
        kinds += [ctypes.c_void_p] * (len(found) + min(columns, 1))
        found += [math.nan if key_of(x) in late else x for x in outputs[single:]]
        steps = [step for step in steps if step.name not in late]
        self._engine = _engine(_loop(inputs, steps, found, columns, many))  # keeps the code
        address = self._engine.get_function_address("program")
        self._loop = ctypes.CFUNCTYPE(None, ctypes.c_int64, *kinds)(address)

    def play(
        self,
        inputs: Sequence[Array | float],
        outputs: Sequence[Array],
        finish: Callable[[slice], None],
    ) -> None:
        """Write the outputs, block by block; each block that is written is given to ``finish``."""
        size = len(outputs[0])
        given = [np.ascontiguousarray(x, float) if isinstance(x, np.ndarray) else x for x in inputs]
        for place in self._folded:
            angles = prepared(given[place])
            given[place] = angles if angles.ndim else float(angles)
        early = [_address(x) for x in (*given, *(outputs[place] for place in self._early))]
        table = [_address(x) for x in outputs[self._table]]
        late = [outputs[place] for place in self._late]

        def thread(block: int) -> Work:
            rows: list[Array] = [np.empty(block, kind) for kind in self._between]
            places = [*early, *((row.ctypes.data, 0) for row in rows), *table]

            def work(part: slice) -> None:
                start = min(part.start, size - LANES)
                part = slice(start, part.stop)
                count = part.stop - start
                at = (at + start * step if step else at for at, step in places)  # -0.0 + 0 is 0.0
                self._loop(count, *at)
                if late:
                    self._after.play([row[:count] for row in rows], [out[part] for out in late])
                finish(part)

            return work

        in_blocks(size, BLOCK, thread)


def _late(steps: Sequence[Recorded]) -> set[str]:
    """Return the names of the arc tangents and of all that follows from them."""
    late: set[str] = set()
    for step in steps:
        if step.operation == "arctan2" or not late.isdisjoint(map(key_of, step.operands)):
            late.add(step.name)
    return late


def _folded(steps: Sequence[Recorded], late: set[str]) -> list[Recorded]:
    """Return the numbers that the loop folds."""
    early = (step for step in steps if step.name not in late)
    return [step.operands[0] for step in early if step.operation == "fold"]


def _between(steps: Sequence[Recorded], late: set[str]) -> list[Recorded]:
    """Return the numbers that are no late ones, but operands of these."""
    operands = [x for step in steps if step.name in late for x in step.operands]
    found = {x.name: x for x in operands if isinstance(x, Recorded) and x.name not in late}
    return list(found.values())


def _address(value: Array | float) -> tuple[Any, int]:
    """Return the address of an array and its step from pose to pose, or a number and 0."""
    if isinstance(value, np.ndarray):
        return value.ctypes.data, value.strides[0]
    return value, 0


def compiled(
    inputs: Sequence[Recorded],
    steps: Sequence[Recorded],
    outputs: Sequence[Operand],
    columns: int,
    many: Sequence[bool],
) -> Compiled | None:
    """Return the loop of a program; None without llvmlite, or if it cannot be written for LLVM."""
    late = _late(steps)
    written = all(step.name in late or step.operation in _TEXTS for step in steps)
    whole = any(kind_of(x) is np.intp for x in _between(steps, late))
    if not written or whole or any(x.operation for x in _folded(steps, late)):
        return None
    try:
        return Compiled(inputs, steps, outputs, columns, many)
    except (ImportError, AttributeError, RuntimeError, TypeError):  # none, or of another version
        return None


def _loop(
    inputs: Sequence[Recorded],
    steps: Sequence[Recorded],
    outputs: Sequence[Operand],
    columns: int,
    many: Sequence[bool],
) -> str:
    """Return a program as a function of the number of poses and of addresses, for LLVM."""
    arguments, before, lines = [], [], []
    for number, each in zip(inputs, many, strict=True):
        name = number.name
        arguments.append(f"ptr noalias %all.{name}" if each else f"double %one.{name}")
        if each:
            lines.append(f"%{name}.at = getelementptr inbounds double, ptr %all.{name}, i64 %pose")
            lines.append(f"%{name} = load {_WORDS['reals']}, ptr %{name}.at, align 8")
        else:
            first = f"insertelement {_WORDS['reals']} poison, double %one.{name}, i32 0"
            before.append(f"%{name}.first = {first}")
            before.append(f"%{name} = {_shuffled(LANES, f'%{name}.first', 'poison', [0] * LANES)}")
    for step in steps:
        texts = [_operand(step, place) for place in range(len(step.operands))]
        lines += _TEXTS[step.operation].format(*texts, out=f"%{step.name}", **_WORDS).split("\n")
        if kind_of(step) is bool:
            truth = f"{_WORDS['truths']} %{step.name}"
            lines.append(f"%{step.name}.real = uitofp {truth} to {_WORDS['reals']}")
    single = len(outputs) - columns
    for place, number in enumerate(outputs[:single]):
        out = f"%out{place}"
        arguments.append(f"ptr noalias {out}")
        kind, value = "double", _real(number)
        if kind_of(number) is bool:
            kind, value = "i8", f"{out}.bytes"
            lines.append(f"{value} = zext {_WORDS['truths']} %{number.name} to <{LANES} x i8>")
        lines.append(f"{out}.at = getelementptr inbounds {kind}, ptr {out}, i64 %pose")
        lines.append(f"store <{LANES} x {kind}> {value}, ptr {out}.at, align 1")
    if columns:
        arguments.append("ptr noalias %table")
        lines += _table_lines([_real(number) for number in outputs[single:]])
    return _FRAME.format(
        arguments=", ".join(arguments),
        before="\n".join(before),
        lines="\n".join(lines),
        **_WORDS,
    )


def _table_lines(columns: list[str]) -> list[str]:
    """Return the lines that write columns, which lie one behind the other, as rows of a table."""
    lines, parts, width, count = [], columns, LANES, len(columns)
    while len(parts) > 1:  # each round halves their number
        parts = parts + ["poison"] * (len(parts) % 2)
        joined: list[str] = []
        for one, other in zip(parts[::2], parts[1::2], strict=True):
            joined.append(f"%joined{width}.{len(joined)}")
            lines.append(f"{joined[-1]} = {_shuffled(width, one, other, range(2 * width))}")
        parts, width = joined, 2 * width
    rows = [column * LANES + lane for lane in range(LANES) for column in range(count)]
    lines.append(f"%rows = {_shuffled(width, parts[0], 'poison', rows)}")
    lines.append(f"%cell = mul nuw nsw i64 %pose, {count}")
    lines.append("%row = getelementptr inbounds double, ptr %table, i64 %cell")
    lines.append(f"store <{len(rows)} x double> %rows, ptr %row, align 8")
    return lines


def _shuffled(width: int, one: str, other: str, order: Iterable[int]) -> str:
    """Return the operation that takes elements of two vectors in some order."""
    places = [f"i32 {place}" for place in order]
    kind = f"<{width} x double>"
    return (
        f"shufflevector {kind} {one}, {kind} {other}, <{len(places)} x i32> <{', '.join(places)}>"
    )


def _operand(step: Recorded, place: int) -> Any:
    operand = step.operands[place]
    if isinstance(operand, tuple):
        return [_real(number) for number in operand]
    if place in _TRUTHS.get(step.operation, ()):
        return (
            f"%{operand.name}"
            if isinstance(operand, Recorded)
            else _in_all_lanes(f"i1 {operand:d}")
        )
    return _real(operand)


def _real(number: Operand) -> str:
    """Return a number as a vector: its name, or all its bits in every lane."""
    if isinstance(number, Recorded):
        return f"%{number.name}.real" if kind_of(number) is bool else f"%{number.name}"
    return _constant(number)


def _engine(text: str) -> Any:
    """Return what holds the machine code of a module for this processor."""
    import llvmlite.binding as llvm  # type: ignore[import-not-found,import-untyped,unused-ignore]

    if llvm.llvm_version_info < (16,):
        raise RuntimeError("this version of LLVM wants a type of every address")
    with suppress(RuntimeError):  # later versions need no such call, and refuse it
        llvm.initialize()
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    machine = llvm.Target.from_default_triple().create_target_machine(
        cpu=llvm.get_host_cpu_name(), features=llvm.get_host_cpu_features().flatten(), opt=2
    )
    module = llvm.parse_assembly(text)
    module.data_layout = str(machine.target_data)
    engine = llvm.create_mcjit_compiler(module, machine)
    engine.finalize_object()
    return engine
