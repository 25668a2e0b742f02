"""Small multiples: a few poses of one mechanism, to be seen side by side at one scale.

The solver is imported only when one is made, because `vad.save` needs the class alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from vad import gate
from vad.displayed import Displayed
from vad.errors import UsageError, quoted
from vad.strokes.sheet import Cell, Sheet
from vad.written import typed

if TYPE_CHECKING:
    from vad.kinematics.motion import Motion
    from vad.mechanisms.mechanism import Mechanism
    from vad.statics.forces import Forces

FEWEST, MOST = 2, 6


@dataclass(frozen=True, slots=True, repr=False)
class Multiples(Displayed):
    """The sheets of a few poses, and the places of the driver, which are their titles."""

    sheets: tuple[Sheet, ...]
    places: tuple[Cell, ...]

    def __repr__(self) -> str:
        """Return a line: what is drawn, and at which places of the driver."""
        places = ", ".join(typed(cell.value) for cell in self.places)
        return f"<Multiples of {self.sheets[0].mechanism}: at {places}>"


def multiples(
    mechanism: Mechanism | Motion | Forces[Any, Any, Any],
    at: Sequence[float],
    panels: Sequence[str] | str | None = None,
    language: str = "en",
    title: str | None = None,
    subtitle: str | None = None,
) -> Multiples:
    """Draw two to six poses of a mechanism, to be saved as one picture.

    Parameters
    ----------
    mechanism
        A mechanism, which moves as is usual for it, one pose of `vad.solve`, whose rates all poses
        take, or the forces in one, whose loads and masses they take, too.
    at
        The places of the driver: angles in degrees, or positions of a driven slide.
    panels, language, title, subtitle
        As for `vad.draw`.

    Raises
    ------
    vad.errors.UsageError
        If there are too few places or too many, or for an unknown panel or language.
    vad.errors.InputError
        For a place that is no finite number, or a motion of many poses.
    vad.errors.AssemblyError, vad.errors.DeadCentreError
        For a pose that does not exist, or has no rates.

    Examples
    --------
    >>> import vad
    >>> poses = vad.multiples(vad.SliderCrank(), at=(30, 60, 90))
    >>> [place.value for place in poses.places], len(poses.sheets)
    ([30.0, 60.0, 90.0], 3)
    """
    from vad.kinematics.motion import solve
    from vad.strokes.draw import draw, started, with_forces

    start, forces = started(mechanism, "its rates are those of one pose")
    driven, *_ = start.mechanism.inputs
    motions = [solve(start.mechanism, **{**start.inputs, driven: each}) for each in _checked(at)]
    burden = forces.burden if forces else None
    titles: dict[str, Any] = {"title": title, "subtitle": subtitle}
    return Multiples(
        tuple(draw(with_forces(motion, burden), panels, language, **titles) for motion in motions),
        tuple(_place(motion) for motion in motions),
    )


def _checked(at: Sequence[float]) -> list[float]:
    """Return the places of the driver, after checking that a picture has room for them."""
    wanted = f"{FEWEST} to {MOST} places of the driver"
    places = [] if isinstance(at, str) else gate.several("at", at, wanted)
    if not FEWEST <= len(places) <= MOST:
        got = str(len(places)) if places else quoted(at)
        raise UsageError(f"at: must be {wanted}, got {got}")
    return places


def _place(motion: Motion) -> Cell:
    """Return the place of the driver with its symbol, as it was given."""
    from vad.strokes.diagram import POSITION
    from vad.strokes.draw import scene_of
    from vad.words import Language

    scene = scene_of(motion, Language("en"))
    driver = scene.driver
    cell, *_ = scene.cells(POSITION, driver.name, driver.kind == "length")
    return replace(cell, value=float(next(iter(motion.inputs.values()))))
