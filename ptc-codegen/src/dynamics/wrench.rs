//! Forces and moments of bodies.

use super::model::Joint;
use super::tape::{Tape, Term};
use super::vector::{Vector, known, zero};
use crate::urdf::Motion;

/// Force and moment about the origin of a frame.
#[derive(Clone)]
pub(super) struct Wrench {
    pub(super) force: Vector,
    pub(super) moment: Vector,
}

impl Wrench {
    /// No force and no moment.
    pub(super) fn none() -> Self {
        Self { force: zero(), moment: zero() }
    }

    /// The part that moves a joint along or about its z axis.
    pub(super) fn along(&self, motion: Motion) -> Term {
        match motion {
            Motion::Revolute => self.moment[2].clone(),
            Motion::Prismatic => self.force[2].clone(),
        }
    }

    /// The sum of two in one frame.
    pub(super) fn plus(&self, tape: &mut Tape, other: &Self) -> Self {
        Self {
            force: tape.add_vectors(&self.force, &other.force),
            moment: tape.add_vectors(&self.moment, &other.moment),
        }
    }

    /// The same on the parent of a body, in the frame of the parent.
    pub(super) fn in_parent(&self, tape: &mut Tape, joint: &Joint<'_>) -> Self {
        let mut moment = self.moment.clone();
        if joint.body.motion == Motion::Prismatic {
            let lever = tape.cross(&joint.slide(), &self.force);
            moment = tape.add_vectors(&moment, &lever);
        }
        let [force, moment] = [&self.force, &moment].map(|own| joint.in_parent(tape, own));
        let lever = tape.cross(&known(&joint.body.placement.origin), &force);
        Self { moment: tape.add_vectors(&moment, &lever), force }
    }
}
