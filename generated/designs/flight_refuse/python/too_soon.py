"""
Prescribed-time controller too_soon: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name too_soon --clock samples --late=refuse --state-max=inf,0.5,4 --precision f32 --tau=1.5 --eps=0 --u-max=20 --poles="least-energy(weight=1)" --sample-time=0.01
Version 0.1.0, design 9b0d3c826af2.

Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
      h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
      gains of 3 samples to go stay: they are deadbeat.

Parameters:
  samples = 150 [samples], fixed: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max = 20 [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
      else stays as it is.
Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
      so their Bernstein coefficients, linear in z, bound them. If these are within the
      limits, u and |x2| <= 0.5 and |x3| <= 4 stay there at every sample to rest, where
      plant and state are as they are known.
late refuse: arm_for refuses a deadline without such a plan (status E_SOON).
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample 150 from any state, whatever the poles, and |u| is
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

__all__ = ["Control", "Params", "Status", "TooSoon"]

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

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Weight of x1 in the law.
_W1_1 = _R(-_R(120000000.0))
# Weight of x2 in the law.
_W1_2 = _R(_R(1200000.0))
# Weight of x3 in the law.
_W1_3 = _R(-_R(4000.0))
# Weight of x2 in the law.
_W2_2 = _R(-_R(600000.0))
# Weight of x3 in the law.
_W2_3 = _R(_R(3000.0))
# Weight of x3 in the law.
_W3_3 = _R(-_R(1200.0))
# Bound of |u|.
_U_MAX = _R(_R(20.0))
# Weight of x1 in the law.
_S1_1 = _R(_R(1000000.0))
# Weight of x2 in the law.
_S1_2 = _R(-_R(10000.0))
# 100/3, weight of x3 in the law.
_S1_3 = _R(_R(33.33333206176758))
# Weight of x2 in the law.
_S2_2 = _R(_R(10000.0))
# Weight of x3 in the law.
_S2_3 = _R(-_R(50.0))
# Weight of x3 in the law.
_S3_3 = _R(_R(100.0))

class TooSoon:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            self._start = 0
            self._last = 150

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`."""
        k = k.__index__() & _WRAP
        self._start = k
        self._last = 150

    def step(self, k: int, x: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and the state x = (x1, x1', ...).

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 3, "x")
            if not (np.isfinite(x[0]) and np.isfinite(x[1]) and np.isfinite(x[2])):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP
            x1 = x[0]
            x2 = x[1]
            x3 = x[2]
            left = max(self._last - elapsed, 0)
            m0 = max(_R(left), _R(3.0))

            # The exact law in samples.
            z1 = (_W1_1 * x1) + (_W1_2 * x2) + (_W1_3 * x3)
            z2 = (_W2_2 * x2) + (_W2_3 * x3)
            z3 = _W3_3 * x3
            m0f1 = m0 + _R(3.0)
            m0f2 = m0f1 * (m0 + _R(2.0))
            v = (z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * (m0 + _R(1.0)))
            if np.isfinite(v):
                if v > _U_MAX:
                    return Control(_U_MAX, Status.SATURATED)
                elif v < -_U_MAX:
                    return Control(-_U_MAX, Status.SATURATED)
                elif elapsed < self._last:
                    return Control(v, Status.OK)
                else:
                    return Control(v, Status.HOLD)
            else:
                return Control(_R(0.0), Status.RANGE)

    def arm_for(self, k: int, samples: int, x: ArrayLike) -> None:
        """Another deadline, at any tick before the call of `step` at it: rest at tick `k` +
        `samples`, 3 to 2147483648 samples. A deadline before which a limit could be exceeded is
        refused (E_SOON).

        ValueError where an argument or what follows from it is not finite; the controller
        is left as it was.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            samples = samples.__index__() & _WRAP
            x = _numbers(x, 3, "x")
            if not ((samples > 2) and (samples < 2147483649)):
                raise ValueError("k and samples and x, and what follows, must be finite")
            if not (np.isfinite(x[0]) and np.isfinite(x[1]) and np.isfinite(x[2])):
                raise ValueError("k and samples and x, and what follows, must be finite")
            x1 = x[0]
            x2 = x[1]
            x3 = x[2]
            flat1 = (_S1_1 * x1) + (_S1_2 * x2) + (_S1_3 * x3)
            flat2 = (_S2_2 * x2) + (_S2_3 * x3)
            flat3 = _S3_3 * x3
            least = _R(0.9949458837509155) * (-_U_MAX)
            most = _R(0.9949458837509155) * _U_MAX
            most2 = _R(0.49747294187545776)
            most3 = _R(3.979783535003662)
            tried = samples
            fits = np.asarray(0)
            m = _R(tried)
            power1 = m + _R(3.0)
            power2 = power1 * (m + _R(2.0))
            power3 = power2 * (m + _R(1.0))
            power4 = power3 * m
            power5 = power4 * (m - _R(1.0))
            power6 = power5 * (m - _R(2.0))
            scaled2 = flat2 * power1
            scaled3 = flat3 * power2
            w1 = ((_R(15.0) * flat1) + (_R(5.0) * scaled2) + (_R(0.5) * scaled3)) / power4
            w2 = ((((-_R(24.0)) * flat1) - (_R(9.0) * scaled2)) - scaled3) / power5
            w3 = ((_R(10.0) * flat1) + (_R(4.0) * scaled2) + (_R(0.5) * scaled3)) / power6
            length = m - _R(4.0)
            b0_c = (((-_R(96.0)) * w1) - (_R(720.0) * w2)) - (_R(2880.0) * w3)
            b1_c = ((((-_R(24.0)) * w1) - (_R(420.0) * w2)) - (_R(3120.0) * w3)) * length
            b2_l = length * length
            b2_c = (((-_R(60.0)) * w2) - (_R(1080.0) * w3)) * b2_l
            b3_l = b2_l * length
            b3_c = (-_R(120.0)) * w3 * b3_l
            b1 = b0_c + (_R(0.1428571492433548) * b1_c)
            b2 = b0_c + (_R(0.2857142984867096) * b1_c) + (_R(0.0476190485060215) * b2_c)
            s10 = b0_c + (_R(0.4285714328289032) * b1_c) + (_R(0.1428571492433548) * b2_c)
            b3 = s10 + (_R(0.02857142873108387) * b3_c)
            s11 = b0_c + (_R(0.5714285969734192) * b1_c) + (_R(0.2857142984867096) * b2_c)
            b4 = s11 + (_R(0.11428571492433548) * b3_c)
            s12 = b0_c + (_R(0.7142857313156128) * b1_c) + (_R(0.4761904776096344) * b2_c)
            b5 = s12 + (_R(0.2857142984867096) * b3_c)
            s13 = b0_c + (_R(0.8571428656578064) * b1_c) + (_R(0.7142857313156128) * b2_c)
            b6 = s13 + (_R(0.5714285969734192) * b3_c)
            b7 = b0_c + b1_c + b2_c + b3_c
            s0_c = (((-_R(0.035999998450279236)) * w1) - (_R(0.11999999731779099) * w2)) - (_R(0.25200000405311584) * w3)
            s1_c = ((((-_R(0.02419999986886978)) * w1) - (_R(0.12399999797344208) * w2)) - (_R(0.3953999876976013) * w3)) * length
            s2_l = length * length
            s2_c = ((((-_R(0.005400000140070915)) * w1) - (_R(0.04749999940395355) * w2)) - (_R(0.24150000512599945) * w3)) * s2_l
            s3_l = s2_l * length
            s3_c = ((((-_R(0.00039999998989515007)) * w1) - (_R(0.00800000037997961) * w2)) - (_R(0.07199999690055847) * w3)) * s3_l
            s4_l = s3_l * length
            s4_c = (((-_R(0.0005000000237487257)) * w2) - (_R(0.010499999858438969) * w3)) * s4_l
            s5_l = s4_l * length
            s5_c = (-_R(0.0006000000284984708)) * w3 * s5_l
            s1 = s0_c + (_R(0.1111111119389534) * s1_c)
            s2 = s0_c + (_R(0.2222222238779068) * s1_c) + (_R(0.02777777798473835) * s2_c)
            s14 = s0_c + (_R(0.3333333432674408) * s1_c) + (_R(0.0833333358168602) * s2_c)
            s3 = s14 + (_R(0.011904762126505375) * s3_c)
            s15 = s0_c + (_R(0.4444444477558136) * s1_c) + (_R(0.1666666716337204) * s2_c)
            s4 = s15 + (_R(0.0476190485060215) * s3_c) + (_R(0.007936508394777775) * s4_c)
            s16 = s0_c + (_R(0.5555555820465088) * s1_c) + (_R(0.2777777910232544) * s2_c)
            s17 = s16 + (_R(0.1190476194024086) * s3_c) + (_R(0.0396825410425663) * s4_c)
            s5 = s17 + (_R(0.007936508394777775) * s5_c)
            s18 = s0_c + (_R(0.6666666865348816) * s1_c) + (_R(0.4166666567325592) * s2_c)
            s19 = s18 + (_R(0.2380952388048172) * s3_c) + (_R(0.1190476194024086) * s4_c)
            s6 = s19 + (_R(0.0476190485060215) * s5_c)
            s20 = s0_c + (_R(0.7777777910232544) * s1_c) + (_R(0.5833333134651184) * s2_c)
            s21 = s20 + (_R(0.4166666567325592) * s3_c) + (_R(0.2777777910232544) * s4_c)
            s7 = s21 + (_R(0.1666666716337204) * s5_c)
            s22 = s0_c + (_R(0.8888888955116272) * s1_c) + (_R(0.7777777910232544) * s2_c)
            s23 = s22 + (_R(0.6666666865348816) * s3_c) + (_R(0.5555555820465088) * s4_c)
            s8 = s23 + (_R(0.4444444477558136) * s5_c)
            s9 = s0_c + s1_c + s2_c + s3_c + s4_c + s5_c
            v0_c = (_R(2.4000000953674316) * w1) + (_R(12.0) * w2) + (_R(36.0) * w3)
            v1_c = ((_R(1.0800000429153442) * w1) + (_R(9.399999618530273) * w2) + (_R(46.20000076293945) * w3)) * length
            v2_l = length * length
            v2_c = ((_R(0.11999999731779099) * w1) + (_R(2.4000000953674316) * w2) + (_R(21.299999237060547) * w3)) * v2_l
            v3_l = v2_l * length
            v3_c = ((_R(0.20000000298023224) * w2) + (_R(4.199999809265137) * w3)) * v3_l
            v4_l = v3_l * length
            v4_c = _R(0.30000001192092896) * w3 * v4_l
            v1 = v0_c + (_R(0.125) * v1_c)
            v2 = v0_c + (_R(0.25) * v1_c) + (_R(0.0357142873108387) * v2_c)
            s24 = v0_c + (_R(0.375) * v1_c) + (_R(0.1071428582072258) * v2_c)
            v3 = s24 + (_R(0.01785714365541935) * v3_c)
            s25 = v0_c + (_R(0.5) * v1_c) + (_R(0.2142857164144516) * v2_c) + (_R(0.0714285746216774) * v3_c)
            v4 = s25 + (_R(0.014285714365541935) * v4_c)
            s26 = v0_c + (_R(0.625) * v1_c) + (_R(0.3571428656578064) * v2_c) + (_R(0.1785714328289032) * v3_c)
            v5 = s26 + (_R(0.0714285746216774) * v4_c)
            s27 = v0_c + (_R(0.75) * v1_c) + (_R(0.5357142686843872) * v2_c) + (_R(0.3571428656578064) * v3_c)
            v6 = s27 + (_R(0.2142857164144516) * v4_c)
            s28 = v0_c + (_R(0.875) * v1_c) + (_R(0.75) * v2_c) + (_R(0.625) * v3_c)
            v7 = s28 + (_R(0.5) * v4_c)
            v8 = v0_c + v1_c + v2_c + v3_c + v4_c
            if (
                (least <= b0_c <= most)
                and (least <= b1 <= most)
                and (least <= b2 <= most)
                and (least <= b3 <= most)
                and (least <= b4 <= most)
                and (least <= b5 <= most)
                and (least <= b6 <= most)
                and (least <= b7 <= most)
                and (-most2 <= s0_c <= most2)
                and (-most2 <= s1 <= most2)
                and (-most2 <= s2 <= most2)
                and (-most2 <= s3 <= most2)
                and (-most2 <= s4 <= most2)
                and (-most2 <= s5 <= most2)
                and (-most2 <= s6 <= most2)
                and (-most2 <= s7 <= most2)
                and (-most2 <= s8 <= most2)
                and (-most2 <= s9 <= most2)
                and (-most3 <= v0_c <= most3)
                and (-most3 <= v1 <= most3)
                and (-most3 <= v2 <= most3)
                and (-most3 <= v3 <= most3)
                and (-most3 <= v4 <= most3)
                and (-most3 <= v5 <= most3)
                and (-most3 <= v6 <= most3)
                and (-most3 <= v7 <= most3)
                and (-most3 <= v8 <= most3)
                and (np.abs((((-_R(72.0)) * w1) - (_R(360.0) * w2)) - (_R(720.0) * w3)) <= most)
                and (np.abs(((-_R(48.0)) * w1) - (_R(120.0) * w2)) <= most)
                and (np.abs((-_R(24.0)) * w1) <= most)
                and (np.abs((((-_R(0.01679999940097332)) * w1) - (_R(0.035999998450279236) * w2)) - (_R(0.035999998450279236) * w3)) <= most2)
                and (np.abs((((-_R(0.006000000052154064)) * w1) - (_R(0.006000000052154064) * w2)) + (_R(4.87890977618477e-18) * w3)) <= most2)
                and (np.abs(((-_R(0.0012000000569969416)) * w1) + (_R(4.87890977618477e-18) * w2) + (_R(4.87890977618477e-18) * w3)) <= most2)
                and (np.abs((_R(1.440000057220459) * w1) + (_R(4.800000190734863) * w2) + (_R(7.199999809265137) * w3)) <= most3)
                and (np.abs(((_R(0.7200000286102295) * w1) + (_R(1.2000000476837158) * w2)) - (_R(1.2490009027033011e-15) * w3)) <= most3)
                and (np.abs((_R(0.23999999463558197) * w1) + (_R(2.914335439641036e-15) * w2) + (_R(3.747002708109903e-15) * w3)) <= most3)
            ):
                fits = 1
            if not ((tried > 3) and (tried < 100001) and (fits == 1)):
                raise ValueError("k and samples and x, and what follows, must be finite")
            self._start = k
            self._last = samples

    def soonest(self, x: ArrayLike) -> int:
        """The fewest samples found, from the next call of `step` on, with which the law keeps u and
        the states within their limits at every sample to rest, from the state x, for sure. Give
        them to `arm_for`.

        ValueError where an argument is not finite, or where there is none.
        """
        with np.errstate(all="ignore"):
            x = _numbers(x, 3, "x")
            if not (np.isfinite(x[0]) and np.isfinite(x[1]) and np.isfinite(x[2])):
                raise ValueError("an argument, or what follows from it, is not finite")
            x1 = x[0]
            x2 = x[1]
            x3 = x[2]
            flat1 = (_S1_1 * x1) + (_S1_2 * x2) + (_S1_3 * x3)
            flat2 = (_S2_2 * x2) + (_S2_3 * x3)
            flat3 = _S3_3 * x3
            low = np.asarray(3)
            top = np.asarray(100001)
            kept = np.asarray(0)
            tried = np.asarray(4)
            for _ in range(64):
                least = _R(0.9949458837509155) * (-_U_MAX)
                most = _R(0.9949458837509155) * _U_MAX
                most2 = _R(0.49747294187545776)
                most3 = _R(3.979783535003662)
                fits = np.asarray(0)
                m = _R(tried)
                power1 = m + _R(3.0)
                power2 = power1 * (m + _R(2.0))
                power3 = power2 * (m + _R(1.0))
                power4 = power3 * m
                power5 = power4 * (m - _R(1.0))
                power6 = power5 * (m - _R(2.0))
                scaled2 = flat2 * power1
                scaled3 = flat3 * power2
                w1 = ((_R(15.0) * flat1) + (_R(5.0) * scaled2) + (_R(0.5) * scaled3)) / power4
                w2 = ((((-_R(24.0)) * flat1) - (_R(9.0) * scaled2)) - scaled3) / power5
                w3 = ((_R(10.0) * flat1) + (_R(4.0) * scaled2) + (_R(0.5) * scaled3)) / power6
                length = m - _R(4.0)
                b0_c = (((-_R(96.0)) * w1) - (_R(720.0) * w2)) - (_R(2880.0) * w3)
                b1_c = ((((-_R(24.0)) * w1) - (_R(420.0) * w2)) - (_R(3120.0) * w3)) * length
                b2_l = length * length
                b2_c = (((-_R(60.0)) * w2) - (_R(1080.0) * w3)) * b2_l
                b3_l = b2_l * length
                b3_c = (-_R(120.0)) * w3 * b3_l
                b1 = b0_c + (_R(0.1428571492433548) * b1_c)
                b2 = b0_c + (_R(0.2857142984867096) * b1_c) + (_R(0.0476190485060215) * b2_c)
                s10 = b0_c + (_R(0.4285714328289032) * b1_c) + (_R(0.1428571492433548) * b2_c)
                b3 = s10 + (_R(0.02857142873108387) * b3_c)
                s11 = b0_c + (_R(0.5714285969734192) * b1_c) + (_R(0.2857142984867096) * b2_c)
                b4 = s11 + (_R(0.11428571492433548) * b3_c)
                s12 = b0_c + (_R(0.7142857313156128) * b1_c) + (_R(0.4761904776096344) * b2_c)
                b5 = s12 + (_R(0.2857142984867096) * b3_c)
                s13 = b0_c + (_R(0.8571428656578064) * b1_c) + (_R(0.7142857313156128) * b2_c)
                b6 = s13 + (_R(0.5714285969734192) * b3_c)
                b7 = b0_c + b1_c + b2_c + b3_c
                s0_c = (((-_R(0.035999998450279236)) * w1) - (_R(0.11999999731779099) * w2)) - (_R(0.25200000405311584) * w3)
                s1_c = ((((-_R(0.02419999986886978)) * w1) - (_R(0.12399999797344208) * w2)) - (_R(0.3953999876976013) * w3)) * length
                s2_l = length * length
                s2_c = ((((-_R(0.005400000140070915)) * w1) - (_R(0.04749999940395355) * w2)) - (_R(0.24150000512599945) * w3)) * s2_l
                s3_l = s2_l * length
                s3_c = ((((-_R(0.00039999998989515007)) * w1) - (_R(0.00800000037997961) * w2)) - (_R(0.07199999690055847) * w3)) * s3_l
                s4_l = s3_l * length
                s4_c = (((-_R(0.0005000000237487257)) * w2) - (_R(0.010499999858438969) * w3)) * s4_l
                s5_l = s4_l * length
                s5_c = (-_R(0.0006000000284984708)) * w3 * s5_l
                s1 = s0_c + (_R(0.1111111119389534) * s1_c)
                s2 = s0_c + (_R(0.2222222238779068) * s1_c) + (_R(0.02777777798473835) * s2_c)
                s14 = s0_c + (_R(0.3333333432674408) * s1_c) + (_R(0.0833333358168602) * s2_c)
                s3 = s14 + (_R(0.011904762126505375) * s3_c)
                s15 = s0_c + (_R(0.4444444477558136) * s1_c) + (_R(0.1666666716337204) * s2_c)
                s4 = s15 + (_R(0.0476190485060215) * s3_c) + (_R(0.007936508394777775) * s4_c)
                s16 = s0_c + (_R(0.5555555820465088) * s1_c) + (_R(0.2777777910232544) * s2_c)
                s17 = s16 + (_R(0.1190476194024086) * s3_c) + (_R(0.0396825410425663) * s4_c)
                s5 = s17 + (_R(0.007936508394777775) * s5_c)
                s18 = s0_c + (_R(0.6666666865348816) * s1_c) + (_R(0.4166666567325592) * s2_c)
                s19 = s18 + (_R(0.2380952388048172) * s3_c) + (_R(0.1190476194024086) * s4_c)
                s6 = s19 + (_R(0.0476190485060215) * s5_c)
                s20 = s0_c + (_R(0.7777777910232544) * s1_c) + (_R(0.5833333134651184) * s2_c)
                s21 = s20 + (_R(0.4166666567325592) * s3_c) + (_R(0.2777777910232544) * s4_c)
                s7 = s21 + (_R(0.1666666716337204) * s5_c)
                s22 = s0_c + (_R(0.8888888955116272) * s1_c) + (_R(0.7777777910232544) * s2_c)
                s23 = s22 + (_R(0.6666666865348816) * s3_c) + (_R(0.5555555820465088) * s4_c)
                s8 = s23 + (_R(0.4444444477558136) * s5_c)
                s9 = s0_c + s1_c + s2_c + s3_c + s4_c + s5_c
                v0_c = (_R(2.4000000953674316) * w1) + (_R(12.0) * w2) + (_R(36.0) * w3)
                v1_c = ((_R(1.0800000429153442) * w1) + (_R(9.399999618530273) * w2) + (_R(46.20000076293945) * w3)) * length
                v2_l = length * length
                v2_c = ((_R(0.11999999731779099) * w1) + (_R(2.4000000953674316) * w2) + (_R(21.299999237060547) * w3)) * v2_l
                v3_l = v2_l * length
                v3_c = ((_R(0.20000000298023224) * w2) + (_R(4.199999809265137) * w3)) * v3_l
                v4_l = v3_l * length
                v4_c = _R(0.30000001192092896) * w3 * v4_l
                v1 = v0_c + (_R(0.125) * v1_c)
                v2 = v0_c + (_R(0.25) * v1_c) + (_R(0.0357142873108387) * v2_c)
                s24 = v0_c + (_R(0.375) * v1_c) + (_R(0.1071428582072258) * v2_c)
                v3 = s24 + (_R(0.01785714365541935) * v3_c)
                s25 = v0_c + (_R(0.5) * v1_c) + (_R(0.2142857164144516) * v2_c) + (_R(0.0714285746216774) * v3_c)
                v4 = s25 + (_R(0.014285714365541935) * v4_c)
                s26 = v0_c + (_R(0.625) * v1_c) + (_R(0.3571428656578064) * v2_c) + (_R(0.1785714328289032) * v3_c)
                v5 = s26 + (_R(0.0714285746216774) * v4_c)
                s27 = v0_c + (_R(0.75) * v1_c) + (_R(0.5357142686843872) * v2_c) + (_R(0.3571428656578064) * v3_c)
                v6 = s27 + (_R(0.2142857164144516) * v4_c)
                s28 = v0_c + (_R(0.875) * v1_c) + (_R(0.75) * v2_c) + (_R(0.625) * v3_c)
                v7 = s28 + (_R(0.5) * v4_c)
                v8 = v0_c + v1_c + v2_c + v3_c + v4_c
                if (
                    (least <= b0_c <= most)
                    and (least <= b1 <= most)
                    and (least <= b2 <= most)
                    and (least <= b3 <= most)
                    and (least <= b4 <= most)
                    and (least <= b5 <= most)
                    and (least <= b6 <= most)
                    and (least <= b7 <= most)
                    and (-most2 <= s0_c <= most2)
                    and (-most2 <= s1 <= most2)
                    and (-most2 <= s2 <= most2)
                    and (-most2 <= s3 <= most2)
                    and (-most2 <= s4 <= most2)
                    and (-most2 <= s5 <= most2)
                    and (-most2 <= s6 <= most2)
                    and (-most2 <= s7 <= most2)
                    and (-most2 <= s8 <= most2)
                    and (-most2 <= s9 <= most2)
                    and (-most3 <= v0_c <= most3)
                    and (-most3 <= v1 <= most3)
                    and (-most3 <= v2 <= most3)
                    and (-most3 <= v3 <= most3)
                    and (-most3 <= v4 <= most3)
                    and (-most3 <= v5 <= most3)
                    and (-most3 <= v6 <= most3)
                    and (-most3 <= v7 <= most3)
                    and (-most3 <= v8 <= most3)
                    and (np.abs((((-_R(72.0)) * w1) - (_R(360.0) * w2)) - (_R(720.0) * w3)) <= most)
                    and (np.abs(((-_R(48.0)) * w1) - (_R(120.0) * w2)) <= most)
                    and (np.abs((-_R(24.0)) * w1) <= most)
                    and (np.abs((((-_R(0.01679999940097332)) * w1) - (_R(0.035999998450279236) * w2)) - (_R(0.035999998450279236) * w3)) <= most2)
                    and (np.abs((((-_R(0.006000000052154064)) * w1) - (_R(0.006000000052154064) * w2)) + (_R(4.87890977618477e-18) * w3)) <= most2)
                    and (np.abs(((-_R(0.0012000000569969416)) * w1) + (_R(4.87890977618477e-18) * w2) + (_R(4.87890977618477e-18) * w3)) <= most2)
                    and (np.abs((_R(1.440000057220459) * w1) + (_R(4.800000190734863) * w2) + (_R(7.199999809265137) * w3)) <= most3)
                    and (np.abs(((_R(0.7200000286102295) * w1) + (_R(1.2000000476837158) * w2)) - (_R(1.2490009027033011e-15) * w3)) <= most3)
                    and (np.abs((_R(0.23999999463558197) * w1) + (_R(2.914335439641036e-15) * w2) + (_R(3.747002708109903e-15) * w3)) <= most3)
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
