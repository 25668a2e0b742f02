"""The verb `batch`: from a file that says what a class is to get to a folder of sheets."""

from __future__ import annotations

import os
from collections.abc import Callable

from vad.batches.folder import Folder
from vad.batches.job import Done
from vad.batches.sheets import read_sheets
from vad.batches.workers import products
from vad.errors import UsageError, shown


def batch(
    path: str | os.PathLike[str],
    folder: str | os.PathLike[str],
    jobs: int = 1,
    *,
    cluster: str | None = None,
    only: int | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> list[Done]:
    """Make the sheets of a file: problems, keys, and all answers as ``answers.csv`` and ``.json``.

    Every sheet is the same for any number of workers.  One that stands in the folder already, made
    from the same settings, is not made again, so that a batch that was cut short goes on where it
    was.

    Parameters
    ----------
    path
        A ``.toml`` file with ``[sheet]``, ``[vary]`` and ``[keep]``, or a ``.csv`` file with one
        row a sheet.
    folder
        Where the files go; it is made if its parent is there.
    jobs
        How many processes work, this one among them; more than one need the extra ``batch``.
    cluster
        The address of the scheduler of a Dask cluster, which works instead; it needs the extra
        ``cluster``.
    only
        The number of one sheet, which is made again.
    progress
        Called after each sheet with how many are done and their total.

    Returns
    -------
    list of Done
        The sheets by number.  One that could not be made has an ``error``; the others are there.

    Raises
    ------
    vad.errors.InputError
        For what cannot be in the file, with its line.
    vad.errors.ExportError
        If the folder cannot be written, or a worker dies.
    """
    if not isinstance(jobs, int) or isinstance(jobs, bool) or jobs < 1:
        raise UsageError(f"jobs: must be a whole number from 1 on, got {shown(jobs)}")
    if cluster is not None and jobs != 1:
        raise UsageError("jobs: a cluster has its own workers", "leave out one of them")
    sheets = read_sheets(path)
    total = len(sheets.jobs) + len(sheets.failed)
    if only is not None and (isinstance(only, bool) or only not in range(1, total + 1)):
        raise UsageError(f"only: there is no sheet {shown(only)}", f"from 1 to {total}")
    target = Folder(folder)
    stand = (target.standing(job) for job in sheets.jobs if job.number != only)
    done = {each.number: each for each in (*sheets.failed, *stand) if each is not None}
    wanted = [job for job in sheets.jobs if job.number not in done and only in (None, job.number)]
    for count, product in enumerate(products(wanted, jobs, cluster), start=1):
        done[product.job.number] = target.take(product)
        if progress is not None:
            progress(count, len(wanted))
    ordered = [done[number] for number in sorted(done)]
    target.finish(ordered)
    return [each for each in ordered if only in (None, each.number)]
