"""Random designs with objectives of known truth."""


import mapping
from loop import Loop
from objectives import objective
from supremum import Setting, supremum

ROOMS = [0.05, 0.01, -0.01, -0.05]


def decimal(random, low, high, digits=2):
    return f"{random.uniform(low, high):.{digits}f}"


def draw_mapping(random, name):
    a = decimal(random, 0.3, 2.5)
    if name == "power":
        return mapping.power(a, random.choice(["0.5", "2", "3", "1.5"]))
    if name == "exp_sum":
        return mapping.exp_sum(a, decimal(random, 0.3, 2.5))
    if name == "kappa":
        return mapping.logarithm_and_linear(a, decimal(random, 0.1, 2))
    return getattr(mapping, name)(a)


def draw_poles(random, n, rho):
    """Poles left of -n rho, in one of the patterns in which they can lie."""
    slow = max(n * rho * random.uniform(1.05, 1.8), random.uniform(0.5, 3))
    pattern = random.choice(["real", "real", "equal", "complex", "whole"])
    poles = []
    while len(poles) < n:
        re = f"-{slow:.2f}"
        if pattern == "complex" and n - len(poles) >= 2:
            im = decimal(random, 0.2, 0.8 * slow)
            poles += [(re, im), (re, f"-{im}")]
        else:
            poles.append((f"-{int(slow) + 1}" if pattern == "whole" else re, "0"))
        if pattern != "equal" or random.random() < 0.3:
            slow += max(1, slow * random.uniform(0.02, 0.3))
    return poles


def pole_text(re, im):
    return re if im == "0" else f'"{re}{"" if im.startswith("-") else "+"}{im}i"'


class Design:
    """A design file with objectives and their truth; `in_range`: u does not leave the range of its
    precision, where nothing may be proved."""


def draw(random, forced, objectives=2, n=None, family=None):
    n = n or random.randint(1, 6 if forced else 8)
    family = family or random.choice(mapping.FAMILIES)
    made = draw_mapping(random, family)
    poles = draw_poles(random, n, made.rho)
    gain = random.choice(["1", "1", "2", "0.5"])
    # x at one instant depends on tau by powers: an interval of it is a dimension more.
    tau = decimal(random, 0.3, 3)
    until = random.choice([1e-3, 1e-3, 1e-2])
    free_tau = random.random() < 0.4
    single = random.random() < 0.15
    if single and random.random() < 0.4:
        # u, which grows like tau^-n, comes near the end of single precision.
        tau = f"{10 ** (-37.5 / (n + 1)) * random.uniform(0.5, 2):.3g}"
    tau_high = f"{float(tau) * random.uniform(1.1, 3):.4g}" if free_tau else tau
    box = []
    for i in range(n):
        kind = random.random()
        size = float(decimal(random, 0.1, 2)) or 1.0
        if kind < 0.6 or i == 0:
            box.append((-size, size))
        elif kind < 0.8:
            box.append((0.0, 0.0))
        else:
            box.append((-size, round(size / 2, 3)))
    force = None
    if forced:
        size = float(decimal(random, 0.05, 1))
        force = (-size, random.choice([size, size, size / 4]))
    setting = Setting(Loop(n, made, poles, gain), box, (tau, tau_high), until, force,
                      random.choice(["any", "any", "constant"]))
    design = Design()
    design.n, design.family, design.forced, design.setting = n, family, forced, setting
    design.objectives = [objective(random, setting, random.choice(ROOMS)) for _ in range(objectives)]
    u = supremum(setting, lambda s, t, rows: setting.linear([0] * n + [1], s, t, rows)[0])[0]
    design.in_range = not single or u < 3.4028234e38
    design.spelling = random.choice(made.spellings)
    interval = lambda lo, hi: f"{lo}" if lo == hi else f"[{lo}, {hi}]"
    lines = ['name = "stage"', f"n = {n}", design.spelling,
             f"poles = [{', '.join(pole_text(*p) for p in poles)}]"]
    if single:
        lines.append('precision = "f32"')
    if gain != "1":
        lines.append(f'g = "{gain}"')
    if forced:
        lines += ["[plant]", 'f = "gust"', f"gust = [{force[0]}, {force[1]}]", "[disturbance]",
                  f'gust = "{setting.signals}"']
    else:
        lines += ["[plant]", "f = 0"]
    lines += ["[verify]"] + [f"x{i + 1} = {interval(*b)}" for i, b in enumerate(box)]
    lines += [f"tau = {interval(tau, tau_high)}", f"until = {until}", "scenarios = 40", "search = 20",
              f"seed = {random.randint(0, 999)}"]
    for one in design.objectives:
        lines += ["[[objective]]"] + one.lines
    design.text = "\n".join(lines) + "\n"
    return design
