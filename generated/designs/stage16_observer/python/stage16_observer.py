"""
Prescribed-time observer stage16_observer: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name stage16 --what observer --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0],[0,0,1]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --after-observer=-90+20i,-90-20i,-100,-120 --sample-time=1e-3 --delay=1
Version 0.1.0, design 76c16d95e916.

Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
      sample to sample, one sample late, y = C x.
Goal: the estimates of the state and of d are exact up to rounding from sample 20 after the
      start on, from any state and at any sample period, as long as the measurement is
      exact, u is what was applied and nothing else acts on the plant.
Observer: xhat(k) = Phi xhat(k - 1) + Gamma u + G (y(k - 1) - C xhat(k - 1)) with the plant
      sampled, Phi and Gamma: the estimates of tick k hold y up to tick k - 1. The gains
      follow by duality from the rows that Theorem 1 gives for the mapping exp. Close to
      the end deadbeat takes over.

Parameters:
  h = 1e-3 [s], fixed: sample period
  a = 1 [1/s], fixed: rate of stretched time

k counts samples and may wrap; arm again within 2^32 - 20 samples.
u is the input of tick k - 1 as it was applied, after clipping: it acts from tick k to tick
      k + 1, and the observer keeps it until then.
From sample 20 on the status is HOLD; from there on the observer has the poles
      after_observer.
Guard full: what is measured and u are finite, or the call is refused (INPUT).
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

__all__ = ["Params", "Stage16Observer", "Status"]

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
# Samples of the round of the observer.
_OBSERVER_SAMPLES = 20
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

class Stage16Observer:
    """The observer. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            self._start = 0
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

    def arm(self, k: int) -> None:
        """Starts a round of 20 samples at tick `k`. Estimates and inputs under way are kept.
        Estimates too large to compute with begin anew.

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

    def update(self, k: int, y: ArrayLike, u: float) -> Status:
        """The estimates of tick `k`, which may wrap, from what is measured, y = C x at that tick
        and u, the input of tick `k` - 1 as it was applied, 0 where there was none. y of tick `k`
        shows in the estimates from the next tick on. Call it once for each tick, before the law,
        which takes its estimates. Status Hold from sample 20 on: the round is over.

        On a negative status nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            y = _numbers(y, 2, "y")
            u = _R(u)
            if not (np.isfinite(y[0]) and np.isfinite(y[1]) and np.isfinite(u)):
                return Status.INPUT
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
            if not (
                np.isfinite(x1)
                and np.isfinite(x1_on)
                and np.isfinite(x2)
                and np.isfinite(x2_on)
                and np.isfinite(x3)
                and np.isfinite(x3_on)
                and np.isfinite(d)
                and np.isfinite(d_on)
            ):
                return Status.RANGE
            self._u1 = u
            self._x1_hat = x1
            self._x1_next = x1_on
            self._x2_hat = x2
            self._x2_next = x2_on
            self._x3_hat = x3
            self._x3_next = x3_on
            self._d_hat = d
            self._d_next = d_on
            self._seen = 1
            if left_o == 0:
                return Status.HOLD
            else:
                return Status.OK

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat, self._x3_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the constant that is added to u."""
        return self._d_hat
