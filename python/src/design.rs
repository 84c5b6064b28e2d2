//! A design: its text, what is given beside it, and what both mean.

use std::ops::Range;
use std::path::PathBuf;

use num_traits::ToPrimitive;
use ptc_codegen::Accepted;
use ptc_codegen::check::examine::examine;
use ptc_codegen::check::resolved::{Choice, Resolved};
use ptc_codegen::design::{self, UNREADABLE, canonical, load, overrides};
use ptc_codegen::diagnostic::{Diagnostic, LARGE, Place};
use ptc_codegen::emit::Language;
use ptc_codegen::internal::guarded;
use ptc_codegen::limits::{DESIGN, ENTRIES};
use ptc_codegen::plant::{Plant, as_one, read_design};
use ptc_codegen::request::{Entry, Spec};
use ptc_codegen::syntax::{Value, parse};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::failure::{internal, mistake, mistakes};

/// A design that can be read.
#[pyclass(frozen, module = "ptc_codegen._ptc")]
pub(crate) struct Design {
    text: String,
    /// Where in the text each place is; what is given beside it is in no line.
    places: Vec<Range<usize>>,
    entries: Vec<Entry>,
    pub(crate) spec: Spec,
    pub(crate) plant: Option<Plant>,
    /// The keys that are given beside the text, with the texts of their values.
    given: Vec<(String, String)>,
}

#[pymethods]
impl Design {
    /// Reads the text of a design file, with values that override its own.
    #[new]
    fn new(py: Python<'_>, text: &str, given: Vec<(String, String)>) -> PyResult<Self> {
        py.detach(|| guarded(|| read(text, &given)))
            .map_err(|fault| internal(&fault))?
            .map_err(|(found, places)| mistakes(py, found, text, &places))
    }

    /// The same of the design file at a path.
    #[staticmethod]
    fn load(py: Python<'_>, path: PathBuf, given: Vec<(String, String)>) -> PyResult<Self> {
        let text = load(&path).map_err(|found| mistakes(py, vec![found], "", &[]))?;
        Self::new(py, &text, given)
    }

    /// The text that it was read from.
    #[getter]
    fn text(&self) -> &str {
        &self.text
    }

    /// What was given beside the text.
    #[getter]
    fn given(&self) -> Vec<(String, String)> {
        self.given.clone()
    }

    /// The design with other values of some keys.
    fn replace(&self, py: Python<'_>, given: Vec<(String, String)>) -> PyResult<Self> {
        let stays =
            |key: &str| given.iter().all(|(other, _)| !overrides(canonical(other), canonical(key)));
        let kept = self.given.iter().filter(|(key, _)| stays(key)).cloned();
        let all: Vec<_> = kept.chain(given.iter().cloned()).collect();
        Self::new(py, &self.text, all)
    }

    /// The value of a key that is one number.
    fn number(&self, key: &str) -> Option<f64> {
        let entry = self.entries.iter().find(|entry| entry.key == canonical(key))?;
        let Value::Number(value) = &entry.value.value else { return None };
        value.number().and_then(ToPrimitive::to_f64)
    }

    /// A state at t0 to show it with.
    fn start(&self, py: Python<'_>) -> PyResult<Vec<f64>> {
        py.detach(|| guarded(|| self.joined().example_start())).map_err(|fault| internal(&fault))
    }

    /// The name of the controller.
    #[getter]
    fn name(&self) -> String {
        self.spec.name()
    }

    /// The flags with which the command makes the same controller.
    #[getter]
    fn command(&self) -> String {
        self.spec.command()
    }

    /// The fingerprint of the resolved design.
    fn fingerprint(&self, py: Python<'_>) -> PyResult<String> {
        let resolved = py.detach(|| guarded(|| Resolved::of(&self.spec)));
        Ok(resolved.map_err(|fault| internal(&fault))?.spec.fingerprint())
    }

    /// The values that were open and are chosen, as (key, value, reason).
    fn chosen(&self, py: Python<'_>) -> PyResult<Vec<(&'static str, String, String)>> {
        let resolved = py.detach(|| guarded(|| Resolved::of(&self.spec)));
        let choices = resolved.map_err(|fault| internal(&fault))?.choices;
        Ok(choices.into_iter().map(|Choice { key, value, reason }| (key, value, reason)).collect())
    }

    /// The names of the states of the plant.
    #[getter]
    fn states(&self) -> Vec<String> {
        self.joined().state_names()
    }
}

impl Design {
    /// The exception of mistakes in it.
    pub(crate) fn wrong(&self, py: Python<'_>, found: Vec<Diagnostic>) -> PyErr {
        mistakes(py, found, &self.text, &self.places)
    }

