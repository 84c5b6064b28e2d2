"""Designs for the check `loop`, just inside and just outside of what it asks.

The loop is run here sample by sample, its worst case is the sum over all causes of what each does by
itself, and where a gain or the times of the samples are uncertain, the worst run that was found.
"""

import json
import random
import subprocess
from math import ceil, factorial

import numpy as np

from checks import gains_at
from draw import decimal, draw_mapping, draw_poles, pole_text
from loop import Loop
from mapping import FAMILIES, exp

ROOMS = [0.2, 1e-6, -1e-6, -0.01]
REAL = np.longdouble


def moved(plant, h):
    """Phi and Gamma of x' = A x + B u over a time h, by Taylor's series and squaring."""
    A, B = plant
    n = len(B)
    Z = np.zeros((n + 1, n + 1), REAL)
    Z[:n, :n], Z[:n, n] = A, B
    halvings = max(0, int(ceil(np.log2(float(np.abs(Z[:n, :n]).sum()) * abs(h) + 1e-300))) + 2)
    Z *= REAL(h) / 2**halvings
    whole = term = np.eye(n + 1, dtype=REAL)
    for k in range(1, 30):
        term = term @ Z / k
        whole = whole + term
    for _ in range(halvings):
        whole = whole @ whole
    return whole[:n, :n], whole[:n, n]


def chain(n):
    return np.eye(n, k=1), np.eye(n)[n - 1]


def draw_plant(source, n, h):
    """A controllable plant whose modes move by up to a radian or so in a sample."""
    pace = source.uniform(0.05, 1.0) / h
    units = [pace**i for i in range(n)]
    entry = lambda i, j: 1.0 if j == i + 1 else source.uniform(-1, 1) if i == n - 1 or source.random() < 0.3 else 0.0
    A = [[float(f"{entry(i, j) * pace * units[i] / units[j]:.6g}") for j in range(n)] for i in range(n)]
    B = [float(f"{(source.uniform(0.5, 2) if i == n - 1 else source.choice([0, 0, 0.2])) * pace * units[i]:.6g}") for i in range(n)]
    return np.array(A), np.array(B)


def rows_of(exponents):
    """The rows of the law with these exponents, by Newton's divided differences of (t - p_1) ... (t - p_n)."""
    n = len(exponents)
    column = [np.prod([t - p for p in exponents]) for t in range(n)]
    rows = []
    for j in range(1, n + 1):
        rows.append((-1) ** (n + j) * REAL(column[0].real))
        column = [(after - before) / j for before, after in zip(column, column[1:])]
    return rows


def size_between(row, h):
    """Integral over a sample of |sum_i row_i r^(n-i)/(n-i)!|, r the time left."""
    n = len(row)
    polynomial = np.array([float(row[i]) / factorial(n - 1 - i) for i in range(n)])
    roots = [r.real for r in np.roots(polynomial)] if np.any(polynomial[:-1]) else []
    ends = sorted([0.0, h] + [r for r in roots if 0 < r < h])
    whole = np.polyint(polynomial)
    return sum(abs(np.polyval(whole, b) - np.polyval(whole, a)) for a, b in zip(ends, ends[1:]))


