"""
Prescribed-time controller stage13: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name stage13 --clock samples --A="[[0,1],[49,-0.1]]" --B="[0.1,-1.3]" --C="[[1,0.5],[0.2,-1]]" --precision f32 --eps=0 --after zero --sample-time=0.01
Version 0.1.0, design 66f29bb0af19.

Plant: x' = A x + B u of --A and --B above; u held from sample to sample, y = C x.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M samples to go and z = S x, the differences of a flat output, u = sum of row_j
      z_j/((M-j+1)...(M-1)) less the drift of z; the rows are those of Theorem 1 for the
      mapping exp. Close to the end deadbeat takes over.

Parameters:
  samples [samples]: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
  k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
  deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on u = 0 (status AFTER).
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample N from any state, whatever the poles, and |u| is bounded.
  sampling: not checked: the law is exact in samples, at any period.
  deadline: not checked: the law is exact in samples, at any period.
  loop: not checked: `samples` is left to run time.
  envelope: not checked: it does not examine a clock in samples.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Params", "Stage13", "Status"]

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
    """samples N from the start to rest [samples], at least 2"""
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""
    k: Sequence[float]
    """gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite"""
    deadbeat: float
    """samples to go at which deadbeat takes over, 0 for a safe default [samples], finite"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Weight of x1 in the law.
_C_1 = _R(_R(54.263023376464844))
# Weight of x2 in the law.
_C_2 = _R(_R(4.285571575164795))
# Weight of x1 in the law.
_B_1 = _R(_R(11626.224609375))
# Weight of x2 in the law.
_B_2 = _R(_R(1009.7781372070313))

class Stage13:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_samples = params.samples.__index__()
            if given_samples != given_samples & _WRAP:
                raise ValueError(f"params.samples is {params.samples}; legal: 0..2^32 - 1")
            given_u_max = _R(params.u_max)
            given_k = _numbers(params.k, 2, "params.k")
            given_deadbeat = _R(params.deadbeat)
            if not (given_samples > 1):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 2")
            if not (given_u_max > _R(0.0)):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not np.isfinite(given_k[0]):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(given_k[1]):
                raise ValueError(f"params.k[1] is {params.k[1]}; legal: finite")
            if not (np.isfinite(given_deadbeat) and (given_deadbeat >= _R(0.0))):
                raise ValueError(f"params.deadbeat is {params.deadbeat}; legal: >= 0")
            samples = given_samples
            s1 = (given_k[1] - _R(1.0)) + _R(2.0)
            s2 = max(s1, _R(4.0))
            deadbeat = given_deadbeat if given_deadbeat > _R(0.0) else s2
            w1_1 = (-_R(10746.611328125)) * (-given_k[0])
            w1_2 = (-_R(788.2066650390625)) * (-given_k[0])
            w2_1 = (-_R(412.67474365234375)) * (_R(1.0) - given_k[1])
            w2_2 = (-_R(108.64293670654297)) * (_R(1.0) - given_k[1])
            u_max = given_u_max
            if not (
                np.isfinite(deadbeat)
                and np.isfinite(w1_1)
                and np.isfinite(w1_2)
                and np.isfinite(w2_1)
                and np.isfinite(w2_2)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._deadbeat = deadbeat
            self._w1_1 = w1_1
            self._w1_2 = w1_2
            self._w2_1 = w2_1
            self._w2_2 = w2_2
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`."""
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, y: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and what is measured, y = C x.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            y = _numbers(y, 2, "y")
            if not (np.isfinite(y[0]) and np.isfinite(y[1])):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP
            x1 = (_R(0.9090909361839294) * y[0]) + (_R(0.4545454680919647) * y[1])
            x2 = (_R(0.1818181872367859) * y[0]) - (_R(0.9090909361839294) * y[1])
            left = max(self._samples - elapsed, 0)
            m0 = _R(left)
            if m0 > self._deadbeat:
                # The exact law in samples.
                z1 = (self._w1_1 * x1) + (self._w1_2 * x2)
                z2 = (self._w2_1 * x1) + (self._w2_2 * x2)
                s1 = (_C_1 * x1) + (_C_2 * x2)
                v = ((z1 + (z2 * m0)) / (m0 * (m0 - _R(1.0)))) + s1
            else:
                # Deadbeat.
                v = (_B_1 * x1) + (_B_2 * x2)
            if np.isfinite(v):
                if elapsed < self._samples:
                    if v > self._u_max:
                        return Control(self._u_max, Status.SATURATED)
                    elif v < -self._u_max:
                        return Control(-self._u_max, Status.SATURATED)
                    else:
                        return Control(v, Status.OK)
                else:
                    return Control(_R(0.0), Status.AFTER)
            else:
                return Control(_R(0.0), Status.RANGE)
