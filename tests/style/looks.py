"""How every role looks in every style, as text that a reviewer reads in a diff.

A line for a role: its fill, its pen (colour, width in ten-thousandths of the page unit, dash in
widths), its alpha and the line beneath it.  ``python -m tests.style.looks`` writes it anew.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from vad.plan.roles import ROLES
from vad.style import Look, Pen, load_style, style_names

TABLE = Path(__file__).with_name("looks.txt")


def written() -> Iterator[str]:
    """Yield the lines of the table: the first two rows and the frame, where they differ."""
    for name in style_names():
        style = load_style(name)
        yield f"{name} on {style.background}, key {10_000 * style.key:.0f}"
        for role in ROLES:
            looks = {_look(style.look(role, row)): row for row in (None, 1, 0)}
            for look, row in sorted(looks.items(), key=lambda pair: (pair[1] is None, pair[1])):
                yield f"  {role}{'' if row is None or len(looks) == 1 else f' [{row}]'}: {look}"


def _look(look: Look) -> str:
    parts = [f"fill {look.fill}" if look.fill else "", f"line {_pen(look.pen)}" if look.pen else ""]
    parts += [f"alpha {look.alpha:g}" if look.alpha != 1.0 else ""]
    parts += [f"on {_pen(look.under)}" if look.under else ""]
    return ", ".join(part for part in parts if part)


def _pen(pen: Pen) -> str:
    dash = " ".join(f"{part / pen.width:.1f}" for part in pen.dash)
    shape = "".join(f" {kind}" for kind in (pen.cap, pen.join) if kind == "round")
    return f"{pen.colour} {10_000 * pen.width:.0f}{shape}" + (f" dash {dash}" if dash else "")


if __name__ == "__main__":
    TABLE.write_text("\n".join(written()) + "\n", encoding="utf-8")
