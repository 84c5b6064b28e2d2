"""A robot of the package example-robot-data in MuJoCo, under the emitted controllers of its joints.

Each joint has a controller with an observer, `joint.toml`. The accelerations that they want become torques by the
inverse dynamics of the robot, emitted from its URDF. MuJoCo reads the same file.
"""

import ctypes
import math
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np

HERE = Path(__file__).resolve().parent
PERIOD = 1e-3
# Samples from the start to rest, as in joint.toml.
SAMPLES = 1000
# Steps of the integration in a sample.
STEPS = 10
# An encoder of 19 bits, rad.
QUANTUM = 2 * math.pi / 2**19
# Where the payload is in the frame of the tip, m.
PAYLOAD_CENTRE = (0, 0, 0.1)


@dataclass
class Robot:
    """A robot of the package, and a move of its joints from rest to rest."""

    name: str
    file: str
    tip: str
    joints: list
    start: list
    end: list

    def folder(self):
        here = "cmeel.prefix/share/example-robot-data/robots"
        places = [Path(place) / here for place in sys.path if (Path(place) / here).is_dir()]
        if not places:
            raise SystemExit("the robots are missing: pip install example-robot-data")
        return places[0]

    def path(self):
        return self.folder() / self.file

    def flags(self):
        return ["--urdf", str(self.path()), "--tip", self.tip]


PANDA = Robot(
    "panda", "panda_description/urdf/panda.urdf", "panda_hand",
    [f"panda_joint{j}" for j in range(1, 8)],
    [0, -0.785, 0, -2.356, 0, 1.571, 0.785], [0.6, -0.3, 0.4, -1.8, -0.4, 2.0, 0.2])
UR5 = Robot(
    "ur5", "ur_description/urdf/ur5_robot.urdf", "tool0",
    ["shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint"],
    [0, -1.2, 1.4, -0.2, 1.57, 0], [0.5, -0.9, 1.0, 0.2, 1.2, -0.5])


