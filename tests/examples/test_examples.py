"""What is true of every example that ships; a new one is tested by itself."""

from __future__ import annotations

import json
import re
import tomllib
from functools import cache

import numpy as np
import pytest

import vad
from vad.files.description import LinkLine
from vad.files.examination import examine
from vad.files.examples import example_names, example_path
from vad.files.loading import WrittenMechanism
from vad.strokes.sheet import Arrow, Dot
from vad.written import PRIME

every = pytest.mark.parametrize("name", example_names())


@cache
def example(name: str) -> WrittenMechanism:
    """Return an example with its own numbers."""
    return vad.load(example_path(name))()


@cache
def poses(name: str) -> np.ndarray:
    """Return a few places of the driver, its own first, away from the ends of the range."""
    mechanism = example(name)
    own = next(iter(mechanism.inputs.values()))
    ranges = examine(type(mechanism)).closes
    low, high = min(ranges, key=lambda ends: abs(own - sum(ends) / 2))
    return np.array([own, *(low + (high - low) * np.array([0.08, 0.31, 0.57, 0.9]))])


@cache
def moving(name: str, later: float = 0.0) -> vad.Motions:
    """Solve an example in its poses, or so many seconds later; its driver moves evenly."""
    mechanism = example(name)
    place, rate, second = mechanism.inputs
    speed = mechanism.inputs[rate]
    way = speed * later * (180.0 / np.pi if place == "angle" else 1.0)
    return vad.solve(mechanism, **{place: poses(name) + way, rate: speed, second: 0.0})


@every
def test_its_words(name):
    text = example_path(name).read_text("utf-8")
    words = tomllib.loads(text)
    assert {"title", "about", "source"} <= set(words)
    assert "'" not in words["title"]  # it is set in large type
    assert words["about"].endswith(".")
    assert max(map(len, text.splitlines())) <= 110


@pytest.mark.exhaustive(4)
@every
def test_it_closes_and_all_is_listed(name):
    motion = moving(name)
    assert motion.assembled.all()
    data = vad.solve(example(name)).to_dict()
    words = tomllib.loads(example_path(name).read_text("utf-8"))
    assert list(data["links"]) == list(words["links"])
    letters = {
        point
        for link in words["links"].values()
        for pair in ([link] if isinstance(link, str) else link)
        if not re.fullmatch("[a-z]+", pair)
        for point in re.findall("[A-Z][0-9]*", pair)
    }
    assert set(words["fixed"]) | letters <= set(data["points"])
    json.dumps(data, allow_nan=False)


@every
def test_every_distance_that_is_written_is_kept(name):
    """Distances of the file's own pairs, read here from its text."""
    motion, words = moving(name), tomllib.loads(example_path(name).read_text("utf-8"))
    mechanism = example(name)
    for link, pairs in words["links"].items():
        for pair, length in pairs.items() if isinstance(pairs, dict) else ():
            points = re.findall("[A-Z][0-9]*", pair)
            if len(points) != 2 or length == "variable" or isinstance(length, str):
                continue
            tail, head = (motion.point(point).position for point in points)
            assert abs(head - tail) == pytest.approx(length, rel=1e-12), (link, pair)
    for point, place in words["fixed"].items():
        if isinstance(place, list) and not any(isinstance(x, str) for x in place):
            assert motion.point(point).position == pytest.approx([complex(*place)] * 5, abs=1e-9)
    assert mechanism.title == words["title"]


@every
def test_bodies_are_rigid(name):
    """No two points of a link come nearer, none turns against its link."""
    motion, description = moving(name), example(name).written.description
    for link in description.links.values():
        if link.cylinder:
            continue
        turn = np.exp(1j * np.radians(motion.link(link.name).angle))
        start = motion.point(link.base[0]).position
        for point in link.points[1:]:
            seen = (motion.point(point).position - start) / turn
            assert seen == pytest.approx(np.full(5, seen[0]), rel=1e-11, abs=1e-10)
    for guide in description.guides.values():
        if isinstance(guide.line, LinkLine):
            tail, head, here = (
                motion.point(each).position for each in (*guide.line.pair, guide.point)
            )
            aside = ((here - tail) / (head - tail)).imag * abs(head - tail)
            assert aside == pytest.approx(np.full(5, aside[0]), abs=1e-10 * abs(head - tail).max())


