//! All checks on one design, and what follows from them for the guard eps.

mod known;
mod numbers;
mod period;

use std::collections::btree_map::Entry;

pub(crate) use known::decay;
use known::{Decay, Rate, fixed_gains, is_known};
pub(crate) use numbers::Numbers;
pub(crate) use period::held_period;

use super::envelope::{Interval, scan};
use super::growth::{self, Growth, Modes, growth, growth_between};
use super::membership::prove;
use super::sampled::{self, Loop, Worst};
use super::sampling::sampling;
use super::zeros;
use super::{Outcome, Verdict};
use crate::check::deadline::{ClosedLoop, deadline};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expansion::Expanded;
use crate::expression::effort::bounded;
use crate::family::Family;
use crate::keys::CHECKS;
use crate::law::Law;
use crate::lower::lower;
use crate::parameter::{Fixed, Parameter};
use crate::program::{Input, number, passes};
use crate::request::{Clock, Feedback, PlantBounds, Reference, Spec, What};

/// Pieces of time-to-go in which the envelope is scanned: some 20 a decade.
const PIECES: f64 = 20.0;

/// What the checks found.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// The design, with eps where a check has set it.
    pub spec: Spec,
    /// The closed forms of the design, where another engine than the library's own has made them.
    pub expanded: Option<Expanded>,
    /// One outcome for each check.
    pub outcomes: Vec<Outcome>,
    /// The greatest value of a run-time parameter with which the checks hold: `init` refuses more.
    pub greatest: Option<(Parameter, Fixed)>,
    /// The worst case of the sampled loop, where it is known.
    pub worst: Option<Worst>,
}

impl Report {
    /// The outcomes for which the design is refused: those that fail and are not allowed to.
    pub fn refusals(&self) -> impl Iterator<Item = &Outcome> {
        let allowed = &self.spec.promises.allow;
        self.outcomes.iter().filter(move |outcome| {
            matches!(outcome.verdict, Verdict::Unsound | Verdict::Refuted)
                && !allowed.iter().any(|name| name == outcome.name)
        })
    }

    /// The outcomes that leave the design open, of those that are not allowed to.
    pub fn undecided(&self) -> impl Iterator<Item = &Outcome> {
        let allowed = &self.spec.promises.allow;
        self.outcomes.iter().filter(move |outcome| {
            outcome.verdict == Verdict::Undecided
                && !allowed.iter().any(|name| name == outcome.name)
        })
    }

    /// Whether no check refuses the design: the refusals as mistakes in the spec.
    ///
    /// # Errors
    /// One diagnostic for each refusal.
    pub fn accepted(&self) -> Result<(), Vec<Diagnostic>> {
        let mut found = Diagnostics::default();
        for outcome in self.refusals() {
            let fix = outcome.fix.as_ref().map(|fix| format!("{fix}; ")).unwrap_or_default();
            found.push(
                outcome.name,
                deciding_key(&self.spec, outcome.name),
                None,
                outcome.summary.clone(),
                format!("{fix}`allow` = {} lets it pass", outcome.name),
            );
        }
        found.finish(Some(()))
    }
}

/// The outcomes of `sampling` and `deadline` alone, and the design with the eps that they set.
pub(crate) fn guarded(spec: &Spec) -> (Spec, Outcome, Outcome) {
    let mut spec = spec.clone();
    let (sampling, deadline) = guard(&mut spec, None);
    (spec, sampling, deadline)
}

/// Runs every check on `spec`. What lacks a value is not checked, and says which value.
pub fn examine(spec: &Spec) -> Report {
    examine_expanded(spec, None)
}

/// The same of what is made from the closed forms of another engine, where they are given.
pub fn examine_expanded(spec: &Spec, expanded: Option<Expanded>) -> Report {
    if spec.sampled().is_some() {
        return in_samples(spec);
    }
    let mut spec = spec.clone();
    let forms = expanded.as_ref();
    let membership = membership(&spec);
    let (growth, greatest) = check_growth(&spec);
    choose_eps(&mut spec, forms);
    let (sampling, deadline) = guard(&mut spec, forms);
    let (looped, worst) = match known::lacking(&spec) {
        Some(lacking) => (Outcome::not_checked(sampled::NAME, format!("it needs {lacking}")), None),
        None => sampled::outcome(&spec, forms),
    };
    let decided = matches!(looped.verdict, Verdict::Sound | Verdict::Refuted | Verdict::Unsound);
    let deadline = superseded(deadline, decided);
    let deadline = of_error(&spec, deadline);
    let envelope = envelope(&spec, forms);
    let allowed = spec.promises.allow.iter().any(|name| name == growth.name);
    let greatest = greatest.filter(|_| !allowed);
    let mut outcomes = vec![
        membership,
        of_error(&spec, of_chain(&spec, growth)),
        sampling,
        deadline,
        looped,
        envelope,
    ];
    outcomes.extend(zeros::outcome(&spec));
    Report { spec, expanded, outcomes, greatest, worst }
}

