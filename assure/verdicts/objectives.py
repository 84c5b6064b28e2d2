"""Objectives just above and just below what a loop attains, as lines of a design file."""

import numpy as np

import supremum as sup
from supremum import corners, gain_at, norm_at, supremum


class Drawn:
    """An objective: its lines, whether it holds, its room as a part of `size`, the supremum."""

    def __init__(self, lines, room, kind, size):
        self.lines, self.room, self.kind, self.size = lines, room, kind, size
        self.holds = room > 0


def text(value):
    return f"{float(value):.12g}"


# Below it a bound says nothing that an engineer asks, and doubles have no digits.
TINY = 1e-60


def objective(random, setting, room):
    """One objective whose bound is 1 + room times what is attained."""
    kinds = ["input", "attractive", "linear", "composed", "composed"]
    if setting.force is None:
        kinds += ["state"]
    draw = {"state": state, "input": input_, "attractive": attractive, "linear": linear, "composed": composed}
    while True:
        found = draw[random.choice(kinds)](random, setting, room)
        if found.size > TINY:
            return found


ZETAS = [
    (None, lambda s: 1.0),
    ("sqrt(T/tau)", lambda w: w**0.5),
    ("T/tau", lambda w: w),
    ("1 - dt/tau", lambda w: w),
    ("(1 - dt/tau)^(1/2)", lambda w: w**0.5),
    ("exp(-dt/tau)", lambda w: np.exp(-(1 - w))),
]


def state(random, setting, room):
    zeta, shape = random.choice(ZETAS)
    value, _ = supremum(
        setting, lambda s, tau, rows: gain_at(setting, s, tau, rows) / shape(np.exp(-s)))
    if value <= 1.02:
        # At t0 the ratio is 1: a smaller sigma is bad input, a larger one says nothing of the loop.
        room = abs(room)
    lines = ['bound = "state"', f"sigma = {text(value * (1 + room))}"]
    return Drawn(lines + ([f'zeta = "{zeta}"'] if zeta else []), room, "state", value)


def input_(random, setting, room):
    shape_text, shape = random.choice(
        [("", lambda w: 1.0), ("*(1 + T/tau)", lambda w: 1 + w), ("*exp(-dt/tau)", lambda w: np.exp(w - 1))])
    value = greatest_input(setting, shape)
    return Drawn(['bound = "input"', f'upsilon = "{text(value * (1 + room))}{shape_text}"'], room, "input", value)


def greatest_input(setting, shape):
    """The greatest |u|/shape(T/tau)."""
    u = [0] * setting.loop.n + [1]
    worst = lambda s, tau, rows: max(
        setting.linear(u, s, tau, rows)[0], setting.linear(negated(u), s, tau, rows)[0])
    return supremum(setting, lambda s, tau, rows: worst(s, tau, rows) / shape(np.exp(-s)))[0]


def attractive(random, setting, room):
    best = norm_at_end(random, setting)
    return Drawn(['bound = "attractive"', f"error = {text(best * sup.SCALE * (1 + room))}"], room, "attractive", best)


def norm_at_end(random, setting):
    """The greatest |x| at the end of a run."""
    end = np.array([setting.end])
    rows = setting.free(end)[0]
    best = 0
    taus = setting.taus()
    if len(taus) > 1:
        taus = np.exp(np.linspace(np.log(taus[0]), np.log(taus[-1]), 200))
    vertices = corners(setting)
    for tau in taus:
        if setting.force is None:
            value = norm_at(setting, end[0], tau, rows, vertices)
        else:
            value = forced_norm(random, setting, end[0], tau, rows)
        best = max(best, value)
    return best


