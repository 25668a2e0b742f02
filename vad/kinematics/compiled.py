"""A recorded calculation as one loop in machine code, where llvmlite is installed.

Each operation is written in the language of LLVM, whose optimizer makes a loop over vectors of it.
That takes some thirtieths of a second: so little that nothing is kept between processes.  LLVM
neither joins nor reorders operations on floats unless it is told to, so that the bits are the same.
"""

from __future__ import annotations

import contextlib
import ctypes
import struct
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.recording import Operand, Recorded, kind_of, prepared

Array = NDArray[Any]

# How each operation is written.  The arc tangent is missing: its last bit would not be numpy's.
_TEXTS = {
    "fold": """
        {out}.turns = fdiv double {0}, 360.0
        {out}.whole = call double @llvm.rint.f64(double {out}.turns)
        {out}.removed = fmul double {out}.whole, 360.0
        {out}.rest = fsub double {0}, {out}.removed
        {out}.size = call double @llvm.fabs.f64(double {out}.rest)
        {out}.beyond = fcmp ogt double {out}.size, 180.0
        {out}.turn = call double @llvm.copysign.f64(double 360.0, double {out}.rest)
        {out}.back = fsub double {out}.rest, {out}.turn
        {out} = select i1 {out}.beyond, double {out}.back, double {out}.rest""",
    "add": "{out} = fadd double {0}, {1}",
    "subtract": "{out} = fsub double {0}, {1}",
    "multiply": "{out} = fmul double {0}, {1}",
    "divide": "{out} = fdiv double {0}, {1}",
    "negative": "{out} = fneg double {0}",
    "absolute": "{out} = call double @llvm.fabs.f64(double {0})",
    "copy": "{out} = fadd double {0}, -0.0",
    "minimum": """
        {out}.less = fcmp olt double {0}, {1}
        {out} = select i1 {out}.less, double {0}, double {1}""",
    "maximum": """
        {out}.more = fcmp ogt double {0}, {1}
        {out} = select i1 {out}.more, double {0}, double {1}""",
    "sqrt": "{out} = call double @llvm.sqrt.f64(double {0})",
    "copysign": "{out} = call double @llvm.copysign.f64(double {0}, double {1})",
    "round": "{out} = call double @llvm.rint.f64(double {0})",
    "place": "{out} = fadd double {0}, -0.0",
    "choose": """
        {out}.low = fcmp olt double {0}, 0.5
        {out}.high = fcmp ogt double {0}, 1.5
        {out}.upper = select i1 {out}.high, double {1[2]}, double {1[1]}
        {out} = select i1 {out}.low, double {1[0]}, double {out}.upper""",
    "less": "{out} = fcmp olt double {0}, {1}",
    "greater": "{out} = fcmp ogt double {0}, {1}",
    "equal": "{out} = fcmp oeq double {0}, {1}",
    "both": "{out} = and i1 {0}, {1}",
    "either": "{out} = or i1 {0}, {1}",
    "select": "{out} = select i1 {0}, double {1}, double {2}",
}
# The operands that are truth values; everywhere else a truth value counts as 0.0 or 1.0.
_TRUTHS = {"both": (0, 1), "either": (0, 1), "select": (0,)}

