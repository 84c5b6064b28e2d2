"""u of the emitted C for parameters of any size, against the definition in 60 digits.

`init` may refuse a set of parameters, and `step` may find u out of range; what they let pass has to
be right.
"""

import ctypes
import os
import random
import subprocess
from fractions import Fraction

import mpmath as mp

FAMILIES = ["exp", "rational", "power", "tan", "tanh", "algebraic", "exp_sum"]
# What u may be wrong by, as a part of the sum of the sizes of its terms.
ALLOWED = {"f64": {"power": 5e-14, "exp_sum": 5e-14}, "f32": {}}
USUAL = {"f64": 1e-14, "f32": 2e-6}
DECADES = {"f64": 300, "f32": 37}
LEAST = {"f64": 2.2250738585072014e-308, "f32": 1.1754943508222875e-38}
ROUNDING = {"f64": mp.mpf(2) ** -52, "f32": mp.mpf(2) ** -23}


def derivatives(family, p, T, count):
    """r_1, r_2, ...: the derivatives of mu at the time-to-go T."""
    tau, w, orders = p["tau"], T / p["tau"], range(1, count + 1)
    if family == "exp_sum":
        return of_sum(p, w, orders)
    a = p["a"]
    sign = lambda k: (-1) ** (k - 1)
    if family == "exp":
        return [sign(k) * a**k * T for k in orders]
    if family == "rational":
        return [sign(k) * mp.factorial(k) * (a / tau) ** k * T ** (k + 1) for k in orders]
    if family == "power":
        rising = lambda k: mp.fprod(1 + i * p["m"] for i in range(1, k))
        return [sign(k) * rising(k) * a**k * tau * w ** (1 + k * p["m"]) for k in orders]
    if family == "tan":
        th = mp.pi * w / 2
        return [sign(k) * mp.factorial(k - 1) * 2 * tau / mp.pi * a**k * mp.sin(k * th) * mp.sin(th) ** k
                for k in orders]
    # y = mu/tau has y' = a (1 - y^2) or a (1 - y^2)^(3/2); y^(k) = a^k P_k(y) (1 - y^2)^(k/2 or k).
    s, v = 1 - w, w * (2 - w)
    half = family == "algebraic"
    out, poly = [], [mp.mpf(1)]
    for k in orders:
        value = sum(c * s**i for i, c in enumerate(poly))
        out.append(tau * a**k * value * (v ** (1 + mp.mpf(k) / 2) if half else v))
        poly = next_polynomial(poly, k, half)
    return out


def next_polynomial(poly, k, half):
    """P_(k+1) of P_k: v P' - (k + 2) s P for `algebraic`, and (v P)' for `tanh`, v = 1 - s^2."""
    times = lambda p, shift, by: [mp.mpf(0)] * shift + [by * c for c in p]
    slope = [i * c for i, c in enumerate(poly)][1:] or [mp.mpf(0)]
    parts = [slope, times(slope, 2, -1), times(poly, 1, -(k + 2) if half else -2)]
    length = max(map(len, parts))
    return [sum(part[i] for part in parts if i < len(part)) for i in range(length)]


def of_sum(p, w, orders):
    rates, logarithm = p["rates"], -mp.log(w)
    # ln(mean e^(-a_i y)) + ln(1/w) is convex and falls: Newton's iteration rises from the left.
    y = logarithm * len(rates) / sum(rates) * mp.mpf("0.999999")
    for _ in range(400):
        e = [mp.exp(-a * y) for a in rates]
        slope = sum(a * x for a, x in zip(rates, e))
        step = (mp.log(sum(e) / len(rates)) + logarithm) * sum(e) / slope
        y += step
        if abs(step) <= abs(y) * mp.mpf(10) ** -50:
            return [(-1) ** (k - 1) * p["tau"] / len(rates) * sum(a**k * mp.exp(-a * y) for a in rates)
                    for k in orders]
    return None


def control(family, p, gains, T, x):
    """u of Theorem 1, and the sum of the sizes of its terms."""
    n = len(x)
    r = derivatives(family, p, T, n)
    if r is None or r[0] == 0:
        return None
    bell = [[mp.mpf(0)] * (n + 1) for _ in range(n + 1)]
    bell[0][0] = mp.mpf(1)
    for i in range(1, n + 1):
        for j in range(1, i + 1):
            bell[i][j] = sum(mp.binomial(i - 1, l - 1) * r[l - 1] * bell[i - l][j - 1]
                             for l in range(1, i - j + 2))
    terms = [gains[i] * bell[i][j] * x[j] for i in range(n) for j in range(i + 1)]
    terms += [bell[n][j] * x[j] for j in range(n)]
    return -sum(terms) / r[0] ** n, sum(map(abs, terms)) / r[0] ** n


def library(command, folder, family, n, precision):
    """The emitted C as a library."""
    place = folder / f"digits_{family}{n}_{precision}_{os.getpid()}"
    place.mkdir(parents=True, exist_ok=True)
    made = place / "own.so"
    if not made.exists():
        subprocess.run([command, "emit", "--lang", "c", "--n", str(n), "--mu", family, "--precision", precision,
                        "--name", "own", "-o", str(place)], check=True, capture_output=True)
        subprocess.run(["gcc", "-O1", "-ffp-contract=off", "-shared", "-fPIC", "-o", str(made),
                        str(place / "own.c"), "-lm"], check=True)
    return ctypes.CDLL(str(made))


