"""TikZ: named styles, scopes of strokes, and the same picture as every other painter's."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pypdfium2
import pytest

import vad
from vad.export.sheet_json import to_text
from vad.painting.agg_painter import AggPainter
from vad.painting.posed import posed
from vad.painting.tikz_painter import TikzPainter
from vad.plan.marks import Lettering

LATEX = shutil.which("pdflatex")
PAGE = r"""\documentclass{article}
\usepackage[T1]{fontenc}
\usepackage{tikz}
%s
\begin{document}
\hoffset=-1in \voffset=-1in \pdfpagewidth=512pt \pdfpageheight=288pt
\shipout\hbox{\input{sheet.tikz}}
\end{document}
"""
SHEET = vad.draw(vad.solve(vad.CrankSlottedLever(rod=120, ram_height=140)), language="de")


def compiled(tikz: str, folder: Path, preamble: str = "") -> np.ndarray:
    """Return the pixels of a picture, or skip the test where there is no LaTeX."""
    if LATEX is None:
        pytest.skip("there is no pdflatex")
    (folder / "sheet.tikz").write_text(tikz, "utf-8")
    (folder / "page.tex").write_text(PAGE % preamble, "utf-8")
    words = [LATEX, "-interaction=nonstopmode", "-halt-on-error", "page.tex"]
    done = subprocess.run(words, cwd=folder, capture_output=True, check=False)
    assert done.returncode == 0, done.stdout.decode("utf-8", "replace")[-1500:]
    page = pypdfium2.PdfDocument(folder / "page.pdf")[0]
    return page.render(scale=1280 / page.get_width()).to_numpy()[..., 2::-1].astype(int)


class Wordless:
    """A painter that leaves out letters, which are those of LaTeX in one of the pictures."""

    def __init__(self, painter):
        self.begin, self.group, self.end = painter.begin, painter.group, painter.end
        self._paint = painter.paint

    def paint(self, mark, look):
        if not isinstance(mark.shape, Lettering):
            self._paint(mark, look)


@pytest.mark.exhaustive(12)
@pytest.mark.parametrize("style", ["paper", "print", "chalk"])
def test_it_is_the_picture_of_every_other_painter(tmp_path: Path, style: str):
    shown = posed(SHEET, style=style)
    tikz, agg = TikzPainter(SHEET), AggPainter(shown.board.form)
    for painter in (tikz, agg):
        shown.play(Wordless(painter))
    pixels = compiled(tikz.tikz, tmp_path)
    other = agg.pixels[..., :3].astype(int)
    height = min(len(pixels), len(other))
    differ = np.abs(pixels[:height] - other[:height]).max(axis=2)
    assert (differ > 100).mean() < 2e-3
    assert (np.abs(other - other[0, 0]).max(axis=2) > 100).mean() > 1e-2  # there is something


@pytest.mark.exhaustive(12)
@pytest.mark.parametrize("kind", ["sheet", "still", "turn", "poses", "problem", "space", "forces"])
def test_letters_and_all_compile(tmp_path: Path, kind: str):
    motion = vad.solve(vad.SliderCrank())
    thing = {
        "sheet": lambda: SHEET,
        "still": lambda: vad.still(vad.animate(SHEET), "acceleration:5"),
        "turn": lambda: vad.turn(motion, title="50 % & more"),
        "poses": lambda: vad.multiples(motion, (30, 60), language="fr"),
        "problem": lambda: vad.draw(motion),
        "space": lambda: vad.draw(vad.solve(vad.RSSR()), language="fr"),
        "forces": lambda: vad.draw(vad.forces(motion, [{"at": "C", "force": 800, "angle": 180}])),
    }[kind]()
    blank = {"blank": "velocity"} if kind == "problem" else {}
    vad.save(thing, tmp_path / "a.tikz", **blank)
    compiled((tmp_path / "a.tikz").read_text("utf-8"), tmp_path)


def test_each_stroke_has_a_scope_and_each_style_a_name(tmp_path: Path):
    vad.save(SHEET, tmp_path / "a.tikz")
    text = (tmp_path / "a.tikz").read_text("utf-8")
    vad.save(SHEET, tmp_path / "a.svg")
    strokes = set(re.findall(r"vad stroke=\{(.*?)\}", text))
    assert strokes == set(
        re.findall('data-stroke="(.*?)"', (tmp_path / "a.svg").read_text("utf-8"))
    )
    named = set(re.findall(r"\\vadstyle\{(vad .*?)\}", text))
    used = set(re.findall(r"\\(?:path\[|vadwords\{)(vad [a-z_ ]+)", text))
    assert used == named - {"vad stroke", "vad text"}
    assert {"vad vector crank", "vad bar rod", "vad head crank", "vad letter"} <= used
    assert text.count(r"\begin{scope}") == text.count(r"\end{scope}")


def test_a_style_of_the_document_takes_the_place_of_one_of_the_picture(tmp_path: Path):
    vad.save(SHEET, tmp_path / "a.tikz")
    text = (tmp_path / "a.tikz").read_text("utf-8")
    pink = np.array([255, 0, 255])
    style = r"\tikzset{vad bar crank/.style={draw=mine, line width=3pt}}"
    own = r"\definecolor{mine}{HTML}{FF00FF}" + style
    usual, other = (compiled(text, tmp_path, each) for each in ("", own))
    assert not (usual == pink).all(axis=2).any()
    assert (other == pink).all(axis=2).sum() > 100


def test_no_name_of_a_sheet_from_elsewhere_is_a_command(tmp_path: Path):
    text = to_text(vad.draw(vad.solve(vad.FourBar()))).replace("BC.line", "B}\\\\input{x}")
    vad.save(vad.sheet_from_json(text), tmp_path / "a.tikz")
    found = (tmp_path / "a.tikz").read_text("utf-8")
    assert "vad stroke={velocity:B--input-x-}" in found
    assert r"\input{x}" not in found
