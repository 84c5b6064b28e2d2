//! `simulate`: the closed loop of a design with its plant, as CSV and as a picture.

mod args;
mod csv;
mod input;
mod merit;
mod page;
mod picture;
mod run;

use crate::check::resolved::Resolved;
use crate::diagnostic::visible_line;
use crate::parameter::Precision;
use crate::plant::{self, Plant};
pub(crate) use args::{ABOUT, EXAMPLES, Simulate};
use csv::Csv;
use page::Drawn;
use run::{Run, continuous, sampled};

use super::output::{self, Content, Outputs};
use super::page as html;
use super::picture::{file_of, format_of};
use super::progress::checking;
use super::report::{Failure, note};
use super::source::Source;
use super::write;
use crate::simulate::event;

/// Runs `simulate`.
pub(crate) fn simulate(request: &Simulate) -> Result<(), Failure> {
    let format = request.plot.as_deref().map(format_of).transpose()?;
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
    let mut designs = Vec::new();
    let mut drawn = None;
    let mappings = source.each_flag("mu");
    if let (true, Some(path)) = (mappings.len() > 1, &request.report) {
        return Err(Failure::because(
            format!(
                "--report {}: a report is of one mapping, and --mu is given {} times",
                path.display(),
                mappings.len()
            ),
            "give --mu once, or --plot for a picture of all",
        ));
    }
    let mut csv = Csv::new(out, numbered(request, &mappings))?;
    let sources = mappings.iter().flat_map(|source| source.each("tau"));
    let all = sources.flat_map(|source| request.x0.iter().map(move |x0| (source.clone(), x0)));
    for (source, x0) in all {
        let given = source.parse();
        let (mut spec, plant) = given.read_run()?;
        if !request.plant.is_empty() {
            // The controller is that of the design, whatever plant it runs with.
            if let Ok((own, _)) = source.without_plant().parse().read_run() {
                spec.promises.plant = own.promises.plant;
            }
        }
        let knows =
            spec.needs_law("simulate").and_then(|()| spec.needs_known_reference("simulate"));
        if let Err(found) = knows {
            return given.finish(None, found);
        }
        let resolved = checking(|| Resolved::of(&spec));
        let requested = spec;
        let (spec, plant) = plant::as_one(resolved.spec.clone(), plant);
        let linear = spec.sampled().is_some_and(|sampled| sampled.linear.is_some());
        if plant.is_none() && !linear && runs.is_empty() {
            let plant = match (spec.has_model(), &spec.drift) {
                _ if spec.joins_axes() => "chains of integrators".to_owned(),
                (true, _) => "its model".to_owned(),
                (false, f) => {
                    let f = f.as_ref().map_or("0".to_owned(), ToString::to_string);
                    format!("the chain of integrators, f = {f}")
                }
            };
            note(&format!("the design has no [plant]: the plant is {plant}"));
        }
        let plant = plant.unwrap_or_else(|| Plant::own(&spec));
        let events = match event::read_numbers(&given.entries, &spec) {
            Ok(events) => events,
            Err(found) => return given.finish(None, found),
        };
        let (asked, around) = input::read(request, x0, &spec, &events)?;
        if let Some(outside) = input::outside(&spec, &asked.x0) {
            note(&outside);
        }
        if around.is_none() && spec.precision == Precision::F32 && runs.is_empty() {
            note(
                "the loop at every instant is integrated in f64; the emitted program, in f32, gives u and its status up to eps, if eps is known; --sample-time runs it in the loop",
            );
        }
        let mut run = match &around {
            None => continuous((&resolved, &spec), &plant, &asked, &mut csv)?,
            Some(around) => sampled((&resolved, &spec), &plant, &asked, around, &mut csv)?,
        };
        if mappings.len() > 1 {
            let text = source.flags().find_map(|(name, text)| (name == "--mu").then_some(text));
            run.mapping = visible_line(text.unwrap_or(&run.mapping));
            run.label = format!("{}, {}", run.mapping, run.label);
        }
        if request.x0.len() > 1 {
            run.label.push_str(&visible_line(&format!(", x0 = ({x0})")));
        }
        if runs.iter().any(|other: &Run| other.label == run.label) {
            return Err(Failure::because(
                format!("{} is given twice", run.label),
                "give each tau, --mu and --x0 once: --tau 1,2,5",
            ));
        }
        if numbered(request, &mappings) {
            note(&format!("run {}: {}", runs.len() + 1, run.label));
        }
        if let Some(told) = run.tracking() {
            note(&told);
        }
        let fingerprint = resolved.spec.fingerprint();
        if !designs.contains(&fingerprint) {
            named(&resolved, (!designs.is_empty()).then_some(&run.label));
            designs.push(fingerprint);
        }
        runs.push(run);
        drawn = Some(Drawn { requested, resolved, spec, plant });
    }
    let mut files = vec![csv.finish()?];
    let picture = match (format, &drawn) {
        (Some(format), Some(drawn)) => {
            file_of(format, &picture::figure(&drawn.spec, &runs, request.log))?
        }
        _ => Vec::new(),
    };
    let told = match (&report, &drawn) {
        (Some(_), Some(drawn)) => page::text(request, &source, drawn, &runs)?,
        _ => String::new(),
    };
    files.extend(report.map(|place| (place, Content::Bytes(told.as_bytes()))));
    files.extend(plot.map(|place| (place, Content::Bytes(&picture))));
    // What is printed is the CSV or the page alone, for whatever reads it.
    let printed = files.iter().any(|(place, _)| place.is_standard_output());
    let told = output::write_all(files)?;
    if printed { Ok(()) } else { write::to_stdout(&told) }
}

/// Names the controller that runs, and prints what was chosen for it; `run` is that of a further one.
fn named(resolved: &Resolved, run: Option<&String>) {
    let of = run.map_or_else(String::new, |run| format!(", {run}"));
    note(&format!("design {}{of}", resolved.spec.fingerprint()));
    resolved.lines().iter().for_each(|line| note(line));
}

/// Returns true if tau does not identify the runs.
fn numbered(request: &Simulate, mappings: &[Source]) -> bool {
    mappings.len() > 1 || request.x0.len() > 1
}
