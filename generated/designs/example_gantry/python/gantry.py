"""
Prescribed-time controller gantry: order n = 2, mapping exp.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --axes 3 --mu "exp(a=1)" --name gantry --tau=1.5 --t0=0 --eps=1.59e-2 --limits=900,400,150 --poles="[[-4,-5],[-4,-5],[-6,-7]]" --g="[1/m1, 1/m2, 1/m3]" --param m1=120 --param m2=45 --param m3=12 --sample-time=1e-3
Version 0.1.0, design 9ac95d6ea129.

Plant: x1' = x2, x2' = f + g u. Time in s, x1 in any unit U, x2 in U/s, g u in U/s^2.
Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
      eps, sampling, f and clipping leave. The checks below say what is known of this
      design.
f is not part of the law: cancel its known terms before the call.
Axes: 3, each a chain of its own with this deadline and mapping. step computes what depends
      on time once.
  axis 1: k = 20, 9; u_max = 900; g = 1/m1
  axis 2: k = 20, 9; u_max = 400; g = 1/m2
  axis 3: k = 42, 13; u_max = 150; g = 1/m3

Parameters:
  tau = 1.5 [s], fixed: prescribed settling time
  t0 = 0 [s], fixed: start time
  eps = 1.59e-2 [s], fixed: time-to-go at which the gains are held
  a = 1 [1/s], fixed: rate of stretched time
  m1 = 120, fixed: parameter of g
  m2 = 45, fixed: parameter of g
  m3 = 12, fixed: parameter of g

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
  sampling: sound: axis 1: eps = 0.0159 s is 3.975 times the minimum for a period of 0.001
      s.
  deadline: not checked: `error` is not given.
  loop: not checked: `x0_max` is not given.
  envelope: not checked: `x_max` is not given.

Operations of one step, without input checks and clipping: 6 additions or comparisons, 12
      multiplications, 4 divisions.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Axes", "Control", "Gains", "Gantry", "Params", "Status"]

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

def _states(x: ArrayLike, name: str) -> tuple[Array, ...]:
    """The states along the last axis, one by one."""
    states = np.asarray(x, dtype=_R)
    if states.ndim == 0 or states.shape[-1] != 2:
        raise ValueError(f"{name} has shape {states.shape}; legal: (..., 2), the states along the last axis")
    return tuple(np.moveaxis(states, -1, 0))

def _of_axes(given: ArrayLike, count: int, length: int, name: str) -> Array:
    """The numbers of each axis: the last two dimensions."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape[-2:] != (count, length):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: (..., {count}, {length})")
    return numbers

class Gains:
    """Feedback gains at one or more times."""

    def __init__(self, gain: Array, input_gain: Array, u_max: Array, status: NDArray[np.int8]) -> None:
        self.gain = gain
        """u input_gain = gain[2*axis] x[0] + ... + gain[2*axis + 1] x[1]; shape (..., 6)"""
        self.input_gain = input_gain
        """g; shape (..., 3)"""
        self.u_max = u_max
        """bound of |u| of each axis; shape (..., 3)"""
        self.status = status
        """OK or HOLD, INPUT where the time was not legal."""

    def axis(self, axis: int, x: ArrayLike) -> Control:
        """u of one axis from its state x = (x1, x1', ...) and the gains.

        Each argument may be a batch; states stand along the last axis.
        """
        axis = axis.__index__()
        if not 0 <= axis < 3:
            raise ValueError(f"axis is {axis}; legal: 0..2")
        x1, x2 = _states(x, "x")
        with np.errstate(all="ignore"):
            s1 = self.gain[..., 2 * axis + 0] * x1
            v1 = s1 + (self.gain[..., 2 * axis + 1] * x2)
            g = self.input_gain[..., axis]
            v = np.where((g < 0.0) | (g > 0.0), v1 / g, _R(np.nan))
            way1 = np.isfinite(v) & (np.abs(v) <= self.u_max[..., axis])
            way2 = np.isfinite(x1) & np.isfinite(x2)
            way3 = np.isfinite(v)
            way4 = v > self.u_max[..., axis]
            status = np.where(axis < 3, np.where(way1, self.status, np.where(way2, np.where(way3, np.where(way4, Status.SATURATED, Status.SATURATED), Status.RANGE), Status.INPUT)), Status.INPUT)
            status = np.where(self.status < 0, self.status, status)
            return Control(np.where(status < 0, _R(0.0), np.where(way1, v, np.where(way4, self.u_max[..., axis], -self.u_max[..., axis]))), status.astype(np.int8))

