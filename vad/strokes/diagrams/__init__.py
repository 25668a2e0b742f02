"""The kinds of diagrams: each module of this package declares one, and no table lists them."""

from importlib import import_module
from pkgutil import iter_modules

from vad.strokes.diagram import Diagram

_FOUND: list[Diagram] = [
    import_module(f"{__name__}.{module.name}").DIAGRAM for module in iter_modules(__path__)
]

#: Every diagram by its name, in the order in which they stand on the page.
DIAGRAMS = {diagram.name: diagram for diagram in sorted(_FOUND, key=lambda found: found.rank)}

__all__ = ["DIAGRAMS", "Diagram"]
