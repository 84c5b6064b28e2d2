"""
Prescribed-time controller stage49: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name stage49 --clock samples --A="[[0,1],[-4,-0.2]]" --B="[0,1]" --delay-law=extend --poles-end="least-energy(weight=2)" --end-samples=50 --precision f32 --guard none --tau=1.7 --eps=0 --poles=least-energy --gain-bytes=300 --after zero --sample-time=0.01 --delay=2
Version 0.1.0, design 50fbb26d547a.

Plant: x' = A x + B u of --A and --B above; u held from sample to sample, 2 samples late.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
      sum of u^2. From 50 samples to go on it is that of u^2/(M ... (M+1)). The gains are a
      table of 224 bytes: exact below 8 samples to go, and before it those of a grid of 14
      nodes, interpolated in a line. The gains of 4 samples to go stay: they are deadbeat.

Parameters:
  samples = 170 [samples], fixed: samples N from the start to rest
  h = 0.01 [s], fixed: sample period
  eps = 0 [s], fixed: time-to-go at which the gains are held
  u_max [unit of u]: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on u = 0 (status AFTER).
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard none: finite measurements are the responsibility of the caller.
Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: at rest at sample 170 from any state, and |u| is bounded.
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

__all__ = ["Control", "Params", "Stage49", "Status"]

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

# Samples from the start to rest.
_SAMPLES = 170

# Gains of least energy of each state, a row for the samples to go of a node.
_GAINS = np.array(
    [
        [-_R(9986.376953125), -_R(348.8790283203125), -_R(1.9976024627685547), -_R(2.992413282394409)],
        [-_R(5777.1005859375), -_R(233.3048858642578), -_R(1.4711980819702148), -_R(2.046189785003662)],
        [-_R(3881.34033203125), -_R(176.58560180664063), -_R(1.1873255968093872), -_R(1.5733152627944946)],
        [-_R(2833.622802734375), -_R(142.71356201171875), -_R(1.0051219463348389), -_R(1.286697506904602)],
        [-_R(2181.096435546875), -_R(120.08089447021484), -_R(0.876236081123352), -_R(1.0928064584732056)],
        [-_R(1018.34033203125), -_R(74.13645935058594), -_R(0.5902820825576782), -_R(0.6911076903343201)],
        [-_R(599.1994018554688), -_R(53.811737060546875), -_R(0.4494777023792267), -_R(0.5086409449577332)],
        [-_R(281.4622497558594), -_R(34.71470260620117), -_R(0.3057497441768646), -_R(0.3333892226219177)],
        [-_R(162.4026336669922), -_R(25.523401260375977), -_R(0.23148728907108307), -_R(0.24734710156917572)],
        [-_R(72.5916748046875), -_R(16.511924743652344), -_R(0.1546342819929123), -_R(0.16164158284664154)],
        [-_R(10.503920555114746), -_R(5.748264312744141), -_R(0.05605069920420647), -_R(0.057010799646377563)],
        [-_R(2.4759387969970703), -_R(3.1387977600097656), -_R(0.031095704063773155), -_R(0.031293418258428574)],
        [-_R(0.28713130950927734), -_R(1.8002805709838867), -_R(0.01800534874200821), -_R(0.0180052537471056)],
        [-_R(0.12725500762462616), -_R(0.7570639252662659), -_R(0.007570731453597546), -_R(0.007571342866867781)],
    ],
    dtype=_R,
)

class Stage49:
    """The controller. Takes the parameters and arms at tick 0.

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
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k

    def step(self, k: int, x: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and the state x. Call it once for each tick.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            x = _numbers(x, 2, "x")
            elapsed = (k - self._start) & _WRAP
            x1 = x[0]
            x2 = x[1]
            left = max(_SAMPLES - elapsed, 0)
            if left > 4:
                to_go = left
            else:
                to_go = 4

            # Its place between the nodes of the table.
            if to_go < 8:
                row = (to_go - 4) & _WRAP
                part = _R(0.0)
            elif to_go < 16:
                row = (to_go // 4) + 2
                part = (_R(0.25) * _R(to_go)) - _R(to_go // 4)
            elif to_go < 32:
                row = (to_go // 8) + 4
                part = (_R(0.125) * _R(to_go)) - _R(to_go // 8)
            elif to_go < 64:
                row = (to_go // 16) + 6
                part = (_R(0.0625) * _R(to_go)) - _R(to_go // 16)
            elif to_go < 128:
                row = (to_go // 32) + 8
                part = (_R(0.03125) * _R(to_go)) - _R(to_go // 32)
            else:
                row = (to_go // 64) + 10
                part = (_R(0.015625) * _R(to_go)) - _R(to_go // 64)

            # The law of least energy.
            above = row + 1
            s1 = part * (_GAINS[above, 0] - _GAINS[row, 0])
            s2 = part * (_GAINS[above, 1] - _GAINS[row, 1])
            s3 = (_GAINS[row, 0] + s1) * x1
            s4 = part * (_GAINS[above, 2] - _GAINS[row, 2])
            s5 = (_GAINS[row, 2] + s4) * self._u1
            s6 = part * (_GAINS[above, 3] - _GAINS[row, 3])
            s7 = s3 + ((_GAINS[row, 1] + s2) * x2) + s5
            v = s7 + ((_GAINS[row, 3] + s6) * self._u2)
            if not np.isfinite(v):
                return Control(_R(0.0), Status.RANGE)
            if elapsed < _SAMPLES:
                if v > self._u_max:
                    u_now = self._u_max
                elif v < -self._u_max:
                    u_now = -self._u_max
                else:
                    u_now = v
            else:
                u_now = _R(0.0)
            self._u2 = self._u1
            self._u1 = u_now
            if elapsed < _SAMPLES:
                if (v > self._u_max) or (v < -self._u_max):
                    return Control(u_now, Status.SATURATED)
                else:
                    return Control(u_now, Status.OK)
            else:
                return Control(u_now, Status.AFTER)