class Gantry:
    """The controller. Takes the parameters and arms at params.t0 (or the fixed t0).

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            self._t0 = _R(0.0)
            self._deadline = _R(0.0)
            self._correction = _R(0.0)
        self.arm(0.0)

    def arm(self, t0: float) -> None:
        """Starts again at t0 [s].

        ValueError where an argument or what follows from it is not finite; the controller
        is left as it was.
        """
        with np.errstate(all="ignore"):
            t0 = _R(t0)
            if not np.isfinite(t0):
                raise ValueError("t0, and what follows, must be finite")
            deadline = t0 + 1.5
            v1 = deadline - t0
            correction = (t0 - (deadline - v1)) + (1.5 - v1)
            if not np.isfinite(deadline):
                raise ValueError("t0, and what follows, must be finite")
            self._t0 = t0
            self._deadline = deadline
            self._correction = correction

    def tick(self, t: ArrayLike) -> Gains:
        """The gains at time t [s] for all axes, from which step computes u of each.

        Each argument may be a batch; states stand along the last axis.
        """
        t = np.asarray(t, dtype=_R)
        with np.errstate(all="ignore"):
            past = (t - self._deadline) - self._correction
            late = np.where(past < -0.0159, past, -0.0159)
            inv_T = (-1.0) / late
            v1 = (-20.0) * inv_T * inv_T
            v2 = (-8.0) * inv_T
            way1 = late < -0.0159
            status = np.where(np.isfinite(t) & (t >= self._t0), np.where(way1, Status.OK, Status.HOLD), Status.INPUT)
            gain = np.stack(np.broadcast_arrays(v1, v2, v1, v2, (-42.0) * inv_T * inv_T, (-12.0) * inv_T), axis=-1)
            input_gain = np.stack(np.broadcast_arrays(0.008333333333333333, 0.022222222222222223, 0.08333333333333333), axis=-1)
            u_max = np.stack(np.broadcast_arrays(900.0, 400.0, 150.0), axis=-1)
            return Gains(gain, input_gain, u_max, status.astype(np.int8))

    def step(self, t: ArrayLike, x: ArrayLike) -> Axes:
        """u of 3 axes at time t [s], from the state x = (x1, x1', ...) of each. Its status is that
        of the first axis that fails, and then every u is 0; else SATURATED where an axis is.

        Each argument may be a batch; axes and what each is given stand along the last two axes.
        """
        t = np.asarray(t, dtype=_R)
        x = _of_axes(x, 3, 2, "x")
        with np.errstate(all="ignore"):
            u: list[Array] = [np.asarray(_R(0.0))] * 3
            axes = [np.asarray(Status.OK)] * 3
            past = (t - self._deadline) - self._correction
            late = np.where(past < -0.0159, past, -0.0159)
            inv_T = (-1.0) / late
            v1 = (-20.0) * inv_T * inv_T
            v2 = (-8.0) * inv_T
            gain: list[Array] = [np.asarray(_R(0.0))] * 6
            gain[0] = v1
            gain[1] = v2
            gain[2] = v1
            gain[3] = v2
            gain[4] = (-42.0) * inv_T * inv_T
            gain[5] = (-12.0) * inv_T
            input_gain: list[Array] = [np.asarray(_R(0.0))] * 3
            input_gain[0] = np.asarray(_R(0.008333333333333333))
            input_gain[1] = np.asarray(_R(0.022222222222222223))
            input_gain[2] = np.asarray(_R(0.08333333333333333))
            u_max: list[Array] = [np.asarray(_R(0.0))] * 3
            u_max[0] = np.asarray(_R(900.0))
            u_max[1] = np.asarray(_R(400.0))
            u_max[2] = np.asarray(_R(150.0))
            status = np.asarray(Status.HOLD)
            chosen = np.asarray(late < -0.0159)
            if chosen.any():
                status = np.where(chosen, Status.OK, status)
            wanted: list[Array] = [np.asarray(_R(0.0))] * 3
            for axis in range(3):
                v3 = (gain[2 * axis] * x[..., axis, 0]) + (gain[(2 * axis) + 1] * x[..., axis, 1])
                g = input_gain[axis]
                wanted[axis] = np.where((g < 0.0) | (g > 0.0), v3 / g, _R(np.nan))
            u[0] = wanted[0]
            u[1] = wanted[1]
            u[2] = wanted[2]
            for axis in range(3):
                axes[axis] = status
            outside = np.asarray(0)
            done = np.asarray(False)
            for axis in range(3):
                v = wanted[axis]
                holds = np.asarray(np.isfinite(v) & (np.abs(v) <= u_max[axis]))
                outside = np.where(~holds & ~done, 1, outside)
                done = done | (~holds & ~done)
                if done.all():
                    break
            holds = np.asarray(outside == 1)
            if holds.any():
                for axis in range(3):
                    v = wanted[axis]
                    holds1 = np.asarray(np.isfinite(v) & (np.abs(v) <= u_max[axis]))
                    holds2 = np.asarray(np.isfinite(x[..., axis, 0]) & np.isfinite(x[..., axis, 1]))
                    holds3 = np.asarray(np.isfinite(v))
                    holds4 = np.asarray(u_max[axis] < v)
                    u[axis] = np.where(holds4 & holds3 & holds2 & ~holds1 & holds, u_max[axis], u[axis])
                    axes[axis] = np.where(holds4 & holds3 & holds2 & ~holds1 & holds, Status.SATURATED, axes[axis])
                    u[axis] = np.where(~holds4 & holds3 & holds2 & ~holds1 & holds, -u_max[axis], u[axis])
                    axes[axis] = np.where(~holds4 & holds3 & holds2 & ~holds1 & holds, Status.SATURATED, axes[axis])
                    axes[axis] = np.where(~holds3 & holds2 & ~holds1 & holds, Status.RANGE, axes[axis])
                    axes[axis] = np.where(~holds2 & ~holds1 & holds, Status.INPUT, axes[axis])
                    holds2 = np.asarray(status >= Status.OK)
                    status = np.where(holds2 & ~holds1 & holds, axes[axis], status)
                holds1 = np.asarray(status < Status.OK)
                for axis in range(3):
                    u[axis] = np.where(holds1 & holds, np.asarray(_R(0.0)), u[axis])
            legal = np.isfinite(t) & (t >= self._t0)
            axes = [np.where(legal, each, Status.INPUT) for each in axes]
            status = np.where(legal, status, Status.INPUT)
            every = np.broadcast_arrays(*u, *axes, status)
            given = np.stack(every[:3], axis=-1)
            return Axes(
                np.where((status < 0)[..., np.newaxis], _R(0.0), given),
                np.stack(every[3:-1], axis=-1).astype(np.int8),
                every[-1].astype(np.int8),
            )
