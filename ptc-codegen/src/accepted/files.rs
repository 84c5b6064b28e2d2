//! The files of an accepted design, in every language and around it.

use super::{Accepted, accepted, within};
use crate::controller::Controller;
use crate::controller::measured::Measured;
use crate::diagnostic::Diagnostic;
#[cfg(feature = "lab")]
use crate::emit::campaign::{self, Sizes};
use crate::emit::{self, File, Language, Project};
use crate::expansion::Expanded;
use crate::law::Law;
use crate::program::cost::{self, Cost};
use crate::program::{self, Stage, passes};
use crate::request::Spec;
use crate::{lower, selftest};

impl Accepted {
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

    /// Returns the cost of one step, without input checks and clipping; `None` if the clock is in samples, whose
    /// program has no stages.
    pub fn cost(&self) -> Option<Cost> {
        let (_, program) = self.staged.as_ref()?;
        Some(cost::count(program, &program.controls(), Stage::Tick))
    }

    /// The source of its self-test in C, and its header.
    ///
    /// # Errors
    /// What has no self-test.
    pub fn selftest(&self) -> Result<Vec<File>, Vec<Diagnostic>> {
        self.report.spec.needs_no_filter("a self-test")?;
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
        self.report.spec.needs_no_filter("a proof")?;
        self.report.spec.needs_no_fma("a proof with Frama-C")?;
        within(|| match &self.staged {
            Some(_) => emit::emit_with_proof(&self.controller()),
            None => {
                let code = emit::sampled_c(&self.report);
                emit::emit_sampled_with_proof(&self.report.spec, &code)
            }
        })
    }

    /// The program in C that runs scenarios in a loop of such sizes; `None` for a controller that such a program does not
    /// call.
    ///
    /// # Errors
    /// As [`Accepted::files`].
    #[cfg(feature = "lab")]
    pub fn campaign(&self, sizes: &Sizes) -> Result<Option<campaign::Program>, Vec<Diagnostic>> {
        within(|| match &self.staged {
            Some(_) => campaign::in_time(&self.controller(), sizes),
            None => campaign::in_samples(&self.report, sizes),
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
