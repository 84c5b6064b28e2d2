"""
Prescribed-time controller stage12: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name stage12 --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0],[0,0,1]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --after-observer=-90+20i,-90-20i,-100,-120 --eps=0 --sample-time=1e-3 --delay=1
Version 0.1.0, design 69fef31f4d23.

Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
      sample to sample, one sample late, y = C x.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M samples to go and z = S x, the differences of a flat output, u = sum of row_j
      z_j/((M-j+1)...(M-3)) less the drift of z; the rows are those of Theorem 1 for the
      mapping exp. Close to the end deadbeat takes over.

Parameters:
  samples [samples]: samples N from the start to rest
  h = 1e-3 [s], fixed: sample period
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
The estimates are exact from sample N/2 after the start on where the measurement is; from
      there on the observer has the poles after_observer.
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

__all__ = ["Control", "Params", "Stage12", "Status"]

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

# Prediction from u.
_GAMMA1 = _R(0.00010816330676811052)
# Prediction from u.
_GAMMA2 = _R(0.30941358230147875)
# Prediction from u.
_GAMMA3 = _R(0.37459048481653323)
# Weight in the observer's gain l1_1.
_Q1_1_1 = _R(-8.0)
# Weight in the observer's gain l1_1.
_Q1_1_2 = _R(8.0)
# Weight in the observer's gain l1_2.
_Q1_2_1 = _R(12007.013438558752)
# Weight in the observer's gain l1_2.
_Q1_2_2 = _R(-4.007472019404232)
# Weight in the observer's gain l1_4.
_Q1_4_1 = _R(359.9910335767149)
# Weight in the observer's gain l2_2.
_Q2_2_1 = _R(-18.578489051610646)
# Weight in the observer's gain l2_2.
_Q2_2_2 = _R(9.913794744612098)
# Weight in the observer's gain l2_3.
_Q2_3_1 = _R(-12.0)
# Weight in the observer's gain l2_3.
_Q2_3_2 = _R(12.0)
# Weight in the observer's gain l2_4.
_Q2_4_1 = _R(79.8275894892242)
# Gain of the observer at its end.
_E0_1_1 = _R(0.9995008164815138)
# Gain of the observer at its end.
_E0_1_2 = _R(-0.4960345371406728)
# Gain of the observer at its end.
_E0_1_3 = _R(0.005627803367048088)
# Gain of the observer at its end.
_E0_2_1 = _R(0.0014420897963740578)
# Gain of the observer at its end.
_E0_2_2 = _R(2.2101945239792857)
# Gain of the observer at its end.
_E0_2_3 = _R(1.0319275340206813)
# Gain of the observer at its end.
_E0_2_4 = _R(1.3304598248204031)
# Gain of the observer at its end.
_E1_1_1 = _R(1.9995008164815138)
# Gain of the observer at its end.
_E1_1_2 = _R(999.2535286720462)
# Gain of the observer at its end.
_E1_1_3 = _R(0.005627803367048088)
# Gain of the observer at its end.
_E1_1_4 = _R(29.999252798059576)
# Gain of the observer at its end.
_E1_2_1 = _R(0.0014420897963740578)
# Gain of the observer at its end.
_E1_2_2 = _R(2.4788577332214805)
# Gain of the observer at its end.
_E1_2_3 = _R(1.5319275340206813)
# Gain of the observer at its end.
_E1_2_4 = _R(2.6609196496408063)
# Prediction of x1 from x2.
_PHI1_2 = _R(0.000996505559752715)
# Prediction of x1 from x3.
_PHI1_3 = _R(0.0006188271646029575)
# Prediction of x1 from d.
_PHI1_4 = _R(0.00010816330676811052)
# Prediction of x2 from x2.
_PHI2_2 = _R(0.9902193397510792)
# Prediction of x2 from x3.
_PHI2_3 = _R(1.1234620408672982)
# Prediction of x2 from d.
_PHI2_4 = _R(0.30941358230147875)
# Prediction of x3 from x2.
_PHI3_2 = _R(-0.011234620408672982)
# Prediction of x3 from x3.
_PHI3_3 = _R(0.5412090107511158)
# Prediction of x3 from d.
_PHI3_4 = _R(0.37459048481653323)
# Weight of x2 in the law.
_C_2 = _R(-0.014068298956658285)
# Weight of x3 in the law.
_C_3 = _R(-0.5288375642249519)
# Weight of u1 in the law.
_C_4 = _R(1.468571649497805)
# Weight of x1 in the law.
_B_1 = _R(-1776.8479601183408)
# Weight of x2 in the law.
_B_2 = _R(-5.132434542441746)
# Weight of x3 in the law.
_B_3 = _R(-6.801905651476086)
# Weight of u1 in the law.
_B_4 = _R(-2.5314283505021953)

class Stage12:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_samples = params.samples.__index__()
            if given_samples != given_samples & _WRAP:
                raise ValueError(f"params.samples is {params.samples}; legal: 0..2^32 - 1")
            given_u_max = _R(params.u_max)
            given_k = _numbers(params.k, 4, "params.k")
            given_deadbeat = _R(params.deadbeat)
            if not (given_samples > 7):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 8")
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
            s1 = (given_k[3] - 9.0) + 4.0
            s2 = max(s1, _R(8.0))
            deadbeat = given_deadbeat if given_deadbeat > 0.0 else s2
            w1_1 = 1776.8479601183408 * (-given_k[0])
            w1_2 = (-1.8656772383860403) * (-given_k[0])
            w1_3 = 1.0279922805444073 * (-given_k[0])
            s3 = ((1.0 - given_k[1]) + given_k[2]) - given_k[3]
            w2_2 = 1.7773373232410332 * s3
            s4 = ((1.0 - given_k[1]) + given_k[2]) - given_k[3]
            w2_3 = (-1.4680893680774487) * s4
            s5 = ((-7.0) - given_k[2]) + (3.0 * given_k[3])
            w3_2 = (-0.0008901057299880047) * s5
            s6 = ((-7.0) - given_k[2]) + (3.0 * given_k[3])
            w3_3 = 2.670317189964014 * s6
            w4_2 = (-0.02999129417826937) * (6.0 - given_k[3])
            w4_3 = (-1.2261174651918907) * (6.0 - given_k[3])
            w4_4 = 6.0 - given_k[3]
            u_max = given_u_max
            if not (
                np.isfinite(deadbeat)
                and np.isfinite(w1_1)
                and np.isfinite(w1_2)
                and np.isfinite(w1_3)
                and np.isfinite(w2_2)
                and np.isfinite(w2_3)
                and np.isfinite(w3_2)
                and np.isfinite(w3_3)
                and np.isfinite(w4_2)
                and np.isfinite(w4_3)
                and np.isfinite(w4_4)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x1_next = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x2_next = _R(0.0)
            self._x3_hat = _R(0.0)
            self._x3_next = _R(0.0)
            self._d_hat = _R(0.0)
            self._d_next = _R(0.0)
            self._deadbeat = deadbeat
            self._w1_1 = w1_1
            self._w1_2 = w1_2
            self._w1_3 = w1_3
            self._w2_2 = w2_2
            self._w2_3 = w2_3
            self._w3_2 = w3_2
            self._w3_3 = w3_3
            self._w4_2 = w4_2
            self._w4_3 = w4_3
            self._w4_4 = w4_4
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept. Estimates too large to compute with begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        s1 = np.abs(self._x1_next) + np.abs(self._x2_next)
        size = s1 + np.abs(self._x3_next) + np.abs(self._d_next)
        if not (size <= 1e150):
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x1_next = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x2_next = _R(0.0)
            self._x3_hat = _R(0.0)
            self._x3_next = _R(0.0)
            self._d_hat = _R(0.0)
            self._d_next = _R(0.0)

    def step(self, k: int, y: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each
        tick.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            y = _numbers(y, 2, "y")
            if not (np.isfinite(y[0]) and np.isfinite(y[1])):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP

            # The estimates; at first what y shows.
            if self._seen == 0:
                x1 = y[0]
                x2 = _R(0.0)
                x3 = y[1]
                d = _R(0.0)
            else:
                x1 = self._x1_next + (_GAMMA1 * self._u2)
                x2 = self._x2_next + (_GAMMA2 * self._u2)
                x3 = self._x3_next + (_GAMMA3 * self._u2)
                d = self._d_next

            # Prediction of the next sample.
            miss1 = y[0] - x1
            miss2 = y[1] - x3
            off1 = miss1
            off2 = miss2
            left_o = max((self._samples // 2) - elapsed, 0)
            o0 = _R(left_o)
            if left_o == 0:
                l1_1 = _R(0.17200400622757925)
                l1_2 = _R(7.693835124666324)
                l1_3 = _R(0.005627803367048088)
                l1_4 = _R(0.23319622641969587)
                l2_1 = _R(0.0014420897963740578)
                l2_2 = _R(1.2843129003368876)
                l2_3 = _R(-0.2598303207324358)
                l2_4 = _R(0.028634005234458536)
            elif o0 > 8.0:
                r0 = 1.0 / (o0 * (o0 - 1.0))
                s1 = (_Q1_1_1 + (_Q1_1_2 * o0)) * r0
                l1_1 = s1 - 0.0004991835184862197
                s2 = (_Q1_2_1 + (_Q1_2_2 * o0)) * r0
                l1_2 = s2 + 0.004899465284856127
                l1_3 = _R(0.005627803367048088)
                l1_4 = _Q1_4_1 * r0
                l2_1 = _R(0.0014420897963740578)
                s3 = (_Q2_2_1 + (_Q2_2_2 * o0)) * r0
                l2_2 = s3 + 1.1153817526860825
                s4 = (_Q2_3_1 + (_Q2_3_2 * o0)) * r0
                l2_3 = s4 - 0.46807246597931873
                l2_4 = _Q2_4_1 * r0
            elif left_o == 8:
                l1_1 = _E0_1_1
                l1_2 = _E0_1_2
                l1_3 = _E0_1_3
                l1_4 = _R(0.0)
                l2_1 = _E0_2_1
                l2_2 = _E0_2_2
                l2_3 = _E0_2_3
                l2_4 = _E0_2_4
            else:
                l1_1 = _E1_1_1
                l1_2 = _E1_1_2
                l1_3 = _E1_1_3
                l1_4 = _E1_1_4
                l2_1 = _E1_2_1
                l2_2 = _E1_2_2
                l2_3 = _E1_2_3
                l2_4 = _E1_2_4
            s5 = x1 + (_PHI1_2 * x2) + (_PHI1_3 * x3)
            x1_on = s5 + (_PHI1_4 * d) + (l1_1 * off1) + (l2_1 * off2)
            s6 = (_PHI2_2 * x2) + (_PHI2_3 * x3)
            x2_on = s6 + (_PHI2_4 * d) + (l1_2 * off1) + (l2_2 * off2)
            s7 = (_PHI3_2 * x2) + (_PHI3_3 * x3)
            x3_on = s7 + (_PHI3_4 * d) + (l1_3 * off1) + (l2_3 * off2)
            d_on = d + (l1_4 * off1) + (l2_4 * off2)
            left = max(self._samples - elapsed, 0)
            m0 = _R(left)
            if m0 > self._deadbeat:
                # The exact law in samples.
                z1 = (self._w1_1 * x1) + (self._w1_2 * x2) + (self._w1_3 * x3)
                z2 = (self._w2_2 * x2) + (self._w2_3 * x3)
                z3 = (self._w3_2 * x2) + (self._w3_3 * x3)
                s8 = (self._w4_2 * x2) + (self._w4_3 * x3)
                z4 = s8 + (self._w4_4 * (self._u1 + d))
                m0f2 = m0 * (m0 - 1.0)
                m0f3 = m0f2 * (m0 - 2.0)
                s9 = (_C_2 * x2) + (_C_3 * x3)
                s10 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0))
                v = (s10 + (s9 + (_C_4 * (self._u1 + d)))) - d
            else:
                # Deadbeat.
                s11 = (_B_1 * x1) + (_B_2 * x2) + (_B_3 * x3)
                v = (s11 + (_B_4 * (self._u1 + d))) - d
            if not (
                np.isfinite(v)
                and np.isfinite(x1_on)
                and np.isfinite(x2_on)
                and np.isfinite(x3_on)
                and np.isfinite(d_on)
            ):
                return Control(_R(0.0), Status.RANGE)
            if v > self._u_max:
                u_now = self._u_max
            elif v < -self._u_max:
                u_now = -self._u_max
            else:
                u_now = v
            self._u2 = self._u1
            self._u1 = u_now
            self._x1_hat = x1
            self._x1_next = x1_on
            self._x2_hat = x2
            self._x2_next = x2_on
            self._x3_hat = x3
            self._x3_next = x3_on
            self._d_hat = d
            self._d_next = d_on
            self._seen = 1
            if (v > self._u_max) or (v < -self._u_max):
                return Control(u_now, Status.SATURATED)
            elif elapsed < self._samples:
                return Control(u_now, Status.OK)
            else:
                return Control(u_now, Status.HOLD)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat, self._x3_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the constant that is added to u."""
        return self._d_hat
