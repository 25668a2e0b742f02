"""The board that is laid out once with traced numbers is the board of every other pose, too."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import vad
from tests.kinds import SPACE
from vad.errors import VadError
from vad.kinematics.reach import closing_range
from vad.kinematics.traced import Traced, plain
from vad.mechanisms import Mechanism
from vad.plan.format import screen
from vad.plan.hand_board import HandBoard, hand_board
from vad.plan.labels.named import NamedLabels
from vad.plan.marks import Lettering, Polyline
from vad.plan.pictures.polygon import Polygon
from vad.plan.scale import Scale
from vad.plan.sketch import Sketch
from vad.statics.burden import burden_of
from vad.strokes.draw import chosen
from vad.words import languages

EXAMPLES = {
    path.stem: vad.load(str(path))
    for path in (Path(vad.__file__).parent / "examples").glob("*.toml")
}
KINDS: dict[str, Any] = {**vad.MECHANISMS, **dict(sorted(EXAMPLES.items()))}
#: Poses of each mechanism: in a usual run, and with all cases.
FEW, POSES = 20, 200
#: Pixels of a page 720 high.
CLOSE = 0.05
#: Degrees.
EMPTY = 1e-4
#: These take a free place beside what moves, which is another one in another pose.
CHOSEN = ("speed", "tag")


def board_of(name: str, language: str = "en", lines: int = 1) -> HandBoard:
    mechanism: Mechanism = KINDS[name]()
    panels = chosen(None, vad.solve(mechanism))
    return hand_board(mechanism, panels, language, screen((1280, 720)), lines)


def coordinates(sketches: dict[str, Sketch]) -> dict[tuple[Any, ...], float]:
    """Return every coordinate of every mark, by stroke, level, role, and the mark's number."""
    found: dict[tuple[Any, ...], float] = {}
    count: dict[tuple[Any, ...], int] = {}
    for panel, sketch in sketches.items():
        for item in sketch.items:
            arrow = any(mark.role in CHOSEN for mark in item.marks)
            for mark in () if arrow else item.marks:
                key = panel, item.stroke, item.level.name, mark.role
                count[key] = count.get(key, -1) + 1
                found.update(numbers(mark.shape, (*key, count[key])))
    return found


def numbers(value: Any, name: tuple[Any, ...]) -> Iterator[tuple[tuple[Any, ...], float]]:
    if isinstance(value, complex):
        yield (*name, "x"), value.real
        yield (*name, "y"), value.imag
    elif isinstance(value, float):
        yield name, value
    elif isinstance(value, tuple):
        for number, each in enumerate(value):
            yield from numbers(each, (*name, number))
    elif is_dataclass(value):
        for each in fields(value):
            yield from numbers(getattr(value, each.name), (*name, each.name))


def seen(found: dict[tuple[Any, ...], float]) -> dict[tuple[Any, ...], float]:
    """Return the coordinates without stretches of curves that have no length in this pose.

    The marks after such a stretch have one number less.
    """
    empty = {key[:5] for key, value in found.items() if key[-1] == "sweep" and abs(value) < EMPTY}
    return {
        (*key[:4], key[4] - sum((*key[:4], n) in empty for n in range(key[4])), *key[5:]): value
        for key, value in found.items()
        if key[:5] not in empty
    }


def posed(board: HandBoard, inputs: dict[str, float]) -> dict[str, Sketch]:
    """Return the sketches of a pose that is drawn with ordinary numbers."""
    panels = [panel.name for panel in board.traced.sheet.panels]
    sheet = vad.draw(vad.solve(board.mechanism, **inputs), panels)
    sketches: dict[str, Sketch] = {}
    for half in sheet.halves:
        setting = board.live.setting(sheet, half)
        traced = board.scales[half.name]
        scale = Scale(plain(traced.origin), plain(traced.factor))
        labels, picture = NamedLabels(half.name), board.live.pictures.get(half.name)
        if picture:
            sketches[half.name] = picture.under_hand(setting, labels)
        else:
            polygon, shared = Polygon(setting, scale), board.shared[half.name]
            sketches[half.name] = polygon.under_hand(setting, labels, shared)
    return sketches


@pytest.mark.exhaustive(192)
@pytest.mark.parametrize("name", KINDS)
def test_one_traced_board_is_the_board_of_every_pose(name: str, exhaustive: bool) -> None:
    tried = POSES if exhaustive else FEW
    board = board_of(name)
    found = coordinates(dict(board.sketches))
    program = board.traced.program(found.values())
    rng, (place, rate, second) = np.random.default_rng(7), tuple(board.mechanism.inputs)
    ranges = closing_range(board.mechanism)
    poses = []
    for _ in range(tried):
        low, high = ranges[rng.integers(len(ranges))]
        at = float(low + (high - low) * rng.uniform(0.01, 0.99))
        rates = [
            float(board.traced.inputs[each]) * rng.uniform(0.5, 1.0) for each in (rate, second)
        ]
        poses.append({place: at, rate: rates[0], second: rates[1]})
    given = [
        np.array([pose.get(key, float(value)) for pose in poses])
        for key, value in board.traced.inputs.items()
    ]
    columns = program.many(given, tried)[len(board.traced.guards) :]
    table = dict(zip(found, columns, strict=True))
    drawn = 0
    for number, pose in enumerate(poses):
        try:
            wanted = seen(coordinates(posed(board, pose)))
        except VadError:
            continue
        drawn += 1
        own = seen({key: float(column[number]) for key, column in table.items()})
        assert wanted.keys() <= own.keys()
        for key, value in wanted.items():
            if key[3] == "angle" and key[-1] == "radius":
                continue  # an arc is smaller where its room ends
            assert abs(own[key] - value) * 720.0 <= CLOSE, (key, pose)
    assert drawn > tried / 2