class Design:
    """A sampled loop with its bounds, and its lines in a design file."""

    def __init__(self, source, linear):
        self.linear = linear
        self.samples_clock = linear or source.random() < 0.25
        n = self.n = source.randint(1, 3 if linear else 4)
        made = exp(decimal(source, 0.3, 2.5)) if self.samples_clock else draw_mapping(source, source.choice(FAMILIES))
        poles = draw_poles(source, n, made.rho)
        N = self.N = source.choice([10, 25, 60, 150]) + source.randint(0, 9) + n
        period = source.choice(["0.001", "0.004", "0.02", "0.05"])
        h = self.h = float(period)
        tau = f"{N * int(period[2:])}e-{len(period) - 2}"
        self.tau = float(tau)
        self.plant = draw_plant(source, n, h) if self.linear else chain(n)
        # In samples the hold is of whole periods; 0 ends in deadbeat.
        self.held = source.choice([0, source.randint(n, N // 2)]) if self.samples_clock else 0
        self.eps = f"{self.held * int(period[2:])}e-{len(period) - 2}" if self.samples_clock else \
            f"{self.tau * source.uniform(0.03, 0.4):.4g}"
        self.delay = 0 if self.samples_clock else source.choice([0, 0, 0, 1, 2])
        each = lambda low, high: [f"{10 ** source.uniform(low, high):.3g}" for _ in range(n)]
        x0 = each(-2, 1)
        self.x0 = [float(x) for x in x0]
        noise = each(-6, -3) if self.linear or source.random() < 0.6 else ["0"] * n
        steps = each(-6, -3) if source.random() < 0.4 else ["0"] * n
        self.noise = [float(v) + float(q) / 2 for v, q in zip(noise, steps)]
        u_step = f"{10 ** source.uniform(-4, -1):.3g}" if source.random() < 0.4 else "0"
        self.u_step = float(u_step) / 2
        self.force = None if self.linear else source.choice([None, None, "constant", "any"])
        self.f = sorted([round(source.uniform(-1, 1), 3), round(source.uniform(-1, 1), 3)])
        self.gain = sorted([round(source.uniform(0.8, 1), 3), round(source.uniform(1, 1.25), 3)]) if source.random() < 0.35 else None
        self.jitter = f"{h * source.uniform(0.001, 0.1):.3g}" if source.random() < 0.25 else None
        loop = Loop(n, made, poles)
        self.rows = self._in_samples(poles, float(made.spellings[0].split("a=")[1].split(")")[0])) if self.samples_clock else \
            gains_at(loop, self.tau, [max(1 - k / N, float(self.eps) / self.tau) for k in range(N + 1)])
        self.lines = [f"n = {n}", made.spellings[0], f"poles = [{', '.join(pole_text(*p) for p in poles)}]",
                      f"sample_time = {period}", f"x0_max = [{', '.join(x0)}]", f"noise = [{', '.join(noise)}]",
                      f"sensor_step = [{', '.join(steps)}]", f"u_step = {u_step}"]
        self.lines += [f"eps = {self.eps}"] + (['clock = "samples"'] if self.samples_clock else [])
        self.lines += [f"delay = {self.delay}"] if self.delay else []
        self.lines += [f"g_error = {self.gain}"] if self.gain else []
        self.lines += [f"jitter = {self.jitter}"] if self.jitter else []
        self.tables = ["[params]", f"tau = {tau}", "u_max = inf"]
        if self.linear:
            A, B = (of.tolist() for of in self.plant)
            self.tables += ["[plant]", f"A = {A}", f"B = {B}"]
        if self.force:
            self.tables += ["[plant]", 'f = "push"', f"push = {self.f}"]
            self.tables += ["[disturbance]", 'push = "any"'] if self.force == "any" else []

    def _in_samples(self, poles, a):
        """u over x at samples 0..N of the law in falling powers, and of that of least energy at the end."""
        n, h, N = self.n, REAL(self.h), self.N
        phi, gamma = moved(self.plant, h)
        D = (phi - np.eye(n)) / h
        # c D^i Gamma = 0 but for i = n - 1, where it is h.
        powers = [np.eye(n, dtype=REAL)]
        for _ in range(n):
            powers.append(powers[-1] @ D)
        columns = np.array([power @ gamma for power in powers[:n]])
        scales = np.abs(columns).max(axis=0)
        wanted, c = np.array([0] * (n - 1) + [h], REAL), np.zeros(n, REAL)
        for _ in range(4):
            left = wanted - columns @ c
            c = c + np.linalg.solve((columns / scales).astype(float), left.astype(float)) / scales
        S = np.array([c @ power for power in powers[:n]])
        drift = c @ powers[n]
        exponents = sorted((complex(-float(re) / a, float(im) / a) for re, im in poles), key=lambda p: p.real)
        first = exponents[0].real
        own = first >= n and abs(first - round(first)) < 1e-12 and all(
            abs(p - (first + i)) < 1e-12 for i, p in enumerate(exponents))
        last = 0 if own else max(2 * n, ceil(exponents[-1].real - 1e-12) + n - 1)
        soft = max(n, ceil(first - 1e-12))
        law, shift = rows_of(exponents), round(first) - 1 if own else 0
        end = rows_of([soft + i for i in range(n)])
        rows = []
        for k in range(N + 1):
            M = max(N - k, self.held)
            row, now = (end, max(M, n) + soft - 1) if M <= last else (law, (max(M, n) if own else M) + shift)
            over_z = [row[j] / np.prod([REAL(now - i) * h for i in range(j, n)]) for j in range(n)]
            rows.append(np.array(over_z) @ S - drift)
        return np.array(rows)

    def worst(self, gain, at):
        """The greatest |x_i| at sample `at`: the sum over all causes, and the signals that attain it."""
        n, d, h = self.n, self.delay, self.h
        phi, one = moved(self.plant, h)
        gamma = one * REAL(gain)
        out = []
        for i in range(n):
            p = np.zeros(n + d, REAL)
            p[i] = 1
            causes, constant, varying = REAL(0), REAL(0), 0.0
            for k in reversed(range(at)):
                row = self.rows[min(k, self.N)].astype(REAL)
                # What an input of 1 at this sample is seen as, and where the actuator's error enters.
                acts = p[:n] @ gamma
                of_u = acts if d == 0 else p[n + d - 1]
                of_noise = abs(of_u * row) @ np.array(self.noise, REAL)
                causes += of_noise + abs(of_u) * self.u_step
                constant += p[:n] @ one
                if self.force == "any":
                    varying += size_between(p[:n], h)
                before = np.zeros(n + d, REAL)
                before[:n] = p[:n] @ phi + of_u * row
                if d:
                    before[n] += acts
                    before[n + 1 :] += p[n : n + d - 1]
                p = before
            total = causes + abs(p[:n]) @ np.array(self.x0, REAL)
            if self.force:
                middle, half = sum(self.f) / 2, (self.f[1] - self.f[0]) / 2
                total += abs(middle) * abs(constant)
                total += half * (abs(constant) if self.force == "constant" else varying)
            out.append(float(total))
        return np.array(out)

    def run(self, source, gain, x0, until):
        """|x| at the deadline, the most until there and from there on, with every error at one of its ends."""
        n, d, J = self.n, self.delay, float(self.jitter or 0)
        late = [0.0] * d
        x, now, acting = np.array(x0, float), 0.0, 0.0
        sign = lambda: source.choice([-1, 1])
        f = source.choice(self.f) if self.force else 0.0
        side, turns = sign(), source.randint(1, 6)
        final, way, most, u_most = None, abs(x), np.zeros(n), 0.0

        def go(x, span):
            phi, gamma = moved(self.plant, span)
            return (phi @ x + gamma * (gain * acting + f)).astype(float)

        for k in range(until):
            if k and source.random() < 1 / turns:
                side = -side
            if self.force == "any" and source.random() < 0.2:
                f = source.choice(self.f)
            if k == self.N:
                # The deadline is in time.
                at_end = go(x, k * self.h - now)
                final, most = abs(at_end), np.maximum(most, abs(at_end))
            t = k * self.h + (J * side if k else 0)
            for part in (0.25, 0.5, 0.75):
                at, seen = now + part * (t - now), abs(go(x, part * (t - now)))
                if at <= self.N * self.h:
                    way = np.maximum(way, seen)
                else:
                    most = np.maximum(most, seen)
            x, now = go(x, t - now), t
            if t <= self.N * self.h:
                way = np.maximum(way, abs(x))
            if k > self.N:
                most = np.maximum(most, abs(x))
            y = x + np.array([sign() * v for v in self.noise])
            u = float(self.rows[min(k, self.N)] @ y)
            if k >= self.N:
                u_most = max(u_most, abs(u))
            late.append(u + sign() * self.u_step)
            acting = late.pop(0)
        return final, way, most, u_most


def verified(command, design, path, truth, later, source, seconds):
    """What `verify` says of |x| from the deadline on, and why that is false, if it is.

    `truth` and `later` are the largest |x_i| at the deadline and from there on that are known to be reached.
    """
    # A loop that diverges after the deadline has no bound there that could be written down.
    beyond = source.random() < 0.5 and bool(np.all(later < 1e30))
    reached = np.maximum(truth, later) if beyond else truth
    most, size = float(np.max(reached)), float(np.linalg.norm(reached))
    wide = source.random() < 0.5
    error = size * 1.02 if wide else most * 0.98
    lines = ["[verify]", f"until = {-0.3 if beyond else 0}", "scenarios = 20", "search = 20"]
    lines += [f"x{i + 1} = [{-x!r}, {x!r}]" for i, x in enumerate(design.x0)]
    lines += ["[[objective]]", 'bound = "attractive"', f"error = {error!r}"]
    path.write_text("\n".join(design.lines + design.tables + lines) + "\n")
    try:
        done = subprocess.run([command, "verify", str(path)], capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return "late", None
    said = next((line for line in done.stdout.splitlines() if line.startswith("objective 1")), "")
    word = next((word for word in ("holds, proved", "holds, by sampling", "fails", "undecided") if word in said), None)
    side = "above" if wide else "below"
    if word is None:
        return "no answer", (done.stdout + done.stderr)[:1500]
    # What is reached later is known from below alone.
    if word == "fails" and wide and not beyond and not design.gain and not design.jitter:
        return f"{word}, {side}", f"fails, and |x| reaches {size} of {error}"
    if word == "holds, proved" and not wide:
        return f"{word}, {side}", f"proved, and |x| reaches {most} of {error}"
    return f"{word}, {side}", None


def trial(job):
    """One design, checked: whether its verdict is false, and how close its bound is."""
    command, folder, seed, index, linear, scale, seconds = job
    name = f"linear{index}" if linear else f"sampled{index}"
    source = random.Random(f"{seed}-{name}")
    design = Design(source, linear)
    uncertain = design.gain or design.jitter
    gains = np.linspace(*design.gain, 9) if design.gain else [1.0]
    truth = np.max([design.worst(gain, design.N) for gain in gains], axis=0)
    result = {"name": name, "false": False, "verdict": "not drawn", "near": None}
    # A loop that diverges says little.
    if not np.all((truth > 1e-100) & (truth < 1e30)):
        return result
    runs = []
    # What is drawn of a known loop leaves its errors as they are.
    drawn = source if uncertain else random.Random(f"{seed}-{name}-runs")
    for _ in range(30 if uncertain else 4):
        gain = drawn.choice(list(design.gain)) if design.gain else 1.0
        runs.append(design.run(drawn, gain, [x * drawn.choice([-1, 1]) for x in design.x0], design.N + 40))
    if uncertain:
        truth = np.max([truth] + [final for final, *_ in runs], axis=0)
    ends = [gains[0], gains[-1]] if design.gain else [1.0]
    later = np.max([design.worst(gain, design.N + j) for gain in ends for j in (0, 1, 3, 10, 40)], axis=0)
    later = np.max([later] + [most for _, _, most, _ in runs], axis=0)
    truth = truth * scale
    room = source.choice(ROOMS)
    if uncertain and room == 1e-6:
        room = 0.5
    errors = truth * (1 + (room if room > 0 else source.uniform(0, 1)))
    if room < 0:
        # One state is above its bound.
        state = source.randrange(design.n)
        errors[state] = truth[state] * (1 + room)
    text = "\n".join(design.lines + [f"error = [{', '.join(f'{e:.12g}' for e in errors)}]"] + design.tables) + "\n"
    path = folder / f"{name}.toml"
    path.write_text(text)
    try:
        done = subprocess.run([command, "check", str(path), "--format", "json"], capture_output=True, text=True, timeout=seconds)
        entry = next(c for c in json.loads(done.stdout)["checks"] if c["name"] == "loop")
    except subprocess.TimeoutExpired:
        return result | {"verdict": "late"}
    except (ValueError, StopIteration):
        return result | {"verdict": "no answer", "false": True, "printed": (done.stdout + done.stderr)[:1500]}
    word, why = entry["verdict"], []
    holds = room > 0
    if word == "sound" and not holds or word in ("refuted", "unsound") and holds and not uncertain:
        why.append(f"{word} with a room of {room}")
    if "worst" in entry:
        worst = entry["worst"]
        rest = np.array(worst["from_rounding"]) + np.array(worst["from_g"]) + np.array(worst["from_jitter"])
        bound = np.array(worst["final"]) + rest
        if np.any(bound * (1 + 1e-9) < truth):
            why.append(f"|x| reaches {truth}, beyond the bound {bound}")
        if not uncertain and np.any(abs(np.array(worst["final"]) - truth) > 1e-9 * truth + 1.01 * rest):
            why.append(f"the sums are {worst['final']}, the truth {truth}")
        way = np.max([way for _, way, *_ in runs], axis=0)
        if worst.get("between") and np.any(np.array(worst["x"]) * (1 + 1e-9) < way):
            why.append(f"on the way |x| reaches {way}, beyond {worst['x']}")
        after = worst.get("after")
        if after and np.any(np.array(after["x"]) * (1 + 1e-9) < later):
            why.append(f"after the deadline |x| reaches {later}, beyond {after['x']}")
        if after and any(u > after["u"] * (1 + 1e-9) for *_, u in runs):
            why.append(f"after the deadline |u| leaves {after['u']}")
        result["near"] = float(np.max(bound / truth))
        result["between"] = worst.get("between")
        result["held"] = float(np.max(np.array(after["x"]) / later)) if after else None
    result["verify"], wrong = verified(command, design, path, truth, later * scale, source, seconds)
    if wrong:
        why.append(f"verify: {wrong}")
    kind = ("linear " if linear else "") + ("uncertain" if uncertain else "known")
    return result | {"verdict": f"{word}, {kind}, {'true' if holds else 'false'}", "false": bool(why), "why": why}
