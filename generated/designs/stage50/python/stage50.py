"""
Prescribed-time controller stage50: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name stage50 --clock samples --A="[[-1,1],[3,-2]]" --B="[1,2]" --output="[-2,1]" --tau=0.2 --eps=0 --poles="least-energy(weight=1)" --reference input --sample-time=0.01
Version 0.1.0, design e09f892711c5.

Plant: x' = A x + B u of --A and --B above; u held from sample to sample.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
      sum of u^2/M. The gains are a table of 320 bytes: a row for each of them. The gains
      of 2 samples to go stay: they are deadbeat.
With the reference r with its derivatives r[0]..r[1] at tick k, x - x_r is in place of x
      above, and u = w + u_r: with them the output y = -2*x1 + x2 is r, and stays so. At
      sample N x = x_r where u_r is constant over each sample; else an error of order
      h^(4-i) is left in y^(i-1).
r[2] is r^(2) over the sample in which u acts: its mean, (r^(1)(t + h) - r^(1)(t))/h, or
      that in its middle. u_r is the mean over that sample. To four digits, the last at one
      time:
  x_r1 = -1.333*r - 0.3333*r^(1)
  x_r2 = -1.667*r - 0.6667*r^(1)
  u_r = 0.3333*r - r^(1) - 0.3333*r^(2)

Parameters:
  samples = 20 [samples], fixed: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample 20 from any state, but for what r does between samples,
      and |u| is bounded.
  sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
  deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
  loop: not checked: `x0_max` is not given.
  envelope: not checked: it does not examine a clock in samples.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Control", "Params", "Stage50", "Status"]

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
    """bound of |u| [unit of u], > 0, infinity allowed"""

def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    """The numbers of a sequence of this length."""
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f"{name} has shape {numbers.shape}; legal: ({length},)")
    return numbers

# Samples from the start to rest.
_SAMPLES = 20

# Gains of least energy of each state, a row for the samples to go of a node.
_GAINS = np.array(
    [
        [-6519.426971737549, 3185.2084972182897],
        [-3857.2972468681514, 1869.370005740587],
        [-2535.8123523502322, 1218.7874484331383],
        [-1786.1499004408652, 851.2162504195531],
        [-1321.0288432240525, 624.1015587650261],
        [-1013.2253140462395, 474.4353779733671],
        [-799.355679292144, 370.8885689114117],
        [-644.9715751559836, 296.46788779068544],
        [-530.0507637726341, 241.31624608777554],
        [-442.31657026726884, 199.40198143585195],
        [-373.9055837746926, 166.86960699606502],
        [-319.59468864669316, 141.16347188259604],
        [-275.80616425447823, 120.53665432938753],
        [-240.02385825378445, 103.76315424562416],
        [-210.4372644374064, 89.96267023338274],
        [-185.7172734991974, 78.4903488691879],
        [-164.8707644351536, 68.86539241539502],
        [-147.1439010804336, 60.72364441333584],
        [-131.95635856841344, 53.785384714229195],
        [-118.85567957234355, 47.83301161237331],
    ],
    dtype=_R,
)

class Stage50:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            given_u_max = _R(params.u_max)
            if not (given_u_max > 0.0):
                raise ValueError(f"params.u_max is {params.u_max}; legal: > 0")
            u_max = given_u_max
            self._start = 0
            self._u_max = u_max

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`."""
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike, r: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and the state x, and the reference.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 2, "x")
            r = _numbers(r, 3, "r")
            if not (
                np.isfinite(x[0])
                and np.isfinite(x[1])
                and np.isfinite(r[0])
                and np.isfinite(r[1])
                and np.isfinite(r[2])
            ):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP
            x1 = x[0]
            x2 = x[1]

            # The tracking error.
            s1 = (0.3333333333333333 * r[0]) - (0.9983333333333333 * r[1])
            u_r = s1 - (0.3383277777777778 * r[2])
            e1 = x1 - (((-1.3333333333333333) * r[0]) - (0.3333333333333333 * r[1]))
            e2 = x2 - (((-1.6666666666666667) * r[0]) - (0.6666666666666666 * r[1]))
            left = max(_SAMPLES - elapsed, 0)
            if left > 2:
                to_go = left
            else:
                to_go = 2
            row = (to_go - 2) & _WRAP

            # The law of least energy.
            v = (_GAINS[row, 0] * e1) + (_GAINS[row, 1] * e2) + u_r
            if np.isfinite(v):
                if v > self._u_max:
                    return Control(self._u_max, Status.SATURATED)
                elif v < -self._u_max:
                    return Control(-self._u_max, Status.SATURATED)
                elif elapsed < _SAMPLES:
                    return Control(v, Status.OK)
                else:
                    return Control(v, Status.HOLD)
            else:
                return Control(_R(0.0), Status.RANGE)
