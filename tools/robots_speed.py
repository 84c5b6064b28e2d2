"""Counts the instructions of one call of inverse dynamics: the emitted C, Pinocchio's `rnea`, and CasADi's C; and those
of a step of the emitted controller, which has the law of each joint and its inverse dynamics.

All are compiled with -O2 for the same processor and called at the same states under callgrind, sine and cosine
included. CasADi is given the textbook algorithm on spatial vectors, with the numbers of the robot known.

    pip install pin example-robot-data casadi numpy; apt install valgrind libeigen3-dev
    python3 tools/robots_speed.py --command target/release/ptc-codegen
"""

import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import casadi
import numpy as np

import robots

PREFIX = next(Path(p) for p in sys.path if "site-packages" in p) / "cmeel.prefix"
NAMES = ["panda", "ur5", "xarm7", "z1", "so101", "kinova"]
# Pinocchio and CasADi are not given the friction of the file.
SMOOTH = ["--damping", "0", "--friction", "0"]

# One call per state; the sum keeps the calls.
DRIVER = """
#include <stdio.h>
#include <stdlib.h>
HEAD
int main(int count, char **arguments) {
    unsigned state = 1U;
    double sum = 0.0, q[N], v[N], a[N], torque[N];
    BEFORE
    (void)count;
    for (int call = atoi(arguments[1]); call > 0; call--) {
        for (int i = 0; i < N; i++) {
            state = state * 1664525U + 1013904223U;
            q[i] = (double)state / 4294967296.0 * 6.0 - 3.0;
            v[i] = 0.5 - q[i] / 3.0;
            a[i] = q[i] * 2.0;
        }
        CALL
        for (int i = 0; i < N; i++) { sum += torque[i]; }
    }
    printf("%.17g\\n", sum);
    return 0;
}
"""


def instructions(program, *more):
    """Instructions of a call: the difference of two runs."""
    def run(calls):
        words = [str(program), str(calls), *map(str, more)]
        done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *words],
                              check=True, capture_output=True, text=True)
        return int(re.search(r"Collected : (\d+)", done.stderr).group(1)), float(done.stdout)
    (few, _), (many, total) = run(1000), run(3000)
    return (many - few) / 2000, total


def build(folder, name, compiler, parts, flags):
    text = DRIVER
    for key in ("HEAD", "BEFORE", "CALL"):
        text = text.replace(key, parts[key])
    source = folder / f"{name}.c"
    source.write_text(re.sub(r"\bN\b", str(parts["N"]), text))
    program = folder / name
    subprocess.run([*compiler, "-O2", *parts.get("sources", []), str(source), "-o", str(program), *flags], check=True)
    return program


def emitted(command, path, base, tip, folder, guard):
    words = [command, "emit", "--lang", "c", "--urdf", str(path), "--what", "inverse-dynamics", "--guard", guard, *SMOOTH]
    words += ["--base", base] if base else []
    words += ["--tip", tip] if tip else []
    subprocess.run([*words, "--name", f"arm_{guard}", "-o", str(folder)], check=True, stdout=subprocess.DEVNULL)
    return {
        "HEAD": f'#include "arm_{guard}.h"',
        "BEFORE": f"arm_{guard} arm; arm_{guard}_params none; arm_{guard}_init(&arm, &none);",
        "CALL": f"arm_{guard}_inverse_dynamics(&arm, q, v, a, torque);",
        "sources": [str(folder / f"arm_{guard}.c"), f"-I{folder}"],
    }


def controller(command, robot, folder):
    """A step of the controller at t = 0.5 s, with limits of u that no torque reaches."""
    _, folder = robots.compiled([command], "law", robot, [*robots.LAW[:-1], "1e9", *SMOOTH], folder)
    return {
        "HEAD": '#include "law.h"',
        "BEFORE": "law arm; law_params none; ptc_status axes[N]; double x[2 * N]; (void)a; law_init(&arm, &none);",
        "CALL": "for (int i = 0; i < N; i++) { x[i] = q[i]; x[N + i] = v[i]; } law_step(&arm, 0.5, x, torque, axes);",
        "sources": [str(folder / "law.c"), f"-I{folder}"],
    }


