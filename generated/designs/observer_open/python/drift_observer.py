"""
Prescribed-time observer drift_observer: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name drift --what observer --clock samples --measured=x1,x2 --disturbance ramp --observer-poles=-4,-5,-6,-7 --observer-samples=60
Version 0.1.0, design 3d13f742d37b.

Plant: x1' = x2, ..., x3' = (u + d), d an unknown ramp; u held from sample to sample.
Goal: the estimates of the state and of d are exact up to rounding from sample 60 after the
      start on, from any state and at any sample period, as long as the measurement is
      exact, u is what was applied and nothing else acts on the plant.
Observer: xhat(k) = p + L (y(k) - p1), p = Phi xhat(k - 1) + Gamma u with the chain
      sampled, Phi and Gamma: the estimates of tick k hold y up to tick k. The gains follow
      by duality from the rows that Theorem 1 gives for the mapping exp. Close to the end
      deadbeat takes over.

Parameters:
  h [s]: sample period
  a = 1 [1/s], fixed: rate of stretched time

k counts samples and may wrap; arm again within 2^32 - 60 samples.
u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
      tick k.
From sample 60 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
      gains of the observer are then held below deadbeat.
Guard full: what is measured and u are finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: not checked: an observer alone has no law.
  sampling: not checked: an observer alone has no law.
  deadline: not checked: an observer alone has no law.
  loop: not checked: an observer alone has no law.
  envelope: not checked: an observer alone has no law.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["DriftObserver", "Params", "Status"]

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

@dataclass(frozen=True, kw_only=True)
class Params:
    """Run-time parameters."""

    h: float
    """sample period [s], from 1e-150 to 1e150"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Samples of the round of the observer.
_OBSERVER_SAMPLES = 60
# Weight in the observer's gain l1.
_Q1_1 = _R(-840.0)
# Weight in the observer's gain l1.
_Q1_2 = _R(480.0)
# Weight in the observer's gain l1.
_Q1_3 = _R(-120.0)
# Weight in the observer's gain l1.
_Q1_4 = _R(16.0)

