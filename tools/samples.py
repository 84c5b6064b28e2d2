"""The emitted C of a clock in samples in the loop with the exact plant, in 120 digits.

    python3 tools/samples.py table COMMAND   both laws side by side, by h/tau
    python3 tools/samples.py rest COMMAND    what is left of the state at sample N
    python3 tools/samples.py alone COMMAND   what an observer alone is off by at its sample N_o
    python3 tools/samples.py follow COMMAND  what is left of the tracking error at sample N
    python3 tools/samples.py machines COMMAND  what is left where the output of a linear plant follows
    python3 tools/samples.py plants COMMAND  the same of random linear plants
    python3 tools/samples.py gains COMMAND   tests/data/sampled_plants.json: gains of linear plants, without COMMAND's help
    python3 tools/samples.py stage COMMAND   examples/encoder.toml with its encoder, by the gains held
    python3 tools/samples.py energy COMMAND  peak and energy of u, by the poles
    python3 tools/samples.py delays COMMAND  the two laws of a delay side by side
    python3 tools/samples.py swing COMMAND   linear plants with the law of a flat output and that of least energy

COMMAND is the path of ptc-codegen. Needs mpmath and a C compiler called cc.
`rest`, `alone`, `follow` and `machines` end with 1 where more is left than docs/benchmarks/samples.md claims, as it is with --gain 1.000001, a
plant that is not the controller's, and then at once.
"""

import argparse
import ctypes
import json
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from mpmath import ceil, expm, factorial, gamma, lu_solve, matrix, mp, mpf, nstr, pi, rgamma, sin, zeros

mp.dps = 120
ROOM = 4096  # bytes for a controller, whatever its fields
LUCK = mpf("1e-28")  # below, digits depend on luck in rounding
LEFT = mpf("1e-13")  # what is claimed to be left at most: some roundings of a law that divides once
OFF = mpf("1e-13")  # what estimates are claimed to be off by at most


class Emitted:
    """C emitted by `command` with `flags`, whose symbols begin with `name`, as a shared library."""

    def __init__(self, command, name, flags):
        self.folder = tempfile.TemporaryDirectory()
        folder = Path(self.folder.name)
        emit = [command, "emit", "--lang", "c", "--name", "probe", "-o", folder]
        subprocess.run([*emit, *flags], check=True, stdout=subprocess.DEVNULL)
        library = folder / "probe.so"
        flags = ["-std=c99", "-O2", "-ffp-contract=off", "-shared", "-fPIC"]
        subprocess.run(["cc", *flags, folder / f"{name}.c", "-o", library, "-lm"], check=True)
        self.library, self.state = ctypes.CDLL(library), ctypes.create_string_buffer(ROOM)


class Observer(Emitted):
    """An observer alone, all of whose parameters are fixed."""

    def __init__(self, command, *flags):
        super().__init__(command, "probe_observer", ["--what", "observer", *flags])
        if self.library.probe_observer_init(self.state, ctypes.byref(ctypes.c_char())) != 0:
            raise ValueError("init refuses")

    def update(self, k, y, u):
        """Takes y of tick k and u of the tick before."""
        given = (ctypes.c_double * len(y))(*map(float, y))
        status = self.library.probe_observer_update(
            self.state, ctypes.c_uint32(k), given, ctypes.c_double(u)
        )
        if status < 0:
            raise ValueError(f"update({k}, {y}, {u}) gives {status}")

    def estimate(self, count):
        """The `count` estimates."""
        xhat = (ctypes.c_double * count)()
        self.library.probe_observer_estimate(self.state, xhat)
        return list(xhat)


class Controller(Emitted):
    """A controller whose u is not bounded."""

    def __init__(self, command, *flags):
        super().__init__(command, "probe", ["--u-max", "inf", *flags])

    def init(self, *parameters):
        """Starts at 0 with run-time parameters, which are doubles."""
        block = (ctypes.c_double * max(1, len(parameters)))(*parameters)
        if self.library.probe_init(self.state, block) != 0:
            raise ValueError(f"init refuses {parameters}")

    def step(self, now, x, r=()):
        """u from a tick (an integer) or a time (a float), and the reference where it is given."""
        now = ctypes.c_uint32(now) if isinstance(now, int) else ctypes.c_double(now)
        u = ctypes.c_double()
        given = [(ctypes.c_double * len(list))(*map(float, list)) for list in (x, r) if list]
        status = self.library.probe_step(self.state, now, *given, ctypes.byref(u))
        if status < 0:
            raise ValueError(f"step({now}, {x}) gives {status}")
        return u.value


