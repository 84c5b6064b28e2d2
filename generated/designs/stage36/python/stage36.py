"""
Prescribed-time controller stage36: outputs of order 2, 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --mu exp --name stage36 --clock samples --precision f32 --eps=0 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[2, 1/2], [1/2, 1]]" --bias="3*q1 - c*q2 + w1/4, c*q2" --param c=2 --sample-time=0.02
Version 0.1.0, design 9c23f2154001.

Plant: the inputs F1, F2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[2, 1/2],
      [1/2, 1]], bias = [3*q1 - c*q2 + w1/4, c*q2]; u held from sample to sample.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state, as long as
      no u is clipped and nothing else acts on the plant.
Law of each output, of order n, in its chain xi as it is sampled, which is the output with
      its derivatives up to O(h), and which held inputs move exactly: with M - s samples to
      go and z = S xi, v h^n = sum of row_j z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are
      those of Theorem 1 for the mapping exp. xi_j of output i is xj_i in step, and v_i is
      law_i. s = 0, 0. Output 1: Close to the end deadbeat takes over. Output 2: Close to
      the end deadbeat takes over.
Output 1, of order n = 2, to four digits:
  xi_1 = q1 - 4.762e-6*w1 + 5.443e-11*w2
  xi_2 = w1 - 5.715e-5*w2
  f_1 = -1.712*q1 + 1.712*q2 - 0.1598*w1 + 0.01713*w2
Output 2, of order n = 2, to four digits:
  xi_1 = q2 + 2.381e-6*w1 - 2.722e-11*w2
  xi_2 = -2.858e-5*w1 + w2
  f_2 = 0.8558*q1 - 2.856*q2 + 0.07988*w1 - 0.02856*w2
u = G^-1 w with w_i = v_i - f_i, to four digits:
  G^-1 = [[2.003, 0.4999], [0.5, 1]]
Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
      input of this number.

Parameters:
  samples [samples]: samples N from the start to rest
  h = 0.02 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a [1/s]: rate of stretched time
  k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
  k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
  deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
  c = 2 [as in its expression], fixed: parameter of an expression of the design

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
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
  envelope: not checked: `x_max` is not given.
  zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Axes", "Control", "Params", "Stage36", "Status"]

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

class Axes(NamedTuple):
    """Result of a step of several axes, for each time and state of the batch."""

    u: Array
    """Inputs of the plants along the last axis; 0 on a negative status."""
    axes: NDArray[np.int8]
    """The Status of each axis, along the last axis."""
    status: NDArray[np.int8]
    """That of the first axis that fails; else SATURATED where one is."""

@dataclass(frozen=True, kw_only=True)
class Params:
    """Run-time parameters."""

    samples: int
    """samples N from the start to rest [samples], at least 2"""
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""
    a: float
    """rate of stretched time [1/s], from 1e-18 to 1e18"""
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
_B_1_1 = _R(-_R(2500.0))
# Weight of x2 in the law.
_B_2_1 = _R(-_R(75.0))
# Weight of x1 in the law.
_B_1_2 = _R(-_R(2500.0))
# Weight of x2 in the law.
_B_2_2 = _R(-_R(75.0))

class Stage36:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_samples = params.samples.__index__()
            if given_samples != given_samples & _WRAP:
                raise ValueError(f"params.samples is {params.samples}; legal: 0..2^32 - 1")
            given_u_max = _R(params.u_max)
            given_a = _R(params.a)
            given_k = _numbers(params.k, 2, "params.k")
            given_deadbeat = _R(params.deadbeat)
            if not (given_samples > 1):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 2")
            if not (given_u_max > _R(0.0)):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not (_R(1.000000045813705e-18) <= given_a <= _R(9.999999843067494e17)):
                raise ValueError(f"params.a is {params.a}; legal: from 1.000000045813705e-18 to 9.999999843067494e17")
            if not np.isfinite(given_k[0]):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(given_k[1]):
                raise ValueError(f"params.k[1] is {params.k[1]}; legal: finite")
            if not (np.isfinite(given_deadbeat) and (given_deadbeat >= _R(0.0))):
                raise ValueError(f"params.deadbeat is {params.deadbeat}; legal: >= 0")
            samples = given_samples
            s1 = ((given_k[1] / given_a) - _R(1.0)) + _R(2.0)
            s2 = max(s1, _R(4.0))
            deadbeat_1 = given_deadbeat if given_deadbeat > _R(0.0) else s2
            w1_1_1 = _R(2500.0) * (-(given_k[0] / (given_a * given_a)))
            w1_2_1 = _R(50.0) * ((-_R(0.5)) * (-(given_k[0] / (given_a * given_a))))
            w2_2_1 = _R(50.0) * (_R(1.0) - (given_k[1] / given_a))
            u_max = given_u_max
            if not (
                np.isfinite(deadbeat_1)
                and np.isfinite(w1_1_1)
                and np.isfinite(w1_2_1)
                and np.isfinite(w2_2_1)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._deadbeat_1 = deadbeat_1
            self._w1_1_1 = w1_1_1
            self._w1_2_1 = w1_2_1
            self._w2_2_1 = w2_2_1
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`."""
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike) -> Axes:
        """u = (F1, F2) from tick `k`, which may wrap, and state x = (q1, q2, w1, w2). Where one of
        them is not finite, as at a state at which the inputs do not decouple the outputs, every u
        is 0; else the status is SATURATED where one was clipped.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 4, "x")
            u = np.zeros(2, dtype=_R)
            axes = np.zeros(2, dtype=np.int8)
            if not (
                np.isfinite(x[0])
                and np.isfinite(x[1])
                and np.isfinite(x[2])
                and np.isfinite(x[3])
            ):
                return Axes(
                    np.zeros(2, dtype=_R),
                    np.full(2, Status.INPUT, dtype=np.int8),
                    np.asarray(Status.INPUT, dtype=np.int8),
                )
            elapsed = (k - self._start) & _WRAP

            # The chain of each output as it is sampled.
            x1_1 = x[0] + ((-_R(4.762448497785954e-6)) * x[2]) + (_R(5.443012707218031e-11) * x[3])
            x2_1 = (_R(1.0000571012496948) * x[2]) + ((-_R(5.715329825761728e-5)) * x[3])
            x1_2 = x[1] + (_R(2.3814147880329983e-6) * x[2]) + ((-_R(2.7217396739165345e-11)) * x[3])
            x2_2 = ((-_R(2.857664912880864e-5)) * x[2]) + (_R(1.000095248222351) * x[3])
            left = max(self._samples - elapsed, 0)
            m0_1 = _R(left)
            m0_2 = _R(left)
            if m0_1 > self._deadbeat_1:
                # The exact law in samples.
                z1_1 = (self._w1_1_1 * x1_1) + (self._w1_2_1 * x2_1)
                z2_1 = self._w2_2_1 * x2_1
                law_1 = (z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - _R(1.0)))
            else:
                # Deadbeat.
                law_1 = (_B_1_1 * x1_1) + (_B_2_1 * x2_1)
            if m0_2 > self._deadbeat_1:
                # The exact law in samples.
                z1_2 = (self._w1_1_1 * x1_2) + (self._w1_2_1 * x2_2)
                z2_2 = self._w2_2_1 * x2_2
                law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - _R(1.0)))
            else:
                # Deadbeat.
                law_2 = (_B_1_2 * x1_2) + (_B_2_2 * x2_2)

            # The inputs that give all of them.
            s1 = ((-_R(1.7116923332214355)) * x[0]) + (_R(1.7115782499313354) * x[1]) + ((-_R(0.15976756811141968)) * x[2])
            v1 = law_1 - (s1 + (_R(0.017126543447375298) * x[3]))
            s2 = (_R(0.8557890057563782) * x[0]) + ((-_R(2.8555986881256104)) * x[1]) + (_R(0.0798790231347084) * x[2])
            v2 = law_2 - (s2 + ((-_R(0.028563272207975388)) * x[3]))
            control1 = (_R(2.002601385116577) * v1) + (_R(0.4999333322048187) * v2)
            control2 = (_R(0.4999999403953552) * v1) + (_R(1.0000666379928589) * v2)
            if elapsed < self._samples:
                status = Status.OK
            else:
                status = Status.HOLD
            if np.isfinite(control1) and np.isfinite(control2):
                u[0] = control1
                axes[0] = status
                u[1] = control2
                axes[1] = status
                if control1 > self._u_max:
                    u[0] = self._u_max
                    axes[0] = Status.SATURATED
                    status = Status.SATURATED
                elif control1 < -self._u_max:
                    u[0] = -self._u_max
                    axes[0] = Status.SATURATED
                    status = Status.SATURATED
                if control2 > self._u_max:
                    u[1] = self._u_max
                    axes[1] = Status.SATURATED
                    status = Status.SATURATED
                elif control2 < -self._u_max:
                    u[1] = -self._u_max
                    axes[1] = Status.SATURATED
                    status = Status.SATURATED
            else:
                u[0] = _R(0.0)
                if np.isfinite(control1):
                    axes[0] = status
                else:
                    axes[0] = Status.RANGE
                u[1] = _R(0.0)
                if np.isfinite(control2):
                    axes[1] = status
                else:
                    axes[1] = Status.RANGE
                status = Status.RANGE
            return Axes(u, axes, np.asarray(status, dtype=np.int8))
