"""Truncated Taylor series over arrays: extended doubles for grids, mpmath numbers for single points."""

from math import comb

import mpmath
import numpy as np


def call(name, value):
    """An elementary function of an array, in the arithmetic of its elements."""
    if value.dtype == object:
        return np.frompyfunc(getattr(mpmath, name), 1, 1)(value)
    return getattr(np, {"ln": "log"}.get(name, name))(value)


class Series:
    """c[0] + c[1] d + c[2] d^2 + ..., each c[k] an array."""

    def __init__(self, c):
        self.c = list(c)

    @classmethod
    def variable(cls, value, order, slope=1):
        zero = value * 0
        return cls([value, zero + slope] + [zero] * (order - 1))

    def _other(self, other):
        if isinstance(other, Series):
            return other
        zero = self.c[0] * 0
        return Series([zero + other] + [zero] * (len(self.c) - 1))

    def __add__(self, other):
        return Series([a + b for a, b in zip(self.c, self._other(other).c)])

    __radd__ = __add__

    def __neg__(self):
        return Series([-a for a in self.c])

    def __sub__(self, other):
        return self + -self._other(other)

    def __rsub__(self, other):
        return self._other(other) + -self

    def __mul__(self, other):
        if not isinstance(other, Series):
            return Series([a * other for a in self.c])
        return Series(
            [sum(self.c[i] * other.c[k - i] for i in range(k + 1)) for k in range(len(self.c))]
        )

    __rmul__ = __mul__

    def __truediv__(self, other):
        if not isinstance(other, Series):
            return Series([a / other for a in self.c])
        q = []
        for k in range(len(self.c)):
            q.append((self.c[k] - sum(q[i] * other.c[k - i] for i in range(k))) / other.c[0])
        return Series(q)

    def __rtruediv__(self, other):
        return self._other(other) / self

    def _by(self, start, recurrence):
        c = [start]
        for k in range(1, len(self.c)):
            c.append(recurrence(c, k))
        return Series(c)

    def exp(self):
        f = self.c
        return self._by(
            call("exp", f[0]), lambda c, k: sum(i * f[i] * c[k - i] for i in range(1, k + 1)) / k
        )

    def ln(self):
        f = self.c
        return self._by(
            call("ln", f[0]),
            lambda c, k: (f[k] - sum(i * c[i] * f[k - i] for i in range(1, k)) / k) / f[0],
        )

    def power(self, p):
        """self^p for a real p and a positive self."""
        f = self.c
        return self._by(
            call("exp", p * call("ln", f[0])),
            lambda c, k: sum((p * i - (k - i)) * f[i] * c[k - i] for i in range(1, k + 1)) / (k * f[0]),
        )

    def sqrt(self):
        return self.power(self.c[0].flat[0] * 0 + 0.5)

    def atan(self):
        slope = (1 / (1 + self * self)).c
        f = self.c
        return self._by(
            call("atan" if f[0].dtype == object else "arctan", f[0]),
            lambda c, k: sum(i * f[i] * slope[k - i] for i in range(1, k + 1)) / k,
        )

    def derivatives(self):
        """The derivatives of order 1, 2, ..."""
        out, factorial = [], 1
        for k in range(1, len(self.c)):
            factorial *= k
            out.append(self.c[k] * factorial)
        return out


def bell(r, size):
    """BB: entry (i, j) is the partial Bell polynomial B_{i,j}(r_1, ...), i, j = 0..size-1."""
    zero = r[0] * 0
    b = [[zero for _ in range(size)] for _ in range(size)]
    b[0][0] = zero + 1
    for i in range(1, size):
        for j in range(1, i + 1):
            b[i][j] = sum(comb(i - 1, l - 1) * r[l - 1] * b[i - l][j - 1] for l in range(1, i - j + 2))
    return b


def inverse_derivatives(r):
    """Derivatives of the inverse function, from those of the function: BB[r] BB[inverse] = I."""
    b = bell(r, len(r) + 1)
    y = [r[0] * 0, 1 / r[0]]
    for i in range(2, len(r) + 1):
        y.append(-sum(b[i][j] * y[j] for j in range(1, i)) / b[i][i])
    return y[1:]
