//! Several axes with one deadline, and plants with several inputs: every language and the interpreter give the
//! same bits, and each axis those of a controller of its own, by `tick` and `axis`, up to order 11.

mod designs;
mod native;
mod others;

use crate::support;
use designs::{coupled, specs};
use native::{in_c, in_rust};
use others::{in_cpp, in_octave, in_python, in_structured_text};
use ptc_codegen::check::examine::examine;
use ptc_codegen::code::{Code, Instance};
use ptc_codegen::controller::{self, Controller};
use ptc_codegen::law::Law;
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::request::Spec;
use support::random::Random;
use support::specs::calls_a_library;
use support::{folder, optimised};

const CALLS: usize = 200;

/// The law of both outputs that is given to those that have none of their own, as C and Rust write it. It
/// knows the chain of the other output, time and kappa', and has no sum whose order is not written.
const LAW: [&str; 2] =
    ["(xi[2] - (2.0F * xi[0])) - (t * xi[1])", "xi[0] * (rate - (3.0F * xi[2]))"];

fn law(xi: &[f64], t: f64, small: bool) -> f64 {
    let settled = |value: f64| match small {
        #[allow(clippy::cast_possible_truncation)]
        true => f64::from(value as f32),
        false => value,
    };
    let [a, b, c, .., rate, place] = xi[..] else { panic!("the law is given {xi:?}") };
    if place == 0.0 {
        let left = settled(c - settled(2.0 * a));
        return settled(left - settled(t * b));
    }
    settled(a * settled(rate - settled(3.0 * c)))
}

fn is_extern(spec: &Spec) -> bool {
    spec.feedback == ptc_codegen::request::Feedback::Extern
}

/// Times and numbers of a call: the states of all axes, and behind them their references.
struct Call {
    t: f64,
    x: Vec<f64>,
    r: Vec<f64>,
}

fn calls(spec: &Spec, count: usize) -> Vec<Call> {
    let mut random = Random(7);
    let settled = |value: f64| match spec.precision {
        Precision::F64 => value,
        #[allow(clippy::cast_possible_truncation)]
        Precision::F32 => f64::from(value as f32),
    };
    let checked = spec.guard == ptc_codegen::request::Guard::Full;
    let mut call = |index: usize| {
        let mut numbers = |length| -> Vec<f64> {
            (0..length).map(|_| settled(random.between(-2.0, 2.0))).collect()
        };
        let states = if spec.coupled.is_some() { spec.states() } else { count * spec.n };
        let (mut x, mut r) = (numbers(states), numbers(count * spec.references()));
        if checked && index % 11 == 3 {
            x[(index / 11) % states] = f64::NAN;
        }
        if checked && index % 19 == 8 && !r.is_empty() {
            // Of outputs of different orders some are not read.
            let length = r.len();
            r[(index / 19) % length] = f64::NAN;
        }
        if index % 13 == 6 {
            x.fill(0.0);
        }
        let early = if checked && index % 17 == 5 { -1.0 } else { 1.0 };
        Call { t: settled(early * random.between(0.0, 1.2)), x, r }
    };
    (0..CALLS).map(&mut call).collect()
}

fn parameters(spec: &Spec) -> Vec<(Parameter, f64)> {
    let value = |parameter| match parameter {
        Parameter::StartTime => 0.0,
        Parameter::Eps => 0.015625,
        Parameter::UMax => 24.0,
        Parameter::Gain(i) => 10.0 + f64::from(u32::try_from(i).expect("a small number")),
        Parameter::Named(_) => 1.75,
        _ => 1.0,
    };
    spec.run_time_parameters().map(|parameter| (parameter, value(parameter))).collect()
}

/// All u by their bits, the status of each axis, and that of the call.
type Given = (Vec<u64>, Vec<i64>, i64);

fn whole(spec: &Spec, work: impl FnOnce(&Code)) {
    let (report, law) = (examine(spec), Law::of(spec));
    let program = optimised(spec);
    let controller = Controller { report: &report, law: &law, program: &program, measured: &[] };
    work(&controller::whole(&controller));
}

fn interpreted(spec: &Spec, calls: &[Call]) -> Vec<Given> {
    let mut all = Vec::new();
    whole(spec, |code| {
        let mut controller = Instance::with_parameters(code, parameters(spec)).expect("legal");
        for call in calls {
            let small = spec.precision == Precision::F32;
            let own = |xi: &[f64], t: f64| law(xi, t, small);
            let given: [(_, &[f64]); 3] = [("t", &[call.t]), ("x", &call.x), ("r", &call.r)];
            let found = controller.call_with("step", &given, &[("pi0", &own)]);
            let u = found.results["u"].iter().map(|u| u.to_bits()).collect();
            #[allow(clippy::cast_possible_truncation)]
            let axes = found.results["axes"].iter().map(|status| *status as i64).collect();
            all.push((u, axes, i64::from(found.status.number())));
        }
    });
    all
}

