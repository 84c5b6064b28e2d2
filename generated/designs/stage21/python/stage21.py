"""
Prescribed-time controller stage21: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name stage21 --clock samples --eps=0 --g="2" --reference="size*dt^2/(1 + t^2)" --delay=0.25
Version 0.1.0, design 0b4602f00880.

Plant: x1' = x2, ..., x3' = g u; u held from sample to sample, 0.25 samples late.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
      the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
      over.
With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
      where the inputs under way count less the rho of their own samples. At sample N e is
      0 where r^(n) is constant over each sample; else an error of order h^(5-i) is left in
      e_i.
t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
      which u acts:
  e_i = x_i - r^(i-1), with the reference r = size*dt^2/(1 + t^2)
  r^(1) = 2*size*dt*(1 + t^2 - dt*t)/(1 + t^2)^2
  r^(2) = 2*size*((1 + t^2)^2 + 4*dt^2*t^2 - 4*(1 + t^2)*dt*t - (1 + t^2)*dt^2)/(1 + t^2)^3
  r^(3) = 12*size*(4*(1 + t^2)*dt*t^2 + 2*(1 + t^2)*dt^2*t - (1 + t^2)^2*dt - (1 + t^2)^2*t
      - 4*dt^2*t^3)/(1 + t^2)^4

Parameters:
  samples [samples]: samples N from the start to rest
  h [s]: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
  k_2 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
  k_3 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
  k_4 [1/s]: gains k_i of pi0 = -sum k_i xi_i
  deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
  size [as in its expression]: parameter of an expression of the design

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
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

__all__ = ["Control", "Params", "Stage21", "Status"]

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

@dataclass(frozen=True, kw_only=True)
class Params:
    """Run-time parameters."""

    samples: int
    """samples N from the start to rest [samples], at least 4"""
    h: float
    """sample period [s], from 1e-150 to 1e150"""
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""
    k: Sequence[float]
    """gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite"""
    deadbeat: float
    """samples to go at which deadbeat takes over, 0 for a safe default [samples], finite"""
    size: float
    """parameter of an expression of the design [as in its expression], finite"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# -67/128, weight of u1 in the law.
_B_4 = _R(-0.5234375)

