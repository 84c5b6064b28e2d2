"""Closed loops of a design, and their pictures."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ptc_codegen import _ptc
from ptc_codegen._design import Design, held
from ptc_codegen._errors import DesignWarning
from ptc_codegen._numbers import (
    array,
    doubles,
    inputs,
    known_units,
    real,
    statuses,
    vector,
    whole,
)
from ptc_codegen._picture import Picture
from ptc_codegen._progress import Progress, reporting
from ptc_codegen._results import Run

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


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

    ``progress`` is called with the number of instants that are done and of all; with True a bar shows them.
    What it raises stops the run, as Ctrl-C does.

    Raises `DesignError` for a value that is missing or illegal, and `RunError` where the loop leaves the
    range of numbers. Warns with `DesignWarning`.
    """
    own = held(design)
    start = vector(x0, "x0")
    if len(start) != len(design.states):
        names = ", ".join(design.states)
        legal = f"({len(design.states)},), one number for each of {names}"
        raise ValueError(f"x0 has shape ({len(start)},); legal: {legal}")
    fractions = None if at is None else vector(at, "at")
    end = None if until is None else real(until, "until")
    again = vector(arm_at, "arm_at")
    number = whole(seed, "seed")
    with reporting(progress, "simulate") as told_progress:
        told = _ptc.simulate(own, start, fractions, number, end, again, told_progress)
    for warning in told["warnings"]:
        warnings.warn(warning, DesignWarning, stacklevel=2)
    return _run(design, told, fractions is None)


def plot(runs: Run | Sequence[Run], *, labels: Sequence[str] | None = None, log: bool = False) -> Picture:
    """A picture of one or several runs of the same plant, as ``ptc-codegen simulate --plot`` draws it.

    ``labels`` name the runs in the legend, by default by their tau. With ``log`` the sizes of states and inputs
    are drawn, on logarithmic axes.

    Raises `DesignError` for runs that cannot be in one picture.
    """
    return Picture([runs] if isinstance(runs, Run) else runs, labels, log)


def _run(design: Design, told: Any, whole: bool) -> Run:
    """The run of plain values."""
    t = array(told["t"], -1)
    names = ["t", *told["states"], *told["inputs"]]
    return Run(
        design=design,
        tau=told["tau"],
        t0=told["t0"],
        states=tuple(told["states"]),
        inputs=tuple(told["inputs"]),
        units=known_units(names, ["s", *told["units"]]),
        whole=whole,
        t=t,
        stretched=array(told["stretched"], -1),
        x=array(told["x"], len(t), len(told["states"])),
        u=inputs(told["u"], len(t)),
        y=None if told["y"] is None else array(told["y"], len(t), -1),
        status=None if told["status"] is None else statuses(told["status"]),
        error=None if told["error"] is None else doubles(told["error"]),
    )
