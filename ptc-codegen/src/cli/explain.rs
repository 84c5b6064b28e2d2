//! `explain`: what a message means, an example that causes it, and its fix.

use crate::diagnostic::explain::{self, CONCEPTS, Concept, Explanation, KINDS, concept};
use crate::diagnostic::near_miss;
use clap::Args;

use super::report::Failure;

pub(crate) const EXAMPLES: &str = "\
The code of a message is in brackets behind `error`; checks and statuses have their names.

Examples:
  ptc-codegen explain                lists all
  ptc-codegen explain missing-key
  ptc-codegen explain growth
  ptc-codegen explain poles
  ptc-codegen explain 'stretched time'
  ptc-codegen explain PTC_HOLD";

/// The flags of `explain`.
#[derive(Debug, Args)]
pub(crate) struct Explain {
    /// Code of a message, check or status, or a concept such as poles; without it, all are listed
    #[arg(value_name = "CODE")]
    pub(crate) code: Option<String>,
}

/// Runs `explain`.
///
/// # Errors
/// No message has this code.
pub(crate) fn explain(request: &Explain) -> Result<String, Failure> {
    let Some(code) = &request.code else { return Ok(list()) };
    let found = explain::find(code).map(text).or_else(|| concept(code).map(of_concept));
    found.ok_or_else(|| {
        let names = CONCEPTS.iter().map(|own| own.name);
        let codes = explain::all().map(|own| own.code).chain(names);
        let meant = near_miss(code, codes).map(|near| format!("did you mean `{near}`? "));
        let help = format!("{}`ptc-codegen explain` lists all", meant.unwrap_or_default());
        let message = format!("no message, check, status or concept is called `{code}`");
        Failure::because(message, &help)
    })
}

fn text(own: &Explanation) -> String {
    let Explanation { code, means, design, example, fix } = own;
    let mut text = format!("{code}\n\n{means}\n\n");
    if !design.is_empty() {
        text.push_str("design.toml:\n");
        text.extend(design.lines().map(|line| format!("  {line}\n").replace("  \n", "\n")));
        text.push('\n');
    }
    text.push_str(&format!("Example: {example}\n\nFix: {fix}\n"));
    text
}

fn of_concept(own: &Concept) -> String {
    let lines: Vec<_> = own.lines.iter().map(|line| format!("{line}\n")).collect();
    format!("{}\n\n{}\nMore: docs/{}\n", own.name, lines.concat(), own.page)
}

fn list() -> String {
    let mut text = String::new();
    for kind in &KINDS {
        text.push_str(&format!("{}\n", kind.title));
        for own in kind.all {
            let first = own.means.split_inclusive(". ").next().unwrap_or_default().trim_end();
            text.push_str(&format!("  {:<18}{first}\n", own.code));
        }
        text.push('\n');
    }
    text.push_str("Concepts\n");
    for own in &CONCEPTS {
        text.push_str(&format!("  {:<18}{}\n", own.name, own.lines[0]));
    }
    text.push('\n');
    text.push_str("`ptc-codegen explain CODE` shows an example and the fix.\n");
    text
}
