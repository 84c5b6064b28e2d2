//! Mass, first moment and second moments of a body.

use std::array::from_fn;

use num_traits::Zero;

use super::geometry::{Matrix, Placement, Vector, product, sum, times, transposed, zero};
use crate::algebra::{BigRational, integer};

/// The inertia of a body about the origin of a frame. All of it is linear in the density, so bodies add up.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Inertia {
    /// Mass.
    pub mass: BigRational,
    /// Integral of the position over the mass.
    pub first: Vector,
    /// Integral of the products of coordinates over the mass.
    pub second: Matrix,
}

impl Inertia {
    /// That of nothing.
    pub fn none() -> Self {
        Self { mass: BigRational::zero(), first: zero(), second: from_fn(|_| zero()) }
    }

    /// The inertia of a body about its centre of mass, from its tensor (xx, yy, zz, xy, xz, yz there).
    pub(super) fn central(mass: BigRational, tensor: [BigRational; 6]) -> Self {
        let [xx, yy, zz, xy, xz, yz] = tensor;
        let half = (&xx + &yy + &zz) / integer(2);
        let second = [
            [&half - xx, -xy.clone(), -xz.clone()],
            [-xy, &half - yy, -yz.clone()],
            [-xz, -yz, &half - zz],
        ];
        Self { mass, first: zero(), second }
    }

    /// The same in a frame in which its own frame has this placement.
    #[must_use]
    pub(crate) fn placed(&self, placement: &Placement) -> Self {
        let Placement { rotation, origin } = placement;
        let first = times(rotation, &self.first);
        let second = product(&product(rotation, &self.second), &transposed(rotation));
        let second = from_fn(|i| {
            from_fn(|j| {
                let moved = &origin[i] * &first[j] + &first[i] * &origin[j];
                &second[i][j] + moved + &self.mass * &origin[i] * &origin[j]
            })
        });
        let first = from_fn(|i| &first[i] + &self.mass * &origin[i]);
        Self { mass: self.mass.clone(), first, second }
    }

    /// Takes in another body.
    pub(crate) fn add(&mut self, more: &Self) {
        self.mass += &more.mass;
        self.first = sum(&self.first, &more.first);
        self.second = from_fn(|i| sum(&self.second[i], &more.second[i]));
    }

    /// Takes out another body.
    pub(super) fn subtract(&mut self, less: &Self) {
        self.mass -= &less.mass;
        self.first = from_fn(|i| &self.first[i] - &less.first[i]);
        self.second = from_fn(|i| from_fn(|j| &self.second[i][j] - &less.second[i][j]));
    }

    /// The part that acts on a body in the same way whatever the position of a joint about its z axis: what lies on that
    /// axis. It is taken out.
    pub(crate) fn take_on_axis(&mut self) -> Self {
        let mut taken = Self::none();
        std::mem::swap(&mut taken.mass, &mut self.mass);
        std::mem::swap(&mut taken.first[2], &mut self.first[2]);
        std::mem::swap(&mut taken.second[2][2], &mut self.second[2][2]);
        taken
    }

    /// The same of a joint that slides: the second moments. They are taken out.
    pub(crate) fn take_second(&mut self) -> Self {
        let second = std::mem::replace(&mut self.second, from_fn(|_| zero()));
        Self { second, ..Self::none() }
    }
}

/// A placement without a shift.
pub(super) fn turned(rotation: Matrix) -> Placement {
    Placement { rotation, ..Placement::identity() }
}

#[cfg(test)]
mod tests {
    use num_traits::One;

    use super::super::geometry::unit;
    use super::*;

    #[test]
    fn shifted_bodies_obey_the_parallel_axis_theorem() {
        let tensor = [1, 2, 3, 0, 0, 0].map(integer);
        let body = Inertia::central(integer(2), tensor);
        let shift = Placement { rotation: unit(), origin: [3, 0, 0].map(integer) };
        let moved = body.placed(&shift);
        assert_eq!(moved.first, [6, 0, 0].map(integer));
        // I_zz = S_xx + S_yy = 3 + m 3^2.
        assert_eq!(&moved.second[0][0] + &moved.second[1][1], integer(21));
        assert_eq!(&moved.second[1][1] + &moved.second[2][2], integer(1));
        assert!(moved.mass > BigRational::one());
    }
}
