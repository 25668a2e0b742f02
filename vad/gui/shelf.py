"""The mechanisms that a window has: the program's own, the examples, and files that are opened.

An example is made when it is asked for.  A file comes as text: no question names a path.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from threading import Lock

from vad.errors import UsageError
from vad.files.examples import EXTENSION, example_names, example_path, example_title
from vad.files.loading import class_of, load
from vad.files.tables import read_text
from vad.gui.messages import Kinds, check_turned
from vad.mechanisms import Mechanism

#: How many files are kept; who opens more opens the first one anew.
MOST_FILES = 20


class Shelf(Mapping[str, type[Mechanism]]):
    """Mechanisms by name; those of files end in ``.toml``.

    Parameters
    ----------
    own
        Those with which the window opens.
    """

    def __init__(self, own: Kinds) -> None:
        self.own = dict(own)
        self._opened: dict[str, type[Mechanism]] = {}
        self._lock = Lock()

    def __getitem__(self, name: str) -> type[Mechanism]:
        """Return a mechanism; an example is read when it is wanted."""
        with self._lock:
            found = self.own.get(name) or self._opened.get(name)
        if found:
            return found
        if name in self.examples:
            return load(example_path(name.removesuffix(EXTENSION)))
        raise KeyError(name)

    def __iter__(self) -> Iterator[str]:
        yield from {**self.own, **self._opened, **dict.fromkeys(self.examples)}

    def __len__(self) -> int:
        return len(list(iter(self)))

    @property
    def opened(self) -> Kinds:
        """The mechanisms of files that were opened, by name."""
        with self._lock:
            return dict(self._opened)

    @property
    def examples(self) -> list[str]:
        """The names of the examples."""
        names = (name + EXTENSION for name in example_names())
        return [name for name in names if name not in self.own]

    def titles(self, language: str) -> dict[str, str]:
        """Return the titles of the examples in a language, by name."""
        return {
            name: example_title(name.removesuffix(EXTENSION), language) for name in self.examples
        }

    def open(self, name: str, text: str) -> str:
        """Keep the mechanism that a file describes, and return what it is called.

        Raises
        ------
        vad.errors.VadError
            With the line of what cannot be read or cannot move; for a shaft or an engine.
        """
        if not name.endswith(EXTENSION) or len(name) > 100 or not name.isprintable():
            raise UsageError(f"name: must end in {EXTENSION}", "vad example watt-1 prints one")
        kind = class_of(read_text(text, name))
        check_turned(kind, name)
        with self._lock:
            self._opened.pop(name, None)
            self._opened[name] = kind
            for oldest in list(self._opened)[:-MOST_FILES]:
                del self._opened[oldest]
            self.own.pop(name, None)
        return name
