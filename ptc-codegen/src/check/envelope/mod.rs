//! Can any value of the controller overflow, for all inputs from given intervals?
//!
//! The staged program is computed on intervals, piece by piece of time-to-go. Where no bound leaves
//! the range of the program's precision, no input does; where one does, the bound may be too wide, so
//! a corner of the inputs is tried with the interpreter, and only what overflows there is refuted.
//!
//! Two things are taken on trust: that a library's functions are exact to two units in the last place,
//! and that an iteration ends no further from its root than its last step may be long.

pub(crate) mod bounds;
mod cells;
mod computed;
mod regular;
mod report;

pub use computed::Computed;
#[cfg(feature = "lab")]
pub(crate) use computed::apply;
pub(crate) use computed::outward;

use bounds::Bounds;
#[cfg(feature = "lab")]
pub(crate) use report::describe;
#[cfg(not(feature = "lab"))]
use report::describe;
use report::input_name;

use crate::limits::CELLS;
use crate::parameter::Precision;
use crate::program::interpret::Interpreter;
use crate::program::{Input, Op, Program, Value, number};

/// A value that may leave the range.
#[derive(Clone, Debug, PartialEq)]
pub struct Excess {
    /// The value: the first in order of computation.
    pub value: Value,
    /// Its name, or the expression that it is.
    pub what: String,
    /// The piece of time-to-go.
    pub time_to_go: (f64, f64),
    /// The other inputs at which it may, with their names.
    pub inputs: Vec<(String, Computed)>,
    /// Inputs at which the decoupling matrix was not shown to be regular, if that is why.
    pub singular: Option<Vec<(String, Computed)>>,
    /// A time-to-go at which the interpreter overflows at one end of each input.
    pub refuted_at: Option<f64>,
}

/// Whether the values of a program stay in range.
#[derive(Clone, Debug, PartialEq)]
pub struct Envelope {
    /// Precision of the program.
    pub precision: Precision,
    /// Time-to-go that was covered.
    pub time_to_go: (f64, f64),
    /// What may leave the range in `step`: the largest time-to-go at which something does.
    pub step: Option<Excess>,
    /// What may leave the range in `tick` or `axis`, which compute the gains alone.
    pub axis: Option<Excess>,
}

/// Scans time-to-go from `tau` down to `eps` in `pieces` of equal ratio. `input` bounds every input
/// but time and the gains, by numbers of the program's precision. Some 20 pieces per decade separate
/// what overflows and what does not in every family.
pub fn scan(
    program: &Program,
    input: &dyn Fn(Input) -> Computed,
    eps: f64,
    tau: f64,
    pieces: u32,
) -> Envelope {
    let pieces = pieces.max(1);
    let mut early = Bounds::new(program, input);
    let singular = settle_divisors(program, input, &mut early);
    // The program's own time-to-go has a rounding or two, but is never below eps.
    let slack = 2.0 * epsilon(program.precision);
    let (mut step, mut axis) = (None, None);
    let controls = program.controls();
    let handed: Vec<_> = program.handed_over().copied().collect();
    let mut high = tau;
    for piece in 1..=pieces {
        let low = if piece == pieces {
            eps
        } else {
            tau * (eps / tau).powf(f64::from(piece) / f64::from(pieces))
        };
        let mut bounds = early.at((low * (1.0 - slack)).max(eps), high * (1.0 + slack));
        let found = |value: Value| Found { value, time_to_go: (low, high) };
        step = step.or_else(|| bounds.first_excess(&controls).map(found));
        axis = axis.or_else(|| {
            let gain = bounds.first_excess(&handed);
            bounds.hand_over_gains();
            gain.or_else(|| bounds.first_excess(program.axis.as_slice())).map(found)
        });
        if step.is_some() && axis.is_some() {
            break;
        }
        high = low;
    }
    let report = |found: Found, roots: &[Value]| {
        let at = |t, root: &Value| overflow(program, input, tau, t, *root);
        let overflow = |t| roots.iter().find_map(|root| at(t, root));
        Excess {
            value: found.value,
            what: describe(program, found.value),
            time_to_go: found.time_to_go,
            inputs: named_inputs(program, input),
            singular: singular
                .as_ref()
                .filter(|_| is_solution(program, found.value))
                .map(|cell| named(cell)),
            refuted_at: [found.time_to_go.0, eps].into_iter().find_map(overflow),
        }
    };
    Envelope {
        precision: program.precision,
        time_to_go: (eps, tau),
        step: step.map(|found| report(found, &controls)),
        axis: axis.zip(program.axis).map(|(found, root)| report(found, &[root])),
    }
}

