//! Legal parameters with which a coefficient overflows: `init` must refuse them, one set for each
//! coefficient that can be the first of the checks to fail.

use super::parameters::Chosen;
use super::trial::Trial;
use super::{Always, Draw, Trials, Unreachable};
use crate::controller::{Checks, Controller, checked};
use crate::parameter::{Domain, Parameter, Precision};
use crate::program::digits::Condition;
use crate::program::machine::Machine;
use crate::program::number::settle;
use crate::program::{Op, Program, Value};
use crate::request::Spec;

/// Sets that are tried.
const TRIALS: usize = 3000;

/// Results of the search.
#[derive(Default)]
pub(super) struct Found {
    pub(super) parameters: Vec<Vec<f64>>,
    /// A start and a state each.
    pub(super) states: Vec<(f64, Vec<f64>)>,
    pub(super) unreachable: Vec<Unreachable>,
}

/// Looks for the sets.
pub(super) fn find(
    controller: &Controller<'_>,
    machine: &Machine,
    chosen: &Chosen<'_>,
    trials: &Trials,
) -> Found {
    let (spec, program) = (controller.spec(), controller.program);
    let mut draw = Draw(1);
    let checks = checked(controller);
    let armed = &checks.arm;
    let (conditions, fields) = of_parameters(&checks);
    let mut found = Found::default();
    let usual = chosen.run_time(0.0625);
    let (start, zeros) = (chosen.value(Parameter::StartTime, 0.0625), vec![0.0; spec.given()]);
    let mut first: Vec<Option<Vec<f64>>> = vec![None; fields.len()];
    for round in trials.rounds(if usual.is_empty() { 0 } else { TRIALS }) {
        let set = extreme(spec, chosen, &usual, round, &mut draw);
        let trial = Trial {
            controller,
            chosen,
            machine,
            parameters: &set,
            x0: &zeros,
            start,
            t: start,
            x: &zeros,
        };
        if let Some(index) = trial.first_failure(&fields) {
            first[index].get_or_insert(set);
        }
        if first.iter().all(Option::is_some) {
            break;
        }
    }
    let mut is_refused = false;
    for ((at, set), condition) in first.into_iter().enumerate().zip(conditions) {
        match set {
            Some(set) => {
                is_refused |= matches!(condition, Always::ArmFor(_));
                found.parameters.push(set);
            }
            None => {
                let reason = reason(program, &fields, at);
                found.unreachable.push(Unreachable { condition, reason });
            }
        }
    }
    // A fixed tau moves no finite start out of range, unless it is 2^970 or more.
    let keeps_tau = chosen.place(Parameter::Tau).is_some();
    if !keeps_tau {
        found.unreachable.push(Unreachable {
            condition: Always::Written(spec.precision.finite_in_c("deadline")),
            reason: "tau is fixed, and less than the last place of the greatest start".to_owned(),
        });
    }
    if program.in_flight {
        found.unreachable.push(Unreachable {
            condition: Always::Written(spec.precision.finite_in_c("deadline")),
            reason: "in arm_for: a legal tau is less than the last place of the greatest start"
                .to_owned(),
        });
    }
    if !spec.latches() && !is_refused {
        found.unreachable.push(Unreachable {
            condition: Always::Written("(status == PTC_OK)".to_owned()),
            reason: match program.in_flight {
                true => "arm_for takes every start time and tau that init takes".to_owned(),
                false => "arm takes every start time that init takes".to_owned(),
            },
        });
    }
    let mut first: Vec<Option<(f64, Vec<f64>)>> = vec![None; armed.len()];
    for round in trials.rounds(if armed.is_empty() { 0 } else { TRIALS }) {
        let x0: Vec<_> = (0..spec.states()).map(|_| any(spec, &mut draw)).collect();
        let start = if round % 2 == 0 { start } else { any(spec, &mut draw) };
        let trial = Trial {
            controller,
            chosen,
            machine,
            parameters: &usual,
            x0: &x0,
            start,
            t: start,
            x: &zeros,
        };
        if let Some(index) = trial.first_failure(armed) {
            first[index].get_or_insert((start, x0));
        }
    }
    for (at, x0) in first.into_iter().enumerate() {
        match x0 {
            Some(x0) => found.states.push(x0),
            None => {
                let both = checks.arm_for.iter().position(|check| *check == armed[at]);
                let reason = reason(program, armed, at);
                found.unreachable.extend(both.map(|both| Unreachable {
                    condition: Always::ArmFor(both),
                    reason: format!("in arm_for: {reason}"),
                }));
                found.unreachable.push(Unreachable { condition: Always::Arm(at), reason });
            }
        }
    }
    found
}

