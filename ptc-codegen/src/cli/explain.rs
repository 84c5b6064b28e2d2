//! `explain`: what a message means, an example that causes it, and its fix.

use crate::diagnostic::explain::{self, Explanation, KINDS};
use crate::diagnostic::near_miss;
use clap::Args;

use super::report::Failure;

pub(crate) const EXAMPLES: &str = "\
The code of a message is in brackets behind `error`; checks and statuses have their names.

Examples:
  ptc-codegen explain                lists all
  ptc-codegen explain missing-key
  ptc-codegen explain growth
  ptc-codegen explain PTC_HOLD";

/// The flags of `explain`.
#[derive(Debug, Args)]
pub(crate) struct Explain {
    /// Code of a message, check or status; without it, all are listed
    #[arg(value_name = "CODE")]
    pub(crate) code: Option<String>,
}

/// Runs `explain`.
///
/// # Errors
/// No message has this code.
pub(crate) fn explain(request: &Explain) -> Result<String, Failure> {
    let Some(code) = &request.code else { return Ok(list()) };
    explain::find(code).map(text).ok_or_else(|| {
        let codes = explain::all().map(|own| own.code);
        let meant = near_miss(code, codes).map(|near| format!("did you mean `{near}`? "));
        let help = format!("{}`ptc-codegen explain` lists all", meant.unwrap_or_default());
        Failure::because(format!("no message, check or status is called `{code}`"), &help)
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
    text.push_str("`ptc-codegen explain CODE` shows an example and the fix.\n");
    text
}
