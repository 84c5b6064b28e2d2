//! Plants with several inputs and outputs: each output with its derivatives is a chain of integrators,
//! and a matrix says which input moves the last rate of which.

pub(crate) mod arm;
mod names;
mod text;

use super::decide::is_zero;
use super::determinant::{CLOSED, determinant, divided, inverse, is_regular, written_out};
use super::lie::{Affine, Ill};
use super::{Intermediates, Values, named};
use crate::collect::listed;
use crate::expression::effort::bounded;
use crate::expression::{Expression, Variable};
use crate::parameter::Name;
pub use arm::Arm;
use text::rows;

/// A plant with as many outputs as inputs. Its states are `x_1`..`x_N` in its expressions, and its
/// inputs stand behind them, `x_(N+1)`..`x_(N+m)`, in its dynamics alone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coupled {
    /// Names of the states.
    pub states: Vec<Name>,
    /// Names of the inputs.
    pub inputs: Vec<Name>,
    /// Named intermediate values of its expressions.
    pub intermediates: Intermediates,
    /// The outputs, one for each input.
    pub outputs: Vec<Output>,
    /// Computation of the inputs from the wanted derivatives of the outputs.
    pub inverse: Inverse,
    /// True if it represents several axes for a law of all of them: a chain of integrators for each, whose states a
    /// call is given in rows.
    pub is_of_axes: bool,
}

/// An output as a chain of integrators.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    /// The output and its derivatives up to that of order r - 1: L_f^(i-1) h for i = 1..r.
    pub coordinates: Vec<Expression>,
    /// L_f^r h, where no input is in it; 0 where the inputs follow without it.
    pub drift: Expression,
}

/// Computation of the inputs from w, the wanted derivatives of order r_i without the drifts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Inverse {
    /// u = D^-1 w with the decoupling matrix D = (L_gj L_f^(r_i-1) h_i).
    Adjugate {
        /// The rate of each state.
        dynamics: Vec<Expression>,
        /// det D, which is 1 where the adjugate has been divided by it.
        determinant: Expression,
        /// Its adjugate.
        adjugate: Vec<Vec<Expression>>,
    },
    /// The same of more outputs than have a closed form: u solves D u = w.
    Elimination {
        /// The rate of each state.
        dynamics: Vec<Expression>,
        /// D.
        matrix: Vec<Vec<Expression>>,
    },
    /// u = M(q) w + bias(q, q') of a plant M q'' + bias = u, without an inverse.
    Inertia {
        /// M.
        inertia: Vec<Vec<Expression>>,
        /// Inputs that hold q'' = 0.
        bias: Vec<Expression>,
    },
    /// The same of a robot, by the recursive Newton-Euler algorithm.
    Robot(Box<Arm>),
}

/// Why the outputs are no chains of integrators that the inputs move one by one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum IllCoupled {
    /// Defect of the plant, or of an output, from 0.
    One(Option<usize>, Ill),
    /// The determinant may be 0 for all states: undecided.
    Open(String),
    /// The determinant is 0 for all states; the entries of the matrix.
    Singular(String),
}

impl Coupled {
    /// Returns true if drifts and decoupling matrix are constants, so that held inputs move each chain by the last rate
    /// that it has at the sample.
    pub fn is_constant(&self) -> bool {
        let (matrix, vectors) = match &self.inverse {
            Inverse::Adjugate { determinant, adjugate, .. } => {
                (adjugate, std::slice::from_ref(determinant))
            }
            Inverse::Elimination { matrix, .. } => (matrix, &[][..]),
            Inverse::Inertia { inertia, bias } => (inertia, bias.as_slice()),
            Inverse::Robot(_) => return false,
        };
        let drifts = self.outputs.iter().map(|output| &output.drift);
        !drifts.chain(matrix.iter().flatten()).chain(vectors).any(Expression::varies)
    }

