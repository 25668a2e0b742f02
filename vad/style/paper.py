"""Paper: dark ink on white, for slides."""

from vad.style import Style

STYLE = Style(
    name="paper",
    background="#FFFFFF",
    text="#1A1A1A",
    grey="#6B6B6B",
    hairline="#C4C4C4",
    inks=("#0072B2", "#D55E00", "#009E73", "#AA3377", "#000000"),
)
