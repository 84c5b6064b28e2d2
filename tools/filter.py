"""Attacks filters: `what = "filter"`, the emitted C against a plant in exact rational numbers.

    python3 tools/filter.py COMMAND [--designs D] [--seed S]

COMMAND is the binary `ptc-codegen`. Each design is random: order, period, bounds, poles, gain, force, delay and limits of u.
A plant of this program's own follows each emitted u without rounding, and is looked at between samples too.

kept     from a safe start with limits that `check` calls enough, under random controllers: every state within its bounds,
         no status INFEASIBLE, and u the bits of the controller's where the status is OK
return   one bound, from any start, without limits of u: within it from sample N on
starved  limits of u that `check` calls too small: how often a bound gives way, and whether the status says so
"""

import argparse
import ctypes
import math
import pathlib
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

OK, SATURATED, INFEASIBLE = 0, 2, 6


class Chain:
    """x_n' = f + g u, u held, `late` samples late, between samples too."""

    def __init__(self, case):
        self.n, self.h, self.g, self.f = case["n"], case["h"], case["g"], case["f"]
        late = case["delay"]
        self.inputs = math.ceil(late)
        self.part = Fraction(late) - self.inputs + 1 if self.inputs else Fraction(1)
        self.past = [Fraction(0)] * self.inputs
        self.x = [Fraction(0)] * self.n

    def after(self, x, u, t):
        n, v = self.n, self.f + self.g * u
        power = [t**k / math.factorial(k) for k in range(n + 1)]
        return [sum(power[j - i] * x[j] for j in range(i, n)) + power[n - i] * v for i in range(n)]

    def step(self, u, parts=4):
        """Goes on by a sample under the input u of now; gives the states on the way."""
        self.past.insert(0, u)
        newer, older = self.past[self.inputs - 1 if self.inputs else 0], self.past[self.inputs]
        switch = self.part * self.h if self.inputs else self.h
        first, second = (older, newer) if self.inputs else (u, u)
        ways = [self.after(self.x, first, switch * Fraction(k, parts)) for k in range(1, parts + 1)]
        middle = ways[-1]
        rest = self.h - switch
        if rest:
            ways += [self.after(middle, second, rest * Fraction(k, parts)) for k in range(1, parts + 1)]
        # Exact to far beyond a double, and not longer with each sample.
        self.x = [x.limit_denominator(10**40) for x in ways[-1]]
        self.past = self.past[: self.inputs]
        return ways


def emitted(command, folder, case):
    """The step of the emitted C."""
    subprocess.run([command, "emit", "--lang", "c", "-o", str(folder), *flags(case)], check=True, capture_output=True)
    library = folder / f"own{random.random()}.so"
    subprocess.run(["cc", "-O1", "-ffp-contract=off", "-shared", "-fPIC", "-o", str(library), str(folder / "own_filter.c"), "-lm"], check=True)
    code = ctypes.CDLL(str(library))
    own, params = ctypes.create_string_buffer(4096), ctypes.create_string_buffer(64)
    assert code.own_filter_init(own, params) == 0
    real = ctypes.c_double

    def step(k, x, nominal):
        u = real()
        status = code.own_filter_step(own, ctypes.c_uint32(k), (real * len(x))(*map(float, x)), real(nominal), ctypes.byref(u))
        return status, u.value

    return step


def listed(values):
    return ",".join("inf" if v == math.inf else "-inf" if v == -math.inf else repr(float(v)) for v in values)


def flags(case):
    all = ["--name=own", "--what=filter", f"--n={case['n']}", f"--sample-time={float(case['h'])!r}", f"--tau={float(case['h'] * case['samples'])!r}"]
    all += [f"--keep-below={listed(case['below'])}", f"--keep-above={listed(case['above'])}", f"--keep-poles={listed(case['poles'])}"]
    all += [f"--g={float(case['g'])!r}", f"--f={float(case['f'])!r}", f"--delay={float(case['delay'])!r}", f"--poles=least-energy(weight={case['weight']})"]
    all += [f"--u-max={listed([case['u_max']])}", f"--u-min={listed([case['u_min']])}"]
    return all


def product_of_rates(rates):
    all = [1.0]
    for rate in rates:
        all = [(all[k] if k < len(all) else 0) + (rate * all[k - 1] if k else 0) for k in range(len(all) + 1)]
    return all


def needed(case, j, sign):
    """What the bounds before it take of bound j, n for u, on one side: Theorem 2, from states beyond by the tolerance."""
    most, opposite = 0.0, case["below" if sign < 0 else "above"]
    for i in range(j):
        if math.isinf(opposite[i]):
            continue
        e = product_of_rates(case["rates"][i : j - 1])
        beyond = math.prod(case["rates"][i:j]) * tolerance(case, i) if j < case["n"] else 0.0
        most = max(most, beyond + sum(e[k] * (abs(opposite[j - k]) + tolerance(case, j - k)) for k in range(1, j - i)))
    return most


