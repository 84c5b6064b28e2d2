"""
Prescribed-time controller stage27: outputs of order 1, 2, 1, 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --mu "exp(a=0.8)" --name stage27 --clock samples --eps=0 --u-max=inf --poles="[[-4],[-3,-4],[-5],[-2.5,-6]]" --states="a, b, b1, c, d, d1" --inputs=A,B,C,D --outputs="a, b, c, d" --dynamics="A*(2 + b^2) + B - a*c, b1, B*(3 + a) + C*d - b*d1, C + D*a - c^2, d1, D*(2 - b) + A*c + a"
Version 0.1.0, design 7fcab43de361.

Plant: the inputs A, B, C, D: a' = A*(2 + b^2) + B - a*c, b' = b1, b1' = B*(3 + a) + C*d -
      b*d1, c' = C + D*a - c^2, d' = d1, d1' = D*(2 - b) + A*c + a, output 1 = a, output 2
      = b, output 3 = c, output 4 = d; u held from sample to sample.
Goal: every output with its derivatives is 0 at sample N after the start, from any state,
      as long as no u is clipped and the plant is the model. The plant is known at the
      samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
      n.
Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
      z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
      v_i is law_i in step. s = 3, -2, -1, -2. Output 1: The gains of 1 sample to go stay:
      they are deadbeat. Rest is planned 1 sample early, and the last gains bring down what
      f and g did between samples. Output 2: From 6 samples to go on these are M - 3 and
      the exponents 4, 5, those of least energy. The gains of 2 samples to go stay: they
      are deadbeat. Rest is planned 2 samples early, and the last gains bring down what f
      and g did between samples. Output 3: From 7 samples to go on these are M - 6 and the
      exponents 7, those of least energy. The gains of 1 sample to go stay: they are
      deadbeat. Rest is planned 1 sample early, and the last gains bring down what f and g
      did between samples. Output 4: From 9 samples to go on these are M - 3 and the
      exponents 4, 5, those of least energy. The gains of 2 samples to go stay: they are
      deadbeat. Rest is planned 2 samples early, and the last gains bring down what f and g
      did between samples.
Output 1, of order n = 1:
  x_1 = a
  f_1 = -a*c
Output 2, of order n = 2:
  x_1 = b
  x_2 = b1
  f_2 = -b*d1
Output 3, of order n = 1:
  x_1 = c
  f_3 = -c^2
Output 4, of order n = 2:
  x_1 = d
  x_2 = d1
  f_4 = a
u of D u = w with w_i = v_i - f_i, by elimination with pivots:
  D = [[2 + b^2, 1, 0, 0], [0, 3 + a, d, 0], [0, 0, 1, a], [c, 0, 0, 2 - b]]
Outputs: 4, each with a law of its own, with this deadline and mapping; u_max is of the
      input of this number.
  output 1: k = 4
  output 2: k = 12, 7
  output 3: k = 5
  output 4: k = 15, 8.5

Parameters:
  samples [samples]: samples N from the start to rest
  h [s]: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max = inf [unit of u], fixed: bound of |u|
  a = 0.8 [1/s], fixed: rate of stretched time

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
u is not clipped.
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
  zeros: sound: none: the relative degrees are 1, 2, 1, 2, whose sum is the number of
      states.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Axes", "Control", "Params", "Stage27", "Status"]

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
    """samples N from the start to rest [samples], at least 2"""
    h: float
    """sample period [s], from 1e-150 to 1e150"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

