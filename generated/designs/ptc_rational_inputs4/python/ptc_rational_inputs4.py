"""
Prescribed-time controller ptc_rational_inputs4: outputs of order 1, 1, 1, 1, mapping rational.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --mu rational --name ptc_rational_inputs4 --states="p, q, r, s" --inputs=a,b,c,d --outputs="p, q, r, s" --dynamics="sin(q)*b + 3*c + r*d, 2*a + p*b + m*d + p*r, r*a + (3 + q^2)*b + s*c, a - p*c + 4*d" --allow=zeros
Version 0.1.0, design d53160516d12.

Plant, with the inputs a, b, c, d: p' = sin(q)*b + 3*c + r*d, q' = 2*a + p*b + m*d + p*r,
      r' = r*a + (3 + q^2)*b + s*c, s' = a - p*c + 4*d, output 1 = p, output 2 = q, output
      3 = r, output 4 = s. Time in s.
Goal: every output with its derivatives is 0 at the deadline t0 + tau from any state at t0,
      up to the error that the hold at eps, sampling, what differs from the model and
      clipping leave. The checks below say what is known of this design.
The law takes the plant to be the model. What differs from it is not part of the law.
Outputs: 4, each with a law of its own, with this deadline and mapping; u_max is of the
      input of this number.

SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
      is stable. Run the emitted step with a model of the plant, sampled.

Parameters:
  tau: prescribed settling time [s], from 1e-150 to 1e150
  t0: start time [s], finite
  eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
  u_max: bound of |u| [unit of u], > 0, infinity allowed
  a: rate of stretched time [1/s], from 1e-150 to 1e150
  k: gains of pi0 = -k_1 xi_1, finite; k[0] is k_1 [1/s]
  m: parameter of the model, finite

Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
      the stretched time since t0:
  mu(t)     = tau*a*t/(1 + a*t)
  kappa(Dt) = Dt/(a*T)
Derivatives r_k = mu^(k)(kappa(Dt)):
  r_k = (-1)^(k-1) k! (a/tau)^k T^(k+1)
  r_1 = tau^-1*a*T^2
Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
  B_{0,0} = 1

Law of each output, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
  v_i = kappa'^n (pi0(xi, t_kappa) - b_n^T x) = sum_j gain_j x_j
  pi0 = -k_1 xi_1
  gain_j = inv_T_squared^(n+1-j) row_j
  K1, K2, ...: K_i = k_i/(tau^-1*a)^(n+1-i)
  row_1 = -K1
  inv_T_squared = 1/T^2
Output 1, of order n = 1:
  x_1 = p
Output 2, of order n = 1:
  x_1 = q
  f_2 = p*r
Output 3, of order n = 1:
  x_1 = r
Output 4, of order n = 1:
  x_1 = s
u of D u = w with w_i = v_i - f_i, by elimination with pivots:
  D = [[0, sin(q), 3, r], [2, p, 0, m], [r, 3 + q^2, s, 0], [1, 0, -p, 4]]

From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
      deadline.
Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
      mathematical library.

Checks of the design (details: ptc-codegen check):
  membership: sound: rational is of class M for all its parameters.
  growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
  sampling: not checked: `sample_time` is not given.
  deadline: not checked: `error` is not given.
  loop: not checked: it needs a value of `tau`.
  envelope: not checked: `x_max` is not given.
  zeros: sound: none: the relative degrees are 1, 1, 1, 1, whose sum is the number of
      states.

Operations of one step, without input checks and clipping: 38 additions or comparisons, 33
      multiplications, 14 divisions, 1 function call.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Axes", "Control", "Params", "PtcRationalInputs4", "Status"]

_R = np.float64
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
    """Result of a step, for each time and state of the batch."""

    u: Array
    """Input of the plant."""
    status: NDArray[np.int8]
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

    tau: float
    """prescribed settling time [s], from 1e-150 to 1e150"""
    t0: float = 0.0
    """start time [s], finite"""
    eps: float
    """time-to-go at which the gains are held [s], >= 1e-150, < tau"""
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""
    a: float
    """rate of stretched time [1/s], from 1e-150 to 1e150"""
    k: Sequence[float]
    """gains of pi0 = -k_1 xi_1, finite; k[0] is k_1 [1/s]"""
    m: float
    """parameter of the model, finite"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

def _states(x: ArrayLike, name: str) -> tuple[Array, ...]:
    """The states along the last axis, one by one."""
    states = np.asarray(x, dtype=_R)
    if states.ndim == 0 or states.shape[-1] != 4:
        raise ValueError(f"{name} has shape {states.shape}; legal: (..., 4), the states along the last axis")
    return tuple(np.moveaxis(states, -1, 0))

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

