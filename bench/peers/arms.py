#!/usr/bin/env python3
"""Counts a step of planar arms beside inverse dynamics by Newton and Euler, written by hand; prints a table.

    cargo build --release -p ptc-codegen
    python3 bench/peers/arms.py target/release/ptc-codegen

The arms have 2 to 8 links of 1 m with 1 kg at the end of each, in a vertical plane. `written` is the model as a
text book prints it, with sines and cosines of sums of relative angles; `let` has intermediate values: the sines and
cosines of absolute angles, the masses beyond each joint, and the forces of the links one after the other. The function
by hand is a recursion over the links, straight-line, with the same law. All are compiled by gcc -std=c99 -O2 and
counted by callgrind in one call, with the library's functions.
"""

import subprocess
import sys
from math import cos
from pathlib import Path
from tempfile import TemporaryDirectory

import counted
from counted import TAU, TIME

GRAVITY = 9.81


def design(n, model):
    joints = range(1, n + 1)
    names = ", ".join([f'"q{i}"' for i in joints] + [f'"w{i}"' for i in joints])
    inputs = ", ".join(f'"M{i}"' for i in joints)
    head = f"states = [{names}]\ninputs = [{inputs}]\n"
    return counted.design(f"arm{n}", [-3, -4], head + model)


def listed(rows):
    return ", ".join(f'"{row}"' for row in rows)


def angle(first, last):
    return " + ".join(f"q{i}" for i in range(first, last + 1))


def written(n):
    """M and bias in relative angles: the links i and j turn by q_(i+1) + ... + q_j against each other."""
    beyond = lambda i, j: n + 1 - max(i, j)
    joints = range(1, n + 1)

    def inertia(a, b):
        terms = []
        for i in range(a, n + 1):
            for j in range(b, n + 1):
                low, high = sorted((i, j))
                factor = f"*cos({angle(low + 1, high)})" if low < high else ""
                terms.append(f"{beyond(i, j)}{factor}")
        return " + ".join(terms)

    def bias(a):
        terms = []
        for i in range(a, n + 1):
            for j in joints:
                if i == j:
                    continue
                low, high = sorted((i, j))
                sign = "-" if j > i else ""
                rate = " + ".join(f"w{k}" for k in range(1, j + 1))
                terms.append(f"{sign}{beyond(i, j)}*sin({angle(low + 1, high)})*({rate})^2")
            terms.append(f"{beyond(i, i) * GRAVITY!r}*cos({angle(1, i)})")
        return " + ".join(terms).replace("+ -", "- ")

    rows = ",\n  ".join(f"[{listed(inertia(a, b) for b in joints)}]" for a in joints)
    return f"inertia = [\n  {rows},\n]\nbias = [{listed(bias(a) for a in joints)}]\n"


def intermediate(n):
    """The same from absolute angles; forces and positions add up from link to link."""
    joints = range(1, n + 1)
    values = []
    for i in joints:
        values.append((f"a{i}", f"a{i - 1} + q{i}" if i > 1 else "q1"))
        values.append((f"v{i}", f"v{i - 1} + w{i}" if i > 1 else "w1"))
        values += [(f"s{i}", f"sin(a{i})"), (f"c{i}", f"cos(a{i})")]
        values += [(f"ax{i}", f"{f'ax{i - 1} ' if i > 1 else ''}- c{i}*v{i}^2")]
        values += [(f"ay{i}", f"{f'ay{i - 1}' if i > 1 else repr(GRAVITY)} - s{i}*v{i}^2")]
    # The force on the end of link i: that of all masses beyond.
    for i in reversed(joints):
        more = f" + fx{i + 1}" if i < n else ""
        values += [(f"fx{i}", f"ax{i}{more}")]
        more = f" + fy{i + 1}" if i < n else ""
        values += [(f"fy{i}", f"ay{i}{more}")]
        more = f" + b{i + 1}" if i < n else ""
        values += [(f"b{i}", f"c{i}*fy{i} - s{i}*fx{i}{more}")]
    # The masses beyond joint j as one body, its moments about each joint before.
    for j in reversed(joints):
        k = n + 1 - j
        last = j == n
        if j > 1:
            values += [(f"px{j}", f"{k}*c{j}" + ("" if last else f" + px{j + 1}"))]
            values += [(f"py{j}", f"{k}*s{j}" + ("" if last else f" + py{j + 1}"))]
        more = "" if last else f" + i{j + 1} + 2*(c{j}*px{j + 1} + s{j}*py{j + 1})"
        values += [(f"i{j}", f"{k}{more}")]
    entries = {}
    for j in joints:
        before = f"i{j}"
        entries[j, j] = before
        for a in range(j - 1, 0, -1):
            values += [(f"m{a}_{j}", f"{before} + c{a}*px{j} + s{a}*py{j}")]
            before = f"m{a}_{j}"
            entries[a, j] = entries[j, a] = before
    table = ", ".join(f'{name} = "{value.strip()}"' for name, value in values)
    rows = ",\n  ".join(f"[{listed(entries[a, b] for b in joints)}]" for a in joints)
    return f"let = {{ {table} }}\ninertia = [\n  {rows},\n]\nbias = [{listed(f'b{i}' for i in joints)}]\n"


