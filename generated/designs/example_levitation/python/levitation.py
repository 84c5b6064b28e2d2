"""
Prescribed-time controller levitation: order n = 3, mapping exp.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name levitation --eps=1e-3 --poles=-4,-5,-6 --states="z, v, i" --input=u --output="z" --dynamics="v, grav*(1 - ((1 + i/i0)/(1 + z/z0))^2), (u - R*i)/L" --param grav=9.81 --param "i0=[0.1,5]" --param "z0=[5e-3,2e-2]" --x-max=2e-3,1,0.05
Version 0.1.0, design 44fd77ede031.

Plant, with the input u: z' = v, v' = grav*(1 - ((1 + i/i0)/(1 + z/z0))^2), i' = (u -
      R*i)/L, output z. Time in s.
Goal: the output and its first 2 derivatives, x, are 0 at the deadline t0 + tau from any
      state at t0, up to the error that the hold at eps, sampling, what differs from the
      model and clipping leave. The checks below say what is known of this design.
The law takes the plant to be the model. What differs from it is not part of the law.

SAMPLE PERIOD NOT GIVEN: the held gains grow as eps falls, and the loop is stable only for
      sample periods below a limit that depends on eps and the gains. ptc-codegen check
      finds it once tau, eps, the gains and --sample-time are given.

Parameters:
  eps = 1e-3 [s], fixed: time-to-go at which the gains are held
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 120 [1/s^3], fixed: gain of xi_1
  k_2 = 74 [1/s^2], fixed: gain of xi_2
  k_3 = 15 [1/s], fixed: gain of xi_3
  grav = 9.81, fixed: parameter of the model
  tau: prescribed settling time [s], from 1e-150 to 1e150
  t0: start time [s], finite
  u_max: bound of |u| [unit of u], > 0, infinity allowed
  L: parameter of the model, finite
  R: parameter of the model, finite
  i0: parameter of the model, from 0.1 to 5
  z0: parameter of the model, from 5e-3 to 2e-2

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
  x_1 = z
  x_2 = v
  x_3 = grav*(1 - ((1 + i/i0)/(1 + z/z0))^2)
  f = grav*-(2*((1 + i/i0)/(1 + z/z0))*((-R*i/L/i0*(1 + z/z0) - (1 + i/i0)*(v/z0))/(1 +
      z/z0)^2))
  g = -2*grav*z0^2*(i0 + i)/(L*i0^2*(z0 + z)^2)
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
  loop: not checked: it needs a value of `tau`.
  envelope: not checked: `tau` is left to run time without bounds.
  zeros: sound: none: the relative degree is 3, the number of states.

Operations of one step, without input checks and clipping: 14 additions or comparisons, 15
      multiplications, 6 divisions.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Levitation", "Params", "Status"]

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
    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""
    L: float
    """parameter of the model, finite"""
    R: float
    """parameter of the model, finite"""
    i0: float
    """parameter of the model, from 0.1 to 5"""
    z0: float
    """parameter of the model, from 5e-3 to 2e-2"""

def _states(x: ArrayLike, name: str) -> tuple[Array, ...]:
    """The states along the last axis, one by one."""
    states = np.asarray(x, dtype=_R)
    if states.ndim == 0 or states.shape[-1] != 3:
        raise ValueError(f"{name} has shape {states.shape}; legal: (..., 3), the states along the last axis")
    return tuple(np.moveaxis(states, -1, 0))

class Levitation:
    """The controller. Takes the parameters and arms at params.t0 (or the fixed t0).

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_tau = _R(params.tau)
            given_t0 = _R(params.t0)
            given_u_max = _R(params.u_max)
            given_L = _R(params.L)
            given_R = _R(params.R)
            given_i0 = _R(params.i0)
            given_z0 = _R(params.z0)
            tau = given_tau
            t0 = given_t0
            u_max = given_u_max
            p_L = given_L
            p_R = given_R
            p_i0 = given_i0
            p_z0 = given_z0
            if not (np.isfinite(tau) and (1e-150 <= tau <= 1e150)):
                raise ValueError(f"params.tau is {params.tau}; legal: from 1e-150 to 1e150")
            if not np.isfinite(t0):
                raise ValueError(f"params.t0 is {params.t0}; legal: finite")
            if not (u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            if not np.isfinite(p_L):
                raise ValueError(f"params.L is {params.L}; legal: finite")
            if not np.isfinite(p_R):
                raise ValueError(f"params.R is {params.R}; legal: finite")
            if not (0.1 <= p_i0 <= 5.0):
                raise ValueError(f"params.i0 is {params.i0}; legal: from 0.1 to 5")
            if not (0.005 <= p_z0 <= 0.02):
                raise ValueError(f"params.z0 is {params.z0}; legal: from 0.005 to 0.02")
            if not (tau > 0.001):
                raise ValueError(f"params.tau is {params.tau}; legal: > 0.001")
            f42 = p_L * (p_i0 * p_i0)
            f53 = -p_L
            size_f42 = _R(1e-200) if np.abs(p_L) <= 0.0 else np.abs(f42)
            size_f53 = _R(1e-200) if np.abs(p_L) <= 0.0 else np.abs(f53)
            size_p_R = _R(1e-200) if np.abs(p_R) <= 0.0 else np.abs(p_R)
            f49 = (-19.62) * (p_z0 * p_z0)
            f56 = p_R * p_z0
            f61 = f53 * p_i0
            if not (
                (size_f42 >= 1e-200)
                and (size_f53 >= 1e-200)
                and (size_p_R >= 1e-200)
                and np.isfinite(f42)
                and np.isfinite(f49)
                and np.isfinite(f53)
                and np.isfinite(f56)
                and np.isfinite(f61)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._tau = tau
            self._p_i0 = p_i0
            self._p_z0 = p_z0
            self._f42 = f42
            self._f49 = f49
            self._f53 = f53
            self._p_R = p_R
            self._f56 = f56
            self._f61 = f61
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
        """u at time t [s] and state x = (z, v, i).

        Each argument may be a batch; states stand along the last axis.
        """
        t = np.asarray(t, dtype=_R)
        x1, x2, x3 = _states(x, "x")
        with np.errstate(all="ignore"):
            past = (t - self._deadline) - self._correction
            late = np.where(past < -0.001, past, -0.001)
            inv_T = (-1.0) / late
            v1 = (1.0 + (x3 / self._p_i0)) / (1.0 + (x1 / self._p_z0))
            v2 = self._p_z0 + x1
            s1 = (((-120.0) * x1 * inv_T) + ((-60.0) * x2)) * inv_T
            s2 = (s1 + ((-117.72) * (1.0 - (v1 * v1)))) * inv_T
            v3 = s2 * (self._f42 * (v2 * v2))
            numerator = self._f49 * (self._p_i0 + x3)
            s3 = (((self._f53 * x2) - self._f56) - (self._p_R * x1)) * x3
            drift = (s3 + (self._f61 * x2)) / v2
            s4 = np.where((numerator < 0.0) | (numerator > 0.0), v3 / numerator, _R(np.nan))
            v = s4 - drift
            way1 = np.isfinite(v) & (np.abs(v) <= self._u_max) & (late < -0.001)
            way2 = np.isfinite(t) & np.isfinite(x1) & np.isfinite(x2) & np.isfinite(x3)
            way3 = np.isfinite(v)
            way4 = v > self._u_max
            way5 = v < -self._u_max
            status = np.where(t >= self._t0, np.where(way1, Status.OK, np.where(way2, np.where(way3, np.where(way4, Status.SATURATED, np.where(way5, Status.SATURATED, Status.HOLD)), Status.RANGE), Status.INPUT)), Status.INPUT)
            return Control(np.where(status < 0, _R(0.0), np.where(way1, v, np.where(way4, self._u_max, np.where(way5, -self._u_max, v)))), status.astype(np.int8))
