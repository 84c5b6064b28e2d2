"""Mappings in many spellings, whose decay rate of mu' is known, with poles left and right of -n rho.

The rate is known by construction and confirmed by the numeric limit of -ln mu' over stretched time.
"""

from math import inf, log

import mpmath

from case import Case
from draw import decimal, pole_text


def mu_forms(a, b, c):
    """Text, rate, and ln(1 - mu/tau) of a mapping at stretched time t."""
    A, B, C = float(a), float(b), float(c)
    e, ln = mpmath.exp, mpmath.log
    big = f"{1 + B:.2f}"
    small = f"{0.9 * A:.4f}"
    return [
        (f"tau*(1 - {big}^(-{c}*t))", C * log(float(big)), lambda t: -C * t * log(float(big))),
        (f"tau - tau/{big}^t", log(float(big)), lambda t: -t * log(float(big))),
        (f"tau*(1 - exp(-{a}*t)*(1 + {small}*t))", A, lambda t: -A * t + ln(1 + float(small) * t)),
        (f"tau*(1 - exp(-{a}*t)/(1 + t))", A, lambda t: -A * t - ln(1 + t)),
        (f"tau*(1 - 2/(1 + exp({a}*t)))", A, lambda t: ln(2) - ln(1 + e(A * t))),
        (f"tau*(exp({a}*t) - 1)/(exp({a}*t) + 1)", A, lambda t: ln(2) - ln(1 + e(A * t))),
        (f"tau*(1 - exp(1 - exp({a}*t)))", inf, lambda t: 1 - e(A * t)),
        (f"tau*(1 - exp(-{a}*t - {c}*t^2))", inf, lambda t: -A * t - C * t * t),
        (f"tau*(1 - exp(-{a}*sinh(t)))", inf, lambda t: -A * mpmath.sinh(t)),
        (f"tau*(1 - exp(-t*ln({big} + t)))", inf, lambda t: -t * ln(float(big) + t)),
        (f"tau*(1 - exp(1 - sqrt(1 + {a}*t)))", 0, lambda t: 1 - mpmath.sqrt(1 + A * t)),
        (f"tau*ln(1 + {a}*t)/(1 + ln(1 + {a}*t))", 0, lambda t: -ln(1 + ln(1 + A * t))),
        (f"2*tau/pi*atan({a}*sinh({c}*t))", C, lambda t: ln(2 / mpmath.pi * mpmath.atan(1 / (A * mpmath.sinh(C * t))))),
        (f"2*tau/pi*atan({a}*t)", 0, lambda t: ln(2 / mpmath.pi * mpmath.atan(1 / (A * t)))),
        (f"tau*t/({a} + t)", 0, lambda t: ln(A / (A + t))),
        (f"tau*(1 - (1 + t)^(-{a}))", 0, lambda t: -A * ln(1 + t)),
        (f"tau*(1 - exp(-{a}*ln(1 + t)))", 0, lambda t: -A * ln(1 + t)),
        (f"tau*(1 - exp(-{a}*ln(1 + t) - ln(1 + t)^2))", 0, lambda t: -A * ln(1 + t) - ln(1 + t) ** 2),
        (f"tau*(exp({a}*t) - exp(-{a}*t))/(exp({a}*t) + exp(-{a}*t))", 2 * A, lambda t: ln(2) - ln(1 + e(2 * A * t))),
        (f"mean(exp(a={a}), rational(a={b}))", 0, lambda t: ln((e(-A * t) + 1 / (1 + B * t)) / 2)),
        (f"mean(exp(a={a}), tanh(a={b}))", min(A, 2 * B), lambda t: ln((e(-A * t) + 2 / (1 + e(2 * B * t))) / 2)),
        (f"tau*(1 - exp(-{a}*t)/3 - 2*exp(-{b}*t)/3)", min(A, B), lambda t: ln((e(-A * t) + 2 * e(-B * t)) / 3)),
        (f"tau*(1 - exp(-({a}*t + {b}*t^2)/(1 + t)))", B, lambda t: -(A * t + B * t * t) / (1 + t)),
        (f"tau*(1 - exp({a} - {a}*sqrt(1 + t^2) - {c}*t))", A + C, lambda t: A - A * mpmath.sqrt(1 + t * t) - C * t),
        (f"tau*(1 - (1 - tanh({a}*t))^{c})", 2 * A * C, lambda t: C * (ln(2) - ln(1 + e(2 * A * t)))),
        (f"tau*(1 - exp(-{a}*t)^{c})", A * C, lambda t: -A * C * t),
        (f"tau*(1 - exp(-{a}*t/ln(3 + t)))", 0, lambda t: -A * t / ln(3 + t)),
        (f"tau*(1 - exp(-{a}*t)*(1 + 0.1*sin({a}*t)))", A, lambda t: -A * t + ln(1 + mpmath.sin(A * t) / 10)),
        (f"tau*(1 - exp(-{a}*t)*({big} + cos({c}*t)/9)/({big} + 1/9))", A,
         lambda t: -A * t + ln((float(big) + mpmath.cos(C * t) / 9) / (float(big) + 1 / mpmath.mpf(9)))),
        (f"tau*(1 - exp(-{a}*t - {c}*t*(1 - 1/(1 + t)^2)))", A + C, lambda t: -A * t - C * t * (1 - 1 / (1 + t) ** 2)),
        (f"tau*(1 - sqrt(exp(-{a}*t)*exp(-{b}*t)))", (A + B) / 2, lambda t: -(A + B) / 2 * t),
        (f"tau*(1 - 1/(1 + sinh({a}*t)))", A, lambda t: -ln(1 + mpmath.sinh(A * t))),
        (f"tau*(1 - 1/(1 + t + {c}*t^3))", 0, lambda t: -ln(1 + t + C * t**3)),
        (f"tau*(1 - exp(-atan(t) - {a}*t))", A, lambda t: -mpmath.atan(t) - A * t),
        (f"tau*(1 - exp(-{a}*t*tanh(1 + t)))", A, lambda t: -A * t * mpmath.tanh(1 + t)),
        (f"tau*sin(pi/2*(1 - exp(-{a}*t)))", 2 * A,
         lambda t: ln(2) + 2 * ln(mpmath.sin(mpmath.pi / 4 * e(-A * t)))),
        (f"exp(a={a})", A, lambda t: -A * t),
        (f"exp(a=ln({big}))", log(float(big)), lambda t: -t * log(float(big))),
        (f"tanh(a={a}/2)", A, lambda t: ln(2) - ln(1 + e(A * t))),
    ]


