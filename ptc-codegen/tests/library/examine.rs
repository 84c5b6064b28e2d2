//! Designs on which checks have stumbled.

use crate::command;

use command::spec_of;
use num_traits::ToPrimitive;
use ptc_codegen::check::Verdict;
use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::emit::Language;
use ptc_codegen::generate;
use ptc_codegen::parameter::{Fixed, Parameter};
use ptc_codegen::request::Feedback;

fn report(line: &str) -> Report {
    examine(&spec_of(line).unwrap_or_else(|found| panic!("{line}: {}", found[0])))
}

/// What the check called `name` says of a design.
fn verdict(line: &str, name: &str) -> Verdict {
    report(line).outcomes.iter().find(|outcome| outcome.name == name).expect("a check").verdict
}

#[test]
fn a_law_that_is_linear_is_gains_in_any_spelling() {
    let with = |law: &str| {
        let line = format!("--n 3 --mu \"tanh(a=1)\" {law} --tau=2");
        spec_of(&line).unwrap_or_else(|found| panic!("{line}: {}", found[0]))
    };
    for (law, gains) in [
        ("-6*xi1 - 11*xi2 - 6*xi3", "6,11,6"),
        ("-(6*xi1 + 11*xi2) - 6*xi3", "6,11,6"),
        ("-6*(xi1 + 2*xi2) + xi2 - 3*(xi3 + xi3)", "6,11,6"),
        ("-xi1/3 - 2^3*xi2 - sqrt(4)*xi3", "1/3,8,2"),
        ("-((xi1 + 1)^2 - xi1^2 - 1) - xi3/0.5", "2,0,2"),
        ("5*xi2", "0,-5,0"),
    ] {
        let (found, given) = (with(&format!("--pi0=\"{law}\"")), with(&format!("--gains={gains}")));
        assert_eq!(found, given, "{law}");
        assert_eq!(generate(&found, Language::C), generate(&given, Language::C), "{law}");
        assert_ne!(verdict(&given.command(), "growth"), Verdict::NotChecked, "{law}");
    }
    for law in [
        "-6*xi1 - 11*xi2 - 6*xi3 + 1",
        "-6*xi1*(1 + t)",
        "-6*xi1 - xi1_0",
        "-6*xi1 - abs(xi2)",
        "-6*xi1^1.5",
        "-6*xi1*xi2",
        "-c*xi1",
        "-sqrt(2)*xi1",
        "-xi1 + sin(xi2)",
        "0*xi1",
    ] {
        let spec = with(&format!("--pi0=\"{law}\""));
        assert!(matches!(spec.feedback, Feedback::Expression(_)), "{law}");
    }
}

#[test]
fn an_envelope_needs_no_gains() {
    // 1/g may be infinite: 1 + cos(x1) has zeros, though not at a corner.
    let with_gain = "--n 2 --mu \"exp(a=1)\" --gains=6,5 --g=\"1 + cos(x1)\" --tau=2 --eps=0.1 \
                     --x-max=10,10";
    assert_eq!(verdict(with_gain, "envelope"), Verdict::Undecided);
    let law = "--n 1 --mu \"exp(a=1)\" --pi0=\"-exp(xi1)\" --tau=2 --eps=0.1 --x-max=1000";
    assert_eq!(verdict(law, "envelope"), Verdict::Refuted);
}

/// Far from 0 the numbers of t are further apart than samples are, and than eps is.
#[test]
fn time_that_cannot_be_told_apart_is_not_taken_as_exact() {
    let line = "--n 2 --mu \"exp(a=1)\" --poles=-4,-5 --tau=0.5 --eps=1e-2 --sample-time=1e-3 \
                --error=1e-3 --x0-max=1,1";
    for (far, sampling, deadline) in [
        ("--t0=1e12", Verdict::Sound, Verdict::Sound),
        ("--t0=1e14", Verdict::Undecided, Verdict::Undecided),
        ("--t0=-1e17", Verdict::Unsound, Verdict::Unsound),
        ("--t0=1000 --precision=f32", Verdict::Sound, Verdict::Sound),
        ("--t0=16384 --precision=f32", Verdict::Undecided, Verdict::Sound),
        ("--t0=1e6 --precision=f32", Verdict::Undecided, Verdict::Undecided),
        ("--t0=2e7 --precision=f32", Verdict::Unsound, Verdict::Unsound),
    ] {
        let line = format!("{line} {far}");
        assert_eq!(verdict(&line, "sampling"), sampling, "{far}");
        // Where the loop is decided, that is what counts.
        let looped = verdict(&line, "loop");
        assert_ne!(looped, Verdict::Unsound, "{far}");
        if looped != Verdict::Sound {
            assert_eq!(verdict(&line, "deadline"), deadline, "{far}");
        }
    }
}

/// The eps that `error` allows for short periods is 0.036 s, at which the loop is not stable.
#[test]
fn an_eps_that_fails_in_the_loop_gives_way() {
    let line = "--n 2 --mu \"exp(a=1)\" --poles=-4,-5 --tau=1 --sample-time=0.02 --error=1e-3,1e-2 \
                --x0-max=1,0.5";
    for check in ["sampling", "loop"] {
        assert_eq!(verdict(line, check), Verdict::Sound, "{check}");
        assert_eq!(verdict(&format!("{line} --eps=0.036"), "sampling"), Verdict::Unsound);
    }
}

/// The eps of a design in samples, in samples.
fn hold(report: &Report) -> u32 {
    let eps = report.spec.fixed.get(&Parameter::Eps).and_then(Fixed::number);
    (eps.and_then(ToPrimitive::to_f64).expect("an eps") / 0.025).round() as u32
}

/// What |x_i| at the deadline is at worst, in parts of its bound.
fn share(report: &Report, errors: [f64; 2]) -> f64 {
    let worst = report.worst.as_ref().expect("a worst case");
    let shares = worst.states.iter().zip(errors).map(|(state, error)| state.total() / error);
    shares.fold(0.0, f64::max)
}

/// Every eps of whole periods is tried.
#[test]
fn an_open_eps_in_samples_is_the_best_hold() {
    let line = "--n 2 --mu \"exp(a=1)\" --poles=-4,-5 --clock samples --tau=1 --sample-time=0.025 \
                --error=0.01,0.1 --x0-max=1,1";
    for (noise, quiet) in [("1e-3,1e-2", false), ("1e-9,1e-9", true)] {
        let line = format!("{line} --noise={noise}");
        let chosen = report(&line);
        let tried = (2..40).chain([0]).map(|samples: u32| {
            let eps = f64::from(samples) * 0.025;
            share(&report(&format!("{line} --eps={eps:.3}")), [0.01, 0.1])
        });
        let best = tried.fold(f64::INFINITY, f64::min);
        let own = share(&chosen, [0.01, 0.1]);
        assert!(own <= best * 1.001, "{own} at a hold of {}, best {best}", hold(&chosen));
        assert_eq!(hold(&chosen) == 0, quiet, "deadbeat is for exact sensors");
    }
    assert_eq!(hold(&report(line)), 0, "nothing disturbs this loop");
}
