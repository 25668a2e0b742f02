"""Points marked on links: they move as points of a rigid body, and are told wherever points are."""

from __future__ import annotations

import cmath
import dataclasses
import json
import math
import pickle
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest

import vad
from tests.kinds import PLANE, SPACE
from tests.limits import within
from vad.cli.run import run
from vad.kinematics.linkage import points_of
from vad.plan.labels.obstacles import Obstacles
from vad.strokes.draw import MOST_POINTS
from vad.strokes.sheet import Arrow, Dot

RAMS = {
    "crank-slotted-lever": {"rod": 100.0, "ram_height": 180.0},
    "whitworth": {"rod": 300.0},
}


def on_every_link() -> Iterator[tuple[str, str, float, float]]:
    """Yield every link of every mechanism, with a place in line and one beside it."""
    for name, kind in PLANE.items():
        for link in kind.links:
            yield name, link, 30.0, 0.0
            yield name, link, 45.0, -70.0
            yield name, link, -20.0, 0.0


def with_point(name: str, **points: Any) -> vad.Motion:
    return vad.solve(vad.MECHANISMS[name](points=points, **RAMS.get(name, {})))


@pytest.mark.parametrize(("name", "link", "distance", "angle"), list(on_every_link()))
def test_it_moves_as_a_point_of_a_rigid_body(name: str, link: str, distance: float, angle: float):
    motion = with_point(name, T=(link, distance, angle))
    first, body, point = motion.mechanism.links[link][0], motion.link(link), motion.point("T")
    arm = cmath.rect(distance, math.radians(body.angle + angle))
    size = abs(arm) * (abs(body.omega) + 1.0) ** 2 + abs(motion.point(first).position)
    spin = 1j * body.omega
    for found, start, more in (
        (point.position, motion.point(first).position, arm),
        (point.velocity, motion.point(first).velocity, spin * arm),
        (point.acceleration, motion.point(first).acceleration, (1j * body.alpha + spin**2) * arm),
    ):
        assert abs(found - start - more) <= 1e-12 * (size + abs(more) + abs(start))


@pytest.mark.parametrize("name", PLANE)
def test_all_else_stays_as_it_was(name: str):
    link = next(iter(vad.MECHANISMS[name].links))
    marked, plain = with_point(name, T=(link, 1e3, 20.0)).to_dict(), with_point(name).to_dict()
    assert list(marked["points"]) == [*plain["points"], "T"]
    del marked["points"]["T"]
    assert marked == plain


@pytest.mark.parametrize("name", SPACE)
def test_space_has_none(name: str):
    with pytest.raises(vad.InputError, match="point T: points are marked on links in the plane"):
        with_point(name, T=(next(iter(SPACE[name].links)), 30.0))


def test_a_letter_that_is_not_reported_makes_way():
    """The guide's own point of a slider-crank is called D, until somebody wants a D on the rod."""
    motion = with_point("slider-crank", D=("rod", 100, 0))
    strokes = vad.draw(motion).panel("velocity").strokes
    assert strokes[0].label == "a,e"
    at = {each.name: each.shape for each in strokes}["D.image"]
    assert isinstance(at, Arrow)
    assert at.end == pytest.approx(motion.point("D").velocity, rel=1e-12)


@pytest.mark.parametrize("panel", ["position", "velocity", "acceleration"])
@pytest.mark.parametrize("angle", [0.0, 35.0])
def test_it_is_drawn_in_every_panel(panel: str, angle: float):
    motion = with_point("four-bar", P=("coupler", 60, angle))
    point, letter = motion.point("P"), {"position": "P", "velocity": "p"}.get(panel, "p′")
    place = {"position": point.position, "velocity": point.velocity}.get(panel, point.acceleration)
    strokes = vad.draw(motion, panels=panel).panels[0].strokes
    heads = [s.shape.end for s in strokes if isinstance(s.shape, Arrow) and s.shape.head == letter]
    heads += [s.shape.at for s in strokes if isinstance(s.shape, Dot) and s.label == letter]
    assert heads
    for head in heads:
        assert head == pytest.approx(place, rel=1e-12)


def test_points_survive_replacing_pickling_and_hashing():
    one = vad.FourBar(points={"P": ("coupler", 60), "O2": ("rocker", 10, 90)})
    assert pickle.loads(pickle.dumps(one)) == one
    assert hash(dataclasses.replace(one, crank=30.0)) != hash(one)
    assert one.points["P"] == ("coupler", 60.0, 0.0)
    assert vad.solve(one).points[-2:] == ("P", "O2")
    assert points_of("O2P") == ("O2", "P")


@pytest.mark.parametrize(
    ("points", "said", "hint"),
    [
        ({"B": ("coupler", 1)}, "point B: the mechanism has a point B already", "free are E"),
        ({"P": ("couple", 1)}, "point P: unknown link 'couple'", "did you mean 'coupler'?"),
        ({"P": ("coupler", "1")}, "point P: its distance: must be a number, got '1'", None),
        ({"P": ("coupler", 1, math.nan)}, "point P: its angle: must be a finite number", None),
        ({"P": ("coupler", 0)}, "point P: its distance must not be 0", "the first end"),
        ({"P": "coupler"}, "point P: must be a link and a distance, got 'coupler'", "as in"),
        ({"D٣": ("coupler", 1)}, "points: a name must be a capital letter", "as in D"),
        ({"P": ("coupler", 10**400)}, "point P: its distance: must be a finite number", None),
        ({"P": ("coupler", 1e201)}, "point P: its distance: must be between 1e-200 and", None),
        ({"P": ("coupler", True)}, "point P: its distance: must be a number, got True", None),
        ({"p": ("coupler", 1)}, "points: a name must be a capital letter", "as in D"),
        (["P"], "points: must be places by name, got ['P']", "as in"),
    ],
)
def test_what_cannot_be_is_said_in_one_line(points: Any, said: str, hint: str | None):
    with pytest.raises(vad.InputError) as caught:
        vad.FourBar(points=points)
    assert said in str(caught.value)
    assert hint is None or (caught.value.hint and hint in caught.value.hint)


