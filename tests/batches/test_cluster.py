"""On a cluster of two: the same sheets, and sweeps whose blocks are solved by its workers."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import vad
from tests.batches.conftest import CLASS
from vad.batches import workers

distributed = pytest.importorskip("distributed", reason="it comes with the extra 'cluster'")

# What the libraries themselves leave behind when a cluster ends.
pytestmark = pytest.mark.filterwarnings("ignore::ResourceWarning")


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    with distributed.LocalCluster(
        n_workers=2,
        threads_per_worker=1,
        dashboard_address="127.0.0.1:0",  # None is the usual port in earlier versions
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


@pytest.fixture
def scheduler(tmp_path: Path) -> Iterator[tuple[str, subprocess.Popen[bytes]]]:
    """Start a scheduler as a process of its own; yield its address with it."""
    script = (
        "import asyncio, sys\n"
        "from distributed import Scheduler, Worker\n"
        "async def main():\n"
        "    async with Scheduler(host='127.0.0.1', dashboard=False) as scheduler:\n"
        "        if sys.argv[1:]:\n"
        "            await Worker(scheduler.address, nthreads=1, dashboard=False)\n"
        "        print(scheduler.address, flush=True)\n"
        "        await scheduler.finished()\n"
        "asyncio.run(main())\n"
    )
    with subprocess.Popen(
        [sys.executable, "-c", script, "worker"],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])},
        cwd=tmp_path,
    ) as running:
        assert running.stdout is not None
        yield running.stdout.readline().decode().strip(), running
        running.kill()


def test_a_scheduler_that_dies_is_told_in_one_sentence(scheduler, written, tmp_path):
    address, running = scheduler

    def kill(done: int, total: int) -> None:
        if done:
            running.kill()
            running.wait()

    with pytest.raises(vad.ExportError) as caught:
        vad.batch(
            written(CLASS.replace("10\n", "99\n")),
            tmp_path / "out",
            cluster=address,
            progress=kill,
        )
    assert str(caught.value).startswith("cluster: ")
    assert repr(address)[1:-1] in str(caught.value)
    assert caught.value.hint == "start it again: what is done stays"


def test_a_cluster_without_workers_is_not_waited_for(monkeypatch):
    class Client:
        """A cluster that answers, and whose workers have gone."""

        def nthreads(self) -> dict[str, int]:
            return {}

        def get_executor(self) -> None:
            return None

        def __enter__(self) -> Client:
            return self

        def __exit__(self, *_: object) -> None:
            pass

    monkeypatch.setattr(workers, "_client", lambda _: Client())
    monkeypatch.setattr(workers, "_shared", lambda *_, **__: iter(lambda: time.sleep(0.01), 3))
    monkeypatch.setattr(workers, "_PATIENCE", 0.05)
    with pytest.raises(vad.ExportError, match="cluster: it has no workers"):
        list(workers.products([], 1, "tcp://127.0.0.1:1"))


def test_other_calculations_of_a_program_do_not_go_there(address):
    """A cluster that has died would never answer them."""
    with workers._client(address), pytest.raises(ValueError, match=r"[Nn]o client"):
        distributed.client.default_client()
