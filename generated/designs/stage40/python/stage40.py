"""
Prescribed-time controller stage40: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name stage40 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=20 --innovation-max=0.5 --measurement-max=1.5 --coast=2 --tau=0.04 --eps=0 --u-max=6 --poles=-4,-5,-6 --reference input --sample-time=1e-3 --delay=1
Version 0.1.0, design 1f938d622e88.

Plant: x1' = x2, x2' = (u + d), d constant and unknown; u held from sample to sample, one
      sample late.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
      h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
      gains of 3 samples to go stay: they are deadbeat.
With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
      where the inputs under way count less the rho of their own samples. At sample N e is
      0 where r^(n) is constant over each sample; else an error of order h^(4-i) is left in
      e_i.
e_i = x_i - r[i-1] with r[0]..r[1] the reference and its derivatives at tick k, and rho =
      r[2], r^(n) over the sample in which u acts: its mean, (r^(n-1)(t + h) -
      r^(n-1)(t))/h, or that in its middle.

Parameters:
  samples = 40 [samples], fixed: samples N from the start to rest
  h = 1e-3 [s], fixed: sample period
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
Gate: a reading that is not finite or beyond +-1.5 or further than 0.5 from its prediction
      is not believed, and the estimates are predicted alone (status GATED) for at most 2
      samples in a row. Then the call is refused (E_INPUT) until a reading is believed or
      arm starts the estimates anew. The first reading has no prediction.
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured passes this gate, the reference is finite, or the call is
      refused (INPUT).
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

__all__ = ["Control", "Params", "Stage40", "Status"]

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
# 1/2000000, prediction of x1 from d.
_PHI1_3 = _R(5e-7)
# 1/2000000, prediction from u.
_GAMMA1 = _R(5e-7)
# 1/1000, prediction of x2 from d.
_PHI2_3 = _R(0.001)
# 1/1000, prediction from u.
_GAMMA2 = _R(0.001)
# Samples of the round of the observer.
_OBSERVER_SAMPLES = 20
# Weight in the observer's gain l1.
_Q1_1 = _R(120.0)
# Weight in the observer's gain l1.
_Q1_2 = _R(-60.0)
# Weight in the observer's gain l1.
_Q1_3 = _R(12.0)
# Weight in the observer's gain l2.
_Q2_1 = _R(-108000.0)
# Weight in the observer's gain l2.
_Q2_2 = _R(36000.0)
# Weight in the observer's gain l3.
_Q3_1 = _R(24000000.0)
# 3000/7, gain of the observer at its end.
_E0_2 = _R(428.57142857142856)
# 1000000/7, gain of the observer at its end.
_E0_3 = _R(142857.14285714287)
# 6000/7, gain of the observer at its end.
_E1_2 = _R(857.1428571428571)
# -2000000/7, gain of the observer at its end.
_E1_3 = _R(-285714.28571428574)
# Gain of the observer at its end.
_E2_2 = _R(1500.0)
# Gain of the observer at its end.
_E2_3 = _R(1000000.0)
# Weight of x1 in the law.
_W1_1 = _R(-120000000.0)
# Weight of x2 in the law.
_W1_2 = _R(60000.0)
# Weight of x2 in the law.
_W2_2 = _R(-60000.0)
# Weight of u1 in the law.
_W3_3 = _R(-12.0)
# Bound of |u|.
_U_MAX = _R(6.0)
# Samples from the start to rest.
_SAMPLES = 40

class Stage40:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            self._start = 0
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._d_hat = _R(0.0)
            self._trust = 1
            self._rho1 = _R(0.0)

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept. Estimates that have had no reading for all samples of `coast`, and those too large
        to compute with, begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        size = np.abs(self._x1_hat) + np.abs(self._x2_hat) + np.abs(self._d_hat)
        if not ((self._trust > 1) and (size <= 1e150)):
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
            if not (np.isfinite(r[0]) and np.isfinite(r[1]) and np.isfinite(r[2])):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP

            # Predict.
            s1 = self._x1_hat + (_PHI1_2 * self._x2_hat)
            s2 = s1 + (_PHI1_3 * self._d_hat)
            p1 = s2 + (_GAMMA1 * self._u2)
            s3 = self._x2_hat + (_PHI2_3 * self._d_hat)
            p2 = s3 + (_GAMMA2 * self._u2)
            p3 = self._d_hat

            # Correct by what is measured, where it is believed.
            if self._seen == 0:
                base = y[0]
                gap = _R(0.0)
            else:
                base = p1
                gap = y[0] - p1
            if np.isfinite(y[0]) and (np.abs(y[0]) <= 1.5) and (np.abs(gap) <= 0.5):
                miss = gap
                trust = 3
            else:
                miss = _R(0.0)
                trust = max(self._trust - 1, 0)
            if not (trust > 0):
                return Control(_R(0.0), Status.INPUT)
            left_o = max(_OBSERVER_SAMPLES - elapsed, 0)
            o0 = _R(left_o)
            if o0 > 8.0:
                o0f2 = o0 * (o0 - 1.0)
                r0 = 1.0 / (o0f2 * (o0 - 2.0))
                l1 = (_Q1_1 + (_Q1_2 * o0) + (_Q1_3 * o0f2)) * r0
                l2 = (_Q2_1 + (_Q2_2 * o0)) * r0
                l3 = _Q3_1 * r0
            elif left_o == 8:
                l1 = _R(1.0)
                l2 = _E0_2
                l3 = _E0_3
            elif left_o == 7:
                l1 = _R(1.0)
                l2 = _E1_2
                l3 = _E1_3
            else:
                l1 = _R(1.0)
                l2 = _E2_2
                l3 = _E2_3
            x1 = base + (l1 * miss)
            x2 = p2 + (l2 * miss)
            d = p3 + (l3 * miss)

            # The tracking error.
            e1 = x1 - r[0]
            e2 = x2 - r[1]

            # The exact law in samples.
            m0 = _R((43 - elapsed) & _WRAP) if elapsed < 37 else _R(6.0)
            z1 = (_W1_1 * e1) + (_W1_2 * e2)
            z2 = _W2_2 * e2
            z3 = _W3_3 * ((self._u1 + d) - self._rho1)
            m0f2 = m0 * (m0 - 1.0)
            s4 = (z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0))
            v = ((s4 + ((self._u1 + d) - self._rho1)) - d) + r[2]
            if not np.isfinite(v):
                return Control(_R(0.0), Status.RANGE)
            if v > _U_MAX:
                u_now = _U_MAX
            elif v < -_U_MAX:
                u_now = -_U_MAX
            else:
                u_now = v
            self._u2 = self._u1
            self._u1 = u_now
            self._rho1 = r[2]
            self._x1_hat = x1
            self._x2_hat = x2
            self._d_hat = d
            self._seen = 1
            self._trust = trust
            if trust < 3:
                return Control(u_now, Status.GATED)
            elif (v > _U_MAX) or (v < -_U_MAX):
                return Control(u_now, Status.SATURATED)
            elif elapsed < _SAMPLES:
                return Control(u_now, Status.OK)
            else:
                return Control(u_now, Status.HOLD)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the constant that is added to u."""
        return self._d_hat
