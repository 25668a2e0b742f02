"""A title and a subtitle of one's own, instead of the name of the mechanism."""

from __future__ import annotations

from typing import Any

from vad import gate

#: The most letters of a title and of a subtitle; a page may have room for fewer.
LONGEST = 120


def own_titles(title: str | None, subtitle: str | None) -> dict[str, Any]:
    """Return the titles that are given, as fields of a sheet.

    Raises
    ------
    vad.errors.InputError
        For one that is no line of text, is empty, or is too long for any page.

    Examples
    --------
    >>> own_titles("Exercise 4", None)
    {'title': 'Exercise 4'}
    """
    given = {"title": title, "subtitle": subtitle}
    return {name: checked(name, text) for name, text in given.items() if text is not None}


def checked(name: str, text: object) -> str:
    """Return a title or a subtitle without spaces about it; errors are those of `own_titles`."""
    return gate.filled(name, text, LONGEST)
