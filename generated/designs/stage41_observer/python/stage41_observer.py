"""
Prescribed-time observer stage41_observer: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name stage41 --what observer --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0],[0,0,1]]" --observer-poles=-4,-5,-6 --observer-samples=20 --innovation-max=1,0.75 --coast=1 --precision f32 --sample-time=0.01
Version 0.1.0, design 5a4b5fc5ddd5.

Plant: x' = A x + B u of --A and --B above; u held from sample to sample, y = C x.
Goal: the estimates of the state are exact up to rounding from sample 20 after the start
      on, from any state and at any sample period, as long as the measurement is exact, u
      is what was applied and nothing else acts on the plant.
Observer: xhat(k) = Phi xhat(k - 1) + Gamma u + G (y(k - 1) - C xhat(k - 1)) with the plant
      sampled, Phi and Gamma: the estimates of tick k hold y up to tick k - 1. The gains
      follow by duality from the rows that Theorem 1 gives for the mapping exp. Close to
      the end deadbeat takes over.

Parameters:
  h = 0.01 [s], fixed: sample period
  a = 1 [1/s], fixed: rate of stretched time

k counts samples and may wrap; arm again within 2^32 - 20 samples.
u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
      tick k.
From sample 20 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
      gains of the observer are then held below deadbeat.
Gate: a reading that is not finite or further than 1, 0.75 from its prediction is not
      believed, and the estimates are predicted alone (status GATED) for at most 1 sample
      in a row. Then the call is refused (E_INPUT) until a reading is believed or arm
      starts the estimates anew. The first reading has no prediction.
Guard full: what is measured passes this gate, u is finite, or the call is refused (INPUT).
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

__all__ = ["Params", "Stage41Observer", "Status"]

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

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Prediction from u.
_GAMMA1 = _R(_R(0.00010803832265082747))
# Prediction from u.
_GAMMA2 = _R(_R(0.03089279867708683))
# Prediction from u.
_GAMMA3 = _R(_R(0.3745921552181244))
# Samples of the round of the observer.
_OBSERVER_SAMPLES = 20
# Weight in the observer's gain l1_1.
_Q1_1_1 = _R(-_R(8.0))
# Weight in the observer's gain l1_1.
_Q1_1_2 = _R(_R(8.0))
# Weight in the observer's gain l1_2.
_Q1_2_1 = _R(_R(1218.3760986328125))
# Weight in the observer's gain l1_2.
_Q1_2_2 = _R(-_R(11.457021713256836))
# Weight in the observer's gain l1_3.
_Q1_3_1 = _R(_R(90.17191314697266))
# Weight in the observer's gain l1_3.
_Q1_3_2 = _R(-_R(90.17191314697266))
# Weight in the observer's gain l2_2.
_Q2_2_1 = _R(-_R(0.37285107374191284))
# Weight in the observer's gain l2_3.
_Q2_3_1 = _R(_R(6.0))
# Gain of the observer at its end.
_E0_1_1 = _R(_R(1.1216537952423096))
# Gain of the observer at its end.
_E0_1_2 = _R(_R(11.488577842712402))
# Gain of the observer at its end.
_E0_1_3 = _R(-_R(7.550089359283447))
# Gain of the observer at its end.
_E0_2_2 = _R(_R(0.05081171914935112))
# Gain of the observer at its end.
_E0_2_3 = _R(_R(0.5481857061386108))
# Gain of the observer at its end.
_E1_1_1 = _R(_R(1.9787967205047607))
# Gain of the observer at its end.
_E1_1_2 = _R(_R(96.46954345703125))
# Gain of the observer at its end.
_E1_1_3 = _R(-_R(17.21136474609375))
# Gain of the observer at its end.
_E1_2_2 = _R(_R(0.05081171914935112))
# Gain of the observer at its end.
_E1_2_3 = _R(_R(0.5481857061386108))
# Prediction of x1 from x2.
_PHI1_2 = _R(_R(0.009942672215402126))
# Prediction of x1 from x3.
_PHI1_3 = _R(_R(0.0006178559851832688))
# Prediction of x2 from x2.
_PHI2_2 = _R(_R(0.9857608079910278))
# Prediction of x2 from x3.
_PHI2_3 = _R(_R(0.11206872016191483))
# Prediction of x3 from x2.
_PHI3_2 = _R(-_R(0.11206872016191483))
# Prediction of x3 from x3.
_PHI3_3 = _R(_R(0.541221559047699))

class Stage41Observer:
    """The observer. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            self._start = 0
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x1_next = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x2_next = _R(0.0)
            self._x3_hat = _R(0.0)
            self._x3_next = _R(0.0)
            self._trust = 1

    def arm(self, k: int) -> None:
        """Starts a round of 20 samples at tick `k`. The estimates are kept. Estimates that have had
        no reading for all samples of `coast`, and those too large to compute with, begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        s1 = np.abs(self._x1_next) + np.abs(self._x2_next)
        size = s1 + np.abs(self._x3_next)
        if not ((self._trust > 1) and (size <= _R(9.999999843067494e17))):
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x1_next = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x2_next = _R(0.0)
            self._x3_hat = _R(0.0)
            self._x3_next = _R(0.0)

    def update(self, k: int, y: ArrayLike, u: float | np.float32) -> Status:
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
            if not np.isfinite(u):
                return Status.INPUT
            elapsed = (k - self._start) & _WRAP

            # The estimates; at first what y shows.
            if self._seen == 0:
                x1 = y[0]
                x2 = _R(0.0)
                x3 = y[1]
            else:
                x1 = self._x1_next + (_GAMMA1 * u)
                x2 = self._x2_next + (_GAMMA2 * u)
                x3 = self._x3_next + (_GAMMA3 * u)

            # Prediction of the next sample.
            gap1 = y[0] - x1
            gap2 = y[1] - x3
            if (
                np.isfinite(y[0])
                and (np.abs(gap1) <= _R(1.0))
                and np.isfinite(y[1])
                and (np.abs(gap2) <= _R(0.75))
            ):
                miss1 = gap1
                miss2 = gap2
                trust = 2
            else:
                miss1 = _R(0.0)
                miss2 = _R(0.0)
                trust = max(self._trust - 1, 0)
            if not (trust > 0):
                return Status.INPUT
            off1 = miss1
            off2 = (_R(11.271489143371582) * miss1) + miss2
            left_o = max(_OBSERVER_SAMPLES - elapsed, 0)
            o0 = _R(left_o)
            if o0 > _R(7.0):
                r0 = _R(1.0) / (o0 * (o0 - _R(1.0)))
                l1_1 = ((_Q1_1_1 + (_Q1_1_2 * o0)) * r0) - _R(0.021203333511948586)
                l1_2 = ((_Q1_2_1 + (_Q1_2_2 * o0)) * r0) - _R(1.2427890300750732)
                l1_3 = ((_Q1_3_1 + (_Q1_3_2 * o0)) * r0) + _R(5.331612586975098)
                l2_1 = _R(0.0)
                l2_2 = (_Q2_2_1 * r0) + _R(0.1129535660147667)
                l2_3 = (_Q2_3_1 * r0) - _R(0.4518142640590668)
            elif left_o == 7:
                l1_1 = _E0_1_1
                l1_2 = _E0_1_2
                l1_3 = _E0_1_3
                l2_1 = _R(0.0)
                l2_2 = _E0_2_2
                l2_3 = _E0_2_3
            else:
                l1_1 = _E1_1_1
                l1_2 = _E1_1_2
                l1_3 = _E1_1_3
                l2_1 = _R(0.0)
                l2_2 = _E1_2_2
                l2_3 = _E1_2_3
            s1 = x1 + (_PHI1_2 * x2) + (_PHI1_3 * x3)
            x1_on = s1 + (l1_1 * off1) + (l2_1 * off2)
            s2 = (_PHI2_2 * x2) + (_PHI2_3 * x3) + (l1_2 * off1)
            x2_on = s2 + (l2_2 * off2)
            s3 = (_PHI3_2 * x2) + (_PHI3_3 * x3) + (l1_3 * off1)
            x3_on = s3 + (l2_3 * off2)
            if not (
                np.isfinite(x1)
                and np.isfinite(x1_on)
                and np.isfinite(x2)
                and np.isfinite(x2_on)
                and np.isfinite(x3)
                and np.isfinite(x3_on)
            ):
                return Status.RANGE
            self._x1_hat = x1
            self._x1_next = x1_on
            self._x2_hat = x2
            self._x2_next = x2_on
            self._x3_hat = x3
            self._x3_next = x3_on
            self._seen = 1
            self._trust = trust
            if trust < 2:
                return Status.GATED
            elif left_o == 0:
                return Status.HOLD
            else:
                return Status.OK

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat, self._x3_hat], dtype=_R)
