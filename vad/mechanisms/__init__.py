"""The mechanisms: every module of this package that declares one is found by itself."""

from importlib import import_module
from pkgutil import iter_modules

from vad.mechanisms.mechanism import MECHANISMS, Mechanism

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")

__all__ = ["MECHANISMS", "Mechanism"]
