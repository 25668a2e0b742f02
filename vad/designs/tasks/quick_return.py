"""A quick return from its stroke and its time ratio: a slotted lever, or Whitworth's.

The slotted lever is at its dead centres where the crank is square to it.  It swings by δ, so

    crank = ground · sin(δ/2),      stroke = 2 · lever · sin(δ/2).

Whitworth's arm is along the line of the ram there, and the block on that line:

    ground = crank · sin(δ/2),      stroke = 2 · arm

(R. S. Khurmi and J. K. Gupta, *Theory of Machines*, chapter 5).
"""

from __future__ import annotations

import math

from vad.designs.dead_centres import TIME_RATIO, imbalance, place
from vad.designs.task import Answer, Demand, Task, above
from vad.errors import InputError, UsageError
from vad.mechanisms.crank_slotted_lever import CrankSlottedLever
from vad.mechanisms.whitworth import Whitworth

#: Below it the lever would be longer than six hundred strokes.
_LEAST = 1.001
#: Without a choice the lever's pivots are apart by this share of it, and Whitworth's crank has so
#: many lengths of its arm.
_GROUND, _CRANK = 0.5, 1.5
#: Without a choice the lever's rod has so many strokes, but at least so many of its least lengths;
#: Whitworth's rod has so many strokes.
_ROD, _LONGER, _LONG = 1.0, 2.0, 2.0


def solve(
    stroke: float,
    time_ratio: float,
    crank: float | None = None,
    ground: float | None = None,
    rod: float | None = None,
    length_unit: str = "mm",
) -> list[Answer]:
    """Return the slotted lever and Whitworth's quick return with this stroke and time ratio.

    The line of the lever's ram halves the height of the arc of its tip, so that the rod is as near
    to that line as it can be; Whitworth's goes through the pivot of the arm.
    """
    if crank is not None and ground is not None:
        raise UsageError("crank and ground: give one of them", "the other follows from it")
    if time_ratio < _LEAST:
        raise InputError(
            f"time_ratio: must be at least {_LEAST:g} for a quick return, got {time_ratio:g}",
            "vad design slider-crank has strokes of the same time",
        )
    half = imbalance(time_ratio) / 2.0
    sine, arm = math.sin(half), stroke / 2.0
    # With a shorter rod the ram would turn back before the lever does.
    shortest = 0.25 * stroke * math.tan(half / 2.0) / math.cos(half)
    if rod is not None and rod <= min(shortest, arm):
        least = above(min(shortest, arm))
        raise InputError(f"rod: must be more than {least} for this ram, got {rod:g}")
    dead = (place(-half), place(math.pi + half))
    answers = []
    bar = max(_ROD * stroke, _LONGER * shortest) if rod is None else rod
    if bar > shortest:
        lever = arm / sine
        apart = crank / sine if crank is not None else ground or _GROUND * lever
        answers.append(
            Answer(
                CrankSlottedLever(
                    ground=apart,
                    crank=crank or apart * sine,
                    lever=lever,
                    rod=bar,
                    ram_height=lever * (1.0 + math.cos(half)) / 2.0 - apart,
                    length_unit=length_unit,
                ),
                dead,
                notes=("slow left",),
            )
        )
    bar = _LONG * stroke if rod is None else rod
    if bar > arm:
        turning = ground / sine if ground is not None else crank or _CRANK * arm
        answers.append(
            Answer(
                Whitworth(
                    ground=ground or turning * sine,
                    crank=turning,
                    arm=arm,
                    rod=bar,
                    length_unit=length_unit,
                ),
                (dead[1], dead[0]),
                notes=("slow right",),
            )
        )
    return answers


#: The task.
TASK = Task(
    "quick-return",
    "Quick return from its stroke and time ratio",
    (
        Demand("stroke", "length", "of the ram", needed=True, example="300"),
        TIME_RATIO,
        Demand("ground", "length", "a free choice: the distance of the pivots", example="200"),
        Demand("crank", "length", "or the crank", example="80"),
        Demand("rod", "length", "a free choice: the rod of the ram", example="250"),
    ),
    solve,
    "the pivots are apart by half of the lever; Whitworth's crank has one and a half lengths of "
    "its arm; the lever's rod is as long as the stroke, or longer where it must be, and "
    "Whitworth's is twice as long as the stroke",
)
