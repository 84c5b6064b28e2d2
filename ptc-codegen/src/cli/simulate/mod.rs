//! `simulate`: the closed loop of a design with its plant, as CSV and as a picture.

mod args;
mod input;
mod page;
mod picture;
mod run;

pub(crate) use args::{EXAMPLES, Simulate};
use picture::Kind;
use ptc_codegen::plant::Plant;
use run::{Run, continuous, sampled};

use super::output::{self, Outputs};
use super::page as html;
use super::report::{Failure, note};
use super::write;

/// Runs `simulate`.
pub(crate) fn simulate(request: &Simulate) -> Result<(), Failure> {
    let kind = request.plot.as_deref().map(Kind::of).transpose()?;
    html::named(request.report.as_deref())?;
    let mut outputs = Outputs::default();
    if let Some(design) = &request.design.design {
        outputs.reads("the design", design);
    }
    let out = outputs.file("--out", &request.out)?;
    let report = outputs.optional("--report", request.report.as_deref())?;
    let plot = outputs.optional("--plot", request.plot.as_deref())?;
    let mut source = request.spec.0.with_design(request.design.design.as_deref())?;
    request.plant.iter().for_each(|text| source.give_plant(text));
    let mut runs = Vec::new();
    let mut drawn = None;
    for source in source.each("tau") {
        let given = source.parse();
        let (spec, plant) = given.read_with_plant()?;
        let knows = spec
            .needs_law("simulate")
            .and_then(|()| spec.needs_one_axis("simulate"))
            .and_then(|()| spec.needs_known_reference("simulate"));
        if let Err(found) = knows {
            return given.finish(None, found);
        }
        let linear = spec.sampled().is_some_and(|sampled| sampled.linear.is_some());
        if plant.is_none() && !linear && runs.is_empty() {
            let plant = match (&spec.model, &spec.drift) {
                (Some(_), _) => "its model".to_owned(),
                (None, f) => {
                    let f = f.as_ref().map_or("0".to_owned(), ToString::to_string);
                    format!("the chain of integrators, f = {f}")
                }
            };
            note(&format!("the design has no [plant]: the plant is {plant}"));
        }
        let plant = plant.unwrap_or_else(|| Plant::own(&spec));
        let asked = input::read(request, &spec)?;
        let run = match &asked.around {
            None => continuous(&spec, &plant, &asked)?,
            Some(around) => sampled(&spec, &plant, &asked, around)?,
        };
        if runs.iter().any(|other: &Run| other.tau.to_bits() == run.tau.to_bits()) {
            return Err(Failure::because(
                format!("tau = {} is given twice", run.tau),
                "give each tau once: --tau 1,2,5",
            ));
        }
        if let Some(told) = run.tracking() {
            note(&told);
        }
        runs.push(run);
        drawn = Some((spec, plant));
    }
    let csv = csv(&runs);
    let mut files = Vec::new();
    let picture = match (kind, &drawn) {
        (Some(kind), Some((spec, _))) => kind.file(spec, &runs)?,
        _ => Vec::new(),
    };
    let told = match (&report, &drawn) {
        (Some(_), Some((spec, plant))) => page::text(request, &source, (spec, plant), &runs)?,
        _ => String::new(),
    };
    files.push((out, csv.as_bytes()));
    files.extend(report.map(|place| (place, told.as_bytes())));
    files.extend(plot.map(|place| (place, picture.as_slice())));
    // What is printed is the CSV or the page alone, for whatever reads it.
    let printed = files.iter().any(|(place, _)| place.is_standard_output());
    let told = output::write(&files)?;
    if printed { Ok(()) } else { write::to_stdout(&told) }
}

fn csv(runs: &[Run]) -> String {
    // All runs are of one kind.
    let columns = runs.first().map(Run::columns).unwrap_or_default();
    let mut text = format!("tau,t,{}\n", columns.join(","));
    for run in runs {
        for row in run.rows.iter().filter(|row| row.reported) {
            let (measured, status) = match run.held {
                true => (&row.measured[..], format!(",{}", row.status.c_name())),
                false => (&[][..], String::new()),
            };
            let given = [run.tau, row.t];
            let values = given.iter().chain(&row.x).chain([&row.u]).chain(measured);
            let values: Vec<_> = values.map(|value| format!("{value:?}")).collect();
            text.push_str(&format!("{}{status}\n", values.join(",")));
        }
    }
    text
}
