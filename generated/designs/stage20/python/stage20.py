"""
Prescribed-time controller stage20: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name stage20 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --eps=0 --f="1/4" --g="1/2" --reference input --delay=1.25
Version 0.1.0, design c90aea54cafb.

Plant: x1' = x2, x2' = f + g (u + d), d constant and unknown; u held from sample to sample,
      1.25 samples late.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
      the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
      over.
With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
      where the inputs under way count less the rho of their own samples. At sample N e is
      0 where r^(n) is constant over each sample; else an error of order h^(4-i) is left in
      e_i.
e_i = x_i - r[i-1] with r[0]..r[1] the reference and its derivatives at tick k, and rho =
      r[2], r^(n) over the sample in which u acts: its mean, (r^(n-1)(t + h) -
      r^(n-1)(t))/h, or that in its middle.

Parameters:
  samples [samples]: samples N from the start to rest
  h [s]: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
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
Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample N from any state, but for what r does between samples,
      whatever the poles, and |u| is bounded.
  sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
  deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
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

__all__ = ["Control", "Params", "Stage20", "Status"]

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
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""
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
# Weight of u1 in the law.
_C_3 = _R(2.0)
# Weight of u1 in the law.
_B_3 = _R(-2.0)
# -21/32, weight of u2 in the law.
_B_4 = _R(-0.65625)

class Stage20:
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
            given_k = _numbers(params.k, 4, "params.k")
            given_deadbeat = _R(params.deadbeat)
            if not (given_samples > 7):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 8")
            if not (1e-150 <= given_h <= 1e150):
                raise ValueError(f"params.h is {params.h}; legal: from 1e-150 to 1e150")
            if not (given_u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
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
            phi1_3 = 0.25 * (given_h * given_h)
            gamma1 = 0.109375 * (given_h * given_h)
            late_gamma1 = 0.140625 * (given_h * given_h)
            phi2_3 = 0.5 * given_h
            gamma2 = 0.125 * given_h
            late_gamma2 = 0.375 * given_h
            q2_1 = (-108.0) * (1.0 / given_h)
            q2_2 = 36.0 * (1.0 / given_h)
            q3_1 = 48.0 * (1.0 / (given_h * given_h))
            e2_2 = 1.5 * (1.0 / given_h)
            e2_3 = 2.0 * (1.0 / (given_h * given_h))
            e1_2 = 0.8571428571428571 * (1.0 / given_h)
            e1_3 = (-0.5714285714285714) * (1.0 / (given_h * given_h))
            e0_2 = 0.42857142857142855 * (1.0 / given_h)
            e0_3 = 0.2857142857142857 * (1.0 / (given_h * given_h))
            s1 = (given_k[3] - 9.0) + 4.0
            s2 = max(s1, _R(8.0))
            deadbeat = given_deadbeat if given_deadbeat > 0.0 else s2
            w1_1 = 2.0 * (-given_k[0]) * (1.0 / (given_h * given_h))
            w1_2 = (-2.5) * (-given_k[0]) * (1.0 / given_h)
            w1_4 = 0.65625 * (-given_k[0])
            s3 = 2.0 * (((1.0 - given_k[1]) + given_k[2]) - given_k[3])
            w2_2 = s3 * (1.0 / given_h)
            w2_4 = (-0.75) * (((1.0 - given_k[1]) + given_k[2]) - given_k[3])
            w3_4 = ((-7.0) - given_k[2]) + (3.0 * given_k[3])
            w4_3 = 6.0 - given_k[3]
            w4_4 = -(6.0 - given_k[3])
            b_1 = (-2.0) * (1.0 / (given_h * given_h))
            b_2 = (-5.5) * (1.0 / given_h)
            u_max = given_u_max
            if not (
                np.isfinite(phi1_3)
                and np.isfinite(gamma1)
                and np.isfinite(late_gamma1)
                and np.isfinite(phi2_3)
                and np.isfinite(gamma2)
                and np.isfinite(late_gamma2)
                and np.isfinite(q2_1)
                and np.isfinite(q2_2)
                and np.isfinite(q3_1)
                and np.isfinite(e2_2)
                and np.isfinite(e2_3)
                and np.isfinite(e1_2)
                and np.isfinite(e1_3)
                and np.isfinite(e0_2)
                and np.isfinite(e0_3)
                and np.isfinite(deadbeat)
                and np.isfinite(w1_1)
                and np.isfinite(w1_2)
                and np.isfinite(w1_4)
                and np.isfinite(w2_2)
                and np.isfinite(w2_4)
                and np.isfinite(w3_4)
                and np.isfinite(w4_3)
                and np.isfinite(w4_4)
                and np.isfinite(b_1)
                and np.isfinite(b_2)
                and (given_h * given_h >= 1e-200)
                and (1.0 / (given_h * given_h) >= 1e-200)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._u3 = _R(0.0)
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
            self._late_gamma2 = late_gamma2
            self._q2_1 = q2_1
            self._q2_2 = q2_2
            self._q3_1 = q3_1
            self._e2_2 = e2_2
            self._e2_3 = e2_3
            self._e1_2 = e1_2
            self._e1_3 = e1_3
            self._e0_2 = e0_2
            self._e0_3 = e0_3
            self._rho1 = _R(0.0)
            self._rho2 = _R(0.0)
            self._deadbeat = deadbeat
            self._w1_1 = w1_1
            self._w1_2 = w1_2
            self._w1_4 = w1_4
            self._w2_2 = w2_2
            self._w2_4 = w2_4
            self._w3_4 = w3_4
            self._w4_3 = w4_3
            self._w4_4 = w4_4
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
        if not (size <= 1e150):
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._d_hat = _R(0.0)

    def step(self, k: int, y: ArrayLike, r: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and what is measured, y = (x1, ...), and the reference.
        Call it once for each tick.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            y = _numbers(y, 1, "y")
            r = _numbers(r, 3, "r")
            if not (
                np.isfinite(y[0])
                and np.isfinite(r[0])
                and np.isfinite(r[1])
                and np.isfinite(r[2])
            ):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP

            # Predict.
            s1 = self._x1_hat + (self._phi1_2 * self._x2_hat)
            s2 = self._late_gamma1 * (self._u2 + 0.5)
            s3 = (self._gamma1 * (self._u3 + 0.5)) + s2
            p1 = s1 + (self._phi1_3 * self._d_hat) + s3
            s4 = self._late_gamma2 * (self._u2 + 0.5)
            s5 = self._x2_hat + (self._phi2_3 * self._d_hat)
            p2 = s5 + ((self._gamma2 * (self._u3 + 0.5)) + s4)
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
            if o0 > 8.0:
                o0f2 = o0 * (o0 - 1.0)
                r0 = 1.0 / (o0f2 * (o0 - 2.0))
                l1 = (_Q1_1 + (_Q1_2 * o0) + (_Q1_3 * o0f2)) * r0
                l2 = (self._q2_1 + (self._q2_2 * o0)) * r0
                l3 = self._q3_1 * r0
            elif left_o == 8:
                l1 = _R(1.0)
                l2 = self._e0_2
                l3 = self._e0_3
            elif left_o == 7:
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

            # The tracking error.
            e1 = x1 - r[0]
            e2 = x2 - r[1]
            left = max(self._samples - elapsed, 0)
            m0 = _R(left)
            if m0 > self._deadbeat:
                # The exact law in samples.
                s6 = self._w1_4 * ((self._u2 + (d + 0.5)) - (2.0 * self._rho2))
                z1 = (self._w1_1 * e1) + (self._w1_2 * e2) + s6
                s7 = self._w2_4 * ((self._u2 + (d + 0.5)) - (2.0 * self._rho2))
                z2 = (self._w2_2 * e2) + s7
                z3 = self._w3_4 * ((self._u2 + (d + 0.5)) - (2.0 * self._rho2))
                s8 = self._w4_3 * ((self._u1 + (d + 0.5)) - (2.0 * self._rho1))
                z4 = s8 + (self._w4_4 * ((self._u2 + (d + 0.5)) - (2.0 * self._rho2)))
                m0f2 = m0 * (m0 - 1.0)
                m0f3 = m0f2 * (m0 - 2.0)
                s9 = _C_3 * ((self._u1 + (d + 0.5)) - (2.0 * self._rho1))
                s10 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0))
                s11 = (s10 + (s9 - ((self._u2 + (d + 0.5)) - (2.0 * self._rho2)))) - (d + 0.5)
                v = s11 + (2.0 * r[2])
            else:
                # Deadbeat.
                s12 = _B_3 * ((self._u1 + (d + 0.5)) - (2.0 * self._rho1))
                s13 = _B_4 * ((self._u2 + (d + 0.5)) - (2.0 * self._rho2))
                s14 = ((self._b_1 * e1) + (self._b_2 * e2) + s12 + s13) - (d + 0.5)
                v = s14 + (2.0 * r[2])
            if not np.isfinite(v):
                return Control(_R(0.0), Status.RANGE)
            if v > self._u_max:
                u_now = self._u_max
            elif v < -self._u_max:
                u_now = -self._u_max
            else:
                u_now = v
            self._u3 = self._u2
            self._u2 = self._u1
            self._u1 = u_now
            self._rho2 = self._rho1
            self._rho1 = r[2]
            self._x1_hat = x1
            self._x2_hat = x2
            self._d_hat = d
            self._seen = 1
            if (v > self._u_max) or (v < -self._u_max):
                return Control(u_now, Status.SATURATED)
            elif elapsed < self._samples:
                return Control(u_now, Status.OK)
            else:
                return Control(u_now, Status.HOLD)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the constant that is added to u."""
        return self._d_hat
