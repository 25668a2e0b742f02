"""Sharing of sheets between this process and a pool: each once, few at a time."""

from __future__ import annotations

import threading
from concurrent.futures import BrokenExecutor, Future, ThreadPoolExecutor

import pytest

import vad
from tests.batches.conftest import CLASS
from vad.batches import workers
from vad.batches.job import Job, Product
from vad.batches.sheets import read_sheets


@pytest.fixture
def jobs(written) -> list[Job]:
    return read_sheets(written(CLASS)).jobs


def test_each_sheet_is_made_once_and_this_process_helps(jobs, monkeypatch):
    made: list[tuple[int, bool]] = []

    def make(job: Job) -> Product:
        made.append((job.number, threading.current_thread() is threading.main_thread()))
        return Product(job)

    monkeypatch.setattr(workers, "make", make)
    with ThreadPoolExecutor(1) as pool:
        products = list(workers._shared(jobs, pool, 1, helping=True))
        assert sorted(each.job.number for each in products) == list(range(1, 11))
        assert sorted(number for number, _ in made) == list(range(1, 11))
        assert {here for _, here in made} == {True, False}
        made.clear()
        assert len(list(workers._shared(jobs, pool, 1, helping=False))) == 10
        assert not any(here for _, here in made)


def test_few_sheets_are_with_the_workers_at_a_time(jobs):
    class Slow(ThreadPoolExecutor):
        """Nothing is done before it is waited for."""

        sent = 0

        def submit(self, fn, /, *args, **kwargs) -> Future:
            self.sent += 1
            return super().submit(lambda: Product(*args))

    with Slow(1) as pool:
        for taken, _ in enumerate(workers._shared(jobs, pool, 3, helping=False), start=1):
            assert pool.sent - taken < 6


def test_a_worker_that_dies_is_told(jobs, monkeypatch):
    def died(*_: object, **__: object) -> None:
        raise BrokenExecutor

    monkeypatch.setattr(workers, "_shared", died)
    with pytest.raises(vad.ExportError, match="a worker died"):
        list(workers.products(jobs, 2, None))
