"""Base class of what shows itself in a notebook: sheets, lessons and turns.

In comes anything that can be seen, out goes what a notebook asks of it.
"""

from __future__ import annotations

from collections.abc import Container


class Displayed:
    """A thing that a notebook shows when it is the value of a cell."""

    __slots__ = ()

    def _repr_mimebundle_(
        self, include: Container[str] | None = None, exclude: Container[str] | None = None
    ) -> dict[str, str]:
        """Return the thing in every form that a viewer may know, by its MIME type."""
        from vad.notebook import bundle

        return bundle(self, include, exclude)
