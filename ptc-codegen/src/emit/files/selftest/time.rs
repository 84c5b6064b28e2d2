//! The self-test of a controller in time.

use askama::Template;

use super::numbers::Numbers;
use super::{About, both, suffix};
use crate::controller::Controller;
use crate::emit::files::c;
use crate::emit::files::outline::Outline;
use crate::emit::files::program;
use crate::emit::{File, Language};
use crate::reference::tolerance;
use crate::request::{After, Feedback, Guard, Spec};
use crate::selftest::{Always, Call, SelfTest, Session, Wanted};

/// The header and the source.
pub(in crate::emit) fn files(controller: &Controller<'_>, test: &SelfTest) -> Vec<File> {
    let spec = controller.spec();
    let name = spec.name();
    let program = program(controller, Language::C);
    let numbers = Numbers::new(spec, &program);
    let frame = Outline::new(controller.spec(), &program);
    let tests = (c::start_tests(&program), c::zero_tests(&program));
    let about = About {
        sessions: test.sessions.len(),
        calls: test.sessions.iter().map(|session| session.calls.len()).sum(),
        refused: test.refused.len(),
        subject: "u was",
        expected: &expected(spec),
        unreachable: test
            .unreachable
            .iter()
            .map(|one| (text(&one.condition, &tests), one.reason.clone()))
            .collect(),
    };
    let calls: Vec<_> = test.sessions.iter().flat_map(|session| &session.calls).collect();
    let has_gains = has_gains(controller);
    let mut first = 0;
    let sessions: Vec<_> = test
        .sessions
        .iter()
        .map(|session| {
            let text = numbers.session(session, first, controller.program.in_flight);
            first += session.calls.len();
            text
        })
        .collect();
    let source = Source {
        name: &name,
        abs: format!("fabs{}", suffix(spec)),
        eighth: numbers.number(0.125),
        three_halves: numbers.number(1.5),
        sixteenth: numbers.number(0.0625),
        laws: spec.laws_at_once(),
        chains: spec.coupled.as_ref().map_or(spec.n, |coupled| coupled.orders().iter().sum()),
        poison: numbers.number(12345.0),
        largest: numbers.number(spec.precision.greatest()),
        pi0: format!("{name}_selftest_pi0"),
        after: format!("{name}_selftest_after"),
        result: if spec.axes.is_some() { "u" } else { "&u" },
        is_after: spec.after == After::Extern,
        has_context: spec.after == After::Extern || spec.feedback == Feedback::Extern,
        has_gains,
        has_axes: controller.program.axis.is_some() && spec.axes.is_some(),
        axis_pointers: pointers(spec),
        numbers_axes: program.numbers_axes(),
        tau_is_kept: test.tau_is_kept,
        in_flight: controller.program.in_flight,
        durations: &test
            .refused_durations
            .iter()
            .map(|tau| numbers.number(*tau))
            .collect::<Vec<_>>(),
        sessions: &sessions,
        calls: &calls.iter().map(|call| numbers.call(call, spec, has_gains)).collect::<Vec<_>>(),
        refused: &test.refused.iter().map(|set| numbers.parameters(set)).collect::<Vec<_>>(),
        states: &test
            .refused_states
            .iter()
            .map(|(start, x0)| format!("{}, {}", numbers.list(x0), numbers.number(*start)))
            .collect::<Vec<_>>(),
        frame: &frame,
    };
    both(spec, &about, source.render())
}

/// Returns true if `tick` and `axis` are called besides `step`; with several axes each call compares `step` with them.
fn has_gains(controller: &Controller<'_>) -> bool {
    controller.program.axis.is_some() && controller.spec().axes.is_none()
}

/// The arguments of `axis`, each time with one of them missing.
fn pointers(spec: &Spec) -> Vec<[&'static str; 4]> {
    let whole = ["&gains", "call.x[0]", "call.r[0]", "&own"];
    let given = (0..whole.len()).filter(|at| *at != 2 || spec.references() > 0);
    let without = |at: usize| {
        let mut lacking = whole;
        lacking[at] = "NULL";
        lacking
    };
    given.map(without).collect()
}

/// Describes the origin of the expected u.
fn expected(spec: &Spec) -> [String; 2] {
    [
        format!(
            "computed from the definition of the controller with {} or more digits; its tolerance is",
            crate::reference::DIGITS
        ),
        format!("{:e} of the sum of the absolute values of its terms.", tolerance::of(spec)),
    ]
}

/// The tests of `init`, `arm` and `arm_for`, and of the factors in `init` and in `arm_for`, in C.
type Tests = ([Vec<String>; 3], [Vec<Vec<String>>; 2]);

