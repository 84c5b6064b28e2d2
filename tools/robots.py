"""Holds the functions of robots against Pinocchio, on random states of published robots.

For each robot of the package example-robot-data the emitted C is compiled and called at random positions,
velocities and accelerations, and compared with Pinocchio's `rnea`, `crba` and `getFrameJacobian` of the same file.
The controller of up to 8 joints is called at random times and states; its torques are compared with `rnea` at the
accelerations of its law. The error of a vector is its largest difference over the largest entry that Pinocchio finds.
In the column "drives" each joint has a rotor, Pinocchio's `armature`, and friction, added to its torques here; in the
others it has the damping and friction that Pinocchio reads from the file.

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


class Drives:
    """Rotors and friction of the joints of a robot; those of its file if none are drawn."""

    def __init__(self, model, order, draw=None):
        n = len(order)
        self.flags = []
        self.rotor, self.damping, self.friction = np.zeros(n), model.damping[order], model.friction[order]
        self.width = np.full(n, 0.01)
        if draw is not None:
            self.rotor, self.damping, self.friction = (draw.uniform(0, most, n) for most in (0.5, 2, 5))
            self.width = draw.uniform(0.01, 0.5, n)
            names = {"rotor": self.rotor, "damping": self.damping, "friction": self.friction,
                     "friction-width": self.width}
            self.flags = [f"--{name}={','.join(map(repr, map(float, own)))}" for name, own in names.items()]

    def torque(self, v):
        """The torque of friction."""
        return self.damping * v + self.friction * v / np.hypot(v, self.width)


def compiled(command, name, robot, flags, folder):
    """The C that flags give for a robot (path, base, tip): the library, and its folder. A command is a program with further flags."""
    # A library of the same path is not loaded again.
    folder = Path(tempfile.mkdtemp(dir=folder))
    path, base, tip = robot
    program, *more = command
    words = [program, "emit", "--lang", "c", "--urdf", str(path), *flags, *more]
    words += ["--base", base] if base else []
    words += ["--tip", tip] if tip else []
    subprocess.run([*words, "--name", name, "-o", str(folder)], check=True, stdout=subprocess.DEVNULL)
    library = folder / f"{name}.so"
    strict = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-Wno-unused-parameter", "-shared", "-fPIC"]
    subprocess.run(["cc", *strict, str(folder / f"{name}.c"), "-o", str(library), "-lm"], check=True)
    return ctypes.CDLL(str(library)), folder


class Law:
    """The controller of a robot, compiled."""

    def __init__(self, command, robot, drives, folder):
        self.library, _ = compiled(command, "law", robot, LAW + drives.flags, folder)
        self.law = ctypes.create_string_buffer(256)
        assert self.library.law_init(self.law, ctypes.create_string_buffer(64)) == 0
        self.library.law_step.argtypes = [ctypes.c_void_p, ctypes.c_double, *[ctypes.c_void_p] * 3]

    def torques(self, t, q, v):
        x, u, axes = np.concatenate([q, v]), np.zeros(len(q)), ctypes.create_string_buffer(4 * len(q))
        assert self.library.law_step(self.law, t, x.ctypes.data, u.ctypes.data, axes) == 0
        return u


class Emitted:
    """The functions of a robot, compiled."""

    def __init__(self, command, robot, what, flags, folder):
        self.library, folder = compiled(command, "arm", robot, ["--what", ",".join(what), *flags], folder)
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


class Comparison:
    """The functions and the controller of a robot beside Pinocchio's."""

    def __init__(self, command, robot, seed, folder):
        _, file, base, tip = robot
        site = next(Path(p) for p in sys.path if "site-packages" in p)
        path = site / "cmeel.prefix/share/example-robot-data/robots" / file
        self.command, self.robot, self.folder = command, (path, base, tip), folder
        self.tip = tip if tip is not None and "," not in tip else None
        joints = Emitted(command, self.robot, ["mass-matrix"], [], folder).joints
        self.model = reference(path, joints, folder)
        assert len(joints) == self.model.nv, (joints, list(self.model.names))
        # The place of each of our joints among Pinocchio's.
        self.places = [self.model.joints[self.model.getJointId(joint)] for joint in joints]
        self.order = [place.idx_v for place in self.places]
        self.n, self.data, self.worst = len(joints), self.model.createData(), {}
        self.draw = np.random.default_rng(seed)

    def error(self, kind, own, other):
        found = float(np.max(np.abs(own - other)) / np.max(np.abs(other)))
        self.worst[kind] = max(self.worst.get(kind, 0.0), found)

    def state(self):
        """Random positions, velocities and accelerations, and the positions of Pinocchio."""
        q, v, a = (self.draw.uniform(-math.pi, math.pi, self.n), self.draw.normal(0, 2, self.n),
                   self.draw.normal(0, 5, self.n))
        full = pin.neutral(self.model)
        for index, place in enumerate(self.places):
            turns = place.nq == 2
            full[place.idx_q : place.idx_q + place.nq] = (math.cos(q[index]), math.sin(q[index])) if turns else q[index]
        return q, v, a, full

    def torque(self, full, v, a):
        rate, acceleration = np.zeros(self.n), np.zeros(self.n)
        rate[self.order], acceleration[self.order] = v, a
        return pin.rnea(self.model, self.data, full, rate, acceleration)[self.order]

    def run(self, states, drives, kind=None):
        """Compares random states; all errors are of one kind if it is given."""
        self.model.armature[self.order] = drives.rotor
        what = ["inverse-dynamics", "mass-matrix"] + (["jacobian"] if self.tip else [])
        emitted = Emitted(self.command, self.robot, what, drives.flags, self.folder)
        law = Law(self.command, self.robot, drives, self.folder) if self.n <= MOST else None
        n = self.n
        for _ in range(states):
            q, v, a, full = self.state()
            friction = drives.torque(v)
            self.error(kind or "inverse dynamics", emitted.call("inverse_dynamics", n, q, v, a),
                       self.torque(full, v, a) + friction)
            if law:
                t = self.draw.uniform(0, 0.95)
                self.error(kind or "controller", law.torques(t, q, v), self.torque(full, v, wanted(t, q, v)) + friction)
            mass = pin.crba(self.model, self.data, full)
            mass = (np.triu(mass) + np.triu(mass, 1).T)[np.ix_(self.order, self.order)]
            self.error(kind or "mass matrix", emitted.call("mass_matrix", n * n, q).reshape(n, n), mass)
            if self.tip and not kind:
                pin.computeJointJacobians(self.model, self.data, full)
                pin.updateFramePlacements(self.model, self.data)
                frame = self.model.getFrameId(self.tip)
                jacobian = pin.getFrameJacobian(self.model, self.data, frame, pin.LOCAL_WORLD_ALIGNED)[:, self.order]
                self.error("jacobian", emitted.call("jacobian", 6 * n, q).reshape(6, n), jacobian)


