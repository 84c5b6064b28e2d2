//! A robot as a plant: its joints, moved by torques that inverse dynamics gives.

use super::Output;
#[cfg(feature = "urdf")]
use super::{Coupled, Inverse};
use crate::algebra::BigRational;
use crate::expression::{Expression, Variable};
#[cfg(feature = "urdf")]
use crate::parameter::Name;
use crate::urdf::{Body, Motion, Payload, Robot, Source, payload_text, plain};

/// A robot and its source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Arm {
    /// The file and what was given with it.
    pub source: Source,
    /// Its bodies, with a joint each.
    pub robot: Robot,
}

/// Names of the states, positions and then velocities, and of the inputs of a robot with `joints`.
#[cfg(feature = "urdf")]
pub(crate) fn names(joints: usize) -> Option<(Vec<Name>, Vec<Name>)> {
    let numbered = |stem: &str| -> Option<Vec<Name>> {
        (1..=joints).map(|j| Name::new(&format!("{stem}{j}"))).collect()
    };
    Some(([numbered("q")?, numbered("dq")?].concat(), numbered("torque")?))
}

impl Arm {
    /// The largest torque or force of each joint, where the file gives those of all.
    pub(crate) fn efforts(&self) -> Option<Vec<BigRational>> {
        self.robot.bodies.iter().map(|body| body.effort.clone()).collect()
    }

    /// The same with another payload; `None` if nothing carries it.
    pub(crate) fn carrying(&self, payload: Payload) -> Option<Self> {
        let robot = self.robot.carrying(Some(&payload), self.source.payload.as_ref())?;
        Some(Self { source: Source { payload: Some(payload), ..self.source.clone() }, robot })
    }

    /// Prints it, a line each: what it is, and its joints.
    pub fn lines(&self) -> Vec<String> {
        let Self { source, robot } = self;
        let gravity = source.gravity_text(", ");
        let mut lines = vec![format!(
            "robot {}, base {}, gravity ({gravity}) m/s^2 in its axes",
            plain(&robot.name),
            plain(&robot.base),
        )];
        lines.extend((1..).zip(&robot.bodies).map(|(j, body)| joint(j, body)));
        if let Some(payload) = &source.payload {
            lines.push(format!("payload at the tip: {}", payload_text(payload)));
        }
        if !robot.held.is_empty() {
            let held: Vec<_> = robot.held.iter().map(|name| plain(name)).collect();
            lines.push(format!("held at position 0: {}", held.join(", ")));
        }
        lines
    }

    /// Prints everything that its motion depends on, with exact numbers.
    pub(crate) fn identity(&self) -> String {
        let gravity = &self.source.gravity;
        let bodies = self.robot.bodies.iter().map(|body| {
            let Body { motion, parent, placement, inertia, drive, .. } = body;
            let numbers = [placement.rotation.concat(), placement.origin.to_vec()].concat();
            let moments = [inertia.first.to_vec(), inertia.second.concat()].concat();
            let drive = drive.text().unwrap_or_default();
            format!("{motion:?} {parent:?} {numbers:?} {:?} {moments:?} {drive}", inertia.mass)
        });
        format!("{gravity:?} {}", bodies.collect::<Vec<_>>().join(" "))
    }
}

fn joint(j: usize, body: &Body) -> String {
    let (kind, units) = match body.motion {
        Motion::Revolute => ("revolute", "rad, rad/s, N m"),
        Motion::Prismatic => ("prismatic", "m, m/s, N"),
    };
    let drive = body.drive.text().map(|text| format!(", {text}")).unwrap_or_default();
    format!("q{j}, dq{j}, torque{j}: {kind} joint {} ({units}){drive}", plain(&body.joint))
}

#[cfg(feature = "urdf")]
impl Coupled {
    /// The plant whose outputs are the positions of the joints of a robot.
    pub(crate) fn of_arm(states: Vec<Name>, inputs: Vec<Name>, arm: Arm) -> Self {
        let outputs = Output::positions(inputs.len());
        let inverse = Inverse::Robot(Box::new(arm));
        Self::of(states, inputs, outputs, inverse)
    }
}

impl Output {
    /// The coordinates of a mechanical plant with `m` of them, whose rates are the states behind them.
    pub(super) fn positions(m: usize) -> Vec<Self> {
        let state = |j: usize| Expression::from(Variable::State(j));
        let output = |j: usize| Self {
            coordinates: vec![state(j), state(m + j)],
            drift: Expression::integer(0),
        };
        (1..=m).map(output).collect()
    }
}
