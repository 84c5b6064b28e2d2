"""The emitted C of a clock in samples in the loop with the exact chain of integrators, in 120 digits.

    python3 tools/samples.py table COMMAND   both laws side by side, by h/tau
    python3 tools/samples.py rest COMMAND    what is left of the state at sample N
    python3 tools/samples.py stage COMMAND   examples/encoder.toml with its encoder, by the gains held

COMMAND is the path of ptc-codegen. Needs mpmath and a C compiler called cc.
`rest` ends with 1 where more is left than docs/samples.md claims, as it is with --gain 1.000001, a plant that
is not the controller's.
"""

import argparse
import ctypes
import random
import subprocess
import sys
import tempfile
from pathlib import Path

from mpmath import factorial, mp, mpf, nstr

mp.dps = 120
ROOM = 4096  # bytes for a controller, whatever its fields
LUCK = mpf("1e-28")  # what is claimed to be left at most


class Controller:
    """A controller emitted by `command` with `flags`, as a shared library."""

    def __init__(self, command, *flags):
        self.folder = tempfile.TemporaryDirectory()
        folder = Path(self.folder.name)
        emit = [command, "emit", "--lang", "c", "--name", "probe", "--u-max", "inf", "-o", folder]
        subprocess.run([*emit, *flags], check=True, stdout=subprocess.DEVNULL)
        library = folder / "probe.so"
        flags = ["-std=c99", "-O2", "-ffp-contract=off", "-shared", "-fPIC"]
        subprocess.run(["cc", *flags, folder / "probe.c", "-o", library, "-lm"], check=True)
        self.library, self.state = ctypes.CDLL(library), ctypes.create_string_buffer(ROOM)

    def init(self, *parameters):
        """Starts at 0 with run-time parameters, which are doubles."""
        block = (ctypes.c_double * max(1, len(parameters)))(*parameters)
        if self.library.probe_init(self.state, block) != 0:
            raise ValueError(f"init refuses {parameters}")

    def step(self, now, x):
        """u from a tick (an integer) or a time (a float)."""
        now = ctypes.c_uint32(now) if isinstance(now, int) else ctypes.c_double(now)
        u = ctypes.c_double()
        status = self.library.probe_step(
            self.state, now, (ctypes.c_double * len(x))(*map(float, x)), ctypes.byref(u)
        )
        if status < 0:
            raise ValueError(f"step({now}, {x}) gives {status}")
        return u.value


class Chain:
    """x1' = x2, ..., xn' = gain (u + force), u held for h and `delay` samples late, in numbers of `kind`."""

    def __init__(self, h, x, delay=0, force=0, kind=mpf, gain="1"):
        n = len(x)
        self.x, self.force = [kind(value) for value in x], kind(force)
        self.late = [kind(0)] * delay
        power = [kind(mpf(h) ** i / factorial(i)) for i in range(n + 1)]
        self.rows = [power[: n - i] for i in range(n)]
        self.inputs = [kind(mpf(gain)) * power[n - i] for i in range(n)]
        self.most = max(map(abs, self.x))

    def step(self, u):
        self.late.append(u)
        u = self.late.pop(0) + self.force
        x = self.x
        self.x = [
            sum(a * b for a, b in zip(row, x[i:])) + self.inputs[i] * u
            for i, row in enumerate(self.rows)
        ]
        self.most = max(self.most, *map(abs, self.x))


def worst_end(controller, n, samples, clock, kind=mpf, parameters=()):
    """The largest |x_i| at the deadline from any |x_j(0)| <= 1, in units of tau = 1."""
    ends = []
    for j in range(n):
        chain = Chain(1 / mpf(samples), [float(i == j) for i in range(n)], kind=kind)
        controller.init(*parameters)
        for k in range(samples):
            chain.step(controller.step(clock(k), chain.x))
        ends.append([abs(value) for value in chain.x])
    return max(map(sum, zip(*ends)))


def table(command, _):
    """Rows of Markdown: the law of continuous time at the eps that is best for it, and that in samples."""
    ratios = {1000: "1e-3", 100: "0.01", 20: "0.05", 10: "0.1", 5: "0.2"}
    common = {n: ("--n", str(n), "--mu", "exp(a=1)", "--tau", "1", f"--poles={poles}")
              for n, poles in ((2, "-4,-5"), (3, "-4,-5,-6"))}
    # Between the samples the clock in time sees T, held at eps, which stays a run-time parameter.
    held = {n: Controller(command, *flags, "--t0", "0") for n, flags in common.items()}
    for samples, ratio in ratios.items():
        cells = []
        for n, flags in common.items():
            time = lambda k: k / samples
            grid = [10 ** (-4 + 4 * i / 200) for i in range(200)]
            least = lambda eps: worst_end(held[n], n, samples, time, float, (eps,))
            eps = min(grid, key=least)
            left = worst_end(held[n], n, samples, time, parameters=(eps,))
            exact = Controller(command, *flags, "--clock", "samples", "--sample-time", ratio)
            rest = worst_end(exact, n, samples, lambda k: k)
            # Below, digits depend on luck in rounding.
            rest = f"{float(rest):.1e}" if rest > LUCK else f"< {float(LUCK):.0e}"
            cells += [f"{float(left):.1e} (eps = {eps:.2g})", rest]
        print("|", " | ".join([ratio, *cells]), "|", flush=True)


