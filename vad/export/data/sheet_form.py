"""The form of a sheet's JSON: one table of keys, by which it is both written and read.

What a stroke has not is absent.  Keys of the public contract (kind, label, component, link, from,
to, through, direction, at, caption, unit) stand beside those that make the sheet whole.
"""

from __future__ import annotations

from functools import partial
from typing import get_args

from vad.export.data.records import (
    COUNT,
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
)
from vad.strokes.language import languages
from vad.strokes.notation import Notation
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
    Kind,
    Line,
    Note,
    Panel,
    Picture,
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

#: A unit as the JSON of ``vad solve`` spells it: mm/s^2.
UNIT = Form(
    lambda unit: unit.replace("²", "^2"),
    lambda value, place: TEXT.read(value, place).replace("^2", "²"),
)
#: The part of a stroke as its name: ``AB.bar``.
NAME = Form(lambda part: part.name, lambda value, place: StrokePart.named(TEXT.read(value, place)))
ELLIPSE = record(
    Ellipse,
    centre=POINT,
    first=POINT,
    second=POINT,
    start=optional(NUMBER, 0.0),
    sweep=optional(NUMBER, 360.0),
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
    arc=record(
        Arc, centre=POINT, radius=NUMBER, start=NUMBER, sweep=NUMBER, through=optional(POINT)
    ),
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
    fold=record(Fold, centre=POINT, axis=WAY, turn=NUMBER, arms=many(POINT), rim=ELLIPSE),
    bearing=record(Bearing, at=POINT, direction=WAY),
)
STROKE = record(
    Stroke,
    kind=one_of(get_args(Kind)),
    label=TEXT,
    component=optional(one_of(get_args(Component))),
    link=optional(TEXT),
    shape=Key(SHAPE, beside=True),
    caption=TEXT,
    part=Key(NAME, "name"),
    image=optional(FLAG, False),
    reveals=optional(many(TEXT), ()),
)
TERM = record(Term, label=TEXT, link=optional(TEXT), stroke=optional(TEXT))
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
    title=TEXT,
    range=TEXT,
    stroke=TEXT,
)
INSET = variants("inset", "coriolis", coriolis=CORIOLIS, polar=POLAR)
TRIANGLE = record(ImageTriangle, link=TEXT, points=many(TEXT), corners=many(POINT), stroke=TEXT)
RIDE = record(Ride, block=TEXT, along=optional(TEXT), slot=optional(FLAG, False))
BODY = record(
    Body, row=optional(TEXT), points=optional(many(TEXT), ()), carries=optional(many(RIDE), ())
)
COINCIDENCE = record(Coincidence, letters=many(TEXT), reason=one_of(get_args(Reason)))
_DRAWN: dict[str, Form | Key] = {
    "unit": UNIT,
    "title": TEXT,
    "picture": one_of(get_args(Picture)),
    "strokes": many(STROKE),
    "zeros": optional(many(STROKE), ()),
    "equations": optional(many(EQUATION), ()),
    "inset": optional(INSET),
    "triangles": optional(many(TRIANGLE), ()),
    "loops": optional(many(INDEX), ()),
    "notes": optional(many(record(Note, at=POINT, text=TEXT)), ()),
    "remark": optional(TEXT, ""),
    "bodies": optional(many(BODY), ()),
    "coincident": optional(many(COINCIDENCE), ()),
}
LOWER = record(Panel, name=TEXT, **_DRAWN)
PANEL = record(
    partial(Panel, ""),  # whose name is its key
    **_DRAWN,
    below=optional(LOWER),
)
CELL = record(Cell, symbol=TEXT, value=NUMBER, unit=UNIT, given=optional(FLAG, False))
ROW = record(Row, key=TEXT, title=TEXT, letters=TEXT, cells=by_name(many(CELL)))
NOTATION = record(
    Notation,
    point=one_of((".", ",")),
    metres=optional(FLAG, False),
    digits=optional(by_name(COUNT), {}),
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
    title=TEXT,
    language=one_of(languages()),
    parameters=many(row(TEXT, NUMBER, UNIT)),
    rows=many(ROW),
    notation=optional(NOTATION, Notation()),
    driver=optional(DRIVER),  # of an old file it is told from the strokes
    panels=by_attribute("name", PANEL),
)
