"""Runs the loop of `examples/robot` in Drake, beside MuJoCo, and prints both errors at the deadline.

Drake has no dry friction of joints, so rows with it are left out; an error-controlled Runge-Kutta method of order 3
moves its robots. Its mass matrix and bias are held against Pinocchio's.

    pip install drake mujoco pin example-robot-data numpy
    python3 tools/robots_drake.py --command target/release/ptc-codegen
"""

import argparse
import logging
import re
import sys

import numpy as np
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant
from pydrake.systems.analysis import Simulator

import robots_mujoco as loops
from robots_mujoco import arm

ACCURACY = 1e-8


class Drake:
    """A robot that stands still at its start."""

    def __init__(self, robot, disturbance):
        text = arm.described(robot, disturbance.payload, disturbance.masses)
        self.plant, self.samples = MultibodyPlant(0.0), 0
        Parser(self.plant).AddModelsFromString(text, "urdf")
        (root,) = set(re.findall(r'<link\s+name="([^"]*)"', text)) - set(re.findall(r'<child\s+link="([^"]*)"', text))
        if root != "world":
            self.plant.WeldFrames(self.plant.world_frame(), self.plant.GetFrameByName(root))
        joints = [self.plant.GetJointByName(name) for name in robot.joints]
        for joint in joints:
            motor = self.plant.AddJointActuator(joint.name(), joint)
            motor.set_default_rotor_inertia(disturbance.drives.get("dof_armature", 0.0))
            motor.set_default_gear_ratio(1.0)
            joint.set_default_damping(disturbance.drives.get("dof_damping", 0.0))
        self.plant.Finalize()
        assert self.plant.num_positions() == len(robot.joints) == self.plant.num_actuators()
        self.simulator = Simulator(self.plant)
        self.simulator.get_mutable_integrator().set_target_accuracy(ACCURACY)
        self.context = self.simulator.get_mutable_context()
        self.plant.SetPositions(self.context, robot.start)
        self.simulator.Initialize()

    def state(self):
        return self.plant.GetPositions(self.context), self.plant.GetVelocities(self.context)

    def bias(self):
        """The torques that hold it where it stands, or let it move as it does."""
        return self.plant.CalcBiasTerm(self.context) - self.plant.CalcGravityGeneralizedForces(self.context)

    def equations(self, q, v):
        """Mass matrix and bias."""
        self.plant.SetPositions(self.context, q)
        self.plant.SetVelocities(self.context, v)
        return self.plant.CalcMassMatrix(self.context), self.bias()

    def advance(self, torque):
        """Moves it for a sample."""
        self.samples += 1
        self.plant.get_actuation_input_port().FixValue(self.context, torque)
        self.simulator.AdvanceTo(self.samples * arm.PERIOD)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", default="target/release/ptc-codegen", help="the program ptc-codegen")
    given = parser.parse_args()
    # Elements of URDF that Drake ignores.
    logging.getLogger("drake").setLevel(logging.ERROR)
    wrong = []
    for name, robot in loops.ROBOTS.items():
        difference = loops.mismatch(robot, Drake(robot, loops.DISTURBANCES[0]).equations)
        print(f"{name}: Drake's mass matrix and bias differ from Pinocchio's by {difference:.1e}\n")
        if difference > loops.SAME:
            wrong.append(f"{name}: Drake's model is another one: {difference:.1e}")
        print("| the robot has | Drake, rad | MuJoCo, rad |\n| --- | --- | --- |")
        for disturbance in loops.DISTURBANCES:
            if disturbance.exact or "dof_frictionloss" in disturbance.drives:
                continue
            worlds = Drake(robot, disturbance), loops.disturbed(robot, disturbance)
            errors = [loops.by_joints(given.command, robot, disturbance, world).error(robot) for world in worlds]
            print(f"| {disturbance.name} | {errors[0]:.1e} | {errors[1]:.1e} |", flush=True)
            if not errors[0] <= disturbance.most[0]:
                wrong.append(f"{name}, {disturbance.name}: {errors[0]:.1e} rad, allowed {disturbance.most[0]:.0e}")
        print()
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main()
