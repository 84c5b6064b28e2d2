"""
Prescribed-time controller stage0: order n = 1, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 1 --mu exp --name stage0 --clock samples --eps=0
Version 0.1.0, design 14ec59d52490.

Plant: x1' = u; u held from sample to sample.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M samples to go and z = S x, u h^1 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-0));
      the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
      over.

Parameters:
  samples [samples]: samples N from the start to rest
  h [s]: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a [1/s]: rate of stretched time
  k_1 [1/s]: gains k_i of pi0 = -sum k_i xi_i
  deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample N from any state, whatever the poles, and |u| is bounded.
  sampling: not checked: the law is exact in samples, at any period.
  deadline: not checked: the law is exact in samples, at any period.
  loop: not checked: `samples` is left to run time.
  envelope: not checked: it does not examine a clock in samples.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Params", "Stage0", "Status"]

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

    samples: int
    """samples N from the start to rest [samples], at least 1"""
    h: float
    """sample period [s], from 1e-150 to 1e150"""
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""
    a: float
    """rate of stretched time [1/s], from 1e-150 to 1e150"""
    k: Sequence[float]
    """gains k_i of pi0 = -sum k_i xi_i [1/s], finite"""
    deadbeat: float
    """samples to go at which deadbeat takes over, 0 for a safe default [samples], finite"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

class Stage0:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_samples = params.samples.__index__()
            if given_samples != given_samples & _WRAP:
                raise ValueError(f"params.samples is {params.samples}; legal: 0..2^32 - 1")
            given_h = _R(params.h)
            given_u_max = _R(params.u_max)
            given_a = _R(params.a)
            given_k = _numbers(params.k, 1, "params.k")
            given_deadbeat = _R(params.deadbeat)
            if not (given_samples > 0):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 1")
            if not (1e-150 <= given_h <= 1e150):
                raise ValueError(f"params.h is {params.h}; legal: from 1e-150 to 1e150")
            if not (given_u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not (1e-150 <= given_a <= 1e150):
                raise ValueError(f"params.a is {params.a}; legal: from 1e-150 to 1e150")
            if not np.isfinite(given_k[0]):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not (np.isfinite(given_deadbeat) and (given_deadbeat >= 0.0)):
                raise ValueError(f"params.deadbeat is {params.deadbeat}; legal: >= 0")
            samples = given_samples
            s1 = (given_k[0] / given_a) + 1.0
            s2 = max(s1, _R(2.0))
            deadbeat = given_deadbeat if given_deadbeat > 0.0 else s2
            w1_1 = (-(given_k[0] / given_a)) * (1.0 / given_h)
            b_1 = -(1.0 / given_h)
            u_max = given_u_max
            if not (np.isfinite(deadbeat) and np.isfinite(w1_1) and np.isfinite(b_1)):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            if not (given_h >= 1e-200):
                raise ValueError(f"params.h is {params.h}; legal: >= 1e-200")
            if not (1.0 / given_h >= 1e-200):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._deadbeat = deadbeat
            self._w1_1 = w1_1
            self._b_1 = b_1
            self._u_max = u_max

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
            x = _numbers(x, 1, "x")
            if not np.isfinite(x[0]):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP
            x1 = x[0]
            left = max(self._samples - elapsed, 0)
            m0 = _R(left)
            if m0 > self._deadbeat:
                # The exact law in samples.
                z1 = self._w1_1 * x1
                v = z1 / m0
            else:
                # Deadbeat.
                v = self._b_1 * x1
            if np.isfinite(v):
                if v > self._u_max:
                    return Control(self._u_max, Status.SATURATED)
                elif v < -self._u_max:
                    return Control(-self._u_max, Status.SATURATED)
                elif elapsed < self._samples:
                    return Control(v, Status.OK)
                else:
                    return Control(v, Status.HOLD)
            else:
                return Control(_R(0.0), Status.RANGE)
