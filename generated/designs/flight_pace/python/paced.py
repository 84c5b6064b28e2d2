"""
Prescribed-time controller paced: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name paced --clock samples --late=extend --pace=soonest --tau=1 --eps=0 --u-min=-1 --poles=-4,-5,-6 --after zero --sample-time=0.01 --delay=1
Version 0.1.0, design d3e4f699dd7c.

Plant: x1' = x2, x2' = u; u held from sample to sample, one sample late.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
      h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
      gains of 3 samples to go stay: they are deadbeat.

Parameters:
  samples = 100 [samples], fixed: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: upper limit of u
  u_min = -1 [unit of u], fixed: lower limit of u
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on u = 0 (status AFTER).
In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
      else stays as it is.
Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
      so their Bernstein coefficients, linear in z, bound them. If these are within the
      limits, u stay there at every sample to rest, where plant and state are as they are
      known.
late extend: a step without such a plan raises N to the soonest that has one (status LATE;
      deadline gives its tick), and others lower N, by at most a sixteenth of the samples
      to go. Where none is found (status INFEASIBLE), or 2^31 samples after the start, N
      stays, and u is clipped; states may leave their bounds then.
u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
      deadline where it lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample 100 from any state, whatever the poles, and |u| is
      bounded.
  sampling: not checked: the law is exact in samples, at any period.
  deadline: not checked: the law is exact in samples, at any period.
  loop: not checked: `x0_max` is not given.
  envelope: not checked: it does not examine a clock in samples.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Paced", "Params", "Status"]

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

    u_max: float = np.inf
    """upper limit of u [unit of u], > u_min, infinity allowed"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Weight of x1 in the law.
_S1_1 = _R(10000.0)
# Weight of x2 in the law.
_S1_2 = _R(-50.0)
# Weight of x2 in the law.
_S2_2 = _R(100.0)
# Weight of x1 in the law.
_W1_1 = _R(-1200000.0)
# Weight of x2 in the law.
_W1_2 = _R(6000.0)
# Weight of x2 in the law.
_W2_2 = _R(-6000.0)
# Weight of u1 in the law.
_W3_3 = _R(-12.0)