class DriftObserver:
    """The observer. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_h = _R(params.h)
            if not (1e-150 <= given_h <= 1e150):
                raise ValueError(f"params.h is {params.h}; legal: from 1e-150 to 1e150")
            phi1_2 = given_h
            phi1_3 = 0.5 * (given_h * given_h)
            phi1_4 = 0.16666666666666666 * (given_h * given_h * given_h)
            q2_1 = 908.0 * (1.0 / given_h)
            q2_2 = (-432.0) * (1.0 / given_h)
            q2_3 = 72.0 * (1.0 / given_h)
            q3_1 = (-336.0) * (1.0 / (given_h * given_h))
            q3_2 = 96.0 * (1.0 / (given_h * given_h))
            q4_1 = 24.0 * (1.0 / (given_h * given_h * given_h))
            e3_2 = 1.8333333333333333 * (1.0 / given_h)
            e3_3 = 2.0 * (1.0 / (given_h * given_h))
            e3_4 = 1.0 / (given_h * given_h * given_h)
            e2_2 = 1.1666666666666667 * (1.0 / given_h)
            e2_4 = -(1.0 / (given_h * given_h * given_h))
            e1_2 = 0.8148148148148148 * (1.0 / given_h)
            e1_3 = (-0.2222222222222222) * (1.0 / (given_h * given_h))
            s1 = 1.0 / (given_h * given_h * given_h)
            e1_4 = 0.4444444444444444 * s1
            e0_2 = 0.4777777777777778 * (1.0 / given_h)
            e0_3 = 0.26666666666666666 * (1.0 / (given_h * given_h))
            s2 = 1.0 / (given_h * given_h * given_h)
            e0_4 = (-0.06666666666666667) * s2
            if not (
                np.isfinite(phi1_3)
                and np.isfinite(phi1_4)
                and np.isfinite(q2_1)
                and np.isfinite(q2_2)
                and np.isfinite(q2_3)
                and np.isfinite(q3_1)
                and np.isfinite(q3_2)
                and np.isfinite(q4_1)
                and np.isfinite(e3_2)
                and np.isfinite(e3_3)
                and np.isfinite(e3_4)
                and np.isfinite(e2_2)
                and np.isfinite(e2_4)
                and np.isfinite(e1_2)
                and np.isfinite(e1_3)
                and np.isfinite(e1_4)
                and np.isfinite(e0_2)
                and np.isfinite(e0_3)
                and np.isfinite(e0_4)
                and (given_h * given_h * given_h >= 1e-200)
                and (1.0 / (given_h * given_h * given_h) >= 1e-200)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._seen = 0
            self._x2_hat = _R(0.0)
            self._x3_hat = _R(0.0)
            self._d_hat = _R(0.0)
            self._d_rate_hat = _R(0.0)
            self._phi1_2 = phi1_2
            self._phi1_3 = phi1_3
            self._phi1_4 = phi1_4
            self._q2_1 = q2_1
            self._q2_2 = q2_2
            self._q2_3 = q2_3
            self._q3_1 = q3_1
            self._q3_2 = q3_2
            self._q4_1 = q4_1
            self._e3_2 = e3_2
            self._e3_3 = e3_3
            self._e3_4 = e3_4
            self._e2_2 = e2_2
            self._e2_4 = e2_4
            self._e1_2 = e1_2
            self._e1_3 = e1_3
            self._e1_4 = e1_4
            self._e0_2 = e0_2
            self._e0_3 = e0_3
            self._e0_4 = e0_4

    def arm(self, k: int) -> None:
        """Starts a round of 60 samples at tick `k`. The estimates are kept. Estimates too large to
        compute with begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        s1 = np.abs(self._x2_hat) + np.abs(self._x3_hat) + np.abs(self._d_hat)
        size = s1 + np.abs(self._d_rate_hat)
        if not (size <= 1e150):
            self._seen = 0
            self._x2_hat = _R(0.0)
            self._x3_hat = _R(0.0)
            self._d_hat = _R(0.0)
            self._d_rate_hat = _R(0.0)

    def update(self, k: int, y: ArrayLike, u: float) -> Status:
        """The estimates of tick `k`, which may wrap, from what is measured, y = (x1, ...) at that
        tick and u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call it
        once for each tick, before the law, which takes its estimates. Status Hold from sample 60
        on: the round is over.

        On a negative status nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            y = _numbers(y, 2, "y")
            u = _R(u)
            if not (np.isfinite(y[0]) and np.isfinite(y[1]) and np.isfinite(u)):
                return Status.INPUT
            elapsed = (k - self._start) & _WRAP

            # Predict.
            s1 = self._x2_hat + (self._phi1_2 * self._x3_hat)
            s2 = s1 + (self._phi1_3 * self._d_hat)
            p1 = s2 + (self._phi1_4 * self._d_rate_hat) + (self._phi1_3 * u)
            s3 = self._x3_hat + (self._phi1_2 * self._d_hat)
            p2 = s3 + (self._phi1_3 * self._d_rate_hat) + (self._phi1_2 * u)
            p3 = self._d_hat + (self._phi1_2 * self._d_rate_hat)
            p4 = self._d_rate_hat

            # Correct by what is measured.
            if self._seen == 0:
                base = y[1]
                miss = _R(0.0)
            else:
                base = p1
                miss = y[1] - p1
            left_o = max(_OBSERVER_SAMPLES - elapsed, 0)
            o0 = _R(left_o)
            if o0 > 10.0:
                o0f2 = o0 * (o0 - 1.0)
                o0f3 = o0f2 * (o0 - 2.0)
                r0 = 1.0 / (o0f3 * (o0 - 3.0))
                s4 = _Q1_1 + (_Q1_2 * o0) + (_Q1_3 * o0f2)
                l1 = (s4 + (_Q1_4 * o0f3)) * r0
                l2 = (self._q2_1 + (self._q2_2 * o0) + (self._q2_3 * o0f2)) * r0
                l3 = (self._q3_1 + (self._q3_2 * o0)) * r0
                l4 = self._q4_1 * r0
            elif left_o == 10:
                l1 = _R(1.0)
                l2 = self._e0_2
                l3 = self._e0_3
                l4 = self._e0_4
            elif left_o == 9:
                l1 = _R(1.0)
                l2 = self._e1_2
                l3 = self._e1_3
                l4 = self._e1_4
            elif left_o == 8:
                l1 = _R(1.0)
                l2 = self._e2_2
                l3 = _R(0.0)
                l4 = self._e2_4
            else:
                l1 = _R(1.0)
                l2 = self._e3_2
                l3 = self._e3_3
                l4 = self._e3_4
            x2 = base + (l1 * miss)
            x3 = p2 + (l2 * miss)
            d = p3 + (l3 * miss)
            d_rate = p4 + (l4 * miss)
            if not (np.isfinite(x2) and np.isfinite(x3) and np.isfinite(d) and np.isfinite(d_rate)):
                return Status.RANGE
            self._x2_hat = x2
            self._x3_hat = x3
            self._d_hat = d
            self._d_rate_hat = d_rate
            self._seen = 1
            if left_o == 0:
                return Status.HOLD
            else:
                return Status.OK

    def estimate(self) -> Array:
        """The estimates of x2, ... at the last sample."""
        return np.array([self._x2_hat, self._x3_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the ramp that is added to u."""
        return self._d_hat
