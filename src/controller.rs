//! What all controllers have in common.

use crate::{Control, Error};

/// A controller of the plant x_1' = x_2, ..., x_N' = u, for code that is generic over controllers.
pub trait Controller<const N: usize> {
    /// Floating-point type: `f64` or `f32`.
    type Real;

    /// Starts again at `t0` (in s): the deadline is now `t0 + tau`.
    ///
    /// # Errors
    /// [`Error::Param`] if `t0` is not finite; the controller is then as it was.
    fn arm(&mut self, t0: Self::Real) -> Result<(), Error>;

    /// u for the state `x` at time `t`: `t` in s, `x[i - 1]` = x_i in unit/s^(i-1), u in unit/s^N,
    /// where x_1 is in unit.
    ///
    /// # Errors
    /// [`Error::Input`] if `t` or `x` is not finite or `t < t0`, [`Error::Range`] if u is not
    /// finite.
    fn step(&self, t: Self::Real, x: &[Self::Real; N]) -> Result<Control<Self::Real>, Error>;
}
