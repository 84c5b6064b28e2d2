"""
Prescribed-time controller duration_latched: order n = 2, mapping custom.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --kappa="dt/(c*tau*(tau - dt)) + dt" --name duration_latched --in-flight --pi0="-6*xi1 - 5*xi2 + xi1_0/8" --param "c=[0.5,2]" --allow=growth
Version 0.1.0, design 618c09f23c7e.

Plant: x1' = x2, x2' = f + u. Time in s, x1 in any unit U, x2 in U/s, u in U/s^2.
Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
      eps, sampling, f and clipping leave. The checks below say what is known of this
      design.
f is not part of the law: cancel its known terms before the call.

SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
      is stable. Simulate the sampled loop: ptc-codegen simulate --sample-time.

Parameters:
  tau: prescribed settling time [s], from 1e-150 to 1e150
  t0: start time [s], finite
  eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
  u_max: bound of |u| [unit of u], > 0, infinity allowed
  c: parameter of kappa, from 0.5 to 2

Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
      the stretched time since t0:
  kappa(dt) = dt/(c*tau*(tau - dt)) + dt
  kappa = (tau + tau^2*c*T - tau*c*T^2 - T)/(tau*c*T)
  r_1 = T*(c*T/(1 + c*T^2))
r_k and BB_n are computed from the Taylor series of mu at each call.

Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
  u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
  pi0 = -6*xi1 - 5*xi2 + xi1_0/8
  xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
  p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i

From t0 + tau - eps on, and after the deadline, T is held at eps in the law (status HOLD).
In flight: arm_for starts again at t0 for another tau, at any time, and computes what
      follows from tau. arm keeps the tau last used: at first that of the parameters.
|u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
      deadline.
Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: the mapping is of its class, proved.
  growth: not checked: the law is not a sum of gains, so its poles are not known.
  sampling: not checked: `sample_time` is not given.
  deadline: not checked: `error` is not given.
  loop: not checked: it needs a linear law.
  envelope: not checked: `x_max` is not given.

Operations of one step, without input checks and clipping: 11 additions or comparisons, 15
      multiplications, 3 divisions.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "DurationLatched", "Params", "Status"]

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
    c: float
    """parameter of kappa, from 0.5 to 2"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

def _states(x: ArrayLike, name: str) -> tuple[Array, ...]:
    """The states along the last axis, one by one."""
    states = np.asarray(x, dtype=_R)
    if states.ndim == 0 or states.shape[-1] != 2:
        raise ValueError(f"{name} has shape {states.shape}; legal: (..., 2), the states along the last axis")
    return tuple(np.moveaxis(states, -1, 0))

