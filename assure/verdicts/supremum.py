"""Suprema over the initial states of a box, settling times, instants and bounded forces.

A linear quantity is a row (c_1..c_n, c_u) over x_1..x_n, u; its worst case over a box and a signal
within bounds is centre plus radius by absolute values, which some state and some signal attain.
"""

from itertools import product

import numpy as np

POINTS = 900
FORCED_POINTS = 120
PEAKS = 4
ZOOMS = 4

# 1, or a wrong factor by which a run shows that false truths are seen.
SCALE = 1.0


class Setting:
    """A loop with a box, an interval of tau, the T/tau of the end, and bounds of a force or None."""

    def __init__(self, loop, box, tau, until, force=None, signals="any"):
        self.loop, self.box, self.tau, self.until = loop, box, tau, until
        self.force, self.signals = force, signals
        self.low = np.array([np.longdouble(lo) for lo, _ in box])
        self.high = np.array([np.longdouble(hi) for _, hi in box])
        self.end = -np.log(np.longdouble(until))
        self._cache = {}

    def taus(self):
        lo, hi = np.longdouble(self.tau[0]), np.longdouble(self.tau[1])
        return np.array([lo]) if lo == hi else np.exp(np.linspace(np.log(lo), np.log(hi), 25))

    def free(self, sigma):
        return self.loop.free(np.exp(-sigma))

    def kernel(self, sigma):
        """The kernel at one instant, the weights of its nodes and these, by a composite Gauss rule that is
        fine at the start, and where the force still acts: near the instant."""
        key = float(sigma)
        if key not in self._cache:
            self._cache[key] = self._kernel(sigma)
        return self._cache[key]

    def _kernel(self, sigma):
        if sigma <= 0:
            return np.zeros((1, self.loop.n + 1), dtype=np.longdouble), np.zeros(1), np.zeros(1)
        table = np.linspace(0, float(sigma), 400)
        times = self.loop.mapping.at(np.exp(-table.astype(np.longdouble)), 1)[0].astype(float)
        back = times[-1] * (1 - np.geomspace(1e-9, 1, 110))
        cuts = np.concatenate([np.linspace(0, float(sigma), 110), np.interp(back, times, table)])
        cuts = np.unique(np.clip(cuts, 0, float(sigma))).astype(np.longdouble)
        cuts[-1] = sigma
        x, g = np.polynomial.legendre.leggauss(3)
        half = (cuts[1:] - cuts[:-1]) / 2
        nodes = (((cuts[1:] + cuts[:-1]) / 2)[:, None] + half[:, None] * x).ravel()
        weights = (half[:, None] * g).ravel()
        return self.loop.kernel(np.exp(-sigma), np.exp(-nodes)), weights, nodes

    def scaled(self, row, w, tau):
        """The row over unit quantities at tau."""
        n = self.loop.n
        powers = [1 - i for i in range(1, n + 1)] + [-n]
        c = [coefficient(w * tau) if callable(coefficient) else coefficient for coefficient in row]
        return np.array([np.longdouble(a) * np.longdouble(tau) ** p for a, p in zip(c, powers)])

    def linear(self, row, sigma, tau, rows):
        """The worst value of a row at one instant, and the initial state that gives it."""
        n = self.loop.n
        c = self.scaled(row, np.exp(-sigma), tau)
        over = (c @ rows) * tau ** np.arange(n, dtype=np.longdouble)
        worst = np.where(over > 0, self.high, self.low)
        value = over @ worst
        if self.force is not None:
            kernel, weights, _ = self.kernel(sigma)
            signal = self.worst_signal(kernel @ c, weights)
            value += tau**n * ((kernel @ c) * signal * weights).sum()
        return value, worst

    def worst_signal(self, kernel, weights):
        lo, hi = np.longdouble(self.force[0]), np.longdouble(self.force[1])
        along = (kernel * weights).sum() if self.signals == "constant" else kernel
        return np.where(along > 0, hi, lo)

    def state(self, row, sigma, tau, rows):
        """The worst value of a row, and x_1..x_n at that instant under its worst state and signal."""
        n = self.loop.n
        value, x0 = self.linear(row, sigma, tau, rows)
        scale = tau ** np.arange(n, dtype=np.longdouble)
        x = (rows[:n] @ (x0 * scale)) / scale
        if self.force is not None:
            kernel, weights, _ = self.kernel(sigma)
            c = self.scaled(row, np.exp(-sigma), tau)
            signal = self.worst_signal(kernel @ c, weights)
            x += tau**n * (kernel[:, :n] * (signal * weights)[:, None]).sum(axis=0) / scale
        return value, x