/// What is said of x and u of a chain, where the plant is another one.
fn of_chain(spec: &Spec, mut outcome: Outcome) -> Outcome {
    if spec.drift.is_some() || spec.model.is_some() {
        let of_model =
            if spec.model.is_some() { "x is the output with its derivatives; " } else { "" };
        outcome.details.push(format!("{of_model}u stands for f + g u, which moves x{}", spec.n));
    }
    outcome
}

/// What is said of x, where the law sees the tracking error in its place.
fn of_error(spec: &Spec, mut outcome: Outcome) -> Outcome {
    if spec.reference.is_some() && outcome.verdict != Verdict::NotChecked {
        let start = if outcome.name == "deadline" { "; x0_max bounds it at the start" } else { "" };
        let n = spec.n;
        outcome.details.push(format!(
            "x is the tracking error, x_i - r^(i-1){start}; u stands for what the law adds to r^({n})"
        ));
    }
    outcome
}

/// The checks of a controller in samples. Its loop is exact at any period, so what looks for the
/// error of a period or of eps has nothing to say.
fn in_samples(spec: &Spec) -> Report {
    let continuous = Spec { n: spec.loop_order(), clock: Clock::Time, ..spec.clone() };
    if spec.what == What::Observer {
        let alone =
            |name: &&'static str| Outcome::not_checked(name, "an observer alone has no law");
        let mut outcomes = vec![membership(&continuous)];
        outcomes.extend(CHECKS[1..].iter().filter(|name| **name != zeros::NAME).map(alone));
        return Report {
            spec: spec.clone(),
            expanded: None,
            outcomes,
            greatest: None,
            worst: None,
        };
    }
    let (growth, _) = check_growth(&continuous);
    let exact = |name| Outcome::not_checked(name, "the law is exact in samples, at any period");
    let known = |p: &Parameter| spec.fixed.contains_key(p);
    let open = spec.parameters().into_iter().find(|p| *p != Parameter::UMax && !known(p));
    let (looped, worst) = match open {
        Some(open) => {
            let reason = format!("`{}` is left to run time", open.spelling());
            (Outcome::not_checked(sampled::NAME, reason), None)
        }
        None => sampled::outcome(spec, None),
    };
    let lacks = |name| Outcome::not_checked(name, "it does not examine a clock in samples");
    let outcomes = vec![
        membership(&continuous),
        growth,
        exact("sampling"),
        exact("deadline"),
        looped,
        lacks("envelope"),
    ];
    Report { spec: spec.clone(), expanded: None, outcomes, greatest: None, worst }
}

/// A statement of the limit for short periods without noise, which decides nothing where the loop
/// itself is decided. What follows the deadline is for `sampling` to judge.
fn superseded(outcome: Outcome, decided: bool) -> Outcome {
    if !decided || outcome.verdict == Verdict::NotChecked {
        return outcome;
    }
    let summary =
        format!("`loop` decides; without noise and for short periods {}", outcome.summary);
    Outcome { verdict: Verdict::NotChecked, summary, fix: None, ..outcome }
}

/// Where eps is open and something disturbs the loop, the eps whose worst final error is least.
fn choose_eps(spec: &mut Spec, expanded: Option<&Expanded>) {
    let promises = &spec.promises;
    let disturbed = !promises.noise.is_empty()
        || !promises.sensor_step.is_empty()
        || promises.u_step.is_some()
        || matches!(promises.plant, Some(PlantBounds::Bounded { .. }));
    let open = !spec.fixed.contains_key(&Parameter::Eps);
    if !disturbed || !open || known::lacking(spec).is_some() {
        return;
    }
    let closed = Loop::new(spec, expanded).ok();
    let best = closed.and_then(|closed| closed.best_eps(&Numbers::new(spec, expanded)));
    if let Some(eps) = best.and_then(known::rounded_down) {
        spec.fixed.insert(Parameter::Eps, eps);
    }
}

fn membership(spec: &Spec) -> Outcome {
    let Some(custom) = spec.custom() else {
        return Outcome {
            name: "membership",
            verdict: Verdict::Sound,
            summary: format!("{} is of class M for all its parameters", spec.mapping_name()),
            details: Vec::new(),
            fix: None,
        };
    };
    let ranges = |parameter| {
        let exact = |value: &Fixed| value.number().cloned();
        match (spec.fixed.get(&parameter), spec.bounds.get(&parameter)) {
            (Some(value), _) => exact(value).map(|value| (value.clone(), value)),
            (None, Some((least, greatest))) => exact(least).zip(exact(greatest)),
            (None, None) => None,
        }
    };
    Outcome::from(&bounded(|| prove(custom, spec.n, &ranges)))
}

