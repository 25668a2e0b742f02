"""Command lines that nobody should type, at random."""

from __future__ import annotations

import random

from vad.mechanisms import MECHANISMS

VERBS = ["solve", "draw", "animate", "sweep", "compare", "list", "sovle", ""]
OPTIONS = [
    *("--ground", "--crank", "--coupler", "--rod", "--ram-height", "--offset", "--link"),
    *("--angle", "--omega", "--alpha", "--position", "--ground-angle", "--assembly"),
    *("--length-unit", "--panels", "--style", "--language", "--size", "--paper", "--fps"),
    *("--blank", "--at"),
    *("--speed", "--still", "--steps", "--from", "--to", "--crnak", "--o", "-x", "-crank", "--"),
]
FLAGS = ["--json", "--subtitles", "--help", "-h", "--turn", "--json=1", "-"]
VALUES = [
    *("60", "0", "-1", "-4e-05", "1e400", "1e-320", "nan", "inf", "6 cm", "120 rpm", "6kg", "٣"),
    *("", " ", "open", "crossed", "paper", "chalk", "de", "A4", "ft", "velocity", "velocity:2"),
    *(
        "30,60",
        "position,velocity",
        ",",
        "640x360",
        "0x0",
        "1e5x3",
        "two\nlines",
        "\x1b[31m",
        "\udc80",
    ),
    *("[red]x[/nope]", "%s{0}", "9" * 6000, "x" * 130_000, "--", "--json", "NaN deg", "1/0"),
]
FILES = [
    *("a.json", "a.svg", "a.csv", "a.srt", "a.vtt", "a.xyz", "a", "/", ".", "..", "", "="),
    *("no/such/a.svg", "x" * 300 + ".srt", "two\nlines.srt", "\udc80.json", "[/b].csv", "\0.svg"),
]


def line(dice: random.Random) -> list[str]:
    """Return the words of one command line; what is written is soon written."""
    words = [dice.choice(VERBS), dice.choice([*MECHANISMS, "four-bar", "fuor-bar"])]
    for _ in range(dice.randrange(4)):
        words += [dice.choice(OPTIONS), dice.choice(VALUES)]
    if dice.random() < 0.2:
        words.append(dice.choice(FLAGS))
    if dice.random() < 0.9:
        words += ["-o", dice.choice(FILES)]
    if dice.random() < 0.2:
        dice.shuffle(words)
    folder_of_frames = words[0] == "animate" and words[-1] in ("a", ".", "..", "/")
    return words[:-2] if folder_of_frames else words
