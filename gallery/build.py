"""Builds the gallery: every mechanism in every style as a poster and a film, and a contact sheet;
mechanisms from files, and some with loads, in one style.

``python gallery/build.py`` writes them beside itself, with a page that shows them all;
``python gallery/build.py --check`` builds them elsewhere and names those that differ.
"""

from __future__ import annotations

import argparse
import multiprocessing
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any

from PIL import Image
from PIL.PngImagePlugin import PngInfo

import vad
from vad.export.palette import Palette, fine
from vad.files.examples import example_path
from vad.lecture.lesson import Lesson
from vad.painting.posed import picture
from vad.statics.burden import burden_of
from vad.strokes.sheet import Sheet
from vad.style import style_names

HERE = Path(__file__).parent

#: Dimensions and input that make good pictures; a mechanism without an entry shows its defaults.
SCENES: dict[str, tuple[dict[str, Any], dict[str, float]]] = {
    "four-bar": (
        {"ground": 120, "crank": 50, "coupler": 90, "rocker": 80},
        {"angle": 70, "omega": -10, "alpha": 30},
    ),
    "slider-crank": ({}, {"angle": 60, "omega": 10, "alpha": 20}),
    "crank-slotted-lever": (
        {"ground": 120, "crank": 60, "lever": 250, "rod": 100, "ram_height": 160},
        {"angle": 150},
    ),
    "whitworth": ({"ground": 50, "arm": 80, "rod": 150}, {"angle": 165}),
    "elliptical-trammel": ({}, {"angle": 35}),
    "scotch-yoke": ({}, {"angle": 40, "alpha": 20}),
    "double-slider": ({"guide_b": 110}, {"position": 400, "acceleration": 2000}),
    "gate-actuator": ({}, {"position": 3.6}),
    "hooke-joint": ({}, {"angle": 60, "alpha": 40}),
    "spherical-four-bar": ({}, {"angle": 140}),
    "rssr": ({}, {"angle": 290}),
}

#: Mechanisms from files that ship with the program, shown in one style.
EXAMPLES = ("toggle-press", "watt-1", "stephenson-3", "shaper", "landing-gear", "jansen-leg")

#: Mechanisms with loads, by the names of their files: the mechanism or example, the numbers, and
#: the words of the options that load it.
LOADED: dict[str, tuple[str, dict[str, float], dict[str, tuple[str, ...]]]] = {
    "loaded-four-bar": (
        "four-bar",
        {"ground": 500, "crank": 400, "coupler": 1000, "rocker": 750, "angle": 120},
        {"point": ("E on rocker 350",), "load": ("P = 80 N @ 150 at E",)},
    ),
    "loaded-engine": (
        "slider-crank",
        {"rod": 220, "angle": 40, "omega": 150},
        {
            "point": ("G on rod 70",),
            "load": ("P = 3 kN @ 180 at C",),
            "mass": ("slider 1.2 kg", "rod 1.5 kg at G"),
            "inertia": ("rod 0.01 kg m^2",),
        },
    ),
    "loaded-shaper": ("shaper", {}, {"load": ("P = 2 kN @ 0 at E",)}),
    "loaded-toggle-press": ("toggle-press", {"angle": 210}, {"load": ("P = 20 kN @ 180 at D",)}),
    "loaded-excavator": ("excavator-bucket", {}, {"load": ("P = 12 kN @ 90 at T",)}),
    "loaded-beam-engine": ("beam-engine", {}, {"load": ("P = 10 kN @ -90 at P on main_link",)}),
    "loaded-watt-1": ("watt-1", {}, {"load": ("M = -20 N m on link",)}),
    "loaded-gate": (
        "gate-actuator",
        {"position": 3.6},
        {"load": ("W = 500 lbf @ -90 at B on arm",)},
    ),
}

