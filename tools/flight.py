"""Deadlines that change in flight: the emitted C against a plant of its own, in doubles.

    python3 tools/flight.py soonest COMMAND   soonest deadlines: kept from there on, and how near the least one
    python3 tools/flight.py late COMMAND      deadlines that are put off: held, kicked, a payload, a start in motion
    python3 tools/flight.py told COMMAND      functions called in random order between samples: at rest all the same
    python3 tools/flight.py fast COMMAND      time to rest over the least there is, from random states
    python3 tools/flight.py oracle COMMAND    soonest deadlines of tests/data/soonest.json, where the least one is known

COMMAND is the path of ptc-codegen. Needs a C compiler called cc; `fast` needs PyPI's ruckig for n = 3.
Each of the others ends with 1 where a limit is exceeded, or the plant is not at rest.
"""

import argparse
import ctypes
import json
import random
import subprocess
import sys
import tempfile
from math import factorial
from pathlib import Path

ROOM = 1 << 14  # bytes for a controller, whatever its fields
OK, HOLD, SATURATED, LATE, SOON = 0, 1, 2, 5, -4


class Emitted:
    """C emitted with `flags` as a shared library; every parameter is fixed."""

    def __init__(self, command, *flags):
        self.folder = tempfile.TemporaryDirectory()
        folder = Path(self.folder.name)
        emit = [command, "emit", "--lang", "c", "--name", "probe", "-o", folder, "--mu", "exp(a=1)"]
        subprocess.run([*emit, *flags], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        library = folder / "probe.so"
        flags = ["-std=c99", "-O2", "-ffp-contract=off", "-shared", "-fPIC"]
        subprocess.run(["cc", *flags, folder / "probe.c", "-o", library, "-lm"], check=True)
        self.library, self.state = ctypes.CDLL(library), ctypes.create_string_buffer(ROOM)
        if self.call("init", ctypes.byref(ctypes.c_char())) != 0:
            raise ValueError("init refuses")

    def call(self, function, *given):
        return getattr(self.library, f"probe_{function}")(self.state, *given)

    def step(self, k, x):
        u = ctypes.c_double()
        status = self.call("step", ctypes.c_uint32(k), numbers(x), ctypes.byref(u))
        if status < 0:
            raise ValueError(f"step({k}, {x}) gives {status}")
        return u.value, status

    def soonest(self, x=None):
        samples = ctypes.c_uint32(12345)
        given = [] if x is None else [numbers(x)]
        status = self.call("soonest", *given, ctypes.byref(samples))
        return None if status == SOON else samples.value

    def deadline(self):
        k = ctypes.c_uint32()
        self.call("deadline", ctypes.byref(k))
        return k.value


def numbers(x):
    return (ctypes.c_double * len(x))(*map(float, x))


class Chain:
    """x_i' = x_{i+1}, x_n' = g (u + force), u held for h and `late` samples late."""

    def __init__(self, x, h, g=1.0, late=0, force=0.0):
        self.x, self.h, self.g, self.force = list(map(float, x)), h, g, force
        self.under_way = [0.0] * late

    def move(self, u, kick=0.0):
        self.under_way.append(u)
        w = self.g * (self.under_way.pop(0) + self.force + kick)
        n, h = len(self.x), self.h
        self.x = [
            sum(self.x[j] * h ** (j - i) / factorial(j - i) for j in range(i, n))
            + w * h ** (n - i) / factorial(n - i)
            for i in range(n)
        ]


def kept(chain, control, first, samples, u_max, state_max, stretch=1.0 + 1e-9):
    """Runs to rest; the names of the limits that are exceeded."""
    wrong, scale = set(), max(abs(value) for value in chain.x) or 1.0
    for k in range(first, first + samples + 5):
        for i, most in enumerate(state_max):
            if abs(chain.x[i]) > most * stretch:
                wrong.add(f"x{i + 1}")
        u, status = control.step(k, chain.x)
        if status == SATURATED:
            wrong.add("clipped")
        if abs(u) > u_max * stretch:
            wrong.add("u")
        if k >= first + samples and max(map(abs, chain.x)) > 1e-9 * scale:
            wrong.add("rest")
        chain.move(u)
    return wrong


def soonest(command, options):
    """From random states: N of `soonest` is kept, and the least N that is kept is not much smaller."""
    draw, bad, runs = random.Random(options.seed), 0, 0
    print("n weight end eps late state_max: runs, exceeded, N over the least kept N: median, worst")
    for n, weight, end, eps, late, limited in designs(options):
        h, u_max = 0.01, 5.0
        order = n
        state_max = [float("inf")] * n
        flags = ["--n", str(n), "--clock", "samples", "--sample-time", "0.01", "--tau", "1", f"--eps={eps}"]
        flags += [f"--poles=least-energy(weight={weight})", f"--u-max={u_max}", "--in-flight"]
        if end:
            flags += [f"--poles-end=least-energy(weight={weight + 1})", f"--end-samples={end}"]
        if late:
            flags += [f"--delay={late}", "--delay-law", "predict"]
        if limited:
            state_max[1] = 0.8
            flags += ["--state-max=" + ",".join(map(str, state_max))]
        control = Emitted(command, *flags)
        ratios, exceeded, none = [], 0, 0
        for _ in range(options.runs):
            size = 10 ** draw.uniform(-2, 0.5)
            x = [draw.uniform(-1, 1) * size * (0.5 if i else 1.0) for i in range(n)]
            if limited:
                x[1] = draw.uniform(-0.75, 0.75)
            control.call("arm", ctypes.c_uint32(0))
            for _ in range(late):
                control.call("applied", ctypes.c_double(0.0))
            samples = control.soonest(x)
            if samples is None:
                none += 1
                continue
            k = draw.randrange(1 << 32)
            if control.call("arm_for", ctypes.c_uint32(k), ctypes.c_uint32(samples)) != 0:
                raise ValueError("arm_for refuses the soonest deadline")
            rest = samples if not eps else samples + 3000
            chain = Chain(x, h, late=late)
            wrong = kept(chain, control, k, rest, u_max, state_max)
            if eps:
                wrong.discard("rest")
            if wrong:
                exceeded += 1
                print("   exceeded", wrong, x, samples)
            if not late and not eps and len(ratios) < 40:
                least = first_kept(control, x, h, samples, u_max, state_max)
                ratios.append(samples / least)
        bad, runs = bad + exceeded, runs + 1
        ratios.sort()
        shown = f"{ratios[len(ratios) // 2]:.3f} {ratios[-1]:.3f}" if ratios else "-"
        print(f"{n} {weight} {end} {eps} {late} {limited}: {options.runs}, {exceeded}, {shown}, none {none}", flush=True)
    print(f"{runs} designs, {bad} exceeded")
    return bad


def first_kept(control, x, h, samples, u_max, state_max):
    """The least N with which the run itself keeps the limits."""
    for count in range(max(len(x) + 1, samples // 4), samples + 1):
        control.call("arm_for", ctypes.c_uint32(0), ctypes.c_uint32(count))
        if not kept(Chain(x, h), control, 0, count, u_max, state_max) - {"rest"}:
            return count
    return samples


def designs(options):
    for n in range(1, options.most + 1):
        for weight in (0, 1, 2):
            for end in (0, 30):
                for eps in (0, 0.08):
                    for late in (0, 1.5) if n < 3 else (0,):
                        for limited in (False, True) if n > 1 else (False,):
                            if late == int(late):
                                late = int(late)
                            if late and limited:
                                continue
                            yield n, weight, end, eps, 0 if not late else 2, limited


def oracle(command, options):
    """Cases with the least N that is kept."""
    bad = 0
    for case in json.loads(Path(options.cases).read_text()):
        n, weight = case["n"], case["weight"]
        flags = ["--n", str(n), "--clock", "samples", "--sample-time", "0.01", "--tau", "1", "--eps=0"]
        flags += [f"--poles=least-energy(weight={weight})", f"--u-max={case['u_max']}", "--in-flight"]
        found = Emitted(command, *flags).soonest(case["x0"])
        first = case["first_feasible"]
        wrong = first is not None and (found is None or found < first)
        bad += wrong
        ratio = "-" if first is None or found is None else f"{found / first:.3f}"
        print(n, weight, first, found, ratio, "WRONG" if wrong else "")
    return bad


def late(command, options):
    """Deadlines that are put off, with an encoder's exact reading, a delay and an unknown force."""
    draw, bad = random.Random(options.seed), 0
    stage = ["--n", "2", "--g=1/1.5", "--clock", "samples", "--sample-time", "1e-3", "--delay", "1"]
    stage += ["--poles=least-energy", "--poles-end=least-energy(weight=1)", "--end-samples", "50"]
    stage += ["--measured", "x1", "--disturbance", "constant", "--observer-poles=-4,-5,-6"]
    stage += ["--observer-samples", "100", "--observer-eps", "0.02", "--eps=0.01", "--u-max", "6", "--tau", "0.8"]
    print("case: runs, clipped samples, latest deadline in s, worst rest in um, put off")
    for pace in ("deadline", "soonest"):
        control = Emitted(command, *stage, "--late", "extend", "--pace", pace, "--reserve", "0.1")
        for name in ("alone", "short", "held", "kicked", "payload", "moving"):
            clipped, latest, worst, off = 0, 0.0, 0.0, 0
            for _ in range(options.runs):
                x = [draw.uniform(-0.2, 0.2), 0.0]
                samples = 800
                if name == "short":
                    samples = draw.randrange(20, 400)
                if name == "moving":
                    x[1] = draw.uniform(-0.5, 0.5)
                g = 1 / 1.5 if name != "payload" else 1 / (1.5 * draw.uniform(0.9, 1.25))
                chain = Chain(x, 1e-3, g, late=1, force=draw.uniform(-0.4, 0.4))
                control.call("init", ctypes.byref(ctypes.c_char()))
                control.call("assume", numbers(x))
                control.call("assume_disturbance", ctypes.c_double(chain.force))
                control.call("arm_for", ctypes.c_uint32(0), ctypes.c_uint32(samples))
                held, kick = draw.randrange(50, 500), draw.randrange(100, 700)
                k = 0
                while k < 4000 and (k < control.deadline() + 200 or k < 900):
                    u, status = control.step(k, chain.x[:1])
                    clipped += status == SATURATED
                    off += status == LATE
                    chain.move(u, 8.0 if name == "kicked" and kick <= k < kick + 20 else 0.0)
                    if name == "held" and k < held:
                        chain.x = list(x)
                    k += 1
                latest = max(latest, control.deadline() * 1e-3)
                worst = max(worst, abs(chain.x[0]) * 1e6)
            # The observer of a held or a kicked stage takes the hold for a force, so that u may be clipped.
            exact = name in ("alone", "short", "moving")
            bad += bool(exact and (clipped or worst > 0.01))
            print(f"{pace} {name}: {options.runs}, {clipped}, {latest:.3f}, {worst:.4f}, {off}", flush=True)
    return bad


def told(command, options):
    """Random calls between samples, each with its truth in the plant."""
    draw, bad = random.Random(options.seed), 0
    stage = ["--n", "2", "--g=1/1.5", "--clock", "samples", "--sample-time", "1e-3", "--delay", "1"]
    stage += ["--poles=least-energy", "--measured", "x1", "--disturbance", "constant"]
    stage += ["--observer-poles=-4,-5,-6", "--observer-samples", "100", "--u-max", "inf", "--tau", "0.5"]
    control = Emitted(command, *stage, "--in-flight")
    worst = 0.0
    for run in range(options.runs):
        chain = Chain([draw.uniform(-0.2, 0.2), 0.0], 1e-3, 1 / 1.5, late=1, force=draw.uniform(-1, 1))
        control.call("init", ctypes.byref(ctypes.c_char()))
        k = draw.randrange(1 << 32)
        control.call("arm", ctypes.c_uint32(k))
        end = k + 500
        for _ in range(2000):
            choice = draw.random()
            if choice < 0.002:
                samples = draw.randrange(200, 600)
                control.call("arm_for", ctypes.c_uint32(k), ctypes.c_uint32(samples))
                end = k + samples
            elif choice < 0.004:
                dx = draw.uniform(-0.1, 0.1)
                control.call("move", ctypes.c_double(dx))
                chain.x[0] -= dx
                control.call("arm_for", ctypes.c_uint32(k), ctypes.c_uint32(400))
                end = k + 400
            elif choice < 0.006:
                chain.x[1] += draw.uniform(-0.2, 0.2)
                control.call("assume_disturbance", ctypes.c_double(chain.force))
                control.call("assume", numbers(chain.x))
                control.call("arm_for", ctypes.c_uint32(k), ctypes.c_uint32(300))
                end = k + 300
            if control.deadline() != end % (1 << 32):
                raise ValueError("deadline differs")
            u, status = control.step(k % (1 << 32), chain.x[:1])
            if draw.random() < 0.02:
                u *= draw.uniform(0.5, 1.0)
                control.call("applied", ctypes.c_double(u))
            chain.move(u)
            k += 1
            if k - end > 150:
                break
        while k < end + 20:
            u, status = control.step(k % (1 << 32), chain.x[:1])
            chain.move(u)
            k += 1
        worst = max(worst, abs(chain.x[0]), abs(chain.x[1]) * 1e-3)
    print(f"{options.runs} runs, off by {worst:.2e} at most")
    return bad + (worst > 1e-9)


def least_time(x, u_max):
    """Time of the fastest input within its limit: bang-bang, in closed form for n = 2, by Ruckig for n = 3."""
    if len(x) == 2:
        x1, x2 = x[0] / u_max, x[1] / u_max
        side = 1.0 if x1 + x2 * abs(x2) / 2 > 0 else -1.0
        x1, x2 = side * x1, side * x2
        return x2 + 2 * (x1 + x2 * x2 / 2) ** 0.5
    import ruckig

    plan = ruckig.InputParameter(1)
    plan.current_position, plan.current_velocity, plan.current_acceleration = ([value] for value in x)
    plan.max_velocity, plan.max_acceleration, plan.max_jerk = [1e6], [1e6], [u_max]
    trajectory = ruckig.Trajectory(1)
    ruckig.Ruckig(1).calculate(plan, trajectory)
    return trajectory.duration


def fast(command, options):
    """Time to rest, over the least there is."""
    draw, bad = random.Random(options.seed), 0
    print("n weight pace: runs, clipped, off at rest, time over the least: median, worst")
    for n in (2, 3):
        for weight in (0, 1):
            for pace in ("deadline", "soonest"):
                h, u_max = 1e-3, 10.0
                flags = ["--n", str(n), "--clock", "samples", "--sample-time", "1e-3", "--tau", "1", "--eps=0"]
                flags += [f"--poles=least-energy(weight={weight})", f"--u-max={u_max}"]
                control = Emitted(command, *flags, "--late", "extend", "--pace", pace)
                ratios, clipped, off = [], 0, 0.0
                for _ in range(options.runs):
                    x = [draw.uniform(-1, 1) for _ in range(n)]
                    least = least_time(x, u_max)
                    samples = control.soonest(x)
                    control.call("arm_for", ctypes.c_uint32(0), ctypes.c_uint32(samples))
                    chain, k = Chain(x, h), 0
                    while k < control.deadline():
                        u, status = control.step(k, chain.x)
                        clipped += status == SATURATED
                        chain.move(u)
                        k += 1
                    off = max(off, *map(abs, chain.x))
                    ratios.append(k * h / least)
                ratios.sort()
                bad += bool(clipped) + (off > 1e-9)
                shown = f"{ratios[len(ratios) // 2]:.3f} {ratios[-1]:.3f}"
                print(f"{n} {weight} {pace}: {options.runs}, {clipped}, {off:.1e}, {shown}", flush=True)
    return bad


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("part", choices=["soonest", "late", "told", "fast", "oracle"])
    parser.add_argument("command")
    parser.add_argument("--runs", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--most", type=int, default=3, help="greatest order")
    parser.add_argument("--cases", default="tests/data/soonest.json", help="a list of cases")
    options = parser.parse_args()
    return min(1, globals()[options.part](options.command, options))


if __name__ == "__main__":
    sys.exit(main())
