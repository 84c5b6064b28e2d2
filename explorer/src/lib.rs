//! Answers the requests of the page to the generator: JSON in, JSON out.
//!
//! A request is `{"design": TOML, "language": NAME, "x0": NUMBERS, "seed": NUMBER, "overlays": MAPPINGS}`, with
//! `"trial": {"gain": NUMBER, "force": NUMBER, "friction": NUMBER, "symbols": {NAME: NUMBER}}` for another plant.
//! The answer holds what the commands `emit`, `check` and `simulate` say of the same design; offsets in
//! the design count UTF-16 units, as a browser does.

mod blocks;
mod check;
mod code;
mod design;
mod figures;
mod run;

use ptc_codegen::Accepted;
use ptc_codegen::check::examine::examine;
use ptc_codegen::emit::Language;
use serde_json::{Value, json};

use design::Design;

/// The answer to a request.
pub fn answer(request: &str) -> String {
    let answer = match serde_json::from_str::<Value>(request) {
        Ok(request) => respond(&request),
        Err(wrong) => json!({ "fault": format!("not a request: {wrong}") }),
    };
    answer.to_string()
}

fn respond(request: &Value) -> Value {
    let text = |key: &str| request[key].as_str().unwrap_or_default();
    // The page shows sources: without FMUs it is smaller.
    let language = Language::named(text("language")).filter(|language| language.fmi().is_none());
    let design = Design::read(text("design"));
    let mut answer = json!({ "keys": design.keys() });
    let (spec, plant) = match design.meaning() {
        Ok(both) => both,
        Err(found) => {
            answer["diagnostics"] = design.told(found);
            return answer;
        }
    };
    answer["design"] = check::of_design(&spec);
    let report = examine(&spec);
    answer["checks"] = check::checks(&report);
    answer["verdict"] = check::verdict(&report);
    answer["fingerprint"] = json!(report.spec.fingerprint());
    answer["chosen"] = report.choices.iter().map(ToString::to_string).collect();
    answer["plane"] = check::plane(&report.spec);
    answer["figures"] = figures::figures(&report);
    answer["law"] = figures::law(&report);
    answer["runs"] = run::runs(&design, (&report, plant), request);
    let found = match Accepted::of(report) {
        Err(found) => found,
        Ok(accepted) => {
            answer["cost"] = check::cost(&accepted);
            answer["formulas"] = json!(accepted.formulas());
            match language.map(|language| accepted.sources(language, &[])).transpose() {
                Ok(files) => {
                    answer["files"] = code::files(&files.unwrap_or_default());
                    Vec::new()
                }
                Err(found) => found,
            }
        }
    };
    answer["diagnostics"] = design.told(found);
    answer
}

#[cfg(test)]
mod tests;
