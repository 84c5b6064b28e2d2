"""
Prescribed-time controller two_link: outputs of order 2, 2, mapping rational.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --mu "rational(a=1/20)" --name two_link --tau=20 --eps=1 --limits=120,60 --poles=-1,-1.5 --states="q1, q2, w1, w2" --inputs=M1,M2 --inertia="[[(m1 + m2)*l1^2 + m2*l2^2 + 2*m2*l1*l2*cos(q2), m2*l2^2 + m2*l1*l2*cos(q2)], [m2*l2^2 + m2*l1*l2*cos(q2), m2*l2^2]]" --bias="-m2*l1*l2*sin(q2)*(2*w1*w2 + w2^2) + (m1 + m2)*grav*l1*cos(q1) + m2*grav*l2*cos(q1 + q2), m2*l1*l2*sin(q2)*w1^2 + m2*grav*l2*cos(q1 + q2)" --param grav=9.81 --param l1=0.6 --param l2=0.5 --param m1=2 --param m2=1.5
Version 0.1.0, design cf1990ed927f.

Plant, with the inputs M1, M2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[(m1 +
      m2)*l1^2 + m2*l2^2 + 2*m2*l1*l2*cos(q2), m2*l2^2 + m2*l1*l2*cos(q2)], [m2*l2^2 +
      m2*l1*l2*cos(q2), m2*l2^2]], bias = [-m2*l1*l2*sin(q2)*(2*w1*w2 + w2^2) + (m1 +
      m2)*grav*l1*cos(q1) + m2*grav*l2*cos(q1 + q2), m2*l1*l2*sin(q2)*w1^2 +
      m2*grav*l2*cos(q1 + q2)]. Time in s.
Goal: every output with its derivatives is 0 at the deadline t0 + tau from any state at t0,
      up to the error that the hold at eps, sampling, what differs from the model and
      clipping leave. The checks below say what is known of this design.
The law takes the plant to be the model. What differs from it is not part of the law.
Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
      input of this number.
  output 1: u_max = 120
  output 2: u_max = 60

SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
      is stable. Run the emitted step with a model of the plant, sampled.

Parameters:
  tau = 20 [s], fixed: prescribed settling time
  eps = 1 [s], fixed: time-to-go at which the gains are held
  a = 1/20 [1/s], fixed: rate of stretched time
  k_1 = 1.5 [1/s^2], fixed: gain of xi_1
  k_2 = 2.5 [1/s], fixed: gain of xi_2
  grav = 9.81, fixed: parameter of the model
  l1 = 0.6, fixed: parameter of the model
  l2 = 0.5, fixed: parameter of the model
  m1 = 2, fixed: parameter of the model
  m2 = 1.5, fixed: parameter of the model
  t0: start time [s], finite

Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
      the stretched time since t0:
  mu(t)     = tau*a*t/(1 + a*t)
  kappa(Dt) = Dt/(a*T)
Derivatives r_k = mu^(k)(kappa(Dt)):
  r_k = (-1)^(k-1) k! (a/tau)^k T^(k+1)
  r_1 = tau^-1*a*T^2
  r_2 = -2*tau^-2*a^2*T^3
Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
  B_{0,0} = 1
  B_{1,1} = tau^-1*a*T^2
  B_{2,1} = -2*tau^-2*a^2*T^3

Law of each output, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
  v_i = kappa'^n (pi0(xi, t_kappa) - b_n^T x) = sum_j gain_j x_j
  pi0 = -(k_1 xi_1 + k_2 xi_2)
  gain_j = inv_T_squared^(n+1-j) row_j
  K1, K2, ...: K_i = k_i/(tau^-1*a)^(n+1-i)
  row_1 = -K1
  row_2 = -K2 + 2*T
  inv_T_squared = 1/T^2
Output 1, of order n = 2:
  x_1 = q1
  x_2 = w1
Output 2, of order n = 2:
  x_1 = q2
  x_2 = w2
u = M v + bias

From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
      deadline.
Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
      mathematical library.

Checks of the design (details: ptc-codegen check):
  membership: sound: rational is of class M for all its parameters.
  growth: sound: x and u go to 0 at the deadline.
  sampling: not checked: `sample_time` is not given.
  deadline: not checked: `error` is not given.
  loop: not checked: `sample_time` is not given.
  envelope: not checked: `x_max` is not given.
  zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.

Operations of one step, without input checks and clipping: 17 additions or comparisons, 26
      multiplications, 1 division, 4 function calls.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Axes", "Control", "Params", "Status", "TwoLink"]

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

    t0: float = 0.0
    """start time [s], finite"""

def _states(x: ArrayLike, name: str) -> tuple[Array, ...]:
    """The states along the last axis, one by one."""
    states = np.asarray(x, dtype=_R)
    if states.ndim == 0 or states.shape[-1] != 4:
        raise ValueError(f"{name} has shape {states.shape}; legal: (..., 4), the states along the last axis")
    return tuple(np.moveaxis(states, -1, 0))

class TwoLink:
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
            deadline = t0 + 20.0
            v1 = deadline - t0
            correction = (t0 - (deadline - v1)) + (20.0 - v1)
            if not np.isfinite(deadline):
                raise ValueError("t0, and what follows, must be finite")
            self._t0 = t0
            self._deadline = deadline
            self._correction = correction

    def step(self, t: ArrayLike, x: ArrayLike) -> Axes:
        """u = (M1, M2) at time t [s] and state x = (q1, q2, w1, w2). Where one of them is not
        finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else
        the status is SATURATED where one was clipped.

        Each argument may be a batch; states stand along the last axis.
        """
        t = np.asarray(t, dtype=_R)
        x1, x2, x3, x4 = _states(x, "x")
        with np.errstate(all="ignore"):
            u: list[Array] = [np.asarray(_R(0.0))] * 2
            axes = [np.asarray(Status.OK)] * 2
            past = (t - self._deadline) - self._correction
            late = np.where(past < -1.0, past, -1.0)
            row2_axis1 = ((-2.0) * late) - 1000.0
            inv_T_squared_axis1 = 1.0 / (late * late)
            s1 = ((-240000.0) * x1 * inv_T_squared_axis1) + (row2_axis1 * x3)
            wanted_axis1 = s1 * inv_T_squared_axis1
            s2 = ((-240000.0) * x2 * inv_T_squared_axis1) + (row2_axis1 * x4)
            wanted_axis2 = s2 * inv_T_squared_axis1
            v1 = np.sin(x2)
            v2 = 7.3575 * np.cos(x1 + x2)
            v3 = np.cos(x2)
            v4 = 0.375 + (0.44999999999999996 * v3)
            s3 = (1.635 + (0.8999999999999999 * v3)) * wanted_axis1
            s4 = (-0.44999999999999996) * v1 * ((2.0 * x3 * x4) + (x4 * x4))
            control1 = s3 + (v4 * wanted_axis2) + (s4 + (20.601 * np.cos(x1)) + v2)
            s5 = (v4 * wanted_axis1) + (0.375 * wanted_axis2)
            control2 = s5 + ((0.44999999999999996 * v1 * (x3 * x3)) + v2)
            status = np.asarray(Status.HOLD)
            chosen = np.asarray(late < -1.0)
            if chosen.any():
                status = np.where(chosen, Status.OK, status)
            holds = np.asarray(np.isfinite(control1) & np.isfinite(control2))
            u[0] = np.where(holds, control1, u[0])
            axes[0] = np.where(holds, status, axes[0])
            u[1] = np.where(holds, control2, u[1])
            axes[1] = np.where(holds, status, axes[1])
            holds1 = np.asarray(control1 > 120.0)
            u[0] = np.where(holds1 & holds, np.asarray(_R(120.0)), u[0])
            axes[0] = np.where(holds1 & holds, Status.SATURATED, axes[0])
            status = np.where(holds1 & holds, Status.SATURATED, status)
            holds2 = np.asarray(control1 < -120.0)
            u[0] = np.where(holds2 & ~holds1 & holds, _R(-120.0), u[0])
            axes[0] = np.where(holds2 & ~holds1 & holds, Status.SATURATED, axes[0])
            status = np.where(holds2 & ~holds1 & holds, Status.SATURATED, status)
            holds1 = np.asarray(control2 > 60.0)
            u[1] = np.where(holds1 & holds, np.asarray(_R(60.0)), u[1])
            axes[1] = np.where(holds1 & holds, Status.SATURATED, axes[1])
            status = np.where(holds1 & holds, Status.SATURATED, status)
            holds2 = np.asarray(control2 < -60.0)
            u[1] = np.where(holds2 & ~holds1 & holds, _R(-60.0), u[1])
            axes[1] = np.where(holds2 & ~holds1 & holds, Status.SATURATED, axes[1])
            status = np.where(holds2 & ~holds1 & holds, Status.SATURATED, status)
            u[0] = np.where(~holds, np.asarray(_R(0.0)), u[0])
            chosen = np.where(np.isfinite(control1), status, Status.RANGE)
            axes[0] = np.where(~holds, chosen, axes[0])
            u[1] = np.where(~holds, np.asarray(_R(0.0)), u[1])
            chosen = np.where(np.isfinite(control2), status, Status.RANGE)
            axes[1] = np.where(~holds, chosen, axes[1])
            status = np.where(~holds, Status.RANGE, status)
            legal = np.isfinite(t) & (t >= self._t0) & np.isfinite(x1) & np.isfinite(x2) & np.isfinite(x3) & np.isfinite(x4)
            axes = [np.where(legal, each, Status.INPUT) for each in axes]
            status = np.where(legal, status, Status.INPUT)
            every = np.broadcast_arrays(*u, *axes, status)
            given = np.stack(every[:2], axis=-1)
            return Axes(
                np.where((status < 0)[..., np.newaxis], _R(0.0), given),
                np.stack(every[2:-1], axis=-1).astype(np.int8),
                every[-1].astype(np.int8),
            )
