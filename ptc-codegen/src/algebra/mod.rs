//! Exact algebra: symbols, and sparse Laurent polynomials over the rationals.
//!
//! Everything the expansions produce is a Laurent polynomial in a few symbols, so equality is
//! decidable, simplification is arithmetic, and Horner forms fall out of the exponents.

pub(crate) mod float;
mod poly;
pub mod polynomial;
mod rational;
#[cfg(feature = "files")]
mod render;
pub mod stability;
mod symbol;

pub use poly::{Monomial, Poly};
pub(crate) use rational::{common_measure, multiple, whole};
#[cfg(feature = "files")]
pub use render::{latex, named_text, text};
pub use symbol::{Kind, Symbol};

pub use num_bigint::BigInt;
pub use num_rational::BigRational;

/// The integer `value` as an exact rational.
pub fn integer(value: i64) -> BigRational {
    BigRational::from_integer(BigInt::from(value))
}