# Pinocchio's rnea of a model that is read from a file: compiled once, as that takes a minute.
PINOCCHIO = """
#include <cmath>
#include <fstream>
#include <iostream>
#include <pinocchio/algorithm/rnea.hpp>
using namespace pinocchio;
int main(int, char **arguments) {
    std::ifstream file(arguments[2]);
    int n;
    file >> n;
    Model model;
    for (int j = 1; j <= n; j++) {
        int parent;
        std::string kind;
        double x[22];
        file >> parent >> kind;
        for (double &own : x) { file >> own; }
        const SE3 at(Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(x), Eigen::Vector3d(x[9], x[10], x[11]));
        Eigen::Matrix3d tensor;
        tensor << x[16], x[17], x[18], x[17], x[19], x[20], x[18], x[20], x[21];
        const Inertia inertia(x[12], Eigen::Vector3d(x[13], x[14], x[15]), tensor);
        JointModel joint;
        if (kind == "RX") { joint = JointModelRX(); } else if (kind == "RY") { joint = JointModelRY(); }
        else if (kind == "RZ") { joint = JointModelRZ(); } else if (kind == "RUBZ") { joint = JointModelRUBZ(); }
        else { return 1; }
        model.addJoint(parent, joint, at, std::to_string(j));
        model.appendBodyToJoint(j, inertia, SE3::Identity());
    }
    Data data(model);
    Eigen::VectorXd q = Eigen::VectorXd::Zero(model.nq), v(n), a(n);
    unsigned state = 1U;
    double sum = 0.0, given[64];
    for (int call = std::atoi(arguments[1]); call > 0; call--) {
        for (int i = 0; i < n; i++) {
            state = state * 1664525U + 1013904223U;
            given[i] = (double)state / 4294967296.0 * 6.0 - 3.0;
            v[i] = 0.5 - given[i] / 3.0;
            a[i] = given[i] * 2.0;
        }
        if (model.nq == n) {
            for (int i = 0; i < n; i++) { q[i] = given[i]; }
        } else {
            for (int j = 1; j <= n; j++) {
                const int place = model.joints[j].idx_q();
                if (model.joints[j].nq() == 2) { q[place] = std::cos(given[j - 1]); q[place + 1] = std::sin(given[j - 1]); }
                else { q[place] = given[j - 1]; }
            }
        }
        const Eigen::VectorXd &torque = rnea(model, data, q, v, a);
        for (int i = 0; i < n; i++) { sum += torque[i]; }
    }
    std::printf("%.17g\\n", sum);
    return 0;
}
"""


def written(model, file):
    """The numbers of a model for that program."""
    lines = [str(model.njoints - 1)]
    for j in range(1, model.njoints):
        at, inertia = model.jointPlacements[j], model.inertias[j]
        tensor = inertia.inertia[np.triu_indices(3)]
        numbers = [*at.rotation.flat, *at.translation, inertia.mass, *inertia.lever, *tensor]
        kind = model.joints[j].shortname().removeprefix("JointModel")
        lines.append(f"{model.parents[j]} {kind} " + " ".join(repr(float(own)) for own in numbers))
    file.write_text("\n".join(lines) + "\n")


def pinocchio_program(folder):
    source, program = folder / "pinocchio.cpp", folder / "pinocchio"
    source.write_text(PINOCCHIO)
    libraries = [f"-L{PREFIX}/lib", "-lpinocchio_default", f"-Wl,-rpath,{PREFIX}/lib"]
    flags = [f"-I{PREFIX}/include", "-I/usr/include/eigen3", "-std=c++17", "-O2", "-DNDEBUG", "-w",
             "-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS", "-DBOOST_FUSION_INVOKE_MAX_ARITY=10"]
    subprocess.run(["g++", *flags, str(source), "-o", str(program), *libraries], check=True)
    return program


