"""The strokes and the bodies of a position diagram: bars, blocks, plates and slots."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from vad.kinematics.linkage import Bar, Slide, angle_of, points_of, scalar_of
from vad.strokes.arithmetic import Figure
from vad.strokes.scene import Scene
from vad.strokes.sentences import Noun, SentencePart, Unit
from vad.strokes.sheet import (
    Arrow,
    Block,
    Body,
    Coincidence,
    Guide,
    Plate,
    Ride,
    Shape,
    Stroke,
    StrokePart,
)


class PositionPencil:
    """The strokes of a pose so far, in the order in which they are drawn, and its bodies."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.strokes: list[Stroke] = []
        #: The points of every body, and below the blocks that slide on it, by the row of the body.
        self._points: dict[str | None, list[str]] = {None: []}
        self._rides: dict[str | None, list[Ride]] = {}
        self._under: list[Coincidence] = []

    @property
    def bodies(self) -> tuple[Body, ...]:
        """The bodies that are drawn, the frame first."""
        return tuple(
            Body(row, tuple(dict.fromkeys(points)), tuple(self._rides.get(row, ())))
            for row, points in self._points.items()
        )

    @property
    def coincident(self) -> tuple[Coincidence, ...]:
        """The points of links that lie under the pins of blocks."""
        return tuple(self._under)

    def join(self, row: str | None, *letters: str) -> None:
        """Give points to a body."""
        self._points.setdefault(row, []).extend(letters)

    def draw(
        self,
        of: str,
        which: str,
        kind: str,
        label: str,
        shape: Shape,
        phrase: str,
        parts: Mapping[str, SentencePart],
        **more: object,
    ) -> None:
        """Add a stroke with the sentence that a phrase makes of its parts."""
        said, part = self.scene.say(phrase, **parts), StrokePart(of, which)
        stroke = Stroke(kind, label, shape, said, part=part, **more)  # type: ignore[arg-type]
        self.strokes.append(stroke)

    def bar(self, bar: Bar, kind: str, phrase: str, image: bool = False) -> None:
        """Draw a bar of a link; the caption names the link itself if the bar points another way."""
        letters, (tail, head) = self.scene.members.letters(bar), self.scene.members.ends(bar)
        arrow = Arrow(
            self.scene.at(tail), self.scene.at(head), tail, head, self.scene.cylinder(bar)
        )
        driven = angle_of(bar.link) == self.scene.driver
        reveals = () if driven or image else (bar.link,)
        self.join(bar.link, tail, head)
        self.draw(
            bar.ends,
            "bar",
            kind,
            letters,
            arrow,
            phrase,
            self._parts_about(bar),
            link=bar.link,
            component="link",
            image=image,
            reveals=reveals,
        )

    def _parts_about(self, bar: Bar) -> Mapping[str, SentencePart]:
        """Return the parts that a phrase about a bar needs."""
        scene, (tail, head) = self.scene, self.scene.members.ends(bar)
        driven = angle_of(bar.link) == scene.driver
        whole = bar.turn != 1.0 or scene.backward(bar)
        return {
            "link": Noun(bar.link),
            "bar": scene.motion.mechanism.links[bar.link] if whole else scene.members.letters(bar),
            "size": scene.length(bar),
            "unit": Unit(scene.unit),
            "angle": Figure(scene.motion.link(bar.link).angle, "°", driven),
            "symbol": scene.members.symbol("θ", bar.link),
            "letter": head,
            "tail": tail,
            "end": points_of(scene.motion.mechanism.links[bar.link])[1],
        }

    def plate(self, link: str) -> None:
        """Draw a link of three points or more as a plate whose corners are points of the link."""
        points = self.scene.members.points_on(link)
        places = dict(zip(points, map(self.scene.at, points), strict=True))
        letters = hull(places)
        shape = Plate(tuple(places[letter] for letter in letters), letters)
        label = "".join(letters)
        parts: dict[str, SentencePart] = {"link": Noun(link), "corners": label}
        self.join(link, *letters)
        self.draw(label, "plate", "result", label, shape, "plate", parts, link=link)

    def slot(self, slide: Slide) -> None:
        """Draw the slot of a moving link, in which a block slides."""
        owner = self.owner(slide)
        line = self.scene.heading(self.scene.members.frame.line(slide, self.scene.pose))
        moving = isinstance(slide.along, str)
        guide = Guide(self.scene.at(slide.head if moving else slide.tail), line)
        parts: dict[str, SentencePart] = {"head": slide.head, "link": Noun(owner)}
        self.draw(slide.ends, "slot", "guide", "", guide, "slot", parts, link=owner)

    def carrier(self, slide: Slide) -> Bar:
        """Return the bar of a turning link that reaches to the point under a block."""
        bars = (step for step in self.scene.members.frame.steps if isinstance(step, Bar))
        return next(bar for bar in bars if (bar.link, bar.length) == (slide.along, slide.name))

    def has_slot(self, slide: Slide) -> bool:
        """Tell whether a block has a slot of its own: in a yoke, or beside the line of its link."""
        return isinstance(slide.along, float) or self.carrier(slide).offset.imag != 0.0

    def owner(self, slide: Slide) -> str:
        """Return the link or slide that has the slot in which a block slides."""
        if isinstance(slide.along, str):
            return slide.along
        return next(other for other in self.scene.members.sliding if other.head == slide.tail).name

    def block(self, slide: Slide, kind: str, phrase: str) -> None:
        """Draw a sliding block."""
        letter = slide.head
        line = self.scene.heading(self.scene.members.frame.line(slide, self.scene.pose))
        on = slide.along if isinstance(slide.along, str) else None
        driven = scalar_of(slide) == self.scene.driver
        symbol = self.scene.members.slide_symbol(slide.name)
        start, beside = self._measured_from(slide)
        parts: dict[str, SentencePart] = {
            "slide": self.scene.members.slider(slide),
            "head": letter,
            "symbol": symbol,
            "value": Figure(self.scene.motion.slide(slide.name).position, self.scene.unit, driven),
            "unit": Unit(self.scene.unit),
            "tail": start,
        }
        owner = self.scene.motion.mechanism.links.get(on or "", "")
        if symbol == "s":
            phrase += " beside" if beside and not driven else " from"
            if (
                phrase == "block from"
                and owner
                and self.scene.motion.slide(slide.name).position < 0
            ):
                phrase, parts["end"] = "block towards", points_of(owner)[1]
        self.join(slide.name, letter)
        self._record_ride(slide)
        self.draw(
            slide.ends,
            "block",
            kind,
            letter,
            Block(self.scene.at(letter), line, on, self.scene.travel(slide.name)),
            phrase,
            parts,
            link=slide.name,
            component="link",
            reveals=() if driven else (slide.name,),
        )

    def _record_ride(self, slide: Slide) -> None:
        """Record on which body a block slides, and along which stroke."""
        on, block = (slide.along if isinstance(slide.along, str) else None), f"{slide.ends}.block"
        if self.scene.members.is_guide(slide):
            ride = Ride(block, f"{slide.ends}.guide")
        elif self.has_slot(slide):
            on, ride = self.owner(slide), Ride(block, f"{slide.ends}.slot", slot=True)
        else:
            bar = f"{self.carrier(slide).ends}.bar"
            ride = Ride(block, bar if any(s.name == bar for s in self.strokes) else None)
        self._rides.setdefault(on, []).append(ride)
        if isinstance(slide.along, str) and slide.tail in self.scene.members.points:
            self._under.append(Coincidence((slide.head, slide.tail), "under"))

    def _measured_from(self, slide: Slide) -> tuple[str, bool]:
        """Return the point from which a slide's position counts, and whether its line passes it.

        That is a lever's pivot, or a line's tail.  A slot may pass a pivot at a distance.
        """
        bars = (step for step in self.scene.members.frame.steps if isinstance(step, Bar))
        levers = ((bar.tail, bool(bar.offset.imag)) for bar in bars if bar.length == slide.name)
        return next(levers, (slide.tail, False))


