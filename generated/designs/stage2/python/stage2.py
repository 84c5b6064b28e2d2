"""
Prescribed-time controller stage2: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name stage2 --clock samples --guard none --tau=0.02 --eps=0 --u-max=inf --poles=-4,-5,-6 --sample-time=1e-3
Version 0.1.0, design 75680df23c07.

Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
      h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
      gains of 3 samples to go stay: they are deadbeat.

Parameters:
  samples = 20 [samples], fixed: samples N from the start to rest
  h = 1e-3 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max = inf [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
u is not clipped.
Guard none: finite measurements are the responsibility of the caller.
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample 20 from any state, whatever the poles, and |u| is
      bounded.
  sampling: not checked: the law is exact in samples, at any period.
  deadline: not checked: the law is exact in samples, at any period.
  loop: not checked: `x0_max` is not given.
  envelope: not checked: it does not examine a clock in samples.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Params", "Stage2", "Status"]

_R = np.float64
_WRAP = 0xFFFFFFFF
Array = NDArray[np.float64]

class Status(IntEnum):
    """Status of u, which is 0 on a negative status."""

    OK = 0
    """Tracking."""
    HOLD = 1
    """Time-to-go is held at eps: the deadline is near or over, u is valid."""
    SATURATED = 2
    """u was clipped to its limits; wins over HOLD and AFTER."""
    AFTER = 3
    """The deadline is over: u is 0 or that of the user-defined law."""
    GATED = 4
    """A reading was not believed: u by prediction alone; wins over all above."""
    LATE = 5
    """The deadline was put off, as a limit would have been exceeded."""
    INFEASIBLE = 6
    """Nothing is known from here that keeps all limits or bounds; u is valid."""
    INPUT = -2
    """x or t is not finite, or t is before t0."""
    RANGE = -3
    """u is not finite."""
    SOON = -4
    """A deadline is too soon for the limits, or none keeps them."""

class Control(NamedTuple):
    """Result of a step."""

    u: np.float64
    """Input of the plant."""
    status: Status
    """Its Status."""

@dataclass(frozen=True, kw_only=True)
class Params:
    """Run-time parameters."""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Weight of x1 in the law.
_W1_1 = _R(-120000000000.0)
# Weight of x2 in the law.
_W1_2 = _R(120000000.0)
# Weight of x3 in the law.
_W1_3 = _R(-40000.0)
# Weight of x2 in the law.
_W2_2 = _R(-60000000.0)
# Weight of x3 in the law.
_W2_3 = _R(30000.0)
# Weight of x3 in the law.
_W3_3 = _R(-12000.0)
# Samples from the start to rest.
_SAMPLES = 20

class Stage2:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            self._start = 0

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`."""
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and the state x = (x1, x1', ...).

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 3, "x")
            elapsed = (k - self._start) & _WRAP
            x1 = x[0]
            x2 = x[1]
            x3 = x[2]

            # The exact law in samples.
            m0 = _R((23 - elapsed) & _WRAP) if elapsed < 17 else _R(6.0)
            z1 = (_W1_1 * x1) + (_W1_2 * x2) + (_W1_3 * x3)
            z2 = (_W2_2 * x2) + (_W2_3 * x3)
            z3 = _W3_3 * x3
            m0f2 = m0 * (m0 - 1.0)
            v = (z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0))
            if np.isfinite(v):
                if elapsed < _SAMPLES:
                    return Control(v, Status.OK)
                else:
                    return Control(v, Status.HOLD)
            else:
                return Control(_R(0.0), Status.RANGE)
