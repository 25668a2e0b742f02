"""The lines of words: title and parameters, panel heads with their scale bars, captions.

In come a sheet and its page, out go marks.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from vad.plan.art import Look
from vad.plan.marks import Mark, Pen, polyline, segments
from vad.plan.page import LONGEST_BAR, Page, PanelPlace
from vad.plan.scale import Scale, scale_bar
from vad.plan.text import Runs, bold, fitted, outline, roman, sentence, width, wrap, write
from vad.strokes.language import Language
from vad.strokes.sheet import Panel, Sheet
from vad.style import mix
from vad.written import given, quantity

TITLE = 0.050
PARAMETERS = 0.032
LEAST_PARAMETERS = 0.028
PANEL_TITLE = 0.037
SCALE = 0.030
CAPTION = 0.040
LEAST_CAPTION = 26.0 / 720.0
COUNT = 0.032
COUNT_ROOM = 0.095
_CENTIMETRES = {"mm": 0.1, "cm": 1.0, "m": 100.0}


def title_marks(sheet: Sheet, page: Page, look: Look) -> list[Mark]:
    """Return the title and, right of it, the parameters."""
    unit = look.unit
    title = bold(roman(sheet.title))
    room = page.right - page.left
    size = fitted(title, TITLE * unit, 0.036 * unit, 0.6 * room)
    marks = write(title, complex(page.left, page.title), size, look.style.text)
    items = [
        f"{name} {quantity(value, unit_, given=True)}" for name, value, unit_ in sheet.parameters
    ]
    room -= width(title, size) + 0.04 * unit
    lines = [items]
    if _line_width(items) * LEAST_PARAMETERS * unit > room:
        half = (len(items) + 1) // 2
        lines = [items[:half], items[half:]]
    widest = max(_line_width(line) for line in lines)
    most = PARAMETERS if len(lines) == 1 else LEAST_PARAMETERS
    size = min(most * unit, room / max(widest, 1e-9))
    for depth, line in enumerate(reversed(lines)):
        at = complex(page.right, page.title + depth * 1.25 * size)
        marks += write(_parameters(line), at, size, look.style.grey, "right")
    return marks


def _parameters(items: list[str]) -> Runs:
    return roman(",   ".join(items))


def _line_width(items: list[str]) -> float:
    return width(_parameters(items), 1.0)


def head_marks(
    panel: Panel, place: PanelPlace, scale: Scale, begun: bool, language: str, look: Look
) -> list[Mark]:
    """Return a panel's rule, title and scale bar; faint and bare before it is begun."""
    unit, style = look.unit, look.style
    left, right = place.drawing.left, place.drawing.right
    ink = style.text if begun else style.hairline
    rule = Pen(ink, 0.0020 * unit)
    marks = [polyline([complex(left, place.rule), complex(right, place.rule)], rule)]
    title = bold(roman(Language(language).say(panel.name)))
    pale = mix(style.grey, style.background, 0.55)
    marks += write(
        title,
        complex(left, place.title),
        PANEL_TITLE * unit,
        style.text if begun else pale,
    )
    if not begun or scale.factor == 1.0:
        return marks
    size = SCALE * unit
    if look.centimetre:
        value = look.centimetre / scale.factor
        runs = _stated(panel, value)
    else:
        value, runs = _scale(panel, scale, right - left - width(title, PANEL_TITLE * unit), look)
    marks += write(runs, complex(right, place.title), size, style.grey, "right")
    end = right - width(runs, size) - 0.0125 * unit
    start = end - value * scale.factor
    y, tick = place.title + 0.0098 * unit, 0.008 * unit
    pen = Pen(style.grey, 0.0028 * unit)
    marks.append(polyline([complex(start, y), complex(end, y)], pen))
    ticks = [(complex(x, y - tick), complex(x, y + tick)) for x in (start, end)]
    return [*marks, segments(ticks, pen)]


