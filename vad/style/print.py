"""Print: black on white for handouts; links are told apart by dash and weight."""

from vad.style import LineStyle, Style

STYLE = Style(
    name="print",
    background="#FFFFFF",
    text="#000000",
    grey="#555555",
    hairline="#9A9A9A",
    inks=("#000000",),
    lines=(
        LineStyle(1.3),
        LineStyle(1.0, (3.2, 1.3)),
        LineStyle(0.85, (6.0, 1.3, 1.2, 1.3)),
        LineStyle(1.0, (1.1, 1.1)),
        LineStyle(0.7, (7.0, 1.3, 1.1, 1.3, 1.1, 1.3)),
        LineStyle(1.3, (1.1, 3.0)),
        LineStyle(0.9, (8.0, 1.6)),
        LineStyle(1.2, (2.4, 1.1, 1.1, 1.1)),
    ),
    key=0.0915,
    erase=0.003,
)