def poles(rng, count, low):
    """Poles -p with p at least `low`: distinct, a complex pair, or equal ones."""
    p = [round(rng.uniform(low, low + 6), 2) for _ in range(count)]
    kind = rng.randrange(3) if count > 1 else 0
    if kind == 2:
        p[1] = p[0]
    text = [f"-{value}" for value in p]
    if kind == 1:
        text[:2] = f"-{p[0]}+2i", f"-{p[0]}-2i"
    return ",".join(text)


def run(command, rng, n, delay, samples, measured=None, force=0, rounds=0, gain="1"):
    """What is left at sample N, in parts of the largest |x_i| on the way."""
    h = rng.choice(["0.001", "0.4"])
    order = n + delay
    flags = ["--n", str(n), "--mu", "exp(a=1)", "--clock", "samples", "--sample-time", h,
             "--tau", nstr(samples * mpf(h), 30), "--delay", str(delay),
             f"--poles={poles(rng, order, order)}"]
    if measured:
        states = ",".join(f"x{i + 1}" for i in range(measured))
        count = n + 1 - measured + (force != 0)
        flags += ["--measured", states, f"--observer-poles={poles(rng, count, count)}"]
        flags += ["--disturbance", "constant"] if force else []
        flags += ["--deadbeat", str(rounds * (order + count))] if rounds else []
    controller = Controller(command, *flags)
    controller.init()
    chain = Chain(h, [rng.uniform(-1, 1) for _ in range(n)], delay, force, gain=gain)
    for k in range(samples):
        chain.step(controller.step(k, chain.x[:measured]))
    return max(map(abs, chain.x)) / chain.most


def rest(command, gain):
    """Rows of Markdown: the most that is left. 1 where it is above what the page claims."""
    rng, found = random.Random(1), {}

    def loop(group, *arguments):
        found.setdefault(group, []).append(run(command, rng, *arguments, gain=gain))

    for n, delay in ((n, delay) for n in range(1, 5) for delay in range(3)):
        for samples in (n + 2, 20, 1000):
            enough = ">=" if samples >= 2 * (n + delay) else "<"
            loop(f"all states, N {enough} 2 (n + d)", n, delay, samples)
        for measured in range(1, n + 1):
            if measured < n:
                loop("observer, N = 20", n, delay, 20, measured)
                loop("observer, N = 1000", n, delay, 1000, measured)
                loop("observer, N = 1000, two rounds", n, delay, 1000, measured, 0, 2)
            loop("observer and force, N = 1000", n, delay, 1000, measured, 0.3)
            loop("observer and force, N = 1000, two rounds", n, delay, 1000, measured, 0.3, 2)
    for group, left in sorted(found.items()):
        print(f"| {group} | {len(left)} | {float(max(left)):.1e} |")
    claimed = ("all states, N >= 2 (n + d)", "observer, N = 1000, two rounds")
    return int(max(max(found[group]) for group in claimed) > LUCK)


def stage(command, _):
    """Rows of Markdown: the worst of 20 runs from 0.1 m with 0.3 N, on a grid of the encoder's steps."""
    for observer_eps, eps in ((0.01, 0), (0.03, 0), (0.03, 0.03), (0.06, 0.03), (0.06, 0.1)):
        controller = Controller(
            command, str(Path(__file__).parent.parent / "examples/encoder.toml"),
            "--disturbance", "constant", "--observer-eps", str(observer_eps), "--eps", str(eps),
        )
        worst = [0.0] * 5
        for start in range(20):
            controller.init()
            chain = Chain("0.001", [0.1 + start * 0.05e-6, 0], 1, mpf("0.2"), float)
            for k in range(1000):
                u = controller.step(k, [round(chain.x[0] / 1e-6) * 1e-6])
                chain.step(u / 1.5)
                at = [(k == 799) * abs(1e6 * chain.x[0]), (k == 799) * abs(1e6 * chain.x[1]),
                      (k >= 800) * abs(1e6 * chain.x[0]), abs(u), (k >= 800) * abs(u + 0.3)]
                worst = list(map(max, worst, at))
        cells = [observer_eps, eps, *(f"{float(f'{value:.1e}'):g}" for value in worst)]
        print("|", " | ".join(map(str, cells)), "|", flush=True)


if __name__ == "__main__":
    commands = {"table": table, "rest": rest, "stage": stage}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("what", choices=commands)
    parser.add_argument("command", metavar="COMMAND")
    parser.add_argument("--gain", default="1")
    arguments = parser.parse_args()
    sys.exit(commands[arguments.what](arguments.command, arguments.gain))
