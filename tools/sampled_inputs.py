"""Inputs of plants with several outputs in samples, at 50 digits: tests/data/sampled_inputs.json.

    python3 tools/sampled_inputs.py > tests/data/sampled_inputs.json

needs mpmath. For each output the law is the input w of its sampled chain for which the flat output y,
the combination of the chain that the input moves last, goes on as y(k+n) + sum c_j y(k+j) = 0 with
c_j = (-1)^(n-j) pi[M, M-1, ..., M-j]/(M-j)^(n-j); pi has the zeros -pole. Where these are consecutive integers
s + 1, ..., s + n, M is the samples to go and s, with n samples to go at least; towards the end of other poles such ones
take their place.
With a reference the chain is the tracking error, and r^(n) in the middle of the sample is added to w.
The matrices and derivatives of the plants are written down by hand. Linear plants are sampled by the matrix
exponential, and their chains are rows of the null space of what inputs reach earlier.
"""

import json
import random

from mpmath import cos, expm, factorial, ff, inverse, lu_solve, matrix, mp, mpf, pi as half_turn, sin

mp.dps = 60


def pair(n, h):
    """What a sample of the chain makes of its state and of its input."""
    phi = matrix(n, n)
    gamma = matrix(n, 1)
    for i in range(n):
        gamma[i] = h ** (n - i) / factorial(n - i)
        for j in range(i, n):
            phi[i, j] = h ** (j - i) / factorial(j - i)
    return phi, gamma


def flat(phi, gamma, h):
    """The row c with c D^i Gamma = 0 for i < n - 1 and c D^(n-1) Gamma = h, D = (Phi - I)/h."""
    n = phi.rows
    d = (phi - mp.eye(n)) / h
    columns, now = [], gamma
    for _ in range(n):
        columns.append(now)
        now = d * now
    rows = matrix(n, n)
    for i, column in enumerate(columns):
        for j in range(n):
            rows[i, j] = column[j]
    wanted = matrix(n, 1)
    wanted[n - 1] = h
    return lu_solve(rows, wanted).T


def divided(f, points):
    """The divided difference of f at the points."""
    table = [f(point) for point in points]
    for step in range(1, len(points)):
        for i in range(len(points) - step):
            table[i] = (table[i + 1] - table[i]) / (points[i + step] - points[i])
    return table[0]


def ending(poles, left):
    """The poles with so many samples left, and the M of their formula."""
    n, exponents = len(poles), sorted(-mpf(pole) for pole in poles)
    first = exponents[0]
    if first >= n and first == int(first) and all(p == first + i for i, p in enumerate(exponents)):
        return poles, max(left, n) + int(first) - 1
    if left > max(int(mp.ceil(exponents[-1])) + n - 1, 2 * n):
        return poles, left
    s = max(n, int(mp.ceil(first))) - 1
    return [-mpf(s + i) for i in range(1, n + 1)], max(left, n) + s


def law(poles, left, h, x):
    """w of a chain with so many samples left."""
    n = len(poles)
    poles, left = ending(poles, left)
    phi, gamma = pair(n, h)
    c = flat(phi, gamma, h)
    x = matrix(x)

    def pi(p):
        product = mpf(1)
        for pole in poles:
            product *= p + pole
        return product

    # y(k+n) holds w, and no y before it does.
    sum_, row = mpf(0), c
    for j in range(n):
        points = [mpf(left - i) for i in range(j + 1)]
        coefficient = (-1) ** (n - j) * divided(pi, points) / ff(left - j, n - j)
        sum_ += coefficient * (row * x)[0]
        row = row * phi
    moved = mpf(0)
    power = c
    for _ in range(n - 1):
        power = power * phi
    moved = (power * gamma)[0]
    return -(sum_ + (row * x)[0]) / moved


def tank(x, wanted):
    """h' = q - h/10, c' = p - c (1 + h), e' = (c - e)(1 + h): the second output is e, of order 2."""
    h, c, e = x
    v = wanted([[h], [e, (c - e) * (1 + h)]])
    free = (-c * (1 + h) - (c - e) * (1 + h)) * (1 + h) + (c - e) * (-h / 10)
    q = v[0] + h / 10
    p = (v[1] - free - (c - e) * q) / (1 + h)
    return [q, p]


def two_link(x, wanted):
    """An arm of two links, M(q) q'' + bias = u."""
    m1, m2, l1, l2, grav = mpf(2), mpf("1.5"), mpf("0.6"), mpf("0.5"), mpf("9.81")
    q1, q2, w1, w2 = x
    v = wanted([[q1, w1], [q2, w2]])
    a, b, d = (m1 + m2) * l1**2, m2 * l2**2, m2 * l1 * l2
    weight = m2 * grav * l2 * cos(q1 + q2)
    return [
        (a + b + 2 * d * cos(q2)) * v[0] + (b + d * cos(q2)) * v[1]
        - d * sin(q2) * (2 * w1 * w2 + w2**2) + (m1 + m2) * grav * l1 * cos(q1) + weight,
        (b + d * cos(q2)) * v[0] + b * v[1] + d * sin(q2) * w1**2 + weight,
    ]