def draw(generator, enough):
    uniform = generator.uniform
    n, h = generator.randint(1, 4), Fraction(generator.choice(["0.001", "0.01", "0.1"]))
    poles = sorted((-uniform(0.01, 0.9) / float(h) for _ in range(n)), reverse=True)
    case = {
        "n": n, "h": h, "samples": n + generator.randint(3, 40), "poles": poles, "weight": generator.randint(0, 2),
        "g": Fraction(generator.choice([1, 2, -3, 0.25])), "f": Fraction(generator.choice([0, 0, 0.5, -2])), "delay": Fraction(generator.choice([0, 0, 1, 2, 0.5, 1.25])),
        "rates": [(1 - math.exp(p * float(h))) / float(h) for p in poles],
        "above": [0.0] * n, "below": [0.0] * n,
    }
    case["samples"] += math.ceil(case["delay"])
    middle = uniform(-2, 2)
    case["below"][0], case["above"][0] = middle + uniform(0.2, 2), middle - uniform(0.2, 2)
    for j in range(1, n):
        case["above"][j], case["below"][j] = (sign * (needed(case, j, sign) + uniform(0.01, 1)) for sign in (-1, 1))
    share = 1.001 if enough else uniform(0.2, 0.8)
    low, high = (sign * (needed(case, n, sign) * share + (0.1 + abs(float(case["f"])) if enough or n < 2 else 0)) for sign in (-1, 1))
    ends = sorted(((low - float(case["f"])) / float(case["g"]), (high - float(case["f"])) / float(case["g"])))
    case["u_min"], case["u_max"] = ends
    return case


def controller(generator, case):
    """A nominal controller: full force, noise, bang-bang, or random numbers of any size."""
    kind, size = generator.randrange(4), max(abs(case["u_min"]), abs(case["u_max"]), 1.0)
    size = size if math.isfinite(size) else 10.0
    sign = generator.choice([-1, 1])
    if kind == 0:
        return lambda k: sign * 1e3 * size
    if kind == 1:
        return lambda k: generator.uniform(-1, 1) * size
    if kind == 2:
        return lambda k: sign * size * (1 if (k // 7) % 2 else -1)
    return lambda k: generator.uniform(-1, 1) * size * 10 ** generator.uniform(-3, 3)


def tolerance(case, i):
    sizes = [abs(b) for b in (case["below"][i], case["above"][i]) if math.isfinite(b)]
    return max(sizes, default=1.0) * 2.0**-30


def excess(case, ways):
    """The greatest distance beyond a bound, in parts of its tolerance."""
    worst = -math.inf
    for x in ways:
        for i, value in enumerate(x):
            ends = [value - Fraction(b) for b in [case["below"][i]] if math.isfinite(b)] + [Fraction(b) - value for b in [case["above"][i]] if math.isfinite(b)]
            beyond = max(map(float, ends), default=-math.inf)
            worst = max(worst, beyond / tolerance(case, i))
    return worst


def verdict(command, case):
    text = subprocess.run([command, "check", *flags(case)], capture_output=True, text=True).stdout
    return next(line for line in text.splitlines() if line.startswith("loop ")).split()[1].rstrip(":")


def runs(command, arguments):
    generator = random.Random(arguments.seed)
    counts = dict(samples=0, changed=0, worst=-math.inf, wrong=0, undecided=0, gave_way=0, silent=0, late=-math.inf)
    with tempfile.TemporaryDirectory() as name:
        for number in range(arguments.designs):
            case = draw(generator, enough=arguments.part != "starved")
            if arguments.part == "return":
                case["u_min"], case["u_max"] = -math.inf, math.inf
                one, side = generator.randrange(case["n"]), generator.choice(["above", "below"])
                for i in range(case["n"]):
                    for key, open_end in (("above", -math.inf), ("below", math.inf)):
                        if (i, key) != (one, side):
                            case[key][i] = open_end
            case_verdict = verdict(command, case)
            if arguments.part != "starved":
                assert case_verdict == "sound", (case, case_verdict)
            else:
                counts["undecided"] += case_verdict == "undecided"
            step = emitted(command, pathlib.Path(name), case)
            plant, nominal = Chain(case), controller(generator, case)
            if arguments.part == "return":
                plant.x = [Fraction(generator.uniform(-3, 3)) for _ in plant.x]
            else:
                plant.x[0] = Fraction((case["below"][0] + case["above"][0]) / 2)
            settled, statuses = None, []
            for k in range(case["samples"] + 160):
                wanted = nominal(k)
                status, u = step(k, plant.x, wanted)
                statuses.append(status)
                assert status in (OK, SATURATED, INFEASIBLE), status
                if status == OK and u != wanted:
                    counts["wrong"] += 1
                if status == SATURATED and u == wanted:
                    counts["wrong"] += 1
                ways = plant.step(Fraction(u))
                beyond = excess(case, ways)
                counts["samples"] += 1
                counts["changed"] += u != wanted
                if arguments.part == "return":
                    if k >= case["samples"]:
                        counts["late"] = max(counts["late"], beyond)
                    continue
                if settled is None and status != INFEASIBLE:
                    settled = k
                if arguments.part == "kept" and settled is not None:
                    counts["wrong"] += status == INFEASIBLE
                    # What is under way at the first safe sample is decided.
                    if k >= settled + plant.inputs:
                        counts["worst"] = max(counts["worst"], beyond)
                if arguments.part == "starved":
                    if beyond > 1:
                        counts["gave_way"] += 1
                        counts["silent"] += INFEASIBLE not in statuses[-1 - plant.inputs :]
    print(arguments.part, counts)
    return counts["wrong"] > 0 or counts["silent"] > 0 or max(counts["worst"], counts["late"]) > 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("part", choices=["kept", "return", "starved"])
    parser.add_argument("--designs", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    return int(runs(str(pathlib.Path(arguments.command).resolve()), arguments))


if __name__ == "__main__":
    sys.exit(main())
