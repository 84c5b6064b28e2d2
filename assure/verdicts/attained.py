"""The suprema by another route: SciPy integrates the plant under the worst state and force."""

import random

import numpy as np
from scipy.integrate import solve_ivp

from draw import draw_mapping, draw_poles
from loop import Loop
from mapping import FAMILIES
from objectives import row
from simulate import law
from supremum import Setting, supremum


def trial(job):
    """By how much a claimed supremum is missed by the run that should attain it, as a part of it."""
    seed, index = job
    source = random.Random(f"{seed}-attained{index}")
    n = source.randint(1, 4)
    made = draw_mapping(source, source.choice(FAMILIES))
    loop = Loop(n, made, draw_poles(source, n, made.rho))
    tau = round(source.uniform(0.3, 2), 2)
    box = [(-round(source.uniform(0.1, 2), 2), 1.0) for _ in range(n)]
    force = (-round(source.uniform(0.05, 1), 2), 0.5)
    setting = Setting(loop, box, (tau, tau), 1e-2, force)
    c, _ = row(source, setting)
    value, (end, _) = supremum(setting, lambda s, t, rows: setting.linear(c, s, t, rows)[0])
    rows = setting.free(np.array([end]))[0]
    _, x0 = setting.linear(c, end, np.longdouble(tau), rows)
    if end == 0:
        return {"miss": 0.0}
    kernel, weights, sigmas = setting.kernel(end)
    signal = setting.worst_signal(kernel @ setting.scaled(c, np.exp(-end), tau), weights)
    u = law(loop, tau)
    x, begin = np.array(x0, dtype=float), 0.0
    jumps = np.flatnonzero(np.diff(signal))
    ends = [float(sigmas[j] + sigmas[j + 1]) / 2 for j in jumps] + [float(end)]
    for until, d in zip(ends, [signal[j] for j in jumps] + [signal[-1]]):
        slope = lambda s, x, d=float(d): tau * np.exp(-s) * np.append(x[1:], u(s, x) + d)
        x = solve_ivp(slope, (begin, until), x, method="DOP853", rtol=1e-9, atol=1e-12).y[:, -1]
        begin = until
    time_to_go = tau * np.exp(-float(end))
    weight = [float(a(time_to_go) if callable(a) else a) for a in c]
    reached = np.dot(weight, np.append(x, u(float(end), x)))
    return {"miss": abs(float(value) - reached) / (abs(float(value)) or 1)}
