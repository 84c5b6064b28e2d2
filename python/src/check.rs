//! What every check says of a design.

use ptc_codegen::Accepted;
use ptc_codegen::check::Outcome;
use ptc_codegen::check::examine::examine;
use ptc_codegen::internal::guarded;
use pyo3::prelude::*;

use crate::design::Design;
use crate::failure::internal;

/// A check as the arguments of `ptc_codegen.Check`.
type Told = (&'static str, &'static str, String, Vec<String>, Option<String>);

/// Its checks, the names of those that refuse the design and of those that are undecided, the last line of the report
/// and the margins.
type Checked = (Vec<Told>, Vec<&'static str>, Vec<&'static str>, String, String);

fn told(outcome: &Outcome) -> Told {
    let Outcome { name, verdict, summary, details, fix } = outcome;
    (name, verdict.text(), summary.clone(), details.clone(), fix.clone())
}

/// Runs the checks of a design.
#[pyfunction]
pub(crate) fn check(py: Python<'_>, design: &Design) -> PyResult<Checked> {
    let report = py.detach(|| {
        guarded(|| {
            let report = examine(&design.spec);
            let names = |outcomes: &mut dyn Iterator<Item = &Outcome>| -> Vec<_> {
                outcomes.map(|outcome| outcome.name).collect()
            };
            let refused = names(&mut report.refusals());
            let open = names(&mut report.undecided());
            let checks = report.outcomes.iter().map(told).collect();
            let (verdict, margins) = (report.verdict(), report.margins());
            // No check looks at coefficients that overflow.
            if refused.is_empty() {
                Accepted::of(report)?;
            }
            Ok((checks, refused, open, verdict, margins))
        })
    });
    report.map_err(|fault| internal(&fault))?.map_err(|found| design.wrong(py, found))
}