POSTER = 1280, 720
FILM = 960, 540
#: Share of a lecture's pauses: here one looks, and does not take notes.
PAUSES = 0.3
#: Hundredths of a second from frame to frame; a film takes the first with which it is small enough.
DELAYS = (4, 5, 6, 7, 8, 10)
MOST_BYTES = 700_000
#: A mechanism from a file has two dyads or three, and each is drawn stroke by stroke.
MOST_BYTES_OF_EXAMPLE = 1_300_000
CELL, COLUMNS, GAP = (990, 600), 2, 40
SHEET_STYLE = "paper"


def sheet(name: str) -> Sheet:
    """Return the sheet of a mechanism's scene, or of one with loads."""
    if name in LOADED:
        return _loaded(name)
    dimensions, inputs = SCENES.get(name, ({}, {}))
    return vad.draw(vad.solve(subject(name)(**dimensions), **inputs))


def _loaded(name: str) -> Sheet:
    """Return the sheet of a mechanism with loads."""
    mechanism, numbers, words = LOADED[name]
    kind = subject(mechanism)
    inputs = {each: value for each, value in numbers.items() if each in kind.inputs}
    dimensions = {each: value for each, value in numbers.items() if each not in kind.inputs}
    points = {}
    for text in words.get("point", ()):
        point, _, link, distance = text.split()
        points[point] = (link, float(distance))
    motion = vad.solve(kind(**dimensions, points=points), **inputs)
    options = {word: texts for word, texts in words.items() if word != "point"}
    return vad.draw(vad.forces(motion, *burden_of(**options)))


def subject(name: str) -> type[vad.Mechanism]:
    """Return a mechanism by its name, or by that of an example."""
    if name in LOADED:
        name = LOADED[name][0]
    return vad.MECHANISMS.get(name) or vad.load(example_path(name))


def command(name: str) -> str:
    """Return the words that make the film of a scene."""
    if name in LOADED:
        mechanism, numbers, words = LOADED[name]
        given = [f"--{option} {value:g}" for option, value in numbers.items()]
        given += [f'--{option} "{text}"' for option, texts in words.items() for text in texts]
        end = " ".join([*given, f"-o {name}.mp4"])
        if mechanism in vad.MECHANISMS:
            return f"vad animate {mechanism} {end}"
        return f"vad example {mechanism} > {mechanism}.toml && vad animate {mechanism}.toml {end}"
    if name in EXAMPLES:
        return f"vad example {name} > {name}.toml && vad animate {name}.toml -o {name}.mp4"
    return " ".join(["vad animate", name, *options(name), f"-o {name}.mp4"])


def options(name: str) -> list[str]:
    """Return the options of the command line that make the scene of a mechanism."""
    dimensions, inputs = SCENES.get(name, ({}, {}))
    numbers = {**dimensions, **inputs}.items()
    return [f"--{option.replace('_', '-')} {value:g}" for option, value in numbers]


def poster(name: str, style: str, path: Path) -> None:
    """Write the picture of a scene, with the colours of a style's films."""
    drawn = sheet(name)
    vad.save(drawn, path, size=POSTER, style=style)
    with Image.open(path) as picture:
        words = PngInfo()
        for key, text in picture.text.items():
            words.add_itxt(key, text)
        small = _with_palette(picture, fine(style, len(drawn.rows)))
    small.save(path, optimize=True, pnginfo=words)


def lesson(name: str, style: str, fps: float) -> Lesson:
    """Return the lesson of a scene, with strokes at their own pace and shorter pauses."""
    slow = vad.animate(sheet(name), fps=fps, size=FILM, style=style)
    steps = tuple(replace(step, hold=round(PAUSES * step.hold)) for step in slow.steps)
    return replace(slow, steps=steps)


def film(name: str, style: str, path: Path) -> None:
    """Write the film of a scene, at the highest rate with which it is small enough."""
    most = most_bytes(name)
    for delay in DELAYS:
        vad.save(lesson(name, style, 100 / delay), path)
        if path.stat().st_size < most:
            return
    raise SystemExit(f"{path.name} is larger than {most} bytes at any rate")


