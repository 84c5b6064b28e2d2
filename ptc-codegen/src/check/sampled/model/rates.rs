//! How large the inputs, and the rates of what they move, may be on the envelope.

use super::super::rounded::Rounded;
use super::super::systems::solution;
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

/// How often the box around such cells is divided again.
const NARROWER: u32 = 3;

/// What is bounded on the envelope.
pub(super) struct Rates<'a> {
    spec: &'a Spec,
    motion: &'a Motion,
    /// The chains, and the inputs from what is wanted, as they are emitted.
    emitted: Program,
    /// The rates of the sums, the matrix, how the sums, and then the coordinates, go with each state.
    exact: Program,
    envelope: Vec<Range>,
    /// The bound of the error of each state that is measured.
    errors: Vec<f64>,
    cells: usize,
}

/// Bounds of the loops of all outputs.
pub(super) struct Reached {
    /// Of the last rate that is wanted of each output.
    pub(super) wanted: Vec<f64>,
    /// Of the chains, one after the other.
    pub(super) chains: Vec<f64>,
    /// Of what moves each chain beside it.
    pub(super) force: Vec<f64>,
}

/// Bounds on the envelope.
pub(super) struct Sizes {
    /// Of the size of each input.
    pub(super) u: Vec<f64>,
    /// Of what moves each chain beside what is wanted.
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
    /// That a coordinate has none.
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
    /// That there is none.
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
    /// That there are none.
    pub(super) fn sizes(&self, reached: &Reached) -> Result<Sizes, String> {
        let cells = self.within(&reached.chains)?;
        let inputs = self.inputs(&cells, &reached.wanted)?;
        let acting: Vec<_> = inputs.iter().map(|input| input.acting).collect();
        let of_chains = reached.wanted.iter().zip(&reached.force).map(|(w, force)| w + force);
        let held = if self.motion.is_mechanical { of_chains.collect() } else { acting };
        let force = self.forces(&cells, &held, &inputs)?;
        // The sums above round too.
        let wider = |value: f64| value * (1.0 + 1e-12);
        Ok(Sizes {
            u: inputs.iter().map(|input| wider(input.u)).collect(),
            force: force.into_iter().map(wider).collect(),
        })
    }

    /// # Errors
    /// That an input has no bound.
    fn inputs(&self, cells: &[Vec<Range>], wanted: &[f64]) -> Result<Vec<Of>, String> {
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
        let of = |(u, inexact): (f64, f64)| Of {
            u,
            // What acts on the plant has been through the actuator and the true input gain.
            acting: (1.0 + off) * (u + step),
            off: inexact + step + off * (u + step),
        };
        Ok(most.into_iter().map(of).collect())
    }

    /// How far the last rates get from what is wanted of them: at a sample by what the sensors and the inputs are
    /// off, behind it by the rates of the sums.
    ///
    /// # Errors
    /// That there is no bound.
    fn forces(
        &self,
        cells: &[Vec<Range>],
        held: &[f64],
        inputs: &[Of],
    ) -> Result<Vec<f64>, String> {
        let (m, states) = (inputs.len(), self.errors.len());
        let behind = self.exact.watched.len() - self.motion.coordinates.len() * states;
        let mut exact = self.on(&self.exact, &self.exact.watched[..behind])?;
        let (mut rates, mut at_sample) = (vec![0.0_f64; m], vec![0.0_f64; m]);
        for cell in cells {
            let found = exact.at(cell, held);
            let (moved, found) = found.split_at(m);
            let (matrix, slopes) = found.split_at(m * m);
            let high = |value: &Option<Rounded>| size(value, |value| value.exact.size().high());
            let off = |k: usize| {
                let seen = self.seen(&slopes[k * states..][..states]);
                match self.motion.is_mechanical {
                    true => inputs[k].off + seen,
                    false => {
                        let row = matrix[k * m..].iter().zip(inputs);
                        row.map(|(gain, input)| high(gain) * input.off).sum::<f64>() + seen
                    }
                }
            };
            let moved: Vec<_> = moved.iter().map(high).collect();
            let off: Vec<_> = (0..m).map(off).collect();
            for (most, found) in [(&mut rates, moved), (&mut at_sample, off)] {
                let found = self.of_chains(matrix, found);
                most.iter_mut().zip(found).for_each(|(most, found)| *most = greater(*most, found));
            }
        }
        let h = one_or_each(self.spec.promises.sample_time.as_slice(), 0).unwrap_or(f64::INFINITY);
        let force = at_sample.iter().zip(&rates).map(|(off, rate)| h * rate + off);
        let force: Vec<_> = force.collect();
        match force.iter().all(|force| force.is_finite()) {
            true => Ok(force),
            false => Err(match (m, self.motion.is_mechanical) {
                (1, _) => "no bound of the rate of f + g u is found within x_max".to_owned(),
                (_, true) => "no bound of the rate of q'' is found within x_max: M may be singular there, or what it is made of has no value".to_owned(),
                (_, false) => {
                    "no bound of the rates that the inputs move is found within x_max".to_owned()
                }
            }),
        }
    }

    /// What sums within these bounds are to the chains: of a mechanical plant the solutions of M s = sum.
    fn of_chains(&self, matrix: &[Option<Rounded>], sums: Vec<f64>) -> Vec<f64> {
        if !self.motion.is_mechanical {
            return sums;
        }
        let entries: Option<Vec<_>> = matrix.iter().map(|entry| Some(entry.as_ref()?.exact)).collect();
        let around: Vec<_> = sums.iter().map(|sum| Range::from(*sum).both_signs()).collect();
        let found = entries.and_then(|entries| solution(&entries, &around));
        let infinite = || vec![f64::INFINITY; sums.len()];
        found.map_or_else(infinite, |found| found.iter().map(|s| s.size().high()).collect())
    }

    /// Values of a program over cells around which the sensors err.
    fn on<'b>(&'b self, program: &'b Program, values: &[Value]) -> Result<OnCells<'b>, String> {
        OnCells::new(self.spec, program, values, &self.errors)
    }

    /// What the errors of the sensors do by these slopes.
    fn seen(&self, slopes: &[Option<Rounded>]) -> f64 {
        let part = |(slope, error): (&Option<Rounded>, &f64)| match *error {
            0.0 => 0.0,
            error => error * size(slope, |value| value.exact.size().high()),
        };
        slopes.iter().zip(&self.errors).map(part).sum()
    }
}

/// Bounds of one input.
struct Of {
    /// Of its size as the program computes it, and as it acts.
    u: f64,
    acting: f64,
    /// How far what acts may be from what was to act.
    off: f64,
}

/// The greater of two bounds; infinite where one is no number, which `max` would leave out.
fn greater(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::INFINITY } else { a.max(b) }
}
