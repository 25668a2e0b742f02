"""The site: built without a warning, complete, and by itself: nothing comes from elsewhere."""

from __future__ import annotations

import re
from html import unescape
from importlib import import_module
from pathlib import Path
from urllib.parse import unquote

import vad
from docs.made import made_pages
from docs.site import HOME, PAGES
from vad.mechanisms import MECHANISMS


def test_the_menu_lists_every_page():
    listed = re.findall(r": ([\w/-]+\.md)$", (HOME / "mkdocs.yml").read_text("utf-8"), re.M)
    written = {page.relative_to(PAGES).as_posix() for page in PAGES.rglob("*.md")}
    assert sorted(listed) == sorted({*written, *made_pages(), "gallery/index.md"})


def test_the_reference_has_every_public_name():
    pages = sorted((PAGES / "reference" / "python").glob("*.md"))
    text = "\n".join(page.read_text("utf-8") for page in pages)
    listed = (PAGES / "reference" / "python.md").read_text("utf-8")
    assert all(f"(python/{page.name})" in listed for page in pages)
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


def test_every_link_and_every_picture_leads_to_a_file_of_the_site(site: Path):
    count = 0
    for page in site.rglob("*.html"):
        if page.name == "404.html":  # it is shown at any path, and its links begin at the root
            continue
        for link in re.findall(r"<[^>]* (?:src|href)=\"([^\"#]+)", page.read_text("utf-8")):
            if not re.match(r"(?:https?|data|mailto):", link):
                assert (page.parent / unquote(unescape(link))).is_file(), f"{page}: {link}"
                count += 1
    assert count > 500


def test_every_film_stands_below_its_command(site: Path):
    text = made_pages()["gallery/films.md"]
    films = re.findall(r"^    vad [^\n]*\n\n!\[The film\]\((films/[^)]+)\)", text, re.M)
    assert len(films) == text.count("![The film]") > 20
    page = (site / "gallery" / "films.html").read_text("utf-8")
    assert all(f'src="{film}"' in page and (site / "gallery" / film).is_file() for film in films)


def test_the_site_names_its_version_and_can_be_searched(site: Path):
    page = (site / "index.html").read_text("utf-8")
    assert f"vad {vad.__version__}" in page
    assert 'data-md-component="search"' in page
    assert "Largest errors" in (site / "search" / "search_index.json").read_text("utf-8")


def test_nothing_comes_from_elsewhere(site: Path):
    loads = re.compile(r"<(?:script|img|link|iframe|source)\b[^>]*(?:src|href)=\"(?:https?:)?//")
    for page in site.rglob("*.html"):
        assert loads.search(page.read_text("utf-8")) is None, page.name
    for sheet in site.rglob("*.css"):
        assert re.search(r"(?:@import|url\()\s*[\"']?(?:https?:)?//", sheet.read_text()) is None


def test_verbs_are_explained_with_their_parameters(site: Path):
    page = (site / "reference" / "python" / "solve.html").read_text("utf-8")
    assert 'id="vad.kinematics.motion.solve"' in page
    assert "The motion of the driver" in page
