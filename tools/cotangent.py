#!/usr/bin/env python3
"""Coefficients of th*cot(th) as a polynomial in z = (2*th/pi)^2 on [0, 1].

Chebyshev interpolation of (th*cot(th) - 1)/z with 50 digits, for ptc-codegen/src/lower/cotangent.rs.
Run: python3 -m pip install mpmath && python3 tools/cotangent.py
"""
from mpmath import cos, cot, lu_solve, matrix, mp, mpf, nstr, pi, polyval, sqrt

mp.dps = 50


def shape(z):
    """th*cot(th)"""
    th = pi * sqrt(z) / 2
    return th * cot(th)


def interpolate(degree):
    count = degree + 1
    nodes = [(1 + cos(pi * (2 * k + 1) / (2 * count))) / 2 for k in range(count)]
    system = matrix(count, count)
    values = matrix(count, 1)
    for i, node in enumerate(nodes):
        for j in range(count):
            system[i, j] = node**j
        values[i] = (shape(node) - 1) / node
    return list(lu_solve(system, values))


for name, degree in (("double", 14), ("single", 7)):
    tail = interpolate(degree)
    points = [mpf(i) / 1000 for i in range(1, 1001)]
    error = max(abs(shape(z) - 1 - z * polyval(tail[::-1], z)) for z in points)
    print(f"{name}: largest error on [0, 1]: {nstr(error, 3)}")
    for coefficient in [mpf(1), *tail]:
        print(f'    "{nstr(coefficient, 25)}",')
