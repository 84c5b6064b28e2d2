"""What the functions of the package give."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from html import escape
from typing import TYPE_CHECKING

from ptc_codegen._picture import Picture
from ptc_codegen._tables import beside, frame

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd
    from numpy.typing import NDArray

    from ptc_codegen._design import Design

    Array = NDArray[np.float64]


class Status(IntEnum):
    """Status of a call of the emitted controller; u is 0 on a negative one."""

    OK = 0
    """Tracking."""
    HOLD = 1
    """Time-to-go is held at eps."""
    SATURATED = 2
    """u was clipped to its limits."""
    AFTER = 3
    """The deadline is over."""
    GATED = 4
    """A reading was not believed: u by prediction alone."""
    LATE = 5
    """The deadline was put off, as a limit would have been exceeded."""
    INFEASIBLE = 6
    """Nothing is known from here that keeps all limits or bounds; u is valid."""
    PARAM = -1
    """A parameter is outside its domain."""
    INPUT = -2
    """x or t is not finite, or t is before t0."""
    RANGE = -3
    """u is not finite."""
    SOON = -4
    """A deadline is too soon for the limits, or none keeps them."""


@dataclass(frozen=True)
class Check:
    """What one check says of a design."""

    name: str
    """Name of the check."""
    verdict: str
    """``sound``, ``unsound``, ``refuted``, ``undecided`` or ``not checked``."""
    summary: str
    """What is wrong, or that nothing is, with its numbers."""
    details: tuple[str, ...]
    """Further facts, a sentence each."""
    fix: str | None
    """What would put it right."""
    refuses: bool
    """Whether it refuses the design."""


@dataclass(frozen=True)
class Part:
    """The draws of a part of a campaign, which `merge` takes: it can be pickled."""

    start: int
    """Index of the first draw."""
    stop: int
    """Index of the first draw that is not of it."""
    campaign: str
    """Hash of the campaign that it is of, and of the version of the engine."""
    numbers: bytes = field(repr=False)
    """The numbers of all draws, each a double."""


@dataclass(frozen=True)
class Report:
    """What all checks say of a design."""

    name: str
    """Name of the controller."""
    accepted: bool
    """Whether no check refuses it, so that code can be emitted."""
    verdict: str
    """The last line of the command's report: what is refused, or what an acceptance leaves open."""
    undecided: tuple[str, ...]
    """Names of the checks that could not be decided."""
    margins: str
    """Input gains, delays and resonances for which the loop with its final gains is stable, or why they are unknown."""
    checks: tuple[Check, ...]
    """All of them."""

    def frame(self) -> pd.DataFrame:
        """The checks as a table of pandas: name, verdict, summary, fix, refuses."""
        keys = ["name", "verdict", "summary", "fix", "refuses"]
        return frame({key: [getattr(check, key) for check in self.checks] for key in keys}, {}, False)

    def __getitem__(self, name: str) -> Check:
        """The check of a name."""
        for check in self.checks:
            if check.name == name:
                return check
        names = ", ".join(check.name for check in self.checks)
        raise KeyError(f"no check `{name}`; the checks are {names}")


@dataclass(frozen=True, eq=False)
class Run:
    """One closed loop, with k instants of n states."""

    design: Design
    """Its design."""
    tau: float
    """Settling time [s]."""
    t0: float
    """Start time [s]."""
    states: tuple[str, ...]
    """Names of the states."""
    inputs: tuple[str, ...]
    """Names of the inputs."""
    units: dict[str, str] = field(repr=False)
    """Units of t, of states and of inputs by their names; those that the design does not tell are missing."""
    whole: bool = field(repr=False)
    """Whether the instants are those of the whole run, not of ``at``."""
    t: Array = field(repr=False)
    """Times [s], shape (k,)."""
    stretched: Array = field(repr=False)
    """Stretched times since the start [s], shape (k,); NaN where they are not computed."""
    x: Array = field(repr=False)
    """States of the plant in their units, shape (k, n)."""
    u: Array = field(repr=False)
    """Input, as it acts on the plant from t on, in its unit, shape (k,); of a plant with m inputs (k, m)."""
    y: Array | None = field(repr=False)
    """Measurements of the sampled loop, shape (k, m); None if the law acts at every instant."""
    status: NDArray[np.int8] | None = field(repr=False)
    """Values of `Status`, shape (k,); None if no emitted controller is in the loop."""
    error: Array | None = field(repr=False)
    """Tracking error and its derivatives at the last instant, shape (n,); None without a reference."""

    def __len__(self) -> int:
        return len(self.t)

    @property
    def held(self) -> bool:
        """Whether the loop is sampled, and u is held between the instants."""
        return self.y is not None

    def frame(self, *, labelled: bool = False) -> pd.DataFrame:
        """A table of pandas: t, states, inputs, and of the sampled loop its measurements y1.. and status.

        ``attrs["units"]`` holds the units; with ``labelled`` the names of the columns have them too: ``x1 [m]``.
        """
        columns = {"t": self.t, **beside(self.states, self.x), **beside(self.inputs, self.u)}
        if self.y is not None:
            columns.update(beside(tuple(f"y{place + 1}" for place in range(self.y.shape[1])), self.y))
        if self.status is not None:
            columns["status"] = self.status
        return frame(columns, self.units, labelled)

    def plot(self, *, log: bool = False) -> Picture:
        """Its picture, as ``ptc-codegen simulate --plot`` draws it; `ptc_codegen.plot` draws several runs."""
        return Picture([self], None, log)

    def _repr_html_(self) -> str:
        return self.plot()._repr_html_() if self.whole else f"<pre>{escape(repr(self))}</pre>"


