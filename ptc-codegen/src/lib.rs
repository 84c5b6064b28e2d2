//! From an order n and a mapping of time to the source of a prescribed-time controller.
//!
//! The plant is x1' = x2, ..., xn' = f + g u. The law is Theorem 1 of A. Shakouri and N. Assadian,
//! "A Framework for Prescribed-Time Control Design via Time-Scale Transformation":
//! u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x), where pi0 is linear unless the user gives another.
//!
//! [`generate`] is the whole line: a [`spec::Spec`] is checked ([`check`]) and expanded to closed
//! forms ([`mapping`], [`expansion`]), these to the law ([`law`]), the law to a staged program ([`lower`],
//! [`program`]), which passes optimise and [`emit`] prints. All mistakes of the user are found by
//! [`spec::read`]; the same spec gives the same bytes on any machine.

pub mod algebra;
pub mod check;
pub mod code;
pub mod design;
pub mod diagnostic;
pub mod emit;
pub mod expansion;
pub mod expression;
pub mod internal;
pub mod law;
pub mod limits;
pub mod lower;
pub mod mapping;
pub mod plant;
#[cfg(feature = "simulation")]
pub mod plot;
pub mod program;
pub mod reference;
pub mod samples;
pub mod selftest;
#[cfg(feature = "simulation")]
pub mod simulate;
pub mod spec;
#[cfg(feature = "campaign")]
pub mod synthesis;
#[cfg(feature = "campaign")]
pub mod verify;

use check::examine::{Report, examine};
use diagnostic::{Diagnostic, Diagnostics};
use emit::measured::Measured;
use emit::{Controller, File, Language, Project};
use internal::guarded;
use law::Law;
use program::{Op, Program, number, passes};
use spec::Spec;

/// Generates the source files of one controller.
///
/// # Errors
/// Everything in the spec that cannot be generated, in this language or at all, and every check that
/// refuses it.
pub fn generate(spec: &Spec, language: Language) -> Result<Vec<File>, Vec<Diagnostic>> {
    generate_measured(spec, language, &[])
}

/// The same, with what a step was measured to cost in the head of the files.
///
/// # Errors
/// As [`generate`].
pub fn generate_measured(
    spec: &Spec,
    language: Language,
    measured: &[Measured],
) -> Result<Vec<File>, Vec<Diagnostic>> {
    if spec.sampled().is_some() {
        return sampled(spec, |report| emit::emit_sampled(report, language))?;
    }
    emitted(spec, |controller| emit::emit(&Controller { measured, ..*controller }, language))?
}

/// Generates the files of a small project around one controller, by their paths in it.
///
/// # Errors
/// Everything in the spec that cannot be generated or stand alone, and every check that refuses it.
pub fn project(spec: &Spec, project: Project) -> Result<Vec<File>, Vec<Diagnostic>> {
    needs_time(spec, "a project")?;
    project.accepts(spec)?;
    emitted(spec, |controller| project.files(controller))
}

/// The self-test of one controller in C: the source that a target compiles beside the controller,
/// and its header.
///
/// # Errors
/// Everything in the spec that cannot be generated, every check that refuses it, and what has no
/// self-test.
pub fn generate_selftest(spec: &Spec) -> Result<Vec<File>, Vec<Diagnostic>> {
    needs_time(spec, "the self-test")?;
    emitted(spec, |controller| {
        let test = selftest::SelfTest::new(controller)?;
        Ok(emit::emit_selftest(controller, &test))
    })?
}

/// Generates the C files of one controller for a proof that they have no error at run time: header
/// and source, which differ from those of [`generate`] by comments alone, and the proof's harness.
///
/// # Errors
/// Everything in the spec that cannot be generated, and every check that refuses it.
pub fn generate_with_proof(spec: &Spec) -> Result<Vec<File>, Vec<Diagnostic>> {
    needs_time(spec, "the proof of run-time errors")?;
    emitted(spec, emit::emit_with_proof)
}

/// The items that `ptc_controller!` expands to: those of the Rust file, on the types of the
/// facade crate `ptc` in place of its own.
///
/// # Errors
/// Everything in the spec that cannot be generated, and every check that refuses it.
pub fn macro_items(spec: &Spec) -> Result<String, Vec<Diagnostic>> {
    if spec.sampled().is_some() {
        return sampled(spec, emit::emit_sampled_items);
    }
    emitted(spec, emit::emit_items)
}

/// What `emit` makes of the controller in samples that `spec` asks for.
fn sampled<T>(spec: &Spec, emit: impl FnOnce(&Report) -> T) -> Result<T, Vec<Diagnostic>> {
    let work = || Ok(emit(&examine(spec).accepted()?));
    guarded(work).map_err(|fault| vec![fault.into()])?
}

/// Refuses a clock in samples for what knows time alone.
pub(crate) fn needs_time(spec: &Spec, what: &str) -> Result<(), Vec<Diagnostic>> {
    let mut found = Diagnostics::default();
    if spec.sampled().is_some() {
        let message = format!("{what} does not know a clock in samples yet");
        found.push(
            "clock",
            "clock",
            None,
            message,
            "leave `clock` out, or emit and simulate it alone",
        );
    }
    found.finish(Some(()))
}

/// What `emit` makes of the controller that `spec` asks for.
fn emitted<T>(spec: &Spec, emit: impl FnOnce(&Controller<'_>) -> T) -> Result<T, Vec<Diagnostic>> {
    let work = || {
        let report = examine(spec).accepted()?;
        let law = Law::of(&report.spec);
        let program = optimised(&report.spec, &law)?;
        Ok(emit(&Controller { report: &report, law: &law, program: &program, measured: &[] }))
    };
    guarded(work).map_err(|fault| vec![fault.into()])?
}

/// The program after the pass called `name`, or as it was lowered where `name` is `lower`, as
/// text; `None` where there is no such pass.
pub fn dump(spec: &Spec, name: &str) -> Option<String> {
    // A controller in samples has no staged program.
    if spec.sampled().is_some() {
        return None;
    }
    let law = Law::of(spec);
    let lowered = lower::lower(spec, &law);
    if name == "lower" {
        return Some(program::dump::dump(&lowered));
    }
    let mut text = None;
    passes::optimise(lowered, &mut |pass, program| {
        if pass.name == name {
            text = Some(program::dump::dump(program));
        }
    });
    text
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
