"""A lesson as slides of PowerPoint: a slide for each step, its picture and its caption as a note.

python-pptx, the extra ``slides``, is loaded only here.
"""

from __future__ import annotations

import io
from collections.abc import Iterator
from datetime import datetime
from typing import Annotated, Any, BinaryIO
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from vad.discovery import from_extra
from vad.export.frames import Progress
from vad.lecture.lesson import Lesson
from vad.lecture.slides import Slide, heading_of, slides
from vad.painting.agg_painter import AggPainter
from vad.painting.painter import play
from vad.painting.posed import board_of
from vad.strokes.description import title
from vad.style import load_style

#: English metric units to a point: a slide is 7.5 inches high.
_UNIT, _HEIGHT = 12_700, 540
#: The layout of the empty presentation that has a title and nothing else.
_TITLE_ONLY = 5
#: The same slides are the same file at any time.
_MADE = datetime(2000, 1, 1)
_DATE = (2000, 1, 1, 0, 0, 0)


def write(
    lesson: Lesson,
    target: BinaryIO,
    *,
    per_panel: Annotated[bool, "a slide of a .pptx for each panel, not for each step"] = False,
    progress: Progress | None = None,
) -> None:
    """Write the slides of ``lesson``, of its size and style.

    Raises
    ------
    vad.errors.InputError
        If python-pptx is not installed.
    """
    show = from_extra("pptx", "slides").Presentation()
    width, height = lesson.size
    show.slide_height, show.slide_width = _HEIGHT * _UNIT, round(_HEIGHT * width / height) * _UNIT
    properties = show.core_properties
    properties.title, properties.language = title(lesson.sheet), lesson.sheet.language
    properties.author = properties.last_modified_by = ""
    properties.created = properties.modified = _MADE
    painted = _Pictures(lesson)
    for slide, captions in _shown(lesson, per_panel):
        _add(show, _heading(lesson, slide, captions), painted.of(slide), captions)
        if progress is not None:
            progress(slide.frames, lesson.frames)
    held = io.BytesIO()
    show.save(held)
    _repack(held, target)
    if progress is not None:
        progress(lesson.frames, lesson.frames)


def _shown(lesson: Lesson, per_panel: bool) -> Iterator[tuple[Slide, list[str]]]:
    """Yield the pages that have a slide, each with the captions that are said on it."""
    captions: list[str] = []
    pages = list(slides(lesson))
    for page, following in zip(pages, [*pages[1:], None], strict=True):
        captions.append(str(page.said))
        if not per_panel or not following or _chapter(page) != _chapter(following):
            yield page, captions
            captions = []


def _chapter(slide: Slide) -> str:
    return slide.step.chapter if slide.step else ""


def _heading(lesson: Lesson, slide: Slide, captions: list[str]) -> str:
    """Return the title of a slide: its panel, and the number of its step where it shows one."""
    heading = heading_of(lesson, slide)
    return f"{heading} {lesson.place(slide.step)}" if slide.step and len(captions) == 1 else heading


class _Pictures:
    """The pages of a lesson as PNG."""

    def __init__(self, lesson: Lesson) -> None:
        self._board, self._style = board_of(lesson), load_style(lesson.style)
        self._painter = AggPainter(self._board.form)

    def of(self, slide: Slide) -> io.BytesIO:
        """Return a page."""
        from PIL import Image

        play(self._board, slide.moment, self._style, self._painter)
        held = io.BytesIO()
        Image.fromarray(self._painter.pixels).convert("RGB").save(held, "PNG", compress_level=6)
        held.seek(0)
        return held


def _add(show: Any, heading: str, picture: io.BytesIO, captions: list[str]) -> None:
    """Add a slide whose title stands above its upper edge, for lists of slides and for readers."""
    slide = show.slides.add_slide(show.slide_layouts[_TITLE_ONLY])
    name = slide.shapes.title
    name.text = heading
    name.left, name.top = 0, -60 * _UNIT
    name.width, name.height = show.slide_width, 50 * _UNIT
    shape = slide.shapes.add_picture(picture, 0, 0, show.slide_width, show.slide_height)
    shape.name = heading
    described = shape._element.nvPicPr.cNvPr  # python-pptx has no name for it
    described.set("descr", f"{heading}: {' '.join(captions)}")
    slide.notes_slide.notes_text_frame.text = "\n".join(captions)


def _repack(held: io.BytesIO, target: BinaryIO) -> None:
    """Write an archive again, without the time of its making."""
    with ZipFile(held) as made, ZipFile(target, "w", ZIP_DEFLATED) as archive:
        for name in made.namelist():
            archive.writestr(ZipInfo(name, _DATE), made.read(name), ZIP_DEFLATED)