/// What the gains do at the deadline; where the rate is left to run time, the greatest with which
/// they do it.
fn check_growth(spec: &Spec) -> (Outcome, Option<(Parameter, Fixed)>) {
    let lacks = |reason: &str| (Outcome::not_checked("growth", reason), None);
    if spec.feedback != Feedback::Linear {
        return lacks("the law is not a sum of gains, so its poles are not known");
    }
    let Some(gains) = fixed_gains(spec) else {
        return lacks("the gains are left to run time: their poles must lie left of -n rho");
    };
    // A pole that fails for the slowest mapping fails for every one.
    let at_rest = growth(&gains, &crate::algebra::integer(0), Modes::Other);
    let Decay { rate, modes } = decay(spec);
    let known = matches!(rate, Rate::Exact(_) | Rate::Between(..));
    if !known && !at_rest.x_to_zero {
        return (Outcome::from(&at_rest), None);
    }
    let told = |growth: Growth| {
        let rate = if spec.custom().is_some() { "a decay rate" } else { growth.rate };
        (Outcome::from(&Growth { rate, ..growth }), None)
    };
    match rate {
        Rate::Exact(rate) => told(growth(&gains, &rate, modes)),
        Rate::Between(low, high, spelling) => match growth_between(&gains, [&low, &high], modes) {
            Some(found) => told(Growth { spelling, ..found }),
            None => {
                let rho = spelling.map_or_else(
                    || "the parameters".to_owned(),
                    |spelling| format!("rho = {spelling}"),
                );
                (growth::open(&rho), None)
            }
        },
        Rate::Infinite => (growth::too_fast(spec.n), None),
        Rate::NotFound => (growth::without_rate(at_rest.largest_rho), None),
        Rate::Open => {
            let Some(limit) = at_rest.largest_rho else {
                return lacks("the rate is left to run time, and none is slow enough");
            };
            let text = super::digits(limit);
            let share = match spec.family() {
                Some(Family::Exp) => Some(1.0),
                Some(Family::Tanh) => Some(0.5),
                _ => None,
            };
            let greatest = share.and_then(|share| known::rounded_down(share * limit));
            let by = if greatest.is_some() { "; init refuses more" } else { "" };
            let (outcome, _) = lacks(&format!(
                "the rate is left to run time: x and u go to 0 where mu' decays at a rate of at most {text}{by}"
            ));
            (outcome, greatest.map(|greatest| (Parameter::A, greatest)))
        }
    }
}

/// A period that is judged for a chain with f = 0 says nothing sound of a law whose f, or reference,
/// moves between the samples at which it is known.
fn of_chain_alone(spec: &Spec, outcome: Outcome) -> Outcome {
    let moves = spec.model.is_some() || spec.drift.as_ref().is_some_and(|f| f.number().is_none());
    let follows = spec.reference.as_ref().is_some_and(Reference::moves);
    if !(moves || follows) || outcome.verdict != Verdict::Sound {
        return outcome;
    }
    let (what, still) = match (moves, follows) {
        (true, false) => ("f is cancelled", "f = 0"),
        (false, _) => ("r is known", "a constant r"),
        (true, true) => ("f and r are known", "f = 0 and a constant r"),
    };
    let summary = format!("{what} at the samples alone; with {still}: {}", outcome.summary);
    Outcome { verdict: Verdict::Undecided, summary, ..outcome }
}

