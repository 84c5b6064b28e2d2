//! wip
pub mod algebra;
pub mod diagnostic;
pub mod emit;
pub mod expansion;
pub mod law;
pub mod lower;
pub mod mapping;
pub mod program;
pub mod spec;

use diagnostic::Diagnostic;
use emit::{Controller, File, Language};
use law::LinearLaw;
use program::{Program, passes};
use spec::Spec;

/// Generates the source files of one controller.
///
/// # Errors
/// Everything in the spec that cannot be generated.
pub fn generate(spec: &Spec, language: Language) -> Result<Vec<File>, Vec<Diagnostic>> {
    let law = LinearLaw::new(spec.n, &spec.mapping());
    let program = optimised(spec, &law);
    Ok(emit::emit(&Controller { spec, law: &law, program: &program }, language))
}

/// The items that `ptc_controller!` expands to: those of the Rust file, on the types of the
/// facade crate `ptc` in place of its own.
///
/// # Errors
/// Everything in the spec that cannot be generated.
pub fn macro_items(spec: &Spec) -> Result<String, Vec<Diagnostic>> {
    let law = LinearLaw::new(spec.n, &spec.mapping());
    let program = optimised(spec, &law);
    Ok(emit::emit_items(&Controller { spec, law: &law, program: &program }))
}

/// The program after the pass called `name`, or as it was lowered where `name` is `lower`, as
/// text; `None` where there is no such pass.
pub fn dump(spec: &Spec, name: &str) -> Option<String> {
    let law = LinearLaw::new(spec.n, &spec.mapping());
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

fn optimised(spec: &Spec, law: &LinearLaw) -> Program {
    passes::optimise(lower::lower(spec, law), &mut |_, _| {})
}
