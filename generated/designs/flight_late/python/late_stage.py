"""
Prescribed-time controller late_stage: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name late_stage --clock samples --delay-law=predict --poles-end="least-energy(weight=1)" --end-samples=50 --late=extend --reserve=0.1 --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=200 --observer-eps=0.03 --tau=0.8 --eps=0.02 --u-max=6 --poles=least-energy --g="2/3" --sample-time=1e-3 --delay=1 --sensor-step=1e-6,0
Version 0.1.0, design ccd999de2243.

Plant: x1' = x2, x2' = g (u + d), d constant and unknown; u held from sample to sample, one
      sample late.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law of the state x predicted for the time from which u acts, by x and the inputs under way:
      with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
      the rows are those of Theorem 1 for the mapping exp. From 50 samples to go on these
      are M - 2 and the exponents 3, 4, those of least energy. The gains of 21 samples to
      go stay.

Parameters:
  samples = 800 [samples], fixed: samples N from the start to rest
  h = 1e-3 [s], fixed: sample period
  eps = 0.02 [s], fixed: time-to-go at which the gains are held
  u_max = 6 [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time
  k_1 = 6 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
  k_2 = 5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
The estimates are exact from sample 200 after the start on where the measurement is; with
      noise or sensor_step given, or observer_eps, the gains of the observer are then held
      below deadbeat.
In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
      else stays as it is.
Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
      so their Bernstein coefficients, linear in z, bound them. If these are within the
      limits, u stay there at every sample to rest, where plant and state are as they are
      known.
late extend: a step without such a plan raises N to the soonest that has one (status LATE;
      deadline gives its tick). Where none is found (status INFEASIBLE), or 2^31 samples
      after the start, N stays, and u is clipped; states may leave their bounds then.
reserve: a new deadline leaves 0.1 of each limit free.
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: near rest at sample 800, not at rest: the gains are held from 20 samples
      to go, and |u| is bounded; so does what the held observer leaves of its error.
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

__all__ = ["Control", "LateStage", "Params", "Status"]

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

# 1/1000, prediction of x1 from x2.
_PHI1_2 = _R(0.001)
# 1/3000000, prediction of x1 from d.
_PHI1_3 = _R(3.3333333333333335e-7)
# 1/3000000, prediction from u.
_GAMMA1 = _R(3.3333333333333335e-7)
# 1/1500, prediction of x2 from d.
_PHI2_3 = _R(0.0006666666666666666)
# 1/1500, prediction from u.
_GAMMA2 = _R(0.0006666666666666666)
# Samples to go at which the observer is held.
_HOLD_O = _R(30.0)
# Weight in the observer's gain l1.
_Q1_1 = _R(120.0)
# Weight in the observer's gain l1.
_Q1_2 = _R(-60.0)
# Weight in the observer's gain l1.
_Q1_3 = _R(12.0)
# Weight in the observer's gain l2.
_Q2_1 = _R(-108000.0)
# Weight in the observer's gain l2.
_Q2_2 = _R(36000.0)
# Weight in the observer's gain l3.
_Q3_1 = _R(36000000.0)
# Weight of x1 in the law.
_S1_1 = _R(1500000.0)
# Weight of x2 in the law.
_S1_2 = _R(750.0)
# Weight of x2 in the law.
_S2_2 = _R(1500.0)
# Bound of |u|.
_U_MAX = _R(6.0)
# Samples to go at which the gains are held.
_HOLD = _R(20.0)
# Samples to go at which the law of the end takes over.
_END_SAMPLES = _R(50.0)
# Weight of x1 in the law.
_W1_1 = _R(-9000000.0)
# Weight of x2 in the law.
_W1_2 = _R(-4500.0)
# Weight of x2 in the law.
_W2_2 = _R(-6000.0)
# Weight of u1 in the law.
_W2_3 = _R(-4.0)
# Weight of x1 in the law.
_END1_1 = _R(-18000000.0)
# Weight of x2 in the law.
_END1_2 = _R(-9000.0)
# Weight of x2 in the law.
_END2_2 = _R(-9000.0)
# Weight of u1 in the law.
_END2_3 = _R(-6.0)
# -1/1000, a state of a sample ago.
_BACK1_2 = _R(-0.001)
# 1/3000000, a state of a sample ago.
_BACK1_3 = _R(3.3333333333333335e-7)
# -1/1500, a state of a sample ago.
_BACK2_3 = _R(-0.0006666666666666666)

class LateStage:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            self._start = 0
            self._last = 800
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._round = 200
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._d_hat = _R(0.0)

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept. Estimates too large to compute with begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        self._last = 800
        self._round = 200
        size = np.abs(self._x1_hat) + np.abs(self._x2_hat) + np.abs(self._d_hat)
        if not (size <= 1e150):
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x2_hat = _R(0.0)
            self._d_hat = _R(0.0)

    def step(self, k: int, y: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
        each tick.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            y = _numbers(y, 1, "y")
            if not np.isfinite(y[0]):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP

            # Predict.
            s1 = self._x1_hat + (_PHI1_2 * self._x2_hat)
            s2 = s1 + (_PHI1_3 * self._d_hat)
            p1 = s2 + (_GAMMA1 * self._u2)
            s3 = self._x2_hat + (_PHI2_3 * self._d_hat)
            p2 = s3 + (_GAMMA2 * self._u2)
            p3 = self._d_hat

            # Correct by what is measured.
            if self._seen == 0:
                base = y[0]
                miss = _R(0.0)
            else:
                base = p1
                miss = y[0] - p1
            left_o = max(self._round - elapsed, 0)
            o0 = max(_R(left_o), _HOLD_O)
            o0f2 = o0 * (o0 - 1.0)
            r0 = 1.0 / (o0f2 * (o0 - 2.0))
            l1 = (_Q1_1 + (_Q1_2 * o0) + (_Q1_3 * o0f2)) * r0
            l2 = (_Q2_1 + (_Q2_2 * o0)) * r0
            l3 = _Q3_1 * r0
            x1 = base + (l1 * miss)
            x2 = p2 + (l2 * miss)
            d = p3 + (l3 * miss)

            # The deadline that keeps the limits.
            last_now = np.asarray(self._last)
            late = np.asarray(0)
            to_rest = max(self._last - elapsed, 0)
            ahead = max(to_rest - 1, 0)
            flat1 = (_S1_1 * x1) + (_S1_2 * x2)
            flat2 = (_S2_2 * x2) + (self._u1 + d)
            low = np.asarray(max(ahead - 1, 0))
            top = np.asarray(1073741825)
            kept = np.asarray(0)
            tried = np.asarray(ahead)
            part = np.asarray(0.9999999999998739)
            for _ in range(64):
                least = ((-_U_MAX) * part) + d
                most = (_U_MAX * part) + d
                within = -least if -least < most else most
                fits = np.asarray(0)
                if tried > 50:
                    m = _R(tried)
                    power1 = m + 1.0
                    power2 = power1 * m
                    power3 = power2 * (m - 1.0)
                    scaled2 = flat2 * power1
                    w1 = ((3.0 * flat1) + scaled2) / power2
                    w2 = (((-2.0) * flat1) - scaled2) / power3
                    length = m - 51.0
                    b0_c = (2.0 * w1) + (300.0 * w2)
                    b1_c = 6.0 * w2 * length
                    b1 = b0_c + b1_c
                    end11 = (2.8506787330316743 * w1) + (117.44796380090497 * w2)
                    end12 = (3.0475113122171944 * w1) + (145.85746606334843 * w2)
                    end13 = (2.9906485671191554 * w1) + (175.02805429864253 * w2)
                    end14 = (2.6800904977375564 * w1) + (204.95972850678734 * w2)
                    end15 = (2.1158371040723982 * w1) + (235.6524886877828 * w2)
                    end16 = (1.2978883861236803 * w1) + (267.10633484162895 * w2)
                    end17 = (0.22624434389140272 * w1) + (299.3212669683258 * w2)
                    if (
                        (least <= b0_c <= most)
                        and (least <= b1 <= most)
                        and (least <= end11 <= most)
                        and (least <= end12 <= most)
                        and (least <= end13 <= most)
                        and (least <= end14 <= most)
                        and (least <= end15 <= most)
                        and (least <= end16 <= most)
                        and (least <= end17 <= most)
                        and (np.abs((2.8054298642533926 * w1) + (111.58371040723979 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((2.583924302196364 * w1) + (85.00144425360725 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((1.9885945165034657 * w1) + (61.86959300518941 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((2.9380703330283167 * w1) + (105.39729178384643 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((2.395997187424203 * w1) + (77.20565274199532 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((2.8712027904432142 * w1) + (99.5000219686458 * w2)) <= 0.9850746268656713 * within)
                    ):
                        fits = 1
                elif tried > 20:
                    m = _R(tried)
                    power1 = m + 2.0
                    power2 = power1 * (m + 1.0)
                    power3 = power2 * m
                    power4 = power3 * (m - 1.0)
                    scaled2 = flat2 * power1
                    w1 = ((4.0 * flat1) + scaled2) / power3
                    w2 = (((-3.0) * flat1) - scaled2) / power4
                    length = m - 21.0
                    b0_c = (126.0 * w1) + (5040.0 * w2)
                    b1_c = ((6.0 * w1) + (492.0 * w2)) * length
                    b2_l = length * length
                    b2_c = 12.0 * w2 * b2_l
                    b1 = b0_c + (0.16666666666666666 * b1_c)
                    s4 = b0_c + (0.3333333333333333 * b1_c)
                    b2 = s4 + (0.06666666666666667 * b2_c)
                    b3 = b0_c + (0.5 * b1_c) + (0.2 * b2_c)
                    b4 = b0_c + (0.6666666666666666 * b1_c) + (0.4 * b2_c)
                    s5 = b0_c + (0.8333333333333334 * b1_c)
                    b5 = s5 + (0.6666666666666666 * b2_c)
                    b6 = b0_c + b1_c + b2_c
                    if (
                        (least <= b0_c <= most)
                        and (least <= b1 <= most)
                        and (least <= b2 <= most)
                        and (least <= b3 <= most)
                        and (least <= b4 <= most)
                        and (least <= b5 <= most)
                        and (least <= b6 <= most)
                        and (np.abs((119.99999999999996 * w1) + (4559.999999999999 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((92.75321716019634 * w1) + (2422.754466594877 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((67.8353765546998 * w1) + (1509.7849977027897 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((114.21150278293138 * w1) + (3629.3877551020414 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((84.39364430426792 * w1) + (2085.179889377806 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((108.11363033997543 * w1) + (3196.9332337421392 * w2)) <= 0.9850746268656713 * within)
                    ):
                        fits = 1
                elif (
                    (np.abs(((-0.025974025974025976) * flat1) - (0.2857142857142857 * flat2)) <= 0.9850746268656713 * within)
                    and (np.abs(((-0.0012475444042476065) * flat1) - (0.08276232337733669 * flat2)) <= 0.9850746268656713 * within)
                    and (np.abs((0.0035664936491730252 * flat1) - (0.02768331367963576 * flat2)) <= 0.9850746268656713 * within)
                    and (np.abs(((-0.012577404043081223) * flat1) - (0.18287834614365228 * flat2)) <= 0.9850746268656713 * within)
                    and (np.abs((0.000902126332826074 * flat1) - (0.060363489673773814 * flat2)) <= 0.9850746268656713 * within)
                    and (np.abs(((-0.007827317130259085) * flat1) - (0.14320479414568998 * flat2)) <= 0.9850746268656713 * within)
                ):
                    fits = 1
                if fits == 1:
                    kept = tried
                    top = tried
                elif tried > 20:
                    low = tried
                else:
                    low = 20
                gap = max(top - low, 0)
                if gap < 2:
                    break
                half = gap // 2
                if low < half:
                    tried = low + low
                else:
                    tried = low + half
                part = _R(0.899999999999773)
            if (ahead < kept) and (elapsed < 2147483648):
                last_now = (elapsed + kept) + 1
            if (kept == 0) and (ahead > 0):
                late = 2
            if last_now > self._last:
                late = 1
            left = max(last_now - elapsed, 0)
            s6 = _R(left) - 1.0
            m0 = max(s6, _HOLD)
            if m0 > _END_SAMPLES:
                # The exact law in samples.
                z1 = (_W1_1 * x1) + (_W1_2 * x2)
                z2 = (_W2_2 * x2) + (_W2_3 * (self._u1 + d))
                m0f1 = m0 + 1.0
                v = ((z1 + (z2 * m0f1)) / (m0f1 * m0)) - d
            else:
                # The law of least energy to the end.
                m1 = max(m0, _R(2.0))
                y1 = (_END1_1 * x1) + (_END1_2 * x2)
                y2 = (_END2_2 * x2) + (_END2_3 * (self._u1 + d))
                m1f1 = m1 + 2.0
                v = ((y1 + (y2 * m1f1)) / (m1f1 * (m1 + 1.0))) - d
            if not np.isfinite(v):
                return Control(_R(0.0), Status.RANGE)
            if v > _U_MAX:
                u_now = _U_MAX
            elif v < -_U_MAX:
                u_now = -_U_MAX
            else:
                u_now = v
            self._u2 = self._u1
            self._u1 = u_now
            self._last = last_now
            self._x1_hat = x1
            self._x2_hat = x2
            self._d_hat = d
            self._seen = 1
            if (v > _U_MAX) or (v < -_U_MAX):
                return Control(u_now, Status.SATURATED)
            elif _R(left) - 1.0 <= _HOLD:
                return Control(u_now, Status.HOLD)
            elif late == 2:
                return Control(u_now, Status.INFEASIBLE)
            elif late == 1:
                return Control(u_now, Status.LATE)
            else:
                return Control(u_now, Status.OK)

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
            elapsed = (k - self._start) & _WRAP
            self._round = max(self._round - elapsed, 0)
            self._start = k
            self._last = samples

    def soonest(self) -> int:
        """The fewest samples found, from the next call of `step` on, with which the law keeps u and
        the states within their limits at every sample to rest, from the estimates as they are
        predicted for the next tick, for sure. Give them to `arm_for`.

        ValueError where an argument is not finite, or where there is none.
        """
        with np.errstate(all="ignore"):
            s1 = self._x1_hat + (_PHI1_2 * self._x2_hat)
            s2 = s1 + (_PHI1_3 * self._d_hat)
            p1 = s2 + (_GAMMA1 * self._u2)
            s3 = self._x2_hat + (_PHI2_3 * self._d_hat)
            p2 = s3 + (_GAMMA2 * self._u2)
            p3 = self._d_hat
            x1 = p1
            x2 = p2
            d = p3
            flat1 = (_S1_1 * x1) + (_S1_2 * x2)
            flat2 = (_S2_2 * x2) + (self._u1 + d)
            low = np.asarray(20)
            top = np.asarray(1073741825)
            kept = np.asarray(0)
            tried = np.asarray(21)
            for _ in range(64):
                least = (0.899999999999773 * (-_U_MAX)) + d
                most = (0.899999999999773 * _U_MAX) + d
                within = -least if -least < most else most
                fits = np.asarray(0)
                if tried > 50:
                    m = _R(tried)
                    power1 = m + 1.0
                    power2 = power1 * m
                    power3 = power2 * (m - 1.0)
                    scaled2 = flat2 * power1
                    w1 = ((3.0 * flat1) + scaled2) / power2
                    w2 = (((-2.0) * flat1) - scaled2) / power3
                    length = m - 51.0
                    b0_c = (2.0 * w1) + (300.0 * w2)
                    b1_c = 6.0 * w2 * length
                    b1 = b0_c + b1_c
                    end11 = (2.8506787330316743 * w1) + (117.44796380090497 * w2)
                    end12 = (3.0475113122171944 * w1) + (145.85746606334843 * w2)
                    end13 = (2.9906485671191554 * w1) + (175.02805429864253 * w2)
                    end14 = (2.6800904977375564 * w1) + (204.95972850678734 * w2)
                    end15 = (2.1158371040723982 * w1) + (235.6524886877828 * w2)
                    end16 = (1.2978883861236803 * w1) + (267.10633484162895 * w2)
                    end17 = (0.22624434389140272 * w1) + (299.3212669683258 * w2)
                    if (
                        (least <= b0_c <= most)
                        and (least <= b1 <= most)
                        and (least <= end11 <= most)
                        and (least <= end12 <= most)
                        and (least <= end13 <= most)
                        and (least <= end14 <= most)
                        and (least <= end15 <= most)
                        and (least <= end16 <= most)
                        and (least <= end17 <= most)
                        and (np.abs((2.8054298642533926 * w1) + (111.58371040723979 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((2.583924302196364 * w1) + (85.00144425360725 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((1.9885945165034657 * w1) + (61.86959300518941 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((2.9380703330283167 * w1) + (105.39729178384643 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((2.395997187424203 * w1) + (77.20565274199532 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((2.8712027904432142 * w1) + (99.5000219686458 * w2)) <= 0.9850746268656713 * within)
                    ):
                        fits = 1
                else:
                    m = _R(tried)
                    power1 = m + 2.0
                    power2 = power1 * (m + 1.0)
                    power3 = power2 * m
                    power4 = power3 * (m - 1.0)
                    scaled2 = flat2 * power1
                    w1 = ((4.0 * flat1) + scaled2) / power3
                    w2 = (((-3.0) * flat1) - scaled2) / power4
                    length = m - 21.0
                    b0_c = (126.0 * w1) + (5040.0 * w2)
                    b1_c = ((6.0 * w1) + (492.0 * w2)) * length
                    b2_l = length * length
                    b2_c = 12.0 * w2 * b2_l
                    b1 = b0_c + (0.16666666666666666 * b1_c)
                    s4 = b0_c + (0.3333333333333333 * b1_c)
                    b2 = s4 + (0.06666666666666667 * b2_c)
                    b3 = b0_c + (0.5 * b1_c) + (0.2 * b2_c)
                    b4 = b0_c + (0.6666666666666666 * b1_c) + (0.4 * b2_c)
                    s5 = b0_c + (0.8333333333333334 * b1_c)
                    b5 = s5 + (0.6666666666666666 * b2_c)
                    b6 = b0_c + b1_c + b2_c
                    if (
                        (least <= b0_c <= most)
                        and (least <= b1 <= most)
                        and (least <= b2 <= most)
                        and (least <= b3 <= most)
                        and (least <= b4 <= most)
                        and (least <= b5 <= most)
                        and (least <= b6 <= most)
                        and (np.abs((119.99999999999996 * w1) + (4559.999999999999 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((92.75321716019634 * w1) + (2422.754466594877 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((67.8353765546998 * w1) + (1509.7849977027897 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((114.21150278293138 * w1) + (3629.3877551020414 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((84.39364430426792 * w1) + (2085.179889377806 * w2)) <= 0.9850746268656713 * within)
                        and (np.abs((108.11363033997543 * w1) + (3196.9332337421392 * w2)) <= 0.9850746268656713 * within)
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
            if np.isfinite(flat1) and np.isfinite(flat2):
                if kept > 0:
                    return int(kept + 1)
                else:
                    raise ValueError("no number of samples was found that keeps the limits")
            else:
                raise ValueError("an argument, or what follows from it, is not finite")

    def deadline(self) -> int:
        """The tick at which the loop is to be at rest."""
        return int((self._start - ((0 - self._last) & _WRAP)) & _WRAP)

    def move(self, dx: float) -> None:
        """The target moves by `dx`: from now on y is measured from the new one, and so are the
        estimates.

        ValueError where an argument or what follows from it is not finite; the controller
        is left as it was.
        """
        with np.errstate(all="ignore"):
            dx = _R(dx)
            moved = self._x1_hat - dx
            if not np.isfinite(moved):
                raise ValueError("dx, and what follows, must be finite")
            self._x1_hat = moved

    def assume(self, xhat: ArrayLike) -> None:
        """The estimates at the tick of the next call are known: it corrects them by what is
        measured then.

        ValueError where an argument or what follows from it is not finite; the controller
        is left as it was.
        """
        with np.errstate(all="ignore"):
            xhat = _numbers(xhat, 2, "xhat")
            g1 = xhat[0] - (_GAMMA1 * self._u2)
            g2 = xhat[1] - (_GAMMA2 * self._u2)
            n1 = g1 + (_BACK1_2 * g2) + (_BACK1_3 * self._d_hat)
            n2 = g2 + (_BACK2_3 * self._d_hat)
            if not (np.isfinite(n1) and np.isfinite(n2)):
                raise ValueError("xhat, and what follows, must be finite")
            self._x1_hat = n1
            self._x2_hat = n2
            self._seen = 1

    def assume_disturbance(self, d: float) -> None:
        """The constant that is added to u is known.

        ValueError where an argument or what follows from it is not finite; the controller
        is left as it was.
        """
        with np.errstate(all="ignore"):
            d = _R(d)
            if not np.isfinite(d):
                raise ValueError("d, and what follows, must be finite")
            self._d_hat = d

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

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the constant that is added to u."""
        return self._d_hat