/// The text of a condition.
fn text(always: &Always, ([init, arm, arm_for], zeros): &Tests) -> String {
    match always {
        Always::Init(at) => init[*at].clone(),
        Always::Arm(at) => arm[*at].clone(),
        Always::ArmFor(at) => arm_for[*at].clone(),
        Always::NotZero(at, factor) => zeros[0][*at][*factor].clone(),
        Always::NotZeroFor(at, factor) => zeros[1][*at][*factor].clone(),
        Always::Written(text) => text.clone(),
    }
}

impl Numbers<'_> {
    fn session(&self, session: &Session, first: usize, in_flight: bool) -> String {
        let mut fields = vec![format!(".params = {{{}}}", self.parameters(&session.parameters))];
        if !session.x0.is_empty() {
            fields.push(format!(".x0 = {{{}}}", self.list(&session.x0)));
        }
        let again = session.again;
        if in_flight {
            let tau = again.and_then(|again| again.duration);
            fields.push(format!(".tau = {}", self.number(tau.unwrap_or(0.0))));
            fields.push(format!(".is_armed_for = {}U", u8::from(tau.is_some())));
        }
        fields.extend([
            format!(".t0 = {}", self.number(again.map_or(0.0, |again| again.start))),
            format!(".is_armed_again = {}U", u8::from(again.is_some_and(|again| again.arms))),
            format!(".first = {first}U"),
            format!(".count = {}U", session.calls.len()),
        ]);
        fields.join(", ")
    }

    fn call(&self, call: &Call, spec: &Spec, has_gains: bool) -> String {
        let of_axes = spec.rows_of_axes();
        let states = of_axes.map_or(spec.states(), |(count, order)| count * order);
        let (x, reference) = call.x.split_at(states);
        let several = spec.axes.is_some();
        let rows = |all: &[f64], length: usize| {
            let each = all.chunks(length).map(|row| format!("{{{}}}", self.list(row)));
            each.collect::<Vec<_>>().join(", ")
        };
        let states = of_axes.map_or_else(|| self.list(x), |(_, order)| rows(x, order));
        // One number, or a list of them.
        let each = |of: &dyn Fn(&Wanted) -> f64| {
            let list = self.list(&call.inputs.iter().map(of).collect::<Vec<_>>());
            if several { format!("{{{list}}}") } else { list }
        };
        let mut fields = vec![
            format!(".t = {}", self.number(call.t)),
            format!(".x = {{{states}}}"),
            format!(".u = {}", each(&|wanted| wanted.u)),
            format!(".tolerance = {}", each(&|wanted| wanted.tolerance)),
            format!(".status = {}", call.status.c_name()),
        ];
        if several {
            let axes: Vec<_> = call.inputs.iter().map(|wanted| wanted.status.c_name()).collect();
            fields.push(format!(".axes = {{{}}}", axes.join(", ")));
        }
        if !reference.is_empty() {
            let reference = match several {
                true => rows(reference, spec.references()),
                false => self.list(reference),
            };
            fields.push(format!(".r = {{{reference}}}"));
        }
        if has_gains {
            fields.push(format!(".axis = {}", call.axis.unwrap_or(call.status).c_name()));
            fields.push(format!(".has_axis = {}U", u8::from(call.axis.is_some())));
        }
        fields.join(", ")
    }
}

#[derive(Template)]
#[template(path = "selftest/time.c.txt", escape = "none")]
struct Source<'a> {
    name: &'a str,
    abs: String,
    eighth: String,
    three_halves: String,
    sixteenth: String,
    /// Number of laws that replace the user's, if there are several.
    laws: Option<usize>,
    /// States of all chains in stretched time.
    chains: usize,
    /// Value of u before a call, which must overwrite it.
    poison: String,
    /// The greatest finite number.
    largest: String,
    /// The functions that stand for the user's.
    pi0: String,
    after: String,
    /// Result argument for u.
    result: &'static str,
    is_after: bool,
    has_context: bool,
    has_gains: bool,
    /// True if `step` of several axes is compared with `tick` and `axis`; and if the latter takes the number of the
    /// axis.
    has_axes: bool,
    numbers_axes: bool,
    /// Calls of `axis` of which each lacks a pointer: gains, x, r and u.
    axis_pointers: Vec<[&'static str; 4]>,
    tau_is_kept: bool,
    /// True if `arm_for` is called too, and the durations that it must refuse.
    in_flight: bool,
    durations: &'a [String],
    /// The fields of each entry of the tables.
    sessions: &'a [String],
    calls: &'a [String],
    refused: &'a [String],
    states: &'a [String],
    frame: &'a Outline,
}
