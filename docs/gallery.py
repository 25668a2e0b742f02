"""The gallery: each mechanism that ships with the program as a page that is turned by hand.

In comes a folder of pages; into its ``gallery`` go one page with cards, one for each mechanism, the
interactive pages that these show in a frame, the pictures of the cards, and the files of the
examples and of the sheets of the others.  All links are relative.
"""

from __future__ import annotations

import inspect
import multiprocessing
from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from html import escape
from pathlib import Path

import vad
from docs.card import card
from gallery.build import SCENES, options
from vad.files.examples import EXTENSION, example_names, example_path
from vad.files.sheet_file import sheet_file
from vad.kinematics.motion import Motion
from vad.mechanisms.mechanism import Mechanism, MechanismInSpace
from vad.strokes.sheet import Sheet
from vad.style import load_style
from vad.words import Language

#: Processes that make pages at once.  On two cores all pages take some 12 seconds.
PROCESSES = 2
#: The styles of the cards in a light and in a dark site.
_STYLES = {"light": "paper", "dark": "chalk"}
#: The page that tells of files of sheets.
_SHEETS = "how-to/batch.md"
_HEAD = "---\nhide: [navigation, toc]\n---\n"
_ABOUT = """\
Open one and turn its crank: links, polygons and table follow. Each is stepped as a lesson, too
([its keys](../how-to/class-page.md)), and is one file, to be kept, sent, or put on
[a learning platform](../how-to/course.md).
"""


@dataclass(frozen=True)
class Piece:
    """A mechanism of the gallery: a built-in one, or an ``example``, which is a file."""

    name: str
    example: bool

    @property
    def place(self) -> str:
        """Where its page is within the gallery, without an extension."""
        return f"examples/{self.name}" if self.example else self.name

    @property
    def kind(self) -> type[Mechanism]:
        """The class of the mechanism."""
        return vad.load(example_path(self.name)) if self.example else vad.MECHANISMS[self.name]

    @property
    def section(self) -> str:
        """The heading under which its card stands."""
        if self.example:
            return "From files"
        return "In space" if issubclass(self.kind, MechanismInSpace) else "In the plane"

    @property
    def command(self) -> str:
        """The commands that write its interactive page."""
        if not self.example:
            return " ".join(["vad draw", self.name, *options(self.name), f"-o {self.name}.html"])
        file = self.name + EXTENSION
        return f"vad example {self.name} > {file}\nvad draw {file} -o {self.name}.html"

    @property
    def file(self) -> str:
        """The text of its file: an example's own, or a sheet with the numbers that are drawn."""
        if self.example:
            return example_path(self.name).read_text("utf-8")
        return sheet_file(self._motion)

    def sheet(self) -> Sheet:
        """Return what is drawn."""
        return vad.draw(self._motion)

    @property
    def _motion(self) -> Motion:
        dimensions, inputs = ({}, {}) if self.example else SCENES.get(self.name, ({}, {}))
        return vad.solve(self.kind(**dimensions), **inputs)


def pieces() -> list[Piece]:
    """Return everything that the gallery shows, by its sections."""
    found = [Piece(name, False) for name in vad.MECHANISMS]
    found += [Piece(name, True) for name in example_names()]
    sections = ("In the plane", "In space", "From files")
    return sorted(found, key=lambda piece: sections.index(piece.section))


def write_gallery(pages: Path, shown: Iterable[Piece]) -> None:
    """Write the gallery of these mechanisms into a folder of pages."""
    folder, shown = pages / "gallery", list(shown)
    for part in ("lessons", "pictures"):
        (folder / part / "examples").mkdir(parents=True, exist_ok=True)
    (folder / "examples").mkdir(exist_ok=True)
    spawn = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(PROCESSES, mp_context=spawn) as pool:
        cards = list(pool.map(partial(_write_piece, folder), shown))
    parts = [f"{_HEAD}# Gallery\n", _ABOUT]
    for section in dict.fromkeys(piece.section for piece in shown):
        own = [made for piece, made in zip(shown, cards, strict=True) if piece.section == section]
        parts.append(f"## {section}\n\n" + '<div class="cards">\n' + "\n".join(own) + "\n</div>\n")
    (folder / "index.md").write_text("\n".join(parts), encoding="utf-8")


def _write_piece(folder: Path, piece: Piece) -> str:
    """Write all that belongs to one mechanism, and return its card."""
    drawn = piece.sheet()
    vad.save(drawn, folder / "lessons" / f"{piece.place}.html")
    for style in _STYLES.values():
        picture = folder / "pictures" / f"{piece.place}-{style}.svg"
        picture.write_text(card(drawn, style), encoding="utf-8")
    (folder / f"{piece.place}{EXTENSION}").write_text(piece.file, encoding="utf-8")
    (folder / f"{piece.place}.md").write_text(_page(piece, drawn.title), encoding="utf-8")
    return _card(piece, drawn)


def _card(piece: Piece, drawn: Sheet) -> str:
    images = "".join(
        f'<img src="pictures/{piece.place}-{style}.svg#only-{side}" alt="" loading="lazy" '
        f'style="background:{load_style(style).background}">'
        for side, style in _STYLES.items()
    )
    in_plane = dict.fromkeys(row.key for row in drawn.rows)
    moving = piece.kind.links if piece.section == "In space" else in_plane
    links = ", ".join(map(Language(drawn.language).name, moving))
    return (
        f'<a href="{piece.place}.html">{images}<strong>{escape(drawn.title)}</strong>'
        f"<span>{escape(links)}</span></a>"
    )


def _page(piece: Piece, title: str) -> str:
    up = "../" if piece.example else ""
    lesson = f"{up}lessons/{piece.place}.html"
    links = [
        f"[All mechanisms]({up}index.md)",
        f"[Films]({up}films.md)",
        f"[Open it alone]({lesson})",
        f"[Download this page]({lesson}){{ download }}",
    ]
    parts = [
        f"{_HEAD}# {title}",
        (inspect.getdoc(piece.kind) or "").partition("\n\n")[0],
        f'<iframe class="lesson" src="{lesson}" title="{escape(title)}" allowfullscreen></iframe>',
        " · ".join(links),
        f"## Its command\n\n```sh\n{piece.command}\n```",
    ]
    file, how = piece.name + EXTENSION, "how-to/mechanism-file.md" if piece.example else _SHEETS
    parts += [
        f'## Its file\n\n```toml title="{file}"\n{piece.file.strip()}\n```',
        f"[Download the file]({file}){{ download }} · [How such a file is written]({up}../{how})",
    ]
    if not piece.example:
        about = f"../reference/mechanisms.md#{piece.name}"
        parts.append(f"[Its dimensions and results]({about})")
    return "\n\n".join(parts) + "\n"
