"""
Prescribed-time controller stage43: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name stage43 --clock samples --delay-law=predict --measured=x1 --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --tau=0.4 --eps=0 --u-max=6 --poles="least-energy(weight=1)" --reference="t^2/2" --sample-time=1e-2 --delay=2.75
Version 0.1.0, design c760bae9e1f5.

Plant: x1' = x2, ..., x3' = (u + d), d constant and unknown; u held from sample to sample,
      2.75 samples late.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law of the state x predicted for the time from which u acts, by x and the inputs under way:
      with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
      the rows are those of Theorem 1 for the mapping exp. The gains of 6 samples to go
      stay: they are deadbeat.
With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
      where the inputs under way count less the rho of their own samples. At sample N e is
      0 where r^(n) is constant over each sample; else an error of order h^(5-i) is left in
      e_i.
t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
      which u acts:
  e_i = x_i - r^(i-1), with the reference r = t^2/2
  r^(1) = t
  r^(2) = 1

Parameters:
  samples = 40 [samples], fixed: samples N from the start to rest
  h = 1e-2 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max = 6 [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
The estimates are exact from sample 20 after the start on where the measurement is; with
      noise or sensor_step given, or observer_eps, the gains of the observer are then held
      below deadbeat.
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample 40 from any state, but for what r does between samples,
      whatever the poles, and |u| is bounded.
  sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
  deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
  loop: not checked: `x0_max` is not given.
  envelope: not checked: it does not examine a clock in samples.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Params", "Stage43", "Status"]

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

# 1/100, prediction of x1 from x2.
_PHI1_2 = _R(0.01)
# 1/20000, prediction of x1 from x3.
_PHI1_3 = _R(5e-5)
# 21/128000000, prediction from u.
_GAMMA1 = _R(1.640625e-7)
# 1/384000000, prediction from u.
_LATE_GAMMA1 = _R(2.604166666666667e-9)
# 1/6000000, prediction of x1 from d.
_PHI1_4 = _R(1.6666666666666668e-7)
# 1/100, prediction of x2 from x3.
_PHI2_3 = _R(0.01)
# 3/64000, prediction from u.
_GAMMA2 = _R(4.6875e-5)
# 1/320000, prediction from u.
_LATE_GAMMA2 = _R(3.125e-6)
# 1/20000, prediction of x2 from d.
_PHI2_4 = _R(5e-5)
# 3/400, prediction from u.
_GAMMA3 = _R(0.0075)
# 1/400, prediction from u.
_LATE_GAMMA3 = _R(0.0025)
# 1/100, prediction of x3 from d.
_PHI3_4 = _R(0.01)
# Samples of the round of the observer.
_OBSERVER_SAMPLES = 20
# Weight in the observer's gain l1.
_Q1_1 = _R(-840.0)
# Weight in the observer's gain l1.
_Q1_2 = _R(480.0)
# Weight in the observer's gain l1.
_Q1_3 = _R(-120.0)
# Weight in the observer's gain l1.
_Q1_4 = _R(16.0)
# Weight in the observer's gain l2.
_Q2_1 = _R(90800.0)
# Weight in the observer's gain l2.
_Q2_2 = _R(-43200.0)
# Weight in the observer's gain l2.
_Q2_3 = _R(7200.0)
# Weight in the observer's gain l3.
_Q3_1 = _R(-3360000.0)
# Weight in the observer's gain l3.
_Q3_2 = _R(960000.0)
# Weight in the observer's gain l4.
_Q4_1 = _R(24000000.0)
# 430/9, gain of the observer at its end.
_E0_2 = _R(47.77777777777778)
# 8000/3, gain of the observer at its end.
_E0_3 = _R(2666.6666666666665)
# -200000/3, gain of the observer at its end.
_E0_4 = _R(-66666.66666666667)
# 2200/27, gain of the observer at its end.
_E1_2 = _R(81.48148148148148)
# -20000/9, gain of the observer at its end.
_E1_3 = _R(-2222.222222222222)
# 4000000/9, gain of the observer at its end.
_E1_4 = _R(444444.44444444444)
# 350/3, gain of the observer at its end.
_E2_2 = _R(116.66666666666667)
# Gain of the observer at its end.
_E2_4 = _R(-1000000.0)
# 550/3, gain of the observer at its end.
_E3_2 = _R(183.33333333333334)
# Gain of the observer at its end.
_E3_3 = _R(20000.0)
# Gain of the observer at its end.
_E3_4 = _R(1000000.0)
# 1/100, sample period.
_H = _R(0.01)
# Weight of x1 in the law.
_W1_1 = _R(-120000000.0)
# Weight of x2 in the law.
_W1_2 = _R(-2100000.0)
# Weight of x3 in the law.
_W1_3 = _R(-16375.0)
# -1155/16, weight of u3 in the law.
_W1_6 = _R(-72.1875)
# Weight of x2 in the law.
_W2_2 = _R(-600000.0)
# Weight of x3 in the law.
_W2_3 = _R(-13500.0)
# Weight of u2 in the law.
_W2_5 = _R(-60.0)
# -675/8, weight of u3 in the law.
_W2_6 = _R(-84.375)
# Weight of x3 in the law.
_W3_3 = _R(-1200.0)
# Weight of u1 in the law.
_W3_4 = _R(-12.0)
# Weight of u2 in the law.
_W3_5 = _R(-12.0)
# Weight of u3 in the law.
_W3_6 = _R(-9.0)
# Bound of |u|.
_U_MAX = _R(6.0)
# Samples from the start to rest.
_SAMPLES = 40

class Stage43:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            self._start = 0
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._u3 = _R(0.0)
            self._u4 = _R(0.0)
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x3_hat = _R(0.0)
            self._d_hat = _R(0.0)

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. The time of the reference counts
        from there. Estimates and inputs under way are kept. Estimates too large to compute with
        begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        s1 = np.abs(self._x1_hat) + np.abs(self._x2_hat) + np.abs(self._x3_hat)
        size = s1 + np.abs(self._d_hat)
        if not (size <= 1e150):
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x3_hat = _R(0.0)
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
            s3 = (_GAMMA1 * self._u4) + (_LATE_GAMMA1 * self._u3)
            p1 = s2 + (_PHI1_4 * self._d_hat) + s3
            s4 = self._x2_hat + (_PHI2_3 * self._x3_hat)
            s5 = (_GAMMA2 * self._u4) + (_LATE_GAMMA2 * self._u3)
            p2 = s4 + (_PHI2_4 * self._d_hat) + s5
            s6 = (_GAMMA3 * self._u4) + (_LATE_GAMMA3 * self._u3)
            p3 = self._x3_hat + (_PHI3_4 * self._d_hat) + s6
            p4 = self._d_hat

            # Correct by what is measured.
            if self._seen == 0:
                base = y[0]
                miss = _R(0.0)
            else:
                base = p1
                miss = y[0] - p1
            left_o = max(_OBSERVER_SAMPLES - elapsed, 0)
            o0 = _R(left_o)
            if o0 > 10.0:
                o0f2 = o0 * (o0 - 1.0)
                o0f3 = o0f2 * (o0 - 2.0)
                r0 = 1.0 / (o0f3 * (o0 - 3.0))
                s7 = _Q1_1 + (_Q1_2 * o0) + (_Q1_3 * o0f2)
                l1 = (s7 + (_Q1_4 * o0f3)) * r0
                l2 = (_Q2_1 + (_Q2_2 * o0) + (_Q2_3 * o0f2)) * r0
                l3 = (_Q3_1 + (_Q3_2 * o0)) * r0
                l4 = _Q4_1 * r0
            elif left_o == 10:
                l1 = _R(1.0)
                l2 = _E0_2
                l3 = _E0_3
                l4 = _E0_4
            elif left_o == 9:
                l1 = _R(1.0)
                l2 = _E1_2
                l3 = _E1_3
                l4 = _E1_4
            elif left_o == 8:
                l1 = _R(1.0)
                l2 = _E2_2
                l3 = _R(0.0)
                l4 = _E2_4
            else:
                l1 = _R(1.0)
                l2 = _E3_2
                l3 = _E3_3
                l4 = _E3_4
            x1 = base + (l1 * miss)
            x2 = p2 + (l2 * miss)
            x3 = p3 + (l3 * miss)
            d = p4 + (l4 * miss)

            # The tracking error.
            t = _R(elapsed) * _H
            reference1 = t
            reference0 = reference1 * reference1 * 0.5
            e1 = x1 - reference0
            e2 = x2 - reference1
            e3 = x3 - 1.0

            # The exact law in samples.
            m0 = _R((40 - elapsed) & _WRAP) if elapsed < 34 else _R(6.0)
            s8 = (_W1_1 * e1) + (_W1_2 * e2) + (_W1_3 * e3)
            z1 = s8 + (_W1_6 * (self._u3 + d))
            s9 = (_W2_2 * e2) + (_W2_3 * e3)
            s10 = s9 + (_W2_5 * (self._u2 + d))
            z2 = s10 + (_W2_6 * (self._u3 + d))
            s11 = (_W3_3 * e3) + (_W3_4 * (self._u1 + d))
            s12 = s11 + (_W3_5 * (self._u2 + d))
            z3 = s12 + (_W3_6 * (self._u3 + d))
            m0f2 = m0 * (m0 - 1.0)
            v = ((z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0))) - d
            if not np.isfinite(v):
                return Control(_R(0.0), Status.RANGE)
            if v > _U_MAX:
                u_now = _U_MAX
            elif v < -_U_MAX:
                u_now = -_U_MAX
            else:
                u_now = v
            self._u4 = self._u3
            self._u3 = self._u2
            self._u2 = self._u1
            self._u1 = u_now
            self._x1_hat = x1
            self._x2_hat = x2
            self._x3_hat = x3
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
        return np.array([self._x1_hat, self._x2_hat, self._x3_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the constant that is added to u."""
        return self._d_hat
