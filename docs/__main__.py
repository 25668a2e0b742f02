"""``python -m docs [FOLDER]`` builds the documentation into FOLDER, ``build/site`` unless given."""

import sys
from pathlib import Path

from docs.site import ROOT, build

if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build" / "site"
    build(folder)
    print(f"open {folder / 'index.html'}")
