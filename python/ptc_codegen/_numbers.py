"""Numbers on their way to the library and back."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ptc_codegen._errors import mistake
from ptc_codegen._extras import needed

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


def array(given: bytearray, *shape: int) -> NDArray[np.float64]:
    """The doubles of a buffer."""
    numpy = needed("numpy", "an array")
    values: NDArray[np.float64] = numpy.frombuffer(given, dtype=numpy.float64).reshape(shape)
    return values


def inputs(given: bytearray, instants: int) -> NDArray[np.float64]:
    """u, with an axis for the inputs where there are several."""
    each = array(given, instants, -1)
    return each[:, 0] if each.shape[1] == 1 else each


def doubles(given: Sequence[float]) -> NDArray[np.float64]:
    """An array of numbers."""
    numpy = needed("numpy", "an array")
    values: NDArray[np.float64] = numpy.array(given, dtype=numpy.float64)
    return values


def statuses(given: Sequence[int]) -> NDArray[np.int8]:
    """Values of `Status`."""
    numpy = needed("numpy", "an array")
    codes: NDArray[np.int8] = numpy.array(given, dtype=numpy.int8)
    return codes


def known_units(names: Sequence[str], units: Sequence[str | None]) -> dict[str, str]:
    """The units of those that have one."""
    return {name: unit for name, unit in zip(names, units) if unit is not None}


def vector(given: ArrayLike, name: str) -> Sequence[float]:
    """The numbers of something with one axis."""
    numpy = needed("numpy", name)
    try:
        numbers = numpy.asarray(given, dtype=numpy.float64)
    except (OverflowError, RecursionError):
        raise mistake(name, "not numbers within 1.7e308", "give numbers that a double holds") from None
    except ValueError:
        raise ValueError(f"{name} is not an array of numbers; legal: one axis, for example [1, 0]") from None
    if numbers.ndim != 1:
        raise ValueError(f"{name} has shape {numbers.shape}; legal: one axis")
    result: Sequence[float] = numbers.tolist()
    return result


def real(given: float, name: str) -> float:
    """A number as a double."""
    try:
        return float(given)
    except OverflowError:
        raise mistake(name, "not a number within 1.7e308", "give a number that a double holds") from None


def whole(given: int, name: str) -> int:
    """A number that is not negative and has 64 bits."""
    try:
        number = int(given)
    except OverflowError:
        number = -1
    if 0 <= number < 2**64:
        return number
    raise mistake(name, f"not a whole number from 0 to {2**64 - 1}", "give such a number")
