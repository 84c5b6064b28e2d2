"""
Prescribed-time controller stage48: order n = 3, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 3 --mu "exp(a=1)" --name stage48 --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0]]" --delay-law=predict --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=50 --tau=0.1 --eps=0.006 --u-max=24 --poles=least-energy --sample-time=1e-3 --delay=1.5
Version 0.1.0, design 62df3f06bf2c.

Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
      sample to sample, 1.5 samples late, y = C x.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant.
Law of the state x predicted for the time from which u acts, by x and the inputs under way:
      u = -K_M x with M samples to go, of all inputs that end at rest those with the least
      sum of u^2. The gains are a table of 1344 bytes: exact below 32 samples to go, and
      before it those of a grid of 56 nodes, interpolated in a line. The gains of 8 samples
      to go stay.

Parameters:
  samples = 100 [samples], fixed: samples N from the start to rest
  h = 1e-3 [s], fixed: sample period
  eps = 0.006 [s], fixed: time-to-go at which the gains are held
  u_max = 24 [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
The estimates are exact from sample 50 after the start on where the measurement is; with
      noise or sensor_step given, or observer_eps, the gains of the observer are then held
      below deadbeat.
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: near rest at sample 100, not at rest: the gains are held from 6 samples to
      go, and |u| is bounded.
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

__all__ = ["Control", "Params", "Stage48", "Status"]

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

# Prediction from u.
_GAMMA1 = _R(9.364814153170347e-5)
# Prediction from u.
_LATE_GAMMA1 = _R(1.4515165236407059e-5)
# Prediction from u.
_GAMMA2 = _R(0.22442191668610964)
# Prediction from u.
_LATE_GAMMA2 = _R(0.08499166561536914)
# Prediction from u.
_GAMMA3 = _R(0.15880778157427425)
# Prediction from u.
_LATE_GAMMA3 = _R(0.21578270324225896)
# Samples of the round of the observer.
_OBSERVER_SAMPLES = 50
# Weight in the observer's gain l1.
_Q1_1 = _R(-96.0)
# Weight in the observer's gain l1.
_Q1_2 = _R(96.0)
# Weight in the observer's gain l1.
_Q1_3 = _R(-48.0)
# Weight in the observer's gain l1.
_Q1_4 = _R(16.0)
# Weight in the observer's gain l2.
_Q2_1 = _R(859382.9277311233)
# Weight in the observer's gain l2.
_Q2_2 = _R(-513847.60335174634)
# Weight in the observer's gain l2.
_Q2_3 = _R(125558.23800330989)
# Weight in the observer's gain l2.
_Q2_4 = _R(-9808.939721535125)
# Weight in the observer's gain l3.
_Q3_1 = _R(-620544.0922410007)
# Weight in the observer's gain l3.
_Q3_2 = _R(289368.54342637886)
# Weight in the observer's gain l3.
_Q3_3 = _R(-49493.69520132396)
# Weight in the observer's gain l3.
_Q3_4 = _R(3680.3758886140504)
# Weight in the observer's gain l4.
_Q4_1 = _R(42644.35104284018)
# Gain of the observer at its end.
_E0_1 = _R(1.1314283505021951)
# Gain of the observer at its end.
_E0_2 = _R(219.51265205459217)
# Gain of the observer at its end.
_E0_3 = _R(75.63157806817)
# Gain of the observer at its end.
_E0_4 = _R(-118.45653067455605)
# Gain of the observer at its end.
_E1_1 = _R(1.3092061282799727)
# Gain of the observer at its end.
_E1_2 = _R(248.77479213018773)
# Gain of the observer at its end.
_E1_3 = _R(58.354009083621726)
# Gain of the observer at its end.
_E1_4 = _R(789.7102044970403)
# Gain of the observer at its end.
_E2_1 = _R(1.531428350502195)
# Gain of the observer at its end.
_E2_2 = _R(-7.605455274169628)
# Gain of the observer at its end.
_E2_3 = _R(-864.4162017900436)
# Gain of the observer at its end.
_E2_4 = _R(-1776.8479601183408)
# Gain of the observer at its end.
_E3_1 = _R(3.5314283505021953)
# Gain of the observer at its end.
_E3_2 = _R(3400.952825738043)
# Gain of the observer at its end.
_E3_3 = _R(1206.9697918675683)
# Gain of the observer at its end.
_E3_4 = _R(1776.8479601183408)
# Prediction of x1 from x2.
_PHI1_2 = _R(0.000996505559752715)
# Prediction of x1 from x3.
_PHI1_3 = _R(0.0006188271646029575)
# Prediction of x1 from d.
_PHI1_4 = _R(0.00010816330676811052)
# Prediction of x2 from x2.
_PHI2_2 = _R(0.9902193397510792)
# Prediction of x2 from x3.
_PHI2_3 = _R(1.1234620408672982)
# Prediction of x2 from d.
_PHI2_4 = _R(0.30941358230147875)
# Prediction of x3 from x2.
_PHI3_2 = _R(-0.011234620408672982)
# Prediction of x3 from x3.
_PHI3_3 = _R(0.5412090107511158)
# Prediction of x3 from d.
_PHI3_4 = _R(0.37459048481653323)
# Samples from the start to rest.
_SAMPLES = 100
# Bound of |u|.
_U_MAX = _R(24.0)
# Samples to go at which the gains are held.
_HOLD = _R(6.0)

# Gains of least energy of each state, a row for the samples to go of a node.
_GAINS = np.array(
    [
        [-1776.8479601183408, -3.433673119968826, -3.4085582810122124],
        [-888.4239800591704, -2.2396226199294076, -2.668895474474135],
        [-509.8205499917047, -1.5836352486541563, -2.156303199309816],
        [-321.2435999059375, -1.1847458154993364, -1.7840105694740966],
        [-216.68093346707525, -0.9242259566604598, -1.5043723951168144],
        [-153.9422258341114, -0.7447029385976519, -1.2887857385166759],
        [-113.93847902814913, -0.6156792469819268, -1.1190107322495595],
        [-87.16471846485014, -0.5197354647522179, -0.9828886639258793],
        [-68.52151427846083, -0.4463449878262189, -0.8720333492968331],
        [-55.10393872697146, -0.3888498994276202, -0.7805015513958865],
        [-45.17340922131986, -0.3428771962392912, -0.7039866926831448],
        [-37.645338987867255, -0.3054615992281757, -0.6393092191236842],
        [-31.81875620585758, -0.27453657915024465, -0.5840834223761374],
        [-27.22654280812768, -0.2486271922797076, -0.5364934991038854],
        [-23.548974074041762, -0.22665835728982042, -0.4951395241819548],
        [-20.56197731368738, -0.20783163893706613, -0.45892943480696],
        [-18.10517741827105, -0.1915440040702233, -0.4270020121187187],
        [-16.06160501852228, -0.17733302260561387, -0.3986711637229456],
        [-14.34448653985888, -0.16483914791668344, -0.3733850940635477],
        [-12.888450440068087, -0.15377927419458942, -0.3506960346235246],
        [-11.643553902420525, -0.14392788889388677, -0.3302375620042263],
        [-10.57115019711518, -0.13510343327021376, -0.31170743224482],
        [-9.640981134457023, -0.12715829319637273, -0.29485446816108246],
        [-8.829099689315191, -0.11997135875672672, -0.27946845400384207],
        [-8.116364548493685, -0.11344242686372868, -0.2653722821336554],
        [-7.4873347145655345, -0.10748794327334095, -0.2524158008059736],
        [-6.92944791969951, -0.10203772969328963, -0.24047095757682826],
        [-6.432403034640657, -0.09703244352848328, -0.22942793730857275],
        [-5.987690902669893, -0.0924215882293794, -0.21919206948913653],
        [-5.588234402434218, -0.08816194151833531, -0.20968133494671454],
        [-4.90232886736555, -0.08055249332977393, -0.19255867915280173],
        [-4.337531609573391, -0.07396200145641044, -0.17758866382046176],
        [-3.866962043305151, -0.06820607163189224, -0.1644055236605839],
        [-3.470790749314056, -0.06314188514263996, -0.1527212184490728],
        [-3.134134775751522, -0.058657163866628094, -0.14230591997800468],
        [-2.845649743939376, -0.05466245582716187, -0.13297406684879373],
        [-2.5965675236180417, -0.051085636807956664, -0.12457422819671518],
        [-2.380025558008824, -0.04786792242488202, -0.11698162121891839],
        [-2.1905911599741885, -0.044960929582640426, -0.11009250906350342],
        [-2.02391866730071, -0.04232447977954594, -0.10381995183425959],
        [-1.8764987244836007, -0.039924935245840495, -0.09809054528111931],
        [-1.7454724729656579, -0.03773392339710073, -0.09284188997856772],
        [-1.6284921470217775, -0.03572734808777426, -0.08802060737537329],
        [-1.523615296707974, -0.03388461531195422, -0.08358076988701066],
        [-1.4292236830261014, -0.03218802108556842, -0.07948264775619424],
        [-1.3439604848291826, -0.03062226328182328, -0.07569170062633748],
        [-1.1964152124156797, -0.02783177725314643, -0.06891436097083738],
        [-1.0737303961538518, -0.025425601240773896, -0.06304865259045363],
        [-0.970591182471621, -0.02333597818938725, -0.057938311673843924],
        [-0.8830294618645727, -0.021509684264473847, -0.053459600787556544],
        [-0.8080344337031824, -0.01990435940283023, -0.04951333308196541],
        [-0.7432884532951157, -0.01848589655966577, -0.04601913572216292],
        [-0.6869841398708345, -0.017226549374695407, -0.04291125081794763],
        [-0.6376953878667164, -0.01610353745589099, -0.04013541272877522],
        [-0.5942848639897524, -0.01509800278331475, -0.03764649228065479],
        [-0.5558366565985665, -0.014194218062618705, -0.035406696215788895],
    ],
    dtype=_R,
)

class Stage48:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            self._start = 0
            self._u1 = _R(0.0)
            self._u2 = _R(0.0)
            self._u3 = _R(0.0)
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x1_next = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x2_next = _R(0.0)
            self._x3_hat = _R(0.0)
            self._x3_next = _R(0.0)
            self._d_hat = _R(0.0)
            self._d_next = _R(0.0)

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept. Estimates too large to compute with begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        s1 = np.abs(self._x1_next) + np.abs(self._x2_next)
        size = s1 + np.abs(self._x3_next) + np.abs(self._d_next)
        if not (size <= 1e150):
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x1_next = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x2_next = _R(0.0)
            self._x3_hat = _R(0.0)
            self._x3_next = _R(0.0)
            self._d_hat = _R(0.0)
            self._d_next = _R(0.0)

    def step(self, k: int, y: ArrayLike) -> Control:
        """u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each
        tick.

        On a negative status u is 0 and nothing has changed.
        """
        with np.errstate(all="ignore"):
            k = k.__index__() & _WRAP
            y = _numbers(y, 1, "y")
            if not np.isfinite(y[0]):
                return Control(_R(0.0), Status.INPUT)
            elapsed = (k - self._start) & _WRAP

            # The estimates; at first what y shows.
            if self._seen == 0:
                x1 = y[0]
                x2 = _R(0.0)
                x3 = _R(0.0)
                d = _R(0.0)
            else:
                s1 = (_GAMMA1 * self._u3) + (_LATE_GAMMA1 * self._u2)
                x1 = self._x1_next + s1
                s2 = (_GAMMA2 * self._u3) + (_LATE_GAMMA2 * self._u2)
                x2 = self._x2_next + s2
                s3 = (_GAMMA3 * self._u3) + (_LATE_GAMMA3 * self._u2)
                x3 = self._x3_next + s3
                d = self._d_next

            # Prediction of the next sample.
            miss1 = y[0] - x1
            off1 = miss1
            left_o = max(_OBSERVER_SAMPLES - elapsed, 0)
            o0 = _R(left_o)
            if o0 > 10.0:
                o0f2 = o0 * (o0 - 1.0)
                o0f3 = o0f2 * (o0 - 2.0)
                r0 = 1.0 / (o0f3 * (o0 - 3.0))
                s4 = _Q1_1 + (_Q1_2 * o0) + (_Q1_3 * o0f2)
                l1 = ((s4 + (_Q1_4 * o0f3)) * r0) - 0.46857164949780494
                s5 = _Q2_1 + (_Q2_2 * o0) + (_Q2_3 * o0f2)
                l2 = ((s5 + (_Q2_4 * o0f3)) * r0) + 264.4187821124759
                s6 = _Q3_1 + (_Q3_2 * o0) + (_Q3_3 * o0f2)
                l3 = ((s6 + (_Q3_4 * o0f3)) * r0) - 98.64522377262374
                l4 = _Q4_1 * r0
            elif left_o == 10:
                l1 = _E0_1
                l2 = _E0_2
                l3 = _E0_3
                l4 = _E0_4
            elif left_o == 9:
                l1 = _E1_1
                l2 = _E1_2
                l3 = _E1_3
                l4 = _E1_4
            elif left_o == 8:
                l1 = _E2_1
                l2 = _E2_2
                l3 = _E2_3
                l4 = _E2_4
            else:
                l1 = _E3_1
                l2 = _E3_2
                l3 = _E3_3
                l4 = _E3_4
            s7 = x1 + (_PHI1_2 * x2) + (_PHI1_3 * x3)
            x1_on = s7 + (_PHI1_4 * d) + (l1 * off1)
            s8 = (_PHI2_2 * x2) + (_PHI2_3 * x3)
            x2_on = s8 + (_PHI2_4 * d) + (l2 * off1)
            s9 = (_PHI3_2 * x2) + (_PHI3_3 * x3)
            x3_on = s9 + (_PHI3_4 * d) + (l3 * off1)
            d_on = d + (l4 * off1)
            left = max(_SAMPLES - elapsed, 0)
            planned = max(left - 2, 0)
            if planned > 6:
                to_go = planned
            else:
                to_go = 6

            # Its place between the nodes of the table.
            if to_go < 32:
                row = (to_go - 3) & _WRAP
                part = _R(0.0)
            elif to_go < 64:
                row = (to_go // 2) + 13
                part = (0.5 * _R(to_go)) - _R(to_go // 2)
            else:
                row = (to_go // 4) + 29
                part = (0.25 * _R(to_go)) - _R(to_go // 4)

            # The state from which this input acts.
            s10 = x1 + (0.0014892124792996978 * x2)
            s11 = 0.00010816330676811052 * (self._u1 + d)
            s12 = s10 + (0.0012719952989597699 * x3) + s11
            p1 = s12 + (0.0002327420309725346 * (self._u2 + d))
            s13 = (0.9801754642759536 * x2) + (1.4706215395736848 * x3)
            s14 = s13 + (0.30941358230147875 * (self._u1 + d))
            p2 = s14 + (0.32658406717840616 * (self._u2 + d))
            s15 = ((-0.014706215395736848) * x2) + (0.39241705562633755 * x3)
            s16 = s15 + (0.37459048481653323 * (self._u1 + d))
            p3 = s16 + (0.11582869425785502 * (self._u2 + d))

            # The law of least energy.
            above = row + 1
            s17 = part * (_GAINS[above, 0] - _GAINS[row, 0])
            s18 = part * (_GAINS[above, 1] - _GAINS[row, 1])
            s19 = (_GAINS[row, 0] + s17) * p1
            s20 = part * (_GAINS[above, 2] - _GAINS[row, 2])
            s21 = s19 + ((_GAINS[row, 1] + s18) * p2)
            v = (s21 + ((_GAINS[row, 2] + s20) * p3)) - d
            if not (
                np.isfinite(v)
                and np.isfinite(x1_on)
                and np.isfinite(x2_on)
                and np.isfinite(x3_on)
                and np.isfinite(d_on)
            ):
                return Control(_R(0.0), Status.RANGE)
            if v > _U_MAX:
                u_now = _U_MAX
            elif v < -_U_MAX:
                u_now = -_U_MAX
            else:
                u_now = v
            self._u3 = self._u2
            self._u2 = self._u1
            self._u1 = u_now
            self._x1_hat = x1
            self._x1_next = x1_on
            self._x2_hat = x2
            self._x2_next = x2_on
            self._x3_hat = x3
            self._x3_next = x3_on
            self._d_hat = d
            self._d_next = d_on
            self._seen = 1
            if (v > _U_MAX) or (v < -_U_MAX):
                return Control(u_now, Status.SATURATED)
            elif _R(left) - 2.0 <= _HOLD:
                return Control(u_now, Status.HOLD)
            else:
                return Control(u_now, Status.OK)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat, self._x3_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the constant that is added to u."""
        return self._d_hat
