"""``python -m docs [FOLDER]`` builds the documentation into FOLDER, ``build/site`` unless given.

With ``--every 9`` the gallery has one mechanism in nine, to look at the site in a moment.
"""

from argparse import ArgumentParser
from pathlib import Path

from docs.site import ROOT, build

if __name__ == "__main__":
    parser = ArgumentParser("python -m docs")
    parser.add_argument("folder", nargs="?", type=Path, default=ROOT / "build" / "site")
    parser.add_argument(
        "--every", type=int, default=1, metavar="N", help="one mechanism in N in the gallery"
    )
    given = parser.parse_args()
    if given.every < 1:
        parser.error(f"--every {given.every}: must be 1 or more")
    build(given.folder, given.every)
    print(f"open {given.folder / 'index.html'}")
