"""Designs for `check` just inside and just outside of what each check asks."""

import random
import subprocess
from math import pi, sqrt

import numpy as np
from scipy.linalg import expm
from scipy.optimize import minimize_scalar

import rates
from case import Case
from draw import decimal, draw_mapping, draw_poles, pole_text
from loop import Loop
from mapping import FAMILIES

NEAR = [0.05, 0.02, -0.02, -0.05]


def controller(source, most):
    """A loop in a family or in another spelling of it, tau, and the words of both."""
    n = source.randint(1, most)
    made = draw_mapping(source, source.choice(FAMILIES))
    poles = draw_poles(source, n, made.rho)
    tau = decimal(source, 0.3, 3)
    key, value = source.choice(made.spellings).split(" = ", 1)
    words = ["--n", str(n), f"--{key}={value.strip(chr(34))}", f"--tau={tau}",
             "--poles=" + ",".join(pole_text(*pole).strip('"') for pole in poles)]
    return Loop(n, made, poles), float(tau), words


def gains_at(loop, tau, w):
    """The rows of u over x at times-to-go w tau."""
    n = loop.n
    _, _, rows = loop.outputs(np.asarray(w, dtype=np.longdouble))
    row = np.zeros((len(rows), n), dtype=np.longdouble)
    for j in reversed(range(n)):
        others = (row[:, j + 1 :] * rows[:, j + 1 : n, j]).sum(axis=1)
        row[:, j] = (rows[:, n, j] - others) / rows[:, j, j]
    return (row * np.longdouble(tau) ** (np.arange(n) - n)).astype(float)


def sampling(source, scale):
    """Held gains are stable for a period h down to the first time-to-go at which they are not."""
    case = Case("sampling")
    loop, tau, words = controller(source, 4)
    n, h = loop.n, float(f"{tau * source.choice([1e-3, 3e-3]):.3g}")
    step = expm(np.diag(np.ones(n), 1) * h)

    def radius(w):
        held = step[:n, :n] + step[:n, n, None] * gains_at(loop, tau, w)[:, None, :]
        return abs(np.linalg.eigvals(held)).max(axis=1)

    shares = np.geomspace(1, h / tau / 50, 3000)
    for _ in range(3):
        first = np.argmax(radius(shares) >= 1)
        if first == 0:
            return None
        shares = np.geomspace(shares[first - 1], shares[first], 30)
    room = source.choice(NEAR)
    eps = float(f"{shares[0] * scale * tau * (1 + room):.10g}")
    if not h / 20 < eps < tau:
        return None
    case.holds = room > 0
    case.words = words + [f"--sample-time={h}", f"--eps={eps}"]
    return case


def deadline(source, scale):
    """The worst |x_i| over a box from eps on."""
    case = Case("deadline")
    loop, tau, words = controller(source, 5)
    n = loop.n
    share = 10 ** source.uniform(-3, -0.5)
    eps = float(f"{share * tau:.3g}")
    box = [float(decimal(source, 0.1, 3)) for _ in range(n)]
    sigma = np.linspace(-np.log(np.longdouble(eps / tau)), 27, 6000)
    powers = np.longdouble(tau) ** np.arange(n)
    phi = abs(loop.free(np.exp(-sigma))[:, :n]) / powers[:, None] * powers
    worst = (phi @ np.array(box)).max()
    room = source.choice(NEAR)
    error = float(worst * scale * (1 + room))
    if error < 1e-200:
        return None
    case.holds = room > 0
    case.words = words + [f"--eps={eps}", f"--error={error:.10g}", f"--x0-max={','.join(map(str, box))}"]
    return case


def envelope(source, scale):
    """u itself leaves the range of numbers at eps: `sound` would be false. That nothing on the way
    does is not decided here, so nothing is asked of the others."""
    case = Case("envelope")
    loop, tau, words = controller(source, 4)
    precision, greatest = source.choice([("f32", 3.4028234e38), ("f64", 1.7976931e308)])
    share = 10 ** -source.uniform(2, 6)
    eps = float(f"{share * tau:.3g}")
    total = abs(gains_at(loop, tau, [eps / tau])).sum()
    room = source.choice([-0.05, -0.02, 4.0])
    size = greatest / total * (1 - room if room < 0 else 1 / (1 + room)) / scale
    if size >= greatest:
        return None
    case.holds = room > 0
    case.words = words + [f"--precision={precision}", f"--eps={eps}",
                          f"--x-max={','.join([f'{size:.8g}'] * loop.n)}"]
    return case


def membership(source, scale):
    """Mappings that stop rising, miss their limit or lose smoothness at a parameter's edge."""
    case = Case("membership")
    k = source.randint(1, 4)

    def wave():
        slope = lambda s: 1 / (1 - s) / max(-np.cos(2 * pi * k * s), 1e-9)
        grid = min(np.linspace(0, 0.999, 4000), key=slope)
        least = minimize_scalar(slope, bounds=(max(grid - 0.001, 0), min(grid + 0.001, 0.9995)), method="bounded",
                                options={"xatol": 1e-12})
        return min(least.fun, slope(grid))

    shape = source.choice(["two exponentials", "sine", "line", "square", "wave"])
    edge = {"two exponentials": 1.0, "sine": 1 / sqrt(1 + k * k), "line": 1.0, "square": 3.375,
            "wave": wave() if shape == "wave" else 0.0}[shape]
    room = source.choice([0.05, 0.01, -0.01, -0.05])
    c = f"{edge * (1 - room) / scale:.8f}"
    limit = source.choice(["", "", "", "0.999*", "1.001*"])
    text = {
        "two exponentials": f"--mu={limit}tau*(1 - (1 + {c})*exp(-t) + {c}*exp(-2*t))",
        "sine": f"--mu={limit}tau*(1 - exp(-t)*(1 + {c}*sin({k}*t)))",
        "line": f"--mu={limit}tau*(1 - (1 + {c}*t)*exp(-t))",
        "square": f"--kappa=dt/(tau - dt) - {c}*(dt/tau)^2",
        "wave": f"--kappa=-ln(1 - dt/tau) + {c}*sin(2*pi*{k}*dt/tau)/(2*pi*{k})",
    }[shape]
    case.holds = room > 0 and ("mu=" not in text or not limit)
    case.words = ["--n", str(source.randint(1, 3)), text, f"--tau={decimal(source, 0.3, 3)}"]
    return case


DRAWS = [rates.draw, rates.draw, sampling, deadline, envelope, membership]


def verdict(check, printed):
    """The word of a check's line."""
    for line in printed.splitlines():
        if line.startswith(check):
            return line.split(None, 1)[1].partition(":")[0].strip()
    return "no line"


def trial(job):
    """One design, checked: its verdict, and whether that is false."""
    command, _, seed, index, scale, seconds = job
    source, case = random.Random(f"{seed}-check{index}"), None
    while case is None:
        case = DRAWS[index % len(DRAWS)](source, scale)
    result = {"name": f"check{index}", "check": case.check, "words": case.words, "holds": bool(case.holds),
              "confirmed": case.confirmed}
    try:
        done = subprocess.run([command, "check"] + case.words, capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return result | {"verdict": "late", "false": False}
    printed = done.stdout + done.stderr
    word = verdict(case.check, printed)
    failed = word in ("unsound", "refuted")
    if case.check == "envelope":
        failed = False
    false = word == "no line" or word == "sound" and not case.holds or failed and case.holds
    return result | {"verdict": word, "false": false, "printed": printed[:1500] if false else ""}
