//! Pictures of runs, and the card of a design, as the command draws and writes them.

use ptc_codegen::check::examine::examine;
use ptc_codegen::internal::guarded;
use ptc_codegen::plant::{self, Plant};
use ptc_codegen::plot::{Drawn, Figure, Format};
use ptc_codegen::reference::Status;
use ptc_codegen::request::Spec;
use ptc_codegen::simulate::Values;
use ptc_codegen::simulate::kept::Kept;
use ptc_codegen::simulate::record::Row;
use ptc_codegen::{Shown, card as written};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

use crate::design::Design;
use crate::failure::{internal, mistake};

/// A run as Python holds it: the bytes of its doubles.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Given {
    design: Py<Design>,
    label: Option<String>,
    tau: f64,
    t0: f64,
    held: bool,
    t: Vec<u8>,
    stretched: Vec<u8>,
    x: Vec<u8>,
    u: Vec<u8>,
}

/// A run of a design, as it is drawn.
struct Own {
    spec: Spec,
    plant: Plant,
    label: String,
    kept: Kept,
}

fn doubles(bytes: &[u8]) -> Vec<f64> {
    bytes.as_chunks().0.iter().map(|bytes| f64::from_ne_bytes(*bytes)).collect()
}

impl Own {
    fn new(py: Python<'_>, given: &Given) -> Self {
        let design = given.design.get();
        let (spec, plant) = py.detach(|| design.as_one());
        let limits = Values::of(&spec, &plant).limits(&spec);
        let mut kept = Kept::new(limits);
        let (t, stretched) = (doubles(&given.t), doubles(&given.stretched));
        let (x, u) = (doubles(&given.x), doubles(&given.u));
        let states = x.chunks_exact(spec.states().max(1));
        let inputs = u.chunks_exact(spec.input_names().len().max(1));
        for ((t, stretched), (x, u)) in t.into_iter().zip(stretched).zip(states.zip(inputs)) {
            let (x, u) = (x.to_vec(), u.to_vec());
            let measured = x.clone();
            kept.take(Row { t, stretched, x, measured, status: Status::Ok, u, reported: true });
        }
        let label = given.label.clone().unwrap_or_else(|| Drawn::label(given.tau));
        Self { spec, plant, label, kept }
    }
}

/// The file of the picture of runs: `format` is the extension of its name.
#[pyfunction]
pub(crate) fn draw(
    py: Python<'_>,
    runs: Vec<Given>,
    by_decades: bool,
    format: &str,
) -> PyResult<Vec<u8>> {
    let wrong = |message: String, help: &str| mistake(py, "bad-value", message, help.to_owned());
    let Some(kind) = Format::of_extension(format) else {
        let help = "give a file that ends in .svg, .png or .pdf";
        return Err(wrong(format!("`.{format}`: unsupported image type"), help));
    };
    let all: Vec<_> = runs.iter().map(|given| Own::new(py, given)).collect();
    let Some(last) = all.last() else {
        return Err(wrong("a picture of no run".to_owned(), "give at least one"));
    };
    let names = |own: &Own| (own.spec.state_names(), own.spec.input_names());
    if all.iter().any(|own| names(own) != names(last)) {
        let help = "draw runs of other plants in a picture of their own";
        return Err(wrong("the runs have different states or inputs".to_owned(), help));
    }
    let alike = |place: usize| all[..place].iter().find(|own| own.label == all[place].label);
    if let Some(own) = (0..all.len()).find_map(alike) {
        let help = "give `labels`, one for each run";
        return Err(wrong(format!("two runs are called `{}`", own.label), help));
    }
    let drawn: Vec<_> = runs.iter().zip(&all).map(|(given, own)| drawn(given, own)).collect();
    let limits = Values::of(&all[0].spec, &all[0].plant).limits(&all[0].spec);
    let file = py
        .detach(|| guarded(|| kind.file(&Figure::of_runs(&last.spec, &drawn, limits, by_decades))));
    let file = file.map_err(|fault| internal(&fault))?;
    file.map_err(|undrawn| {
        let help = "see that the numbers of the run are of a size that can be drawn";
        wrong(format!("the picture cannot be drawn: {undrawn}"), help)
    })
}

fn drawn<'a>(given: &Given, own: &'a Own) -> Drawn<'a> {
    let mapping = own.spec.mapping_name();
    let Given { tau, t0, held, .. } = *given;
    Drawn { label: own.label.clone(), mapping, tau, t0, held, kept: &own.kept }
}

/// The card of a design: a fragment of HTML with its summary, its picture, of which `source` is a URL with a caption or
/// `problem` the reason why there is none, and its verdicts.
#[pyfunction]
pub(crate) fn card(
    py: Python<'_>,
    design: &Design,
    picture: Option<(String, String)>,
    problem: String,
) -> PyResult<String> {
    let shown = picture.map(|(source, caption)| Shown { source, caption }).ok_or(problem);
    let text = py.detach(|| {
        guarded(|| {
            let report = examine(&design.spec);
            let plant = design.plant.clone().unwrap_or_else(|| Plant::own(&report.spec));
            written(&report, &plant, shown)
        })
    });
    text.map_err(|fault| internal(&fault))?.map_err(PyRuntimeError::new_err)
}

impl Design {
    /// The resolved design with its plant, several axes as one plant.
    pub(crate) fn as_one(&self) -> (Spec, Plant) {
        let resolved = ptc_codegen::check::resolved::Resolved::of(&self.spec);
        let (spec, plant) = plant::as_one(resolved.spec, self.plant.clone());
        let plant = plant.unwrap_or_else(|| Plant::own(&spec));
        (spec, plant)
    }
}
