"""How long each lecture lasted when it was first measured: ``python -m tests.lecture.durations``.

A lecture may become half as long again, and no longer.  The command measures what is new, a
mechanism or a language, and leaves out what is gone; what is known stays as it is.
"""

from __future__ import annotations

import json
from pathlib import Path

import vad
from vad.files.examples import example_path
from vad.lecture.lesson import Lesson
from vad.words import languages

_FILE = Path(__file__).parent / "durations.json"
#: Seconds by mechanism and language.
DURATIONS: dict[str, dict[str, float]] = json.loads(_FILE.read_text("utf-8"))
#: The mechanisms whose lectures are measured: all that have a class, and some of the examples.
MEASURED = sorted({*vad.MECHANISMS, *DURATIONS})


def lesson_of(name: str, language: str = "en") -> Lesson:
    """Return the lecture of a mechanism or of an example, as it is without options."""
    kind = vad.MECHANISMS[name] if name in vad.MECHANISMS else vad.load(example_path(name))
    return vad.animate(vad.draw(vad.solve(kind()), language=language))


def first_measured(name: str, language: str) -> float:
    """Return the seconds that a lecture lasted when it was first measured."""
    command = "python -m tests.lecture.durations"
    assert language in DURATIONS.get(name, {}), f"{name}, {language}: `{command}` measures it"
    return DURATIONS[name][language]


def _measure(name: str, language: str) -> float:
    known = DURATIONS.get(name, {}).get(language)
    return known if known is not None else round(lesson_of(name, language).duration, 1)


if __name__ == "__main__":
    measured = {name: {each: _measure(name, each) for each in languages()} for name in MEASURED}
    _FILE.write_text(json.dumps(measured, indent=0) + "\n", "utf-8")
