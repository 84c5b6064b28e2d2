"""
Prescribed-time controller stage5: order n = 4, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 4 --mu exp --name stage5 --clock samples --guard none --eps=0.01 --delay=2
Version 0.1.0, design af29f716abf2.

Plant: x1' = x2, ..., x4' = u; u held from sample to sample, 2 samples late.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M samples to go and z = S x, u h^6 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-5));
      the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
      over.

Parameters:
  samples [samples]: samples N from the start to rest
  h [s]: sample period
  eps = 0.01 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a [1/s]: rate of stretched time
  k_1 [1/s^6]: gains k_i of pi0 = -sum k_i xi_i
  k_2 [1/s^5]: gains k_i of pi0 = -sum k_i xi_i
  k_3 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
  k_4 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
  k_5 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
  k_6 [1/s]: gains k_i of pi0 = -sum k_i xi_i
  deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard none: finite measurements are the responsibility of the caller.
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

__all__ = ["Control", "Params", "Stage5", "Status"]

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
    """samples N from the start to rest [samples], at least 6"""
    h: float
    """sample period [s], from 1e-150 to 1e150"""
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""
    a: float
    """rate of stretched time [1/s], from 1e-150 to 1e150"""
    k: Sequence[float]
    """gains k_i of pi0 = -sum k_i xi_i [1/s^6], finite"""
    deadbeat: float
    """samples to go at which deadbeat takes over, 0 for a safe default [samples], finite"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# 11/2, samples to go at which deadbeat takes over.
_DEADBEAT = _R(5.5)
# Weight of u1 in the law.
_C_5 = _R(2.0)
# Weight of u1 in the law.
_B_5 = _R(-4.0)
# Weight of u2 in the law.
_B_6 = _R(-10.0)