@pytest.mark.parametrize(
    ("words", "distance", "angle"),
    [
        ("D on rod 100", 100.0, 0.0),
        ("D on rod 100 30", 100.0, 30.0),
        ("D on rod -100 at -0.5 rad", -100.0, -math.degrees(0.5)),
        (" D  on  rod 10 cm at 30 deg ", 100.0, 30.0),
    ],
)
def test_a_point_of_the_command_line(words: str, distance: float, angle: float, capsys: Any):
    assert run(["solve", "slider-crank", "--point", words, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["points"]["D"]
    wanted = with_point("slider-crank", D=("rod", distance, angle)).to_dict()["points"]["D"]
    for quantity, pair in wanted.items():
        assert found[quantity] == pytest.approx(pair, rel=1e-12)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["D"], "--point: 'D' is no point of a link"),
        (["D on rod x"], "--point: 'x' is not a number"),
        (["D on rod 1", "D on crank 2"], "--point: point D: is given twice"),
        (["C on rod 1"], "point C: the mechanism has a point C already"),
    ],
)
def test_a_wrong_point_of_the_command_line(words: list[str], said: str, capsys: Any):
    given = [part for word in words for part in ("--point", word)]
    assert run(["solve", "slider-crank", *given]) in (1, 2)
    assert capsys.readouterr().err.startswith(f"error: {said}")


def test_a_sweep_lists_it(tmp_path: Path):
    path = tmp_path / "sweep.csv"
    words = ["--point", "D on rod 100", "--steps", "3", "-o", str(path)]
    assert run(["sweep", "slider-crank", *words]) == 0
    heads, first, *_ = (line.split(",") for line in path.read_text().splitlines())
    found = dict(zip(heads, first, strict=True))
    point = vad.solve(vad.SliderCrank(points={"D": ("rod", 100)}), angle=0.0).point("D")
    assert float(found["D position x [mm]"]) == point.position.real
    assert float(found["D acceleration y [mm/s^2]"]) == point.acceleration.imag


def on_coupler(at: int) -> tuple[str, float, float]:
    """Return the place of the point with this number."""
    return "coupler", 10.0 + at, 7.0 * at


def many(count: int) -> vad.FourBar:
    """Return a four-bar with so many points on its coupler."""
    names = [f"{letter}{number}" for letter in "EFGHPQ" for number in range(1000)]
    places = {name: on_coupler(at) for at, name in enumerate(names[:count])}
    return vad.FourBar(points=places)


def test_thousands_of_points_are_solved_in_seconds():
    with within(10.0):
        motion = vad.solve(many(3000))
        assert len(motion.table()) > 3000
    one = with_point("four-bar", T=on_coupler(2999)).point("T").position
    assert motion.point("G999").position == one


@pytest.mark.exhaustive(1000)
@pytest.mark.parametrize(("count", "most"), [(30, 100), (MOST_POINTS, 750)])
def test_many_points_take_as_much_work_as_so_many_usual_drawings_at_most(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, count: int, most: float
):
    """Nearly all of it compares places of letters with strokes: 76 and 588 times as many."""
    usual = compared(monkeypatch, vad.Whitworth(rod=300.0), tmp_path / "usual.svg")
    assert compared(monkeypatch, many(count), tmp_path / "many.svg") <= most * usual


def compared(monkeypatch: pytest.MonkeyPatch, mechanism: vad.Mechanism, path: Path) -> int:
    """Return how many pairs of a place and a stroke or box are compared for a drawing."""
    pairs = 0
    free = Obstacles.free

    def counted(obstacles: Obstacles, centres: Sequence[complex], *size: Any) -> Any:
        nonlocal pairs
        pairs += len(centres) * (len(obstacles.lines) + len(obstacles.boxes))
        return free(obstacles, centres, *size)

    with monkeypatch.context() as patch:
        patch.setattr(Obstacles, "free", counted)
        vad.save(vad.draw(vad.solve(mechanism)), path)
    return pairs


@pytest.mark.parametrize(
    "drawn",
    [
        lambda kind: vad.draw(vad.solve(kind)),
        lambda kind: vad.save(vad.turn(kind), "turn.svg"),
        lambda kind: vad.multiples(kind, [10, 20]),
        lambda kind: vad.animate(vad.draw(vad.solve(kind))),
    ],
)
def test_more_points_than_a_drawing_takes_are_refused_by_name(drawn: Any):
    message = "^points: a drawing has room for 60 on links, got 61$"
    with pytest.raises(vad.InputError, match=message):
        drawn(many(61))


def test_a_window_refuses_points_when_it_opens(capsys: pytest.CaptureFixture[str]):
    words = [f"--point=E{number} on coupler {number + 1}" for number in range(41)]
    with within(10.0):
        assert run(["gui", "four-bar", *words, "--no-browser"]) == 2
    assert capsys.readouterr().err == "error: points: a window takes at most 40, got 41\n"
    with pytest.raises(vad.UsageError, match="a window takes at most 40, got 41"):
        vad.widget(many(41))
