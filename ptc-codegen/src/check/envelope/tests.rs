//! The scan of an envelope against the interpreter.

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
        | Input::Control
        | Input::Wanted(_) => {
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
                    assert!(low <= number && number <= high, "{text} {t}: {number} {low} {high}");
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
