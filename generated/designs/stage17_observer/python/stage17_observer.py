"""
Prescribed-time observer stage17_observer: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name stage17 --what observer --clock samples --disturbance constant --observer-poles=-4,-5 --observer-samples=8 --guard none
Version 0.1.0, design da56a9ae4fbe.

Plant: x1' = x2, x2' = (u + d), d constant and unknown; u held from sample to sample.
Goal: the estimates of the state and of d are exact up to rounding from sample 8 after the
      start on, from any state and at any sample period, as long as the measurement is
      exact, u is what was applied and nothing else acts on the plant.
Observer: xhat(k) = p + L (y(k) - p1), p = Phi xhat(k - 1) + Gamma u with the chain
      sampled, Phi and Gamma: the estimates of tick k hold y up to tick k. The gains follow
      by duality from the rows that Theorem 1 gives for the mapping exp. Close to the end
      deadbeat takes over.

Parameters:
  h [s]: sample period
  a = 1 [1/s], fixed: rate of stretched time

k counts samples and may wrap; arm again within 2^32 - 8 samples.
u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
      tick k.
From sample 8 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
      gains of the observer are then held below deadbeat.
Guard none: finite measurements and inputs are the responsibility of the caller.
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

__all__ = ["Params", "Stage17Observer", "Status"]

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
_OBSERVER_SAMPLES = 8
# Weight in the observer's gain l1.
_Q1_1 = _R(-20.0)
# Weight in the observer's gain l1.
_Q1_2 = _R(8.0)

class Stage17Observer:
    """The observer. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_h = _R(params.h)
            if not (1e-150 <= given_h <= 1e150):
                raise ValueError(f"params.h is {params.h}; legal: from 1e-150 to 1e150")
            phi1_2 = given_h
            q2_1 = 12.0 * (1.0 / given_h)
            e1_2 = 1.0 / given_h
            e0_2 = 0.3333333333333333 * (1.0 / given_h)
            if not (
                np.isfinite(q2_1)
                and np.isfinite(e1_2)
                and np.isfinite(e0_2)
                and (given_h * given_h >= 1e-200)
                and (1.0 / (given_h * given_h) >= 1e-200)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._seen = 0
            self._x2_hat = _R(0.0)
            self._d_hat = _R(0.0)
            self._phi1_2 = phi1_2
            self._q2_1 = q2_1
            self._e1_2 = e1_2
            self._e0_2 = e0_2

    def arm(self, k: int) -> None:
        """Starts a round of 8 samples at tick `k`. The estimates are kept. Estimates too large to
        compute with begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        size = np.abs(self._x2_hat) + np.abs(self._d_hat)
        if not (size <= 1e150):
            self._seen = 0
            self._x2_hat = _R(0.0)
            self._d_hat = _R(0.0)

    def update(self, k: int, y: ArrayLike, u: float) -> Status:
        """The estimates of tick `k`, which may wrap, from what is measured, y = (x1, ...) at that
        tick and u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call it
        once for each tick, before the law, which takes its estimates. Status Hold from sample 8 on:
        the round is over.

        On a negative status nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            y = _numbers(y, 2, "y")
            u = _R(u)
            elapsed = (k - self._start) & _WRAP

            # Predict.
            s1 = self._x2_hat + (self._phi1_2 * self._d_hat)
            p1 = s1 + (self._phi1_2 * u)
            p2 = self._d_hat

            # Correct by what is measured.
            if self._seen == 0:
                base = y[1]
                miss = _R(0.0)
            else:
                base = p1
                miss = y[1] - p1
            left_o = max(_OBSERVER_SAMPLES - elapsed, 0)
            o0 = _R(left_o)
            if o0 > 6.0:
                r0 = 1.0 / (o0 * (o0 - 1.0))
                l1 = (_Q1_1 + (_Q1_2 * o0)) * r0
                l2 = self._q2_1 * r0
            elif left_o == 6:
                l1 = _R(1.0)
                l2 = self._e0_2
            else:
                l1 = _R(1.0)
                l2 = self._e1_2
            x2 = base + (l1 * miss)
            d = p2 + (l2 * miss)
            if not (np.isfinite(x2) and np.isfinite(d)):
                return Status.RANGE
            self._x2_hat = x2
            self._d_hat = d
            self._seen = 1
            if left_o == 0:
                return Status.HOLD
            else:
                return Status.OK

    def estimate(self) -> Array:
        """The estimates of x2, ... at the last sample."""
        return np.array([self._x2_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the constant that is added to u."""
        return self._d_hat
