"""
Prescribed-time controller stage: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name stage --clock samples --delay-law=predict --poles-end="least-energy(weight=1)" --end-samples=250 --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=200 --observer-eps=0.03 --tau=0.8 --eps=0.02 --u-max=6 --poles=least-energy --g="2/3" --sample-time=1e-3 --delay=1 --sensor-step=1e-6,0
Version 0.1.0, design 87cdac884d95.

Plant: x1' = x2, x2' = g (u + d), d constant and unknown; u held from sample to sample, one
      sample late.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law of the state x predicted for the time from which u acts, by x and the inputs under way:
      with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
      the rows are those of Theorem 1 for the mapping exp. From 250 samples to go on these
      are M - 2 and the exponents 3, 4, those of least energy. The gains of 21 samples to
      go stay.

Parameters:
  samples = 800 [samples], fixed: samples N from the start to rest
  h = 1e-3 [s], fixed: sample period
  eps = 0.02 [s], fixed: time-to-go at which the gains are held
  u_max = 6 [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 6 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_2 = 5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i

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
  growth: sound: near rest at sample 800, not at rest: the gains are held from 20 samples
      to go, and |u| is bounded; so does what the held observer leaves of its error.
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

__all__ = ["Control", "Params", "Stage", "Status"]

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

# 1/1000, prediction of x1 from x2.
_PHI1_2 = _R(0.001)
# 1/3000000, prediction of x1 from d.
_PHI1_3 = _R(3.3333333333333335e-7)
# 1/3000000, prediction from u.
_GAMMA1 = _R(3.3333333333333335e-7)
# 1/1500, prediction of x2 from d.
_PHI2_3 = _R(0.0006666666666666666)
# 1/1500, prediction from u.
_GAMMA2 = _R(0.0006666666666666666)
# Samples of the round of the observer.
_OBSERVER_SAMPLES = 200
# Samples to go at which the observer is held.
_HOLD_O = _R(30.0)
# Weight in the observer's gain l1.
_Q1_1 = _R(120.0)
# Weight in the observer's gain l1.
_Q1_2 = _R(-60.0)
# Weight in the observer's gain l1.
_Q1_3 = _R(12.0)
# Weight in the observer's gain l2.
_Q2_1 = _R(-108000.0)
# Weight in the observer's gain l2.
_Q2_2 = _R(36000.0)
# Weight in the observer's gain l3.
_Q3_1 = _R(36000000.0)
# Samples from the start to rest.
_SAMPLES = 800
# Samples to go at which the gains are held.
_HOLD = _R(20.0)
# Samples to go at which the law of the end takes over.
_END_SAMPLES = _R(250.0)
# Weight of x1 in the law.
_W1_1 = _R(-9000000.0)
# Weight of x2 in the law.
_W1_2 = _R(-4500.0)
# Weight of x2 in the law.
_W2_2 = _R(-6000.0)
# Weight of u1 in the law.
_W2_3 = _R(-4.0)
# Weight of x1 in the law.
_END1_1 = _R(-18000000.0)
# Weight of x2 in the law.
_END1_2 = _R(-9000.0)
# Weight of x2 in the law.
_END2_2 = _R(-9000.0)
# Weight of u1 in the law.
_END2_3 = _R(-6.0)
# Bound of |u|.
_U_MAX = _R(6.0)

class Stage:
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
            o0 = max(_R(left_o), _HOLD_O)
            o0f2 = o0 * (o0 - 1.0)
            r0 = 1.0 / (o0f2 * (o0 - 2.0))
            l1 = (_Q1_1 + (_Q1_2 * o0) + (_Q1_3 * o0f2)) * r0
            l2 = (_Q2_1 + (_Q2_2 * o0)) * r0
            l3 = _Q3_1 * r0
            x1 = base + (l1 * miss)
            x2 = p2 + (l2 * miss)
            d = p3 + (l3 * miss)
            left = max(_SAMPLES - elapsed, 0)
            s4 = _R(left) - 1.0
            m0 = max(s4, _HOLD)
            if m0 > _END_SAMPLES:
                # The exact law in samples.
                z1 = (_W1_1 * x1) + (_W1_2 * x2)
                z2 = (_W2_2 * x2) + (_W2_3 * (self._u1 + d))
                m0f1 = m0 + 1.0
                v = ((z1 + (z2 * m0f1)) / (m0f1 * m0)) - d
            else:
                # The law of least energy to the end.
                m1 = max(m0, _R(2.0))
                y1 = (_END1_1 * x1) + (_END1_2 * x2)
                y2 = (_END2_2 * x2) + (_END2_3 * (self._u1 + d))
                m1f1 = m1 + 2.0
                v = ((y1 + (y2 * m1f1)) / (m1f1 * (m1 + 1.0))) - d
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
            elif _R(left) - 1.0 <= _HOLD:
                return Control(u_now, Status.HOLD)
            else:
                return Control(u_now, Status.OK)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the constant that is added to u."""
        return self._d_hat
