"""
Prescribed-time controller stage28: outputs of order 1, 1, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --mu "exp(a=1)" --name stage28 --clock samples --deadbeat=9 --eps=0 --gains="[[3],[4.5]]" --states="a, b" --inputs=A,B --outputs="a, b" --dynamics="A*(b - 1), A + B - k*a"
Version 0.1.0, design e8fd88f575ec.

Plant: the inputs A, B: a' = A*(b - 1), b' = A + B - k*a, output 1 = a, output 2 = b; u
      held from sample to sample.
Goal: every output with its derivatives is 0 at sample N after the start, from any state,
      as long as no u is clipped and the plant is the model. The plant is known at the
      samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
      n.
Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
      z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
      v_i is law_i in step. s = 0, 0. Output 1: Close to the end, with 9 samples to go
      deadbeat takes over. Output 2: Close to the end, with 9 samples to go deadbeat takes
      over.
Output 1, of order n = 1:
  x_1 = a
Output 2, of order n = 1:
  x_1 = b
  f_2 = -k*a
u = adj(D) w/det(D) with w_i = v_i - f_i:
  det(D) = b - 1
  adj(D) = [[1, 0], [-1, b - 1]]
Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
      input of this number.
  output 1: k = 3
  output 2: k = 4.5

Parameters:
  samples [samples]: samples N from the start to rest
  h [s]: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k [as in its expression]: parameter of an expression of the design

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
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
  zeros: sound: none: the relative degrees are 1, 1, whose sum is the number of states.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Axes", "Control", "Params", "Stage28", "Status"]

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
    """samples N from the start to rest [samples], at least 1"""
    h: float
    """sample period [s], from 1e-150 to 1e150"""
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

# Samples to go at which deadbeat takes over.
_DEADBEAT_1 = _R(9.0)
# Samples to go at which deadbeat takes over.
_DEADBEAT_2 = _R(9.0)

class Stage28:
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
            given_k = _R(params.k)
            if not (given_samples > 0):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 1")
            if not (1e-150 <= given_h <= 1e150):
                raise ValueError(f"params.h is {params.h}; legal: from 1e-150 to 1e150")
            if not (given_u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not np.isfinite(given_k):
                raise ValueError(f"params.k is {params.k}; legal: finite")
            samples = given_samples
            w1_1_1 = (-3.0) * (1.0 / given_h)
            b_1_1 = -(1.0 / given_h)
            w1_1_2 = (-4.5) * (1.0 / given_h)
            p_k = given_k
            c1 = -p_k
            u_max = given_u_max
            if not (
                np.isfinite(w1_1_1)
                and np.isfinite(b_1_1)
                and np.isfinite(w1_1_2)
                and np.isfinite(c1)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            if not (given_h >= 1e-200):
                raise ValueError(f"params.h is {params.h}; legal: >= 1e-200")
            if not (1.0 / given_h >= 1e-200):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._w1_1_1 = w1_1_1
            self._b_1_1 = b_1_1
            self._w1_1_2 = w1_1_2
            self._p_k = p_k
            self._c1 = c1
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`."""
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike) -> Axes:
        """u = (A, B) from tick `k`, which may wrap, and state x = (a, b). Where one of them is not
        finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else
        the status is SATURATED where one was clipped.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 2, "x")
            u = np.zeros(2, dtype=_R)
            axes = np.zeros(2, dtype=np.int8)
            if not (np.isfinite(x[0]) and np.isfinite(x[1])):
                return Axes(
                    np.zeros(2, dtype=_R),
                    np.full(2, Status.INPUT, dtype=np.int8),
                    np.asarray(Status.INPUT, dtype=np.int8),
                )
            elapsed = (k - self._start) & _WRAP

            # The chain of each output.
            x1_1 = x[0]
            x1_2 = x[1]
            left = max(self._samples - elapsed, 0)
            m0_1 = _R(left)
            m0_2 = _R(left)
            if m0_1 > _DEADBEAT_1:
                # The exact law in samples.
                z1_1 = self._w1_1_1 * x1_1
                law_1 = z1_1 / m0_1
            else:
                # Deadbeat.
                law_1 = self._b_1_1 * x1_1
            if m0_2 > _DEADBEAT_2:
                # The exact law in samples.
                z1_2 = self._w1_1_2 * x1_2
                law_2 = z1_2 / m0_2
            else:
                # Deadbeat.
                law_2 = self._b_1_1 * x1_2

            # The inputs that give all of them.
            v2 = x1_2 - 1.0
            v3 = np.where((v2 < 0.0) | (v2 > 0.0), 1.0 / v2, _R(np.nan))
            control1 = law_1 * v3
            control2 = ((-law_1) + (v2 * (law_2 - (self._c1 * x1_1)))) * v3
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