def test_scales_of_polygons_are_inputs() -> None:
    """Twice the scale moves a vertex twice as far from the pole."""
    board = board_of("four-bar")
    label = next(each for each in board.labels if (each.panel, each.name) == ("velocity", "b"))
    program = board.traced.program([label.at.real, label.at.imag])
    given = {name: float(value) for name, value in board.traced.inputs.items()}
    factor = np.array([1.0, 2.0]) * given["velocity scale"]
    given |= {"velocity x": 0.0, "velocity y": 0.0}
    columns = [factor if name == "velocity scale" else value for name, value in given.items()]
    x, y = program.many(columns, 2)
    assert isinstance(label.at.real, Traced)
    np.testing.assert_allclose([x[1], y[1]], [2.0 * x[0], 2.0 * y[0]], rtol=1e-14)


def test_each_vertex_has_its_letters_in_every_pose() -> None:
    names = {(label.panel, label.name) for label in board_of("four-bar").labels}
    assert {("position", letter) for letter in "ABCD"} < names
    assert {("acceleration", each) for each in ("b′ₙ", "b′", "cₙ", "c″ₙ", "c′", "a′, d′")} < names


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("name", SPACE)
def test_notes_have_room_beside_all_poses_and_letters_keep_off_them(
    name: str, language: str
) -> None:
    """Words in French and German are longer: then the views are smaller."""
    board = board_of(name, language, 2)
    views: Any = board.live.pictures["position"]
    taken = [box for box, _ in board.sketches["position"].obstacles.boxes]
    assert views.astray < 0.3
    for note in views.poses[0].notes:
        (box,) = (tag.box for tag in views.still.tags if tag.text == note.text)
        assert box in taken


def test_the_arrow_of_a_velocity_lies_on_no_link_in_any_pose() -> None:
    """Beside the block of a lift there is room in each pose, but seldom the same."""
    board = board_of("scissor-lift")
    picture: Any = next(iter(board.live.pictures.values()))
    sketch, driver = board.sketches["position"], board.traced.sheet.driver.stroke
    arrow: Any = next(m.shape for item in sketch.items for m in item.marks if m.role == "speed")
    block = plain(sketch.solved.point((driver, "at")))
    ends = [plain(z) - plain(board.scales["position"](block)) for z in arrow.pieces[0]]
    assert len(picture.posed) > 5
    for solved, drawn in picture.posed:
        at = picture.scale(solved.point((driver, "at")))
        line = [at + plain(ends[0] + share * (ends[-1] - ends[0])) for share in (0.0, 0.5, 1.0)]
        assert drawn.free([complex(z) for z in line], 0.0, 0.0, 0.005).all()


@pytest.mark.parametrize("name", ["gate-actuator", "tipper", "double-slider", "excavator-bucket"])
def test_the_letter_of_a_velocity_stands_beside_its_arrow_in_every_pose(name: str) -> None:
    """An actuator that stands upright has it at its side, one that lies has it above."""
    board = board_of(name)
    (item,) = (
        item
        for item in board.sketches["position"].items
        if any(mark.role == "speed" for mark in item.marks)
    )
    arrow: Any = next(mark.shape for mark in item.marks if mark.role == "speed")
    text: Any = next(mark.shape for mark in item.marks if isinstance(mark.shape, Lettering))
    ends = [arrow.pieces[0][0], arrow.pieces[0][-1], text.at]
    program = board.traced.program([part for z in ends for part in (z.real, z.imag)])
    low, high = closing_range(board.mechanism)[0]
    places = np.linspace(low, high, 102)[1:-1]
    given = [
        places if number == 0 else np.full(places.size, float(value))
        for number, value in enumerate(board.traced.inputs.values())
    ]
    columns = program.many(given, places.size)[len(board.traced.guards) :]
    start, end, at = (columns[n] + 1j * columns[n + 1] for n in (0, 2, 4))
    assert (np.abs(at - (start + end) / 2) * 720.0 < 40.0).all()


def test_the_driven_link_alone_fills_its_panel() -> None:
    """Its scale is that of its own poses, not of the whole mechanism."""
    burden = burden_of(["800 N @ 180 at C"])
    board = hand_board(
        vad.SliderCrank(), ["position", "force", "drive"], "en", screen((1280, 720)), 1, burden
    )
    position, drive = (board.live.pictures[name].scale for name in ("position", "drive"))
    assert plain(drive.factor) > 1.5 * plain(position.factor)
    room = board.live.page.panels["drive"].drawing
    arrows = [
        mark.shape
        for item in board.sketches["drive"].items
        for mark in item.marks
        if mark.role == "vector" and isinstance(mark.shape, Polyline)
    ]
    ends = [complex(plain(z)) for shape in arrows for piece in shape.pieces for z in piece]
    assert len(ends) > 3
    assert all(room.holds(end) for end in ends)
