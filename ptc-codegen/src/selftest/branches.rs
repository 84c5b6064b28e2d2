//! The branches of the program: calls that take those that no other call took, and which are left.

use super::maker::Maker;
use super::{Always, CANDIDATES, Call, Draw, Session, Unreachable, Wanted};
use crate::code::Iteration;
use crate::parameter::Parameter;
use crate::program::number::settle;
use crate::program::{Input, Op, Value};
use crate::reference::Status;
use crate::request::Guard;

/// As many where an iteration has branches that few numbers take.
const ITERATED: usize = 4000;

impl Maker<'_> {
    /// Number of inputs that follow from all outputs; 0 where each is of its own chain.
    fn decoupled(&self) -> usize {
        self.spec().decoupled().map_or(0, |coupled| coupled.outputs.len())
    }

    /// The branches of iterations, of divisions and of the test of u alone that no call takes.
    pub(super) fn never(&self, sessions: &[Session]) -> Vec<Unreachable> {
        let program = self.controller.program;
        let mut never = Vec::new();
        let mut add = |condition: String, what: &str| {
            let tried = if self.spec().is_iterated() { ITERATED } else { CANDIDATES };
            let reason = format!("{what} in {tried} random calls, nor at the ends of the range");
            never.push(Unreachable { condition: Always::Written(condition), reason });
        };
        let fails = |call: &Call| call.status == Status::Range;
        let is_one = self.spec().coupled.is_none();
        if is_one && self.spec().guard != Guard::Full {
            let is_seen = sessions.iter().flat_map(|session| &session.calls).any(fails);
            let limit = self.spec().fixed.get(&Parameter::UMax);
            let is_limited = limit.is_none_or(|limit| limit.number().is_some());
            let test = self.spec().precision.nan_in_c("margin");
            match is_seen {
                false => add(test, "u was not beyond the range"),
                // Beyond each limit the test stands once more.
                true if is_limited => add(test, "u was not shown to overflow beyond each limit"),
                true => {}
            }
        }
        for (condition, what) in self.never_of_inputs(sessions) {
            add(condition, what);
        }
        let needed = program.needed(&program.controls());
        let divides = |value: &&Value| matches!(program.get(**value).op, Op::Quotient(..));
        let divisions: Vec<_> = match self.spec().joins_axes() {
            true => needed.iter().filter(divides).copied().collect(),
            false => Vec::new(),
        };
        for value in needed {
            // The divisions of several axes are one in the code.
            let same = match divisions.contains(&value) {
                true if divisions[0] != value => continue,
                true => divisions.as_slice(),
                false => &[value],
            };
            let missing = |way| !same.iter().any(|value| self.taken.contains(&(*value, way)));
            match &program.get(value).op {
                Op::Root(root) => {
                    let name = program.get(value).name.as_ref().map_or("y", |(name, _)| name);
                    if missing("exhausted") {
                        let condition = format!("{} < {}U", Iteration::ROUND, root.rounds);
                        add(condition, "the iteration used no more rounds than it has");
                    }
                    if root.proposals < root.rounds && missing("bisected") {
                        let condition = format!("{}U < {}", root.proposals - 1, Iteration::ROUND);
                        add(condition, "the iteration needed no bisection");
                    }
                    if missing("before") {
                        add(
                            format!("({name}_low <= {name}_next)"),
                            "no step went below the bracket",
                        );
                    }
                    if missing("beyond") {
                        add(
                            format!("({name}_next <= {name}_high)"),
                            "no step went above the bracket",
                        );
                    }
                }
                Op::Quotient(_, divisor) => {
                    // Axes with gains of their own divide by that of each.
                    let axes = self.spec().axes.as_ref();
                    let each = axes.is_some_and(|axes| !axes.input_gains.is_empty());
                    let name = program.get(*divisor).name.as_ref().filter(|_| !each);
                    let name = name.map_or_else(|| Input::Divisor.name(), |(name, _)| name.clone());
                    if missing("negative") {
                        add(format!("{name} < 0.0"), "g was not negative");
                    }
                    if missing("zero") {
                        add(format!("{name} > 0.0"), "g was not 0");
                    }
                }
                Op::Elimination { right, .. } if missing("singular") => {
                    let condition = format!("a[({}U * k) + k] > 0.0", right.len());
                    add(condition, "the matrix was not singular");
                }
                _ => {}
            }
        }
        never
    }

    /// Returns, for inputs that depend on all outputs, the tests of each u that no call makes true, or false.
    fn never_of_inputs(&self, sessions: &[Session]) -> Vec<(String, &'static str)> {
        let calls = || sessions.iter().flat_map(|session| &session.calls);
        let mut never = Vec::new();
        for k in 0..self.decoupled() {
            let finite = |call: &Call, j: usize| call.inputs[j].status != Status::Range;
            let first = |call: &Call| (0..k).all(|j| finite(call, j)) && !finite(call, k);
            let beside = |call: &Call| call.status == Status::Range && finite(call, k);
            if !calls().any(first) || !calls().any(beside) {
                never.push((
                    self.controller.report.spec.precision.finite_in_c(&format!("control{}", k + 1)),
                    "it was never the first u that is no number, or never finite beside one,",
                ));
            }
        }
        never
    }

    /// Random calls that take a branch of the code which none before took.
    pub(super) fn branches(&mut self) -> Vec<Session> {
        let spec = self.spec();
        let mut draw = Draw(3);
        let all = self.chosen.at_run_time();
        let mut found = Vec::new();
        let iterated = self.spec().is_iterated();
        for round in self.trials.rounds(if iterated { ITERATED } else { CANDIDATES }) {
            let eps = draw.of(&[1e-3, 0.05, 0.3]);
            let mut session = self.session(eps);
            for (at, parameter) in all.iter().enumerate() {
                if round % 2 == 0
                    || matches!(parameter, Parameter::StartTime | Parameter::UMax | Parameter::Eps)
                {
                    continue;
                }
                // Equal ones, now and then: brackets of no width.
                let size = if round % 3 == 0 { 0.875 } else { draw.between(0.2, 3.0) };
                let signed = spec.domain(*parameter) == crate::parameter::Domain::Finite;
                let value = match draw.of(&[0, 1, 2, 3]) {
                    0 if signed => 0.0,
                    1 if signed => -size,
                    _ => size,
                };
                session.parameters[at] = self.chosen.legal(*parameter, value);
            }
            let tau = self.parameter(&session, Parameter::Tau);
            if let Some(at) = all.iter().position(|p| *p == Parameter::Eps) {
                session.parameters[at] = self.chosen.legal(Parameter::Eps, eps * tau);
            }
            if self.parameter(&session, Parameter::Eps) >= tau {
                continue;
            }
            for x0 in &mut session.x0 {
                *x0 = settle(draw.between(-2.0, 2.0), spec.precision);
            }
            let share = draw.between(0.0, 1.0);
            let t = self.time(&session, draw.of(&[share, share, 1.0, 0.999_999]) * tau);
            let size = draw.of(&[1.0, 1e-3, 1e2, 1e6]);
            let x: Vec<_> = (0..spec.given())
                .map(|_| {
                    settle(draw.of(&[0.0, 1.0, 1.0]) * draw.between(-size, size), spec.precision)
                })
                .collect();
            let seen = self.trial(&session, t, &x);
            if seen.decisions.is_subset(&self.taken) || !self.is_taken(&session) {
                continue;
            }
            let nan = seen.each.iter().any(|(_, u)| u.is_nan());
            let zero_gain = nan && seen.step == Status::Range;
            if zero_gain {
                // A division by g = 0, which is no number.
                let inputs = seen.each.iter().map(|(status, _)| Wanted::none(*status));
                let (status, inputs) = (Status::Range, inputs.collect());
                session.calls.push(Call { t, x, status, inputs, axis: None });
                self.taken.extend(seen.decisions);
            } else {
                self.ask(&mut session, t, &x);
            }
            found.push(session);
        }
        found
    }
}
