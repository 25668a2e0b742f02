"""The workers that make the sheets: this process, further processes beside it, or a cluster.

They take jobs, and return products in the order in which these are complete.  Processes of this
machine end with this one, whatever ends it, and leave nothing behind: what comes from the terminal
does not reach them, their temporary files are in a folder of this process, and they look whether it
still lives.
"""

from __future__ import annotations

import multiprocessing
import os
import shutil
import signal
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    CancelledError,
    Executor,
    Future,
    wait,
)
from contextlib import ExitStack, contextmanager, suppress
from functools import partial
from itertools import islice
from multiprocessing import resource_tracker
from pathlib import Path
from typing import Any

from vad.batches.job import Job, Product
from vad.batches.making import make
from vad.discovery import from_extra
from vad.errors import ExportError, InputError, VadError, quoted
from vad.export.files import cleared_up, temporary_folder

#: Seconds in which a cluster must answer; it may be without a worker for twice as long.
_PATIENCE = 10
#: Sheets that are with a worker at a time: the one that it makes, and one to go on with.
_AHEAD = 2
#: Seconds between two glances: of a worker at its process, and of that one at what is done.
_GLANCE = 0.5
_DIED, _AGAIN = "a worker died, perhaps for want of memory", "start it again: what is done stays"
#: What a terminal, or the end of a login, sends to all processes at once.
_SIGNALS = [getattr(signal, name) for name in ("SIGINT", "SIGHUP") if hasattr(signal, name)]
_KILL = getattr(signal, "SIGKILL", signal.SIGTERM)


def products(jobs: Sequence[Job], workers: int, cluster: str | None) -> Iterator[Product | None]:
    """Yield the products of jobs, and None at each glance at which there is no new one.

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
        If a worker dies, or the scheduler of the cluster.
    """
    beside = min(workers, len(jobs)) - 1
    if cluster is not None:
        yield from _on_cluster(jobs, cluster)
    elif beside < 1:
        yield from map(make, jobs)
    else:
        try:
            with _processes(beside) as pool:
                yield from _shared(jobs, pool, beside, helping=True)
        except BrokenExecutor as error:
            raise ExportError(_DIED, _AGAIN) from error


def _on_cluster(jobs: Sequence[Job], address: str) -> Iterator[Product | None]:
    """Yield what a cluster makes."""
    with ExitStack() as stack:
        client = stack.enter_context(_client(address))
        try:
            others = max(1, sum(client.nthreads().values()))
            pool = client.get_executor()
            idle_since, alone = time.monotonic(), False
            for product in _shared(jobs, pool, others, helping=False):
                yield product
                if product is not None:
                    idle_since, alone = time.monotonic(), False
                elif time.monotonic() - idle_since > _PATIENCE:
                    was_alone, alone = alone, not client.nthreads()
                    if alone and was_alone:
                        raise ExportError("cluster: it has no workers", _AGAIN)
                    idle_since = time.monotonic()
        except VadError:
            raise
        except CancelledError as error:
            gone = f"cluster: the scheduler at {quoted(address)} has ended"
            raise ExportError(gone, _AGAIN) from error
        except Exception as error:  # of the many kinds that its transports have
            name, said = type(error).__name__, str(error).partition("\n")[0]
            if name == "KilledWorker":
                raise ExportError(f"cluster: {_DIED}", _AGAIN) from error
            makes = f"cluster: {quoted(address)} makes no sheets ({said or name})"
            raise ExportError(makes, _AGAIN) from error


@contextmanager
def _processes(count: int) -> Iterator[Executor]:
    """Yield a pool of processes, which end with the block."""
    loky = from_extra("joblib.externals.loky", "batch")
    with temporary_folder() as folder, cleared_up(_kill_children), ExitStack() as stack:
        with _unheard(_SIGNALS) as unheard:
            if os.name == "posix":
                resource_tracker.ensure_running()
            pool = loky.ProcessPoolExecutor(
                count,
                initializer=_end_with,
                initargs=(os.getpid(), folder),
                env={"TMPDIR": str(folder)},
            )
            stack.callback(partial(pool.shutdown, kill_workers=True))
            unheard()  # again, because the start of a resource tracker lets some of them through
            pool.submit(os.getpid)  # the first task starts the processes
        yield pool


@contextmanager
def _unheard(signals: Sequence[int]) -> Iterator[Callable[[], object]]:
    """Let processes that are started in the block never hear these signals.

    This process hears them when the block ends.  Yields what begins that, if it is interrupted.
    """
    if not hasattr(signal, "pthread_sigmask"):  # on Windows
        yield lambda: None
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, signals)
    try:
        yield partial(signal.pthread_sigmask, signal.SIG_BLOCK, signals)
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _kill_children() -> None:
    for child in multiprocessing.active_children():
        with suppress(OSError):
            os.kill(child.pid or 0, _KILL)


def _end_with(parent: int, folder: Path) -> None:
    """End this process soon after its parent has died, and remove the folder that it had."""

    def watch() -> None:
        # Waits as long as the parent lives.
        while os.getppid() == parent:
            time.sleep(_GLANCE)
        shutil.rmtree(folder, ignore_errors=True)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


def _shared(
    jobs: Sequence[Job], pool: Executor, others: int, *, helping: bool
) -> Iterator[Product | None]:
    """Yield what the workers of a pool make, and this process where it is ``helping``.

    It helps because starting a worker and its first sheet cost as much as several sheets.
    """
    left = iter(jobs)
    away: set[Future[Product]] = set()
    while True:  # each round takes a job, or waits for one that is away, until none is left
        here = list(islice(left, 1)) if helping else []
        more = islice(left, _AHEAD * others - len(away))
        away |= {pool.submit(make, job) for job in more}
        if not (here or away):
            return
        yield from map(make, here)
        done, away = wait(away, timeout=0 if here else _GLANCE, return_when=FIRST_COMPLETED)
        yield from (each.result() for each in done)
        if not (here or done):
            yield None


def _client(address: str) -> Any:
    """Return a connection to a cluster, which ends with its block; arrays of dask do not use it."""
    distributed = from_extra("distributed", "cluster")
    try:
        return distributed.Client(address, timeout=_PATIENCE, set_as_default=False)
    except Exception as error:  # of the many kinds that its transports have
        said = str(error).partition("\n")[0] or type(error).__name__
        message = f"cluster: nobody answers at {quoted(address)} ({said})"
        raise InputError(message, "as in tcp://127.0.0.1:8786, where dask scheduler runs") from None
