"""What `verify` proves with 5 % of room: each family and order, without and with a bounded force.

Every design bounds |x_1|, |x_n|, |u|, a sum of the three with constant factors and one with T in them by
1.05 times what the loop attains, and without a force |x|/|x0|.
"""

import argparse
import multiprocessing
import random
import re
import resource
from pathlib import Path

import mapping
from draw import draw_poles, pole_text
from loop import Loop
from objectives import negated, text
from supremum import Setting, gain_at, supremum
from verify import ask

ROOM = 1.05
FORCES = ["none", "constant", "any"]


def greatest(setting, row):
    """The greatest size of a row."""
    signs = [row, negated(row)]
    most, _ = supremum(setting, lambda s, tau, rows: max(
        setting.linear(signed, s, tau, rows)[0] for signed in signs))
    return most


class Case:
    """One loop: box, tau, poles and force are drawn from its name."""

    def __init__(self, family, n, force, interval, draw):
        self.family, self.n, self.force, self.interval, self.draw = family, n, force, interval, draw
        self.name = f"{family}-{n}-{force}-{'interval' if interval else 'fixed'}-{draw}"

    def setting(self):
        source = random.Random(self.name)
        a = f"{source.uniform(0.5, 2):.2f}"
        more = {"power": ["2"], "exp_sum": [f"{source.uniform(0.5, 2):.2f}"]}.get(self.family, [])
        made = getattr(mapping, self.family)(a, *more)
        poles = draw_poles(source, self.n, made.rho)
        # Few corners, so that what takes time is the proof.
        box = [(-1.0, 1.0)] + [(0.2, 0.2)] * (self.n - 2) + [(-0.5, 0.5)]
        tau = ("1", "2") if self.interval else ("2", "2")
        force = None if self.force == "none" else (-0.5, 0.5)
        lines = [made.spellings[0], f"poles = [{', '.join(pole_text(*p) for p in poles)}]"]
        return lines, Setting(Loop(self.n, made, poles), box, tau, 1e-3, force, self.force)

    def objectives(self, setting):
        """Names of what is bounded, and lines of a design file for each."""
        out, factors = [], {}
        for name, index in [("x1", 0), ("xn", self.n - 1), ("u", self.n)]:
            row = [0] * (self.n + 1)
            row[index] = 1
            most = greatest(setting, row)
            factors[index] = float(f"{1 / most:.2g}")
            bound = text(ROOM * most)
            if name == "u":
                out.append((name, ['bound = "input"', f'upsilon = "{bound}"']))
            else:
                state = f"x{index + 1}"
                out.append((name, ['bound = "within"', f'h = "abs({state})"', f"high = {bound}"]))
        names = [f"x{i + 1}" for i in range(self.n)] + ["u"]
        for name, time_to_go in [("sum", ""), ("sum(T)", "*T")]:
            row = [0] * (self.n + 1)
            for index, factor in factors.items():
                row[index] = factor
            # The second sum: u is multiplied by time-to-go.
            if time_to_go:
                row[self.n] = lambda left: left * factors[self.n]
            h = " + ".join(f"{factors[i]}*{names[i]}" for i in factors) + time_to_go
            out.append((name, ['bound = "within"', f'h = "{h}"', f"high = {text(ROOM * greatest(setting, row))}"]))
        if self.force == "none":
            most, _ = supremum(setting, lambda s, tau, rows: gain_at(setting, s, tau, rows))
            out.append(("norm", ['bound = "state"', f"sigma = {text(ROOM * most)}"]))
        return out

    def design(self):
        loop, setting = self.setting()
        interval = lambda pair: f"[{pair[0]}, {pair[1]}]" if pair[0] != pair[1] else f"{pair[0]}"
        lines = ['name = "stage"', f"n = {self.n}", *loop, "[plant]"]
        if setting.force:
            lines += ['f = "gust"', "gust = [-0.5, 0.5]", "[disturbance]", f'gust = "{self.force}"']
        else:
            lines += ["f = 0"]
        lines += ["[verify]"] + [f"x{i + 1} = {interval(b)}" for i, b in enumerate(setting.box)]
        lines += [f"tau = {interval(setting.tau)}", "scenarios = 1", "search = 0"]
        names = []
        for name, own in self.objectives(setting):
            names.append(name)
            lines += ["[[objective]]"] + own
        return names, "\n".join(lines) + "\n"


def processor_time():
    own = resource.getrusage(resource.RUSAGE_CHILDREN)
    return own.ru_utime + own.ru_stime


def trial(job):
    command, folder, case = job
    known = folder / f"{case.name}.known"
    if known.exists():
        names, _, design = known.read_text().partition("\n")
        names = names.split()
    else:
        names, design = case.design()
        known.write_text(" ".join(names) + "\n" + design)
    start = processor_time()
    verdicts, _, printed = ask(command, folder, case.name, design, 300)
    seconds = processor_time() - start
    whys = re.findall(r"not proved: (.*)", printed)
    return case, {name: verdicts.get(k, "none") for k, name in enumerate(names, 1)}, seconds, whys


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("command", help="the path of ptc-codegen")
    parser.add_argument("folder", type=Path, help="where designs are written and their truth is kept")
    parser.add_argument("--orders", type=int, nargs="*", default=[2, 4, 6, 8])
    parser.add_argument("--families", nargs="*", default=mapping.FAMILIES[:-1])
    parser.add_argument("--forces", nargs="*", default=FORCES)
    parser.add_argument("--draws", type=int, default=1, help="loops of each kind")
    parser.add_argument("--jobs", type=int, default=multiprocessing.cpu_count())
    parser.add_argument("--verbose", action="store_true", help="print each loop, and why it is not proved")
    arguments = parser.parse_args()
    arguments.command = str(Path(arguments.command).resolve())
    arguments.folder.mkdir(parents=True, exist_ok=True)
    cases = [Case(family, n, force, interval, draw) for force in arguments.forces for n in arguments.orders
             for family in arguments.families for interval in (False, True) for draw in range(arguments.draws)]
    cases = [case for case in cases if case.force == "none" or case.n <= 6]
    table = {}
    with multiprocessing.Pool(arguments.jobs) as pool:
        for case, verdicts, seconds, whys in pool.imap(
                trial, [(arguments.command, arguments.folder, case) for case in cases]):
            own = table.setdefault((case.family, case.force), {}).setdefault(case.n, [0, 0, 0.0])
            own[0] += sum(word == "proved" for word in verdicts.values())
            own[1] += len(verdicts)
            own[2] = max(own[2], seconds)
            if arguments.verbose:
                short = " ".join(f"{name}={word}" for name, word in verdicts.items())
                print(f"{case.name:32} {seconds:6.1f} s  {short}", *[f"\n    {why[:170]}" for why in whys], flush=True)
    print("| family | f |", " | ".join(f"n = {n}" for n in arguments.orders), "|")
    print("| --- | --- |" + " --- |" * len(arguments.orders))
    for (family, force), row in table.items():
        cells = [f"{a} of {b}, {s:.1f} s" if (a, b, s) else "" for a, b, s in
                 [row.get(n, (0, 0, 0.0)) for n in arguments.orders]]
        cells = [cell if not cell.startswith("0 of 0") else "-" for cell in cells]
        print(f"| {family} | {force} |", " | ".join(cells), "|")


if __name__ == "__main__":
    main()
