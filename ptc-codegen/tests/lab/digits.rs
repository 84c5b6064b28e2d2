//! Parameters of any size: what `init` accepts gives u its digits, or no u; all else is refused.

use crate::support;

use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::plant::Plant;
use ptc_codegen::program::number::settle;
use ptc_codegen::reference::{Call, Status, evaluate, tolerance};
use ptc_codegen::request::Spec;
use ptc_codegen::simulate::{Control, Controller, Values};
use support::design;

/// Pseudo-random numbers, the same in every run: SplitMix64.
struct Draw(u64);

impl Draw {
    #[allow(clippy::cast_precision_loss)]
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        low + (high - low) * ((bits ^ (bits >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A size between 10^-decades and 10^decades, small ones more often.
    fn size(&mut self, decades: f64) -> f64 {
        let share = self.between(-1.0, 1.0);
        10f64.powf(decades * share * share.abs())
    }
}

/// Outcomes for random parameters.
#[derive(Default, Debug)]
struct Seen {
    accepted: usize,
    refused: usize,
    judged: usize,
}

fn spec(family: &str, n: usize, precision: &str) -> Spec {
    design(&format!("mu = \"{family}\"\nn = {n}\nprecision = \"{precision}\"\n")).0
}

/// Draws parameters until `wanted` sets of them are accepted, and judges u of each.
fn judge(spec: &Spec, wanted: usize) -> Seen {
    let (mut draw, mut seen) = (Draw(spec.n as u64), Seen::default());
    let decades = if spec.precision == Precision::F64 { 300.0 } else { 37.0 };
    let round = |value: f64| settle(value, spec.precision);
    let mut controller = Controller::new(spec).expect("a controller");
    let plant = Plant::default();
    while seen.accepted < wanted {
        let tau = round(draw.size(decades));
        let mut values = Values::of(spec, &plant).with(Parameter::Tau, tau);
        values.set(Parameter::Eps, round(tau * draw.between(0.001, 0.3)));
        let a = draw.size(decades);
        for parameter in spec.run_time_parameters() {
            let value = match parameter {
                Parameter::A => a,
                Parameter::Rate(i) => a * f64::from(u32::try_from(i).expect("few rates")),
                Parameter::M => draw.size(1.0),
                Parameter::Start => draw.size(2.0),
                // Around those of poles near -a, and now and then of any size.
                Parameter::Gain(i) if draw.between(0.0, 1.0) < 0.8 => {
                    draw.size(4.0) * (0..=spec.n - i).fold(1.0, |power, _| power * a)
                }
                Parameter::Gain(_) => draw.size(decades),
                _ => continue,
            };
            values.set(parameter, round(value));
        }
        if controller.init(&values, &[]).is_err() {
            seen.refused += 1;
            continue;
        }
        seen.accepted += 1;
        for share in [0.3, 0.05, 0.0] {
            let t = round(tau - share * tau);
            let x: Vec<_> = (0..spec.n).map(|_| round(draw.size(4.0))).collect();
            let parameter = |p| values.get(p);
            let call = Call { parameter: &parameter, x0: &[], t, x: &x, laws: &[], after: 0.0 };
            // Where the long arithmetic itself has no exponent left nothing is known.
            let Some(expected) = evaluate(spec, &call) else { continue };
            if expected.control.as_ref().is_some_and(|control| control.u().is_nan()) {
                continue;
            }
            let (u, status) = controller.step(t, &x);
            let u = u[0];
            if status == Status::Range {
                continue;
            }
            assert_eq!(status, expected.status, "{values:?} at {t}, {x:?}");
            let control = expected.control.expect("a control");
            let allowed = tolerance::of(spec) * control.scale()
                + if spec.precision == Precision::F64 { 1e-300 } else { 1e-35 };
            let error = (u - control.u()).abs();
            assert!(error <= allowed, "{values:?} at {t}, {x:?}: {u}, not {}", control.u());
            seen.judged += 1;
        }
    }
    seen
}

/// Every family, in either precision, over all sizes that a number can have.
#[test]
fn what_is_accepted_keeps_its_digits() {
    for family in ["exp", "rational", "power", "tan", "tanh", "algebraic", "exp_sum", "soft"] {
        let (mut refused, mut judged) = (0, 0);
        for (n, precision) in [(1, "f64"), (2, "f64"), (4, "f64"), (2, "f32"), (3, "f32")] {
            let seen = judge(&spec(family, n, precision), 3);
            (refused, judged) = (refused + seen.refused, judged + seen.judged);
        }
        assert!(refused > 0 && judged >= 15, "{family}: {refused} refused, {judged} judged");
    }
}

/// With one parameter of each set at the end of the range u would be wrong, with no sign of it.
#[test]
fn what_step_cannot_compute_is_refused() {
    let refused = |family: &str, n, own: &[(Parameter, f64)]| {
        let spec = spec(family, n, "f64");
        let mut values = Values::of(&spec, &Plant::default());
        for parameter in spec.run_time_parameters() {
            let usual = match parameter {
                Parameter::StartTime => 0.0,
                Parameter::Eps => 1e-3,
                _ => 1.0,
            };
            values.set(parameter, usual);
        }
        let mut controller = Controller::new(&spec).expect("a controller");
        assert!(controller.init(&values, &[]).is_ok(), "{family}");
        own.iter().for_each(|(parameter, value)| values.set(*parameter, *value));
        controller.init(&values, &[]).is_err()
    };
    assert!(refused("tanh", 2, &[(Parameter::Tau, 1e300)]));
    assert!(refused("tan", 2, &[(Parameter::Tau, 1e300)]));
    assert!(refused("tan", 2, &[(Parameter::Eps, 1e-170)]));
    assert!(refused("exp", 3, &[(Parameter::A, 1e120)]));
    assert!(refused("exp", 2, &[(Parameter::Gain(1), 1e-310)]));
    assert!(refused("rational", 2, &[(Parameter::A, 1e100), (Parameter::Tau, 1e-100)]));
    assert!(refused("algebraic", 3, &[(Parameter::Tau, 1e120)]));
    assert!(refused("power", 2, &[(Parameter::M, 1e4)]));
    assert!(refused("soft", 2, &[(Parameter::Start, 1.01)]));
    assert!(refused("soft", 2, &[(Parameter::Start, 1e-13)]));
    assert!(!refused("soft", 2, &[(Parameter::Start, 1e-12)]));
    // Gains of 0 lose nothing.
    assert!(!refused("exp", 3, &[(Parameter::Gain(1), 0.0), (Parameter::Gain(2), 0.0)]));
}
