//! Gains that overflow at eps: what the check says without bounds of x, beside the emitted program.

use crate::command::spec_of;
use crate::verdicts::report;

use num_traits::ToPrimitive;
use ptc_codegen::check::Verdict;
use ptc_codegen::check::examine::Report;
use ptc_codegen::code::Instance;
use ptc_codegen::controller::{Controller, whole};
use ptc_codegen::law::Law;
use ptc_codegen::lower::lower;
use ptc_codegen::parameter::Parameter;
use ptc_codegen::program::passes;
use ptc_codegen::reference::Status;

/// Designs without an eps: their gains grow like 1/eps^n, and faster.
const DESIGNS: [&str; 5] = [
    "--n 8 --mu \"exp(a=1)\" --poles=-9,-10,-11,-12,-13,-14,-15,-16 --precision=f32 --tau=1",
    "--n 5 --mu \"rational(a=1)\" --poles=-9,-10,-11,-12,-13 --precision=f32 --tau=0.7",
    "--n 4 --mu \"tanh(a=2)\" --gains=9e5,3000,300,40 --g=1/3 --precision=f32 --tau=2",
    "--n 6 --mu \"mean(exp(a=1), rational(a=1))\" --poles=-9,-10,-11,-12,-13,-14 --precision=f32 --tau=1",
    "--n 16 --mu \"exp(a=1)\" --poles=-17,-18,-19,-20,-21,-22,-23,-24,-25,-26,-27,-28,-29,-30,-31,-32 --tau=1",
];

fn with_eps(design: &str, eps: &str) -> Report {
    report(&format!("{design} --eps={eps}"))
}

/// Returns the verdict, the summary and the fix of the check `envelope`.
fn told(report: &Report) -> (Verdict, String, String) {
    let outcome = report.outcomes.iter().find(|outcome| outcome.name == "envelope");
    let outcome = outcome.expect("a check");
    (outcome.verdict, outcome.summary.clone(), outcome.fix.clone().unwrap_or_default())
}

/// Returns true if a state of 1 alone makes u of the emitted `step` overflow, at the last instant before the gains are
/// held or where they are held.
fn overflows(report: &Report, eps: f64, tau: f64) -> bool {
    let spec = &report.spec;
    let law = Law::of(spec);
    let program = passes::optimise(lower(spec, &law), &mut |_, _| {});
    let emitted = Controller { report, law: &law, program: &program, measured: &[] };
    let code = whole(&emitted);
    let free = |p| (p, if p == Parameter::UMax { f64::INFINITY } else { 0.0 });
    let controller = Instance::with_parameters(&code, spec.run_time_parameters().map(free));
    let mut controller = controller.expect("legal parameters");
    let mut step = |t: f64, state: usize| {
        let x: Vec<_> = (0..spec.n).map(|j| f64::from(u8::from(j == state))).collect();
        controller.call("step", &[("t", &[t]), ("x", &x)]).status.number()
    };
    let range = Status::Range as i32;
    [tau - eps, tau].into_iter().any(|t| (0..spec.n).any(|state| step(t, state) == range))
}

#[test]
fn suggested_eps_is_the_smallest_without_overflow() {
    for design in DESIGNS {
        let is_f32 = design.contains("f32");
        let small = if is_f32 { "1e-17" } else { "1e-21" };
        let (verdict, summary, fix) = told(&with_eps(design, small));
        assert_eq!(verdict, Verdict::Undecided, "{design}");
        assert!(summary.starts_with("the gain of x1 overflows f"), "{summary}");
        assert!(!is_f32 || fix.contains("precision = \"f64\""), "{design}: {fix}");
        let least = fix.split("at least ").nth(1).and_then(|rest| rest.split(' ').next());
        let least = least.unwrap_or_else(|| panic!("{design}: {fix}"));
        let spec = spec_of(design).expect("a design");
        let tau = spec.fixed[&Parameter::Tau].number().and_then(ToPrimitive::to_f64);
        let tau = tau.expect("a number");
        for (part, overflows) in [(1.0, false), (0.995, true), (0.9, true)] {
            let eps = part * least.parse::<f64>().expect("a number");
            let report = with_eps(design, &format!("{eps:e}"));
            let expected = if overflows { Verdict::Undecided } else { Verdict::NotChecked };
            assert_eq!(told(&report).0, expected, "{design}, eps = {eps:e}");
            assert_eq!(self::overflows(&report, eps, tau), overflows, "{design}, eps = {eps:e}");
        }
        // In f64 they do not, and with bounds of x it is these that decide.
        if is_f32 {
            let eps = format!("{:e}", 0.9 * least.parse::<f64>().expect("a number"));
            let wider = with_eps(&design.replace("f32", "f64"), &eps);
            assert_eq!(told(&wider).0, Verdict::NotChecked, "{design}");
            let small = vec!["1e-30"; spec.n].join(",");
            let bounded = with_eps(&format!("{design} --x-max={small}"), &eps);
            assert!(!told(&bounded).1.contains("where it is held"), "{design}");
        }
    }
}

