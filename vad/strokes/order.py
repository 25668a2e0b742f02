"""Orders of derivative with respect to time, and what their quantities are called."""

from __future__ import annotations

from dataclasses import dataclass

from vad.written import per_second


@dataclass(frozen=True, slots=True)
class Order:
    """An order of derivative.

    Attributes
    ----------
    number
        0, 1 or 2: so many times a position is differentiated.
    panel
        The name of its diagram; points and slides call their quantity so, too.
    rate
        What a link calls its quantity: "angle", "omega" or "alpha".
    symbol, sliding
        The letters of what turns and of what slides.
    unit
        The unit of what turns.
    """

    number: int
    panel: str
    rate: str
    symbol: str
    sliding: str
    unit: str

    def unit_of(self, length: str) -> str:
        """Return the unit of what slides.

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
