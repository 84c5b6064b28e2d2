"""The module ptc_codegen of the wheel against the command of the workspace: the same files, verdicts and bits.

Usage: module.py GENERATOR COMMAND WORKSPACE [--defect|--hang], where COMMAND is the wheel's. With --defect
the module is asked for a start that is one rounding away, and with --hang a forked process does not answer,
which have to be seen.
"""

import contextlib
import copy
import io
import json
import multiprocessing
import os
import pickle
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import warnings
from pathlib import Path

import numpy as np
import ptc_codegen as ptc

GENERATOR, COMMAND, WORKSPACE = sys.argv[1:4]
DEFECT = "--defect" in sys.argv
HANG = "--hang" in sys.argv
FAILURES = []

# Seconds after which a process of a pool is taken to hang.
HANGS = 3 if HANG else 120

EXAMPLES = sorted(Path(WORKSPACE).glob("examples/*.toml"))
CATALOGUE = sorted(Path(WORKSPACE).glob("ptc-codegen/catalogue/*.toml"))

# A design, flags, the same as keywords, x0, and more flags with their arguments.
RUNS = [
    ("table", [], {}, [1.0, 0.25], [], {}),
    ("table", ["--tau=0.5", "--poles=-4,-5"], {"tau": 0.5, "poles": np.array([-4, -5])}, [1, 0],
     ["--at=0,0.1,0.999999"], {"at": [0, 0.1, 0.999999]}),
    ("table", ["--sample-time=1e-3", "--noise=1e-4,1e-3"],
     {"sample_time": 1e-3, "noise": [1e-4, 1e-3]}, [0.5, 0],
     ["--seed=7", "--until=1.5", "--arm-at=0.25"], {"seed": 7, "until": 1.5, "arm_at": [0.25]}),
    ("track", ["--sample-time=1e-3"], {"sample_time": 1e-3}, [0.3, 0], ["--until=3"], {"until": 3}),
    ("motor", [], {}, [1, 0, 0], [], {}),
    ("drive", ["--eps=1e-3"], {"eps": 1e-3}, [1, 0, 0], [], {}),
    ("pendulum", ["--plant=m=1.05", "--plant=load=0.1"], {"plant": {"m": 1.05, "load": 0.1}},
     [1, 0], ["--seed=3"], {"seed": 3}),
    ("gantry", [], {}, [0.1, 0, 0.05, 0, 0, 0.1], ["--seed=2"], {"seed": 2}),
    ("two_link", ["--plant=m2=1.6"], {"plant": {"m2": 1.6}}, [1, -0.5, 0, 0], [], {}),
]

LINES = [
    [],
    ["--version"],
    ["emit", "--help"],
    ["emit", "--lang", "klingon"],
    ["emit", "--lang", "c", "--n", "2", "--mu", "expo", "-o", "-"],
    ["emit", "--lang", "rust", "--n", "2", "--mu", "exp", "-o", "-"],
    ["check", "examples/cart.toml"],
    ["check", "examples/no such file.toml"],
    ["check", b"examples/\xff.toml"],
    ["check", "examples/table.toml", "--format", "json"],
    ["verify", "examples/pendulum.toml", "--scenarios", "16"],
    ["explain", "missing-key"],
]


class Steps(list):
    """What progress was told."""

    def __call__(self, done, total):
        self.append((done, total))


def expect(holds, what):
    """Notes a failure."""
    if not holds:
        FAILURES.append(what)


def run(line, **how):
    """A finished process."""
    return subprocess.run(line, cwd=WORKSPACE, capture_output=True, check=False, **how)


def raised(kind, work):
    """The exception of a kind that work raises."""
    try:
        work()
    except kind as error:
        return error
    FAILURES.append(f"{kind.__name__} is not raised")
    return None


def same(ours, theirs):
    """Whether two arrays have the same bits."""
    ours, theirs = np.ascontiguousarray(ours), np.ascontiguousarray(theirs, dtype=np.float64)
    return ours.shape == theirs.shape and ours.tobytes() == theirs.tobytes()


def table(text):
    """The columns of a CSV by their heads, as text."""
    head, *rows = [line.split(",") for line in text.strip().split("\n")]
    return dict(zip(head, zip(*rows)))


