"""
Prescribed-time controller ptc_exp3: order n = 3, mapping exp.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)"
Version 0.1.0, design 083a85e9f77c.

Plant: x1' = x2, ..., x3' = f + u. Time in s, x1 in any unit U, x2 in U/s, x3 in U/s^2, u
      in U/s^3.
Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
      eps, sampling, f and clipping leave. The checks below say what is known of this
      design.
f is not part of the law: cancel its known terms before the call.

SAMPLE PERIOD NOT GIVEN: the held gains grow as eps falls, and the loop is stable only for
      sample periods below a limit that depends on eps and the gains. ptc-codegen check
      finds it once tau, eps, the gains and --sample-time are given.

Parameters:
  a = 1 [1/s], fixed: rate of stretched time
  tau: prescribed settling time [s], from 1e-150 to 1e150
  t0: start time [s], finite
  eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
  u_max: bound of |u| [unit of u], > 0, infinity allowed
  k: gains of pi0 = -(k_1 xi_1 + ... + k_3 xi_3), finite; k[0] is k_1 [1/s^3], k[1] is k_2
      [1/s^2], k[2] is k_3 [1/s]

Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
      the stretched time since t0:
  mu(t)     = tau*(1 - exp(-a*t))
  kappa(Dt) = -ln(T/tau)/a
Derivatives r_k = mu^(k)(kappa(Dt)):
  r_k = (-1)^(k-1) a^k T
  r_1 = a*T
  r_2 = -a^2*T
  r_3 = a^3*T
Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
  B_{0,0} = 1
  B_{1,1} = a*T
  B_{2,1} = -a^2*T
  B_{2,2} = a^2*T^2
  B_{3,1} = a^3*T
  B_{3,2} = -3*a^3*T^2

Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
  u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
  pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
  u = sum_j gain_j x_j
  gain_j = inv_T^(n+1-j) row_j
  K1, K2, ...: K_i = k_i/a^(n+1-i)
  row_1 = -K1
  row_2 = -1 - K2 + K3
  row_3 = 3 - K3
  inv_T = 1/T

From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
      deadline.
Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
  sampling: not checked: `sample_time` is not given.
  deadline: not checked: `error` is not given.
  loop: not checked: it needs a value of `tau`.
  envelope: not checked: `x_max` is not given.

Operations of one step, without input checks and clipping: 5 additions or comparisons, 6
      multiplications, 1 division.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Gains", "Params", "PtcExp3", "Status"]

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
    k: Sequence[float]
    """gains of pi0 = -(k_1 xi_1 + ... + k_3 xi_3), finite; k[0] is k_1 [1/s^3], k[1] is k_2 [1/s^2], k[2] is k_3 [1/s]"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

def _states(x: ArrayLike, name: str) -> tuple[Array, ...]:
    """The states along the last axis, one by one."""
    states = np.asarray(x, dtype=_R)
    if states.ndim == 0 or states.shape[-1] != 3:
        raise ValueError(f"{name} has shape {states.shape}; legal: (..., 3), the states along the last axis")
    return tuple(np.moveaxis(states, -1, 0))

class Gains:
    """Feedback gains at one or more times."""

    def __init__(self, gain: Array, u_max: Array, status: NDArray[np.int8]) -> None:
        self.gain = gain
        """u = gain[0] x[0] + ... + gain[2] x[2]; shape (..., 3)"""
        self.u_max = u_max
        """bound of |u|"""
        self.status = status
        """OK or HOLD, INPUT where the time was not legal."""

    def axis(self, x: ArrayLike) -> Control:
        """u of one axis from its state x = (x1, x1', ...) and the gains.

        Each argument may be a batch; states stand along the last axis.
        """
        x1, x2, x3 = _states(x, "x")
        with np.errstate(all="ignore"):
            s1 = (self.gain[..., 0] * x1) + (self.gain[..., 1] * x2)
            v = s1 + (self.gain[..., 2] * x3)
            way1 = np.isfinite(v) & (np.abs(v) <= self.u_max)
            way2 = np.isfinite(x1) & np.isfinite(x2) & np.isfinite(x3)
            way3 = np.isfinite(v)
            way4 = v > self.u_max
            status = np.where(way1, self.status, np.where(way2, np.where(way3, np.where(way4, Status.SATURATED, Status.SATURATED), Status.RANGE), Status.INPUT))
            status = np.where(self.status < 0, self.status, status)
            return Control(np.where(status < 0, _R(0.0), np.where(way1, v, np.where(way4, self.u_max, -self.u_max))), status.astype(np.int8))