@dataclass(frozen=True)
class Objective:
    """The verdict on one objective."""

    text: str
    """The objective."""
    holds: bool | None
    """Whether it holds for all that is uncertain; None if that is undecided."""
    verdict: str
    """The same in words: proved, by sampling, fails or undecided."""
    excess: float
    """The largest excess over the objective; positive fails. Of a bound of |x|
    or |u| as a part of the bound, of others in the unit of their expression."""
    worst: str
    """The scenario in which it was met; ``ptc-codegen verify DESIGN --scenario TEXT`` runs it again."""
    details: tuple[str, ...] = field(repr=False)
    """What the verdict was made of, a sentence each."""


@dataclass(frozen=True, eq=False)
class Trajectory:
    """The worst trajectory of a campaign, with k instants of n states and m objectives."""

    scenario: str
    """Its scenario, in words."""
    t: Array = field(repr=False)
    """Times [s], shape (k,)."""
    time_to_go: Array = field(repr=False)
    """Time-to-go [s], shape (k,)."""
    x: Array = field(repr=False)
    """States, shape (k, n)."""
    u: Array = field(repr=False)
    """Input, shape (k,); of a plant with m inputs (k, m)."""
    excess: Array = field(repr=False)
    """Excess over each objective, shape (k, m); positive fails."""
    ended: str | None
    """Why it ends early, if it does."""
    states: tuple[str, ...] = field(repr=False)
    """Names of the states."""
    inputs: tuple[str, ...] = field(repr=False)
    """Names of the inputs."""
    units: dict[str, str] = field(repr=False)
    """Units of times, states and inputs by their names, as far as the design tells them."""

    def frame(self, *, labelled: bool = False) -> pd.DataFrame:
        """A table of pandas, as `Run.frame`: t, time_to_go, states, inputs, and the excess over each objective."""
        columns = {"t": self.t, "time_to_go": self.time_to_go}
        columns.update({**beside(self.states, self.x), **beside(self.inputs, self.u)})
        columns.update(beside(tuple(f"excess{place + 1}" for place in range(self.excess.shape[1])), self.excess))
        return frame(columns, self.units, labelled)


@dataclass(frozen=True, eq=False)
class Verdict:
    """What a campaign comes to."""

    holds: bool | None
    """Whether every objective holds; None if none fails and one is undecided."""
    objectives: tuple[Objective, ...]
    """One for each objective, in the order of the design."""
    worst: Trajectory | None
    """The worst trajectory of the objective with the largest excess."""
    draws: dict[str, Array] | None = field(repr=False)
    """The draws by column, shape (scenarios,) each, if they were asked for: what was drawn, with the signal of
    each disturbance, the excess of each objective, and the status."""
    units: dict[str, str] = field(repr=False)
    """Units of the columns of ``draws``, as far as the design tells them."""
    text: str = field(repr=False)
    """The report, as ``ptc-codegen verify`` prints it."""

    def frame(self, *, labelled: bool = False) -> pd.DataFrame:
        """The draws as a table of pandas, one row for each, as `Run.frame`.

        Raises `ValueError` without draws.
        """
        if self.draws is None:
            raise ValueError("the verdict holds no draws: give draws=True to `verify` or `merge`")
        return frame(self.draws, self.units, labelled)

    def __str__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        return f"<pre>{escape(self.text)}</pre>"
