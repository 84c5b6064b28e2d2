"""Zero dynamics of textbook plants at their rest points: tests/data/zero_dynamics.json.

    python3 tools/zero_dynamics.py > tests/data/zero_dynamics.json

needs SymPy. The relative degree is that of the Lie derivatives L_g L_f^(r-1) h. The rest point solves f(x, u) = 0
and h(x) = r: a guess that does so exactly, or Newton's iteration from it, at 50 digits. The roots are the finite
zeros of the linearised plant there, those of det [A - s I, B; C, 0], which needs no normal form.
"""

import json

import sympy as sp
from mpmath import mp

mp.dps = 50

# name, states, output, its value, rates, guess of the rest point with u.
PLANTS = [
    ("pendulum", "q w", "q", "1/2", {"q": "w", "w": "-10*sin(q) - w/5 + u"}, [0.5, 0, 5]),
    ("cart and pole, position", "x v q w", "x", "0",
     {"x": "v", "v": "(u + 0.1*w^2*sin(q) - 2*sin(q)*cos(q))/(1 + 0.2*sin(q)^2)", "q": "w",
      "w": "2*(-u*cos(q) - 0.1*w^2*sin(q)*cos(q) + 12*sin(q))/(1 + 0.2*sin(q)^2)"}, [0, 0, 0, 0, 0]),
    ("cart and pole, angle", "x v q w", "q", "0",
     {"x": "v", "v": "(u - v + 0.1*w^2*sin(q) - 2*sin(q)*cos(q))/(1 + 0.2*sin(q)^2)", "q": "w",
      "w": "2*(-(u - v)*cos(q) - 0.1*w^2*sin(q)*cos(q) + 12*sin(q))/(1 + 0.2*sin(q)^2)"}, [0, 0, 0, 0, 0]),
    ("crane, position", "x v q w", "x", "1",
     {"x": "v", "v": "u", "q": "w", "w": "-10*sin(q) - w/10 - u*cos(q)"}, [1, 0, 0, 0, 0]),
    ("crane without damping", "x v q w", "x", "1",
     {"x": "v", "v": "u", "q": "w", "w": "-10*sin(q) - u*cos(q)"}, [1, 0, 0, 0, 0]),
    ("ball and beam", "r v q w", "r", "0",
     {"r": "v", "v": "5/7*(r*w^2 - 9.81*sin(q))", "q": "w", "w": "u"}, [0, 0, 0, 0, 0]),
    ("synchronous machine", "d w e", "d", "1/2",
     {"d": "w", "w": "10*(1 - e*sin(d)) - 0.5*w", "e": "-0.2*e + 0.1*cos(d) + 0.2*u"}, [0.5, 0, 2, 2]),
    ("Van de Vusse reactor, product", "a b", "b", "1",
     {"a": "-50*a - 10*a^2 + u*(10 - a)", "b": "50*a - 100*b - u*b"}, [2.4, 1, 20]),
    ("Van de Vusse reactor, feed", "a b", "a", "3",
     {"a": "-50*a - 10*a^2 + u*(10 - a)", "b": "50*a - 100*b - u*b"}, [3, 1.1, 34]),
    ("stirred tank, temperature", "c T", "T", "2",
     {"c": "-c + 0.1*(1 - c)*exp(T/(1 + T/20))",
      "T": "-T + 0.8*(1 - c)*exp(T/(1 + T/20)) - 0.3*(T - u)"}, [0.4, 2, -5]),
    ("quadrotor, one axis", "x v q w m", "x", "1",
     {"x": "v", "v": "9.81*tan(q)", "q": "w", "w": "20*m", "m": "(u - m)/0.05"}, [1, 0, 0, 0, 0, 0]),
    ("vertical take-off, side force", "y v q w", "y", "0",
     {"y": "v", "v": "-9.81*sin(q) + 0.1*u*cos(q)", "q": "w", "w": "u"}, [0, 0, 0, 0, 0]),
    ("magnetic levitation, position", "x v i", "x", "0.01",
     {"x": "v", "v": "9.81 - 1e-4*i^2/x^2/0.05", "i": "(u - 2*i)/0.1"}, [0.01, 0, 0.7, 1.4]),
    ("magnetic levitation, current", "x v i", "i", "1/2",
     {"x": "v", "v": "9.81 - 1e-4*i^2/x^2/0.05", "i": "(u - 2*i)/0.1"}, [0.007, 0, 0.5, 1]),
    ("oscillator with a rotor", "z s q w", "q", "0",
     {"z": "s", "s": "(-z + 0.2*(w^2*sin(q) - u*cos(q)))/(1 - 0.04*cos(q)^2)", "q": "w",
      "w": "(u - 0.2*cos(q)*(-z + 0.2*w^2*sin(q)))/(1 - 0.04*cos(q)^2)"}, [0, 0, 0, 0, 0]),
    ("induction motor, fed by currents", "p w", "w", "100",
     {"p": "-5*p + 2", "w": "80*p*u - 0.4*w"}, [0.4, 100, 1.25]),
    ("series motor", "i w", "w", "10",
     {"i": "(u - 2*i - 0.5*i*w)/0.1", "w": "(0.5*i^2 - 0.2*w)/0.05"}, [2, 10, 14]),
    ("two tanks, upper level", "a b", "a", "1",
     {"a": "u - 0.5*sqrt(a)", "b": "0.5*sqrt(a) - 0.4*sqrt(b)"}, [1, 1.5, 0.5]),
    ("two tanks, lower level", "a b", "b", "1",
     {"a": "u - 0.5*sqrt(a)", "b": "0.5*sqrt(a) - 0.4*sqrt(b)"}, [0.64, 1, 0.4]),
    ("aircraft, height by elevator", "a q p h", "h", "0",
     {"a": "q - 0.8*a - 0.06*u", "q": "-4*a - 1.2*q - 6*u", "p": "q", "h": "50*(p - a)"}, [0, 0, 0, 0, 0]),
    ("elastic joint, motor", "q w m n", "m", "1/2",
     {"q": "w", "w": "-5*sin(q) + 40*(m - q) - 0.5*w", "m": "n", "n": "u - 40*(m - q)"},
     [0.45, 0, 0.5, 0, 2]),
    ("elastic joint, link", "q w m n", "q", "1/2",
     {"q": "w", "w": "-5*sin(q) + 40*(m - q) - 0.5*w", "m": "n", "n": "u - 40*(m - q)"},
     [0.5, 0, 0.56, 0, 2.4]),
    ("pendulum with a wheel", "q w s", "q", "0",
     {"q": "w", "w": "20*sin(q) - u", "s": "10*u - 0.1*s"}, [0, 0, 0, 0]),
    ("boost converter, voltage", "i v", "v", "20",
     {"i": "(10 - (1 - u)*v)/0.01", "v": "((1 - u)*i - v/10)/0.001"}, [4, 20, 0.5]),
    ("boost converter, current", "i v", "i", "4",
     {"i": "(10 - (1 - u)*v)/0.01", "v": "((1 - u)*i - v/10)/0.001"}, [4, 20, 0.5]),
    ("bioreactor, substrate", "b s", "s", "0.2",
     {"b": "0.5*s/(0.2 + s)*b - u*b", "s": "u*(4 - s) - 0.5*s/(0.2 + s)*b/0.5"}, [1.9, 0.2, 0.25]),
    ("predator and prey", "x y", "y", "1.2", {"x": "x*(1 - y)", "y": "y*(x - 1) + u"}, [0, 1.2, 1.2]),
    ("glucose by insulin, its effect", "g e i", "e", "1/100",
     {"g": "-0.03*g - e*(g + 80)", "e": "-0.02*e + 1e-3*i", "i": "-0.1*i + u"}, [-20, 0.01, 0.2, 0.02]),
    ("Lorenz system, driven", "x y z", "x", "0",
     {"x": "10*(y - x) + u", "y": "28*x - y - x*z", "z": "x*y - 8/3*z"}, [0, 0, 0, 0]),
    ("hydro turbine with its gate", "g q w", "w", "0",
     {"g": "(u - g)/0.2", "q": "(g - q)/0.5", "w": "(3*q - 2*g - w)/8"}, [0, 0, 0, 0]),
]


