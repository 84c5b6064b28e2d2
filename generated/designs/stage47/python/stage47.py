"""
Prescribed-time controller stage47: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name stage47 --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0],[0,0,1]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --after-observer=stationary --disturbance-walk=1/2 --eps=0.06 --poles=-3,-4,-5 --sample-time=0.01 --noise=1e-5,1e-3
Version 0.1.0, design bd3303578b4f.

Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
      sample to sample, y = C x.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M - 2 samples to go and z = S x, the differences of a flat output, u = sum of
      row_j z_j/((M-j+1)...(M-2)) less the drift of z; the rows are those of Theorem 1 for
      the mapping exp. The gains of 6 samples to go stay.

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
The estimates are exact from sample 20 after the start on where the measurement is; from
      there on the observer has the gains of the stationary Kalman filter for the noise and
      disturbance_walk.
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

__all__ = ["Control", "Params", "Stage47", "Status"]

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
    """samples N from the start to rest [samples], at least 23"""
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Prediction from u.
_GAMMA1 = _R(0.00010803832226644697)
# Prediction from u.
_GAMMA2 = _R(0.030892799233141147)
# Prediction from u.
_GAMMA3 = _R(0.3745921515889058)
# Samples of the round of the observer.
_OBSERVER_SAMPLES = 20
# Weight in the observer's gain l1_1.
_Q1_1_1 = _R(-8.0)
# Weight in the observer's gain l1_1.
_Q1_1_2 = _R(8.0)
# Weight in the observer's gain l1_2.
_Q1_2_1 = _R(1207.0156938434693)
# Weight in the observer's gain l1_2.
_Q1_2_2 = _R(-4.007471679722458)
# Weight in the observer's gain l1_4.
_Q1_4_1 = _R(359.9103398433305)
# Weight in the observer's gain l2_2.
_Q2_2_1 = _R(-1.8587963031465917)
# Weight in the observer's gain l2_2.
_Q2_2_2 = _R(0.9913796378212842)
# Weight in the observer's gain l2_3.
_Q2_3_1 = _R(-12.0)
# Weight in the observer's gain l2_3.
_Q2_3_2 = _R(12.0)
# Weight in the observer's gain l2_4.
_Q2_4_1 = _R(79.82759275642569)
# Gain of the observer at its end.
_E0_1_1 = _R(0.9950193780571475)
# Gain of the observer at its end.
_E0_1_2 = _R(-0.49380107331759976)
# Gain of the observer at its end.
_E0_1_3 = _R(0.056139026437663865)
# Gain of the observer at its end.
_E0_2_1 = _R(0.0014392695129337434)
# Gain of the observer at its end.
_E0_2_2 = _R(0.220357858722901)
# Gain of the observer at its end.
_E0_2_3 = _R(1.0319630246108107)
# Gain of the observer at its end.
_E0_2_4 = _R(1.3304598792737614)
# Gain of the observer at its end.
_E1_1_1 = _R(1.9950193780571475)
# Gain of the observer at its end.
_E1_1_2 = _R(99.25595014702932)
# Gain of the observer at its end.
_E1_1_3 = _R(0.056139026437663865)
# Gain of the observer at its end.
_E1_1_4 = _R(29.992528320277543)
# Gain of the observer at its end.
_E1_2_1 = _R(0.0014392695129337434)
# Gain of the observer at its end.
_E1_2_2 = _R(0.24720839921003274)
# Gain of the observer at its end.
_E1_2_3 = _R(1.5319630246108107)
# Gain of the observer at its end.
_E1_2_4 = _R(2.660919758547523)
# Prediction of x1 from x2.
_PHI1_2 = _R(0.009942671770940647)
# Prediction of x1 from x3.
_PHI1_3 = _R(0.000617855984662823)
# Prediction of x1 from d.
_PHI1_4 = _R(0.00010803832226644697)
# Prediction of x2 from x2.
_PHI2_2 = _R(0.9857608243445873)
# Prediction of x2 from x3.
_PHI2_3 = _R(0.11206871748434033)
# Prediction of x2 from d.
_PHI2_4 = _R(0.030892799233141147)
# Prediction of x3 from x2.
_PHI3_2 = _R(-0.11206871748434033)
# Prediction of x3 from x3.
_PHI3_3 = _R(0.5412215783233707)
# Prediction of x3 from d.
_PHI3_4 = _R(0.3745921515889058)
# Samples to go at which the gains are held.
_HOLD = _R(6.0)
# Weight of x1 in the law.
_W1_1 = _R(-106850.90292251826)
# Weight of x2 in the law.
_W1_2 = _R(1124.1848178645955)
# Weight of x3 in the law.
_W1_3 = _R(-61.894579201640425)
# Weight of x2 in the law.
_W2_2 = _R(-642.8726851005619)
# Weight of x3 in the law.
_W2_3 = _R(53.018026963569255)
# Weight of x2 in the law.
_W3_2 = _R(0.8030787004640786)
# Weight of x3 in the law.
_W3_3 = _R(-24.09236101392236)
# Weight of x2 in the law.
_C_2 = _R(0.29872942459099683)
# Weight of x3 in the law.
_C_3 = _R(1.238117262270095)

class Stage47:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_samples = params.samples.__index__()
            if given_samples != given_samples & _WRAP:
                raise ValueError(f"params.samples is {params.samples}; legal: 0..2^32 - 1")
            given_u_max = _R(params.u_max)
            if not (given_samples > 22):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 23")
            if not (given_u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            samples = given_samples
            u_max = given_u_max
            self._start = 0
            self._samples = samples
            self._u1 = _R(0.0)
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x1_next = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x2_next = _R(0.0)
            self._x3_hat = _R(0.0)
            self._x3_next = _R(0.0)
            self._d_hat = _R(0.0)
            self._d_next = _R(0.0)
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
                x1 = self._x1_next + (_GAMMA1 * self._u1)
                x2 = self._x2_next + (_GAMMA2 * self._u1)
                x3 = self._x3_next + (_GAMMA3 * self._u1)
                d = self._d_next

            # Prediction of the next sample.
            miss1 = y[0] - x1
            miss2 = y[1] - x3
            off1 = miss1
            off2 = miss2
            left_o = max(_OBSERVER_SAMPLES - elapsed, 0)
            o0 = _R(left_o)
            if left_o == 0:
                l1_1 = _R(0.5288853188994155)
                l1_2 = _R(11.043581739724111)
                l1_3 = _R(-1.95232951580154)
                l1_4 = _R(-4.310227400623051)
                l2_1 = _R(0.00186202868892253)
                l2_2 = _R(0.2724600360147846)
                l2_3 = _R(1.5302977387244094)
                l2_4 = _R(2.6662087225258313)
            elif o0 > 8.0:
                r0 = 1.0 / (o0 * (o0 - 1.0))
                s1 = (_Q1_1_1 + (_Q1_1_2 * o0)) * r0
                l1_1 = s1 - 0.004980621942852573
                s2 = (_Q1_2_1 + (_Q1_2_2 * o0)) * r0
                l1_2 = s2 + 0.007132886647707467
                l1_3 = _R(0.056139026437663865)
                l1_4 = _Q1_4_1 * r0
                l2_1 = _R(0.0014392695129337434)
                s3 = (_Q2_2_1 + (_Q2_2_2 * o0)) * r0
                l2_2 = s3 + 0.11089234841732894
                s4 = (_Q2_3_1 + (_Q2_3_2 * o0)) * r0
                l2_3 = s4 - 0.4680369753891894
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
            m0 = max(_R(left), _HOLD)

            # The exact law in samples.
            z1 = (_W1_1 * x1) + (_W1_2 * x2) + (_W1_3 * x3)
            z2 = (_W2_2 * x2) + (_W2_3 * x3)
            z3 = (_W3_2 * x2) + (_W3_3 * x3)
            m0f1 = m0 + 2.0
            m0f2 = m0f1 * (m0 + 1.0)
            s8 = (z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * m0)
            v = (s8 + ((_C_2 * x2) + (_C_3 * x3))) - d
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
            elif _R(left) <= _HOLD:
                return Control(u_now, Status.HOLD)
            else:
                return Control(u_now, Status.OK)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat, self._x3_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the constant that is added to u."""
        return self._d_hat
