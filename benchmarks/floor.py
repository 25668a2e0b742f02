"""The least that an MP4 can cost: the imports, and the encoder fed with planes that are ready.

``python -m benchmarks.floor store FOLDER`` makes the default slider-crank film with the command
line and stores what its encoder was given: for each picture the samples (Y, Cb, Cr) of the boxes
that changed, and how often it repeats; captions and settings; the names of all modules.
``python -m benchmarks.floor encode FOLDER FILE`` imports those modules, reads the pictures and
encodes them with the same code and settings: nothing is solved, laid out, painted or converted.
"""

from __future__ import annotations

import contextlib
import importlib
import pickle
import sys
from pathlib import Path
from typing import Any

FILM = "animate", "slider-crank"


def store(folder: Path) -> None:
    """Make the film, and keep what went into its encoder."""
    from vad.cli.run import run
    from vad.export import film_mp4

    pictures: list[Any] = []
    options: dict[str, Any] = {}
    converted, encode = film_mp4.converted, film_mp4.encode

    def kept(*arguments: Any) -> Any:
        for picture in converted(*arguments):
            pictures.append(picture)
            yield picture

    def noted(*arguments: Any, **given: Any) -> None:
        options.update(given)
        encode(*arguments, **given)

    film_mp4.converted, film_mp4.encode = kept, noted
    assert run([*FILM, "-o", str(folder / "stored.mp4")]) == 0
    modules = [name for name in sys.modules if not name.startswith(("__", "benchmarks"))]
    with open(folder / "floor.pickle", "wb") as file:
        pickle.dump((modules, pictures, options), file, protocol=5)


def encode(folder: Path, path: Path) -> None:
    """Import and encode what `store` has kept."""
    with open(folder / "floor.pickle", "rb") as file:
        modules, pictures, options = pickle.load(file)
    for name in modules:
        with contextlib.suppress(ImportError):  # a module that goes by another name
            importlib.import_module(name)
    from vad.export import film_mp4

    film_mp4.converted = lambda frames, size: frames
    with open(path, "w+b") as stream:
        film_mp4.encode(pictures, stream, **options)


if __name__ == "__main__":
    {"store": store, "encode": encode}[sys.argv[1]](*map(Path, sys.argv[2:]))
