"""Deadlines in flight of several axes: the emitted C against plants of its own, in doubles.

    python3 tools/flight_axes.py soonest COMMAND   the common N: kept by all axes, and against the least N by trying each
    python3 tools/flight_axes.py late COMMAND      deadlines that are put off: an axis that is held, or kicked
    python3 tools/flight_axes.py told COMMAND      `arm_for`, jumps of the state and targets in random order

COMMAND is the path of ptc-codegen. Needs a C compiler called cc. Each part ends with 1 where a limit is exceeded, an
axis is not at rest, or N is smaller than the least that the axes keep by themselves.
"""

import argparse
import ctypes
import random
import sys
from math import inf

from flight import LATE, OK, SATURATED, SOON, Chain, Emitted, numbers

H = 0.01
STRETCH = 1.0 + 1e-9


class Axis:
    """What one axis has of its own."""

    def __init__(self, draw, n, bounded):
        least = n + draw.randrange(2)
        self.poles = "[" + ",".join(f"-{least + j}" for j in range(n)) + "]"
        self.limit = round(10 ** draw.uniform(-0.3, 1.7), 3)
        self.gain = round(10 ** draw.uniform(-1, 0.5), 3)
        self.state_max = [inf] * n
        if bounded and n > 1 and draw.random() < 0.7:
            self.state_max[1] = round(draw.uniform(0.4, 2.0), 3)

    def keeps(self, chain, u):
        """True if u and the states are within the limits."""
        states = all(abs(x) <= most * STRETCH for x, most in zip(chain.x, self.state_max))
        return states and abs(u) <= self.limit * STRETCH

    def state(self, draw, n, size):
        x = [draw.uniform(-size, size) for _ in range(n)]
        for i, most in enumerate(self.state_max):
            if most < inf:
                x[i] = draw.uniform(-0.9, 0.9) * most
        return x


class Together(Emitted):
    """The controller of all axes."""

    def __init__(self, command, axes, n, *flags):
        self.n, self.count = n, len(axes)
        poles = ",".join(axis.poles for axis in axes)
        bounds = ",".join("[" + ",".join(map(str, axis.state_max)) + "]" for axis in axes)
        super().__init__(
            command,
            *common(n),
            f"--axes={self.count}",
            f"--poles=[{poles}]",
            "--limits=" + ",".join(str(axis.limit) for axis in axes),
            "--g=[" + ",".join(str(axis.gain) for axis in axes) + "]",
            f"--state-max=[{bounds}]",
            *flags,
        )

    def steps(self, k, chains):
        u, axes = (ctypes.c_double * self.count)(), (ctypes.c_int * self.count)()
        status = self.call("step", ctypes.c_uint32(k), numbers(states(chains)), u, axes)
        if status < 0:
            raise ValueError(f"step({k}, {states(chains)}) gives {status}")
        return list(u), status

    def arm_for(self, k, samples):
        if self.call("arm_for", ctypes.c_uint32(k), ctypes.c_uint32(samples)) != OK:
            raise ValueError(f"arm_for refuses {samples} samples")


class Alone(Emitted):
    """One axis alone, which says of each N whether it is kept."""

    def __init__(self, command, axis, n, *flags):
        bounds = ",".join(map(str, axis.state_max))
        limits = [f"--poles={axis.poles}", f"--u-max={axis.limit}", f"--g={axis.gain}"]
        super().__init__(command, *common(n), *limits, f"--state-max={bounds}", "--late=refuse", *flags)

    def keeps(self, samples, x):
        status = self.call("arm_for", ctypes.c_uint32(0), ctypes.c_uint32(samples), numbers(x))
        if status not in (OK, SOON):
            raise ValueError(f"arm_for({samples}, {x}) gives {status}")
        return status == OK


def common(n):
    return ["--n", str(n), "--clock", "samples", "--sample-time", str(H), "--tau", "1", "--eps=0"]


def states(chains):
    return [x for chain in chains for x in chain.x]


