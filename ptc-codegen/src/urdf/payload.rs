//! A payload at the tip of a robot.

use num_traits::{Signed, Zero};

use super::geometry::unit;
use super::{Inertia, Placement, Robot, Vector};
use crate::algebra::BigRational;

/// A body that the tip carries.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Payload {
    mass: BigRational,
    /// Centre of mass in the frame of the tip.
    centre: Vector,
    /// xx, yy, zz, xy, xz, yz about the centre.
    tensor: [BigRational; 6],
}

impl Payload {
    /// The payload of 4 or 10 numbers: mass, centre, and inertia if there is one; `None` for others.
    pub fn of(numbers: &[BigRational]) -> Option<Self> {
        let [mass, x, y, z, rest @ ..] = numbers else { return None };
        let zero = std::array::from_fn(|_| BigRational::zero());
        let tensor = if rest.is_empty() { zero } else { rest.to_vec().try_into().ok()? };
        let centre = [x, y, z].map(Clone::clone);
        let is_legal = !mass.is_negative() && is_semidefinite(&tensor);
        is_legal.then(|| Self { mass: mass.clone(), centre, tensor })
    }

    /// Returns its numbers.
    pub fn numbers(&self) -> impl Iterator<Item = &BigRational> {
        let tensor = Some(&self.tensor).filter(|all| all.iter().any(|own| !own.is_zero()));
        [&self.mass].into_iter().chain(&self.centre).chain(tensor.into_iter().flatten())
    }

    /// Its inertia in the frame of the tip.
    fn inertia(&self) -> Inertia {
        let own = Inertia::central(self.mass.clone(), self.tensor.clone());
        own.placed(&Placement { rotation: unit(), origin: self.centre.clone() })
    }
}

/// Returns true if ixx, iyy, izz, ixy, ixz, iyz are those of a matrix with no negative principal minor: about no axis is
/// the moment of inertia negative.
fn is_semidefinite([xx, yy, zz, xy, xz, yz]: &[BigRational; 6]) -> bool {
    let minors = [xx * yy - xy * xy, xx * zz - xz * xz, yy * zz - yz * yz];
    let two = BigRational::from_integer(2.into());
    let whole = xx * &minors[2] - xy * xy * zz + two * xy * xz * yz - xz * xz * yy;
    [xx, yy, zz, &whole].into_iter().chain(&minors).all(|minor| !minor.is_negative())
}

impl Robot {
    /// Puts a payload in place of another one at the tip; `None` if the robot has no tip that moves.
    #[must_use]
    pub fn carrying(&self, payload: Option<&Payload>, before: Option<&Payload>) -> Option<Self> {
        let tip = self.tip.as_ref()?;
        let body = tip.body?;
        let mut robot = self.clone();
        let inertia = &mut robot.bodies[body].inertia;
        if let Some(before) = before {
            inertia.subtract(&before.inertia().placed(&tip.placement));
        }
        if let Some(payload) = payload {
            inertia.add(&payload.inertia().placed(&tip.placement));
        }
        Some(robot)
    }
}
