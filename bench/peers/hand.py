"""Kernels as one writes them by hand: kappa', the ratios p_k = r_k/r_1, Horner in kappa'.

`hand` is order 3 written out, `hand_loop` any order with the Bell recurrence at each call.
"""

from math import comb

SIGNATURE = (
    "double ptc_u(const double *x, double t, const double *k, double tau, double t0, double a)"
)

# For each mapping: kappa' = q and what the ratios need; p_2 and p_3; p_2..p_n in a loop.
POLYNOMIAL = """    double c[N + 2] = {{1}}, power = 1;
    for (int i = 2; i <= N; i++) {{
        double d[N + 2] = {{0}}, sum = 0;
        for (int j = 0; j < i - 1; j++) {{
            if (j) d[j - 1] += j * c[j];
            d[j + 1] -= (j + {weight}) * c[j];
        }}
        for (int j = i - 1; j >= 0; j--) sum = sum * {y} + (c[j] = d[j]);
        p[i] = (power *= {base}) * sum;
    }}
"""
SCALARS = {
    "exp": "    const double q = 1 / (a * T);\n",
    "rational": "    const double aw = a * T / tau, q = 1 / (aw * T);\n",
    "tan": "    const double h = 1.57079632679489661923 / tau, s = sin(h * T), c = cos(h * T);\n"
    "    const double as = a * s, q = h / (as * s);\n",
    "atanh": "    const double y = (t - t0) / tau, q = 1 / (a * T * (1 + y));\n",
    "algebraic": "    const double y = (t - t0) / tau, v = T * (1 + y) / tau, root = sqrt(v);\n"
    "    const double b = a * root, q = 1 / (b * v * tau);\n",
}
THIRD = {
    "exp": ("-a", "a * a"),
    "rational": ("-2 * aw", "6 * aw * aw"),
    "tan": ("-2 * as * c", "as * as * (6 - 8 * s * s)"),
    "atanh": ("-2 * a * y", "a * a * (6 * y * y - 2)"),
    "algebraic": ("-3 * b * y", "b * b * (12 * y * y - 3 * v)"),
}
LOOP = {
    "exp": "    for (int i = 2; i <= N; i++) p[i] = -a * p[i - 1];\n",
    "rational": "    for (int i = 2; i <= N; i++) p[i] = -i * aw * p[i - 1];\n",
    # sin(k h T)/sin(h T) by its recurrence.
    "tan": "    double u0 = 0, u1 = 1, f = 1;\n"
    "    for (int i = 2; i <= N; i++) {\n"
    "        const double u2 = 2 * c * u1 - u0;\n"
    "        u0 = u1, u1 = u2, f *= -(i - 1) * as, p[i] = f * u1;\n"
    "    }\n",
    "atanh": POLYNOMIAL.format(weight="2", y="y", base="a"),
    # Q_{k+1} = (1 - y^2) Q_k' - (k + 2) y Q_k, k = i - 1.
    "algebraic": POLYNOMIAL.format(weight="i + 1", y="y", base="b"),
}
BELL = """    double B[N + 1][N + 1] = {{1}};
    for (int m = 1; m <= N; m++)
        for (int l = 1; l <= m; l++) {
            double sum = 0;
            for (int i = 1; i <= m - l + 1; i++) sum += C[m - 1][i - 1] * p[i] * B[m - i][l - 1];
            B[m][l] = sum;
        }
    double u = q * k[0] * x[0];
    for (int j = 1; j < N; j++) {
        double row = B[N][j];
        for (int i = j; i < N; i++) row += k[i] * B[i][j];
        u = q * (u + row * x[j]);
    }
    return -u;
}
"""


def _start(mapping):
    return f"{SIGNATURE}\n{{\n    const double T = tau - (t - t0);\n{SCALARS[mapping]}"


def hand(mapping, n):
    """Order 3 written out; nothing for other orders."""
    if n != 3:
        return None
    p2, p3 = THIRD[mapping]
    return (
        f"#include <math.h>\n{_start(mapping)}    const double p2 = {p2}, p3 = {p3};\n"
        "    return -q * ((k[2] + 3 * p2) * x[2]\n"
        "        + q * ((k[1] + k[2] * p2 + p3) * x[1] + q * k[0] * x[0]));\n}\n"
    )


def hand_loop(mapping, n):
    """Any order."""
    rows = ", ".join("{" + ", ".join(str(comb(i, j)) for j in range(i + 1)) + "}" for i in range(n))
    return (
        f"#include <math.h>\n#define N {n}\nstatic const double C[N][N] = {{{rows}}};\n"
        f"{_start(mapping)}    double p[N + 1];\n    p[1] = 1;\n{LOOP[mapping]}{BELL}"
    )