def expression(text):
    return sp.sympify(text.replace("^", "**"), locals=NAMES, rational=True)


def degree(rates, through, output, states):
    """The relative degree: how often the output is differentiated until u is in it."""
    for order in range(1, len(states) + 1):
        slopes = [sp.diff(output, x) for x in states]
        if sp.simplify(sum(s * b for s, b in zip(slopes, through))) != 0:
            return order
        output = sum(s * f for s, f in zip(slopes, rates))
    raise ValueError("u does not move the output")


def coefficients(a, b, c):
    """det [A - s I, B; C, 0] in powers of s, through its values at integers."""
    n = a.shape[0]
    whole = lambda s: sp.Matrix(sp.BlockMatrix([[a - s * sp.eye(n), b], [c, sp.zeros(1, 1)]]))
    s = sp.Symbol("s")
    values = [(at, whole(sp.Integer(at)).det(method="berkowitz")) for at in range(n + 1)]
    return sp.Poly(sp.interpolate(values, s), s)


def examined(name, states, output, value, rates, guess):
    global NAMES
    names = states.split()
    NAMES = {word: sp.Symbol(word) for word in [*names, "u"]}
    x, u = [NAMES[word] for word in names], NAMES["u"]
    f = [expression(rates[word]) for word in names]
    h = expression(output) - expression(value)
    order = degree([e.subs(u, 0) for e in f], [sp.diff(e, u) for e in f], h, x)
    design = {"states": names, "output": output, "reference": value, "dynamics": rates}
    found = {"name": name, "design": design, "degree": order}
    unknowns = [*x, u]
    rests = all(e.subs(dict(zip(unknowns, guess))) == 0 for e in [*f, h])
    rest = guess if rests else sp.nsolve([*f, h], unknowns, guess, prec=50, verify=True)
    at = {of: sp.nsimplify(sp.Float(v, 40), rational=True) for of, v in zip(unknowns, rest)}
    number = lambda e: sp.Rational(sp.nsimplify(sp.N(sp.sympify(e).subs(at), 40), rational=True))
    a = sp.Matrix([[number(sp.diff(e, of)) for of in x] for e in f])
    b = sp.Matrix([number(sp.diff(e, u)) for e in f])
    c = sp.Matrix([[number(sp.diff(h, of)) for of in x]])
    polynomial = coefficients(a, b, c)
    # The rest point is one to 40 digits: what is far below that is 0.
    kept = [polynomial.coeff_monomial(sp.Symbol("s") ** i) for i in range(len(x) - order + 1)]
    size = max(abs(v) for v in polynomial.all_coeffs()) if polynomial.all_coeffs() else 0
    small = [0 if abs(v) <= size * sp.Rational(1, 10**30) else v for v in kept]
    singular = small[-1] == 0
    roots = [] if singular or len(small) < 2 else mp.polyroots(
        [mp.mpf(v.p) / v.q if v else mp.mpf(0) for v in map(sp.Rational, reversed(small))],
        maxsteps=500, extraprec=400)
    return {
        **found,
        "singular": bool(singular),
        "rest": [float(v) for v in rest],
        "roots": sorted(([float(mp.re(r)), float(mp.im(r))] for r in roots), reverse=True),
    }


print("[")
print(",\n".join(json.dumps(examined(*plant)) for plant in PLANTS))
print("]")
