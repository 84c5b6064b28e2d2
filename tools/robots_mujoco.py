"""Runs the emitted controllers of robots in MuJoCo, and prints how far they are from rest at the deadline.

MuJoCo compiles each robot of the package example-robot-data from its URDF; its mass matrix and bias are held against
Pinocchio's first. The controllers move it from rest to rest in 1 s, at 1 kHz, in two ways:

- joints: behind encoders of 19 bits alone, a controller with an observer for each joint, and the inverse dynamics of the
  robot: the loop of `examples/robot`. It knows the sample of delay.
- state: the controller of the robot, from the same encoders and differences of their readings. It has no observer, and
  knows nothing of the sample of delay.

MuJoCo's dry friction holds a joint at rest up to its limit; that of the law has a smooth sign.

    pip install mujoco pin example-robot-data numpy
    python3 tools/robots_mujoco.py --command target/release/ptc-codegen
"""

import argparse
import itertools
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

import mujoco
import numpy as np
import pinocchio as pin

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "examples" / "robot"))
import arm  # noqa: E402

ROBOTS = {robot.name: robot for robot in (arm.PANDA, arm.UR5)}
LAW = ["--mu", "exp(a=1)", "--clock", "samples", f"--sample-time={arm.PERIOD}", f"--tau={arm.PERIOD * arm.SAMPLES}",
       "--poles=-3,-4", "--eps=0.05"]
PAYLOAD = 0.5
# MuJoCo's model has no friction but that of a disturbance.
FRICTIONLESS = ("--damping=0", "--friction=0")
# Largest difference of MuJoCo's mass matrix and bias from Pinocchio's, relative.
SAME = 1e-13


@dataclass
class Disturbance:
    """What the robot is beside its file, and the flags by which the law knows of it."""

    name: str
    # The largest errors at the deadline of both ways, rad.
    most: tuple
    masses: float = 1.0
    payload: float = 0.0
    # Values of MuJoCo's model for each joint.
    drives: dict = field(default_factory=dict)
    known: tuple = ()
    exact: bool = False


DRIVES = ("dof_armature", "dof_damping", "dof_frictionloss")
CENTRE = ",".join(map(str, arm.PAYLOAD_CENTRE))
DISTURBANCES = [
    Disturbance("none, exact states, no delay", (1e-5, 1e-5), exact=True),
    Disturbance("none", (1e-5, 2e-5)),
    Disturbance("masses + 10 %", (3e-5, 2e-3), masses=1.1),
    Disturbance("masses - 10 %", (3e-5, 2e-3), masses=0.9),
    Disturbance("payload 0.5 kg", (3e-4, 5e-3), payload=PAYLOAD),
    Disturbance("payload 0.5 kg, known", (1e-5, 2e-5), payload=PAYLOAD, known=(f"--payload={PAYLOAD},{CENTRE}",)),
    Disturbance("rotors 0.1 kg m^2", (1e-1, 5e-2), drives={"dof_armature": 0.1}),
    Disturbance("rotors 0.1 kg m^2, known", (1e-5, 2e-5), drives={"dof_armature": 0.1}, known=("--rotor=0.1",)),
    Disturbance("damping 0.1 N m s/rad", (3e-5, 3e-3), drives={"dof_damping": 0.1}),
    Disturbance("damping 0.1 N m s/rad, known", (1e-5, 2e-5), drives={"dof_damping": 0.1}, known=("--damping=0.1",)),
    Disturbance("friction 0.5 N m", (1e-2, 5e-2), drives={"dof_frictionloss": 0.5}),
    Disturbance("friction 0.5 N m, known", (5e-3, 2e-2), drives={"dof_frictionloss": 0.5}, known=("--friction=0.5",)),
    Disturbance("rotors, damping, friction 0.1, known 10 % less", (2e-4, 3e-4), drives=dict.fromkeys(DRIVES, 0.1),
                known=("--rotor=0.09", "--damping=0.09", "--friction=0.09")),
]


class State:
    """The controller of a robot, from encoders or exact states."""

    def __init__(self, command, robot, folder, known):
        end = ",".join(map(str, robot.end))
        flags = [*robot.flags(), *LAW, f"--reference={end}", *known]
        self.library = arm.library(command, "law", flags, folder)
        self.law, self.before = arm.ctypes.create_string_buffer(256), None
        assert self.library.law_init(self.law, arm.ctypes.create_string_buffer(64)) == 0

    def torque(self, k, q, v=None):
        if v is None:
            v = np.zeros(len(q)) if self.before is None else (q - self.before) / arm.PERIOD
            self.before = q
        x, u, axes = np.concatenate([q, v]), np.zeros(len(q)), arm.ctypes.create_string_buffer(4 * len(q))
        given = (arm.ctypes.c_uint32(k), arm.address(x), arm.address(u), axes)
        assert self.library.law_step(self.law, *given) >= 0
        return u


