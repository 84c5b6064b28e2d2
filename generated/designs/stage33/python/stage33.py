"""
Prescribed-time controller stage33: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --axes 3 --mu "exp(a=1)" --name stage33 --clock samples --precision f32 --tau=0.3 --eps=0 --limits=1,2,3 --poles="[[-4,-5],[-3+i,-3-i],[-6,-7.5]]" --g="[1/2, 2, -1]" --reference="1/(2 + t^2), size*dt/(3 + dt), t^2/(2 + t^2)" --sample-time=0.01
Version 0.1.0, design 600667a7090c.

Plant: x1' = x2, x2' = g u; u held from sample to sample.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
      the rows are those of Theorem 1 for the mapping exp. From 9 samples to go on these
      are M - 2 and the exponents 3, 4, those of least energy. The gains of 2 samples to go
      stay: they are deadbeat.
With a reference r of each axis, e_i = x_i - r^(i-1) is in place of x_i above, and u = w +
      rho/g of each axis. What r^(n) changes over a sample leaves an error of order
      h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is constant there.
t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
      which u acts:
  of axis 1: r = 1/(2 + t^2), r^(1) = -2*t/(2 + t^2)^2, r^(2) = 2*(4*t^2 - (2 + t^2))/(2 +
      t^2)^3
  of axis 2: r = size*dt/(3 + dt), r^(1) = size*(3 + dt - dt)/(3 + dt)^2, r^(2) =
      2*size*(dt - (3 + dt))/(3 + dt)^3
  of axis 3: r = t^2/(2 + t^2), r^(1) = 2*t*(2 + t^2 - t^2)/(2 + t^2)^2, r^(2) = 2*((2 +
      t^2)^2 + 4*t^4 - 5*(2 + t^2)*t^2)/(2 + t^2)^3
Axes: 3, each a chain of its own with this deadline and mapping. step computes what depends
      on time once.
  axis 1: k = 20, 9; u_max = 1; g = 1/2
  axis 2: k = 10, 6; u_max = 2; g = 2
  axis 3: k = 45, 13.5; u_max = 3; g = -1

Parameters:
  samples = 30 [samples], fixed: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  a = 1 [1/s], fixed: rate of stretched time
  size [as in its expression]: parameter of an expression of the design

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample 30 from any state, but for what r does between samples,
      whatever the poles, and |u| is bounded.
  sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
  deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
  loop: not checked: axis 1: `x0_max` is not given.
  envelope: not checked: it does not examine a clock in samples.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Axes", "Control", "Params", "Stage33", "Status"]

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

    size: float
    """parameter of an expression of the design [as in its expression], finite"""

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

# 1/100, sample period.
_H = _R(_R(0.009999999776482582))
# Weight of x1 in the law.
_W1_1_1 = _R(-_R(400000.0))
# Weight of x2 in the law.
_W1_2_1 = _R(_R(2000.0))
# Weight of x2 in the law.
_W2_2_1 = _R(-_R(1600.0))
# Weight of x1 in the law.
_W1_1_2 = _R(-_R(50000.0))
# Weight of x2 in the law.
_W1_2_2 = _R(_R(250.0))
# Weight of x2 in the law.
_W2_2_2 = _R(-_R(250.0))
# Weight of x1 in the law.
_END1_1_2 = _R(-_R(60000.0))
# Weight of x2 in the law.
_END1_2_2 = _R(_R(300.0))
# Weight of x2 in the law.
_END2_2_2 = _R(-_R(300.0))
# Weight of x1 in the law.
_W1_1_3 = _R(_R(450000.0))
# Weight of x2 in the law.
_W1_2_3 = _R(-_R(2250.0))
# Weight of x2 in the law.
_W2_2_3 = _R(_R(1250.0))
# Weight of x1 in the law.
_END1_1_3 = _R(_R(420000.0))
# Weight of x2 in the law.
_END1_2_3 = _R(-_R(2100.0))
# Weight of x2 in the law.
_END2_2_3 = _R(_R(1200.0))

class Stage33:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_size = _R(params.size)
            if not np.isfinite(given_size):
                raise ValueError(f"params.size is {params.size}; legal: finite")
            p_size = given_size
            c_r10 = _R(2.0) * p_size
            if not np.isfinite(c_r10):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._p_size = p_size
            self._c_r10 = c_r10

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. The time of the reference counts
        from there.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike) -> Axes:
        """u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) of each.
        Where one of them is not finite, every u is 0; else the status is SATURATED where one was
        clipped.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _of_axes(x, 3, 2, "x")
            u = np.zeros(3, dtype=_R)
            axes = np.zeros(3, dtype=np.int8)
            if not (
                np.isfinite(x[..., 0, 0])
                and np.isfinite(x[..., 0, 1])
                and np.isfinite(x[..., 1, 0])
                and np.isfinite(x[..., 1, 1])
                and np.isfinite(x[..., 2, 0])
                and np.isfinite(x[..., 2, 1])
            ):
                return Axes(
                    np.zeros(3, dtype=_R),
                    np.full(3, Status.INPUT, dtype=np.int8),
                    np.asarray(Status.INPUT, dtype=np.int8),
                )
            elapsed = (k - self._start) & _WRAP
            x1_1 = x[..., 0, 0]
            x2_1 = x[..., 0, 1]
            x1_2 = x[..., 1, 0]
            x2_2 = x[..., 1, 1]
            x1_3 = x[..., 2, 0]
            x2_3 = x[..., 2, 1]

            # The tracking error.
            t = _R(elapsed) * _H
            v_r1 = t * t
            v_r2 = _R(2.0) + v_r1
            reference0_1 = _R(1.0) / v_r2
            v_r3 = v_r2 * v_r2
            reference1_1 = ((-_R(2.0)) * t) / v_r3
            v_r4 = t + _R(0.004999999888241291)
            v_r5 = v_r4 * v_r4
            v_r6 = _R(2.0) + v_r5
            v_r7 = v_r6 * v_r6
            v_r8 = v_r6 * v_r7
            rho0_1 = (_R(2.0) * ((_R(4.0) * v_r5) - v_r6)) / v_r8
            v_r9 = _R(3.0) + t
            reference0_2 = (self._p_size * t) / v_r9
            reference1_2 = (self._p_size * (v_r9 - t)) / (v_r9 * v_r9)
            v_r11 = _R(3.0) + v_r4
            rho0_2 = (self._c_r10 * (v_r4 - v_r11)) / (v_r11 * (v_r11 * v_r11))
            reference0_3 = v_r1 / v_r2
            reference1_3 = (_R(2.0) * t * (v_r2 - v_r1)) / v_r3
            rho0_3 = (_R(2.0) * ((v_r7 + (_R(4.0) * (v_r5 * v_r5))) - (_R(5.0) * v_r6 * v_r5))) / v_r8
            e1_1 = x1_1 - reference0_1
            e2_1 = x2_1 - reference1_1
            e1_2 = x1_2 - reference0_2
            e2_2 = x2_2 - reference1_2
            e1_3 = x1_3 - reference0_3
            e2_3 = x2_3 - reference1_3

            # The exact law in samples.
            m0_1 = _R((33 - elapsed) & _WRAP) if elapsed < 28 else _R(5.0)
            z1_1 = (_W1_1_1 * e1_1) + (_W1_2_1 * e2_1)
            z2_1 = _W2_2_1 * e2_1
            law_1 = ((z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - _R(1.0)))) + (_R(2.0) * rho0_1)
            if elapsed < 26:
                # The exact law in samples.
                m0_2 = _R((30 - elapsed) & _WRAP)
                z1_2 = (_W1_1_2 * e1_2) + (_W1_2_2 * e2_2)
                z2_2 = _W2_2_2 * e2_2
                law_2 = ((z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - _R(1.0)))) + (_R(0.5) * rho0_2)
            else:
                # The law of least energy to the end.
                m1_2 = _R((32 - elapsed) & _WRAP) if elapsed < 28 else _R(4.0)
                y1_2 = (_END1_1_2 * e1_2) + (_END1_2_2 * e2_2)
                y2_2 = _END2_2_2 * e2_2
                law_2 = ((y1_2 + (y2_2 * m1_2)) / (m1_2 * (m1_2 - _R(1.0)))) + (_R(0.5) * rho0_2)
            if elapsed < 21:
                # The exact law in samples.
                m0_3 = _R((30 - elapsed) & _WRAP)
                z1_3 = (_W1_1_3 * e1_3) + (_W1_2_3 * e2_3)
                z2_3 = _W2_2_3 * e2_3
                law_3 = ((z1_3 + (z2_3 * m0_3)) / (m0_3 * (m0_3 - _R(1.0)))) - rho0_3
            else:
                # The law of least energy to the end.
                m1_3 = _R((35 - elapsed) & _WRAP) if elapsed < 28 else _R(7.0)
                y1_3 = (_END1_1_3 * e1_3) + (_END1_2_3 * e2_3)
                y2_3 = _END2_2_3 * e2_3
                law_3 = ((y1_3 + (y2_3 * m1_3)) / (m1_3 * (m1_3 - _R(1.0)))) - rho0_3
            if elapsed < 30:
                status = Status.OK
            else:
                status = Status.HOLD
            if np.isfinite(law_1) and np.isfinite(law_2) and np.isfinite(law_3):
                u[0] = law_1
                axes[0] = status
                u[1] = law_2
                axes[1] = status
                u[2] = law_3
                axes[2] = status
                if law_1 > _R(1.0):
                    u[0] = _R(1.0)
                    axes[0] = Status.SATURATED
                    status = Status.SATURATED
                elif law_1 < -_R(1.0):
                    u[0] = -_R(1.0)
                    axes[0] = Status.SATURATED
                    status = Status.SATURATED
                if law_2 > _R(2.0):
                    u[1] = _R(2.0)
                    axes[1] = Status.SATURATED
                    status = Status.SATURATED
                elif law_2 < -_R(2.0):
                    u[1] = -_R(2.0)
                    axes[1] = Status.SATURATED
                    status = Status.SATURATED
                if law_3 > _R(3.0):
                    u[2] = _R(3.0)
                    axes[2] = Status.SATURATED
                    status = Status.SATURATED
                elif law_3 < -_R(3.0):
                    u[2] = -_R(3.0)
                    axes[2] = Status.SATURATED
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
                u[2] = _R(0.0)
                if np.isfinite(law_3):
                    axes[2] = status
                else:
                    axes[2] = Status.RANGE
                status = Status.RANGE
            return Axes(u, axes, np.asarray(status, dtype=np.int8))