_FRAME = """
define void @program(i64 %poses, {arguments}) nounwind "prefer-vector-width"="512" {{
begin:
  %some = icmp sgt i64 %poses, 0
  br i1 %some, label %loop, label %end
loop:
  %pose = phi i64 [0, %begin], [%next, %loop]
{lines}
  %next = add nuw nsw i64 %pose, 1
  %more = icmp slt i64 %next, %poses
  br i1 %more, label %loop, label %end
end:
  ret void
}}
declare double @llvm.fabs.f64(double)
declare double @llvm.sqrt.f64(double)
declare double @llvm.rint.f64(double)
declare double @llvm.copysign.f64(double, double)
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
        self._folded = [names.index(x.operands[0].name) for x in steps if x.operation == "fold"]
        # A table has one address, that of its first column.
        self._starts = len(outputs) - columns + min(columns, 1)
        kinds = [ctypes.c_void_p if each else ctypes.c_double for each in many]
        kinds += [ctypes.c_void_p] * self._starts
        self._engine = _engine(_loop(inputs, steps, outputs, columns, many))  # keeps the code
        address = self._engine.get_function_address("program")
        self._loop = ctypes.CFUNCTYPE(None, ctypes.c_int64, *kinds)(address)

    def play(
        self,
        inputs: Sequence[Array | float],
        outputs: Sequence[Array],
        block: int,
        finish: Callable[[slice], None],
    ) -> None:
        """Write the outputs, block by block; each block that is written is given to ``finish``."""
        size = len(outputs[0])
        given = [np.ascontiguousarray(x, float) if isinstance(x, np.ndarray) else x for x in inputs]
        for place in self._folded:
            angles = prepared(given[place])
            given[place] = angles if angles.ndim else float(angles)
        places = [_address(x) for x in (*given, *outputs[: self._starts])]
        for start in range(0, size, block):
            part = slice(start, min(start + block, size))
            self._loop(part.stop - start, *(at + start * step for at, step in places))
            finish(part)


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
    folded = [step.operands[0] for step in steps if step.operation == "fold"]
    if any(step.operation not in _TEXTS for step in steps) or any(x.operation for x in folded):
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
    arguments, lines = [], []
    for number, each in zip(inputs, many, strict=True):
        name = number.name
        arguments.append(f"ptr noalias %all.{name}" if each else f"double %{name}")
        if each:
            lines += [_place(f"{name}.at", f"all.{name}", "double", "%pose")]
            lines += [f"%{name} = load double, ptr %{name}.at"]
    for step in steps:
        texts = [_operand(step, place) for place in range(len(step.operands))]
        lines += _TEXTS[step.operation].format(*texts, out=f"%{step.name}").split("\n")
        if kind_of(step) is bool:
            lines.append(f"%{step.name}.real = uitofp i1 %{step.name} to double")
    for place, number in enumerate(outputs):
        out, column = f"out{place}", place - (len(outputs) - columns)
        if column <= 0:
            arguments.append(f"ptr noalias %{out}")
        if column >= 0:
            lines.append(f"%{out}.row = mul nuw nsw i64 %pose, {columns}")
            lines.append(f"%{out}.cell = add nuw nsw i64 %{out}.row, {column}")
            lines.append(_place(f"{out}.at", f"out{place - column}", "double", f"%{out}.cell"))
        elif kind_of(number) is bool:
            lines.append(_place(f"{out}.at", out, "i8", "%pose"))
            lines.append(f"%{out}.byte = zext i1 %{number.name} to i8")
            lines.append(f"store i8 %{out}.byte, ptr %{out}.at")
            continue
        else:
            lines.append(_place(f"{out}.at", out, "double", "%pose"))
        lines.append(f"store double {_real(number)}, ptr %{out}.at")
    return _FRAME.format(arguments=", ".join(arguments), lines="\n".join(lines))


def _place(name: str, start: str, kind: str, number: str) -> str:
    """Return the line that names the address of an element."""
    return f"%{name} = getelementptr inbounds {kind}, ptr %{start}, i64 {number}"


def _operand(step: Recorded, place: int) -> Any:
    operand = step.operands[place]
    if isinstance(operand, tuple):
        return [_real(number) for number in operand]
    if place in _TRUTHS.get(step.operation, ()):
        return f"%{operand.name}" if isinstance(operand, Recorded) else str(bool(operand)).lower()
    return _real(operand)


def _real(number: Operand) -> str:
    """Return a number as a float: its name, or all its bits."""
    if isinstance(number, Recorded):
        return f"%{number.name}.real" if kind_of(number) is bool else f"%{number.name}"
    return f"0x{struct.pack('>d', number).hex().upper()}"


def _engine(text: str) -> Any:
    """Return what holds the machine code of a module for this processor."""
    import llvmlite.binding as llvm  # type: ignore[import-not-found,import-untyped,unused-ignore]

    if llvm.llvm_version_info < (16,):
        raise RuntimeError("this version of LLVM wants a type of every address")
    with contextlib.suppress(RuntimeError):  # later versions need no such call, and refuse it
        llvm.initialize()
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    machine = llvm.Target.from_default_triple().create_target_machine(
        cpu=llvm.get_host_cpu_name(), features=llvm.get_host_cpu_features().flatten(), opt=2
    )
    module = llvm.parse_assembly(text)
    module.data_layout = str(machine.target_data)
    options = llvm.create_pipeline_tuning_options()
    options.loop_vectorization = True
    passes = llvm.create_pass_builder(machine, options)
    passes.getModulePassManager().run(module, passes)
    engine = llvm.create_mcjit_compiler(module, machine)
    engine.finalize_object()
    return engine
