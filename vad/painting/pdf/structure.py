"""Tagged PDF: every page is a figure, which a screen reader meets in words.

In come pages with their words, out go the objects of the structure that names them.
"""

from __future__ import annotations

from collections.abc import Sequence

from vad.painting.pdf.objects import Objects
from vad.painting.pdf.operators import Area, box, string


def entry(number: int) -> str:
    """Return what the dictionary of page ``number`` says of its place in the structure."""
    return f"/StructParents {number} /Tabs /S"


def marked(content: str) -> str:
    """Return the content of a page as one piece that the structure can point at."""
    return f"/Figure << /MCID 0 >> BDC\n{content}\nEMC"


def write(
    objects: Objects, pages: Sequence[int], areas: Sequence[Area], words: Sequence[str]
) -> str:
    """Write the structure of a document and return what its catalog says of it.

    Parameters
    ----------
    objects
        The file in the making.
    pages, areas, words
        The number of each page's object, its rectangle in points, and what it shows.
    """
    root, document = objects.reserve(), objects.reserve()
    figures = [
        objects.write(
            f"<< /Type /StructElem /S /Figure /P {document} 0 R /Pg {page} 0 R /K 0 "
            f"/Alt {string(text)} /A << /O /Layout /Placement /Block /BBox {box(area)} >> >>"
        )
        for page, area, text in zip(pages, areas, words, strict=True)
    ]
    kids = " ".join(f"{figure} 0 R" for figure in figures)
    objects.write(f"<< /Type /StructElem /S /Document /P {root} 0 R /K [{kids}] >>", document)
    parents = " ".join(f"{number} [{figure} 0 R]" for number, figure in enumerate(figures))
    objects.write(
        f"<< /Type /StructTreeRoot /K {document} 0 R /ParentTreeNextKey {len(figures)} "
        f"/ParentTree << /Nums [{parents}] >> >>",
        root,
    )
    return f"/MarkInfo << /Marked true >> /StructTreeRoot {root} 0 R"
