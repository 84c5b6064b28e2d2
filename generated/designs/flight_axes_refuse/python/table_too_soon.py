"""
Prescribed-time controller table_too_soon: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --axes 2 --mu "exp(a=1)" --name table_too_soon --clock samples --late=refuse --state-max=inf,0.5,4 --tau=1.5 --eps=0 --u-min=runtime --poles="[[-3,-4,-5],[-4,-5,-6]]" --sample-time=0.01
Version 0.1.0, design ed84b87c488b.

Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
      the rows are those of Theorem 1 for the mapping exp. From 8 samples to go on these
      are M - 2 and the exponents 3, 4, 5, those of least energy. The gains of 3 samples to
      go stay: they are deadbeat.
Axes: 2, each a chain of its own with this deadline and mapping. step computes what depends
      on time once.
  axis 1: k = 60, 47, 12
  axis 2: k = 120, 74, 15

Parameters:
  samples = 150 [samples], fixed: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: upper limit of u
  u_min [unit of u]: lower limit of u
  a = 1 [1/s], fixed: rate of stretched time

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
      else stays as it is.
Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
      so their Bernstein coefficients, linear in z, bound them. If these are within the
      limits, u and |x2| <= 0.5 and |x3| <= 4 stay there at every sample to rest, where
      plant and state are as they are known.
Axes: all come to rest at the same sample, and each deadline is tested for every one of
      them.
late refuse: arm_for refuses a deadline without such a plan (status E_SOON).
u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
      deadline where it lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample 150 from any state, whatever the poles, and |u| is
      bounded.
  sampling: not checked: the law is exact in samples, at any period.
  deadline: not checked: the law is exact in samples, at any period.
  loop: not checked: `x0_max` is not given.
  envelope: not checked: it does not examine a clock in samples.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Axes", "Control", "Params", "Status", "TableTooSoon"]

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

    u_max: float = np.inf
    """upper limit of u [unit of u], > u_min, infinity allowed"""
    u_min: float = -np.inf
    """lower limit of u [unit of u], < u_max, -infinity allowed"""

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

# Weight of x1 in the law.
_W1_1_1 = _R(-60000000.0)
# Weight of x2 in the law.
_W1_2_1 = _R(600000.0)
# Weight of x3 in the law.
_W1_3_1 = _R(-2000.0)
# Weight of x2 in the law.
_W2_2_1 = _R(-360000.0)
# Weight of x3 in the law.
_W2_3_1 = _R(1800.0)
# Weight of x3 in the law.
_W3_3_1 = _R(-900.0)
# Weight of x1 in the law.
_W1_1_2 = _R(-120000000.0)
# Weight of x2 in the law.
_W1_2_2 = _R(1200000.0)
# Weight of x3 in the law.
_W1_3_2 = _R(-4000.0)
# Weight of x2 in the law.
_W2_2_2 = _R(-600000.0)
# Weight of x3 in the law.
_W2_3_2 = _R(3000.0)
# Weight of x3 in the law.
_W3_3_2 = _R(-1200.0)
# Weight of x1 in the law.
_S1_1_1 = _R(1000000.0)
# Weight of x2 in the law.
_S1_2_1 = _R(-10000.0)
# 100/3, weight of x3 in the law.
_S1_3_1 = _R(33.333333333333336)
# Weight of x2 in the law.
_S2_2_1 = _R(10000.0)
# Weight of x3 in the law.
_S2_3_1 = _R(-50.0)
# Weight of x3 in the law.
_S3_3_1 = _R(100.0)
# Weight of x1 in the law.
_S1_1_2 = _R(1000000.0)
# Weight of x2 in the law.
_S1_2_2 = _R(-10000.0)
# 100/3, weight of x3 in the law.
_S1_3_2 = _R(33.333333333333336)
# Weight of x2 in the law.
_S2_2_2 = _R(10000.0)
# Weight of x3 in the law.
_S2_3_2 = _R(-50.0)
# Weight of x3 in the law.
_S3_3_2 = _R(100.0)

class TableTooSoon:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_u_max = _R(params.u_max)
            given_u_min = _R(params.u_min)
            if not (given_u_min < given_u_max):
                raise ValueError(f"params.u_min is {params.u_min}; legal: < u_max")
            u_max = given_u_max
            u_min = given_u_min
            self._start = 0
            self._last = 150
            self._u_max = u_max
            self._u_min = u_min

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`."""
        k = k.__index__() & _WRAP
        self._start = k
        self._last = 150

    def step(self, k: int, x: ArrayLike) -> Axes:
        """u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) of each.
        Where one of them is not finite, every u is 0; else the status is SATURATED where one was
        clipped.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _of_axes(x, 2, 3, "x")
            u = np.zeros(2, dtype=_R)
            axes = np.zeros(2, dtype=np.int8)
            if not (
                np.isfinite(x[..., 0, 0])
                and np.isfinite(x[..., 0, 1])
                and np.isfinite(x[..., 0, 2])
                and np.isfinite(x[..., 1, 0])
                and np.isfinite(x[..., 1, 1])
                and np.isfinite(x[..., 1, 2])
            ):
                return Axes(
                    np.zeros(2, dtype=_R),
                    np.full(2, Status.INPUT, dtype=np.int8),
                    np.asarray(Status.INPUT, dtype=np.int8),
                )
            elapsed = (k - self._start) & _WRAP
            x1_1 = x[..., 0, 0]
            x2_1 = x[..., 0, 1]
            x3_1 = x[..., 0, 2]
            x1_2 = x[..., 1, 0]
            x2_2 = x[..., 1, 1]
            x3_2 = x[..., 1, 2]
            left = max(self._last - elapsed, 0)
            m0_1 = max(_R(left), _R(3.0))

            # The exact law in samples.
            s1 = (_W1_1_1 * x1_1) + (_W1_2_1 * x2_1)
            z1_1 = s1 + (_W1_3_1 * x3_1)
            z2_1 = (_W2_2_1 * x2_1) + (_W2_3_1 * x3_1)
            z3_1 = _W3_3_1 * x3_1
            m0f_11 = m0_1 + 2.0
            m0f_12 = m0f_11 * (m0_1 + 1.0)
            law_1 = (z1_1 + (z2_1 * m0f_11) + (z3_1 * m0f_12)) / (m0f_12 * m0_1)
            m0_2 = max(_R(left), _R(3.0))
            s2 = (_W1_1_2 * x1_2) + (_W1_2_2 * x2_2)
            z1_2 = s2 + (_W1_3_2 * x3_2)
            z2_2 = (_W2_2_2 * x2_2) + (_W2_3_2 * x3_2)
            z3_2 = _W3_3_2 * x3_2
            m0f_21 = m0_2 + 3.0
            m0f_22 = m0f_21 * (m0_2 + 2.0)
            s3 = z1_2 + (z2_2 * m0f_21) + (z3_2 * m0f_22)
            law_2 = s3 / (m0f_22 * (m0_2 + 1.0))
            if elapsed < self._last:
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
                elif law_1 < self._u_min:
                    u[0] = self._u_min
                    axes[0] = Status.SATURATED
                    status = Status.SATURATED
                if law_2 > self._u_max:
                    u[1] = self._u_max
                    axes[1] = Status.SATURATED
                    status = Status.SATURATED
                elif law_2 < self._u_min:
                    u[1] = self._u_min
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

    def arm_for(self, k: int, samples: int, x: ArrayLike) -> None:
        """Another deadline, at any tick before the call of `step` at it: rest at tick `k` +
        `samples`, 3 to 2147483648 samples. A deadline before which a limit could be exceeded is
        refused (E_SOON).

        ValueError where an argument or what follows from it is not finite; the controller
        is left as it was.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            samples = samples.__index__() & _WRAP
            x = _of_axes(x, 2, 3, "x")
            if not ((samples > 2) and (samples < 2147483649)):
                raise ValueError("k and samples and x, and what follows, must be finite")
            if not (
                np.isfinite(x[..., 0, 0])
                and np.isfinite(x[..., 0, 1])
                and np.isfinite(x[..., 0, 2])
                and np.isfinite(x[..., 1, 0])
                and np.isfinite(x[..., 1, 1])
                and np.isfinite(x[..., 1, 2])
            ):
                raise ValueError("k and samples and x, and what follows, must be finite")
            x1_1 = x[..., 0, 0]
            x2_1 = x[..., 0, 1]
            x3_1 = x[..., 0, 2]
            x1_2 = x[..., 1, 0]
            x2_2 = x[..., 1, 1]
            x3_2 = x[..., 1, 2]
            s1 = (_S1_1_1 * x1_1) + (_S1_2_1 * x2_1)
            flat1_1 = s1 + (_S1_3_1 * x3_1)
            flat2_1 = (_S2_2_1 * x2_1) + (_S2_3_1 * x3_1)
            flat3_1 = _S3_3_1 * x3_1
            s2 = (_S1_1_2 * x1_2) + (_S1_2_2 * x2_2)
            flat1_2 = s2 + (_S1_3_2 * x3_2)
            flat2_2 = (_S2_2_2 * x2_2) + (_S2_3_2 * x3_2)
            flat3_2 = _S3_3_2 * x3_2
            least_1 = 0.999999999990586 * self._u_min
            most_1 = 0.999999999990586 * self._u_max
            most2_1 = _R(0.499999999995293)
            most3_1 = _R(3.999999999962344)
            least_2 = 0.999999999990586 * self._u_min
            most_2 = 0.999999999990586 * self._u_max
            most2_2 = _R(0.499999999995293)
            most3_2 = _R(3.999999999962344)
            tried = samples
            fits = np.asarray(0)
            m_1 = _R(tried)
            power1_1 = m_1 + 2.0
            power2_1 = power1_1 * (m_1 + 1.0)
            power3_1 = power2_1 * m_1
            power4_1 = power3_1 * (m_1 - 1.0)
            power5_1 = power4_1 * (m_1 - 2.0)
            scaled2_1 = flat2_1 * power1_1
            scaled3_1 = flat3_1 * power2_1
            s3 = (10.0 * flat1_1) + (4.0 * scaled2_1) + (0.5 * scaled3_1)
            w1_1 = s3 / power3_1
            w2_1 = ((((-15.0) * flat1_1) - (7.0 * scaled2_1)) - scaled3_1) / power4_1
            s4 = (6.0 * flat1_1) + (3.0 * scaled2_1) + (0.5 * scaled3_1)
            w3_1 = s4 / power5_1
            length_1 = m_1 - 4.0
            b0_c_1 = (((-6.0) * w1_1) - (72.0 * w2_1)) - (360.0 * w3_1)
            b1_c_1 = (((-24.0) * w2_1) - (300.0 * w3_1)) * length_1
            b2_l_1 = length_1 * length_1
            b2_c_1 = (-60.0) * w3_1 * b2_l_1
            b1_1 = b0_c_1 + (0.16666666666666666 * b1_c_1)
            s5 = b0_c_1 + (0.3333333333333333 * b1_c_1)
            b2_1 = s5 + (0.06666666666666667 * b2_c_1)
            b3_1 = b0_c_1 + (0.5 * b1_c_1) + (0.2 * b2_c_1)
            b4_1 = b0_c_1 + (0.6666666666666666 * b1_c_1) + (0.4 * b2_c_1)
            s6 = b0_c_1 + (0.8333333333333334 * b1_c_1)
            b5_1 = s6 + (0.6666666666666666 * b2_c_1)
            b6_1 = b0_c_1 + b1_c_1 + b2_c_1
            s0_c_1 = (((-0.0048) * w1_1) - (0.0168 * w2_1)) - (0.036 * w3_1)
            s1_c_1 = ((((-0.0024) * w1_1) - (0.0146 * w2_1)) - (0.051 * w3_1)) * length_1
            s2_l_1 = length_1 * length_1
            s2_c_1 = ((((-0.0003) * w1_1) - (0.0042 * w2_1)) - (0.0265 * w3_1)) * s2_l_1
            s3_l_1 = s2_l_1 * length_1
            s3_c_1 = (((-0.0004) * w2_1) - (0.006 * w3_1)) * s3_l_1
            s4_l_1 = s3_l_1 * length_1
            s4_c_1 = (-0.0005) * w3_1 * s4_l_1
            s1_1 = s0_c_1 + (0.125 * s1_c_1)
            s2_1 = s0_c_1 + (0.25 * s1_c_1) + (0.03571428571428571 * s2_c_1)
            s7 = s0_c_1 + (0.375 * s1_c_1) + (0.10714285714285714 * s2_c_1)
            s3_1 = s7 + (0.017857142857142856 * s3_c_1)
            s8 = s0_c_1 + (0.5 * s1_c_1) + (0.21428571428571427 * s2_c_1)
            s9 = s8 + (0.07142857142857142 * s3_c_1)
            s4_1 = s9 + (0.014285714285714285 * s4_c_1)
            s10 = s0_c_1 + (0.625 * s1_c_1) + (0.35714285714285715 * s2_c_1)
            s11 = s10 + (0.17857142857142858 * s3_c_1)
            s5_1 = s11 + (0.07142857142857142 * s4_c_1)
            s12 = s0_c_1 + (0.75 * s1_c_1) + (0.5357142857142857 * s2_c_1)
            s13 = s12 + (0.35714285714285715 * s3_c_1)
            s6_1 = s13 + (0.21428571428571427 * s4_c_1)
            s14 = s0_c_1 + (0.875 * s1_c_1) + (0.75 * s2_c_1) + (0.625 * s3_c_1)
            s7_1 = s14 + (0.5 * s4_c_1)
            s8_1 = s0_c_1 + s1_c_1 + s2_c_1 + s3_c_1 + s4_c_1
            v0_c_1 = (0.24 * w1_1) + (1.44 * w2_1) + (4.8 * w3_1)
            v1_c_1 = ((0.06 * w1_1) + (0.84 * w2_1) + (5.2 * w3_1)) * length_1
            v2_l_1 = length_1 * length_1
            v2_c_1 = ((0.12 * w2_1) + (1.8 * w3_1)) * v2_l_1
            v3_l_1 = v2_l_1 * length_1
            v3_c_1 = 0.2 * w3_1 * v3_l_1
            v1_1 = v0_c_1 + (0.14285714285714285 * v1_c_1)
            s15 = v0_c_1 + (0.2857142857142857 * v1_c_1)
            v2_1 = s15 + (0.047619047619047616 * v2_c_1)
            s16 = v0_c_1 + (0.42857142857142855 * v1_c_1)
            s17 = s16 + (0.14285714285714285 * v2_c_1)
            v3_1 = s17 + (0.02857142857142857 * v3_c_1)
            s18 = v0_c_1 + (0.5714285714285714 * v1_c_1)
            s19 = s18 + (0.2857142857142857 * v2_c_1)
            v4_1 = s19 + (0.11428571428571428 * v3_c_1)
            s20 = v0_c_1 + (0.7142857142857143 * v1_c_1)
            s21 = s20 + (0.47619047619047616 * v2_c_1)
            v5_1 = s21 + (0.2857142857142857 * v3_c_1)
            s22 = v0_c_1 + (0.8571428571428571 * v1_c_1)
            s23 = s22 + (0.7142857142857143 * v2_c_1)
            v6_1 = s23 + (0.5714285714285714 * v3_c_1)
            v7_1 = v0_c_1 + v1_c_1 + v2_c_1 + v3_c_1
            end51_1 = (((-6.0) * w1_1) - (48.0 * w2_1)) - (120.0 * w3_1)
            end52_1 = ((-6.0) * w1_1) - (24.0 * w2_1)
            end53_1 = (-6.0) * w1_1
            if (
                (least_1 <= b0_c_1 <= most_1)
                and (least_1 <= b1_1 <= most_1)
                and (least_1 <= b2_1 <= most_1)
                and (least_1 <= b3_1 <= most_1)
                and (least_1 <= b4_1 <= most_1)
                and (least_1 <= b5_1 <= most_1)
                and (least_1 <= b6_1 <= most_1)
                and (-most2_1 <= s0_c_1 <= most2_1)
                and (-most2_1 <= s1_1 <= most2_1)
                and (-most2_1 <= s2_1 <= most2_1)
                and (-most2_1 <= s3_1 <= most2_1)
                and (-most2_1 <= s4_1 <= most2_1)
                and (-most2_1 <= s5_1 <= most2_1)
                and (-most2_1 <= s6_1 <= most2_1)
                and (-most2_1 <= s7_1 <= most2_1)
                and (-most2_1 <= s8_1 <= most2_1)
                and (-most3_1 <= v0_c_1 <= most3_1)
                and (-most3_1 <= v1_1 <= most3_1)
                and (-most3_1 <= v2_1 <= most3_1)
                and (-most3_1 <= v3_1 <= most3_1)
                and (-most3_1 <= v4_1 <= most3_1)
                and (-most3_1 <= v5_1 <= most3_1)
                and (-most3_1 <= v6_1 <= most3_1)
                and (-most3_1 <= v7_1 <= most3_1)
                and (least_1 <= end51_1 <= most_1)
                and (least_1 <= end52_1 <= most_1)
                and (least_1 <= end53_1 <= most_1)
                and (np.abs((((-0.0027) * w1_1) - (0.006 * w2_1)) - (0.006 * w3_1)) <= most2_1)
                and (np.abs((((-0.0012) * w1_1) - (0.0011999999999999995 * w2_1)) + (8.131516293641283e-19 * w3_1)) <= most2_1)
                and (np.abs(((-0.00029999999999999965) * w1_1) + (8.131516293641283e-19 * w2_1) + (8.131516293641283e-19 * w3_1)) <= most2_1)
                and (np.abs((0.18 * w1_1) + (0.72 * w2_1) + (1.2 * w3_1)) <= most3_1)
                and (np.abs(((0.11999999999999994 * w1_1) + (0.23999999999999982 * w2_1)) - (2.0816681711721685e-16 * w3_1)) <= most3_1)
                and (np.abs((0.06000000000000016 * w1_1) + (4.579669976578771e-16 * w2_1) + (6.245004513516506e-16 * w3_1)) <= most3_1)
            ):
                fits = 1
            if fits == 1:
                m_2 = _R(tried)
                power1_2 = m_2 + 3.0
                power2_2 = power1_2 * (m_2 + 2.0)
                power3_2 = power2_2 * (m_2 + 1.0)
                power4_2 = power3_2 * m_2
                power5_2 = power4_2 * (m_2 - 1.0)
                power6_2 = power5_2 * (m_2 - 2.0)
                scaled2_2 = flat2_2 * power1_2
                scaled3_2 = flat3_2 * power2_2
                s24 = (15.0 * flat1_2) + (5.0 * scaled2_2) + (0.5 * scaled3_2)
                w1_2 = s24 / power4_2
                w2_2 = ((((-24.0) * flat1_2) - (9.0 * scaled2_2)) - scaled3_2) / power5_2
                s25 = (10.0 * flat1_2) + (4.0 * scaled2_2) + (0.5 * scaled3_2)
                w3_2 = s25 / power6_2
                length_2 = m_2 - 4.0
                b0_c_2 = (((-96.0) * w1_2) - (720.0 * w2_2)) - (2880.0 * w3_2)
                b1_c_2 = ((((-24.0) * w1_2) - (420.0 * w2_2)) - (3120.0 * w3_2)) * length_2
                b2_l_2 = length_2 * length_2
                b2_c_2 = (((-60.0) * w2_2) - (1080.0 * w3_2)) * b2_l_2
                b3_l_2 = b2_l_2 * length_2
                b3_c_2 = (-120.0) * w3_2 * b3_l_2
                b1_2 = b0_c_2 + (0.14285714285714285 * b1_c_2)
                s26 = b0_c_2 + (0.2857142857142857 * b1_c_2)
                b2_2 = s26 + (0.047619047619047616 * b2_c_2)
                s27 = b0_c_2 + (0.42857142857142855 * b1_c_2)
                s28 = s27 + (0.14285714285714285 * b2_c_2)
                b3_2 = s28 + (0.02857142857142857 * b3_c_2)
                s29 = b0_c_2 + (0.5714285714285714 * b1_c_2)
                s30 = s29 + (0.2857142857142857 * b2_c_2)
                b4_2 = s30 + (0.11428571428571428 * b3_c_2)
                s31 = b0_c_2 + (0.7142857142857143 * b1_c_2)
                s32 = s31 + (0.47619047619047616 * b2_c_2)
                b5_2 = s32 + (0.2857142857142857 * b3_c_2)
                s33 = b0_c_2 + (0.8571428571428571 * b1_c_2)
                s34 = s33 + (0.7142857142857143 * b2_c_2)
                b6_2 = s34 + (0.5714285714285714 * b3_c_2)
                b7_2 = b0_c_2 + b1_c_2 + b2_c_2 + b3_c_2
                s0_c_2 = (((-0.036) * w1_2) - (0.12 * w2_2)) - (0.252 * w3_2)
                s1_c_2 = ((((-0.0242) * w1_2) - (0.124 * w2_2)) - (0.3954 * w3_2)) * length_2
                s2_l_2 = length_2 * length_2
                s2_c_2 = ((((-0.0054) * w1_2) - (0.0475 * w2_2)) - (0.2415 * w3_2)) * s2_l_2
                s3_l_2 = s2_l_2 * length_2
                s3_c_2 = ((((-0.0004) * w1_2) - (0.008 * w2_2)) - (0.072 * w3_2)) * s3_l_2
                s4_l_2 = s3_l_2 * length_2
                s4_c_2 = (((-0.0005) * w2_2) - (0.0105 * w3_2)) * s4_l_2
                s5_l_2 = s4_l_2 * length_2
                s5_c_2 = (-0.0006) * w3_2 * s5_l_2
                s1_2 = s0_c_2 + (0.1111111111111111 * s1_c_2)
                s35 = s0_c_2 + (0.2222222222222222 * s1_c_2)
                s2_2 = s35 + (0.027777777777777776 * s2_c_2)
                s36 = s0_c_2 + (0.3333333333333333 * s1_c_2)
                s37 = s36 + (0.08333333333333333 * s2_c_2)
                s3_2 = s37 + (0.011904761904761904 * s3_c_2)
                s38 = s0_c_2 + (0.4444444444444444 * s1_c_2)
                s39 = s38 + (0.16666666666666666 * s2_c_2)
                s40 = s39 + (0.047619047619047616 * s3_c_2)
                s4_2 = s40 + (0.007936507936507936 * s4_c_2)
                s41 = s0_c_2 + (0.5555555555555556 * s1_c_2)
                s42 = s41 + (0.2777777777777778 * s2_c_2)
                s43 = s42 + (0.11904761904761904 * s3_c_2)
                s44 = s43 + (0.03968253968253968 * s4_c_2)
                s5_2 = s44 + (0.007936507936507936 * s5_c_2)
                s45 = s0_c_2 + (0.6666666666666666 * s1_c_2)
                s46 = s45 + (0.4166666666666667 * s2_c_2)
                s47 = s46 + (0.23809523809523808 * s3_c_2)
                s48 = s47 + (0.11904761904761904 * s4_c_2)
                s6_2 = s48 + (0.047619047619047616 * s5_c_2)
                s49 = s0_c_2 + (0.7777777777777778 * s1_c_2)
                s50 = s49 + (0.5833333333333334 * s2_c_2)
                s51 = s50 + (0.4166666666666667 * s3_c_2)
                s52 = s51 + (0.2777777777777778 * s4_c_2)
                s7_2 = s52 + (0.16666666666666666 * s5_c_2)
                s53 = s0_c_2 + (0.8888888888888888 * s1_c_2)
                s54 = s53 + (0.7777777777777778 * s2_c_2)
                s55 = s54 + (0.6666666666666666 * s3_c_2)
                s56 = s55 + (0.5555555555555556 * s4_c_2)
                s8_2 = s56 + (0.4444444444444444 * s5_c_2)
                s9_2 = s0_c_2 + s1_c_2 + s2_c_2 + s3_c_2 + s4_c_2 + s5_c_2
                v0_c_2 = (2.4 * w1_2) + (12.0 * w2_2) + (36.0 * w3_2)
                v1_c_2 = ((1.08 * w1_2) + (9.4 * w2_2) + (46.2 * w3_2)) * length_2
                v2_l_2 = length_2 * length_2
                v2_c_2 = ((0.12 * w1_2) + (2.4 * w2_2) + (21.3 * w3_2)) * v2_l_2
                v3_l_2 = v2_l_2 * length_2
                v3_c_2 = ((0.2 * w2_2) + (4.2 * w3_2)) * v3_l_2
                v4_l_2 = v3_l_2 * length_2
                v4_c_2 = 0.3 * w3_2 * v4_l_2
                v1_2 = v0_c_2 + (0.125 * v1_c_2)
                v2_2 = v0_c_2 + (0.25 * v1_c_2) + (0.03571428571428571 * v2_c_2)
                s57 = v0_c_2 + (0.375 * v1_c_2) + (0.10714285714285714 * v2_c_2)
                v3_2 = s57 + (0.017857142857142856 * v3_c_2)
                s58 = v0_c_2 + (0.5 * v1_c_2) + (0.21428571428571427 * v2_c_2)
                s59 = s58 + (0.07142857142857142 * v3_c_2)
                v4_2 = s59 + (0.014285714285714285 * v4_c_2)
                s60 = v0_c_2 + (0.625 * v1_c_2) + (0.35714285714285715 * v2_c_2)
                s61 = s60 + (0.17857142857142858 * v3_c_2)
                v5_2 = s61 + (0.07142857142857142 * v4_c_2)
                s62 = v0_c_2 + (0.75 * v1_c_2) + (0.5357142857142857 * v2_c_2)
                s63 = s62 + (0.35714285714285715 * v3_c_2)
                v6_2 = s63 + (0.21428571428571427 * v4_c_2)
                s64 = v0_c_2 + (0.875 * v1_c_2) + (0.75 * v2_c_2) + (0.625 * v3_c_2)
                v7_2 = s64 + (0.5 * v4_c_2)
                v8_2 = v0_c_2 + v1_c_2 + v2_c_2 + v3_c_2 + v4_c_2
                end61_2 = (((-72.0) * w1_2) - (360.0 * w2_2)) - (720.0 * w3_2)
                end62_2 = ((-48.0) * w1_2) - (120.0 * w2_2)
                end63_2 = (-24.0) * w1_2
                if (
                    (least_2 <= b0_c_2 <= most_2)
                    and (least_2 <= b1_2 <= most_2)
                    and (least_2 <= b2_2 <= most_2)
                    and (least_2 <= b3_2 <= most_2)
                    and (least_2 <= b4_2 <= most_2)
                    and (least_2 <= b5_2 <= most_2)
                    and (least_2 <= b6_2 <= most_2)
                    and (least_2 <= b7_2 <= most_2)
                    and (-most2_2 <= s0_c_2 <= most2_2)
                    and (-most2_2 <= s1_2 <= most2_2)
                    and (-most2_2 <= s2_2 <= most2_2)
                    and (-most2_2 <= s3_2 <= most2_2)
                    and (-most2_2 <= s4_2 <= most2_2)
                    and (-most2_2 <= s5_2 <= most2_2)
                    and (-most2_2 <= s6_2 <= most2_2)
                    and (-most2_2 <= s7_2 <= most2_2)
                    and (-most2_2 <= s8_2 <= most2_2)
                    and (-most2_2 <= s9_2 <= most2_2)
                    and (-most3_2 <= v0_c_2 <= most3_2)
                    and (-most3_2 <= v1_2 <= most3_2)
                    and (-most3_2 <= v2_2 <= most3_2)
                    and (-most3_2 <= v3_2 <= most3_2)
                    and (-most3_2 <= v4_2 <= most3_2)
                    and (-most3_2 <= v5_2 <= most3_2)
                    and (-most3_2 <= v6_2 <= most3_2)
                    and (-most3_2 <= v7_2 <= most3_2)
                    and (-most3_2 <= v8_2 <= most3_2)
                    and (least_2 <= end61_2 <= most_2)
                    and (least_2 <= end62_2 <= most_2)
                    and (least_2 <= end63_2 <= most_2)
                    and (np.abs((((-0.016800000000000002) * w1_2) - (0.036000000000000004 * w2_2)) - (0.036000000000000004 * w3_2)) <= most2_2)
                    and (np.abs((((-0.005999999999999998) * w1_2) - (0.005999999999999997 * w2_2)) + (4.87890977618477e-18 * w3_2)) <= most2_2)
                    and (np.abs(((-0.0011999999999999977) * w1_2) + (4.87890977618477e-18 * w2_2) + (4.87890977618477e-18 * w3_2)) <= most2_2)
                    and (np.abs((1.44 * w1_2) + (4.8 * w2_2) + (7.2 * w3_2)) <= most3_2)
                    and (np.abs(((0.7199999999999996 * w1_2) + (1.199999999999999 * w2_2)) - (1.2490009027033011e-15 * w3_2)) <= most3_2)
                    and (np.abs((0.2400000000000011 * w1_2) + (2.914335439641036e-15 * w2_2) + (3.747002708109903e-15 * w3_2)) <= most3_2)
                ):
                    fits = 2
            if not ((tried > 3) and (tried < 1073741825) and (fits == 2)):
                raise ValueError("k and samples and x, and what follows, must be finite")
            self._start = k
            self._last = samples

    def soonest(self, x: ArrayLike) -> int:
        """The fewest samples found, from the next call of `step` on, with which the law of each
        axis keeps u and the states within their limits at every sample to rest, from the state x of
        each, all of which come to rest at one sample, for sure. Give them to `arm_for`.

        ValueError where an argument is not finite, or where there is none.
        """
        with np.errstate(all="ignore"):
            x = _of_axes(x, 2, 3, "x")
            if not (
                np.isfinite(x[..., 0, 0])
                and np.isfinite(x[..., 0, 1])
                and np.isfinite(x[..., 0, 2])
                and np.isfinite(x[..., 1, 0])
                and np.isfinite(x[..., 1, 1])
                and np.isfinite(x[..., 1, 2])
            ):
                raise ValueError("an argument, or what follows from it, is not finite")
            x1_1 = x[..., 0, 0]
            x2_1 = x[..., 0, 1]
            x3_1 = x[..., 0, 2]
            x1_2 = x[..., 1, 0]
            x2_2 = x[..., 1, 1]
            x3_2 = x[..., 1, 2]
            s1 = (_S1_1_1 * x1_1) + (_S1_2_1 * x2_1)
            flat1_1 = s1 + (_S1_3_1 * x3_1)
            flat2_1 = (_S2_2_1 * x2_1) + (_S2_3_1 * x3_1)
            flat3_1 = _S3_3_1 * x3_1
            s2 = (_S1_1_2 * x1_2) + (_S1_2_2 * x2_2)
            flat1_2 = s2 + (_S1_3_2 * x3_2)
            flat2_2 = (_S2_2_2 * x2_2) + (_S2_3_2 * x3_2)
            flat3_2 = _S3_3_2 * x3_2
            low = np.asarray(3)
            top = np.asarray(1073741825)
            kept = np.asarray(0)
            tried = np.asarray(4)
            for _ in range(64):
                least_1 = 0.999999999990586 * self._u_min
                most_1 = 0.999999999990586 * self._u_max
                most2_1 = _R(0.499999999995293)
                most3_1 = _R(3.999999999962344)
                least_2 = 0.999999999990586 * self._u_min
                most_2 = 0.999999999990586 * self._u_max
                most2_2 = _R(0.499999999995293)
                most3_2 = _R(3.999999999962344)
                fits = np.asarray(0)
                m_1 = _R(tried)
                power1_1 = m_1 + 2.0
                power2_1 = power1_1 * (m_1 + 1.0)
                power3_1 = power2_1 * m_1
                power4_1 = power3_1 * (m_1 - 1.0)
                power5_1 = power4_1 * (m_1 - 2.0)
                scaled2_1 = flat2_1 * power1_1
                scaled3_1 = flat3_1 * power2_1
                s3 = (10.0 * flat1_1) + (4.0 * scaled2_1) + (0.5 * scaled3_1)
                w1_1 = s3 / power3_1
                w2_1 = ((((-15.0) * flat1_1) - (7.0 * scaled2_1)) - scaled3_1) / power4_1
                s4 = (6.0 * flat1_1) + (3.0 * scaled2_1) + (0.5 * scaled3_1)
                w3_1 = s4 / power5_1
                length_1 = m_1 - 4.0
                b0_c_1 = (((-6.0) * w1_1) - (72.0 * w2_1)) - (360.0 * w3_1)
                b1_c_1 = (((-24.0) * w2_1) - (300.0 * w3_1)) * length_1
                b2_l_1 = length_1 * length_1
                b2_c_1 = (-60.0) * w3_1 * b2_l_1
                b1_1 = b0_c_1 + (0.16666666666666666 * b1_c_1)
                s5 = b0_c_1 + (0.3333333333333333 * b1_c_1)
                b2_1 = s5 + (0.06666666666666667 * b2_c_1)
                b3_1 = b0_c_1 + (0.5 * b1_c_1) + (0.2 * b2_c_1)
                b4_1 = b0_c_1 + (0.6666666666666666 * b1_c_1) + (0.4 * b2_c_1)
                s6 = b0_c_1 + (0.8333333333333334 * b1_c_1)
                b5_1 = s6 + (0.6666666666666666 * b2_c_1)
                b6_1 = b0_c_1 + b1_c_1 + b2_c_1
                s0_c_1 = (((-0.0048) * w1_1) - (0.0168 * w2_1)) - (0.036 * w3_1)
                s1_c_1 = ((((-0.0024) * w1_1) - (0.0146 * w2_1)) - (0.051 * w3_1)) * length_1
                s2_l_1 = length_1 * length_1
                s2_c_1 = ((((-0.0003) * w1_1) - (0.0042 * w2_1)) - (0.0265 * w3_1)) * s2_l_1
                s3_l_1 = s2_l_1 * length_1
                s3_c_1 = (((-0.0004) * w2_1) - (0.006 * w3_1)) * s3_l_1
                s4_l_1 = s3_l_1 * length_1
                s4_c_1 = (-0.0005) * w3_1 * s4_l_1
                s1_1 = s0_c_1 + (0.125 * s1_c_1)
                s2_1 = s0_c_1 + (0.25 * s1_c_1) + (0.03571428571428571 * s2_c_1)
                s7 = s0_c_1 + (0.375 * s1_c_1) + (0.10714285714285714 * s2_c_1)
                s3_1 = s7 + (0.017857142857142856 * s3_c_1)
                s8 = s0_c_1 + (0.5 * s1_c_1) + (0.21428571428571427 * s2_c_1)
                s9 = s8 + (0.07142857142857142 * s3_c_1)
                s4_1 = s9 + (0.014285714285714285 * s4_c_1)
                s10 = s0_c_1 + (0.625 * s1_c_1) + (0.35714285714285715 * s2_c_1)
                s11 = s10 + (0.17857142857142858 * s3_c_1)
                s5_1 = s11 + (0.07142857142857142 * s4_c_1)
                s12 = s0_c_1 + (0.75 * s1_c_1) + (0.5357142857142857 * s2_c_1)
                s13 = s12 + (0.35714285714285715 * s3_c_1)
                s6_1 = s13 + (0.21428571428571427 * s4_c_1)
                s14 = s0_c_1 + (0.875 * s1_c_1) + (0.75 * s2_c_1) + (0.625 * s3_c_1)
                s7_1 = s14 + (0.5 * s4_c_1)
                s8_1 = s0_c_1 + s1_c_1 + s2_c_1 + s3_c_1 + s4_c_1
                v0_c_1 = (0.24 * w1_1) + (1.44 * w2_1) + (4.8 * w3_1)
                v1_c_1 = ((0.06 * w1_1) + (0.84 * w2_1) + (5.2 * w3_1)) * length_1
                v2_l_1 = length_1 * length_1
                v2_c_1 = ((0.12 * w2_1) + (1.8 * w3_1)) * v2_l_1
                v3_l_1 = v2_l_1 * length_1
                v3_c_1 = 0.2 * w3_1 * v3_l_1
                v1_1 = v0_c_1 + (0.14285714285714285 * v1_c_1)
                s15 = v0_c_1 + (0.2857142857142857 * v1_c_1)
                v2_1 = s15 + (0.047619047619047616 * v2_c_1)
                s16 = v0_c_1 + (0.42857142857142855 * v1_c_1)
                s17 = s16 + (0.14285714285714285 * v2_c_1)
                v3_1 = s17 + (0.02857142857142857 * v3_c_1)
                s18 = v0_c_1 + (0.5714285714285714 * v1_c_1)
                s19 = s18 + (0.2857142857142857 * v2_c_1)
                v4_1 = s19 + (0.11428571428571428 * v3_c_1)
                s20 = v0_c_1 + (0.7142857142857143 * v1_c_1)
                s21 = s20 + (0.47619047619047616 * v2_c_1)
                v5_1 = s21 + (0.2857142857142857 * v3_c_1)
                s22 = v0_c_1 + (0.8571428571428571 * v1_c_1)
                s23 = s22 + (0.7142857142857143 * v2_c_1)
                v6_1 = s23 + (0.5714285714285714 * v3_c_1)
                v7_1 = v0_c_1 + v1_c_1 + v2_c_1 + v3_c_1
                end51_1 = (((-6.0) * w1_1) - (48.0 * w2_1)) - (120.0 * w3_1)
                end52_1 = ((-6.0) * w1_1) - (24.0 * w2_1)
                end53_1 = (-6.0) * w1_1
                if (
                    (least_1 <= b0_c_1 <= most_1)
                    and (least_1 <= b1_1 <= most_1)
                    and (least_1 <= b2_1 <= most_1)
                    and (least_1 <= b3_1 <= most_1)
                    and (least_1 <= b4_1 <= most_1)
                    and (least_1 <= b5_1 <= most_1)
                    and (least_1 <= b6_1 <= most_1)
                    and (-most2_1 <= s0_c_1 <= most2_1)
                    and (-most2_1 <= s1_1 <= most2_1)
                    and (-most2_1 <= s2_1 <= most2_1)
                    and (-most2_1 <= s3_1 <= most2_1)
                    and (-most2_1 <= s4_1 <= most2_1)
                    and (-most2_1 <= s5_1 <= most2_1)
                    and (-most2_1 <= s6_1 <= most2_1)
                    and (-most2_1 <= s7_1 <= most2_1)
                    and (-most2_1 <= s8_1 <= most2_1)
                    and (-most3_1 <= v0_c_1 <= most3_1)
                    and (-most3_1 <= v1_1 <= most3_1)
                    and (-most3_1 <= v2_1 <= most3_1)
                    and (-most3_1 <= v3_1 <= most3_1)
                    and (-most3_1 <= v4_1 <= most3_1)
                    and (-most3_1 <= v5_1 <= most3_1)
                    and (-most3_1 <= v6_1 <= most3_1)
                    and (-most3_1 <= v7_1 <= most3_1)
                    and (least_1 <= end51_1 <= most_1)
                    and (least_1 <= end52_1 <= most_1)
                    and (least_1 <= end53_1 <= most_1)
                    and (np.abs((((-0.0027) * w1_1) - (0.006 * w2_1)) - (0.006 * w3_1)) <= most2_1)
                    and (np.abs((((-0.0012) * w1_1) - (0.0011999999999999995 * w2_1)) + (8.131516293641283e-19 * w3_1)) <= most2_1)
                    and (np.abs(((-0.00029999999999999965) * w1_1) + (8.131516293641283e-19 * w2_1) + (8.131516293641283e-19 * w3_1)) <= most2_1)
                    and (np.abs((0.18 * w1_1) + (0.72 * w2_1) + (1.2 * w3_1)) <= most3_1)
                    and (np.abs(((0.11999999999999994 * w1_1) + (0.23999999999999982 * w2_1)) - (2.0816681711721685e-16 * w3_1)) <= most3_1)
                    and (np.abs((0.06000000000000016 * w1_1) + (4.579669976578771e-16 * w2_1) + (6.245004513516506e-16 * w3_1)) <= most3_1)
                ):
                    fits = 1
                if fits == 1:
                    m_2 = _R(tried)
                    power1_2 = m_2 + 3.0
                    power2_2 = power1_2 * (m_2 + 2.0)
                    power3_2 = power2_2 * (m_2 + 1.0)
                    power4_2 = power3_2 * m_2
                    power5_2 = power4_2 * (m_2 - 1.0)
                    power6_2 = power5_2 * (m_2 - 2.0)
                    scaled2_2 = flat2_2 * power1_2
                    scaled3_2 = flat3_2 * power2_2
                    s24 = (15.0 * flat1_2) + (5.0 * scaled2_2) + (0.5 * scaled3_2)
                    w1_2 = s24 / power4_2
                    w2_2 = ((((-24.0) * flat1_2) - (9.0 * scaled2_2)) - scaled3_2) / power5_2
                    s25 = (10.0 * flat1_2) + (4.0 * scaled2_2) + (0.5 * scaled3_2)
                    w3_2 = s25 / power6_2
                    length_2 = m_2 - 4.0
                    b0_c_2 = (((-96.0) * w1_2) - (720.0 * w2_2)) - (2880.0 * w3_2)
                    b1_c_2 = ((((-24.0) * w1_2) - (420.0 * w2_2)) - (3120.0 * w3_2)) * length_2
                    b2_l_2 = length_2 * length_2
                    b2_c_2 = (((-60.0) * w2_2) - (1080.0 * w3_2)) * b2_l_2
                    b3_l_2 = b2_l_2 * length_2
                    b3_c_2 = (-120.0) * w3_2 * b3_l_2
                    b1_2 = b0_c_2 + (0.14285714285714285 * b1_c_2)
                    s26 = b0_c_2 + (0.2857142857142857 * b1_c_2)
                    b2_2 = s26 + (0.047619047619047616 * b2_c_2)
                    s27 = b0_c_2 + (0.42857142857142855 * b1_c_2)
                    s28 = s27 + (0.14285714285714285 * b2_c_2)
                    b3_2 = s28 + (0.02857142857142857 * b3_c_2)
                    s29 = b0_c_2 + (0.5714285714285714 * b1_c_2)
                    s30 = s29 + (0.2857142857142857 * b2_c_2)
                    b4_2 = s30 + (0.11428571428571428 * b3_c_2)
                    s31 = b0_c_2 + (0.7142857142857143 * b1_c_2)
                    s32 = s31 + (0.47619047619047616 * b2_c_2)
                    b5_2 = s32 + (0.2857142857142857 * b3_c_2)
                    s33 = b0_c_2 + (0.8571428571428571 * b1_c_2)
                    s34 = s33 + (0.7142857142857143 * b2_c_2)
                    b6_2 = s34 + (0.5714285714285714 * b3_c_2)
                    b7_2 = b0_c_2 + b1_c_2 + b2_c_2 + b3_c_2
                    s0_c_2 = (((-0.036) * w1_2) - (0.12 * w2_2)) - (0.252 * w3_2)
                    s1_c_2 = ((((-0.0242) * w1_2) - (0.124 * w2_2)) - (0.3954 * w3_2)) * length_2
                    s2_l_2 = length_2 * length_2
                    s2_c_2 = ((((-0.0054) * w1_2) - (0.0475 * w2_2)) - (0.2415 * w3_2)) * s2_l_2
                    s3_l_2 = s2_l_2 * length_2
                    s3_c_2 = ((((-0.0004) * w1_2) - (0.008 * w2_2)) - (0.072 * w3_2)) * s3_l_2
                    s4_l_2 = s3_l_2 * length_2
                    s4_c_2 = (((-0.0005) * w2_2) - (0.0105 * w3_2)) * s4_l_2
                    s5_l_2 = s4_l_2 * length_2
                    s5_c_2 = (-0.0006) * w3_2 * s5_l_2
                    s1_2 = s0_c_2 + (0.1111111111111111 * s1_c_2)
                    s35 = s0_c_2 + (0.2222222222222222 * s1_c_2)
                    s2_2 = s35 + (0.027777777777777776 * s2_c_2)
                    s36 = s0_c_2 + (0.3333333333333333 * s1_c_2)
                    s37 = s36 + (0.08333333333333333 * s2_c_2)
                    s3_2 = s37 + (0.011904761904761904 * s3_c_2)
                    s38 = s0_c_2 + (0.4444444444444444 * s1_c_2)
                    s39 = s38 + (0.16666666666666666 * s2_c_2)
                    s40 = s39 + (0.047619047619047616 * s3_c_2)
                    s4_2 = s40 + (0.007936507936507936 * s4_c_2)
                    s41 = s0_c_2 + (0.5555555555555556 * s1_c_2)
                    s42 = s41 + (0.2777777777777778 * s2_c_2)
                    s43 = s42 + (0.11904761904761904 * s3_c_2)
                    s44 = s43 + (0.03968253968253968 * s4_c_2)
                    s5_2 = s44 + (0.007936507936507936 * s5_c_2)
                    s45 = s0_c_2 + (0.6666666666666666 * s1_c_2)
                    s46 = s45 + (0.4166666666666667 * s2_c_2)
                    s47 = s46 + (0.23809523809523808 * s3_c_2)
                    s48 = s47 + (0.11904761904761904 * s4_c_2)
                    s6_2 = s48 + (0.047619047619047616 * s5_c_2)
                    s49 = s0_c_2 + (0.7777777777777778 * s1_c_2)
                    s50 = s49 + (0.5833333333333334 * s2_c_2)
                    s51 = s50 + (0.4166666666666667 * s3_c_2)
                    s52 = s51 + (0.2777777777777778 * s4_c_2)
                    s7_2 = s52 + (0.16666666666666666 * s5_c_2)
                    s53 = s0_c_2 + (0.8888888888888888 * s1_c_2)
                    s54 = s53 + (0.7777777777777778 * s2_c_2)
                    s55 = s54 + (0.6666666666666666 * s3_c_2)
                    s56 = s55 + (0.5555555555555556 * s4_c_2)
                    s8_2 = s56 + (0.4444444444444444 * s5_c_2)
                    s9_2 = s0_c_2 + s1_c_2 + s2_c_2 + s3_c_2 + s4_c_2 + s5_c_2
                    v0_c_2 = (2.4 * w1_2) + (12.0 * w2_2) + (36.0 * w3_2)
                    v1_c_2 = ((1.08 * w1_2) + (9.4 * w2_2) + (46.2 * w3_2)) * length_2
                    v2_l_2 = length_2 * length_2
                    v2_c_2 = ((0.12 * w1_2) + (2.4 * w2_2) + (21.3 * w3_2)) * v2_l_2
                    v3_l_2 = v2_l_2 * length_2
                    v3_c_2 = ((0.2 * w2_2) + (4.2 * w3_2)) * v3_l_2
                    v4_l_2 = v3_l_2 * length_2
                    v4_c_2 = 0.3 * w3_2 * v4_l_2
                    v1_2 = v0_c_2 + (0.125 * v1_c_2)
                    v2_2 = v0_c_2 + (0.25 * v1_c_2) + (0.03571428571428571 * v2_c_2)
                    s57 = v0_c_2 + (0.375 * v1_c_2) + (0.10714285714285714 * v2_c_2)
                    v3_2 = s57 + (0.017857142857142856 * v3_c_2)
                    s58 = v0_c_2 + (0.5 * v1_c_2) + (0.21428571428571427 * v2_c_2)
                    s59 = s58 + (0.07142857142857142 * v3_c_2)
                    v4_2 = s59 + (0.014285714285714285 * v4_c_2)
                    s60 = v0_c_2 + (0.625 * v1_c_2) + (0.35714285714285715 * v2_c_2)
                    s61 = s60 + (0.17857142857142858 * v3_c_2)
                    v5_2 = s61 + (0.07142857142857142 * v4_c_2)
                    s62 = v0_c_2 + (0.75 * v1_c_2) + (0.5357142857142857 * v2_c_2)
                    s63 = s62 + (0.35714285714285715 * v3_c_2)
                    v6_2 = s63 + (0.21428571428571427 * v4_c_2)
                    s64 = v0_c_2 + (0.875 * v1_c_2) + (0.75 * v2_c_2) + (0.625 * v3_c_2)
                    v7_2 = s64 + (0.5 * v4_c_2)
                    v8_2 = v0_c_2 + v1_c_2 + v2_c_2 + v3_c_2 + v4_c_2
                    end61_2 = (((-72.0) * w1_2) - (360.0 * w2_2)) - (720.0 * w3_2)
                    end62_2 = ((-48.0) * w1_2) - (120.0 * w2_2)
                    end63_2 = (-24.0) * w1_2
                    if (
                        (least_2 <= b0_c_2 <= most_2)
                        and (least_2 <= b1_2 <= most_2)
                        and (least_2 <= b2_2 <= most_2)
                        and (least_2 <= b3_2 <= most_2)
                        and (least_2 <= b4_2 <= most_2)
                        and (least_2 <= b5_2 <= most_2)
                        and (least_2 <= b6_2 <= most_2)
                        and (least_2 <= b7_2 <= most_2)
                        and (-most2_2 <= s0_c_2 <= most2_2)
                        and (-most2_2 <= s1_2 <= most2_2)
                        and (-most2_2 <= s2_2 <= most2_2)
                        and (-most2_2 <= s3_2 <= most2_2)
                        and (-most2_2 <= s4_2 <= most2_2)
                        and (-most2_2 <= s5_2 <= most2_2)
                        and (-most2_2 <= s6_2 <= most2_2)
                        and (-most2_2 <= s7_2 <= most2_2)
                        and (-most2_2 <= s8_2 <= most2_2)
                        and (-most2_2 <= s9_2 <= most2_2)
                        and (-most3_2 <= v0_c_2 <= most3_2)
                        and (-most3_2 <= v1_2 <= most3_2)
                        and (-most3_2 <= v2_2 <= most3_2)
                        and (-most3_2 <= v3_2 <= most3_2)
                        and (-most3_2 <= v4_2 <= most3_2)
                        and (-most3_2 <= v5_2 <= most3_2)
                        and (-most3_2 <= v6_2 <= most3_2)
                        and (-most3_2 <= v7_2 <= most3_2)
                        and (-most3_2 <= v8_2 <= most3_2)
                        and (least_2 <= end61_2 <= most_2)
                        and (least_2 <= end62_2 <= most_2)
                        and (least_2 <= end63_2 <= most_2)
                        and (np.abs((((-0.016800000000000002) * w1_2) - (0.036000000000000004 * w2_2)) - (0.036000000000000004 * w3_2)) <= most2_2)
                        and (np.abs((((-0.005999999999999998) * w1_2) - (0.005999999999999997 * w2_2)) + (4.87890977618477e-18 * w3_2)) <= most2_2)
                        and (np.abs(((-0.0011999999999999977) * w1_2) + (4.87890977618477e-18 * w2_2) + (4.87890977618477e-18 * w3_2)) <= most2_2)
                        and (np.abs((1.44 * w1_2) + (4.8 * w2_2) + (7.2 * w3_2)) <= most3_2)
                        and (np.abs(((0.7199999999999996 * w1_2) + (1.199999999999999 * w2_2)) - (1.2490009027033011e-15 * w3_2)) <= most3_2)
                        and (np.abs((0.2400000000000011 * w1_2) + (2.914335439641036e-15 * w2_2) + (3.747002708109903e-15 * w3_2)) <= most3_2)
                    ):
                        fits = 2
                if fits == 2:
                    kept = tried
                    top = tried
                else:
                    low = tried
                gap = max(top - low, 0)
                if gap < 2:
                    break
                half = gap // 2
                if low < half:
                    tried = low + low
                else:
                    tried = low + half
            if (
                np.isfinite(flat1_1)
                and np.isfinite(flat2_1)
                and np.isfinite(flat3_1)
                and np.isfinite(flat1_2)
                and np.isfinite(flat2_2)
                and np.isfinite(flat3_2)
            ):
                if kept > 0:
                    return int(kept)
                else:
                    raise ValueError("no number of samples was found that keeps the limits")
            else:
                raise ValueError("an argument, or what follows from it, is not finite")

    def deadline(self) -> int:
        """The tick at which the loop is to be at rest."""
        return int((self._start - ((0 - self._last) & _WRAP)) & _WRAP)
