"""u of plants with several inputs by the definition, in 50 digits: the data of ptc-codegen's tests.

    python3 tools/coupled.py > ptc-codegen/tests/lab/models/coupled.txt

A line is the name of a plant, t, its state and u. The law is Theorem 1 with BB_n as it is defined, and the
inputs solve linear equations by elimination. Needs mpmath.
"""

import random

from mpmath import cos, lu_solve, matrix, mp, mpf, sin, tan

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


def four(t, x):
    """Dense but for zeros where the first pivots would be."""
    p, q, r, s = x
    rates = [exp_law([e], [3], mpf(1), t) for e in x]
    wanted = [rates[0], rates[1] - p * r, rates[2], rates[3] - cos(s)]
    rows = [[0, sin(q), 3, r], [2, p, 0, 1], [r, 3 + q**2, s, 0], [1, 0, -p, 4]]
    return list(lu_solve(matrix(rows), matrix(wanted)))


def quadrotor(t, x):
    """Height and Euler angles of a rigid body, by the thrust beyond its weight and three moments."""
    z, vz, roll, pitch, yaw, p, q, r = x
    m, jx, jy, jz, g = mpf("1.2"), mpf("0.02"), mpf("0.025"), mpf("0.04"), mpf("9.81")
    s, c, tp, cp = sin(roll), cos(roll), tan(pitch), cos(pitch)
    to_rates = [[1, s * tp, c * tp], [0, c, -s], [0, s / cp, c / cp]]
    rate, tilt, turn = [sum(w * o for w, o in zip(row, (p, q, r))) for row in to_rates]
    # What the angles' rates change by while the moments are 0.
    spin = [(jy - jz) * q * r / jx, (jz - jx) * p * r / jy, (jx - jy) * p * q / jz]
    along = q * s + r * c
    across = q * c - r * s
    changes = [
        rate * tp * across + tilt * along / cp**2,
        -rate * along,
        rate * across / cp + tilt * along * tp / cp,
    ]
    drift = [change + sum(w * o for w, o in zip(row, spin)) for change, row in zip(changes, to_rates)]
    laws = [exp_law(e, [20, 9], mpf(2), t) for e in ([z, vz], [roll, rate], [pitch, tilt], [yaw, turn])]
    moments = lu_solve(matrix(to_rates), matrix([law - f for law, f in zip(laws[1:], drift)]))
    thrust = m * (laws[0] + g) / (c * cp) - m * g
    return [thrust, *(j * moment for j, moment in zip((jx, jy, jz), moments))]


PLANTS = [
    ("two_link", two_link, 4, 18),
    ("mix", mix, 3, 0.95),
    ("unicycle", unicycle, 4, 0.95),
    ("three", three, 3, 0.95),
    ("four", four, 4, 0.95),
    ("quadrotor", quadrotor, 8, 1.9),
]

if __name__ == "__main__":
    draw = random.Random(1)
    for name, plant, states, until in PLANTS:
        for _ in range(25):
            t = draw.uniform(0, until)
            x = [draw.uniform(-1, 1) for _ in range(states)]
            u = plant(mpf(t), [mpf(value) for value in x])
            numbers = [repr(t), *(repr(value) for value in x), *(mp.nstr(value, 25) for value in u)]
            print(name, *numbers)
