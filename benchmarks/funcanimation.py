"""The peer of `benchmarks.rendering`: the default slider-crank lecture as matplotlib animates it.

The same strokes, labels, captions, results and moments as the program's own film, each of them an
artist that is made once; a frame shows what is there and sets the growing stroke.  Where there was
a choice, the cheaper artist was taken: no axes and ticks, plain text, no glow, set square or hatch.

``python -m benchmarks.funcanimation FILE [FRAMES]`` writes an MP4 or a GIF of so many frames,
spread evenly over the film; of all frames if none are given.
"""

from __future__ import annotations

import sys
from collections.abc import Callable

import matplotlib as mpl
import numpy as np
from matplotlib.animation import AbstractMovieWriter, FFMpegWriter, FuncAnimation, PillowWriter
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import vad
from vad.diagrams.strokes import Arc, Arrow, Block, Dot, Guide, Line, Panel, Row
from vad.lecture.lesson import Lesson
from vad.lecture.moment import Moment, moments

INKS = ("#0072B2", "#D55E00", "#009E73", "#AA3377", "#000000")
TEXT, GREY = "#1A1A1A", "#6B6B6B"
FONT = {"font.family": "STIXGeneral", "font.size": 20}

#: Shows a share of a stroke.
Grow = Callable[[float], None]


class Scene:
    """A figure with three panels, and the artists of every stroke."""

    def __init__(self, lesson: Lesson) -> None:
        self.figure = Figure(figsize=(12.8, 7.2), dpi=100)
        self.panels = lesson.sheet.panels
        self._inks = {
            row.key: INKS[number % len(INKS)] for number, row in enumerate(lesson.sheet.rows)
        }
        self._grow: dict[tuple[int, int], Grow] = {}
        self._strokes: dict[tuple[int, int], list[Artist]] = {}
        self._cells: dict[tuple[int, int], list[Artist]] = {}
        self.figure.text(0.03, 0.93, lesson.sheet.title, size=26, weight="bold", color=TEXT)
        given = ", ".join(f"{name} {value:g} {unit}" for name, value, unit in lesson.sheet.parameters)
        self.figure.text(0.97, 0.93, given, size=17, ha="right", color=GREY)
        self._caption = self.figure.text(0.03, 0.03, "", size=20, color=TEXT)
        self._count = self.figure.text(0.97, 0.03, "", size=17, ha="right", color=GREY)
        for number, panel in enumerate(self.panels):
            self._lay_out(number, panel, lesson.sheet.rows)

    def show(self, state: Moment) -> None:
        """Set every artist as it is at a moment."""
        for (panel, stroke), artists in self._strokes.items():
            done = stroke < state.done[panel]
            growing = (panel, stroke) == (state.panel, state.stroke) and state.grown is not None
            for artist in artists:
                artist.set_visible(done or growing)
            if done or growing:
                self._grow[panel, stroke](1.0 if state.grown is None or done else state.grown)
        for (panel, stroke), artists in self._cells.items():
            for artist in artists:
                artist.set_visible(stroke < state.done[panel])
        if state.panel is not None:
            strokes = self.panels[state.panel].strokes
            self._caption.set_text(strokes[state.stroke].caption)
            self._count.set_text(f"{state.stroke + 1} / {len(strokes)}")

    def _lay_out(self, number: int, panel: Panel, rows: tuple[Row, ...]) -> None:
        left = 0.03 + 0.32 * number
        axes = self.figure.add_axes((left, 0.28, 0.29, 0.55))
        axes.axis("off")
        axes.set_aspect("equal")
        self.figure.text(left, 0.85, panel.name.capitalize(), size=19, weight="bold", color=TEXT)
        self.figure.text(left + 0.29, 0.85, panel.unit, size=15, ha="right", color=GREY)
        points = [point for stroke in panel.strokes for point in _ends(stroke.shape)]
        across, up = np.real(points), np.imag(points)
        room = 0.12 * max(np.ptp(across), np.ptp(up))
        axes.set_xlim(across.min() - room, across.max() + room)
        axes.set_ylim(up.min() - room, up.max() + room)
        for index, stroke in enumerate(panel.strokes):
            ink = self._inks.get(stroke.link or "", GREY)
            self._strokes[number, index], self._grow[number, index] = _artists(
                axes, stroke.shape, ink, stroke.label, dashed=stroke.kind == "construction"
            )
        for equation in panel.equations:
            words = (
                " + ".join(term.label for term in equation.left),
                " + ".join(term.label for term in equation.right),
            )
            text = _plain(" = ".join(words))
            self.figure.text(left + 0.145, 0.23, text, size=18, ha="center", color=TEXT)
        for line, row in enumerate(rows):
            height = 0.19 - 0.04 * line
            if number == 0:
                self.figure.text(left, height, f"{row.title} {row.letters}", size=17, color=TEXT)
            for cell in row.cells[panel.name]:
                text = f"{cell.symbol} = {cell.value:.4g} {cell.unit}"
                artist = self.figure.text(left + 0.15, height, text, size=17, color=TEXT)
                shown = [i for i, stroke in enumerate(panel.strokes) if row.key in stroke.reveals]
                if shown and not cell.given:
                    self._cells.setdefault((number, shown[0]), []).append(artist)


