"""Holds the functions of robots against Pinocchio, on random states of published robots.

For each robot of the package example-robot-data the emitted C is compiled and called at random positions,
velocities and accelerations, and compared with Pinocchio's `rnea`, `crba` and `getFrameJacobian` of the same file.
The controller of up to 8 joints is called at random times and states; its torques are compared with `rnea` at the
accelerations of its law. The error of a vector is its largest difference over the largest entry that Pinocchio finds.

    pip install pin example-robot-data numpy
    python3 tools/robots.py --command target/release/ptc-codegen

An angle such as 1.57079632679 is a quarter turn in ptc-codegen; Pinocchio is given the file with all its digits.
"""

import argparse
import ctypes
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import pinocchio as pin

# Joints of a controller.
MOST = 8
# Name, file, base, tip.
ROBOTS = [
    ("panda", "panda_description/urdf/panda.urdf", None, "panda_hand_tcp"),
    ("ur5", "ur_description/urdf/ur5_robot.urdf", None, None),
    ("xarm7", "xarm_description/urdf/xarm7.urdf", None, "link7"),
    ("z1", "z1_description/urdf/z1.urdf", None, "link06"),
    ("so101", "so_arm_description/urdf/so101.urdf", None, "gripper_link"),
    ("kinova", "kinova_description/robots/kinova.urdf", None, "j2s6s200_end_effector"),
    ("baxter", "baxter_description/urdf/baxter.urdf", None, "left_hand_link,right_hand_link"),
    ("tiago_pro", "tiago_pro_description/robots/tiago_pro.urdf", "base_footprint", "arm_left_7_link"),
    ("talos", "talos_data/robots/talos_reduced.urdf", None, None),
    ("double_pendulum", "double_pendulum_description/urdf/double_pendulum.urdf", None, None),
]


def full_digits(match):
    """The angles of an origin, quarter turns with all their digits."""
    def one(text):
        decimals = len(text.partition(".")[2])
        turns = round(float(text) / (math.pi / 2))
        rest = abs(float(text) - turns * math.pi / 2)
        whole = turns != 0 and decimals >= 4 and "e" not in text and rest < 10.0**-decimals
        return repr(turns * math.pi / 2) if whole else text
    return f'rpy="{" ".join(one(text) for text in match.group(1).split())}"'


# The law of each joint, at rest at 1 s, and its acceleration. Its gains are (k1, k2) = (12, 7).
LAW = ["--mu", "exp(a=1)", "--poles=-3,-4", "--tau", "1", "--t0", "0", "--eps", "0.001", "--u-max", "inf"]


def wanted(t, q, v):
    return -(12 * q / (1 - t) + 6 * v) / (1 - t)


def compiled(command, name, robot, flags, folder):
    """The C that flags give for a robot (path, base, tip), as a library."""
    path, base, tip = robot
    words = [command, "emit", "--lang", "c", "--urdf", str(path), *flags]
    words += ["--base", base] if base else []
    words += ["--tip", tip] if tip else []
    subprocess.run([*words, "--name", name, "-o", str(folder)], check=True, stdout=subprocess.DEVNULL)
    library = folder / f"{name}.so"
    strict = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-Wno-unused-parameter", "-shared", "-fPIC"]
    subprocess.run(["cc", *strict, str(folder / f"{name}.c"), "-o", str(library), "-lm"], check=True)
    return ctypes.CDLL(str(library))


class Law:
    """The controller of a robot, compiled."""

    def __init__(self, command, robot, folder):
        self.library = compiled(command, "law", robot, LAW, folder)
        self.law = ctypes.create_string_buffer(256)
        assert self.library.law_init(self.law, ctypes.create_string_buffer(64)) == 0
        self.library.law_step.argtypes = [ctypes.c_void_p, ctypes.c_double, *[ctypes.c_void_p] * 3]

    def torques(self, t, q, v):
        x, u, axes = np.concatenate([q, v]), np.zeros(len(q)), ctypes.create_string_buffer(4 * len(q))
        assert self.library.law_step(self.law, t, x.ctypes.data, u.ctypes.data, axes) == 0
        return u


class Emitted:
    """The functions of a robot, compiled."""

    def __init__(self, command, path, base, tip, what, folder):
        self.library = compiled(command, "arm", (path, base, tip), ["--what", ",".join(what)], folder)
        self.arm = ctypes.create_string_buffer(64)
        assert self.library.arm_init(self.arm, ctypes.create_string_buffer(64)) == 0
        head = (folder / "arm.h").read_text()
        listed = re.search(r"order of all arrays: (.*?)\.\n", head, re.S).group(1)
        self.joints = re.sub(r"[\s*]+", " ", listed).split(", ")

    def call(self, name, size, *arrays):
        result = np.zeros(size)
        given = [np.ascontiguousarray(array) for array in arrays]
        pointers = [ctypes.c_void_p(array.ctypes.data) for array in [*given, result]]
        assert getattr(self.library, f"arm_{name}")(self.arm, *pointers) == 0
        return result


