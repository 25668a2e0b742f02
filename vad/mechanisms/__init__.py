"""The mechanisms: each is one file of this folder, and other packages may bring more.

A mechanism that is called ``four-bar`` is declared in ``four_bar.py``.  A file is imported when its
mechanism is asked for.
"""

from collections.abc import Iterator, Mapping
from importlib import import_module

from vad.discovery import all_names, from_packages, names_in
from vad.errors import InputError, unknown
from vad.mechanisms.mechanism import LOADED, Mechanism

__all__ = ["GROUP", "MECHANISMS", "Mechanism", "class_named", "mechanism_named", "mechanism_names"]

#: The entry points under which other packages bring their mechanisms.
GROUP = "vad.mechanisms"
#: The files of this folder that declare no mechanism.
_FRAME = ("link_points", "mechanism")


class _Mechanisms(Mapping[str, type[Mechanism]]):
    """The mechanisms of this package by name, then those that somebody's program declares.

    Asking for the names imports nothing.
    """

    _OWN = tuple(name.replace("_", "-") for name in names_in("mechanisms") if name not in _FRAME)

    def __getitem__(self, name: str) -> type[Mechanism]:
        if name not in LOADED and name in self._OWN:
            import_module(f"{__name__}.{name.replace('-', '_')}")
        return LOADED[name]

    def __contains__(self, name: object) -> bool:
        return name in self._OWN or name in LOADED

    def __iter__(self) -> Iterator[str]:
        return iter(dict.fromkeys((*self._OWN, *LOADED)))

    def __len__(self) -> int:
        return len({*self._OWN, *LOADED})

    def __repr__(self) -> str:
        return f"<mechanisms {', '.join(self)}>"


#: Every mechanism class by the name that the command line knows.
MECHANISMS: Mapping[str, type[Mechanism]] = _Mechanisms()


def mechanism_names() -> tuple[str, ...]:
    """Return the names of all mechanisms: those of `MECHANISMS`, then those of other packages.

    Nothing is imported for it.
    """
    return all_names(tuple(MECHANISMS), GROUP)


def mechanism_named(name: str) -> type[Mechanism]:
    """Return the mechanism of a name: one of `MECHANISMS`, or one that another package brings.

    Other packages are asked only when `MECHANISMS` has no such name.  What a package brings is a
    subclass of `Mechanism`, or a module that declares one; its ``name`` is that of the entry point.

    Raises
    ------
    vad.errors.UsageError
        If there is no mechanism of that name.
    vad.errors.InputError
        If what another package brings cannot be imported, or is no mechanism of that name.

    Examples
    --------
    >>> mechanism_named("four-bar").title
    'Four-bar'
    """
    if name not in MECHANISMS:
        others = from_packages(GROUP)
        if name not in others:
            raise unknown("mechanism", name, mechanism_names())
        others[name]  # which declares the mechanism as it is imported
        if name not in MECHANISMS:
            raise InputError(f"mechanism '{name}': its package declares no mechanism of that name")
    return MECHANISMS[name]


def class_named(name: str) -> type[Mechanism] | None:
    """Return the class in `MECHANISMS` of a name such as FourBar; None if there is none.

    Examples
    --------
    >>> class_named("ScotchYoke").name
    'scotch-yoke'
    """
    likely_first = sorted(MECHANISMS, key=lambda each: each.replace("-", "") != name.lower())
    kinds = (MECHANISMS[each] for each in likely_first)
    return next((kind for kind in kinds if kind.__name__ == name), None)
