"""
Prescribed-time controller ptc_exp_sum2: order n = 2, mapping exp_sum.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp_sum(2)"
Version 0.1.0, design b16d2a0d4a86.

Plant: x1' = x2, x2' = f + u. Time in s, x1 in any unit U, x2 in U/s, u in U/s^2.
Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
      eps, sampling, f and clipping leave. The checks below say what is known of this
      design.
f is not part of the law: cancel its known terms before the call.

SAMPLE PERIOD NOT GIVEN: the held gains grow as eps falls, and the loop is stable only for
      sample periods below a limit that depends on eps and the gains. ptc-codegen check
      finds it once tau, eps, the gains and --sample-time are given.

Parameters:
  tau: prescribed settling time [s], from 1e-150 to 1e150
  t0: start time [s], finite
  eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
  u_max: bound of |u| [unit of u], > 0, infinity allowed
  rates: rates a_i of stretched time, from 1e-150 to 1e150; rates[0] is a_1 [1/s], rates[1]
      is a_2 [1/s]
  k: gains of pi0 = -(k_1 xi_1 + k_2 xi_2), finite; k[0] is k_1 [1/s^2], k[1] is k_2 [1/s]

Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
      the stretched time since t0:
  mu(t)     = tau*mean_i(1 - exp(-a_i*t))
  kappa(Dt) = the root t of mean_i(exp(-a_i*t)) = T/tau, by a bracketed iteration
  in terms of e_i = exp(-a_i*t)
Derivatives r_k = mu^(k)(kappa(Dt)):
  r_k = (-1)^(k-1) tau mean_i(a_i^k e_i)
  r_1 = 1/2*tau*a1*e1 + 1/2*tau*a2*e2
  r_2 = -1/2*tau*a1^2*e1 - 1/2*tau*a2^2*e2
Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
  B_{0,0} = 1
  B_{1,1} = r1
  B_{2,1} = r2

Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
  u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
  pi0 = -(k_1 xi_1 + k_2 xi_2)
  u = sum_j gain_j x_j
  gain_j = r_1^-(n+1-j) row_j
  row_j = -1/(j-1)! sum_{i=j..n+1} k_i (i-1)! [z^(i-1)] p(z)^(j-1), with k_(n+1) = 1
  p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i

From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
      deadline.
Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
      mathematical library.

Checks of the design (details: ptc-codegen check):
  membership: sound: exp_sum is of class M for all its parameters.
  growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
  sampling: not checked: `sample_time` is not given.
  deadline: not checked: `error` is not given.
  loop: not checked: it needs a value of `tau`.
  envelope: not checked: `x_max` is not given.

Operations of one step, without input checks and clipping: 34 additions or comparisons, 50
      multiplications, 5 divisions, 5 function calls. One round of the iteration is
      counted; it takes at most 12.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Gains", "Params", "PtcExpSum2", "Status"]

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
    rates: Sequence[float]
    """rates a_i of stretched time, from 1e-150 to 1e150; rates[0] is a_1 [1/s], rates[1] is a_2 [1/s]"""
    k: Sequence[float]
    """gains of pi0 = -(k_1 xi_1 + k_2 xi_2), finite; k[0] is k_1 [1/s^2], k[1] is k_2 [1/s]"""

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

class Gains:
    """Feedback gains at one or more times."""

    def __init__(self, gain: Array, u_max: Array, status: NDArray[np.int8]) -> None:
        self.gain = gain
        """u = gain[0] x[0] + ... + gain[1] x[1]; shape (..., 2)"""
        self.u_max = u_max
        """bound of |u|"""
        self.status = status
        """OK or HOLD, INPUT where the time was not legal."""

    def axis(self, x: ArrayLike) -> Control:
        """u of one axis from its state x = (x1, x1', ...) and the gains.

        Each argument may be a batch; states stand along the last axis.
        """
        x1, x2 = _states(x, "x")
        with np.errstate(all="ignore"):
            v = (self.gain[..., 0] * x1) + (self.gain[..., 1] * x2)
            way1 = np.isfinite(v) & (np.abs(v) <= self.u_max)
            way2 = np.isfinite(x1) & np.isfinite(x2)
            way3 = np.isfinite(v)
            way4 = v > self.u_max
            status = np.where(way1, self.status, np.where(way2, np.where(way3, np.where(way4, Status.SATURATED, Status.SATURATED), Status.RANGE), Status.INPUT))
            status = np.where(self.status < 0, self.status, status)
            return Control(np.where(status < 0, _R(0.0), np.where(way1, v, np.where(way4, self.u_max, -self.u_max))), status.astype(np.int8))

class PtcExpSum2:
    """The controller. Takes the parameters and arms at params.t0 (or the fixed t0).

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_tau = _R(params.tau)
            given_t0 = _R(params.t0)
            given_eps = _R(params.eps)
            given_u_max = _R(params.u_max)
            given_rates = _numbers(params.rates, 2, "params.rates")
            given_k = _numbers(params.k, 2, "params.k")
            tau = given_tau
            t0 = given_t0
            eps = given_eps
            u_max = given_u_max
            a1 = given_rates[0]
            a2 = given_rates[1]
            k1 = given_k[0]
            k2 = given_k[1]
            if not (np.isfinite(tau) and (1e-150 <= tau <= 1e150)):
                raise ValueError(f"params.tau is {params.tau}; legal: from 1e-150 to 1e150")
            if not np.isfinite(t0):
                raise ValueError(f"params.t0 is {params.t0}; legal: finite")
            if not (eps >= 1e-150):
                raise ValueError(f"params.eps is {params.eps}; legal: >= 1e-150")
            if not (u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not (np.isfinite(a1) and (1e-150 <= a1 <= 1e150)):
                raise ValueError(f"params.rates[0] is {params.rates[0]}; legal: from 1e-150 to 1e150")
            if not (np.isfinite(a2) and (1e-150 <= a2 <= 1e150)):
                raise ValueError(f"params.rates[1] is {params.rates[1]}; legal: from 1e-150 to 1e150")
            if not np.isfinite(k1):
                raise ValueError(f"params.k[0] is {params.k[0]}; legal: finite")
            if not np.isfinite(k2):
                raise ValueError(f"params.k[1] is {params.k[1]}; legal: finite")
            if not (eps < tau):
                raise ValueError(f"params.eps is {params.eps}; legal: < tau")
            hold_from = -eps
            target_rate = 2.0 / tau
            v1 = 1.0 / a1
            v2 = 1.0 / a2
            slowest = max(v1, v2)
            mean_period = 2.0 / (a1 + a2)
            s1 = max(a1, a2)
            tolerance = 0.03 / s1
            b1_1 = 0.5 * a1 * tau
            b1_2 = 0.5 * a2 * tau
            b2_1 = (-0.25) * (a1 * a1) * tau
            b2_2 = (-0.25) * (a2 * a2) * tau
            w1 = -k1
            w2 = -k2
            size_w1 = _R(1e-200) if np.abs(k1) <= 0.0 else np.abs(w1)
            size_w2 = _R(1e-200) if np.abs(k2) <= 0.0 else np.abs(w2)
            if not (
                (b2_1 <= -1e-200)
                and (b2_2 <= -1e-200)
                and (size_w1 >= 1e-200)
                and (size_w2 >= 1e-200)
                and np.isfinite(hold_from)
                and np.isfinite(target_rate)
                and np.isfinite(slowest)
                and np.isfinite(mean_period)
                and np.isfinite(tolerance)
                and np.isfinite(b1_1)
                and np.isfinite(b1_2)
                and np.isfinite(b2_1)
                and np.isfinite(b2_2)
                and np.isfinite(w1)
                and np.isfinite(w2)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._a1 = a1
            self._a2 = a2
            self._tau = tau
            self._eps = eps
            self._hold_from = hold_from
            self._target_rate = target_rate
            self._slowest = slowest
            self._mean_period = mean_period
            self._tolerance = tolerance
            self._b1_1 = b1_1
            self._b1_2 = b1_2
            self._b2_1 = b2_1
            self._b2_2 = b2_2
            self._w1 = w1
            self._w2 = w2
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
        x1, x2 = _states(x, "x")
        with np.errstate(all="ignore"):
            past = (t - self._deadline) - self._correction
            late = np.where(past < self._hold_from, past, self._hold_from)
            T = -late
            target = T * self._target_rate
            v1 = -np.log(target / 2.0)
            v2 = v1 * self._mean_period
            v3 = (v1 - 0.6931467056274414) * self._slowest
            y = np.asarray(np.where(v2 < v3, v3, v2))
            y_low = np.asarray(v2)
            y_high = np.asarray(v1 * self._slowest)
            done = np.asarray(False)
            for _ in range(12):
                v4 = np.exp(-(self._a1 * y))
                v5 = np.exp(-(self._a2 * y))
                v6 = self._a1 * v4
                v7 = v4 + v5
                v8 = self._a2 * v5
                v9 = (2.0 * (v7 - target)) / (v7 + target)
                v10 = v9 * (1.0 + (0.08333333333333333 * (v9 * v9)))
                v11 = 1.0 / (v6 + v8)
                v12 = v7 * v11
                s1 = (((self._a1 * v6) + (self._a2 * v8)) * v11 * v12) - 1.0
                v13 = v10 * v12 * (1.0 + (0.5 * v10 * s1))
                y_next = y + v13
                y_size = np.abs(v13)
                holds = np.asarray(v10 > 0.0)
                y_low = np.where(holds & ~done, y, y_low)
                y_high = np.where(~holds & ~done, y, y_high)
                chosen = np.where((y_low <= y_next) & (y_next <= y_high), y_next, 0.5 * (y_low + y_high))
                y = np.where(~done, chosen, y)
                done = done | (y_size <= self._tolerance)
                if done.all():
                    break
            v14 = np.exp(-(self._a1 * y))
            v15 = np.exp(-(self._a2 * y))
            v16 = self._a1 * v14
            v17 = self._a2 * v15
            v18 = 1.0 / (v16 + v17)
            v19 = ((v14 + v15) - target) * v18
            s2 = 1.0 + (0.5 * (((self._a1 * v16) + (self._a2 * v17)) * v18 * v19))
            v20 = v19 * s2
            v21 = self._a1 * v20
            v22 = v14 - (v14 * (v21 * (1.0 - (0.5 * v21))))
            v23 = self._a2 * v20
            v24 = v15 - (v15 * (v23 * (1.0 - (0.5 * v23))))
            inv_r1 = 1.0 / ((self._b1_1 * v22) + (self._b1_2 * v24))
            p2 = ((self._b2_1 * v22) + (self._b2_2 * v24)) * inv_r1
            s3 = (self._w1 * x1 * inv_r1) + ((self._w2 + ((-2.0) * p2)) * x2)
            v = s3 * inv_r1
            way1 = np.isfinite(v) & (np.abs(v) <= self._u_max) & (late < self._hold_from)
            way2 = np.isfinite(t) & np.isfinite(x1) & np.isfinite(x2)
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
            T = -late
            target = T * self._target_rate
            v1 = -np.log(target / 2.0)
            v2 = v1 * self._mean_period
            v3 = (v1 - 0.6931467056274414) * self._slowest
            y = np.asarray(np.where(v2 < v3, v3, v2))
            y_low = np.asarray(v2)
            y_high = np.asarray(v1 * self._slowest)
            done = np.asarray(False)
            for _ in range(12):
                v4 = np.exp(-(self._a1 * y))
                v5 = np.exp(-(self._a2 * y))
                v6 = self._a1 * v4
                v7 = v4 + v5
                v8 = self._a2 * v5
                v9 = (2.0 * (v7 - target)) / (v7 + target)
                v10 = v9 * (1.0 + (0.08333333333333333 * (v9 * v9)))
                v11 = 1.0 / (v6 + v8)
                v12 = v7 * v11
                s1 = (((self._a1 * v6) + (self._a2 * v8)) * v11 * v12) - 1.0
                v13 = v10 * v12 * (1.0 + (0.5 * v10 * s1))
                y_next = y + v13
                y_size = np.abs(v13)
                holds = np.asarray(v10 > 0.0)
                y_low = np.where(holds & ~done, y, y_low)
                y_high = np.where(~holds & ~done, y, y_high)
                chosen = np.where((y_low <= y_next) & (y_next <= y_high), y_next, 0.5 * (y_low + y_high))
                y = np.where(~done, chosen, y)
                done = done | (y_size <= self._tolerance)
                if done.all():
                    break
            v14 = np.exp(-(self._a1 * y))
            v15 = np.exp(-(self._a2 * y))
            v16 = self._a1 * v14
            v17 = self._a2 * v15
            v18 = 1.0 / (v16 + v17)
            v19 = ((v14 + v15) - target) * v18
            s2 = 1.0 + (0.5 * (((self._a1 * v16) + (self._a2 * v17)) * v18 * v19))
            v20 = v19 * s2
            v21 = self._a1 * v20
            v22 = v14 - (v14 * (v21 * (1.0 - (0.5 * v21))))
            v23 = self._a2 * v20
            v24 = v15 - (v15 * (v23 * (1.0 - (0.5 * v23))))
            inv_r1 = 1.0 / ((self._b1_1 * v22) + (self._b1_2 * v24))
            p2 = ((self._b2_1 * v22) + (self._b2_2 * v24)) * inv_r1
            way1 = late < self._hold_from
            status = np.where(np.isfinite(t) & (t >= self._t0), np.where(way1, Status.OK, Status.HOLD), Status.INPUT)
            gain = np.stack(np.broadcast_arrays(self._w1 * inv_r1 * inv_r1, (self._w2 + ((-2.0) * p2)) * inv_r1), axis=-1)
            return Gains(gain, np.asarray(self._u_max), status.astype(np.int8))
