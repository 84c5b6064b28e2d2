"""
Prescribed-time controller motor: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name motor --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=150 --observer-eps=0.04 --tau=0.4 --eps=0.02 --u-max=24 --poles=-4,-5,-6,-7 --sample-time=1e-3 --delay=1 --sensor-step=6e-6
Version 0.1.0, design c4f0b0da5e5e.

Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
      sample to sample, one sample late, y = C x.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M - 3 samples to go and z = S x, the differences of a flat output, u = sum of
      row_j z_j/((M-j+1)...(M-3)) less the drift of z; the rows are those of Theorem 1 for
      the mapping exp. The gains of 20 samples to go stay.

Parameters:
  samples = 400 [samples], fixed: samples N from the start to rest
  h = 1e-3 [s], fixed: sample period
  eps = 0.02 [s], fixed: time-to-go at which the gains are held
  u_max = 24 [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 840 [1/s^4], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_2 = 638 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_3 = 179 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_4 = 22 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
The estimates are exact from sample 150 after the start on where the measurement is; with
      noise or sensor_step given, or observer_eps, the gains of the observer are then held
      below deadbeat.
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: near rest at sample 400, not at rest: the gains are held from 20 samples
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

__all__ = ["Control", "Motor", "Params", "Status"]

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
    INPUT = -2
    """x or t is not finite, or t is before t0."""
    RANGE = -3
    """u is not finite."""

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

class Motor:
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
            self._x1_next = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x2_next = _R(0.0)
            self._x3_hat = _R(0.0)
            self._x3_next = _R(0.0)
            self._d_hat = _R(0.0)
            self._d_next = _R(0.0)

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
            y = _numbers(y, 1, "y")
            if not np.isfinite(y[0]):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP

            # The estimates; at first what y shows.
            if self._seen == 0:
                x1 = y[0]
                x2 = _R(0.0)
                x3 = _R(0.0)
                d = _R(0.0)
            else:
                x1 = self._x1_next + (0.00010816330676811052 * self._u2)
                x2 = self._x2_next + (0.30941358230147875 * self._u2)
                x3 = self._x3_next + (0.37459048481653323 * self._u2)
                d = self._d_next

            # Prediction of the next sample.
            miss1 = y[0] - x1
            off1 = miss1
            left_o = max(150 - elapsed, 0)
            o0 = max(_R(left_o), _R(40.0))
            r0 = 1.0 / o0
            r1 = 1.0 / (o0 - 1.0)
            r2 = 1.0 / (o0 - 2.0)
            r3 = 1.0 / (o0 - 3.0)
            s1 = (((((((-96.0) * r0) + 96.0) * r1) - 48.0) * r2) + 16.0) * r3
            l1 = s1 - 0.46857164949780494
            s2 = ((859382.9277311233 * r0) - 513847.60335174634) * r1
            s3 = (((s2 + 125558.23800330989) * r2) - 9808.939721535125) * r3
            l2 = s3 + 264.4187821124759
            s4 = (((-620544.0922410007) * r0) + 289368.54342637886) * r1
            s5 = (((s4 - 49493.69520132396) * r2) + 3680.3758886140504) * r3
            l3 = s5 - 98.64522377262374
            l4 = 42644.35104284018 * r0 * r1 * r2 * r3
            s6 = x1 + (0.000996505559752715 * x2) + (0.0006188271646029575 * x3)
            x1_on = s6 + (0.00010816330676811052 * d) + (l1 * off1)
            s7 = (0.9902193397510792 * x2) + (1.1234620408672982 * x3)
            x2_on = s7 + (0.30941358230147875 * d) + (l2 * off1)
            s8 = ((-0.011234620408672982) * x2) + (0.5412090107511158 * x3)
            x3_on = s8 + (0.37459048481653323 * d) + (l3 * off1)
            d_on = d + (l4 * off1)
            left = max(400 - elapsed, 0)
            m0 = max(_R(left), _R(20.0))

            # The exact law in samples.
            s9 = ((-1492552.2864994062) * x1) + (1567.1688802442739 * x2)
            z1 = s9 - (863.5135156573022 * x3)
            z2 = ((-853.121915155696) * x2) + (704.6828966771754 * x3)
            z3 = (0.10681268759856057 * x2) - (320.4380627956817 * x3)
            s10 = (0.4798607068523099 * x2) + (19.61787944307025 * x3)
            z4 = s10 - (16.0 * (self._u1 + d))
            s11 = ((((z1 / (m0 + 3.0)) + z2) / (m0 + 2.0)) + z3) / (m0 + 1.0)
            s12 = ((-0.014068298956658285) * x2) - (0.5288375642249519 * x3)
            s13 = ((s11 + z4) / m0) + (s12 + (1.468571649497805 * (self._u1 + d)))
            v = s13 - d
            if not (
                np.isfinite(v)
                and np.isfinite(x1_on)
                and np.isfinite(x2_on)
                and np.isfinite(x3_on)
                and np.isfinite(d_on)
            ):
                return Control(_R(0.0), Status.RANGE)
            if 24.0 < v:
                u_now = _R(24.0)
            elif v < -24.0:
                u_now = _R(-24.0)
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
            if (24.0 < v) or (v < -24.0):
                return Control(u_now, Status.SATURATED)
            elif _R(left) <= 20.0:
                return Control(u_now, Status.HOLD)
            else:
                return Control(u_now, Status.OK)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat, self._x3_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the constant that is added to u."""
        return self._d_hat