def kappa_forms(a, b, c):
    """Text, rate, and kappa at T/tau = w with l = -ln w, which may be large."""
    A, B, C = float(a), float(b), float(c)
    ln, sqrt = mpmath.log, mpmath.sqrt
    big = f"{1 + B:.2f}"
    s, w = "dt/tau", "(1 - dt/tau)"
    return [
        (f"-ln{w}/ln({big})", log(float(big)), lambda l, w: l / log(float(big))),
        (f"-{a}*ln{w} - {b}*ln(1 - dt/(2*tau))", 1 / A, lambda l, w: A * l - B * ln((1 + w) / 2)),
        (f"-{a}*ln{w} + {b}*dt/(tau - dt)", 0, lambda l, w: A * l + B * (1 / w - 1)),
        (f"{a}*ln((tau + dt)/(tau - dt))", 1 / A, lambda l, w: A * (ln(2 - w) + l)),
        (f"{a}*atanh({s})", 2 / A, lambda l, w: A / 2 * (ln(2 - w) + l)),
        (f"ln(1 - {a}*ln{w})", inf, lambda l, w: ln(1 + A * l)),
        (f"sqrt(1 - {a}*ln{w}) - 1", inf, lambda l, w: sqrt(1 + A * l) - 1),
        (f"(1 - {a}*ln{w})^2 - 1", 0, lambda l, w: (1 + A * l) ** 2 - 1),
        (f"-ln{w}*(1 + {s})", mpmath.mpf(1) / 2, lambda l, w: l * (2 - w)),
        (f"-ln{w}*(1 + {w}/2)", 1, lambda l, w: l * (1 + w / 2)),
        (f"{a}*tan(pi/2*{s})", 0, lambda l, w: A * mpmath.cot(mpmath.pi / 2 * w)),
        (f"{w}^(-{c}) - 1", 0, lambda l, w: mpmath.exp(C * l) - 1),
        (f"-ln{w}/{a} + sqrt(1 - ln{w}) - 1", A, lambda l, w: l / A + sqrt(1 + l) - 1),
        (f"-ln{w}/{a} + ln(1 - ln{w})", A, lambda l, w: l / A + ln(1 + l)),
        ("ln(sqrt(1 + (dt/(tau - dt))^2) + dt/(tau - dt))", 1,
         lambda l, w: ln(sqrt(1 + (1 / w - 1) ** 2) + 1 / w - 1)),
        (f"exp({s}/{w}) - 1", 0, None),
        (f"{a}*(atanh({s}) + atanh(({s})^3))", 1 / A,
         lambda l, w: A / 2 * (ln(2 - w) + l + ln((1 + (1 - w) ** 3) / (w * (3 - 3 * w + w * w))))),
        (f"ln(tau/(tau - dt))/{a} + {s}*{w}/{big}", A, None),
    ]


