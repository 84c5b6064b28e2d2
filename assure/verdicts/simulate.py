"""Runs of `simulate` against exact solutions, and against SciPy's integration with events.

`modes`: the free loop, by its modes in 60 digits; `constant`: a u that is clipped throughout, a
polynomial; `clipped`: clipped in part; `friction`: dry friction, which sticks (Filippov).
"""

import random
import subprocess
from math import factorial

import mpmath
import numpy as np
from scipy.integrate import solve_ivp

from draw import draw_mapping, draw_poles, pole_text
from loop import Loop
from mapping import FAMILIES

# Exact in binary, so that both sides speak of the same instants.
EXACT = [1, 3, 7, 14, 29]
EARLY = [1, 3, 7, 10]
# Where mu' falls like a power of stretched time, x is below what SciPy resolves from there on.
EARLIER = [1, 2, 3, 5]
# States below it are beyond what a double keeps through 2^-29 of a rational mapping.
TINY = 1e-60
# What is left of a state in stretched time that has died out, by the integration: x and u are that
# times rows that grow like a power of 1/T.
LEFT = mpmath.mpf("1e-200")
TOLERANCE = {"modes": 1e-7, "constant": 1e-9, "clipped": 1e-6, "friction": 1e-6}


class Case:
    """A design, the flags of a run, and the states and inputs that are true at its instants."""


def law(loop, tau):
    """u of x at time-to-go w tau, by the loop's own rows."""
    n = loop.n
    scale = tau ** np.arange(n)

    def u(sigma, x):
        _, _, rows = loop.outputs(np.array([np.exp(-np.longdouble(sigma))]))
        rows, z = rows[0], np.asarray(x, dtype=np.longdouble) * scale
        xi = np.zeros(n, dtype=np.longdouble)
        for i in range(n):
            xi[i] = (z[i] - rows[i, :i] @ xi[:i]) / rows[i, i]
        return float(rows[n] @ xi) / tau**n

    return u


def draw(source):
    case = Case()
    case.kind = source.choice(["modes", "constant", "clipped", "friction"])
    family = source.choice(FAMILIES)
    made = draw_mapping(source, family)
    case.n = 2 if case.kind == "friction" else source.randint(1, 6 if case.kind == "modes" else 4)
    poles = draw_poles(source, case.n, made.rho)
    loop, tau = Loop(case.n, made, poles), round(source.uniform(0.3, 2), 2)
    case.family = family
    x0 = [round(source.uniform(-1, 1), 2) or 0.5 for _ in range(case.n)]
    f, u_max, halvings = "0", None, EARLY if made.rho else EARLIER
    if case.kind == "modes":
        case.truth, halvings = by_modes(loop, tau, x0), EXACT
    elif case.kind == "constant":
        x0 = [source.choice([1.0, -1.0])] + [0.0] * (case.n - 1)
        u_max = 0.3 * factorial(case.n) / tau**case.n * source.uniform(0.1, 1)
        u_max, halvings = float(f"{u_max:.3g}"), EXACT
        case.truth = constantly_clipped(loop, tau, x0, u_max)
        if case.truth is None:
            return None
    else:
        b, c, d = 0.0, 0.0, 0.0
        u = law(loop, tau)
        if case.kind == "friction":
            b, c, d = (round(source.uniform(0.1, 1), 2) for _ in range(3))
            f = f"-{b}*x2 - {c}*sign(x2) + {d}"
            u_max = source.choice([None, None, round(2 * abs(u(0, x0)) + c + d, 2)])
        else:
            u_max = float(f"{abs(u(0, x0)) * source.uniform(0.3, 0.9):.3g}")
            f = source.choice(["0", "0.1*x1", "-0.3*x1"])
        case.truth = integrated(loop, tau, x0, u_max, f, (b, c, d), halvings)
        if case.truth is None:
            return None
    lines = ['name = "stage"', f"n = {case.n}", source.choice(made.spellings),
             f"poles = [{', '.join(pole_text(*p) for p in poles)}]", f"tau = {tau}"]
    lines += ([f"u_max = {u_max}"] if u_max else []) + ["[plant]", f'f = "{f}"']
    case.text = "\n".join(lines) + "\n"
    at = ",".join(mpmath.nstr(1 - mpmath.mpf(2) ** -k, 40) for k in halvings)
    case.words = [f"--x0={','.join(map(str, x0))}", f"--at={at}"]
    return case


def by_modes(loop, tau, x0):
    w = np.array([mpmath.mpf(2) ** -k for k in EXACT], dtype=object)
    rows, grown = loop.free(w), loop.outputs(w)[2]
    n, tau = loop.n, mpmath.mpf(str(tau))
    out = []
    for row, left in zip(rows, grown):
        values = []
        for i in range(n + 1):
            terms = [row[i, j] * tau ** (j - (i if i < n else n)) * mpmath.mpf(str(x0[j])) for j in range(n)]
            size = sum(abs(term) for term in terms)
            noise = LEFT * sum(abs(left[i, j]) for j in range(n)) * tau ** (-(i if i < n else n))
            values.append((float(sum(terms)), float(size + noise / mpmath.mpf(TOLERANCE["modes"]))))
        out.append(values)
    return out