    /// The plant z' = `dynamics` with these outputs. `values` are those of the parameters that are
    /// fixed, which decide what is 0.
    ///
    /// # Errors
    /// The plant cannot be decoupled by static feedback, and why.
    pub fn new(
        (states, inputs): (Vec<Name>, Vec<Name>),
        outputs: &[Expression],
        dynamics: Vec<Expression>,
        values: &Values,
    ) -> Result<Self, IllCoupled> {
        bounded(|| {
            let names = [states.as_slice(), &inputs].concat();
            let controls: Vec<_> = (states.len() + 1..=names.len()).map(Variable::State).collect();
            let plant = Affine::of((&names, None), &controls, &dynamics, values)
                .map_err(|ill| IllCoupled::One(None, ill))?;
            let chain = |(index, output)| {
                chain(&plant, output, values).map_err(|ill| IllCoupled::One(Some(index), ill))
            };
            let chains = outputs.iter().enumerate().map(chain).collect::<Result<Vec<_>, _>>()?;
            let (outputs, matrix): (Vec<_>, Vec<_>) = chains.into_iter().unzip();
            if matrix.len() > CLOSED {
                let text = |e: &Expression| plant.text(e);
                match is_regular(&matrix, values) {
                    Some(true) => {}
                    Some(false) => return Err(IllCoupled::Singular(rows(&text, &matrix))),
                    None => {
                        return Err(IllCoupled::Open(format!("det {}", rows(&text, &matrix))));
                    }
                }
                let inverse = Inverse::Elimination { dynamics, matrix };
                return Ok(Self::of(states, inputs, outputs, inverse));
            }
            let (determinant, adjugate) = inverse(&matrix);
            match is_zero(&determinant, values) {
                Some(false) => {}
                Some(true) => {
                    let text = |e: &Expression| plant.text(e);
                    return Err(IllCoupled::Singular(rows(&text, &matrix)));
                }
                None => return Err(IllCoupled::Open(plant.text(&determinant))),
            }
            let (determinant, adjugate) = divided(determinant, adjugate);
            let inverse = Inverse::Adjugate { dynamics, determinant, adjugate };
            Ok(Self::of(states, inputs, outputs, inverse))
        })
    }

    /// The plant M q'' + bias = u, whose states are the coordinates q, its outputs, and then their rates.
    ///
    /// # Errors
    /// M is singular for all q.
    pub fn lagrangian(
        (states, inputs): (Vec<Name>, Vec<Name>),
        (inertia, bias): (Vec<Vec<Expression>>, Vec<Expression>),
        values: &Values,
    ) -> Result<Self, IllCoupled> {
        bounded(|| {
            let m = inputs.len();
            // Of a larger one the determinant takes m! products, and the law takes none.
            if m <= CLOSED && is_zero(&determinant(&inertia), values) == Some(true) {
                let text = |e: &Expression| named(&states, None, e).to_string();
                return Err(IllCoupled::Singular(rows(&text, &inertia)));
            }
            let outputs = Output::positions(m);
            let inverse = Inverse::Inertia { inertia, bias };
            Ok(Self::of(states, inputs, outputs, inverse))
        })
    }

    fn of(states: Vec<Name>, inputs: Vec<Name>, outputs: Vec<Output>, inverse: Inverse) -> Self {
        let intermediates = Intermediates::default();
        Self { states, inputs, intermediates, outputs, inverse, is_of_axes: false }
    }

