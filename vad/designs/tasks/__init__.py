"""The tasks of design: each module of this package declares one, and no table lists them."""

from collections.abc import Iterator, Mapping
from importlib import import_module

from vad.designs.task import Task
from vad.discovery import names_in
from vad.errors import one_of

__all__ = ["TASKS", "Task", "task_named"]


class _Tasks(Mapping[str, Task]):
    """Every task by its name; its module is imported when it is asked for."""

    def __getitem__(self, name: str) -> Task:
        if name not in tuple(self):
            raise KeyError(name)
        task: Task = import_module(f"{__name__}.{name.replace('-', '_')}").TASK
        return task

    def __iter__(self) -> Iterator[str]:
        return (name.replace("_", "-") for name in names_in("designs", "tasks"))

    def __len__(self) -> int:
        return len(names_in("designs", "tasks"))


#: Every task by the name that the command line knows.
TASKS: Mapping[str, Task] = _Tasks()


def task_named(name: object) -> Task:
    """Return the task of a name.

    Raises
    ------
    vad.errors.UsageError
        If there is none.

    Examples
    --------
    >>> task_named("slider-crank").title
    'Slider–crank from its stroke and time ratio'
    """
    return TASKS[one_of("task of design", name, TASKS)]
