//! How large u, and the rate of f + g u, may be on the envelope.

use super::super::rounded::Rounded;
use super::cell::{OnCells, cells, size};
use crate::expression::enclosure::Range;
use crate::expression::{Expression, Variable};
use crate::lower::{at_sample, plant};
use crate::model::Model;
use crate::parameter::Fixed;
use crate::program::{Program, Value, passes};
use crate::request::{Spec, one_or_each};

/// Cells into which the envelope is divided, at most.
const CELLS: usize = 600;

/// How often the box around such cells is divided again.
const NARROWER: u32 = 3;

/// What is bounded on the envelope.
pub(super) struct Rates<'a> {
    spec: &'a Spec,
    /// The chain, and u from w, as they are emitted.
    emitted: Program,
    /// d(f + g u)/dt, g, and how f + g u, and each coordinate, goes with each state.
    exact: Program,
    envelope: Vec<Range>,
    /// The bound of the error of each state that is measured.
    errors: Vec<f64>,
}

/// Bounds on the envelope.
pub(super) struct Sizes {
    /// Of |u|.
    pub(super) u: f64,
    /// Of what moves the chain beside w.
    pub(super) force: f64,
}

impl<'a> Rates<'a> {
    /// # Errors
    /// Why there are no such bounds.
    pub(super) fn new(spec: &'a Spec, model: &Model) -> Result<Self, String> {
        let f = spec.drift.clone().unwrap_or(Expression::integer(0));
        let g = spec.input_gain.clone().unwrap_or(Expression::integer(1));
        let sum = f.add(g.clone().mul(Variable::Control.into()));
        if sum.any(&Expression::is_kink) {
            return Err(format!(
                "f + g u = {} has a kink, at which it has no rate",
                model.text(&sum)
            ));
        }
        let rate = |variable| match variable {
            Variable::State(j) => model.dynamics[j - 1].clone(),
            Variable::Time => Expression::integer(1),
            _ => Expression::integer(0),
        };
        let states = || (1..=spec.states()).map(Variable::State);
        let mut all = vec![sum.along(&rate), g];
        for e in [&sum].into_iter().chain(&model.coordinates) {
            all.extend(states().map(|state| e.derivative(state)));
        }
        let errors = (0..spec.states()).map(|j| {
            let each = |bounds: &[Fixed]| one_or_each(bounds, j).unwrap_or(0.0);
            each(&spec.promises.noise) + each(&spec.promises.sensor_step) / 2.0
        });
        let errors: Vec<_> = errors.collect();
        let optimised = |program| passes::optimise(program, &mut |_, _| {});
        let emitted = optimised(at_sample(spec));
        let bound = |j: usize| one_or_each(&spec.promises.x_max, j).unwrap_or(f64::INFINITY);
        let envelope = (0..spec.states()).map(|j| Range::from(bound(j)).both_signs()).collect();
        Ok(Self { spec, emitted, exact: optimised(plant(spec, &all)), envelope, errors })
    }

    /// Bounds of the error of each coordinate of the chain, as the law sees it.
    ///
    /// # Errors
    /// That a coordinate has none.
    pub(super) fn sensors(&self) -> Result<Vec<f64>, String> {
        let states = self.errors.len();
        let mut rounded = self.on(&self.emitted, &self.emitted.watched)?;
        let mut slopes = self.on(&self.exact, &self.exact.watched[2 + states..])?;
        let mut most = vec![0.0_f64; self.spec.n];
        for cell in cells(&self.envelope, CELLS) {
            let (rounded, slopes) = (rounded.at(&cell, 0.0), slopes.at(&cell, 0.0));
            for (i, most) in most.iter_mut().enumerate() {
                let own = size(&rounded[i], |value| value.error);
                *most = greater(*most, own + self.seen(&slopes[i * states..]));
            }
        }
        match most.iter().position(|bound| !bound.is_finite()) {
            Some(i) => Err(format!("x{} has no bound within x_max", i + 1)),
            None => Ok(most),
        }
    }

    /// Cells that hold every state of the envelope whose chain is within bounds.
    ///
    /// # Errors
    /// That there is none.
    fn within(&self, chain: &[f64]) -> Result<Vec<Vec<Range>>, String> {
        let exact = vec![0.0; self.errors.len()];
        let mut coordinates =
            OnCells::new(self.spec, &self.emitted, &self.emitted.watched, &exact)?;
        let mut around = self.envelope.clone();
        let mut left = Vec::new();
        for _ in 0..NARROWER {
            left = cells(&around, CELLS);
            left.retain(|cell| !coordinates.is_beyond(cell, chain));
            let hull = left
                .iter()
                .cloned()
                .reduce(|a, b| a.into_iter().zip(b).map(|(a, b)| a.hull(&b)).collect());
            around = hull.ok_or("no state within x_max has a chain within its bounds")?;
        }
        Ok(left)
    }

    /// The bounds where |w| is at most `wanted`, and the chain within its bounds.
    ///
    /// # Errors
    /// That there are none.
    pub(super) fn sizes(&self, wanted: f64, chain: &[f64]) -> Result<Sizes, String> {
        let cells = self.within(chain)?;
        let h = one_or_each(self.spec.promises.sample_time.as_slice(), 0).unwrap_or(f64::INFINITY);
        let promises = &self.spec.promises;
        let step = promises.u_step.as_slice();
        let step = one_or_each(step, 0).unwrap_or(0.0) / 2.0;
        let off = (0..promises.g_error.len())
            .filter_map(|i| one_or_each(&promises.g_error, i))
            .fold(0.0, |most: f64, part| most.max((part - 1.0).abs()));
        let (mut u, mut inexact) = (0.0_f64, 0.0_f64);
        let mut input = self.on(&self.emitted, &[self.emitted.step])?;
        for cell in &cells {
            let found = &input.at(cell, wanted)[0];
            u = greater(u, size(found, |value| value.emitted().size().high()));
            inexact = greater(inexact, size(found, |value| value.error));
        }
        if !u.is_finite() {
            return Err("u is not bounded within x_max: g may be 0 there, or f or g has no value"
                .to_owned());
        }
        let mut rates = self.on(&self.exact, &self.exact.watched[..2 + self.errors.len()])?;
        let mut force = 0.0_f64;
        for cell in &cells {
            // What acts on the plant has been through the actuator and the true input gain.
            let found = rates.at(cell, (1.0 + off) * (u + step));
            let exact = |i: usize| size(&found[i], |value| value.exact.size().high());
            let input = exact(1) * (inexact + step + off * (u + step));
            force = greater(force, h * exact(0) + input + self.seen(&found[2..]));
        }
        if !force.is_finite() {
            return Err("no bound of the rate of f + g u is found within x_max".to_owned());
        }
        // The sums above round too.
        Ok(Sizes { u: u * (1.0 + 1e-12), force: force * (1.0 + 1e-12) })
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

/// The greater of two bounds; infinite where one is no number, which `max` would leave out.
fn greater(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::INFINITY } else { a.max(b) }
}