def _eliminate(given_b: Sequence[ArrayLike], given_a: Sequence[ArrayLike]) -> list[Array]:
    """Solves a x = b, with a row by row, by elimination with the largest pivot of each column: b
    becomes x, NaN where a is singular.
    """
    b = [np.asarray(v, dtype=_R) for v in given_b]
    a = [np.asarray(v, dtype=_R) for v in given_a]
    for k in range(4):
        most = np.asarray(k)
        largest = np.asarray(np.abs(a[(4 * k) + k]))
        for i in range(k + 1, 4):
            size = np.abs(a[(4 * i) + k])
            holds = np.asarray(largest < size)
            if holds.any():
                largest = np.where(holds, size, largest)
                most = np.where(holds, i, most)
        for i in range(k + 1, 4):
            holds = np.asarray(most == i)
            if holds.any():
                kept = b[k]
                b[k] = np.where(holds, b[i], b[k])
                b[i] = np.where(holds, kept, b[i])
                for j in range(k, 4):
                    entry = a[(4 * k) + j]
                    a[(4 * k) + j] = np.where(holds, a[(4 * i) + j], a[(4 * k) + j])
                    a[(4 * i) + j] = np.where(holds, entry, a[(4 * i) + j])
        a[(4 * k) + k] = np.where((a[(4 * k) + k] < 0.0) | (a[(4 * k) + k] > 0.0), a[(4 * k) + k], _R(np.nan))
        for i in range(k + 1, 4):
            factor = a[(4 * i) + k] / a[(4 * k) + k]
            for j in range(k + 1, 4):
                a[(4 * i) + j] = a[(4 * i) + j] - (factor * a[(4 * k) + j])
            b[i] = b[i] - (factor * b[k])
    for k in reversed(range(4)):
        for j in range(k + 1, 4):
            b[k] = b[k] - (a[(4 * k) + j] * b[j])
        b[k] = b[k] / a[(4 * k) + k]
    return b

# Samples to go at which the law of the end takes over.
_END_SAMPLES_2 = _R(6.0)
# Samples to go at which the law of the end takes over.
_END_SAMPLES_3 = _R(7.0)
# Samples to go at which the law of the end takes over.
_END_SAMPLES_4 = _R(9.0)

