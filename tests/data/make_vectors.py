#!/usr/bin/env python3
"""Reference vectors for the generated controllers, computed from the definitions alone.

    python3 -m pip install mpmath && python3 tests/data/make_vectors.py            # writes the two files below
    python3 -m pip install mpmath && python3 tests/data/make_vectors.py --check    # only checks vectors.jsonl

Default mode writes, next to this script, deadline.jsonl (binary64) and single.jsonl (binary32), after the check.
`--check` recomputes t_kappa, xi, b, u and scale of every line of vectors.jsonl and exits with status 1 unless all of
them agree to 25 digits. Both modes are deterministic: the seeds are fixed below.

The route uses no closed form of a derivative:
  * kappa from its definition (exp_sum: monotone Newton iteration on mu, then a sign change that brackets the root);
    mu(kappa) = t - t0 is asserted for every family;
  * r_k = k! [h^k] mu(kappa + h), by truncated power-series arithmetic on the definition of mu;
  * B_{i,j} = sum_l C(i-1, l-1) r_l B_{i-l,j-1},  B_{0,0} = 1;
  * kappa' = 1 / mu'(kappa) = 1 / r_1;
  * u = kappa'^n (-(sum_i k_i xi_i) - sum_j b_j x_j),  xi_i = sum_j B_{i-1,j-1} x_j,  b_j = B_{n,j-1};
  * scale = kappa'^n (sum_{i,j} |k_i B_{i-1,j-1} x_j| + sum_j |b_j x_j|).
Every point is computed with DPS[0] and again with DPS[1] digits, and the two must agree to 40.
"""

import json
import os
import random
import struct
import sys
from fractions import Fraction
from math import comb, factorial

from mpmath import mp, mpf

HERE = os.path.dirname(os.path.abspath(__file__))
DPS = (160, 280)
MATCH = mpf(10) ** -25  # vectors.jsonl against this script
SELF = mpf(10) ** -40  # DPS[0] against DPS[1]
FAMILIES = ("exp", "rational", "power", "tan", "tanh", "algebraic", "exp_sum", "soft")
POWERS = (0.5, 1.0, 2.0, 3.0, None)  # None: drawn from 0.3..3
STARTS = (1e-6, 0.01, 0.1, 0.5, 1.0, None)  # None: drawn from 0.05..1
STARTS_SINGLE = (0.05, 0.2, 0.5, 1.0, None)


# ---- truncated power series in h: lists [c_0, ..., c_N] -------------------------------------------------------------

def s_mul(p, q):
    return [mp.fsum(p[i] * q[k - i] for i in range(k + 1)) for k in range(len(p))]


def s_div(p, q):
    r = []
    for k in range(len(p)):
        r.append((p[k] - mp.fsum(q[i] * r[k - i] for i in range(1, k + 1))) / q[0])
    return r


def s_exp(p):  # e' = p' e
    e = [mp.exp(p[0])]
    for k in range(1, len(p)):
        e.append(mp.fsum(i * p[i] * e[k - i] for i in range(1, k + 1)) / k)
    return e


def s_pow(p, alpha):  # p e' = alpha p' e
    e = [mp.power(p[0], alpha)]
    for k in range(1, len(p)):
        e.append(mp.fsum((alpha * i - (k - i)) * p[i] * e[k - i] for i in range(1, k + 1)) / (k * p[0]))
    return e


def s_atan(p):  # e' = p' / (1 + p^2)
    n = len(p)
    d = s_mul(p, p)
    d[0] += 1
    q = s_div([(i + 1) * p[i + 1] for i in range(n - 1)] + [mpf(0)], d)
    return [mp.atan(p[0])] + [q[i - 1] / i for i in range(1, n)]


def s_lin(a, t, order):  # a (t + h)
    return [a * t, a] + [mpf(0)] * (order - 1)


def s_const(c, p):  # c + p
    return [c + p[0]] + list(p[1:])


# ---- the families: mu as a series around t, and kappa(dt) -----------------------------------------------------------

def mu_series(mu, par, tau, t, order):
    if mu == "exp_sum":
        rates = [mpf(v) for v in par["rates"]]
        terms = [s_exp(s_lin(-v, t, order)) for v in rates]
        mean = [mp.fsum(c) / len(rates) for c in zip(*terms)]
        return [tau * c for c in s_const(1, [-c for c in mean])]
    a = mpf(par["a"])
    y = s_lin(a, t, order)
    if mu == "exp":
        f = s_const(1, [-c for c in s_exp([-c for c in y])])
    elif mu == "rational":
        f = s_div(y, s_const(1, y))
    elif mu == "power":
        m = mpf(par["m"])
        f = s_const(1, [-c for c in s_pow(s_const(1, [m * c for c in y]), -1 / m)])
    elif mu == "tan":
        f = [2 / mp.pi * c for c in s_atan(y)]
    elif mu == "tanh":
        e = s_exp([2 * c for c in y])
        f = s_div(s_const(-1, e), s_const(1, e))
    elif mu == "algebraic":
        f = s_mul(y, s_pow(s_const(1, s_mul(y, y)), mpf(-1) / 2))
    elif mu == "soft":  # the root w of w (2 - r - (1 - r) w) = e^(-a t); f = 1 - w
        r = mpf(par["start"])
        e = s_exp([-c for c in y])
        root = s_pow(s_const((2 - r) ** 2, [-4 * (1 - r) * c for c in e]), mpf(1) / 2)
        f = s_const(1, [-2 * c for c in s_div(e, s_const(2 - r, root))])
    else:
        raise ValueError(mu)
    return [tau * c for c in f]