def compare(command, robot, states, seed):
    """The number of joints, and the worst errors by their kinds."""
    with tempfile.TemporaryDirectory() as folder:
        comparison = Comparison(command, robot, seed, Path(folder))
        comparison.run(states, Drives(comparison.model, comparison.order))
        comparison.run(states, Drives(comparison.model, comparison.order, comparison.draw), "drives")
    return comparison.n, comparison.worst


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", default="target/release/ptc-codegen", help="the program ptc-codegen")
    parser.add_argument("--states", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--more", action="append", default=[], help="a further flag of `emit`, as a defect")
    parser.add_argument("--most", type=float, default=1e-12, help="largest relative error")
    given = parser.parse_args()
    kinds = ("inverse dynamics", "mass matrix", "jacobian", "controller", "drives")
    print(f"| robot | joints | {' | '.join(kinds)} |\n|{' --- |' * 7}")
    failed = False
    for robot in ROBOTS:
        joints, worst = compare([given.command, *given.more], robot, given.states, given.seed)
        failed |= max(worst.values()) > given.most
        shown = [f"{worst[kind]:.1e}" if kind in worst else "" for kind in kinds]
        print(f"| {robot[0]} | {joints} | {' | '.join(shown)} |", flush=True)
    sys.exit(f"an error is larger than {given.most:.0e}" if failed else 0)


if __name__ == "__main__":
    main()
