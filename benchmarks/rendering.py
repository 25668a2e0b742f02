"""What films and pictures cost: whole processes, as ratios within one run.

The film is the default slider-crank lecture at 1280×720 and 30 frames a second.  Every process
is started several times in turn with the others, files in the cache, and the fastest start
counts.  Before anything is timed, each incremental frame of the film must equal its full redraw.

``python -m benchmarks.rendering`` takes less than a minute, prints a table in Markdown and writes
benchmarks/results/rendering.csv.  It needs imageio-ffmpeg, whose FFmpeg serves matplotlib.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks.common import RESULTS, ROOT, write_csv
from benchmarks.floor import FILM

PACKAGES = ("numpy", "matplotlib", "av", "pillow", "imageio-ffmpeg")
RUNS = 3
#: `FuncAnimation` is timed on two shares of the film, and what a frame costs is the difference.
FEW, MANY = 4, 20
BARE = """
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
figure, axes = plt.subplots(1, 3, figsize=(12.8, 7.2))
figure.savefig("bare.png", dpi=100)
"""
COMMANDS = {
    "mp4": ["-m", "vad", *FILM, "-o", "film.mp4"],
    "gif": ["-m", "vad", *FILM, "-o", "film.gif"],
    "png": ["-m", "vad", "draw", "slider-crank", "-o", "sheet.png"],
    "floor": ["-m", "benchmarks.floor", "encode", ".", "floor.mp4"],
    "bare": ["-c", BARE],
}
HEAD = ["what", "measured", "target"]


@dataclass
class Cost:
    """What a process took: seconds on the clock, and the most memory in bytes."""

    seconds: float
    memory: float


def run(arguments: Sequence[str], folder: Path) -> Cost:
    """Run Python with ``arguments`` in ``folder`` and wait for it."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    start = time.perf_counter()
    process = subprocess.Popen([sys.executable, *arguments], cwd=folder, env=environment)
    _, status, usage = os.wait4(process.pid, 0)
    seconds = time.perf_counter() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise SystemExit(f"failed: {' '.join(arguments)}")
    return Cost(seconds, usage.ru_maxrss * (1 if sys.platform == "darwin" else 1024))


def check_frames() -> None:
    """Compare every frame of the film with its full redraw, byte for byte."""
    import numpy as np

    import vad
    from vad.lecture.moment import moments
    from vad.painting.film import filmed, redraw
    from vad.painting.posed import board_of
    from vad.style import load_style

    lesson = vad.animate(vad.draw(vad.solve(vad.SliderCrank())))
    board, style = board_of(lesson), load_style(lesson.style)
    different = 0
    for frame, (state, repeats) in zip(filmed(lesson), moments(lesson), strict=True):
        same = np.array_equal(frame.pixels, redraw(board, state, style))
        if not same or frame.repeats != repeats:
            raise SystemExit(f"picture {different} is not what a full redraw gives")
        different += 1
    print(f"{lesson.frames} frames, {different} of them different: all equal full redraws\n")


def best(folder: Path) -> dict[str, Cost]:
    """Return the fastest of a few runs of every command, run in turn."""
    costs: dict[str, list[Cost]] = {name: [] for name in COMMANDS}
    for _ in range(RUNS):
        for name, arguments in COMMANDS.items():
            costs[name].append(run(arguments, folder))
    least = {name: min(runs, key=lambda cost: cost.seconds) for name, runs in costs.items()}
    for name, cost in least.items():
        print(f"{cost.seconds:6.2f} s  {name}")
    return least


def func_animation(file: str, axes: str, frames: int, folder: Path) -> float:
    """Return the seconds of `FuncAnimation.save` for all ``frames``, from two shares of them."""
    peer = ["-m", "benchmarks.funcanimation", file, axes]
    times: dict[int, list[float]] = {FEW: [], MANY: []}
    for count in (FEW, MANY) * 2:
        times[count].append(run([*peer, str(count)], folder).seconds)
    few, many = min(times[FEW]), min(times[MANY])
    seconds = few + (many - few) / (MANY - FEW) * (frames - FEW)
    print(f"{seconds:6.2f} s  FuncAnimation.save, {axes}, {file}: {frames} frames from {MANY}")
    return seconds


def mp4_seconds(path: Path) -> float:
    """Return how long an MP4 plays."""
    import av

    with av.open(str(path)) as container:
        return float(container.duration / av.time_base)


def gif_seconds(path: Path) -> float:
    """Return how long a GIF plays."""
    from PIL import Image

    with Image.open(path) as film:
        total = 0
        for number in range(film.n_frames):
            film.seek(number)
            total += film.info["duration"]
    return total / 1000


def measure(folder: Path) -> Iterator[tuple[str, str, str]]:
    """Yield what was measured, the figure, and what is aimed at."""
    run(["-m", "benchmarks.floor", "store", "."], folder)
    cost = best(folder)
    short, long = (
        run([*COMMANDS["mp4"][:-1], f"{speed}.mp4", "--speed", speed], folder).memory
        for speed in ("4", "0.4")
    )
    if (folder / "floor.mp4").read_bytes() != (folder / "film.mp4").read_bytes():
        raise SystemExit("the floor has encoded another film")

    import vad

    lesson = vad.animate(vad.draw(vad.solve(vad.SliderCrank())))
    mp4 = func_animation("peer.mp4", "plain", lesson.frames, folder) / cost["mp4"].seconds
    framed = func_animation("peer.mp4", "axes", lesson.frames, folder) / cost["mp4"].seconds
    gif = func_animation("peer.gif", "plain", lesson.frames, folder) / cost["gif"].seconds
    size = (folder / "film.gif").stat().st_size
    yield "MP4, faster than `FuncAnimation.save`", f"{mp4:.0f} ×", "≥ 80 ×"
    yield "… with matplotlib's own axes about the panels", f"{framed:.0f} ×", ""
    floor = cost["mp4"].seconds / cost["floor"].seconds
    yield "MP4, against imports and encoding alone", f"{floor:.2f} ×", "≤ 1.3 ×"
    yield "GIF, faster than `FuncAnimation.save`", f"{gif:.0f} ×", "≥ 120 ×"
    yield "GIF, size", f"{size / 1000:.0f} kB", "≤ 300 kB"
    bare = cost["png"].seconds / cost["bare"].seconds
    yield "PNG picture, against a bare three-panel `savefig`", f"{bare:.2f} ×", "≤ 0.9 ×"
    memory = f"{100 * (long / short - 1):+.0f} %"
    yield f"MP4 ten times as long, memory above {short / 1e6:.0f} MB", memory, "≤ 10 %"
    stated = f"{lesson.duration:.2f} s"
    yield "MP4, plays for", f"{mp4_seconds(folder / 'film.mp4'):.2f} s", stated
    yield "GIF, plays for", f"{gif_seconds(folder / 'film.gif'):.2f} s", stated


def main() -> None:
    """Check, measure, print and write."""
    check = "from benchmarks.rendering import check_frames; check_frames()"
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        run(["-c", check], folder)  # on its own: a child is never counted smaller than its parent
        rows = list(measure(folder))
    print()
    for row in [HEAD, ["---"] * len(HEAD), *rows]:
        print("| " + " | ".join(row) + " |")
    print()
    write_csv(RESULTS / "rendering.csv", HEAD, rows, PACKAGES)


if __name__ == "__main__":
    main()
