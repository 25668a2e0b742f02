"""Who makes the sheets: this process, further ones beside it, or a cluster.

In come jobs, out come products in the order in which they are done.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from importlib import import_module
from typing import Any

from vad.batches.job import Job, Product
from vad.batches.making import make
from vad.errors import ExportError, InputError, shown

#: Seconds in which a cluster must answer.
_PATIENCE = 10


def products(jobs: Sequence[Job], workers: int, cluster: str | None) -> Iterator[Product]:
    """Yield what becomes of jobs.

    Parameters
    ----------
    jobs
        The sheets to be made.
    workers
        How many processes make them; 1 is this one alone.
    cluster
        The address of the scheduler of a Dask cluster, which makes them instead.

    Raises
    ------
    vad.errors.InputError
        If a library that is needed for that is not installed, or nobody answers at the address.
    vad.errors.ExportError
        If a worker dies.
    """
    if cluster is None and workers == 1:
        yield from map(make, jobs)
        return
    joblib = needed("joblib", "batch")
    try:
        with ExitStack() as stack:
            if cluster is not None:
                stack.enter_context(_client(cluster))
                stack.enter_context(joblib.parallel_config(backend="dask"))
            parallel = joblib.Parallel(
                n_jobs=workers if cluster is None else -1,
                return_as="generator_unordered",
                batch_size=1,
            )
            yield from parallel(joblib.delayed(_elsewhere)(job) for job in jobs)
    except Exception as error:
        if not _is_death(error):
            raise
        hint = "start it again: what is done stays"
        raise ExportError("a worker died, perhaps for want of memory", hint) from error


def _elsewhere(job: Job) -> Product:
    """Make a sheet in a worker; Ctrl+C reaches it, too, but what follows is its master's affair."""
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
        message = f"cluster: nobody answers at {shown(address)} ({said})"
        raise InputError(message, "as in tcp://127.0.0.1:8786, where dask scheduler runs") from None


def _is_death(error: Exception) -> bool:
    return type(error).__name__ in ("TerminatedWorkerError", "BrokenProcessPool", "KilledWorker")
