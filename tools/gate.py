"""One wild reading at sample 400 of examples/encoder.toml, without and with a gate of its observer.

    python3 tools/gate.py COMMAND [INNOVATION_MAX]

COMMAND is the path of ptc-codegen; the gate is 1e-4 m if no other is given. Needs a C compiler called cc. The loop starts
at rest at 0.1 m, against a force of 0.3 N.
"""

import ctypes
import subprocess
import sys
import tempfile
from pathlib import Path

DESIGN = Path(__file__).parent.parent / "examples" / "encoder.toml"
END, WILD = 800, 400
STEP, PERIOD, MASS, FORCE = 1e-6, 1e-3, 1.5, 0.3
SATURATED, GATED = 2, 4


def emitted(command, folder, flags):
    """The controller with `flags`, as a shared library."""
    emit = [command, "emit", DESIGN, "--lang", "c", "-o", folder]
    subprocess.run([*emit, *flags], check=True, stdout=subprocess.DEVNULL)
    library = Path(folder) / "stage.so"
    flags = ["-std=c99", "-O2", "-ffp-contract=off", "-shared", "-fPIC"]
    subprocess.run(["cc", *flags, Path(folder) / "stage.c", "-o", library, "-lm"], check=True)
    return ctypes.CDLL(library)


def motion(controller, wild):
    """|x1| at the deadline and 2 s later, and how many samples had each status until then."""
    state, u = ctypes.create_string_buffer(4096), ctypes.c_double()
    controller.stage_init(state, ctypes.byref(ctypes.c_char()))
    x, late, statuses, at = (0.1, 0.0), 0.0, [], []
    for k in range(END + 2001):
        if k in (END, END + 2000):
            at.append(abs(x[0]))
        y = wild if k == WILD and wild is not None else round(x[0] / STEP) * STEP
        given = (ctypes.c_double * 1)(y)
        statuses.append(controller.stage_step(state, ctypes.c_uint32(k), given, ctypes.byref(u)))
        a = (late + FORCE) / MASS
        x = (x[0] + PERIOD * x[1] + PERIOD**2 / 2 * a, x[1] + PERIOD * a)
        late = u.value
    counts = [statuses.count(SATURATED), statuses.count(GATED), sum(s < 0 for s in statuses)]
    return at, counts


def main():
    command, bound = (sys.argv[1:] + ["1e-4"])[:2]
    gated = ["--innovation-max", bound, "--coast", "5"]
    readings = [("none", None), ("2^31 counts", 2**31 * STEP), ("1e100", 1e100), ("NaN", float("nan"))]
    print("| reading | gate | abs(x1) at 0.8 s [m] | at 2.8 s [m] | saturated | gated | refused |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for name, wild in readings:
        for gate in ([], gated):
            with tempfile.TemporaryDirectory() as folder:
                at, counts = motion(emitted(command, folder, gate), wild)
            sizes = " | ".join(f"{size:.1e}" for size in at)
            numbers = " | ".join(map(str, counts))
            print(f"| {name} | {'yes' if gate else 'no'} | {sizes} | {numbers} |")


if __name__ == "__main__":
    main()