/// A law that is no sum of gains has none, and gains that are left to run time are not known.
#[test]
fn unknown_gains_are_not_checked() {
    for rest in [
        "--gains=1,2 --eps=1e-17",
        "--pi0=\"-xi1-xi2^3\" --tau=1 --eps=1e-17",
        "--tau=1 --eps=1e-17",
    ] {
        let report = report(&format!("--n 2 --mu \"exp(a=1)\" --precision=f32 {rest}"));
        assert_eq!(told(&report).0, Verdict::NotChecked, "{rest}");
    }
}

/// Designs of each form in which u is clipped, without the limits.
const CLIPPED: [&str; 8] = [
    "--n 3 --mu \"exp(a=1)\" --gains=120,74,15 --tau=1 --eps=0.01",
    "--n 3 --mu \"exp(a=1)\" --gains=120,74,15 --tau=1 --eps=0.01 --precision=f32",
    "--n 2 --mu \"rational(a=1)\" --gains=6,5 --tau=1 --eps=0.01 --guard=result",
    "--n 2 --mu \"tanh(a=1)\" --gains=6,5 --tau=1 --eps=0.01 --guard=none --precision=f32",
    "--n 2 --mu \"exp(a=1)\" --gains=6,5 --tau=1 --eps=0.01 --after=zero",
    "--n 2 --mu \"exp(a=1)\" --pi0=\"-6*xi1-5*xi2\" --tau=1 --eps=0.01",
    "--n 2 --mu \"exp(a=1)\" --gains=6,5 --tau=1 --eps=0.01 --g=\"exp(-x1^2)\"",
    "--n 2 --mu \"exp(a=1)\" --gains=6,5 --tau=1 --eps=0.01 --reference=input",
];

const LIMITS: [&str; 4] =
    ["--u-max=5", "--u-max=5 --u-min=-1", "--u-max=inf --u-min=-1", "--u-max=5 --u-min=-inf"];

/// Status and u of `step` at times and states of all sizes.
fn swept(design: &str) -> Vec<(i32, f64)> {
    let report = report(design);
    let law = Law::of(&report.spec);
    let program = passes::optimise(lower(&report.spec, &law), &mut |_, _| {});
    let emitted = Controller { report: &report, law: &law, program: &program, measured: &[] };
    let code = whole(&emitted);
    let zero = report.spec.run_time_parameters().map(|p| (p, 0.0));
    let mut controller = Instance::with_parameters(&code, zero).expect("legal parameters");
    let greatest = if design.contains("f32") { f64::from(f32::MAX) } else { f64::MAX };
    let sizes = [0.0, 0.5, greatest.sqrt(), 1e-3 * greatest, 0.9 * greatest, greatest];
    let values: Vec<_> = sizes.iter().flat_map(|size| [*size, -size]).collect();
    let mut found = Vec::new();
    for t in [0.0, 0.7, 0.995, 1.5] {
        for x1 in &values {
            for x2 in &values {
                let x = [*x1, *x2, 0.0];
                let given = [("t", &[t][..]), ("x", &x[..report.spec.n]), ("r", &[0.0; 3])];
                let count = if design.contains("input") { 3 } else { 2 };
                let outcome = controller.call("step", &given[..count]);
                found.push((
                    outcome.status.number(),
                    outcome.results.get("u").map_or(0.0, |u| u[0]),
                ));
            }
        }
    }
    found
}

#[test]
fn limits_of_u_do_not_hide_an_overflow() {
    for design in CLIPPED {
        let open = swept(&format!("{design} --u-max=inf"));
        let range = Status::Range as i32;
        assert!(open.iter().any(|own| own.0 == range), "{design}");
        for limits in LIMITS {
            let clipped = swept(&format!("{design} {limits}"));
            assert!(clipped.iter().any(|own| own.0 == Status::Saturated as i32), "{design}");
            for (at, (open, own)) in open.iter().zip(&clipped).enumerate() {
                assert_eq!(
                    open.0 == range,
                    own.0 == range,
                    "{design} {limits}: {at}, {open:?}, {own:?}"
                );
                assert!(own.0 != range || own.1 == 0.0, "{design} {limits}: {own:?}");
            }
        }
    }
}
