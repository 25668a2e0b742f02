"""The form of a sheet's JSON: one table of keys, by which it is both written and read.

A key is absent if the stroke has no such thing.  Keys of the public contract (kind, label,
component, link, from, to, through, direction, at, caption, unit) stand beside those that make the
sheet whole.  Where a text is a sentence, its data stand beside it: ``caption_said`` beside
``caption``.

=============  =================================================================================
a string       letters of a point, a vector or a quantity
``figure``     a number with its unit, ``given`` where it was not measured, its ``power``, and the
               ``scale`` of another unit by which it is written
``unit``       a unit
``word``       a name of the language files, behind which ``of`` may follow
``terms``      the numbers of a sum
``list``       several of all these, with what is ``between`` them
``phrase``     a sentence with its ``parts`` and ``calculations``
=============  =================================================================================
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any, get_args

from vad.errors import InputError
from vad.export.data.records import (
    ANGLE,
    COUNT,
    FEWER,
    FLAG,
    INDEX,
    NUMBER,
    POINT,
    TEXT,
    WAY,
    Form,
    Key,
    by_attribute,
    by_name,
    many,
    one_of,
    optional,
    record,
    row,
    variants,
    within,
    wrong,
)
from vad.strokes.arithmetic import Calculation, CalculationKind, Figure, Terms
from vad.strokes.notation import Notation
from vad.strokes.sentences import Listed, Noun, Sentence, SentencePart, Text, Unit
from vad.strokes.shapes import Turned
from vad.strokes.sheet import (
    Arc,
    Arrow,
    Bearing,
    Block,
    Body,
    Cell,
    Coincidence,
    Component,
    CoriolisInset,
    Curve,
    Dot,
    Driver,
    Ellipse,
    Equation,
    Fold,
    Guide,
    ImageTriangle,
    KennedyCircle,
    Kind,
    Line,
    Note,
    Panel,
    PictureKind,
    Plate,
    PolarInset,
    Reason,
    Ride,
    Row,
    Sheet,
    Stroke,
    StrokePart,
    Term,
)
from vad.words import all_languages, languages

#: A unit as the JSON of ``vad solve`` spells it: mm/s^2.
UNIT = Form(
    lambda unit: unit.replace("²", "^2"),
    lambda value, place: TEXT.read(value, place).replace("^2", "²"),
)
#: The part of a stroke as its name: ``AB.bar``.
NAME = Form(lambda part: part.name, lambda value, place: StrokePart.named(TEXT.read(value, place)))


def _write_part(part: SentencePart) -> Any:
    return part if isinstance(part, str) else _PARTS[_KEYS[type(part)]].write(part)


def _read_part(value: Any, place: str) -> SentencePart:
    if isinstance(value, str):
        return TEXT.read(value, place)  # type: ignore[no-any-return]
    found = value if isinstance(value, Mapping) else {}
    for key, form in _PARTS.items():
        if key in found:
            return form.read(value, place)  # type: ignore[no-any-return]
    raise wrong(place, "a part of a sentence", value)


def _read_operand(value: Any, place: str) -> str | float:
    return (TEXT if isinstance(value, str) else NUMBER).read(value, place)  # type: ignore[no-any-return]


PART = Form(_write_part, _read_part)
FIGURE = record(
    Figure,
    value=Key(NUMBER, "figure"),
    unit=optional(UNIT, ""),
    given=optional(FLAG, False),
    power=optional(one_of((-1, 1, 2)), 1),
    scale=optional(UNIT, ""),
    typed=optional(FLAG, False),
    digits=optional(COUNT, 0),
)
CALCULATION = record(
    Calculation,
    result=TEXT,
    operation=one_of(get_args(CalculationKind)),
    operands=many(Form(lambda value: value, _read_operand)),
)
SENTENCE = record(
    Sentence,
    phrase=TEXT,
    parts=optional(by_name(PART), {}),
    calculations=optional(many(CALCULATION), ()),
)
#: The forms of a sentence's parts by the key that tells one from another.
_PARTS: dict[str, Form] = {
    "phrase": SENTENCE,
    "figure": FIGURE,
    "word": record(
        Noun, name=Key(TEXT, "word"), generic=optional(TEXT, "link"), of=optional(SENTENCE)
    ),
    "list": record(Listed, items=Key(many(PART), "list"), between=TEXT),
    "terms": record(Terms, addends=Key(many(FIGURE), "terms")),
    "unit": record(Unit, name=Key(UNIT, "unit"), typed=optional(FLAG, False)),
}
_KEYS: dict[Any, str] = {form.cls: key for key, form in _PARTS.items()}


def words(name: str, missing: str | None = None) -> Key:
    """Return the key of a text under ``name``, with the data of what it says beside it.

    A text that is ``missing`` is left out.
    """
    said = f"{name}_said"

    def write(text: str | Sentence) -> dict[str, Any]:
        part = text.said if isinstance(text, Text) else text
        data = {} if part is text and isinstance(part, str) else {said: PART.write(part)}
        return {} if text == missing else {name: str(text), **data}

    def read(found: Mapping[str, Any], place: str) -> str:
        if name not in found:
            if missing is None:
                raise InputError(f"{within(place, name)}: missing")
            return missing
        text: str = TEXT.read(found[name], within(place, name))
        if said not in found:
            return text
        return Text.kept(text, PART.read(found[said], within(place, said)))

    return Key(Form(write, read), beside=True)


def _write_parameters(parameters: tuple[tuple[str, float, str], ...]) -> dict[str, Any]:
    names = [name.said if isinstance(name, Text) else None for name, *_ in parameters]
    written = [None if each is None else PART.write(each) for each in names]
    said = {"parameters_said": written} if any(written) else {}
    return {"parameters": _PARAMETERS.write(parameters), **said}


def _read_parameters(found: Mapping[str, Any], place: str) -> tuple[tuple[str, float, str], ...]:
    at, said = within(place, "parameters"), within(place, "parameters_said")
    if "parameters" not in found:
        raise InputError(f"{at}: missing")
    parameters: tuple[tuple[str, float, str], ...] = _PARAMETERS.read(found["parameters"], at)
    names = found.get("parameters_said", [None] * len(parameters))
    if not isinstance(names, list) or len(names) != len(parameters):
        raise wrong(said, f"a list of {len(parameters)}", names)
    return tuple(
        each if part is None else (Text.kept(each[0], PART.read(part, said)), *each[1:])
        for each, part in zip(parameters, names, strict=True)
    )


_PARAMETERS = many(row(TEXT, NUMBER, UNIT))


def _read_language(value: Any, place: str) -> str:
    known = languages() if value in languages() else all_languages()
    return one_of(known).read(value, place)  # type: ignore[no-any-return]


ELLIPSE = record(
    Ellipse,
    centre=POINT,
    first=POINT,
    second=POINT,
    start=optional(ANGLE, 0.0),
    sweep=optional(ANGLE, 360.0),
    far=optional(many(row(NUMBER, NUMBER)), ()),
)
SHAPE = variants(
    "shape",
    dot=record(Dot, at=POINT),
    arrow=record(
        Arrow,
        start=Key(POINT, "from"),
        end=Key(POINT, "to"),
        tail=TEXT,
        head=TEXT,
        cylinder=optional(NUMBER, 0.0),
    ),
    line=record(Line, through=POINT, direction=WAY, until=POINT, square_to=optional(TEXT)),
    arc=record(Arc, centre=POINT, radius=NUMBER, start=ANGLE, sweep=ANGLE, through=optional(POINT)),
    guide=record(Guide, through=POINT, direction=WAY, side=optional(WAY)),
    block=record(
        Block,
        at=POINT,
        direction=WAY,
        on=optional(TEXT),
        travel=optional(row(NUMBER, NUMBER), (0.0, 0.0)),
    ),
    plate=record(Plate, corners=many(POINT), letters=many(TEXT)),
    curve=record(
        Curve,
        points=many(POINT),
        far=optional(FLAG, False),
        breaks=optional(many(INDEX), ()),
    ),
    ellipse=ELLIPSE,
    fold=record(Fold, centre=POINT, axis=WAY, turn=ANGLE, arms=many(POINT), rim=ELLIPSE),
    bearing=record(Bearing, at=POINT, direction=WAY),
    kennedy=record(
        KennedyCircle,
        names=many(TEXT),
        rows=many(TEXT),
        edges=many(row(INDEX, INDEX, TEXT)),
    ),
)
STROKE = record(
    Stroke,
    kind=one_of(get_args(Kind)),
    label=words("label"),
    component=optional(one_of(get_args(Component))),
    link=optional(TEXT),
    shape=Key(SHAPE, beside=True),
    said=words("caption"),
    part=Key(NAME, "name"),
    image=optional(FLAG, False),
    reveals=optional(many(TEXT), ()),
)
TERM = record(Term, label=words("label"), link=optional(TEXT), stroke=optional(TEXT))
EQUATION = record(Equation, left=many(TERM), right=many(TERM))
CORIOLIS = record(
    CoriolisInset,
    link=TEXT,
    slide=TEXT,
    slot=WAY,
    sliding=WAY,
    coriolis=WAY,
    sense=one_of((1, -1)),
    stroke=TEXT,
)
POLAR = record(
    PolarInset,
    driver=TEXT,
    driven=TEXT,
    circle=NUMBER,
    curve=many(POINT),
    ray=POINT,
    dots=many(POINT),
    title=words("title"),
    range=words("range"),
    stroke=TEXT,
)
INSET = variants("inset", "coriolis", coriolis=CORIOLIS, polar=POLAR)
TRIANGLE = record(ImageTriangle, link=TEXT, points=many(TEXT), corners=many(POINT), stroke=TEXT)
RIDE = record(Ride, block=TEXT, along=optional(TEXT), slot=optional(FLAG, False))
BODY = record(
    Body, row=optional(TEXT), points=optional(many(TEXT), ()), carries=optional(many(RIDE), ())
)
COINCIDENCE = record(Coincidence, letters=many(TEXT), reason=one_of(get_args(Reason)))
TURNED = record(Turned, panel=TEXT, degrees=ANGLE, rate=NUMBER, pole=POINT)
_DRAWN: dict[str, Form | Key] = {
    "unit": UNIT,
    "title": words("title"),
    "picture": one_of(get_args(PictureKind)),
    "strokes": many(STROKE, FEWER),
    "zeros": optional(many(STROKE, FEWER), ()),
    "equations": optional(many(EQUATION, FEWER), ()),
    "inset": optional(INSET),
    "triangles": optional(many(TRIANGLE), ()),
    "loops": optional(many(INDEX), ()),
    "notes": optional(
        many(record(Note, at=POINT, text=words("text"), comes=optional(TEXT, ""))), ()
    ),
    "remark": words("remark", missing=""),
    "bodies": optional(many(BODY), ()),
    "coincident": optional(many(COINCIDENCE), ()),
    "given": optional(COUNT, 0),
    "turned": optional(many(TURNED), ()),
    "resumes": words("resumes", missing=""),
}
LOWER = record(Panel, name=TEXT, **_DRAWN)
PANEL = record(
    partial(Panel, ""),  # whose name is its key
    **_DRAWN,
    below=optional(LOWER),
)
CELL = record(
    Cell,
    symbol=TEXT,
    value=NUMBER,
    unit=UNIT,
    given=optional(FLAG, False),
    below=optional(FLAG, False),
)
ROW = record(
    Row,
    key=TEXT,
    title=words("title"),
    letters=TEXT,
    cells=by_name(many(CELL)),
    inked=optional(FLAG, True),
)
NOTATION = record(
    Notation,
    point=one_of((".", ",")),
    metres=optional(FLAG, False),
)
DRIVER = record(
    Driver,
    row=TEXT,
    turns=optional(FLAG, True),
    rate=optional(NUMBER, 0.0),
    stroke=optional(TEXT),
    angle=optional(TEXT),
)
SHEET = record(
    Sheet,
    mechanism=TEXT,
    title=words("title"),
    subtitle=words("subtitle", missing=""),
    language=Form(str, _read_language),
    parameters=Key(Form(_write_parameters, _read_parameters), beside=True),
    rows=many(ROW, FEWER),
    notation=optional(NOTATION, Notation()),
    names=optional(by_name(by_name(TEXT)), {}),
    output=optional(TEXT, ""),
    driver=optional(DRIVER),  # of an old file it is told from the strokes
    panels=by_attribute("name", PANEL),
)