def most_bytes(name: str) -> int:
    """Return how large the film of a scene may be."""
    return MOST_BYTES if name in vad.MECHANISMS else MOST_BYTES_OF_EXAMPLE


def contact_sheet(path: Path) -> None:
    """Write a picture of all mechanisms."""
    names, (width, height) = list(vad.MECHANISMS), CELL
    rows = -(-len(names) // COLUMNS)
    size = COLUMNS * (width + GAP) - GAP, rows * (height + GAP) - GAP
    whole = Image.new("RGB", size, "white")
    for number, name in enumerate(names):
        row, column = divmod(number, COLUMNS)
        cell = Image.fromarray(picture(sheet(name), CELL, SHEET_STYLE)[..., :3])
        whole.paste(cell, (column * (width + GAP), row * (height + GAP)))
    _with_palette(whole, fine(SHEET_STYLE)).save(path, optimize=True)


def page(path: Path) -> None:
    """Write the page that shows everything."""
    lines = [
        "# Gallery",
        "",
        "Made by `python gallery/build.py`. The films show shorter pauses than the lectures.",
        "`python -m docs` builds the site, whose gallery has all mechanisms and examples as pages",
        "that are turned by hand.",
    ]
    for name in vad.MECHANISMS:
        lines += _section(name, command(name))
        for style in style_names():
            if style != SHEET_STYLE:
                lines.append(f"[![{style}](posters/{name}-{style}.png)](films/{name}-{style}.gif)")
    lines += ["", "# From files", "", "Each of them is a short file that ships with the program."]
    for name in EXAMPLES:
        lines += _section(name, command(name))
    lines += ["", "# With loads", "", "The force polygons of each dyad, and what drives."]
    for name in LOADED:
        lines += _section(name, command(name))
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _section(name: str, words: str) -> list[str]:
    head = ["", f"## {subject(name).title}", "", f"    {words}", ""]
    return [*head, f"![The film](films/{name}-{SHEET_STYLE}.gif)"]


def shown() -> Iterator[tuple[str, str]]:
    """Yield what is shown as poster and film: names with styles."""
    yield from ((name, style) for name in vad.MECHANISMS for style in style_names())
    yield from ((name, SHEET_STYLE) for name in (*EXAMPLES, *LOADED))


def build(folder: Path) -> None:
    """Write the whole gallery into ``folder``, with as many processes as there are cores."""
    for part in ("posters", "films"):
        (folder / part).mkdir(parents=True, exist_ok=True)
    spawn = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(mp_context=spawn) as pool:
        jobs: list[Future[None]] = []
        for name, style in shown():
            jobs.append(pool.submit(film, name, style, folder / f"films/{name}-{style}.gif"))
            jobs.append(pool.submit(poster, name, style, folder / f"posters/{name}-{style}.png"))
        jobs.append(pool.submit(contact_sheet, folder / "contact-sheet.png"))
        for job in jobs:
            job.result()
    page(folder / "README.md")


def check() -> int:
    """Build elsewhere, name the files that differ from those that are here, count them."""
    with tempfile.TemporaryDirectory() as name:
        build(Path(name))
        built = [path for path in sorted(Path(name).rglob("*")) if path.is_file()]
        different = 0
        for path in built:
            here = HERE / path.relative_to(name)
            if not here.exists() or here.read_bytes() != path.read_bytes():
                print(f"differs: {here.relative_to(HERE.parent)}")
                different += 1
    print(f"{len(built) - different} of {len(built)} files are the same")
    return different


def main() -> None:
    """Build or check, as the command line says."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="compare instead of writing")
    if parser.parse_args().check:
        sys.exit(check() > 0)
    build(HERE)


def _with_palette(picture: Image.Image, palette: Palette) -> Image.Image:
    import numpy as np

    small = Image.fromarray(palette.indices(np.asarray(picture.convert("RGBA"))))
    small.putpalette(palette.colours.tobytes())
    return small


if __name__ == "__main__":
    main()