def flags(disturbance):
    """The flags of a law that knows what it may of a disturbance."""
    given = [flag.partition("=")[0] for flag in disturbance.known]
    return [flag for flag in FRICTIONLESS if flag.partition("=")[0] not in given] + list(disturbance.known)


def mismatch(robot, equations, states=100):
    """The largest relative difference of mass matrix and bias, which `equations` gives, from Pinocchio's."""
    whole = pin.buildModelFromUrdf(str(robot.path()))
    held = [j for j in range(1, whole.njoints) if whole.names[j] not in robot.joints]
    own = pin.buildReducedModel(whole, held, pin.neutral(whole))
    assert list(own.names)[1:] == robot.joints and own.nq == own.nv
    data, draw, worst = own.createData(), np.random.default_rng(1), 0.0
    for _ in range(states):
        q, v = draw.uniform(-3, 3, own.nv), draw.normal(0, 2, own.nv)
        mass, bias = equations(q, v)
        expected = np.triu(pin.crba(own, data, q)), pin.rnea(own, data, q, v, np.zeros(own.nv))
        for a, b in zip((np.triu(mass), bias), expected):
            worst = max(worst, float(np.max(np.abs(a - b)) / np.max(np.abs(b))))
    return worst


def equations(model):
    """MuJoCo's mass matrix and bias as a function."""
    data, mass = mujoco.MjData(model), np.zeros((model.nv, model.nv))

    def computed(q, v):
        data.qpos[:], data.qvel[:] = q, v
        mujoco.mj_forward(model, data)
        mujoco.mj_fullM(model, data, mass)
        return mass, data.qfrc_bias

    return computed


def disturbed(robot, disturbance):
    """A robot in MuJoCo with a disturbance."""
    model = arm.compiled(robot, arm.described(robot, disturbance.payload, disturbance.masses))
    for name, value in disturbance.drives.items():
        getattr(model, name)[:] = value
    mujoco.mj_setConst(model, mujoco.MjData(model))
    return arm.MuJoCo(robot, model)


def by_joints(command, robot, disturbance, physics, more=()):
    """A run with a controller for each joint."""
    with tempfile.TemporaryDirectory() as folder:
        law = arm.Joints(command, robot, folder, [*flags(disturbance), *more])
        return arm.run(robot, physics, lambda k, q, v: law.torque(k, q if disturbance.exact else arm.encoders(q)))


def by_state(command, robot, disturbance, physics, more=()):
    """A run with the controller of the robot."""
    with tempfile.TemporaryDirectory() as folder:
        law = State(command, robot, folder, [*flags(disturbance), *more])
        if disturbance.exact:
            return arm.run(robot, physics, law.torque, delay=False)
        return arm.run(robot, physics, lambda k, q, v: law.torque(k, arm.encoders(q)))


WAYS = {"joints": by_joints, "state": by_state}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", default="target/release/ptc-codegen", help="the program ptc-codegen")
    parser.add_argument("--robots", default=",".join(ROBOTS), help="of " + ", ".join(ROBOTS))
    parser.add_argument("--more", action="append", default=[], help="a further flag of the robot, as a defect")
    given = parser.parse_args()
    wrong, arms = [], {name: ROBOTS[name] for name in given.robots.split(",")}
    for name, robot in arms.items():
        difference = mismatch(robot, equations(arm.compiled(robot, arm.described(robot))))
        print(f"{name}: MuJoCo's mass matrix and bias differ from Pinocchio's by {difference:.1e}\n")
        if difference > SAME:
            wrong.append(f"{name}: MuJoCo's model is another one: {difference:.1e}")
    print("| robot | it has | joints, rad | N m | state, rad | N m |\n|" + " --- |" * 6)
    for disturbance, (name, robot) in itertools.product(DISTURBANCES, arms.items()):
        found = [way(given.command, robot, disturbance, disturbed(robot, disturbance), given.more)
                 for way in WAYS.values()]
        cells = [f"{run.error(robot):.1e} | {np.max(np.abs(run.torques)):.1f}" for run in found]
        print(f"| {name} | {disturbance.name} | {' | '.join(cells)} |", flush=True)
        for way, run, most in zip(WAYS, found, disturbance.most):
            if not run.error(robot) <= most:
                wrong.append(f"{name}, {disturbance.name}, {way}: {run.error(robot):.1e} rad, allowed {most:.0e}")
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main()
