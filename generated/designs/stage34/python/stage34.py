"""
Prescribed-time controller stage34: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --axes 2 --mu exp --name stage34 --clock samples --guard none --eps=0 --g="3" --reference input
Version 0.1.0, design 0d8dd7fc9d15.

Plant: x1' = x2, ..., x3' = g u; u held from sample to sample.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
      the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
      over.
With a reference r of each axis, e_i = x_i - r^(i-1) is in place of x_i above, and u = w +
      rho/g of each axis. What r^(n) changes over a sample leaves an error of order
      h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is constant there.
Row i of r is of axis i, of order n: in its places 0..n-1 the reference and its derivatives
      at tick k, and in place n rho, r^(n) over the sample in which u acts: its mean,
      (r^(n-1)(t + h) - r^(n-1)(t))/h, or that in its middle.
Axes: 2, each a chain of its own with this deadline and mapping. step computes what depends
      on time once.

Parameters:
  samples [samples]: samples N from the start to rest
  h [s]: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a [1/s]: rate of stretched time
  k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
  k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
  k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
  deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard none: finite measurements and references are the responsibility of the caller.
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample N from any state, but for what r does between samples,
      whatever the poles, and |u| is bounded.
  sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
  deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
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

__all__ = ["Axes", "Control", "Params", "Stage34", "Status"]

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
    """samples N from the start to rest [samples], at least 3"""
    h: float
    """sample period [s], from 1e-150 to 1e150"""
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""
    a: float
    """rate of stretched time [1/s], from 1e-150 to 1e150"""
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

def _of_axes(given: ArrayLike, count: int, length: int, name: str) -> Array:
    """The numbers of each axis: the last two dimensions."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape[-2:] != (count, length):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: (..., {count}, {length})")
    return numbers

