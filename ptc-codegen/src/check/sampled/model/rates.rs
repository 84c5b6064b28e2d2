//! Bounds of the inputs, and of the rates of the sums that they move, on the envelope.

use super::super::rounded::{ROUNDED, Rounded};
use super::cell::{OnCells, cells, size};
use super::motion::Motion;
use crate::expression::Expression;
use crate::expression::enclosure::Range;
use crate::lower::{at_sample, plant};
use crate::parameter::Fixed;
use crate::program::{Program, Value, passes};
use crate::request::{Spec, one_or_each};

/// Cells into which the envelope is divided, at most: of one input, and of several.
const CELLS: [usize; 2] = [600, 1300];

/// Number of further divisions of the box around such cells.
const NARROWER: u32 = 3;

/// Subject of the bounds on the envelope.
pub(super) struct Rates<'a> {
    pub(super) spec: &'a Spec,
    pub(super) motion: &'a Motion,
    /// The chains, and the inputs from what is wanted, as they are emitted.
    pub(super) emitted: Program,
    /// The rates of the sums, the matrix, how the sums, and then the coordinates, go with each state.
    pub(super) exact: Program,
    envelope: Vec<Range>,
    /// The bound of the error of each state that is measured.
    pub(super) errors: Vec<f64>,
    cells: usize,
}

/// Bounds of the loops of all outputs.
pub(super) struct Reached {
    /// Bound of the wanted last rate of each output.
    pub(super) wanted: Vec<f64>,
    /// Bounds of the chains, one after the other.
    pub(super) chains: Vec<f64>,
    /// Bound of the force on each chain in addition to it.
    pub(super) force: Vec<f64>,
}

/// Bounds on the envelope.
pub(super) struct Sizes {
    /// Bound of the size of each input.
    pub(super) u: Vec<f64>,
    /// Bound of the force on each chain in addition to the wanted rate.
    pub(super) force: Vec<f64>,
}

impl<'a> Rates<'a> {
    /// # Errors
    /// Why there are no such bounds.
    pub(super) fn new(spec: &'a Spec, motion: &'a Motion) -> Result<Self, String> {
        if let Some(sum) = motion.sums.iter().find(|sum| sum.any(&Expression::is_kink)) {
            return Err(match (&spec.model, spec.decoupled()) {
                (Some(model), None) => {
                    format!("f + g u = {} has a kink, at which it has no rate", model.text(sum))
                }
                _ => "a rate of the plant has a kink, at which it has no rate".to_owned(),
            });
        }
        let mut all = [motion.moved.as_slice(), &motion.matrix].concat();
        all.extend(motion.slopes(&motion.sums));
        all.extend(motion.slopes(&motion.coordinates));
        let states = motion.states.len();
        let errors = (0..states).map(|j| {
            let each = |bounds: &[Fixed]| one_or_each(bounds, j).unwrap_or(0.0);
            each(&spec.promises.noise) + each(&spec.promises.sensor_step) / 2.0
        });
        let errors: Vec<_> = errors.collect();
        let optimised = |program| passes::optimise(program, &mut |_, _| {});
        let (emitted, exact) = (optimised(at_sample(spec)), optimised(plant(spec, &all)));
        let bound = |j: usize| one_or_each(&spec.promises.x_max, j).unwrap_or(f64::INFINITY);
        let envelope = (0..states).map(|j| Range::from(bound(j)).both_signs()).collect();
        let cells = CELLS[usize::from(motion.inputs.len() > 1)];
        Ok(Self { spec, motion, emitted, exact, envelope, errors, cells })
    }

    /// Bounds of the error of each coordinate of the chains, as the law sees it.
    ///
    /// # Errors
    /// Fails if a coordinate has none.
    pub(super) fn sensors(&self) -> Result<Vec<f64>, String> {
        let (states, chains) = (self.errors.len(), self.motion.coordinates.len());
        let mut rounded = self.on(&self.emitted, &self.emitted.watched)?;
        let behind = self.exact.watched.len() - chains * states;
        let mut slopes = self.on(&self.exact, &self.exact.watched[behind..])?;
        let mut most = vec![0.0_f64; chains];
        for cell in cells(&self.envelope, self.cells) {
            let (rounded, slopes) = (rounded.at(&cell, &[]), slopes.at(&cell, &[]));
            for (i, most) in most.iter_mut().enumerate() {
                let own = size(&rounded[i], |value| value.error);
                *most = greater(*most, own + self.seen(&slopes[i * states..]));
            }
        }
        match most.iter().position(|bound| !bound.is_finite()) {
            Some(i) => {
                let name = &self.spec.names_of_chains()[i];
                Err(format!("x{name} has no bound within x_max"))
            }
            None => Ok(most),
        }
    }

