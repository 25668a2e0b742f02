"""Sentences as data: a phrase of the language files, and the parts that fill its gaps.

The caption of a stroke is such a sentence.  It becomes text when somebody reads it.  The types of
its parts tell numbers, units, nouns and symbols apart; the `Voice` has the language and knows how
numbers are written.  A script says one by ``scene.say("crossing", letter="c")``; a number in it is
a `Figure`, a unit a `Unit`, a link or slide a `Noun`, and any other text the letters of points,
vectors and quantities.  The calculations of a sentence come before its parts: ``scene.say("whole",
product("value", "rate", "size"), value=…, rate=…, size=…)``.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any, TypeAlias

from vad.errors import InputError
from vad.strokes.arithmetic import Calculation, Figure, Terms
from vad.strokes.notation import Notation
from vad.words import Gap, Language, Names, TextPiece, gaps, text_of
from vad.written import MINUS, plain, squared, typeset


@dataclass(slots=True)
class Unit:
    """A unit, as data have it: mm/s where the sheet writes m/s, but not if it was ``typed``."""

    name: str
    typed: bool = False


@dataclass(slots=True)
class Noun:
    """A name of the language files: a link, a slide, a title.

    Attributes
    ----------
    name
        What the program calls it.
    generic
        The general word for it, link or slider.  It is written before a name whose gender is
        unknown.  Empty for a name that stands alone, as in a title.
    of
        What follows it: "of A".
    """

    name: str
    generic: str = "link"
    of: Sentence | None = None


@dataclass(slots=True)
class Listed:
    """Several parts, one after the other, with a sign between them."""

    items: tuple[SentencePart, ...]
    between: str


@dataclass(slots=True)
class Voice:
    """The language of a sheet, and how it writes numbers.

    While strokes are drawn, the notation is not complete: whether rates are written in metres is
    known after the last one.
    """

    language: str = "en"
    notation: Notation = field(default_factory=Notation)
    names: Names = field(default_factory=dict)

    def pieces(self, part: SentencePart) -> tuple[TextPiece, ...]:
        """Return what a part says, as pieces."""
        found: list[TextPiece] = []
        _add(found, part, self, Language(self.language, self.names))
        return tuple(found)

    def text(self, part: SentencePart) -> str:
        """Return what a part says, as a string."""
        return text_of(self.pieces(part))


@dataclass(slots=True)
class Sentence:
    """A sentence as data, which belongs to no language yet.

    Attributes
    ----------
    phrase
        The key of a phrase in the language files.
    parts
        What fills its gaps, by their names.
    calculations
        The calculations in it, by the names of its parts.
    voice
        The voice of its sheet, which says it if no other voice is asked.

    Examples
    --------
    >>> said = Sentence("crossing", {"letter": "c"})
    >>> str(said)
    'c is where both lines cross.'
    >>> Voice("de").text(said)
    'c ist der Schnittpunkt der Geraden.'
    """

    phrase: str
    parts: Mapping[str, SentencePart] = field(default_factory=dict)
    calculations: tuple[Calculation, ...] = ()
    voice: Voice = field(default_factory=Voice, compare=False, repr=False)
    _set: tuple[TextPiece, ...] = field(default=(), init=False, compare=False, repr=False)

    @property
    def pieces(self) -> tuple[TextPiece, ...]:
        """What it says in its voice, as pieces; they are made once."""
        if not self._set:
            self._set = self.voice.pieces(self)
        return self._set

    def __str__(self) -> str:
        return text_of(self.pieces)

    def __hash__(self) -> int:
        return hash(self.phrase)

    def figures(self, names: tuple[str | float, ...]) -> Iterator[Figure]:
        """Yield the numbers of parts, those of a sum one by one."""
        for name in names:
            part = self.parts[name] if isinstance(name, str) else Figure(name, given=True)
            if isinstance(part, Terms):
                yield from part.addends
            else:
                assert isinstance(part, Figure)
                yield part


#: What fills a gap.  A bare string is the letters of a point, a vector, a line or a quantity.
SentencePart: TypeAlias = str | Figure | Unit | Noun | Listed | Terms | Sentence


class Text(str):
    """The text of a label, a title or a note, together with the data that it was made from.

    Examples
    --------
    >>> title = Text.of(Noun("crank", ""), Voice("de"))
    >>> title, title.said
    ('Kurbel', Noun(name='crank', generic='', of=None))
    """

    __slots__ = ("pieces", "said")
    said: SentencePart
    pieces: tuple[TextPiece, ...]

    @classmethod
    def of(cls, said: SentencePart, voice: Voice) -> Text:
        """Return the text of a part in a voice."""
        pieces = voice.pieces(said)
        return cls.kept(text_of(pieces), said, pieces)

    @classmethod
    def kept(cls, text: str, said: SentencePart, pieces: tuple[TextPiece, ...] = ()) -> Text:
        """Return a text whose pieces are known."""
        made = cls(text)
        made.said, made.pieces = said, pieces
        return made

    def __reduce__(self) -> tuple[Any, ...]:
        return Text.kept, (str(self), self.said, self.pieces)


def called(name: str, voice: Voice) -> Text:
    """Return the word for a name, as titles have it: that of the mechanism, or of the language."""
    own = any(name in names for names in voice.names.values())
    return Text.of(Noun(name, generic=""), voice) if own else named(name, voice.language)


@lru_cache(maxsize=1024)
def named(name: str, code: str) -> Text:
    """Return the word of a language for a name, as titles have it.

    Examples
    --------
    >>> named("crank", "de"), named("ground_twist", "en")
    ('Kurbel', 'angle of axes')
    """
    return Text.of(Noun(name, generic=""), Voice(code))


def pieces_of(said: str | Sentence) -> tuple[TextPiece, ...]:
    """Return the pieces of a caption, label or note; a plain string is one piece."""
    if isinstance(said, Text | Sentence):
        return said.pieces
    return (TextPiece(said),)


def _add(
    found: list[TextPiece], part: SentencePart, voice: Voice, language: Language, article: str = ""
) -> None:
    """Append what a part says to the pieces ``found`` so far."""
    if isinstance(part, str):
        found.append(TextPiece(part, "symbol"))
    elif isinstance(part, Figure):
        text = _number(part, voice.notation)
        found.append(TextPiece(squared(text) if part.power == 2 else text, "figure"))
    elif isinstance(part, Unit):
        unit = part.name if part.typed else voice.notation.unit(part.name)
        found.append(TextPiece(unit, "unit"))
    elif isinstance(part, Sentence):
        speaker = language.speaker(part.phrase)
        factors = _factors(part, voice.notation)
        for each in speaker.template(part.phrase):
            if not isinstance(each, Gap):
                found.append(each)
            elif each.name in factors:
                found += factors[each.name]
            elif each.name in part.parts:
                _add(found, part.parts[each.name], voice, speaker, each.article)
            else:
                where = f"language '{speaker.code}': phrase '{part.phrase}'"
                raise InputError(f"{where}: there is no {{{each.name}}}")
    elif isinstance(part, Noun):
        found.append(TextPiece(language.noun(part.name, article, part.generic)))
        if part.of:
            found.append(TextPiece(" "))
            _add(found, part.of, voice, language)
    elif isinstance(part, Terms):
        for number, addend in enumerate(part.addends):
            size = replace(addend, value=abs(addend.value)) if number else addend
            if number:
                found.append(TextPiece(f" {MINUS} " if addend.value < 0.0 else " + "))
            _add(found, size, voice, language)
    else:
        for number, item in enumerate(part.items):
            if number:
                found.append(TextPiece(part.between))
            _add(found, item, voice, language)


def _number(figure: Figure, notation: Notation) -> str:
    """Return a number as a sentence has it."""
    if figure.typed:
        return typeset(plain(figure.value, figure.unit, given=True), notation.point)
    unit = figure.scale or figure.unit
    return notation.number(figure.value, unit, figure.given, figure.digits)


def _factors(sentence: Sentence, notation: Notation) -> dict[str, list[TextPiece]]:
    """Return the factors of a product with their units, where one is written in another unit.

    A length that is 60 mm in the title is 0.06 m here.
    """
    names = [name for each in sentence.calculations for name in each.operands]
    figures = {name: sentence.parts[name] for name in names if isinstance(name, str)}
    factors = {name: part for name, part in figures.items() if isinstance(part, Figure)}
    if not any(part.scale and notation.changes(part.scale) for part in factors.values()):
        return {}
    divided = any(part.power < 0 for part in factors.values())
    return {name: _factor(part, divided, notation) for name, part in factors.items()}


def _factor(figure: Figure, divided: bool, notation: Notation) -> list[TextPiece]:
    """Return a factor with its unit: 0.06 m, (10 rad/s)²."""
    unit = notation.unit(figure.scale or figure.unit)
    unit = unit.partition("/")[0] if figure.scale else unit
    pieces = [
        TextPiece(_number(figure, notation), "figure"),
        TextPiece(" "),
        TextPiece(unit, "unit"),
    ]
    if divided or figure.power != 1:
        pieces = [TextPiece("("), *pieces, TextPiece(")²" if figure.power == 2 else ")")]
    return pieces


@dataclass(frozen=True)
class CaptionedMotion:
    """A motion, the language of its captions, and the captions with calculations."""

    motion: Any
    language: Language
    voice: Voice = field(init=False)
    #: The sentences with calculations, whose numbers get their digits when the notation is known.
    calculated: list[Sentence] = field(default_factory=list, init=False)

    def __post_init__(self) -> None:
        """Make the voice, whose notation is not complete at first."""
        own = self.motion.mechanism.own_names
        voice = Voice(self.language.code, Notation(self.language.point), own)
        object.__setattr__(self, "voice", voice)

    def say(self, phrase: str, *calculations: Calculation, **parts: SentencePart) -> Sentence:
        """Return a sentence; one with calculations is recorded.

        It keeps only the parts for which its phrase has gaps.
        """
        wanted = gaps(phrase)
        if not wanted.issuperset(parts):
            parts = {name: part for name, part in parts.items() if name in wanted}
        sentence = Sentence(phrase, parts, calculations, self.voice)
        if calculations:
            self.calculated.append(sentence)
        return sentence

    def write(self, phrase: str, **parts: SentencePart) -> Text:
        """Return the text of a label, a title or a note, without calculations."""
        return Text.of(Sentence(phrase, parts), self.voice)

    def name(self, name: str) -> Text:
        """Return the word of its language for a name."""
        return called(name, self.voice)