def constantly_clipped(loop, tau, x0, u_max):
    """x of the chain under a constant u, where the law is clipped to it throughout; else None."""
    n, u = loop.n, law(loop, tau)
    value = -np.sign(x0[0]) * u_max

    def state(t):
        return [
            sum(x0[i + k] * t**k / factorial(k) for k in range(n - i)) + value * t ** (n - i) / factorial(n - i)
            for i in range(n)
        ]

    for sigma in np.linspace(0, 22, 400):
        wanted = u(sigma, state(tau * -np.expm1(-sigma)))
        if wanted * value <= 1.01 * u_max**2:
            return None
    out = []
    for k in EXACT:
        x = state(tau * (1 - 2.0**-k))
        out.append([(v, max(1, abs(v))) for v in x] + [(value, u_max)])
    return out


def integrated(loop, tau, x0, u_max, f, friction, halvings):
    """States and inputs at the instants, by an integration in -ln(T/tau) from event to event."""
    n, u = loop.n, law(loop, tau)
    # Where mu' falls like a power of stretched time the loop is stiff in -ln w.
    method = "LSODA" if loop.mapping.rho == 0 else "DOP853"
    # There u = k x grows faster than 1/T^n, and so does what the tolerance leaves of x in it.
    absolute = 1e-20 if loop.mapping.rho == 0 else 1e-13
    b, c, d = friction
    limit = u_max or np.inf
    stiffness = {"0.1*x1": 0.1, "-0.3*x1": -0.3}.get(f, 0.0)
    clip = lambda sigma, x: min(max(u(sigma, x), -limit), limit)
    drive = lambda sigma, x: clip(sigma, x) + d + stiffness * x[0]

    def slope(side):
        def of(sigma, x):
            time = tau * np.exp(-sigma)
            last = 0.0 if side == 0 else drive(sigma, x) - b * x[-1] - c * side
            rest = list(x[1:])
            if side == 0:
                rest[-1] = 0.0
            return [time * v for v in rest] + [time * last]
        return of

    def event(function, direction=0):
        function.terminal, function.direction = True, direction
        return function

    def enter(sigma, x):
        """The side on which the motion goes on from x2 = 0: 0 where it sticks."""
        force = drive(sigma, x)
        return 0 if abs(force) <= c else np.sign(force)

    ends, sigma, x = [k * np.log(2) for k in halvings], 0.0, list(x0)
    side = 1.0 if c == 0 else (np.sign(x[-1]) or enter(0.0, x))
    out, biggest, switches = [], np.abs(x0), 0
    for end in ends:
        while sigma < end:
            events = [event(lambda s, x: limit - abs(u(s, x)))] if u_max else []
            if c and side:
                events.append(event(lambda s, x: x[-1], -side))
            if c and not side:
                events.append(event(lambda s, x: abs(drive(s, x)) - c, 1))
            run = solve_ivp(slope(side), (sigma, end), x, method=method, rtol=1e-11, atol=absolute, events=events or None)
            if not run.success or switches > 200:
                return None
            biggest = np.maximum(biggest, np.abs(run.y).max(axis=1))
            sigma, x = run.t[-1], list(run.y[:, -1])
            if run.status == 1 and sigma < end:
                switches += 1
                hit = [len(t) > 0 for t in run.t_events]
                if c and hit[-1]:
                    x[-1] = 0.0 if n > 1 else x[-1]
                    side = enter(sigma, x) if side else np.sign(drive(sigma, x))
                if u_max and hit[0]:
                    # Over the corner of the clipping, which the next piece would find again.
                    h = 1e-9
                    x = list(np.array(x) + h * np.array(slope(side)(sigma, x)))
                    sigma += h
        value = clip(sigma, x)
        out.append([(v, m) for v, m in zip(x, biggest)] + [(value, max(1.0, abs(value)))])
    return out


def trial(job):
    """One run: its kind, the greatest error as a part of what is allowed, and whether it ended."""
    command, folder, seed, name, scale, seconds = job
    source = random.Random(f"{seed}-{name}")
    case = None
    while case is None:
        case = draw(source)
    path = folder / f"{name}.toml"
    path.write_text(case.text)
    try:
        done = subprocess.run([command, "simulate", path.name] + case.words, cwd=folder,
                              capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return {"name": name, "kind": case.kind, "end": "late", "error": None, "design": case.text}
    result = {"name": name, "kind": case.kind, "family": case.family, "n": case.n, "code": done.returncode,
              "design": case.text, "words": case.words, "printed": (done.stdout + done.stderr)[:1500]}
    if done.returncode != 0:
        return result | {"end": "refused", "error": None}
    rows = list(csv(done.stdout))
    worst, whole = 0.0, len(rows) == len(case.truth)
    for row, truth in zip(rows, case.truth):
        for value, (exact, size) in zip(row, truth):
            error = abs(value - exact * scale) / max(size, TINY) / TOLERANCE[case.kind]
            # JSON has no infinity, and no number is as far off as any.
            worst = max(worst, float(error) if error < 1e300 else 1e300)
    return result | {"end": "whole" if whole else "short", "error": worst}


def csv(text):
    """x_1..x_n, u of each line, by the names of the head."""
    lines = text.splitlines()
    head = lines[0].split(",")
    kept = [i for i, name in enumerate(head) if name == "u" or name[0] == "x" and name[1:].isdigit()]
    for line in lines[1:]:
        cells = line.split(",")
        yield [float(cells[i]) for i in kept]
