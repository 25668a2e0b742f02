"""What is found by itself: the modules of a folder, each of them one style or one language.

A folder is listed without being imported, so that a film knows which styles there are before
anything is painted.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from pkgutil import iter_modules

_HOME = Path(__file__).parent


@cache
def names_in(*folder: str) -> tuple[str, ...]:
    """Return the names of the modules in a folder of this package, in alphabetical order.

    Examples
    --------
    >>> names_in("style")
    ('chalk', 'paper', 'print')
    """
    return tuple(sorted(module.name for module in iter_modules([str(_HOME.joinpath(*folder))])))
