//! Designs on which checks have stumbled.

use crate::command::spec_of;
use crate::verdicts::verdict;

use ptc_codegen::check::Verdict;
use ptc_codegen::emit::Language;
use ptc_codegen::generate;
use ptc_codegen::request::Feedback;

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

/// The states of the infinite-time system are those of a chain, which a model does not have.
#[test]
fn an_associated_system_has_no_model() {
    let text = "mu = \"exp(a=1)\"\npoles = [-6, -3]\nwhat = \"associated\"\n[params]\ntau = 2\nt0 = 0\n[model]\n\
                states = [\"h\", \"q\"]\ninput = \"u\"\noutput = \"h\"\ndynamics = \"q - 0.5*h, u\"\n";
    let found = ptc_codegen::request::read(&crate::support::entries(text)).expect_err("a mistake");
    assert!(
        found.iter().any(|d| d.key == "what" && d.help.contains("leave `what` out")),
        "{found:#?}"
    );
}
