"""Time mappings at tau = 1: stretched time and the derivatives of kappa at a time-to-go w."""

import mpmath
import numpy as np

from series import Series, call, inverse_derivatives


class Mapping:
    """A mapping of `spellings` (lines of a design file), given by kappa of w = T/tau, or by the rest
    1 - mu of stretched time with its decay bracketed by `rates`."""

    def __init__(self, name, spellings, rho, kappa=None, rest=None, rates=None, scales=True):
        self.name, self.spellings, self.rho = name, spellings, rho
        self.kappa, self.rest, self.rates, self.scales = kappa, rest, rates, scales

    def at(self, w, order):
        """Stretched time and the derivatives 1..order of kappa by elapsed time, at w."""
        if self.kappa is not None:
            kappa = self.kappa(Series.variable(w, order, -1))
            return kappa.c[0], kappa.derivatives()
        t = self._solve(w)
        rest = self.rest(Series.variable(t, order))
        return t, inverse_derivatives([-r for r in rest.derivatives()])

    def _solve(self, w):
        """t with rest(t) = w: Newton on ln(rest), which is convex or nearly so, kept in its bracket."""
        logarithm = call("ln", w)
        low, high = -logarithm / max(self.rates), -logarithm / min(self.rates)
        t = low
        for _ in range(200):
            value = self.rest(Series.variable(t, 1)).ln()
            gap = value.c[0] - logarithm
            low = np.where(gap > 0, t, low)
            high = np.where(gap < 0, t, high)
            step = t - gap / value.c[1]
            inside = (step >= low) & (step <= high)
            new = np.where(inside, step, (low + high) / 2)
            if np.all(abs(new - t) <= 1e-18 * (1 + abs(t))) and w.dtype != object:
                return new
            if w.dtype == object and all(abs(x - y) < mpmath.mpf(10) ** -40 for x, y in zip(new, t)):
                return new
            t = new
        return t


def number(text, like):
    """A decimal in the arithmetic of an array."""
    return mpmath.mpf(text) if like.dtype == object else np.longdouble(text)


def pi(like):
    return mpmath.mpf(mpmath.pi) if like.dtype == object else np.longdouble("3.14159265358979323846264338327950288")


def exp(a):
    a_ = lambda x: number(a, x.c[0])
    return Mapping(
        "exp",
        [f'mu = "exp(a={a})"', f'mu = "tau*(1 - exp(-{a}*t))"', f'kappa = "-ln(1 - dt/tau)/{a}"',
         f'kappa = "ln(tau/(tau - dt))/{a}"', f'mu = "tau - tau*exp({a})^(-t)"'],
        float(a), kappa=lambda w: w.ln() / -a_(w))


def rational(a):
    return Mapping(
        "rational",
        [f'mu = "rational(a={a})"', f'mu = "tau*{a}*t/(1 + {a}*t)"', f'kappa = "dt/({a}*(tau - dt))"',
         f'mu = "tau*(1 - 1/(1 + {a}*t))"', f'mu = "power(a={a},m=1)"'],
        0.0, kappa=lambda w: (1 / w - 1) / number(a, w.c[0]))


def power(a, m):
    def kappa(w):
        a_, m_ = number(a, w.c[0]), number(m, w.c[0])
        return (w.power(-m_) - 1) / (a_ * m_)
    return Mapping(
        "power",
        [f'mu = "power(a={a},m={m})"', f'kappa = "((1 - dt/tau)^(-{m}) - 1)/({a}*{m})"',
         f'mu = "tau*(1 - (1 + {a}*{m}*t)^(-1/{m}))"'],
        0.0, kappa=kappa)


def tan(a):
    def kappa(w):
        th = w * (pi(w.c[0]) / 2)
        sin, cos = sine_cosine(th)
        return cos / sin / number(a, w.c[0])
    return Mapping(
        "tan",
        [f'mu = "tan(a={a})"', f'kappa = "tan(pi/2*dt/tau)/{a}"', f'mu = "2*tau/pi*atan({a}*t)"'],
        0.0, kappa=kappa)


def sine_cosine(f):
    s, c = [call("sin", f.c[0])], [call("cos", f.c[0])]
    for k in range(1, len(f.c)):
        s.append(sum(i * f.c[i] * c[k - i] for i in range(1, k + 1)) / k)
        c.append(-sum(i * f.c[i] * s[k - i] for i in range(1, k + 1)) / k)
    return Series(s), Series(c)


def tanh(a):
    return Mapping(
        "tanh",
        [f'mu = "tanh(a={a})"', f'mu = "tau*tanh({a}*t)"', f'kappa = "atanh(dt/tau)/{a}"',
         f'mu = "tau*(1 - exp(-2*{a}*t))/(1 + exp(-2*{a}*t))"',
         f'kappa = "ln((tau + dt)/(tau - dt))/(2*{a})"'],
        2 * float(a), kappa=lambda w: ((2 - w) / w).ln() / (2 * number(a, w.c[0])))


def algebraic(a):
    return Mapping(
        "algebraic",
        [f'mu = "algebraic(a={a})"', f'mu = "tau*{a}*t/sqrt(1 + ({a}*t)^2)"',
         f'kappa = "dt/tau/({a}*sqrt(1 - (dt/tau)^2))"'],
        0.0, kappa=lambda w: (1 - w) / (w * (2 - w)).sqrt() / number(a, w.c[0]))


def exp_sum(a, b):
    def rest(t):
        return ((t * -number(a, t.c[0])).exp() + (t * -number(b, t.c[0])).exp()) / 2
    return Mapping(
        "exp_sum",
        [f'mu = "exp_sum(rates=[{a},{b}])"', f'mu = "tau*(1 - (exp(-{a}*t) + exp(-{b}*t))/2)"',
         f'mu = "mean(exp(a={a}), exp(a={b}))"'],
        min(float(a), float(b)), rest=rest, rates=[float(a), float(b)])


def logarithm_and_linear(a, b):
    """A mapping of no family: its rate is that of exp, its start another."""
    return Mapping(
        "kappa",
        [f'kappa = "-ln(1 - dt/tau)/{a} + {b}*dt/tau"', f'kappa = "{b}*dt/tau + ln(tau/(tau - dt))/{a}"'],
        float(a), kappa=lambda w: w.ln() / -number(a, w.c[0]) + number(b, w.c[0]) * (1 - w))


FAMILIES = ["exp", "rational", "power", "tan", "tanh", "algebraic", "exp_sum", "kappa"]
