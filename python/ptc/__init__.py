"""Prescribed-time controllers: from a design to code, checks, simulations and verdicts.

    design = ptc.Design.load("roll.toml", tau=0.8)
    ptc.check(design).accepted
    ptc.emit(design, "c")["roll.c"]
    run = ptc.simulate(design, [0.1, 0.0])
    ptc.verify(design, seed=7).holds

The numbers are bit for bit those of the command ``ptc-codegen``, which comes with the package.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, overload

from ptc import _ptc
from ptc._design import Design, readable
from ptc._errors import DesignError, DesignWarning, Mistake, RunError, mistake
from ptc._results import (
    Check,
    Objective,
    Part,
    Report,
    Run,
    Status,
    Trajectory,
    Verdict,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    Progress = Callable[[int, int], object]

__all__ = [
    "Check",
    "Design",
    "DesignError",
    "DesignWarning",
    "Mistake",
    "Objective",
    "Part",
    "Report",
    "Run",
    "RunError",
    "Status",
    "Trajectory",
    "Verdict",
    "check",
    "emit",
    "merge",
    "simulate",
    "verify",
]


def _array(given: bytearray, *shape: int) -> NDArray[np.float64]:
    """The doubles of a buffer."""
    import numpy as np

    return np.frombuffer(given, dtype=np.float64).reshape(shape)


def _inputs(given: bytearray, instants: int) -> NDArray[np.float64]:
    """u, with an axis for the inputs where there are several."""
    each = _array(given, instants, -1)
    return each[:, 0] if each.shape[1] == 1 else each


def _vector(given: ArrayLike, name: str) -> Sequence[float]:
    """The numbers of something with one axis."""
    import numpy as np

    try:
        numbers = np.asarray(given, dtype=np.float64)
    except (OverflowError, RecursionError):
        raise mistake(name, "not numbers within 1.7e308", "give numbers that a double holds") from None
    if numbers.ndim != 1:
        raise ValueError(f"{name} has shape {numbers.shape}; legal: one axis")
    result: Sequence[float] = numbers.tolist()
    return result


def _real(given: float, name: str) -> float:
    """A number as a double."""
    try:
        return float(given)
    except OverflowError:
        raise mistake(name, "not a number within 1.7e308", "give a number that a double holds") from None


def _whole(given: int, name: str) -> int:
    """A number that is not negative and has 64 bits."""
    try:
        number = int(given)
    except OverflowError:
        number = -1
    if 0 <= number < 2**64:
        return number
    raise mistake(name, f"not a whole number from 0 to {2**64 - 1}", "give such a number")


def emit(design: Design, lang: str = "c", *, selftest: bool = False) -> dict[str, str]:
    """The source files of a controller: their texts by their names.

    ``lang`` is ``c``, ``rust``, ``cpp``, ``matlab``, ``python``, ``st`` or ``plcopen``. With ``selftest``
    its self-test in C is among them.

    Raises `DesignError` for checks that refuse the design, and for what the language cannot express.
    """
    return dict(_ptc.emit(design._own, readable("lang", lang), selftest))


def check(design: Design) -> Report:
    """What every check says of a design. A design that is refused is no error here."""
    checks, refused, undecided, verdict, margins = _ptc.check(design._own)
    return Report(
        name=design.name,
        accepted=not refused,
        verdict=verdict,
        undecided=tuple(undecided),
        margins=margins,
        checks=tuple(
            Check(name, verdict, summary, tuple(details), fix, name in refused)
            for name, verdict, summary, details, fix in checks
        ),
    )


def simulate(
    design: Design,
    x0: ArrayLike,
    *,
    at: ArrayLike | None = None,
    seed: int = 0,
    until: float | None = None,
    arm_at: ArrayLike = (),
    progress: Progress | None = None,
) -> Run:
    """Runs the closed loop of a design with its plant from the states ``x0``, shape (n,).

    The law acts at every instant, for a model the emitted controller, and time-to-go falls to 1e-9 tau.
    If ``sample_time`` is a keyword of `Design`, or the design has noise, a resolution, a delay or a
    clock in samples, the emitted controller itself is in the loop, bit for bit, and u is held between
    the samples.

    ``at`` are fractions of tau in [0, 1), at which alone to report; the sampled loop reports every
    sample. Of the sampled loop, ``seed`` is that of the noise, ``until`` the time after t0 in s at
    which the run ends, tau unless it is given, and ``arm_at`` are times after t0 in s, at whose next
    samples the controller is armed again.

    ``progress`` is called with the number of instants that are done and of all. What it raises stops
    the run, as Ctrl-C does.

    Raises `DesignError` for a value that is missing or illegal, and `RunError` where the loop leaves the
    range of numbers. Warns with `DesignWarning`.
    """
    import numpy as np

    start = _vector(x0, "x0")
    if len(start) != len(design.states):
        names = ", ".join(design.states)
        legal = f"({len(design.states)},), one number for each of {names}"
        raise ValueError(f"x0 has shape ({len(start)},); legal: {legal}")
    fractions = None if at is None else _vector(at, "at")
    end = None if until is None else _real(until, "until")
    again = _vector(arm_at, "arm_at")
    number = _whole(seed, "seed")
    told = _ptc.simulate(design._own, start, fractions, number, end, again, progress)
    for warning in told["warnings"]:
        warnings.warn(warning, DesignWarning, stacklevel=2)
    t = _array(told["t"], -1)
    return Run(
        tau=told["tau"],
        t0=told["t0"],
        states=tuple(told["states"]),
        inputs=tuple(told["inputs"]),
        t=t,
        x=_array(told["x"], len(t), len(told["states"])),
        u=_inputs(told["u"], len(t)),
        y=None if told["y"] is None else _array(told["y"], len(t), -1),
        status=None if told["status"] is None else np.array(told["status"], dtype=np.int8),
        error=None if told["error"] is None else np.array(told["error"]),
    )


@overload
def verify(
    design: Design,
    *,
    scenarios: int | None = None,
    seed: int | None = None,
    draws: bool = False,
    shard: None = None,
    progress: Progress | None = None,
) -> Verdict: ...


@overload
def verify(
    design: Design,
    *,
    scenarios: int | None = None,
    seed: int | None = None,
    draws: bool = False,
    shard: tuple[int, int],
    progress: Progress | None = None,
) -> Part: ...


def verify(
    design: Design,
    *,
    scenarios: int | None = None,
    seed: int | None = None,
    draws: bool = False,
    shard: tuple[int, int] | None = None,
    progress: Progress | None = None,
) -> Verdict | Part:
    """Verifies the objectives of a design for all that is uncertain, as it says under ``[verify]``.

    ``scenarios`` and ``seed`` override the design's. With ``draws`` the verdict holds all
    draws, 8 bytes a number. With ``shard = (i, n)`` the draws of the i-th of n parts alone are run, here
    or on another machine, and `merge` makes the verdict of all parts.

    ``progress`` is called with the number of runs that are done and the most that there may be, at most
    20 times a second, from the thread that called, and with the two equal in the end. What it raises
    stops the campaign, as Ctrl-C does.

    Raises `DesignError` for mistakes in the campaign, and for objectives that no control can keep.
    """
    given = _campaign(scenarios, seed)
    if shard is None:
        return _verdict(_ptc.verify(design._own, given, draws, progress))
    index, count = (_whole(number, "shard") for number in shard)
    start, stop, of, numbers = _ptc.part(design._own, given, (index, count), progress)
    return Part(start=start, stop=stop, campaign=of, numbers=bytes(numbers))


def merge(
    design: Design,
    parts: Sequence[Part],
    *,
    scenarios: int | None = None,
    seed: int | None = None,
    draws: bool = False,
    progress: Progress | None = None,
) -> Verdict:
    """The verdict of a campaign whose draws were run in parts, in any order: that of `verify` in one piece.

    ``scenarios`` and ``seed`` are those of the parts. Raises `DesignError` for a part that is missing, is
    there twice or is of another campaign.
    """
    own = [(part.start, part.stop, part.campaign, part.numbers) for part in parts]
    return _verdict(_ptc.merge(design._own, _campaign(scenarios, seed), own, draws, progress))


def _campaign(scenarios: int | None, seed: int | None) -> list[tuple[str, str]]:
    """What overrides the campaign of a design."""
    keys = [("scenarios", scenarios), ("seed", seed)]
    return [(f"verify.{key}", str(_whole(value, key))) for key, value in keys if value is not None]


def _verdict(told: Any) -> Verdict:
    """The verdict of plain values."""
    worst = told["worst"]
    trajectory = None
    if worst is not None:
        t = _array(worst["t"], -1)
        trajectory = Trajectory(
            scenario=worst["scenario"],
            t=t,
            time_to_go=_array(worst["time_to_go"], len(t)),
            x=_array(worst["x"], len(t), worst["states"]),
            u=_inputs(worst["u"], len(t)),
            excess=_array(worst["excess"], len(t), len(told["objectives"])),
            ended=worst["ended"],
        )
    rows = None
    if told["rows"] is not None:
        table = _array(told["rows"], -1, len(told["columns"]))
        rows = {name: table[:, place] for place, name in enumerate(told["columns"])}
    return Verdict(
        holds=told["holds"],
        objectives=tuple(
            Objective(
                text=one["text"],
                holds=one["holds"],
                verdict=one["verdict"],
                excess=one["excess"],
                worst=one["worst"],
                details=tuple(one["details"]),
            )
            for one in told["objectives"]
        ),
        worst=trajectory,
        draws=rows,
        text=told["text"],
    )
