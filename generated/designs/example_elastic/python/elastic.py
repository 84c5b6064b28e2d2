"""
Prescribed-time controller elastic: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name elastic --clock samples --measured=x1 --disturbance constant --observer-poles=-5,-6,-7 --observer-samples=200 --tau=0.5 --eps=0.0965 --u-max=100 --poles=-4,-4.5,-5 --g="2/7" --sample-time=5e-4 --delay=1 --error=1e-3,0.1 --sensor-step=7.7e-6 --x0-max=0.3,1e-6
Version 0.1.0, design b13fcc225118.

Plant: x1' = x2, x2' = g (u + d), d constant and unknown; u held from sample to sample, one
      sample late.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
      the rows are those of Theorem 1 for the mapping exp. The gains of 193 samples to go
      stay.

Parameters:
  samples = 1000 [samples], fixed: samples N from the start to rest
  h = 5e-4 [s], fixed: sample period
  eps = 0.0965 [s], fixed: time-to-go at which the gains are held
  u_max = 100 [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 90 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_2 = 60.5 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_3 = 13.5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
The estimates are exact from sample 200 after the start on where the measurement is; with
      noise or sensor_step given, or observer_eps, the gains of the observer are then held
      below deadbeat.
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: near rest at sample 1000, not at rest: the gains are held from 193 samples
      to go, and |u| is bounded.
  sampling: not checked: the law is exact in samples, at any period.
  deadline: not checked: the law is exact in samples, at any period.
  loop: undecided: f = -5*x2/(7/2) is not a sum of bounded symbols; with f = 0, the g of
      the law and a rigid plant, at the deadline |x| <= 1.015e-4, 0.002024.
  envelope: not checked: it does not examine a clock in samples.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Elastic", "Params", "Status"]

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

# 1/2000, prediction of x1 from x2.
_PHI1_2 = _R(0.0005)
# 1/28000000, prediction of x1 from d.
_PHI1_3 = _R(3.571428571428571e-8)
# 1/28000000, prediction from u.
_GAMMA1 = _R(3.571428571428571e-8)
# 1/7000, prediction of x2 from d.
_PHI2_3 = _R(0.00014285714285714287)
# 1/7000, prediction from u.
_GAMMA2 = _R(0.00014285714285714287)
# Samples of the round of the observer.
_OBSERVER_SAMPLES = 200
# Weight in the observer's gain l1.
_Q1_1 = _R(210.0)
# Weight in the observer's gain l1.
_Q1_2 = _R(-90.0)
# Weight in the observer's gain l1.
_Q1_3 = _R(15.0)
# Weight in the observer's gain l2.
_Q2_1 = _R(-420000.0)
# Weight in the observer's gain l2.
_Q2_2 = _R(120000.0)
# Weight in the observer's gain l3.
_Q3_1 = _R(840000000.0)
# 3500/3, gain of the observer at its end.
_E0_2 = _R(1166.6666666666667)
# 7000000/3, gain of the observer at its end.
_E0_3 = _R(2333333.3333333335)
# Gain of the observer at its end.
_E1_2 = _R(1875.0)
# Gain of the observer at its end.
_E1_3 = _R(-1750000.0)
# Gain of the observer at its end.
_E2_2 = _R(3000.0)
# Gain of the observer at its end.
_E2_3 = _R(14000000.0)
# Samples from the start to rest.
_SAMPLES = 1000
# Samples to go at which the gains are held.
_HOLD = _R(193.0)
# Weight of x1 in the law.
_W1_1 = _R(-1260000000.0)
# Weight of x2 in the law.
_W1_2 = _R(315000.0)
# Weight of x2 in the law.
_W2_2 = _R(-336000.0)
# -21/2, weight of u1 in the law.
_W3_3 = _R(-10.5)
# Bound of |u|.
_U_MAX = _R(100.0)

class Elastic:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            self._start = 0
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._d_hat = _R(0.0)

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept. Estimates too large to compute with begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        size = np.abs(self._x1_hat) + np.abs(self._x2_hat) + np.abs(self._d_hat)
        if not (size <= 1e150):
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._d_hat = _R(0.0)

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
            s1 = self._x1_hat + (_PHI1_2 * self._x2_hat)
            s2 = s1 + (_PHI1_3 * self._d_hat)
            p1 = s2 + (_GAMMA1 * self._u2)
            s3 = self._x2_hat + (_PHI2_3 * self._d_hat)
            p2 = s3 + (_GAMMA2 * self._u2)
            p3 = self._d_hat

            # Correct by what is measured.
            if self._seen == 0:
                base = y[0]
                miss = _R(0.0)
            else:
                base = p1
                miss = y[0] - p1
            left_o = max(_OBSERVER_SAMPLES - elapsed, 0)
            o0 = _R(25.0) if left_o == 0 else _R(left_o)
            if o0 > 9.0:
                o0f2 = o0 * (o0 - 1.0)
                r0 = 1.0 / (o0f2 * (o0 - 2.0))
                l1 = (_Q1_1 + (_Q1_2 * o0) + (_Q1_3 * o0f2)) * r0
                l2 = (_Q2_1 + (_Q2_2 * o0)) * r0
                l3 = _Q3_1 * r0
            elif left_o == 9:
                l1 = _R(1.0)
                l2 = _E0_2
                l3 = _E0_3
            elif left_o == 8:
                l1 = _R(1.0)
                l2 = _E1_2
                l3 = _E1_3
            else:
                l1 = _R(1.0)
                l2 = _E2_2
                l3 = _E2_3
            x1 = base + (l1 * miss)
            x2 = p2 + (l2 * miss)
            d = p3 + (l3 * miss)
            left = max(_SAMPLES - elapsed, 0)
            m0 = max(_R(left), _HOLD)

            # The exact law in samples.
            z1 = (_W1_1 * x1) + (_W1_2 * x2)
            z2 = _W2_2 * x2
            z3 = _W3_3 * (self._u1 + d)
            m0f2 = m0 * (m0 - 1.0)
            s4 = (z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0))
            v = (s4 + (self._u1 + d)) - d
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
            self._d_hat = d
            self._seen = 1
            if (v > _U_MAX) or (v < -_U_MAX):
                return Control(u_now, Status.SATURATED)
            elif _R(left) <= _HOLD:
                return Control(u_now, Status.HOLD)
            else:
                return Control(u_now, Status.OK)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the constant that is added to u."""
        return self._d_hat
