"""The links of a mechanism: bars, levers with their slits, plates, blocks, and slots of yokes.

Strokes of a position panel become pieces, with the same anchors in all poses.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from vad.plan.anchors import Anchor, Area, Chains, Hung, Strip, Term
from vad.plan.geometry import direction_of
from vad.plan.items import Level
from vad.plan.labels.obstacles import PIXEL
from vad.plan.marks import Fading, Trimming
from vad.plan.pictures import machine, supports
from vad.plan.pictures.lanes import Pen
from vad.plan.reach import block_along, block_on, carries_block, ends_of_travel, is_bar, is_yoke
from vad.plan.roles import BAR, BLOCK_RIM, PLATE_EDGE
from vad.plan.sketch import Part, Piece, Sketch
from vad.strokes.sheet import Arrow, Block, Guide, Panel, Plate, Stroke

NARROW = 0.42  # of a bar's width, on a longer bar
NEXT_TO_PIVOT = 2.0  # the reaches of a joint, from a lever's pivot to its slit
SLOT_EDGE = 0.004  # from the lower and the upper edge of the room, a slot ends
LIGHT_AND_BLOCK = ("block light", "block")


class Links:
    """The links of one mechanism; ``size`` is that of all parts."""

    def __init__(self, size: float) -> None:
        self.size = size
        self._pieces: dict[tuple[str, bool, bool], Piece] = {}

    def pieces(
        self, sketch: Sketch, order: Iterable[int], alone: bool = False
    ) -> Iterator[tuple[int, Piece | None]]:
        """Yield strokes in an order, each with how it hangs if it is a bar, block, plate or slot.

        The anchors are the same in all poses, except those of bars on a longer bar, which are
        narrower unless they are drawn ``alone``, and of levers whose block is behind their pivot.
        """
        panel, behind = sketch.setting.panel, self._behind(sketch)
        narrow = set() if alone else self._narrow(sketch)
        for index in order:
            stroke = panel.strokes[index]
            match stroke.shape:
                case Arrow() | Block() | Plate() | Guide(side=None):
                    piece = self._piece(sketch, index, index in narrow, stroke.link in behind)
                    yield index, piece
                case _:
                    yield index, None

    def _piece(self, sketch: Sketch, index: int, narrow: bool, behind: bool) -> Piece:
        stroke = sketch.setting.panel.strokes[index]
        piece = self._pieces.get((stroke.name, narrow, behind))
        if piece is None:
            match stroke.shape:
                case Arrow():
                    piece = self._bar(sketch, index, narrow)
                case Plate():
                    piece = plate(stroke, sketch.setting.row(stroke.link))
                case Block():
                    piece = self._block(sketch, stroke)
                case _:
                    piece = self._slot(sketch, stroke)
            self._pieces[stroke.name, narrow, behind] = piece
        return piece

    def _bar(self, sketch: Sketch, index: int, narrow: bool) -> Piece:
        """Return a bar of a link; the slit of a lever is over all its bars, and under the block."""
        panel = sketch.setting.panel
        stroke = panel.strokes[index]
        shape, row = stroke.shape, sketch.setting.row(stroke.link)
        assert isinstance(shape, Arrow)
        level = Level.CARRIER if carries_block(panel, stroke) else Level.STROKE
        start, end = self._ends(panel, stroke)
        seen, width = self._seen(sketch, index), NARROW if narrow else 1.0
        light = Hung(Chains(((start, end),)), "bar light", row, Trimming())
        shown: list[Hung] = []
        blocks: list[tuple[tuple[Anchor, ...], float]] = [((start, end), BAR / 2)]
        if shape.cylinder:
            foot, wide = Anchor.of(stroke.name, "foot"), machine.CYLINDER * self.size
            corners = machine.bar_corners(start, foot, -Term(stroke.name), wide)
            blocks.append(((*corners, corners[0]), BLOCK_RIM / 2))
        if seen:
            role = "piston rod" if shape.cylinder else "bar"
            if narrow:
                shown.append(Hung(Chains(((seen, end),)), "bar casing", None, Trimming()))
            shown.append(Hung(Chains(((seen, end),)), role, row, Trimming(), width))
            if shape.cylinder:
                shown.append(Hung(Area(tuple(corners)), "block", row, Fading()))
        slit = self._slit(sketch, stroke, end)
        parts = [
            Part(level, (light,), until="over"),
            Part(level, tuple(shown)),
            Part(Level.BLOCK, (slit,) if slit else ()),
        ]
        return Piece(tuple(parts), tuple(blocks), replace(light, growth=None))

    def _ends(self, panel: Panel, stroke: Stroke) -> tuple[Anchor, Anchor]:
        """Return the ends of a bar; a lever's slit ends half a block past the way of its block."""
        start, end = Anchor.of(stroke.name, "start"), Anchor.of(stroke.name, "end")
        ridden = self._way_on(panel, stroke)
        if ridden:
            way, (_, ahead) = ridden
            past = machine.LEVER_BLOCK[0] / 2 * self.size - BAR / 2  # its cap is under the slit
            end = start + way.in_panel(ahead) + past * way
        return start, end

    def _way_on(self, panel: Panel, lever: Stroke) -> tuple[Term, tuple[float, float]] | None:
        """Return the way from a lever's pivot to the block on it, and how far away that gets.

        That is the way of the slide, or against it where the block is behind the pivot.  None for
        a bar that carries no block.
        """
        block, bar = block_on(panel, lever), lever.shape
        if block is None:
            return None
        assert isinstance(bar, Arrow) and isinstance(block.shape, Block)
        ahead = _is_ahead(lever, block)
        way = block.shape.direction if ahead else -block.shape.direction
        spots = ends_of_travel(block.shape)[:: 1 if ahead else -1]
        back, far = (((spot - bar.start) * way.conjugate()).real for spot in spots)
        return (1.0 if ahead else -1.0) * Term(block.name), (back, far)

    def _slit(self, sketch: Sketch, lever: Stroke, end: Anchor) -> Hung | None:
        """Return the slit of a lever, as long as the way of its block; None for other bars."""
        ridden = self._way_on(sketch.setting.panel, lever)
        if ridden is None:
            return None
        way, (back, _) = ridden
        row, factor = sketch.setting.row(lever.link), sketch.scale.factor
        nearest = NEXT_TO_PIVOT * machine.JOINT_REACH * self.size
        first = back * factor - machine.LEVER_BLOCK[0] / 2 * self.size
        start = Anchor.of(lever.name, "start") + max(first, nearest) * way
        corners = machine.bar_corners(start, end + BAR / 2 * way, -way, machine.SLIT)
        return Hung(Area(tuple(corners)), "slit", row, Fading())

    def _seen(self, sketch: Sketch, index: int) -> Anchor | None:
        """Return where a bar leaves those of its link that are drawn already."""
        panel, solved = sketch.setting.panel, sketch.solved
        stroke = panel.strokes[index]
        seen, last = self._ends(panel, stroke)
        start, end = solved.places((seen, last))
        farthest = 0.0
        for other in panel.strokes[:index]:
            if isinstance(other.shape, Arrow) and other.link == stroke.link:
                hung = self._ends(panel, other)
                tail, head = solved.places(hung)
                same_way = abs(direction_of(tail, head) - direction_of(start, end)) < 1e-6
                if abs(tail - start) < PIXEL and same_way and abs(head - start) > farthest:
                    seen, farthest = hung[1], abs(head - start)
        return seen if farthest < abs(end - start) - PIXEL else None

    def _behind(self, sketch: Sketch) -> set[str | None]:
        """Return the levers whose block is behind their pivot, seen along its way, in this pose."""
        panel = sketch.setting.panel
        levers = ((stroke, block_on(panel, stroke)) for stroke in self._levers(panel))
        return {lever.link for lever, block in levers if block and not _is_ahead(lever, block)}

    def _levers(self, panel: Panel) -> list[Stroke]:
        bars = (stroke for stroke in panel.strokes if isinstance(stroke.shape, Arrow))
        return [bar for bar in bars if carries_block(panel, bar)]

    def _narrow(self, sketch: Sketch) -> set[int]:
        """Return the numbers of the bars that lie on a longer one of another link in this pose."""
        panel = sketch.setting.panel
        bars = {
            index: Pen(start, end, BAR)
            for index, stroke in enumerate(panel.strokes)
            if is_bar(stroke)
            for start, end in [sketch.solved.places(self._ends(panel, stroke))]
        }
        return {
            index
            for index, bar in bars.items()
            if any(
                panel.strokes[number].link != panel.strokes[index].link
                and abs(other.end - other.start) > abs(bar.end - bar.start)
                and bar.covers(other)
                for number, other in bars.items()
            )
        }

    def _block(self, sketch: Sketch, stroke: Stroke) -> Piece:
        """Return a sliding block; that of a yoke is its shaft."""
        panel, row = sketch.setting.panel, sketch.setting.row(stroke.link)
        assert isinstance(stroke.shape, Block)
        if is_yoke(panel, stroke.link):
            outline = supports.yoke_of(panel, stroke.link, self.size).outline()
        else:
            at, on_lever = Anchor.of(stroke.name, "at"), stroke.shape.on is not None
            outline = machine.block_corners(at, Term(stroke.name), on_lever, self.size)
        return block_piece(outline, row)

    def _base(self, panel: Panel, slot: Stroke) -> tuple[Anchor, complex]:
        """Return a point fixed on the link of a slot: that of a bar, else the slot's own."""
        assert isinstance(slot.shape, Guide)
        for stroke in panel.strokes:
            if isinstance(stroke.shape, Arrow) and stroke.link == slot.link:
                return Anchor.of(stroke.name, "start"), stroke.shape.start
        return Anchor.of(slot.name, "through"), slot.shape.through

    def _slot(self, sketch: Sketch, stroke: Stroke) -> Piece:
        """Return the slot of a moving link: half a block past all places of its block."""
        panel, row = sketch.setting.panel, sketch.setting.row(stroke.link)
        shape, block = stroke.shape, block_along(panel, stroke)
        assert isinstance(shape, Guide)
        base, at = self._base(panel, stroke)
        back, factor = shape.direction.conjugate(), sketch.scale.factor
        off = (shape.through - at) * back
        past = machine.BLOCK[0] / 2 * self.size + machine.PAST
        reach = [off.real * factor]
        for spot in ends_of_travel(block.shape) if block else ():
            along = ((spot - at) * back).real * factor
            reach += [along - past, along + past]
        strip = Strip(
            through=base + (1j * Term(stroke.name)).in_panel(off.imag) if off else base,
            stroke=stroke.name,
            low=min(reach),
            high=max(reach),
            wide=machine.slot_width(self.size),
            room=sketch.setting.room,
            inset=SLOT_EDGE,
        )
        edge = Hung(replace(strip, closed=False), "slot", row, Trimming())
        parts = (
            Part(Level.GROUND, (edge,), until="after"),
            Part(Level.GROUND, (Hung(strip, "slot", row),), since="after"),
        )
        return Piece(parts, slot=replace(strip, closed=False))


