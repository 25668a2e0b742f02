"""``vad check FILE``: what a file describes, as text or JSON."""

from __future__ import annotations

import json
import sys
from typing import TYPE_CHECKING, Any

import click

import vad
from vad.cli import completion
from vad.cli.groups import HelpfulCommand
from vad.errors import UsageError
from vad.files.places import PARALLEL

if TYPE_CHECKING:
    from vad.files.examination import Choice, Examination, FoundDyad
    from vad.files.loading import WrittenMechanism

# A smaller sine is taken for that of a dead centre: a grid of poses rarely meets one exactly.
_DEAD = 5e-4


@click.command("check", cls=HelpfulCommand)
@click.argument("file", required=False, shell_complete=completion.a_file)
@click.option("--json", "as_json", is_flag=True, help="as JSON, with all digits")
def command(file: str | None, as_json: bool) -> None:
    """Look at a mechanism's file: its joints, its dyads, and the range that closes.

    If FILE is -, the text is read from standard input.
    """
    if file is None:
        hint = "vad check press.toml; vad example prints some to begin with"
        raise UsageError("check needs a mechanism's file", hint)
    from vad.files.examination import examine
    from vad.files.examples import EXTENSION, all_names
    from vad.files.loading import load

    if file in all_names():
        hint = f"vad example {file} > {file}{EXTENSION}"
        raise UsageError(f"'{file}' is an example, and no file yet", hint)
    kind = _from_standard_input() if file == "-" else load(file)
    if kind.is_rotor:  # it closes in every pose, and what is balanced is all that there is to say
        mechanism = kind()
        found = mechanism.balancing(vad.solve(mechanism))
        data = {"mechanism": mechanism.name, "title": mechanism.title, found.kind: found.to_dict()}
        text = f"{mechanism.title}\n\n{found.table()}"
        click.echo(json.dumps(data, ensure_ascii=False) if as_json else text)
        return
    examined = examine(kind)
    figures = vad.merit(examined.mechanism)
    if as_json:
        data = _data(examined) | {"merit": figures.to_dict()}
        click.echo(json.dumps(data, ensure_ascii=False))
    else:
        click.echo(f"{_text(examined)}\n\n{figures.table()}")


def _from_standard_input() -> type[WrittenMechanism]:
    """Return the mechanism that standard input describes."""
    from vad.files.loading import load_text
    from vad.files.tables import LONGEST

    data = b"" if sys.stdin is None else sys.stdin.buffer.read(LONGEST + 1)
    return load_text(data, "standard input")


def _text(examined: Examination) -> str:
    from vad.kinematics.results import place_unit

    unit = place_unit(examined.mechanism)
    written = examined.mechanism.written
    mobility, driver = written.mobility, written.description.driver
    head = (
        f"{written.source.name}: {mobility.bodies} bodies, {mobility.joints} joints, "
        f"{mobility.freedoms} degree of freedom; the {driver.name} drives"
    )
    rows = [
        [str(number), each.dyad.kind, each.what, each.loop, _places(each)]
        for number, each in enumerate(examined.found, start=1)
    ]
    widths = [max((len(row[i]) for row in rows), default=0) for i in range(5)]
    lines = [
        " " + "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in rows
    ]
    return "\n".join([head, *lines, _range(examined, unit), *_changes(examined, unit)])


def _places(found: FoundDyad) -> str:
    return "; ".join(map(_choice, found.choices)) or "one place"


def _choice(choice: Choice) -> str:
    if choice.word == PARALLEL:
        return f"{choice.point} parallel"
    return f"{choice.point} {choice.word} {_at(choice.place)}, not {_at(choice.other)}"


def _at(place: complex) -> str:
    return f"({place.real + 0.0:.4g}, {place.imag + 0.0:.4g})"


def _changes(examined: Examination, unit: str) -> list[str]:
    """Return a line for each change point of the mechanism."""
    return [f"dyad {change.loop + 1}: {change.words(unit)}" for change in examined.changes]


def _range(examined: Examination, unit: str) -> str:
    """Return a line with the ranges that close and the pose that is nearest to a dead centre."""
    turns = unit == "°"
    name = next(iter(examined.mechanism.inputs))
    if turns and examined.closes == ((0.0, 360.0),):
        said = "closes for every angle"
    else:
        ends = " and ".join(f"{low:.6g}{unit} … {high:.6g}{unit}" for low, high in examined.closes)
        said = f"closes for {name} {ends}"
    near = examined.nearest
    if near is None:
        return said
    where = f"{near.place:.1f}°" if turns else f"{near.place:.4g}{unit}"
    if near.sine < _DEAD:
        return f"{said}; a dead centre at {where} (dyad {near.dyad})"
    return f"{said}; nearest to a dead centre at {where} (dyad {near.dyad}, sine {near.sine:.3f})"


def _data(examined: Examination) -> dict[str, Any]:
    written, near = examined.mechanism.written, examined.nearest
    return {
        "mechanism": examined.mechanism.name,
        "title": examined.mechanism.title,
        "bodies": written.mobility.bodies,
        "joints": written.mobility.joints,
        "freedoms": written.mobility.freedoms,
        "driver": written.description.driver.name,
        "dyads": [
            {
                "kind": each.dyad.kind,
                "links": [link.name for link in each.dyad.links],
                "slides": [guide.slide for guide in each.dyad.guides],
                "loop": each.loop,
                "places": {
                    choice.point: {
                        "word": choice.word,
                        "position": [choice.place.real, choice.place.imag],
                        "other": [choice.other.real, choice.other.imag],
                    }
                    for choice in each.choices
                },
            }
            for each in examined.found
        ],
        "closes": [list(ends) for ends in examined.closes],
        "dead_centre": None
        if near is None
        else {"at": near.place, "dyad": near.dyad, "sine": near.sine},
        "change_points": [
            {"at": change.place, "dyad": change.loop + 1, "parallel": change.parallel}
            for change in examined.changes
        ],
    }
