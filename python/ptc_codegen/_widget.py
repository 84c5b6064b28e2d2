"""A design with sliders, for notebooks.

The wheel is the engine: it computes where the notebook computes, and the browser draws what it gives. So the widget
has the version and the bits of all other functions, takes any design of the session, and hands one back; a page of
WebAssembly would have none of these, and a megabyte in each notebook.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import anywidget
import traitlets

from ptc_codegen._design import Design
from ptc_codegen._errors import DesignError, mistake
from ptc_codegen._numbers import vector

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

# Ranges of more than this ratio have a logarithmic slider.
_WIDE = 20.0


def _flat(ranges: Mapping[str, Any], table: str = "") -> Iterator[tuple[str, Any]]:
    for key, value in ranges.items():
        if isinstance(value, Mapping):
            yield from _flat(value, f"{table}{key}.")
        else:
            yield f"{table}{key}", value


def _knob(design: Design, key: str, ends: Any) -> dict[str, Any]:
    """A slider from one end to the other, which begins at the value of the design."""
    numbers = vector(ends, key)
    if len(numbers) != 2 or not numbers[0] < numbers[1]:
        raise mistake(key, f"{ends!r} is no range", "give (lowest, highest), for example tau=(0.2, 2)")
    low, high = numbers
    wide = low > 0 and high > _WIDE * low
    value = design._own.number(key)
    if value is None or not low <= value <= high:
        value = (low * high) ** 0.5 if wide else 0.5 * (low + high)
    whole = all(isinstance(end, int) for end in ends)
    return {"key": key, "low": low, "high": high, "value": float(f"{value:.3g}"), "wide": wide, "whole": whole}


class Explorer(anywidget.AnyWidget):
    """Sliders for keys of a design, and its card."""

    _esm = Path(__file__).with_name("_widget.js")
    _css = Path(__file__).with_name("_widget.css")

    knobs: traitlets.List[Any] = traitlets.List().tag(sync=True)
    asked: traitlets.Dict[str, Any] = traitlets.Dict().tag(sync=True)
    """A number of the request, and the values of the keys."""
    answered = traitlets.Int(0).tag(sync=True)
    """The number of the last request that is answered."""
    html = traitlets.Unicode("").tag(sync=True)

    def __init__(self, design: Design, x0: ArrayLike | None, ranges: Mapping[str, Any]) -> None:
        self.design = design
        """The design with the values of the sliders; of values that are refused the last one before."""
        self._x0 = x0
        knobs = [_knob(design, key, ends) for key, ends in _flat(ranges)]
        if not knobs:
            raise mistake("", "no key to explore", "give a range, for example tau=(0.2, 2)")
        super().__init__(knobs=knobs)
        self.observe(self._answer, "asked")
        self.asked = {"number": 1, "values": {knob["key"]: knob["value"] for knob in knobs}}

    def _answer(self, change: Any) -> None:
        asked = change["new"]
        try:
            own = self.design.replace(**asked["values"])
            self.html = own.card(self._x0)
            self.design = own
        except (DesignError, ValueError) as error:
            self.html = f'<pre class="ptc-wrong">{escape(str(error))}</pre>'
        self.answered = asked["number"]