def numbers(columns, names):
    """Columns side by side."""
    return np.array([[float(item) for item in columns[name]] for name in names]).T


def emitted():
    """Every language of every design: the files that the command writes, or its refusal."""
    files = 0
    for path in EXAMPLES:
        design = ptc.Design.load(path)
        for lang in ["c", "rust", "cpp", "matlab", "python", "st"]:
            with tempfile.TemporaryDirectory() as folder:
                done = run([GENERATOR, "emit", path, "--lang", lang, "-o", folder])
                written = {own.name: own.read_text() for own in Path(folder).iterdir()}
            try:
                ours = ptc.emit(design, lang)
            except ptc.DesignError as error:
                expect(done.returncode == 1 or done.returncode == 2, f"{path} {lang}: {error}")
                for mistake in error.mistakes:
                    expect(mistake.message.encode() in done.stderr, f"{path} {lang}: {mistake}")
                continue
            expect(ours == written, f"{path}: other files in {lang}")
            files += len(ours)
    return f"{files} files emitted"


def checked():
    """Every check of every design."""
    checks = 0
    for path in EXAMPLES + CATALOGUE:
        theirs = json.loads(run([GENERATOR, "check", path, "--format", "json"]).stdout)
        report = ptc.check(ptc.Design.load(path))
        expect(report.accepted == theirs["accepted"], f"{path}: accepted")
        expect(report.verdict == theirs["verdict"], f"{path}: verdict")
        expect(list(report.undecided) == theirs["undecided"], f"{path}: undecided")
        for ours, check in zip(report.checks, theirs["checks"]):
            told = (ours.name, ours.verdict, ours.summary, list(ours.details), ours.fix)
            keys = ["name", "verdict", "summary", "details", "fix"]
            expect(told == tuple(check[key] for key in keys), f"{path}: {ours}")
        expect(len(report.checks) == len(theirs["checks"]), f"{path}: number of checks")
        checks += len(report.checks)
    return f"{checks} verdicts of checks"


def simulated():
    """Runs of every kind, bit for bit."""
    instants = 0
    for name, flags, keys, x0, more, arguments in RUNS:
        path = f"{WORKSPACE}/examples/{name}.toml"
        line = [GENERATOR, "simulate", path, "--x0", ",".join(map(str, x0)), *flags, *more]
        done = run(line, text=True)
        expect(done.returncode == 0, f"{line}: {done.stderr}")
        start = np.nextafter(np.array(x0, dtype=float), np.inf) if DEFECT else x0
        steps = Steps()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ptc.DesignWarning)
            ours = ptc.simulate(ptc.Design.load(path, **keys), start, **arguments, progress=steps)
        theirs = table(done.stdout)
        outputs = [column for column in theirs if column[0] == "y" and column[1:].isdigit()]
        expect(same(ours.t, numbers(theirs, ["t"])[:, 0]), f"{line}: t")
        expect(same(ours.x, numbers(theirs, ours.states)), f"{line}: x")
        inputs = numbers(theirs, ours.inputs)
        expect(same(ours.u, inputs if len(ours.inputs) > 1 else inputs[:, 0]), f"{line}: u")
        expect((ours.y is None) == (not outputs), f"{line}: y")
        if outputs:
            expect(same(ours.y, numbers(theirs, outputs)), f"{line}: y")
            own = [ptc.Status(status).name for status in ours.status]
            told = [status.replace("PTC_E_", "PTC_")[4:] for status in theirs["status"]]
            expect(own == told, f"{line}: status")
        expect(float(theirs["tau"][0]) == ours.tau, f"{line}: tau")
        told = [f"{float(e):.3e}" for e in re.findall(r"e\d = ([-+.\de]+)", done.stderr)]
        own = [] if ours.error is None else [f"{e:.3e}" for e in ours.error]
        expect(told == own, f"{line}: error {own} in place of {told}")
        expect(steps and steps[-1] == (len(ours), len(ours)), f"{line}: progress {steps[-1:]}")
        instants += len(ours)
    return f"{instants} instants of {len(RUNS)} runs"


