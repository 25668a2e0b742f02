"""A lesson for Beamer: a document that steps through a PDF of all steps, which lies beside it.

``lecture.tex`` has a frame for each chapter, with the pages of ``lecture-steps.pdf`` as overlays
and the captions as notes.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import groupby
from typing import BinaryIO

from vad.errors import UsageError, quoted
from vad.export.frames import Progress
from vad.lecture.lesson import Lesson
from vad.lecture.slides import heading_of, slides
from vad.painting.latex import latex_of
from vad.plan.lettering.runs import roman, said
from vad.strokes.sentences import pieces_of

#: How the name of the file that lies beside this one ends, and what it is saved as.
COMPANION = "-steps.pdf"
#: What a name of a file in LaTeX is made of.
_NAME = re.compile(r"[\w .+@-]+", re.ASCII)
#: The shapes of slides that Beamer knows, by their name.
_SHAPES = {"169": 16 / 9, "1610": 16 / 10, "149": 14 / 9, "32": 3 / 2, "43": 4 / 3, "54": 5 / 4}
_HEAD = r"""% Compile this file with pdflatex, or copy its frames into slides of your own.
\documentclass[aspectratio={shape}]{{beamer}}
\usepackage[T1]{{fontenc}}
\setbeamertemplate{{navigation symbols}}{{}}
\setbeamersize{{text margin left=0pt, text margin right=0pt}}
% \setbeameroption{{show notes}} % for a hand-out with the captions
\newcommand*{{\vadsteps}}{{{name}}}
\newcommand*{{\vadstep}}[3]{{% overlay, page, caption
  \only<#1>{{\includegraphics[page=#2, width=\paperwidth, height=\paperheight,
    keepaspectratio]{{\vadsteps}}}}%
  \note<#1>{{#3}}}}
\title{{{title}}}
\begin{{document}}
"""


def write(
    lesson: Lesson,
    target: BinaryIO,
    *,
    companion: str,
    progress: Progress | None = None,
) -> None:
    """Write the document; ``companion`` is the name of the PDF with a page for each step.

    Raises
    ------
    vad.errors.UsageError
        If LaTeX cannot read a file of this name.
    """
    if not _NAME.fullmatch(companion):
        name = companion.removesuffix(COMPANION) + ".tex"
        raise UsageError(f"{quoted(name)} is no name that LaTeX reads", "as in lecture-4.tex")
    target.write("".join(_lines(lesson, companion)).encode())
    if progress is not None:
        progress(lesson.frames, lesson.frames)


def _lines(lesson: Lesson, name: str) -> Iterator[str]:
    width, height = lesson.size
    shape = min(_SHAPES, key=lambda each: abs(_SHAPES[each] - width / height))
    yield _HEAD.format(shape=shape, name=name, title=latex_of(roman(lesson.sheet.title)))
    numbered = enumerate(slides(lesson), start=1)
    for heading, pages in groupby(numbered, lambda each: heading_of(lesson, each[1])):
        yield f"\n\\section{{{latex_of(roman(heading))}}}\n"
        yield f"\\begin{{frame}}[plain] % {heading}\n"
        for overlay, (page, slide) in enumerate(pages, start=1):
            caption = latex_of(said(pieces_of(slide.said)))
            yield f"  \\vadstep{{{overlay}}}{{{page}}}{{{caption}}}%\n"
        yield "\\end{frame}\n"
    yield "\n\\end{document}\n"