/// The checks that parameters alone decide, in the order in which they are made: those of `init`, and those of `arm_for`
/// that no start decides.
fn of_parameters(checks: &Checks) -> (Vec<Always>, Vec<Condition>) {
    let Checks { init, arm, arm_for } = checks;
    let of_init = init.iter().enumerate().map(|(at, check)| (Always::Init(at), check.clone()));
    let of_duration = arm_for.iter().enumerate().filter(|(_, check)| !arm.contains(check));
    let of_duration = of_duration.map(|(at, check)| (Always::ArmFor(at), check.clone()));
    of_init.chain(of_duration).unzip()
}

/// Why a value is never the first that is not finite, as far as it is known.
fn reason(program: &Program, fields: &[Condition], at: usize) -> String {
    let value = fields[at].values()[0];
    let of_input = |v: Value| matches!(program.get(v).op, Op::Input(_) | Op::Number(_));
    match program.get(value).op {
        Op::Neg(a) if of_input(a) => "the negative of a parameter that is finite".to_owned(),
        _ if at > 0 => format!(
            "among {TRIALS} sets of parameters, drawn up to the ends of the range, what fails it \
             fails one of the {at} before it"
        ),
        _ => format!(
            "none of {TRIALS} sets of parameters, drawn up to the ends of the range, fails it"
        ),
    }
}

/// A set with some parameters anywhere in their domains.
pub(super) fn extreme(
    spec: &Spec,
    chosen: &Chosen<'_>,
    usual: &[f64],
    round: usize,
    draw: &mut Draw,
) -> Vec<f64> {
    let all = chosen.at_run_time();
    // First each alone at its ends, then all of them anywhere.
    let ends = [
        spec.precision.greatest(),
        spec.precision.greatest() / 4.0,
        2.0 * least(spec),
        64.0 / spec.precision.greatest(),
    ];
    let alone = (round < 4 * all.len()).then(|| (round / 4, ends[round % 4]));
    let share = draw.of(&[0.2, 0.5, 0.9]);
    let mut set: Vec<f64> = Vec::with_capacity(all.len());
    for (at, parameter) in all.iter().enumerate() {
        let value = match alone {
            Some((which, value)) if which == at => value,
            Some(_) => usual[at],
            None if draw.between(0.0, 1.0) < share => any(spec, draw),
            None => usual[at],
        };
        let value = if spec.domain(*parameter) == Domain::Finite { value } else { value.abs() };
        set.push(if value == 0.0 { usual[at] } else { chosen.legal(*parameter, value) });
    }
    // eps stays below tau.
    let place = |wanted| all.iter().position(|p| *p == wanted);
    if let Some(eps) = place(Parameter::Eps) {
        let tau = place(Parameter::Tau).map_or(chosen.value(Parameter::Tau, 0.0625), |at| set[at]);
        if set[eps] >= tau {
            set[eps] = chosen.legal(Parameter::Eps, tau / 16.0);
        }
        if let Some(at) = place(Parameter::Tau).filter(|at| set[eps] >= set[*at]) {
            set[at] = chosen.legal(Parameter::Tau, 16.0 * set[eps]);
        }
    }
    set
}

/// The least number > 0.
pub(super) fn least(spec: &Spec) -> f64 {
    match spec.precision {
        Precision::F64 => f64::from_bits(1),
        Precision::F32 => f64::from(f32::from_bits(1)),
    }
}

/// A number of any size and sign, sometimes one of the ends of the range or 0.
fn any(spec: &Spec, draw: &mut Draw) -> f64 {
    let range = spec.precision.greatest().log10();
    let exponent = draw.between(-range, range);
    let end =
        draw.of(&[10f64.powf(exponent), 10f64.powf(exponent), spec.precision.greatest(), 0.0, 3.0]);
    settle(draw.of(&[-1.0, 1.0]) * end, spec.precision)
}
