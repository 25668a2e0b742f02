"""The least that an MP4 can cost: the imports, and the encoder fed with planes that are ready.

``python -m benchmarks.floor store FOLDER`` makes the default slider-crank film with the command
line and stores what its encoder was given: for each picture the samples (Y, Cb, Cr) of the boxes
that changed, and how often it repeats; and the names of all modules that were loaded.
``python -m benchmarks.floor encode FOLDER FILE`` imports those modules, reads the pictures and
encodes them with the same code and settings: nothing is solved, laid out, painted or converted.
"""

from __future__ import annotations

import contextlib
import importlib
import pickle
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

FILM = "animate", "slider-crank"


def store(folder: Path) -> None:
    """Make the film, and keep what went into its encoder."""
    from vad.cli.run import run
    from vad.export import mp4

    pictures: list[Any] = []
    converted = mp4.converted

    def kept(*arguments: Any) -> Any:
        for picture in converted(*arguments):
            pictures.append(picture)
            yield picture

    mp4.converted = kept
    assert run([*FILM, "-o", str(folder / "stored.mp4")]) == 0
    modules = [name for name in sys.modules if not name.startswith(("__", "benchmarks"))]
    with open(folder / "floor.pickle", "wb") as file:
        pickle.dump((modules, pictures), file, protocol=5)


def encode(folder: Path, path: Path) -> None:
    """Import and encode what `store` has kept."""
    with open(folder / "floor.pickle", "rb") as file:
        modules, pictures = pickle.load(file)
    for name in modules:
        with contextlib.suppress(ImportError):  # a module that goes by another name
            importlib.import_module(name)
    from vad.export import mp4

    mp4.converted = lambda frames, size: frames
    with open(path, "w+b") as stream:
        mp4.encode(pictures, stream, size=(1280, 720), rate=Fraction(30))


if __name__ == "__main__":
    {"store": store, "encode": encode}[sys.argv[1]](*map(Path, sys.argv[2:]))