def hull(places: Mapping[str, complex]) -> tuple[str, ...]:
    """Return the corners of the convex hull of points, counter-clockwise from the first of them.

    A point within the hull or on its edge is no corner, and of points in one place the first is.
    The points are sorted once, and each is added to a side and taken from it at most once.  So
    there is an end whatever rounding does to points that nearly coincide.

    Examples
    --------
    >>> hull({"A": 0j, "B": 4 + 0j, "M": 1 + 1j, "C": 3j})
    ('A', 'B', 'C')
    """
    named = {place: letter for letter, place in list(places.items())[::-1]}
    rightward = sorted(named, key=lambda place: (place.real, place.imag))
    lower, upper = _side(rightward), _side(rightward[::-1])
    corners = [named[place] for place in (*lower[:-1], *upper[:-1])] or [named[lower[0]]]
    first = min(map(list(places).index, corners))
    start = corners.index(list(places)[first])
    return tuple(corners[start:] + corners[:start])


def _side(points: Sequence[complex]) -> list[complex]:
    """Return the corners of the side of a hull on the right hand, of points that are sorted."""
    side: list[complex] = []
    for point in points:
        # Each round takes a point away that was added once.
        while len(side) > 1 and not _turns_left(side[-2], side[-1], point):
            side.pop()
        side.append(point)
    return side


def _turns_left(start: complex, corner: complex, end: complex) -> bool:
    """Tell whether a way turns to the left at a corner, by more than rounding makes of none."""
    way, onward = corner - start, end - corner
    return (way.conjugate() / abs(way) * (onward / abs(onward))).imag > 1e-12