def _stated(panel: Panel, value: float) -> Runs:
    """Return what a centimetre of paper stands for, and the ratio where both are metric lengths."""
    text = f"1 cm = {quantity(value, panel.unit, given=True)}"
    ratio = value * _CENTIMETRES.get(panel.unit, 0.0)
    if ratio:
        text += f"   ({given(max(1.0, 1.0 / ratio))} : {given(max(1.0, ratio))})"
    return roman(text)


def _scale(panel: Panel, scale: Scale, room: float, look: Look) -> tuple[float, Runs]:
    """Return the value of the scale bar, and as text, so that both fit beside the title."""
    unit = look.unit
    longest = LONGEST_BAR * unit
    while True:
        value = scale_bar(scale.factor, longest)
        runs = roman(quantity(value, panel.unit, given=True))
        need = width(runs, SCALE * unit) + value * scale.factor + 0.035 * unit
        if need <= room or longest < 0.03 * unit:
            return value, runs
        longest *= 0.6


def italic_names(sheet: Sheet) -> frozenset[str]:
    """Return the letters and letter pairs that name points, vectors and quantities."""
    found = {"v", "x", "s"}
    for panel in sheet.panels:
        words = ("angle", "construction")  # whose labels have words in them
        strings = [stroke.label for stroke in panel.strokes if stroke.kind not in words]
        # An image is found by the ratio of two vectors, of which one is not drawn.
        ratios = (re.match(r"\D* ([a-z]{2})/", s.caption) for s in panel.strokes if s.image)
        strings += [ratio.group(1) for ratio in ratios if ratio]
        for equation in panel.equations:
            strings += [term.label for term in (*equation.left, *equation.right)]
        for text in strings:
            found |= {token for token in re.findall(r"[A-Za-z]+", text) if len(token) <= 2}
    for row in sheet.rows:
        found |= {token for token in re.findall(r"[A-Za-z]+", row.letters) if len(token) <= 2}
        found |= {cell.symbol for cells in row.cells.values() for cell in cells}
    singles = {letter for name in found for letter in name if letter.isalpha()}
    return frozenset(found | singles) - {"mm", "cm", "ft", "in", "m"}


def _setter(sheet: Sheet) -> Callable[[str], Runs]:
    names = italic_names(sheet)
    article = Language(sheet.language).article
    return lambda text: sentence(text, names, article)


def _caption_size(text: str, setter: Callable[[str], Runs], room: float, unit: float) -> float:
    """Return the size at which a caption fits one line, or the full size for two lines."""
    size = CAPTION * unit
    least = LEAST_CAPTION * unit
    advance = outline(setter(text)).advance
    return size if advance * least > room else min(size, room / max(advance, 1e-9))


def caption_lines(sheet: Sheet, room: float, unit: float) -> int:
    """Return how many lines the sheet's longest caption takes."""
    setter = _setter(sheet)
    most = 1
    for panel in sheet.panels:
        for stroke in panel.strokes:
            most = max(most, len(_set(stroke.caption, setter, room, unit)[0]))
    return most


def _set(
    text: str, setter: Callable[[str], Runs], room: float, unit: float
) -> tuple[list[Runs], float]:
    room -= COUNT_ROOM * unit
    size = _caption_size(text, setter, room, unit)
    lines = wrap(text, setter, size, room * (1 + 1e-9))
    if len(lines) > 2:
        size = LEAST_CAPTION * unit
        lines = wrap(text, setter, size, room)
    return lines, size


def caption_marks(sheet: Sheet, panel: Panel, index: int, page: Page, look: Look) -> list[Mark]:
    """Return the caption of a step and the number of its stroke in the panel."""
    room = page.right - page.left
    lines, size = _set(panel.strokes[index].caption, _setter(sheet), room, look.unit)
    marks: list[Mark] = []
    baselines = page.captions[max(len(page.captions) - len(lines), 0) :]
    if len(lines) < len(page.captions):
        baselines = page.captions[: len(lines)]
    for runs, baseline in zip(lines, baselines, strict=False):
        marks += write(runs, complex(page.left, baseline), size, look.style.text)
    count = roman(f"{index + 1} / {len(panel.strokes)}")
    at = complex(page.right, page.captions[-1])
    return marks + write(count, at, COUNT * look.unit, look.style.grey, "right")
