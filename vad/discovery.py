"""Discovery: the files of a folder of this package, and what other packages provide.

Each style, language and mechanism is one file, and no table names them.  Another package brings
its own by entry points; in its ``pyproject.toml`` it says, for example::

    [project.entry-points."vad.styles"]
    blueprint = "my_package.blueprint:STYLE"

The groups are ``vad.mechanisms``, ``vad.styles`` and ``vad.languages``.  Reading the entry points
of all installed packages takes longer than drawing a picture needs, so they are read only when a
name is not one of this package's own, and where all names are listed.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import cache
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules
from typing import TYPE_CHECKING, Any

from vad.errors import InputError, one_of

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

_HOME = Path(__file__).parent


@cache
def names_in(*folder: str) -> tuple[str, ...]:
    """Return the names of the modules in a folder of this package, in alphabetical order.

    The folder is listed, its modules are not imported.

    Examples
    --------
    >>> names_in("style")
    ('chalk', 'paper', 'print')
    """
    return tuple(sorted(module.name for module in iter_modules([str(_HOME.joinpath(*folder))])))


@cache
def from_packages(group: str) -> Mapping[str, object]:
    """Return what other packages offer under a group of entry points, by name.

    An entry point names a module (``"my_package.es"``) or an object in one
    (``"my_package.blueprint:STYLE"``).  It is imported when it is taken from the mapping: asking
    for the names, or whether there is one of a name, imports nothing.

    Raises
    ------
    vad.errors.InputError
        When something is taken whose import fails; the message names the package.

    Examples
    --------
    >>> "blueprint" in from_packages("vad.styles")
    False
    """
    return _FromPackages(group)


def one_of_all(what: str, given: object, own: Collection[str], group: str) -> str:
    """Return ``given`` if it is one of this package's ``own`` names, or a name of another package.

    Other packages are asked only when the name is not an own one.

    Raises
    ------
    vad.errors.UsageError
        If there is no such name; the message calls it ``what``.

    Examples
    --------
    >>> one_of_all("style", "chalk", names_in("style"), "vad.styles")
    'chalk'
    """
    if isinstance(given, str) and given in own:
        return given
    return one_of(what, given, all_names(own, group))


def all_names(own: Collection[str], group: str) -> tuple[str, ...]:
    """Return this package's ``own`` names, and after them those that other packages add."""
    return (*own, *(name for name in from_packages(group) if name not in own))


def from_extra(module: str, extra: str) -> Any:
    """Return a module that comes with an extra of this package.

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


class _FromPackages(Mapping[str, object]):
    """The entry points of one group, each imported when it is asked for."""

    def __init__(self, group: str) -> None:
        from importlib.metadata import entry_points

        points = sorted(entry_points(group=group), key=lambda point: point.name)
        self._points: dict[str, EntryPoint] = {point.name: point for point in points}

    def __getitem__(self, name: str) -> object:
        point = self._points[name]
        try:
            return point.load()
        except Exception as error:  # whatever another package's module does on import
            package = point.dist.name if point.dist else point.module
            problem = f"{type(error).__name__}: {error}"
            raise InputError(f"'{name}' of the package '{package}': {problem}") from error

    def __contains__(self, name: object) -> bool:
        return name in self._points

    def __iter__(self) -> Iterator[str]:
        return iter(self._points)

    def __len__(self) -> int:
        return len(self._points)
