"""
Prescribed-time filter stop_filter: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --name stop --what filter --keep-below=0.5,0.8 --keep-above=-0.5,-0.8 --keep-poles=-10,-40 --tau=0.4 --u-max=10 --sample-time=1e-3
Version 0.1.0, design 74c45379c0da.

Plant: x1' = x2, x2' = u; u held from sample to sample.
Goal: -0.5 <= x1 <= 0.5, -0.8 <= x2 <= 0.8, at and between all samples, under any
      controller, from every state from which that is possible and as long as nothing else
      acts on the plant.
Filter: with the control points z = S x of the trajectory, q_0 = z_i and q_j = (Delta +
      a_(i+j-1)) q_(j-1), with the rates a_i = (1 - exp(p_i h))/h of the poles -10, -40
      1/s. In this cone all states are safe: x_i stays within its bound b as long as all
      q_j are within b a_i...a_(i+j-1), j < n+1-i; the last of them, in which u occurs, is
      the limit of u.
From any other state u is held to the law least-energy of the chain of each x_i less its
      bound too, so that x_i is within it at the latest N samples after the last safe one,
      as long as neither the limits of u nor those by other bounds are in the way.

Parameters:
  samples = 400 [samples], fixed: samples N in which a state outside returns
  h = 1e-3 [s], fixed: sample period
  u_max = 10 [unit of u], fixed: bound of |u|

k counts samples and may wrap; call step at least once within 2^32 - N samples.
u is u_nominal where no bound is near (status OK), and else the nearest that they allow
      (SATURATED).
INFEASIBLE: the state is not safe, or not all bounds can be kept: those of x1 go before
      those of x2 and so on, the limits of u before all.
|u| <= u_max: u is clipped to it (status SATURATED). This goes before all bounds.
Guard full: x and u_nominal are finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: not checked: a filter has no law.
  sampling: not checked: a filter has no law.
  deadline: not checked: a filter has no law.
  loop: sound: from every safe state the bounds are kept at and between all samples, and no
      limit is in the way.
  envelope: not checked: a filter has no law.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Params", "Status", "StopFilter"]

_R = np.float64
_WRAP = 0xFFFFFFFF
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
    """Result of a step."""

    u: np.float64
    """Input of the plant."""
    status: Status
    """Its Status."""

@dataclass(frozen=True, kw_only=True)
class Params:
    """Run-time parameters."""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# -1/2000, weight of x2 in the law.
_S1_2 = _R(-0.0005)
# Bound of |u|.
_U_MAX = _R(10.0)

class StopFilter:
    """The filter. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            self._start = 0

    def arm(self, k: int) -> None:
        """From tick `k` on a state outside has N samples to return."""
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike, u_nominal: float) -> Control:
        """u_nominal as it is, or as near to it as the bounds allow, from tick `k`, which may wrap,
        and the state x = (x1, x1', ...).

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 2, "x")
            u_nominal = _R(u_nominal)
            if not (np.isfinite(x[0]) and np.isfinite(x[1]) and np.isfinite(u_nominal)):
                return Control(_R(0.0), Status.INPUT)
            x1 = x[0]
            x2 = x[1]
            z1 = x1 + (_S1_2 * x2)
            z2 = x2

            # The limits of u that keep a safe state safe.
            q1_1 = z2 + (9.950166250831947 * z1)
            q1_2 = (49.16072709850874 * z2) + (390.1515992227461 * z1)
            low1 = np.asarray((-195.07579961137304) - q1_2)
            high1 = np.asarray(195.07579961137304 - q1_2)
            q2_1 = 39.21056084767679 * z2
            low2 = np.asarray((-31.368448678141434) - q2_1)
            high2 = np.asarray(31.368448678141434 - q2_1)
            since = np.asarray(self._start)
            safe = np.asarray(1)
            if (
                (-0.5000000004656613 <= z1 <= 0.5000000004656613)
                and (-4.975083130049381 <= q1_1 <= 4.975083130049381)
                and (-0.8000000007450581 <= z2 <= 0.8000000007450581)
            ):
                since = k
            else:
                safe = 0

                # Outside: u is held to the law of return too.
                left = _R(max(400 - ((k - since) & _WRAP), 0))
                t1 = max(left, _R(2.0))
                law1 = ((((-6000000.0) * z1) / (t1 + 1.0)) - (4000.0 * z2)) / t1
                weight1 = ((-6000000.0) / (t1 + 1.0)) / t1
                low1_back = law1 - ((-0.5) * weight1)
                if low1 < low1_back:
                    low1 = low1_back
                high1_back = law1 - (0.5 * weight1)
                if high1_back < high1:
                    high1 = high1_back
                t2 = max(left, _R(1.0))
                law2 = ((-1000.0) * z2) / t2
                weight2 = (-1000.0) / t2
                low2_back = law2 - ((-0.8) * weight2)
                if low2 < low2_back:
                    low2 = low2_back
                high2_back = law2 - (0.8 * weight2)
                if high2_back < high2:
                    high2 = high2_back

            # u within them, the bounds of x1 last.
            u_now = np.asarray(u_nominal)
            if u_now < low2:
                u_now = low2
            if high2 < u_now:
                u_now = high2
            if u_now < low1:
                u_now = low1
            if high1 < u_now:
                u_now = high1
            if u_now > _U_MAX:
                u_now = _U_MAX
            if u_now < -_U_MAX:
                u_now = -_U_MAX
            if not (
                np.isfinite(u_now)
                and np.isfinite(low1)
                and np.isfinite(high1)
                and np.isfinite(low2)
                and np.isfinite(high2)
            ):
                return Control(_R(0.0), Status.RANGE)
            self._start = since
            if (safe == 0) or (high2 + 2.9214144384620184e-8 < u_now) or (u_now < low2 - 2.9214144384620184e-8) or (high1 + 1.816784959392371e-7 < u_now) or (u_now < low1 - 1.816784959392371e-7):
                return Control(u_now, Status.INFEASIBLE)
            elif (u_now < u_nominal) or (u_nominal < u_now):
                return Control(u_now, Status.SATURATED)
            else:
                return Control(u_now, Status.OK)