    /// A chain of order `n` for each of these input gains, which divide the law of each.
    pub fn of_axes(n: usize, gains: &[Expression]) -> Option<Self> {
        let m = gains.len();
        let names = (1..=m).flat_map(|j| (1..=n).map(move |i| Name::new(&format!("x{i}_{j}"))));
        let inputs = (1..=m).map(|j| Name::new(&format!("u{j}")));
        let state = |place: usize| Expression::from(Variable::State(place));
        let output = |j: usize| Output {
            coordinates: (1..=n).map(|i| state(j * n + i)).collect(),
            drift: Expression::integer(0),
        };
        let rate = |place: usize| match place % n {
            0 => gains[place / n - 1].clone().mul(state(m * n + place / n)),
            _ => state(place + 1),
        };
        let entry = |i: usize, j: usize| Expression::integer(i64::from(i == j));
        let inverse = Inverse::Adjugate {
            dynamics: (1..=m * n).map(rate).collect(),
            determinant: Expression::integer(1),
            adjugate: (0..m).map(|i| (0..m).map(|j| entry(i, j)).collect()).collect(),
        };
        let outputs = (0..m).map(output).collect();
        let own = Self::of(
            names.collect::<Option<_>>()?,
            inputs.collect::<Option<_>>()?,
            outputs,
            inverse,
        );
        Some(Self { is_of_axes: true, ..own })
    }

    /// The outputs as functions of the states.
    pub fn output(&self, index: usize) -> &Expression {
        &self.outputs[index].coordinates[0]
    }

    /// The order of each output's chain.
    pub fn orders(&self) -> Vec<usize> {
        self.outputs.iter().map(|output| output.coordinates.len()).collect()
    }

    /// Every expression that the law is computed from.
    pub fn expressions(&self) -> impl Iterator<Item = &Expression> {
        let chains = self.outputs.iter();
        let chains = chains.flat_map(|output| output.coordinates.iter().chain([&output.drift]));
        let (matrix, others): (&[Vec<Expression>], _) = match &self.inverse {
            Inverse::Adjugate { determinant, adjugate, .. } => {
                (adjugate, std::slice::from_ref(determinant))
            }
            Inverse::Elimination { matrix, .. } => (matrix, [].as_slice()),
            Inverse::Inertia { inertia, bias } => (inertia, bias.as_slice()),
            Inverse::Robot(_) => (&[], [].as_slice()),
        };
        listed(chains.chain(matrix.iter().flatten()).chain(others))
    }

    /// The determinant of the decoupling matrix, where the law divides by it and it is short enough.
    pub fn determinant(&self) -> Option<Expression> {
        match &self.inverse {
            Inverse::Adjugate { determinant, .. } => Some(determinant.clone()),
            Inverse::Elimination { matrix, .. } => written_out(matrix),
            Inverse::Inertia { .. } | Inverse::Robot(_) => None,
        }
    }

    /// The rate of each state, where they are given.
    pub fn dynamics(&self) -> &[Expression] {
        match &self.inverse {
            Inverse::Adjugate { dynamics, .. } | Inverse::Elimination { dynamics, .. } => dynamics,
            Inverse::Inertia { .. } | Inverse::Robot(_) => &[],
        }
    }
}

/// The chain of an output, and the gains of the inputs in its last rate.
fn chain(
    plant: &Affine<'_>,
    output: &Expression,
    values: &Values,
) -> Result<(Output, Vec<Expression>), Ill> {
    let mut coordinates = vec![output.clone()];
    for order in 1..=plant.drifts.len() {
        let last = plant.smooth(&coordinates[order - 1])?;
        let gains = plant.gains.iter().map(|field| plant.along(last, field, order));
        let gains = gains.collect::<Result<Vec<_>, _>>()?;
        let drift = plant.along(last, &plant.drifts, order)?;
        let zero: Vec<_> = gains.iter().map(|gain| is_zero(gain, values)).collect();
        if zero.contains(&Some(false)) {
            let kept = |(gain, zero)| match zero {
                Some(true) => Expression::integer(0),
                _ => gain,
            };
            let row = gains.into_iter().zip(zero).map(kept).collect();
            return Ok((Output { coordinates, drift }, row));
        }
        if let Some(open) = zero.iter().position(Option::is_none) {
            return Err(Ill::Open(plant.text(&gains[open])));
        }
        coordinates.push(drift);
    }
    Err(Ill::Unreached)
}
