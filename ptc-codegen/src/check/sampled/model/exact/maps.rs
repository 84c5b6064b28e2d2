//! Maps from the chains that inputs move exactly to the outputs with their derivatives, the states and the inputs:
//! exact fractions, of which sizes are summed.

use crate::algebra::BigRational;
use crate::linear::{Matrix, scaled, sizes};
use crate::request::Exact;

/// Rows over xi and v, with the sizes of what multiplies errors.
pub(super) struct Maps {
    /// xi of x.
    pub(super) coordinates: Matrix,
    /// xi of the outputs with their derivatives, and these of xi.
    pub(super) of_outputs: Matrix,
    pub(super) outputs: Matrix,
    /// x of xi.
    pub(super) states: Matrix,
    /// F.
    pub(super) drift: Matrix,
    /// G and its inverse.
    pub(super) gain: Matrix,
    pub(super) inverse: Matrix,
    /// -G^-1 F of x, and of xi.
    pub(super) of_measured: Matrix,
    pub(super) of_chains: Matrix,
}

impl Maps {
    /// `None` where the constants are singular.
    pub(super) fn new(exact: &Exact) -> Option<Self> {
        let of = |rows: &Vec<Vec<BigRational>>| Matrix::of(rows.clone());
        let chains = &exact.chains;
        let (coordinates, drift) = (of(&chains.coordinates), of(&chains.drift));
        let inverse = of(&chains.inverse);
        let derivatives = exact.plant.derivatives();
        let states = coordinates.inverse()?;
        let minus = BigRational::from_integer((-1).into());
        let of_measured = scaled(&inverse.times(&drift), &minus);
        Some(Self {
            of_outputs: coordinates.times(&derivatives.inverse()?),
            outputs: derivatives.times(&states),
            gain: inverse.inverse()?,
            of_chains: of_measured.times(&states),
            coordinates,
            states,
            drift,
            inverse,
            of_measured,
        })
    }
}

/// The sums of what is at most `most`, by the sizes of the entries of a matrix.
pub(super) fn summed(of: &Matrix, most: &[BigRational]) -> Vec<BigRational> {
    sizes(of).on(most)
}

/// The sums of two such bounds.
pub(super) fn both(a: Vec<BigRational>, b: &[BigRational]) -> Vec<BigRational> {
    a.into_iter().zip(b).map(|(a, b)| a + b).collect()
}
