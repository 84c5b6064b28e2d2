"""
Prescribed-time controller a_name_that_fills_half_of_a_line_alone_4: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=2)" --name a_name_that_fills_half_of_a_line_alone_4 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --precision f32 --eps=0 --after zero
Version 0.1.0, design 077043d15f79.

Plant: x1' = x2, x2' = (u + d), d constant and unknown; u held from sample to sample.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
      the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
      over.

Parameters:
  samples [samples]: samples N from the start to rest
  h [s]: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a = 2 [1/s], fixed: rate of stretched time
  k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
  k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
  deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on u = 0 (status AFTER).
The estimates are exact from sample N/2 after the start on where the measurement is; with
      noise or sensor_step given, or observer_eps, the gains of the observer are then held
      below deadbeat.
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
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

__all__ = ["ANameThatFillsHalfOfALineAlone4", "Control", "Params", "Status"]

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
    """samples N from the start to rest [samples], at least 6"""
    h: float
    """sample period [s], from 1e-18 to 1e18"""
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""
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

# Weight in the observer's gain l1.
_Q1_1 = _R(_R(15.0))
# Weight in the observer's gain l1.
_Q1_2 = _R(-_R(12.0))
# 9/2, weight in the observer's gain l1.
_Q1_3 = _R(_R(4.5))

class ANameThatFillsHalfOfALineAlone4:
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
            given_k = _numbers(params.k, 2, "params.k")
            given_deadbeat = _R(params.deadbeat)
            if not (given_samples > 5):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 6")
            if not (_R(1.000000045813705e-18) <= given_h <= _R(9.999999843067494e17)):
                raise ValueError(f"params.h is {params.h}; legal: from 1.000000045813705e-18 to 9.999999843067494e17")
            if not (given_u_max > _R(0.0)):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not np.isfinite(given_k[0]):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(given_k[1]):
                raise ValueError(f"params.k[1] is {params.k[1]}; legal: finite")
            if not (np.isfinite(given_deadbeat) and (given_deadbeat >= _R(0.0))):
                raise ValueError(f"params.deadbeat is {params.deadbeat}; legal: >= 0")
            samples = given_samples
            phi1_2 = given_h
            phi1_3 = _R(0.5) * (given_h * given_h)
            q2_1 = (-_R(6.0)) * (_R(1.0) / given_h)
            q2_2 = _R(3.0) * (_R(1.0) / given_h)
            e2_2 = _R(1.5) * (_R(1.0) / given_h)
            e2_3 = _R(1.0) / (given_h * given_h)
            e1_2 = _R(0.44999998807907104) * (_R(1.0) / given_h)
            e1_3 = (-_R(1.100000023841858)) * (_R(1.0) / (given_h * given_h))
            e0_2 = (-_R(0.42500001192092896)) * (_R(1.0) / given_h)
            e0_3 = _R(0.3499999940395355) * (_R(1.0) / (given_h * given_h))
            s1 = ((given_k[1] / _R(2.0)) - _R(1.0)) + _R(2.0)
            s2 = max(s1, _R(4.0))
            deadbeat = given_deadbeat if given_deadbeat > _R(0.0) else s2
            w1_1 = (-(given_k[0] / _R(4.0))) * (_R(1.0) / (given_h * given_h))
            w1_2 = (-_R(0.5)) * (-(given_k[0] / _R(4.0))) * (_R(1.0) / given_h)
            w2_2 = (_R(1.0) - (given_k[1] / _R(2.0))) * (_R(1.0) / given_h)
            b_1 = -(_R(1.0) / (given_h * given_h))
            b_2 = (-_R(1.5)) * (_R(1.0) / given_h)
            u_max = given_u_max
            if not (
                np.isfinite(phi1_3)
                and np.isfinite(q2_1)
                and np.isfinite(q2_2)
                and np.isfinite(e2_2)
                and np.isfinite(e2_3)
                and np.isfinite(e1_2)
                and np.isfinite(e1_3)
                and np.isfinite(e0_2)
                and np.isfinite(e0_3)
                and np.isfinite(deadbeat)
                and np.isfinite(w1_1)
                and np.isfinite(w1_2)
                and np.isfinite(w2_2)
                and np.isfinite(b_1)
                and np.isfinite(b_2)
                and (given_h * given_h >= _R(1.0000000031710769e-30))
                and (_R(1.0) / (given_h * given_h) >= _R(1.0000000031710769e-30))
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._u1 = _R(0.0)
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._d_hat = _R(0.0)
            self._phi1_2 = phi1_2
            self._phi1_3 = phi1_3
            self._q2_1 = q2_1
            self._q2_2 = q2_2
            self._e2_2 = e2_2
            self._e2_3 = e2_3
            self._e1_2 = e1_2
            self._e1_3 = e1_3
            self._e0_2 = e0_2
            self._e0_3 = e0_3
            self._deadbeat = deadbeat
            self._w1_1 = w1_1
            self._w1_2 = w1_2
            self._w2_2 = w2_2
            self._b_1 = b_1
            self._b_2 = b_2
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept. Estimates too large to compute with begin anew.

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
            p1 = s1 + (self._phi1_3 * self._d_hat) + (self._phi1_3 * self._u1)
            s2 = self._x2_hat + (self._phi1_2 * self._d_hat)
            p2 = s2 + (self._phi1_2 * self._u1)
            p3 = self._d_hat

            # Correct by what is measured.
            if self._seen == 0:
                base = y[0]
                miss = _R(0.0)
            else:
                base = p1
                miss = y[0] - p1
            left_o = max((self._samples // 2) - elapsed, 0)
            o0 = _R(left_o)
            if o0 > _R(6.0):
                r0 = _R(1.0) / o0
                r1 = _R(1.0) / (o0 - _R(1.0))
                r2 = _R(1.0) / (o0 - _R(2.0))
                l1 = ((((_Q1_1 * r0) + _Q1_2) * r1) + _Q1_3) * r2
                l2 = ((self._q2_1 * r0) + self._q2_2) * r1 * r2
                l3 = _R(0.0)
            elif left_o == 6:
                l1 = _R(1.0)
                l2 = self._e0_2
                l3 = self._e0_3
            elif left_o == 5:
                l1 = _R(1.0)
                l2 = self._e1_2
                l3 = self._e1_3
            else:
                l1 = _R(1.0)
                l2 = self._e2_2
                l3 = self._e2_3
            x1 = base + (l1 * miss)
            x2 = p2 + (l2 * miss)
            d = p3 + (l3 * miss)
            left = max(self._samples - elapsed, 0)
            m0 = _R(left)
            if m0 > self._deadbeat:
                # The exact law in samples.
                z1 = (self._w1_1 * x1) + (self._w1_2 * x2)
                z2 = self._w2_2 * x2
                v = ((z1 + (z2 * m0)) / (m0 * (m0 - _R(1.0)))) - d
            else:
                # Deadbeat.
                v = ((self._b_1 * x1) + (self._b_2 * x2)) - d
            if not np.isfinite(v):
                return Control(_R(0.0), Status.RANGE)
            if elapsed < self._samples:
                if v > self._u_max:
                    u_now = self._u_max
                elif v < -self._u_max:
                    u_now = -self._u_max
                else:
                    u_now = v
            else:
                u_now = _R(0.0)
            self._u1 = u_now
            self._x1_hat = x1
            self._x2_hat = x2
            self._d_hat = d
            self._seen = 1
            if elapsed < self._samples:
                if (v > self._u_max) or (v < -self._u_max):
                    return Control(u_now, Status.SATURATED)
                else:
                    return Control(u_now, Status.OK)
            else:
                return Control(u_now, Status.AFTER)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat], dtype=_R)

    def disturbance(self) -> np.float32:
        """The estimate of the constant that is added to u."""
        return self._d_hat