/// Sets the bounds of what operations divide by, take roots or logarithms of, and of matrices, where one interval of
/// each input leaves their domain and smaller cells do not. Gives a cell in which a matrix may be singular.
fn settle_divisors(
    program: &Program,
    input: &dyn Fn(Input) -> Computed,
    early: &mut Bounds<'_>,
) -> Option<cells::Cell> {
    let (mut done, mut work) = (Vec::new(), CELLS.size());
    for (value, domain) in cells::critical(program) {
        if done.contains(&value) || !cells::is_bounded(program, &[value]) {
            continue;
        }
        done.push(value);
        if domain(Bounds::only(program, input, &[value]).get(value)) {
            continue;
        }
        if let Some(bound) = cells::refined(program, input, (value, domain), &mut work) {
            early.set(value, bound);
        }
    }
    let mut singular = None;
    for (index, definition) in program.values.iter().enumerate() {
        let Op::Elimination { matrix, .. } = &definition.op else { continue };
        if !cells::is_bounded(program, matrix) {
            continue;
        }
        match cells::regular(program, input, matrix, &mut work) {
            Ok(bounds) => early.set_regular(Value(index), bounds),
            Err(cell) => singular = Some(cell),
        }
    }
    singular
}

/// Whether a value is solved for by an elimination.
fn is_solution(program: &Program, value: Value) -> bool {
    let Op::Element(array, _) = program.get(value).op else { return false };
    matches!(program.get(array).op, Op::Elimination { .. })
}

/// The distance from 1 to the next number of `precision`.
fn epsilon(precision: Precision) -> f64 {
    match precision {
        Precision::F32 => f64::from(f32::EPSILON),
        Precision::F64 => f64::EPSILON,
    }
}

/// Where a bound left the range.
#[derive(Clone, Copy)]
struct Found {
    value: Value,
    time_to_go: (f64, f64),
}

/// The time-to-go, next to the given one, at which `root` is not finite with parameters all at their
/// lower or all at their upper ends. States are at those ends that give all terms of u one sign; a
/// law or an input gain that is an expression has no such ends, and is tried at those of the
/// parameters and, as it may divide by a state, in the middle.
fn overflow(
    program: &Program,
    input: &dyn Fn(Input) -> Computed,
    tau: f64,
    time_to_go: f64,
    root: Value,
) -> Option<f64> {
    let settle = |value| number::settle(value, program.precision);
    let corners = [(false, false), (true, false), (false, true)];
    corners.into_iter().find_map(|(upper, middle)| {
        let end =
            |bound: Computed, upper| if upper { bound.range.high() } else { bound.range.low() };
        let early = |asked: Input| match asked {
            Input::Time => {
                let start = end(input(Input::StartTime), upper);
                settle(settle(start + tau) - settle(time_to_go))
            }
            other => end(input(other), upper),
        };
        let mut interpreter = Interpreter::new(program, &early);
        let gains: Vec<_> = program.gains.iter().map(|gain| interpreter.value(*gain)).collect();
        let divisor = program.divisors.first().map(|value| interpreter.value(*value));
        let aligned = |asked: Input| match asked {
            Input::State(_) if middle => {
                settle(f64::midpoint(input(asked).range.low(), input(asked).range.high()))
            }
            Input::State(j) => {
                end(input(asked), gains.get(j - 1).map_or(upper, |gain| *gain >= 0.0))
            }
            Input::Gain(j) => gains.get(j - 1).copied().unwrap_or(f64::NAN),
            Input::Divisor => divisor.unwrap_or(f64::NAN),
            other => early(other),
        };
        let finite = Interpreter::new(program, &aligned).value(root).is_finite();
        (!finite).then(|| -interpreter.value(program.limits.late))
    })
}

/// Every input that u depends on but time, with its bounds.
fn named_inputs(program: &Program, input: &dyn Fn(Input) -> Computed) -> Vec<(String, Computed)> {
    let needed = program.needed(&program.controls()).into_iter();
    let given = needed.filter_map(|value| match program.get(value).op {
        Op::Input(Input::Time) => None,
        Op::Input(asked) => Some((asked, input(asked))),
        _ => None,
    });
    named(&given.collect::<Vec<_>>())
}

