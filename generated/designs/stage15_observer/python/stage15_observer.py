"""
Prescribed-time observer stage15_observer: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1.5)" --name stage15 --what observer --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=9 --observer-eps=0.05 --precision f32 --f="-981/100" --g="1/2" --delay=1.5
Version 0.1.0, design fa54d2fef2e7.

Plant: x1' = x2, x2' = f + g (u + d), d constant and unknown; u held from sample to sample,
      1.5 samples late.
Goal: the estimates of the state and of d are as near as the hold at observer_eps leaves
      them from sample 9 after the start on, from any state and at any sample period, as
      long as the measurement is exact, u is what was applied and nothing else acts on the
      plant.
Observer: xhat(k) = p + L (y(k) - p1), p = Phi xhat(k - 1) + Gamma u with the chain
      sampled, Phi and Gamma: the estimates of tick k hold y up to tick k. The gains follow
      by duality from the rows that Theorem 1 gives for the mapping exp. Close to the end
      deadbeat takes over.

Parameters:
  h [s]: sample period
  a = 1.5 [1/s], fixed: rate of stretched time

k counts samples and may wrap; arm again within 2^32 - 9 samples.
u is the input of tick k - 1 as it was applied, after clipping: it acts from 1.5 samples
      after tick k - 1 on for one sample, and the observer keeps those under way.
From sample 9 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
      gains of the observer are then held below deadbeat.
Guard full: what is measured and u are finite, or the call is refused (INPUT).
Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
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

__all__ = ["Params", "Stage15Observer", "Status"]

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

@dataclass(frozen=True, kw_only=True)
class Params:
    """Run-time parameters."""

    h: float
    """sample period [s], from 1e-18 to 1e18"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Samples of the round of the observer.
_OBSERVER_SAMPLES = 9
# 320/9, weight in the observer's gain l1.
_Q1_1 = _R(_R(35.55555725097656))
# -215/9, weight in the observer's gain l1.
_Q1_2 = _R(-_R(23.88888931274414))
# Weight in the observer's gain l1.
_Q1_3 = _R(_R(7.0))

class Stage15Observer:
    """The observer. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_h = _R(params.h)
            if not (_R(1.000000045813705e-18) <= given_h <= _R(9.999999843067494e17)):
                raise ValueError(f"params.h is {params.h}; legal: from 1.000000045813705e-18 to 9.999999843067494e17")
            phi1_2 = given_h
            phi1_3 = _R(0.25) * (given_h * given_h)
            gamma1 = _R(0.1875) * (given_h * given_h)
            late_gamma1 = _R(0.0625) * (given_h * given_h)
            phi2_3 = _R(0.5) * given_h
            gamma2 = _R(0.25) * given_h
            hold_o = _R(0.05000000074505806) / given_h
            q2_1 = (-_R(22.44444465637207)) * (_R(1.0) / given_h)
            q2_2 = _R(9.88888931274414) * (_R(1.0) / given_h)
            q3_1 = _R(3.555555582046509) * (_R(1.0) / (given_h * given_h))
            if not (
                np.isfinite(phi1_3)
                and np.isfinite(gamma1)
                and np.isfinite(late_gamma1)
                and np.isfinite(phi2_3)
                and np.isfinite(gamma2)
                and np.isfinite(hold_o)
                and np.isfinite(q2_1)
                and np.isfinite(q2_2)
                and np.isfinite(q3_1)
                and (given_h * given_h >= _R(1.0000000031710769e-30))
                and (_R(1.0) / (given_h * given_h) >= _R(1.0000000031710769e-30))
                and (hold_o >= _R(3.0))
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._d_hat = _R(0.0)
            self._phi1_2 = phi1_2
            self._phi1_3 = phi1_3
            self._gamma1 = gamma1
            self._late_gamma1 = late_gamma1
            self._phi2_3 = phi2_3
            self._gamma2 = gamma2
            self._hold_o = hold_o
            self._q2_1 = q2_1
            self._q2_2 = q2_2
            self._q3_1 = q3_1

    def arm(self, k: int) -> None:
        """Starts a round of 9 samples at tick `k`. Estimates and inputs under way are kept.
        Estimates too large to compute with begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        size = np.abs(self._x1_hat) + np.abs(self._x2_hat) + np.abs(self._d_hat)
        if not (size <= _R(9.999999843067494e17)):
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._d_hat = _R(0.0)

    def update(self, k: int, y: ArrayLike, u: float | np.float32) -> Status:
        """The estimates of tick `k`, which may wrap, from what is measured, y = (x1, ...) at that
        tick and u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call it
        once for each tick, before the law, which takes its estimates. Status Hold from sample 9 on:
        the round is over.

        On a negative status nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            y = _numbers(y, 1, "y")
            u = _R(u)
            if not (np.isfinite(y[0]) and np.isfinite(u)):
                return Status.INPUT
            elapsed = (k - self._start) & _WRAP

            # Predict.
            s1 = self._x1_hat + (self._phi1_2 * self._x2_hat)
            s2 = self._late_gamma1 * (self._u1 - _R(19.6200008392334))
            s3 = (self._gamma1 * (self._u2 - _R(19.6200008392334))) + s2
            p1 = s1 + (self._phi1_3 * self._d_hat) + s3
            s4 = self._gamma2 * (self._u2 - _R(19.6200008392334))
            s5 = self._x2_hat + (self._phi2_3 * self._d_hat)
            p2 = s5 + (s4 + (self._gamma2 * (self._u1 - _R(19.6200008392334))))
            p3 = self._d_hat

            # Correct by what is measured.
            if self._seen == 0:
                base = y[0]
                miss = _R(0.0)
            else:
                base = p1
                miss = y[0] - p1
            left_o = max(_OBSERVER_SAMPLES - elapsed, 0)
            o0 = max(_R(left_o), self._hold_o)
            o0f2 = o0 * (o0 - _R(1.0))
            r0 = _R(1.0) / (o0f2 * (o0 - _R(2.0)))
            l1 = (_Q1_1 + (_Q1_2 * o0) + (_Q1_3 * o0f2)) * r0
            l2 = (self._q2_1 + (self._q2_2 * o0)) * r0
            l3 = self._q3_1 * r0
            x1 = base + (l1 * miss)
            x2 = p2 + (l2 * miss)
            d = p3 + (l3 * miss)
            if not (np.isfinite(x1) and np.isfinite(x2) and np.isfinite(d)):
                return Status.RANGE
            self._u2 = self._u1
            self._u1 = u
            self._x1_hat = x1
            self._x2_hat = x2
            self._d_hat = d
            self._seen = 1
            if left_o == 0:
                return Status.HOLD
            else:
                return Status.OK

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat], dtype=_R)

    def disturbance(self) -> np.float32:
        """The estimate of the constant that is added to u."""
        return self._d_hat