class DurationLatched:
    """The controller. Takes the parameters and arms at params.t0 (or the fixed t0) for params.tau, latching the state x0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params, x0: ArrayLike) -> None:
        with np.errstate(all="ignore"):
            given_tau = _R(params.tau)
            given_t0 = _R(params.t0)
            given_eps = _R(params.eps)
            given_u_max = _R(params.u_max)
            given_c = _R(params.c)
            tau = given_tau
            t0 = given_t0
            eps = given_eps
            u_max = given_u_max
            p_c = given_c
            if not (np.isfinite(tau) and (1e-150 <= tau <= 1e150)):
                raise ValueError(f"params.tau is {params.tau}; legal: from 1e-150 to 1e150")
            if not np.isfinite(t0):
                raise ValueError(f"params.t0 is {params.t0}; legal: finite")
            if not (eps >= 1e-150):
                raise ValueError(f"params.eps is {params.eps}; legal: >= 1e-150")
            if not (u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not (0.5 <= p_c <= 2.0):
                raise ValueError(f"params.c is {params.c}; legal: from 0.5 to 2")
            if not (eps < tau):
                raise ValueError(f"params.eps is {params.eps}; legal: < tau")
            hold_from = -eps
            if not np.isfinite(hold_from):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._eps = eps
            self._hold_from = hold_from
            self._p_c = p_c
            self._u_max = u_max
            self._t0 = _R(0.0)
            self._tau = _R(0.0)
            self._deadline = _R(0.0)
            self._correction = _R(0.0)
            self._f44 = _R(0.0)
        self.arm_for(t0, tau, x0)

    def arm(self, t0: float, x0: ArrayLike) -> None:
        """Starts again at t0 [s], with the tau last used, latching the state x0.

        ValueError where an argument or what follows from it is not finite; the controller
        is left as it was.
        """
        with np.errstate(all="ignore"):
            t0 = _R(t0)
            x0 = _numbers(x0, 2, "x0")
            if not (np.isfinite(t0) and np.isfinite(x0[0]) and np.isfinite(x0[1])):
                raise ValueError("t0 and x0, and what follows, must be finite")
            deadline = t0 + self._tau
            v1 = deadline - t0
            correction = (t0 - (deadline - v1)) + (self._tau - v1)
            f44 = x0[0] * 0.125
            if not (np.isfinite(deadline) and np.isfinite(f44)):
                raise ValueError("t0 and x0, and what follows, must be finite")
            self._t0 = t0
            self._deadline = deadline
            self._correction = correction
            self._f44 = f44

    def arm_for(self, t0: float, tau: float, x0: ArrayLike) -> None:
        """Starts again at t0 [s] with another duration tau [s]: the deadline is t0 + tau, latching
        the state x0.

        ValueError where an argument or what follows from it is not finite, or tau is outside its
        domain; the controller is left as it was.
        """
        with np.errstate(all="ignore"):
            t0 = _R(t0)
            tau = _R(tau)
            x0 = _numbers(x0, 2, "x0")
            if not (
                np.isfinite(t0)
                and np.isfinite(x0[0])
                and np.isfinite(x0[1])
                and np.isfinite(tau)
                and (1e-150 <= tau <= 1e150)
                and (tau > self._eps)
            ):
                raise ValueError("t0 and tau and x0, and what follows, must be finite, and tau within its domain")
            deadline = t0 + tau
            v1 = deadline - t0
            correction = (t0 - (deadline - v1)) + (tau - v1)
            f44 = x0[0] * 0.125
            if not (np.isfinite(deadline) and np.isfinite(f44)):
                raise ValueError("t0 and tau and x0, and what follows, must be finite, and tau within its domain")
            self._t0 = t0
            self._tau = tau
            self._deadline = deadline
            self._correction = correction
            self._f44 = f44

    def step(self, t: ArrayLike, x: ArrayLike) -> Control:
        """u at time t [s] and state x = (x1, x1', ...).

        Each argument may be a batch; states stand along the last axis.
        """
        t = np.asarray(t, dtype=_R)
        x1, x2 = _states(x, "x")
        with np.errstate(all="ignore"):
            past = (t - self._deadline) - self._correction
            late = np.where(past < self._hold_from, past, self._hold_from)
            T = -late
            v1 = T * T * self._p_c
            v2 = 1.0 + v1
            unit = (T * self._p_c) / v2
            v3 = T * unit
            inv_r1 = 1.0 / v3
            xi2 = x2 * v3
            law = (((-6.0) * x1) - (5.0 * xi2)) + self._f44
            s1 = (-2.0) * ((((-(v1 * (-2.0) * (1.0 / v2))) - 1.0) - 1.0) * 0.5 * unit)
            v = ((law * inv_r1) + (s1 * x2)) * inv_r1
            way1 = np.isfinite(v) & (np.abs(v) <= self._u_max) & (late < self._hold_from)
            way2 = np.isfinite(t) & np.isfinite(x1) & np.isfinite(x2)
            way3 = np.isfinite(v)
            way4 = v > self._u_max
            way5 = v < -self._u_max
            status = np.where(t >= self._t0, np.where(way1, Status.OK, np.where(way2, np.where(way3, np.where(way4, Status.SATURATED, np.where(way5, Status.SATURATED, Status.HOLD)), Status.RANGE), Status.INPUT)), Status.INPUT)
            return Control(np.where(status < 0, _R(0.0), np.where(way1, v, np.where(way4, self._u_max, np.where(way5, -self._u_max, v)))), status.astype(np.int8))
