"""A design with a model beside a function by hand: both compiled by gcc -std=c99 -O2 and counted by callgrind in one call."""

import re
import subprocess

TAU, TIME = 2.0, 0.5


def design(name, poles, model):
    """The text of a design without limits and guards, as the function by hand has none."""
    return f"""name = "{name}"
mu = "exp(a=1)"
poles = {poles}
u_max = inf
guard = "none"
[params]
tau = {TAU}
eps = 0.02
t0 = 0
[model]
{model}"""


def run(folder, *words):
    return subprocess.run(words, cwd=folder, capture_output=True, text=True, check=True).stdout


def counted(folder, name, hand, driver):
    """Instructions of the emitted step and of the function by hand, and the numbers that the driver prints."""
    (folder / "hand.c").write_text(hand)
    (folder / "main.c").write_text(driver)
    # Without lazy binding, which the first call of a function would take some hundred instructions for.
    run(folder, "gcc", "-std=c99", "-O2", "-Wl,-z,now", f"{name}.c", "hand.c", "main.c", "-lm", "-o", "run")
    pairs = [tuple(map(float, line.split())) for line in run(folder, "./run").splitlines()]
    run(folder, "valgrind", "--tool=callgrind", "--callgrind-out-file=counts", "./run")
    listed = run(folder, "callgrind_annotate", "--inclusive=yes", "--threshold=100", "counts")
    of = lambda function: int(re.search(rf"^ *([\d,]+) .*:{function}\b", listed, re.M)[1].replace(",", ""))
    return of(f"{name}_step"), of("hand"), pairs
