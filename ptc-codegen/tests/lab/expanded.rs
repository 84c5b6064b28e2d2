//! Closed forms of another engine: with those that the library would have found, everything is as
//! without them, and a custom mapping is computed from its r_k.

use ptc_codegen::Accepted;
use ptc_codegen::algebra::{Poly, integer};
use ptc_codegen::check::examine::{examine, examine_expanded};
use ptc_codegen::emit::Language;
use ptc_codegen::expansion::{self, ClosedForms, Expanded, bell};
use ptc_codegen::expression::{Expression, Variable};
use ptc_codegen::family::Family;
use ptc_codegen::mapping::{Form, Mapping};
use ptc_codegen::request::Spec;

use crate::support;

use support::design;

/// The forms of a family as the library expands them.
fn own(spec: &Spec) -> Expanded {
    let ring: Mapping = spec.ring().expect("a family");
    let bell: Vec<Vec<Poly>> = match spec.is_iterated() {
        true => bell::bell_table(spec.n),
        false => expansion::table(&ring, spec.n),
    };
    Expanded::Family(ClosedForms { r: expansion::r(&ring, spec.n), bell })
}

#[test]
fn the_forms_of_a_family_are_the_same_from_every_engine() {
    for family in [Family::Exp, Family::Power, Family::Tan, Family::Algebraic, Family::ExpSum] {
        let spec = Spec::new(3, family);
        let (plain, given) = (examine(&spec), examine_expanded(&spec, Some(own(&spec))));
        assert_eq!(plain.outcomes, given.outcomes);
        let files = |report| Accepted::of(report)?.files(Language::C, &[]);
        assert_eq!(files(plain), files(given), "{family:?}");
        // Others give another program: they are used.
        let Expanded::Family(mut forms) = own(&spec) else { panic!("a family") };
        let all = forms.bell.iter_mut().flatten().chain(&mut forms.r);
        all.for_each(|form| *form = form.scaled(&integer(2)));
        let doubled = Expanded::Family(forms);
        let lowered = |forms: Option<&Expanded>| ptc_codegen::dump(&spec, forms, "lower");
        assert_eq!(lowered(None), lowered(Some(&own(&spec))));
        assert_ne!(lowered(None), lowered(Some(&doubled)), "{family:?}");
    }
}

#[test]
fn a_custom_mapping_is_computed_from_its_derivatives() {
    let (mut spec, _) = design(
        "n = 2\nkappa = \"-ln(1 - dt/tau)/a + dt/tau\"\ngains = [6, 5]\nsample_time = 1e-3\n\
         x0_max = [1, 1]\n[params]\ntau = 2\na = 1\neps = 1e-2\nt0 = 0\n",
    );
    spec.engine = Some("another");
    let custom = spec.custom().expect("a mapping");
    let Form::Kappa(kappa) = &custom.form else { panic!("kappa is given") };
    let first = Expression::from(Variable::TimeToGo).mul(kappa.rate.clone());
    // D = r_1 d/dDt, and time-to-go falls as time goes on.
    let second = first.clone().mul(first.derivative(Variable::TimeToGo).neg());
    let forms = Expanded::Custom(vec![first, second]);
    let report = examine_expanded(&spec, Some(forms.clone()));
    let plain = examine(&spec);
    for (own, other) in plain.outcomes.iter().zip(&report.outcomes) {
        assert_eq!((own.name, own.verdict), (other.name, other.verdict));
    }
    let reached = |report: &ptc_codegen::check::examine::Report| {
        report.worst.as_ref().expect("a worst case").states[0].attained()
    };
    let (one, other) = (reached(&plain), reached(&report));
    assert!((one - other).abs() <= 1e-9 * one, "{one} and {other}");
    assert_ne!(
        ptc_codegen::dump(&spec, None, "lower"),
        ptc_codegen::dump(&spec, Some(&forms), "lower")
    );
    let files = Accepted::of(report).and_then(|own| own.files(Language::C, &[])).expect("C");
    assert!(files[0].text.contains("expanded by the engine another:"), "{}", files[0].text);
    assert!(files[0].text.contains("--engine another"));
}
