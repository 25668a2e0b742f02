"""Looks whose colours are the reader's choice: variables of CSS, with the colours of each theme.

Looks name variables, and rules give these variables their values, from styles.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from functools import lru_cache

from vad.painting.painter import Looks
from vad.plan.marks import Lettering, Mark
from vad.plan.roles import Ink
from vad.style import Look, Style, load_style, mix, style_names

#: The least contrast of letters to their ground.
CONTRAST = 4.5
#: Shares of ink that are tried, from all to none, when an ink is mixed with the colour of text.
_SHARES = [part / 20 for part in range(20, -1, -1)]


@dataclass(frozen=True, slots=True)
class Themed(Style):
    """A style whose colours are variables: ``var(--ink0)``."""

    def colour(self, ink: Ink, row: int | None) -> str:
        """Return the variable of an ink."""
        if ink not in ("row", "tint"):
            return f"var(--{ink})"
        if row is None:
            return "var(--grey)" if ink == "row" else "var(--tint)"
        return f"var(--{'ink' if ink == 'row' else 'tint'}{row % len(self.inks)})"


class Inks(Looks):
    """The looks of marks on a page in a style: letters are in inks that can be read."""

    def __init__(self, style: Style) -> None:
        self.style = themed(style)
        super().__init__(self.style)

    def __call__(self, mark: Mark) -> Look:
        """Return how a mark looks."""
        look = super().__call__(mark)
        return _legible(look) if isinstance(mark.shape, Lettering) and look.fill else look


@lru_cache(maxsize=64)
def _legible(look: Look) -> Look:
    return replace(look, fill=lettered(look.fill or ""))


def lettered(colour: str) -> str:
    """Return the variable of letters in an ink: dark or light enough to be read."""
    return colour.replace("--ink", "--letter")


def themed(style: Style) -> Themed:
    """Return a style with variables for colours."""
    told = {each.name: getattr(style, each.name) for each in fields(Style)}
    return Themed(**told | {"background": "var(--ground)"})


def themes(style: Style) -> list[Style]:
    """Return a style, and another one that differs from it in its colours alone."""
    others = (load_style(name) for name in style_names() if name != style.name)
    alike = [other for other in others if _lines(other) == _lines(style)]
    return [style, *alike[:1]]


def _lines(style: Style) -> tuple[object, ...]:
    return style.lines, style.key, style.erase, len(style.inks)


def variables(style: Style, rows: int) -> str:
    """Return the declarations of a style's colours that are needed for a number of rows."""
    colours = {ink: style.colour(ink, None) for ink in ("text", "grey", "hairline", "ground")}
    colours["tint"] = style.colour("tint", None)
    for row, ink in enumerate(style.inks[:rows]):
        colours[f"ink{row}"] = ink
        colours[f"tint{row}"] = style.colour("tint", row)
        colours[f"letter{row}"] = readable(ink, style)
    return "".join(f"--{name}:{colour};" for name, colour in colours.items())


def readable(ink: str, style: Style) -> str:
    """Return an ink for letters, mixed with the colour of text as far as contrast needs it.

    Examples
    --------
    >>> paper = load_style("paper")
    >>> readable("#0072B2", paper), readable("#D55E00", paper)
    ('#0072B2', '#C25703')
    """
    mixed = (mix(ink, style.text, share) for share in _SHARES)
    return next((c for c in mixed if contrast(c, style.background) >= CONTRAST), style.text)


def contrast(one: str, other: str) -> float:
    """Return the contrast of two colours as WCAG has it, 1 to 21."""
    low, high = sorted((_luminance(one), _luminance(other)))
    return (high + 0.05) / (low + 0.05)


def _luminance(colour: str) -> float:
    parts = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    red, green, blue = (p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue
