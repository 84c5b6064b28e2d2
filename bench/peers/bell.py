#!/usr/bin/env python3
"""Seconds that other tools take for all B_{i,j} in free symbols up to an order, as JSON.

The textbook recurrence, expanded, in one process for each tool and order; the best of --runs.
"""

import argparse
import json
import multiprocessing
import time
from math import comb

# SymPy is given smaller orders only: it takes minutes at 30.
CASES = [("python-flint", 12), ("python-flint", 20), ("python-flint", 30), ("SymEngine", 12),
         ("SymEngine", 20), ("SymEngine", 30), ("SymPy", 8), ("SymPy", 12)]


def table(n, r, one, zero, expand):
    """B_{i,j} for 0 <= j <= i <= n; r[l - 1] is r_l."""
    bell = [[one] + [zero] * n] + [[zero] * (n + 1) for _ in range(n)]
    for i in range(1, n + 1):
        for j in range(1, i + 1):
            terms = (comb(i - 1, l - 1) * r[l - 1] * bell[i - l][j - 1] for l in range(1, i - j + 2))
            bell[i][j] = expand(sum(terms, zero))
    return bell


def setting(tool, n):
    """The symbols, one, zero and what expands, of one tool."""
    names = [f"r{i}" for i in range(1, n + 1)]
    if tool == "python-flint":
        from flint import Ordering, fmpz_mpoly_ctx

        ring = fmpz_mpoly_ctx.get(names, Ordering.lex)
        return ring.gens(), ring.constant(1), ring.constant(0), lambda e: e
    if tool == "SymEngine":
        import symengine as tool
    else:
        import sympy as tool
    return [tool.Symbol(name) for name in names], tool.Integer(1), tool.Integer(0), tool.expand


def terms(entry):
    """Terms of an expanded polynomial, to see that all tools computed the same."""
    if hasattr(entry, "is_Add"):
        return len(entry.args) if entry.is_Add else int(entry != 0)
    return len(entry)


def measure(tool, n, results):
    given = setting(tool, n)
    start = time.perf_counter()
    bell = table(n, *given)
    seconds = time.perf_counter() - start
    results.put((seconds, sum(terms(entry) for row in bell for entry in row)))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=5)
    runs = parser.parse_args().runs
    found = []
    for tool, n in CASES:
        best = (float("inf"), 0)
        for _ in range(runs):
            results = multiprocessing.Queue()
            process = multiprocessing.Process(target=measure, args=(tool, n, results))
            process.start()
            best = min(best, results.get())
            process.join()
            if best[0] > 5:
                break
        found.append({"tool": tool, "n": n, "seconds": best[0], "terms": best[1]})
    print(json.dumps(found))


if __name__ == "__main__":
    main()
