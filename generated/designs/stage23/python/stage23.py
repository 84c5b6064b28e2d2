"""
Prescribed-time controller stage23: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name stage23 --clock samples --A="[[0,1,0],[0,-1,10],[0,-2,-50]]" --B="[0,0,100]" --C="[[1,0,0]]" --output="[1,0,0]" --observer-poles=-4,-5,-6 --observer-samples=25 --tau=0.5 --eps=0 --poles=-4,-5,-6,-7 --reference input --sample-time=0.01 --delay=1
Version 0.1.0, design da426a349de3.

Plant: x' = A x + B u of --A and --B above; u held from sample to sample, one sample late,
      y = C x.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M - 3 samples to go and z = S x, the differences of a flat output, u = sum of
      row_j z_j/((M-j+1)...(M-3)) less the drift of z; the rows are those of Theorem 1 for
      the mapping exp. The gains of 4 samples to go stay: they are deadbeat.
With the reference r with its derivatives r[0]..r[2] at tick k, x - x_r is in place of x
      above, and u = w + u_r, where the inputs under way count less the u_r of their own
      samples: with them the output y = x1 is r, and stays so. At sample N x = x_r where
      u_r is constant over each sample; else an error of order h^(5-i) is left in y^(i-1).
r[3] is r^(3) over the sample in which u acts: its mean, (r^(2)(t + h) - r^(2)(t))/h, or
      that in its middle. u_r is the mean over that sample. To four digits, the last at one
      time:
  x_r1 = r
  x_r2 = r^(1)
  x_r3 = 0.1*r^(1) + 0.1*r^(2)
  u_r = 0.07*r^(1) + 0.051*r^(2) + 0.001*r^(3)

Parameters:
  samples = 50 [samples], fixed: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 840 [1/s^4], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_2 = 638 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_3 = 179 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_4 = 22 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
The estimates are exact from sample 25 after the start on where the measurement is; with
      noise or sensor_step given, or observer_eps, the gains of the observer are then held
      below deadbeat.
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample 50 from any state, but for what r does between samples,
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

__all__ = ["Control", "Params", "Stage23", "Status"]

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

    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Prediction from u.
_GAMMA1 = _R(0.00014736313620654503)
# Prediction from u.
_GAMMA2 = _R(0.04245805872561294)
# Prediction from u.
_GAMMA3 = _R(0.7866781644184895)
# Samples of the round of the observer.
_OBSERVER_SAMPLES = 25
# Weight in the observer's gain l1.
_Q1_1 = _R(24.0)
# Weight in the observer's gain l1.
_Q1_2 = _R(-24.0)
# Weight in the observer's gain l1.
_Q1_3 = _R(12.0)
# Weight in the observer's gain l2.
_Q2_1 = _R(-12098.699806867564)
# Weight in the observer's gain l2.
_Q2_2 = _R(5834.153087954333)
# Weight in the observer's gain l2.
_Q2_3 = _R(-616.5581920200482)
# Weight in the observer's gain l3.
_Q3_1 = _R(90981.25917900148)
# Weight in the observer's gain l3.
_Q3_2 = _R(-29002.765439771665)
# Weight in the observer's gain l3.
_Q3_3 = _R(2998.7909601002407)
# Gain of the observer at its end.
_E0_1 = _R(1.0950153689199909)
# Gain of the observer at its end.
_E0_2 = _R(15.297392853547647)
# Gain of the observer at its end.
_E0_3 = _R(98.32269091567703)
# Gain of the observer at its end.
_E1_1 = _R(1.309301083205705)
# Gain of the observer at its end.
_E1_2 = _R(6.605837883444068)
# Gain of the observer at its end.
_E1_3 = _R(-407.1438225313707)
# Gain of the observer at its end.
_E2_1 = _R(2.5950153689199906)
# Gain of the observer at its end.
_E2_2 = _R(180.07490250022406)
# Gain of the observer at its end.
_E2_3 = _R(358.78371927742626)
# Prediction of x1 from x2.
_PHI1_2 = _R(0.009947226521739929)
# Prediction of x1 from x3.
_PHI1_3 = _R(0.00042458058725612934)
# Prediction of x2 from x2.
_PHI2_2 = _R(0.9892036123037478)
# Prediction of x2 from x3.
_PHI2_3 = _R(0.07824323585459282)
# Prediction of x3 from x2.
_PHI3_2 = _R(-0.015648647170918566)
# Prediction of x3 from x3.
_PHI3_3 = _R(0.605811756616243)
# Weight of x1 in the law.
_W1_1 = _R(-1072951.6050632286)
# Weight of x2 in the law.
_W1_2 = _R(11224.193450693596)
# Weight of x3 in the law.
_W1_3 = _R(-404.795716419329)
# Weight of x2 in the law.
_W2_2 = _R(-6164.422229232715)
# Weight of x3 in the law.
_W2_3 = _R(332.70200299979865)
# Weight of x2 in the law.
_W3_2 = _R(15.336789013047456)
# Weight of x3 in the law.
_W3_3 = _R(-153.36789013047456)
# Weight of u1 in the law.
_W4_4 = _R(-16.0)
# Weight of x2 in the law.
_W4_2 = _R(0.29792241063993585)
# Weight of x3 in the law.
_W4_3 = _R(8.220775893600642)
# Weight of u1 in the law.
_C_4 = _R(1.4049846310800091)
# Weight of x2 in the law.
_C_2 = _R(-0.00824128170492625)
# Weight of x3 in the law.
_C_3 = _R(-0.20107642470674394)
# Weight of x1 in the law.
_B_1 = _R(-1277.3233393609864)
# Weight of x2 in the law.
_B_2 = _R(-37.174971411649004)
# Weight of x3 in the law.
_B_3 = _R(-3.523659928569286)
# Weight of u1 in the law.
_B_4 = _R(-2.5950153689199906)
# Samples from the start to rest.
_SAMPLES = 50

class Stage23:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_u_max = _R(params.u_max)
            if not (given_u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            u_max = given_u_max
            self._start = 0
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x1_next = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x2_next = _R(0.0)
            self._x3_hat = _R(0.0)
            self._x3_next = _R(0.0)
            self._u_r1 = _R(0.0)
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept. Estimates too large to compute with begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        s1 = np.abs(self._x1_next) + np.abs(self._x2_next)
        size = s1 + np.abs(self._x3_next)
        if not (size <= 1e150):
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x1_next = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x2_next = _R(0.0)
            self._x3_hat = _R(0.0)
            self._x3_next = _R(0.0)

    def step(self, k: int, y: ArrayLike, r: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and what is measured, y = C x, and the reference. Call
        it once for each tick.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            y = _numbers(y, 1, "y")
            r = _numbers(r, 4, "r")
            if not (
                np.isfinite(y[0])
                and np.isfinite(r[0])
                and np.isfinite(r[1])
                and np.isfinite(r[2])
                and np.isfinite(r[3])
            ):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP

            # The estimates; at first what y shows.
            if self._seen == 0:
                x1 = y[0]
                x2 = _R(0.0)
                x3 = _R(0.0)
            else:
                x1 = self._x1_next + (_GAMMA1 * self._u2)
                x2 = self._x2_next + (_GAMMA2 * self._u2)
                x3 = self._x3_next + (_GAMMA3 * self._u2)

            # Prediction of the next sample.
            miss1 = y[0] - x1
            off1 = miss1
            left_o = max(_OBSERVER_SAMPLES - elapsed, 0)
            o0 = _R(left_o)
            if o0 > 8.0:
                o0f2 = o0 * (o0 - 1.0)
                r0 = 1.0 / (o0f2 * (o0 - 2.0))
                s1 = (_Q1_1 + (_Q1_2 * o0) + (_Q1_3 * o0f2)) * r0
                l1 = s1 - 0.4049846310800092
                s2 = (_Q2_1 + (_Q2_2 * o0) + (_Q2_3 * o0f2)) * r0
                l2 = s2 + 20.107642470674392
                s3 = (_Q3_1 + (_Q3_2 * o0) + (_Q3_3 * o0f2)) * r0
                l3 = s3 - 97.7033199358119
            elif left_o == 8:
                l1 = _E0_1
                l2 = _E0_2
                l3 = _E0_3
            elif left_o == 7:
                l1 = _E1_1
                l2 = _E1_2
                l3 = _E1_3
            else:
                l1 = _E2_1
                l2 = _E2_2
                l3 = _E2_3
            x1_on = x1 + (_PHI1_2 * x2) + (_PHI1_3 * x3) + (l1 * off1)
            x2_on = (_PHI2_2 * x2) + (_PHI2_3 * x3) + (l2 * off1)
            x3_on = (_PHI3_2 * x2) + (_PHI3_3 * x3) + (l3 * off1)

            # The tracking error.
            u_r = (0.07 * r[1]) + (0.05205 * r[2]) + (0.0017731666666666666 * r[3])
            e1 = x1 - r[0]
            e2 = x2 - r[1]
            e3 = x3 - ((0.1 * r[1]) + (0.1 * r[2]))
            if elapsed < 46:
                # The exact law in samples.
                m0 = _R((53 - elapsed) & _WRAP)
                z1 = (_W1_1 * e1) + (_W1_2 * e2) + (_W1_3 * e3)
                z2 = (_W2_2 * e2) + (_W2_3 * e3)
                z3 = (_W3_2 * e2) + (_W3_3 * e3)
                s4 = _W4_4 * (self._u1 - self._u_r1)
                z4 = (_W4_2 * e2) + (_W4_3 * e3) + s4
                m0f2 = m0 * (m0 - 1.0)
                m0f3 = m0f2 * (m0 - 2.0)
                s5 = _C_4 * (self._u1 - self._u_r1)
                s6 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0))
                v = s6 + ((_C_2 * e2) + (_C_3 * e3) + s5) + u_r
            else:
                # Deadbeat.
                s7 = (_B_1 * e1) + (_B_2 * e2) + (_B_3 * e3)
                v = s7 + (_B_4 * (self._u1 - self._u_r1)) + u_r
            if not (
                np.isfinite(v)
                and np.isfinite(x1_on)
                and np.isfinite(x2_on)
                and np.isfinite(x3_on)
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
            self._u_r1 = u_r
            self._x1_hat = x1
            self._x1_next = x1_on
            self._x2_hat = x2
            self._x2_next = x2_on
            self._x3_hat = x3
            self._x3_next = x3_on
            self._seen = 1
            if (v > self._u_max) or (v < -self._u_max):
                return Control(u_now, Status.SATURATED)
            elif elapsed < _SAMPLES:
                return Control(u_now, Status.OK)
            else:
                return Control(u_now, Status.HOLD)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat, self._x3_hat], dtype=_R)
