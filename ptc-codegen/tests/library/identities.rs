//! Two spellings of one function have one verdict, and bounds that are close.

use proptest::prelude::*;
use ptc_codegen::check::Verdict;

use crate::verdicts::report;

/// A formula in two spellings: as it is drawn, and rewritten by identities throughout.
#[derive(Clone, Debug)]
struct Spelled {
    plain: String,
    rewritten: String,
}

impl Spelled {
    fn of(plain: String, rewritten: String) -> Self {
        Self { plain, rewritten }
    }

    /// `template` with each spelling in place of `#`.
    fn within(&self, plain: &str, rewritten: &str) -> Self {
        let put = |template: &str, inner: &str| template.replace('#', &format!("({inner})"));
        Self::of(put(plain, &self.plain), put(rewritten, &self.rewritten))
    }
}

/// Functions of a number between -1 and 1, and what they are by others.
const INSIDE: [[&str; 2]; 11] = [
    ["atanh(0.6*#)", "0.5*ln((1 + 0.6*#)/(1 - 0.6*#))"],
    ["tan(#)", "sin(#)/cos(#)"],
    ["sinh(#)", "(exp(#) - exp(-#))/2"],
    ["cosh(#)", "(exp(#) + exp(-#))/2"],
    ["tanh(#)", "(1 - exp(-2*#))/(1 + exp(-2*#))"],
    ["asin(0.6*#)", "atan(0.6*#/sqrt(1 - (0.6*#)^2))"],
    ["acos(0.6*#)", "pi/2 - atan(0.6*#/sqrt(1 - (0.6*#)^2))"],
    ["(1.5 + #)^0.3", "exp(0.3*ln(1.5 + #))"],
    ["sqrt(2 + #)", "(2 + #)^0.5"],
    ["cbrt(2 + #)", "exp(ln(2 + #)/3)"],
    ["2*sin(#)", "sin(#)*2"],
];

/// A function of a function of `inner`, which is between -1 and 1.
fn spelled(inner: &'static str) -> impl Strategy<Value = Spelled> {
    let share = prop::sample::select(vec!["0.25", "0.5", "0.9"]);
    let one = prop::sample::select(INSIDE.to_vec());
    (share, one.clone(), one, any::<bool>()).prop_map(move |(share, first, second, nested)| {
        let leaf = Spelled::of(format!("{share}*{inner}"), format!("{inner}*{share}"));
        let value = leaf.within(first[0], first[1]);
        // All of them are within -4 and 4.
        if nested { value.within("0.2*#", "#*0.2").within(second[0], second[1]) } else { value }
    })
}

/// The verdict of a check, and the bounds of |x1| and |x2| that it gives.
fn found(line: &str, check: &str) -> (Verdict, Vec<f64>) {
    let report = report(line);
    let outcome = report.outcomes.iter().find(|outcome| outcome.name == check).expect("a check");
    let bound = |text: &str| {
        let (_, rest) = text.split_once("| <= ")?;
        rest.split([':', ',', ' ']).next()?.parse().ok()
    };
    let texts = outcome.details.iter().filter(|note| note.starts_with("|x"));
    (outcome.verdict, texts.filter_map(|note| bound(note)).collect())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn equivalent_references_get_the_same_loop_verdict(formula in spelled("sin(t)")) {
        let line = |reference: &str| format!(
            "--n 2 --mu \"exp(a=1)\" --clock samples --sample-time 1e-2 --poles=-4,-5 --x0-max 0.1,0.1 \
             --error 1e-2,1 --tau 0.1 --eps 0 --u-max inf --reference \"0.1*({reference})\""
        );
        let [plain, rewritten] =
            [&formula.plain, &formula.rewritten].map(|text| found(&line(text), "loop"));
        prop_assert_eq!(plain.0, rewritten.0, "{:?}", formula);
        prop_assert_eq!(plain.1.len(), rewritten.1.len());
        for (a, b) in plain.1.iter().zip(&rewritten.1) {
            // Enclosures over cells of time differ by what they lose of dependencies.
            prop_assert!(*a <= 4.0 * b && *b <= 4.0 * a, "{a} {b}: {formula:?}");
        }
    }

    #[test]
    fn equivalent_drifts_get_the_same_verdicts(formula in spelled("cos(x1)*sin(x1)")) {
        let line = |f: &str| format!(
            "--n 2 --mu \"exp(a=1)\" --gains=20,9 --tau=1 --t0=0 --eps=1e-2 --u-max=inf --x-max=4,4 --f=\"{f}\""
        );
        for check in ["envelope", "growth"] {
            let [plain, rewritten] =
                [&formula.plain, &formula.rewritten].map(|text| found(&line(text), check).0);
            prop_assert_eq!(plain, rewritten, "{}: {:?}", check, formula);
        }
    }

    /// Beyond the domain of a form, at it and within.
    #[test]
    fn equivalent_forms_share_their_domain(
        at in -1.9..3.0f64,
        forms in prop::sample::select(INSIDE.to_vec()),
    ) {
        let verdict = |form: &str| {
            let f = form.replace('#', &format!("(x1 + {at:.3})"));
            let line = format!(
                "--n 1 --mu \"exp(a=1)\" --gains=2 --tau=1 --t0=0 --eps=1e-2 --u-max=inf --x-max=1e-9 --f=\"{f}\""
            );
            found(&line, "envelope").0
        };
        let [plain, rewritten] = forms.map(verdict);
        prop_assert_eq!(plain, rewritten, "{:?} at {}", forms, at);
    }
}

#[test]
fn equivalent_functions_get_the_same_verdict() {
    let samples = |reference: &str| {
        format!(
            "--n 2 --mu \"exp(a=1)\" --clock samples --sample-time 1e-2 --poles=-4,-5 --x0-max 0.1,0.1 \
             --error 1e-2,1 --tau 0.2 --eps 0 --u-max inf --reference \"{reference}\""
        )
    };
    for reference in [
        "0.1*atanh(0.5*sin(t))",
        "0.05*ln((1+0.5*sin(t))/(1-0.5*sin(t)))",
        "(1.5+sin(t))^0.3",
        "exp(0.3*ln(1.5+sin(t)))",
    ] {
        let (verdict, bounds) = found(&samples(reference), "loop");
        assert_eq!(verdict, Verdict::Sound, "{reference}: {bounds:?}");
        assert!(bounds[1] < 1e-5, "{reference}: {bounds:?}");
    }
    for f in [
        "-tan(2*cos(x1)*sin(x1))",
        "-sin(2*cos(x1)*sin(x1))/cos(2*cos(x1)*sin(x1))",
        "atanh(1.5*cos(x1)*sin(x1))",
        "asin(1.9*cos(x1)*sin(x1))",
    ] {
        let line = format!(
            "--n 2 --mu \"exp(a=1)\" --gains=20,9 --tau=1 --t0=0 --eps=1e-2 --u-max=inf --x-max=4,4 --f=\"{f}\""
        );
        assert_eq!(found(&line, "envelope").0, Verdict::Sound, "{f}");
    }
}
