#!/usr/bin/env python3
"""Writes the contestants of `ptc-bench peers`: contestants/<name>/<mapping>_n<n>.c (or .cc).

Set up, then run, from the root of the repository:

    python3 -m venv bench/peers/venv
    bench/peers/venv/bin/pip install sympy symengine casadi symforce python-flint mpmath
    bench/peers/venv/bin/python bench/peers/generate.py

A file that takes longer than --seconds is left out; --only makes those of some names alone.
"""

import argparse
import multiprocessing
import sys
import time
from functools import partial
from pathlib import Path

import hand
import symbolic

HERE = Path(__file__).resolve().parent
ORDERS = [3, 6, 12]
# What makes the text, and how its file ends.
CONTESTANTS = {
    "hand": (hand.hand, "c"),
    "hand_loop": (hand.hand_loop, "c"),
    "sympy_cse": (symbolic.sympy_cse, "c"),
    "sympy_tuned": (symbolic.sympy_tuned, "c"),
    "casadi_diff": (partial(symbolic.casadi, route="diff"), "c"),
    "casadi_mu": (partial(symbolic.casadi, route="mu"), "c"),
    "symforce_diff": (partial(symbolic.symforce, route="diff"), "cc"),
    "symforce_mu": (partial(symbolic.symforce, route="mu"), "cc"),
}
# A source this long is no contestant: gcc alone would take minutes.
LONGEST = 1_000_000


def write(name, mapping, n, path):
    try:
        text = CONTESTANTS[name][0](mapping, n)
    except Exception as error:  # Whatever a tool raises, the others go on.
        print(f"{type(error).__name__}: {error}", file=sys.stderr)
        sys.exit(1)
    if text is None or len(text) > LONGEST:
        sys.exit(3)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def attempt(name, mapping, n, folder, seconds):
    """Makes one file in a process of its own, and reports the outcome."""
    path = folder / name / f"{mapping}_n{n}.{CONTESTANTS[name][1]}"
    path.unlink(missing_ok=True)
    process = multiprocessing.Process(target=write, args=(name, mapping, n, path))
    start = time.monotonic()
    process.start()
    process.join(seconds)
    if process.exitcode is None:
        process.kill()
        process.join()
        return f"left out after {seconds} s"
    if process.exitcode:
        return "none" if process.exitcode == 3 else "failed"
    return f"{time.monotonic() - start:.1f} s, {path.stat().st_size} bytes"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--out", type=Path, default=HERE / "contestants")
    parser.add_argument("--only", nargs="*", choices=CONTESTANTS, default=list(CONTESTANTS))
    parser.add_argument("--seconds", type=int, default=60)
    arguments = parser.parse_args()
    for name in arguments.only:
        for mapping in symbolic.MAPPINGS:
            for n in ORDERS:
                outcome = attempt(name, mapping, n, arguments.out, arguments.seconds)
                print(f"{name} {mapping} n={n}: {outcome}", flush=True)
                if outcome.startswith("left out"):
                    break  # A higher order takes longer still.


if __name__ == "__main__":
    main()