class Drawn:
    """Random parameters of one controller, as the emitted struct."""

    def __init__(self, source, family, n, precision):
        self.real = ctypes.c_double if precision == "f64" else ctypes.c_float
        decades = DECADES[precision]
        size = lambda: 10 ** (decades * source.random() ** 2 * source.choice([-1, 1]))
        fields = [(name, self.real) for name in ("tau", "t0", "eps", "u_max")]
        fields += [("rates", self.real * 2)] if family == "exp_sum" else [("a", self.real)]
        fields += [("m", self.real)] if family == "power" else []
        fields.append(("k", self.real * n))
        p = type("Params", (ctypes.Structure,), {"_fields_": fields})()
        a = size()
        p.tau = size()
        p.eps = p.tau * 10 ** -source.uniform(0.3, source.choice([2, 6]))
        p.t0 = source.choice([0, 0, p.tau * source.uniform(-2, 2)])
        p.u_max = float("inf")
        if family == "exp_sum":
            p.rates = (self.real * 2)(a, a * 10 ** source.uniform(-2, 2))
        else:
            p.a = a
        if family == "power":
            p.m = 10 ** source.uniform(-0.7, 0.7)
        p.k = (self.real * n)(*(self.gain(source, a, n - i, size) for i in range(n)))
        self.params = p
        exact = {"tau": mp.mpf(p.tau)}
        if family == "exp_sum":
            exact["rates"] = [mp.mpf(rate) for rate in p.rates]
        else:
            exact["a"] = mp.mpf(p.a)
        if family == "power":
            exact["m"] = mp.mpf(p.m)
        self.exact = exact

    @staticmethod
    def gain(source, a, power, size):
        if source.random() < 0.1:
            return 0.0
        near = mp.mpf(a) ** power * 10 ** source.uniform(-2, 2)
        free = source.random() < 0.4 or not 1e-307 < near < 1e307
        return source.choice([1, 1, -1]) * (size() if free else float(near))


def trial(job):
    """Sets of parameters of one controller: how many were taken, and each u that is wrong."""
    command, folder, seed, family, n, precision, wanted, scale = job
    mp.mp.dps = 60
    source = random.Random(f"{seed}-digits-{family}-{n}-{precision}")
    own = library(command, folder, family, n, precision)
    allowed = ALLOWED[precision].get(family, USUAL[precision])
    memory = ctypes.create_string_buffer(1 << 16)
    found = {"name": f"{family}, n = {n}, {precision}", "accepted": 0, "refused": 0, "calls": 0, "range": 0, "wrong": []}
    while found["accepted"] < wanted and found["refused"] < 60 * wanted:
        drawn = Drawn(source, family, n, precision)
        if own.own_init(memory, ctypes.byref(drawn.params)) != 0:
            found["refused"] += 1
            continue
        found["accepted"] += 1
        for _ in range(4):
            call(own, memory, drawn, source, (family, n, precision), allowed, scale, found)
    return found


def call(own, memory, drawn, source, design, allowed, scale, found):
    family, n, precision = design
    real, p = drawn.real, drawn.params
    share = 0 if source.random() < 0.2 else 10 ** -source.uniform(0, source.choice([0.01, 1, 3]))
    t = real(p.t0 + p.tau * (1 - share)).value
    to_go = max(Fraction(p.tau) + Fraction(p.t0) - Fraction(t), Fraction(p.eps))
    if t < p.t0 or to_go > Fraction(p.tau):
        return
    x = [0.0 if source.random() < 0.15 else source.choice([-1, 1]) * 10 ** source.uniform(-4, 4) for _ in range(n)]
    x, u = (real * n)(*x), real()
    found["calls"] += 1
    if own.own_step(memory, real(t), x, ctypes.byref(u)) < 0:
        found["range"] += 1
        return
    T = mp.mpf(to_go.numerator) / to_go.denominator
    exact = lambda T: control(family, drawn.exact, [mp.mpf(k) for k in p.k], T, [mp.mpf(v) for v in x])
    true = exact(T)
    if true is None:
        return
    # u is that of a time-to-go within a rounding: near t0 a term may vanish that no other hides.
    u_true, size = true[0] * scale, true[1]
    beside = [exact(T * (1 + sign * ROUNDING[precision])) for sign in (-1, 1)]
    moved = abs(beside[1][0] - beside[0][0]) if None not in beside and to_go < Fraction(p.tau) else 0
    floor = 8 * n * LEAST[precision] * max(1, *map(abs, x))
    if abs(mp.mpf(u.value) - u_true) > allowed * size + 2 * moved + floor:
        found["wrong"].append(
            f"tau = {p.tau!r}, t0 = {p.t0!r}, eps = {p.eps!r}, k = {list(p.k)}, t = {t!r}, x = {list(x)}: "
            f"u = {u.value!r}, not {mp.nstr(u_true, 17)}")
