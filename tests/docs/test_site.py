"""The site: built without a warning, complete, and by itself: nothing comes from elsewhere."""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
from html import unescape
from importlib import import_module
from pathlib import Path

import pytest

import vad
from docs.made import made_pages
from docs.site import HOME, PAGES, ROOT
from vad.mechanisms import MECHANISMS

with_mkdocs = pytest.mark.skipif(
    importlib.util.find_spec("mkdocs") is None, reason="mkdocs comes with the extra docs"
)


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the site, which is built in a process of its own."""
    folder = tmp_path_factory.mktemp("site")
    done = subprocess.run(
        [sys.executable, "-m", "docs", str(folder)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr
    assert "WARNING" not in done.stderr
    return folder


def test_the_menu_lists_every_page():
    listed = re.findall(r": ([\w/-]+\.md)$", (HOME / "mkdocs.yml").read_text("utf-8"), re.M)
    written = {page.relative_to(PAGES).as_posix() for page in PAGES.rglob("*.md")}
    assert sorted(listed) == sorted({*written, *made_pages()})


def test_the_reference_has_every_public_name():
    text = (PAGES / "reference" / "python.md").read_text("utf-8")
    shown = set()
    for name in re.findall(r"^::: ([\w.]+)$", text, re.M):
        module, _, attribute = name.rpartition(".")
        shown.add(getattr(import_module(module), attribute))
    public = {getattr(vad, name) for name in vad.__all__ if name != "MECHANISMS"}
    assert shown == public - set(MECHANISMS.values())


def test_the_made_reference_has_every_option_and_mechanism():
    pages = made_pages()
    for name, kind in MECHANISMS.items():
        assert f"## {kind.title}" in pages["reference/mechanisms.md"]
        assert f"`vad solve {name}`" in pages["reference/mechanisms.md"]
    for option in ("--panels", "--still", "--steps", "--completion", "--json", "--paper"):
        assert f"`{option}" in pages["reference/command-line.md"] or (
            f", {option} " in pages["reference/command-line.md"]
        )


@with_mkdocs
def test_every_picture_is_there(site: Path):
    for page in site.rglob("*.html"):
        for picture in re.findall(r"<img[^>]* src=\"([^\"]+)\"", page.read_text("utf-8")):
            assert (page.parent / unescape(picture)).is_file(), f"{page.name}: {picture}"


@with_mkdocs
def test_nothing_comes_from_elsewhere(site: Path):
    loads = re.compile(r"<(?:script|img|link|iframe|source)\b[^>]*(?:src|href)=\"(?:https?:)?//")
    for page in site.rglob("*.html"):
        assert loads.search(page.read_text("utf-8")) is None, page.name
    for sheet in site.rglob("*.css"):
        assert re.search(r"(?:@import|url\()\s*[\"']?(?:https?:)?//", sheet.read_text()) is None


@with_mkdocs
def test_verbs_are_explained_with_their_parameters(site: Path):
    page = (site / "reference" / "python.html").read_text("utf-8")
    assert 'id="vad.kinematics.motion.solve"' in page
    assert "The motion of the driver" in page
