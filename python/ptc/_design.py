"""Designs."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Union

from ptc import _ptc

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Value = Union[str, complex, Sequence[Any], NDArray[Any], np.generic, Mapping[str, Any]]


def _text(key: str, value: Any) -> str:
    """A value as it is written in a design."""
    if hasattr(value, "tolist"):
        # Of NumPy: its numbers as those of Python.
        value = value.tolist()
    if isinstance(value, str):
        return value
    if isinstance(value, int) and not isinstance(value, bool):
        return str(value)
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, complex):
        return f"{value.real!r}{value.imag:+}i"
    if isinstance(value, Sequence) and not isinstance(value, (bytes, bytearray)):
        return "[" + ", ".join(_text(key, item) for item in value) + "]"
    kinds = "a text, a number, a sequence of these, or a mapping for a table"
    raise TypeError(f"{key} is of type {type(value).__name__}; legal: {kinds}")


def given(values: Mapping[str, Any], table: str = "") -> Iterator[tuple[str, str]]:
    """Keys with dots, and the texts of their values."""
    for key, value in values.items():
        whole = f"{table}{key}"
        if isinstance(value, Mapping):
            yield from given(value, f"{whole}.")
        else:
            yield whole, _text(whole, value)


class Design:
    """A controller with its plant and its objectives: what a design file holds.

    ``text`` is the text of a design file, TOML. Keywords are its keys, and override those in
    the text: texts, numbers, sequences of these, and mappings for tables. A design may be made of them
    alone::

        ptc.Design(n=2, mu="exp(a=1)", poles=[-4, -5], tau=0.8, eps=0.01, plant={"f": "-0.5*x2"})

    Units are those of the design, time in s.

    Raises `DesignError` with every mistake.
    """

    __slots__ = ("_own",)

    def __init__(self, text: str = "", /, **keys: Value) -> None:
        self._own = _ptc.Design(text, list(given(keys)))

    @classmethod
    def load(cls, path: str | os.PathLike[str], /, **keys: Value) -> Design:
        """The design in a file; keywords as for the class."""
        design = cls.__new__(cls)
        design._own = _ptc.Design.load(path, list(given(keys)))
        return design

    @property
    def name(self) -> str:
        """Name of the controller."""
        return self._own.name

    @property
    def states(self) -> tuple[str, ...]:
        """Names of the states of the plant, in the order of ``x0``."""
        return tuple(self._own.states)

    @property
    def flags(self) -> str:
        """The flags with which ``ptc-codegen emit`` makes the same controller."""
        return self._own.command

    def __repr__(self) -> str:
        return f"<ptc.Design {self.name}: {self.flags}>"