class Stage5:
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
            given_k = _numbers(params.k, 6, "params.k")
            given_deadbeat = _R(params.deadbeat)
            if not (given_samples > 5):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 6")
            if not (1e-150 <= given_h <= 1e150):
                raise ValueError(f"params.h is {params.h}; legal: from 1e-150 to 1e150")
            if not (given_u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not (1e-150 <= given_a <= 1e150):
                raise ValueError(f"params.a is {params.a}; legal: from 1e-150 to 1e150")
            if not np.isfinite(given_k[0]):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(given_k[1]):
                raise ValueError(f"params.k[1] is {params.k[1]}; legal: finite")
            if not np.isfinite(given_k[2]):
                raise ValueError(f"params.k[2] is {params.k[2]}; legal: finite")
            if not np.isfinite(given_k[3]):
                raise ValueError(f"params.k[3] is {params.k[3]}; legal: finite")
            if not np.isfinite(given_k[4]):
                raise ValueError(f"params.k[4] is {params.k[4]}; legal: finite")
            if not np.isfinite(given_k[5]):
                raise ValueError(f"params.k[5] is {params.k[5]}; legal: finite")
            if not (np.isfinite(given_deadbeat) and (given_deadbeat >= 0.0)):
                raise ValueError(f"params.deadbeat is {params.deadbeat}; legal: >= 0")
            samples = given_samples
            hold = 0.01 / given_h
            s1 = given_a * given_a * given_a * given_a * given_a
            s2 = 1.0 / (given_h * given_h * given_h * given_h)
            w1_1 = (-(given_k[0] / (s1 * given_a))) * s2
            s3 = given_a * given_a * given_a * given_a * given_a
            s4 = (-1.5) * (-(given_k[0] / (s3 * given_a)))
            w1_2 = s4 * (1.0 / (given_h * given_h * given_h))
            s5 = given_a * given_a * given_a * given_a * given_a
            s6 = 0.9166666666666666 * (-(given_k[0] / (s5 * given_a)))
            w1_3 = s6 * (1.0 / (given_h * given_h))
            s7 = given_a * given_a * given_a * given_a * given_a
            w1_4 = (-0.25) * (-(given_k[0] / (s7 * given_a))) * (1.0 / given_h)
            s8 = given_a * given_a * given_a * given_a * given_a
            s9 = given_a * given_a * given_a * given_a
            s10 = given_k[3] / (given_a * given_a * given_a)
            s11 = ((1.0 - (given_k[1] / s8)) + (given_k[2] / s9)) - s10
            s12 = s11 + (given_k[4] / (given_a * given_a))
            s13 = 1.0 / (given_h * given_h * given_h)
            w2_2 = (s12 - (given_k[5] / given_a)) * s13
            s14 = given_a * given_a * given_a * given_a * given_a
            s15 = given_a * given_a * given_a * given_a
            s16 = given_k[3] / (given_a * given_a * given_a)
            s17 = ((1.0 - (given_k[1] / s14)) + (given_k[2] / s15)) - s16
            s18 = s17 + (given_k[4] / (given_a * given_a))
            s19 = -(s18 - (given_k[5] / given_a))
            w2_3 = s19 * (1.0 / (given_h * given_h))
            s20 = given_a * given_a * given_a * given_a * given_a
            s21 = given_a * given_a * given_a * given_a
            s22 = given_k[3] / (given_a * given_a * given_a)
            s23 = ((1.0 - (given_k[1] / s20)) + (given_k[2] / s21)) - s22
            s24 = s23 + (given_k[4] / (given_a * given_a))
            s25 = 0.3333333333333333 * (s24 - (given_k[5] / given_a))
            w2_4 = s25 * (1.0 / given_h)
            s26 = given_a * given_a * given_a * given_a
            s27 = 3.0 * (given_k[3] / (given_a * given_a * given_a))
            s28 = 7.0 * (given_k[4] / (given_a * given_a))
            s29 = (((-31.0) - (given_k[2] / s26)) + s27) - s28
            s30 = s29 + (15.0 * (given_k[5] / given_a))
            w3_3 = s30 * (1.0 / (given_h * given_h))
            s31 = given_a * given_a * given_a * given_a
            s32 = 3.0 * (given_k[3] / (given_a * given_a * given_a))
            s33 = 7.0 * (given_k[4] / (given_a * given_a))
            s34 = (((-31.0) - (given_k[2] / s31)) + s32) - s33
            s35 = (-0.5) * (s34 + (15.0 * (given_k[5] / given_a)))
            w3_4 = s35 * (1.0 / given_h)
            s36 = 90.0 - (given_k[3] / (given_a * given_a * given_a))
            s37 = s36 + (6.0 * (given_k[4] / (given_a * given_a)))
            w4_4 = (s37 - (25.0 * (given_k[5] / given_a))) * (1.0 / given_h)
            s38 = (-65.0) - (given_k[4] / (given_a * given_a))
            w5_6 = s38 + (10.0 * (given_k[5] / given_a))
            w6_5 = 15.0 - (given_k[5] / given_a)
            w6_6 = -(15.0 - (given_k[5] / given_a))
            b_1 = -(1.0 / (given_h * given_h * given_h * given_h))
            b_2 = (-4.5) * (1.0 / (given_h * given_h * given_h))
            b_3 = (-9.916666666666666) * (1.0 / (given_h * given_h))
            b_4 = (-14.25) * (1.0 / given_h)
            u_max = given_u_max
            if not (
                np.isfinite(hold)
                and np.isfinite(w1_1)
                and np.isfinite(w1_2)
                and np.isfinite(w1_3)
                and np.isfinite(w1_4)
                and np.isfinite(w2_2)
                and np.isfinite(w2_3)
                and np.isfinite(w2_4)
                and np.isfinite(w3_3)
                and np.isfinite(w3_4)
                and np.isfinite(w4_4)
                and np.isfinite(w5_6)
                and np.isfinite(w6_5)
                and np.isfinite(w6_6)
                and np.isfinite(b_1)
                and np.isfinite(b_2)
                and np.isfinite(b_3)
                and np.isfinite(b_4)
                and (given_h * given_h * given_h * given_h >= 1e-200)
                and (1.0 / (given_h * given_h * given_h * given_h) >= 1e-200)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._hold = hold
            self._w1_1 = w1_1
            self._w1_2 = w1_2
            self._w1_3 = w1_3
            self._w1_4 = w1_4
            self._w2_2 = w2_2
            self._w2_3 = w2_3
            self._w2_4 = w2_4
            self._w3_3 = w3_3
            self._w3_4 = w3_4
            self._w4_4 = w4_4
            self._w5_6 = w5_6
            self._w6_5 = w6_5
            self._w6_6 = w6_6
            self._b_1 = b_1
            self._b_2 = b_2
            self._b_3 = b_3
            self._b_4 = b_4
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
            x = _numbers(x, 4, "x")
            elapsed = (k - self._start) & _WRAP
            x1 = x[0]
            x2 = x[1]
            x3 = x[2]
            x4 = x[3]
            left = max(self._samples - elapsed, 0)
            m0 = max(_R(left), self._hold)
            if m0 > _DEADBEAT:
                # The exact law in samples.
                s1 = (self._w1_1 * x1) + (self._w1_2 * x2) + (self._w1_3 * x3)
                z1 = s1 + (self._w1_4 * x4)
                z2 = (self._w2_2 * x2) + (self._w2_3 * x3) + (self._w2_4 * x4)
                z3 = (self._w3_3 * x3) + (self._w3_4 * x4)
                z4 = self._w4_4 * x4
                z5 = self._w5_6 * self._u2
                z6 = (self._w6_5 * self._u1) + (self._w6_6 * self._u2)
                m0f2 = m0 * (m0 - 1.0)
                m0f3 = m0f2 * (m0 - 2.0)
                m0f4 = m0f3 * (m0 - 3.0)
                m0f5 = m0f4 * (m0 - 4.0)
                s2 = z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3) + (z5 * m0f4)
                s3 = (s2 + (z6 * m0f5)) / (m0f5 * (m0 - 5.0))
                v = s3 + ((_C_5 * self._u1) - self._u2)
            else:
                # Deadbeat.
                s4 = (self._b_1 * x1) + (self._b_2 * x2) + (self._b_3 * x3)
                s5 = s4 + (self._b_4 * x4) + (_B_5 * self._u1)
                v = s5 + (_B_6 * self._u2)
            if not np.isfinite(v):
                return Control(_R(0.0), Status.RANGE)
            if v > self._u_max:
                u_now = self._u_max
            elif v < -self._u_max:
                u_now = -self._u_max
            else:
                u_now = v
            self._u2 = self._u1
            self._u1 = u_now
            if (v > self._u_max) or (v < -self._u_max):
                return Control(u_now, Status.SATURATED)
            elif _R(left) <= self._hold:
                return Control(u_now, Status.HOLD)
            else:
                return Control(u_now, Status.OK)
