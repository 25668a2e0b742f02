"""What pages have in common: in come the contents of pages, group by group, out go pieces."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from itertools import pairwise


def pieces(pages: Sequence[Sequence[str]]) -> list[list[str]]:
    """Return each page in as few pieces as can be, none of which is part of another.

    Two groups are in one piece where they follow each other on every page that has either.

    Examples
    --------
    >>> for page in pieces([["a", "b", "c"], ["a", "b", "x", "c"]]):
    ...     print([piece.splitlines() for piece in page])
    [['a', 'b'], ['c']]
    [['a', 'b'], ['x'], ['c']]
    """
    after: dict[str, set[str]] = defaultdict(set)
    before: dict[str, set[str]] = defaultdict(set)
    for page in pages:
        for one, other in pairwise(["", *page, ""]):
            after[one].add(other)
            before[other].add(one)
    found: list[list[str]] = []
    for page in pages:
        runs: list[list[str]] = []
        for one, other in pairwise(["", *page]):
            if after[one] == {other} and before[other] == {one} and runs:
                runs[-1].append(other)
            else:
                runs.append([other])
        found.append(["\n".join(run) for run in runs])
    return found
