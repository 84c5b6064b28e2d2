"""
Prescribed-time controller stage9: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name stage9 --clock samples --measured=x1 --observer-poles=-4,-5,-6 --observer-eps=0.05 --eps=0.02 --u-max=1e3 --delay=1
Version 0.1.0, design a9f2dd91a5f7.

Plant: x1' = x2, ..., x3' = u; u held from sample to sample, one sample late.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
      the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
      over.

Parameters:
  samples [samples]: samples N from the start to rest
  h [s]: sample period
  eps = 0.02 [s], fixed: time-to-go at which the gains are held
  u_max = 1e3 [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
  k_2 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
  k_3 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
  k_4 [1/s]: gains k_i of pi0 = -sum k_i xi_i
  deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
The estimates are exact from sample N/2 after the start on where the measurement is; with
      noise or sensor_step given, or observer_eps, the gains of the observer are then held
      below deadbeat.
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample N from any state, but for what the held observer leaves
      of its error, whatever the poles, and |u| is bounded.
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

__all__ = ["Control", "Params", "Stage9", "Status"]

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
    """samples N from the start to rest [samples], at least 8"""
    h: float
    """sample period [s], from 1e-150 to 1e150"""
    k: Sequence[float]
    """gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite"""
    deadbeat: float
    """samples to go at which deadbeat takes over, 0 for a safe default [samples], finite"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Weight in the observer's gain l1.
_Q1_1 = _R(120.0)
# Weight in the observer's gain l1.
_Q1_2 = _R(-60.0)
# Weight in the observer's gain l1.
_Q1_3 = _R(12.0)
# 7/2, samples to go at which deadbeat takes over.
_DEADBEAT = _R(3.5)
# Weight of u1 in the law.
_B_4 = _R(-3.0)
# Bound of |u|.
_U_MAX = _R(1000.0)

