"""Deadlines of linear plants in flight, planned from a table: the emitted C against plants of its own, in doubles.

    python3 tools/flight_tables.py soonest COMMAND   no limit is exceeded from N of `soonest`; N over the least one
    python3 tools/flight_tables.py late COMMAND      deadlines that are put off after kicks, and not without
    python3 tools/flight_tables.py cost COMMAND      instructions of `soonest` and of a step, by callgrind; bytes

COMMAND is the path of ptc-codegen. Needs a C compiler called cc, `cost` valgrind and size. The first two end with 1 where a limit
is exceeded, the plant is not at rest, or a deadline is put off although nothing acted. Plants are random: stable,
unstable and oscillating, of order 2 to `--most`, with delays, bounds of states, weights and held gains.
"""

import argparse
import ctypes
import math
import random
import subprocess
import sys
import tempfile
from math import inf
from pathlib import Path

from flight import LATE, OK, SATURATED, SOON, Emitted, numbers

H, TAU = 0.01, 0.5
STRETCH = 1.0 + 1e-9
INFEASIBLE = 6


def times(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def exponential(a):
    """e^A by its series, halved until A is small."""
    size = max(sum(map(abs, row)) for row in a)
    halvings = max(0, math.ceil(math.log2(size + 1e-300)) + 4)
    a = [[x / 2**halvings for x in row] for row in a]
    unit = [[float(i == j) for j in range(len(a))] for i in range(len(a))]
    total, term = unit, unit
    for k in range(1, 20):
        term = [[x / k for x in row] for row in times(term, a)]
        total = [[x + y for x, y in zip(*rows)] for rows in zip(total, term)]
    for _ in range(halvings):
        total = times(total, total)
    return total


class Plant:
    """x' = A x + B u, u held, `delay` samples late."""

    def __init__(self, a, b, delay):
        self.n, self.delay = len(b), delay
        self.whole, part = int(delay), delay - int(delay)
        self.parts = [self.over(a, b, part * H)] if part else []
        self.parts.append(self.over(a, b, (1 - part) * H))
        self.x, self.under_way = [0.0] * self.n, []

    @staticmethod
    def over(a, b, t):
        n = len(b)
        whole = exponential([[x * t for x in row] + [u * t] for row, u in zip(a, b)] + [[0.0] * (n + 1)])
        return whole[:n]

    def start(self, x):
        self.x, self.under_way = list(map(float, x)), [0.0] * (self.whole + len(self.parts) - 1)

    def move(self, u):
        """One sample: the oldest input acts first, where another one takes over within the sample."""
        self.under_way.append(u)
        for index, part in enumerate(self.parts):
            acts = self.under_way[index]
            self.x = [sum(p * x for p, x in zip(row, self.x + [acts])) for row in part]
        self.under_way.pop(0)


class Design:
    """A random plant with limits, and the flags of its controller."""

    def __init__(self, draw, n, kind):
        modes, left = [], n
        while left:
            unstable = {"stable": 0.0, "unstable": 0.5, "oscillating": 0.1}[kind]
            rate = draw.uniform(0.1, 4) if draw.random() < unstable else -draw.uniform(0, 8)
            if left > 1 and draw.random() < (0.8 if kind == "oscillating" else 0.3):
                modes.append((rate * (0.1 if kind == "oscillating" else 1), draw.uniform(3, 40)))
                left -= 2
            else:
                modes.append((rate, None))
                left -= 1
        a = [[0.0] * n for _ in range(n)]
        place = 0
        for rate, turns in modes:
            a[place][place] = rate
            if turns:
                a[place + 1][place + 1] = rate
                a[place][place + 1], a[place + 1][place] = turns, -turns
                place += 1
            place += 1
        # Other coordinates: sums with the neighbours.
        mix = [[float(i == j) for j in range(n)] for i in range(n)]
        back = [row[:] for row in mix]
        for _ in range(n):
            i, j, c = *draw.sample(range(n), 2), draw.uniform(-1, 1)
            shear = [[float(p == q) + (c if (p, q) == (i, j) else 0) for q in range(n)] for p in range(n)]
            other = [[float(p == q) - (c if (p, q) == (i, j) else 0) for q in range(n)] for p in range(n)]
            mix, back = times(shear, mix), times(back, other)
        self.a = [[round(x, 4) for x in row] for row in times(times(mix, a), back)]
        self.b = [round(draw.choice([-1, 1]) * draw.uniform(0.3, 2), 3) for _ in range(n)]
        self.delay = draw.choice([0, 0, 2, 0.3])
        self.eps = draw.choice([0, 0, 0.08])
        self.weight = draw.choice([0, 0, 1, 2])
        self.u_max = round(10 ** draw.uniform(-0.5, 1), 3)
        self.state_max = [inf] * n
        if draw.random() < 0.5:
            self.state_max[draw.randrange(n)] = round(10 ** draw.uniform(-1.5, 0), 3)
        self.n, self.name = n, f"{n} {kind} d={self.delay} eps={self.eps} w={self.weight} bounded={self.state_max.count(inf) < n}"

    def flags(self):
        text = lambda row: "[" + ",".join(map(repr, row)) + "]"
        rows = "[" + ",".join(map(text, self.a)) + "]"
        flags = ["--clock", "samples", "--sample-time", str(H), "--tau", str(TAU), f"--eps={self.eps}"]
        flags += [f"--A={rows}", f"--B={text(self.b)}", f"--poles=least-energy(weight={self.weight})"]
        flags += [f"--u-max={self.u_max}", "--state-max=" + ",".join(map(str, self.state_max))]
        if self.delay:
            flags += [f"--delay={self.delay}"]
        if self.delay == 2:
            flags += ["--delay-law=predict"]
        return flags

    def plant(self):
        return Plant(self.a, self.b, self.delay)

    def parts(self, x, u):
        """The largest part of a limit that is taken."""
        states = [abs(x) / most for x, most in zip(x, self.state_max)]
        return max([abs(u) / self.u_max, *states])


def emitted(command, design, *flags):
    """The controller, and the warning of a design that is refused."""
    try:
        return Emitted(command, *design.flags(), *flags)
    except subprocess.CalledProcessError:
        return None


def designs(draw, options):
    for n in range(2, options.most + 1):
        for kind in ("stable", "unstable", "oscillating"):
            for _ in range(options.designs):
                yield Design(draw, n, kind)


def arm(control, design, k=0):
    control.call("arm", ctypes.c_uint32(k))
    for _ in range(math.ceil(design.delay)):
        control.call("applied", ctypes.c_double(0.0))


def run(control, design, plant, x, k, samples):
    """The largest part of a limit on the way to rest and behind it, and what is left at the end."""
    arm(control, design, k)
    for index in range(math.ceil(design.delay)):
        control.call("applied", ctypes.c_double(0.0))
    if control.call("arm_for", ctypes.c_uint32(k), ctypes.c_uint32(samples)) != OK:
        raise ValueError(f"arm_for refuses {samples}")
    plant.start(x)
    most, behind = 0.0, 400 if design.eps else 5
    for elapsed in range(samples + behind):
        u, status = control.step((k + elapsed) % (1 << 32), plant.x)
        if status == SATURATED:
            return inf, inf
        # The inputs under way have decided the first states.
        states = plant.x if elapsed >= int(design.delay) else [0.0] * design.n
        most = max(most, design.parts(states, u))
        plant.move(u)
    return most, max(map(abs, plant.x))


def soonest(command, options):
    draw, bad, drawn, refused, ratios, forces = random.Random(options.seed), 0, 0, 0, [], []
    print("design: runs, none found, exceeded; N over the least kept N: median, worst; limits that are left at the edge: median, worst")
    for design in designs(draw, options):
        # The reserve makes it plan; the flag lets it arm any deadline.
        control = emitted(command, design, "--in-flight", "--reserve=1e-9")
        drawn += 1
        if control is None:
            refused += 1
            print(design.name, "refused")
            continue
        plant, free = design.plant(), None
        none, exceeded, own, left = 0, 0, [], []
        for _ in range(options.runs):
            x = [draw.uniform(-1, 1) * 10 ** draw.uniform(-2, 0) for _ in range(design.n)]
            for i, most in enumerate(design.state_max):
                x[i] = max(-0.95 * most, min(0.95 * most, x[i]))
            arm(control, design)
            found = control.soonest(x)
            if found is None:
                none += 1
                continue
            # The edge: the largest multiple of x for which N is found.
            low, high = 1.0, 64.0
            for _ in range(30):
                middle = math.sqrt(low * high)
                arm(control, design)
                soon = control.soonest([middle * own for own in x])
                low, high = (middle, high) if soon is not None and soon <= found else (low, middle)
            edge = [low * own for own in x]
            k = draw.randrange(1 << 32)
            most, rest = run(control, design, plant, edge, k, found)
            if most > STRETCH or not design.eps and rest > 1e-7 * max(map(abs, edge)):
                exceeded += 1
                print("   exceeded", design.name, edge, found, most, rest)
            left.append(1.0 / most)
            least = next((n for n in range(design.n + 3, found) if run(control, design, plant, edge, k, n)[0] <= 1.0), found)
            own.append(found / least)
        bad += exceeded
        ratios, forces = ratios + own, forces + left
        print(f"{design.name}: {options.runs}, {none}, {exceeded}; {shown(own)}; {shown(left)}", flush=True)
    print(f"{drawn} designs, {refused} refused, {len(ratios)} runs, {bad} exceeded; N {shown(ratios)}; limits {shown(forces)}")
    return bad or not ratios


def shown(values):
    values = sorted(values)
    return f"{values[len(values) // 2]:.3f} {values[-1]:.3f}" if values else "-"


def late(command, options):
    draw, bad, put_off, clipped = random.Random(options.seed), 0, 0, 0
    for design in designs(draw, options):
        control = emitted(command, design, "--late=extend")
        if control is None:
            continue
        plant, off = design.plant(), 0
        for _ in range(options.runs):
            x = [draw.uniform(-1, 1) * 10 ** draw.uniform(-2.5, -0.5) for _ in range(design.n)]
            x = [max(-0.9 * most, min(0.9 * most, own)) for own, most in zip(x, design.state_max)]
            arm(control, design)
            if control.soonest(x) is None:
                continue
            control.call("arm_for", ctypes.c_uint32(0), ctypes.c_uint32(draw.randrange(design.n + 4, 60)))
            plant.start(x)
            kicked = draw.randrange(5, 60)
            k, last, planned = 0, control.deadline(), True
            while k < max(control.deadline(), kicked) + (400 if design.eps else 10):
                u, status = control.step(k, plant.x)
                now = control.deadline()
                acted = k in (0, kicked + 1)
                planned = status not in (INFEASIBLE, SATURATED) if acted else planned
                if now < last or now > last and not acted and planned:
                    bad += 1
                    print("   put off although nothing acted", design.name, k, last, now, status)
                inside = k < int(design.delay) or design.parts(plant.x, u) <= STRETCH
                if planned and not (inside and status != SATURATED):
                    bad += 1
                    print("   limit", design.name, k, plant.x, u, status)
                clipped += status == SATURATED
                off, last = off + (now > last), now
                plant.move(u)
                if k == kicked:
                    plant.x = [own + draw.uniform(-1, 1) * 0.1 * abs(own) for own in plant.x]
                    # What acts at a sample is seen at the next one.
                k += 1
            if planned and not design.eps and max(map(abs, plant.x)) > 1e-7 * max(map(abs, x)):
                bad += 1
                print("   rest", design.name, plant.x)
        put_off += off
        print(f"{design.name}: {options.runs}, {off} put off", flush=True)
    print(f"{put_off} put off, {clipped} clipped samples without a plan, {bad} wrong")
    return bad or not put_off


MAIN = """#include "probe.h"
#include <stdlib.h>
int main(int count, char **given) {
    static probe c; probe_params p = {0}; double x[4], u; uint32_t n = 0, k; (void)count;
    probe_init(&c, &p);
    for (k = 0; k < 1000; k++) {
        for (int i = 0; i < 4; i++) x[i] = 1e-2 * ((double)rand() / RAND_MAX - 0.5);
        if (given[1][0] == 's') probe_soonest(&c, x, &n);
        else if (given[1][0] == 't') probe_step(&c, 0, x, &u);
    }
    return 0;
}
"""

PLANTS = {
    "motor, n = 2": ("[[0,1],[0,-5]]", "[0,40]", "1,inf"),
    "oscillator, n = 2": ("[[0,1],[-400,-2]]", "[0,40]", "inf,inf"),
    "motor with current, n = 3": ("[[0,1,0],[0,-1,30],[0,-2,-80]]", "[0,0,50]", "inf,inf,inf"),
    "two masses, n = 4": ("[[0,1,0,0],[-90,0,90,0],[0,0,0,1],[45,0,-45,0]]", "[0,4,0,0]", "inf,inf,inf,inf"),
}


def cost(command, _):
    for name, (a, b, states) in PLANTS.items():
        for limit in ("--late=extend", "--in-flight"):
            with tempfile.TemporaryDirectory() as folder:
                flags = ["--mu=exp(a=1)", "--clock=samples", "--sample-time=0.01", "--tau=1", "--eps=0", f"--A={a}", f"--B={b}"]
                flags += ["--poles=least-energy", "--u-max=10", limit]
                flags += [f"--state-max={states}"] if limit == "--late=extend" else []
                emit = [command, "emit", "--lang", "c", "--name", "probe", "-o", folder, *flags]
                subprocess.run(emit, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                counts = []
                main = Path(folder, "main.c")
                source = MAIN if limit == "--late=extend" else MAIN.replace("probe_soonest(&c, x, &n)", "(void)n")
                main.write_text(source)
                build = ["cc", "-std=c99", "-O2", main, Path(folder, "probe.c"), "-o", Path(folder, "run"), "-lm"]
                subprocess.run(build, check=True)
                for call in "nst":
                    grind = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", Path(folder, "run"), call]
                    told = subprocess.run(grind, check=True, capture_output=True, text=True).stderr
                    counts.append(int(told.split("Collected : ")[1].split()[0]))
                subprocess.run(["cc", "-std=c99", "-Os", "-c", Path(folder, "probe.c"), "-o", Path(folder, "probe.o")], check=True)
                size = subprocess.run(["size", Path(folder, "probe.o")], check=True, capture_output=True, text=True).stdout
                text = size.split("\n")[1].split()[0]
                each = [(count - counts[0]) // 1000 for count in counts[1:]]
                print(f"{name} {limit}: soonest {each[0]}, step {each[1]} instructions, {text} bytes of code and tables")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("part", choices=["soonest", "late", "cost"])
    parser.add_argument("command")
    parser.add_argument("--runs", type=int, default=20)
    parser.add_argument("--designs", type=int, default=4, help="designs of each order and kind")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--most", type=int, default=4, help="greatest order")
    options = parser.parse_args()
    return min(1, int(globals()[options.part](options.command, options)))


if __name__ == "__main__":
    sys.exit(main())
