"""The base class of the things that a notebook displays: sheets, lessons and turns.

A notebook asks for their forms by a method of this class.
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