class Stage9:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_samples = params.samples.__index__()
            if given_samples != given_samples & _WRAP:
                raise ValueError(f"params.samples is {params.samples}; legal: 0..2^32 - 1")
            given_h = _R(params.h)
            given_k = _numbers(params.k, 4, "params.k")
            given_deadbeat = _R(params.deadbeat)
            if not (given_samples > 7):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 8")
            if not (1e-150 <= given_h <= 1e150):
                raise ValueError(f"params.h is {params.h}; legal: from 1e-150 to 1e150")
            if not np.isfinite(given_k[0]):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(given_k[1]):
                raise ValueError(f"params.k[1] is {params.k[1]}; legal: finite")
            if not np.isfinite(given_k[2]):
                raise ValueError(f"params.k[2] is {params.k[2]}; legal: finite")
            if not np.isfinite(given_k[3]):
                raise ValueError(f"params.k[3] is {params.k[3]}; legal: finite")
            if not (np.isfinite(given_deadbeat) and (given_deadbeat >= 0.0)):
                raise ValueError(f"params.deadbeat is {params.deadbeat}; legal: >= 0")
            samples = given_samples
            phi1_2 = given_h
            phi1_3 = 0.5 * (given_h * given_h)
            gamma1 = 0.16666666666666666 * (given_h * given_h * given_h)
            hold_o = 0.05 / given_h
            q2_1 = (-108.0) * (1.0 / given_h)
            q2_2 = 36.0 * (1.0 / given_h)
            q3_1 = 24.0 * (1.0 / (given_h * given_h))
            hold = 0.02 / given_h
            w1_1 = (-given_k[0]) * (1.0 / (given_h * given_h * given_h))
            w1_2 = given_k[0] * (1.0 / (given_h * given_h))
            w1_3 = 0.3333333333333333 * (-given_k[0]) * (1.0 / given_h)
            s1 = ((1.0 - given_k[1]) + given_k[2]) - given_k[3]
            w2_2 = s1 * (1.0 / (given_h * given_h))
            s2 = (-0.5) * (((1.0 - given_k[1]) + given_k[2]) - given_k[3])
            w2_3 = s2 * (1.0 / given_h)
            w3_3 = (((-7.0) - given_k[2]) + (3.0 * given_k[3])) * (1.0 / given_h)
            w4_4 = 6.0 - given_k[3]
            b_1 = -(1.0 / (given_h * given_h * given_h))
            b_2 = (-3.0) * (1.0 / (given_h * given_h))
            b_3 = (-4.333333333333333) * (1.0 / given_h)
            if not (
                np.isfinite(phi1_3)
                and np.isfinite(gamma1)
                and np.isfinite(hold_o)
                and np.isfinite(q2_1)
                and np.isfinite(q2_2)
                and np.isfinite(q3_1)
                and np.isfinite(hold)
                and np.isfinite(w1_1)
                and np.isfinite(w1_2)
                and np.isfinite(w1_3)
                and np.isfinite(w2_2)
                and np.isfinite(w2_3)
                and np.isfinite(w3_3)
                and np.isfinite(w4_4)
                and np.isfinite(b_1)
                and np.isfinite(b_2)
                and np.isfinite(b_3)
                and (given_h * given_h * given_h >= 1e-200)
                and (1.0 / (given_h * given_h * given_h) >= 1e-200)
                and (hold_o >= 3.0)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x3_hat = _R(0.0)
            self._phi1_2 = phi1_2
            self._phi1_3 = phi1_3
            self._gamma1 = gamma1
            self._hold_o = hold_o
            self._q2_1 = q2_1
            self._q2_2 = q2_2
            self._q3_1 = q3_1
            self._hold = hold
            self._w1_1 = w1_1
            self._w1_2 = w1_2
            self._w1_3 = w1_3
            self._w2_2 = w2_2
            self._w2_3 = w2_3
            self._w3_3 = w3_3
            self._w4_4 = w4_4
            self._b_1 = b_1
            self._b_2 = b_2
            self._b_3 = b_3

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept. Estimates too large to compute with begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        size = np.abs(self._x1_hat) + np.abs(self._x2_hat) + np.abs(self._x3_hat)
        if not (size <= 1e150):
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x3_hat = _R(0.0)

    def step(self, k: int, y: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
        each tick.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            y = _numbers(y, 1, "y")
            if not np.isfinite(y[0]):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP

            # Predict.
            s1 = self._x1_hat + (self._phi1_2 * self._x2_hat)
            p1 = s1 + (self._phi1_3 * self._x3_hat) + (self._gamma1 * self._u2)
            s2 = self._x2_hat + (self._phi1_2 * self._x3_hat)
            p2 = s2 + (self._phi1_3 * self._u2)
            p3 = self._x3_hat + (self._phi1_2 * self._u2)

            # Correct by what is measured.
            if self._seen == 0:
                base = y[0]
                miss = _R(0.0)
            else:
                base = p1
                miss = y[0] - p1
            left_o = max((self._samples // 2) - elapsed, 0)
            o0 = max(_R(left_o), self._hold_o)
            o0f2 = o0 * (o0 - 1.0)
            r0 = 1.0 / (o0f2 * (o0 - 2.0))
            l1 = (_Q1_1 + (_Q1_2 * o0) + (_Q1_3 * o0f2)) * r0
            l2 = (self._q2_1 + (self._q2_2 * o0)) * r0
            l3 = self._q3_1 * r0
            x1 = base + (l1 * miss)
            x2 = p2 + (l2 * miss)
            x3 = p3 + (l3 * miss)
            left = max(self._samples - elapsed, 0)
            m0 = max(_R(left), self._hold)
            if m0 > _DEADBEAT:
                # The exact law in samples.
                z1 = (self._w1_1 * x1) + (self._w1_2 * x2) + (self._w1_3 * x3)
                z2 = (self._w2_2 * x2) + (self._w2_3 * x3)
                z3 = self._w3_3 * x3
                z4 = self._w4_4 * self._u1
                m0f2 = m0 * (m0 - 1.0)
                m0f3 = m0f2 * (m0 - 2.0)
                s3 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0))
                v = s3 + self._u1
            else:
                # Deadbeat.
                s4 = (self._b_1 * x1) + (self._b_2 * x2) + (self._b_3 * x3)
                v = s4 + (_B_4 * self._u1)
            if not np.isfinite(v):
                return Control(_R(0.0), Status.RANGE)
            if v > _U_MAX:
                u_now = _U_MAX
            elif v < -_U_MAX:
                u_now = -_U_MAX
            else:
                u_now = v
            self._u2 = self._u1
            self._u1 = u_now
            self._x1_hat = x1
            self._x2_hat = x2
            self._x3_hat = x3
            self._seen = 1
            if (v > _U_MAX) or (v < -_U_MAX):
                return Control(u_now, Status.SATURATED)
            elif _R(left) <= self._hold:
                return Control(u_now, Status.HOLD)
            else:
                return Control(u_now, Status.OK)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat, self._x3_hat], dtype=_R)