def library(command, name, words, folder):
    """The C of a design or of flags, compiled."""
    emit = [command, "emit", *words, "--lang", "c", "--name", name, "-o", str(folder)]
    subprocess.run(emit, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    path = Path(folder) / f"{name}.so"
    strict = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-Wno-unused-parameter", "-shared", "-fPIC"]
    subprocess.run(["cc", *strict, str(path.with_suffix(".c")), "-o", str(path), "-lm"], check=True)
    return ctypes.CDLL(str(path))


def address(array):
    return ctypes.c_void_p(array.ctypes.data)


class Joints:
    """The controllers of all joints, and the inverse dynamics of the robot."""

    def __init__(self, command, robot, folder, known=()):
        self.end = np.array(robot.end, dtype=float)
        self.dynamics = library(command, "arm", [*robot.flags(), "--what", "inverse-dynamics", *known], folder)
        self.controller = library(command, "joint", [str(HERE / "joint.toml")], folder)
        self.arm = ctypes.create_string_buffer(64)
        self.joints = [ctypes.create_string_buffer(1024) for _ in self.end]
        params = ctypes.create_string_buffer(64)
        assert self.dynamics.arm_init(self.arm, params) == 0
        for joint in self.joints:
            assert self.controller.joint_init(joint, params) == 0

    def torque(self, k, q):
        """The torques from sample `k`, of the readings of the encoders."""
        x, wanted = np.zeros((2, len(q))), np.zeros(len(q))
        for j, joint in enumerate(self.joints):
            y, u, estimate = np.array([q[j] - self.end[j]]), np.zeros(1), np.zeros(2)
            assert self.controller.joint_step(joint, ctypes.c_uint32(k), address(y), address(u)) >= 0
            assert self.controller.joint_estimate(joint, address(estimate)) >= 0
            x[:, j], wanted[j] = estimate, u[0]
        torque, at, rate = np.zeros(len(q)), x[0] + self.end, x[1].copy()
        assert self.dynamics.arm_inverse_dynamics(self.arm, *map(address, (at, rate, wanted, torque))) == 0
        return torque


def described(robot, payload=0.0, masses=1.0, visible=False):
    """The URDF of a robot without friction, in which all joints but its own are held; its masses are scaled."""
    text = robot.path().read_text().replace("package://example-robot-data/robots", str(robot.folder()))
    left_out = ["visual", "transmission", "dynamics", "safety_controller"] + ([] if visible else ["collision"])
    for element in left_out:
        text = re.sub(rf"<{element}\b[^>]*/>|<{element}\b[^>]*>.*?</{element}>", "", text, flags=re.S)

    def held(match):
        return match.group(0) if match.group(2) in robot.joints else f'<joint {match.group(1)} type="fixed">'

    def scaled(match):
        return re.sub(r'"([^"]*)"', lambda number: f'"{float(number.group(1)) * masses!r}"', match.group(0))

    text = re.sub(r'<joint\s+(name="([^"]*)")\s+type="[^"]*"\s*>', held, text)
    text = re.sub(r"<(?:mass|inertia)\b[^>]*>", scaled, text)
    if payload:
        centre, inertia = " ".join(map(str, PAYLOAD_CENTRE)), 'ixx="1e-9" iyy="1e-9" izz="1e-9" ixy="0" ixz="0" iyz="0"'
        text = text.replace("</robot>", f"""<link name="payload"><inertial><origin xyz="{centre}"/><mass value="{payload}"/>
            <inertia {inertia}/></inertial></link><joint name="payload" type="fixed"><parent link="{robot.tip}"/>
            <child link="payload"/></joint></robot>""")
    return text


def compiled(robot, text, visible=False):
    """MuJoCo's model of a URDF."""
    options = '<mujoco><compiler fusestatic="false" discardvisual="false" strippath="false"/></mujoco>'
    spec = mujoco.MjSpec.from_string(re.sub(r"(<robot\b[^>]*>)", rf"\1{options}", text))
    if visible:
        spec.visual.headlight.ambient, spec.visual.headlight.diffuse = [0.4] * 3, [0.6] * 3
        spec.add_texture(name="sky", type=mujoco.mjtTexture.mjTEXTURE_SKYBOX, builtin=mujoco.mjtBuiltin.mjBUILTIN_FLAT,
                         rgb1=[1, 1, 1], rgb2=[1, 1, 1], width=64, height=384)
        for geom in spec.geoms:
            geom.rgba = [0.85, 0.87, 0.9, 1]
    model = spec.compile()
    assert [model.joint(j).name for j in range(model.njnt)] == robot.joints
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_RK4
    model.opt.timestep = PERIOD / STEPS
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    return model


class MuJoCo:
    """A robot that stands still at its start."""

    def __init__(self, robot, model):
        self.model, self.data = model, mujoco.MjData(model)
        self.data.qpos[:] = robot.start
        mujoco.mj_forward(model, self.data)

    def state(self):
        return self.data.qpos.copy(), self.data.qvel.copy()

    def bias(self):
        """The torques that hold it where it stands."""
        return self.data.qfrc_bias.copy()

    def advance(self, torque):
        """Moves it for a sample."""
        self.data.qfrc_applied[:] = torque
        for _ in range(STEPS):
            mujoco.mj_step(self.model, self.data)


@dataclass
class Run:
    """Positions and torques at all samples."""

    positions: np.ndarray
    torques: np.ndarray

    def error(self, robot):
        """The largest distance of a joint from its target at the deadline, rad."""
        return float(np.max(np.abs(self.positions[SAMPLES] - robot.end)))


def run(robot, physics, torque, delay=True, samples=SAMPLES):
    """Moves a robot; `torque` gives the torques from a sample, positions and velocities."""
    waiting = physics.bias()
    positions, torques = np.zeros((samples + 1, len(robot.end))), np.zeros((samples, len(robot.end)))
    for k in range(samples):
        q, v = physics.state()
        new = torque(k, q, v)
        acts, waiting = (waiting, new) if delay else (new, new)
        positions[k], torques[k] = q, acts
        physics.advance(acts)
    positions[samples], _ = physics.state()
    return Run(positions, torques)


def encoders(q):
    """What the encoders read at positions."""
    return np.round(q / QUANTUM) * QUANTUM
