"""Slides of PowerPoint and of Beamer: a picture for each step, with its caption."""

from __future__ import annotations

import io
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pypdf
import pytest
from PIL import Image
from pptx import Presentation

import vad
from vad.errors import InputError, UsageError
from vad.lecture.lesson import Lesson
from vad.painting.latex import latex_of
from vad.painting.posed import picture
from vad.plan.lettering.runs import bold, roman, symbols

LATEX = shutil.which("pdflatex")


@pytest.fixture(scope="module")
def lesson() -> Lesson:
    sheet = vad.draw(vad.solve(vad.SliderCrank()), title="Exercise 4 & 5: 50 %", language="de")
    return vad.animate(sheet, size=(640, 480))


@pytest.fixture(scope="module")
def slides(lesson: Lesson, tmp_path_factory):
    path = tmp_path_factory.mktemp("slides") / "lecture.pptx"
    vad.save(lesson, path)
    return path


def test_each_step_has_a_slide_with_its_picture_words_and_note(lesson: Lesson, slides: Path):
    found = Presentation(slides)
    assert found.slide_width / found.slide_height == pytest.approx(4 / 3)
    assert found.core_properties.title.startswith("Exercise 4 & 5: 50 %: Kurbel 60 mm")
    *slides, last = found.slides
    for slide, step in zip(slides, lesson.steps, strict=True):
        _, shown = slide.shapes
        heading = f"{step.panel.title} {lesson.place(step)}"
        assert slide.shapes.title.text == heading
        assert shown._element.nvPicPr.cNvPr.get("descr") == f"{heading}: {step.stroke.caption}"
        assert slide.notes_slide.notes_text_frame.text == step.stroke.caption
        sides = shown.left, shown.top, shown.width, shown.height
        assert sides == (0, 0, found.slide_width, found.slide_height)
    assert last.shapes.title.text == "Antwort"
    assert last.notes_slide.notes_text_frame.text == str(lesson.answer)
    pixels = np.asarray(Image.open(io.BytesIO(shown.image.blob)))
    assert np.array_equal(pixels, picture(vad.still(lesson, len(lesson.steps)))[..., :3])


def test_a_slide_for_each_panel(lesson: Lesson, tmp_path: Path):
    vad.save(lesson, tmp_path / "panels.pptx", per_panel=True)
    found = Presentation(tmp_path / "panels.pptx").slides
    titles = [panel.title for panel in lesson.sheet.panels]
    assert [slide.shapes.title.text for slide in found] == [*titles, "Antwort"]
    notes = "\n".join(slide.notes_slide.notes_text_frame.text for slide in found)
    captions = [step.stroke.caption for step in lesson.steps]
    assert notes.split("\n") == [*captions, str(lesson.answer)]


@pytest.mark.parametrize("name", ["a.pptx", "a.pdf"])
def test_progress_rises_to_the_whole_film(lesson: Lesson, tmp_path: Path, name: str):
    told = []
    vad.save(lesson, tmp_path / name, progress=lambda done, total: told.append((done, total)))
    done = [each for each, _ in told]
    assert done[:-2] == sorted(set(done[:-2]))
    assert set(told[-2:]) == {(lesson.frames, lesson.frames)}


def test_the_same_slides_are_the_same_file(lesson: Lesson, slides: Path, tmp_path: Path):
    vad.save(lesson, tmp_path / "again.pptx")
    assert (tmp_path / "again.pptx").read_bytes() == slides.read_bytes()


