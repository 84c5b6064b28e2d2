#!/usr/bin/env python3
"""Counts a step of chains of higher order beside Taylor jets written by hand; prints a table.

    cargo build --release -p ptc-codegen
    python3 bench/peers/jets.py target/release/ptc-codegen

The plant is z_i' = z_(i+1) + 0.3 sin(z_i) z_1 with the output z_1, and u in the last rate. The hand-written function
has the same law, straight-line, in Horner's form in 1/T with its coefficients as numbers. Both are compiled by
gcc -std=c99 -O2 and counted by callgrind in one call, with the library's functions. SymPy and CasADi are not needed.
"""

import math
import re
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import counted
from counted import TAU, TIME


def design(r):
    states = range(1, r + 1)
    names = ", ".join(f'"z{i}"' for i in states)
    after = {i: f"z{i + 1}" for i in states} | {r: "u"}
    rates = ", ".join(f'z{i} = "{after[i]} + 0.3*sin(z{i})*z1"' for i in states)
    model = f'states = [{names}]\ninput = "u"\noutput = "z1"\ndynamics = {{ {rates} }}\n'
    return counted.design(f"chain{r}", [-(r + i) for i in states], model)


def rows(command, file):
    """The rows of the law: gain_j = inv_T^(r+1-j) row_j."""
    shown = subprocess.run([command, "show", "law", file], capture_output=True, text=True, check=True)
    known = {}
    for line in shown.stdout.splitlines():
        if found := re.match(r"(K\d+|row\d+) *= (.*)$", line):
            known[found[1]] = eval(found[2].replace("^", "**"), {}, known)
    return [known[f"row{j}"] for j in range(1, sum(key[0] == "r" for key in known) + 1)]


def convolution(a, b, k, first):
    return " + ".join(f"{a}_{j}*{b}_{k - j}" for j in range(first, k + 1))


def hand(r, law):
    """The same step by Taylor jets: only the terms that the output's derivatives need."""
    lines = [f"const double p = 1.0/({TAU} - t);"]
    lines += [f"const double z{i}_0 = z[{i - 1}];" for i in range(1, r + 1)]
    for k in range(r):
        for i in range(1, r - k + 1):
            last = i + k == r
            if k == 0:
                cosine = "" if last else f", c{i}_0 = cos(z{i}_0)"
                lines.append(f"const double s{i}_0 = sin(z{i}_0){cosine};")
            else:
                lines.append(f"const double d{i}_{k} = {float(k)}*z{i}_{k};")
                sine = convolution(f"d{i}", f"c{i}", k, 1)
                lines.append(f"const double s{i}_{k} = ({sine})*{1 / k!r};")
                if not last:
                    cosine = convolution(f"d{i}", f"s{i}", k, 1)
                    lines.append(f"const double c{i}_{k} = -({cosine})*{1 / k!r};")
            after = f"z{i + 1}_{k} + " if i < r else ""
            product = convolution(f"s{i}", "z1", k, 0)
            lines.append(f"const double z{i}_{k + 1} = ({after}0.3*({product}))*{1 / (k + 1)!r};")
    value = ""
    for j, row in enumerate(law):
        term = f"{float(math.factorial(j) * row)!r}*z1_{j}"
        value = f"{term} + p*({value})" if value else term
    lines.append(f"return p*({value}) - {float(math.factorial(r))!r}*z1_{r};")
    body = "\n    ".join(lines)
    return f"#include <math.h>\ndouble hand(double t, const double *z) {{\n    {body}\n}}\n"


def driver(r):
    state = ", ".join(repr(0.3 * math.cos(1.7 * i)) for i in range(r))
    return f"""#include <stdio.h>
#include "chain{r}.h"
double hand(double, const double *);
int main(void) {{
    chain{r} self;
    const chain{r}_params params = {{ 0 }};
    const double z[{r}] = {{ {state} }};
    double u;
    if (chain{r}_init(&self, &params) != PTC_OK) return 1;
    if (chain{r}_step(&self, {TIME}, z, &u) < PTC_OK) return 2;
    printf("%.17g %.17g\\n", u, hand({TIME}, z));
    return 0;
}}
"""


def count(command, r, folder):
    """Instructions of ours and of the hand-written step, and the relative difference of u."""
    (folder / "design.toml").write_text(design(r))
    counted.run(folder, command, "emit", "design.toml", "--lang", "c", "-o", str(folder))
    by_hand = hand(r, rows(command, folder / "design.toml"))
    ours, theirs, [(u, other)] = counted.counted(folder, f"chain{r}", by_hand, driver(r))
    return ours, theirs, abs(u - other) / abs(other)


def main():
    command = str(Path(sys.argv[1]).resolve())
    print("| r | ptc-codegen | Taylor jets by hand | ratio | difference of u |")
    print("| ---: | ---: | ---: | ---: | ---: |")
    for r in map(int, sys.argv[2:] or ["2", "3", "4", "5", "6", "8", "10", "12"]):
        with TemporaryDirectory() as folder:
            ours, theirs, difference = count(command, r, Path(folder))
        print(f"| {r} | {ours} | {theirs} | {ours / theirs:.2f} | {difference:.0e} |")


if __name__ == "__main__":
    main()