class Linear:
    """x' = A x + gain B (u + force), u held for h and `delay` samples late."""

    def __init__(self, h, a, b, x, delay=0, force=0, gain="1"):
        n = len(x)
        rates = zeros(n + 1, n + 1)
        for i in range(n):
            rates[i, n] = mpf(gain) * mpf(b[i]) * mpf(h)
            for j in range(n):
                rates[i, j] = mpf(a[i][j]) * mpf(h)
        inputs = int(ceil(mpf(delay)))
        part = mpf(delay) - inputs + 1
        self.parts = [expm(length * rates, method="taylor") for length in (part, 1 - part) if length]
        self.x, self.force, self.late = [mpf(value) for value in x], mpf(force), [mpf(0)] * inputs
        self.most = max(map(abs, self.x))

    def step(self, u):
        self.late.append(mpf(u))
        older, n = self.late.pop(0), len(self.x)
        for part, u in zip(self.parts, (older, *self.late[:1])):
            given = [*self.x, u + self.force]
            self.x = [sum(part[i, j] * given[j] for j in range(n + 1)) for i in range(n)]
        self.most = max(self.most, *map(abs, self.x))


class Chain:
    """x1' = x2, ..., xn' = gain (u + force), u held for h and `delay` samples late, in numbers of `kind`."""

    def __init__(self, h, x, delay=0, force=0, kind=mpf, gain="1"):
        self.x, self.force, self.gain = [kind(value) for value in x], kind(force), kind(mpf(gain))
        inputs = int(ceil(mpf(delay)))
        self.late = [kind(0)] * inputs
        # Until the next input takes over, and the rest of the sample.
        part = mpf(delay) - inputs + 1
        lengths = [part * mpf(h), (1 - part) * mpf(h)]
        self.powers = [
            [kind(length**i / factorial(i)) for i in range(len(x) + 1)] for length in lengths if length
        ]
        self.most = max(map(abs, self.x))

    def step(self, u):
        self.late.append(u)
        older = self.late.pop(0)
        for power, u in zip(self.powers, (older, *self.late[:1])):
            given = [*self.x, self.gain * (u + self.force)]
            self.x = [sum(a * b for a, b in zip(power, given[i:])) for i in range(len(self.x))]
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


def shown(left):
    """What is left, as pages show it."""
    return f"{float(left):.1e}" if left > LUCK else f"< {float(LUCK):.0e}"


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
            cells += [f"{float(left):.1e} (eps = {eps:.2g})", shown(rest)]
        print("|", " | ".join([ratio, *cells]), "|", flush=True)


def energy(command, _):
    """Rows of Markdown: peak and energy of u from x = (1, 0) in 800 samples of 1 ms, and what is left at the last."""
    laws = {
        "least-energy, that is -2, -3": ["--poles=least-energy"],
        "least-energy(weight=1), -3, -4": ["--poles=least-energy(weight=1)"],
        "least-energy(weight=2), -4, -5": ["--poles=least-energy(weight=2)"],
        "least energy, from 400 samples to go with a weight of 1": [
            "--poles=least-energy", "--poles-end=least-energy(weight=1)", "--end-samples=400"],
        "-2, -4": ["--poles=-2,-4", "--poles-end=least-energy", "--end-samples=5"],
        "-2, -4 with deadbeat = 5": ["--poles=-2,-4", "--deadbeat=5"],
        "-2, -3 with deadbeat = 4": ["--poles=-2,-3", "--deadbeat=4"],
    }
    for name, flags in laws.items():
        controller = Controller(command, "--n=2", "--mu=exp(a=1)", "--clock=samples", "--sample-time=1e-3",
                                "--tau=0.8", "--eps=0", *flags)
        controller.init()
        chain, peak, spent = Chain("0.001", [1, 0]), 0.0, 0.0
        for k in range(800):
            u = controller.step(k, chain.x)
            peak, spent = max(peak, abs(u)), spent + u * u * 1e-3
            chain.step(u)
        print(f"| {name} | {peak:.4g} | {spent:.4g} | {shown(max(map(abs, chain.x)))} |", flush=True)


