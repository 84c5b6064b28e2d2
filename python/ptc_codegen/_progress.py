"""Progress of long work: a bar of tqdm where that is installed, else a line."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Union

from ptc_codegen._extras import wanted

Progress = Union[Callable[[int, int], object], bool, None]
"""A callback that gets what is done and the whole; True for a bar, None or False for nothing."""


class _Bar:
    """A bar of tqdm."""

    def __init__(self, tqdm: Any, title: str) -> None:
        self._bar = tqdm(desc=title, total=0, leave=False)

    def __call__(self, done: int, total: int) -> None:
        self._bar.total = total
        self._bar.update(done - self._bar.n)

    def close(self) -> None:
        self._bar.close()


class _Line:
    """A line of the standard error that is written again and again."""

    def __init__(self, title: str) -> None:
        self._title = title
        self._length = 0

    def __call__(self, done: int, total: int) -> None:
        text = f"{self._title}: {done} of {total}"
        print(f"\r{text:<{self._length}}", end="", file=sys.stderr, flush=True)
        self._length = len(text)

    def close(self) -> None:
        if self._length:
            print(f"\r{'':<{self._length}}\r", end="", file=sys.stderr, flush=True)


@contextmanager
def reporting(progress: Progress, title: str) -> Iterator[Callable[[int, int], object] | None]:
    """What to call with the progress of the work in the block."""
    if progress is None or progress is False:
        yield None
        return
    if progress is not True:
        yield progress
        return
    module = wanted("tqdm.auto")
    bar = _Line(title) if module is None else _Bar(module.tqdm, title)
    try:
        yield bar
    finally:
        bar.close()