def _is_ahead(lever: Stroke, block: Stroke) -> bool:
    """Tell whether a lever leads along the way of the block on it, not against it."""
    bar, shape = lever.shape, block.shape
    assert isinstance(bar, Arrow) and isinstance(shape, Block)
    return ((bar.end - bar.start) * shape.direction.conjugate()).real >= 0


def block_piece(outline: Sequence[Anchor], row: int | None) -> Piece:
    """Return a block with its outline, which labels keep clear of, as of its diagonals."""
    first, second, third, fourth = outline
    light, block = (Hung(Area(tuple(outline)), role, row, Fading()) for role in LIGHT_AND_BLOCK)
    parts = Part(Level.BLOCK, (light,), until="over"), Part(Level.BLOCK, (block,))
    blocks = ((*outline, first, third), BLOCK_RIM / 2), ((second, fourth), BLOCK_RIM / 2)
    return Piece(parts, blocks, replace(light, growth=None))


def plate(stroke: Stroke, row: int | None) -> Piece:
    """Return the plate of a link: its outline, and a tint through which what is beneath shows."""
    assert isinstance(stroke.shape, Plate)
    corners = tuple(Anchor.of(stroke.name, number) for number in range(len(stroke.shape.corners)))
    light, *marks = (
        Hung(Area(corners), role, row, Fading())
        for role in ("plate edge light", "plate", "plate edge")
    )
    parts = Part(Level.GLOW, (light,), until="over"), Part(Level.CARRIER, tuple(marks))
    blocks = (((*corners, corners[0]), PLATE_EDGE / 2),)
    return Piece(parts, blocks, replace(light, growth=None))
