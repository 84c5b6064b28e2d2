//! The spelling of a design reads back as the same design, and what has no spelling is refused.

use crate::command;

use command::spec_of;
use ptc_codegen::expression::Expression;
use ptc_codegen::request::{Feedback, Spec};

fn spec(line: &str) -> Spec {
    spec_of(line).unwrap_or_else(|found| panic!("{line}: {}", found[0]))
}

/// The first mistake.
fn mistake(line: &str) -> String {
    spec_of(line).err().unwrap_or_else(|| panic!("{line} is read"))[0].message.clone()
}

fn law(text: &str) -> Expression {
    match spec(&format!("--n 3 --mu exp --pi0=\"{text}\"")).feedback {
        Feedback::Expression(law) => law,
        other => panic!("{text}: {other:?}"),
    }
}

#[test]
fn designs_round_trip() {
    for (given, told) in [
        // One rate of two is a parameter beside the mapping.
        ("--n 2 --mu exp_sum --param a1=2", "--n 2 --mu \"exp_sum(2)\" --param a1=2"),
        ("--n 1 --mu \"exp_sum(rates=[1,2])\"", "--n 1 --mu \"exp_sum(rates=[1,2])\""),
        ("--fma=true --n 2 --mu exp", "--n 2 --mu exp --fma"),
        ("--fma=false --n 2 --mu exp", "--n 2 --mu exp"),
        ("--latency --fma --n 2 --mu exp", "--n 2 --mu exp --fma --latency"),
        ("--units rad --n 2 --mu exp", "--n 2 --mu exp --units rad"),
        // A shell would look for files called a=1 or a=2.
        ("--n 1 --mu exp --param \"a=[1,2]\"", "--n 1 --mu exp --param \"a=[1,2]\""),
        ("--n 3 --mu exp --poles=-1,-2+3i/2,-2-1.5i", "--n 3 --mu exp --poles=-1,-2+3i/2,-2-1.5i"),
        // A function that has the name of a family.
        ("--n 1 --mu=\"1*tanh(t)\"", "--n 1 --mu=\"tanh(t)\""),
        ("--n 1 --mu=\"tau*(2/4)*exp(t)\"", "--n 1 --mu=\"tau*(1/2)*exp(t)\""),
    ] {
        let spec = spec(given);
        assert_eq!(spec.command(), told);
        assert_eq!(spec_of(told), Ok(spec), "{told}");
    }
}

#[test]
fn invalid_units_are_refused() {
    for (given, told) in [
        ("--n 2 --mu exp --units m/s", "`m/s` is not a unit of x1"),
        ("--n 2 --mu exp --units 5", "`5` is not a unit of x1"),
        ("--n 2 --mu exp --units abcdefghijklmnopq", "`abcdefghijklmnopq` is not a unit of x1"),
        (
            "--mu \"exp(a=1)\" --clock samples --poles=-4,-5 --A \"[[0,1],[0,0]]\" --B \"[0,1]\" --units m",
            "the units of a chain follow from that of x1, and the states of this plant have their own",
        ),
    ] {
        assert_eq!(mistake(given), told, "{given}");
    }
}

#[test]
fn negative_fractions_are_bracketed() {
    for (given, told) in [
        ("xi1^2/(-1/2)", "xi1^2/(-1/2)"),
        ("xi1^2*(-0.5)*3", "xi1^2*(-1/2)*3"),
        ("-0.5*xi1^2", "-1/2*xi1^2"),
        ("xi1^(-1/2)", "xi1^(-1/2)"),
        ("xi1 - (-1/2)", "xi1 - -1/2"),
    ] {
        let expression = law(given);
        assert_eq!(expression.to_string(), told);
        assert_eq!(law(told), expression);
    }
}

#[test]
fn many_arguments_stay_in_one_call() {
    let all = vec!["xi1"; 90].join(", ");
    let expression = law(&format!("min({all}) - max({all})"));
    assert_eq!(expression.to_string(), format!("min({all}) - max({all})"));
    assert_eq!(
        law("max(max(xi1, xi2), max(xi2, xi3))").to_string(),
        "max(xi1, xi2, max(xi2, xi3))"
    );
    for function in ["min", "max", "mean"] {
        let text = format!("{function}({})", vec!["xi1"; 3000].join(","));
        assert!(mistake(&format!("--n 1 --mu exp --pi0=\"{text}\"")).contains("the limit is 99"));
    }
}

/// A few characters can make numbers and expressions of any size.
#[test]
fn oversized_expressions_are_refused() {
    let powers = "--n 1 --mu exp --pi0=\"((1e400^64)^64)^64*xi1\"";
    assert!(mistake(powers).contains("the limit is 4096"));
    let mut families = "a".to_owned();
    for _ in 0..60 {
        families = format!("algebraic(a={families}/tau)");
    }
    assert!(mistake(&format!("--n 1 --mu=\"1*{families}\"")).contains("the limit is 10000"));
    let mut powers = "xi1".to_owned();
    for _ in 0..45 {
        powers = format!("xi1^-{powers}");
    }
    assert!(mistake(&format!("--n 1 --mu exp --pi0=\"{powers}\"")).contains("nesting"));
}

#[test]
fn gains_of_poles_print_every_digit() {
    let spec = spec("--n 2 --mu exp --poles=-12345678901234567.5,-1");
    let gains: Vec<_> = spec.fixed.values().map(ToString::to_string).collect();
    assert_eq!(gains, ["24691357802469135/2", "24691357802469137/2"]);
}

#[test]
fn division_by_zero_in_a_family_is_refused() {
    let found = mistake("--n 1 --kappa=\"mean(exp(a=b), exp(a=0))\"");
    assert_eq!(found, "`exp` with a parameter that is 0 divides by zero");
    assert!(mistake("--n 1 --mu=\"1*power(m=1-1)\"").contains("divides by zero"));
}

#[test]
fn a_name_that_is_wrong_three_times_is_one_mistake() {
    let found = |line: &str| spec_of(line).err().map_or(0, |found| found.len());
    assert_eq!(found("--n 1 --kappa=\"t*t/(tau - t)\""), 1);
    assert_eq!(found("--n 1 --kappa=\"t*x1/(tau - t)\""), 2);
    // Another expression has a mistake of its own.
    assert_eq!(found("--n 1 --kappa=\"t/(tau - t)\" --g=\"xi1\" --f=\"xi1\""), 3);
}

/// Each parameter has a field of its own in the emitted code.
#[test]
fn reserved_names_are_refused() {
    for (line, name) in [
        ("--n 2 --mu=\"tau*(1 - exp(-eps*t))\"", "`eps` is not known where mu"),
        ("--n 2 --kappa=\"t0*dt/(tau - dt)\"", "`t0` is not known where kappa"),
        ("--n 1 --mu=\"tau*(1 - exp(-k*t))\"", "`k` is the gains"),
        ("--n 1 --mu exp_sum --pi0=\"-rates*xi1\"", "`rates` is the rates"),
        ("--n 1 --mu exp --g=\"2 + k\"", "`k` is the gains"),
    ] {
        assert!(mistake(line).starts_with(name), "{}", mistake(line));
    }
    let _ = spec("--n 1 --mu exp --pi0=\"-k*xi1\"");
}
