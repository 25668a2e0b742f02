"""Easing: from [0, 1] to [0, 1], share of time to share of the stroke."""

from __future__ import annotations


def smooth(share: float) -> float:
    """Start and end gently: the cubic 3t² − 2t³.

    Examples
    --------
    >>> smooth(0.0), smooth(0.5), smooth(1.0)
    (0.0, 0.5, 1.0)
    """
    return share * share * (3.0 - 2.0 * share)