/// u and status of one axis by a controller of its own.
fn alone(spec: &Spec, index: usize, calls: &[Call]) -> Vec<(u64, i64)> {
    let one = spec.axis(index);
    let mut all = Vec::new();
    whole(&one, |code| {
        let controller = Instance::with_parameters(code, parameters(&one)).expect("legal");
        for call in calls {
            let mut controller = controller.clone();
            let gains = controller.call("tick", &[("t", &[call.t])]);
            if gains.status.number() < 0 {
                all.push((0, i64::from(gains.status.number())));
                continue;
            }
            let part = |values: &[f64], length: usize| {
                values[length * index..length * (index + 1)].to_vec()
            };
            let (x, r) = (part(&call.x, one.n), part(&call.r, one.references()));
            let found = controller.gains(&gains).call("axis", &[("x", &x), ("r", &r)]);
            let u = found.results.get("u").map_or(0.0, |u| u[0]);
            all.push((u.to_bits(), i64::from(found.status.number())));
        }
    });
    all
}

#[test]
fn axes_give_the_same_bits_everywhere() {
    let mut seen = std::collections::BTreeSet::new();
    for (index, spec) in specs().into_iter().chain(coupled()).enumerate() {
        let count = spec.axes.as_ref().expect("axes").count;
        let calls = calls(&spec, count);
        let folder = folder(&format!("axes_{}", spec.name()));
        let wanted = interpreted(&spec, &calls);
        let mut all = vec![
            ("C", in_c(&folder, &spec, &calls, count)),
            ("Rust", in_rust(&folder, &spec, &calls, count)),
            ("C++", in_cpp(&folder, &spec, &calls, count)),
        ];
        // They have functions of their own.
        if !calls_a_library(&spec) {
            let python = in_python(&folder, &spec, &calls, count);
            all.extend(python.map(|found| ("Python", found)));
            let octave = in_octave(&folder, &spec, &calls, count);
            all.extend(octave.map(|found| ("Octave", found)));
            // Its parser takes seconds for each file.
            let is_parsed = index % 3 == 0 || spec.name() == "four";
            if is_parsed && !is_extern(&spec) {
                let structured = in_structured_text(&folder, &spec, &calls);
                all.extend(structured.map(|found| ("Structured Text", found)));
            }
        }
        for (language, found) in all {
            assert_eq!(found.len(), wanted.len());
            for (index, (found, wanted)) in found.iter().zip(&wanted).enumerate() {
                assert_eq!(found, wanted, "{language}, call {index} of {}", spec.name());
            }
        }
        // At order 12 u of one of several axes is summed in parts.
        let chains = if spec.coupled.is_some() || spec.n == 12 { 0 } else { count };
        for axis in 0..chains {
            let alone = alone(&spec, axis, &calls);
            for (index, ((u, axes, status), (own, own_status))) in
                wanted.iter().zip(&alone).enumerate()
            {
                let name = spec.name();
                assert_eq!(axes[axis], *own_status, "axis {axis}, call {index} of {name}");
                let u_wanted = if *status < 0 { 0 } else { *own };
                assert_eq!(u[axis], u_wanted, "axis {axis}, call {index} of {name}");
            }
        }
        for (u, axes, status) in &wanted {
            let failed = axes.iter().find(|status| **status < 0);
            let clipped = axes.iter().find(|status| **status == 2);
            let known = failed.or(clipped).unwrap_or(&axes[0]);
            assert_eq!(status, known, "{axes:?}");
            assert!(*status >= 0 || u.iter().all(|u| *u == 0), "{u:?}");
            seen.insert(*status);
        }
    }
    assert_eq!(seen, [-3, -2, 0, 1, 2].into());
}

/// An axis that is none is refused whatever is trusted.
#[test]
fn the_number_of_an_axis_is_checked() {
    for spec in specs().iter().filter(|spec| spec.axes.as_ref().is_some_and(|a| a.differ())) {
        whole(spec, |code| {
            let mut controller = Instance::with_parameters(code, parameters(spec)).expect("legal");
            let gains = controller.call("tick", &[("t", &[0.5])]);
            let (x, r) = (vec![1.0; spec.n], vec![0.0; spec.references()]);
            let mut gains = controller.gains(&gains);
            let count = spec.axes.as_ref().expect("axes").count;
            for (axis, legal) in [(0.0, true), (count as f64, false)] {
                let found = gains.call("axis", &[("axis", &[axis]), ("x", &x), ("r", &r)]);
                assert_eq!(found.status.number() >= 0, legal, "{}", spec.name());
            }
        });
    }
}