def four(x, wanted):
    """Four outputs, whose inputs are solved for: see tests/lab/samples/several_inputs."""
    a, b, b1, c, d, d1 = x
    v = wanted([[a], [b, b1], [c], [d, d1]])
    rows = matrix([[2 + b**2, 1, 0, 0], [0, 3 + a, d, 0], [0, 0, 1, a], [c, 0, 0, 2 - b]])
    free = matrix([-a * c, -b * d1, -(c**2), a])
    return list(lu_solve(rows, matrix(v) - free))


def rails(x, wanted):
    """Two axes of order 3, with the input gains 2 and -1/2."""
    v = wanted([x[:3], x[3:]])
    return [v[0] / 2, -2 * v[1]]


def null_rows(of):
    """Rows that span all c with c of = 0."""
    a, row, pivots = of.T, 0, []
    for column in range(a.cols):
        if row == a.rows:
            break
        best = max(range(row, a.rows), key=lambda i: abs(a[i, column]))
        if abs(a[best, column]) < mpf(10) ** -45:
            continue
        for j in range(a.cols):
            a[row, j], a[best, j] = a[best, j], a[row, j]
        pivot = a[row, column]
        for j in range(a.cols):
            a[row, j] /= pivot
        for i in range(a.rows):
            if i != row:
                factor = a[i, column]
                for j in range(a.cols):
                    a[i, j] -= factor * a[row, j]
        pivots.append(column)
        row += 1
    rows = []
    for free in (j for j in range(a.cols) if j not in pivots):
        c = matrix(1, a.cols)
        c[free] = 1
        for k, column in enumerate(pivots):
            c[column] = -a[k, free]
        rows.append(c)
    return rows


def linear(a, b, outputs, orders, h):
    """The inputs of x' = a x + b u, y = outputs x, whose chains held inputs move exactly."""
    a, b, outputs = ([[mpf(entry) for entry in row] for row in rows] for rows in (a, b, outputs))
    n, m = len(a), len(orders)
    whole = matrix(n + m, n + m)
    for i in range(n):
        for j, entry in enumerate(a[i] + b[i]):
            whole[i, j] = entry * h
    whole = expm(whole)
    phi, gamma = whole[:n, :n], whole[:n, n:]
    d, a = (phi - mp.eye(n)) / h, matrix(a)
    basis, places = matrix(n, n), []
    for k in range(m):
        row = matrix([outputs[k]])
        for i in range(orders[k]):
            basis[len(places), :] = row
            places.append((k, i))
            row = row * a
    back = inverse(basis)
    xi, drift, gain = matrix(n, n), matrix(m, n), matrix(m, m)
    at = 0
    for k, order in enumerate(orders):
        reached = matrix(n, max(m * (order - 1), 1))
        now = gamma
        for i in range(order - 1):
            reached[:, i * m:(i + 1) * m] = now
            now = d * now
        free = null_rows(reached)
        named = [place for place in places if place[1] <= orders[place[0]] - order]
        assert len(free) == len(named)
        system, wanted = matrix(len(free), len(free)), matrix(len(free), 1)
        for i, place in enumerate(named):
            for j, row in enumerate(free):
                system[i, j] = (row * back)[places.index(place)]
            wanted[i] = 1 if place == (k, 0) else 0
        weights = lu_solve(system, wanted)
        row = matrix(1, n)
        for weight, own in zip(weights, free):
            row += weight * own
        z = matrix(order, n)
        for i in range(order):
            z[i, :] = row
            row, last = row * d, row
        drift[k, :] = row
        gain[k, :] = last * gamma / h
        # The differences of the chain of integrators in its states.
        own_phi, own_gamma = pair(order, h)
        own_d, own_row = (own_phi - mp.eye(order)) / h, flat(own_phi, own_gamma, h)
        s = matrix(order, order)
        for i in range(order):
            s[i, :] = own_row
            own_row = own_row * own_d
        xi[at:at + order, :] = inverse(s) * z
        at += order

    def plant(x, wanted):
        x = matrix(x)
        chains = xi * x
        v = wanted([[chains[i] for i, place in enumerate(places) if place[0] == k] for k in range(m)])
        return list(lu_solve(gain, matrix(v) - drift * x))

    return plant


def masses(h):
    """Two masses with springs and a damper between them."""
    return linear(
        [[0, 0, 1, 0], [0, 0, 0, 1], [-40, 25, "-0.25", "0.25"], [50, -50, "0.5", "-0.5"]],
        [[0, 0], [0, 0], ["0.5", 0], [0, 1]], [[1, 0, 0, 0], [0, 1, 0, 0]], [2, 2], h,
    )


def train(h):
    """A chain of order 3 beside one of order 2, each of which moves the other."""
    return linear(
        [[0, 1, 0, 0, 0], [-1, 0, 1, 0, 0], [0, 0, -2, 0, 1], [0, 0, 0, 0, 1], ["0.5", "-0.25", 0, -3, 0]],
        [[0, 0], [0, 0], [1, 0], [0, 0], ["0.25", 1]], [[1, 0, 0, 0, 0], ["0.125", 0, 0, 1, 0]], [3, 2], h,
    )


