//! Numbers on the command line of a simulation.

use std::ops::Range;

use crate::algebra::BigRational;
use crate::diagnostic::counted;
use crate::limits::SAMPLES;
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;
use crate::simulate::record::{Asked, instant};
use crate::simulate::{Change, Event, Loop};
use crate::syntax::number;
use num_traits::{Signed, ToPrimitive};

use super::args::Simulate;
use crate::cli::report::{Failure, Notice, Quote};

/// Reads the flags, for the run from `x0`: what is asked of it, and the sampled loop, if selected.
pub(super) fn read(
    request: &Simulate,
    x0: &str,
    spec: &Spec,
    events: &[Event],
) -> Result<(Asked, Option<Loop>), Failure> {
    let states = spec.state_names();
    let x0 = List::new("--x0", x0)?;
    let rest = states.len().saturating_sub(x0.items.len());
    if x0.items.len() > states.len() || rest != 0 && rest != spec.states_at_rest() {
        let message = format!(
            "--x0 has {} for {}",
            counted(&x0.items.len(), "number"),
            counted(&states.len(), "state")
        );
        let help =
            format!("give one number for each of {}, separated by commas", states.join(", "));
        return Err(x0.wrong(None, message, &help));
    }
    let around = around(request, spec, events)?;
    if around.is_none() && !events.is_empty() {
        return Err(Failure::because(
            "the events of the design need the sampled loop".to_owned(),
            "give --sample-time, or a clock in samples",
        ));
    }
    for (flag, given) in [("--until", &request.until), ("--arm-at", &request.arm_at)] {
        if let (None, Some(given)) = (&around, given) {
            let message = format!("{flag} needs the sampled loop");
            let help = "give --sample-time, or a clock in samples: the law itself ends at the deadline, where its gains are infinite";
            return Err(List::new(flag, given)?.wrong(None, message, help));
        }
    }
    let fraction = request.at_fraction.as_deref().map(|text| (FRACTION, text));
    let at = fraction.or(request.at_time.as_deref().map(|text| (TIME, text)));
    let at = at.map(|(flag, text)| List::new(flag, text)).transpose()?;
    if let (Some(at), Some(_)) = (&at, &around) {
        let message = format!("{} gives instants between the samples", at.flag);
        let help = format!(
            "the sampled loop reports every sample: leave {} out, or the flags of the sampled loop",
            at.flag
        );
        return Err(at.wrong(None, message, &help));
    }
    let tau = spec.fixed.get(&Parameter::Tau).and_then(Fixed::number);
    let at = at.as_ref().map(|at| instants(at, tau)).transpose()?.unwrap_or_default();
    let whole = at.is_empty() || request.plot.is_some() || request.report.is_some();
    let mut x0 = x0.doubles()?;
    x0.resize(states.len(), 0.0);
    Ok((Asked { x0, at, whole }, around))
}

/// The flags of instants, as fractions of tau and in s.
const FRACTION: &str = "--at-fraction";
const TIME: &str = "--at-time";

/// Returns the instants of a list; none without tau, which the run lacks too.
fn instants(at: &List<'_>, tau: Option<&BigRational>) -> Result<Vec<(f64, f64)>, Failure> {
    let in_seconds = at.flag == TIME;
    let Some(tau) = tau else { return Ok(Vec::new()) };
    let share = |(value, range): &(BigRational, Range<usize>)| {
        let elapsed = if in_seconds { value / tau } else { value.clone() };
        instant(&elapsed).ok_or_else(|| match in_seconds {
            true => {
                let tau = tau.to_f64().unwrap_or(f64::NAN);
                let message = format!("a time outside [0, tau), tau = {tau} s");
                let help = "0 is the start; at the deadline, tau, the gains are infinite";
                at.wrong(Some(range), message, help)
            }
            false => {
                let message = "a fraction of tau outside [0, 1)".to_owned();
                let help = format!(
                    "0 is the start, and 1 the deadline, where the gains are infinite; for times in s write {TIME} {}",
                    at.text
                );
                at.wrong(Some(range), message, &help)
            }
        })
    };
    at.items.iter().map(share).collect()
}

