"""Other tools' C for the linear law from the mapping alone, as their documentation has one do it.

Each takes kappa and mu as they are in the paper, its own derivatives for r_k, the textbook
recurrence for the Bell polynomials, and its own elimination of common subexpressions.
"""

from math import comb, pi

from hand import SIGNATURE

# kappa(dt) and mu(s), written with the functions of one library.
MAPPINGS = {
    "exp": (lambda f, d, tau, a: -f.log(1 - d / tau) / a,
            lambda f, s, tau, a: tau * (1 - f.exp(-a * s))),
    "rational": (lambda f, d, tau, a: d / (a * (tau - d)),
                 lambda f, s, tau, a: tau * a * s / (1 + a * s)),
    "tan": (lambda f, d, tau, a: f.tan(f.pi * d / (2 * tau)) / a,
            lambda f, s, tau, a: 2 * tau / f.pi * f.atan(a * s)),
    "atanh": (lambda f, d, tau, a: f.atanh(d / tau) / a,
              lambda f, s, tau, a: tau * f.tanh(a * s)),
    "algebraic": (lambda f, d, tau, a: d / (a * f.sqrt(tau * tau - d * d)),
                  lambda f, s, tau, a: tau * a * s / f.sqrt(1 + a * a * s * s)),
}


def derivatives(route, mapping, n, f, d, s, tau, a, diff, subs):
    """kappa' and [r_1, ..., r_n]: by mu, or by r_{k+1} = r_1 dr_k/dDt."""
    kappa, mu = MAPPINGS[mapping]
    kappa, mu = kappa(f, d, tau, a), mu(f, s, tau, a)
    slope = diff(kappa, d)
    if route == "diff":
        r = [1 / slope]
        while len(r) < n:
            r.append(r[0] * diff(r[-1], d))
        return slope, r
    r = [diff(mu, s)]
    while len(r) < n:
        r.append(diff(r[-1], s))
    return slope, [subs(one, s, kappa) for one in r]


def law(n, r, slope, x, k):
    """u = kappa'^n (-(k . BB_n x) - b_n . x)."""
    bell = [[1] + [0] * n] + [[0] * (n + 1) for _ in range(n)]
    for m in range(1, n + 1):
        for j in range(1, m + 1):
            bell[m][j] = sum(comb(m - 1, i - 1) * r[i - 1] * bell[m - i][j - 1]
                             for i in range(1, m - j + 2))
    rows = [sum(bell[i][j] * x[j] for j in range(n)) for i in range(n + 1)]
    return slope**n * (-sum(k[i] * rows[i] for i in range(n)) - rows[n])


def _function(n, lines, result):
    names = "".join(f"    const double x{i} = x[{i}], k{i} = k[{i}];\n" for i in range(n))
    body = "".join(f"    const double {name} = {value};\n" for name, value in lines)
    return (f"#include <math.h>\n{SIGNATURE}\n{{\n{names}    const double dt = t - t0;\n"
            f"{body}    return {result};\n}}\n")


def _sympy(mapping, n, route):
    import sympy as sp

    x, k = sp.symbols(f"x:{n}", real=True), sp.symbols(f"k:{n}", real=True)
    tau, a = sp.symbols("tau a", positive=True)
    d, s = sp.symbols("dt s", real=True)
    slope, r = derivatives(route, mapping, n, sp, d, s, tau, a, sp.diff, lambda e, v, to: e.subs(v, to))
    return sp, x, k, slope, r


def sympy_cse(mapping, n):
    """Plain: the whole of u, cse, ccode."""
    sp, x, k, slope, r = _sympy(mapping, n, "diff")
    lines, (u,) = sp.cse([law(n, r, slope, x, k)])
    return _function(n, [(name, sp.ccode(e)) for name, e in lines], sp.ccode(u))


def sympy_tuned(mapping, n):
    """r_k simplified and kept as temporaries, cse, integer powers written as products."""
    sp, x, k, slope, r = _sympy(mapping, n, "mu")
    from sympy.codegen.rewriting import create_expand_pow_optimization

    text = lambda e: sp.ccode(create_expand_pow_optimization(2 * n)(e))
    names = sp.symbols(f"r1:{n + 1} slope", real=True)
    first, r = sp.cse([sp.simplify(e) for e in [*r, slope]], symbols=sp.numbered_symbols("c"))
    then, (u,) = sp.cse([law(n, names[:n], names[n], x, k)], symbols=sp.numbered_symbols("d"))
    return _function(n, [(name, text(e)) for name, e in [*first, *zip(names, r), *then]], text(u))


def casadi(mapping, n, route):
    """SX, cse, Function.generate."""
    import casadi as ca

    ca.pi = pi
    x, k = ca.SX.sym("x", n), ca.SX.sym("k", n)
    tau, a, t, t0, d, s = (ca.SX.sym(name) for name in ("tau", "a", "t", "t0", "d", "s"))
    slope, r = derivatives(route, mapping, n, ca, d, s, tau, a, ca.jacobian, ca.substitute)
    u = law(n, r, slope, [x[i] for i in range(n)], [k[i] for i in range(n)])
    u = ca.cse(ca.substitute(u, d, t - t0))
    function = ca.Function("peer", [x, t, k, tau, t0, a], [u])
    generator = ca.CodeGenerator("peer.c")
    generator.add(function)
    return generator.dump() + f"""
{SIGNATURE}
{{
    const double *in[] = {{x, &t, k, &tau, &t0, &a}};
    double u, *out[] = {{&u}}, work[{max(function.sz_w(), 1)}];
    peer(in, out, 0, work, 0);
    return u;
}}
"""


def symforce(mapping, n, route):
    """C++ by SymForce's own generator; scalars only, so Eigen is not needed."""
    import logging
    import tempfile
    from pathlib import Path

    logging.disable(logging.WARNING)
    import symforce as base

    base.set_symbolic_api("symengine")
    import symforce.symbolic as sf
    from symforce import codegen
    from symforce.values import Values

    x, k = [[sf.Symbol(f"{v}{i}") for i in range(n)] for v in "xk"]
    t, tau, t0, a, d, s = (sf.Symbol(name) for name in ("t", "tau", "t0", "a", "d", "s"))
    subs = lambda e, v, to: e.subs(v, to)
    slope, r = derivatives(route, mapping, n, sf, d, s, tau, a, lambda e, v: e.diff(v), subs)
    u = law(n, r, slope, x, k).subs(d, t - t0)
    # The linker keeps one of several templates that are named alike.
    name = f"{route}_{mapping}_{n}"
    inputs = Values(**{str(v): v for v in [*x, *k, t, tau, t0, a]})
    one = codegen.Codegen(inputs, Values(u=u), codegen.CppConfig(), name=name, return_key="u")
    with tempfile.TemporaryDirectory() as folder:
        files = one.generate_function(output_dir=folder, skip_directory_nesting=True).generated_files
        text = Path(files[0]).read_text().replace("<Eigen/Core>", "<cmath>")
    class_name = "".join(part.capitalize() for part in name.split("_"))
    arguments = [f"{v}[{i}]" for v in "xk" for i in range(n)] + ["t", "tau", "t0", "a"]
    return f'{text}\nextern "C" {SIGNATURE} {{\n    return sym::{class_name}<double>({", ".join(arguments)});\n}}\n'
