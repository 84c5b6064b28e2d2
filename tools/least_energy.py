#!/usr/bin/env python3
"""Compare laws in samples: peak and energy of u, and the rest that they leave.

    python3 tools/least_energy.py COMMAND

The C that COMMAND, the path of ptc-codegen, emits for n = 2, tau = 0.8 s and h = 1 ms runs in the loop with the exact
chain in rational numbers. `cc` is needed."""

import ctypes
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

PERIOD, SAMPLES = Fraction(1, 1000), 800
LAWS = {
    "least-energy, that is -2, -3": ["--poles=least-energy"],
    "least-energy(weight=1), -3, -4": ["--poles=least-energy(weight=1)"],
    "least-energy(weight=2), -4, -5": ["--poles=least-energy(weight=2)"],
    "least energy, from 400 samples to go with a weight of 1": [
        "--poles=least-energy", "--poles-end=least-energy(weight=1)", "--end-samples=400"],
    "-2, -4": ["--poles=-2,-4"],
    "-2, -4 with deadbeat = 5": ["--poles=-2,-4", "--deadbeat=5"],
    "-2, -3 with deadbeat = 4": ["--poles=-2,-3", "--deadbeat=4"],
}


def controller(command, flags, folder):
    """The emitted law as a function of the sample and the state."""
    subprocess.run([command, "emit", "--name=law", "--n=2", "--mu=exp(a=1)", "--clock=samples", "--sample-time=1e-3",
                    "--tau=0.8", "--eps=0", "--u-max=inf", *flags, "--lang=c", "-o", folder], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    library = Path(folder, "law.so")
    subprocess.run(["cc", "-O2", "-ffp-contract=off", "-shared", "-fPIC", "-o", library, Path(folder, "law.c")],
                   check=True)
    law = ctypes.CDLL(str(library))
    memory, params, u = ctypes.create_string_buffer(4096), ctypes.create_string_buffer(4096), ctypes.c_double()
    assert law.law_init(memory, params) == 0 and law.law_arm(memory, 0) == 0

    def step(k, x):
        assert law.law_step(memory, k, (ctypes.c_double * 2)(*map(float, x)), ctypes.byref(u)) >= 0
        return Fraction(u.value)

    return step


def run(step):
    """Peak of |u|, energy, and the largest |x_i| at sample N, from x = (1, 0)."""
    x, peak, energy = [Fraction(1), Fraction(0)], Fraction(0), Fraction(0)
    for k in range(SAMPLES):
        u = step(k, x)
        peak, energy = max(peak, abs(u)), energy + u * u * PERIOD
        x = [x[0] + PERIOD * x[1] + PERIOD ** 2 / 2 * u, x[1] + PERIOD * u]
    return float(peak), float(energy), float(max(map(abs, x)))


def main():
    (command,) = sys.argv[1:]
    print("| poles | peak of abs(u) | energy, sum of u^2 h | abs(x) at sample N |\n| --- | --- | --- | --- |")
    for name, flags in LAWS.items():
        with tempfile.TemporaryDirectory() as folder:
            peak, energy, rest = run(controller(command, flags, folder))
        print(f"| {name} | {peak:.4g} | {energy:.4g} | {rest:.1e} |", flush=True)


if __name__ == "__main__":
    main()
