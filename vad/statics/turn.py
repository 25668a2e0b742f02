"""Over a turn: the mean of the drive, the excess energy, and the flywheel that it asks for."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from vad import gate
from vad.errors import InputError

# The step between angles may differ by this share.
_EVEN = 1e-6
# Rounds of Newton's method; each doubles the number of right digits.
_ROUNDS = 6


class Turning:
    """The drive over a whole turn: a periodic function, of which the samples are known.

    It is read as a sum of sines, so that mean and energy are as accurate as the samples where the
    drive is smooth.

    Parameters
    ----------
    angles, drive
        Angles of the driver in degrees, evenly spaced over one turn along the last axis, and the
        drive at them in N·m.

    Raises
    ------
    vad.errors.InputError
        If the angles are no whole turn, or the drive is not known at all of them.
    """

    def __init__(self, angles: NDArray[np.float64], drive: NDArray[np.float64]) -> None:
        hint = "as in angle=numpy.linspace(0, 360, 361)"
        steps = np.diff(angles, axis=-1)
        if steps.shape[-1] < 3 or not steps.size:
            raise InputError("angle: a turn needs four angles or more along the last axis", hint)
        step = float(steps.flat[0])
        wrong = not np.all(np.abs(steps - step) <= _EVEN * abs(step))
        count = round(abs(360.0 / step)) if step and not wrong else 0
        if wrong or not math.isclose(count * abs(step), 360.0, rel_tol=_EVEN):
            raise InputError("angle: must run through one turn in even steps", hint)
        if angles.shape[-1] not in (count, count + 1):
            raise InputError("angle: must run through one turn, no more and no less", hint)
        if not np.isfinite(drive).all():
            lasting = "links with which the driver goes all the way round"
            raise InputError("forces: the drive is not known at every angle of the turn", lasting)
        # Energy is gained in the sense in which the driver turns.
        self._drive = drive[..., :count]
        self._sense = math.copysign(1.0, step)
        self._count = count

    @cached_property
    def mean(self) -> Any:
        """The mean drive in N·m."""
        mean = self._drive.mean(axis=-1)
        return mean if mean.ndim else float(mean)

    @cached_property
    def fluctuation(self) -> Any:
        """The difference of the greatest and the least excess energy, in J."""
        rows = self._drive.reshape(-1, self._count)
        found = np.array([_excess(row).energy for row in rows])
        return found.reshape(self._drive.shape[:-1]) if self._drive.ndim > 1 else float(found[0])

    @property
    def excess(self) -> Excess:
        """Between which samples of a single turn the drive gives most beyond its mean."""
        return _excess(self._sense * self._drive)

    def flywheel(self, ratio: float, speed: float) -> Any:
        """Return the moment of inertia that keeps the speed within a ratio of its mean."""
        ratio, speed = gate.number("ratio", ratio), gate.number("speed", speed)
        for name, value in (("ratio", ratio), ("speed", speed)):
            if value == 0.0:
                raise InputError(f"{name}: must not be zero")
        if ratio < 0.0:
            raise InputError(f"ratio: must be positive, got {ratio:g}", f"try {-ratio:g}")
        energy = np.asarray(self.fluctuation)
        with np.errstate(all="ignore"):  # what is beyond all numbers is refused below
            found = energy / np.float64(ratio * speed * speed)
        if not np.isfinite(found).all() or np.any((found == 0.0) & (energy != 0.0)):
            asked = f"a ratio of {ratio:g} at {speed:g} rad/s"
            message = f"ratio, speed: {asked} asks for a flywheel that no number can say"
            raise InputError(message, "as in flywheel(0.02, 10)")
        return found if found.ndim else float(found)


class Excess(NamedTuple):
    """The greatest excess energy of a turn.

    Attributes
    ----------
    energy
        The difference of the greatest and the least sum of what the drive gives beyond its mean.
    least, greatest
        Where these are, as shares of the turn from its first sample.
    """

    energy: float
    least: float
    greatest: float


def _excess(drive: NDArray[np.float64]) -> Excess:
    """Return the range of the integral of the drive less its mean, from samples of one turn."""
    count = drive.size
    waves = np.fft.rfft(drive)
    order = np.arange(waves.size)
    if count % 2 == 0:
        waves[-1] = 0.0  # a wave of two samples has no phase
    waves[0] = 0.0
    energy = np.zeros_like(waves)
    energy[1:] = waves[1:] / (1j * order[1:])
    samples = np.fft.irfft(energy, count)
    ends = []  # of the greatest and of the least: between samples, and the sample
    for place in (int(samples.argmax()), int(samples.argmin())):
        angle = start = 2.0 * math.pi * place / count
        for _ in range(_ROUNDS):
            turn = np.exp(1j * order * angle)
            slope = float((1j * order * waves * turn).real.sum())
            step = float((waves * turn).real.sum()) / slope if slope else 0.0
            if abs(angle - step - start) > 2.0 * math.pi / count:
                break  # it is a corner, and the sample is the best that is known
            angle -= step
        value = float((energy * np.exp(1j * order * angle)).real.sum()) * 2.0 / count
        found = (value, angle / (2.0 * math.pi) % 1.0)
        ends.append((found, (float(samples[place]), place / count)))
    (most, greatest), (lowest, least) = max(ends[0]), min(ends[1])
    return Excess(most - lowest, least, greatest)