def supremum(setting, value):
    """The greatest value(sigma, tau, rows) over all instants and settling times, where it is."""
    points = FORCED_POINTS if setting.force is not None else POINTS
    taus = setting.taus()
    if len(taus) > 1:
        points, taus = (points, taus[::4]) if setting.force is not None else (points // 3, taus)
    # Poles left of -n rho make the transient of high orders short: points are dense at the start.
    sigmas = setting.end * (np.arange(points + 1, dtype=np.longdouble) / points) ** 1.7
    rows = setting.free(sigmas)
    table = np.array([[value(s, tau, r) for s, r in zip(sigmas, rows)] for tau in taus])
    best, at = -np.inf, None
    for i, j in peaks(table):
        found, where = climb(setting, value, sigmas, taus, i, j, table[i, j])
        if found > best:
            best, at = found, where
    return best * SCALE, at


def peaks(table):
    """The highest local maxima of a table, over its rows and columns."""
    padded = np.pad(table, 1, constant_values=-np.inf)
    inner = padded[1:-1, 1:-1]
    around = [padded[:-2, 1:-1], padded[2:, 1:-1], padded[1:-1, :-2], padded[1:-1, 2:]]
    indices = np.argwhere(np.all([inner >= other for other in around], axis=0))
    return sorted(map(tuple, indices), key=lambda index: -table[index])[:PEAKS]


def climb(setting, value, sigmas, taus, i, j, best):
    """From a point of the table to the top, by ever finer tables around the best point."""
    at = (sigmas[j], taus[i])
    step_s = sigmas[min(j + 1, len(sigmas) - 1)] - sigmas[max(j - 1, 0)]
    step_t = taus[1] / taus[0] if len(taus) > 1 else 1
    for _ in range(ZOOMS):
        span = np.clip(at[0] + step_s * np.linspace(-1, 1, 9), 0, setting.end)
        near = [at[1]]
        if len(taus) > 1:
            near = np.clip(at[1] * step_t ** np.linspace(-1, 1, 7), taus[0], taus[-1])
        local = setting.free(span)
        for tau in near:
            for s, r in zip(span, local):
                v = value(s, tau, r)
                if v > best:
                    best, at = v, (s, tau)
        step_s, step_t = step_s / 4, step_t ** np.longdouble(0.3)
    return best, at


def corners(setting):
    free = [i for i in range(setting.loop.n) if setting.low[i] < setting.high[i]]
    base = setting.low.copy()
    out = []
    for choice in product([0, 1], repeat=len(free)):
        x = base.copy()
        for index, high in zip(free, choice):
            x[index] = setting.high[index] if high else setting.low[index]
        out.append(x)
    return np.array(out)


def norm_at(setting, sigma, tau, rows, vertices):
    """The greatest |x| over the box at one instant: a convex function, so at a vertex."""
    n = setting.loop.n
    scale = np.longdouble(tau) ** np.arange(n, dtype=np.longdouble)
    phi = rows[:n] / scale[:, None] * scale[None, :]
    x = vertices @ phi.T
    return np.sqrt((x * x).sum(axis=1).max())


def gain_at(setting, sigma, tau, rows):
    """The greatest |x|/|x0| over directions of those states that are not held at 0."""
    n = setting.loop.n
    free = [i for i in range(n) if setting.low[i] < setting.high[i] or setting.low[i] != 0]
    scale = np.longdouble(tau) ** np.arange(n, dtype=np.longdouble)
    phi = (rows[:n] / scale[:, None] * scale[None, :])[:, free].astype(float)
    return np.linalg.norm(phi, 2)
