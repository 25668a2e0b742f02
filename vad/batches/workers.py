"""The workers that make the sheets: this process, further processes beside it, or a cluster.

They take jobs, and return products in the order in which these are complete.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from contextlib import ExitStack
from functools import partial
from importlib import import_module
from itertools import islice
from typing import Any

from vad.batches.job import Job, Product
from vad.batches.making import make
from vad.errors import ExportError, InputError, quoted

#: Seconds in which a cluster must answer.
_PATIENCE = 10
#: Sheets that are with a worker at a time: the one that it makes, and one to go on with.
_AHEAD = 2


def products(jobs: Sequence[Job], workers: int, cluster: str | None) -> Iterator[Product]:
    """Yield the products of jobs.

    Parameters
    ----------
    jobs
        The sheets to be made.
    workers
        How many processes make them: this one, and the others beside it.
    cluster
        The address of the scheduler of a Dask cluster, which makes them instead.

    Raises
    ------
    vad.errors.InputError
        If a library that is needed for that is not installed, or nobody answers at the address.
    vad.errors.ExportError
        If a worker dies.
    """
    beside = min(workers, len(jobs)) - 1
    if cluster is None and beside < 1:
        yield from map(make, jobs)
        return
    try:
        with ExitStack() as stack:
            if cluster is None:
                pool = needed("joblib.externals.loky", "batch").ProcessPoolExecutor(beside)
                stack.callback(partial(pool.shutdown, kill_workers=True))
                yield from _shared(jobs, pool, beside, helping=True)
            else:
                client = stack.enter_context(_client(cluster))
                others = max(1, sum(client.nthreads().values()))
                yield from _shared(jobs, client.get_executor(), others, helping=False)
    except Exception as error:
        if not _is_dead_worker(error):
            raise
        hint = "start it again: what is done stays"
        raise ExportError("a worker died, perhaps for want of memory", hint) from error


def _shared(
    jobs: Sequence[Job], pool: Executor, others: int, *, helping: bool
) -> Iterator[Product]:
    """Yield what the workers of a pool make, and this process where it is ``helping``.

    It helps because starting a worker and its first sheet cost as much as several sheets.
    """
    left = iter(jobs)
    away: set[Future[Product]] = set()
    while True:
        here = list(islice(left, 1)) if helping else []
        more = islice(left, _AHEAD * others - len(away))
        away |= {pool.submit(_in_worker, job) for job in more}
        if not (here or away):
            return
        yield from map(make, here)
        done, away = wait(away, timeout=0 if here else None, return_when=FIRST_COMPLETED)
        yield from (each.result() for each in done)


def _in_worker(job: Job) -> Product:
    """Make a sheet in a worker; Ctrl+C reaches it, too, but the main process deals with that."""
    try:
        return make(job)
    except KeyboardInterrupt:
        return Product(job, error=InputError("interrupted"))


def needed(module: str, extra: str) -> Any:
    """Return a module that comes with an extra.

    Raises
    ------
    vad.errors.InputError
        If it is not installed.
    """
    try:
        return import_module(module)
    except ImportError:
        hint = f"pip install 'vad-diagrams[{extra}]'"
        raise InputError(f"{module.partition('.')[0]} is not installed", hint) from None


def _client(address: str) -> Any:
    """Return a connection to a cluster, which ends with its block."""
    distributed = needed("distributed", "cluster")
    try:
        return distributed.Client(address, timeout=_PATIENCE, set_as_default=True)
    except Exception as error:  # of the many kinds that its transports have
        said = str(error).partition("\n")[0] or type(error).__name__
        message = f"cluster: nobody answers at {quoted(address)} ({said})"
        raise InputError(message, "as in tcp://127.0.0.1:8786, where dask scheduler runs") from None


def _is_dead_worker(error: Exception) -> bool:
    return isinstance(error, BrokenExecutor) or type(error).__name__ == "KilledWorker"
