"""A sheet in another language: the same strokes with other words."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from vad.errors import InputError
from vad.strokes.sentences import Sentence, Text, Voice
from vad.strokes.shapes import PolarInset
from vad.strokes.sheet import Equation, Panel, Sheet, Stroke, Term
from vad.words import Language

#: A function that says a text or a caption in another voice.
Say = Callable[[str | Sentence], str | Sentence]


def translated(sheet: Sheet, code: str) -> Sheet:
    """Return a sheet in the language ``code``; texts that are no sentences stay as they are.

    Raises
    ------
    vad.errors.UsageError
        If there is no such language.

    Examples
    --------
    >>> import vad
    >>> sheet = translated(vad.draw(vad.solve(vad.FourBar())), "de")
    >>> sheet.title, sheet.panel("velocity").strokes[4].caption
    ('Gelenkviereck', 'c ist der Schnittpunkt der Geraden.')
    """
    voice = Voice(code, replace(sheet.notation, point=Language(code).point), sheet.names)
    with_words = said_by(sheet, lambda words: _in_voice(words, voice))
    return replace(with_words, language=code, notation=voice.notation)


def as_written(sheet: Sheet) -> Sheet:
    """Return a sheet from a file, with plain text for each sentence that differs from its text.

    So a caption that somebody has edited in the file is kept as it is.
    """
    voice = Voice(sheet.language, sheet.notation, sheet.names)

    def say(words: str | Sentence) -> str | Sentence:
        if not isinstance(words, Text):
            return words
        try:
            said = Text.of(words.said, voice)
        except (KeyError, InputError):  # a phrase of another program, or a part is missing
            return str(words)
        return said if said == words else str(words)

    return said_by(sheet, say, captions=lambda words: _caption(say(words), voice))


def _caption(words: str | Sentence, voice: Voice) -> str | Sentence:
    """Return a caption as a sentence where it is one."""
    if isinstance(words, Text) and isinstance(words.said, Sentence):
        return replace(words.said, voice=voice)
    return str(words)


def _in_voice(words: str | Sentence, voice: Voice) -> str | Sentence:
    if isinstance(words, Sentence):
        return replace(words, voice=voice)
    return Text.of(words.said, voice) if isinstance(words, Text) else words


def said_by(sheet: Sheet, say: Say, captions: Say | None = None) -> Sheet:
    """Return a sheet with all its words changed by ``say``, its captions by ``captions``."""
    caption = captions or say

    def text(words: str) -> str:
        said = say(words)
        assert isinstance(said, str)
        return said

    def stroke(old: Stroke) -> Stroke:
        return replace(old, label=text(old.label), said=caption(old.said))

    def terms(old: tuple[Term, ...]) -> tuple[Term, ...]:
        return tuple(replace(each, label=text(each.label)) for each in old)

    def panel(old: Panel) -> Panel:
        inset = old.inset
        if isinstance(inset, PolarInset):
            inset = replace(inset, title=text(inset.title), range=text(inset.range))
        return replace(
            old,
            title=text(old.title),
            remark=text(old.remark),
            notes=tuple(replace(note, text=text(note.text)) for note in old.notes),
            strokes=tuple(map(stroke, old.strokes)),
            zeros=tuple(map(stroke, old.zeros)),
            equations=tuple(Equation(terms(e.left), terms(e.right)) for e in old.equations),
            inset=inset,
            below=old.below and panel(old.below),
        )

    return replace(
        sheet,
        title=text(sheet.title),
        subtitle=text(sheet.subtitle),
        parameters=tuple((text(name), value, unit) for name, value, unit in sheet.parameters),
        rows=tuple(replace(row, title=text(row.title)) for row in sheet.rows),
        panels=tuple(map(panel, sheet.panels)),
    )
