"""Dimensions that are arrays: each pose has the bits that it has alone."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import vad

ANGLES = np.linspace(0.0, 360.0, 5)
CRANKS = np.array([30.0, 40.0, 130.0, np.nan])


@pytest.mark.parametrize(
    ("mechanism", "name", "values"),
    [
        (vad.FourBar(), "crank", CRANKS),
        (vad.SliderCrank(offset=20.0), "rod", np.array([90.0, 140.0])),
        (vad.SphericalFourBar(), "crank", np.array([35.0, 40.0])),
        (vad.CrankSlottedLever(rod=120, ram_height=140), "ground", np.array([110.0, 125.0])),
    ],
    ids=lambda value: getattr(value, "name", ""),
)
def test_each_pose_is_that_of_one_mechanism(mechanism, name, values):
    many = vad.solve(replace(mechanism, **{name: values[:, None]}), angle=ANGLES, alpha=3.0)
    assert many.shape == (len(values), len(ANGLES))
    for number, value in enumerate(values):
        if np.isnan(value):
            assert not many.assembled[number].any()
            continue
        one = vad.solve(replace(mechanism, **{name: value}), angle=ANGLES, alpha=3.0)
        assert (many.assembled[number] == one.assembled).all()
        for result in one.results.values():
            alone, beside = np.asarray(one.read(result)), np.asarray(many.read(result)[number])
            assert alone.tobytes() == beside.tobytes(), result


def test_long_arrays_run_as_programs():
    angles = np.linspace(0.0, 360.0, 101)
    many = vad.solve(vad.FourBar(crank=np.array([[30.0], [40.0]])), angle=angles)
    one = vad.solve(vad.FourBar(crank=40.0), angle=angles)
    assert (many.link("rocker").alpha[1] == one.link("rocker").alpha).all()


def test_a_sweep_takes_them_with_forces_and_dask():
    da = pytest.importorskip("dask.array")
    mechanism = vad.FourBar(crank=CRANKS)
    names = ("rocker.angle", "transmission", "C.velocity")
    swept = vad.sweep(mechanism, names, angle=40.0)
    assert swept["transmission"][1] == vad.sweep(vad.FourBar(), "transmission", angle=40.0)[()][0]
    lazy = vad.sweep(vad.FourBar(crank=da.from_array(CRANKS, chunks=2)), names, angle=40.0)
    assert lazy.compute().tobytes() == swept.tobytes()
    driven = vad.sweep(mechanism, "drive", loads=["6 N m on rocker"], angle=40.0)["drive"]
    alone = vad.forces(vad.solve(vad.FourBar(), angle=40.0), ["6 N m on rocker"]).drive
    assert driven[1] == alone
    assert np.isnan(driven[3])


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: vad.draw(vad.solve(vad.FourBar(crank=CRANKS))), "crank: must be one number here"),
        (lambda: vad.turn(vad.FourBar(crank=CRANKS)), "crank: must be one number here"),
        (
            lambda: vad.forces(vad.solve(vad.FourBar(crank=CRANKS))),
            "crank: must be one number here",
        ),
        (lambda: vad.FourBar(crank=[40.0, -2.0]), "crank: must be positive, got -2"),
        (lambda: vad.FourBar(crank=[40.0, np.inf]), "crank: must be a finite number"),
        (
            lambda: vad.solve(vad.FourBar(crank=CRANKS), angle=[1.0, 2.0]),
            r"shapes of the inputs do not broadcast: .*crank \(4,\)",
        ),
    ],
)
def test_what_cannot_be_names_the_dimension(call, message):
    with pytest.raises(vad.InputError, match=message):
        call()
