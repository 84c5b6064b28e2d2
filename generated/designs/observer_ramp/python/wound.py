"""
Prescribed-time controller wound: order n = 2, clock in samples.

DO NOT EDIT. Made by:
  ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --name wound --clock samples --A="[[0,1],[0,-5]]" --B="[0,40]" --C="[[1,0]]" --disturbance ramp --observer=stationary --disturbance-walk=5 --tau=0.3 --eps=0.01 --u-max=10 --poles=least-energy --sample-time=0.001 --sensor-step=1e-5
Version 0.1.0, design 6978bbac7216.

Plant: x' = A x + B (u + d), d an unknown ramp of --A and --B above; u held from sample to
      sample, y = C x.
Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
      sample period, as long as u is not clipped and nothing else acts on the plant. What d
      does within a sample remains, of order h^(4-i) in x_i.
Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
      sum of u^2. The gains are a table of 2128 bytes: exact below 64 samples to go, and
      before it those of a grid of 133 nodes, interpolated in a line. The gains of 10
      samples to go stay.

Parameters:
  samples = 300 [samples], fixed: samples N from the start to rest
  h = 0.001 [s], fixed: sample period
  eps = 0.01 [s], fixed: time-to-go at which the gains are held
  u_max = 10 [unit of u], fixed: bound of |u|
  a = 1 [1/s], fixed: rate of stretched time

k counts samples and may wrap; arm again within 2^32 - N samples.
From sample N on the last gains are held (status HOLD).
The estimates approach the state from the first sample on: the observer has the gains of
      the stationary Kalman filter for the noise and disturbance_walk.
|u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
      lasts.
Guard full: what is measured is finite, or the call is refused (INPUT).
Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
      machine without fused multiply-add (gcc, clang: -ffp-contract=off).

Checks of the design (details: ptc-codegen check):
  membership: sound: exp is of class M for all its parameters.
  growth: sound: near rest at sample 300, not at rest: the gains are held from 10 samples
      to go, and |u| is bounded; so does what the stationary observer leaves of its error.
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

__all__ = ["Control", "Params", "Status", "Wound"]

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
_GAMMA1 = _R(1.9966708291701364e-5)
# Prediction from u.
_GAMMA2 = _R(0.03990016645854149)
# Prediction of x1 from x2.
_PHI1_2 = _R(0.0009975041614635374)
# Prediction of x1 from d.
_PHI1_3 = _R(1.9966708291701364e-5)
# Prediction of x1 from d_rate.
_PHI1_4 = _R(6.65834165972718e-9)
# Prediction of x2 from x2.
_PHI2_2 = _R(0.9950124791926823)
# Prediction of x2 from d.
_PHI2_3 = _R(0.03990016645854149)
# Prediction of x2 from d_rate.
_PHI2_4 = _R(1.9966708291701364e-5)
# Prediction of d from d_rate.
_PHI3_4 = _R(0.001)
# 1/2000, weight of d_rate in d0.
_D0_D_RATE = _R(0.0005)
# Samples from the start to rest.
_SAMPLES = 300
# Bound of |u|.
_U_MAX = _R(10.0)
# Samples to go at which the gains are held.
_HOLD = _R(10.0)

# Gains of least energy of each state, a row for the samples to go of a node.
_GAINS = np.array(
    [
        [-25062.55208331163, -37.45838539928387],
        [-12531.276041655816, -27.02091153629504],
        [-7518.771890597572, -21.17512730136674],
        [-5012.522947839163, -17.41685454673074],
        [-3580.382484960281, -14.791921685154502],
        [-2685.29581446331, -12.853004827701644],
        [-2088.572113309308, -11.361511337588555],
        [-1670.8660445699165, -10.178253886647713],
        [-1367.0801924248185, -9.216462472334808],
        [-1139.2410880456976, -8.419192302134173],
        [-963.9804575280741, -7.7475056835855245],
        [-826.2758484653018, -7.173867479447892],
        [-716.1122988456777, -6.678251755867355],
        [-626.6045265894896, -6.245743125016565],
        [-552.8923356192942, -5.8650030366739845],
        [-491.46558651746074, -5.527257508159454],
        [-439.73786238226137, -5.225610425046795],
        [-395.76935174979474, -4.954566395590321],
        [-358.08210395224614, -4.709692126318068],
        [-325.53406691464073, -4.487371545828679],
        [-297.2314613108345, -4.284625719832186],
        [-272.4667122832038, -4.098978394427451],
        [-250.67376029944174, -3.9283542217508476],
        [-231.3954037153636, -3.7710007577691615],
        [-214.2591080907677, -3.625427994983439],
        [-198.9588631838909, -3.490360996044272],
        [-185.24141929776482, -3.3647024313193445],
        [-172.89573515015255, -3.2475026852219093],
        [-161.7448084859356, -3.1379358050018875],
        [-151.63929374570083, -3.0352800015816697],
        [-142.45247356429783, -2.938901727848315],
        [-134.0762655507691, -2.8482425912471],
        [-126.41802771362536, -2.7628085288985127],
        [-119.39798505450041, -2.682160801615334],
        [-112.9471430233356, -2.6059084599124938],
        [-107.00558533779206, -2.533702008723079],
        [-101.52107732283747, -2.4652280540296214],
        [-96.4479136663855, -2.4002047583056494],
        [-91.74596289998007, -2.3383779656868584],
        [-87.37987113303078, -2.2795178844715838],
        [-83.31839541198548, -2.2234162356068197],
        [-79.53384313623167, -2.1698837925359418],
        [-76.00159867616605, -2.118748251137814],
        [-72.69972202781202, -2.0698523792108214],
        [-69.60860724242359, -2.0230524036126596],
        [-66.71069066856059, -1.9782166001907233],
        [-63.990200873971226, -1.935224057363983],
        [-61.43294357850104, -1.8939635889065702],
        [-59.02611610609145, -1.854332775340262],
        [-56.75814681446088, -1.8162371165287596],
        [-54.618555732244545, -1.7795892807083726],
        [-52.597833261740725, -1.7443084373888083],
        [-50.68733431953344, -1.7103196633950737],
        [-48.87918570957591, -1.6775534128620255],
        [-47.166204871543165, -1.6459450432891332],
        [-45.54182843544784, -1.6154343908569635],
        [-44.00004925285312, -1.5859653891331444],
        [-42.53536077446738, -1.5574857260822101],
        [-41.14270781065835, -1.5299465349637833],
        [-39.81744285128224, -1.5033021152758699],
        [-38.55528723888131, -1.4775096803902563],
        [-37.35229658857752, -1.4525291289479483],
        [-36.20482993199029, -1.4283228374450154],
        [-34.06325919005944, -1.3820938155806135],
        [-32.106536803142006, -1.338564431477856],
        [-30.313985513026402, -1.297505701218112],
        [-28.667740477433156, -1.2587138257138495],
        [-27.152302410418812, -1.2220068207829147],
        [-25.754171416504423, -1.1872216742436565],
        [-24.46154528468084, -1.1542119363133219],
        [-23.264069592318712, -1.1228456681669643],
        [-22.152629694858003, -1.0930036880472276],
        [-21.119176765645577, -1.0645780657608817],
        [-20.156581661606076, -1.0374708254679725],
        [-19.258511641816636, -1.0115928238994039],
        [-18.419325944014677, -0.9868627769342994],
        [-17.63398699291158, -0.9632064121390287],
        [-16.89798462206792, -0.9405557286528212],
        [-16.207271174315228, -0.9188483488839579],
        [-15.558205731836736, -0.8980269489982304],
        [-14.947506037085217, -0.8780387572491501],
        [-14.372206915882634, -0.8588351109048781],
        [-13.829624216800774, -0.8403710639392016],
        [-13.317323445964547, -0.8226050388280604],
        [-12.833092411325039, -0.8054985167729085],
        [-12.374917301162197, -0.7890157614927269],
        [-11.940961712785693, -0.7731235724159998],
        [-11.529548222820779, -0.7577910636853106],
        [-11.139142153050017, -0.7429894658788976],
        [-10.768337237893562, -0.728691947770666],
        [-10.415842943146174, -0.714873455805111],
        [-10.080473222075732, -0.7015105692665033],
        [-9.761136525661026, -0.6885813693808883],
        [-9.456826909609179, -0.6760653208118154],
        [-9.16661610266188, -0.6639431642020094],
        [-8.625124415267713, -0.6408092925783974],
        [-8.130537323271147, -0.6190477039605723],
        [-7.67758988647958, -0.5985413585332934],
        [-7.261735669555908, -0.5791861530901838],
        [-6.879032210126091, -0.5608891815779076],
        [-6.5260472340516715, -0.5435672689587614],
        [-6.1997814312332595, -0.5271457295661145],
        [-5.897604532320134, -0.5115573108473565],
        [-5.617202131130627, -0.49674129098509934],
        [-5.35653123684372, -0.48264270486283967],
        [-5.113782955729232, -0.46921167757142107],
        [-4.887351024780353, -0.4564028484192852],
        [-4.67580517153525, -0.4441748714258962],
        [-4.477868472289474, -0.43248998070631994],
        [-4.2923980372763735, -0.421313611120303],
        [-4.118368475621753, -0.4106140661574739],
        [-3.954857692083967, -0.400362226336105],
        [-3.801034647206928, -0.3905312924645114],
        [-3.6561487767130783, -0.3810965589973729],
        [-3.5195208179677313, -0.372035213450151],
        [-3.3905348336558507, -0.36332615844198357],
        [-3.2686312573789826, -0.35494985344378815],
        [-3.153300814234341, -0.34688817373208025],
        [-3.0440791927863806, -0.33912428440490333],
        [-2.9405423641389032, -0.3316425276161462],
        [-2.8423024598226094, -0.32442832143802014],
        [-2.749004133535985, -0.3174680689764142],
        [-2.660321342903319, -0.31074907654665324],
        [-2.575954496734587, -0.3042594798730975],
        [-2.495627921104846, -0.2979881774093737],
        [-2.4190876041728377, -0.2919247699903831],
        [-2.3460991852392303, -0.28605950612555253],
        [-2.2099282641741778, -0.27488734794385006],
        [-2.085569571646548, -0.2644048657952509],
        [-1.9716947441056276, -0.2545528356422077],
        [-1.8671570099165657, -0.2452785920601236],
        [-1.7709621952622956, -0.23653514437701323],
        [-1.6822449906745098, -0.22828043202923856],
    ],
    dtype=_R,
)

class Wound:
    """The controller. Takes the parameters and arms at tick 0.

    ValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.
    """

    def __init__(self, params: Params) -> None:
        with np.errstate(all="ignore"):
            self._start = 0
            self._u1 = _R(0.0)
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x1_next = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x2_next = _R(0.0)
            self._d_hat = _R(0.0)
            self._d_next = _R(0.0)
            self._d_rate_hat = _R(0.0)
            self._d_rate_next = _R(0.0)

    def arm(self, k: int) -> None:
        """Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
        are kept. Estimates too large to compute with begin anew.

        On a negative status u is 0 and nothing has changed.
        """
        k = k.__index__() & _WRAP
        self._start = k
        s1 = np.abs(self._x1_next) + np.abs(self._x2_next) + np.abs(self._d_next)
        size = s1 + np.abs(self._d_rate_next)
        if not (size <= 1e150):
            self._seen = 0
            self._x1_hat = _R(0.0)
            self._x1_next = _R(0.0)
            self._x2_hat = _R(0.0)
            self._x2_next = _R(0.0)
            self._d_hat = _R(0.0)
            self._d_next = _R(0.0)
            self._d_rate_hat = _R(0.0)
            self._d_rate_next = _R(0.0)

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
                d = _R(0.0)
                d_rate = _R(0.0)
            else:
                x1 = self._x1_next + (_GAMMA1 * self._u1)
                x2 = self._x2_next + (_GAMMA2 * self._u1)
                d = self._d_next
                d_rate = self._d_rate_next

            # Prediction of the next sample.
            miss1 = y[0] - x1
            off1 = miss1
            l1 = _R(0.5585637305501465)
            l2 = _R(139.80905203556958)
            l3 = _R(543.231381268175)
            l4 = _R(41388.00314050849)
            s1 = x1 + (_PHI1_2 * x2) + (_PHI1_3 * d)
            x1_on = s1 + (_PHI1_4 * d_rate) + (l1 * off1)
            s2 = (_PHI2_2 * x2) + (_PHI2_3 * d)
            x2_on = s2 + (_PHI2_4 * d_rate) + (l2 * off1)
            d_on = d + (_PHI3_4 * d_rate) + (l3 * off1)
            d_rate_on = d_rate + (l4 * off1)

            # The disturbance while each input acts.
            d0 = d + (_D0_D_RATE * d_rate)
            left = max(_SAMPLES - elapsed, 0)
            if left > 10:
                to_go = left
            else:
                to_go = 10

            # Its place between the nodes of the table.
            if to_go < 64:
                row = (to_go - 2) & _WRAP
                part = _R(0.0)
            elif to_go < 128:
                row = (to_go // 2) + 30
                part = (0.5 * _R(to_go)) - _R(to_go // 2)
            elif to_go < 256:
                row = (to_go // 4) + 62
                part = (0.25 * _R(to_go)) - _R(to_go // 4)
            else:
                row = (to_go // 8) + 94
                part = (0.125 * _R(to_go)) - _R(to_go // 8)

            # The law of least energy.
            above = row + 1
            s3 = part * (_GAINS[above, 0] - _GAINS[row, 0])
            s4 = part * (_GAINS[above, 1] - _GAINS[row, 1])
            s5 = (_GAINS[row, 0] + s3) * x1
            v = (s5 + ((_GAINS[row, 1] + s4) * x2)) - d0
            if not (
                np.isfinite(v)
                and np.isfinite(x1_on)
                and np.isfinite(x2_on)
                and np.isfinite(d_on)
                and np.isfinite(d_rate_on)
            ):
                return Control(_R(0.0), Status.RANGE)
            if v > _U_MAX:
                u_now = _U_MAX
            elif v < -_U_MAX:
                u_now = -_U_MAX
            else:
                u_now = v
            self._u1 = u_now
            self._x1_hat = x1
            self._x1_next = x1_on
            self._x2_hat = x2
            self._x2_next = x2_on
            self._d_hat = d
            self._d_next = d_on
            self._d_rate_hat = d_rate
            self._d_rate_next = d_rate_on
            self._seen = 1
            if (v > _U_MAX) or (v < -_U_MAX):
                return Control(u_now, Status.SATURATED)
            elif _R(left) <= _HOLD:
                return Control(u_now, Status.HOLD)
            else:
                return Control(u_now, Status.OK)

    def estimate(self) -> Array:
        """The estimate of the state at the last sample."""
        return np.array([self._x1_hat, self._x2_hat], dtype=_R)

    def disturbance(self) -> np.float64:
        """The estimate of the ramp that is added to u."""
        return self._d_hat
