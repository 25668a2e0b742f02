"""A sweep as a plot in SVG."""

from __future__ import annotations

from typing import BinaryIO

from vad.export.plotting import Look
from vad.export.sweep_png import write_as
from vad.kinematics.motion import Motions
from vad.statics.burden import Burden


def write(
    motion: Motions,
    target: BinaryIO,
    burden: Burden | None = None,
    style: str | None = None,
    language: str | None = None,
) -> None:
    """Write the plot of a motion's results, and of its forces, as `vad.export.sweep_png` has it."""
    write_as("svg", motion, target, burden, Look.of(style, language, motion.mechanism))
