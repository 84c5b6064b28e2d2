//! Mistakes and faults as Python's exceptions.

use std::ops::Range;

use ptc_codegen::design::Quote;
use ptc_codegen::diagnostic::Diagnostic;
use ptc_codegen::internal::Internal;
use ptc_codegen::simulate::{Cause, Failure};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// An exception of the module `ptc_codegen._errors`.
fn exception<'py>(
    py: Python<'py>,
    name: &str,
    arguments: impl pyo3::call::PyCallArgs<'py>,
) -> PyErr {
    let made =
        py.import("ptc_codegen._errors").and_then(|errors| errors.getattr(name)?.call1(arguments));
    made.map_or_else(|error| error, PyErr::from_value)
}

/// A mistake as the arguments of `ptc_codegen.Mistake`: line, code, key, message and help.
type Told = (Option<usize>, &'static str, String, String, String);

/// The mistakes in a design, each with its line in `text`.
pub(crate) fn mistakes(
    py: Python<'_>,
    found: Vec<Diagnostic>,
    text: &str,
    places: &[Range<usize>],
) -> PyErr {
    let line =
        |found: &Diagnostic| Some(Quote::new(text, places.get(found.place?.0)?.clone()).line);
    let told = |found: Diagnostic| -> Told {
        (line(&found), found.code, found.key, found.message, found.help)
    };
    let all: Vec<_> = found.into_iter().map(told).collect();
    exception(py, "DesignError", (all,))
}

/// One mistake that is in no line.
pub(crate) fn mistake(py: Python<'_>, code: &'static str, message: String, help: String) -> PyErr {
    let told: Told = (None, code, String::new(), message, help);
    exception(py, "DesignError", (vec![told],))
}

/// A run that ended early.
pub(crate) fn ended(py: Python<'_>, failure: Failure) -> PyErr {
    let Failure { cause, at, message, help } = failure;
    match cause {
        Cause::Input => mistake(py, "bad-value", message, help),
        Cause::Range => exception(py, "RunError", (message, help, at, false)),
        Cause::Unfinished => exception(py, "RunError", (message, help, at, true)),
    }
}

/// A fault of the generator.
pub(crate) fn internal(fault: &Internal) -> PyErr {
    PyRuntimeError::new_err(format!("{fault}; {}", Internal::HELP))
}