/// What the sample period and the wanted error ask of eps; sets it where the design leaves it open.
fn guard(spec: &mut Spec, expanded: Option<&Expanded>) -> (Outcome, Outcome) {
    let number = |value: &Option<Fixed>| value.as_ref().and_then(known::to_f64);
    let period = number(&spec.promises.sample_time);
    // The smallest one bounds every state.
    let errors = spec.promises.error.iter().filter_map(known::to_f64);
    let error = errors.reduce(f64::min);
    let unasked = |name, key: &str| Outcome::not_checked(name, format!("`{key}` is not given"));
    let lacking = known::lacking(spec);
    let lacks = |name| {
        let reason = match &lacking {
            Some(lacking) => format!("it needs {lacking}"),
            None => String::new(),
        };
        Outcome::not_checked(name, reason)
    };
    if period.is_none() && error.is_none() {
        return (unasked("sampling", "sample_time"), unasked("deadline", "error"));
    }
    if lacking.is_some() {
        return (lacks("sampling"), lacks("deadline"));
    }
    let numbers = Numbers::new(spec, expanded);
    let tau = numbers.tau;
    let sampled = period.map(|period| sampling(&|t| numbers.gains(t), period, tau));
    let bounds: Vec<_> = spec.promises.x0_max.iter().filter_map(known::to_f64).collect();
    let ended = error.map(|error| {
        let gains = numbers.feedback();
        let closed_loop = ClosedLoop {
            gains: &gains,
            tau,
            r: &|t| numbers.r(t),
            stretched: &|t| numbers.stretched(t),
        };
        deadline(&closed_loop, &bounds, error)
    });
    if let Entry::Vacant(open) = spec.fixed.entry(Parameter::Eps) {
        // The largest eps is the gentlest on noise; the period then only has to tolerate it.
        let wanted = ended.as_ref().and_then(|ended| ended.largest_eps.filter(|eps| *eps < tau));
        let eps = wanted.or(sampled.as_ref().and_then(|sampled| sampled.default_eps));
        if let Some(fixed) = eps.and_then(known::rounded_down) {
            open.insert(fixed);
        }
    }
    let eps = spec.fixed.get(&Parameter::Eps).and_then(known::to_f64);
    (
        sampled.map_or_else(
            || unasked("sampling", "sample_time"),
            |s| of_chain_alone(spec, s.outcome(eps)),
        ),
        ended.map_or_else(|| unasked("deadline", "error"), |d| d.outcome(eps)),
    )
}

fn envelope(spec: &Spec, expanded: Option<&Expanded>) -> Outcome {
    let lacks = |reason: String| Outcome::not_checked("envelope", reason);
    if spec.promises.x_max.is_empty() {
        return lacks("`x_max` is not given".to_owned());
    }
    if spec.what == What::Associated {
        return lacks("the infinite-time system has no deadline".to_owned());
    }
    if spec.reference.is_some() {
        return lacks("it does not examine a reference".to_owned());
    }
    if spec.feedback == Feedback::Extern {
        return lacks("the law is user-defined, and its range is unknown".to_owned());
    }
    let open = |p: &Parameter| {
        !matches!(p, Parameter::UMax | Parameter::StartTime)
            && !is_known(spec, *p)
            && !spec.bounds.contains_key(p)
    };
    if let Some(open) = spec.parameters().into_iter().find(open) {
        return lacks(format!("`{}` is left to run time without bounds", open.spelling()));
    }
    let law = Law::from(spec, expanded);
    let program = passes::optimise(lower(spec, &law), &mut |_, _| {});
    let round = |value: &Fixed| {
        value.number().map_or(f64::INFINITY, |value| number::round(value, spec.precision))
    };
    let parameter = |p: Parameter| match (spec.fixed.get(&p), spec.bounds.get(&p)) {
        (Some(value), _) if p != Parameter::UMax => Interval::point(round(value)),
        (_, Some((least, greatest))) => Interval::new(round(least), round(greatest)),
        _ => Interval::point(0.0),
    };
    let around = |bounds: &[Fixed], j: usize| {
        bounds.get(j - 1).map(|bound| Interval::new(-round(bound), round(bound)))
    };
    let promises = &spec.promises;
    let input = |input: Input| match input {
        Input::Parameter(p) => parameter(p),
        Input::StartTime => parameter(Parameter::StartTime),
        Input::State(j) => around(&promises.x_max, j).unwrap_or(Interval::ANY),
        Input::StateAtStart(j) => around(&promises.x0_max, j)
            .or_else(|| around(&promises.x_max, j))
            .unwrap_or(Interval::ANY),
        Input::Time | Input::Reference(_) | Input::Gain(_) | Input::Drift | Input::Control => {
            Interval::ANY
        }
    };
    let (eps, tau) = (parameter(Parameter::Eps).low, parameter(Parameter::Tau).high);
    let pieces = (PIECES * (tau / eps).log10()).clamp(1.0, 400.0);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    Outcome::from(&scan(&program, &input, eps, tau, pieces.ceil() as u32))
}

/// The key of the spec that decides a check.
fn deciding_key(spec: &Spec, check: &str) -> &'static str {
    match check {
        "membership" if spec.custom().is_some_and(|c| c.subject.key() == "kappa") => "kappa",
        "membership" => "mu",
        "growth" if !spec.poles.is_empty() => "poles",
        "growth" => "gains",
        "envelope" => "x_max",
        zeros::NAME => "output",
        _ if spec.fixed.contains_key(&Parameter::Eps) => "eps",
        "sampling" => "sample_time",
        _ => "error",
    }
}
