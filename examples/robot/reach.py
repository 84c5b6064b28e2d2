"""Moves Franka's Panda to a pose in 1 s, in MuJoCo, and draws its joints and a strip of frames.

    pip install mujoco example-robot-data matplotlib numpy
    python examples/robot/reach.py --command target/release/ptc-codegen -o reach
"""

import argparse
import os
import tempfile
from pathlib import Path

# Frames are drawn without a window.
os.environ.setdefault("MUJOCO_GL", "egl")

import matplotlib  # noqa: E402

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import mujoco  # noqa: E402
import numpy as np  # noqa: E402

import arm  # noqa: E402

# Samples for which the robot holds the pose after the deadline.
HOLD = 200
FRAMES = 6


def joints(run, robot, path):
    """Draws angles to go and torques over time."""
    figure, (angles, torques) = plt.subplots(2, 1, sharex=True, figsize=(7, 5), layout="constrained")
    t = arm.PERIOD * np.arange(len(run.positions))
    for j in range(len(robot.end)):
        angles.plot(t, run.positions[:, j] - robot.end[j], label=f"q{j + 1}")
        torques.step(t[:-1], run.torques[:, j], where="post")
    angles.set_ylabel("angle to go, rad")
    torques.set_ylabel("torque, N m")
    torques.set_xlabel("time, s")
    for axes in (angles, torques):
        axes.axvline(arm.PERIOD * arm.SAMPLES, color="0.5", linestyle=":")
    angles.legend(ncols=len(robot.end), fontsize="small")
    figure.savefig(path)


def frames(run, robot, path):
    """Draws the robot at a few times, side by side."""
    model = arm.compiled(robot, arm.described(robot, visible=True), visible=True)
    data, camera = mujoco.MjData(model), mujoco.MjvCamera()
    camera.lookat[:], camera.distance, camera.azimuth, camera.elevation = (0.25, 0, 0.4), 1.7, 130, -15
    strip = []
    with mujoco.Renderer(model, 320, 240) as renderer:
        for k in np.linspace(0, arm.SAMPLES, FRAMES).astype(int):
            data.qpos[:] = run.positions[k]
            mujoco.mj_forward(model, data)
            renderer.update_scene(data, camera)
            strip.append(renderer.render().copy())
    plt.imsave(path, np.concatenate(strip, axis=1))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", default="ptc-codegen", help="the program ptc-codegen")
    parser.add_argument("-o", "--out", default="reach", type=Path, help="folder of the pictures")
    given = parser.parse_args()
    robot = arm.PANDA
    with tempfile.TemporaryDirectory() as folder:
        law = arm.Joints(given.command, robot, folder)
        physics = arm.MuJoCo(robot, arm.compiled(robot, arm.described(robot)))
        run = arm.run(robot, physics, lambda k, q, v: law.torque(k, arm.encoders(q)), samples=arm.SAMPLES + HOLD)
    given.out.mkdir(parents=True, exist_ok=True)
    joints(run, robot, given.out / "joints.svg")
    print(f"{run.error(robot):.1e} rad from the pose at {arm.PERIOD * arm.SAMPLES} s, "
          f"at most {np.max(np.abs(run.torques)):.1f} N m")
    print(f"wrote {given.out / 'joints.svg'}")
    try:
        frames(run, robot, given.out / "frames.png")
        print(f"wrote {given.out / 'frames.png'}")
    except Exception as error:  # MuJoCo's renderers raise errors of their own kinds
        print(f"no frames: MuJoCo cannot draw here ({error}); try MUJOCO_GL=osmesa or MUJOCO_GL=glfw")


if __name__ == "__main__":
    main()
