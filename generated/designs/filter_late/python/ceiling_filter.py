"""
Prescribed-time filter ceiling_filter: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --name ceiling --what filter --keep-below=1 --keep-tolerance=1e-3 --keep-poles=-3,-5,-8 --poles="least-energy(weight=1)" --precision f32 --tau=1 --f="1/2" --g="-2" --sample-time=0.01 --delay=1.5
Version 0.1.0, design deb0d31bb8ee.

Plant: x1' = x2, ..., x3' = f + g u; u held from sample to sample, 1.5 samples late.
Goal: x1 <= 1, at and between all samples, under any controller, from every state from
      which that is possible and as long as nothing else acts on the plant.
Filter: with the control points z = S x of the trajectory, q_0 = z_i and q_j = (Delta +
      a_(i+j-1)) q_(j-1), with the rates a_i = (1 - exp(p_i h))/h of the poles -3, -5, -8
      1/s. In this cone all states are safe: x_i stays within its bound b as long as all
      q_j are within b a_i...a_(i+j-1), j < n+1-i; the last of them, in which u occurs, is
      the limit of u.
From any other state u is held to the law least-energy(weight=1) of the chain of each x_i
      less its bound too, so that x_i is within it at the latest N samples after the last
      safe one, as long as neither the limits of u nor those by other bounds are in the way.

Parameters:
  samples = 100 [samples], fixed: samples N in which a state outside returns
  h = 0.01 [s], fixed: sample period
  u_max [unit of u]: bound of |u|

k counts samples and may wrap; call step at least once within 2^32 - N samples.
u is u_nominal where no bound is near (status OK), and else the nearest that they allow
      (SATURATED).
INFEASIBLE: the state is not safe, or not all bounds can be kept: those of x1 go before
      those of x2 and so on, the limits of u before all.
|u| <= u_max: u is clipped to it (status SATURATED). This goes before all bounds.
Guard full: x and u_nominal are finite, or the call is refused (INPUT).
Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: not checked: a filter has no law.
  sampling: not checked: a filter has no law.
  deadline: not checked: a filter has no law.
  loop: not checked: `u_max` is left to run time.
  envelope: not checked: a filter has no law.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["CeilingFilter", "Control", "Params", "Status"]

_R = np.float32
_WRAP = 0xFFFFFFFF
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
    """Result of a step."""

    u: np.float32
    """Input of the plant."""
    status: Status
    """Its Status."""

@dataclass(frozen=True, kw_only=True)
class Params:
    """Run-time parameters."""

    u_max: float = np.inf
    """bound of |u| [unit of u], > 0, infinity allowed"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# -1/2, weight of x1 in the law.
_S1_1 = _R(-_R(0.5))
# -1/400, weight of x2 in the law.
_S1_2 = _R(-_R(0.0024999999441206455))
# 1/480000, weight of x3 in the law.
_S1_3 = _R(_R(2.0833333564951317e-6))
# -1/16000000, weight of u2 in the law.
_S1_5 = _R(-_R(6.249999984220267e-8))
# -1/2, weight of x2 in the law.
_S2_2 = _R(-_R(0.5))
# -1/200, weight of x3 in the law.
_S2_3 = _R(-_R(0.004999999888241291))
# 3/80000, weight of u2 in the law.
_S2_5 = _R(_R(3.7500001781154424e-5))
# -1/2, weight of x3 in the law.
_S3_3 = _R(-_R(0.5))
# 1/100, weight of u1 in the law.
_S3_4 = _R(_R(0.009999999776482582))
# 1/200, weight of u2 in the law.
_S3_5 = _R(_R(0.004999999888241291))

class CeilingFilter:
    """The filter. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_u_max = _R(params.u_max)
            if not (given_u_max > _R(0.0)):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            u_max = given_u_max
            self._start = 0
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """From tick `k` on a state outside has N samples to return. Estimates and inputs under way
        are kept.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike, u_nominal: float | np.float32) -> Control:
        """u_nominal as it is, or as near to it as the bounds allow, from tick `k`, which may wrap,
        and the state x = (x1, x1', ...). Call it once for each tick.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 3, "x")
            u_nominal = _R(u_nominal)
            if not (
                np.isfinite(x[0])
                and np.isfinite(x[1])
                and np.isfinite(x[2])
                and np.isfinite(u_nominal)
            ):
                return Control(_R(0.0), Status.INPUT)
            x1 = x[0]
            x2 = x[1]
            x3 = x[2]
            s1 = (_S1_1 * x1) + (_S1_2 * x2) + (_S1_3 * x3)
            z1 = s1 + (_S1_5 * (self._u2 - _R(0.25)))
            s2 = (_S2_2 * x2) + (_S2_3 * x3)
            z2 = s2 + (_S2_5 * (self._u2 - _R(0.25)))
            s3 = (_S3_3 * x3) + (_S3_4 * (self._u1 - _R(0.25)))
            z3 = s3 + (_S3_5 * (self._u2 - _R(0.25)))

            # The limits of u that keep a safe state safe.
            q1_1 = z2 + (_R(2.955446720123291) * z1)
            q1_2 = z3 + (_R(7.8325042724609375) * z2) + (_R(14.413883209228516) * z1)
            q1_3 = (_R(15.520869255065918) * z3) + (_R(74.6330337524414) * z2) + (_R(110.81919860839844) * z1)
            low1 = np.asarray((-_R(55.15959930419922)) - q1_3)
            since = np.asarray(self._start)
            safe = np.asarray(1)
            if (
                (z1 >= -_R(0.5005000233650208))
                and (q1_1 >= -_R(1.479201078414917))
                and (q1_2 >= -_R(7.21414852142334))
            ):
                since = k
            else:
                safe = 0

                # Outside: u is held to the law of return too.
                left = _R(max(98 - ((k - since) & _WRAP), 0))
                t1 = max(left, _R(3.0))
                s4 = ((((-_R(120000000.0)) * z1) / (t1 + _R(3.0))) - (_R(600000.0) * z2)) / (t1 + _R(2.0))
                law1 = ((s4 - (_R(1200.0) * z3)) / (t1 + _R(1.0))) + _R(0.25)
                weight1 = (((-_R(120000000.0)) / (t1 + _R(3.0))) / (t1 + _R(2.0))) / (t1 + _R(1.0))
                low1_back = law1 - ((-_R(0.5)) * weight1)
                if low1 < low1_back:
                    low1 = low1_back

            # u within them, the bounds of x1 last.
            u_now = np.asarray(u_nominal)
            if u_now < low1:
                u_now = low1
            if u_now > self._u_max:
                u_now = self._u_max
            if u_now < -self._u_max:
                u_now = -self._u_max
            if not (np.isfinite(u_now) and np.isfinite(low1)):
                return Control(_R(0.0), Status.RANGE)
            self._u2 = self._u1
            self._u1 = u_now
            self._start = since
            if (safe == 0) or (u_now < low1 - _R(0.05540959909558296)):
                return Control(u_now, Status.INFEASIBLE)
            elif (u_now < u_nominal) or (u_nominal < u_now):
                return Control(u_now, Status.SATURATED)
            else:
                return Control(u_now, Status.OK)