    /// Its spec, with several axes as one plant.
    fn joined(&self) -> Spec {
        as_one(self.spec.clone(), self.plant.clone()).0
    }

    /// Whether `key` is given beside the text.
    pub(crate) fn gives(&self, key: &str) -> bool {
        self.given.iter().any(|(own, _)| canonical(own) == key)
    }

    /// The entries with other values of some keys.
    pub(crate) fn with(&self, py: Python<'_>, given: &[(String, String)]) -> PyResult<Vec<Entry>> {
        let mut places = self.places.clone();
        let mut entries = self.entries.clone();
        give(&mut entries, given, &mut |_| outside(&mut places))
            .map_err(|found| mistakes(py, found, &self.text, &self.places))?;
        Ok(entries)
    }
}

/// A place that is not in the text.
fn outside(places: &mut Vec<Range<usize>>) -> Place {
    places.push(usize::MAX..usize::MAX);
    Place(usize::MAX)
}

/// Puts values in place of those of a design.
fn give(
    entries: &mut Vec<Entry>,
    given: &[(String, String)],
    place: &mut dyn FnMut(Range<usize>) -> Place,
) -> Result<(), Vec<Diagnostic>> {
    let mut found = Vec::new();
    entries.retain(|entry| given.iter().all(|(key, _)| !overrides(canonical(key), &entry.key)));
    for (key, text) in given {
        let key = canonical(key);
        match parse(key, text, place) {
            Ok(value) => entries.push(Entry { key: key.to_owned(), place: place(0..0), value }),
            Err(wrong) => found.push(wrong),
        }
    }
    if found.is_empty() { Ok(()) } else { Err(found) }
}

/// Mistakes, and where in the text their places are.
type Wrong = (Vec<Diagnostic>, Vec<Range<usize>>);

fn read(text: &str, given: &[(String, String)]) -> Result<Design, Wrong> {
    let large = |code, message: String, help: &str| {
        let key = "design".to_owned();
        (vec![Diagnostic { code, key, place: None, message, help: help.to_owned() }], Vec::new())
    };
    if !DESIGN.admits(text.len()) {
        return Err(large(UNREADABLE, DESIGN.beyond("the design"), DESIGN.fix));
    }
    if !ENTRIES.admits(given.len()) {
        return Err(large(LARGE, ENTRIES.exceeded("the call", given.len()), ENTRIES.fix));
    }
    let mut places = Vec::new();
    let (mut entries, mut found) = design::read(text, &mut |range| {
        places.push(range);
        Place(places.len() - 1)
    });
    // Invalid TOML is always reported, even where other values override it.
    let stands = |wrong: &Diagnostic| given.iter().all(|(key, _)| !overrides(key, &wrong.key));
    found.retain(|wrong| wrong.code == design::SYNTAX || stands(wrong));
    let beside = give(&mut entries, given, &mut |_| Place(usize::MAX));
    found.extend(beside.err().unwrap_or_default());
    match read_design(&entries) {
        Ok((spec, plant)) if found.is_empty() => Ok(Design {
            text: text.to_owned(),
            places,
            entries,
            spec,
            plant,
            given: given.to_vec(),
        }),
        Ok(_) => Err((design::mistakes(&found, &entries, Vec::new()), places)),
        Err(more) => Err((design::mistakes(&found, &entries, more), places)),
    }
}

/// The source files of a design, each with its name.
#[pyfunction]
pub(crate) fn emit(
    py: Python<'_>,
    design: &Design,
    lang: &str,
    selftest: bool,
) -> PyResult<Vec<(String, String)>> {
    let languages: Vec<_> = Language::ALL.into_iter().filter(|one| one.fmi().is_none()).collect();
    let named = Language::named(lang).filter(|one| languages.contains(one));
    let Some(language) = named else {
        let names: Vec<_> = languages.iter().map(|one| one.name()).collect();
        let names = names.join(", ");
        return Err(PyValueError::new_err(format!(
            "unknown language `{lang}`; legal: {names} (`ptc-codegen emit` writes FMUs and projects)"
        )));
    };
    if selftest && language != Language::C {
        let message = format!("a self-test is in C, not `{lang}`");
        let help = "give lang=\"c\", or leave selftest out".to_owned();
        return Err(mistake(py, "conflict", message, help));
    }
    let files = py.detach(|| {
        guarded(|| {
            let accepted = Accepted::of(examine(&design.spec))?;
            let mut files = accepted.files(language, &[])?;
            if selftest {
                files.extend(accepted.selftest()?);
            }
            Ok(files)
        })
    });
    let files = files.map_err(|fault| internal(&fault))?;
    let files = files.map_err(|found| design.wrong(py, found))?;
    Ok(files.into_iter().map(|file| (file.name, file.text)).collect())
}