def levels(h):
    """An unstable plant whose inputs move both outputs at once."""
    return linear([[2, -5], [4, "0.5"]], [[1, "0.25"], ["-0.5", 2]], [[1, "0.5"], [0, 1]], [1, 1], h)


def sine(size, rate, phase):
    """A sine as an expression, and its derivative of an order at a time."""
    text = f"{size}*sin({rate}*t + {phase})"
    size, rate, phase = mpf(size), mpf(rate), mpf(phase)
    return text, lambda order, t: size * rate**order * sin(rate * t + phase + order * half_turn / 2)


def parabola(offset, slope, curve):
    """The same of a parabola."""
    text = f"{offset} + {slope}*t + {curve}*t^2"
    offset, slope, curve = mpf(offset), mpf(slope), mpf(curve)
    return text, lambda order, t: [offset + slope * t + curve * t**2, slope + 2 * curve * t, 2 * curve, 0][order]


# The plant, its poles, samples and period, how large the states are, and what the outputs follow.
CASES = [
    (tank, [[-4], [-3, -4]], 40, mpf("0.25"), [0.5, 20, 20]),
    (tank, [[mpf("-1.25")], [mpf("-3.5"), mpf("-4.25")]], 100, mpf("0.05"), [0.5, 20, 20]),
    (two_link, [[-3, -4], [-3, -4]], 50, mpf("0.04"), [2, 2, 3, 3]),
    (two_link, [[-3, -4], [-6, mpf("-7.5")]], 200, mpf("0.01"), [2, 2, 3, 3]),
    (four, [[-4], [-3, -4], [-5], [mpf("-2.5"), -6]], 60, mpf("0.02"), [1, 1, 2, 1, 1, 2]),
    (tank, [[-4], [-3, -4]], 40, mpf("0.25"), [0.5, 20, 20], [sine("0.3", "0.4", "0"), parabola("2", "-1", "0.25")]),
    (two_link, [[-3, -4], [-6, mpf("-7.5")]], 50, mpf("0.04"), [2, 2, 3, 3], "input"),
    (four, [[-4], [-3, -4], [-5], [mpf("-2.5"), -6]], 60, mpf("0.02"), [1, 1, 2, 1, 1, 2], "input"),
    (rails, [[-4, -5, -6], [-3, mpf("-4.5"), -8]], 40, mpf("0.25"), [1, 2, 3, 1, 2, 3], [sine("2", "3", "1"), sine("0.5", "1.5", "2")]),
    (rails, [[-4, -5, -6], [-3, mpf("-4.5"), -8]], 100, mpf("0.05"), [1, 2, 3, 1, 2, 3], "input"),
    (masses, [[-3, -4], [mpf("-3.5"), -6]], 40, mpf("0.05"), [1, 1, 2, 2]),
    (train, [[-4, -5, -6], [-3, mpf("-4.5")]], 60, mpf("0.1"), [1, 1, 2, 1, 1]),
    (levels, [[-2], [-3]], 30, mpf("0.2"), [1, 1]),
]

# They are sampled by the matrix exponential.
LINEAR = [masses, train, levels]


def main():
    source = random.Random(1)
    cases = []
    for plant, poles, samples, h, scale, *followed in CASES:
        followed = followed[0] if followed else None
        columns = max(map(len, poles)) + 1
        calls = []
        for k in [0, 1, samples // 3, samples // 2, samples - 8, samples - 4, samples - 2, samples - 1, samples + 3]:
            x = [source.uniform(-size, size) for size in scale]
            left = max(samples - k, 0)
            given, now = {}, k * h
            if followed is None:
                r = [[mpf(0)] * columns for _ in poles]
            elif followed == "input":
                r = [[source.uniform(-1, 1) for _ in range(columns)] for _ in poles]
                given = {"r": [[repr(value) for value in row] for row in r]}
            else:
                # The last one is that of the middle of the sample.
                r = [[own(i, now) for i in range(len(p))] + [own(len(p), now + h / 2)]
                     for p, (_, own) in zip(poles, followed)]

            def wanted(chains):
                all_ = []
                for own, chain, row in zip(poles, chains, r):
                    n = len(own)
                    e = [x - mpf(r) for x, r in zip(chain, row)]
                    # A plant that is known at the samples alone is to be at rest n samples early.
                    spare = 0 if plant in LINEAR or plant is rails else n
                    all_.append(law(own, left - spare, h, e) + mpf(row[n]))
                return all_

            inputs = plant(h) if plant in LINEAR else plant
            u = inputs([mpf(value) for value in x], wanted)
            calls.append({
                "k": k,
                "x": [repr(value) for value in x],
                **given,
                "u": [mp.nstr(value, 50) for value in u],
            })
        follows = {} if followed is None else {
            "reference": followed if followed == "input" else [text for text, _ in followed]
        }
        cases.append({
            "plant": plant.__name__,
            "poles": [[mp.nstr(mpf(pole), 10) for pole in own] for own in poles],
            "samples": samples,
            "h": mp.nstr(h, 10),
            **follows,
            "calls": calls,
        })
    print(json.dumps(cases, indent=1))


main()
