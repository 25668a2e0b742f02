"""Pages that stand elsewhere in the repository: changelog, contributing, extras and films.

Out go pages in Markdown by their paths, with links that lead somewhere on the site.
"""

from __future__ import annotations

import re
from pathlib import Path

_ROOT = Path(__file__).parents[1]
_LINK = re.compile(r"(?<!!)\[(?P<words>[^]]*)\]\((?P<path>[^)#]+)(?P<place>#[^)]*)?\)")
_FILM = re.compile(r"^!\[The film\]\((films/[^)]+)\)$", re.M)
_EXTRAS = "## What an install brings\n"


def copied_pages() -> dict[str, str]:
    """Return the pages by their paths."""
    return {
        "changelog.md": _read("CHANGELOG.md"),
        "contributing.md": _read("CONTRIBUTING.md"),
        "reference/extras.md": _extras(),
        "gallery/films.md": _films(),
    }


def _read(name: str) -> str:
    """Return a page of the repository; a link to a file that is not on the site is its words."""

    def led(match: re.Match[str]) -> str:
        path, within = match["path"], "docs/pages/"
        if path.startswith(within) or "://" in path:
            return match[0].replace(f"({within}", "(", 1)
        return match["words"]

    return _LINK.sub(led, (_ROOT / name).read_text("utf-8"))


def _extras() -> str:
    section = _read("README.md").partition(_EXTRAS)[2].partition("\n## ")[0]
    return f"# Extras\n\n{section.strip()}\n"


def _films() -> str:
    """Return the films of the repository, each with its command; they are loaded when seen."""
    text = (_ROOT / "gallery" / "README.md").read_text("utf-8")
    _, first, films = text.partition("\n## ")
    about = (
        "Each film has its command above it. The small pictures lead to the same film in the other "
        "styles. [All mechanisms](index.md) can be turned by hand, too.\n"
    )
    shown = _FILM.sub(r"![The film](\1){ loading=lazy }", first.lstrip("\n") + films)
    return f"---\nhide: [toc]\n---\n# Films\n\n{about}\n{shown}"
