//! The coefficients of Dormand and Prince's method of order 8, without the zeros of their table.

use differential_equations::tableau::ButcherTableau;

/// Stages of a step.
pub(super) const STAGES: usize = 12;

/// The derivative at the end of a step, after its stages; those of the dense output follow it.
pub(super) const END: usize = STAGES;

/// All derivatives of a step.
pub(super) const ALL: usize = 16;

/// Coefficients of the dense output.
pub(super) const DENSE: usize = 8;

/// Weights of derivatives.
pub(super) type Row = Vec<(usize, f64)>;

/// The method.
#[derive(Debug)]
pub(super) struct Tableau {
    pub(super) nodes: [f64; ALL],
    pub(super) stages: Vec<Row>,
    pub(super) weights: Row,
    pub(super) error: Row,
    /// The weights less those of the embedded method of order 3.
    pub(super) embedded: Row,
    /// Weights of the dense output from its fifth coefficient on.
    pub(super) dense: Vec<Row>,
}

impl Tableau {
    /// Reads the tableau of the library.
    pub(super) fn new() -> Self {
        let ButcherTableau { c, a, b, bh, bi, er } = ButcherTableau::<f64, STAGES, ALL>::dop853();
        let row = |numbers: &[f64]| -> Row {
            numbers.iter().copied().enumerate().filter(|(_, weight)| *weight != 0.0).collect()
        };
        let third = bh.unwrap_or([0.0; STAGES]);
        let embedded: [f64; STAGES] = std::array::from_fn(|stage| b[stage] - third[stage]);
        let dense = bi.unwrap_or([[0.0; ALL]; ALL]);
        Self {
            nodes: c,
            stages: a.iter().map(|a| row(a)).collect(),
            weights: row(&b),
            error: row(&er.unwrap_or([0.0; STAGES])),
            embedded: row(&embedded),
            dense: dense[4..DENSE].iter().map(|weights| row(weights)).collect(),
        }
    }
}