class Paced:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_u_max = _R(params.u_max)
            if not ((given_u_max > -1.0) and (given_u_max >= 0.0)):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > -1, >= 0")
            u_max = given_u_max
            self._start = 0
            self._last = 100
            self._u1 = _R(0.0)
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        self._last = 100

    def step(self, k: int, x: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for each
        tick.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 2, "x")
            if not (np.isfinite(x[0]) and np.isfinite(x[1])):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP
            x1 = x[0]
            x2 = x[1]

            # The deadline that keeps the limits.
            last_now = np.asarray(self._last)
            late = np.asarray(0)
            if elapsed < self._last:
                to_rest = max(self._last - elapsed, 0)
                ahead = to_rest
                flat1 = (_S1_1 * x1) + (_S1_2 * x2)
                flat2 = _S2_2 * x2
                flat3 = self._u1
                below = np.asarray(max(max(ahead - 1, 0) - (ahead // 16), 0))
                if ahead > 3:
                    if below < 3:
                        below = 3
                else:
                    below = max(ahead - 1, 0)
                low = np.asarray(below)
                top = np.asarray(1073741825)
                kept = np.asarray(0)
                tried = np.asarray(ahead)
                part = np.asarray(0.9999999999968848)
                for _ in range(64):
                    least = -part
                    most = self._u_max * part
                    fits = np.asarray(0)
                    if tried > 3:
                        m = _R(tried)
                        power1 = m + 3.0
                        power2 = power1 * (m + 2.0)
                        power3 = power2 * (m + 1.0)
                        power4 = power3 * m
                        power5 = power4 * (m - 1.0)
                        power6 = power5 * (m - 2.0)
                        scaled2 = flat2 * power1
                        scaled3 = flat3 * power2
                        w1 = ((15.0 * flat1) + (5.0 * scaled2) + (0.5 * scaled3)) / power4
                        w2 = ((((-24.0) * flat1) - (9.0 * scaled2)) - scaled3) / power5
                        w3 = ((10.0 * flat1) + (4.0 * scaled2) + (0.5 * scaled3)) / power6
                        length = m - 4.0
                        b0_c = (144.0 * w1) + (480.0 * w2) + (720.0 * w3)
                        b1_c = ((84.0 * w1) + (520.0 * w2) + (1500.0 * w3)) * length
                        b2_l = length * length
                        b2_c = ((12.0 * w1) + (180.0 * w2) + (1050.0 * w3)) * b2_l
                        b3_l = b2_l * length
                        b3_c = ((20.0 * w2) + (300.0 * w3)) * b3_l
                        b4_l = b3_l * length
                        b4_c = 30.0 * w3 * b4_l
                        b1 = b0_c + (0.125 * b1_c)
                        b2 = b0_c + (0.25 * b1_c) + (0.03571428571428571 * b2_c)
                        s1 = b0_c + (0.375 * b1_c) + (0.10714285714285714 * b2_c)
                        b3 = s1 + (0.017857142857142856 * b3_c)
                        s2 = b0_c + (0.5 * b1_c) + (0.21428571428571427 * b2_c)
                        s3 = s2 + (0.07142857142857142 * b3_c)
                        b4 = s3 + (0.014285714285714285 * b4_c)
                        s4 = b0_c + (0.625 * b1_c) + (0.35714285714285715 * b2_c)
                        s5 = s4 + (0.17857142857142858 * b3_c)
                        b5 = s5 + (0.07142857142857142 * b4_c)
                        s6 = b0_c + (0.75 * b1_c) + (0.5357142857142857 * b2_c)
                        s7 = s6 + (0.35714285714285715 * b3_c)
                        b6 = s7 + (0.21428571428571427 * b4_c)
                        s8 = b0_c + (0.875 * b1_c) + (0.75 * b2_c) + (0.625 * b3_c)
                        b7 = s8 + (0.5 * b4_c)
                        b8 = b0_c + b1_c + b2_c + b3_c + b4_c
                        end29 = (72.0 * w1) + (120.0 * w2)
                        end30 = 24.0 * w1
                        if (
                            (least <= b0_c <= most)
                            and (least <= b1 <= most)
                            and (least <= b2 <= most)
                            and (least <= b3 <= most)
                            and (least <= b4 <= most)
                            and (least <= b5 <= most)
                            and (least <= b6 <= most)
                            and (least <= b7 <= most)
                            and (least <= b8 <= most)
                            and (least <= end29 <= most)
                            and (least <= end30 <= most)
                        ):
                            fits = 1
                    else:
                        end0 = ((-flat1) - (3.0 * flat2)) - (2.0 * flat3)
                        end1 = flat1 + (2.0 * flat2) + flat3
                        if (least <= end0 <= most) and (least <= end1 <= most):
                            fits = 1
                    if fits == 1:
                        kept = tried
                        top = tried
                    elif tried > 3:
                        low = tried
                    else:
                        low = 3
                    gap = max(top - low, 0)
                    if gap < 2:
                        break
                    half = gap // 2
                    if low < half:
                        tried = low + low
                    else:
                        tried = low + half
                    part = _R(0.9999999999937695)
                if (kept > 0) and (elapsed < 2147483648):
                    last_now = elapsed + kept
                if (kept == 0) and (ahead > 0):
                    late = 2
            if last_now > self._last:
                late = 1
            left = max(last_now - elapsed, 0)
            m0 = max(_R(left), _R(3.0))

            # The exact law in samples.
            z1 = (_W1_1 * x1) + (_W1_2 * x2)
            z2 = _W2_2 * x2
            z3 = _W3_3 * self._u1
            m0f1 = m0 + 3.0
            m0f2 = m0f1 * (m0 + 2.0)
            v = ((z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * (m0 + 1.0))) + self._u1
            if not np.isfinite(v):
                return Control(_R(0.0), Status.RANGE)
            if elapsed < last_now:
                if v > self._u_max:
                    u_now = self._u_max
                elif v < -1.0:
                    u_now = _R(-1.0)
                else:
                    u_now = v
            else:
                u_now = _R(0.0)
            self._u1 = u_now
            self._last = last_now
            if elapsed < last_now:
                if (v > self._u_max) or (v < -1.0):
                    return Control(u_now, Status.SATURATED)
                elif late == 2:
                    return Control(u_now, Status.INFEASIBLE)
                elif late == 1:
                    return Control(u_now, Status.LATE)
                else:
                    return Control(u_now, Status.OK)
            else:
                return Control(u_now, Status.AFTER)

    def arm_for(self, k: int, samples: int) -> None:
        """Another deadline, at any tick before the call of `step` at it: rest at tick `k` +
        `samples`, 3 to 2147483648 samples. Estimates and inputs under way are kept.

        ValueError where an argument or what follows from it is not finite; the controller
        is left as it was.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            samples = samples.__index__() & _WRAP
            if not ((samples > 2) and (samples < 2147483649)):
                raise ValueError("k and samples, and what follows, must be finite")
            self._start = k
            self._last = samples

    def soonest(self, x: ArrayLike) -> int:
        """The fewest samples found, from the next call of `step` on, with which the law keeps u and
        the states within their limits at every sample to rest, from the state x, for sure. Give
        them to `arm_for`.

        ValueError where an argument is not finite, or where there is none.
        """
        with np.errstate(all="ignore"):
            x = _numbers(x, 2, "x")
            if not (np.isfinite(x[0]) and np.isfinite(x[1])):
                raise ValueError("an argument, or what follows from it, is not finite")
            x1 = x[0]
            x2 = x[1]
            flat1 = (_S1_1 * x1) + (_S1_2 * x2)
            flat2 = _S2_2 * x2
            flat3 = self._u1
            low = np.asarray(3)
            top = np.asarray(1073741825)
            kept = np.asarray(0)
            tried = np.asarray(4)
            for _ in range(64):
                least = _R(-0.9999999999937695)
                most = 0.9999999999937695 * self._u_max
                fits = np.asarray(0)
                m = _R(tried)
                power1 = m + 3.0
                power2 = power1 * (m + 2.0)
                power3 = power2 * (m + 1.0)
                power4 = power3 * m
                power5 = power4 * (m - 1.0)
                power6 = power5 * (m - 2.0)
                scaled2 = flat2 * power1
                scaled3 = flat3 * power2
                w1 = ((15.0 * flat1) + (5.0 * scaled2) + (0.5 * scaled3)) / power4
                w2 = ((((-24.0) * flat1) - (9.0 * scaled2)) - scaled3) / power5
                w3 = ((10.0 * flat1) + (4.0 * scaled2) + (0.5 * scaled3)) / power6
                length = m - 4.0
                b0_c = (144.0 * w1) + (480.0 * w2) + (720.0 * w3)
                b1_c = ((84.0 * w1) + (520.0 * w2) + (1500.0 * w3)) * length
                b2_l = length * length
                b2_c = ((12.0 * w1) + (180.0 * w2) + (1050.0 * w3)) * b2_l
                b3_l = b2_l * length
                b3_c = ((20.0 * w2) + (300.0 * w3)) * b3_l
                b4_l = b3_l * length
                b4_c = 30.0 * w3 * b4_l
                b1 = b0_c + (0.125 * b1_c)
                b2 = b0_c + (0.25 * b1_c) + (0.03571428571428571 * b2_c)
                s1 = b0_c + (0.375 * b1_c) + (0.10714285714285714 * b2_c)
                b3 = s1 + (0.017857142857142856 * b3_c)
                s2 = b0_c + (0.5 * b1_c) + (0.21428571428571427 * b2_c)
                s3 = s2 + (0.07142857142857142 * b3_c)
                b4 = s3 + (0.014285714285714285 * b4_c)
                s4 = b0_c + (0.625 * b1_c) + (0.35714285714285715 * b2_c)
                s5 = s4 + (0.17857142857142858 * b3_c)
                b5 = s5 + (0.07142857142857142 * b4_c)
                s6 = b0_c + (0.75 * b1_c) + (0.5357142857142857 * b2_c)
                s7 = s6 + (0.35714285714285715 * b3_c)
                b6 = s7 + (0.21428571428571427 * b4_c)
                s8 = b0_c + (0.875 * b1_c) + (0.75 * b2_c) + (0.625 * b3_c)
                b7 = s8 + (0.5 * b4_c)
                b8 = b0_c + b1_c + b2_c + b3_c + b4_c
                end29 = (72.0 * w1) + (120.0 * w2)
                end30 = 24.0 * w1
                if (
                    (least <= b0_c <= most)
                    and (least <= b1 <= most)
                    and (least <= b2 <= most)
                    and (least <= b3 <= most)
                    and (least <= b4 <= most)
                    and (least <= b5 <= most)
                    and (least <= b6 <= most)
                    and (least <= b7 <= most)
                    and (least <= b8 <= most)
                    and (least <= end29 <= most)
                    and (least <= end30 <= most)
                ):
                    fits = 1
                if fits == 1:
                    kept = tried
                    top = tried
                else:
                    low = tried
                gap = max(top - low, 0)
                if gap < 2:
                    break
                half = gap // 2
                if low < half:
                    tried = low + low
                else:
                    tried = low + half
            if np.isfinite(flat1) and np.isfinite(flat2) and np.isfinite(flat3):
                if kept > 0:
                    return int(kept)
                else:
                    raise ValueError("no number of samples was found that keeps the limits")
            else:
                raise ValueError("an argument, or what follows from it, is not finite")

    def deadline(self) -> int:
        """The tick at which the loop is to be at rest."""
        return int((self._start - ((0 - self._last) & _WRAP)) & _WRAP)

    def applied(self, u: float) -> None:
        """The drive applied `u` in place of the u that the last call of `step` gave.

        ValueError where an argument or what follows from it is not finite; the controller
        is left as it was.
        """
        with np.errstate(all="ignore"):
            u = _R(u)
            if not np.isfinite(u):
                raise ValueError("u, and what follows, must be finite")
            self._u1 = u
