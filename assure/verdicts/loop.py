"""The closed loop of the chain of integrators at tau = 1, from its modes in stretched time.

xi' = A xi + e_n mu'^n d has the modes t^m e^(lambda t) of the poles; x = BB_n[kappa'] xi and
u = (pi0/mu'^n + b_n xi)/g. For another tau, x_i scales by tau^(1-i), u by tau^-n, d by tau^n.
"""

from math import comb, factorial

import mpmath
import numpy as np

from series import bell, call

mpmath.mp.dps = 60


class Loop:
    """A chain of order n with a mapping and poles, pairs (real, imaginary) of decimals as text."""

    def __init__(self, n, mapping, poles, gain="1"):
        self.n, self.mapping, self.gain = n, mapping, gain
        self.poles = [mpmath.mpc(re, im) for re, im in poles]
        self.modes = []
        for index, pole in enumerate(self.poles):
            self.modes.append((pole, sum(1 for p in self.poles[:index] if p == pole)))
        gains = [mpmath.mpc(1)]
        for pole in self.poles:
            gains = [
                (gains[i - 1] if i else 0) - (pole * gains[i] if i < len(gains) else 0)
                for i in range(len(gains) + 1)
            ]
        self.gains = [mpmath.re(k) for k in gains[:n]]
        start = np.array([mpmath.mpf(0)], dtype=object)
        vandermonde = mpmath.matrix(n, n)
        for j, column in enumerate(self._modes(start)):
            for i in range(n):
                vandermonde[i, j] = column[i][0]
        inverse = vandermonde**-1
        bk, _ = self._maps(np.array([mpmath.mpf(1)], dtype=object))[1:3]
        k0 = mpmath.matrix(n, n)
        for i in range(n):
            for j in range(n):
                k0[i, j] = bk[i][j][0]
        self.from_start = inverse * k0**-1
        self.from_force = [inverse[i, n - 1] for i in range(n)]

    def _modes(self, t):
        """For each mode its xi_1..xi_n at stretched times t."""
        out = []
        for pole, m in self.modes:
            if t.dtype != object:
                pole = _long(pole)
            wave = call("exp", pole * t)
            rows = []
            for i in range(self.n):
                rows.append(
                    wave
                    * sum(
                        comb(i, l) * pole ** (i - l) * t ** (m - l) / factorial(m - l)
                        for l in range(min(i, m) + 1)
                    )
                )
            out.append(rows)
        return out

    def _maps(self, w):
        """t, BB_n of kappa's derivatives, the row b_n, mu' at the times-to-go w."""
        t, r = self.mapping.at(w, self.n)
        b = bell(r, self.n + 1)
        return t, b, b[self.n], 1 / r[0]

    def outputs(self, w):
        """t, mu' and the rows of x_1..x_n, u over xi at w: array [N, n+1, n]."""
        t, b, row, slope = self._maps(w)
        n = self.n
        rows = np.empty((len(w), n + 1, n), dtype=w.dtype)
        for i in range(n):
            for j in range(n):
                rows[:, i, j] = b[i][j]
        gain = mpmath.mpf(self.gain) if w.dtype == object else np.longdouble(self.gain)
        for j in range(n):
            k = self.gains[j] if w.dtype == object else _real(self.gains[j])
            rows[:, n, j] = (row[j] - k / slope**n) / gain
        return t, slope, rows

    def free(self, w):
        """Rows of x_1..x_n, u over x0 at w: array [N, n+1, n]."""
        t, _, rows = self.outputs(w)
        modes = np.array(self._modes(t)).transpose(2, 1, 0)  # N, i, mode
        c = [[self.from_start[i, j] for j in range(self.n)] for i in range(self.n)]
        c = _as(c, w.dtype)
        return _real_part(_dot(_dot(rows, modes), c))

    def kernel(self, w, nodes):
        """What a force at the times-to-go `nodes` adds to x_1..x_n, u at the one time-to-go w,
        per unit of -ln of its time-to-go: array [nodes, n+1]."""
        _, _, rows = self.outputs(np.array([w]))
        t = self.mapping.at(np.array([w]), self.n)[0][0]
        s, r = self.mapping.at(nodes, self.n)
        weight = (1 / r[0]) ** (self.n - 1) * nodes
        modes = np.array(self._modes(t - s)).transpose(2, 1, 0)
        c = _as([self.from_force], nodes.dtype)[0]
        xi = _real_part((modes * c).sum(axis=2)) * weight[:, None]
        return xi @ rows[0].T


def _long(z):
    return np.clongdouble(_real(mpmath.re(z))) + 1j * _real(mpmath.im(z))


def _real(x):
    return np.longdouble(mpmath.nstr(x, 30))


def _as(rows, dtype):
    if dtype == object:
        return np.array(rows, dtype=object)
    return np.array([[_long(mpmath.mpc(x)) for x in row] for row in rows], dtype=np.clongdouble)


def _dot(a, b):
    if a.dtype == object or b.dtype == object:
        return np.array([x.dot(b[k] if b.ndim == 3 else b) for k, x in enumerate(a)], dtype=object)
    return a @ b


def _real_part(a):
    if a.dtype == object:
        return np.frompyfunc(mpmath.re, 1, 1)(a)
    return a.real
