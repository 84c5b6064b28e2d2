"""
Prescribed-time controller stage24: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name stage24 --clock samples --A="[[-1,1],[3,-2]]" --B="[1,2]" --output="[-2,1]" --precision f32 --tau=0.3 --eps=0 --poles=-4,-5 --reference="size*dt^2/(1 + t^2)" --sample-time=0.01
Version 0.1.0, design 50bc8ccf34e5.

Plant: x' = A x + B u of --A and --B above; u held from sample to sample.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M - 3 samples to go and z = S x, the differences of a flat output, u = sum of
      row_j z_j/((M-j+1)...(M-1)) less the drift of z; the rows are those of Theorem 1 for
      the mapping exp. The gains of 2 samples to go stay: they are deadbeat.
With the reference r = size*dt^2/(1 + t^2), x - x_r is in place of x above, and u = w +
      u_r: with them the output y = -2*x1 + x2 is r, and stays so. At sample N x = x_r
      where u_r is constant over each sample; else an error of order h^(4-i) is left in
      y^(i-1).
t counts from the tick at which it was armed, and u_r is that in the middle of the time in
      which u acts. To four digits:
  r^(1) = 2*size*dt*(1 + t^2 - dt*t)/(1 + t^2)^2
  r^(2) = 2*size*((1 + t^2)^2 + 4*dt^2*t^2 - 4*(1 + t^2)*dt*t - (1 + t^2)*dt^2)/(1 + t^2)^3
  x_r1 = -1.333*r - 0.3333*r^(1)
  x_r2 = -1.667*r - 0.6667*r^(1)
  u_r = 0.3333*r - r^(1) - 0.3333*r^(2)

Parameters:
  samples = 30 [samples], fixed: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 20 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_2 = 9 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
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
  loop: not checked: `size` is left to run time.
  envelope: not checked: it does not examine a clock in samples.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Params", "Stage24", "Status"]

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

    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""
    size: float
    """parameter of an expression of the design [as in its expression], finite"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# 1/100, sample period.
_H = _R(_R(0.009999999776482582))
# Weight of x1 in the law.
_W1_1 = _R(-_R(137042.421875))
# Weight of x2 in the law.
_W1_2 = _R(_R(69031.28125))
# Weight of x1 in the law.
_W2_1 = _R(_R(1353.4107666015625))
# Weight of x2 in the law.
_W2_2 = _R(-_R(1082.7286376953125))
# Weight of x1 in the law.
_C_1 = _R(-_R(5.658291816711426))
# Weight of x2 in the law.
_C_2 = _R(_R(4.326633453369141))
# Weight of x1 in the law.
_B_1 = _R(-_R(6519.4267578125))
# Weight of x2 in the law.
_B_2 = _R(_R(3185.20849609375))
# Samples from the start to rest.
_SAMPLES = 30

class Stage24:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_u_max = _R(params.u_max)
            given_size = _R(params.size)
            if not (given_u_max > _R(0.0)):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not np.isfinite(given_size):
                raise ValueError(f"params.size is {params.size}; legal: finite")
            p_size = given_size
            c_r4 = _R(2.0) * p_size
            u_max = given_u_max
            if not np.isfinite(c_r4):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._p_size = p_size
            self._c_r4 = c_r4
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. The time of the reference counts
        from there.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and the state x.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 2, "x")
            if not (np.isfinite(x[0]) and np.isfinite(x[1])):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP
            x1 = x[0]
            x2 = x[1]

            # The tracking error.
            t = _R(elapsed) * _H
            v_r1 = t * t
            v_r2 = _R(1.0) + v_r1
            v_r3 = (self._p_size * v_r1) / v_r2
            v_r5 = (self._c_r4 * t * (v_r2 - v_r1)) / (v_r2 * v_r2)
            x_r1 = ((-_R(1.3333333730697632)) * v_r3) + ((-_R(0.3333333432674408)) * v_r5)
            x_r2 = ((-_R(1.6666666269302368)) * v_r3) + ((-_R(0.6666666865348816)) * v_r5)
            v_r6 = t + _R(0.004999999888241291)
            v_r7 = v_r6 * v_r6
            v_r8 = _R(1.0) + v_r7
            v_r9 = v_r8 * v_r8
            s1 = (self._c_r4 * v_r6 * (v_r8 - v_r7)) / v_r9
            s2 = (v_r9 + (_R(4.0) * v_r7 * v_r7)) - (_R(4.0) * v_r8 * v_r6 * v_r6)
            s3 = (-_R(0.3333333432674408)) * ((self._c_r4 * (s2 - (v_r8 * v_r7))) / (v_r8 * v_r9))
            u_r0 = ((_R(0.3333333432674408) * ((self._p_size * v_r7) / v_r8)) - s1) + s3
            e1 = x1 - x_r1
            e2 = x2 - x_r2
            if elapsed < 28:
                # The exact law in samples.
                m0 = _R((33 - elapsed) & _WRAP)
                z1 = (_W1_1 * e1) + (_W1_2 * e2)
                z2 = (_W2_1 * e1) + (_W2_2 * e2)
                s4 = (_C_1 * e1) + (_C_2 * e2)
                v = ((z1 + (z2 * m0)) / (m0 * (m0 - _R(1.0)))) + s4 + u_r0
            else:
                # Deadbeat.
                v = (_B_1 * e1) + (_B_2 * e2) + u_r0
            if np.isfinite(v):
                if v > self._u_max:
                    return Control(self._u_max, Status.SATURATED)
                elif v < -self._u_max:
                    return Control(-self._u_max, Status.SATURATED)
                elif elapsed < _SAMPLES:
                    return Control(v, Status.OK)
                else:
                    return Control(v, Status.HOLD)
            else:
                return Control(_R(0.0), Status.RANGE)