fn named(inputs: &[(Input, Computed)]) -> Vec<(String, Computed)> {
    inputs.iter().map(|(asked, bound)| (input_name(*asked), *bound)).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::check::{Outcome, Verdict};
    use crate::expression::Subject;
    use crate::expression::testing::mu;
    use crate::family::Family;
    use crate::law::Law;
    use crate::lower;
    use crate::mapping::{Custom, TimeMapping};
    use crate::parameter::Parameter;
    use crate::program::passes;
    use crate::request::Spec;

    fn program(n: usize, family: Family, precision: Precision) -> Program {
        let spec = Spec { precision, ..Spec::new(n, family) };
        let law = Law::of(&spec);
        passes::optimise(lower::lower(&spec, &law), &mut |_, _| {})
    }

    /// tau = 1, t0 = 0, a = 1, m = 1.5, rates 1 and 2, all gains 1 except those that are given.
    fn inputs(eps: f64, state: f64, gain: Computed) -> impl Fn(Input) -> Computed {
        move |input| match input {
            Input::Parameter(Parameter::Eps) => Computed::point(eps),
            Input::Parameter(Parameter::M) => Computed::point(1.5),
            Input::Parameter(Parameter::Start) => Computed::point(0.125),
            Input::Parameter(Parameter::Rate(i)) => Computed::point(if i == 1 { 1.0 } else { 2.0 }),
            Input::Parameter(Parameter::Gain(_)) => gain,
            Input::Parameter(_) => Computed::point(1.0),
            Input::StartTime => Computed::point(0.0),
            Input::State(_) | Input::StateAtStart(_) => Computed::new(-state, state),
            Input::Time
            | Input::Reference(_)
            | Input::ReferenceOf(..)
            | Input::Gain(_)
            | Input::Divisor
            | Input::Drift
            | Input::Control => {
                panic!("{input:?} is not asked for")
            }
        }
    }

    const FAMILIES: [Family; 8] = [
        Family::Exp,
        Family::Rational,
        Family::Power,
        Family::Tan,
        Family::Tanh,
        Family::Algebraic,
        Family::ExpSum,
        Family::Soft,
    ];

    #[test]
    fn common_designs_stay_in_range() {
        for family in FAMILIES {
            for precision in [Precision::F64, Precision::F32] {
                let program = program(3, family, precision);
                let input = inputs(f64::from(1e-2f32), 10.0, Computed::new(1.0, 20.0));
                let found = scan(&program, &input, f64::from(1e-2f32), 1.0, 200);
                let outcome = Outcome::from(&found);
                assert_eq!(outcome.verdict, Verdict::Sound, "{family:?}: {outcome:?}");
            }
        }
    }

    #[test]
    fn an_overflow_is_found_and_shown() {
        // gain_1 is about 1/eps^4 for exp and 1/eps^8 for rational.
        let eps = f64::from(1e-6f32);
        for family in FAMILIES {
            let program = program(4, family, Precision::F32);
            let input = inputs(eps, 1e30, Computed::point(1.0));
            let found = scan(&program, &input, eps, 1.0, 200);
            let outcome = Outcome::from(&found);
            assert_eq!(outcome.verdict, Verdict::Refuted, "{family:?}: {outcome:?}");
            let excess = found.step.expect("overflow");
            assert!(excess.time_to_go.0 > 1e-6, "the first piece from tau down: {excess:?}");
        }
    }

    #[test]
    fn what_a_reader_is_told() {
        let program = program(1, Family::Exp, Precision::F32);
        let input = inputs(f64::from(1e-3f32), 1e36, Computed::point(1.0));
        let outcome = Outcome::from(&scan(&program, &input, f64::from(1e-3f32), 1.0, 30));
        assert_eq!(
            outcome.summary,
            "step overflows f32 at T = 0.002512 s; (K1*x1)/late may be the first to"
        );
        assert_eq!(
            outcome.details[0],
            "axis overflows f32 at T = 0.002512 s; gain1*x1 may be the first to"
        );
        assert_eq!(
            outcome.details[1],
            "with a = 1, k[0] = 1, t0 = 0, tau = 1, eps = 0.001, x1 in [-1e36, 1e36]"
        );
        let calm = inputs(f64::from(1e-3f32), 1.0, Computed::point(1.0));
        let outcome = Outcome::from(&scan(&program, &calm, f64::from(1e-3f32), 1.0, 30));
        assert_eq!(outcome.summary, "every value stays within f32 for T in [0.001, 1] s");
    }

    #[test]
    fn an_iterated_stretched_time_is_within_close_bounds() {
        for text in [
            "tau*(1 - exp(-t)/(1 + t))",
            "tau*(1 - 1/(1 + t + t^3)^0.1)",
            "tau*(1 - 1/(1 + t + sinh(t)))",
        ] {
            let custom = Custom::new(Subject::Mu, mu(text)).expect(text);
            for precision in [Precision::F32, Precision::F64] {
                let time_mapping = TimeMapping::Custom(Box::new(custom.clone()));
                let spec = Spec { precision, time_mapping, ..Spec::new(2, Family::Exp) };
                let law = Law::of(&spec);
                let program = passes::optimise(lower::lower(&spec, &law), &mut |_, _| {});
                let of_root = |value: &Value| matches!(program.get(*value).op, Op::Root(_));
                let Some(root) = program.needed(&[program.step]).into_iter().find(of_root) else {
                    panic!("{text} is iterated")
                };
                let input = inputs(f64::from(1e-4f32), 10.0, Computed::new(1.0, 20.0));
                let early = Bounds::new(&program, &input);
                for t in [0.0f32, 0.01, 0.3, 0.9, 0.999] {
                    let at = |asked: Input| match asked {
                        Input::Time => f64::from(t),
                        other => input(other).range.low(),
                    };
                    let number = Interpreter::new(&program, &at).value(root);
                    let time_to_go = 1.0 - f64::from(t);
                    for slack in [1e-6, 4e-3] {
                        let (low, high) = (time_to_go * (1.0 - slack), time_to_go * (1.0 + slack));
                        let mut bounds = early.at(low, high);
                        bounds.first_excess(&[root]);
                        let Computed { range, special } = bounds.get(root);
                        let (low, high) = (range.low(), range.high());
                        assert!(
                            low <= number && number <= high,
                            "{text} {t}: {number} {low} {high}"
                        );
                        let close = !special && high - low <= 0.2 * number + 0.3;
                        assert!(close, "{text} {t}: {number} {low} {high}");
                    }
                }
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// Every value that the interpreter computes lies in its bounds.
        #[test]
        fn bounds_hold_what_is_computed(
            family in prop::sample::select(&FAMILIES),
            n in prop::sample::select(&[3, 9]),
            single in prop::bool::ANY,
            (t, gain, state) in (0.0..0.9999f32, 1.0..20.0f32, -10.0..10.0f32),
        ) {
            let precision = if single { Precision::F32 } else { Precision::F64 };
            let program = program(n, family, precision);
            let eps = f64::from(1e-4f32);
            let input = inputs(eps, 10.0, Computed::new(1.0, 20.0));
            let time_to_go = 1.0 - f64::from(t);
            let mut bounds = Bounds::new(&program, &input).at(0.99 * time_to_go, 1.01 * time_to_go);
            let handed: Vec<_> = program.handed_over().copied().collect();
            bounds.first_excess(&handed);
            bounds.first_excess(&[program.step]);
            let at = |asked: Input| match asked {
                Input::Time => f64::from(t),
                Input::State(_) => f64::from(state),
                Input::Parameter(Parameter::Gain(_)) => f64::from(gain),
                other => input(other).range.low(),
            };
            let mut interpreter = Interpreter::new(&program, &at);
            let outputs: Vec<_> = program.gains.iter().chain([&program.step]).copied().collect();
            for value in program.needed(&outputs) {
                let definition = program.get(value);
                let no_number = matches!(definition.op, Op::Input(Input::Time) | Op::Rows { .. });
                if definition.looped || no_number {
                    continue;
                }
                let (bound, number) = (bounds.get(value), interpreter.value(value));
                prop_assert!(
                    bound.range.low() <= number && number <= bound.range.high(),
                    "{:?}: {} = {number} outside {bound:?}", family, describe(&program, value)
                );
            }
        }
    }
}
