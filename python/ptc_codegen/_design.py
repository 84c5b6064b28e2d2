"""Designs."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Union

from ptc_codegen import _ptc
from ptc_codegen._errors import DesignError, DesignWarning, RunError, mistake
from ptc_codegen._extras import needed
from ptc_codegen._numbers import vector

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from ptc_codegen._picture import Picture
    from ptc_codegen._widget import Explorer

    Value = Union[str, complex, Sequence[Any], NDArray[Any], np.generic, Mapping[str, Any]]


def readable(key: str, text: str) -> str:
    """A text that has an encoding."""
    try:
        text.encode()
    except UnicodeEncodeError as wrong:
        shown = ascii(text[wrong.start : wrong.start + 1])
        raise mistake(ascii(key)[1:-1], f"half a surrogate, {shown}", "give a text of Unicode") from None
    return text


def _text(key: str, value: Any) -> str:
    """A value as it is written in a design."""
    if hasattr(value, "tolist"):
        # Of NumPy: its numbers as those of Python.
        value = value.tolist()
    if isinstance(value, str):
        return readable(key, value)
    if isinstance(value, int) and not isinstance(value, bool):
        try:
            return str(value)
        except ValueError:
            # Python writes no more than some thousand digits.
            raise mistake(key, "too many digits", "round the number") from None
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, complex):
        return f"{value.real!r}{value.imag:+}i"
    if isinstance(value, Sequence) and not isinstance(value, (bytes, bytearray)):
        return "[" + ", ".join(_text(key, item) for item in value) + "]"
    kinds = "a text, a number, a sequence of these, or a mapping for a table"
    raise TypeError(f"{key} is of type {type(value).__name__}; legal: {kinds}")


def _flat(values: Mapping[str, Any], table: str = "") -> Iterator[tuple[str, str]]:
    for key, value in values.items():
        whole = readable("", f"{table}{key}")
        if isinstance(value, Mapping):
            yield from _flat(value, f"{whole}.")
        else:
            yield whole, _text(whole, value)


def given(values: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Keys with dots, and the texts of their values."""
    try:
        return list(_flat(values))
    except RecursionError:
        help = "give a list of numbers, or of such lists"
        raise mistake("", "a value that is nested too deeply, or holds itself", help) from None


class Design:
    """A controller with its plant and its objectives: what a design file holds.

    ``text`` is the text of a design file, TOML. Keywords are its keys, and override those in
    the text: texts, numbers, sequences of these, and mappings for tables. A design may be made of them
    alone::

        ptc_codegen.Design(n=2, mu="exp(a=1)", poles=[-4, -5], tau=0.8, eps=0.01, plant={"f": "-0.5*x2"})

    Units are those of the design, time in s.

    Raises `DesignError` with every mistake.
    """

    __slots__ = ("_card", "_own")

    def __init__(self, text: str = "", /, **keys: Value) -> None:
        self._own = _ptc.Design(readable("", text), given(keys))
        self._card: str | None = None

    @classmethod
    def load(cls, path: str | os.PathLike[str], /, **keys: Value) -> Design:
        """The design in a file; keywords as for the class."""
        design = cls.__new__(cls)
        try:
            name = os.fspath(path)
            os.fsencode(name)
        except UnicodeEncodeError:
            raise mistake("", f"no file is called {path!a}", "give the path of a file") from None
        return _of(design, _ptc.Design.load(name, given(keys)))

    def replace(self, **keys: Value) -> Design:
        """The design with other values of some keys, as for the class."""
        return _of(type(self).__new__(type(self)), self._own.replace(given(keys)))

    def __reduce__(self) -> tuple[Any, ...]:
        """A design is its text with its keywords, in another process too."""
        return _restored, (type(self), self._own.text, self._own.given)

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

    @property
    def fingerprint(self) -> str:
        """Fingerprint of the resolved design, as in the head of its emitted files."""
        return self._own.fingerprint()

    @property
    def chosen(self) -> dict[str, tuple[str, str]]:
        """Values that the design leaves open and the checks choose, each with the reason."""
        return {key: (value, reason) for key, value, reason in self._own.chosen()}

    def plot(self, x0: ArrayLike | None = None, *, log: bool = False, seed: int = 0) -> Picture:
        """Runs its closed loop from ``x0`` and draws it, as ``ptc-codegen simulate --plot`` does.

        Without ``x0`` the run begins at the bounds ``x0_max`` of the design, else at 1 in the first state.
        `simulate` has the numbers, and raises and warns alike.
        """
        from ptc_codegen._simulate import simulate

        return simulate(self, self._own.start() if x0 is None else x0, seed=seed).plot(log=log)

    def explore(self, x0: ArrayLike | None = None, **ranges: Any) -> Explorer:
        """A widget with a slider for each key: its picture and its verdicts follow.

        ``ranges`` are ``(lowest, highest)`` of keys that are numbers, for example ``tau=(0.2, 2)``, with mappings for
        tables as in the class: ``plant={"damping": (0.2, 0.6)}``. The widget holds its ``design``.

        Raises `ModuleNotFoundError` without anywidget.
        """
        needed("anywidget", "`explore`")
        from ptc_codegen._widget import Explorer

        return Explorer(self, x0, ranges)

    def _repr_html_(self) -> str:
        """Summary, picture and verdicts, as the library writes them."""
        if self._card is None:
            self._card = self.card()
        return self._card

    def card(self, x0: ArrayLike | None = None) -> str:
        """Summary, picture and verdicts as a fragment of HTML, which a notebook shows; ``x0`` as for `plot`."""
        start = self._own.start() if x0 is None else x0
        try:
            with warnings.catch_warnings():
                # The card has the verdicts that a run warns of.
                warnings.simplefilter("ignore", DesignWarning)
                shown = (self.plot(start).url, f"From x0 = ({', '.join(map(str, vector(start, 'x0')))}).")
        except (DesignError, RunError) as error:
            return _ptc.card(self._own, None, str(error))
        return _ptc.card(self._own, shown, "")

    def __repr__(self) -> str:
        return f"<ptc_codegen.Design {self.name}: {self.flags}>"


def held(design: Design) -> _ptc.Design:
    """What the library holds of a design."""
    if not isinstance(design, Design):
        legal = "a Design: Design(text), or Design.load(path) for a file"
        raise TypeError(f"design is of type {type(design).__name__}; legal: {legal}")
    return design._own


def _restored(cls: type[Design], text: str, keys: Sequence[tuple[str, str]]) -> Design:
    """The design of a text and of keywords that are texts already."""
    return _of(cls.__new__(cls), _ptc.Design(text, keys))


def _of(design: Design, own: _ptc.Design) -> Design:
    """A new design made of what the library holds of it."""
    design._own, design._card = own, None
    return design
