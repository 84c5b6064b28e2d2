//! The self-test of a controller in C: tables of calls, and the function that runs them.

use askama::Template;

use super::apart::apart;
use super::outline::Outline;
use super::{Controller, File, Language, code, declared, program, text_of, tidy};
use crate::parameter::Precision;
use crate::program::number;
use crate::reference::tolerance;
use crate::request::{After, Feedback, Guard, Spec};
use crate::selftest::{Always, Call, SelfTest, Session, Unreachable};

/// The header and the source.
pub(super) fn files(controller: &Controller<'_>, test: &SelfTest) -> Vec<File> {
    let spec = controller.spec();
    let name = spec.name();
    let numbers = Numbers { spec };
    let program = program(controller, Language::C);
    let frame = Outline::new(controller.spec(), &program);
    let tests = (code::start_tests(&program), code::zero_tests(&program));
    let unreachable = wrapped(&test.unreachable, &tests);
    let header = Header {
        name: &name,
        command: &spec.command(),
        version: env!("CARGO_PKG_VERSION"),
        sessions: test.sessions.len(),
        calls: test.sessions.iter().map(|session| session.calls.len()).sum(),
        refused: test.refused.len(),
        digits: crate::reference::DIGITS,
        tolerance: &format!("{:e}", tolerance::of(spec)),
        unreachable: &unreachable,
    };
    let calls: Vec<_> = test.sessions.iter().flat_map(|session| &session.calls).collect();
    let suffix = if spec.precision == Precision::F32 { "f" } else { "" };
    let has_gains = controller.program.axis.is_some();
    let mut first = 0;
    let sessions: Vec<_> = test
        .sessions
        .iter()
        .map(|session| {
            let text = numbers.session(session, first);
            first += session.calls.len();
            text
        })
        .collect();
    let source = Source {
        name: &name,
        abs: format!("fabs{suffix}"),
        eighth: numbers.number(0.125),
        three_halves: numbers.number(1.5),
        poison: numbers.number(12345.0),
        largest: numbers.number(match spec.precision {
            Precision::F64 => f64::MAX,
            Precision::F32 => f64::from(f32::MAX),
        }),
        pi0: format!("{name}_selftest_pi0"),
        after: format!("{name}_selftest_after"),
        is_after: spec.after == After::Extern,
        has_context: spec.after == After::Extern || spec.feedback == Feedback::Extern,
        has_gains,
        tau_is_kept: test.tau_is_kept,
        sessions: &sessions,
        calls: &calls.iter().map(|call| numbers.call(call, has_gains)).collect::<Vec<_>>(),
        refused: &test.refused.iter().map(|set| numbers.parameters(set)).collect::<Vec<_>>(),
        states: &test
            .refused_states
            .iter()
            .map(|(start, x0)| format!("{}, {}", numbers.list(x0), numbers.number(*start)))
            .collect::<Vec<_>>(),
        frame: &frame,
    };
    [
        (format!("{name}_selftest.h"), header.render()),
        (format!("{name}_selftest.c"), source.render()),
    ]
    .into_iter()
    .map(|(file, text)| apart(File { name: file, text: tidy(&text_of(text)) }, &name))
    .collect()
}

/// The conditions with their reasons in lines of a comment.
fn wrapped(
    all: &[Unreachable],
    ([init, arm], zero): &([Vec<String>; 2], Vec<Vec<String>>),
) -> Vec<(String, String)> {
    let wrap = |one: &Unreachable| {
        let condition = match &one.condition {
            Always::Init(at) => init[*at].clone(),
            Always::Arm(at) => arm[*at].clone(),
            Always::NotZero(at, factor) => zero[*at][*factor].clone(),
            Always::Written(text) => text.clone(),
        };
        let mut reason = String::new();
        let mut column = condition.len() + 6;
        for word in one.reason.split(' ') {
            if column + word.len() > 96 {
                reason.push_str("\n *    ");
                column = 6;
            }
            reason.push_str(if reason.is_empty() { "" } else { " " });
            reason.push_str(word);
            column += word.len() + 1;
        }
        (condition, reason)
    };
    all.iter().map(wrap).collect()
}