def verified():
    """Campaigns: the report, the worst trajectory, and a draw that is run again."""
    draws = 0
    for name in ["campaign", "pendulum"]:
        path = f"{WORKSPACE}/examples/{name}.toml"
        with tempfile.TemporaryDirectory() as folder:
            worst = Path(folder) / "worst.csv"
            done = run([GENERATOR, "verify", path, "--scenarios=64", "--seed=5", "--worst", worst],
                       text=True)
            theirs = table(worst.read_text())
        steps = Steps()
        design = ptc.Design.load(path)
        ours = ptc.verify(design, scenarios=64, seed=5, draws=True, progress=steps)
        expect(ours.text == done.stdout, f"{name}: another report")
        expect({True: 0, False: 1, None: 3}[ours.holds] == done.returncode, f"{name}: holds")
        own = ours.worst
        expect(same(own.x, numbers(theirs, design.states)), f"{name}: x of the worst")
        expect(same(own.t, numbers(theirs, ["t"])[:, 0]), f"{name}: t of the worst")
        excess = [f"excess{i + 1}" for i in range(len(ours.objectives))]
        expect(same(own.excess, numbers(theirs, excess)), f"{name}: excess of the worst")
        expect(all(column.shape == (64,) for column in ours.draws.values()), f"{name}: draws")
        place = 17
        line = [GENERATOR, "verify", path, "--scenarios=64", "--seed=5", f"--scenario={place}"]
        theirs = table(run(line, text=True).stdout)
        expect(float(theirs["time_to_go"][0]) == ours.draws["tau"][place], f"{name}: tau drawn")
        start = numbers(theirs, design.states)[0]
        drawn = [ours.draws[f"{state}_0"][place] for state in design.states]
        # The trajectory begins with x as it is mapped back from stretched time.
        expect(np.allclose(drawn, start, rtol=1e-14, atol=0), f"{name}: x0 drawn")
        worse = max(objective.excess for objective in ours.objectives)
        expect(worse >= max(ours.draws[column].max() for column in excess), f"{name}: excess")
        expect(steps and steps[-1][0] == steps[-1][1] > 64, f"{name}: progress {steps[-1:]}")
        expect(steps == sorted(steps), f"{name}: progress goes back")
        draws += 64
    return f"{draws} draws of campaigns"


def refused():
    """Wrong inputs: every mistake at once, each with its line."""
    text = 'n = 2\nmu = "expo"\ngains = [1]\n'
    error = raised(ptc.DesignError, lambda: ptc.Design(text, tau=-1, foo=3))
    told = {(mistake.line, mistake.key) for mistake in error.mistakes}
    expect(told == {(2, "mu"), (3, "gains"), (None, "tau"), (None, "foo")}, f"mistakes {told}")
    expect("did you mean `exp`?" in str(error), "no near miss")
    design = ptc.Design(n=2, mu="exp(a=1)", poles=[-4, -5], tau=0.8)
    for x0, shape in [([1, 2, 3], "(3,)"), (1.0, "()"), ([[1, 2]], "(1, 2)")]:
        error = raised(ValueError, lambda x0=x0: ptc.simulate(design, x0))
        expect(shape in str(error), f"shape {shape}: {error}")
    raised(ptc.DesignError, lambda: ptc.simulate(design, [1, float("nan")]))
    raised(ptc.DesignError, lambda: ptc.simulate(design, [1, 0], at=[1.0]))
    raised(ptc.DesignError, lambda: ptc.simulate(design, [1, 0], until=2))
    raised(ptc.DesignError, lambda: ptc.verify(design))
    error = raised(ptc.DesignError, lambda: ptc.simulate(ptc.Design(n=2, mu="exp"), [1, 0]))
    expect("tau" in str(error), f"missing values: {error}")
    error = raised(ValueError, lambda: ptc.emit(design, "klingon"))
    expect("rust" in str(error), f"languages: {error}")
    raised(TypeError, lambda: ptc.Design(n=2, mu=object()))
    for work in [lambda: ptc.simulate("table.toml", [1, 0]), lambda: ptc.check("n = 2"), lambda: ptc.verify({})]:
        error = raised(TypeError, work)
        expect("Design.load(path)" in str(error), f"another type for a design: {error}")
    error = raised(ValueError, lambda: ptc.simulate(design, "ab"))
    expect("x0" in str(error), f"a text for x0: {error}")
    raised(ptc.DesignError, lambda: ptc.Design.load("no such file.toml"))
    unstable = ptc.Design(n=1, mu="exp(a=1)", gains=[2], tau=1, plant={"f": "exp(x1^2)"})
    raised(ptc.RunError, lambda: ptc.simulate(unstable, [30]))
    cart = ptc.Design.load(f"{WORKSPACE}/examples/cart.toml", eps=1e-3)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            ptc.simulate(cart, [0.1, 0, 0, 0])
        except ptc.RunError:
            pass
        else:
            expect(any(one.category is ptc.DesignWarning for one in caught), "no warning")


