"""x and u of the letter's Example 4 (Fig. 1), for ptc-codegen/tests/lab/simulate.rs.

In time t, in 30 digits, by Gragg's method with extrapolation: another variable, another formulation
and another method than the simulation's. Run with: python3 tools/example4.py (needs mpmath).
"""

from mpmath import exp, mp, mpf, sin

mp.dps = 30
PSI, PHI = mpf(20), mpf("1.1")
TOLERANCE = mpf(10) ** -22
COLUMNS = 10


def control(tau, t, x):
    """u of Theorem 1 for exp with a = 1: -psi x/((tau - t)(|x| - phi |x(0)|)^2)."""
    return -PSI * x / ((tau - t) * (abs(x) - PHI) ** 2)


def rate(tau, t, x):
    """x' = a(x, u, t) + (b + g) u with b = -0.5, g = 1."""
    u = control(tau, t, x)
    a = mpf("0.1") - t**3 * exp(-t) * sin(x / (u + mpf("0.001")))
    return a + u / 2


def midpoint(tau, t, x, step, parts):
    """Gragg's modified midpoint rule."""
    h = step / parts
    before, here = x, x + h * rate(tau, t, x)
    for i in range(1, parts):
        before, here = here, before + 2 * h * rate(tau, t + i * h, here)
    return (before + here + h * rate(tau, t + step, here)) / 2


def extrapolated(tau, t, x, step):
    """The step by extrapolation in h^2, and what its last two columns differ by."""
    rows = []
    for k in range(COLUMNS):
        row = [midpoint(tau, t, x, step, 2 * (k + 1))]
        for j in range(k):
            ratio = (mpf(k + 1) / (k - j)) ** 2
            row.append(row[j] + (row[j] - rows[-1][j]) / (ratio - 1))
        rows.append(row)
    return rows[-1][-1], abs(rows[-1][-1] - rows[-1][-2])


def run(tau, shares):
    t, x, step = mpf(0), mpf(1), mpf("1e-5")
    for share in shares:
        end = tau * mpf(share)
        while t < end:
            step = min(step, end - t)
            new, error = extrapolated(tau, t, x, step)
            grow = 2 if error == 0 else (TOLERANCE / error) ** (mpf(1) / (2 * COLUMNS - 1))
            if error <= TOLERANCE:
                t, x = (end if step == end - t else t + step), new
            step *= min(mpf(2), max(mpf("0.2"), mpf("0.9") * grow))
        yield share, x, control(tau, t, x)


for tau in (1, 2, 5):
    for share, x, u in run(mpf(tau), ("0.01", "0.1", "0.5", "0.9", "0.99")):
        print(f"({tau}.0, {share}, {float(x)!r}, {float(u)!r}),")
