"""
Prescribed-time controller stage19: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name stage19 --clock samples --precision f32 --guard none --eps=0 --u-max=inf --states="q, w, i" --input=V --output="q" --dynamics="w, i/(1 + q^2) - w/4, 50*(V - 2*i - w)" --after zero
Version 0.1.0, design 837b86fb35a8.

Plant: the input V: q' = w, w' = i/(1 + q^2) - w/4, i' = 50*(V - 2*i - w), output q; u held
      from sample to sample.
Goal: the output and its derivatives up to order 2, x, are 0 at sample N after the start,
      from any state, as long as u is not clipped and the plant is the model. f and g are
      known at the samples alone, which leaves an error of order h^(5-i) in x_i.
Law: with M samples to go and z = S x, w h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2)),
      and u = (w - f)/g; the rows are those of Theorem 1 for the mapping exp. Close to the
      end deadbeat takes over.

Parameters:
  samples [samples]: samples N from the start to rest
  h [s]: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max = inf [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
  k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
  k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
  deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on u = 0 (status AFTER).
u is not clipped.
Guard none: finite measurements are the responsibility of the caller.
Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample N from any state, but for what f + g u does between
      samples, whatever the poles, and |u| is bounded.
  sampling: not checked: `loop` bounds what the period leaves of a model that is not linear.
  deadline: not checked: `loop` bounds what the period leaves of a model that is not linear.
  loop: not checked: `samples` is left to run time.
  envelope: not checked: it does not examine a clock in samples.
  zeros: sound: none: the relative degree is 3, the number of states.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Params", "Stage19", "Status"]

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

class Control(NamedTuple):
    """Result of a step."""

    u: np.float32
    """Input of the plant."""
    status: Status
    """Its Status."""

@dataclass(frozen=True, kw_only=True)
class Params:
    """Run-time parameters."""

    samples: int
    """samples N from the start to rest [samples], at least 3"""
    h: float
    """sample period [s], from 1e-18 to 1e18"""
    k: Sequence[float]
    """gains k_i of pi0 = -sum k_i xi_i [1/s^3], finite"""
    deadbeat: float
    """samples to go at which deadbeat takes over, 0 for a safe default [samples], finite"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

class Stage19:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_samples = params.samples.__index__()
            if given_samples != given_samples & _WRAP:
                raise ValueError(f"params.samples is {params.samples}; legal: 0..2^32 - 1")
            given_h = _R(params.h)
            given_k = _numbers(params.k, 3, "params.k")
            given_deadbeat = _R(params.deadbeat)
            if not (given_samples > 2):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 3")
            if not (_R(1.000000045813705e-18) <= given_h <= _R(9.999999843067494e17)):
                raise ValueError(f"params.h is {params.h}; legal: from 1.000000045813705e-18 to 9.999999843067494e17")
            if not np.isfinite(given_k[0]):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(given_k[1]):
                raise ValueError(f"params.k[1] is {params.k[1]}; legal: finite")
            if not np.isfinite(given_k[2]):
                raise ValueError(f"params.k[2] is {params.k[2]}; legal: finite")
            if not (np.isfinite(given_deadbeat) and (given_deadbeat >= _R(0.0))):
                raise ValueError(f"params.deadbeat is {params.deadbeat}; legal: >= 0")
            samples = given_samples
            s1 = (given_k[2] - _R(4.0)) + _R(3.0)
            s2 = max(s1, _R(6.0))
            deadbeat = given_deadbeat if given_deadbeat > _R(0.0) else s2
            w1_1 = (-given_k[0]) * (_R(1.0) / (given_h * given_h * given_h))
            w1_2 = given_k[0] * (_R(1.0) / (given_h * given_h))
            w1_3 = _R(0.3333333432674408) * (-given_k[0]) * (_R(1.0) / given_h)
            s3 = ((-_R(1.0)) - given_k[1]) + given_k[2]
            w2_2 = s3 * (_R(1.0) / (given_h * given_h))
            s4 = (-_R(0.5)) * (((-_R(1.0)) - given_k[1]) + given_k[2])
            w2_3 = s4 * (_R(1.0) / given_h)
            w3_3 = (_R(3.0) - given_k[2]) * (_R(1.0) / given_h)
            b_1 = -(_R(1.0) / (given_h * given_h * given_h))
            b_2 = (-_R(2.0)) * (_R(1.0) / (given_h * given_h))
            b_3 = (-_R(1.8333333730697632)) * (_R(1.0) / given_h)
            if not (
                np.isfinite(deadbeat)
                and np.isfinite(w1_1)
                and np.isfinite(w1_2)
                and np.isfinite(w1_3)
                and np.isfinite(w2_2)
                and np.isfinite(w2_3)
                and np.isfinite(w3_3)
                and np.isfinite(b_1)
                and np.isfinite(b_2)
                and np.isfinite(b_3)
                and (given_h * given_h * given_h >= _R(1.0000000031710769e-30))
                and (_R(1.0) / (given_h * given_h * given_h) >= _R(1.0000000031710769e-30))
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._deadbeat = deadbeat
            self._w1_1 = w1_1
            self._w1_2 = w1_2
            self._w1_3 = w1_3
            self._w2_2 = w2_2
            self._w2_3 = w2_3
            self._w3_3 = w3_3
            self._b_1 = b_1
            self._b_2 = b_2
            self._b_3 = b_3

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`."""
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and the state x of the model.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 3, "x")
            elapsed = (k - self._start) & _WRAP

            # The chain of the output.
            x1 = x[0]
            x2 = x[1]
            v1 = _R(1.0) + (x1 * x1)
            x3 = (x[2] / v1) - (x2 * _R(0.25))
            left = max(self._samples - elapsed, 0)
            m0 = _R(left)
            if m0 > self._deadbeat:
                # The exact law in samples.
                z1 = (self._w1_1 * x1) + (self._w1_2 * x2) + (self._w1_3 * x3)
                z2 = (self._w2_2 * x2) + (self._w2_3 * x3)
                z3 = self._w3_3 * x3
                w = ((((z1 / m0) + z2) / (m0 - _R(1.0))) + z3) / (m0 - _R(2.0))
            else:
                # Deadbeat.
                w = (self._b_1 * x1) + (self._b_2 * x2) + (self._b_3 * x3)
            s1 = ((-_R(50.0)) * (x2 + (_R(2.0) * x[2])) * v1) - (x[2] * (_R(2.0) * x1 * x2))
            v = (w - ((s1 / (v1 * v1)) - (x3 * _R(0.25)))) * v1 * _R(0.019999999552965164)
            if np.isfinite(v):
                if elapsed < self._samples:
                    return Control(v, Status.OK)
                else:
                    return Control(_R(0.0), Status.AFTER)
            else:
                return Control(_R(0.0), Status.RANGE)
