"""
Prescribed-time controller stage22: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name stage22 --clock samples --tau=0.3 --eps=0 --poles=-3,-4 --states="q, w" --input=F --output="q + q^3/6" --dynamics="w, F/(2 + q^2) - k*q^3 - 3*w" --reference input --sample-time=0.01
Version 0.1.0, design 1531839ead9d.

Plant: the input F: q' = w, w' = F/(2 + q^2) - k*q^3 - 3*w, output q + q^3/6; u held from
      sample to sample.
Goal: the output and its derivatives up to order 1, x, are 0 at sample N after the start,
      from any state, as long as u is not clipped and the plant is the model. f and g are
      known at the samples alone, which leaves an error of order h^(4-i) in x_i.
Law: with M samples to go and z = S x, w h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1)),
      and u = (w - f)/g; the rows are those of Theorem 1 for the mapping exp. The gains of
      2 samples to go stay: they are deadbeat. Rest is planned 2 samples early, and the
      last gains bring down what f and g did between samples.
With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = (w + rho -
      f)/g. At sample N e is 0 where r^(n) is constant over each sample; else an error of
      order h^(4-i) is left in e_i.
e_i = x_i - r[i-1] with r[0]..r[1] the reference and its derivatives at tick k, and rho =
      r[2], r^(n) over the sample in which u acts: its mean, (r^(n-1)(t + h) -
      r^(n-1)(t))/h, or that in its middle.

Parameters:
  samples = 30 [samples], fixed: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 12 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_2 = 7 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
  k [as in its expression]: parameter of an expression of the design

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample 30 from any state, but for what f + g u and r do between
      samples, whatever the poles, and |u| is bounded.
  sampling: not checked: `loop` bounds what the period leaves of a model that is not linear.
  deadline: not checked: `loop` bounds what the period leaves of a model that is not linear.
  loop: not checked: `k` is left to run time.
  envelope: not checked: it does not examine a clock in samples.
  zeros: sound: none: the relative degree is 2, the number of states.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Params", "Stage22", "Status"]

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
    k: float
    """parameter of an expression of the design [as in its expression], finite"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Weight of x1 in the law.
_W1_1 = _R(-120000.0)
# Weight of x2 in the law.
_W1_2 = _R(600.0)
# Weight of x2 in the law.
_W2_2 = _R(-600.0)
# Samples from the start to rest.
_SAMPLES = 30

class Stage22:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_u_max = _R(params.u_max)
            given_k = _R(params.k)
            if not (given_u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not np.isfinite(given_k):
                raise ValueError(f"params.k is {params.k}; legal: finite")
            p_k = given_k
            u_max = given_u_max
            self._start = 0
            self._p_k = p_k
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`."""
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike, r: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and the state x of the model, and the reference.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 2, "x")
            r = _numbers(r, 3, "r")
            if not (
                np.isfinite(x[0])
                and np.isfinite(x[1])
                and np.isfinite(r[0])
                and np.isfinite(r[1])
                and np.isfinite(r[2])
            ):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP

            # The chain of the output.
            v1 = x[0] * x[0]
            v2 = x[0] * v1
            x1 = x[0] + (v2 * 0.16666666666666666)
            v3 = 2.0 + v1
            x2 = x[1] * v3 * 0.5

            # The tracking error.
            e1 = x1 - r[0]
            e2 = x2 - r[1]

            # The exact law in samples.
            m0 = _R((30 - elapsed) & _WRAP) if elapsed < 26 else _R(4.0)
            z1 = (_W1_1 * e1) + (_W1_2 * e2)
            z2 = _W2_2 * e2
            w = ((z1 + (z2 * m0)) / (m0 * (m0 - 1.0))) + r[2]
            s1 = (-((self._p_k * v2) + (3.0 * x[1]))) * v3
            v = (w - ((s1 + (x[1] * (2.0 * x[0] * x[1]))) * 0.5)) * 2.0
            if np.isfinite(v):
                if v > self._u_max:
                    return Control(self._u_max, Status.SATURATED)
                elif v < -self._u_max:
                    return Control(-self._u_max, Status.SATURATED)
                elif elapsed < _SAMPLES:
                    return Control(v, Status.OK)
                else:
                    return Control(v, Status.HOLD)
            else:
                return Control(_R(0.0), Status.RANGE)
