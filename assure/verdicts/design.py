"""Wishes for `design`: what it chooses is held against the true supremum of its own objectives."""

import random
import re
import subprocess

import mapping
from draw import decimal
from loop import Loop
from objectives import greatest_input, norm_at_end, text
from supremum import Setting


def trial(job):
    """One wish: whether something was chosen, and the greatest part of a bound that it attains."""
    command, folder, seed, index, scale, seconds = job
    source = random.Random(f"{seed}-design{index}")
    n = source.randint(1, 3)
    tau = decimal(source, 0.3, 2)
    box = [(-float(decimal(source, 0.2, 1)), 1.0) for _ in range(n)]
    force = source.choice([None, (-0.1, 0.1), (-0.3, 0.1)])
    # The bounds are those of one loop, with room: there is something to choose.
    usual = Loop(n, mapping.exp("1"), [(f"-{n + 1.5 + 0.75 * k}", "0") for k in range(n)])
    setting = Setting(usual, box, (tau, tau), 1e-3, force)
    error, upsilon = (float(text(source.uniform(1.1, 1.5) * value)) for value in (
        norm_at_end(source, setting), greatest_input(setting, lambda w: 1.0)))
    lines = ['name = "stage"', f"n = {n}", "[plant]"]
    lines += ['f = "gust"', f"gust = [{force[0]}, {force[1]}]", "[disturbance]", 'gust = "any"'] if force else ["f = 0"]
    lines += ["[verify]"] + [f"x{i + 1} = [{lo}, {hi}]" for i, (lo, hi) in enumerate(box)]
    lines += [f"tau = {tau}", "scenarios = 100", "search = 60", f"seed = {index}"]
    lines += ["[[objective]]", 'bound = "attractive"', f"error = {error}"]
    lines += ["[[objective]]", 'bound = "input"', f"upsilon = {upsilon}"]
    name = f"design{index}"
    wish, made = folder / f"{name}.toml", folder / f"{name}_made.toml"
    wish.write_text("\n".join(lines) + "\n")
    made.unlink(missing_ok=True)
    result = {"name": name, "design": wish.read_text()}
    try:
        done = subprocess.run([command, "design", wish.name, "-o", made.name], cwd=folder,
                              capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return result | {"end": "late", "most": None}
    result["printed"] = (done.stdout + done.stderr)[:1500]
    if done.returncode != 0:
        return result | {"end": "none", "most": None}
    chosen = loop_of(n, made.read_text())
    setting = Setting(chosen, box, (tau, tau), 1e-3, force)
    most = max(norm_at_end(source, setting) / error, greatest_input(setting, lambda w: 1.0) / upsilon)
    return result | {"end": "chosen", "most": float(most * scale), "design": made.read_text()}


def loop_of(n, made):
    """The loop of a design file that `design` wrote."""
    name, values = re.search(r'^mu = "(\w+)\((.*)\)"', made, re.M).groups()
    numbers = [value.partition("=")[2].strip() for value in values.split(",")]
    poles = re.search(r"^poles = \[(.*)\]", made, re.M)[1].split(",")
    return Loop(n, getattr(mapping, name)(*numbers), [(pole.strip(), "0") for pole in poles])
