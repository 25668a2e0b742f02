"""Chalk: light ink on a dark board."""

from vad.style import Style

STYLE = Style(
    name="chalk",
    background="#1D2B27",
    text="#F5F2E9",
    grey="#A9B4AE",
    hairline="#4A5A54",
    inks=(
        *("#56B4E9", "#E69F00", "#FFF956", "#CBAFBA"),
        *("#F5FFFF", "#5673D1", "#FE5082", "#827B14"),
    ),
)
