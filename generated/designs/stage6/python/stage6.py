"""
Prescribed-time controller stage6: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=0.7)" --name stage6 --clock samples --measured=x1,x2 --observer-poles=-4,-5.3 --eps=0 --f="1/2" --g="2" --sample-time=2e-3
Version 0.1.0, design 6c8ba09a0bea.

Plant: x1' = x2, ..., x3' = f + g u; u held from sample to sample.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
      the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
      over.

Parameters:
  samples [samples]: samples N from the start to rest
  h = 2e-3 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a = 0.7 [1/s], fixed: rate of stretched time
  k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
  k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
  k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
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

__all__ = ["Control", "Params", "Stage6", "Status"]

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
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""
    k: Sequence[float]
    """gains k_i of pi0 = -sum k_i xi_i [1/s^3], finite"""
    deadbeat: float
    """samples to go at which deadbeat takes over, 0 for a safe default [samples], finite"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# 1/500, prediction of x2 from x3.
_PHI1_2 = _R(0.002)
# 1/250000, prediction from u.
_GAMMA1 = _R(4e-6)
# 1/250, prediction from u.
_GAMMA2 = _R(0.004)
# -2120/49, weight in the observer's gain l1.
_Q1_1 = _R(-43.265306122448976)
# 86/7, weight in the observer's gain l1.
_Q1_2 = _R(12.285714285714286)
# 759000/49, weight in the observer's gain l2.
_Q2_1 = _R(15489.795918367347)
# 11500/63, gain of the observer at its end.
_E0_2 = _R(182.53968253968253)
# Gain of the observer at its end.
_E1_2 = _R(500.0)
# Weight of x1 in the law.
_B_1 = _R(-62500000.0)
# Weight of x2 in the law.
_B_2 = _R(-250000.0)
# -1375/3, weight of x3 in the law.
_B_3 = _R(-458.3333333333333)

class Stage6:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_samples = params.samples.__index__()
            if given_samples != given_samples & _WRAP:
                raise ValueError(f"params.samples is {params.samples}; legal: 0..2^32 - 1")
            given_u_max = _R(params.u_max)
            given_k = _numbers(params.k, 3, "params.k")
            given_deadbeat = _R(params.deadbeat)
            if not (given_samples > 5):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 6")
            if not (given_u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not np.isfinite(given_k[0]):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(given_k[1]):
                raise ValueError(f"params.k[1] is {params.k[1]}; legal: finite")
            if not np.isfinite(given_k[2]):
                raise ValueError(f"params.k[2] is {params.k[2]}; legal: finite")
            if not (np.isfinite(given_deadbeat) and (given_deadbeat >= 0.0)):
                raise ValueError(f"params.deadbeat is {params.deadbeat}; legal: >= 0")
            samples = given_samples
            s1 = ((given_k[2] / 0.7) - 4.0) + 3.0
            s2 = max(s1, _R(6.0))
            deadbeat = given_deadbeat if given_deadbeat > 0.0 else s2
            w1_1 = 125000000.0 * (0.5 * (-(given_k[0] / 0.343)))
            w1_2 = 250000.0 * ((-0.5) * (-(given_k[0] / 0.343)))
            w1_3 = 500.0 * (0.16666666666666666 * (-(given_k[0] / 0.343)))
            s3 = 0.5 * (((-1.0) - (given_k[1] / 0.49)) + (given_k[2] / 0.7))
            w2_2 = 250000.0 * s3
            s4 = (-0.25) * (((-1.0) - (given_k[1] / 0.49)) + (given_k[2] / 0.7))
            w2_3 = 500.0 * s4
            w3_3 = 500.0 * (0.5 * (3.0 - (given_k[2] / 0.7)))
            u_max = given_u_max
            if not (
                np.isfinite(deadbeat)
                and np.isfinite(w1_1)
                and np.isfinite(w1_2)
                and np.isfinite(w1_3)
                and np.isfinite(w2_2)
                and np.isfinite(w2_3)
                and np.isfinite(w3_3)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._u1 = _R(0.0)
            self._seen = 0
            self._x2_hat = _R(0.0)
            self._x3_hat = _R(0.0)
            self._deadbeat = deadbeat
            self._w1_1 = w1_1
            self._w1_2 = w1_2
            self._w1_3 = w1_3
            self._w2_2 = w2_2
            self._w2_3 = w2_3
            self._w3_3 = w3_3
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept. Estimates too large to compute with begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        size = np.abs(self._x2_hat) + np.abs(self._x3_hat)
        if not (size <= 1e150):
            self._seen = 0
            self._x2_hat = _R(0.0)
            self._x3_hat = _R(0.0)

    def step(self, k: int, y: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
        each tick.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            y = _numbers(y, 2, "y")
            if not (np.isfinite(y[0]) and np.isfinite(y[1])):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP

            # Predict.
            s1 = self._x2_hat + (_PHI1_2 * self._x3_hat)
            p1 = s1 + (_GAMMA1 * (self._u1 + 0.25))
            p2 = self._x3_hat + (_GAMMA2 * (self._u1 + 0.25))

            # Correct by what is measured.
            if self._seen == 0:
                base = y[1]
                miss = _R(0.0)
            else:
                base = p1
                miss = y[1] - p1
            left_o = max((self._samples // 2) - elapsed, 0)
            o0 = _R(left_o)
            if o0 > 9.0:
                r0 = 1.0 / (o0 * (o0 - 1.0))
                l1 = (_Q1_1 + (_Q1_2 * o0)) * r0
                l2 = _Q2_1 * r0
            elif left_o == 9:
                l1 = _R(1.0)
                l2 = _E0_2
            else:
                l1 = _R(1.0)
                l2 = _E1_2
            x1 = y[0]
            x2 = base + (l1 * miss)
            x3 = p2 + (l2 * miss)
            left = max(self._samples - elapsed, 0)
            m0 = _R(left)
            if m0 > self._deadbeat:
                # The exact law in samples.
                z1 = (self._w1_1 * x1) + (self._w1_2 * x2) + (self._w1_3 * x3)
                z2 = (self._w2_2 * x2) + (self._w2_3 * x3)
                z3 = self._w3_3 * x3
                m0f2 = m0 * (m0 - 1.0)
                v = ((z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0))) - 0.25
            else:
                # Deadbeat.
                s2 = (_B_1 * x1) + (_B_2 * x2) + (_B_3 * x3)
                v = s2 - 0.25
            if not np.isfinite(v):
                return Control(_R(0.0), Status.RANGE)
            if v > self._u_max:
                u_now = self._u_max
            elif v < -self._u_max:
                u_now = -self._u_max
            else:
                u_now = v
            self._u1 = u_now
            self._x2_hat = x2
            self._x3_hat = x3
            self._seen = 1
            if (v > self._u_max) or (v < -self._u_max):
                return Control(u_now, Status.SATURATED)
            elif elapsed < self._samples:
                return Control(u_now, Status.OK)
            else:
                return Control(u_now, Status.HOLD)

    def estimate(self) -> Array:
        """The estimates of x2, ... at the last sample."""
        return np.array([self._x2_hat, self._x3_hat], dtype=_R)