@pytest.mark.exhaustive(4)
@every
def test_rates_are_derivatives(name):
    """Over a moment before and after, the driver moving evenly."""
    mechanism = example(name)
    _, speed, _ = mechanism.inputs.values()
    way = 1e-4 if "angle" in mechanism.inputs else 1e-6 * np.ptp(poses(name))
    step = way / abs(speed)
    before, now, after = (moving(name, later) for later in (-step, 0.0, step))
    under = set(now.points) - set(mechanism.written.description.points)
    for point in set(now.points) - under:
        one, two, three = (each.point(point) for each in (before, now, after))
        for lower, higher in (("position", "velocity"), ("velocity", "acceleration")):
            rate = (getattr(three, lower) - getattr(one, lower)) / (2 * step)
            wanted = getattr(two, higher)
            assert rate == pytest.approx(wanted, rel=1e-4, abs=1e-5 * (abs(wanted).max() + 1e-3))
    for link in now.links:
        one, two, three = (each.link(link) for each in (before, now, after))
        turned = np.radians((three.angle - one.angle + 180.0) % 360.0 - 180.0)
        assert turned / (2 * step) == pytest.approx(two.omega, rel=1e-4, abs=1e-4)
        assert (three.omega - one.omega) / (2 * step) == pytest.approx(
            two.alpha, rel=1e-4, abs=1e-4 * (abs(two.alpha).max() + 1e-3)
        )
    for slide in now.slides:
        one, two, three = (each.slide(slide) for each in (before, now, after))
        for lower, higher in (("position", "velocity"), ("velocity", "acceleration")):
            rate = (getattr(three, lower) - getattr(one, lower)) / (2 * step)
            wanted = getattr(two, higher)
            assert rate == pytest.approx(wanted, rel=1e-4, abs=1e-4 * (abs(wanted).max() + 1e-3))


@every
def test_its_polygons_close(name):
    """Every vertex is drawn where the motion of its point ends, and the equations add up."""
    motion = vad.solve(example(name))
    sheet = vad.draw(motion, panels=("velocity", "acceleration"))
    for panel in sheet.panels:
        vertices = {
            point.lower() + PRIME * (panel.name == "acceleration"): point for point in motion.points
        }
        arrows = {s.name: s.shape for s in panel.strokes if isinstance(s.shape, Arrow)}
        size = max(abs(arrow.end - arrow.start) for arrow in arrows.values())
        drawn = [
            (end, at) for a in arrows.values() for end, at in ((a.tail, a.start), (a.head, a.end))
        ]
        drawn += [
            (letter, stroke.shape.at)
            for stroke in panel.strokes
            if isinstance(stroke.shape, Dot)
            for letter in stroke.label.split(",")
        ]
        for letter, at in drawn:
            if letter in vertices:
                wanted = getattr(motion.point(vertices[letter]), panel.name)
                assert abs(at - wanted) <= 1e-10 * size, (panel.name, letter)
        assert {vertices[letter] for letter, _ in drawn if letter in vertices} >= moving_points(
            name
        )
        for equation in panel.equations:
            sums = [
                sum(
                    arrows[term.stroke].end - arrows[term.stroke].start
                    for term in side
                    if term.stroke
                )
                for side in (equation.left, equation.right)
            ]
            assert abs(sums[0] - sums[1]) <= 1e-10 * size


def moving_points(name: str) -> set[str]:
    """Return the points of an example's links that are not fixed."""
    description = example(name).written.description
    return {point for link in description.links.values() for point in link.points} - set(
        description.fixed
    )
