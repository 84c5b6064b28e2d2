//! The draws in a report: how they spread, what drives them, which are worst.

use crate::diagnostic::digits;
use crate::parameter::Parameter;
use crate::plot::{Band, Histogram};
use crate::verify::{Campaign, Drawn, Envelope, Kind, Trajectory, Trial, Worst};

use crate::cli::page::{Part, Svg, Table};
use crate::cli::report::Failure;

/// Draws that are run once more for the envelope.
const ENVELOPED: u64 = 256;

/// Shares of the draws, with their names.
const SHARES: [(f64, &str); 5] =
    [(0.5, "50 %"), (0.9, "90 %"), (0.99, "99 %"), (0.999, "99.9 %"), (1.0, "100 %")];

/// The parts, in their order; `replayed` is the command that runs one draw again, by its index.
pub(super) fn parts(
    (campaign, trial): (&Campaign, &Trial),
    drawn: &Drawn,
    trajectory: Option<&Trajectory>,
    replayed: &dyn Fn(u64) -> String,
) -> Result<Vec<Part>, Failure> {
    if drawn.tally.scenarios == 0 {
        return Ok(Vec::new());
    }
    Ok(vec![
        spread(campaign, drawn)?,
        drivers(campaign, drawn),
        envelope((campaign, trial), trajectory)?,
        worst(campaign, drawn, replayed),
    ])
}

fn spread(campaign: &Campaign, drawn: &Drawn) -> Result<Part, Failure> {
    let mut charts = Vec::new();
    let mut rows = Vec::new();
    let all = (1..).zip(campaign.objectives.iter().zip(&drawn.spreads));
    for (number, (objective, spread)) in all {
        let kind = &objective.kind;
        let title = format!("objective {number}: draws");
        let (across, bound) = match kind {
            Kind::Within { .. } => ("outside by, in the unit of h (below 0: inside)", 0.0),
            _ => ("worst size in parts of the bound", 1.0),
        };
        let (across, sizes) = (across.to_owned(), spread.measures());
        let histogram = Histogram { title, across, sizes, bound };
        charts.push(Svg::try_from(histogram.svg())?);
        let at = SHARES.map(|(share, _)| told(kind, spread.percentile(share)));
        rows.push([number.to_string()].into_iter().chain(at).collect());
    }
    let heads = SHARES.map(|(_, name)| format!("{name} of the draws"));
    let head = ["objective".to_owned()].into_iter().chain(heads).collect();
    let count = drawn.tally.scenarios;
    Ok(Part {
        title: "Spread of the draws",
        told: vec![format!(
            "The {count} draws by their worst instant, counted on a logarithmic axis. Below, what a share of them keeps: a part of the bound, or a distance to it, rounded up by 1 % at most. A run that ends early counts as far as it comes."
        )],
        charts,
        table: Table { head, rows },
    })
}

/// A measure in a cell.
fn told(kind: &Kind, measure: f64) -> String {
    match kind {
        _ if measure.is_infinite() => "out of range".to_owned(),
        Kind::Within { .. } if measure > 0.0 => format!("outside by {}", digits(measure)),
        Kind::Within { .. } => format!("inside by {}", digits(-measure)),
        _ => digits(measure),
    }
}

fn drivers(campaign: &Campaign, drawn: &Drawn) -> Part {
    let rows = (0..campaign.objectives.len()).map(|objective| {
        let drivers = drawn.drivers(objective);
        let rest = 1.0 - drivers.iter().map(|driver| driver.share).sum::<f64>();
        let each =
            drivers.iter().map(|driver| format!("{} {:.0} %", driver.name, 100.0 * driver.share));
        let all: Vec<_> = each.collect();
        let all = if all.is_empty() { "none beyond chance".to_owned() } else { all.join(", ") };
        vec![(objective + 1).to_string(), all, format!("{:.0} %", 100.0 * rest.clamp(0.0, 1.0))]
    });
    Part {
        title: "What drives them",
        told: vec![
            "The share of the variation that each quantity explains by itself: the first-order Sobol index of the rank of the draws, from 8 parts of its interval. The rest is due to combinations, to the course of a disturbance, and to what is drawn at each sample.".to_owned(),
        ],
        charts: Vec::new(),
        table: Table {
            head: ["objective", "driven by", "rest"].map(str::to_owned).into(),
            rows: rows.collect(),
        },
    }
}

fn envelope(
    (campaign, trial): (&Campaign, &Trial),
    trajectory: Option<&Trajectory>,
) -> Result<Part, Failure> {
    let Envelope { draws, at, within } = Envelope::of(campaign, trial, ENVELOPED);
    let spec = &campaign.spec;
    let names: Vec<_> = spec.state_names().into_iter().chain(spec.input_names()).collect();
    let mut charts = Vec::new();
    for (place, (title, within)) in names.into_iter().zip(within).enumerate() {
        let run = trajectory.map_or_else(Vec::new, |worst| {
            let values = campaign.setting(&worst.scenario).values;
            let [tau, start] = [Parameter::Tau, Parameter::StartTime].map(|p| values.get(p));
            let instants = worst.instants.iter();
            let of_place =
                instants.filter_map(|i| Some((i.t, *i.x.iter().chain(&i.u).nth(place)?)));
            of_place.map(|(t, value)| ((t - start) / tau, value)).collect()
        });
        let across = "(t - t0)/tau".to_owned();
        charts.push(Svg::try_from(Band { title, across, at: at.clone(), within, run }.svg())?);
    }
    Ok(Part {
        title: "Envelope of the trajectories",
        told: vec![format!(
            "Between what the first {draws} draws are in each 64th of the run, and the worst trajectory."
        )],
        charts,
        table: Table::default(),
    })
}

fn worst(campaign: &Campaign, drawn: &Drawn, replayed: &dyn Fn(u64) -> String) -> Part {
    let all = (1..).zip(campaign.objectives.iter().zip(&drawn.spreads));
    let rows = all.flat_map(|(number, (objective, spread))| {
        spread.worst.iter().map(move |Worst { value, index }| {
            let at = told(&objective.kind, objective.kind.measure(*value));
            vec![number.to_string(), index.to_string(), at, replayed(*index)]
        })
    });
    Part {
        title: "Worst draws",
        told: vec!["Each command prints the trajectory of its draw as CSV.".to_owned()],
        charts: Vec::new(),
        table: Table {
            head: ["objective", "draw", "part of the bound, or distance to it", "command"]
                .map(str::to_owned)
                .into(),
            rows: rows.collect(),
        },
    }
}