def reference(path, joints, folder):
    """Pinocchio's model with all other joints held at position 0."""
    text = re.sub(r'rpy="([-+.eE0-9\s]*)"', full_digits, Path(path).read_text())
    whole = folder / "whole.urdf"
    whole.write_text(text)
    model = pin.buildModelFromUrdf(str(whole))
    held = [i for i in range(1, model.njoints) if model.names[i] not in joints]
    neutral = pin.neutral(model)
    return pin.buildReducedModel(model, held, neutral)


def compare(command, robot, states, seed):
    name, file, base, tip = robot
    path = next(Path(p) for p in sys.path if "site-packages" in p) / "cmeel.prefix/share/example-robot-data/robots" / file
    worst = {"inverse dynamics": 0.0, "mass matrix": 0.0}
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        one_tip = tip is not None and "," not in tip
        what = ["inverse-dynamics", "mass-matrix"] + (["jacobian"] if one_tip else [])
        emitted = Emitted(command, path, base, tip, what, folder)
        model = reference(path, emitted.joints, folder)
        data = model.createData()
        n = len(emitted.joints)
        assert n == model.nv, (emitted.joints, list(model.names))
        # The place of each of our joints among Pinocchio's.
        places = [model.joints[model.getJointId(joint)] for joint in emitted.joints]
        order = [place.idx_v for place in places]
        if one_tip:
            worst["jacobian"] = 0.0
            frame = model.getFrameId(tip)
        law = Law(command, (path, base, tip), folder) if n <= MOST else None
        if law:
            worst["controller"] = 0.0
        draw = np.random.default_rng(seed)

        def error(kind, own, other):
            worst[kind] = max(worst[kind], float(np.max(np.abs(own - other)) / np.max(np.abs(other))))

        for _ in range(states):
            q, v, a = draw.uniform(-math.pi, math.pi, n), draw.normal(0, 2, n), draw.normal(0, 5, n)
            full, rate, acceleration = pin.neutral(model), np.zeros(n), np.zeros(n)
            for index, place in enumerate(places):
                if place.nq == 2:
                    full[place.idx_q : place.idx_q + 2] = math.cos(q[index]), math.sin(q[index])
                else:
                    full[place.idx_q] = q[index]
                rate[place.idx_v], acceleration[place.idx_v] = v[index], a[index]
            error("inverse dynamics", emitted.call("inverse_dynamics", n, q, v, a),
                  pin.rnea(model, data, full, rate, acceleration)[order])
            if law:
                t = draw.uniform(0, 0.95)
                acceleration[order] = wanted(t, q, v)
                error("controller", law.torques(t, q, v), pin.rnea(model, data, full, rate, acceleration)[order])
            mass = pin.crba(model, data, full)
            mass = np.triu(mass) + np.triu(mass, 1).T
            error("mass matrix", emitted.call("mass_matrix", n * n, q).reshape(n, n), mass[np.ix_(order, order)])
            if one_tip:
                pin.computeJointJacobians(model, data, full)
                pin.updateFramePlacements(model, data)
                jacobian = pin.getFrameJacobian(model, data, frame, pin.LOCAL_WORLD_ALIGNED)[:, order]
                error("jacobian", emitted.call("jacobian", 6 * n, q).reshape(6, n), jacobian)
    return n, worst


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", default="target/release/ptc-codegen", help="the program ptc-codegen")
    parser.add_argument("--states", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--most", type=float, default=1e-12, help="largest relative error")
    given = parser.parse_args()
    kinds = ("inverse dynamics", "mass matrix", "jacobian", "controller")
    print(f"| robot | joints | {' | '.join(kinds)} |\n|{' --- |' * 6}")
    failed = False
    for robot in ROBOTS:
        joints, worst = compare(given.command, robot, given.states, given.seed)
        failed |= max(worst.values()) > given.most
        shown = [f"{worst[kind]:.1e}" if kind in worst else "" for kind in kinds]
        print(f"| {robot[0]} | {joints} | {' | '.join(shown)} |", flush=True)
    sys.exit("an error is larger than allowed" if failed else 0)


if __name__ == "__main__":
    main()
