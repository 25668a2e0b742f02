"""Captions as they are read out: in come runs, out go words for signs that a screen reader drops.

Letters of points and vectors are spelt one by one: "b prime n", "omega 2 squared".
"""

from __future__ import annotations

import re
from itertools import groupby

from vad.page.phrases import phrases
from vad.plan.lettering.runs import Run, Runs

_SPELT = ("italic", "bolditalic")


def spoken(runs: Runs, code: str) -> str:
    """Return runs in words of the language ``code``."""
    said = phrases(code)["spoken"]
    text = ""
    for manner, group in groupby(runs, _manner):
        letters = [letter for run in group for letter in run.text]
        words = [said.get(letter, letter) for letter in letters]
        if manner == "power":
            power = "".join(words)
            text += " " + (said.get(f"^{power}") or said["^"].format(power)) + " "
        else:
            text += f" {' '.join(words)} " if manner == "spelt" else "".join(letters)
    for sign in sorted(said, key=len, reverse=True):  # "/s" before "/"
        end = r"(?![A-Za-z])" if sign[-1].isalpha() else ""
        text = re.sub(re.escape(sign) + end, said[sign], text)
    return re.sub(r" (?=[,.;:](?:\s|$))", "", re.sub(r"\s+", " ", text)).strip()


def _manner(run: Run) -> str:
    """Return how a run is read: as a power, letter by letter, or as it is written."""
    if run.script > 0:
        return "power"
    return "spelt" if run.script < 0 or run.face in _SPELT else "written"