def confirm(form, is_mu):
    """The numeric rate: the slope of -ln mu' over stretched time, far out at two places."""
    _, rho, function = form
    if function is None:
        return True
    with mpmath.workdps(60):
        slopes = []
        for far in (40, 4000) if is_mu else (1e3, 1e6):
            if is_mu:
                # ln mu' = ln rest + ln(-(ln rest)')
                value = lambda t: function(t) + mpmath.log(-mpmath.diff(function, t))
                far = mpmath.mpf(far)
                slopes.append((value(far) - value(2 * far)) / far)
            else:
                stretched = lambda l: function(l, mpmath.exp(-l))
                slope = mpmath.diff(stretched, mpmath.mpf(far), h=mpmath.mpf(10) ** -12)
                # d(-ln mu')/dt with mu' = w/(d kappa/dl)
                slopes.append(1 / slope)
        if rho == inf:
            return slopes[1] > 1.3 * slopes[0] > 0
        if rho == 0:
            return abs(slopes[1]) < 0.8 * abs(slopes[0]) or abs(slopes[1]) < 1e-3
        return abs(slopes[1] - rho) < 0.02 * rho


def draw(source, scale):
    a, b, c = (decimal(source, 0.3, 2) for _ in range(3))
    is_mu = source.random() < 0.6
    case = Case("growth")
    form = source.choice((mu_forms if is_mu else kappa_forms)(a, b, c))
    mapping, rho, _ = form
    key, case.rho = "mu" if is_mu else "kappa", float(rho)
    case.confirmed = bool(confirm(form, is_mu))
    case.n = source.randint(1, 4)
    edge = case.n * case.rho
    if rho == inf:
        slow, case.holds = source.uniform(1, 30), False
    elif rho == 0:
        slow = source.choice([1, 1, -1]) * source.uniform(0.2, 4)
        case.holds = slow > 0
    else:
        case.holds = source.random() < 0.5
        slow = edge * (source.choice([1.02, 1.05, 1.5]) if case.holds else source.choice([0.98, 0.95, 0.6]))
    slow = f"{-slow:.5f}"
    slowest = float(slow)
    if rho not in (0, inf):
        case.holds = slowest < -edge * scale
    poles = [(slow, "0")] + [(f"{min(float(slow), -edge if rho != inf else 0) - 1 - k:.5f}", "0") for k in range(case.n - 1)]
    poles = ",".join(pole_text(*pole).strip('"') for pole in poles)
    case.words = ["--n", str(case.n), f"--{key}={mapping}", f"--poles={poles}"]
    return case
