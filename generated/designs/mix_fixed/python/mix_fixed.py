"""
Prescribed-time controller mix_fixed: outputs of order 2, 1, mapping exp.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --mu "exp(a=1)" --name mix_fixed --guard result --tau=1 --eps=1e-2 --limits=40,15 --poles="[[-4,-5],[-3]]" --states="p, v, h" --inputs=a,b --outputs="p, h" --dynamics="v, -v + (2 + sin(p))*a + h*b, v*h + h*a + (2 + h^2)*b"
Version 0.1.0, design 63889dce100a.

Plant, with the inputs a, b: p' = v, v' = -v + (2 + sin(p))*a + h*b, h' = v*h + h*a + (2 +
      h^2)*b, output 1 = p, output 2 = h. Time in s.
Goal: every output with its derivatives is 0 at the deadline t0 + tau from any state at t0,
      up to the error that the hold at eps, sampling, what differs from the model and
      clipping leave. The checks below say what is known of this design.
The law takes the plant to be the model. What differs from it is not part of the law.
Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
      input of this number.
  output 1: k = 20, 9; u_max = 40
  output 2: k = 3; u_max = 15

SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
      is stable. Run the emitted step with a model of the plant, sampled.

Parameters:
  tau = 1 [s], fixed: prescribed settling time
  eps = 1e-2 [s], fixed: time-to-go at which the gains are held
  a = 1 [1/s], fixed: rate of stretched time
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

Law of each output, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
  v_i = kappa'^n (pi0(xi, t_kappa) - b_n^T x) = sum_j gain_j x_j
Order n = 1:
  pi0 = -k_1 xi_1
  gain_j = inv_T^(n+1-j) row_j
  K1, K2, ...: K_i = k_i/a^(n+1-i)
  row_1 = -K1
  inv_T = 1/T
Order n = 2:
  pi0 = -(k_1 xi_1 + k_2 xi_2)
  gain_j = inv_T^(n+1-j) row_j
  K1, K2, ...: K_i = k_i/a^(n+1-i)
  row_1 = -K1
  row_2 = 1 - K2
  inv_T = 1/T
Output 1, of order n = 2:
  x_1 = p
  x_2 = v
  f_1 = -v
Output 2, of order n = 1:
  x_1 = h
  f_2 = v*h
u = adj(D) w/det(D) with w_i = v_i - f_i:
  det(D) = (2 + sin(p))*(2 + h^2) - h*h
  adj(D) = [[2 + h^2, -h], [-h, 2 + sin(p)]]

From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
      deadline.
Guard result: t or x that is not finite is refused by one test on u (RANGE). t >= t0 is the
      responsibility of the caller.
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
      mathematical library.

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: x and u go to 0 at the deadline.
  sampling: not checked: `sample_time` is not given.
  deadline: not checked: `error` is not given.
  loop: not checked: `sample_time` is not given.
  envelope: not checked: `x_max` is not given.
  zeros: sound: none: the relative degrees are 2, 1, whose sum is the number of states.

Operations of one step, without input checks and clipping: 13 additions or comparisons, 15
      multiplications, 2 divisions, 1 function call.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Axes", "Control", "MixFixed", "Params", "Status"]

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
    if states.ndim == 0 or states.shape[-1] != 3:
        raise ValueError(f"{name} has shape {states.shape}; legal: (..., 3), the states along the last axis")
    return tuple(np.moveaxis(states, -1, 0))

class MixFixed:
    """The controller. Takes the parameters and arms at params.t0 (or the fixed t0).

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_t0 = _R(params.t0)
            t0 = given_t0
            if not np.isfinite(t0):
                raise ValueError(f"params.t0 is {params.t0}; legal: finite")
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
            self._deadline = deadline
            self._correction = correction

    def step(self, t: ArrayLike, x: ArrayLike) -> Axes:
        """u = (a, b) at time t [s] and state x = (p, v, h). Where one of them is not finite, as at
        a state at which the inputs do not decouple the outputs, every u is 0; else the status is
        SATURATED where one was clipped.

        Each argument may be a batch; states stand along the last axis.
        """
        t = np.asarray(t, dtype=_R)
        x1, x2, x3 = _states(x, "x")
        with np.errstate(all="ignore"):
            u: list[Array] = [np.asarray(_R(0.0))] * 2
            axes = [np.asarray(Status.OK)] * 2
            past = (t - self._deadline) - self._correction
            late = np.where(past < -0.01, past, -0.01)
            inv_T_axis1 = (-1.0) / late
            drift_axis1 = -x2
            s1 = (((-20.0) * x1 * inv_T_axis1) + ((-8.0) * x2)) * inv_T_axis1
            wanted_axis1 = s1 - drift_axis1
            drift_axis2 = x2 * x3
            wanted_axis2 = ((-3.0) * x3 * inv_T_axis1) - drift_axis2
            v1 = 2.0 + np.sin(x1)
            v2 = x3 * x3
            v3 = 2.0 + v2
            determinant = (v1 * v3) - v2
            over_determinant = np.where((determinant < 0.0) | (determinant > 0.0), 1.0 / determinant, _R(np.nan))
            v4 = -x3
            s2 = ((v3 * wanted_axis1) + (v4 * wanted_axis2)) * over_determinant
            control1 = s2 + (t - t)
            s3 = ((v4 * wanted_axis1) + (v1 * wanted_axis2)) * over_determinant
            control2 = s3 + (t - t)
            status = np.asarray(Status.HOLD)
            chosen = np.asarray(late < -0.01)
            if chosen.any():
                status = np.where(chosen, Status.OK, status)
            holds = np.asarray(np.isfinite(control1) & np.isfinite(control2))
            u[0] = np.where(holds, control1, u[0])
            axes[0] = np.where(holds, status, axes[0])
            u[1] = np.where(holds, control2, u[1])
            axes[1] = np.where(holds, status, axes[1])
            holds1 = np.asarray(control1 > 40.0)
            u[0] = np.where(holds1 & holds, np.asarray(_R(40.0)), u[0])
            axes[0] = np.where(holds1 & holds, Status.SATURATED, axes[0])
            status = np.where(holds1 & holds, Status.SATURATED, status)
            holds2 = np.asarray(control1 < -40.0)
            u[0] = np.where(holds2 & ~holds1 & holds, _R(-40.0), u[0])
            axes[0] = np.where(holds2 & ~holds1 & holds, Status.SATURATED, axes[0])
            status = np.where(holds2 & ~holds1 & holds, Status.SATURATED, status)
            holds1 = np.asarray(control2 > 15.0)
            u[1] = np.where(holds1 & holds, np.asarray(_R(15.0)), u[1])
            axes[1] = np.where(holds1 & holds, Status.SATURATED, axes[1])
            status = np.where(holds1 & holds, Status.SATURATED, status)
            holds2 = np.asarray(control2 < -15.0)
            u[1] = np.where(holds2 & ~holds1 & holds, _R(-15.0), u[1])
            axes[1] = np.where(holds2 & ~holds1 & holds, Status.SATURATED, axes[1])
            status = np.where(holds2 & ~holds1 & holds, Status.SATURATED, status)
            u[0] = np.where(~holds, np.asarray(_R(0.0)), u[0])
            chosen = np.where(np.isfinite(control1), status, Status.RANGE)
            axes[0] = np.where(~holds, chosen, axes[0])
            u[1] = np.where(~holds, np.asarray(_R(0.0)), u[1])
            chosen = np.where(np.isfinite(control2), status, Status.RANGE)
            axes[1] = np.where(~holds, chosen, axes[1])
            status = np.where(~holds, Status.RANGE, status)
            every = np.broadcast_arrays(*u, *axes, status)
            given = np.stack(every[:2], axis=-1)
            return Axes(
                np.where((status < 0)[..., np.newaxis], _R(0.0), given),
                np.stack(every[2:-1], axis=-1).astype(np.int8),
                every[-1].astype(np.int8),
            )
