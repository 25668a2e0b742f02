"""Paper: dark ink on white, for slides."""

from vad.style import Style

STYLE = Style(
    name="paper",
    background="#FFFFFF",
    text="#1A1A1A",
    grey="#6B6B6B",
    hairline="#C4C4C4",
    inks=(
        *("#0C6CBA", "#D76104", "#02A374", "#AF0976"),
        *("#000000", "#9C88A0", "#B10000", "#5A6752"),
    ),
)
