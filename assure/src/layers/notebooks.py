"""The notebooks of the examples, and what the module shows in one.

Usage: notebooks.py GENERATOR WORKSPACE [--defect|--broken]. With --defect a picture is of another run, and with
--broken a notebook has a cell that raises, which have to be seen.
"""

import contextlib
import io
import pickle
import subprocess
import sys
import tempfile
import warnings
from pathlib import Path

import nbclient
import nbformat
import numpy as np
import ptc_codegen as ptc

GENERATOR, WORKSPACE = sys.argv[1:3]
DEFECT = "--defect" in sys.argv
BROKEN = "--broken" in sys.argv
FAILURES = []

NOTEBOOKS = sorted(Path(WORKSPACE).glob("examples/notebooks/*.ipynb"))

# A design, its flags, the same as keywords, x0, and whether its axes are logarithmic.
PICTURES = [
    ("table", [], {}, [1, 0.25], False),
    ("table", ["--sample-time=5e-5"], {"sample_time": 5e-5}, [1, 0], False),
    ("track", ["--sample-time=1e-3"], {"sample_time": 1e-3}, [0.3, 0], False),
    ("motor", [], {}, [1, 0, 0], True),
    ("two_link", ["--plant=m2=1.6"], {"plant": {"m2": 1.6}}, [1, -0.5, 0, 0], False),
]

# Designs whose cards are looked at: without a value for the plant, of a model, of axes, with bounds of x0.
CARDS = ["campaign", "cart", "gantry", "table"]

CAMPAIGN = """
name = "stage"
n = 2
units = "mm"
mu = "exp(a=1)"
poles = [-4, -5]
tau = 0.4
sample_time = 4e-3
noise = [1e-3, 0]
[plant]
f = "gust + load"
gust = [-200, 200]
load = [-1, 1]
[disturbance]
gust = "any"
load = "constant"
[verify]
x1 = [-10, 10]
x2 = 0
scenarios = 60
[[objective]]
bound = "attractive"
error = 12
"""


def expect(holds, what):
    """Notes a failure."""
    if not holds:
        FAILURES.append(what)


def raised(kind, work):
    """The exception of a kind that work raises, as text."""
    try:
        work()
    except kind as error:
        return str(error)
    FAILURES.append(f"{kind.__name__} is not raised")
    return ""


def executed():
    """Every notebook, in a kernel of its own."""
    cells = 0
    for path in NOTEBOOKS:
        notebook = nbformat.read(path, as_version=4)
        nbformat.validate(notebook)
        code = [cell for cell in notebook.cells if cell.cell_type == "code"]
        kept = [cell for cell in code if cell.outputs or cell.execution_count is not None]
        expect(not kept, f"{path.name}: holds outputs")
        if BROKEN:
            code[-1].source += "\nprint(undefined)"
        client = nbclient.NotebookClient(notebook, timeout=60, resources={"metadata": {"path": path.parent}})
        try:
            client.execute()
        except nbclient.exceptions.CellExecutionError as error:
            FAILURES.append(f"{path.name}: {str(error).splitlines()[-1]}")
            continue
        outputs = [output for cell in code for output in cell.outputs]
        for output in outputs:
            told = output.get("text", "") if output.get("name") == "stderr" else ""
            expect("Warning" not in told, f"{path.name}: {told}")
        data = [kind for output in outputs for kind in output.get("data", {})]
        expect("text/html" in data or "application/vnd.jupyter.widget-view+json" in data,
               f"{path.name}: shows {sorted(set(data))}")
        cells += len(code)
    expect(len(NOTEBOOKS) >= 3, "there are no notebooks")
    return f"{cells} cells of {len(NOTEBOOKS)} notebooks"


