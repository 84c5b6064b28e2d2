//! Limits of u that are not symmetric, as they are read.

use crate::command::spec_of;

use ptc_codegen::parameter::{Fixed, Parameter};

const CHAIN: &str = "--n 2 --mu \"exp(a=1)\"";

#[test]
fn limits_are_fixed_or_left_to_run_time() {
    for (line, fixed) in [
        ("--u-max=5 --u-min=0", Some("0")),
        ("--u-max=inf --u-min=-1/3", Some("-1/3")),
        ("--u-min=-inf", Some("-inf")),
        ("--u-max=-1 --u-min=-2", Some("-2")),
        ("--u-min=runtime", None),
        ("--u-min=1 --u-max=5", Some("1")),
        ("--u-max=0 --u-min=runtime --clock samples --eps=0.1", None),
    ] {
        let spec = spec_of(&format!("{CHAIN} {line}")).unwrap_or_else(|e| panic!("{line}: {e:?}"));
        let found = spec.fixed.get(&Parameter::UMin).map(Fixed::to_string);
        assert_eq!(found.as_deref(), fixed, "{line}");
        assert!(spec.parameters().contains(&Parameter::UMin), "{line}");
        assert_eq!(spec_of(&spec.command()).as_ref(), Ok(&spec), "{line}: {}", spec.command());
    }
    let symmetric = spec_of(&format!("{CHAIN} --u-max=5")).expect("a design");
    assert!(!symmetric.parameters().contains(&Parameter::UMin));
}

#[test]
fn axes_take_pairs_of_limits() {
    let axes = "--n 2 --axes 3 --mu \"exp(a=1)\"";
    let spec = spec_of(&format!("{axes} --limits=\"[[-1,5],[0,3],2]\"")).expect("a design");
    let [upper, lower] =
        [&spec.axes.as_ref().expect("axes").limits, &spec.axes.as_ref().expect("axes").lower]
            .map(|all| all.iter().map(Fixed::to_string).collect::<Vec<_>>());
    assert_eq!((upper.join(" "), lower.join(" ")), ("5 3 2".to_owned(), "-1 0 -2".to_owned()));
    assert_eq!(spec_of(&spec.command()).as_ref(), Ok(&spec), "{}", spec.command());
    let plain = spec_of(&format!("{axes} --limits=5,3,2")).expect("a design");
    assert!(plain.axes.expect("axes").lower.is_empty() && !plain.u_min);
}

#[test]
fn each_mistake_has_one_message_with_its_fix() {
    for (line, told, help) in [
        ("--u-min=5 --u-max=5", "u_min = 5 is not below u_max = 5", "u_min"),
        ("--u-min=6 --u-max=5", "u_min = 6 is not below u_max = 5", "u_min"),
        ("--u-min=inf", "u_min = `inf` is outside its domain", "< u_max"),
        ("--u-max=-1", "u_max = `-1` is outside its domain", "u_min beside it"),
        ("--u-max=\"[-100, 100]\"", "u_max is one number", "u_min = -100 and u_max = 100"),
        ("--u-min=1 --u-max=2 --after zero", "u = 0 is outside of u_min and u_max", "after"),
        ("--u-min=0.1 --u-max=0.1000000001 --precision f32", "is not below", "u_min"),
        ("--axes 2 --limits=\"[[1,0],[0,1]]\"", "is not a pair of limits", "[lower, upper]"),
        ("--axes 2 --limits=\"[[0,inf],[0,1]]\"", "an axis without a limit", "does not reach"),
        ("--axes 2 --limits=1,2 --u-min=0", "`u_min` beside `limits`", "pairs"),
        ("--u-min=runtme", "u_min = `runtme` is outside its domain", "< u_max"),
        ("--u-min=0 --g \"2 + u_min\"", "`u_min` is the lower limit of u here", "another name"),
    ] {
        let found = spec_of(&format!("{CHAIN} {line}")).expect_err(line);
        assert_eq!(found.len(), 1, "{line}: {found:?}");
        assert!(found[0].message.contains(told), "{line}: {found:?}");
        assert!(found[0].help.contains(help), "{line}: {found:?}");
    }
}

/// A parameter of the user's own keeps the name where no key gives the lower limit.
#[test]
fn a_parameter_may_be_called_u_min() {
    let spec = spec_of(&format!("{CHAIN} --g \"2 + u_min\"")).expect("a design");
    assert!(!spec.u_min && spec.parameters().iter().any(|p| p.key() == "u_min"));
}