    /// Cells that hold every state of the envelope whose chains are within bounds.
    ///
    /// # Errors
    /// Fails if there is no such cell.
    fn within(&self, chains: &[f64]) -> Result<Vec<Vec<Range>>, String> {
        let exact = vec![0.0; self.errors.len()];
        let mut coordinates =
            OnCells::new(self.spec, &self.emitted, &self.emitted.watched, &exact)?;
        let mut around = self.envelope.clone();
        let mut left = Vec::new();
        for _ in 0..NARROWER {
            left = cells(&around, self.cells);
            left.retain(|cell| !coordinates.is_beyond(cell, chains));
            let hull = left
                .iter()
                .cloned()
                .reduce(|a, b| a.into_iter().zip(b).map(|(a, b)| a.hull(&b)).collect());
            around = hull.ok_or("no state within x_max has a chain within its bounds")?;
        }
        Ok(left)
    }

    /// The bounds where all is within those that the loops reach.
    ///
    /// # Errors
    /// Fails if no bounds are found.
    pub(super) fn sizes(&self, reached: &Reached) -> Result<Sizes, String> {
        let cells = self.within(&reached.chains)?;
        let around = |bounds: &[f64]| -> Vec<_> {
            bounds.iter().map(|bound| Range::from(*bound).both_signs()).collect()
        };
        let inputs = self.inputs(&cells, &around(&reached.wanted))?;
        let last = reached.wanted.iter().zip(&reached.force).map(|(w, force)| w + force);
        let last: Vec<_> = last.map(|bound| Range::from(bound * ROUNDED).both_signs()).collect();
        let force = self.forces(&cells, &last, &inputs)?;
        // The sums above round too.
        let wider = |value: f64| value * (1.0 + 1e-12);
        Ok(Sizes {
            u: inputs.iter().map(|input| wider(input.u)).collect(),
            force: force.into_iter().map(wider).collect(),
        })
    }

    /// # Errors
    /// Fails if an input has no bound.
    fn inputs(&self, cells: &[Vec<Range>], wanted: &[Range]) -> Result<Vec<InputBound>, String> {
        let controls = self.emitted.controls();
        let mut most = vec![(0.0_f64, 0.0_f64); controls.len()];
        let mut emitted = self.on(&self.emitted, &controls)?;
        for cell in cells {
            for (found, (u, inexact)) in emitted.at(cell, wanted).iter().zip(&mut most) {
                *u = greater(*u, size(found, |value| value.emitted().size().high()));
                *inexact = greater(*inexact, size(found, |value| value.error));
            }
        }
        if let Some(j) = most.iter().position(|(u, _)| !u.is_finite()) {
            return Err(match self.motion.inputs.as_slice() {
                [_] => "u is not bounded within x_max: g may be 0 there, or f or g has no value"
                    .to_owned(),
                all => format!(
                    "{} is not bounded within x_max: the decoupling matrix may be singular there, or what it is made of has no value",
                    all[j]
                ),
            });
        }
        let promises = &self.spec.promises;
        let step = promises.u_step.as_slice();
        let step = one_or_each(step, 0).unwrap_or(0.0) / 2.0;
        let off = (0..promises.g_error.len())
            .filter_map(|i| one_or_each(&promises.g_error, i))
            .fold(0.0, |most: f64, part| most.max((part - 1.0).abs()));
        let of = |(u, inexact): (f64, f64)| InputBound {
            u,
            // What acts on the plant has been through the actuator and the true input gain.
            acting: (1.0 + off) * (u + step),
            off: inexact + step + off * (u + step),
        };
        Ok(most.into_iter().map(of).collect())
    }

    /// Values of a program over cells around which the sensors err.
    pub(super) fn on<'b>(
        &'b self,
        program: &'b Program,
        values: &[Value],
    ) -> Result<OnCells<'b>, String> {
        OnCells::new(self.spec, program, values, &self.errors)
    }

    /// Bounds the effect of the sensor errors through these slopes.
    pub(super) fn seen(&self, slopes: &[Option<Rounded>]) -> f64 {
        let part = |(slope, error): (&Option<Rounded>, &f64)| match *error {
            0.0 => 0.0,
            error => error * size(slope, |value| value.exact.size().high()),
        };
        slopes.iter().zip(&self.errors).map(part).sum()
    }
}

/// Bounds of one input.
pub(super) struct InputBound {
    /// Bounds of its size as the program computes it, and as it acts.
    pub(super) u: f64,
    pub(super) acting: f64,
    /// Bound of the difference between the input that acts and the intended one.
    pub(super) off: f64,
}

/// The greater of two bounds; infinite where one is no number, which `max` would leave out.
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::INFINITY } else { a.max(b) }
}
