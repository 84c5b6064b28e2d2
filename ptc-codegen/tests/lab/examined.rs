//! Checks of designs that take long: many samples, every eps, and expressions made to be hard to prove.

use crate::command::spec_of;
use crate::verdicts::{report, verdict};

use num_traits::ToPrimitive;
use ptc_codegen::check::Verdict;
use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::parameter::{Fixed, Parameter};

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

/// Largest |x_i| at the deadline in the worst case, as a fraction of its bound.
fn share(report: &Report, errors: [f64; 2]) -> f64 {
    let worst = report.worst.as_ref().expect("a worst case");
    let shares = worst.states.iter().zip(errors).map(|(state, error)| state.total() / error);
    shares.fold(0.0, f64::max)
}

/// Every eps of whole periods is tried.
#[test]
fn an_open_eps_in_samples_is_the_best_hold() {
    let line = "--n 2 --mu \"exp(a=1)\" --poles=-4,-5 --clock samples --tau=1 --sample-time=0.025 \
                --error=0.01,0.1 --x0-max=1,1 --margin-gain=1 --margin-delay=0";
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

/// Processor seconds of this thread, which no other thread adds to; 0 if the system does not report them.
fn processor_seconds() -> f64 {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    told.split_whitespace().next().and_then(|ns| ns.parse::<f64>().ok()).map_or(0.0, |ns| ns / 1e9)
}

#[test]
fn nothing_hangs_or_panics() {
    let nested = |around: &str, core: &str, times: usize| {
        (0..times).fold(core.to_owned(), |inner, _| around.replace('#', &inner))
    };
    let mut examined = 0;
    let many = (1..60).map(|k| format!("exp(-{k}*@)/{k}")).collect::<Vec<_>>().join(" + ");
    for text in [
        nested("tan(#)", "@", 20),
        nested("exp(-(@ + #))", "@", 12),
        nested("sqrt(1 + (#)^2)", "@", 12),
        nested("ln(1 + #)*atan(#)", "@", 5),
        nested("(#)^(#)", "@", 4),
        nested("abs(# - 1)", "@", 15),
        nested("min(#, 1/(#))", "@", 4),
        nested("((#)^9 + 1)", "@", 5),
        nested("exp(#)", "@", 15),
        nested("1/(1 + #)", "@", 20),
        nested("tanh(sinh(#))", "@", 8),
        format!("tau*(1 - ({many}))"),
        "@/0.0000000000000000000001 + 1e300*@^64 - @^0.3333333333333333333333".to_owned(),
        "0^@ + 0/@ + (0*@)^(-2)".to_owned(),
        "1/(@ - @) + ln(@ - @) + sqrt(-@)".to_owned(),
        "(-2)^@ + (-@)^(1/3)".to_owned(),
        "((@^64)^64)^64 + exp(exp(exp(1e300*@)))".to_owned(),
        "sin(1e300*@)*cos(exp(@)) + tan(@^30)".to_owned(),
    ] {
        let began = processor_seconds();
        // It may be refused; within the effort that the checks give it, and so within their time.
        for (key, time) in [("mu", "t"), ("kappa", "dt")] {
            let line =
                format!("--n 3 --{key} \"{}\" --gains=6,11,6 --tau=1", text.replace('@', time));
            if let Ok(spec) = spec_of(&line) {
                let _ = examine(&spec);
                examined += 1;
            }
        }
        let taken = processor_seconds() - began;
        assert!(taken < 20.0, "{text}: {taken} s");
    }
    assert!(examined > 20, "{examined} were examined");
}
