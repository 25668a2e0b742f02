"""On a cluster of two: the same sheets, and sweeps whose blocks are solved by its workers."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

import vad
from tests.batches.conftest import CLASS

distributed = pytest.importorskip("distributed", reason="it comes with the extra 'cluster'")

# What the libraries themselves leave behind when a cluster ends.
pytestmark = pytest.mark.filterwarnings("ignore::ResourceWarning")


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    with distributed.LocalCluster(
        n_workers=2,
        threads_per_worker=1,
        dashboard_address=None,
        local_directory=str(tmp_path_factory.mktemp("workers")),
    ) as cluster:
        yield cluster.scheduler_address


def test_a_cluster_makes_the_same_sheets(address, written, contents, tmp_path):
    path = written(CLASS.replace("10", "4"))
    vad.batch(path, tmp_path / "here")
    vad.batch(path, tmp_path / "there", cluster=address)
    assert contents(tmp_path / "here") == contents(tmp_path / "there")


def test_blocks_are_solved_by_the_workers(address):
    import dask.array as da

    angles = np.linspace(0.0, 360.0, 1001)
    with distributed.Client(address, set_as_default=True):
        angle = da.from_array(angles, chunks=250)
        swept = vad.sweep(vad.SliderCrank(), "C.acceleration", angle=angle, omega=10.0).compute()
    here = vad.solve(vad.SliderCrank(), angle=angles, omega=10.0).point("C").acceleration
    assert np.array_equal(swept["C.acceleration"], here)
