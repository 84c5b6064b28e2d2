"""
Prescribed-time controller stage46: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name stage46 --clock samples --delay-law=predict --measured=x1 --disturbance constant --observer=stationary --disturbance-walk=1 --tau=0.04 --eps=0 --u-max=6 --poles=least-energy --sample-time=1e-3 --delay=1 --sensor-step=1e-6,0
Version 0.1.0, design 86690ba9feac.

Plant: x1' = x2, x2' = (u + d), d constant and unknown; u held from sample to sample, one
      sample late.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law of the state x predicted for the time from which u acts, by x and the inputs under way:
      with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
      the rows are those of Theorem 1 for the mapping exp. The gains of 3 samples to go
      stay: they are deadbeat.

Parameters:
  samples = 40 [samples], fixed: samples N from the start to rest
  h = 1e-3 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max = 6 [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 6 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_2 = 5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
The estimates approach the state from the first sample on: the observer has the gains of
      the stationary Kalman filter for the noise and disturbance_walk.
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample 40 from any state, but for what the stationary observer
      leaves of its error, whatever the poles, and |u| is bounded.
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

__all__ = ["Control", "Params", "Stage46", "Status"]

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
# 1/2000000, prediction of x1 from d.
_PHI1_3 = _R(5e-7)
# 1/2000000, prediction from u.
_GAMMA1 = _R(5e-7)
# 1/1000, prediction of x2 from d.
_PHI2_3 = _R(0.001)
# 1/1000, prediction from u.
_GAMMA2 = _R(0.001)
# Weight of x1 in the law.
_W1_1 = _R(-6000000.0)
# Weight of x2 in the law.
_W1_2 = _R(-3000.0)
# Weight of x2 in the law.
_W2_2 = _R(-4000.0)
# Weight of u1 in the law.
_W2_3 = _R(-4.0)
# Bound of |u|.
_U_MAX = _R(6.0)
# Samples from the start to rest.
_SAMPLES = 40

class Stage46:
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
            l1 = _R(0.6159148679121326)
            l2 = _R(289.1861751977763)
            l3 = _R(67889.77526148109)
            x1 = base + (l1 * miss)
            x2 = p2 + (l2 * miss)
            d = p3 + (l3 * miss)

            # The exact law in samples.
            m0 = _R((40 - elapsed) & _WRAP) if elapsed < 37 else _R(3.0)
            z1 = (_W1_1 * x1) + (_W1_2 * x2)
            z2 = (_W2_2 * x2) + (_W2_3 * (self._u1 + d))
            v = ((z1 + (z2 * m0)) / (m0 * (m0 - 1.0))) - d
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
            elif elapsed < _SAMPLES:
                return Control(u_now, Status.OK)
            else:
                return Control(u_now, Status.HOLD)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the constant that is added to u."""
        return self._d_hat
