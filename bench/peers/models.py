#!/usr/bin/env python3
"""Writes the contestants of `ptc-bench models`: contestants/<name>/model_<design>.c.

Set up as generate.py tells; SymPy and CasADi are enough. Then run from the root of the repository:

    bench/peers/venv/bin/python bench/peers/models.py

Each file is u of a design in examples/ with a model, all parameters numbers. The tools are given the
plant as the design writes it and take the Lie derivatives by themselves. The law v of the chain is
given in Horner's form in 1/T, with its coefficients as numbers: what the mapping costs otherwise is
measured by `ptc-bench peers`.
"""

from math import factorial
from pathlib import Path
from types import SimpleNamespace

import casadi as ca
import sympy as sp

from symbolic import law

HERE = Path(__file__).resolve().parent
SIGNATURE = "void ptc_model(const double *x, double t, double *u)"
Q = sp.Rational


def drive(f, x, u):
    k, j, b, r, l = map(f.number, ("0.03", "2e-5", "1e-5", "1.2", "2e-3"))
    return [x[1], (k * x[2] - b * x[1]) / j, (u - r * x[2] - k * x[1]) / l]


def pendulum(f, x, u):
    grav, l, m, drag = map(f.number, ("9.81", "0.5", "1", "0.02"))
    return [x[1], (u - drag * x[1]) / (m * l**2) - grav / l * f.sin(x[0])]


def cart(f, x, u):
    big, m, l, drag, grav = map(f.number, ("1", "0.2", "0.5", "0.1", "9.81"))
    _, v, angle, rate = x
    sin, cos = f.sin(angle), f.cos(angle)
    return [
        v,
        (u - drag * v + m * sin * (l * rate**2 - grav * cos)) / (big + m * sin**2),
        rate,
        ((big + m) * grav * sin - cos * (u - drag * v + m * l * rate**2 * sin))
        / (l * (big + m * sin**2)),
    ]


def levitation(f, x, u):
    grav, z0, i0, r, l = map(f.number, ("9.81", "0.01", "0.8", "2", "0.02"))
    z, v, i = x
    return [v, grav * (1 - ((1 + i / i0) / (1 + z / z0)) ** 2), (u - r * i) / l]


def two_link(f, x):
    """Inertia and bias."""
    m1, m2, l1, l2, grav = map(f.number, ("2", "1.5", "0.6", "0.5", "9.81"))
    q1, q2, w1, w2 = x
    cross = m2 * l2**2 + m2 * l1 * l2 * f.cos(q2)
    inertia = [[(m1 + m2) * l1**2 + m2 * l2**2 + 2 * m2 * l1 * l2 * f.cos(q2), cross], [cross, m2 * l2**2]]
    hang = m2 * grav * l2 * f.cos(q1 + q2)
    bias = [
        -m2 * l1 * l2 * f.sin(q2) * (2 * w1 * w2 + w2**2) + (m1 + m2) * grav * l1 * f.cos(q1) + hang,
        m2 * l1 * l2 * f.sin(q2) * w1**2 + hang,
    ]
    return inertia, bias


# The plant, its number of states, poles of the law, mapping, rate and tau.
DESIGNS = {
    "drive": (drive, 3, [-4, -5, -6], "exp", 1, Q("0.4")),
    "pendulum": (pendulum, 2, [-3, -4], "exp", 1, Q("0.8")),
    "cart": (cart, 4, [-3, -4], "exp", 1, 2),
    "levitation": (levitation, 3, [-4, -5, -6], "exp", 1, Q("0.5")),
    "two_link": (two_link, 4, [-1, Q("-1.5")], "rational", Q("1/20"), 20),
}


def coefficients(poles, mapping, a, tau):
    """The coefficient of w^p x_j, w = 1/T, in v of the chain: {(p, j): number}."""
    n, w, s = len(poles), sp.Symbol("w"), sp.Symbol("s")
    x = sp.symbols(f"x:{n}")
    k = sp.Poly(sp.prod(s - pole for pole in poles), s).all_coeffs()[:0:-1]
    if mapping == "exp":
        slope, r = w / a, [(-1) ** (i - 1) * a**i / w for i in range(1, n + 1)]
    else:
        slope = tau * w**2 / a
        r = [(-1) ** (i - 1) * factorial(i) * (a / tau) ** i / w ** (i + 1) for i in range(1, n + 1)]
    terms = sp.Poly(sp.expand(law(n, r, slope, x, k)), w, *x).terms()
    return {(powers[0], powers[1:].index(1)): value for powers, value in terms}


def chain(f, terms, w, x):
    """v by Horner's rule."""
    value = 0
    for power in range(max(power for power, _ in terms), 0, -1):
        value = (value + sum(f.number(c) * x[j] for (p, j), c in terms.items() if p == power)) * w
    return value