def kappa(mu, par, tau, dt):
    s = dt / tau
    if mu == "exp_sum":
        return kappa_exp_sum([mpf(v) for v in par["rates"]], s)
    a = mpf(par["a"])
    if mu == "exp":
        return -mp.log(1 - s) / a
    if mu == "rational":
        return dt / (a * (tau - dt))
    if mu == "power":
        m = mpf(par["m"])
        return (mp.power(1 - s, -m) - 1) / (a * m)
    if mu == "tan":
        return mp.tan(mp.pi * s / 2) / a
    if mu == "tanh":
        return mp.atanh(s) / a
    if mu == "algebraic":
        return s / (a * mp.sqrt(1 - s * s))
    if mu == "soft":
        r = mpf(par["start"])
        return -mp.log(1 - r * s - (1 - r) * s * s) / a
    raise ValueError(mu)


def kappa_exp_sum(rates, s):
    """The root of mean_i exp(-a_i t) = 1 - s: convex and decreasing, so Newton from the left climbs to the root."""
    def g(t):
        return mp.fsum(mp.exp(-a * t) for a in rates) / len(rates) - (1 - s)

    def dg(t):
        return -mp.fsum(a * mp.exp(-a * t) for a in rates) / len(rates)

    if s == 0:
        return mpf(0)
    t = -mp.log(1 - s) / max(rates)
    for _ in range(1000):
        step = -g(t) / dg(t)
        t += step
        if abs(step) < mpf(10) ** (-(mp.dps // 2 + 10)) * t:  # the next step squares it
            t -= g(t) / dg(t)
            break
    width = mpf(10) ** (30 - mp.dps) * t
    assert g(t - width) > 0 > g(t + width), "the root is not bracketed"
    return t


# ---- the law --------------------------------------------------------------------------------------------------------

def evaluate(p, dps):
    """t_kappa, xi, b, u, scale of one point whose inputs are taken as exact."""
    with mp.workdps(dps):
        mu, par, n = p["mu"], p["params"], p["n"]
        tau = mpf(p["tau"])
        dt = mpf(p["t"]) - mpf(p["t0"])
        x = [mpf(v) for v in p["x"]]
        gain = [mpf(v) for v in p["k"]]
        assert 0 <= dt < tau and len(x) == len(gain) == n
        tk = kappa(mu, par, tau, dt)
        c = mu_series(mu, par, tau, tk, n)
        assert abs(c[0] - dt) < mpf(10) ** (50 - dps) * tau, "mu(kappa) is not t - t0"
        r = [None] + [c[k] * factorial(k) for k in range(1, n + 1)]
        bell = [[mpf(0)] * (n + 1) for _ in range(n + 1)]
        bell[0][0] = mpf(1)
        for i in range(1, n + 1):
            for j in range(1, i + 1):
                bell[i][j] = mp.fsum(comb(i - 1, l - 1) * r[l] * bell[i - l][j - 1] for l in range(1, i - j + 2))
        xi = [mp.fsum(bell[i][j] * x[j] for j in range(i + 1)) for i in range(n)]
        b = [bell[n][j] for j in range(n)]
        lead = (1 / r[1]) ** n
        u = lead * (-mp.fsum(gain[i] * xi[i] for i in range(n)) - mp.fsum(b[j] * x[j] for j in range(n)))
        terms = [gain[i] * bell[i][j] * x[j] for i in range(n) for j in range(i + 1)] + [b[j] * x[j] for j in range(n)]
        scale = abs(lead) * mp.fsum(abs(v) for v in terms)
        return {"t_kappa": tk + mpf(p["t0"]), "xi": xi, "b": b, "u": u, "scale": scale}


def reference(p):
    low, high = evaluate(p, DPS[0]), evaluate(p, DPS[1])
    for key in ("u", "scale"):
        assert abs(low[key] - high[key]) <= SELF * abs(high[key]), (key, p)
    return high["u"], high["scale"]


def check(path):
    """Largest relative difference from the oracle vectors, and their number."""
    worst, where, count = mpf(0), None, 0
    with open(path, encoding="utf-8") as f, mp.workdps(DPS[0]):
        for number, line in enumerate(f, 1):
            p = json.loads(line)
            mine = evaluate(p, DPS[0])
            for name, a in mine.items():
                b = p[name]
                a, b = (a, [mpf(v) for v in b]) if isinstance(b, list) else ([a], [mpf(b)])
                # entries of b that are exactly zero come out as rounding residue: nothing below 1e-100 of the largest counts
                floor = mpf(10) ** -100 * max(map(abs, b))
                for v, w in zip(a, b, strict=True):
                    if v != w and (diff := abs(v - w) / max(abs(w), floor)) > worst:
                        worst, where = diff, f"{name}, line {number}"
            count += 1
    return worst, where, count


# ---- drawing the points ---------------------------------------------------------------------------------------------

def single(v):
    return struct.unpack("<f", struct.pack("<f", v))[0]


def ulp32(v):
    bits = struct.unpack("<I", struct.pack("<f", abs(v)))[0]
    return struct.unpack("<f", struct.pack("<I", bits + 1))[0] - abs(v)


def draw(rng, cast, mu, n, index, t0_class, ratio):
    def number(lo, hi):  # three decimals or a full significand
        v = rng.uniform(lo, hi)
        return cast(round(v, 3) if rng.random() < 0.5 else v)

    if mu == "exp_sum":
        params = {"rates": sorted(cast(round(rng.uniform(0.3, 3), 3)) for _ in range(2 + index % 2))}
    else:
        params = {"a": cast(round(rng.uniform(0.3, 3), 3))}
    if mu == "power":
        m = POWERS[index % len(POWERS)]
        params["m"] = cast(round(rng.uniform(0.3, 3), 3) if m is None else m)
    if mu == "soft":
        starts = STARTS if cast is float else STARTS_SINGLE
        start = starts[index % len(starts)]
        params["start"] = cast(round(rng.uniform(0.05, 1), 3) if start is None else start)
    tau = number(0.5, 10)
    t0 = (cast(0.0), number(0.1, 30), number(1e2, 1e4), -number(0.1, 30))[t0_class]
    t = cast(float(Fraction(t0) + Fraction(tau) * (1 - Fraction(ratio))))
    x = [cast(rng.uniform(-3, 3)) for _ in range(n)]
    if index % 3 == 2:  # coefficients of (lambda + p)^n
        pole = rng.uniform(0.5, 1.5)
        k = [cast(round(comb(n, i) * pole ** (n - i), 3)) for i in range(n)]
        k = [max(v, cast(0.001)) for v in k]
    else:
        k = [cast(round(rng.uniform(0.5, 20), 3)) for _ in range(n)]
    return {"mu": mu, "params": params, "n": n, "tau": tau, "t0": t0, "t": t, "x": x, "k": k}


def points(seed, cast, orders, decades, limits, resolved):
    """`decades`: T/tau runs over 1 ... 10^-decades; `limits`: smallest and largest magnitude of u and scale."""
    small, large = mpf(limits[0]), mpf(limits[1])
    for family, mu in enumerate(FAMILIES):
        for n in orders:
            rng = random.Random(f"{seed}/{mu}/{n}")
            count = {"power": 20, "exp_sum": 16, "soft": 24}.get(mu, 14)
            for index in range(count):
                exponent = decades * index / (count - 1)
                if 0 < index < count - 1:
                    exponent += rng.uniform(-0.3, 0.3)
                attempts = 0
                while True:
                    p = draw(rng, cast, mu, n, index, (index + n + family) % 4, 10.0 ** -exponent)
                    left = Fraction(p["tau"]) - (Fraction(p["t"]) - Fraction(p["t0"]))
                    # rounding may leave t at the deadline or beyond it: such a draw is dropped
                    if left > 0 and p["t"] >= p["t0"] and resolved(p["t"], left):
                        u, scale = reference(p)
                        if small <= abs(u) and scale <= large:
                            break
                        exponent *= rng.uniform(0.6, 0.95)  # out of range: move away from the deadline
                    else:
                        attempts += 1
                        if attempts % 6 == 0:
                            exponent *= rng.uniform(0.6, 0.95)
                p["u"], p["scale"] = mp.nstr(u, 30), mp.nstr(scale, 30)
                p["T_over_tau"] = float(f"{float(left / Fraction(p['tau'])):.3g}")
                yield p


def write(name, stream):
    path = os.path.join(HERE, name)
    lines = [json.dumps(p) for p in stream]
    with open(path, "w", encoding="utf-8", newline="\n") as f:
        f.write("\n".join(lines) + "\n")
    print(f"{name}: {len(lines)} lines, {os.path.getsize(path)} bytes")


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    mp.dps = DPS[1]
    worst, where, count = check(os.path.join(HERE, "vectors.jsonl"))
    print(f"vectors.jsonl: {count} lines, largest relative difference {mp.nstr(worst, 3)} ({where})")
    if not count or worst > MATCH:
        sys.exit(1)
    if sys.argv[1:] == ["--check"]:
        return
    write("deadline.jsonl", points("deadline", float, (*range(1, 9), 12), 12, ("1e-300", "1e300"), lambda t, left: True))
    write("single.jsonl", points("single", single, range(1, 9), 6, ("1e-30", "1e37"), lambda t, left: left >= Fraction(ulp32(t))))


if __name__ == "__main__":
    main()
