"""The kind of a four-bar chain, by Grashof's rule."""

from __future__ import annotations

import math

from vad.kinematics.linkage import Bar
from vad.kinematics.solver import Solver

#: Sums of two lengths that differ by no more than this share are equal: each was rounded.
_ROUNDED = 4.0 * 2.0**-52


def grashof(solver: Solver) -> str | None:
    """Return the kind of the four-bar chain that the driven crank moves; None where there is none.

    The shortest link and the longest one are together at most as long as the other two where a link
    turns fully (F. Grashof, *Theoretische Maschinenlehre*, 1883).  Then the kind follows from the
    shortest link; else all three moving links only rock.

    Examples
    --------
    >>> from vad.kinematics.solver import solver_of
    >>> from vad.mechanisms.four_bar import FourBar
    >>> [grashof(solver_of(FourBar(*lengths))) for lengths in ((100, 40, 120, 80), (2, 3, 4, 4))]
    ['crank-rocker', 'double-crank']
    """
    loop = solver.loops[0] if solver.loops else None
    if loop is None or loop.crank is None or not loop.crank.c:
        return None
    bars = [bar for bar in (loop.step, loop.other) if isinstance(bar, Bar)]
    if len(bars) < 2 or not all(isinstance(bar.length, float) for bar in bars):
        return None
    (_, crank), chains = loop.known[0], (loop.loop.first, loop.loop.second)
    beside = {step.ends for chain in chains if crank in chain for step in chain}
    coupler, rocker = sorted(bars, key=lambda bar: bar.ends not in beside)
    return kind_of(
        ground=abs(loop.crank.c),
        crank=abs(loop.crank.t),
        coupler=abs(float(solver.frame.size(coupler))),
        rocker=abs(float(solver.frame.size(rocker))),
    )


def kind_of(*, ground: float, crank: float, coupler: float, rocker: float) -> str:
    """Return the kind of a four-bar with these lengths.

    Examples
    --------
    >>> kind_of(ground=100, crank=90, coupler=110, rocker=200)
    'triple-rocker'
    """
    lengths = {
        "crank-rocker": crank,
        "double-crank": ground,
        "double-rocker": coupler,
        "rocker-crank": rocker,
    }
    ordered = sorted(lengths.values())
    excess = math.fsum((ordered[0], ordered[3], -ordered[1], -ordered[2]))
    if abs(excess) <= _ROUNDED * ordered[3]:
        return "change point"
    if excess > 0.0:
        return "triple-rocker"
    return min(lengths, key=lambda kind: lengths[kind])