def drawn():
    """Pictures of runs: the bytes of the files that the command writes."""
    files = 0
    for name, flags, keys, x0, log in PICTURES:
        path = f"{WORKSPACE}/examples/{name}.toml"
        with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
            warnings.simplefilter("ignore", ptc.DesignWarning)
            own = x0 if not DEFECT else [2 * x0[0], *x0[1:]]
            run = ptc.simulate(ptc.Design.load(path, **keys), own)
            again = pickle.loads(pickle.dumps(run)).plot(log=log)
            for kind in ["svg", "png", "pdf"]:
                ours, theirs = f"{folder}/ours.{kind}", f"{folder}/theirs.{kind}"
                line = [GENERATOR, "simulate", path, *flags, f"--x0={','.join(map(str, x0))}", "-o", f"{folder}/run.csv"]
                done = subprocess.run([*line, "--plot", theirs, *(["--log"] if log else [])],
                                      capture_output=True, text=True, check=False)
                expect(done.returncode == 0, f"{line}: {done.stderr}")
                run.plot(log=log).save(ours)
                expect(Path(ours).read_bytes() == Path(theirs).read_bytes(), f"{name} {flags}: another {kind}")
                files += 1
            expect(again.svg == run.plot(log=log).svg, f"{name}: a copy is drawn differently")
    several = [ptc.simulate(ptc.Design.load(f"{WORKSPACE}/examples/table.toml", tau=tau), [1, 0]) for tau in [1, 2]]
    text = ptc.plot(several).svg
    expect("tau = 1 s" in text and "tau = 2 s" in text, "a picture of two runs")
    expect("slow" in ptc.plot(several, labels=["fast", "slow"]).svg, "labels")
    at = ptc.simulate(ptc.Design(n=2, mu="exp(a=1)", poles=[-4, -5], tau=1), [1, 0], at=[0, 0.5])
    for what, work in [
        ("called", lambda: ptc.plot([several[0], several[0]])),
        ("one for each run", lambda: ptc.plot(several, labels=["one"])),
        ("`at`", at.plot),
        ("no run", lambda: ptc.plot([])),
        (".svg, .png or .pdf", lambda: several[0].plot().save("run.jpg")),
        ("other plants", lambda: ptc.plot([several[0], ptc.simulate(
            ptc.Design(n=1, mu="exp(a=1)", poles=[-4], tau=1), [1])])),
    ]:
        told = raised(ptc.DesignError, work)
        expect(what in told, f"{what}: {told}")
    return f"{files} pictures"


def tabulated():
    """Tables with units, and the columns of drawn signals."""
    design = ptc.Design(CAMPAIGN)
    run = ptc.simulate(design.replace(plant={"gust": 0, "load": 0.5}), [10, 0], seed=3)
    expect(run.units == {"t": "s", "x1": "mm", "x2": "mm/s", "u": "mm/s^2"}, f"units {run.units}")
    table = run.frame()
    expect(list(table) == ["t", "x1", "x2", "u", "y1", "y2", "status"], f"columns {list(table)}")
    expect(np.array_equal(table["x2"], run.x[:, 1]) and table.attrs["units"]["u"] == "mm/s^2", "table")
    expect(list(run.frame(labelled=True))[:4] == ["t [s]", "x1 [mm]", "x2 [mm/s]", "u [mm/s^2]"], "labels")
    verdict = ptc.verify(design, draws=True)
    expect(list(verdict.worst.frame())[:5] == ["t", "time_to_go", "x1", "x2", "u"], "worst")
    rows = verdict.frame()
    expect(len(rows) == 60 and rows.attrs["units"]["x2_0"] == "mm/s", "rows")
    expect(rows["seed"].is_unique and np.isfinite(rows["load.value"]).all(), "seeds and constants")
    expect("load.periods" not in rows, "numbers of signals that are not drawn")
    kinds = [ptc.SIGNALS[int(kind)] for kind in rows["gust.signal"]]
    expect(set(kinds) == set(ptc.SIGNALS), f"signals {set(kinds)}")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "stage.toml"
        path.write_text(CAMPAIGN)
        for place, row in rows.iloc[:24].iterrows():
            drawn, written = (replayed(path, text) for text in [str(place), scenario(row)])
            expect(np.allclose(drawn, written, rtol=1e-9, atol=1e-9), f"draw {place} is not {scenario(row)}")
    report = ptc.check(ptc.Design.load(f"{WORKSPACE}/examples/table.toml")).frame()
    expect("sound" in set(report["verdict"]), "checks")
    return f"{len(rows)} rows with signals"


def scenario(row):
    """The scenario of a row, made of its columns alone, as the command reads it."""
    kind = ptc.SIGNALS[int(row["gust.signal"])]
    if kind == "constant":
        gust = repr(float(row["gust.value"]))
    elif kind in ("sine", "square"):
        # The command counts half periods of a square.
        gust = f"{kind}({row['gust.periods'] * (2 if kind == 'square' else 1)}, {row['gust.phase']})"
    else:
        levels = [float(row[f"gust.{piece + 1}"]) for piece in range(16)]
        if kind == "worst":
            ends = [begin(piece) for piece in range(1, 16) if levels[piece] != levels[piece - 1]]
            levels = [levels[0], *ends]
        gust = f"{kind}({', '.join(map(str, levels))})"
    return (f"tau = {row['tau']}, x1 = {row['x1_0']}, x2 = 0, gust = {gust}, load = {row['load.value']}, "
            f"seed = {int(row['seed'])}")


def begin(piece):
    """T/tau at which one of 16 pieces begins: 8 even in time, then 8 even in the logarithm, down to 1e-3."""
    last = 0.125
    return 1 - (1 - last) * piece / 8 if piece <= 8 else last * (1e-3 / last) ** (piece / 8 - 1)


