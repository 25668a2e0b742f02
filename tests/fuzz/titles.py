"""Titles of mechanisms that nobody should give, in every format: no markup gets out of its text.

A seed is a title; it is drawn, and read back by a strict reader of each format.
"""

from __future__ import annotations

import json
import random
import re
import tempfile
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import vad
from tests.fuzz import files
from tests.fuzz.promise import broken

#: The most seconds that a title may take in all formats.
LONGEST = 60.0

PARTS = (
    *("<script>alert(1)</script>", "</title>", "</style>", "]]>", "<!--", "-->", "&lt;", "&", "<"),
    *(
        "\u202e",
        "\u200d",
        "👩",
        "a\u0301\u0302\u0303",
        "ﷺ",
        "$x^2$",
        "$",
        "\\",
        "{",
        "}",
        "%s",
        "%",
    ),
    *(
        "'",
        '"',
        "`",
        "@import",
        "(",
        ")",
        "endstream endobj",
        "\u2028",
        "é",
        "中",
        "١",
        "\u202b",
        "x" * 200,
    ),
    *("onload=", "javascript:", "{{7*7}}", "${1}", "-", "--", "#", "1", " ", "A", "Press"),
)
FORMATS = ("svg", "html", "json", "pdf", "png", "srt", "vtt", "txt", "tex", "tikz")


def case(seed: int) -> str:
    """Return a title."""
    dice = random.Random(seed)
    return "".join(dice.choice(PARTS) for _ in range(dice.choice((1, 2, 3, 6))))


class _Tags(HTMLParser):
    """Counts the scripts of a page, and what calls for one."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag in ("script", "style", "title", "iframe", "img", "link"):
            self.found.append(tag)
        self.found += [name for name, _ in attrs if name.startswith("on")]


def tags(page: str) -> list[str]:
    """Return the tags of a page by which markup would get out, and handlers of events."""
    reader = _Tags()
    reader.feed(page)
    return sorted(reader.found)


def fault(title: str, seed: int = 0) -> str | None:
    """Draw a mechanism with a title, in two formats that the seed chooses; say what it breaks."""
    text = "\n".join(
        f"title = {json.dumps(title, ensure_ascii=False)}" if line.startswith("title") else line
        for line in files.EXAMPLES[seed % len(files.EXAMPLES)].splitlines()
    )

    def drawn() -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "titled.toml"
            path.write_text(text, "utf-8", newline="")
            sheet = vad.draw(vad.solve(vad.load(path)()))
            lesson = vad.animate(sheet)
            for kind in random.Random(seed).sample(FORMATS, 2):
                target = Path(folder) / f"a.{kind}"
                vad.save(lesson if kind in ("srt", "vtt", "html", "txt", "tex") else sheet, target)
                _check(kind, target, sheet)

    return broken(drawn, LONGEST)


def _check(kind: str, path: Path, sheet: vad.Sheet) -> None:
    """Read a file back."""
    if kind == "svg":
        root = ElementTree.parse(path).getroot()
        assert not [each for each in root.iter() if "script" in each.tag], "a script"
    elif kind == "json":
        assert vad.sheet_from_json(path) == sheet, "another sheet"
    elif kind in ("tex", "tikz"):
        plain = re.sub(r"\\.|%.*", "", path.read_text("utf-8"))
        assert plain.count("{") == plain.count("}"), "braces without a partner"
        assert plain.count("$") % 2 == 0, "mathematics without an end"
    elif kind == "html":
        assert tags(path.read_text("utf-8")) == _usual_tags(), "other tags than those of a page"


def _usual_tags() -> list[str]:
    """Return the tags of a page with a plain title."""
    if not _USUAL:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "a.html"
            vad.save(vad.animate(vad.draw(vad.solve(vad.FourBar()))), path)
            _USUAL.extend(tags(path.read_text("utf-8")))
    return _USUAL


_USUAL: list[str] = []
