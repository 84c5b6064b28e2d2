"""
Prescribed-time controller stage11: order n = 4, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 4 --mu "exp(a=1)" --name stage11 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6,-7,-8 --precision f32 --eps=0 --sample-time=0.01
Version 0.1.0, design a4fcc16c71ec.

Plant: x1' = x2, ..., x4' = (u + d), d constant and unknown; u held from sample to sample.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
      the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
      over.

Parameters:
  samples [samples]: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
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

__all__ = ["Control", "Params", "Stage11", "Status"]

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
    """samples N from the start to rest [samples], at least 10"""
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

# 1/100, prediction of x1 from x2.
_PHI1_2 = _R(_R(0.009999999776482582))
# 1/20000, prediction of x1 from x3.
_PHI1_3 = _R(_R(4.999999873689376e-5))
# 1/6000000, prediction of x1 from x4.
_PHI1_4 = _R(_R(1.6666666624587378e-7))
# 1/2400000000, prediction of x1 from d.
_PHI1_5 = _R(_R(4.1666667338624563e-10))
# 1/2400000000, prediction from u.
_GAMMA1 = _R(_R(4.1666667338624563e-10))
# 1/100, prediction of x2 from x3.
_PHI2_3 = _R(_R(0.009999999776482582))
# 1/20000, prediction of x2 from x4.
_PHI2_4 = _R(_R(4.999999873689376e-5))
# 1/6000000, prediction of x2 from d.
_PHI2_5 = _R(_R(1.6666666624587378e-7))
# 1/6000000, prediction from u.
_GAMMA2 = _R(_R(1.6666666624587378e-7))
# 1/100, prediction of x3 from x4.
_PHI3_4 = _R(_R(0.009999999776482582))
# 1/20000, prediction of x3 from d.
_PHI3_5 = _R(_R(4.999999873689376e-5))
# 1/20000, prediction from u.
_GAMMA3 = _R(_R(4.999999873689376e-5))
# 1/100, prediction of x4 from d.
_PHI4_5 = _R(_R(0.009999999776482582))
# 1/100, prediction from u.
_GAMMA4 = _R(_R(0.009999999776482582))
# Weight in the observer's gain l1.
_Q1_1 = _R(_R(6720.0))
# Weight in the observer's gain l1.
_Q1_2 = _R(-_R(4200.0))
# Weight in the observer's gain l1.
_Q1_3 = _R(_R(1200.0))
# Weight in the observer's gain l1.
_Q1_4 = _R(-_R(200.0))
# Weight in the observer's gain l1.
_Q1_5 = _R(_R(20.0))
# Weight in the observer's gain l2.
_Q2_1 = _R(-_R(808000.0))
# Weight in the observer's gain l2.
_Q2_2 = _R(_R(454000.0))
# Weight in the observer's gain l2.
_Q2_3 = _R(-_R(108000.0))
# Weight in the observer's gain l2.
_Q2_4 = _R(_R(12000.0))
# Weight in the observer's gain l3.
_Q3_1 = _R(_R(38400000.0))
# Weight in the observer's gain l3.
_Q3_2 = _R(-_R(16800000.0))
# Weight in the observer's gain l3.
_Q3_3 = _R(_R(2400000.0))
# Weight in the observer's gain l4.
_Q4_1 = _R(-_R(480000000.0))
# Weight in the observer's gain l4.
_Q4_2 = _R(_R(120000000.0))
# 1675/33, gain of the observer at its end.
_E0_2 = _R(_R(50.75757598876953))
# 1092500/297, gain of the observer at its end.
_E0_3 = _R(_R(3678.451171875))
# -500000/3, gain of the observer at its end.
_E0_4 = _R(-_R(166666.671875))
# 700000000/99, gain of the observer at its end.
_E0_5 = _R(_R(7070707.0))
# 7850/99, gain of the observer at its end.
_E1_2 = _R(_R(79.29293060302734))
# -140000/99, gain of the observer at its end.
_E1_3 = _R(-_R(1414.141357421875))
# 23000000/33, gain of the observer at its end.
_E1_4 = _R(_R(696969.6875))
# -1600000000/33, gain of the observer at its end.
_E1_5 = _R(-_R(48484848.0))
# 950/9, gain of the observer at its end.
_E2_2 = _R(_R(105.55555725097656))
# -10000/9, gain of the observer at its end.
_E2_3 = _R(-_R(1111.111083984375))
# -1000000/3, gain of the observer at its end.
_E2_4 = _R(-_R(333333.34375))
# 400000000/3, gain of the observer at its end.
_E2_5 = _R(_R(133333336.0))
# 1250/9, gain of the observer at its end.
_E3_2 = _R(_R(138.88888549804688))
# 100000/27, gain of the observer at its end.
_E3_3 = _R(_R(3703.70361328125))
# -5000000/3, gain of the observer at its end.
_E3_4 = _R(-_R(1666666.625))
# -1600000000/9, gain of the observer at its end.
_E3_5 = _R(-_R(177777776.0))
# 625/3, gain of the observer at its end.
_E4_2 = _R(_R(208.3333282470703))
# 87500/3, gain of the observer at its end.
_E4_3 = _R(_R(29166.666015625))
# Gain of the observer at its end.
_E4_4 = _R(_R(2500000.0))
# Gain of the observer at its end.
_E4_5 = _R(_R(100000000.0))
# Weight of x1 in the law.
_B_1 = _R(-_R(100000000.0))
# Weight of x2 in the law.
_B_2 = _R(-_R(2500000.0))
# -87500/3, weight of x3 in the law.
_B_3 = _R(-_R(29166.666015625))
# -625/3, weight of x4 in the law.
_B_4 = _R(-_R(208.3333282470703))

class Stage11:
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
            if not (given_samples > 9):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 10")
            if not (given_u_max > _R(0.0)):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not np.isfinite(given_k[0]):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(given_k[1]):
                raise ValueError(f"params.k[1] is {params.k[1]}; legal: finite")
            if not np.isfinite(given_k[2]):
                raise ValueError(f"params.k[2] is {params.k[2]}; legal: finite")
            if not np.isfinite(given_k[3]):
                raise ValueError(f"params.k[3] is {params.k[3]}; legal: finite")
            if not (np.isfinite(given_deadbeat) and (given_deadbeat >= _R(0.0))):
                raise ValueError(f"params.deadbeat is {params.deadbeat}; legal: >= 0")
            samples = given_samples
            s1 = (given_k[3] - _R(9.0)) + _R(4.0)
            s2 = max(s1, _R(8.0))
            deadbeat = given_deadbeat if given_deadbeat > _R(0.0) else s2
            w1_1 = _R(100000000.0) * (-given_k[0])
            w1_2 = _R(1000000.0) * ((-_R(1.5)) * (-given_k[0]))
            w1_3 = _R(10000.0) * (_R(0.9166666865348816) * (-given_k[0]))
            w1_4 = _R(100.0) * ((-_R(0.25)) * (-given_k[0]))
            s3 = ((_R(1.0) - given_k[1]) + given_k[2]) - given_k[3]
            w2_2 = _R(1000000.0) * s3
            s4 = -(((_R(1.0) - given_k[1]) + given_k[2]) - given_k[3])
            w2_3 = _R(10000.0) * s4
            s5 = ((_R(1.0) - given_k[1]) + given_k[2]) - given_k[3]
            w2_4 = _R(100.0) * (_R(0.3333333432674408) * s5)
            w3_3 = _R(10000.0) * (((-_R(7.0)) - given_k[2]) + (_R(3.0) * given_k[3]))
            w3_4 = _R(100.0) * ((-_R(0.5)) * (((-_R(7.0)) - given_k[2]) + (_R(3.0) * given_k[3])))
            w4_4 = _R(100.0) * (_R(6.0) - given_k[3])
            u_max = given_u_max
            if not (
                np.isfinite(deadbeat)
                and np.isfinite(w1_1)
                and np.isfinite(w1_2)
                and np.isfinite(w1_3)
                and np.isfinite(w1_4)
                and np.isfinite(w2_2)
                and np.isfinite(w2_3)
                and np.isfinite(w2_4)
                and np.isfinite(w3_3)
                and np.isfinite(w3_4)
                and np.isfinite(w4_4)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._u1 = _R(0.0)
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x3_hat = _R(0.0)
            self._x4_hat = _R(0.0)
            self._d_hat = _R(0.0)
            self._deadbeat = deadbeat
            self._w1_1 = w1_1
            self._w1_2 = w1_2
            self._w1_3 = w1_3
            self._w1_4 = w1_4
            self._w2_2 = w2_2
            self._w2_3 = w2_3
            self._w2_4 = w2_4
            self._w3_3 = w3_3
            self._w3_4 = w3_4
            self._w4_4 = w4_4
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept. Estimates too large to compute with begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        s1 = np.abs(self._x1_hat) + np.abs(self._x2_hat) + np.abs(self._x3_hat)
        size = s1 + np.abs(self._x4_hat) + np.abs(self._d_hat)
        if not (size <= _R(9.999999843067494e17)):
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x3_hat = _R(0.0)
            self._x4_hat = _R(0.0)
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
            s2 = s1 + (_PHI1_3 * self._x3_hat)
            s3 = s2 + (_PHI1_4 * self._x4_hat)
            s4 = s3 + (_PHI1_5 * self._d_hat)
            p1 = s4 + (_GAMMA1 * self._u1)
            s5 = self._x2_hat + (_PHI2_3 * self._x3_hat)
            s6 = s5 + (_PHI2_4 * self._x4_hat)
            s7 = s6 + (_PHI2_5 * self._d_hat)
            p2 = s7 + (_GAMMA2 * self._u1)
            s8 = self._x3_hat + (_PHI3_4 * self._x4_hat)
            s9 = s8 + (_PHI3_5 * self._d_hat)
            p3 = s9 + (_GAMMA3 * self._u1)
            s10 = self._x4_hat + (_PHI4_5 * self._d_hat)
            p4 = s10 + (_GAMMA4 * self._u1)
            p5 = self._d_hat

            # Correct by what is measured.
            if self._seen == 0:
                base = y[0]
                miss = _R(0.0)
            else:
                base = p1
                miss = y[0] - p1
            left_o = max((self._samples // 2) - elapsed, 0)
            o0 = _R(left_o)
            if o0 > _R(12.0):
                r0 = _R(1.0) / o0
                r1 = _R(1.0) / (o0 - _R(1.0))
                r2 = _R(1.0) / (o0 - _R(2.0))
                r3 = _R(1.0) / (o0 - _R(3.0))
                r4 = _R(1.0) / (o0 - _R(4.0))
                s11 = ((((_Q1_1 * r0) + _Q1_2) * r1) + _Q1_3) * r2
                l1 = (((s11 + _Q1_4) * r3) + _Q1_5) * r4
                s12 = ((((_Q2_1 * r0) + _Q2_2) * r1) + _Q2_3) * r2
                l2 = (s12 + _Q2_4) * r3 * r4
                s13 = ((((_Q3_1 * r0) + _Q3_2) * r1) + _Q3_3) * r2
                l3 = s13 * r3 * r4
                l4 = ((_Q4_1 * r0) + _Q4_2) * r1 * r2 * r3 * r4
                l5 = _R(0.0)
            elif left_o == 12:
                l1 = _R(1.0)
                l2 = _E0_2
                l3 = _E0_3
                l4 = _E0_4
                l5 = _E0_5
            elif left_o == 11:
                l1 = _R(1.0)
                l2 = _E1_2
                l3 = _E1_3
                l4 = _E1_4
                l5 = _E1_5
            elif left_o == 10:
                l1 = _R(1.0)
                l2 = _E2_2
                l3 = _E2_3
                l4 = _E2_4
                l5 = _E2_5
            elif left_o == 9:
                l1 = _R(1.0)
                l2 = _E3_2
                l3 = _E3_3
                l4 = _E3_4
                l5 = _E3_5
            else:
                l1 = _R(1.0)
                l2 = _E4_2
                l3 = _E4_3
                l4 = _E4_4
                l5 = _E4_5
            x1 = base + (l1 * miss)
            x2 = p2 + (l2 * miss)
            x3 = p3 + (l3 * miss)
            x4 = p4 + (l4 * miss)
            d = p5 + (l5 * miss)
            left = max(self._samples - elapsed, 0)
            m0 = _R(left)
            if m0 > self._deadbeat:
                # The exact law in samples.
                s14 = (self._w1_1 * x1) + (self._w1_2 * x2) + (self._w1_3 * x3)
                z1 = s14 + (self._w1_4 * x4)
                z2 = (self._w2_2 * x2) + (self._w2_3 * x3) + (self._w2_4 * x4)
                z3 = (self._w3_3 * x3) + (self._w3_4 * x4)
                z4 = self._w4_4 * x4
                s15 = (((((z1 / m0) + z2) / (m0 - _R(1.0))) + z3) / (m0 - _R(2.0))) + z4
                v = (s15 / (m0 - _R(3.0))) - d
            else:
                # Deadbeat.
                s16 = (_B_1 * x1) + (_B_2 * x2) + (_B_3 * x3)
                v = (s16 + (_B_4 * x4)) - d
            if not np.isfinite(v):
                return Control(_R(0.0), Status.RANGE)
            if v > self._u_max:
                u_now = self._u_max
            elif v < -self._u_max:
                u_now = -self._u_max
            else:
                u_now = v
            self._u1 = u_now
            self._x1_hat = x1
            self._x2_hat = x2
            self._x3_hat = x3
            self._x4_hat = x4
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
        return np.array([self._x1_hat, self._x2_hat, self._x3_hat, self._x4_hat], dtype=_R)

    def disturbance(self) -> np.float32:
        """The estimate of the constant that is added to u."""
        return self._d_hat
