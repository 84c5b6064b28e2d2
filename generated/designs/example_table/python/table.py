"""
Prescribed-time controller table: order n = 2, mapping exp.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name table --tau=1 --eps=4.93e-2 --u-max=0.5 --poles=-4,-5 --g="50" --sample-time=5e-3 --error=1e-3,1e-2 --x0-max=1,0.5
Version 0.1.0, design a83bf3b80b92.

Plant: x1' = x2, x2' = f + g u. Time in s, x1 in any unit U, x2 in U/s, g u in U/s^2.
Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
      eps, sampling, f and clipping leave. The checks below say what is known of this
      design.
f is not part of the law: cancel its known terms before the call.

Parameters:
  tau = 1 [s], fixed: prescribed settling time
  eps = 4.93e-2 [s], fixed: time-to-go at which the gains are held
  u_max = 0.5 [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 20 [1/s^2], fixed: gain of xi_1
  k_2 = 9 [1/s], fixed: gain of xi_2
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
  u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)/g
  pi0 = -(k_1 xi_1 + k_2 xi_2)
  g = 50
  u = (sum_j gain_j x_j)/g
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
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: x and u go to 0 at the deadline.
  sampling: sound: eps = 0.0493 s is 2.465 times the minimum for a period of 0.005 s.
  deadline: not checked: `loop` decides; without noise and for short periods eps = 0.0493 s
      is too early to stop: |x| <= 0.001 from 0.03613 s on.
  loop: sound: at the deadline |x| <= 4.179e-7, 4.094e-5.
  envelope: not checked: `x_max` is not given.

Operations of one step, without input checks and clipping: 4 additions or comparisons, 5
      multiplications, 1 division.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Gains", "Params", "Status", "Table"]

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

class Gains:
    """Feedback gains at one or more times."""

    def __init__(self, gain: Array, status: NDArray[np.int8]) -> None:
        self.gain = gain
        """u = gain[0] x[0] + ... + gain[1] x[1]; shape (..., 2)"""
        self.status = status
        """OK or HOLD, INPUT where the time was not legal."""

    def axis(self, x: ArrayLike) -> Control:
        """u of one axis from its state x = (x1, x1', ...) and the gains.

        Each argument may be a batch; states stand along the last axis.
        """
        x1, x2 = _states(x, "x")
        with np.errstate(all="ignore"):
            v = ((self.gain[..., 0] * x1) + (self.gain[..., 1] * x2)) * 0.02
            way1 = np.isfinite(v) & (np.abs(v) <= 0.5)
            way2 = np.isfinite(x1) & np.isfinite(x2)
            way3 = np.isfinite(v)
            way4 = v > 0.5
            status = np.where(way1, self.status, np.where(way2, np.where(way3, np.where(way4, Status.SATURATED, Status.SATURATED), Status.RANGE), Status.INPUT))
            status = np.where(self.status < 0, self.status, status)
            return Control(np.where(status < 0, _R(0.0), np.where(way1, v, np.where(way4, 0.5, -0.5))), status.astype(np.int8))

class Table:
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
            deadline = t0 + 1.0
            v1 = deadline - t0
            correction = (t0 - (deadline - v1)) + (1.0 - v1)
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
            late = np.where(past < -0.0493, past, -0.0493)
            inv_T = (-1.0) / late
            v = (((-20.0) * x1 * inv_T) + ((-8.0) * x2)) * inv_T * 0.02
            way1 = np.isfinite(v) & (np.abs(v) <= 0.5) & (late < -0.0493)
            way2 = np.isfinite(t) & np.isfinite(x1) & np.isfinite(x2)
            way3 = np.isfinite(v)
            way4 = v > 0.5
            way5 = v < -0.5
            status = np.where(t >= self._t0, np.where(way1, Status.OK, np.where(way2, np.where(way3, np.where(way4, Status.SATURATED, np.where(way5, Status.SATURATED, Status.HOLD)), Status.RANGE), Status.INPUT)), Status.INPUT)
            return Control(np.where(status < 0, _R(0.0), np.where(way1, v, np.where(way4, 0.5, np.where(way5, -0.5, v)))), status.astype(np.int8))

    def tick(self, t: ArrayLike) -> Gains:
        """The gains at time t [s], for several axes that share one deadline: tick once, then axis
        for each. The result of tick and axis may differ from that of step in the last bits.

        Each argument may be a batch; states stand along the last axis.
        """
        t = np.asarray(t, dtype=_R)
        with np.errstate(all="ignore"):
            past = (t - self._deadline) - self._correction
            late = np.where(past < -0.0493, past, -0.0493)
            inv_T = (-1.0) / late
            way1 = late < -0.0493
            status = np.where(np.isfinite(t) & (t >= self._t0), np.where(way1, Status.OK, Status.HOLD), Status.INPUT)
            gain = np.stack(np.broadcast_arrays((-20.0) * inv_T * inv_T, (-8.0) * inv_T), axis=-1)
            return Gains(gain, status.astype(np.int8))
