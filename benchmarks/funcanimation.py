"""The peer of `benchmarks.rendering`: the default slider-crank lecture as matplotlib animates it.

What the program's own film shows, at the same moments and in the same type: strokes with their
glow, letters with their halo, joints, hatching, compass and set square, equations, results and
captions.  Each is an artist that is made once; a frame shows what is there and sets the growing
stroke.  The right-angle marks and the ω arrow are left out.

``python -m benchmarks.funcanimation FILE AXES [FRAMES]`` writes an MP4 or a GIF.  AXES is "plain"
for panels without axes, as in the program's film, or "axes" for matplotlib's own.  FRAMES is how
many, spread evenly over the film, or all of them.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import matplotlib as mpl
import numpy as np
from matplotlib.animation import AbstractMovieWriter, FFMpegWriter, FuncAnimation, PillowWriter
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import FancyArrowPatch, Polygon
from matplotlib.patheffects import withStroke

import vad
from vad.lecture.lesson import Lesson
from vad.lecture.moment import Moment, moments
from vad.strokes.sheet import Arc, Arrow, Block, Dot, Guide, Line, Panel, Row, Shape, Stroke

INKS = ("#0072B2", "#D55E00", "#009E73", "#AA3377", "#000000")
TEXT, GREY = "#1A1A1A", "#6B6B6B"

FONT = {"font.family": "STIXGeneral", "mathtext.fontset": "stix"}
_SUBSCRIPTS = dict(zip("₂₃₄ₙ", "234n", strict=True))

Place = tuple[int, int]


class Scene:
    """A figure with three axes, and the artists of every stroke by panel and number."""

    def __init__(self, lesson: Lesson, plain: bool) -> None:
        sheet = lesson.sheet
        self.figure = Figure(figsize=(12.8, 7.2), dpi=100)
        self._panels = sheet.panels
        self._inks = {row.key: INKS[n % len(INKS)] for n, row in enumerate(sheet.rows)}
        self._strokes: dict[Place, Drawn] = {}
        self._revealed: dict[Place, list[Artist]] = {}
        given = ", ".join(f"{name} {value:g} {unit}" for name, value, unit in sheet.parameters)
        self._write(0.03, 0.93, sheet.title, size=24, weight="bold")
        self._write(0.97, 0.93, given, size=16, ha="right", color=GREY)
        self._caption = self._write(0.03, 0.03, "", size=20)
        self._count = self._write(0.97, 0.03, "", size=16, ha="right", color=GREY)
        for number, panel in enumerate(sheet.panels):
            left = 0.05 + 0.32 * number
            axes = self.figure.add_axes((left, 0.3, 0.27, 0.53))
            if plain:
                axes.axis("off")
            self._draw(number, panel, axes)
            self._write_results(number, panel, left, sheet.rows)

    def show(self, state: Moment) -> None:
        """Set every artist as it is at a moment."""
        finished, growing_now = divmod(state.beat, 2)
        for number, drawn in enumerate(self._strokes.values()):
            done = number < finished
            growing = bool(growing_now) and number == finished
            for artist in drawn.lasting:
                artist.set_visible(done or growing)
            for artist in drawn.passing:
                artist.set_visible(growing)
            if done or growing:
                drawn.grow(1.0 if done else state.share)
        places = list(self._strokes)
        for place, texts in self._revealed.items():
            for text in texts:
                text.set_visible(places.index(place) < finished)
        if state.beat:
            panel, stroke = places[min(finished - 1 + growing_now, len(places) - 1)]
            strokes = self._panels[panel].strokes
            self._caption.set_text(_mathematics(strokes[stroke].caption, words=True))
            self._count.set_text(f"{stroke + 1} / {len(strokes)}")

    def _draw(self, number: int, panel: Panel, axes: Axes) -> None:
        points = np.array([point for stroke in panel.strokes for point in _ends(stroke.shape)])
        size = max(np.ptp(points.real), np.ptp(points.imag))
        axes.set_aspect("equal", adjustable="box")
        axes.set_xlim(points.real.min() - 0.12 * size, points.real.max() + 0.12 * size)
        axes.set_ylim(points.imag.min() - 0.12 * size, points.imag.max() + 0.12 * size)
        for index, stroke in enumerate(panel.strokes):
            ink = self._inks.get(stroke.link or "", GREY)
            self._strokes[number, index] = _artists(axes, stroke, ink, size)

    def _write_results(self, number: int, panel: Panel, left: float, rows: Sequence[Row]) -> None:
        self._write(left, 0.86, panel.name.capitalize(), size=18, weight="bold")
        self._write(left + 0.27, 0.86, _mathematics(panel.unit), size=15, ha="right", color=GREY)
        for equation in panel.equations:
            terms = [*equation.left, *equation.right]
            for place, term in enumerate(terms):
                sign = "" if place == 0 else "=" if term is equation.right[0] else "+"
                ink = self._inks.get(term.link or "", GREY)
                at = left + 0.27 * place / len(terms)
                self._write(at, 0.23, f"{sign} {_mathematics(term.label)}", size=16, color=ink)
        for line, row in enumerate(rows):
            height = 0.18 - 0.04 * line
            if number == 0:
                self._write(left, height, f"{row.title} {_mathematics(row.letters)}", size=16)
            for cell in row.cells[panel.name]:
                value = f"${cell.symbol}$ = {cell.value:.4g} {_mathematics(cell.unit, words=True)}"
                text = self._write(left + 0.13, height, value, size=16)
                shown = [n for n, stroke in enumerate(panel.strokes) if row.key in stroke.reveals]
                if shown and not cell.given:
                    self._revealed.setdefault((number, shown[0]), []).append(text)

    def _write(self, x: float, y: float, text: str, **look: object) -> mpl.text.Text:
        return self.figure.text(x, y, text, **{"color": TEXT, **look})


@dataclass
class Drawn:
    """The artists of a stroke, those that show only while it grows, and what makes it grow."""

    lasting: list[Artist]
    passing: list[Artist] = field(default_factory=list)
    grow: Callable[[float], None] = lambda share: None


def _artists(axes: Axes, stroke: Stroke, ink: str, size: float) -> Drawn:
    shape = stroke.shape
    if isinstance(shape, Arrow):
        return _arrow(axes, shape, ink, stroke.component == "link")
    if isinstance(shape, (Line, Arc)):
        return _line(axes, shape, ink, stroke, size)
    if isinstance(shape, Guide):
        return Drawn([_hatching(axes, shape.through, shape.direction, 0.5 * size)])
    (mark,) = axes.plot([shape.at.real], [shape.at.imag], "o", color=TEXT, ms=7)
    marks: list[Artist] = [mark, _letter(axes, shape.at, stroke.label)]
    if stroke.kind == "fixed":
        (pivot,) = axes.plot([shape.at.real], [shape.at.imag], "^", color="none", mec=TEXT, ms=24)
        marks += [pivot, _hatching(axes, shape.at - 0.1j * size, 1, 0.15 * size)]
    if isinstance(shape, Block):
        (block,) = axes.plot([shape.at.real], [shape.at.imag], "s", color=ink, alpha=0.2, ms=36)
        marks.append(block)
    return Drawn(marks)


def _arrow(axes: Axes, shape: Arrow, ink: str, bar: bool) -> Drawn:
    look = {"color": ink, "lw": 6 if bar else 3, "shrinkA": 0, "shrinkB": 0}
    arrow = FancyArrowPatch(
        (0, 0), (1, 1), arrowstyle="-" if bar else "-|>", mutation_scale=20, **look
    )
    axes.add_patch(arrow)
    (glow,) = axes.plot([], [], color=ink, lw=14, alpha=0.2)
    ends = np.array([shape.start, shape.end])
    (dots,) = axes.plot(ends.real, ends.imag, "o", color="white" if bar else TEXT, mec=TEXT, ms=7)
    letters = [_letter(axes, *end) for end in zip(ends, (shape.tail, shape.head), strict=True)]

    def grow(share: float) -> None:
        tip = shape.start + share * (shape.end - shape.start)
        arrow.set_positions((shape.start.real, shape.start.imag), (tip.real, tip.imag))
        glow.set_data([shape.start.real, tip.real], [shape.start.imag, tip.imag])

    return Drawn([arrow, dots, *letters], [glow], grow)


def _line(axes: Axes, shape: Line | Arc, ink: str, stroke: Stroke, size: float) -> Drawn:
    path = _path(shape)
    dashed = stroke.kind == "construction"
    (line,) = axes.plot([], [], color=ink, lw=2, ls="--" if dashed else "-")
    name = _letter(axes, complex(path[-1]), stroke.label)
    if not dashed:
        return Drawn([line, name], [], lambda share: _set_path(line, path, share))
    (tip,) = axes.plot([], [], "o", color=ink, ms=9)
    tool = Polygon(np.zeros((3, 2)), facecolor=GREY, alpha=0.16, edgecolor=GREY)
    axes.add_patch(tool)

    def grow(share: float) -> None:
        _set_path(line, path, share)
        last, end = path[max(0, round(share * len(path)) - 2) :][:2]
        tip.set_data([end.real], [end.imag])
        along = (end - last) / abs(end - last) * 0.3 * size
        corners = end + np.array([0.1, -0.9, 0.1 + 0.58j]) * along
        tool.set_xy(np.column_stack([corners.real, corners.imag]))

    return Drawn([line], [name, tip, tool], grow)


def _set_path(line: Line2D, path: np.ndarray, share: float) -> None:
    drawn = path[: max(2, round(share * len(path)))]
    line.set_data(drawn.real, drawn.imag)


def _hatching(axes: Axes, at: complex, along: complex, length: float) -> Artist:
    feet = at + along * np.linspace(-length / 2, length / 2, 10)
    tips = feet + 0.08 * length * along * (-1 - 1j)
    rows = [(feet[0], feet[-1]), *zip(feet, tips, strict=True)]
    lines = LineCollection([[(z.real, z.imag) for z in row] for row in rows], color=GREY)
    axes.add_collection(lines)
    return lines


def _letter(axes: Axes, at: complex, text: str) -> Artist:
    halo = [withStroke(linewidth=5, foreground="white")]
    return axes.annotate(
        _mathematics(text),
        (at.real, at.imag),
        (8, 8),
        textcoords="offset points",
        size=20,
        color=TEXT,
        path_effects=halo,
    )


def _path(shape: Line | Arc) -> np.ndarray:
    shares = np.linspace(0.0, 1.0, 60)
    if isinstance(shape, Line):
        return shape.through + 1.06 * shares * (shape.until - shape.through)
    return shape.centre + shape.radius * np.exp(1j * np.radians(shape.start + shares * shape.sweep))


def _ends(shape: Shape) -> list[complex]:
    if isinstance(shape, Arrow):
        return [shape.start, shape.end]
    return [shape.at] if isinstance(shape, (Dot, Block)) else []


def _mathematics(text: str, words: bool = False) -> str:
    """Return a label, or the names in a sentence, as matplotlib sets mathematics."""
    if not re.search(r"[₂₃₄ₙ²]" if words else r"\w", text):
        return text
    pieces = re.split(r"([A-Za-zαωθ′]*[₂₃₄ₙ²]+′?)", text) if words else ["", text, ""]
    for place in range(1, len(pieces), 2):
        piece = re.sub(r"[₂₃₄ₙ]", lambda found: f"_{_SUBSCRIPTS[found.group()]}", pieces[place])
        pieces[place] = f"${piece.replace('²', '^2')}$"
    return "".join(pieces)


def writer(path: str, fps: float) -> AbstractMovieWriter:
    """Return matplotlib's own writer; FFmpeg gets the preset that the program has chosen."""
    if path.endswith(".gif"):
        return PillowWriter(fps=fps)
    import imageio_ffmpeg

    mpl.rcParams["animation.ffmpeg_path"] = imageio_ffmpeg.get_ffmpeg_exe()
    fast = ["-preset", "ultrafast", "-crf", "20", "-pix_fmt", "yuv420p"]
    return FFMpegWriter(fps=fps, codec="libx264", extra_args=fast)


def main(path: str, axes: str, count: str = "") -> None:
    """Write the film."""
    lesson = vad.animate(vad.draw(vad.solve(vad.SliderCrank())))
    states = [state for state, repeats in moments(lesson) for _ in range(repeats)]
    chosen = np.linspace(0, len(states) - 1, int(count or len(states))).round().astype(int)
    mpl.rcParams.update(FONT)
    scene = Scene(lesson, plain=axes == "plain")
    film = FuncAnimation(
        scene.figure, lambda number: scene.show(states[number]), chosen, init_func=lambda: None
    )
    film.save(path, writer(path, lesson.fps), dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
