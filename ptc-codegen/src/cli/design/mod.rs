//! `design`: the mapping and the poles with which the objectives of a design hold.

mod args;
mod blocked;
mod report;

use std::ops::ControlFlow;
use std::path::Path;

use crate::design::completed;
use crate::synthesis::{self, Outcome, Wish, file};
use crate::verify::{Trial, possible};

pub(crate) use args::{EXAMPLES, Request};

use super::output::{self, Interruption, Outputs, watch};
use super::progress::{checking, tries};
use super::report::Failure;
use super::source::{Source, chosen};
use super::write;

/// Runs `design`.
pub(crate) fn design(request: &Request) -> Result<(), Failure> {
    watch();
    let interruption = Interruption::new();
    let mut outputs = Outputs::default();
    outputs.reads("the design", &request.design);
    let out = outputs.file("--out", &request.out)?;
    let source = Source::default().with_design(Some(&request.design))?;
    let parsed = source.parse();
    let wish = match checking(|| Wish::read(&parsed.entries)) {
        Ok(wish) => parsed.finish(Some(wish), Vec::new())?,
        Err(found) => return parsed.finish(None, found),
    };
    // What fails at t0 fails with every choice.
    let of_law = wish.campaign().of_law();
    possible(&of_law, &mut Trial::new(&of_law)?)?;
    let bar = tries("designing", u64::from(request.tries));
    let most = usize::try_from(request.tries).unwrap_or(usize::MAX);
    let outcome = synthesis::design(&wish, most, &|standing| {
        bar.set_position(standing.tries as u64);
        bar.set_message(report::standing(standing));
        if interruption.is_asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    drop(interruption);
    bar.finish_and_clear();
    let Outcome { best: Some(best), assessment: Some(found), .. } = &outcome else {
        return Err(blocked::blocked(&wish, &outcome));
    };
    let told = report::met(best, found, &outcome);
    let text = file::complete(
        source.text().unwrap_or_default(),
        &best.choice,
        &head(&request.design, &told),
    )
    .map_err(|error| Failure::because(format!("invalid TOML: {error}"), "mend the design file"))?;
    let text = completed(&text, &chosen(&best.campaign.design.choices));
    let printed = out.is_standard_output();
    let written = output::write(&[(out, text.as_bytes())])?;
    if printed { Ok(()) } else { write::to_stdout(&format!("{told}{written}")) }
}

/// The comment above a design that was completed.
fn head(path: &Path, told: &str) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    format!(
        "Made of {name} by `ptc-codegen design`: `ptc-codegen verify` reports the same.\n{told}"
    )
}