def strange():
    """Values that Python refuses before the library sees them: mistakes like all others."""
    design = ptc.Design.load(f"{WORKSPACE}/examples/campaign.toml")
    endless = []
    endless.append(endless)
    held = {}
    held["x"] = held
    for work in [
        lambda: ptc.Design("\ud800"),
        lambda: ptc.Design(n=2, mu="\ud800"),
        lambda: ptc.Design(n=10**5000),
        lambda: ptc.Design(n=2, gains=endless),
        lambda: ptc.Design(n=2, plant=held),
        lambda: ptc.Design(**{"\udcff": 1}),
        lambda: ptc.Design.load("\ud800.toml"),
        lambda: ptc.emit(design, "\ud800"),
        lambda: ptc.simulate(design, [10**400, 0, 0]),
        lambda: ptc.simulate(design, [1, 0, 0], seed=-1),
        lambda: ptc.simulate(design, [1, 0, 0], seed=2**64),
        lambda: ptc.simulate(design, [1, 0, 0], until=10**400),
        lambda: ptc.verify(design, seed=-1),
        lambda: ptc.verify(design, scenarios=float("inf")),
        lambda: ptc.verify(design, shard=(0, 3)),
        lambda: ptc.verify(design, shard=(4, 3)),
        lambda: ptc.merge(design, []),
    ]:
        try:
            work()
        except ptc.DesignError:
            continue
        except BaseException as error:
            FAILURES.append(f"{type(error).__name__} in place of DesignError: {error}")
        else:
            FAILURES.append("a strange value is no mistake")


def shared():
    """Other processes: designs and parts go to them, forked ones included, and parts make the whole."""
    design = ptc.Design.load(f"{WORKSPACE}/examples/campaign.toml", name="other")
    run = {"scenarios": 200, "seed": 5}
    whole = ptc.verify(design, **run, draws=True)
    for other in [copy.copy(design), copy.deepcopy(design), pickle.loads(pickle.dumps(design))]:
        expect((other.flags, repr(other)) == (design.flags, repr(design)), "a copy is another design")
        expect(ptc.verify(other, **run).text == whole.text, "the verdict of a copy")
    for kind in ["fork", "spawn"]:
        with multiprocessing.get_context(kind).Pool(2) as pool:
            work = pool.starmap_async(part_of, [(design, run, (i, 3)) for i in [3, 1, 2]])
            try:
                parts = work.get(timeout=HANGS)
            except multiprocessing.TimeoutError:
                pool.terminate()
                FAILURES.append(f"{kind}: no answer in {HANGS} s")
                continue
        merged = ptc.merge(design, parts, **run, draws=True)
        expect(merged.text == whole.text, f"{kind}: another report of the parts")
        expect(all(same(merged.draws[name], own) for name, own in whole.draws.items()), f"{kind}: draws")
        for wrong in [parts[:2], [*parts, parts[0]]]:
            raised(ptc.DesignError, lambda wrong=wrong: ptc.merge(design, wrong, **run))
        raised(ptc.DesignError, lambda: ptc.merge(design, parts, scenarios=200, seed=6))
    return "parts of a campaign in forked and spawned processes"


def part_of(design, run, shard):
    """What a process of a pool does."""
    if HANG:
        time.sleep(1000)
    return ptc.verify(design, **run, shard=shard)


