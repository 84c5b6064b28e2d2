"""
Prescribed-time controller drive: order n = 3, mapping exp.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name drive --tau=0.4 --u-max=24 --poles=-4,-5,-6 --states="q, w, i" --input=V --output="q" --dynamics="w, (k*i - b*w)/J, (V - R*i - k*w)/L" --param J=2e-5 --param L=2e-3 --param R=1.2 --param b=1e-5 --param k=0.03
Version 0.1.0, design c35b1c6c3590.

Plant, with the input V: q' = w, w' = (k*i - b*w)/J, i' = (V - R*i - k*w)/L, output q. Time
      in s.
Goal: the output and its first 2 derivatives, x, are 0 at the deadline t0 + tau from any
      state at t0, up to the error that the hold at eps, sampling, what differs from the
      model and clipping leave. The checks below say what is known of this design.
The law takes the plant to be the model. What differs from it is not part of the law.

SAMPLE PERIOD NOT GIVEN: the held gains grow as eps falls, and the loop is stable only for
      sample periods below a limit that depends on eps and the gains. ptc-codegen check
      finds it once tau, eps, the gains and --sample-time are given.

Parameters:
  tau = 0.4 [s], fixed: prescribed settling time
  u_max = 24 [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 120 [1/s^3], fixed: gain of xi_1
  k_2 = 74 [1/s^2], fixed: gain of xi_2
  k_3 = 15 [1/s], fixed: gain of xi_3
  J = 2e-5, fixed: parameter of the model
  L = 2e-3, fixed: parameter of the model
  R = 1.2, fixed: parameter of the model
  b = 1e-5, fixed: parameter of the model
  k = 0.03, fixed: parameter of the model
  t0: start time [s], finite
  eps: time-to-go at which the gains are held [s], >= 1e-150, < tau

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
  u = (kappa'^n (pi0(xi, t_kappa) - b_n^T x) - f)/g
  pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
  x_1 = q
  x_2 = w
  x_3 = (k*i - b*w)/J
  f = (k*(-(R*i + k*w)/L) - b*((k*i - b*w)/J))/J
  g = k/(J*L)
  u = (sum_j gain_j x_j - f)/g
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
  growth: sound: x and u go to 0 at the deadline.
  sampling: not checked: `sample_time` is not given.
  deadline: not checked: `error` is not given.
  loop: not checked: `sample_time` is not given.
  envelope: not checked: `x_max` is not given.
  zeros: sound: none: the relative degree is 3, the number of states.

Operations of one step, without input checks and clipping: 8 additions or comparisons, 9
      multiplications, 1 division.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Drive", "Params", "Status"]

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

    t0: float = 0.0
    """start time [s], finite"""
    eps: float
    """time-to-go at which the gains are held [s], >= 1e-150, < tau"""

def _states(x: ArrayLike, name: str) -> tuple[Array, ...]:
    """The states along the last axis, one by one."""
    states = np.asarray(x, dtype=_R)
    if states.ndim == 0 or states.shape[-1] != 3:
        raise ValueError(f"{name} has shape {states.shape}; legal: (..., 3), the states along the last axis")
    return tuple(np.moveaxis(states, -1, 0))

class Drive:
    """The controller. Takes the parameters and arms at params.t0 (or the fixed t0).

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_t0 = _R(params.t0)
            given_eps = _R(params.eps)
            t0 = given_t0
            eps = given_eps
            if not np.isfinite(t0):
                raise ValueError(f"params.t0 is {params.t0}; legal: finite")
            if not (1e-150 <= eps < 0.4):
                raise ValueError(f"params.eps is {params.eps}; legal: >= 1e-150, < 0.4")
            hold_from = -eps
            if not np.isfinite(hold_from):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._eps = eps
            self._hold_from = hold_from
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
            deadline = t0 + 0.4
            v1 = deadline - t0
            correction = (t0 - (deadline - v1)) + (0.4 - v1)
            if not np.isfinite(deadline):
                raise ValueError("t0, and what follows, must be finite")
            self._t0 = t0
            self._deadline = deadline
            self._correction = correction

    def step(self, t: ArrayLike, x: ArrayLike) -> Control:
        """u at time t [s] and state x = (q, w, i).

        Each argument may be a batch; states stand along the last axis.
        """
        t = np.asarray(t, dtype=_R)
        x1, x2, x3 = _states(x, "x")
        with np.errstate(all="ignore"):
            past = (t - self._deadline) - self._correction
            late = np.where(past < self._hold_from, past, self._hold_from)
            inv_T = (-1.0) / late
            drift = ((-0.029999666666666668) * x2) - (1.201 * x3)
            s1 = (((-0.00016) * x1 * inv_T) + ((-8e-5) * x2)) * inv_T
            v = ((s1 + (((-0.024) * x3) - ((-8e-6) * x2))) * inv_T) - drift
            way1 = np.isfinite(v) & (np.abs(v) <= 24.0) & (late < self._hold_from)
            way2 = np.isfinite(t) & np.isfinite(x1) & np.isfinite(x2) & np.isfinite(x3)
            way3 = np.isfinite(v)
            way4 = v > 24.0
            way5 = v < -24.0
            status = np.where(t >= self._t0, np.where(way1, Status.OK, np.where(way2, np.where(way3, np.where(way4, Status.SATURATED, np.where(way5, Status.SATURATED, Status.HOLD)), Status.RANGE), Status.INPUT)), Status.INPUT)
            return Control(np.where(status < 0, _R(0.0), np.where(way1, v, np.where(way4, 24.0, np.where(way5, -24.0, v)))), status.astype(np.int8))
