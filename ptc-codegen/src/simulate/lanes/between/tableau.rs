//! The coefficients of Dormand and Prince's method of order 5, with the zeros of their table: what is added of a
//! derivative times 0 is what the library adds.

use differential_equations::tableau::ButcherTableau;

/// Stages of a step.
pub(super) const STAGES: usize = 7;

/// The method.
#[derive(Debug)]
pub(super) struct Tableau {
    pub(super) nodes: [f64; STAGES],
    pub(super) stages: [[f64; STAGES]; STAGES],
    pub(super) weights: [f64; STAGES],
    pub(super) error: [f64; STAGES],
    /// Weights of the fifth coefficient of the dense output.
    pub(super) dense: [f64; STAGES],
}

impl Tableau {
    /// Reads the tableau of the library.
    pub(super) fn new() -> Self {
        let table = ButcherTableau::<f64, STAGES, STAGES>::dopri5();
        let dense = table.bi.unwrap_or([[0.0; STAGES]; STAGES]);
        Self {
            nodes: table.c,
            stages: table.a,
            weights: table.b,
            error: table.er.unwrap_or([0.0; STAGES]),
            dense: dense[4],
        }
    }
}
