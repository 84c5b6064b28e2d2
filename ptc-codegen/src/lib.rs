//! wip
pub mod algebra;
pub mod diagnostic;
pub mod emit;
pub mod expansion;
pub mod law;
pub mod mapping;
pub mod spec;

use diagnostic::Diagnostic;
use emit::{File, Language};
use spec::Spec;

/// Generates the source files of one controller.
///
/// # Errors
/// Everything in the spec that cannot be generated.
pub fn generate(spec: &Spec, language: Language) -> Result<Vec<File>, Vec<Diagnostic>> {
    let _ = (spec, language);
    Ok(vec![])
}

/// The items that `ptc_controller!` expands to: those of the Rust file, on the types of the
/// facade crate `ptc` in place of its own.
///
/// # Errors
/// Everything in the spec that cannot be generated.
pub fn macro_items(spec: &Spec) -> Result<String, Vec<Diagnostic>> {
    let _ = spec;
    Ok(String::new())
}
