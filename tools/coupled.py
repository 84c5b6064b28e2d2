"""u of plants with several inputs by the definition, in 50 digits: the data of ptc-codegen's tests.

    python3 tools/coupled.py > ptc-codegen/tests/library/models/coupled.txt

A line is the name of a plant, t, its state and u. The law is Theorem 1 with BB_n as it is defined, and the
inputs solve linear equations by elimination. Needs mpmath.
"""

import random

from mpmath import cos, lu_solve, matrix, mp, mpf, sin

mp.dps = 50


def exp_law(x, gains, tau, t):
    """kappa = -ln(T/tau), a = 1, so that kappa' = 1/T, r_1 = T and r_2 = -T."""
    to_go = tau - t
    if len(x) == 1:
        return -gains[0] * x[0] / to_go
    xi = [x[0], to_go * x[1]]
    return (-gains[0] * xi[0] - gains[1] * xi[1] + to_go * x[1]) / to_go**2


def rational_law(x, gains, tau, t, a):
    """kappa = Dt/(a T): r_1 = a T^2/tau, r_2 = -2 (a/tau)^2 T^3."""
    to_go = tau - t
    slope = tau / (a * to_go**2)
    xi = [x[0], x[1] / slope]
    second = -2 * (a / tau) ** 2 * to_go**3
    return slope**2 * (-gains[0] * xi[0] - gains[1] * xi[1] - second * x[1])


def two_link(t, x):
    q1, q2, w1, w2 = x
    m1, m2, l1, l2, g = mpf(2), mpf("1.5"), mpf("0.6"), mpf("0.5"), mpf("9.81")
    v = [rational_law(s, [mpf("1.5"), mpf("2.5")], mpf(20), t, mpf(1) / 20) for s in ([q1, w1], [q2, w2])]
    c2, s2 = cos(q2), sin(q2)
    big = [(m1 + m2) * l1**2 + m2 * l2**2 + 2 * m2 * l1 * l2 * c2, m2 * l2**2 + m2 * l1 * l2 * c2]
    small = [big[1], m2 * l2**2]
    tip = m2 * g * l2 * cos(q1 + q2)
    first = -m2 * l1 * l2 * s2 * (2 * w1 * w2 + w2**2) + (m1 + m2) * g * l1 * cos(q1) + tip
    second = m2 * l1 * l2 * s2 * w1**2 + tip
    return [big[0] * v[0] + big[1] * v[1] + first, small[0] * v[0] + small[1] * v[1] + second]


def mix(t, x):
    """p'' = -v + (2 + sin p) a + h b, h' = v h + h a + (2 + h^2) b."""
    p, v, h = x
    wanted = [exp_law([p, v], [20, 9], mpf(1), t) + v, exp_law([h], [3], mpf(1), t) - v * h]
    return list(lu_solve(matrix([[2 + sin(p), h], [h, 2 + h**2]]), matrix(wanted)))


def unicycle(t, x):
    """The position of what moves with x' = s cos c, y' = s sin c, s' = a, c' = w."""
    px, py, s, c = x
    wanted = [exp_law(e, [20, 9], mpf(1), t) for e in ([px, s * cos(c)], [py, s * sin(c)])]
    return list(lu_solve(matrix([[cos(c), -s * sin(c)], [sin(c), s * cos(c)]]), matrix(wanted)))


def three(t, x):
    p, q, r = x
    rates = [exp_law([e], [3], mpf(1), t) for e in x]
    wanted = [rates[0] - sin(q), rates[1] + p * r, rates[2]]
    return list(lu_solve(matrix([[3, p, q], [sin(r), 4, p], [q, r, 5]]), matrix(wanted)))


PLANTS = [("two_link", two_link, 4, 18), ("mix", mix, 3, 0.95), ("unicycle", unicycle, 4, 0.95), ("three", three, 3, 0.95)]

if __name__ == "__main__":
    draw = random.Random(1)
    for name, plant, states, until in PLANTS:
        for _ in range(25):
            t = draw.uniform(0, until)
            x = [draw.uniform(-1, 1) for _ in range(states)]
            u = plant(mpf(t), [mpf(value) for value in x])
            numbers = [repr(t), *(repr(value) for value in x), *(mp.nstr(value, 25) for value in u)]
            print(name, *numbers)