class Stage21:
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
            given_k = _numbers(params.k, 4, "params.k")
            given_deadbeat = _R(params.deadbeat)
            given_size = _R(params.size)
            if not (given_samples > 3):
                raise ValueError(f"params.samples is {params.samples}; legal: >= 4")
            if not (1e-150 <= given_h <= 1e150):
                raise ValueError(f"params.h is {params.h}; legal: from 1e-150 to 1e150")
            if not (given_u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not np.isfinite(given_k[0]):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(given_k[1]):
                raise ValueError(f"params.k[1] is {params.k[1]}; legal: finite")
            if not np.isfinite(given_k[2]):
                raise ValueError(f"params.k[2] is {params.k[2]}; legal: finite")
            if not np.isfinite(given_k[3]):
                raise ValueError(f"params.k[3] is {params.k[3]}; legal: finite")
            if not (np.isfinite(given_deadbeat) and (given_deadbeat >= 0.0)):
                raise ValueError(f"params.deadbeat is {params.deadbeat}; legal: >= 0")
            if not np.isfinite(given_size):
                raise ValueError(f"params.size is {params.size}; legal: finite")
            samples = given_samples
            h = given_h
            p_size = given_size
            c_r3 = 2.0 * p_size
            c_r5 = 12.0 * p_size
            c_r6 = 0.75 * h
            c_r12 = (-0.25) * h
            s1 = (given_k[3] - 9.0) + 4.0
            s2 = max(s1, _R(8.0))
            deadbeat = given_deadbeat if given_deadbeat > 0.0 else s2
            s3 = 1.0 / (given_h * given_h * given_h)
            w1_1 = 0.5 * (-given_k[0]) * s3
            w1_2 = (-0.875) * (-given_k[0]) * (1.0 / (given_h * given_h))
            w1_3 = 0.6822916666666666 * (-given_k[0]) * (1.0 / given_h)
            w1_4 = (-0.6015625) * (-given_k[0])
            s4 = 0.5 * (((1.0 - given_k[1]) + given_k[2]) - given_k[3])
            w2_2 = s4 * (1.0 / (given_h * given_h))
            s5 = (-0.625) * (((1.0 - given_k[1]) + given_k[2]) - given_k[3])
            w2_3 = s5 * (1.0 / given_h)
            w2_4 = 0.65625 * (((1.0 - given_k[1]) + given_k[2]) - given_k[3])
            s6 = 0.5 * (((-7.0) - given_k[2]) + (3.0 * given_k[3]))
            w3_3 = s6 * (1.0 / given_h)
            w3_4 = (-0.75) * (((-7.0) - given_k[2]) + (3.0 * given_k[3]))
            w4_4 = 6.0 - given_k[3]
            b_1 = (-0.5) * (1.0 / (given_h * given_h * given_h))
            b_2 = (-1.125) * (1.0 / (given_h * given_h))
            b_3 = (-1.1822916666666667) * (1.0 / given_h)
            u_max = given_u_max
            if not (
                np.isfinite(c_r3)
                and np.isfinite(c_r5)
                and np.isfinite(c_r6)
                and np.isfinite(c_r12)
                and np.isfinite(deadbeat)
                and np.isfinite(w1_1)
                and np.isfinite(w1_2)
                and np.isfinite(w1_3)
                and np.isfinite(w1_4)
                and np.isfinite(w2_2)
                and np.isfinite(w2_3)
                and np.isfinite(w2_4)
                and np.isfinite(w3_3)
                and np.isfinite(w3_4)
                and np.isfinite(w4_4)
                and np.isfinite(b_1)
                and np.isfinite(b_2)
                and np.isfinite(b_3)
                and (given_h * given_h * given_h >= 1e-200)
                and (1.0 / (given_h * given_h * given_h) >= 1e-200)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._samples = samples
            self._u1 = _R(0.0)
            self._h = h
            self._p_size = p_size
            self._c_r3 = c_r3
            self._c_r5 = c_r5
            self._c_r6 = c_r6
            self._c_r12 = c_r12
            self._deadbeat = deadbeat
            self._w1_1 = w1_1
            self._w1_2 = w1_2
            self._w1_3 = w1_3
            self._w1_4 = w1_4
            self._w2_2 = w2_2
            self._w2_3 = w2_3
            self._w2_4 = w2_4
            self._w3_3 = w3_3
            self._w3_4 = w3_4
            self._w4_4 = w4_4
            self._b_1 = b_1
            self._b_2 = b_2
            self._b_3 = b_3
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. The time of the reference counts
        from there. Estimates and inputs under way are kept.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for each
        tick.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 3, "x")
            if not (np.isfinite(x[0]) and np.isfinite(x[1]) and np.isfinite(x[2])):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP
            x1 = x[0]
            x2 = x[1]
            x3 = x[2]

            # The tracking error.
            t = _R(elapsed) * self._h
            v_r1 = t * t
            v_r2 = 1.0 + v_r1
            reference0 = (self._p_size * v_r1) / v_r2
            v_r4 = v_r2 * v_r2
            reference1 = (self._c_r3 * t * (v_r2 - v_r1)) / v_r4
            s1 = ((v_r4 + (4.0 * v_r1 * v_r1)) - (4.0 * v_r2 * t * t)) - (v_r2 * v_r1)
            reference2 = (self._c_r3 * s1) / (v_r2 * v_r4)
            v_r7 = t + self._c_r6
            v_r8 = v_r7 * v_r7
            v_r9 = 1.0 + v_r8
            v_r10 = v_r9 * v_r9
            v_r11 = v_r10 * v_r7
            s2 = ((4.0 * v_r9 * v_r7 * v_r8) + (2.0 * v_r9 * v_r8 * v_r7)) - v_r11
            s3 = self._c_r5 * ((s2 - v_r11) - (4.0 * v_r8 * (v_r7 * v_r8)))
            rho0 = s3 / (v_r10 * v_r10)
            v_r13 = t + self._c_r12
            v_r14 = max(v_r13, _R(0.0))
            v_r15 = v_r14 * v_r14
            v_r16 = 1.0 + v_r15
            v_r17 = v_r16 * v_r16
            v_r18 = v_r17 * v_r14
            s4 = (4.0 * v_r16 * v_r14 * v_r15) + (2.0 * v_r16 * v_r15 * v_r14)
            s5 = ((s4 - v_r18) - v_r18) - (4.0 * v_r15 * (v_r14 * v_r15))
            rho1 = (self._c_r5 * s5) / (v_r17 * v_r17)
            e1 = x1 - reference0
            e2 = x2 - reference1
            e3 = x3 - reference2
            left = max(self._samples - elapsed, 0)
            m0 = _R(left)
            if m0 > self._deadbeat:
                # The exact law in samples.
                s6 = (self._w1_1 * e1) + (self._w1_2 * e2) + (self._w1_3 * e3)
                z1 = s6 + (self._w1_4 * (self._u1 - (0.5 * rho1)))
                s7 = self._w2_4 * (self._u1 - (0.5 * rho1))
                z2 = (self._w2_2 * e2) + (self._w2_3 * e3) + s7
                z3 = (self._w3_3 * e3) + (self._w3_4 * (self._u1 - (0.5 * rho1)))
                z4 = self._w4_4 * (self._u1 - (0.5 * rho1))
                m0f2 = m0 * (m0 - 1.0)
                m0f3 = m0f2 * (m0 - 2.0)
                s8 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0))
                v = s8 + (self._u1 - (0.5 * rho1)) + (0.5 * rho0)
            else:
                # Deadbeat.
                s9 = (self._b_1 * e1) + (self._b_2 * e2) + (self._b_3 * e3)
                v = s9 + (_B_4 * (self._u1 - (0.5 * rho1))) + (0.5 * rho0)
            if not np.isfinite(v):
                return Control(_R(0.0), Status.RANGE)
            if v > self._u_max:
                u_now = self._u_max
            elif v < -self._u_max:
                u_now = -self._u_max
            else:
                u_now = v
            self._u1 = u_now
            if (v > self._u_max) or (v < -self._u_max):
                return Control(u_now, Status.SATURATED)
            elif elapsed < self._samples:
                return Control(u_now, Status.OK)
            else:
                return Control(u_now, Status.HOLD)