def _artists(
    axes: Axes, shape: object, ink: str, label: str, *, dashed: bool
) -> tuple[list[Artist], Grow]:
    """Return the artists of a shape, and what sets how much of it is drawn."""
    if isinstance(shape, Arrow):
        (line,) = axes.plot([], [], color=ink, lw=3.1)
        (head,) = axes.plot([], [], color=ink, marker=(3, 0, 0), ms=10)
        ends = [_letter(axes, shape.start, shape.tail), _letter(axes, shape.end, shape.head)]

        def grow(share: float, shape: Arrow = shape) -> None:
            tip = shape.start + share * (shape.end - shape.start)
            line.set_data([shape.start.real, tip.real], [shape.start.imag, tip.imag])
            turn = np.degrees(np.angle(shape.end - shape.start)) - 90.0
            head.set_data([tip.real], [tip.imag])
            head.set_marker((3, 0, turn))

        return [line, head, *ends], grow
    if isinstance(shape, (Line, Arc)):
        (line,) = axes.plot([], [], color=ink, lw=2.4, dashes=(5, 3.2) if dashed else ())
        path = _path(shape)
        text = _letter(axes, complex(path[-1]), label)

        def grow_along(share: float) -> None:
            drawn = path[: max(2, round(share * len(path)))]
            line.set_data(drawn.real, drawn.imag)

        return [line, text], grow_along
    at = shape.through if isinstance(shape, Guide) else getattr(shape, "at", 0j)
    marker = {Dot: "o", Block: "s"}.get(type(shape), "_")
    (dot,) = axes.plot([at.real], [at.imag], color=ink, marker=marker, ms=7)
    return [dot, _letter(axes, at, label)], lambda share: None


def _letter(axes: Axes, at: complex, text: str) -> Artist:
    return axes.annotate(
        _plain(text), (at.real, at.imag), (8, 8), textcoords="offset points", color=TEXT
    )


def _path(shape: Line | Arc) -> np.ndarray:
    if isinstance(shape, Line):
        return shape.through + np.linspace(0.0, 1.06, 60) * (shape.until - shape.through)
    angles = np.radians(shape.start + np.linspace(0.0, shape.sweep, 60))
    return shape.centre + shape.radius * np.exp(1j * angles)


def _ends(shape: object) -> list[complex]:
    if isinstance(shape, Arrow):
        return [shape.start, shape.end]
    return [shape.at] if isinstance(shape, (Dot, Block)) else []


def _plain(text: str) -> str:
    """Return ``text`` without the subscripts that the font lacks."""
    return text.translate(str.maketrans("ₙ₂₃₄", "n234"))


def writer(path: str, fps: float) -> AbstractMovieWriter:
    """Return matplotlib's own writer; FFmpeg gets the program's preset."""
    if path.endswith(".gif"):
        return PillowWriter(fps=fps)
    import imageio_ffmpeg

    mpl.rcParams["animation.ffmpeg_path"] = imageio_ffmpeg.get_ffmpeg_exe()
    fast = ["-preset", "ultrafast", "-crf", "20", "-pix_fmt", "yuv420p"]
    return FFMpegWriter(fps=fps, codec="libx264", extra_args=fast)


def main(path: str, count: int | None = None) -> None:
    """Write the film."""
    lesson = vad.animate(vad.draw(vad.solve(vad.SliderCrank(), angle=60.0, omega=10.0)))
    states = [state for state, repeats in moments(lesson) for _ in range(repeats)]
    chosen = range(len(states)) if count is None else np.linspace(0, len(states) - 1, count)
    mpl.rcParams.update(FONT)
    scene = Scene(lesson)
    film = FuncAnimation(
        scene.figure,
        lambda frame: scene.show(states[round(frame)]),
        frames=list(chosen),
        init_func=lambda: None,
        interval=1000 / lesson.fps,
    )
    film.save(path, writer(path, lesson.fps), dpi=100)


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:]))
