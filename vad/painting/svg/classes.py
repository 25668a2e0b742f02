"""Looks become classes: each is written once, and named by what it says.

In come declarations of CSS, out go the names of classes and one style sheet.  In a picture with a
scope, which stands among others on a page, rules reach no further than that element, and names that
the whole page shares begin with it.
"""

from __future__ import annotations

from base64 import urlsafe_b64encode
from collections.abc import Collection
from functools import lru_cache
from zlib import crc32

from vad.painting.svg.grid import number
from vad.style import Look, Pen


class Classes:
    """The classes of one picture."""

    def __init__(self, scope: str = "") -> None:
        self.scope = scope
        self._rules: dict[str, str] = {}

    def name(self, *declarations: str) -> str:
        """Return the class that says ``declarations``; an empty one says nothing."""
        says = ";".join(each for each in declarations if each)
        name = named("c", says)
        self._rules[name] = says
        return name

    def sheet(self, known: Collection[str] = ()) -> str:
        """Return all classes but the known ones."""
        within = f"#{self.scope} " if self.scope else ""
        fresh = ((name, says) for name, says in self._rules.items() if name not in known)
        return "".join(f"{within}.{name}{{{says}}}\n" for name, says in fresh)

    def shared(self, name: str) -> str:
        """Return a name that no other picture on the page has: of an element, or of a font."""
        return f"{self.scope}-{name}" if self.scope else name


@lru_cache(maxsize=1024)
def named(initial: str, content: str) -> str:
    """Return a short name that speaks for its content.

    Examples
    --------
    >>> named("c", "fill:#000000"), named("c", "fill:#000001")
    ('cc_mF', 'cdMkT')
    """
    digest = crc32(content.encode()).to_bytes(4, "big")[1:]
    return initial + urlsafe_b64encode(digest).decode()


@lru_cache(maxsize=256)
def filled(look: Look) -> str:
    """Return the declarations of the area of a look."""
    if not look.fill:
        return ""
    return f"fill:{look.fill}" + _opacity("fill", look.alpha)


@lru_cache(maxsize=256)
def drawn(pen: Pen | None, unit: float, alpha: float = 1.0) -> str:
    """Return the declarations of a line, its widths in what a page unit is."""
    if not pen:
        return ""
    dash = " ".join(number(part * unit) for part in pen.dash)
    says = [f"stroke:{pen.colour}", f"stroke-width:{number(pen.width * unit)}"]
    says += [f"stroke-dasharray:{dash}"] if dash else []
    says += [f"stroke-linecap:{pen.cap}"] if pen.cap != "butt" else []
    says += [f"stroke-linejoin:{pen.join}"] if pen.join != "miter" else []
    return ";".join(says) + _opacity("stroke", alpha)


def _opacity(what: str, alpha: float) -> str:
    return f";{what}-opacity:{number(alpha, 3)}" if alpha != 1.0 else ""
