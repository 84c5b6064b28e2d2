"""
Prescribed-time controller shaken: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name shaken --clock samples --delay-law=predict --measured=x1 --disturbance="sine(omega=60)" --observer-poles=-4,-5,-6,-7 --observer-samples=200 --observer-eps=0.03 --tau=0.6 --eps=0.01 --u-max=8 --poles="least-energy(weight=1)" --g="2" --sample-time=1e-3 --delay=1.75 --sensor-step=1e-6,0
Version 0.1.0, design db5a18285eee.

Plant: x1' = x2, x2' = g (u + d), d an unknown sine(omega=60); u held from sample to
      sample, 1.75 samples late.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant. What d
      does within a sample remains, of order h^(4-i) in x_i.
Law of the state x predicted for the time from which u acts, by x and the inputs under way:
      with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
      the rows are those of Theorem 1 for the mapping exp. The gains of 12 samples to go
      stay.

Parameters:
  samples = 600 [samples], fixed: samples N from the start to rest
  h = 1e-3 [s], fixed: sample period
  eps = 0.01 [s], fixed: time-to-go at which the gains are held
  u_max = 8 [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 12 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_2 = 7 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
The estimates are exact from sample 200 after the start on where the measurement is; with
      noise or sensor_step given, or observer_eps, the gains of the observer are then held
      below deadbeat.
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: near rest at sample 600, not at rest: the gains are held from 10 samples
      to go, and |u| is bounded; so does what the held observer leaves of its error.
  sampling: not checked: the law is exact in samples, at any period.
  deadline: not checked: the law is exact in samples, at any period.
  loop: not checked: `x0_max` is not given.
  envelope: not checked: it does not examine a clock in samples.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Params", "Shaken", "Status"]

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

# 1/1000, prediction of x1 from x2.
_PHI1_2 = _R(0.001)
# Prediction of x1 from d.
_PHI1_3 = _R(9.997000359976858e-7)
# 3/3200000, prediction from u.
_GAMMA1 = _R(9.375e-7)
# 1/16000000, prediction from u.
_LATE_GAMMA1 = _R(6.25e-8)
# Prediction of x1 from d_rate.
_PHI1_4 = _R(3.3327333847593334e-10)
# Prediction of x2 from d.
_PHI2_3 = _R(0.001998800215981487)
# 3/2000, prediction from u.
_GAMMA2 = _R(0.0015)
# 1/2000, prediction from u.
_LATE_GAMMA2 = _R(0.0005)
# Prediction of x2 from d_rate.
_PHI2_4 = _R(9.997000359976858e-7)
# Prediction of d from d_rate.
_PHI3_4 = _R(0.0009994001079907434)
# Prediction of d from d.
_PHI3_3 = _R(0.9982005399352042)
# Prediction of d_rate from d_rate.
_PHI4_4 = _R(0.9982005399352042)
# Prediction of d_rate from d.
_PHI4_3 = _R(-3.597840388766676)
# Samples of the round of the observer.
_OBSERVER_SAMPLES = 200
# Samples to go at which the observer is held.
_HOLD_O = _R(30.0)
# Weight in the observer's gain l1.
_Q1_1 = _R(-840.0)
# Weight in the observer's gain l1.
_Q1_2 = _R(480.0)
# Weight in the observer's gain l1.
_Q1_3 = _R(-120.0)
# Weight in the observer's gain l1.
_Q1_4 = _R(16.0)
# Weight in the observer's gain l2.
_Q2_1 = _R(907032.0947896534)
# Weight in the observer's gain l2.
_Q2_2 = _R(-431395.04961199313)
# Weight in the observer's gain l2.
_Q2_3 = _R(71827.15332755336)
# Weight in the observer's gain l2.
_Q2_4 = _R(28.808643111533488)
# Weight in the observer's gain l3.
_Q3_1 = _R(-166538409.07329616)
# Weight in the observer's gain l3.
_Q3_2 = _R(47150402.59237033)
# Weight in the observer's gain l3.
_Q3_3 = _R(216000.0)
# Weight in the observer's gain l3.
_Q3_4 = _R(-28800.0)
# Weight in the observer's gain l4.
_Q4_1 = _R(10370942877.471207)
# Weight in the observer's gain l4.
_Q4_2 = _R(776511089.3015876)
# Weight in the observer's gain l4.
_Q4_3 = _R(-129288875.98959604)
# Weight in the observer's gain l4.
_Q4_4 = _R(-51855.55760076028)
# Weight of d in d0.
_D0_D = _R(0.990752702693308)
# Weight of d_rate in d0.
_D0_D_RATE = _R(0.002242835389486039)
# Weight of d in d1.
_D1_D = _R(0.9970392465203709)
# Weight of d_rate in d1.
_D1_D_RATE = _R(0.0012486411387069352)
# Weight of d in d2.
_D2_D = _R(0.9996625341702274)
# Weight of d_rate in d2.
_D2_D_RATE = _R(0.0003749367230213299)
# Samples from the start to rest.
_SAMPLES = 600
# Samples to go at which the gains are held.
_HOLD = _R(10.0)
# Weight of x1 in the law.
_W1_1 = _R(-6000000.0)
# Weight of x2 in the law.
_W1_2 = _R(-7500.0)
# -63/8, weight of u2 in the law.
_W1_4 = _R(-7.875)
# Weight of x2 in the law.
_W2_2 = _R(-3000.0)
# Weight of u1 in the law.
_W2_3 = _R(-6.0)
# -9/2, weight of u2 in the law.
_W2_4 = _R(-4.5)
# Bound of |u|.
_U_MAX = _R(8.0)

class Shaken:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            self._start = 0
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._u3 = _R(0.0)
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._d_hat = _R(0.0)
            self._d_rate_hat = _R(0.0)

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept. Estimates too large to compute with begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        s1 = np.abs(self._x1_hat) + np.abs(self._x2_hat) + np.abs(self._d_hat)
        size = s1 + np.abs(self._d_rate_hat)
        if not (size <= 1e150):
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._d_hat = _R(0.0)
            self._d_rate_hat = _R(0.0)

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
            s2 = s1 + (_PHI1_3 * self._d_hat)
            s3 = (_GAMMA1 * self._u3) + (_LATE_GAMMA1 * self._u2)
            p1 = s2 + (_PHI1_4 * self._d_rate_hat) + s3
            s4 = self._x2_hat + (_PHI2_3 * self._d_hat)
            s5 = (_GAMMA2 * self._u3) + (_LATE_GAMMA2 * self._u2)
            p2 = s4 + (_PHI2_4 * self._d_rate_hat) + s5
            s6 = _PHI3_4 * self._d_rate_hat
            p3 = (_PHI3_3 * self._d_hat) + s6
            s7 = _PHI4_4 * self._d_rate_hat
            p4 = (_PHI4_3 * self._d_hat) + s7

            # Correct by what is measured.
            if self._seen == 0:
                base = y[0]
                miss = _R(0.0)
            else:
                base = p1
                miss = y[0] - p1
            left_o = max(_OBSERVER_SAMPLES - elapsed, 0)
            o0 = max(_R(left_o), _HOLD_O)
            o0f2 = o0 * (o0 - 1.0)
            o0f3 = o0f2 * (o0 - 2.0)
            r0 = 1.0 / (o0f3 * (o0 - 3.0))
            s8 = _Q1_1 + (_Q1_2 * o0) + (_Q1_3 * o0f2)
            l1 = ((s8 + (_Q1_4 * o0f3)) * r0) - 3.8011523294569497e-121
            s9 = _Q2_1 + (_Q2_2 * o0) + (_Q2_3 * o0f2)
            l2 = ((s9 + (_Q2_4 * o0f3)) * r0) - 3.601080388941686
            s10 = _Q3_1 + (_Q3_2 * o0) + (_Q3_3 * o0f2)
            l3 = ((s10 + (_Q3_4 * o0f3)) * r0) + 1.3694003898462869e-117
            s11 = _Q4_1 + (_Q4_2 * o0) + (_Q4_3 * o0f2)
            l4 = ((s11 + (_Q4_4 * o0f3)) * r0) + 6481.944700095035
            x1 = base + (l1 * miss)
            x2 = p2 + (l2 * miss)
            d = p3 + (l3 * miss)
            d_rate = p4 + (l4 * miss)

            # The disturbance while each input acts.
            d0 = (_D0_D * d) + (_D0_D_RATE * d_rate)
            d1 = (_D1_D * d) + (_D1_D_RATE * d_rate)
            d2 = (_D2_D * d) + (_D2_D_RATE * d_rate)
            left = max(_SAMPLES - elapsed, 0)
            s12 = _R(left) - 2.0
            m0 = max(s12, _HOLD)

            # The exact law in samples.
            s13 = (_W1_1 * x1) + (_W1_2 * x2)
            z1 = s13 + (_W1_4 * (self._u2 + d2))
            s14 = (_W2_2 * x2) + (_W2_3 * (self._u1 + d1))
            z2 = s14 + (_W2_4 * (self._u2 + d2))
            m0f1 = m0 + 2.0
            v = ((z1 + (z2 * m0f1)) / (m0f1 * (m0 + 1.0))) - d0
            if not np.isfinite(v):
                return Control(_R(0.0), Status.RANGE)
            if v > _U_MAX:
                u_now = _U_MAX
            elif v < -_U_MAX:
                u_now = -_U_MAX
            else:
                u_now = v
            self._u3 = self._u2
            self._u2 = self._u1
            self._u1 = u_now
            self._x1_hat = x1
            self._x2_hat = x2
            self._d_hat = d
            self._d_rate_hat = d_rate
            self._seen = 1
            if (v > _U_MAX) or (v < -_U_MAX):
                return Control(u_now, Status.SATURATED)
            elif _R(left) - 2.0 <= _HOLD:
                return Control(u_now, Status.HOLD)
            else:
                return Control(u_now, Status.OK)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the sine that is added to u."""
        return self._d_hat
