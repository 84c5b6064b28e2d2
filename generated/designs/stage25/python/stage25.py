"""
Prescribed-time controller stage25: outputs of order 1, 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --mu "exp(a=1)" --name stage25 --clock samples --tau=0.3 --eps=0.04 --limits=2,3 --poles="[[-4],[-3,-4.5]]" --states="h, c, e" --inputs=q,p --outputs="h, e" --dynamics="q - 1/10*h, p - c*(1 + h), (c - e)*(1 + h)" --sample-time=0.01
Version 0.1.0, design 602ddeccb2d0.

Plant: the inputs q, p: h' = q - 1/10*h, c' = p - c*(1 + h), e' = (c - e)*(1 + h), output 1
      = h, output 2 = e; u held from sample to sample.
Goal: every output with its derivatives is 0 at sample N after the start, from any state,
      as long as no u is clipped and the plant is the model. The plant is known at the
      samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
      n.
Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
      z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
      v_i is law_i in step. s = 2, -2. Output 1: The gains of 4 samples to go stay. Rest is
      planned 1 sample early, and the last gains bring down what f and g did between
      samples. Output 2: From 6 samples to go on these are M - 2 and the exponents 3, 4,
      those of least energy. The gains of 4 samples to go stay. Rest is planned 2 samples
      early, and the last gains bring down what f and g did between samples.
Output 1, of order n = 1:
  x_1 = h
  f_1 = -h/10
Output 2, of order n = 2:
  x_1 = e
  x_2 = (c - e)*(1 + h)
  f_2 = (-c*(1 + h) - (c - e)*(1 + h))*(1 + h) + (c - e)*(-h/10)
u = adj(D) w/det(D) with w_i = v_i - f_i:
  det(D) = 1 + h
  adj(D) = [[1 + h, 0], [-(c - e), 1]]
Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
      input of this number.
  output 1: k = 4; u_max = 2
  output 2: k = 13.5, 7.5; u_max = 3

Parameters:
  samples = 30 [samples], fixed: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
  eps = 0.04 [s], fixed: time-to-go at which the gains are held
  a = 1 [1/s], fixed: rate of stretched time

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: near rest at sample 30, not at rest: the gains are held from 4 samples to
      go, and |u| is bounded; so does what f + g u does between samples.
  sampling: not checked: `loop` bounds what the period leaves of a plant with several
      inputs.
  deadline: not checked: `loop` bounds what the period leaves of a plant with several
      inputs.
  loop: not checked: `x0_max` is not given.
  envelope: not checked: `x_max` is not given.
  zeros: sound: none: the relative degrees are 1, 2, whose sum is the number of states.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Axes", "Control", "Params", "Stage25", "Status"]

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

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Samples from the start to rest.
_SAMPLES = 30
# Samples to go at which the gains are held.
_HOLD = _R(4.0)
# Weight of x1 in the law.
_W1_1_1 = _R(-400.0)
# Samples to go at which the law of the end takes over.
_END_SAMPLES_2 = _R(6.0)
# Weight of x1 in the law.
_W1_1_2 = _R(-135000.0)
# Weight of x2 in the law.
_W1_2_2 = _R(675.0)
# Weight of x2 in the law.
_W2_2_2 = _R(-650.0)
# Weight of x1 in the law.
_END1_1_2 = _R(-120000.0)
# Weight of x2 in the law.
_END1_2_2 = _R(600.0)
# Weight of x2 in the law.
_END2_2_2 = _R(-600.0)

class Stage25:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            self._start = 0

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`."""
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike) -> Axes:
        """u = (q, p) from tick `k`, which may wrap, and state x = (h, c, e). Where one of them is
        not finite, as at a state at which the inputs do not decouple the outputs, every u is 0;
        else the status is SATURATED where one was clipped.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 3, "x")
            u = np.zeros(2, dtype=_R)
            axes = np.zeros(2, dtype=np.int8)
            if not (np.isfinite(x[0]) and np.isfinite(x[1]) and np.isfinite(x[2])):
                return Axes(
                    np.zeros(2, dtype=_R),
                    np.full(2, Status.INPUT, dtype=np.int8),
                    np.asarray(Status.INPUT, dtype=np.int8),
                )
            elapsed = (k - self._start) & _WRAP

            # The chain of each output.
            x1_1 = x[0]
            x1_2 = x[2]
            v1 = x[1] - x1_2
            v2 = 1.0 + x1_1
            x2_2 = v1 * v2
            left = max(_SAMPLES - elapsed, 0)
            s1 = _R(left) - 1.0
            m0_1 = max(s1, _HOLD)

            # The exact law in samples.
            z1_1 = _W1_1_1 * x1_1
            law_1 = z1_1 / (m0_1 + 3.0)
            s2 = _R(left) - 2.0
            m0_2 = max(s2, _HOLD)
            if m0_2 > _END_SAMPLES_2:
                # The exact law in samples.
                z1_2 = (_W1_1_2 * x1_2) + (_W1_2_2 * x2_2)
                z2_2 = _W2_2_2 * x2_2
                law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0))
            else:
                # The law of least energy to the end.
                m1_2 = max(m0_2, _R(2.0))
                y1_2 = (_END1_1_2 * x1_2) + (_END1_2_2 * x2_2)
                y2_2 = _END2_2_2 * x2_2
                m1f_21 = m1_2 + 2.0
                law_2 = (y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 1.0))

            # The inputs that give all of them.
            v3 = (-x1_1) * 0.1
            v4 = law_1 - v3
            v5 = np.where((v2 < 0.0) | (v2 > 0.0), 1.0 / v2, _R(np.nan))
            control1 = v2 * v4 * v5
            s3 = ((-v1) * v4) + (law_2 - (((((-x[1]) * v2) - x2_2) * v2) + (v1 * v3)))
            control2 = s3 * v5
            if _R(left) > _HOLD:
                status = Status.OK
            else:
                status = Status.HOLD
            if np.isfinite(control1) and np.isfinite(control2):
                u[0] = control1
                axes[0] = status
                u[1] = control2
                axes[1] = status
                if control1 > 2.0:
                    u[0] = _R(2.0)
                    axes[0] = Status.SATURATED
                    status = Status.SATURATED
                elif control1 < -2.0:
                    u[0] = _R(-2.0)
                    axes[0] = Status.SATURATED
                    status = Status.SATURATED
                if control2 > 3.0:
                    u[1] = _R(3.0)
                    axes[1] = Status.SATURATED
                    status = Status.SATURATED
                elif control2 < -3.0:
                    u[1] = _R(-3.0)
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