/// Returns a note where a run starts outside the box of the design; its reference does not move the chain.
pub(super) fn outside(spec: &Spec, x0: &[f64]) -> Option<String> {
    let bounds = &spec.promises.x0_max;
    // Of a model, and with a reference, x0_max bounds other numbers than x0.
    if spec.has_model() || spec.reference.is_some() || bounds.is_empty() {
        return None;
    }
    let names = spec.state_names();
    let beyond = |(j, x): (usize, &f64)| {
        let bound = &bounds[j % bounds.len()];
        let most = bound.number()?.to_f64()?;
        (x.abs() > most)
            .then(|| format!("|{}| = {} > {bound}", names.get(j).map_or("x", |n| n), x.abs()))
    };
    let all: Vec<_> = x0.iter().enumerate().filter_map(beyond).collect();
    let told = format!("--x0 is outside x0_max of the design: {}", all.join(", "));
    (!all.is_empty()).then_some(told)
}

/// The sampled loop, if the design or a flag gives what it needs.
fn around(request: &Simulate, spec: &Spec, events: &[Event]) -> Result<Option<Loop>, Failure> {
    let at = request.at_fraction.is_some() || request.at_time.is_some();
    let between = at && !request.spec.0.gives("sample_time");
    let Some(asked) = Loop::asked(spec, between) else { return Ok(None) };
    let Some(around) = Loop::of(spec) else {
        return Err(Failure::because(
            format!("`{asked}` needs the sampled loop, which has no sample period"),
            "give --sample-time, or sample_time in the design",
        ));
    };
    let until = request.until.as_deref().map(end).transpose()?;
    let arm_at = request.arm_at.as_deref().map(List::times).transpose()?.unwrap_or_default();
    let arm = |at| Event { at, change: Change::Arm };
    let events = events.iter().copied().chain(arm_at.into_iter().map(arm)).collect();
    let around = Loop { seed: request.seed, until, events, ..around };
    if let Some(message) = around.too_long(spec) {
        return Err(Failure::because(message, SAMPLES.fix));
    }
    Ok(Some(around))
}

/// The time at which a run ends.
fn end(text: &str) -> Result<f64, Failure> {
    let list = List::new("--until", text)?;
    match list.doubles()?.as_slice() {
        [end] if *end > 0.0 => Ok(*end),
        _ => Err(list.wrong(
            None,
            "--until is not one time > 0".to_owned(),
            "give the time after t0 at which the run ends, in s",
        )),
    }
}

/// Numbers separated by commas, with their places in the text.
struct List<'a> {
    flag: &'static str,
    text: &'a str,
    items: Vec<(BigRational, Range<usize>)>,
}

impl<'a> List<'a> {
    fn new(flag: &'static str, text: &'a str) -> Result<Self, Failure> {
        let mut list = Self { flag, text, items: Vec::new() };
        let mut start = 0;
        for item in text.split(',') {
            let range = start..start + item.len();
            start = range.end + 1;
            let value = number(item.trim()).and_then(|value| value.number().cloned());
            let Some(value) = value else {
                let message = format!("{flag} holds `{item}`, which is not a number");
                return Err(list.wrong(
                    Some(&range),
                    message,
                    "give decimal numbers separated by commas, for example 1,-0.5,0",
                ));
            };
            list.items.push((value, range));
        }
        Ok(list)
    }

    /// The times of `--arm-at`.
    fn times(text: &'a str) -> Result<Vec<f64>, Failure> {
        let list = Self::new("--arm-at", text)?;
        let negative = list.items.iter().find(|(value, _)| value.is_negative());
        if let Some((_, range)) = negative {
            let message = "a time before t0".to_owned();
            return Err(list.wrong(Some(range), message, "give times after t0, in s"));
        }
        list.doubles()
    }

    /// The items rounded to doubles.
    fn doubles(&self) -> Result<Vec<f64>, Failure> {
        let one = |(value, range): &(BigRational, Range<usize>)| {
            let near = value.to_f64().filter(|near| near.is_finite());
            near.ok_or_else(|| {
                let message = format!("{} holds a number outside the range of f64", self.flag);
                self.wrong(Some(range), message, "give a number within 1.7e308")
            })
        };
        self.items.iter().map(one).collect()
    }

    /// A mistake in one of the items, or in all.
    fn wrong(&self, range: Option<&Range<usize>>, title: String, help: &str) -> Failure {
        let before = self.flag.len() + 2;
        let range = range.cloned().unwrap_or(0..self.text.len());
        let line = self.text.replace(|c: char| c.is_ascii_control(), " ");
        let quote = Quote {
            file: None,
            text: format!("{} \"{line}\"", self.flag),
            range: before + range.start..before + range.end,
            label: "not legal",
        };
        Failure::bad_input(vec![Notice {
            code: Some("bad-value"),
            quote: Some(quote),
            help: Some(help.to_owned()),
            ..Notice::of(title)
        }])
    }
}
