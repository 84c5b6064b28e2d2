"""
Prescribed-time controller duration: order n = 3, mapping tan.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu tan --name duration --in-flight --precision f32 --u-max=100 --poles=-4,-5,-6
Version 0.1.0, design 3d20bda1c4e1.

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
  u_max = 100 [unit of u], fixed: bound of |u|
  k_1 = 120 [1/s^3], fixed: gain of xi_1
  k_2 = 74 [1/s^2], fixed: gain of xi_2
  k_3 = 15 [1/s], fixed: gain of xi_3
  tau: prescribed settling time [s], from 1e-18 to 1e18
  t0: start time [s], finite
  eps: time-to-go at which the gains are held [s], >= 1e-18, < tau
  a: rate of stretched time [1/s], from 1e-18 to 1e18

Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
      the stretched time since t0:
  mu(t)     = (2*tau/pi)*atan(a*t)
  kappa(Dt) = cot(th)/a, th = pi*T/(2*tau)
  in terms of y = cot(th), V = 1/(1 + y^2)
Derivatives r_k = mu^(k)(kappa(Dt)):
  r_k = (-1)^(k-1) (k-1)! (2*tau/pi) a^k sin(k*th) sin(th)^k
  r_1 = 2*pi^-1*tau*a*V
  r_2 = -4*pi^-1*tau*a^2*y*V^2
  r_3 = 12*pi^-1*tau*a^3*y^2*V^3 - 4*pi^-1*tau*a^3*V^3
Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
  B_{0,0} = 1
  B_{1,1} = 2*pi^-1*tau*a*V
  B_{2,1} = -4*pi^-1*tau*a^2*y*V^2
  B_{2,2} = 4*pi^-2*tau^2*a^2*V^2
  B_{3,1} = 12*pi^-1*tau*a^3*y^2*V^3 - 4*pi^-1*tau*a^3*V^3
  B_{3,2} = -24*pi^-2*tau^2*a^3*y*V^3

Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
  u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
  pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
  u = sum_j gain_j x_j
  gain_j = row_j
  K1, K2, ...: K_i = k_i/a^(n+1-i)
  row_1 = -K1*slope^3
  row_2 = -4*pi^-2*tau^2*K2*cot_rate^4 + 4*pi^-1*tau*K3*cot_rate^3 + pi*tau^-1*K3*cot_rate
      + 1/2*pi^2*tau^-2 - 1/4*pi^2*tau^-2*K2 - 2*K2*cot_rate^2 - 6*cot_rate^2
  row_3 = -2*pi^-1*tau*K3*cot_rate^2 - 1/2*pi*tau^-1*K3 + 6*cot_rate
  cot_rate = (pi/(2*tau))*y = (pi/(2*tau))*cot(th)
  slope = (pi/(2*tau))*(1 + y^2) = kappa'/a

From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
In flight: arm_for starts again at t0 for another tau, at any time, and computes what
      follows from tau. arm keeps the tau last used: at first that of the parameters.
|u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
      deadline.
Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: tan is of class M for all its parameters.
  growth: sound: x and u go to 0 at the deadline.
  sampling: not checked: `sample_time` is not given.
  deadline: not checked: `error` is not given.
  loop: not checked: it needs a value of `tau`.
  envelope: not checked: `x_max` is not given.

Operations of one step, without input checks and clipping: 21 additions or comparisons, 28
      multiplications, 1 division.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Duration", "Gains", "Params", "Status"]

_R = np.float32
Array = NDArray[np.float32]

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
    """prescribed settling time [s], from 1e-18 to 1e18"""
    t0: float = 0.0
    """start time [s], finite"""
    eps: float
    """time-to-go at which the gains are held [s], >= 1e-18, < tau"""
    a: float
    """rate of stretched time [1/s], from 1e-18 to 1e18"""

def _states(x: ArrayLike, name: str) -> tuple[Array, ...]:
    """The states along the last axis, one by one."""
    states = np.asarray(x, dtype=_R)
    if states.ndim == 0 or states.shape[-1] != 3:
        raise ValueError(f"{name} has shape {states.shape}; legal: (..., 3), the states along the last axis")
    return tuple(np.moveaxis(states, -1, 0))

class Gains:
    """Feedback gains at one or more times."""

    def __init__(self, gain: Array, status: NDArray[np.int8]) -> None:
        self.gain = gain
        """u = gain[0] x[0] + ... + gain[2] x[2]; shape (..., 3)"""
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
            way1 = np.isfinite(v) & (np.abs(v) <= _R(100.0))
            way2 = np.isfinite(x1) & np.isfinite(x2) & np.isfinite(x3)
            way3 = np.isfinite(v)
            way4 = v > _R(100.0)
            status = np.where(way1, self.status, np.where(way2, np.where(way3, np.where(way4, Status.SATURATED, Status.SATURATED), Status.RANGE), Status.INPUT))
            status = np.where(self.status < 0, self.status, status)
            return Control(np.where(status < 0, _R(0.0), np.where(way1, v, np.where(way4, _R(100.0), -_R(100.0)))), status.astype(np.int8))

class Duration:
    """The controller. Takes the parameters and arms at params.t0 (or the fixed t0) for params.tau.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_tau = _R(params.tau)
            given_t0 = _R(params.t0)
            given_eps = _R(params.eps)
            given_a = _R(params.a)
            tau = given_tau
            t0 = given_t0
            eps = given_eps
            a = given_a
            if not (
                np.isfinite(tau)
                and (_R(1.000000045813705e-18) <= tau <= _R(9.999999843067494e17))
            ):
                raise ValueError(f"params.tau is {params.tau}; legal: from 1.000000045813705e-18 to 9.999999843067494e17")
            if not np.isfinite(t0):
                raise ValueError(f"params.t0 is {params.t0}; legal: finite")
            if not (eps >= _R(1.000000045813705e-18)):
                raise ValueError(f"params.eps is {params.eps}; legal: >= 1.000000045813705e-18")
            if not (
                np.isfinite(a)
                and (_R(1.000000045813705e-18) <= a <= _R(9.999999843067494e17))
            ):
                raise ValueError(f"params.a is {params.a}; legal: from 1.000000045813705e-18 to 9.999999843067494e17")
            if not (eps < tau):
                raise ValueError(f"params.eps is {params.eps}; legal: < tau")
            v1 = a * a
            v2 = a * v1
            K1 = _R(120.0) / v2
            K2 = _R(74.0) / v1
            K3 = _R(15.0) / a
            c1_3 = -K1
            hold_from = -eps
            c2_2 = (-(_R(2.0) * K2)) - _R(6.0)
            f69 = (-(_R(2.4674010276794434) * K2)) + _R(4.934802055358887)
            f73 = _R(3.1415927410125732) * K3
            f81 = _R(1.2732394933700562) * K3
            f85 = -(_R(0.40528473258018494) * K2)
            f99 = -(_R(1.5707963705062866) * K3)
            f103 = -(_R(0.6366197466850281) * K3)
            if not (
                (v2 >= _R(1.0000000031710769e-30))
                and (K1 >= _R(1.0000000031710769e-30))
                and np.isfinite(c1_3)
                and np.isfinite(hold_from)
                and np.isfinite(f69)
                and np.isfinite(f73)
                and np.isfinite(c2_2)
                and np.isfinite(f81)
                and np.isfinite(f85)
                and np.isfinite(f99)
                and np.isfinite(f103)
            ):
                raise ValueError("the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1")
            self._c1_3 = c1_3
            self._eps = eps
            self._hold_from = hold_from
            self._f69 = f69
            self._f73 = f73
            self._c2_2 = c2_2
            self._f81 = f81
            self._f85 = f85
            self._f99 = f99
            self._f103 = f103
            self._tau = _R(0.0)
            self._angle_rate = _R(0.0)
            self._inv_angle_rate = _R(0.0)
            self._t0 = _R(0.0)
            self._deadline = _R(0.0)
            self._correction = _R(0.0)
            self._inv_tau = _R(0.0)
            self._c2_0 = _R(0.0)
            self._c2_1 = _R(0.0)
            self._c2_3 = _R(0.0)
            self._c2_4 = _R(0.0)
            self._c3_0 = _R(0.0)
            self._c3_2 = _R(0.0)
        self.arm_for(t0, tau)

    def arm(self, t0: float | np.float32) -> None:
        """Starts again at t0 [s], with the tau last used.

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

    def arm_for(self, t0: float | np.float32, tau: float | np.float32) -> None:
        """Starts again at t0 [s] with another duration tau [s]: the deadline is t0 + tau.

        ValueError where an argument or what follows from it is not finite, or tau is outside its
        domain; the controller is left as it was.
        """
        with np.errstate(all="ignore"):
            t0 = _R(t0)
            tau = _R(tau)
            if not (
                np.isfinite(t0)
                and np.isfinite(tau)
                and (_R(1.000000045813705e-18) <= tau <= _R(9.999999843067494e17))
                and (tau > self._eps)
            ):
                raise ValueError("t0 and tau, and what follows, must be finite, and tau within its domain")
            angle_rate = _R(1.5707963705062866) / tau
            inv_angle_rate = _R(0.6366197466850281) * tau
            deadline = t0 + tau
            v1 = deadline - t0
            correction = (t0 - (deadline - v1)) + (tau - v1)
            inv_tau = _R(1.0) / tau
            v2 = tau * tau
            c2_0 = self._f69 / v2
            c2_1 = self._f73 / tau
            c2_3 = self._f81 * tau
            c2_4 = self._f85 * v2
            c3_0 = self._f99 / tau
            c3_2 = self._f103 * tau
            if not (
                np.isfinite(deadline)
                and (c2_4 <= -_R(1.0000000031710769e-30))
                and np.isfinite(angle_rate)
                and np.isfinite(inv_angle_rate)
                and np.isfinite(inv_tau)
                and np.isfinite(c2_0)
                and np.isfinite(c2_1)
                and np.isfinite(c2_3)
                and np.isfinite(c2_4)
                and np.isfinite(c3_0)
                and np.isfinite(c3_2)
            ):
                raise ValueError("t0 and tau, and what follows, must be finite, and tau within its domain")
            self._tau = tau
            self._angle_rate = angle_rate
            self._inv_angle_rate = inv_angle_rate
            self._t0 = t0
            self._deadline = deadline
            self._correction = correction
            self._inv_tau = inv_tau
            self._c2_0 = c2_0
            self._c2_1 = c2_1
            self._c2_3 = c2_3
            self._c2_4 = c2_4
            self._c3_0 = c3_0
            self._c3_2 = c3_2

    def step(self, t: ArrayLike, x: ArrayLike) -> Control:
        """u at time t [s] and state x = (x1, x1', ...).

        Each argument may be a batch; states stand along the last axis.
        """
        t = np.asarray(t, dtype=_R)
        x1, x2, x3 = _states(x, "x")
        with np.errstate(all="ignore"):
            past = (t - self._deadline) - self._correction
            late = np.where(past < self._hold_from, past, self._hold_from)
            v1 = late * self._inv_tau
            inv_T_squared = _R(1.0) / (late * late)
            v2 = v1 * v1
            s1 = (((((-_R(9.254479664377868e-5)) * v2) - _R(7.244605360057221e-9)) * v2) - _R(0.0006016576080583036)) * v2
            s2 = ((((s1 - _R(0.001899098395369947)) * v2) - _R(0.007859068922698498)) * v2) - _R(0.03179009631276131)
            th_cot_th = (((((s2 * v2) - _R(0.1352904886007309)) * v2) - _R(0.822467029094696)) * v2) + _R(1.0)
            cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th)
            slope = self._angle_rate + (self._inv_angle_rate * cot_rate_squared)
            row1 = self._c1_3 * slope * slope * slope
            T = -late
            cot_rate = T * inv_T_squared * th_cot_th
            s3 = (self._c2_4 * cot_rate_squared) + self._c2_2
            s4 = ((self._c2_3 * cot_rate_squared) + self._c2_1) * cot_rate
            row2 = (s3 * cot_rate_squared) + self._c2_0 + s4
            row3 = (self._c3_2 * cot_rate_squared) + self._c3_0 + (_R(6.0) * cot_rate)
            v = (row1 * x1) + (row2 * x2) + (row3 * x3)
            way1 = np.isfinite(v) & (np.abs(v) <= _R(100.0)) & (late < self._hold_from)
            way2 = np.isfinite(t) & np.isfinite(x1) & np.isfinite(x2) & np.isfinite(x3)
            way3 = np.isfinite(v)
            way4 = v > _R(100.0)
            way5 = v < -_R(100.0)
            status = np.where(t >= self._t0, np.where(way1, Status.OK, np.where(way2, np.where(way3, np.where(way4, Status.SATURATED, np.where(way5, Status.SATURATED, Status.HOLD)), Status.RANGE), Status.INPUT)), Status.INPUT)
            return Control(np.where(status < 0, _R(0.0), np.where(way1, v, np.where(way4, _R(100.0), np.where(way5, -_R(100.0), v)))), status.astype(np.int8))

    def tick(self, t: ArrayLike) -> Gains:
        """The gains at time t [s], for several axes that share one deadline: tick once, then axis
        for each. The result of tick and axis may differ from that of step in the last bits.

        Each argument may be a batch; states stand along the last axis.
        """
        t = np.asarray(t, dtype=_R)
        with np.errstate(all="ignore"):
            past = (t - self._deadline) - self._correction
            late = np.where(past < self._hold_from, past, self._hold_from)
            v1 = late * self._inv_tau
            inv_T_squared = _R(1.0) / (late * late)
            v2 = v1 * v1
            s1 = (((((-_R(9.254479664377868e-5)) * v2) - _R(7.244605360057221e-9)) * v2) - _R(0.0006016576080583036)) * v2
            s2 = ((((s1 - _R(0.001899098395369947)) * v2) - _R(0.007859068922698498)) * v2) - _R(0.03179009631276131)
            th_cot_th = (((((s2 * v2) - _R(0.1352904886007309)) * v2) - _R(0.822467029094696)) * v2) + _R(1.0)
            cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th)
            slope = self._angle_rate + (self._inv_angle_rate * cot_rate_squared)
            row1 = self._c1_3 * slope * slope * slope
            T = -late
            cot_rate = T * inv_T_squared * th_cot_th
            s3 = (self._c2_4 * cot_rate_squared) + self._c2_2
            s4 = ((self._c2_3 * cot_rate_squared) + self._c2_1) * cot_rate
            row2 = (s3 * cot_rate_squared) + self._c2_0 + s4
            row3 = (self._c3_2 * cot_rate_squared) + self._c3_0 + (_R(6.0) * cot_rate)
            way1 = late < self._hold_from
            status = np.where(np.isfinite(t) & (t >= self._t0), np.where(way1, Status.OK, Status.HOLD), Status.INPUT)
            gain = np.stack(np.broadcast_arrays(row1, row2, row3), axis=-1)
            return Gains(gain, status.astype(np.int8))
