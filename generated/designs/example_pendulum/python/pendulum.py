"""
Prescribed-time controller pendulum: order n = 2, mapping exp.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name pendulum --tau=0.8 --eps=6.00e-3 --u-max=25 --poles=-3,-4 --states="q, w" --input=M --output="q" --dynamics="w, (M - drag*w)/(m*l^2) - grav/l*sin(q)" --param drag=0.02 --param grav=9.81 --param l=0.5 --param m=1 --sample-time=1e-3 --noise=1e-4,1e-3
Version 0.1.0, design d3c8a839e63d.

Plant, with the input M: q' = w, w' = (M - drag*w)/(m*l^2) - grav/l*sin(q), output q. Time
      in s.
Goal: the output and its rate, x, are 0 at the deadline t0 + tau from any state at t0, up
      to the error that the hold at eps, sampling, what differs from the model and clipping
      leave. The checks below say what is known of this design.
The law takes the plant to be the model. What differs from it is not part of the law.

Parameters:
  tau = 0.8 [s], fixed: prescribed settling time
  eps = 6.00e-3 [s], fixed: time-to-go at which the gains are held
  u_max = 25 [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 12 [1/s^2], fixed: gain of xi_1
  k_2 = 7 [1/s], fixed: gain of xi_2
  drag = 0.02, fixed: parameter of the model
  grav = 9.81, fixed: parameter of the model
  l = 0.5, fixed: parameter of the model
  m = 1, fixed: parameter of the model
  t0: start time [s], finite

Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
      the stretched time since t0:
  mu(t)     = tau*(1 - exp(-a*t))
  kappa(Dt) = -ln(T/tau)/a
Derivatives r_k = mu^(k)(kappa(Dt)):
  r_k = (-1)^(k-1) a^k T
  r_1 = a*T
  r_2 = -a^2*T
Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
  B_{0,0} = 1
  B_{1,1} = a*T
  B_{2,1} = -a^2*T

Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
  u = (kappa'^n (pi0(xi, t_kappa) - b_n^T x) - f)/g
  pi0 = -(k_1 xi_1 + k_2 xi_2)
  x_1 = q
  x_2 = w
  f = -(drag*w)/(m*l^2) - grav/l*sin(q)
  g = 1/(l^2*m)
  u = (sum_j gain_j x_j - f)/g
  gain_j = inv_T^(n+1-j) row_j
  K1, K2, ...: K_i = k_i/a^(n+1-i)
  row_1 = -K1
  row_2 = 1 - K2
  inv_T = 1/T

From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
      deadline.
Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
      mathematical library.

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: x and u go to 0 at the deadline.
  sampling: undecided: f is cancelled at the samples alone; with f = 0: eps = 0.006 s is 2
      times the minimum for a period of 0.001 s.
  deadline: not checked: `error` is not given.
  loop: not checked: `x0_max` is not given.
  envelope: not checked: `x_max` is not given.
  zeros: sound: none: the relative degree is 2, the number of states.

Operations of one step, without input checks and clipping: 6 additions or comparisons, 6
      multiplications, 1 division, 1 function call.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Params", "Pendulum", "Status"]

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

def _states(x: ArrayLike, name: str) -> tuple[Array, ...]:
    """The states along the last axis, one by one."""
    states = np.asarray(x, dtype=_R)
    if states.ndim == 0 or states.shape[-1] != 2:
        raise ValueError(f"{name} has shape {states.shape}; legal: (..., 2), the states along the last axis")
    return tuple(np.moveaxis(states, -1, 0))

class Pendulum:
    """The controller. Takes the parameters and arms at params.t0 (or the fixed t0).

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_t0 = _R(params.t0)
            t0 = given_t0
            if not np.isfinite(t0):
                raise ValueError(f"params.t0 is {params.t0}; legal: finite")
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
            deadline = t0 + 0.8
            v1 = deadline - t0
            correction = (t0 - (deadline - v1)) + (0.8 - v1)
            if not np.isfinite(deadline):
                raise ValueError("t0, and what follows, must be finite")
            self._t0 = t0
            self._deadline = deadline
            self._correction = correction

    def step(self, t: ArrayLike, x: ArrayLike) -> Control:
        """u at time t [s] and state x = (q, w).

        Each argument may be a batch; states stand along the last axis.
        """
        t = np.asarray(t, dtype=_R)
        x1, x2 = _states(x, "x")
        with np.errstate(all="ignore"):
            past = (t - self._deadline) - self._correction
            late = np.where(past < -0.006, past, -0.006)
            inv_T = (-1.0) / late
            drift = ((-4.905) * np.sin(x1)) - (0.02 * x2)
            v = ((((-3.0) * x1 * inv_T) + ((-1.5) * x2)) * inv_T) - drift
            way1 = np.isfinite(v) & (np.abs(v) <= 25.0) & (late < -0.006)
            way2 = np.isfinite(t) & np.isfinite(x2)
            way3 = np.isfinite(v)
            way4 = v > 25.0
            way5 = v < -25.0
            status = np.where((t >= self._t0) & np.isfinite(x1), np.where(way1, Status.OK, np.where(way2, np.where(way3, np.where(way4, Status.SATURATED, np.where(way5, Status.SATURATED, Status.HOLD)), Status.RANGE), Status.INPUT)), Status.INPUT)
            return Control(np.where(status < 0, _R(0.0), np.where(way1, v, np.where(way4, 25.0, np.where(way5, -25.0, v)))), status.astype(np.int8))
