"""A sweep as a table: every number as `repr` writes it, in memory that does not grow."""

from __future__ import annotations

import io
import tracemalloc

import numpy as np
import pytest

import vad
from vad.export import sweep_csv

#: Where notations change, and what is hard to write: the ends of the range, powers, long fractions.
EDGES = [
    *(0.0, -0.0, 1.0, -1.0, 0.1, 1 / 3, 5e-324, 2.2250738585072014e-308, 1.7976931348623157e308),
    *(9.999999999999999e-05, 1e-4, 1.0000000000000002e-4, 1e-5, 1.5e-5, 0.00012345),
    *(1e15, 1e16, 9999999999999998.0, 1.0000000000000002e16, 123456789012345678.0, 1e17, 1e22),
    *(9007199254740993.0, 2.0**53, 2.0**-1074, 5e-5, 4.35, 0.3, 2.675, 1e21, 1e23),
]


def lines(columns: list[np.ndarray]) -> bytes:
    """Write a table number by number."""
    rows = zip(*(column.tolist() for column in columns), strict=True)
    cells = (["" if x != x else repr(x + 0.0) for x in row] for row in rows)
    return "".join(",".join(row) + "\n" for row in cells).encode()


@pytest.mark.parametrize("columns", [1, 2, 7])
def test_every_number_is_written_as_repr_writes_it(columns):
    dice = np.random.default_rng(columns)
    bits = dice.integers(0, 2**64, 30_000, dtype=np.uint64).view(np.float64)
    sizes = dice.standard_normal(40_000) * 10.0 ** dice.integers(-7, 19, 40_000)
    short = dice.integers(-(10**6), 10**6, 10_000) / 10.0 ** dice.integers(0, 12, 10_000)
    powers = 10.0 ** np.arange(-300.0, 300.0)
    edges = np.array(EDGES)
    with np.errstate(over="ignore"):
        near = [np.nextafter(edges, to) for to in (-np.inf, np.inf)]
    numbers = np.concatenate([bits, sizes, short, powers, edges, -edges, *near])
    numbers[~np.isfinite(numbers)] = np.nan
    numbers = numbers[: len(numbers) // columns * columns]
    dice.shuffle(numbers)
    table = list(numbers.reshape(columns, -1))
    assert sweep_csv.written(table) == lines(table)


@pytest.mark.parametrize("size", [1, sweep_csv._BLOCK, sweep_csv._BLOCK + 1])
@pytest.mark.parametrize("mechanism", [vad.FourBar(), vad.FourBar(crank=130.0)])
def test_blocks_hold_the_bits_of_the_whole_array(mechanism, size):
    motion = vad.solve(mechanism, angle=np.linspace(20.0, 360.0, size), omega=7.0)
    target = io.BytesIO()
    sweep_csv.write(motion, target)
    head, _, body = target.getvalue().partition(b"\n")
    columns = [motion.inputs["angle"]]
    for name in motion.links:
        link = motion.link(name)
        columns += [link.angle, link.omega, link.alpha]
    assert head.count(b",") == len(columns) - 1
    assert body == lines(columns)


def test_memory_does_not_grow_with_the_number_of_poses():
    class Null(io.RawIOBase):
        def write(self, text: object) -> int:
            return len(memoryview(text))

    peaks = []
    for count in (100_000, 400_000):
        motion = vad.solve(vad.SliderCrank(), angle=np.linspace(0.0, 360.0, count))
        tracemalloc.start()
        sweep_csv.write(motion, Null())
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[1] < 1.2 * peaks[0]
