"""Pictures of runs, drawn as the command draws them."""

from __future__ import annotations

import os
from base64 import b64encode
from collections.abc import Sequence
from functools import cached_property
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ptc_codegen import _ptc
from ptc_codegen._errors import mistake

if TYPE_CHECKING:
    from ptc_codegen._results import Run


class Picture:
    """A picture of runs of the closed loop: states, inputs and bounds over time.

    A notebook shows it. `save` writes it as SVG, PNG or PDF.
    """

    def __init__(self, runs: Sequence[Run], labels: Sequence[str] | None, log: bool) -> None:
        self._runs = tuple(runs)
        self._labels: tuple[str | None, ...] = (None,) * len(self._runs) if labels is None else tuple(labels)
        self._log = log
        if len(self._labels) != len(self._runs):
            message = f"{len(self._labels)} labels for {len(self._runs)} runs"
            raise mistake("labels", message, "give one for each run, or none")
        if not all(run.whole for run in self._runs):
            help = "leave `at` out of `simulate` for a run that is drawn"
            raise mistake("at", "a run has the instants of `at` alone", help)
        # What cannot be drawn is an error here, not where a notebook shows it.
        self.svg  # noqa: B018

    def _draw(self, kind: str) -> bytes:
        runs: list[Any] = [
            {
                "design": run.design._own,
                "label": label,
                "tau": run.tau,
                "t0": run.t0,
                "held": run.held,
                "t": run.t.tobytes(),
                "stretched": run.stretched.tobytes(),
                "x": run.x.tobytes(),
                "u": run.u.tobytes(),
            }
            for run, label in zip(self._runs, self._labels)
        ]
        return _ptc.draw(runs, self._log, kind)

    @cached_property
    def svg(self) -> str:
        """The text of an SVG file."""
        return self._draw("svg").decode()

    @cached_property
    def png(self) -> bytes:
        """The bytes of a PNG file."""
        return self._draw("png")

    @property
    def url(self) -> str:
        """A ``data:`` URL of the SVG, for the ``src`` of an image."""
        return "data:image/svg+xml;base64," + b64encode(self.svg.encode()).decode()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a file that ends in ``.svg``, ``.png`` or ``.pdf``."""
        place = Path(path)
        place.write_bytes(self._draw(place.suffix.removeprefix(".") if place.suffix else ""))

    def _repr_html_(self) -> str:
        # An image, as the styles in an SVG that is part of a page reach all of the page.
        return f'<img src="{escape(self.url)}" alt="{escape(repr(self))}" style="max-width: 100%"/>'

    def _repr_png_(self) -> bytes:
        return self.png

    def __repr__(self) -> str:
        count = len(self._runs)
        return f"<ptc_codegen.Picture of {count} run{'s' if count > 1 else ''} of {self._runs[-1].design.name}>"
