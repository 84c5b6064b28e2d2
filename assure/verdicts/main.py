"""Attacks the verdicts of `ptc-codegen` with designs of known truth; prints a JSON of what it found.

The truth comes from mpmath, NumPy and SciPy and shares no code with the project.
"""

import argparse
import json
import multiprocessing
import sys
from collections import Counter
from pathlib import Path

import numpy as np

import attained
import checks
import design
import digits
import sampled
import simulate
import verify


def verdicts(pool, arguments):
    """Designs for `verify` until enough objectives were judged on either side of the truth."""
    jobs = ((arguments.command, arguments.folder, arguments.seed, f"verify{index}", arguments.order,
             arguments.scale, arguments.seconds) for index in range(20 * arguments.each_way))
    results, judged = [], Counter(above=0, below=0)
    for result in each(pool, verify.trial, jobs, arguments):
        results.append(result)
        for row in result["rows"]:
            if row[-1] is not None:
                judged["above" if row[-2] > 0 else "below"] += 1
        if min(judged.values()) >= arguments.each_way:
            break
    rows = [row for result in results for row in result["rows"]]
    roomy = lambda n: [row[-1] for row in rows if row[0] == n and row[-2] == 0.05 and row[-1]]
    return {
        "designs": len(results), **judged,
        "verdicts": Counter(f"{word}, {'true' if room > 0 else 'false'}" for *_, room, word in rows if word),
        "proved_with_room": {n: [roomy(n).count("proved"), len(roomy(n))] for n in range(1, arguments.order + 1)},
        "false": [result for result in results if any(kind != "held by sampling" for kind, _ in result["faults"])],
        "held": sum(kind == "held by sampling" for result in results for kind, _ in result["faults"]),
    }


def checked(pool, arguments):
    jobs = ((arguments.command, arguments.folder, arguments.seed, index, arguments.scale,
             arguments.seconds) for index in range(arguments.checks))
    results = list(each(pool, checks.trial, jobs, arguments))
    words = {}
    for result in results:
        truth = "true" if result["holds"] else "false"
        words.setdefault(result["check"], Counter())[f"{result['verdict']}, {truth}"] += 1
    return {
        "designs": len(results), "verdicts": words,
        "unconfirmed": [r for r in results if not r["confirmed"]],
        "false": [r for r in results if r["false"]],
    }


KINDS = ("known", "uncertain", "linear known", "linear uncertain")


def loops(pool, arguments):
    jobs = ((arguments.command, arguments.folder, arguments.seed, index, linear, arguments.scale, arguments.seconds)
            for linear, count in ((False, arguments.loops), (True, arguments.loops // 10)) for index in range(count))
    results = list(each(pool, sampled.trial, jobs, arguments))
    near = lambda key, kind: [r[key] for r in results if r.get(key) and f", {kind}," in r["verdict"]]
    middle = lambda values: float(np.median(values)) if values else None
    return {
        "designs": len(results), "verdicts": Counter(r["verdict"] for r in results),
        "after": sum(r.get("held") is not None for r in results),
        "verify": Counter(r["verify"] for r in results if r.get("verify")),
        "close": {kind: middle(near("near", kind)) for kind in KINDS},
        "close_after": {kind: middle(near("held", kind)) for kind in KINDS},
        "false": [r for r in results if r["false"]],
    }


def runs(pool, arguments):
    jobs = ((arguments.command, arguments.folder, arguments.seed, f"simulate{index}", arguments.scale,
             arguments.seconds) for index in range(arguments.simulate))
    results = list(each(pool, simulate.trial, jobs, arguments))
    kinds = {}
    for kind in sorted({r["kind"] for r in results}):
        own = [r for r in results if r["kind"] == kind]
        errors = [r["error"] * simulate.TOLERANCE[kind] for r in own if r["error"] is not None]
        kinds[kind] = {"runs": len(own), "finished": len(errors), "error": max(errors, default=None),
                       "tolerance": simulate.TOLERANCE[kind]}
    return {
        "designs": len(results), "kinds": kinds,
        "false": [r for r in results if r["end"] == "short" or r["error"] is not None and r["error"] > 1],
        "unfinished": [r for r in results if r["end"] in ("late", "refused")],
    }


def wishes(pool, arguments):
    jobs = ((arguments.command, arguments.folder, arguments.seed, index, arguments.scale,
             10 * arguments.seconds) for index in range(arguments.design))
    results = list(each(pool, design.trial, jobs, arguments))
    reached = [r["most"] for r in results if r["most"] is not None]
    return {
        "wishes": len(results), "chosen": len(reached), "most": max(reached, default=None),
        "false": [r for r in results if r["most"] is not None and r["most"] > 1],
    }


def kept_digits(pool, arguments):
    orders = [n for n in (1, 2, 3, 5, 8) if n <= arguments.order]
    jobs = ((arguments.command, arguments.folder, arguments.seed, family, n, precision, arguments.digits,
             arguments.scale) for family in digits.FAMILIES for n in orders for precision in ("f64", "f32"))
    results = list(each(pool, digits.trial, jobs, arguments))
    total = lambda key: sum(result[key] for result in results)
    return {
        **{key: total(key) for key in ("accepted", "refused", "calls", "range")},
        "false": [{"name": r["name"], "printed": wrong} for r in results for wrong in r["wrong"]],
    }


def routes(pool, arguments):
    results = list(pool.imap(attained.trial, [(arguments.seed, k) for k in range(arguments.attained)]))
    return {"runs": len(results), "miss": max((r["miss"] for r in results), default=0.0)}


def each(pool, trial, jobs, arguments):
    for result in pool.imap(trial, jobs):
        if arguments.verbose:
            print({k: v for k, v in result.items() if k not in ("design", "printed")}, file=sys.stderr, flush=True)
        yield result


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("command", help="the path of ptc-codegen")
    parser.add_argument("folder", type=Path, help="where designs are written")
    parser.add_argument("--each-way", type=int, default=500, help="objectives above, and below, the truth")
    parser.add_argument("--order", type=int, default=8, help="greatest order")
    parser.add_argument("--checks", type=int, default=600, help="designs for `check`")
    parser.add_argument("--loops", type=int, default=1000, help="designs for the check `loop`, and a tenth as many of linear plants")
    parser.add_argument("--simulate", type=int, default=100, help="runs of `simulate`")
    parser.add_argument("--design", type=int, default=20, help="wishes for `design`")
    parser.add_argument("--digits", type=int, default=40, help="sets of parameters of each emitted controller")
    parser.add_argument("--attained", type=int, default=40, help="suprema computed by another route")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=120, help="for one run of the command")
    parser.add_argument("--jobs", type=int, default=multiprocessing.cpu_count())
    parser.add_argument("--scale", type=float, default=1.0, help="a factor that makes the truth wrong")
    parser.add_argument("--verbose", action="store_true")
    arguments = parser.parse_args()
    arguments.command = str(Path(arguments.command).resolve())
    arguments.folder.mkdir(parents=True, exist_ok=True)
    with multiprocessing.Pool(arguments.jobs) as pool:
        # What lasts longest comes last; the pool is ended once enough was judged.
        found = {"attained": routes(pool, arguments), "checks": checked(pool, arguments),
                 "loops": loops(pool, arguments),
                 "simulate": runs(pool, arguments),
                 "digits": kept_digits(pool, arguments),
                 "design": wishes(pool, arguments), "verify": verdicts(pool, arguments)}
        pool.terminate()
    print(json.dumps(found))


if __name__ == "__main__":
    main()