def parts(design, f, x, w):
    """v, L_f^r h and L_g L_f^(r-1) h of a plant with one output; of the arm every M v and bias."""
    plant, _, poles, mapping, a, tau = DESIGNS[design]
    terms, n = coefficients(poles, mapping, a, tau), len(poles)
    if design == "two_link":
        inertia, bias = plant(f, x)
        v = [chain(f, terms, w, [x[i], x[i + 2]]) for i in range(2)]
        return [row[0] * v[0] + row[1] * v[1] for row in inertia], bias
    drift, gain = f.affine(lambda u: plant(f, x, u))
    outputs = [x[0]]
    for _ in range(n):
        outputs.append(f.along(outputs[-1], drift))
    return chain(f, terms, w, outputs[:n]), outputs[n], f.along(outputs[n - 1], gain)


def with_sympy(design, simplified):
    """cse and ccode, powers as products: of (v - f)/g, or of v/g - f/g with both parts simplified."""
    from sympy.codegen.rewriting import create_expand_pow_optimization

    count = DESIGNS[design][1]
    x, w = sp.symbols(f"x:{count}", real=True), sp.Symbol("w", positive=True)

    def affine(plant):
        u = sp.Symbol("u", real=True)
        return [rate.subs(u, 0) for rate in plant(u)], [sp.diff(rate, u) for rate in plant(u)]

    def along(e, rates):
        return sum(sp.diff(e, one) * rate for one, rate in zip(x, rates))

    functions = SimpleNamespace(sin=sp.sin, cos=sp.cos, number=sp.Rational, along=along, affine=affine)
    found = parts(design, functions, x, w)
    better = sp.simplify if simplified else lambda e: e
    if design == "two_link":
        found = [better(moved) + better(bias) for moved, bias in zip(*found)]
    else:
        v, drift, gain = found
        found = [v * better(1 / gain) - better(drift / gain)] if simplified else [(v - drift) / gain]
    names = sp.numbered_symbols("c")
    lines, results = sp.cse([sp.N(u, 17) for u in found], symbols=names)
    text = lambda e: sp.ccode(create_expand_pow_optimization(8)(e))
    body = "".join(f"    const double x{i} = x[{i}];\n" for i in range(count))
    body += "".join(f"    const double {name} = {text(value)};\n" for name, value in lines)
    body += "".join(f"    u[{i}] = {text(value)};\n" for i, value in enumerate(results))
    return (
        f"/* SymPy {sp.__version__} */\n#include <math.h>\n{SIGNATURE}\n{{\n"
        f"    const double w = 1 / ({float(DESIGNS[design][-1])} - t);\n{body}}}\n"
    )


def with_casadi(design):
    """SX, its own derivatives, cse, CodeGenerator."""
    count = DESIGNS[design][1]
    # As an input, for CasADi turns v*(1/T) into v/T.
    x, w = ca.SX.sym("x", count), ca.SX.sym("w")

    def affine(plant):
        u = ca.SX.sym("u")
        rates = ca.vertcat(*plant(u))
        return ca.vertsplit(ca.substitute(rates, u, 0)), ca.vertsplit(ca.jacobian(rates, u))

    def along(e, rates):
        return ca.jtimes(e, x, ca.vertcat(*rates))

    functions = SimpleNamespace(sin=ca.sin, cos=ca.cos, number=float, along=along, affine=affine)
    found = parts(design, functions, [x[i] for i in range(count)], w)
    if design == "two_link":
        u = [moved + bias for moved, bias in zip(*found)]
    else:
        v, drift, gain = found
        u = [(v - drift) / gain]
    function = ca.Function("model", [x, w], [ca.cse(ca.vertcat(*u))])
    generator = ca.CodeGenerator("model.c")
    generator.add(function)
    return f"""/* CasADi {ca.__version__} */
#define CASADI_SYMBOL_EXPORT static
{generator.dump()}
{SIGNATURE}
{{
    const double w = 1 / ({float(DESIGNS[design][-1])} - t), *in[] = {{x, &w}};
    double *out[] = {{u}}, work[{max(function.sz_w(), 1)}];
    model(in, out, 0, work, 0);
}}
"""


CONTESTANTS = {
    "sympy": lambda design: with_sympy(design, simplified=False),
    "sympy_simplified": lambda design: with_sympy(design, simplified=True),
    "casadi": with_casadi,
}


def main():
    for name, make in CONTESTANTS.items():
        for design in DESIGNS:
            path = HERE / "contestants" / name / f"model_{design}.c"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(make(design))
            print(f"{path.relative_to(HERE)}: {path.stat().st_size} bytes", flush=True)


if __name__ == "__main__":
    main()