def hand(n):
    """u by the recursion of Newton and Euler with the accelerations that the law wants."""
    lines = [f"const double p = 1.0/({TAU} - t);"]
    angle = rate = turn = "0.0"
    ax, ay = "0.0", repr(GRAVITY)
    for i in range(1, n + 1):
        q, w = f"x[{i - 1}]", f"x[{n + i - 1}]"
        # The gains 12 and 7 of the poles, in 1/T: row_1 = -12, row_2 = -(7 - 1).
        lines.append(f"const double z{i} = p*(-6.0*{w} - p*(12.0*{q}));")
        for name, before, own in (("a", angle, q), ("v", rate, w), ("d", turn, f"z{i}")):
            lines.append(f"const double {name}{i} = " + (f"{before} + {own};" if i > 1 else f"{own};"))
        angle, rate, turn = f"a{i}", f"v{i}", f"d{i}"
        lines.append(f"const double s{i} = sin(a{i}), c{i} = cos(a{i}), y{i} = v{i}*v{i};")
        lines.append(f"const double ax{i} = {ax} - d{i}*s{i} - y{i}*c{i};")
        lines.append(f"const double ay{i} = {ay} + d{i}*c{i} - y{i}*s{i};")
        ax, ay = f"ax{i}", f"ay{i}"
    for i in range(n, 0, -1):
        more = lambda name: f" + {name}{i + 1}" if i < n else ""
        lines.append(f"const double fx{i} = ax{i}{more('fx')}, fy{i} = ay{i}{more('fy')};")
        lines.append(f"u[{i - 1}] = c{i}*fy{i} - s{i}*fx{i}" + (f" + u[{i}];" if i < n else ";"))
    body = "\n    ".join(lines)
    return f"#include <math.h>\nvoid hand(double t, const double *restrict x, double *restrict u) {{\n    {body}\n}}\n"


def driver(n):
    state = ", ".join(repr(0.4 * cos(1.7 * i)) for i in range(2 * n))
    return f"""#include <stdio.h>
#include "arm{n}.h"
void hand(double, const double *, double *);
int main(void) {{
    arm{n} self;
    const arm{n}_params params = {{ 0 }};
    const double x[{2 * n}] = {{ {state} }};
    double u[{n}], by_hand[{n}];
    ptc_status axes[{n}];
    if (arm{n}_init(&self, &params) != PTC_OK) return 1;
    if (arm{n}_step(&self, {TIME}, x, u, axes) < PTC_OK) return 2;
    hand({TIME}, x, by_hand);
    for (int i = 0; i < {n}; ++i) printf("%.17g %.17g\\n", u[i], by_hand[i]);
    return 0;
}}
"""


def count(command, n, model, folder):
    """Instructions of ours and of the function by hand, and the largest difference relative to the largest u."""
    (folder / "design.toml").write_text(design(n, model))
    emitted = subprocess.run([command, "emit", "design.toml", "--lang", "c"], cwd=folder, capture_output=True, text=True)
    if emitted.returncode:
        return None
    ours, theirs, pairs = counted.counted(folder, f"arm{n}", hand(n), driver(n))
    largest = max(abs(by_hand) for _, by_hand in pairs)
    return ours, theirs, max(abs(u - by_hand) for u, by_hand in pairs) / largest


def main():
    command = str(Path(sys.argv[1]).resolve())
    print("| links | written | `let` | Newton and Euler by hand | ratio | difference of u |")
    print("| ---: | ---: | ---: | ---: | ---: | ---: |")
    for n in map(int, sys.argv[2:] or ["2", "3", "4", "5", "6", "8"]):
        with TemporaryDirectory() as folder:
            plain = count(command, n, written(n), Path(folder))
            named = count(command, n, intermediate(n), Path(folder))
        ours, theirs, difference = named
        shown = plain[0] if plain else "refused"
        print(f"| {n} | {shown} | {ours} | {theirs} | {ours / theirs:.2f} | {difference:.0e} |")


if __name__ == "__main__":
    main()
