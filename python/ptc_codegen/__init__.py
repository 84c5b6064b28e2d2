"""Prescribed-time controllers: from a design to code, checks, simulations and verdicts.

    import ptc_codegen as ptc

    design = ptc.Design.load("roll.toml", tau=0.8)
    ptc.check(design).accepted
    ptc.emit(design, "c")["roll.c"]
    run = ptc.simulate(design, [0.1, 0.0])
    ptc.verify(design, seed=7).holds

In a notebook a design shows itself, ``run.plot()`` draws a run and ``design.explore(tau=(0.2, 2))`` has sliders.
The numbers are bit for bit those of the command ``ptc-codegen``, which comes with the package.
"""

from __future__ import annotations

from ptc_codegen._checks import check, emit
from ptc_codegen._design import Design
from ptc_codegen._errors import DesignError, DesignWarning, Mistake, RunError
from ptc_codegen._picture import Picture
from ptc_codegen._results import (
    Check,
    Objective,
    Part,
    Report,
    Run,
    Status,
    Trajectory,
    Verdict,
)
from ptc_codegen._simulate import plot, simulate
from ptc_codegen._verify import SIGNALS, merge, verify

__all__ = [
    "SIGNALS",
    "Check",
    "Design",
    "DesignError",
    "DesignWarning",
    "Mistake",
    "Objective",
    "Part",
    "Picture",
    "Report",
    "Run",
    "RunError",
    "Status",
    "Trajectory",
    "Verdict",
    "check",
    "emit",
    "merge",
    "plot",
    "simulate",
    "verify",
]
