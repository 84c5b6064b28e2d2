//! The whole line on one screen: a design that the checks accept, and what is made of it: the items of the macro, or
//! `files`.

#[cfg(feature = "files")]
mod files;
#[cfg(feature = "files")]
pub use files::*;

use crate::check::examine::{Report, examine};
use crate::controller::Controller;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::emit;
use crate::internal::{fault, guarded};
use crate::law::Law;
use crate::program::{Op, Program, number, passes};
use crate::request::{Spec, What};
use crate::{lower, samples};

/// A design that the checks accept, and its optimised program: what all files are made of.
#[derive(Clone, Debug)]
pub struct Accepted {
    report: Report,
    /// The law and its program; `None` if the clock is in samples.
    staged: Option<(Law, Program)>,
}

impl Accepted {
    /// The design of a report of [`examine`].
    ///
    /// # Errors
    /// Every check that refuses it, or the coefficient that overflows.
    pub fn of(report: Report) -> Result<Self, Vec<Diagnostic>> {
        within(|| {
            report.accepted()?;
            if report.spec.sampled().is_some() {
                in_range(&report.spec)?;
                return Ok(Self { report, staged: None });
            }
            let law = Law::from(&report.spec, report.expanded.as_ref());
            let program = optimised(&report.spec, &law)?;
            Ok(Self { report, staged: Some((law, program)) })
        })
    }

    fn controller(&self) -> Controller<'_> {
        let Some((law, program)) = &self.staged else { fault("a clock in samples has no law") };
        Controller { report: &self.report, law, program, measured: &[] }
    }
}

/// The items that `ptc_controller!` expands to: those of the Rust file, on the types of the
/// facade crate `ptc` in place of its own.
///
/// # Errors
/// Everything in the spec that cannot be generated, and every check that refuses it.
pub fn macro_items(spec: &Spec) -> Result<String, Vec<Diagnostic>> {
    let accepted = accepted(spec)?;
    within(|| match &accepted.staged {
        Some(_) => Ok(emit::emit_items(&accepted.controller())),
        None => Ok(emit::emit_sampled_items(&accepted.report.spec)),
    })
}

/// The design of `spec`, if the checks accept it.
fn accepted(spec: &Spec) -> Result<Accepted, Vec<Diagnostic>> {
    within(|| Accepted::of(examine(spec)))
}

/// Returns the result of `work`; a fault of the generator in it is an error too.
fn within<T>(work: impl FnOnce() -> Result<T, Vec<Diagnostic>>) -> Result<T, Vec<Diagnostic>> {
    guarded(work).map_err(|fault| vec![fault.into()])?
}

/// Refuses a controller in samples whose fixed values make a weight that its precision does not hold.
fn in_range(spec: &Spec) -> Result<(), Vec<Diagnostic>> {
    let sampled = spec.sampled().map(|sampled| samples::controller(spec, sampled, Vec::new()));
    let mut found = Diagnostics::default();
    if let Some(lost) = sampled.and_then(|code| code.out_of_range()) {
        let precision = spec.precision.name();
        let of = match spec.what {
            What::Observer => "observer",
            What::Filter => "filter",
            What::Controller | What::Associated => "law",
        };
        let size = if lost.numer().bits() > lost.denom().bits() { "large" } else { "small" };
        found.push(
            "overflow",
            "sample_time",
            None,
            format!("a weight of the {of} is too {size} for {precision} with the values that are fixed"),
            "the weights hold the gains over powers of the sample period up to the order of the loop: take a longer period, a lower order, other units, or f64",
        );
    }
    found.finish(Some(()))
}

/// The staged program, with all passes run. What the spec fixes must leave every coefficient finite.
fn optimised(spec: &Spec, law: &Law) -> Result<Program, Vec<Diagnostic>> {
    let program = passes::optimise(lower::lower(spec, law), &mut |_, _| {});
    let overflow = program.values.iter().find(|definition| {
        matches!(&definition.op, Op::Number(value)
            if !number::round(value, spec.precision).is_finite())
    });
    let Some(overflow) = overflow else { return Ok(program) };
    let name = overflow.name.as_ref().map_or("a coefficient", |(_, meaning)| meaning.as_str());
    let precision = spec.precision.name();
    let mut found = Diagnostics::default();
    found.push(
        "overflow",
        "mu",
        None,
        format!("{name} overflows {precision} with the values that are fixed"),
        "the coefficients hold k_i/a^(n+1-i): give a rate nearer to 1, smaller gains or a lower order",
    );
    found.finish(None)
}