class PtcRationalInputs4:
    """The controller. Takes the parameters and arms at params.t0 (or the fixed t0).

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_tau = _R(params.tau)
            given_t0 = _R(params.t0)
            given_eps = _R(params.eps)
            given_u_max = _R(params.u_max)
            given_a = _R(params.a)
            given_k = _numbers(params.k, 1, "params.k")
            given_m = _R(params.m)
            tau = given_tau
            t0 = given_t0
            eps = given_eps
            u_max = given_u_max
            a = given_a
            k1 = given_k[0]
            p_m = given_m
            if not (np.isfinite(tau) and (1e-150 <= tau <= 1e150)):
                raise ValueError(f"params.tau is {params.tau}; legal: from 1e-150 to 1e150")
            if not np.isfinite(t0):
                raise ValueError(f"params.t0 is {params.t0}; legal: finite")
            if not (eps >= 1e-150):
                raise ValueError(f"params.eps is {params.eps}; legal: >= 1e-150")
            if not (u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not (np.isfinite(a) and (1e-150 <= a <= 1e150)):
                raise ValueError(f"params.a is {params.a}; legal: from 1e-150 to 1e150")
            if not np.isfinite(k1):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(p_m):
                raise ValueError(f"params.m is {params.m}; legal: finite")
            if not (eps < tau):
                raise ValueError(f"params.eps is {params.eps}; legal: < tau")
            rate_axis1 = a / tau
            K1_axis1 = k1 / rate_axis1
            c1_axis1 = -K1_axis1
            hold_from = -eps
            size_K1_axis1 = _R(1e-200) if np.abs(k1) <= 0.0 else np.abs(K1_axis1)
            size_p_m = _R(1e-200) if np.abs(p_m) <= 0.0 else np.abs(p_m)
            if not (
                (size_K1_axis1 >= 1e-200)
                and (size_p_m >= 1e-200)
                and np.isfinite(c1_axis1)
                and np.isfinite(hold_from)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._tau = tau
            self._c1_axis1 = c1_axis1
            self._eps = eps
            self._hold_from = hold_from
            self._p_m = p_m
            self._u_max = u_max
            self._t0 = _R(0.0)
            self._deadline = _R(0.0)
            self._correction = _R(0.0)
        self.arm(t0)

    def arm(self, t0: float) -> None:
        """Starts again at t0 [s].

        ValueError where an argument or what follows from it is not finite; the controller
        is left as it was.
        """
        with np.errstate(all="ignore"):
            t0 = _R(t0)
            if not np.isfinite(t0):
                raise ValueError("t0, and what follows, must be finite")
            deadline = t0 + self._tau
            v1 = deadline - t0
            correction = (t0 - (deadline - v1)) + (self._tau - v1)
            if not np.isfinite(deadline):
                raise ValueError("t0, and what follows, must be finite")
            self._t0 = t0
            self._deadline = deadline
            self._correction = correction

    def step(self, t: ArrayLike, x: ArrayLike) -> Axes:
        """u = (a, b, c, d) at time t [s] and state x = (p, q, r, s). Where one of them is not
        finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else
        the status is SATURATED where one was clipped.

        Each argument may be a batch; states stand along the last axis.
        """
        t = np.asarray(t, dtype=_R)
        x1, x2, x3, x4 = _states(x, "x")
        with np.errstate(all="ignore"):
            u: list[Array] = [np.asarray(_R(0.0))] * 4
            axes = [np.asarray(Status.OK)] * 4
            past = (t - self._deadline) - self._correction
            late = np.where(past < self._hold_from, past, self._hold_from)
            v1 = late * late
            wanted_axis1 = (self._c1_axis1 * x1) / v1
            drift_axis2 = x1 * x3
            wanted_axis2 = ((self._c1_axis1 * x2) / v1) - drift_axis2
            wanted_axis3 = (self._c1_axis1 * x3) / v1
            wanted_axis4 = (self._c1_axis1 * x4) / v1
            inputs = _eliminate([wanted_axis1, wanted_axis2, wanted_axis3, wanted_axis4], [0.0, np.sin(x2), 3.0, x3, 2.0, x1, 0.0, self._p_m, x3, 3.0 + (x2 * x2), x4, 0.0, 1.0, 0.0, -x1, 4.0])
            control1 = inputs[0]
            control2 = inputs[1]
            control3 = inputs[2]
            control4 = inputs[3]
            status = np.asarray(Status.HOLD)
            chosen = np.asarray(late < self._hold_from)
            if chosen.any():
                status = np.where(chosen, Status.OK, status)
            holds = np.asarray(np.isfinite(control1) & np.isfinite(control2) & np.isfinite(control3) & np.isfinite(control4))
            u[0] = np.where(holds, control1, u[0])
            axes[0] = np.where(holds, status, axes[0])
            u[1] = np.where(holds, control2, u[1])
            axes[1] = np.where(holds, status, axes[1])
            u[2] = np.where(holds, control3, u[2])
            axes[2] = np.where(holds, status, axes[2])
            u[3] = np.where(holds, control4, u[3])
            axes[3] = np.where(holds, status, axes[3])
            holds1 = np.asarray(control1 > self._u_max)
            u[0] = np.where(holds1 & holds, self._u_max, u[0])
            axes[0] = np.where(holds1 & holds, Status.SATURATED, axes[0])
            status = np.where(holds1 & holds, Status.SATURATED, status)
            holds2 = np.asarray(control1 < -self._u_max)
            u[0] = np.where(holds2 & ~holds1 & holds, -self._u_max, u[0])
            axes[0] = np.where(holds2 & ~holds1 & holds, Status.SATURATED, axes[0])
            status = np.where(holds2 & ~holds1 & holds, Status.SATURATED, status)
            holds1 = np.asarray(control2 > self._u_max)
            u[1] = np.where(holds1 & holds, self._u_max, u[1])
            axes[1] = np.where(holds1 & holds, Status.SATURATED, axes[1])
            status = np.where(holds1 & holds, Status.SATURATED, status)
            holds2 = np.asarray(control2 < -self._u_max)
            u[1] = np.where(holds2 & ~holds1 & holds, -self._u_max, u[1])
            axes[1] = np.where(holds2 & ~holds1 & holds, Status.SATURATED, axes[1])
            status = np.where(holds2 & ~holds1 & holds, Status.SATURATED, status)
            holds1 = np.asarray(control3 > self._u_max)
            u[2] = np.where(holds1 & holds, self._u_max, u[2])
            axes[2] = np.where(holds1 & holds, Status.SATURATED, axes[2])
            status = np.where(holds1 & holds, Status.SATURATED, status)
            holds2 = np.asarray(control3 < -self._u_max)
            u[2] = np.where(holds2 & ~holds1 & holds, -self._u_max, u[2])
            axes[2] = np.where(holds2 & ~holds1 & holds, Status.SATURATED, axes[2])
            status = np.where(holds2 & ~holds1 & holds, Status.SATURATED, status)
            holds1 = np.asarray(control4 > self._u_max)
            u[3] = np.where(holds1 & holds, self._u_max, u[3])
            axes[3] = np.where(holds1 & holds, Status.SATURATED, axes[3])
            status = np.where(holds1 & holds, Status.SATURATED, status)
            holds2 = np.asarray(control4 < -self._u_max)
            u[3] = np.where(holds2 & ~holds1 & holds, -self._u_max, u[3])
            axes[3] = np.where(holds2 & ~holds1 & holds, Status.SATURATED, axes[3])
            status = np.where(holds2 & ~holds1 & holds, Status.SATURATED, status)
            u[0] = np.where(~holds, np.asarray(_R(0.0)), u[0])
            chosen = np.where(np.isfinite(control1), status, Status.RANGE)
            axes[0] = np.where(~holds, chosen, axes[0])
            u[1] = np.where(~holds, np.asarray(_R(0.0)), u[1])
            chosen = np.where(np.isfinite(control2), status, Status.RANGE)
            axes[1] = np.where(~holds, chosen, axes[1])
            u[2] = np.where(~holds, np.asarray(_R(0.0)), u[2])
            chosen = np.where(np.isfinite(control3), status, Status.RANGE)
            axes[2] = np.where(~holds, chosen, axes[2])
            u[3] = np.where(~holds, np.asarray(_R(0.0)), u[3])
            chosen = np.where(np.isfinite(control4), status, Status.RANGE)
            axes[3] = np.where(~holds, chosen, axes[3])
            status = np.where(~holds, Status.RANGE, status)
            legal = np.isfinite(t) & (t >= self._t0) & np.isfinite(x1) & np.isfinite(x2) & np.isfinite(x3) & np.isfinite(x4)
            axes = [np.where(legal, each, Status.INPUT) for each in axes]
            status = np.where(legal, status, Status.INPUT)
            every = np.broadcast_arrays(*u, *axes, status)
            given = np.stack(every[:4], axis=-1)
            return Axes(
                np.where((status < 0)[..., np.newaxis], _R(0.0), given),
                np.stack(every[4:-1], axis=-1).astype(np.int8),
                every[-1].astype(np.int8),
            )
