//! Forces of the drives: rotors, viscous friction and dry friction, whose sign is smooth.

use num_traits::Zero;

use super::model::Joint;
use super::tape::{Tape, Term};
use crate::expression::Function;

impl Joint<'_> {
    /// The force that moves the drive of the joint.
    pub(super) fn drive(&self, tape: &mut Tape) -> Term {
        let drive = &self.body.drive;
        let [rotor, damping] = [&drive.rotor, &drive.damping].map(Term::from);
        let smooth = tape.products(&[(&rotor, self.acceleration), (&damping, self.rate)]);
        if drive.friction.is_zero() {
            return smooth;
        }
        let width = Term::Known(&drive.width * &drive.width);
        let square = tape.mul(self.rate, self.rate);
        let sum = tape.add(&square, &width);
        let size = tape.call(Function::Sqrt, &sum);
        let sign = tape.quotient(self.rate, &size);
        let dry = tape.mul(&Term::from(&drive.friction), &sign);
        tape.add(&smooth, &dry)
    }
}
