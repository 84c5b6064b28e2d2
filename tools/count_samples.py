"""Instructions of a step of the emitted C with a clock in samples, by callgrind.

    python3 tools/count_samples.py COMMAND

COMMAND is the path of ptc-codegen. Needs valgrind and a C compiler called cc.
"""

import argparse
import subprocess
import tempfile
from pathlib import Path

COUNTED = r"""
#include "probe.h"
int main(void)
{
    static const double x[4] = { 0.5, 0.25, 0.125, 0.0625 };
    const probe_params params = { 0 };
    probe self;
    double u;
    int status = probe_init(&self, &params);

    for (uint32_t k = 0; k < 1000u; k++) {
        status |= probe_step(&self, k, x, &u);
    }
    return status < 0;
}
"""


def counted(command, *flags):
    """Instructions of a step in x86-64 code of `cc -O2`, the mean over a run of 1000 samples."""
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        emit = [command, "emit", "--lang", "c", "--name", "probe", "-o", folder, *flags]
        subprocess.run(emit, check=True, stdout=subprocess.DEVNULL)
        (folder / "main.c").write_text(COUNTED)
        for name in ("probe", "main"):
            subprocess.run(["cc", "-O2", "-c", folder / f"{name}.c", "-o", folder / f"{name}.o"], check=True)
        program, events = folder / "counted", folder / "events"
        subprocess.run(["cc", folder / "probe.o", folder / "main.o", "-o", program, "-lm"], check=True)
        grind = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={events}", "--toggle-collect=probe_step"]
        subprocess.run([*grind, program], check=True, stderr=subprocess.DEVNULL)
        totals = next(line for line in events.read_text().splitlines() if line.startswith("totals:"))
        return round(int(totals.split()[1]) / 1000)


def count(command):
    """Rows of Markdown, a delay each, with n = 1..4: without guards and bound, and with both."""
    for delay in range(3):
        cells = []
        for n in range(1, 5):
            own = ",".join(f"-{n + delay + i}" for i in range(n + delay))
            flags = ["--n", str(n), "--mu", "exp(a=1)", "--clock", "samples", "--sample-time", "1e-3",
                     "--tau", "1", "--delay", str(delay), f"--poles={own}"]
            bare = counted(command, *flags, "--guard", "none", "--u-max", "inf")
            cells.append(f"{bare}, {counted(command, *flags, '--u-max', '1e30')}")
        print("|", " | ".join([str(delay), *cells]), "|")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("command", metavar="COMMAND")
    count(parser.parse_args().command)
