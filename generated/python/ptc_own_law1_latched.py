"""
Prescribed-time controller ptc_own_law1_latched: order n = 1, mapping exp.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 1 --mu "exp(a=1)" --name ptc_own_law1_latched --pi0="-2*xi1 - xi1*xi1_0"
Version 0.1.0, design fef8ca24aec8.

Plant: x1' = f + u. Time in s, x1 in any unit U, u in U/s.
Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
      eps, sampling, f and clipping leave. The checks below say what is known of this
      design.
f is not part of the law: cancel its known terms before the call.

SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
      is stable. Simulate the sampled loop: ptc-codegen simulate --sample-time.

Parameters:
  a = 1 [1/s], fixed: rate of stretched time
  tau: prescribed settling time [s], from 1e-150 to 1e150
  t0: start time [s], finite
  eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
  u_max: bound of |u| [unit of u], > 0, infinity allowed

Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
      the stretched time since t0:
  mu(t)     = tau*(1 - exp(-a*t))
  kappa(Dt) = -ln(T/tau)/a
Derivatives r_k = mu^(k)(kappa(Dt)):
  r_k = (-1)^(k-1) a^k T
  r_1 = a*T
Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
  B_{0,0} = 1

Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
  u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
  pi0 = -2*xi1 - xi1*xi1_0
  xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
  p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i

From t0 + tau - eps on, and after the deadline, T is held at eps in the law (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
      deadline.
Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: not checked: the law is not a sum of gains, so its poles are not known.
  sampling: not checked: `sample_time` is not given.
  deadline: not checked: `error` is not given.
  loop: not checked: it needs a linear law.
  envelope: not checked: `x_max` is not given.

Operations of one step, without input checks and clipping: 5 additions or comparisons, 3
      multiplications, 1 division.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Params", "PtcOwnLaw1Latched", "Status"]

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

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

def _states(x: ArrayLike, name: str) -> tuple[Array, ...]:
    """The states along the last axis, one by one."""
    states = np.asarray(x, dtype=_R)
    if states.ndim == 0 or states.shape[-1] != 1:
        raise ValueError(f"{name} has shape {states.shape}; legal: (..., 1), the states along the last axis")
    return tuple(np.moveaxis(states, -1, 0))

class PtcOwnLaw1Latched:
    """The controller. Takes the parameters and arms at params.t0 (or the fixed t0), latching the state x0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params, x0: ArrayLike) -> None:
        with np.errstate(all="ignore"):
            given_tau = _R(params.tau)
            given_t0 = _R(params.t0)
            given_eps = _R(params.eps)
            given_u_max = _R(params.u_max)
            tau = given_tau
            t0 = given_t0
            eps = given_eps
            u_max = given_u_max
            if not (np.isfinite(tau) and (1e-150 <= tau <= 1e150)):
                raise ValueError(f"params.tau is {params.tau}; legal: from 1e-150 to 1e150")
            if not np.isfinite(t0):
                raise ValueError(f"params.t0 is {params.t0}; legal: finite")
            if not (eps >= 1e-150):
                raise ValueError(f"params.eps is {params.eps}; legal: >= 1e-150")
            if not (u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not (eps < tau):
                raise ValueError(f"params.eps is {params.eps}; legal: < tau")
            hold_from = -eps
            if not np.isfinite(hold_from):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._tau = tau
            self._eps = eps
            self._hold_from = hold_from
            self._u_max = u_max
            self._t0 = _R(0.0)
            self._deadline = _R(0.0)
            self._correction = _R(0.0)
            self._x1_0 = _R(0.0)
        self.arm(t0, x0)

    def arm(self, t0: float, x0: ArrayLike) -> None:
        """Starts again at t0 [s], latching the state x0.

        ValueError where an argument or what follows from it is not finite; the controller
        is left as it was.
        """
        with np.errstate(all="ignore"):
            t0 = _R(t0)
            x0 = _numbers(x0, 1, "x0")
            if not (np.isfinite(t0) and np.isfinite(x0[0])):
                raise ValueError("t0 and x0, and what follows, must be finite")
            deadline = t0 + self._tau
            v1 = deadline - t0
            correction = (t0 - (deadline - v1)) + (self._tau - v1)
            if not np.isfinite(deadline):
                raise ValueError("t0 and x0, and what follows, must be finite")
            self._t0 = t0
            self._deadline = deadline
            self._correction = correction
            self._x1_0 = x0[0]

    def step(self, t: ArrayLike, x: ArrayLike) -> Control:
        """u at time t [s] and state x = (x1, x1', ...).

        Each argument may be a batch; states stand along the last axis.
        """
        t = np.asarray(t, dtype=_R)
        x1, = _states(x, "x")
        with np.errstate(all="ignore"):
            past = (t - self._deadline) - self._correction
            late = np.where(past < self._hold_from, past, self._hold_from)
            T = -late
            inv_r1 = 1.0 / T
            law = ((-2.0) * x1) - (x1 * self._x1_0)
            v = law * inv_r1
            way1 = np.isfinite(v) & (np.abs(v) <= self._u_max) & (late < self._hold_from)
            way2 = np.isfinite(t) & np.isfinite(x1)
            way3 = np.isfinite(v)
            way4 = v > self._u_max
            way5 = v < -self._u_max
            status = np.where(t >= self._t0, np.where(way1, Status.OK, np.where(way2, np.where(way3, np.where(way4, Status.SATURATED, np.where(way5, Status.SATURATED, Status.HOLD)), Status.RANGE), Status.INPUT)), Status.INPUT)
            return Control(np.where(status < 0, _R(0.0), np.where(way1, v, np.where(way4, self._u_max, np.where(way5, -self._u_max, v)))), status.astype(np.int8))
