"""
Prescribed-time controller stage35: outputs of order 2, 1, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --mu "exp(a=1)" --name stage35 --clock samples --tau=0.3 --eps=0 --limits=20,30 --poles="[[-3,-4],[-4]]" --states="s, v, i" --inputs=F,V --outputs="s, i" --dynamics="v, 3*i - 2*s - v/2 + F, V - 4*i + s/8" --sample-time=0.01
Version 0.1.0, design 28ee8693b5c2.

Plant: the inputs F, V: s' = v, v' = 3*i - 2*s - v/2 + F, i' = V - 4*i + s/8, output 1 = s,
      output 2 = i; u held from sample to sample.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state, as long as
      no u is clipped and nothing else acts on the plant.
Law of each output, of order n, in its chain xi as it is sampled, which is the output with
      its derivatives up to O(h), and which held inputs move exactly: with M - s samples to
      go and z = S xi, v h^n = sum of row_j z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are
      those of Theorem 1 for the mapping exp. xi_j of output i is xj_i in step, and v_i is
      law_i. s = 2, 3. Output 1: The gains of 2 samples to go stay: they are deadbeat.
      Output 2: The gains of 1 sample to go stay: they are deadbeat.
Output 1, of order n = 2, to four digits:
  xi_1 = s - 4.167e-6*v + 2.5e-5*i
  xi_2 = v
  f_1 = -1.993*s - 0.5087*v + 2.933*i
Output 2, of order n = 1, to four digits:
  xi_1 = i
  f_2 = 0.1225*s + 6.157e-4*v - 3.921*i
u = G^-1 w with w_i = v_i - f_i, to four digits:
  G^-1 = [[1.003, -0.01511], [-2.107e-6, 1.02]]
Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
      input of this number.
  output 1: k = 12, 7; u_max = 20
  output 2: k = 4; u_max = 30

Parameters:
  samples = 30 [samples], fixed: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
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
  growth: sound: at rest at sample 30 from any state, whatever the poles, and |u| is
      bounded.
  sampling: not checked: the law is exact in samples, at any period.
  deadline: not checked: the law is exact in samples, at any period.
  loop: not checked: `x0_max` is not given.
  envelope: not checked: `x_max` is not given.
  zeros: sound: none: the relative degrees are 2, 1, whose sum is the number of states.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Axes", "Control", "Params", "Stage35", "Status"]

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

# Weight of x1 in the law.
_W1_1_1 = _R(-120000.0)
# Weight of x2 in the law.
_W1_2_1 = _R(600.0)
# Weight of x2 in the law.
_W2_2_1 = _R(-600.0)
# Weight of x1 in the law.
_W1_1_2 = _R(-400.0)

class Stage35:
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
        """u = (F, V) from tick `k`, which may wrap, and state x = (s, v, i). Where one of them is
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

            # The chain of each output as it is sampled.
            x1_2 = x[2]
            s1 = x[0] + ((-4.16676736285295e-6) * x[1])
            x1_1 = s1 + (2.499973960459077e-5 * x1_2)
            x2_1 = 1.0000166669696244 * x[1]

            # The exact law in samples.
            m0_1 = _R((32 - elapsed) & _WRAP) if elapsed < 28 else _R(4.0)
            z1_1 = (_W1_1_1 * x1_1) + (_W1_2_1 * x2_1)
            z2_1 = _W2_2_1 * x2_1
            law_1 = (z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0))
            m0_2 = _R((33 - elapsed) & _WRAP) if elapsed < 29 else _R(4.0)
            z1_2 = _W1_1_2 * x1_2
            law_2 = z1_2 / m0_2

            # The inputs that give all of them.
            s2 = ((-1.993127946172519) * x[0]) + ((-0.5087209499488312) * x[1])
            v1 = law_1 - (s2 + (2.9333536080559304 * x1_2))
            s3 = (0.12252888444119461 * x[0]) + (0.0006157089861155933 * x[1])
            v2 = law_2 - (s3 + ((-3.921049966023507) * x1_2))
            control1 = (1.002518807547881 * v1) + ((-0.015112747669367257) * v2)
            control2 = ((-2.106833310985952e-6) * v1) + (1.0201333455511812 * v2)
            if elapsed < 30:
                status = Status.OK
            else:
                status = Status.HOLD
            if np.isfinite(control1) and np.isfinite(control2):
                u[0] = control1
                axes[0] = status
                u[1] = control2
                axes[1] = status
                if control1 > 20.0:
                    u[0] = _R(20.0)
                    axes[0] = Status.SATURATED
                    status = Status.SATURATED
                elif control1 < -20.0:
                    u[0] = _R(-20.0)
                    axes[0] = Status.SATURATED
                    status = Status.SATURATED
                if control2 > 30.0:
                    u[1] = _R(30.0)
                    axes[1] = Status.SATURATED
                    status = Status.SATURATED
                elif control2 < -30.0:
                    u[1] = _R(-30.0)
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