def test_slides_need_their_extra(lesson: Lesson, tmp_path: Path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pptx", None)
    with pytest.raises(InputError, match=r"^pptx is not installed$") as wrong:
        vad.save(lesson, tmp_path / "lecture.pptx")
    assert wrong.value.hint == "pip install 'vad-diagrams[slides]'"
    assert not list(tmp_path.iterdir())


@pytest.fixture(scope="module")
def beamer(lesson: Lesson, tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("beamer") / "lecture 4.tex"
    vad.save(lesson, path)
    return path


def test_beamer_has_an_overlay_for_each_page_of_the_steps(lesson: Lesson, beamer: Path):
    text = beamer.read_text("utf-8")
    steps = pypdf.PdfReader(beamer.with_name("lecture 4-steps.pdf"))
    overlays = re.findall(r"\\vadstep\{(\d+)\}\{(\d+)\}", text)
    assert [int(page) for _, page in overlays] == list(range(1, len(steps.pages) + 1))
    places = [lesson.place(step) for step in lesson.steps]
    assert [int(number) for number, _ in overlays] == [*places, 1]
    assert text.count(r"\begin{frame}") == text.count(r"\end{frame}") == 4
    assert r"\newcommand*{\vadsteps}{lecture 4-steps.pdf}" in text
    assert r"\title{Exercise 4 \& 5: 50 \%}" in text
    assert "aspectratio=43" in text


def test_what_is_on_the_board_already_has_no_slide_and_each_chapter_its_frame(tmp_path: Path):
    sheet = vad.draw(vad.solve(vad.Whitworth(rod=300)))
    lesson = vad.animate(sheet, loop=2)
    vad.save(lesson, tmp_path / "a.tex")
    text = (tmp_path / "a.tex").read_text("utf-8")
    assert text.count(r"\begin{frame}") == len(sheet.panels) + 1
    drawn = sum(not step.there for step in lesson.steps)
    assert len(re.findall(r"\\vadstep\{\d", text)) == drawn + 1


def test_beamer_compiles(lesson: Lesson, beamer: Path):
    if LATEX is None:
        pytest.skip("there is no pdflatex")
    compiled(beamer, beamer.parent)
    pages = pypdf.PdfReader(beamer.with_suffix(".pdf")).pages
    assert len(pages) == len(lesson.steps) + 1


def compiled(path: Path, folder: Path) -> str:
    """Compile a document and return what LaTeX said; an error of LaTeX is a failure."""
    words = [LATEX, "-interaction=nonstopmode", "-halt-on-error", path.name]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-2000:]
    return done.stdout


def test_a_name_that_latex_cannot_read_is_refused(lesson: Lesson, tmp_path: Path):
    with pytest.raises(UsageError, match=r"'50%\.tex' is no name that LaTeX reads"):
        vad.save(lesson, tmp_path / "50%.tex")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["sheet.eps", "lecture.EPS"])
def test_eps_is_answered_in_a_clause(lesson: Lesson, tmp_path: Path, name: str):
    with pytest.raises(UsageError, match=r"\.eps is not made$") as wrong:
        vad.save(lesson if "lecture" in name else lesson.sheet, tmp_path / name)
    assert wrong.value.hint == "save .pdf, of which pdftops -eps makes EPS"


@pytest.mark.parametrize(
    ("runs", "text"),
    [
        (symbols("b′cₙ"), "$b'c_{n}$"),
        (symbols("a″"), "$a''$"),
        (symbols("ω₃²·BC"), r"$\omega _{3}{}^{2}\cdot BC$"),
        (symbols("s_D"), "$s_{D}$"),
        (symbols("⟂ BC"), r"$\perp $ $BC$"),
        (symbols("∥ guide"), r"$\parallel $ guide"),
        (symbols("ṡ"), r"$\dot{s}$"),
        (symbols("θ̇"), r"$\dot{\theta}$"),
        (roman("rod 60 mm,   offset 0"), r"rod 60 mm,\quad offset 0"),
        (roman("1\N{NO-BREAK SPACE}000\N{NARROW NO-BREAK SPACE}mm"), r"1~000\,mm"),
        (roman("50 % & a_b {x} # $"), r"50 \% \& a\_b \{x\} \# \$"),
        (roman("\\ ~ ^"), r"\textbackslash{} \textasciitilde{} \textasciicircum{}"),
        (roman("−2 < 3"), "$-$2 $<$ 3"),
        (bold(roman("Lage")), r"{\bfseries\boldmath Lage}"),
    ],
)  # fmt: skip
def test_words_for_latex(runs, text: str):
    assert latex_of(runs) == text