def delays(command, _):
    """Rows of Markdown: both laws of a delay, for a chain alone and for the loop of examples/encoder.toml."""
    for delay in (1, 2, 4, 8):
        for law, weight in (("extend", 0), ("predict", 0), ("predict", 1)):
            if law == "extend" and delay > 4:
                continue
            named = "least-energy" + f"(weight={weight})" * (weight > 0)
            flags = [f"--delay-law={law}", f"--poles={named}"]
            controller = Controller(command, "--n=2", "--mu=exp(a=1)", "--clock=samples", "--sample-time=1e-3",
                                    "--tau=0.8", "--eps=0", f"--delay={delay}", *flags)
            controller.init()
            chain, peak, spent = Chain("0.001", [1, 0], delay), 0.0, 0.0
            for k in range(800):
                u = controller.step(k, chain.x)
                peak, spent = max(peak, abs(u)), spent + u * u * 1e-3
                chain.step(u)
            report = subprocess.run(
                [command, "check", Path(__file__).parent.parent / "examples/encoder.toml", "--delay", str(delay),
                 "--x0-max=0.1,0", f"--poles-end={named}", "--end-samples=20", "--format=json", *flags],
                check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
            report = json.loads(report.stdout)
            worst = next(check["worst"] for check in report["checks"] if check["name"] == "loop")
            margins = report["stability"]
            cells = [delay, law, named, f"{peak:.4g}", f"{spent:.4g}", f"{1e6 * worst['total'][0]:.3g}",
                     f"{margins['gain'][1]:.3g}", margins["delay"]]
            print("|", " | ".join(map(str, cells)), "|", flush=True)


MACHINES = {
    "motor with its coil": (
        [[0, 1, 0], [0, -0.5, 1500], [0, -15, -600]], [0, 0, 500], "0.001", (1000, 200)),
    "two masses and a spring": (
        [[0, 1, 0, 0], [-90000, -3, 90000, 3], [0, 0, 0, 1], [40000, 1.3, -40000, -1.3]], [0, 0, 0, 0.5],
        "0.0001", (1000, 500, 200)),
    "cart with an upright pendulum": (
        [[0, 1, 0, 0], [0, -0.1, -1.962, 0], [0, 0, 0, 1], [0, 0.2, 23.544, 0]], [0, 1, 0, -2], "0.005", (200,)),
}


def least_inputs(loop, start, samples):
    """The inputs from `start` to rest after so many samples with the least sum of squares."""
    n = len(start)
    part = loop.parts[0]
    phi, column = part[:n, :n], part[:n, n]
    columns = [column]
    for _ in range(samples - 1):
        columns.append(phi * columns[-1])
    gramian = zeros(n, n)
    for column in columns:
        gramian += column * column.T
    shadow = lu_solve(gramian, phi**samples * matrix(start))
    return [-float((column.T * shadow)[0]) for column in reversed(columns)]


def swing(command, _):
    """Rows of Markdown: peak and energy of u from x1 = 1, beside the least ones, rest, and bytes of the gains."""
    for name, (a, b, h, counts) in MACHINES.items():
        n = len(b)
        for samples in counts:
            start = [float(j == 0) for j in range(n)]
            best = least_inputs(Linear(h, a, b, start), start, samples)
            least = [max(map(abs, best)), sum(u * u for u in best) * float(h)]
            flat = ",".join(f"-{n + i}" for i in range(n))
            for label, law in ((flat.replace(",", ", "), flat), ("least-energy", "least-energy")):
                flags = [f"--A={rows(a)}", f"--B={[*b]}", "--mu=exp(a=1)", "--clock=samples", f"--sample-time={h}",
                         f"--tau={nstr(samples * mpf(h), 10)}", "--eps=0", f"--poles={law}"]
                controller, loop = Controller(command, *flags), Linear(h, a, b, start)
                controller.init()
                u = []
                for k in range(samples):
                    u.append(controller.step(k, loop.x))
                    loop.step(u[-1])
                text = (Path(controller.folder.name) / "probe.c").read_text()
                table = re.search(r"_gains\[(\d+)\]\[(\d+)\]", text)
                size = 8 * int(table[1]) * int(table[2]) if table else 0
                peak, spent = max(map(abs, u)), sum(value * value for value in u) * float(h)
                cells = [name, nstr(samples * mpf(h), 3), label, f"{peak:.4g}", f"{peak / least[0]:.4g}",
                         f"{spent / least[1]:.5g}", shown(max(map(abs, loop.x)) / loop.most), size or "-"]
                print("|", " | ".join(map(str, cells)), "|", flush=True)


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


def run(command, rng, n, delay, samples, measured=None, force=0, rounds=0, predicts=False, gain="1"):
    """What is left at sample N, in parts of the largest |x_i| on the way."""
    h = rng.choice(["0.001", "0.4"])
    late = int(ceil(mpf(delay)))
    order = n if predicts else n + late
    flags = ["--n", str(n), "--mu", "exp(a=1)", "--clock", "samples", "--sample-time", h,
             "--tau", nstr(samples * mpf(h), 30), "--delay", str(delay),
             f"--poles={poles(rng, order, order)}"]
    if measured:
        states = ",".join(f"x{i + 1}" for i in range(measured))
        count = n + 1 - measured + (force != 0)
        flags += ["--measured", states, f"--observer-poles={poles(rng, count, count)}"]
        flags += ["--disturbance", "constant"] if force else []
        flags += ["--deadbeat", str(rounds * (n + late + count))] if rounds else []
    controller = Controller(command, *flags)
    controller.init()
    chain = Chain(h, [rng.uniform(-1, 1) for _ in range(n)], delay, force, gain=gain)
    for k in range(samples):
        chain.step(controller.step(k, chain.x[:measured]))
    return max(map(abs, chain.x)) / chain.most


def row(group, left):
    """A row of Markdown: a group, how many there are in it, the most of them."""
    return f"| {group} | {len(left)} | {float(max(left)):.1e} |"


def end_early(gain, group, left):
    """Ends with 1: of a plant that is not the controller's one loop says enough."""
    if gain != "1":
        print(row(group, [left]))
        sys.exit(1)


def rest(command, gain):
    """Rows of Markdown: the most that is left. 1 where it is above what the page claims."""
    rng, found = random.Random(1), {}
    claimed = ("all states, N >= 2 (n + d)", "all states, d = 0.3 and 1.75",
               "observer, N = 1000, two rounds", "observer, d = 0.3 and 1.75, two rounds",
               "all states, predicted, N >= 4 (n + d)", "observer, predicted, two rounds")

    def loop(group, *arguments):
        left = run(command, rng, *arguments, gain=gain)
        found.setdefault(group, []).append(left)
        if group in claimed and left > LEFT:
            end_early(gain, group, left)

    for n, delay in ((n, delay) for n in range(1, 5) for delay in range(3)):
        for samples in (n + 2, 20, 1000, 100000):
            short = f"all states, N = n + 2, d = {delay}"
            loop(short if samples == n + 2 else "all states, N >= 2 (n + d)", n, delay, samples)
        for measured in range(1, n + 1):
            if measured < n:
                loop("observer, N = 20", n, delay, 20, measured)
                loop("observer, N = 1000", n, delay, 1000, measured)
                loop("observer, N = 1000, two rounds", n, delay, 1000, measured, 0, 2)
            loop("observer and force, N = 1000", n, delay, 1000, measured, 0.3)
            loop("observer and force, N = 1000, two rounds", n, delay, 1000, measured, 0.3, 2)
    for n, delay in ((n, delay) for n in range(1, 5) for delay in ("0.3", "1.75")):
        for samples in (20, 1000):
            loop("all states, d = 0.3 and 1.75", n, delay, samples)
        if n > 1:
            loop("observer, d = 0.3 and 1.75, two rounds", n, delay, 1000, 1, 0, 2)
    for n, delay in ((2, 1), (3, 0)):
        loop("observer and force, N = 100000, two rounds", n, delay, 100000, 1, 0.3, 2)
    for n, delay in ((n, delay) for n in range(1, 5) for delay in ("0.3", 1, "1.75", 2, 5, "7.1", 16)):
        for samples in (4 * (n + 16), 1000):
            loop("all states, predicted, N >= 4 (n + d)", n, delay, samples, None, 0, 0, True)
        if n > 1:
            loop("observer, predicted, two rounds", n, delay, 1000, 1, 0, 2, True)
    for group, left in sorted(found.items()):
        print(row(group, left))
    return int(max(max(found[group]) for group in claimed) > LEFT)


def observed(command, rng, n, delay, samples, measured, force, gain):
    """What the estimates are off by at sample N_o, in parts of the largest |x_i| on the way, with time in samples."""
    h = rng.choice(["0.001", "0.4"])
    states = ",".join(f"x{i + 1}" for i in range(measured))
    count = n + 1 - measured + (force != 0)
    flags = ["--n", str(n), "--mu", "exp(a=1)", "--clock", "samples", "--sample-time", h,
             "--delay", str(delay), "--measured", states, "--observer-samples", str(samples),
             f"--observer-poles={poles(rng, count, count)}"]
    observer = Observer(command, *flags, *(["--disturbance", "constant"] if force else []))
    chain = Chain(h, [rng.uniform(-1, 1) for _ in range(n)], delay, force, gain=gain)
    size = lambda first, values: max(abs(x) * mpf(h) ** i for i, x in enumerate(values, first))
    u, most = 0.0, size(0, chain.x)
    for k in range(samples):
        observer.update(k, chain.x[:measured], u)
        u = rng.uniform(-1, 1)
        chain.step(u)
        most = max(most, size(0, chain.x))
    observer.update(samples, chain.x[:measured], u)
    exact = chain.x[measured - 1 :]
    off = [mpf(a) - b for a, b in zip(observer.estimate(len(exact)), exact)]
    return size(measured - 1, off) / most


def alone(command, gain):
    """Rows of Markdown: what the estimates are off by. 1 where it is above what the page claims."""
    rng, found = random.Random(1), {}

    def loop(group, *arguments):
        off = observed(command, rng, *arguments, gain)
        found.setdefault(group, []).append(off)
        if off > OFF:
            end_early(gain, group, off)

    for n, delay in ((n, delay) for n in range(1, 5) for delay in range(3)):
        for measured in range(1, n + 1):
            for samples in (n + 2, 20, 1000):
                size = "n + 2" if samples == n + 2 else samples
                if measured < n:
                    loop(f"observer alone, N_o = {size}", n, delay, samples, measured, 0)
                loop(f"observer alone and force, N_o = {size}", n, delay, samples, measured, 0.3)
    for group, left in sorted(found.items()):
        print(row(group, left))
    return int(max(map(max, found.values())) > OFF)


def followed(command, n, delay, h, samples, r, text=None, measured=None, force=0, predicts=False, gain="1"):
    """|e_i| h^(i-1) at sample N, of the reference `text` with the derivatives r(i, t), which calls are given without it."""
    late = int(ceil(mpf(delay)))
    order = n if predicts else n + late
    own = lambda count: ",".join(str(-count - 1 - i) for i in range(count))
    flags = ["--n", str(n), "--mu", "exp(a=1)", "--clock", "samples", "--sample-time", h, "--delay", delay,
             "--tau", nstr(samples * mpf(h), 30), f"--poles={own(order)}", "--reference", text or "input"]
    if measured:
        count = n + 1 - measured + (force != 0)
        flags += ["--measured", ",".join(f"x{i + 1}" for i in range(measured)), f"--observer-poles={own(count)}",
                  "--deadbeat", str(2 * (n + late + count)), *(["--disturbance", "constant"] if force else [])]
    controller = Controller(command, *flags)
    controller.init()
    period = mpf(h)
    chain = Chain(h, [mpf(1) / (i + 2) + r(i, mpf(0)) for i in range(n)], delay, force, gain=gain)
    for k in range(samples):
        now, acts = k * period, (k + mpf(delay)) * period
        mean = (r(n - 1, acts + period) - r(n - 1, acts)) / period
        given = [] if text else [*(r(i, now) for i in range(n)), mean]
        chain.step(controller.step(k, chain.x[:measured], given))
    return [abs(chain.x[i] - r(i, samples * period)) * period**i for i in range(n)]


def follow(command, gain):
    """Rows of Markdown: the most that is left of polynomials, and by how much less of a sine for half the period."""
    found = {}
    for n, delay in ((n, delay) for n in range(1, 4) for delay in ("0", "1", "2", "0.3", "1.75")):
        def polynomial(i, t):
            terms = range(i, n + 1)
            return sum(mpf(j + 1) / (j + 2) * factorial(j) / factorial(j - i) * t ** (j - i) for j in terms)
        text = "+".join(f"{j + 1}/{j + 2}*t^{j}" for j in range(n + 1))
        for known, words in ((text, "known"), (None, "given with each call")):
            for measured, force, group in ((None, 0, "all states"), (1, 0.25, "x1 and a force")):
                for predicts in (False, True)[: 1 + (delay != "0")]:
                    left = followed(command, n, delay, "0.001", 200, polynomial, known, measured, force, predicts, gain)
                    law = ", predicted" * predicts
                    found.setdefault(f"polynomial{law}, {words}, {group}", []).append(max(left))
    print("| reference | number | largest abs(e_i) h^(i-1) |\n| --- | --- | --- |")
    for group, left in sorted(found.items()):
        print(row(group, left))
    sine = lambda i, t: 7**i * sin(7 * t + 1 + i * pi / 2)
    print("\n| sine, n | e at h = 1 ms | e at 2 ms in parts of it |\n| --- | --- | --- |")
    for n in range(1, 4):
        coarse, fine = (followed(command, n, "0", h, samples, sine, "sin(7*t + 1)", gain=gain)
                        for h, samples in (("0.002", 100), ("0.001", 200)))
        fine = [e / mpf("0.001") ** i for i, e in enumerate(fine)]
        coarse = [e / mpf("0.002") ** i for i, e in enumerate(coarse)]
        print(f"| {n} | {', '.join(f'{float(e):.1e}' for e in fine)} |",
              ", ".join(f"{float(a / b):.1f}" for a, b in zip(coarse, fine)), "|")
    return int(max(map(max, found.values())) > mpf("1e-13"))


def machine(rng, n):
    """A and B of a random plant whose output x1 the input reaches through all states."""
    number = lambda low, high: round(rng.choice((-1, 1)) * rng.uniform(low, high), 3)
    a = [[number(0, 9) if j <= i else number(1, 20) if j == i + 1 else 0 for j in range(n)] for i in range(n)]
    return a, [0] * (n - 1) + [number(1, 9)]


def output_rows(a, n):
    """y, y', ..., y^(n) of y = x1 without the input, over x."""
    found = [[mpf(j == 0) for j in range(n)]]
    for _ in range(n):
        found.append([sum(found[-1][i] * mpf(str(a[i][j])) for i in range(n)) for j in range(n)])
    return found


def followed_by(command, rng, n, delay, h, samples, r, text=None, observes=False, predicts=False, gain="1", of=None):
    """|y^(i) - r^(i)| h^i at sample N, of a random linear plant or that of `of`, and the largest of it before."""
    a, b = of or machine(rng, n)
    order = n if predicts else n + delay
    own = lambda count: ",".join(str(-count - 1 - i) for i in range(count))
    flags = [f"--A={rows(a)}", f"--B={[*b]}", f"--C={[1] + [0] * (n - 1)}" if observes else "--output=" + str([1] + [0] * (n - 1)),
             "--mu", "exp(a=1)", "--clock", "samples", "--sample-time", h, "--delay", str(delay),
             "--tau", nstr(samples * mpf(h), 30), f"--poles={own(order)}", "--reference", text or "input"]
    flags += [f"--observer-poles={own(n)}", "--deadbeat", str(2 * (2 * n + delay))] if observes and n > 1 else []
    controller = Controller(command, *flags)
    controller.init()
    period, y = mpf(h), output_rows(a, n)
    at = lambda t: lu_solve(matrix(y[:n]), matrix([r(i, t) for i in range(n)]))
    plant = [[str(value) for value in row] for row in a]
    loop = Linear(h, plant, [str(value) for value in b], [at(mpf(0))[i] + mpf(1) / (i + 2) for i in range(n)], delay, gain=gain)
    off = lambda t: [abs(sum(p * q for p, q in zip(y[i], loop.x)) - r(i, t)) * period**i for i in range(n)]
    most = mpf(0)
    for k in range(samples):
        now, acts = k * period, (k + delay) * period
        most = max(most, *off(now))
        mean = (r(n - 1, acts + period) - r(n - 1, acts)) / period
        given = [] if text else [*(r(i, now) for i in range(n)), mean]
        loop.step(controller.step(k, loop.x[:1] if observes else loop.x, given))
    return off(samples * period), most


def machines(command, gain):
    """Rows of Markdown: the most that is left of constants and by how much less of a sine for half the period, of plants."""
    rng, found = random.Random(1), {}
    constant = lambda i, t: mpf(3) / 4 if i == 0 else mpf(0)
    for n in range(1, 5):
        for delay in range(3):
            for known, words in (("3/4", "known"), (None, "given with each call")):
                for observes, group in ((False, "all states"), (True, "x1 alone")):
                    left, most = followed_by(
                        command, rng, n, delay, "0.005", 200, constant, known, observes, gain=gain)
                    found.setdefault(f"constant, {words}, {group}", []).append(max(left) / most)
    for n, delay in ((n, delay) for n in range(1, 5) for delay in (1, 2)):
        for observes, group in ((False, "all states"), (True, "x1 alone")):
            left, most = followed_by(
                command, rng, n, delay, "0.005", 200, constant, "3/4", observes, True, gain)
            found.setdefault(f"constant, predicted, {group}", []).append(max(left) / most)
    print("| reference | number | largest abs(y^(i-1) - r^(i-1)) h^(i-1), in parts of the largest before |\n| --- | --- | --- |")
    for group, left in sorted(found.items()):
        print(row(group, left))
    sine = lambda i, t: 7**i * sin(7 * t + 1 + i * pi / 2)
    print("\n| sine, n, delay | known: error at 2 ms in parts of that at 1 ms | given with each call |\n| --- | --- | --- |")
    for n, delay in ((1, 0), (2, 0), (3, 0), (3, 2)):
        of, parts = machine(rng, n), []
        for text in ("sin(7*t + 1)", None):
            coarse, fine = (followed_by(command, rng, n, delay, h, samples, sine, text, gain=gain, of=of)[0]
                            for h, samples in (("0.002", 250), ("0.001", 500)))
            parts.append(", ".join(f"{float(a / b / 2**i):.1f}" for i, (a, b) in enumerate(zip(coarse, fine))))
        print(f"| {n}, {delay} | {' | '.join(parts)} |")
    return int(max(map(max, found.values())) > mpf("1e-13"))


def plant(rng, n, kind, h):
    """A and B of a random plant, of some `kind`, in coordinates that mix its modes."""
    a = [[0.0] * n for _ in range(n)]
    rates = [rng.uniform(-8, 8) for _ in range(n)] if kind == "unstable" else [
        -rng.uniform(0.1, 20) for _ in range(n)]
    if kind == "stiff":
        rates[0] = -rng.uniform(2, 12) / h
    for i in range(n):
        a[i][i] = rates[i]
    if kind == "complex" and n > 1:
        w = rng.uniform(5, 40)
        a[0][0], a[0][1], a[1][0], a[1][1] = -0.3, w, -w, -0.3
    for _ in range(2 * n if n > 1 else 0):  # x_i += f x_j
        i, j = rng.sample(range(n), 2)
        f = rng.uniform(-1, 1)
        a[i] = [p + f * q for p, q in zip(a[i], a[j])]
        for row in a:
            row[j] -= f * row[i]
    b = [rng.uniform(-2, 2) for _ in range(n)]
    return [[float(f"{value:.6g}") for value in row] for row in a], [float(f"{value:.6g}") for value in b]


def rows(matrix):
    return "[" + ",".join("[" + ",".join(map(repr, row)) + "]" for row in matrix) + "]"


def one_plant(command, rng, n, kind, delay, samples, outputs=None, force=0, predicts=False, gain="1"):
    """What is left of a random plant at sample N; None where the generator refuses it."""
    h = rng.choice([0.001, 0.05])
    a, b = plant(rng, n, kind, h)
    order = n if predicts else n + int(ceil(mpf(delay)))
    flags = [f"--A={rows(a)}", f"--B={[*b]}", "--mu", "exp(a=1)", "--clock", "samples",
             "--sample-time", str(h), "--tau", nstr(samples * mpf(str(h)), 30), "--delay", str(delay),
             f"--poles={poles(rng, order, order)}"]
    c = None
    if outputs:
        c = [[round(rng.uniform(-1, 1), 3) for _ in range(n)] for _ in range(outputs)]
        count = n + (force != 0)
        flags += [f"--C={rows(c)}"]
        if outputs < n or force:
            own = poles(rng, count, count) if outputs == 1 else ",".join(f"-{count + i}" for i in range(count))
            flags += [f"--observer-poles={own}", "--deadbeat", str(2 * (order + count))]
            flags += ["--disturbance", "constant"] if force else []
    try:
        controller = Controller(command, *flags)
    except subprocess.CalledProcessError:
        return None
    controller.init()
    loop = Linear(str(h), a, b, [rng.uniform(-1, 1) for _ in range(n)], delay, force, gain)
    for k in range(samples):
        y = loop.x if c is None else [sum(p * q for p, q in zip(row, loop.x)) for row in c]
        loop.step(controller.step(k, y))
    return max(map(abs, loop.x)) / loop.most


def plants(command, gain):
    """Rows of Markdown: loops, plants refused, what is left in the median and at most."""
    rng, found, refused = random.Random(1), {}, {}

    def loop(group, *arguments):
        left = one_plant(command, rng, *arguments, gain=gain)
        if left is None:
            refused[group] = refused.get(group, 0) + 1
        else:
            found.setdefault(group, []).append(left)

    for kind in ("slow", "unstable", "complex", "stiff"):
        for n in range(1, 5):
            for delay in range(3):
                for samples in (n + delay + 2, 20, 1000):
                    enough = ">=" if samples >= 2 * (n + delay) else "<"
                    loop(f"all states, N {enough} 2 (n + d)", n, kind, delay, samples)
            for outputs in range(1, n + 1):
                loop("C of several rows, N = 200" if outputs > 1 else "C of one row, N = 200", n, kind, 1, 200, outputs)
                loop("observer and disturbance, N = 200", n, kind, 0, 200, outputs, 0.3)
    for kind in ("slow", "unstable", "complex", "stiff"):
        for n, delay in ((n, delay) for n in range(1, 5) for delay in ("0.3", 1, "2.75", 8)):
            loop("all states, predicted, N = 200", n, kind, delay, 200, None, 0, True)
            loop("C of one row, predicted, N = 200", n, kind, delay, 200, 1, 0, True)
    for group, left in sorted(found.items()):
        left.sort()
        ends = f"{float(left[len(left) // 2]):.1e} | {float(left[-1]):.1e}"
        print(f"| {group} | {len(left)} | {refused.get(group, 0)} | {ends} |")
    return 0


def gains(_, __):
    """Gains from the solutions T^(p) of the loop: those of the flat output and of the states that go with it."""
    plants = [
        ("motor", [[0, 1, 0], [0, "-0.5", 1500], [0, -15, -600]], [0, 0, 500], "1e-3"),
        ("complex", [[0, 1, 0, 0], [-900, "-0.6", 900, "0.6"], [0, 0, 0, 1], [400, "0.3", -400, "-0.3"]], [0, 0, 0, 1], "2e-3"),
        ("unstable", [[0, 1], [49, 0]], [0, "-1.3"], "0.01"),
        ("mixed", [["3.1", "-2", "0.4"], ["1.2", "-7", 1], ["0.3", "0.9", "-1.5"]], [1, "-0.4", "0.7"], "0.05"),
        ("stiff", [["-9000", 3], [2, "-0.5"]], [1, "0.25"], "1e-3"),
        ("first", [["-0.25"]], [2], "0.5"),
    ]
    found = []
    with mp.workdps(90):
        for name, a, b, h in plants:
            n = len(b)
            whole = zeros(n + 1, n + 1)
            for i in range(n):
                whole[i, n] = mpf(b[i]) * mpf(h)
                for j in range(n):
                    whole[i, j] = mpf(a[i][j]) * mpf(h)
            whole = expm(whole, method="taylor")
            phi, held = whole[:n, :n], whole[:n, n]
            # The row c with c Phi^i Gamma = 0, i < n - 1, and 1 for i = n - 1.
            reach = zeros(n, n)
            for j in range(n):
                column = phi**j * held
                for i in range(n):
                    reach[j, i] = column[i]
            unit = zeros(n, 1)
            unit[n - 1] = 1
            c = lu_solve(reach, unit).T
            flat = zeros(n, n)
            for j in range(n):
                row = c * phi**j
                for i in range(n):
                    flat[j, i] = row[i]
            for samples in (n + 2, 40, 1000):
                p = [mpf(n + 1) + mpf(i) * 5 / 4 for i in range(n)]
                chosen = sorted({0, samples // 2, samples - 1, max(0, samples - 2 * n - 4)})
                cases = {}
                for k in chosen:
                    left = samples - k
                    own, now = p, mpf(left)
                    if n == 1 and p[0] == int(p[0]):
                        # One integer ends at rest by itself.
                        now = max(left, n) + p[0] - 1
                    elif left <= max(2 * n, int(ceil(max(p))) + n - 1):
                        s = max(n, int(ceil(min(p)))) - 1
                        own, now = [mpf(s + i) for i in range(1, n + 1)], mpf(max(left, n) + s)
                    x, u = zeros(n, n), zeros(1, n)
                    for i in range(n):
                        y = [falling(now - j, own[i]) / falling(now, own[i]) for j in range(n + 1)]
                        state = lu_solve(flat, matrix(y[:n]))
                        u[i] = y[n] - (c * phi**n * state)[0]
                        for j in range(n):
                            x[j, i] = state[j]
                    row = lu_solve(x.T, u.T)
                    cases[str(k)] = [nstr(value, 40) for value in row]
                found.append({
                    "name": name, "A": rows(a).replace("'", ""), "B": str(b).replace("'", ""),
                    "h": h, "samples": samples, "poles": [nstr(-value, 20) for value in p], "gains": cases,
                })
    print(json.dumps(found, indent=1))
    return 0


def falling(m, p):
    """m^(p)."""
    return rgamma(m - p + 1) * gamma(m + 1)


def stage(command, _):
    """Rows of Markdown: the worst of 20 runs from 0.1 m with 0.3 N, on a grid of the encoder's steps."""
    for observer_eps, eps in ((0.01, 0), (0.03, 0), (0.03, 0.02), (0.06, 0.02), (0.06, 0.1)):
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
    commands = {"table": table, "rest": rest, "alone": alone, "follow": follow, "machines": machines, "plants": plants, "gains": gains, "stage": stage, "energy": energy, "delays": delays, "swing": swing}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("what", choices=commands)
    parser.add_argument("command", metavar="COMMAND")
    parser.add_argument("--gain", default="1")
    arguments = parser.parse_args()
    sys.exit(commands[arguments.what](arguments.command, arguments.gain))
