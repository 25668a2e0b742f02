"""The few functions that an oracle needs, of numbers of mpmath, of gmpy2 or of arrays alike.

Numbers of mpmath are made with `mpmath.mpf` and are easy to look at.  Those of gmpy2 are ten times
as fast, and errors of millions of results are measured with them.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import gmpy2
import numpy as np
from mpmath import mp, mpf


def expj(angle: Any) -> Any:
    """Return cos + i·sin of an angle in radians."""
    if isinstance(angle, np.ndarray):
        return np.exp(1j * angle)
    if isinstance(angle, mpf):
        return mp.expj(angle)
    return _expj(angle, gmpy2.get_context().precision)


@lru_cache(maxsize=256)
def _expj(angle: Any, bits: int) -> Any:
    """Return it from the few angles of a pose, which stand in every equation, once."""
    sine, cosine = gmpy2.sin_cos(angle)
    return gmpy2.mpc(cosine, sine)


def sqrt(number: Any) -> Any:
    return mp.sqrt(number) if isinstance(number, mpf) else gmpy2.sqrt(number)


def arg(vector: Any) -> Any:
    """Return the direction of a vector in radians, within ±π."""
    if isinstance(vector, np.ndarray):
        return np.angle(vector)
    return gmpy2.phase(vector) if isinstance(vector, gmpy2.mpc) else mp.arg(vector)


def pi_like(number: Any) -> Any:
    """Return π with the digits of a number."""
    return gmpy2.const_pi() if isinstance(number, gmpy2.mpfr) else +mp.pi


def fold(angle: Any) -> Any:
    """Return the same direction within ±π."""
    turn = 2 * pi_like(angle)
    turns = angle / turn
    whole = gmpy2.rint(turns) if isinstance(turns, gmpy2.mpfr) else mp.nint(turns)
    return angle - turn * whole
