"""Sweeps over arrays: Dask arrays in, Dask arrays out, with the numbers of `vad.solve`."""

from __future__ import annotations

import subprocess
import sys

import dask
import dask.array as da
import numpy as np
import pytest

import vad

ANGLES = np.linspace(0.0, 360.0, 1001)
RESULTS = ("rocker.omega", "C.acceleration", "coupler.angle")


def expected(name: str, motion: vad.Motions) -> np.ndarray:
    part, _, quantity = name.partition(".")
    owner = motion.point(part) if part == "C" else motion.link(part)
    return np.asarray(getattr(owner, quantity))


def test_numpy_arrays_are_solved_at_once():
    swept = vad.sweep(vad.FourBar(), RESULTS, angle=ANGLES, omega=10.0)
    motion = vad.solve(vad.FourBar(), angle=ANGLES, omega=10.0)
    assert swept.dtype.names == RESULTS
    for name in RESULTS:
        assert np.array_equal(swept[name], expected(name, motion))


@pytest.mark.parametrize("mechanism", [vad.FourBar(), vad.FourBar(crank=130)])
def test_a_dask_array_gives_the_same_bits_block_by_block(mechanism):
    swept = vad.sweep(mechanism, RESULTS, angle=da.from_array(ANGLES, chunks=100), omega=10.0)
    assert isinstance(swept, da.Array)
    assert swept.chunks == ((100,) * 10 + (1,),)
    motion = vad.solve(mechanism, angle=ANGLES, omega=10.0)
    whole = swept.compute(scheduler="synchronous")
    for name in RESULTS:
        assert np.array_equal(whole[name], expected(name, motion), equal_nan=True)
        assert np.array_equal(swept[name].compute(), whole[name], equal_nan=True)


def test_inputs_broadcast_whatever_they_are():
    omegas = np.array([1.0, 2.0, 3.0])
    angle = da.from_array(ANGLES[:, None], chunks=(300, 1))
    swept = vad.sweep(vad.FourBar(), "rocker.omega", angle=angle, omega=omegas)
    motion = vad.solve(vad.FourBar(), angle=ANGLES[:, None], omega=omegas)
    assert swept.shape == (1001, 3)
    assert np.array_equal(swept["rocker.omega"].compute(), motion.link("rocker").omega)


def test_nothing_is_computed_and_no_block_twice():
    solved = []

    def block(numbers: np.ndarray) -> np.ndarray:
        solved.append(len(numbers))
        return numbers * 1.0

    meta = np.empty(0)
    angle = da.from_array(ANGLES, chunks=100).map_blocks(block, dtype=float, meta=meta)
    swept = vad.sweep(vad.FourBar(), RESULTS, angle=angle)
    assert solved == []
    with dask.config.set(scheduler="synchronous"):
        da.compute(swept["rocker.omega"].max(), swept["C.acceleration"].sum())
    assert sorted(solved) == [1, *[100] * 10]


def test_more_than_memory_holds_may_be_asked_for():
    """Of a hundred gigabytes only the block that is looked at is solved."""
    angle = da.arange(10**10, chunks=10**6, dtype=float) % 360.0
    swept = vad.sweep(vad.FourBar(), "C.position", angle=angle)
    assert (
        swept["C.position"][12345].compute()
        == vad.solve(vad.FourBar(), angle=12345 % 360.0).point("C").position
    )


@pytest.mark.parametrize(
    ("results", "inputs", "part"),
    [
        ("rocker.omeg", {}, "unknown result 'rocker.omeg'"),
        ("rocker", {}, "results: 'rocker' is no result"),
        ((), {}, "results: none given"),
        ("rocker.omega", {"angel": 3}, "unknown input 'angel'"),
        ("rocker.omega", {"angle": da.ones(3), "omega": da.ones(4)}, "do not broadcast"),
        ("rocker.omega", {"angle": da.ones(3, dtype=complex)}, "angle: must be an array of num"),
        ("rocker.omega", {"angle": da.ones(3), "omega": "x"}, "omega: 'x' is not a number"),
    ],
)
def test_what_is_wrong_is_said_at_once(results, inputs, part):
    with pytest.raises(vad.InputError) as caught:
        vad.sweep(vad.FourBar(), results, **inputs)
    assert part in str(caught.value)


def test_numpy_alone_does_not_load_dask():
    script = (
        "import sys, numpy as np, vad\n"
        "vad.sweep(vad.FourBar(), 'C.velocity', angle=np.arange(3.0))\n"
        "assert not {'dask', 'joblib'} & set(sys.modules)\n"
    )
    subprocess.run([sys.executable, "-c", script], check=True)


@pytest.mark.parametrize("mechanism", [vad.SliderCrank(), vad.CrankSlottedLever()], ids=repr)
def test_forces_have_the_same_bits_block_by_block(mechanism):
    """Those of a call, of an array, and of a Dask array in blocks."""
    angle = np.linspace(0.0, 360.0, 1001)
    slide = next(iter(mechanism.slides))
    given = {"loads": ["5 N m on crank"], "masses": {slide: 2.0}, "gravity": 9.81}
    names = ["drive", "frame.crank.force", "crank.alpha"]
    whole = vad.sweep(mechanism, names, **given, angle=angle, alpha=3.0)
    blocks = da.from_array(angle, chunks=300)
    again = vad.sweep(mechanism, names, **given, angle=blocks, alpha=3.0).compute()
    forces = vad.forces(vad.solve(mechanism, angle=angle, alpha=3.0), **given)
    assert whole.tobytes() == again.tobytes()
    assert np.array_equal(whole["drive"], forces.drive)
    assert np.array_equal(whole["frame.crank.force"], forces.force("frame", "crank"))
    one = vad.sweep(mechanism, names, **given, angle=angle[7], alpha=3.0)
    assert one == whole[7]


def test_forces_that_are_unknown_are_named():
    with pytest.raises(vad.UsageError, match="unknown result") as caught:
        vad.sweep(vad.SliderCrank(), "rod.ram.force", angle=60)
    assert "rod.slider.force" in str(caught.value.hint)