class Stage27:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_samples = params.samples.__index__()
            if given_samples != given_samples & _WRAP:
                raise ValueError(f"params.samples is {params.samples}; legal: 0..2^32 - 1")
            given_h = _R(params.h)
            if not (given_samples > 1):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 2")
            if not (1e-150 <= given_h <= 1e150):
                raise ValueError(f"params.h is {params.h}; legal: from 1e-150 to 1e150")
            samples = given_samples
            w1_1_1 = (-5.0) * (1.0 / given_h)
            w1_1_2 = (-18.75) * (1.0 / (given_h * given_h))
            w1_2_2 = 9.375 * (1.0 / given_h)
            w2_2_2 = (-7.75) * (1.0 / given_h)
            end1_1_2 = (-20.0) * (1.0 / (given_h * given_h))
            end1_2_2 = 10.0 * (1.0 / given_h)
            end2_2_2 = (-8.0) * (1.0 / given_h)
            w1_1_3 = (-6.25) * (1.0 / given_h)
            end1_1_3 = (-7.0) * (1.0 / given_h)
            w1_1_4 = (-23.4375) * (1.0 / (given_h * given_h))
            w1_2_4 = 11.71875 * (1.0 / given_h)
            w2_2_4 = (-9.625) * (1.0 / given_h)
            if not (
                np.isfinite(w1_1_1)
                and np.isfinite(w1_1_2)
                and np.isfinite(w1_2_2)
                and np.isfinite(w2_2_2)
                and np.isfinite(end1_1_2)
                and np.isfinite(end1_2_2)
                and np.isfinite(end2_2_2)
                and np.isfinite(w1_1_3)
                and np.isfinite(end1_1_3)
                and np.isfinite(w1_1_4)
                and np.isfinite(w1_2_4)
                and np.isfinite(w2_2_4)
                and (given_h * given_h >= 1e-200)
                and (1.0 / (given_h * given_h) >= 1e-200)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._w1_1_1 = w1_1_1
            self._w1_1_2 = w1_1_2
            self._w1_2_2 = w1_2_2
            self._w2_2_2 = w2_2_2
            self._end1_1_2 = end1_1_2
            self._end1_2_2 = end1_2_2
            self._end2_2_2 = end2_2_2
            self._w1_1_3 = w1_1_3
            self._end1_1_3 = end1_1_3
            self._w1_1_4 = w1_1_4
            self._w1_2_4 = w1_2_4
            self._w2_2_4 = w2_2_4

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`."""
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike) -> Axes:
        """u = (A, B, C, D) from tick `k`, which may wrap, and state x = (a, b, b1, c, d, d1). Where
        one of them is not finite, as at a state at which the inputs do not decouple the outputs,
        every u is 0; else the status is SATURATED where one was clipped.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 6, "x")
            u = np.zeros(4, dtype=_R)
            axes = np.zeros(4, dtype=np.int8)
            if not (
                np.isfinite(x[0])
                and np.isfinite(x[1])
                and np.isfinite(x[2])
                and np.isfinite(x[3])
                and np.isfinite(x[4])
                and np.isfinite(x[5])
            ):
                return Axes(
                    np.zeros(4, dtype=_R),
                    np.full(4, Status.INPUT, dtype=np.int8),
                    np.asarray(Status.INPUT, dtype=np.int8),
                )
            elapsed = (k - self._start) & _WRAP

            # The chain of each output.
            x1_1 = x[0]
            x1_2 = x[1]
            x2_2 = x[2]
            x1_3 = x[3]
            x1_4 = x[4]
            x2_4 = x[5]
            left = max(self._samples - elapsed, 0)
            s1 = _R(left) - 1.0
            m0_1 = max(s1, _R(1.0))

            # The exact law in samples.
            z1_1 = self._w1_1_1 * x1_1
            law_1 = z1_1 / (m0_1 + 4.0)
            m0_2 = _R(left) - 2.0
            m0_3 = _R(left) - 1.0
            m0_4 = _R(left) - 2.0
            if m0_2 > _END_SAMPLES_2:
                # The exact law in samples.
                z1_2 = (self._w1_1_2 * x1_2) + (self._w1_2_2 * x2_2)
                z2_2 = self._w2_2_2 * x2_2
                law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0))
            else:
                # The law of least energy to the end.
                m1_2 = max(m0_2, _R(2.0))
                y1_2 = (self._end1_1_2 * x1_2) + (self._end1_2_2 * x2_2)
                y2_2 = self._end2_2_2 * x2_2
                m1f_21 = m1_2 + 3.0
                law_2 = (y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 2.0))
            if m0_3 > _END_SAMPLES_3:
                # The exact law in samples.
                z1_3 = self._w1_1_3 * x1_3
                law_3 = z1_3 / m0_3
            else:
                # The law of least energy to the end.
                m1_3 = max(m0_3, _R(1.0))
                y1_3 = self._end1_1_3 * x1_3
                law_3 = y1_3 / (m1_3 + 6.0)
            if m0_4 > _END_SAMPLES_4:
                # The exact law in samples.
                z1_4 = (self._w1_1_4 * x1_4) + (self._w1_2_4 * x2_4)
                z2_4 = self._w2_2_4 * x2_4
                law_4 = (z1_4 + (z2_4 * m0_4)) / (m0_4 * (m0_4 - 1.0))
            else:
                # The law of least energy to the end.
                m1_4 = max(m0_4, _R(2.0))
                y1_4 = (self._end1_1_2 * x1_4) + (self._end1_2_2 * x2_4)
                y2_4 = self._end2_2_2 * x2_4
                m1f_41 = m1_4 + 3.0
                law_4 = (y1_4 + (y2_4 * m1f_41)) / (m1f_41 * (m1_4 + 2.0))

            # The inputs that give all of them.
            v1 = _eliminate([law_1 - ((-x1_1) * x1_3), law_2 - ((-x1_2) * x2_4), law_3 - (-(x1_3 * x1_3)), law_4 - x1_1], [2.0 + (x1_2 * x1_2), 1.0, 0.0, 0.0, 0.0, 3.0 + x1_1, x1_4, 0.0, 0.0, 0.0, 1.0, x1_1, x1_3, 0.0, 0.0, 2.0 - x1_2])
            control1 = v1[0]
            control2 = v1[1]
            control3 = v1[2]
            control4 = v1[3]
            if elapsed < self._samples:
                status = Status.OK
            else:
                status = Status.HOLD
            if (
                np.isfinite(control1)
                and np.isfinite(control2)
                and np.isfinite(control3)
                and np.isfinite(control4)
            ):
                u[0] = control1
                axes[0] = status
                u[1] = control2
                axes[1] = status
                u[2] = control3
                axes[2] = status
                u[3] = control4
                axes[3] = status
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
                u[2] = _R(0.0)
                if np.isfinite(control3):
                    axes[2] = status
                else:
                    axes[2] = Status.RANGE
                u[3] = _R(0.0)
                if np.isfinite(control4):
                    axes[3] = status
                else:
                    axes[3] = Status.RANGE
                status = Status.RANGE
            return Axes(u, axes, np.asarray(status, dtype=np.int8))
