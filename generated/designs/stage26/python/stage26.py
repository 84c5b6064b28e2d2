"""
Prescribed-time controller stage26: outputs of order 2, 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --mu exp --name stage26 --clock samples --precision f32 --guard none --eps=0 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[m + q2^2, q2], [q2, 1]]" --bias="m*q2*w1*w2, w1^2/2 - q1"
Version 0.1.0, design 7cc34530b578.

Plant: the inputs F1, F2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[m + q2^2,
      q2], [q2, 1]], bias = [m*q2*w1*w2, w1^2/2 - q1]; u held from sample to sample.
Goal: every output with its derivatives is 0 at sample N after the start, from any state,
      as long as no u is clipped and the plant is the model. The plant is known at the
      samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
      n.
Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
      z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
      v_i is law_i in step. s = 0, 0. Output 1: Close to the end deadbeat takes over.
      Output 2: Close to the end deadbeat takes over.
Output 1, of order n = 2:
  x_1 = q1
  x_2 = w1
Output 2, of order n = 2:
  x_1 = q2
  x_2 = w2
u = M v + bias
Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
      input of this number.

Parameters:
  samples [samples]: samples N from the start to rest
  h [s]: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a [1/s]: rate of stretched time
  k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
  k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
  deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
  m [as in its expression]: parameter of an expression of the design

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard none: finite measurements are the responsibility of the caller.
Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample N from any state, but for what f + g u does between
      samples, whatever the poles, and |u| is bounded.
  sampling: not checked: `loop` bounds what the period leaves of a plant with several
      inputs.
  deadline: not checked: `loop` bounds what the period leaves of a plant with several
      inputs.
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

__all__ = ["Axes", "Control", "Params", "Stage26", "Status"]

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
    h: float
    """sample period [s], from 1e-18 to 1e18"""
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""
    a: float
    """rate of stretched time [1/s], from 1e-18 to 1e18"""
    k: Sequence[float]
    """gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite"""
    deadbeat: float
    """samples to go at which deadbeat takes over, 0 for a safe default [samples], finite"""
    m: float
    """parameter of an expression of the design [as in its expression], finite"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

class Stage26:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_samples = params.samples.__index__()
            if given_samples != given_samples & _WRAP:
                raise ValueError(f"params.samples is {params.samples}; legal: 0..2^32 - 1")
            given_h = _R(params.h)
            given_u_max = _R(params.u_max)
            given_a = _R(params.a)
            given_k = _numbers(params.k, 2, "params.k")
            given_deadbeat = _R(params.deadbeat)
            given_m = _R(params.m)
            if not (given_samples > 1):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 2")
            if not (_R(1.000000045813705e-18) <= given_h <= _R(9.999999843067494e17)):
                raise ValueError(f"params.h is {params.h}; legal: from 1.000000045813705e-18 to 9.999999843067494e17")
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
            if not np.isfinite(given_m):
                raise ValueError(f"params.m is {params.m}; legal: finite")
            samples = given_samples
            s1 = ((given_k[1] / given_a) - _R(1.0)) + _R(2.0)
            s2 = max(s1, _R(4.0))
            deadbeat_1 = given_deadbeat if given_deadbeat > _R(0.0) else s2
            s3 = -(given_k[0] / (given_a * given_a))
            w1_1_1 = s3 * (_R(1.0) / (given_h * given_h))
            s4 = (-_R(0.5)) * (-(given_k[0] / (given_a * given_a)))
            w1_2_1 = s4 * (_R(1.0) / given_h)
            w2_2_1 = (_R(1.0) - (given_k[1] / given_a)) * (_R(1.0) / given_h)
            b_1_1 = -(_R(1.0) / (given_h * given_h))
            b_2_1 = (-_R(1.5)) * (_R(1.0) / given_h)
            p_m = given_m
            u_max = given_u_max
            if not (
                np.isfinite(deadbeat_1)
                and np.isfinite(w1_1_1)
                and np.isfinite(w1_2_1)
                and np.isfinite(w2_2_1)
                and np.isfinite(b_1_1)
                and np.isfinite(b_2_1)
                and (given_h * given_h >= _R(1.0000000031710769e-30))
                and (_R(1.0) / (given_h * given_h) >= _R(1.0000000031710769e-30))
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._deadbeat_1 = deadbeat_1
            self._w1_1_1 = w1_1_1
            self._w1_2_1 = w1_2_1
            self._w2_2_1 = w2_2_1
            self._b_1_1 = b_1_1
            self._b_2_1 = b_2_1
            self._p_m = p_m
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
            elapsed = (k - self._start) & _WRAP

            # The chain of each output.
            x1_1 = x[0]
            x2_1 = x[2]
            x1_2 = x[1]
            x2_2 = x[3]
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
                law_1 = (self._b_1_1 * x1_1) + (self._b_2_1 * x2_1)
            if m0_2 > self._deadbeat_1:
                # The exact law in samples.
                z1_2 = (self._w1_1_1 * x1_2) + (self._w1_2_1 * x2_2)
                z2_2 = self._w2_2_1 * x2_2
                law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - _R(1.0)))
            else:
                # Deadbeat.
                law_2 = (self._b_1_1 * x1_2) + (self._b_2_1 * x2_2)

            # The inputs that give all of them.
            s1 = ((self._p_m + (x1_2 * x1_2)) * law_1) + (x1_2 * law_2)
            control1 = s1 + (self._p_m * x1_2 * x2_1 * x2_2)
            control2 = (x1_2 * law_1) + law_2 + ((x2_1 * x2_1 * _R(0.5)) - x1_1)
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
