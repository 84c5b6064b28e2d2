"""
Prescribed-time controller stage45: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu exp --name stage45 --clock samples --delay-law=predict --precision f32 --guard none --eps=0 --delay=5
Version 0.1.0, design 494dc2a017da.

Plant: x1' = x2, x2' = u; u held from sample to sample, 5 samples late.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law of the state x predicted for the time from which u acts, by x and the inputs under way:
      with M + 5 samples to go and z = S x, u h^2 = sum of row_j z_j
      h^(j-1)/((M-j+1)...(M-1)); the rows are those of Theorem 1 for the mapping exp. Close
      to the end deadbeat takes over.

Parameters:
  samples [samples]: samples N from the start to rest
  h [s]: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a [1/s]: rate of stretched time
  k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
  k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
  deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard none: finite measurements are the responsibility of the caller.
Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
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

__all__ = ["Control", "Params", "Stage45", "Status"]

_R = np.float32
_WRAP = 0xFFFFFFFF
Array = NDArray[np.float32]

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

    u: np.float32
    """Input of the plant."""
    status: Status
    """Its Status."""

@dataclass(frozen=True, kw_only=True)
class Params:
    """Run-time parameters."""

    samples: int
    """samples N from the start to rest [samples], at least 7"""
    h: float
    """sample period [s], from 1e-18 to 1e18"""
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""
    a: float
    """rate of stretched time [1/s], from 1e-18 to 1e18"""
    k: Sequence[float]
    """gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite"""
    deadbeat: float
    """samples to go at which deadbeat takes over, 0 for a safe default [samples], finite"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Weight of u1 in the law.
_B_3 = _R(-_R(2.0))
# Weight of u2 in the law.
_B_4 = _R(-_R(3.0))
# Weight of u3 in the law.
_B_5 = _R(-_R(4.0))
# Weight of u4 in the law.
_B_6 = _R(-_R(5.0))
# Weight of u5 in the law.
_B_7 = _R(-_R(6.0))

class Stage45:
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
            given_k = _numbers(params.k, 2, "params.k")
            given_deadbeat = _R(params.deadbeat)
            if not (given_samples > 6):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 7")
            if not (_R(1.000000045813705e-18) <= given_h <= _R(9.999999843067494e17)):
                raise ValueError(f"params.h is {params.h}; legal: from 1.000000045813705e-18 to 9.999999843067494e17")
            if not (given_u_max > _R(0.0)):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not (_R(1.000000045813705e-18) <= given_a <= _R(9.999999843067494e17)):
                raise ValueError(f"params.a is {params.a}; legal: from 1.000000045813705e-18 to 9.999999843067494e17")
            if not np.isfinite(given_k[0]):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(given_k[1]):
                raise ValueError(f"params.k[1] is {params.k[1]}; legal: finite")
            if not (np.isfinite(given_deadbeat) and (given_deadbeat >= _R(0.0))):
                raise ValueError(f"params.deadbeat is {params.deadbeat}; legal: >= 0")
            samples = given_samples
            s1 = ((given_k[1] / given_a) - _R(1.0)) + _R(2.0)
            s2 = max(s1, _R(4.0))
            deadbeat = given_deadbeat if given_deadbeat > _R(0.0) else s2
            s3 = -(given_k[0] / (given_a * given_a))
            w1_1 = s3 * (_R(1.0) / (given_h * given_h))
            s4 = _R(4.5) * (-(given_k[0] / (given_a * given_a)))
            w1_2 = s4 * (_R(1.0) / given_h)
            w1_4 = -(given_k[0] / (given_a * given_a))
            w1_5 = _R(2.0) * (-(given_k[0] / (given_a * given_a)))
            w1_6 = _R(3.0) * (-(given_k[0] / (given_a * given_a)))
            w1_7 = _R(4.0) * (-(given_k[0] / (given_a * given_a)))
            w2_2 = (_R(1.0) - (given_k[1] / given_a)) * (_R(1.0) / given_h)
            w2_3 = _R(1.0) - (given_k[1] / given_a)
            b_1 = -(_R(1.0) / (given_h * given_h))
            b_2 = (-_R(6.5)) * (_R(1.0) / given_h)
            u_max = given_u_max
            if not (
                np.isfinite(deadbeat)
                and np.isfinite(w1_1)
                and np.isfinite(w1_2)
                and np.isfinite(w1_4)
                and np.isfinite(w1_5)
                and np.isfinite(w1_6)
                and np.isfinite(w1_7)
                and np.isfinite(w2_2)
                and np.isfinite(w2_3)
                and np.isfinite(b_1)
                and np.isfinite(b_2)
                and (given_h * given_h >= _R(1.0000000031710769e-30))
                and (_R(1.0) / (given_h * given_h) >= _R(1.0000000031710769e-30))
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._u3 = _R(0.0)
            self._u4 = _R(0.0)
            self._u5 = _R(0.0)
            self._deadbeat = deadbeat
            self._w1_1 = w1_1
            self._w1_2 = w1_2
            self._w1_4 = w1_4
            self._w1_5 = w1_5
            self._w1_6 = w1_6
            self._w1_7 = w1_7
            self._w2_2 = w2_2
            self._w2_3 = w2_3
            self._b_1 = b_1
            self._b_2 = b_2
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for each
        tick.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 2, "x")
            elapsed = (k - self._start) & _WRAP
            x1 = x[0]
            x2 = x[1]
            left = max(self._samples - elapsed, 0)
            m0 = _R(left) - _R(5.0)
            if m0 > self._deadbeat:
                # The exact law in samples.
                s1 = (self._w1_1 * x1) + (self._w1_2 * x2) + (self._w1_4 * self._u2)
                s2 = s1 + (self._w1_5 * self._u3) + (self._w1_6 * self._u4)
                z1 = s2 + (self._w1_7 * self._u5)
                s3 = (self._w2_2 * x2) + (self._w2_3 * self._u1)
                s4 = s3 + (self._w2_3 * self._u2) + (self._w2_3 * self._u3)
                z2 = s4 + (self._w2_3 * self._u4) + (self._w2_3 * self._u5)
                v = (z1 + (z2 * m0)) / (m0 * (m0 - _R(1.0)))
            else:
                # Deadbeat.
                s5 = (self._b_1 * x1) + (self._b_2 * x2) + (_B_3 * self._u1)
                s6 = s5 + (_B_4 * self._u2) + (_B_5 * self._u3)
                v = s6 + (_B_6 * self._u4) + (_B_7 * self._u5)
            if not np.isfinite(v):
                return Control(_R(0.0), Status.RANGE)
            if v > self._u_max:
                u_now = self._u_max
            elif v < -self._u_max:
                u_now = -self._u_max
            else:
                u_now = v
            self._u5 = self._u4
            self._u4 = self._u3
            self._u3 = self._u2
            self._u2 = self._u1
            self._u1 = u_now
            if (v > self._u_max) or (v < -self._u_max):
                return Control(u_now, Status.SATURATED)
            elif elapsed < self._samples:
                return Control(u_now, Status.OK)
            else:
                return Control(u_now, Status.HOLD)