def designs(draw, options):
    """Axes of random limits, gains, poles and bounds of speed, and flags that they share."""
    for n in range(1, options.most + 1):
        for count in (2, 3):
            for end in (0, 30):
                for bounded in (False, True) if n > 1 else (False,):
                    flags = [f"--poles-end=least-energy(weight=2)", f"--end-samples={end}"] if end else []
                    if draw.random() < 0.3:
                        flags.append("--reserve=0.1")
                    yield n, [Axis(draw, n, bounded) for _ in range(count)], flags, f"{n} {count} {end} {bounded}"


def runs_to_rest(control, axes, chains, k, samples):
    """Runs to rest; what is wrong on the way or at the end."""
    wrong, scale = set(), max(map(abs, states(chains))) or 1.0
    for elapsed in range(samples):
        u, status = control.steps((k + elapsed) % (1 << 32), chains)
        if status == SATURATED:
            wrong.add("clipped")
        for axis, chain, own in zip(axes, chains, u):
            if not axis.keeps(chain, own):
                wrong.add("limit")
            chain.move(own)
    if max(map(abs, states(chains))) > 1e-9 * scale:
        wrong.add("rest")
    return wrong


def soonest(command, options):
    """N of `soonest` from random states."""
    draw, bad, all_runs = random.Random(options.seed), 0, 0
    print("n axes end state_max: runs, none found and missed, exceeded, N not the least, over it at most; N over the largest of the axes' own")
    for n, axes, flags, name in designs(draw, options):
        control = Together(command, axes, n, "--in-flight", *flags)
        alone = [Alone(command, axis, n, *flags) for axis in axes]
        none, missed, exceeded, other, worst, over = 0, 0, 0, 0, 1.0, 1.0
        for _ in range(options.runs):
            x = [axis.state(draw, n, 10 ** draw.uniform(-1.5, 0.3)) for axis in axes]
            chains = [Chain(own, H, axis.gain) for own, axis in zip(x, axes)]
            found = control.soonest(states(chains))
            own = [one.soonest(state) for one, state in zip(alone, x)]
            tried = range(n + 1, 4000 if found is None else found + 1)
            least = next((samples for samples in tried if all(one.keeps(samples, s) for one, s in zip(alone, x))), None)
            if found is None:
                none += 1
                missed += least is not None
                continue
            if least is None or not all(one.keeps(found, state) for one, state in zip(alone, x)):
                bad += 1
                print("   N is not kept by each axis", x, found)
            other += least != found
            worst = max(worst, found / least)
            if None not in own:
                over = max(over, found / max(own))
            k = draw.randrange(1 << 32)
            control.call("arm", ctypes.c_uint32(k))
            control.arm_for(k, found)
            wrong = runs_to_rest(control, axes, chains, k, found)
            if wrong:
                exceeded += 1
                print("   exceeded", wrong, x, found)
        bad, all_runs = bad + exceeded, all_runs + options.runs
        print(f"{name}: {options.runs}, {none} {missed}, {exceeded}, {other}, {worst:.3f}; {over:.3f}", flush=True)
    print(f"{all_runs} runs, {bad} wrong")
    return bad


