"""Verdicts of `verify` on random designs, against the truth."""

import random
import re
import subprocess

import supremum
from draw import draw

# What is bounded may be any text: the verdict is the first of these behind it.
VERDICT = re.compile(r": (holds, proved|holds|fails|undecided)")


def ask(command, folder, name, text, seconds):
    """Verdicts by the number of the objective, the exit code and all that was printed."""
    path = folder / f"{name}.toml"
    path.write_text(text)
    try:
        done = subprocess.run([command, "verify", path.name], cwd=folder, capture_output=True,
                              text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return {}, None, f"no end within {seconds} s"
    printed = done.stdout + done.stderr
    verdicts = {}
    for line in printed.splitlines():
        found = re.match(r"(error: | = note: )?objective (\d+), (.*)", line)
        said = found and VERDICT.search(found[3])
        if said:
            verdicts[int(found[2])] = said[1].split(" ")[-1].rstrip(",")
        elif found and found[1]:
            verdicts.setdefault(int(found[2]), "fails")
    return verdicts, done.returncode, printed


def faults(design, verdicts, code, printed):
    """Kinds of what is false, each with the objective's number: none for a true command."""
    out = []
    for number, one in enumerate(design.objectives, 1):
        verdict = verdicts.get(number)
        if verdict == "proved" and not (one.holds and design.in_range):
            out.append(("falsely proved", number))
        if verdict == "holds" and not one.holds:
            out.append(("held by sampling", number))
        if verdict == "fails" and one.holds:
            out.append(("falsely failed", number))
    words = list(verdicts.values())
    if code is None or not words or "Theorem 1 differ" in printed:
        return out
    expected = {1} if "fails" in words else {3} if "undecided" in words else {0}
    if code not in expected | ({2} if len(words) < len(design.objectives) else set()):
        out.append(("exit code", code))
    return out


def trial(job):
    """One design, drawn, run and judged: what a row of the campaign needs."""
    command, folder, seed, name, order, scale, seconds = job
    supremum.SCALE = scale
    design = drawn(seed, name, order)
    verdicts, code, printed = ask(command, folder, name, design.text, seconds)
    found = faults(design, verdicts, code, printed)
    if any(kind.startswith("falsely") for kind, _ in found) and scale == 1:
        # A table that was too coarse must not accuse: the same draws, with finer ones.
        points = supremum.POINTS, supremum.FORCED_POINTS
        supremum.POINTS, supremum.FORCED_POINTS = 5 * points[0], 4 * points[1]
        finer = drawn(seed, name, order)
        supremum.POINTS, supremum.FORCED_POINTS = points
        if not close(finer, design):
            found, verdicts = [], {}
    rows = [(design.n, design.family, design.forced, one.kind, one.room, verdicts.get(number))
            for number, one in enumerate(design.objectives, 1)]
    return {"name": name, "rows": rows, "faults": found, "code": code,
            "design": design.text if found else "", "printed": printed[:1500] if found else ""}


def drawn(seed, name, order):
    source = random.Random(f"{seed}-{name}")
    forced = source.random() < 0.25
    return draw(source, forced, n=source.randint(1, min(order, 6) if forced else order))


def close(finer, design):
    """Whether both have the same bounds, up to a fifth of the least room."""
    numbers = lambda text: [float(x) for x in re.findall(r"\d+\.?\d*(?:e[-+]?\d+)?", text)]
    a, b = numbers(finer.text), numbers(design.text)
    return len(a) == len(b) and all(abs(x - y) <= 2e-3 * max(abs(x), abs(y)) for x, y in zip(a, b))