/// Numbers of one precision as constants of C.
struct Numbers<'a> {
    spec: &'a Spec,
}

impl Numbers<'_> {
    fn number(&self, value: f64) -> String {
        let (real, suffix) = match self.spec.precision {
            Precision::F32 => ("float", "f"),
            Precision::F64 => ("double", ""),
        };
        let sign = if value.is_sign_negative() { "-" } else { "" };
        match value {
            _ if value.is_nan() => format!("({real})NAN"),
            _ if value.is_infinite() => format!("{sign}({real})INFINITY"),
            _ => format!("{sign}{}{suffix}", number::literal(value.abs(), self.spec.precision)),
        }
    }

    fn list(&self, values: &[f64]) -> String {
        values.iter().map(|value| self.number(*value)).collect::<Vec<_>>().join(", ")
    }

    /// The fields of the parameters, by name.
    fn parameters(&self, values: &[f64]) -> String {
        let mut rest = values;
        let mut fields = Vec::new();
        for field in declared(self.spec, Language::C) {
            let (own, others) = rest.split_at(field.shape.length().unwrap_or(1).min(rest.len()));
            rest = others;
            let list = self.list(own);
            let value = if field.shape.length().is_some() { format!("{{ {list} }}") } else { list };
            fields.push(format!(".{} = {value}", field.name));
        }
        if fields.is_empty() { ".none = (char)0".to_owned() } else { fields.join(", ") }
    }

    fn session(&self, session: &Session, first: usize) -> String {
        let mut fields = vec![format!(".params = {{ {} }}", self.parameters(&session.parameters))];
        if !session.x0.is_empty() {
            fields.push(format!(".x0 = {{ {} }}", self.list(&session.x0)));
        }
        fields.extend([
            format!(".t0 = {}", self.number(session.again.unwrap_or(0.0))),
            format!(".is_armed_again = {}U", u8::from(session.again.is_some())),
            format!(".first = {first}U"),
            format!(".count = {}U", session.calls.len()),
        ]);
        fields.join(", ")
    }

    fn call(&self, call: &Call, has_gains: bool) -> String {
        let mut fields = vec![
            format!(".t = {}", self.number(call.t)),
            format!(".x = {{ {} }}", self.list(&call.x)),
            format!(".u = {}", self.number(call.u)),
            format!(".tolerance = {}", self.number(call.tolerance)),
            format!(".status = {}", call.status.c_name()),
        ];
        if has_gains {
            fields.push(format!(".axis = {}", call.axis.unwrap_or(call.status).c_name()));
            fields.push(format!(".has_axis = {}U", u8::from(call.axis.is_some())));
        }
        fields.join(", ")
    }
}

#[derive(Template)]
#[template(path = "selftest.h.txt", escape = "none")]
struct Header<'a> {
    name: &'a str,
    command: &'a str,
    version: &'static str,
    sessions: usize,
    calls: usize,
    refused: usize,
    digits: usize,
    tolerance: &'a str,
    /// Conditions that always hold, with the reasons.
    unreachable: &'a [(String, String)],
}

#[derive(Template)]
#[template(path = "selftest.c.txt", escape = "none")]
struct Source<'a> {
    name: &'a str,
    abs: String,
    eighth: String,
    three_halves: String,
    /// What u is before a call, which must overwrite it.
    poison: String,
    /// The greatest finite number.
    largest: String,
    /// The functions that stand for the user's.
    pi0: String,
    after: String,
    is_after: bool,
    has_context: bool,
    has_gains: bool,
    tau_is_kept: bool,
    /// The fields of each entry of the tables.
    sessions: &'a [String],
    calls: &'a [String],
    refused: &'a [String],
    states: &'a [String],
    frame: &'a Outline,
}