def late(command, options):
    """Axes that are held or kicked, with the deadline kept or paced."""
    draw, bad, put_off = random.Random(options.seed), 0, 0
    print("n axes end state_max pace: runs, clipped samples, worst at rest, put off")
    for n, axes, flags, name in designs(draw, options):
        for pace in ("deadline", "soonest"):
            control = Together(command, axes, n, "--late=extend", f"--pace={pace}", *flags)
            alone = [Alone(command, axis, n, *flags) for axis in axes]
            clipped, worst, off = 0, 0.0, 0
            for _ in range(options.runs):
                x = [axis.state(draw, n, 0.4) for axis in axes]
                chains = [Chain(own, H, axis.gain) for own, axis in zip(x, axes)]
                if control.soonest(states(chains)) is None:
                    continue
                held, kicked = draw.randrange(0, 100), draw.randrange(20, 200)
                one = draw.randrange(len(axes))
                free = axes[one].state_max[-1] == inf and n > 1
                control.arm_for(0, draw.randrange(n, 300))
                k, last, beyond = 0, control.deadline(), False
                # After the deadline the last gains bring an axis to rest that is let go.
                while k < max(control.deadline(), kicked, held) + 10:
                    # A kick may leave an axis without a plan that keeps its bound of speed.
                    found = control.soonest(states(chains))
                    beyond = beyond or found is None
                    u, status = control.steps(k, chains)
                    now = control.deadline()
                    if status == SATURATED and not beyond:
                        clipped += 1
                        bad += not narrow(alone, chains, last - k, found)
                    if (status == LATE) != (now > last) and status != SATURATED:
                        bad += 1
                        print("   deadline and status differ", last, now, status)
                    if pace == "deadline" and now < last:
                        bad += 1
                        print("   earlier", last, now)
                    off, last = off + (now > last), now
                    for axis, chain, own in zip(axes, chains, u):
                        if not beyond and not axis.keeps(chain, own):
                            bad += 1
                            print("   limit", name, chain.x, own)
                        chain.move(own)
                    if k < held:
                        chains[one].x = list(x[one])
                    if k == kicked and free:
                        chains[one].x[-1] += draw.uniform(-0.5, 0.5)
                    k += 1
                worst = max(worst, *map(abs, states(chains)))
            bad += worst > 1e-9
            put_off += off
            print(f"{name} {pace}: {options.runs}, {clipped}, {worst:.1e}, {off}", flush=True)
    print(f"{put_off} times put off, {bad} wrong")
    return bad or put_off == 0


def narrow(alone, chains, planned, found):
    """True if the deadlines that all axes keep end before half of their distance from the planned one."""
    last = planned + (found - planned) * 3 // 2 + 1
    tried = range(found, last + 1)
    return not all(one.keeps(samples, chain.x) for samples in tried for one, chain in zip(alone, chains))


def told(command, options):
    """Random calls between samples: at rest all the same."""
    draw, worst = random.Random(options.seed), 0.0
    for n, axes, flags, _ in designs(draw, options):
        if any(most < inf for axis in axes for most in axis.state_max):
            continue
        control = Together(command, axes, n, "--late=extend", *flags)
        for _ in range(options.runs):
            chains = [Chain(axis.state(draw, n, 0.3), H, axis.gain) for axis in axes]
            k = draw.randrange(1 << 32)
            control.call("arm", ctypes.c_uint32(k))
            for _ in range(500):
                choice = draw.random()
                if choice < 0.01:
                    control.arm_for(k % (1 << 32), draw.randrange(n, 500))
                elif choice < 0.02:
                    draw.choice(chains).x[0] += draw.uniform(-0.3, 0.3)
                elif choice < 0.03:
                    chains[draw.randrange(len(axes))].x[-1] *= draw.uniform(-1, 1)
                elif choice < 0.04:
                    control.soonest(states(chains))
                elif choice < 0.05:
                    nothing = (ctypes.c_double * len(axes))(), (ctypes.c_int * len(axes))()
                    before = control.deadline()
                    spoilt = [float("nan")] + states(chains)[1:]
                    status = control.call("step", ctypes.c_uint32(k % (1 << 32)), numbers(spoilt), *nothing)
                    if status >= 0 or control.deadline() != before or any(nothing[0]):
                        raise ValueError("a call that fails changes something")
                u, _ = control.steps(k % (1 << 32), chains)
                for chain, own in zip(chains, u):
                    chain.move(own)
                k += 1
            control.arm_for(k % (1 << 32), draw.randrange(n, 3000))
            control.steps(k % (1 << 32), chains)
            for elapsed in range((control.deadline() - k) % (1 << 32)):
                u, status = control.steps((k + elapsed) % (1 << 32), chains)
                if status == SATURATED:
                    raise ValueError("u is clipped")
                for chain, own in zip(chains, u):
                    chain.move(own)
            worst = max(worst, *map(abs, states(chains)))
    print(f"off by {worst:.2e} at most")
    return worst > 1e-9


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("part", choices=["soonest", "late", "told"])
    parser.add_argument("command")
    parser.add_argument("--runs", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--most", type=int, default=3, help="greatest order")
    options = parser.parse_args()
    return min(1, int(globals()[options.part](options.command, options)))


if __name__ == "__main__":
    sys.exit(main())
