//! Designs on which checks have stumbled.

#[path = "../../tests/support/command.rs"]
mod command;

use command::spec_of;
use ptc_codegen::check::Verdict;
use ptc_codegen::check::examine::examine;

/// What the check called `name` says of a design.
fn verdict(line: &str, name: &str) -> Verdict {
    let spec = spec_of(line).unwrap_or_else(|found| panic!("{line}: {}", found[0]));
    let report = examine(&spec);
    report.outcomes.iter().find(|outcome| outcome.name == name).expect("a check").verdict
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