def casadi_code(model, folder):
    """CasADi's C of the recursive Newton-Euler algorithm."""
    n = model.nv
    q, v, a = (casadi.SX.sym(name, n) for name in "qva")

    def motion(spatial):
        (x, y, z), (p, r, s) = spatial[:3], spatial[3:]
        turn = casadi.vertcat(casadi.horzcat(0, -s, r), casadi.horzcat(s, 0, -p), casadi.horzcat(-r, p, 0))
        shift = casadi.vertcat(casadi.horzcat(0, -z, y), casadi.horzcat(z, 0, -x), casadi.horzcat(-y, x, 0))
        return casadi.vertcat(casadi.horzcat(turn, shift), casadi.horzcat(casadi.SX(3, 3), turn))

    def parts(spatial):
        return [spatial[i] for i in range(6)]

    rates, accelerations, forces, placements = {}, {}, {}, {}
    down = casadi.SX(np.concatenate([-model.gravity.linear, np.zeros(3)]))
    for j in range(1, model.njoints):
        i = model.joints[j].idx_v
        kind = model.joints[j].shortname()
        axis = np.zeros(6)
        place = "XYZ".index(kind[-1])
        axis[place + (0 if "JointModelP" in kind else 3)] = 1.0
        fixed, rotation, shift = model.jointPlacements[j], casadi.SX.eye(3), casadi.SX(3, 1)
        if "JointModelP" in kind:
            shift[place] = q[i]
        else:
            c, s, (b, d) = casadi.cos(q[i]), casadi.sin(q[i]), ((place + 1) % 3, (place + 2) % 3)
            rotation[b, b], rotation[d, d], rotation[b, d], rotation[d, b] = c, c, -s, s
        constant = np.where(np.abs(fixed.rotation) < 1e-15, 0.0, fixed.rotation)
        constant = np.where(np.abs(np.abs(constant) - 1) < 1e-15, np.round(constant), constant)
        r = casadi.sparsify(casadi.SX(constant)) @ rotation
        p = casadi.SX(fixed.translation) + casadi.SX(constant) @ shift
        skew = casadi.skew(p)
        # From the body to its parent.
        up = casadi.vertcat(casadi.horzcat(r, skew @ r), casadi.horzcat(casadi.SX(3, 3), r))
        back = casadi.vertcat(casadi.horzcat(r.T, -r.T @ skew), casadi.horzcat(casadi.SX(3, 3), r.T))
        placements[j] = up, back
        parent = model.parents[j]
        own = casadi.SX(axis) * v[i]
        rates[j] = back @ rates.get(parent, casadi.SX(6, 1)) + own
        accelerations[j] = back @ accelerations.get(parent, down) + casadi.SX(axis) * a[i] + motion(parts(rates[j])) @ own
        inertia = casadi.SX(model.inertias[j].matrix())
        forces[j] = inertia @ accelerations[j] - motion(parts(rates[j])).T @ (inertia @ rates[j])
    torque = casadi.SX(n, 1)
    for j in range(model.njoints - 1, 0, -1):
        kind = model.joints[j].shortname()
        torque[model.joints[j].idx_v] = forces[j]["XYZ".index(kind[-1]) + (0 if "JointModelP" in kind else 3)]
        if model.parents[j]:
            forces[model.parents[j]] += placements[j][1].T @ forces[j]
    function = casadi.Function("casadi_rnea", [q, v, a], [torque])
    function.generate("casadi_rnea.c", {"with_header": False})
    Path("casadi_rnea.c").rename(folder / "casadi_rnea.c")
    return {
        "HEAD": "int casadi_rnea(const double **given, double **result, long long *iw, double *w, int mem);",
        "BEFORE": f"double w[{max(1, function.sz_w())}];",
        "CALL": "const double *given[3 + 8] = {q, v, a}; double *result[8] = {torque}; casadi_rnea(given, result, 0, w, 0);",
        "sources": [str(folder / "casadi_rnea.c"), "-Dcasadi_int=long long"],
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", default="target/release/ptc-codegen", help="the program ptc-codegen")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        compare(given.command, pinocchio_program(Path(temporary)))


def compare(command, compiled):
    print(f"| robot | joints | emitted C | without guards | controller | Pinocchio | CasADi |\n|{' --- |' * 7}")
    for name, file, base, tip in robots.ROBOTS:
        if name not in NAMES:
            continue
        path = PREFIX / "share/example-robot-data/robots" / file
        with tempfile.TemporaryDirectory() as temporary:
            folder = Path(temporary)
            own = robots.Emitted(command, path, base, tip, ["inverse-dynamics"], folder)
            n = len(own.joints)
            model = robots.reference(path, own.joints, folder)
            programs = [
                build(folder, "full", ["gcc"], {**emitted(command, path, base, tip, folder, "full"), "N": n}, ["-lm"]),
                build(folder, "none", ["gcc"], {**emitted(command, path, base, tip, folder, "none"), "N": n}, ["-lm"]),
                compiled,
            ]
            programs.append(build(folder, "casadi", ["gcc", "-w"], {**casadi_code(model, folder), "N": n}, ["-lm"]))
            written(model, folder / "model")
            found = [instructions(program, folder / "model") for program in programs]
            totals = [total for _, total in found]
            assert max(totals) - min(totals) < 1e-7 * max(1.0, abs(totals[0])), totals
            # The driver's own part is the same in all.
            empty = {"HEAD": "", "BEFORE": "", "CALL": "for (int i = 0; i < N; i++) { torque[i] = a[i]; }", "N": n}
            driver, _ = instructions(build(folder, "driver", ["gcc"], empty, []))
            law = build(folder, "step", ["gcc"], {**controller(command, (path, base, tip), folder), "N": n}, ["-lm"])
            counts = [count for count, _ in found]
            counts.insert(2, instructions(law)[0])
            print(f"| {name} | {n} | {' | '.join(f'{count - driver:.0f}' for count in counts)} |", flush=True)


if __name__ == "__main__":
    main()
