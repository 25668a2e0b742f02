"""The words of every language: one file per language, for captions, boards and pages alike.

`vad.words.en` says how such a file is written.  What a language leaves out, a whole table or a
single phrase, is said in English.  The files are Python and not TOML because Python compiles a file
once: reading them takes a tenth of the time.  Other packages bring languages by the entry point
group ``vad.languages``, each a module like `vad.words.en`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache, lru_cache
from importlib import import_module
from string import Formatter
from typing import Any, Literal, NamedTuple

from vad.discovery import all_names, from_packages, names_in, one_of_all
from vad.errors import InputError

#: Where other packages say which languages they bring.
GROUP = "vad.languages"
#: The language that has every phrase.
ENGLISH = "en"

#: Names by the codes of languages, and by what they name.
Names = Mapping[str, Mapping[str, str]]
NO_NAMES: Names = {}

PieceKind = Literal["words", "symbol", "figure", "unit"]


class TextPiece(NamedTuple):
    """A piece of a text: words, a symbol such as ω₃ or b′, a number or a unit."""

    text: str
    kind: PieceKind = "words"


class Gap(NamedTuple):
    """A place in a phrase that is filled in: the name of the part, and the article it takes."""

    name: str
    article: str = ""


#: What a phrase consists of, in the order in which it is said.
Template = tuple[TextPiece | Gap, ...]


def languages() -> tuple[str, ...]:
    """Return the codes of the languages of this package."""
    return names_in("words")


def all_languages() -> tuple[str, ...]:
    """Return the codes of all languages, those of other packages last."""
    return all_names(languages(), GROUP)


@cache
def template(phrase: str) -> Template:
    """Return what a phrase consists of.

    Examples
    --------
    >>> [each[0] for each in template("2·*v* = {rate} {rad/s}")]
    ['2·', 'v', ' = ', 'rate', ' ', 'rad/s']
    """
    found: list[TextPiece | Gap] = []
    for fixed, name, article, _ in Formatter().parse(phrase):
        kinds: tuple[PieceKind, PieceKind] = ("words", "symbol")
        for number, text in enumerate(fixed.split("*")):
            if text:
                found.append(TextPiece(text, kinds[number % 2]))
        if name is not None:
            found.append(TextPiece(name, "unit") if "/" in name else Gap(name, article or ""))
    return tuple(found)


@cache
def gaps(phrase: str) -> frozenset[str]:
    """Return the names of the parts that a phrase of the language files has.

    Examples
    --------
    >>> sorted(gaps("crossing zero"))
    ['found', 'letter']
    """
    found = Language(ENGLISH).template(phrase)
    return frozenset(each.name for each in found if isinstance(each, Gap))


def text_of(pieces: Iterable[TextPiece]) -> str:
    """Return the text of pieces."""
    return "".join([piece[0] for piece in pieces])


class Language:
    """The words of one language.

    Parameters
    ----------
    code
        Its two letters.
    own
        Names that a mechanism brings, by the codes of languages: "das Nebenpleuel" for
        ``link_rod``.  An article says the gender.

    Attributes
    ----------
    point
        Its decimal sign.

    Raises
    ------
    vad.errors.UsageError
        If neither this package nor another one has this language.
    vad.errors.InputError
        If the module of another package is no language file.

    Examples
    --------
    >>> Language("de").name("crank"), Language("de").say("and", first="a", last="d")
    ('Kurbel', 'a und d')
    """

    def __init__(self, code: str, own: Names = NO_NAMES) -> None:
        self.code = one_of_all("language", code, languages(), GROUP)
        self.own = own
        self._own = own.get(self.code, {}) if own else own
        self._tables = _tables(self.code)
        self.point = self._tables.point

    def say(self, phrase: str, **texts: str) -> str:
        """Return a phrase with texts in its gaps."""
        found = self.template(phrase)
        return "".join([texts[each.name] if isinstance(each, Gap) else each[0] for each in found])

    def pieces(self, phrase: str) -> tuple[TextPiece, ...]:
        """Return a phrase without gaps."""
        return tuple(each for each in self.template(phrase) if isinstance(each, TextPiece))

    def template(self, phrase: str) -> Template:
        """Return a phrase, in English if this language does not have it."""
        return self.speaker(phrase)._tables.template(phrase)

    def speaker(self, phrase: str) -> Language:
        """Return the language in which a phrase is said: this one, or English."""
        return self if phrase in self._tables.phrases else Language(ENGLISH, self.own)

    def name(self, name: str) -> str:
        """Return a name or title in this language, or as it is if no language has it."""
        own = self._own.get(name)
        return self._tables.parted(own)[1] if isinstance(own, str) else self._tables.name(name)

    def noun(self, name: str, article: str = "", generic: str = "link") -> str:
        """Return a name as a sentence has it, with the article for which a phrase asks.

        If its gender is unknown, the name follows its ``generic`` name, if it has one.

        Examples
        --------
        >>> Language("de").noun("crank", "des"), Language("de").noun("wing", "der")
        ('der Kurbel', 'das Glied wing')
        """
        own = self._own.get(name)
        if isinstance(own, str):
            return self._tables.own_noun(own, article, generic)
        return self._tables.noun(name, article, generic)

    def page(self, table: str) -> Mapping[str, str]:
        """Return a table: ``PLAYER``, ``HAND``, ``SPOKEN``, ``WINDOW`` or ``DESIGN``."""
        return self._tables.page(table)


class _Tables:
    """The tables of a language's file, each in English where it has none of its own."""

    def __init__(self, code: str, module: Any) -> None:
        self.code = code
        self.phrases: Mapping[str, str] = _table(module, "PHRASES")
        self.point: str = getattr(module, "POINT", ".")
        self._module = module
        self._articles: Mapping[str, Mapping[str, str]] = _table(module, "ARTICLES")
        self._genders: Mapping[str, str] = _table(module, "GENDERS")
        self._tied: tuple[str, ...] = getattr(module, "TIED", ())
        self.template = lru_cache(maxsize=None)(self._template)
        self.name = lru_cache(maxsize=256)(self._name)
        self.noun = lru_cache(maxsize=256)(self._noun)
        self.page = lru_cache(maxsize=None)(self._page)

    def _template(self, phrase: str) -> Template:
        try:
            return template(self._bound(self.phrases[phrase]))
        except ValueError as error:
            raise InputError(f"language '{self.code}': phrase '{phrase}': {error}") from None

    def _name(self, name: str) -> str:
        names = _table(self._module, "NAMES")
        point, _, kind = name.partition("_")
        of_point = names.get(f"{{}}_{kind}", "") if point[:1].isupper() else ""  # as in B_angle
        known = names.get(name) or _english("NAMES").get(name) or of_point.format(point)
        return known or name.replace("_", " ")

    def _noun(self, name: str, article: str, generic: str) -> str:
        known = name in self._genders or not self._articles or not generic
        gender = self._genders.get(name if known else generic, "")
        if known:
            return self._declined(self.name(name), gender, article)
        return f"{self._declined(self.name(generic), gender, article)} {self.name(name)}"

    def own_noun(self, own: str, article: str, generic: str) -> str:
        """Return a name that a mechanism brings, as a sentence has it."""
        gender, bare = self.parted(own)
        if gender or not self._articles or not generic:
            return self._declined(bare, gender, article)
        first = self._genders.get(generic, "")
        return f"{self._declined(self.name(generic), first, article)} {bare}"

    def parted(self, own: str) -> tuple[str, str]:
        """Return the gender that the article of a name says, empty without one, and the name.

        The first form of each gender is the article as it stands before a subject.
        """
        for gender, forms in self._articles.items():
            before, _, behind = next(iter(forms.values())).partition("{}")
            if not behind and own.startswith(before) and len(own) > len(before):
                return gender, own.removeprefix(before)
        return "", own.removeprefix("the ") if not self._articles else own

    def _declined(self, said: str, gender: str, article: str) -> str:
        """Return a name with the article for which a sentence asks."""
        forms = self._articles.get(gender, {})
        if article:
            said = forms.get(article.lower(), f"{article.lower()} {{}}").format(said)
        if article[:1].isupper():
            said = said[0].upper() + said[1:]
        return said

    def _page(self, table: str) -> Mapping[str, str]:
        own = _table(self._module, table)
        return {**_english(table), **{key: self._bound(text) for key, text in own.items()}}

    def _bound(self, text: str) -> str:
        """Return a text in which signs are not parted from the word before them."""
        for tied in self._tied:
            text = text.replace(tied, tied.replace(" ", "\N{NO-BREAK SPACE}"))
        return text


@cache
def _tables(code: str) -> _Tables:
    """Return the tables of a language of this package or another one."""
    if code in languages():
        return _Tables(code, import_module(f"{__name__}.{code}"))
    module = from_packages(GROUP)[code]
    if not isinstance(getattr(module, "PHRASES", None), Mapping):
        raise InputError(f"language '{code}': has no table PHRASES", hint="as vad.words.en has it")
    return _Tables(code, module)


def _english(table: str) -> Mapping[str, str]:
    return _table(import_module(f"{__name__}.{ENGLISH}"), table)


def _table(module: Any, name: str) -> Mapping[str, Any]:
    found: Mapping[str, Any] = getattr(module, name, {})
    return found