class Stage34:
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
            given_k = _numbers(params.k, 3, "params.k")
            given_deadbeat = _R(params.deadbeat)
            if not (given_samples > 2):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 3")
            if not (1e-150 <= given_h <= 1e150):
                raise ValueError(f"params.h is {params.h}; legal: from 1e-150 to 1e150")
            if not (given_u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not (1e-150 <= given_a <= 1e150):
                raise ValueError(f"params.a is {params.a}; legal: from 1e-150 to 1e150")
            if not np.isfinite(given_k[0]):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(given_k[1]):
                raise ValueError(f"params.k[1] is {params.k[1]}; legal: finite")
            if not np.isfinite(given_k[2]):
                raise ValueError(f"params.k[2] is {params.k[2]}; legal: finite")
            if not (np.isfinite(given_deadbeat) and (given_deadbeat >= 0.0)):
                raise ValueError(f"params.deadbeat is {params.deadbeat}; legal: >= 0")
            samples = given_samples
            s1 = ((given_k[2] / given_a) - 4.0) + 3.0
            s2 = max(s1, _R(6.0))
            deadbeat_1 = given_deadbeat if given_deadbeat > 0.0 else s2
            s3 = -(given_k[0] / (given_a * given_a * given_a))
            s4 = 1.0 / (given_h * given_h * given_h)
            w1_1_1 = 0.3333333333333333 * s3 * s4
            s5 = -(given_k[0] / (given_a * given_a * given_a))
            w1_2_1 = (-0.3333333333333333) * s5 * (1.0 / (given_h * given_h))
            s6 = -(given_k[0] / (given_a * given_a * given_a))
            w1_3_1 = 0.1111111111111111 * s6 * (1.0 / given_h)
            s7 = (-1.0) - (given_k[1] / (given_a * given_a))
            s8 = 0.3333333333333333 * (s7 + (given_k[2] / given_a))
            w2_2_1 = s8 * (1.0 / (given_h * given_h))
            s9 = (-1.0) - (given_k[1] / (given_a * given_a))
            s10 = (-0.16666666666666666) * (s9 + (given_k[2] / given_a))
            w2_3_1 = s10 * (1.0 / given_h)
            s11 = 0.3333333333333333 * (3.0 - (given_k[2] / given_a))
            w3_3_1 = s11 * (1.0 / given_h)
            s12 = 1.0 / (given_h * given_h * given_h)
            b_1_1 = (-0.3333333333333333) * s12
            b_2_1 = (-0.6666666666666666) * (1.0 / (given_h * given_h))
            b_3_1 = (-0.6111111111111112) * (1.0 / given_h)
            u_max = given_u_max
            if not (
                np.isfinite(deadbeat_1)
                and np.isfinite(w1_1_1)
                and np.isfinite(w1_2_1)
                and np.isfinite(w1_3_1)
                and np.isfinite(w2_2_1)
                and np.isfinite(w2_3_1)
                and np.isfinite(w3_3_1)
                and np.isfinite(b_1_1)
                and np.isfinite(b_2_1)
                and np.isfinite(b_3_1)
                and (given_h * given_h * given_h >= 1e-200)
                and (1.0 / (given_h * given_h * given_h) >= 1e-200)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._deadbeat_1 = deadbeat_1
            self._w1_1_1 = w1_1_1
            self._w1_2_1 = w1_2_1
            self._w1_3_1 = w1_3_1
            self._w2_2_1 = w2_2_1
            self._w2_3_1 = w2_3_1
            self._w3_3_1 = w3_3_1
            self._b_1_1 = b_1_1
            self._b_2_1 = b_2_1
            self._b_3_1 = b_3_1
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`."""
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike, r: ArrayLike) -> Axes:
        """u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) and the
        reference r of each. Where one of them is not finite, every u is 0; else the status is
        SATURATED where one was clipped.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _of_axes(x, 2, 3, "x")
            r = _of_axes(r, 2, 4, "r")
            u = np.zeros(2, dtype=_R)
            axes = np.zeros(2, dtype=np.int8)
            elapsed = (k - self._start) & _WRAP
            x1_1 = x[..., 0, 0]
            x2_1 = x[..., 0, 1]
            x3_1 = x[..., 0, 2]
            x1_2 = x[..., 1, 0]
            x2_2 = x[..., 1, 1]
            x3_2 = x[..., 1, 2]

            # The tracking error.
            e1_1 = x1_1 - r[..., 0, 0]
            e2_1 = x2_1 - r[..., 0, 1]
            e3_1 = x3_1 - r[..., 0, 2]
            e1_2 = x1_2 - r[..., 1, 0]
            e2_2 = x2_2 - r[..., 1, 1]
            e3_2 = x3_2 - r[..., 1, 2]
            left = max(self._samples - elapsed, 0)
            m0_1 = _R(left)
            m0_2 = _R(left)
            if m0_1 > self._deadbeat_1:
                # The exact law in samples.
                s1 = (self._w1_1_1 * e1_1) + (self._w1_2_1 * e2_1)
                z1_1 = s1 + (self._w1_3_1 * e3_1)
                z2_1 = (self._w2_2_1 * e2_1) + (self._w2_3_1 * e3_1)
                z3_1 = self._w3_3_1 * e3_1
                m0f_12 = m0_1 * (m0_1 - 1.0)
                s2 = (z1_1 + (z2_1 * m0_1) + (z3_1 * m0f_12)) / (m0f_12 * (m0_1 - 2.0))
                law_1 = s2 + (0.3333333333333333 * r[..., 0, 3])
            else:
                # Deadbeat.
                s3 = (self._b_1_1 * e1_1) + (self._b_2_1 * e2_1)
                law_1 = s3 + (self._b_3_1 * e3_1) + (0.3333333333333333 * r[..., 0, 3])
            if m0_2 > self._deadbeat_1:
                # The exact law in samples.
                s4 = (self._w1_1_1 * e1_2) + (self._w1_2_1 * e2_2)
                z1_2 = s4 + (self._w1_3_1 * e3_2)
                z2_2 = (self._w2_2_1 * e2_2) + (self._w2_3_1 * e3_2)
                z3_2 = self._w3_3_1 * e3_2
                m0f_22 = m0_2 * (m0_2 - 1.0)
                s5 = (z1_2 + (z2_2 * m0_2) + (z3_2 * m0f_22)) / (m0f_22 * (m0_2 - 2.0))
                law_2 = s5 + (0.3333333333333333 * r[..., 1, 3])
            else:
                # Deadbeat.
                s6 = (self._b_1_1 * e1_2) + (self._b_2_1 * e2_2)
                law_2 = s6 + (self._b_3_1 * e3_2) + (0.3333333333333333 * r[..., 1, 3])
            if elapsed < self._samples:
                status = Status.OK
            else:
                status = Status.HOLD
            if np.isfinite(law_1) and np.isfinite(law_2):
                u[0] = law_1
                axes[0] = status
                u[1] = law_2
                axes[1] = status
                if law_1 > self._u_max:
                    u[0] = self._u_max
                    axes[0] = Status.SATURATED
                    status = Status.SATURATED
                elif law_1 < -self._u_max:
                    u[0] = -self._u_max
                    axes[0] = Status.SATURATED
                    status = Status.SATURATED
                if law_2 > self._u_max:
                    u[1] = self._u_max
                    axes[1] = Status.SATURATED
                    status = Status.SATURATED
                elif law_2 < -self._u_max:
                    u[1] = -self._u_max
                    axes[1] = Status.SATURATED
                    status = Status.SATURATED
            else:
                u[0] = _R(0.0)
                if np.isfinite(law_1):
                    axes[0] = status
                else:
                    axes[0] = Status.RANGE
                u[1] = _R(0.0)
                if np.isfinite(law_2):
                    axes[1] = status
                else:
                    axes[1] = Status.RANGE
                status = Status.RANGE
            return Axes(u, axes, np.asarray(status, dtype=np.int8))