def forced_norm(random, setting, sigma, tau, rows):
    """The greatest |x|: over directions, each by its own worst state and force."""
    n = setting.loop.n
    best = 0
    for start in range(2 * n + 4):
        c = np.zeros(n + 1)
        if start < 2 * n:
            c[start // 2] = 1 - 2 * (start % 2)
        else:
            c[:n] = [random.gauss(0, 1) for _ in range(n)]
            c /= np.linalg.norm(c)
        previous = -1
        for _ in range(50):
            value, x = setting.state(list(c), sigma, tau, rows)
            if value <= previous * (1 + 1e-12):
                break
            previous = value
            c = np.append(x / np.sqrt((x * x).sum()), 0)
        best = max(best, previous)
    return best


def row(random, setting):
    """A random row over x_1..x_n, u and its text; numbers are short, so that they are exact."""
    n = setting.loop.n
    names = [f"x{i + 1}" for i in range(n)] + ["u"]
    chosen = random.sample(range(n + 1), min(n + 1, random.choice([1, 1, 2, 3])))
    c, terms = [0] * (n + 1), []
    for i in chosen:
        weight = random.choice([1, -1, 0.5, -2, 0.25, 3])
        c[i] = weight
        terms.append(f"{weight}*{names[i]}")
        if random.random() < 0.2:
            c[i] = lambda time_to_go, weight=weight: weight * time_to_go
            terms[-1] += "*T"
    return c, " + ".join(terms).replace("+ -", "- ")


def negated(c):
    return [(lambda T, a=a: -a(T)) if callable(a) else -a for a in c]


def range_of(setting, c):
    high, _ = supremum(setting, lambda s, tau, rows: setting.linear(c, s, tau, rows)[0])
    low, _ = supremum(setting, lambda s, tau, rows: setting.linear(negated(c), s, tau, rows)[0])
    return -low, high


def linear(random, setting, room):
    c, expression = row(random, setting)
    low, high = range_of(setting, c)
    size = max(abs(low), abs(high))
    if random.random() < 0.5:
        lines = [f"high = {text(high + room * size)}"]
        if random.random() < 0.3:
            lines.append(f"low = {text(low - 0.2 * size)}")
    else:
        lines = [f"low = {text(low - room * size)}"]
    return Drawn(['bound = "within"', f'h = "{expression}"'] + lines, room, "linear", size)


def composed(random, setting, room):
    """h of a row L, at the threshold c = sup L + room: fails if and only if L reaches beyond c."""
    c, expression = row(random, setting)
    low, high = range_of(setting, c)
    size = max(abs(low), abs(high))
    t = high + room * size
    L, edge = f"({expression})", text(t)
    forms = [
        (f"sign({L} - {edge})", ["high = 0.5"]),
        (f"-sign({edge} - {L})", ["high = 0.5"]),
        (f"sqrt({edge} - {L})", ["low = -1"]),
        (f"sqrt({edge} - {L})^2", ["low = -1"]),
        (f"ln({edge} - {L})", ["high = 1e6"]),
        (f"0*ln({edge} - {L})", ["high = 1"]),
        (f"min(0, sqrt({edge} - {L}))", ["low = -1"]),
        (f"abs({edge} - {L})/({edge} - {L})", ["low = 0.5"]),
        (f"1/({edge} - {L})", ["low = 0"]),
        (f"({edge} - {L})^(1/2)", ["low = -1"]),
        (f"atan({L} - {edge})", ["high = 0"]),
        (f"max({L} - {edge}, -1)", ["high = 0"]),
        (f"({L} - {edge})^3", ["high = 0"]),
        (f"exp(({L} - {edge})/{text(size)})", ["high = 1"]),
        (f"tanh(({L} - {edge})/{text(size)})", ["high = 0"]),
        (f"max({L}, x1 - 1e9)", [f"high = {edge}"]),
        (f"{L} + 0*abs(x1)", [f"high = {edge}"]),
        (f"sign({L} - {edge})*abs({L} - {edge})", ["high = 0"]),
        (f"atanh(({L} - {edge})/1e12)", ["high = 0"]),
        (f"abs({L} - {edge}) + {L} - {edge}", [f"high = {text(1e-9 * size)}"]),
    ]
    if abs(low) < abs(high):
        forms += [
            (f"abs({L})", [f"high = {edge}"]),
            (f"{L}^2", [f"high = {text(t * t)}"]),
            (f"sqrt({L}^2)", [f"high = {edge}"]),
            (f"sqrt({text(t * t)} - {L}^2)", ["low = -1"]),
            (f"max({L}, -{L})", [f"high = {edge}"]),
            (f"sqrt({edge} - abs({L}))", ["low = -1"]),
            (f"cosh({L}/{text(size)})", [f"high = {np.cosh(float(t) / float(size)):.14g}"]),
        ]
    h, bounds = random.choice(forms)
    return Drawn(['bound = "within"', f'h = "{h}"'] + bounds, room, "composed " + h.replace(L, "L").replace(edge, "c"), size)
