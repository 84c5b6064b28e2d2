//! From the law to a staged program.
//!
//! Here the closed forms become operations: coefficients in `init` (`coefficient`), quantities of
//! time in `tick` (`quantity`), and the state enters last. Everything that may change rounding
//! happens here or earlier; the passes after it keep every bit.

mod angle_sum;
mod associated;
mod axes;
mod builder;
mod closed_loop;
mod coefficient;
mod coefficients;
mod cotangent;
mod coupled;
mod exp_sum;
mod input_gain;
mod jet;
mod mapping;
mod plant;
mod quantity;
mod row;
mod rows;
mod sampled;
mod scalar;
mod series;
mod soft;
mod state;
mod tangent;
mod taylor;
mod time;

use axes::{Shared, shares_time};
use builder::Builder;
use row::lower_row;
use rows::{Factor, Rows, factor};

use crate::law::{Form, Law};
use crate::parameter::Parameter;
use crate::program::{Input, Limits, Op, Program, Value};
use crate::request::{After, Guard, Spec, What};

pub(crate) use associated::Plant;
pub use closed_loop::{ClosedLoop, associated_loop, closed_loop, mapped_back, observed, plant};
pub use sampled::{at_sample, reference_at_sample};

/// The program of `law` for `spec`.
pub fn lower(spec: &Spec, law: &Law) -> Program {
    let associated = match spec.what {
        What::Associated => associated::lower(spec, law),
        _ => None,
    };
    let one = |form| controller(spec, law, form);
    // Gains that are handed over are those of x, whatever g is.
    let linear = matches!(law.form, Form::Rows { .. }) && !shares_time(spec);
    let program = associated.unwrap_or_else(|| plant::cheapest(spec, linear, &one));
    Program { fma: spec.fma, latency: spec.latency, ..program }
}

fn controller(spec: &Spec, law: &Law, form: plant::Form) -> Option<Program> {
    let designs = spec.designs();
    let mut b = Builder::of(spec, law);
    form.enter(&mut b)?;
    let (step, others, determinant, shared) = match spec.decoupled() {
        Some(coupled) => {
            let (first, others, determinant) = coupled::controls(&mut b, law, coupled, &designs);
            (first, others, determinant, Shared::default())
        }
        None => {
            let (step, shared) = of_chain(&mut b, law, &designs);
            (step, Vec::new(), None, shared)
        }
    };
    let start_time = (spec.guard == Guard::Full).then(|| b.push(Op::Input(Input::StartTime)));
    let (u_max, u_min) = closed_loop::limits_of_u(&mut b);
    let past = (spec.after != After::Hold).then(|| b.past());
    let (late, hold_from, eps) = (b.late(), b.hold_from(), b.parameter(Parameter::Eps));
    let elapsed = b.elapsed;
    let limits = Limits { start_time, u_max, u_min, past, late, hold_from, eps, elapsed };
    let program = b.finish(step, limits);
    let Shared { gains, divisors, bounds, lower, axis, parts } = shared;
    Some(Program { others, gains, divisors, bounds, lower, axis, parts, determinant, ..program })
}

/// u of a chain, and what several axes share; these have no step of one.
fn of_chain<'a>(b: &mut Builder<'a>, law: &Law, designs: &'a [Spec]) -> (Value, Shared) {
    let spec = b.spec;
    let rows = rows(b, law);
    let step = match &rows {
        Some(rows) => rows.step(b, None),
        None => state::step(b),
    };
    let step = plant::control(b, step);
    let shared = match rows {
        Some(rows) if shares_time(spec) => axes::shared(b, law, designs, &rows),
        _ => Shared::default(),
    };
    let axis = shared.axis.filter(|_| spec.axes.is_some());
    (axis.unwrap_or(step), shared)
}

/// The rows of the gains; empty for a law that is not a sum of gains.
fn rows(b: &mut Builder<'_>, law: &Law) -> Option<Rows> {
    match &law.form {
        Form::Rows { base_inverse, rows, values } => {
            b.values = values.iter().cloned().collect();
            let scaled = coefficient::scaled_gains(b, &law.rate);
            let rows: Vec<_> =
                rows.iter().enumerate().map(|(j, row)| lower_row(b, j, row, &scaled)).collect();
            let base = base_inverse.map(|symbol| factor(b, symbol));
            let negated = matches!(base, Some(Factor::DivideNegated(_)));
            let mut signed = |row| if negated { b.push(Op::Neg(row)) } else { row };
            Some(Rows { base, rows: rows.into_iter().map(|row| row.map(&mut signed)).collect() })
        }
        Form::Series => {
            let taylor = b.taylor();
            let base = Some(Factor::Multiply(taylor.base_inverse));
            Some(Rows { base, rows: series::rows(b, &taylor) })
        }
        Form::State => None,
    }
}
