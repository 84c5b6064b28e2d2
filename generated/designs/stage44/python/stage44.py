"""
Prescribed-time controller stage44: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name stage44 --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0]]" --delay-law=predict --observer-poles=-4,-5,-6 --eps=0.06 --poles=-3,-4,-5 --sample-time=0.01 --delay=1.5
Version 0.1.0, design 985c02d3ad50.

Plant: x' = A x + B u of --A and --B above; u held from sample to sample, 1.5 samples late,
      y = C x.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law of the state x predicted for the time from which u acts, by x and the inputs under way:
      with M samples to go and z = S x, the differences of a flat output, u = sum of row_j
      z_j/((M-j+1)...(M-2)) less the drift of z; the rows are those of Theorem 1 for the
      mapping exp. The gains of 8 samples to go stay.

Parameters:
  samples [samples]: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
  eps = 0.06 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 60 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_2 = 47 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_3 = 12 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
The estimates are exact from sample N/2 after the start on where the measurement is; with
      noise or sensor_step given, or observer_eps, the gains of the observer are then held
      below deadbeat.
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: near rest at sample N, not at rest: the gains are held from 6 samples to
      go, and |u| is bounded.
  sampling: not checked: the law is exact in samples, at any period.
  deadline: not checked: the law is exact in samples, at any period.
  loop: not checked: `samples` is left to run time.
  envelope: not checked: it does not examine a clock in samples.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Params", "Stage44", "Status"]

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
    """samples N from the start to rest [samples], at least 10"""
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Prediction from u.
_GAMMA1 = _R(9.353143640028875e-5)
# Prediction from u.
_LATE_GAMMA1 = _R(1.4506885866158227e-5)
# Prediction from u.
_GAMMA2 = _R(0.02240015856569381)
# Prediction from u.
_LATE_GAMMA2 = _R(0.008492640667447336)
# Prediction from u.
_GAMMA3 = _R(0.15880933131841984)
# Prediction from u.
_LATE_GAMMA3 = _R(0.21578282027048595)
# Weight in the observer's gain l1.
_Q1_1 = _R(24.0)
# Weight in the observer's gain l1.
_Q1_2 = _R(-24.0)
# Weight in the observer's gain l1.
_Q1_3 = _R(12.0)
# Weight in the observer's gain l2.
_Q2_1 = _R(-12889.952685745366)
# Weight in the observer's gain l2.
_Q2_2 = _R(6304.212917508586)
# Weight in the observer's gain l2.
_Q2_3 = _R(-742.8703573620571)
# Weight in the observer's gain l3.
_Q3_1 = _R(72521.99132748511)
# Weight in the observer's gain l3.
_Q3_2 = _R(-24808.851670034343)
# Weight in the observer's gain l3.
_Q3_3 = _R(2767.4814294482285)
# Gain of the observer at its end.
_E0_1 = _R(1.026982402667958)
# Gain of the observer at its end.
_E0_2 = _R(9.393065010983802)
# Gain of the observer at its end.
_E0_3 = _R(72.1724949708503)
# Gain of the observer at its end.
_E1_1 = _R(1.2412681169536723)
# Gain of the observer at its end.
_E1_2 = _R(-0.9955098611216602)
# Gain of the observer at its end.
_E1_3 = _R(-271.5264302640074)
# Gain of the observer at its end.
_E2_1 = _R(2.526982402667958)
# Gain of the observer at its end.
_E2_2 = _R(168.91277532831796)
# Gain of the observer at its end.
_E2_3 = _R(171.81438886235838)
# Prediction of x1 from x2.
_PHI1_2 = _R(0.009942671770940647)
# Prediction of x1 from x3.
_PHI1_3 = _R(0.000617855984662823)
# Prediction of x2 from x2.
_PHI2_2 = _R(0.9857608243445873)
# Prediction of x2 from x3.
_PHI2_3 = _R(0.11206871748434033)
# Prediction of x3 from x2.
_PHI3_2 = _R(-0.11206871748434033)
# Prediction of x3 from x3.
_PHI3_3 = _R(0.5412215783233707)
# Samples to go at which the gains are held.
_HOLD = _R(6.0)
# Weight of x1 in the law.
_W1_1 = _R(-106850.90292251826)
# Weight of x2 in the law.
_W1_2 = _R(-482.3692808208648)
# Weight of x3 in the law.
_W1_3 = _R(4.807633485406011)
# Weight of u1 in the law.
_W1_4 = _R(-1.2197801784387233e-74)
# Weight of u2 in the law.
_W1_5 = _R(4.609258112111791)
# Weight of x2 in the law.
_W2_2 = _R(-633.6322203514217)
# Weight of x3 in the law.
_W2_3 = _R(-73.36956899710586)
# Weight of u1 in the law.
_W2_4 = _R(-1.2733281521282373e-76)
# Weight of u2 in the law.
_W2_5 = _R(-14.786896717013052)
# Weight of x2 in the law.
_W3_2 = _R(4.311208496599377)
# Weight of x3 in the law.
_W3_3 = _R(-9.337493806987991)
# Weight of u1 in the law.
_W3_4 = _R(-9.0)
# Weight of u2 in the law.
_W3_5 = _R(-2.7645844206856207)
# Weight of x2 in the law.
_C_2 = _R(0.10945032226632541)
# Weight of x3 in the law.
_C_3 = _R(0.5296658086896372)
# Weight of u1 in the law.
_C_4 = _R(0.47301759733204196)
# Weight of u2 in the law.
_C_5 = _R(0.15314166966017376)

class Stage44:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_samples = params.samples.__index__()
            if given_samples != given_samples & _WRAP:
                raise ValueError(f"params.samples is {params.samples}; legal: 0..2^32 - 1")
            given_u_max = _R(params.u_max)
            if not (given_samples > 9):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 10")
            if not (given_u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            samples = given_samples
            u_max = given_u_max
            self._start = 0
            self._samples = samples
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._u3 = _R(0.0)
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x1_next = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x2_next = _R(0.0)
            self._x3_hat = _R(0.0)
            self._x3_next = _R(0.0)
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

    def step(self, k: int, y: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each
        tick.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            y = _numbers(y, 1, "y")
            if not np.isfinite(y[0]):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP

            # The estimates; at first what y shows.
            if self._seen == 0:
                x1 = y[0]
                x2 = _R(0.0)
                x3 = _R(0.0)
            else:
                s1 = (_GAMMA1 * self._u3) + (_LATE_GAMMA1 * self._u2)
                x1 = self._x1_next + s1
                s2 = (_GAMMA2 * self._u3) + (_LATE_GAMMA2 * self._u2)
                x2 = self._x2_next + s2
                s3 = (_GAMMA3 * self._u3) + (_LATE_GAMMA3 * self._u2)
                x3 = self._x3_next + s3

            # Prediction of the next sample.
            miss1 = y[0] - x1
            off1 = miss1
            left_o = max((self._samples // 2) - elapsed, 0)
            o0 = _R(left_o)
            if o0 > 8.0:
                o0f2 = o0 * (o0 - 1.0)
                r0 = 1.0 / (o0f2 * (o0 - 2.0))
                s4 = (_Q1_1 + (_Q1_2 * o0) + (_Q1_3 * o0f2)) * r0
                l1 = s4 - 0.47301759733204196
                s5 = (_Q2_1 + (_Q2_2 * o0) + (_Q2_3 * o0f2)) * r0
                l2 = s5 + 26.72716299730578
                s6 = (_Q3_1 + (_Q3_2 * o0) + (_Q3_3 * o0f2)) * r0
                l3 = s6 - 98.86735283457841
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
            left = max(self._samples - elapsed, 0)
            s7 = _R(left) - 2.0
            m0 = max(s7, _HOLD)

            # The exact law in samples.
            s8 = (_W1_1 * x1) + (_W1_2 * x2) + (_W1_3 * x3)
            z1 = s8 + (_W1_4 * self._u1) + (_W1_5 * self._u2)
            s9 = (_W2_2 * x2) + (_W2_3 * x3)
            z2 = s9 + (_W2_4 * self._u1) + (_W2_5 * self._u2)
            s10 = (_W3_2 * x2) + (_W3_3 * x3)
            z3 = s10 + (_W3_4 * self._u1) + (_W3_5 * self._u2)
            m0f1 = m0 + 2.0
            m0f2 = m0f1 * (m0 + 1.0)
            s11 = (_C_2 * x2) + (_C_3 * x3)
            s12 = s11 + (_C_4 * self._u1) + (_C_5 * self._u2)
            v = ((z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * m0)) + s12
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
            self._u3 = self._u2
            self._u2 = self._u1
            self._u1 = u_now
            self._x1_hat = x1
            self._x1_next = x1_on
            self._x2_hat = x2
            self._x2_next = x2_on
            self._x3_hat = x3
            self._x3_next = x3_on
            self._seen = 1
            if (v > self._u_max) or (v < -self._u_max):
                return Control(u_now, Status.SATURATED)
            elif _R(left) - 2.0 <= _HOLD:
                return Control(u_now, Status.HOLD)
            else:
                return Control(u_now, Status.OK)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat, self._x3_hat], dtype=_R)