def stopped():
    """What progress raises and Ctrl-C stop the work, soon."""
    long = ptc.Design.load(f"{WORKSPACE}/examples/campaign.toml")
    table = ptc.Design.load(f"{WORKSPACE}/examples/table.toml", sample_time=1e-6)

    def stop(*_):
        raise KeyError("stop")

    def interrupt():
        os.kill(os.getpid(), signal.SIGINT)

    works = [
        lambda progress: ptc.verify(long, scenarios=10**6, progress=progress),
        lambda progress: ptc.simulate(table, [1, 0], until=9, progress=progress),
    ]
    for work in works:
        began = time.process_time()
        raised(KeyError, lambda work=work: work(stop))
        threading.Timer(0.5, interrupt).start()
        raised(KeyboardInterrupt, lambda work=work: work(None))
        took = time.process_time() - began
        # All of it takes many minutes; a chunk of scenarios is run to its end.
        expect(took < 60, f"it takes {took} processor seconds to stop")
    # The interpreter is free meanwhile.
    ticks = []
    done = threading.Event()

    def tick():
        while not done.wait(0.01):
            ticks.append(None)

    thread = threading.Thread(target=tick)
    thread.start()
    began = time.monotonic()
    ptc.verify(long, scenarios=256)
    took = time.monotonic() - began
    done.set()
    thread.join()
    expect(len(ticks) > 10 * took, f"other threads wait: {len(ticks)} ticks in {took} s")


def documented():
    """The examples of the page, one after the other, print what stands below each."""
    text = (Path(WORKSPACE) / "docs/guide/python.md").read_text()
    blocks = re.findall(r"```(python|text)\n(.*?)```", text, re.DOTALL)
    own = {}
    with tempfile.TemporaryDirectory() as folder:
        for path in EXAMPLES:
            shutil.copy(path, folder)
        os.chdir(folder)
        for kind, block in blocks:
            if kind == "python":
                printed = io.StringIO()
                with contextlib.redirect_stdout(printed), warnings.catch_warnings():
                    warnings.simplefilter("error")
                    exec(block, own)
                lines = [line.split("\r")[-1] for line in printed.getvalue().split("\n")]
            else:
                expect(lines == block.split("\n"), f"the page has {block}, in place of {lines}")
        os.chdir(WORKSPACE)
    return f"{len(blocks) // 2} examples of the page"


def commanded():
    """The command of the wheel is the program: exit codes, both streams, pipes and signals."""
    for line in LINES:
        ours, theirs = run([COMMAND, *line]), run([GENERATOR, *line])
        for part in ["returncode", "stdout", "stderr"]:
            expect(getattr(ours, part) == getattr(theirs, part), f"{line}: {part}: {ours}")
    closed = [["sh", "-c", f"'{own}' list >&-; echo $?"] for own in [COMMAND, GENERATOR]]
    gone = [["sh", "-c", f"('{own}' schema; echo $? >&2) | true"] for own in [COMMAND, GENERATOR]]
    for ours, theirs in [closed, gone]:
        ours, theirs = run(ours), run(theirs)
        expect((ours.stdout, ours.stderr) == (theirs.stdout, theirs.stderr), f"streams: {ours}")
    with tempfile.TemporaryDirectory() as folder:
        line = ["verify", "examples/campaign.toml", "--scenarios=1000000", "--out"]
        ended = []
        for own in [COMMAND, GENERATOR]:
            # One that is run in the background of a shell ignores the signal.
            out = f"{folder}/{len(ended)}.parquet"
            process = subprocess.Popen([own, *line, out], cwd=WORKSPACE, stderr=subprocess.DEVNULL)
            while not os.listdir(folder) and process.poll() is None:
                time.sleep(0.05)
            time.sleep(0.5)
            process.send_signal(signal.SIGINT)
            ended.append((process.wait(60), sorted(own.split(".", 1)[1] for own in os.listdir(folder))))
            for own in os.listdir(folder):
                os.remove(f"{folder}/{own}")
    expect(ended[0] == ended[1] and ended[0][0] == -signal.SIGINT, f"interrupted: {ended}")
    return f"{len(LINES) + 3} command lines"


def main():
    """Runs all parts, or the one that a defect is put into."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    all_parts = [emitted, checked, simulated, verified, refused, strange, shared, stopped, documented, commanded]
    told = [part() for part in ([simulated] if DEFECT else [shared] if HANG else all_parts)]
    for failure in FAILURES:
        print(failure, file=sys.stderr)
    print("; ".join(filter(None, told)))
    return bool(FAILURES)


if __name__ == "__main__":
    sys.exit(main())