def replayed(path, text):
    """The states and u of the run of a scenario."""
    done = subprocess.run([GENERATOR, "verify", path, f"--scenario={text}"],
                          capture_output=True, text=True, check=False)
    expect(done.returncode == 0, f"{text}: {done.stderr}")
    return np.array([line.split(",")[2:5] for line in done.stdout.splitlines()[1:]], dtype=float)


def carded():
    """Designs that show themselves."""
    for name in CARDS:
        path = Path(WORKSPACE) / f"examples/{name}.toml"
        design = ptc.Design.load(path)
        html = design._repr_html_()
        expect(ptc.check(design).verdict.split("`")[0] in html.replace("&#39;", "'"), f"{name}: verdict")
        expect(("data:image/svg" in html) != ("No picture" in html), f"{name}: picture")
        expect("<script" not in html, f"{name}: scripts")
    odd = ptc.Design(n=2, mu="exp(a=1)", poles=[-4, -5], name="stage", plant={"f": "-k*x2"})
    expect("No picture" in odd._repr_html_() and "tau" in odd._repr_html_(), "what a picture lacks")
    bounds = ptc.Design(n=2, mu="exp(a=1)", poles=[-4, -5], tau=1, x0_max=[0.5, 2])
    expect("From x0 = (0.5, 2.0)" in bounds._repr_html_(), "x0_max")
    return "cards"


def explored():
    """The widget, as a browser drives it."""
    design = ptc.Design(n=2, mu="exp(a=1)", poles=[-4, -5], tau=0.8, plant={"f": "-damping*x2", "damping": 0.5})
    widget = design.explore([1, 0], tau=(0.2, 20), plant={"damping": (0, 5)})
    knobs = {knob["key"]: (knob["value"], knob["wide"]) for knob in widget.knobs}
    expect(knobs == {"tau": (0.8, True), "plant.damping": (0.5, False)}, f"knobs {knobs}")
    before = widget.html
    widget.asked = {"number": 2, "values": {"tau": 1.5, "plant.damping": 2}}
    expect(widget.html != before and widget.answered == 2, "an answer")
    expect(widget.html == design.replace(tau=1.5, plant={"damping": 2}).card([1, 0]), "another answer")
    widget.asked = {"number": 3, "values": {"tau": -1}}
    expect("tau" in widget.html and "ptc-wrong" in widget.html and widget.answered == 3, "a refused value")
    expect(widget.design.replace(tau=1).flags == design.replace(tau=1).flags, "the design of the widget")
    expect("no range" in raised(ptc.DesignError, lambda: design.explore(tau=(2, 1))), "a wrong range")
    expect("tau=(0.2, 2)" in raised(ptc.DesignError, design.explore), "no range")
    return "the widget"


def lacking():
    """Without a package its name and its extra are told; bars become lines; the former name warns."""
    code = """
import sys
for name in ["pandas", "anywidget", "tqdm", "tqdm.auto"]:
    sys.modules[name] = None
import ptc_codegen as ptc
design = ptc.Design(n=2, mu="exp(a=1)", poles=[-4, -5], tau=1, sample_time=1e-5)
run = ptc.simulate(design, [1, 0], progress=True)
for work in [run.frame, lambda: design.explore(tau=(1, 2))]:
    try:
        work()
    except ModuleNotFoundError as error:
        print(error)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    expect(done.stdout.count('pip install "ptc_codegen[notebook]"') == 2, f"missing: {done}")
    expect("simulate: 100001 of 100001" in done.stderr, f"a line of progress: {done.stderr[-200:]!r}")
    shown = io.StringIO()
    with contextlib.redirect_stderr(shown):
        ptc.simulate(ptc.Design(n=2, mu="exp(a=1)", poles=[-4, -5], tau=1), [1, 0], progress=True)
    expect("simulate" in shown.getvalue(), f"a bar: {shown.getvalue()!r}")
    code = "import ptc, ptc_codegen; print(ptc.Design is ptc_codegen.Design, ptc.verify is ptc_codegen.verify)"
    done = subprocess.run([sys.executable, "-W", "always", "-c", code], capture_output=True, text=True, check=False)
    expect(done.stdout == "True True\n" and "import ptc_codegen as ptc" in done.stderr, f"former name: {done}")


def main():
    """Runs all parts, or the one that a defect is put into."""
    parts = [executed] if BROKEN else [drawn] if DEFECT else [executed, drawn, tabulated, carded, explored, lacking]
    told = [part() for part in parts]
    for failure in FAILURES:
        print(failure, file=sys.stderr)
    print("; ".join(filter(None, told)))
    return bool(FAILURES)


if __name__ == "__main__":
    sys.exit(main())
