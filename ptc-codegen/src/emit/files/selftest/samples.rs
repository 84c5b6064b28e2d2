//! The self-test of a controller in samples, or of an observer alone.

use askama::Template;

use super::commands::Commands;
use super::numbers::Numbers;
use super::{About, both, suffix};
use crate::code::Code;
use crate::emit::File;
use crate::emit::files::c;
use crate::emit::files::outline::Outline;
use crate::request::{Guard, Spec};
use crate::selftest::samples::{Call, SelfTest, Session};

/// Origin of the expected values.
const EXPECTED: [&str; 2] = [
    "computed by the generator, which runs this very program in the arithmetic of IEEE 754: the",
    "operations are its own alone, so that a target has to give the same numbers.",
];

/// The header and the source.
pub(in crate::emit) fn files(spec: &Spec, code: &Code, test: &SelfTest) -> Vec<File> {
    let name = spec.name();
    let numbers = Numbers::new(spec, code);
    let about = About {
        sessions: test.sessions.len(),
        calls: test.sessions.iter().map(|session| session.calls.len()).sum(),
        refused: test.refused.len(),
        subject: "values were",
        expected: &EXPECTED.map(str::to_owned),
        unreachable: test
            .untaken
            .iter()
            .map(|one| (c::written(code, &one.condition), one.reason.clone()))
            .collect(),
    };
    let mut first = 0;
    let session = |session: &Session| {
        let (from, count) = (first, session.calls.len());
        first += count;
        let parameters = numbers.parameters(&session.parameters);
        format!(".params = {{{parameters}}}, .first = {from}U, .count = {count}U")
    };
    let sessions: Vec<_> = test.sessions.iter().map(session).collect();
    let calls = test.sessions.iter().flat_map(|session| &session.calls);
    let estimate = |name: &str| {
        let result = code.function(name).and_then(|function| function.results.first());
        result.map(|result| result.shape.length().unwrap_or(1))
    };
    let states = estimate("estimate");
    let measured = spec.sampled().map_or(0, |sampled| sampled.measured);
    let commands = Commands::of(code);
    let source = Source {
        name: &name,
        noun: code.noun(),
        abs: format!("fabs{}", suffix(spec)),
        poison: numbers.number(12345.0),
        dimension: spec.axes.as_ref().map(|axes| format!("[{}]", axes.count)).unwrap_or_default(),
        result: if spec.axes.is_some() { "u" } else { "&u" },
        shape: match spec.rows_of_axes() {
            Some((count, n)) => format!("[{count}][{n}]"),
            None => format!("[{measured}]"),
        },
        alone: code.function("update").is_some(),
        states,
        disturbance: estimate("disturbance").is_some(),
        sessions: &sessions,
        calls: &calls
            .map(|call| {
                let own = numbers.sample(call, measured, states.unwrap_or(0), spec);
                let before = call.before.as_ref().map(|before| numbers.command(before, &commands));
                before.into_iter().chain([own]).collect::<Vec<_>>().join(", ")
            })
            .collect::<Vec<_>>(),
        refused: &test.refused.iter().map(|set| numbers.parameters(set)).collect::<Vec<_>>(),
        has_parameters: !code.parameters.is_empty(),
        commands: &commands,
        frame: &Outline::new(spec, code),
    };
    both(spec, &about, source.render())
}

impl Numbers<'_> {
    /// A call that is given so many measured values, those of axes in rows, and then the reference, that of
    /// each output in a row, and whose estimates are those of `states` states, and then that of the disturbance.
    fn sample(&self, call: &Call, measured: usize, states: usize, spec: &Spec) -> String {
        let (y, r) = call.y.split_at(measured);
        let rows = |values: &[f64], length: Option<usize>| match length {
            Some(length) => {
                let row = |row: &[f64]| format!("{{{}}}", self.list(row));
                values.chunks(length).map(row).collect::<Vec<_>>().join(", ")
            }
            None => self.list(values),
        };
        let y = rows(y, spec.rows_of_axes().map(|(_, n)| n));
        let mut fields = vec![
            format!(".is_armed = {}U", u8::from(call.start.is_some())),
            format!(".start = {}U", call.start.unwrap_or(0)),
            format!(".k = {}U", call.k),
            format!(".y = {{{y}}}"),
        ];
        if !r.is_empty() {
            let row = spec.axes.as_ref().map(|_| spec.references());
            fields.push(format!(".r = {{{}}}", rows(r, row)));
        }
        fields.extend(call.applied.map(|u| format!(".applied = {}", self.number(u))));
        fields.push(format!(".status = {}", c::word(call.status)));
        fields.extend(match call.axes.as_slice() {
            [] => call.u.first().map(|u| format!(".u = {}", self.number(*u))),
            axes => {
                let axes: Vec<_> = axes.iter().map(|status| c::word(*status)).collect();
                Some(format!(".u = {{{}}}, .axes = {{{}}}", self.list(&call.u), axes.join(", ")))
            }
        });
        let (xhat, d) = call.estimates.split_at(states.min(call.estimates.len()));
        if !xhat.is_empty() {
            fields.push(format!(".xhat = {{{}}}", self.list(xhat)));
        }
        fields.extend(d.first().map(|d| format!(".d = {}", self.number(*d))));
        fields.join(", ")
    }
}

#[derive(Template)]
#[template(path = "selftest/samples.c.txt", escape = "none")]
struct Source<'a> {
    name: &'a str,
    noun: &'static str,
    abs: String,
    /// Value of a result before a call, which must overwrite it.
    poison: String,
    /// Array dimension behind u where there are several, and u as an argument.
    dimension: String,
    result: &'static str,
    /// The shape of what is measured.
    shape: String,
    /// True for a stand-alone observer.
    alone: bool,
    /// States that are estimated; `None` without an observer.
    states: Option<usize>,
    /// True if the disturbance is estimated.
    disturbance: bool,
    /// The fields of each entry of the tables.
    sessions: &'a [String],
    calls: &'a [String],
    refused: &'a [String],
    has_parameters: bool,
    /// The functions of a deadline in flight.
    commands: &'a Commands,
    frame: &'a Outline,
}
