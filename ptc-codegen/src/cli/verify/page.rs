//! The report of a verification.

use crate::check::examine::examine_resolved;
use crate::parameter::Parameter;
use crate::plot::{Bounded, Figure, Quantity, Trace};
use crate::request::Spec;
use crate::verify::{
    APART, Campaign, Drawn, End, Judged, Kind, Level, Objective, Sides, Summary, Trajectory, Trial,
    Verdict, columns, shown,
};

use super::args::Verify;
use super::draws;
use crate::cli::mathml::{
    Math, fenced, name, number, of_expression, operator, product, relation, row, sub, words,
};
use crate::cli::page::{self, Content, Section, Svg, Table, command, reporting, short};
use crate::cli::progress::checking;
use crate::cli::report::Failure;
use crate::cli::source::Source;

/// The page.
pub(super) fn text(
    request: &Verify,
    source: &Source,
    (campaign, trial): (&Campaign, &mut Trial),
    (summary, drawn): (&Summary, &Drawn),
) -> Result<String, Failure> {
    let spec = &campaign.spec;
    let flags = [("--scenarios", request.scenarios.clone()), ("--seed", request.seed.clone())];
    let command = command("verify", spec, source, &flags);
    let replayed = |index: u64| format!("{command} --scenario={index}");
    let parts = draws::parts((campaign, trial), drawn, summary.trajectory.as_ref(), &replayed)?;
    let content = Content {
        spec,
        report: &checking(|| examine_resolved(campaign.design.clone(), None)),
        plant: &campaign.plant,
        source,
        section: Section { parts, ..section((campaign, trial), summary)? },
        command: reporting(&command, spec),
    };
    page::html(&content)
}

fn section(
    (campaign, trial): (&Campaign, &mut Trial),
    summary: &Summary,
) -> Result<Section, Failure> {
    let end = match summary.end() {
        End::Holds => "Every objective holds",
        End::Fails => "Not verified",
        End::Undecided => "Undecided",
    };
    let mut told = vec![format!("{end}: {}.", summary.run)];
    told.push(format!("{}. Draws: {}.", uncertain(campaign).join("; "), summary.distribution));
    let pairs = campaign.objectives.iter().zip(&summary.objectives);
    let mut verdicts: Vec<_> = (1..).zip(pairs).map(judged).collect();
    if let Some(Sides { told, apart }) = &summary.sides {
        let mut details = vec![told.clone()];
        details.extend(apart.then(|| APART.to_owned()));
        verdicts.push(page::Judged {
            name: String::new(),
            what: words("both sides of Theorem 1"),
            colour: if *apart { "open" } else { "good" },
            verdict: if *apart { "differ" } else { "agree" }.to_owned(),
            details,
        });
    }
    let Some(trajectory) = &summary.trajectory else {
        let figure = Svg::of(&Figure::default())?;
        let caption = String::new();
        return Ok(Section {
            title: TITLE,
            told,
            verdicts,
            caption,
            figure,
            table: Table::default(),
            parts: Vec::new(),
        });
    };
    Ok(Section {
        title: TITLE,
        told,
        verdicts,
        caption: format!(
            "Worst trajectory, {}. Bounds of the objectives are dashed, in red.{}",
            trajectory.told,
            trajectory
                .ended
                .iter()
                .map(|ended| format!(" It ends early: {ended}."))
                .collect::<String>()
        ),
        figure: Svg::of(&figure((campaign, trial), trajectory)?)?,
        table: table(&campaign.spec, trajectory),
        parts: Vec::new(),
    })
}

const TITLE: &str = "Verification";

/// The boxes and the disturbances.
fn uncertain(campaign: &Campaign) -> Vec<String> {
    let within = |name: &str, (least, greatest): (f64, f64)| match least == greatest {
        true => format!("{name} = {least}"),
        false => format!("{name} in [{least}, {greatest}]"),
    };
    let mut parts: Vec<_> =
        campaign.uncertain().map(|(name, interval)| within(&name, interval)).collect();
    for (symbol, interval, signals) in &campaign.disturbances {
        let signals: Vec<_> = signals.iter().map(|signal| signal.name()).collect();
        let signals = signals.join(", ");
        parts.push(format!("{} over time: {signals}", within(&symbol.spelling(), *interval)));
    }
    parts
}

fn judged((number, (objective, judged)): (usize, (&Objective, &Judged))) -> page::Judged {
    page::Judged {
        name: format!("objective {number}"),
        what: formula(objective),
        colour: match judged.verdict {
            Verdict::Proved | Verdict::Sampled { .. } => "good",
            Verdict::Met | Verdict::Undecided(_) => "open",
            Verdict::Fails => "bad",
        },
        verdict: judged.verdict(),
        details: judged.details.clone(),
    }
}

/// Writes formulas that belong together, with commas between them.
fn listed(all: impl Iterator<Item = Math>) -> Math {
    let joined = all.reduce(|one, next| row([one, operator(","), words("  "), next]));
    joined.unwrap_or_else(|| words(""))
}

