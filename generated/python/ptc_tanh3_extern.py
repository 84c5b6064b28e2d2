"""
Prescribed-time controller ptc_tanh3_extern: order n = 3, mapping tanh.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu tanh --name ptc_tanh3_extern --pi0 extern --after extern
Version 0.1.0, design 04514e738293.

Plant: x1' = x2, ..., x3' = f + u. Time in s, x1 in any unit U, x2 in U/s, x3 in U/s^2, u
      in U/s^3.
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
  a: rate of stretched time [1/s], from 1e-150 to 1e150

Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
      the stretched time since t0:
  mu(t)     = tau*tanh(a*t)
  kappa(Dt) = -ln(E)/(2*a), E = T/(2*tau - T)
  in terms of T = time-to-go, E = exp(-2*a*t) = T/(2*tau - T), L = 1/(1 + E)
Derivatives r_k = mu^(k)(kappa(Dt)):
  r_k = 2*tau*(-2*a)^k Li_{-k}(-E)
  r_1 = 2*a*T*L
  r_2 = 4*a^2*T*E*L^2 - 4*a^2*T*L^2
  r_3 = -32*a^3*T*E*L^3 + 8*a^3*T*E^2*L^3 + 8*a^3*T*L^3
Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
  B_{0,0} = 1
  B_{1,1} = 2*a*T*L
  B_{2,1} = 4*a^2*T*E*L^2 - 4*a^2*T*L^2
  B_{2,2} = 4*a^2*T^2*L^2
  B_{3,1} = -32*a^3*T*E*L^3 + 8*a^3*T*E^2*L^3 + 8*a^3*T*L^3
  B_{3,2} = 24*a^3*T^2*E*L^3 - 24*a^3*T^2*L^3

Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
  u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
  pi0 = a user-defined function of xi and t_kappa
  xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
  p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i

From t0 + tau - eps on, T is held at eps in the law (status HOLD). From t0 + tau on, u is
      the result of the user-defined function after (status AFTER).
|u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
      deadline.
Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
      mathematical library.

Checks of the design (details: ptc-codegen check):
  membership: sound: tanh is of class M for all its parameters.
  growth: not checked: the law is not a sum of gains, so its poles are not known.
  sampling: not checked: `sample_time` is not given.
  deadline: not checked: `error` is not given.
  loop: not checked: it needs a linear law.
  envelope: not checked: `x_max` is not given.

Operations of one step, without input checks and clipping: 16 additions or comparisons, 24
      multiplications, 4 divisions, 2 function calls.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Params", "PtcTanh3Extern", "Status"]

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
    a: float
    """rate of stretched time [1/s], from 1e-150 to 1e150"""

def _states(x: ArrayLike, name: str) -> tuple[Array, ...]:
    """The states along the last axis, one by one."""
    states = np.asarray(x, dtype=_R)
    if states.ndim == 0 or states.shape[-1] != 3:
        raise ValueError(f"{name} has shape {states.shape}; legal: (..., 3), the states along the last axis")
    return tuple(np.moveaxis(states, -1, 0))

class PtcTanh3Extern:
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
            tau = given_tau
            t0 = given_t0
            eps = given_eps
            u_max = given_u_max
            a = given_a
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
            if not (eps < tau):
                raise ValueError(f"params.eps is {params.eps}; legal: < tau")
            hold_from = -eps
            f16 = 2.0 * tau
            f22 = 2.0 * a
            f24 = f16 * a
            f29 = 1.0 / tau
            if not (
                np.isfinite(hold_from)
                and np.isfinite(f16)
                and np.isfinite(f22)
                and np.isfinite(f24)
                and np.isfinite(f29)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._tau = tau
            self._eps = eps
            self._hold_from = hold_from
            self._f16 = f16
            self._a = a
            self._f22 = f22
            self._f24 = f24
            self._f29 = f29
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

    def step(self, t: ArrayLike, x: ArrayLike, *, pi0: Callable[[Array, Array], ArrayLike], after: Callable[[Array, Array], ArrayLike]) -> Control:
        """u at time t [s] and state x = (x1, x1', ...).

        Each argument may be a batch; states stand along the last axis.

        pi0 is called for the whole batch. User-defined law pi0(xi, t); t is the stretched time
        kappa + t0.

        after is called for the whole batch. User-defined law for t >= t0 + tau.
        """
        t = np.asarray(t, dtype=_R)
        x1, x2, x3 = _states(x, "x")
        with np.errstate(all="ignore"):
            past = (t - self._deadline) - self._correction
            late = np.where(past < self._hold_from, past, self._hold_from)
            T = -late
            v1 = T * self._a
            v2 = self._f24 + (-v1)
            unit = self._f29 * v2
            v3 = v1 * (1.0 / v2)
            v4 = v3 - 1.0
            v5 = v4 * 0.5
            v6 = T * unit
            inv_r1 = 1.0 / v6
            xi2 = x2 * v6
            xi3 = ((x3 * v6) + (2.0 * (v5 * unit) * x2)) * v6
            t_kappa = self._t0 + ((-np.log(T / (self._f16 - T))) / self._f22)
            xi = np.stack(np.broadcast_arrays(x1, xi2, xi3), axis=-1)
            law = np.asarray(pi0(np.asarray(xi, dtype=_R), np.asarray(t_kappa)), dtype=_R)
            s1 = ((v4 * v4) + (2.0 * (-v3))) * 0.16666666666666666
            s2 = ((law * inv_r1) + ((-6.0) * (s1 * (unit * unit)) * x2)) * inv_r1
            applied = np.asarray((s2 + ((-3.0) * ((v5 + v5) * unit) * x3)) * inv_r1)
            chosen = np.asarray(past >= 0.0)
            if chosen.any():
                applied = np.where(chosen, np.asarray(after(np.asarray(x, dtype=_R), np.asarray(t)), dtype=_R), applied)
            v = applied
            way1 = np.isfinite(v)
            way2 = v > self._u_max
            way3 = v < -self._u_max
            way4 = late < self._hold_from
            way5 = past >= 0.0
            status = np.where(np.isfinite(t) & (t >= self._t0) & np.isfinite(x1) & np.isfinite(x2) & np.isfinite(x3), np.where(way1, np.where(way2, Status.SATURATED, np.where(way3, Status.SATURATED, np.where(way4, Status.OK, np.where(way5, Status.AFTER, Status.HOLD)))), Status.RANGE), Status.INPUT)
            return Control(np.where(status < 0, _R(0.0), np.where(way2, self._u_max, np.where(way3, -self._u_max, v))), status.astype(np.int8))
