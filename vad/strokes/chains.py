"""The loop equations of a linkage as vector equations: each step with its components."""

from __future__ import annotations

from dataclasses import dataclass
from typing import cast

from vad.kinematics.linkage import Bar, Loop, Scalar, Slide, Step, scalar_of
from vad.strokes.scene import Scene, image_letter
from vad.strokes.sheet import Component
from vad.strokes.vector_equations import Chain, Part, Vector, VectorEquation

SUBSCRIPT_N = "ₙ"


@dataclass(frozen=True, eq=False, kw_only=True)
class StepVector(Vector):
    """The vector of a step of the linkage."""

    step: Step


def equation_of(
    scene: Scene, loop: Loop, unknowns: tuple[Scalar, ...], order: int
) -> VectorEquation[StepVector]:
    """Return a loop's equation of an order."""
    first, second = (chain_of(scene, steps, unknowns, order) for steps in (loop.first, loop.second))
    return VectorEquation(first, second, loop.first[-1].end)


def chain_of(
    scene: Scene, steps: tuple[Step, ...], unknowns: tuple[Scalar, ...], order: int
) -> Chain[StepVector]:
    """Return one side of a loop equation."""
    vectors = tuple(_vector(scene, step, order) for step in steps)
    parts = [part for vector in vectors for part in _parts(scene, vector, unknowns, order)]
    start, end = (image_letter(each, order) for each in (steps[0].start, steps[-1].end))
    return Chain(start, end, vectors, tuple(_coriolis_last(parts)))


def owner(step: Step) -> str:
    """Return the row of the results table whose ink a step takes."""
    return scalar_of(step).name


def _vector(scene: Scene, step: Step, order: int) -> StepVector:
    tail, head = (image_letter(each, order) for each in (step.tail, step.head))
    measured = order > 1 and isinstance(step, Bar) and not _is_driving_strut(scene, step)
    still = step.tail in scene.members.fixed
    whole: Component | None = ("absolute" if still else "relative") if measured else None
    return StepVector(
        step.ends,
        tail,
        head,
        owner(step),
        step.reverse,
        arrives=not _on_link(step),
        lettered=step.head in scene.members.points,
        whole=whole,
        step=step,
    )


def _parts(
    scene: Scene, vector: StepVector, unknowns: tuple[Scalar, ...], order: int
) -> list[Part[StepVector]]:
    """Return the components of a step."""
    step, frame = vector.step, scene.members.frame
    found = scalar_of(step) in unknowns
    label, square_to = _line(scene, step) if found else ("", None)
    parts = []
    for component in frame.components(step, scene.pose, scene.orders(order)):
        direction = scene.heading(component.direction)
        amount = float(cast(float, component.amount)) * frame.scale
        coriolis = component.name == "coriolis"
        part = Part(
            vector,
            component.name,
            amount * direction,
            direction,
            unknown=found and component.name in ("tangential", "sliding"),
            component="absolute" if scene.members.is_guide(step) else component.name,
            stage="z" if coriolis else _stage(scene, vector, found, order),
            dictated=scene.members.drives(step)
            and not coriolis,  # Coriolis needs a link that is found
            label=label,
            square_to=square_to,
        )
        parts.append(part)
    return parts


def _line(scene: Scene, step: Step) -> tuple[str, str | None]:
    """Return the label of a step's construction line, and what that is perpendicular to."""
    if isinstance(step, Slide):
        return scene.say("parallel", line=scene.line(step)), None
    square_to = scene.members.letters(step)
    return f"⟂ {square_to}", square_to


def _stage(scene: Scene, vector: StepVector, found: bool, order: int) -> str:
    """Name the vertex between the components of a step: b′ₙ, cₙ; a slide has but its head."""
    step = vector.step
    if isinstance(step, Slide):
        return vector.head
    if not found:
        return vector.head + SUBSCRIPT_N
    # That of a strut stands where its part is before it turns.
    point = step.tail if _is_driving_strut(scene, step) else step.head
    return point.lower() + SUBSCRIPT_N


def _on_link(step: Step) -> bool:
    """Tell whether a step slides on a turning link: its end is a stage, no point of the link."""
    return isinstance(step, Slide) and isinstance(step.along, str)


def _is_driving_strut(scene: Scene, step: Bar) -> bool:
    """Tell whether a bar is a strut that the driver makes longer."""
    return step.length == scene.driver.name


def _coriolis_last(parts: list[Part[StepVector]]) -> list[Part[StepVector]]:
    """Put the Coriolis part of a strut behind the normal part of the bar that has its length."""
    late = [part for part in parts if part.name == "coriolis" and not part.reverse]
    struts = {part.of.owner for part in late}
    bars = (part.of.step for part in parts if isinstance(part.of.step, Bar))
    if not any(bar.length in struts for bar in bars):
        return parts
    return [part for part in parts if part not in late] + late