/// The objective in words.
fn formula(objective: &Objective) -> Math {
    let size = |of: Math| fenced("|", of, "|");
    let below = |left: Math, right: Math| relation(left, "\u{2264}", right);
    let bound = |value: f64| number(value);
    // An integral has no name of its own in a formula.
    if objective.integrates {
        return words(&objective.text);
    }
    match &objective.written {
        Kind::State { sigma, zeta } => {
            let start = size(sub(name(objective.letter), number(0)));
            let whole = product(bound(*sigma), start);
            let right = match zeta.small_integer() {
                Some(1) => whole,
                _ => product(whole, fenced("(", of_expression(zeta), ")")),
            };
            below(size(name(objective.letter)), right)
        }
        Kind::Input { upsilon } => below(size(name("u")), of_expression(upsilon)),
        Kind::Inputs { upsilon } => {
            let each = upsilon
                .iter()
                .map(|(input, bound)| below(size(name(input.text())), of_expression(bound)));
            listed(each)
        }
        Kind::Attractive { error } => {
            row([below(size(name(objective.letter)), bound(*error)), words(" at the end")])
        }
        Kind::AttractiveEach { errors } => {
            let each = errors.iter().map(|(index, error)| {
                below(size(sub(name(objective.letter), name(index))), bound(*error))
            });
            row([listed(each), words(" at the end")])
        }
        Kind::Within { h, low, high } => {
            let mut math = of_expression(h);
            if let Some(low) = low {
                math = below(of_expression(low), math);
            }
            if let Some(high) = high {
                math = below(math, of_expression(high));
            }
            math
        }
    }
}

fn figure(
    (campaign, trial): (&Campaign, &mut Trial),
    trajectory: &Trajectory,
) -> Result<Figure, Failure> {
    let Trajectory { scenario, instants, .. } = trajectory;
    let setting = campaign.closely(scenario);
    let levels = trial.levels(&setting, instants)?;
    let [tau, start] = [Parameter::Tau, Parameter::StartTime].map(|p| setting.values.get(p));
    let spec = &campaign.spec;
    let trace = Trace {
        label: format!("worst trajectory, tau = {} s", short(tau)),
        start,
        deadline: start + tau,
        t: instants.iter().map(|instant| instant.t).collect(),
        stretched: vec![f64::NAN; instants.len()],
        x: (0..spec.states())
            .map(|j| instants.iter().map(|instant| instant.x[j]).collect())
            .collect(),
        u: (0..spec.input_names().len())
            .map(|k| instants.iter().map(|instant| instant.u[k]).collect())
            .collect(),
        held: campaign.around.is_some(),
    };
    let bounded = campaign.objectives.iter().zip(&levels).enumerate();
    Ok(Figure {
        title: format!("{}: {}, {}", spec.name(), spec.order_text(), spec.mapping_name()),
        states: Quantity::states(spec),
        inputs: Quantity::inputs(spec),
        traces: vec![trace],
        limits: setting.values.limits(spec),
        x_max: Vec::new(),
        objectives: bounded
            .map(|(i, (objective, levels))| of_levels(i, objective, levels))
            .collect(),
        by_decades: false,
    })
}

fn of_levels(index: usize, objective: &Objective, levels: &[Level]) -> Bounded {
    let what = match &objective.written {
        Kind::State { .. } | Kind::Attractive { .. } => format!("|{}|", objective.letter),
        Kind::Input { .. } => "|u|".to_owned(),
        Kind::Inputs { .. } => "largest |u_k| in parts of its bound".to_owned(),
        Kind::AttractiveEach { .. } => {
            format!("largest |{}_i| in parts of its bound", objective.letter)
        }
        Kind::Within { h, .. } => h.to_string(),
    };
    let column = |of: &dyn Fn(&Level) -> Option<f64>| -> Vec<f64> {
        levels.iter().map(|level| of(level).unwrap_or(f64::NAN)).collect()
    };
    Bounded {
        title: format!("objective {}: {what}", index + 1),
        values: levels.iter().map(|level| level.value).collect(),
        bounds: vec![column(&|level| level.low), column(&|level| level.high)],
        by_decades: !matches!(objective.kind, Kind::Within { .. }),
    }
}

fn table(spec: &Spec, Trajectory { instants, .. }: &Trajectory) -> Table {
    let heads = ["t in s".to_owned(), "T in s".to_owned()].into_iter().chain(columns(spec));
    let head = heads.chain([String::new()]).collect();
    let rows = shown(instants).into_iter().map(|(instant, worst)| {
        let numbers = [instant.t, instant.time_to_go].into_iter().chain(instant.numbers().copied());
        let told = if worst { "worst" } else { "" };
        numbers.map(short).chain([told.to_owned()]).collect()
    });
    Table { head, rows: rows.collect() }
}
