"""Which scene a motion is: that of the plane, or that of its mechanism in space."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vad.kinematics.space.balls import BallSolver
from vad.kinematics.space.crossed_shafts import UniversalSolver
from vad.kinematics.space.sphere import SphereSolver
from vad.strokes.construct import construct
from vad.strokes.diagram import Drawing
from vad.strokes.order import Order
from vad.strokes.polygon import polygon
from vad.strokes.scene import Scene
from vad.strokes.space.balls import BallScene
from vad.strokes.space.hooke import HookeScene
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.strokes.space.spatial import SpatialScene
from vad.strokes.space.spherical import SphericalScene
from vad.words import Language

if TYPE_CHECKING:
    from vad.kinematics.motion import Motion


class PlaneScene(Scene):
    """One pose of a mechanism in the plane, with what is drawn of it."""

    def drawing(self, order: Order) -> Drawing:
        """Return the construction of the mechanism, or a polygon."""
        return polygon(self, order.number) if order.number else construct(self)


AnyScene = Scene | SceneInSpace

#: The scene of each solver in space, by whether anything slides.
IN_SPACE: Mapping[tuple[type, bool], type[SceneInSpace]] = {
    (UniversalSolver, False): HookeScene,
    (SphereSolver, False): SphericalScene,
    (SphereSolver, True): SpatialScene,
    (BallSolver, False): BallScene,
}


def scene_of(motion: Motion, language: Language) -> AnyScene:
    """Return the scene of a motion, whose solver tells the plane from space."""
    solver = motion.solver
    kind: Any = IN_SPACE.get((type(solver), bool(solver.slides)), PlaneScene)
    scene: AnyScene = kind(motion, language)
    return scene
