"""The site: in come the pages, out goes a folder of HTML that needs no other server.

The pages are copied to a folder in the making, with every picture that one of them shows and one of
its own commands draws, the pages that follow from the code, and the gallery.
"""

from __future__ import annotations

import logging
import shutil
import tempfile
from pathlib import Path

from docs.examples import draw_pictures
from docs.gallery import pieces, write_gallery
from docs.made import made_pages
from vad import __version__

HOME = Path(__file__).parent
ROOT = HOME.parent
PAGES = HOME / "pages"
#: Of the pictures and films in the repository, what the pages show.
_SHOWN = ("*.png", "films/*.gif", "posters/*.png")


def build(folder: Path, every: int = 1) -> None:
    """Build the site into ``folder``, which is emptied before.

    Parameters
    ----------
    folder
        Where it goes.
    every
        How many mechanisms there are to each one that the gallery shows.

    Raises
    ------
    SystemExit
        If a command of a page fails, or anything is amiss: a link or a picture that leads nowhere,
        a page that no menu lists, a name without a docstring.
    """
    with tempfile.TemporaryDirectory() as name:
        pages = Path(name) / "pages"
        gather(pages, every)
        _html(pages, folder.resolve())


def gather(pages: Path, every: int = 1) -> None:
    """Write everything that the site consists of into ``pages``, as Markdown and pictures."""
    shutil.copytree(PAGES, pages)
    for pattern in _SHOWN:
        for picture in (ROOT / "gallery").glob(pattern):
            copy = pages / picture.relative_to(ROOT)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(picture, copy)
    for page in sorted(pages.rglob("*.md")):
        draw_pictures(page)
    for path, text in made_pages().items():
        (pages / path).parent.mkdir(exist_ok=True)
        (pages / path).write_text(text, encoding="utf-8")
    write_gallery(pages, pieces()[::every])


def _html(pages: Path, folder: Path) -> None:
    from mkdocs.commands.build import build as build_html
    from mkdocs.config import load_config

    logging.basicConfig(level=logging.WARNING, format="%(levelname)s: %(message)s")
    settings = load_config(
        str(HOME / "mkdocs.yml"),
        docs_dir=str(pages),
        site_dir=str(folder),
        strict=True,
        copyright=f"vad {__version__} · MIT License",
    )
    settings.plugins.on_startup(command="build", dirty=False)
    build_html(settings)
