"""Poses in blocks, which two threads share where that takes less time.

numpy and a compiled loop leave Python to other threads while they calculate.  What lies between two
calculations is done by one thread at a time; so they share long blocks alone.
"""

from __future__ import annotations

import os
import sys
import threading
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from contextvars import copy_context

# From this number of poses on two threads share them.  Where a second processor is idle, they take
# two thirds of the time for the four results of a four-bar, by numpy as in a compiled loop.
SHARED = 250_000
# The poses of a block that is one of many for two threads.
BLOCK = 32_768

# What does the work of one thread, block after block.
Work = Callable[[slice], None]


def in_blocks(poses: int, block: int, thread: Callable[[int], Work]) -> None:
    """Do a work for each block of poses.

    Parameters
    ----------
    poses, block
        Their number, and that of the poses of a block, if one thread works.
    thread
        What makes the work of a thread, which has its own memory, for blocks of at most so many
        poses.
    """
    shared = two_threads(poses)
    size = min(BLOCK if shared else block, poses)
    starts = deque(range(0, poses, size or 1))

    def run(work: Work, take: Callable[[], int]) -> None:
        while starts:  # each round takes one of them
            try:
                start = take()
            except IndexError:  # the other thread has taken the last one
                return
            work(slice(start, min(start + size, poses)))

    if not shared:
        run(thread(size), starts.popleft)
        return
    failed: list[BaseException] = []

    def help_out() -> None:
        try:
            run(thread(size), starts.pop)
        except BaseException as error:  # the other thread ends, too, and raises it
            starts.clear()
            failed.append(error)

    # One begins at the end: if both were at one page of new memory, the system would make it twice.
    # What numpy does not warn of is in the context.
    helper = threading.Thread(target=copy_context().run, args=(help_out,))
    with suppress(RuntimeError):  # where no more threads may start, this one does all
        helper.start()
    try:
        run(thread(size), starts.popleft)
    finally:
        starts.clear()  # if this thread is interrupted, the other one ends, too
        if helper.is_alive():
            helper.join()
    if failed:
        raise failed[0]


def two_threads(poses: int) -> bool:
    """Tell whether two threads are to share so many poses.

    Not in a thread or a process that somebody has started beside others, such as those of Dask and
    of a batch: together they use all processors already.
    """
    if poses < SHARED or threading.current_thread() is not threading.main_thread():
        return False
    processes = sys.modules.get("multiprocessing.process")
    if processes and processes.parent_process():
        return False
    allowed = getattr(os, "sched_getaffinity", None)  # not on macOS and Windows
    return (len(allowed(0)) if allowed else os.cpu_count() or 1) > 1
