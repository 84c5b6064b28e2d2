//! Gains from poles.
use crate::algebra::{BigRational, integer};

/// A pole.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pole {
    /// Real part.
    pub re: BigRational,
    /// Imaginary part.
    pub im: BigRational,
}

/// Why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PoleError(pub String);

impl std::fmt::Display for PoleError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

/// Gains.
/// # Errors
/// Unpaired poles.
pub fn gains(poles: &[Pole]) -> Result<Vec<BigRational>, PoleError> {
    let mut c = vec![(integer(1), integer(0))];
    for p in poles {
        let mut next = vec![(integer(0), integer(0)); c.len() + 1];
        for (i, (re, im)) in c.iter().enumerate() {
            next[i + 1].0 += re;
            next[i + 1].1 += im;
            next[i].0 -= re * &p.re - im * &p.im;
            next[i].1 -= re * &p.im + im * &p.re;
        }
        c = next;
    }
    c.pop();
    if c.iter().any(|(_, im)| *im != integer(0)) {
        return Err(PoleError("a complex pole without its conjugate".into()));
    }
    Ok(c.into_iter().map(|(re, _)| re).collect())
}
