"""Campaigns of a design."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, overload

from ptc_codegen import _ptc
from ptc_codegen._design import Design, held
from ptc_codegen._numbers import array, inputs, known_units, whole
from ptc_codegen._progress import Progress, reporting
from ptc_codegen._results import Objective, Part, Trajectory, Verdict

SIGNALS: tuple[str, ...] = tuple(_ptc.signals())
"""Names of the signals of a disturbance; the columns ``NAME.signal`` of draws hold their places here."""


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
    20 times a second, from the thread that called, and with the two equal in the end; with True a bar shows
    them. What it raises stops the campaign, as Ctrl-C does.

    Raises `DesignError` for mistakes in the campaign, and for objectives that no control can keep.
    """
    given = _campaign(scenarios, seed)
    with reporting(progress, "verify") as told:
        if shard is None:
            return _verdict(_ptc.verify(held(design), given, draws, told))
        index, count = (whole(number, "shard") for number in shard)
        start, stop, of, numbers = _ptc.part(held(design), given, (index, count), told)
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
    with reporting(progress, "merge") as told:
        return _verdict(_ptc.merge(held(design), _campaign(scenarios, seed), own, draws, told))


def _campaign(scenarios: int | None, seed: int | None) -> list[tuple[str, str]]:
    """What overrides the campaign of a design."""
    keys = [("scenarios", scenarios), ("seed", seed)]
    return [(f"verify.{key}", str(whole(value, key))) for key, value in keys if value is not None]


def _verdict(told: Any) -> Verdict:
    """The verdict of plain values."""
    worst = told["worst"]
    trajectory = None
    if worst is not None:
        t = array(worst["t"], -1)
        trajectory = Trajectory(
            scenario=worst["scenario"],
            t=t,
            time_to_go=array(worst["time_to_go"], len(t)),
            x=array(worst["x"], len(t), worst["states"]),
            u=inputs(worst["u"], len(t)),
            excess=array(worst["excess"], len(t), len(told["objectives"])),
            ended=worst["ended"],
            states=tuple(told["states"]),
            inputs=tuple(told["inputs"]),
            units=known_units(["t", "time_to_go", *told["states"], *told["inputs"]], ["s", "s", *told["units_of_run"]]),
        )
    rows = None
    if told["rows"] is not None:
        table = array(told["rows"], -1, len(told["columns"]))
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
        units=known_units(told["columns"], told["units"]),
        text=told["text"],
    )
