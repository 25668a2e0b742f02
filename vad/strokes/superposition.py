"""Superposition: the force polygons of each load alone, and then the sums of their forces.

F₂₃′ is due to the first load, F₂₃″ to the second one.  At the end the parts of each joint force are
laid tip to tail, and their sum is the force F₂₃ (S. S. Rattan, Theory of
Machines, static force analysis, principle of superposition).
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import Drawing
from vad.strokes.force_captions import NEWTON
from vad.strokes.forces import Polygons
from vad.strokes.sentences import Listed, Unit
from vad.strokes.sheet import Arrow, Stroke, StrokePart
from vad.strokes.vector_equations import NOTHING

if TYPE_CHECKING:
    from vad.statics.forces import JointForce
    from vad.strokes.force_names import ForceNames


def superposed_polygons(scene: Any) -> Drawing:
    """Return the polygons of each load alone, and then the sums."""
    return _Superposed(scene).draw()


class _Superposed(Polygons):
    """The polygons of all loads, and the sums of the joint forces."""

    def __init__(self, scene: Any) -> None:
        self.scene, self.all = scene, scene.force_names
        parts = [part for _, part in scene.force_parts]
        halves = [h for dyad in self.all.found_dyads for h in (dyad.first, dyad.second)]
        self.outer: list[JointForce] = [half.outer for half in halves]
        of_parts = [
            [h.outer.force for dyad in part.found_dyads for h in (dyad.first, dyad.second)]
            for part in parts
        ]
        self.shares = list(zip(*of_parts, strict=True))
        self.parts = parts
        super().__init__(scene, parts)

    def draw(self) -> Drawing:
        """Draw load after load, each with what is said of it, and then the sums."""
        drawing = super().draw()
        strokes = list(drawing.strokes)
        for names in self.parts:
            own = (n for n, each in enumerate(strokes) if each.part.of.endswith(names.alone))
            first = next(own, None)
            if first is not None:
                said = strokes[first].said
                headed = self.scene.say("superposed alone", loads=self._acting(names), said=said)
                strokes[first] = replace(strokes[first], said=headed)
        return replace(drawing, strokes=tuple(strokes))

    def _acting(self, names: ForceNames) -> Listed:
        """Return the symbols of all that acts in one part."""
        loads = [names.load(each) for each in names.loads if each.force]
        couples = [names.couple(each) for each in names.couples if each.value]
        return Listed(tuple(dict.fromkeys([*loads, *couples])), ", ")

    def further(self) -> list[dict[str, complex]]:
        """Return the vertices of the sums: a polygon for each joint force."""
        found = []
        for number, shares in enumerate(self.shares):
            at, places = 0j, {f"sum{number}:0": 0j}
            for place, share in enumerate(shares, start=1):
                at += share
                places[f"sum{number}:{place}"] = at
            found.append(places)
        return found

    def last(self) -> None:
        """Lay the parts of each joint force tip to tail, and ink their sum."""
        for number, (joint, shares) in enumerate(zip(self.outer, self.shares, strict=True)):
            plain = self.all.plain(joint.one, joint.other, joint.point)
            row = self.all.row(joint.other)
            parts = list(zip(self.parts, shares, strict=True))
            for place, (names, share) in enumerate(parts, start=1):
                symbol = names.force(joint.one, joint.other)
                said = self.scene.say(
                    "superposed part",
                    label=symbol,
                    value=Figure(abs(share), NEWTON),
                    unit=Unit(NEWTON),
                    loads=self._acting(names),
                )
                ends = f"sum{number}:{place - 1}", f"sum{number}:{place}"
                part = StrokePart(plain, f"part{place}")
                self._vector("known", symbol, ends, said, row, part, share)
            seen = [
                names.force(joint.one, joint.other) for names, share in parts if self._seen(share)
            ]
            said = self.scene.say(
                "superposed sum",
                label=self.all.force(joint.one, joint.other),
                terms=Listed(tuple(seen), " + "),
                value=Figure(abs(joint.force), NEWTON),
                unit=Unit(NEWTON),
                one=self.all.noun(joint.one),
                other=self.all.noun(joint.other),
            )
            ends, part = (f"sum{number}:0", f"sum{number}:{len(parts)}"), StrokePart(plain, "sum")
            symbol = self.all.force(joint.one, joint.other)
            self._vector("result", symbol, ends, said, row, part, joint.force)

    def _seen(self, force: complex) -> bool:
        return abs(force) > NOTHING * self.longest

    def _vector(
        self,
        kind: Any,
        symbol: str,
        ends: tuple[str, str],
        said: Any,
        row: str,
        part: StrokePart,
        force: complex,
    ) -> None:
        start, end = map(self.pencil.place, ends)
        shape, reveals = Arrow(start, end, "", ""), (row,) if kind == "result" else ()
        if self._seen(force):
            stroke = Stroke(kind, symbol, shape, said, row, "force", reveals=reveals, part=part)
            self.pencil.strokes.append(stroke)
        else:
            self.pencil.zeros.append(Stroke(kind, symbol, shape, "", row, "force", part=part))
