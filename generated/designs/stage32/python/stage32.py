"""
Prescribed-time controller stage32: outputs of order 2, 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --mu exp --name stage32 --clock samples --tau=0.3 --eps=0.04 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[m + q2^2, q2], [q2, 1]]" --bias="m*q2*w1*w2, w1^2/2 - q1" --reference="size*dt^2/(1 + t^2), 0" --sample-time=0.01
Version 0.1.0, design 241446d65458.

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
With a reference r of each output, e_i = x_i - r^(i-1) is in place of x_i above, and law_i
      = v_i + rho of output i is in place of v_i. What r^(n) changes over a sample leaves
      an error of order h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is
      constant there.
t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
      which u acts:
  of output 1: r = size*dt^2/(1 + t^2), r^(1) = 2*size*dt*(1 + t^2 - dt*t)/(1 + t^2)^2,
      r^(2) = 2*size*((1 + t^2)^2 + 4*dt^2*t^2 - 4*(1 + t^2)*dt*t - (1 + t^2)*dt^2)/(1 +
      t^2)^3
  of output 2: r = 0, r^(1) = 0, r^(2) = 0
Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
      input of this number.

Parameters:
  samples = 30 [samples], fixed: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
  eps = 0.04 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a [1/s]: rate of stretched time
  k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
  k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
  deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
  m [as in its expression]: parameter of an expression of the design
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
  growth: sound: output 1: near rest at sample 30, not at rest: the gains are held from 4
      samples to go, and |u| is bounded; so does what f + g u and r do between samples.
  sampling: not checked: `loop` bounds what the period leaves of a plant with several
      inputs.
  deadline: not checked: `loop` bounds what the period leaves of a plant with several
      inputs.
  loop: not checked: `a` is left to run time.
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

__all__ = ["Axes", "Control", "Params", "Stage32", "Status"]

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
    """bound of |u| [unit of u], > 0, infinity allowed"""
    a: float
    """rate of stretched time [1/s], from 1e-150 to 1e150"""
    k: Sequence[float]
    """gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite"""
    deadbeat: float
    """samples to go at which deadbeat takes over, 0 for a safe default [samples], finite"""
    m: float
    """parameter of an expression of the design [as in its expression], finite"""
    size: float
    """parameter of an expression of the design [as in its expression], finite"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# 1/100, sample period.
_H = _R(0.01)
# Samples from the start to rest.
_SAMPLES = 30
# Samples to go at which the gains are held.
_HOLD = _R(4.0)

class Stage32:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_u_max = _R(params.u_max)
            given_a = _R(params.a)
            given_k = _numbers(params.k, 2, "params.k")
            given_deadbeat = _R(params.deadbeat)
            given_m = _R(params.m)
            given_size = _R(params.size)
            if not (given_u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not (1e-150 <= given_a <= 1e150):
                raise ValueError(f"params.a is {params.a}; legal: from 1e-150 to 1e150")
            if not np.isfinite(given_k[0]):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(given_k[1]):
                raise ValueError(f"params.k[1] is {params.k[1]}; legal: finite")
            if not (np.isfinite(given_deadbeat) and (given_deadbeat >= 0.0)):
                raise ValueError(f"params.deadbeat is {params.deadbeat}; legal: >= 0")
            if not np.isfinite(given_m):
                raise ValueError(f"params.m is {params.m}; legal: finite")
            if not np.isfinite(given_size):
                raise ValueError(f"params.size is {params.size}; legal: finite")
            p_size = given_size
            c_r3 = 2.0 * p_size
            w1_1_1 = 10000.0 * (-(given_k[0] / (given_a * given_a)))
            w1_2_1 = 100.0 * ((-0.5) * (-(given_k[0] / (given_a * given_a))))
            w2_2_1 = 100.0 * (1.0 - (given_k[1] / given_a))
            p_m = given_m
            u_max = given_u_max
            if not (
                np.isfinite(c_r3)
                and np.isfinite(w1_1_1)
                and np.isfinite(w1_2_1)
                and np.isfinite(w2_2_1)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._start = 0
            self._p_size = p_size
            self._c_r3 = c_r3
            self._w1_1_1 = w1_1_1
            self._w1_2_1 = w1_2_1
            self._w2_2_1 = w2_2_1
            self._p_m = p_m
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. The time of the reference counts
        from there.

        On a negative status u is 0 and nothing has changed.
        """
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
            if not (
                np.isfinite(x[0])
                and np.isfinite(x[1])
                and np.isfinite(x[2])
                and np.isfinite(x[3])
            ):
                return Axes(
                    np.zeros(2, dtype=_R),
                    np.full(2, Status.INPUT, dtype=np.int8),
                    np.asarray(Status.INPUT, dtype=np.int8),
                )
            elapsed = (k - self._start) & _WRAP

            # The chain of each output.
            x1_1 = x[0]
            x2_1 = x[2]
            x1_2 = x[1]
            x2_2 = x[3]

            # The tracking error.
            t = _R(elapsed) * _H
            v_r1 = t * t
            v_r2 = 1.0 + v_r1
            reference0_1 = (self._p_size * v_r1) / v_r2
            reference1_1 = (self._c_r3 * t * (v_r2 - v_r1)) / (v_r2 * v_r2)
            v_r4 = t + 0.005
            v_r5 = v_r4 * v_r4
            v_r6 = 1.0 + v_r5
            v_r7 = v_r6 * v_r6
            s1 = (v_r7 + (4.0 * v_r5 * v_r5)) - (4.0 * v_r6 * v_r4 * v_r4)
            rho0_1 = (self._c_r3 * (s1 - (v_r6 * v_r5))) / (v_r6 * v_r7)
            e1_1 = x1_1 - reference0_1
            e2_1 = x2_1 - reference1_1
            e1_2 = x1_2
            e2_2 = x2_2
            left = max(_SAMPLES - elapsed, 0)
            m0_1 = max(_R(left), _HOLD)

            # The exact law in samples.
            z1_1 = (self._w1_1_1 * e1_1) + (self._w1_2_1 * e2_1)
            z2_1 = self._w2_2_1 * e2_1
            law_1 = ((z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0))) + rho0_1
            m0_2 = max(_R(left), _HOLD)
            z1_2 = (self._w1_1_1 * e1_2) + (self._w1_2_1 * e2_2)
            z2_2 = self._w2_2_1 * e2_2
            law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0))

            # The inputs that give all of them.
            s2 = ((self._p_m + (x1_2 * x1_2)) * law_1) + (x1_2 * law_2)
            control1 = s2 + (self._p_m * x1_2 * x2_1 * x2_2)
            control2 = (x1_2 * law_1) + law_2 + ((x2_1 * x2_1 * 0.5) - x1_1)
            if _R(left) > _HOLD:
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
