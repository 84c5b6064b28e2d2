"""A design of the stage of docs/design.md beside a quintic profile with feedforward and PID, in the same loop.

    python3 tools/peers.py COMMAND DESIGN

COMMAND is the path of ptc-codegen, DESIGN what its `design` made of precise.toml. Needs a C compiler called cc.
Prints the worst position at the deadline, the largest force and the energy over both starts, three masses, both pulls,
and no kick or one of either sign at each of three times; the PID has the best of 20 settings in that error.
"""

import ctypes
import itertools
import subprocess
import sys
import tempfile
from math import tanh
from pathlib import Path

H, N, FINER = 1e-3, 800, 10  # period in s, samples to the deadline, steps of the integration in each
MASS, STEP, MOST = 1.5, 1e-6, 6.0  # kg of the controllers' plant, m of the encoder, N of the drive
ROOM = 8192  # bytes for a controller, whatever its fields

KICKS = [(0.0, 0.0), *itertools.product((-0.5, 0.5), (0.4, 0.7, 0.76))]
SCENARIOS = list(itertools.product((-0.1, 0.1), (1.2, 1.5, 1.8), (-0.3, 0.3), KICKS))


class Design:
    """The emitted C of a design."""

    def __init__(self, command, design):
        self.folder = tempfile.TemporaryDirectory()
        folder = Path(self.folder.name)
        emit = [command, "emit", design, "--lang", "c", "--name", "stage", "-o", folder]
        subprocess.run(emit, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        library = folder / "stage.so"
        flags = ["-std=c99", "-O2", "-ffp-contract=off", "-shared", "-fPIC"]
        subprocess.run(["cc", *flags, folder / "stage.c", "-o", library, "-lm"], check=True)
        self.library = ctypes.CDLL(library)

    def start(self, _):
        self.state, params = ctypes.create_string_buffer(ROOM), ctypes.create_string_buffer(ROOM)
        if self.library.stage_init(self.state, params) != 0 or self.library.stage_arm(self.state, 0) != 0:
            raise ValueError("the design refuses")

    def step(self, k, y):
        u, y = ctypes.c_double(), (ctypes.c_double * 1)(y)
        if self.library.stage_step(self.state, k, y, ctypes.byref(u)) < 0:
            raise ValueError(f"step {k} refuses")
        return u.value


class Pid:
    """A quintic profile, its force, and a PID with three equal poles at -w and a filtered derivative."""

    def __init__(self, w, filtered):
        self.p, self.i, self.d = 3 * w**2 * MASS, w**3 * MASS, 3 * w * MASS
        self.share = filtered * H

    def start(self, x):
        self.x, self.sum, self.speed, self.last = x, 0.0, 0.0, x

    def step(self, k, y):
        s, tau, x = k / N, N * H, self.x
        r = x * (1 - 10 * s**3 + 15 * s**4 - 6 * s**5)
        v = -x / tau * (30 * s**2 - 60 * s**3 + 30 * s**4)
        a = -x / tau**2 * (60 * s - 180 * s**2 + 120 * s**3)
        self.speed += self.share * ((y - self.last) / H - self.speed)
        self.last = y
        self.sum += H * (y - r)
        u = MASS * a - self.p * (y - r) - self.i * self.sum - self.d * (self.speed - v)
        return max(-MOST, min(MOST, u))


def run(control, scenario):
    """Returns |x1| at the deadline, the largest |u| that acts, and h sum u^2."""
    x, mass, pull, (kick, when) = scenario
    v, under_way, most, energy = 0.0, 0.0, 0.0, 0.0
    control.start(round(x / STEP) * STEP)
    for k in range(N):
        u, under_way = under_way, control.step(k, round(x / STEP) * STEP)
        most, energy = max(most, abs(u)), energy + H * u * u
        for j in range(FINER):
            t, h = k * H + j * H / FINER, H / FINER
            force = u + pull + (kick if t >= when - 1e-9 else 0.0) - 0.05 * tanh(1000 * v)
            x, v = x + h * v + h * h / 2 * force / mass, v + h * force / mass
    return abs(x), most, energy


def worst(control):
    return [max(column) for column in zip(*(run(control, one) for one in SCENARIOS))]


def row(name, numbers):
    error, most, energy = numbers
    print(f"| {name} | {1e6 * error:.2g} | {most:.3g} | {energy:.3g} |")


command, design = sys.argv[1:]
print("| controller | abs(x1) at the deadline [um] | largest abs(u) [N] | energy, sum of u^2 h [N^2 s] |")
print("| --- | --- | --- | --- |")
settings = [Pid(w, filtered) for w in (60, 80, 100, 120, 150) for filtered in (300, 500, 700, 900)]
row("quintic profile, feedforward and PID", min(map(worst, settings)))
row("what `design` found", worst(Design(command, design)))
