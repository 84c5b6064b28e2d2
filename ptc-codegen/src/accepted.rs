//! The whole line on one screen: a design that the checks accept, and the files that are made of it.

use crate::check::examine::{Report, examine};
use crate::controller::Controller;
use crate::controller::measured::Measured;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::emit::{self, File, Language, Project};
use crate::expansion::Expanded;
use crate::internal::{fault, guarded};
use crate::law::Law;
use crate::program::cost::{self, Cost};
use crate::program::{self, Op, Program, Stage, number, passes};
use crate::request::{Spec, What};
use crate::{lower, samples, selftest};

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

    /// Its files, with what a step was measured to cost in their heads.
    ///
    /// # Errors
    /// Everything in the spec that this language cannot express.
    pub fn files(
        &self,
        language: Language,
        measured: &[Measured],
    ) -> Result<Vec<File>, Vec<Diagnostic>> {
        let Some(version) = language.fmi() else { return self.sources(language, measured) };
        within(|| match &self.staged {
            Some(_) => emit::emit_fmu(&Controller { measured, ..self.controller() }, version),
            None => emit::emit_sampled_fmu(&self.report, version),
        })
    }

    /// The same in a language of source files, which an FMU is not.
    ///
    /// # Errors
    /// As [`Accepted::files`].
    pub fn sources(
        &self,
        language: Language,
        measured: &[Measured],
    ) -> Result<Vec<File>, Vec<Diagnostic>> {
        within(|| match &self.staged {
            Some(_) => emit::emit(&Controller { measured, ..self.controller() }, language),
            None => emit::emit_sampled(&self.report, language),
        })
    }

    /// The mapping, its closed forms and the law, as they are in the heads of its files.
    pub fn formulas(&self) -> Vec<String> {
        match &self.staged {
            Some(_) => emit::formulas(&self.controller()),
            None => emit::sampled_formulas(&self.report),
        }
    }

    /// What one step costs, without input checks and clipping; `None` if the clock is in samples,
    /// whose program has no stages.
    pub fn cost(&self) -> Option<Cost> {
        let (_, program) = self.staged.as_ref()?;
        Some(cost::count(program, &program.controls(), Stage::Tick))
    }

    /// The source of its self-test in C, and its header.
    ///
    /// # Errors
    /// What has no self-test.
    pub fn selftest(&self) -> Result<Vec<File>, Vec<Diagnostic>> {
        within(|| match &self.staged {
            Some(_) => {
                let test = selftest::SelfTest::new(&self.controller())?;
                Ok(emit::emit_selftest(&self.controller(), &test))
            }
            None => {
                let code = emit::sampled_c(&self.report);
                let test = selftest::samples::SelfTest::new(&self.report.spec, &code)?;
                Ok(emit::emit_sampled_selftest(&self.report.spec, &code, &test))
            }
        })
    }

    /// Its C files for a proof that they have no error at run time: header and source, which differ
    /// from those of [`Accepted::files`] by comments alone, and the proof's harness.
    ///
    /// # Errors
    /// A fault of the generator.
    pub fn files_with_proof(&self) -> Result<Vec<File>, Vec<Diagnostic>> {
        self.report.spec.needs_one_axis("a proof")?;
        self.report.spec.needs_no_fma("a proof with Frama-C")?;
        within(|| match &self.staged {
            Some(_) => Ok(emit::emit_with_proof(&self.controller())),
            None => {
                let code = emit::sampled_c(&self.report);
                Ok(emit::emit_sampled_with_proof(&self.report.spec, &code))
            }
        })
    }

    /// The files of a small project around it, by their paths in it.
    ///
    /// # Errors
    /// Everything in the spec that a self-contained file cannot have.
    pub fn project(&self, project: Project) -> Result<Vec<File>, Vec<Diagnostic>> {
        project.accepts(&self.report.spec)?;
        let emitted = self.files(project.language(), &[])?;
        within(|| Ok(project.files(&self.report, emitted)))
    }

    fn controller(&self) -> Controller<'_> {
        let Some((law, program)) = &self.staged else { fault("a clock in samples has no law") };
        Controller { report: &self.report, law, program, measured: &[] }
    }
}

/// Generates the source files of one controller.
///
/// # Errors
/// Everything in the spec that cannot be generated, in this language or at all, and every check that
/// refuses it.
pub fn generate(spec: &Spec, language: Language) -> Result<Vec<File>, Vec<Diagnostic>> {
    accepted(spec)?.files(language, &[])
}

/// Generates the files of a small project around one controller, by their paths in it.
///
/// # Errors
/// Everything in the spec that cannot be generated or stand alone, and every check that refuses it.
pub fn project(spec: &Spec, project: Project) -> Result<Vec<File>, Vec<Diagnostic>> {
    project.accepts(spec)?;
    accepted(spec)?.project(project)
}

/// The self-test of one controller in C: the source that a target compiles beside the controller,
/// and its header.
///
/// # Errors
/// Everything in the spec that cannot be generated, every check that refuses it, and what has no
/// self-test.
pub fn generate_selftest(spec: &Spec) -> Result<Vec<File>, Vec<Diagnostic>> {
    accepted(spec)?.selftest()
}

/// Generates the C files of one controller for a proof, as [`Accepted::files_with_proof`].
///
/// # Errors
/// Everything in the spec that cannot be generated, and every check that refuses it.
pub fn generate_with_proof(spec: &Spec) -> Result<Vec<File>, Vec<Diagnostic>> {
    accepted(spec)?.files_with_proof()
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
        None => Ok(emit::emit_sampled_items(&accepted.report)),
    })
}

/// The design of `spec`, if the checks accept it.
fn accepted(spec: &Spec) -> Result<Accepted, Vec<Diagnostic>> {
    within(|| Accepted::of(examine(spec)))
}

/// What `work` gives; a fault of the generator in it is an error too.
fn within<T>(work: impl FnOnce() -> Result<T, Vec<Diagnostic>>) -> Result<T, Vec<Diagnostic>> {
    guarded(work).map_err(|fault| vec![fault.into()])?
}

/// The program after the pass called `name`, or as it was lowered where `name` is `lower`, as
/// text; `None` where there is no such pass.
pub fn dump(spec: &Spec, expanded: Option<&Expanded>, name: &str) -> Option<String> {
    // A controller in samples has no staged program.
    if spec.sampled().is_some() {
        return None;
    }
    let law = Law::from(spec, expanded);
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

/// Refuses a controller in samples whose fixed values make a weight that its precision does not hold.
fn in_range(spec: &Spec) -> Result<(), Vec<Diagnostic>> {
    let sampled = spec.sampled().map(|sampled| samples::controller(spec, sampled, Vec::new()));
    let mut found = Diagnostics::default();
    if let Some(lost) = sampled.and_then(|code| code.out_of_range()) {
        let precision = spec.precision.name();
        let of = if spec.what == What::Observer { "observer" } else { "law" };
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