class PtcExp3:
    """The controller. Takes the parameters and arms at params.t0 (or the fixed t0).

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_tau = _R(params.tau)
            given_t0 = _R(params.t0)
            given_eps = _R(params.eps)
            given_u_max = _R(params.u_max)
            given_k = _numbers(params.k, 3, "params.k")
            tau = given_tau
            t0 = given_t0
            eps = given_eps
            u_max = given_u_max
            k1 = given_k[0]
            k2 = given_k[1]
            k3 = given_k[2]
            if not (np.isfinite(tau) and (1e-150 <= tau <= 1e150)):
                raise ValueError(f"params.tau is {params.tau}; legal: from 1e-150 to 1e150")
            if not np.isfinite(t0):
                raise ValueError(f"params.t0 is {params.t0}; legal: finite")
            if not (eps >= 1e-150):
                raise ValueError(f"params.eps is {params.eps}; legal: >= 1e-150")
            if not (u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not np.isfinite(k1):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(k2):
                raise ValueError(f"params.k[1] is {params.k[1]}; legal: finite")
            if not np.isfinite(k3):
                raise ValueError(f"params.k[2] is {params.k[2]}; legal: finite")
            if not (eps < tau):
                raise ValueError(f"params.eps is {params.eps}; legal: < tau")
            c1 = -k1
            c2 = ((-k2) + k3) - 1.0
            c3 = (-k3) + 3.0
            hold_from = -eps
            size_c1 = _R(1e-200) if np.abs(k1) <= 0.0 else np.abs(c1)
            if not (
                (size_c1 >= 1e-200)
                and np.isfinite(c1)
                and np.isfinite(c2)
                and np.isfinite(c3)
                and np.isfinite(hold_from)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._c1 = c1
            self._c2 = c2
            self._c3 = c3
            self._tau = tau
            self._eps = eps
            self._hold_from = hold_from
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

    def step(self, t: ArrayLike, x: ArrayLike) -> Control:
        """u at time t [s] and state x = (x1, x1', ...).

        Each argument may be a batch; states stand along the last axis.
        """
        t = np.asarray(t, dtype=_R)
        x1, x2, x3 = _states(x, "x")
        with np.errstate(all="ignore"):
            past = (t - self._deadline) - self._correction
            late = np.where(past < self._hold_from, past, self._hold_from)
            inv_T = (-1.0) / late
            s1 = ((self._c1 * x1 * inv_T) + (self._c2 * x2)) * inv_T
            v = (s1 + (self._c3 * x3)) * inv_T
            way1 = np.isfinite(v) & (np.abs(v) <= self._u_max) & (late < self._hold_from)
            way2 = np.isfinite(t) & np.isfinite(x1) & np.isfinite(x2) & np.isfinite(x3)
            way3 = np.isfinite(v)
            way4 = v > self._u_max
            way5 = v < -self._u_max
            status = np.where(t >= self._t0, np.where(way1, Status.OK, np.where(way2, np.where(way3, np.where(way4, Status.SATURATED, np.where(way5, Status.SATURATED, Status.HOLD)), Status.RANGE), Status.INPUT)), Status.INPUT)
            return Control(np.where(status < 0, _R(0.0), np.where(way1, v, np.where(way4, self._u_max, np.where(way5, -self._u_max, v)))), status.astype(np.int8))

    def tick(self, t: ArrayLike) -> Gains:
        """The gains at time t [s], for several axes that share one deadline: tick once, then axis
        for each. The result of tick and axis may differ from that of step in the last bits.

        Each argument may be a batch; states stand along the last axis.
        """
        t = np.asarray(t, dtype=_R)
        with np.errstate(all="ignore"):
            past = (t - self._deadline) - self._correction
            late = np.where(past < self._hold_from, past, self._hold_from)
            inv_T = (-1.0) / late
            way1 = late < self._hold_from
            status = np.where(np.isfinite(t) & (t >= self._t0), np.where(way1, Status.OK, Status.HOLD), Status.INPUT)
            gain = np.stack(np.broadcast_arrays(self._c1 * (inv_T * inv_T) * inv_T, self._c2 * inv_T * inv_T, self._c3 * inv_T), axis=-1)
            return Gains(gain, np.asarray(self._u_max), status.astype(np.int8))
