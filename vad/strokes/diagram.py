"""Kinds of diagrams, and the orders of derivatives.

A diagram makes a `Panel` from the scene of a pose.  It states what is drawn, its place on the page,
and what it measures.  Each kind is one file of `vad.strokes.diagrams`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, get_args

from vad.errors import UsageError, quoted
from vad.strokes.shapes import Turned
from vad.strokes.sheet import (
    BELOW,
    Body,
    Cell,
    Coincidence,
    Equation,
    ImageTriangle,
    Inset,
    Note,
    Panel,
    PictureKind,
    Stroke,
)
from vad.written import per_second

if TYPE_CHECKING:
    from vad.kinematics.motion import Motion
    from vad.strokes.draw import AnyScene


@dataclass(frozen=True, slots=True, eq=False)  # there are three, each equal to itself alone
class Order:
    """The order of a derivative: position, velocity or acceleration.

    Attributes
    ----------
    number
        0, 1 or 2: how many times the position is differentiated.
    panel
        The name of its diagram, and of the quantity of points and slides.
    rate
        The name of the quantity of links: "angle", "omega" or "alpha".
    symbol, sliding
        The letters of the quantity for links, which turn, and for slides.
    unit
        The unit of the quantity of links.
    """

    number: int
    panel: str
    rate: str
    symbol: str
    sliding: str
    unit: str

    def unit_of(self, length: str) -> str:
        """Return the unit of the quantity of slides, for a unit of length.

        Examples
        --------
        >>> [order.unit_of("mm") for order in ORDERS]
        ['mm', 'mm/s', 'mm/s²']
        """
        return per_second(length, self.number)


POSITION = Order(0, "position", "angle", "θ", "s", "°")
VELOCITY = Order(1, "velocity", "omega", "ω", "v", "rad/s")
ACCELERATION = Order(2, "acceleration", "alpha", "α", "a", "rad/s²")
#: All orders, by their numbers.
ORDERS = POSITION, VELOCITY, ACCELERATION


@dataclass(frozen=True, slots=True)
class Drawing:
    """The content of a panel in one pose.

    The fields are those of `Panel`, which also has the name and the title of its diagram.  If
    ``picture`` and ``unit`` are not given, they are those of the diagram.
    """

    strokes: tuple[Stroke, ...]
    zeros: tuple[Stroke, ...] = ()
    equations: tuple[Equation, ...] = ()
    inset: Inset | None = None
    triangles: tuple[ImageTriangle, ...] = ()
    loops: tuple[int, ...] = ()
    notes: tuple[Note, ...] = ()
    remark: str = ""
    unit: str = ""
    below: Drawing | None = None
    picture: PictureKind | None = None
    bodies: tuple[Body, ...] = ()
    coincident: tuple[Coincidence, ...] = ()
    given: int = 0
    turned: tuple[Turned, ...] = ()
    resumes: str = ""


class Spot(NamedTuple):
    """A point of a diagram, in one of its views.

    ``view`` is the name of the view, empty for the first.  ``below`` is true for a point of the
    polygon below.  One that is not ``lettered`` has a name that is not written beside it.  ``row``
    is that whose ink its path has, where no vector tells it that ends there.  ``path`` says whether
    its path over a turn is drawn with numbered positions, is bare of them, is numbered alone
    because a stroke of the panel draws it, or is left out.  ``arrow`` is the name of the stroke
    that leads to it in poses in which it is too far away to be drawn.
    """

    letter: str
    view: str = ""
    below: bool = False
    lettered: bool = True
    row: str | None = None
    path: Literal["drawn", "bare", "numbered", "none"] = "drawn"
    arrow: str = ""


def in_plane(motion: Motion[Any, Any, Any]) -> bool:
    """Tell whether the mechanism is one in the plane: a choice for `Diagram.applies`."""
    from vad.kinematics.motion import MotionInSpace  # a list of diagrams does not need it

    return everywhere(motion) and not isinstance(motion, MotionInSpace)


def turns_on_the_frame(motion: Motion[Any, Any, Any]) -> bool:
    """Tell whether a link is driven that turns about a pivot of the frame."""
    from vad.kinematics.linkage import Bar, scalar_of  # a list of diagrams does not need them

    if not in_plane(motion) or motion.linkage.driver.kind != "angle":
        return False
    bars = (step for step in motion.frame.steps if isinstance(step, Bar))
    mine = (bar for bar in bars if scalar_of(bar) == motion.linkage.driver)
    return any({bar.tail, bar.head} & motion.frame.fixed.keys() for bar in mine)


def is_slider_crank(motion: Motion[Any, Any, Any]) -> bool:
    """Tell whether the mechanism is a slider-crank whose crank is driven."""
    from vad.kinematics.klein import parts_of  # a list of diagrams does not need it

    return parts_of(motion.solver) is not None


def output_of(scene: AnyScene) -> str:
    """Return the row of the output."""
    return scene.output


def everywhere(motion: Motion[Any, Any, Any]) -> bool:
    """Tell whether a motion is that of a mechanism, and not of a shaft or an engine."""
    return not motion.mechanism.is_rotor


def no_cells(scene: AnyScene, key: str, slides: bool) -> tuple[Cell, ...]:
    """Add nothing to a row of the results table."""
    return ()


def no_tracks(scene: AnyScene) -> Mapping[Spot, Any]:
    """Return no lettered points."""
    return {}


@dataclass(frozen=True, slots=True)
class Diagram:
    """A kind of diagram.

    Attributes
    ----------
    name
        What it is called in ``panels=…``, in JSON and on the command line.
    title
        Its heading in English; another language may have its own.
    rank
        Diagrams stand on the page, and are drawn, in ascending order of it.
    picture
        How its panel is painted: "skeleton" is a mechanism in the plane, "vectors" are those from a
        pole, "views" are those of a mechanism in space.
    unit
        The function from a scene to the unit of its coordinates.
    pose
        The function from a scene to its strokes.
    cells
        The function that returns the cells which the diagram adds to a row of the results, from the
        scene, the key of the row and whether it is the row of a slide.
    tracks
        The function from a scene to the places of its lettered points: complex arrays if the scene
        has many poses.
    usual
        Whether it is drawn where nobody asks for it by name.
    applies
        The function that tells whether the diagram can be drawn for the mechanism of a motion.
    by_hand
        Whether a hand may turn it on a page: its strokes are the same in all poses.
    curve_row
        The function from a scene to the row whose quantity is drawn over a turn.
    """

    name: str
    title: str
    rank: float
    picture: PictureKind
    unit: Callable[[AnyScene], str]
    pose: Callable[[AnyScene], Drawing]
    cells: Callable[[AnyScene, str, bool], tuple[Cell, ...]] = no_cells
    tracks: Callable[[AnyScene], Mapping[Spot, Any]] = no_tracks
    usual: bool = True
    applies: Callable[[Motion[Any, Any, Any]], bool] = everywhere
    by_hand: bool = True
    curve_row: Callable[[AnyScene], str] = output_of

    def __post_init__(self) -> None:
        """Refuse a kind of picture that no painter knows."""
        kinds = get_args(PictureKind)
        if self.picture not in kinds:
            problem = f"diagram '{self.name}': unknown picture {quoted(self.picture)}"
            raise UsageError(problem, "known: " + ", ".join(kinds))

    @classmethod
    def of_order(cls, order: Order, rank: float, picture: PictureKind) -> Diagram:
        """Return the diagram of positions, velocities or accelerations, which every scene has."""
        return cls(
            order.panel,
            order.panel.capitalize(),
            rank,
            picture,
            lambda scene: scene.unit_of(order),
            lambda scene: scene.drawing(order),
            lambda scene, key, slides: scene.cells(order, key, slides),
            lambda scene: scene.tracks(order),
        )

    @classmethod
    def of_balancing(
        cls,
        name: str,
        title: str,
        rank: float,
        picture: PictureKind,
        otherwise: tuple[Any, ...] = (),
    ) -> Diagram:
        """Return a diagram of shafts or engines.

        ``otherwise`` are the unit, the strokes, the cells and the tracks of the diagram of that
        name of a mechanism in the plane.
        """

        def balancing(scene: Any) -> Any:
            """Return the drawings of a shaft or an engine; None for a mechanism."""
            return getattr(scene, "drawings", None)

        def unit(scene: Any) -> str:
            found = balancing(scene)
            return str(found.unit(name) if found else otherwise[0])

        def pose(scene: Any) -> Drawing:
            found = balancing(scene)
            drawn: Drawing = found.drawing(name) if found else otherwise[1](scene)
            return drawn

        def cells(scene: Any, key: str, slides: bool) -> tuple[Cell, ...]:
            found = balancing(scene)
            own: tuple[Cell, ...] = (
                found.cells(name, key) if found else otherwise[2](scene, key, slides)
            )
            return own

        def tracks(scene: Any) -> Mapping[Spot, Any]:
            found = balancing(scene)
            own: Mapping[Spot, Any] = found.tracks(name) if found else otherwise[3](scene)
            return own

        def curve_row(scene: Any) -> str:
            found = balancing(scene)
            return str(found.curve_row(name) if found else scene.output)

        def applies(motion: Motion[Any, Any, Any]) -> bool:
            if everywhere(motion):
                return bool(otherwise) and in_plane(motion)
            return name in motion.mechanism.diagrams

        return cls(
            name,
            title,
            rank,
            picture,
            unit,
            pose,
            cells,
            tracks,
            usual=False,
            applies=applies,
            curve_row=curve_row,
        )

    def panel(self, scene: AnyScene) -> Panel:
        """Return the panel of a pose, its title in the language of the scene."""
        return self._panel(scene, self.name, self.pose(scene))

    def _panel(self, scene: AnyScene, name: str, drawing: Drawing) -> Panel:
        return Panel(
            name,
            drawing.unit or self.unit(scene),
            drawing.strokes,
            drawing.equations,
            drawing.inset,
            drawing.zeros,
            scene.name(self.title),
            drawing.picture or self.picture,
            drawing.triangles,
            drawing.loops,
            drawing.notes,
            drawing.remark,
            self._panel(scene, name + BELOW, drawing.below) if drawing.below else None,
            drawing.bodies,
            drawing.coincident,
            drawing.given,
            drawing.turned,
            drawing.resumes,
        )
