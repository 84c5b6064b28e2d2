//! The head of an emitted file says what is true of its controller, in each language.

use crate::support;

use ptc_codegen::emit::Language;
use ptc_codegen::generate;
use support::design;

/// The languages whose files have a head.
const LANGUAGES: [Language; 6] = [
    Language::C,
    Language::Rust,
    Language::Cpp,
    Language::Matlab,
    Language::Python,
    Language::StructuredText,
];

/// The first file of a design, its lines joined where they were broken.
fn emitted(text: &str, language: Language) -> String {
    let files = generate(&design(text).0, language).expect("a controller");
    let lines = files[0].text.lines();
    let words = lines.flat_map(|line| {
        line.trim_start_matches([' ', '*', '/', '!', '%']).split_whitespace().map(str::to_owned)
    });
    words.collect::<Vec<_>>().join(" ")
}

fn holds(text: &str, language: Language, present: &[&str], absent: &[&str]) {
    let found = emitted(text, language);
    for part in present {
        assert!(found.contains(part), "{text}: {part} is missing:\n{found}");
    }
    for part in absent {
        assert!(!found.contains(part), "{text}: {part} is there:\n{found}");
    }
}

#[test]
fn the_plant_has_its_input_gain() {
    for language in LANGUAGES {
        let wrong = ["to rest at", "' = u ", "cycles"];
        let present = ["Plant: x1' = x2, x2' = f + g u.", "g u in U/s^2", "g = 2 + x1*x1"];
        holds("n = 2\nmu = \"exp\"\ng = \"2 + x1*x1\"\n", language, &present, &wrong);
        holds("n = 1\nmu = \"exp\"\n", language, &["Plant: x1' = f + u."], &["g u", "/g"]);
    }
}

#[test]
fn an_element_says_which_gain_it_is() {
    for (language, first, last) in [
        (Language::C, "k[0] is k_1 [1/s^3]", "k[2] is k_3 [1/s]"),
        (Language::Cpp, "k[0] is k_1 [1/s^3]", "k[2] is k_3 [1/s]"),
        (Language::Rust, "k[0] is k_1 [1/s^3]", r"k\[2\] is k_3 \[1/s\]"),
        (Language::Python, "k[0] is k_1 [1/s^3]", "k[2] is k_3 [1/s]"),
        (Language::Matlab, "k(1) is k_1 [1/s^3]", "k(3) is k_3 [1/s]"),
        (Language::StructuredText, "k[1] is k_1 [1/s^3]", "k[3] is k_3 [1/s]"),
    ] {
        holds("n = 3\nmu = \"exp\"\n", language, &[first, last], &["unit unit", "s^(i"]);
    }
    let many = "n = 5\nmu = \"exp_sum(2)\"\n";
    let present = ["k[0] is k_1 [1/s^5], ..., k[4] is k_5 [1/s]", "rates[1] is a_2 [1/s]"];
    holds(many, Language::C, &present, &[]);
    let fixed = "n = 2\nmu = \"exp(a=1)\"\ngains = [12, 7]\n";
    holds(fixed, Language::C, &["k_1 = 12 [1/s^2], fixed: gain of xi_1"], &["k[0]"]);
}

#[test]
fn an_unknown_sample_period_is_loud() {
    let power = "n = 2\nmu = \"power(a=1,m=2)\"\npoles = [-1, -2]\n[params]\ntau = 1\neps = 1e-3\n";
    // u = -2e18 x1 - (3e9 - 3e3) x2 is stable up to h = 2/k_2, to the digits that are shown.
    let limit = ["SAMPLE PERIOD NOT GIVEN", "eps = 1e-3 s", "sample periods below 6.66e-10 s"];
    // A double integrator with poles -3/T, -4/T at T = eps is stable up to h = eps/3.
    let exp = "n = 2\nmu = \"exp(a=1)\"\ngains = [12, 7]\n[params]\ntau = 0.8\neps = 0.01\n";
    let open = "n = 2\nmu = \"exp(a=1)\"\n";
    let law = "n = 1\nmu = \"exp(a=1)\"\npi0 = \"-20*xi1*abs(xi1)\"\n";
    for language in LANGUAGES {
        holds(power, language, &limit, &[]);
        holds(exp, language, &["sample periods below 0.00333 s"], &[]);
        holds(open, language, &["SAMPLE PERIOD NOT GIVEN", "--sample-time"], &["below 0"]);
        holds(law, language, &["SAMPLE PERIOD NOT GIVEN", "ptc-codegen simulate"], &[]);
        let checked = exp.replace("[params]", "sample_time = 1e-3\n[params]");
        holds(&checked, language, &["sampling: sound"], &["SAMPLE PERIOD"]);
    }
    let late = open.replace("n = 2", "n = 2\nsample_time = 1e-3");
    holds(&late, Language::C, &["SAMPLE PERIOD NOT CHECKED"], &["NOT GIVEN"]);
}

#[test]
fn a_check_that_failed_and_was_allowed_is_loud() {
    let text = "n = 2\nmu = \"exp(a=1)\"\npoles = [-1, -2]\nallow = [\"growth\"]\n";
    holds(text, Language::C, &["growth: UNSOUND, ALLOWED BY THE DESIGN"], &[]);
}

#[test]
fn what_follows_the_deadline_and_the_bound_is_told_as_it_is() {
    let with = |rest: &str| format!("n = 2\nmu = \"exp_sum\"\n{rest}");
    holds(&with(""), Language::C, &["and after the deadline, the gains of T = eps are held"], &[]);
    let zero = ["From t0 + tau on, u = 0 (status AFTER)", "it takes at most 12"];
    holds(&with("after = \"zero\"\n"), Language::C, &zero, &["and after the deadline"]);
    let own = "after = \"extern\"\n[params]\nu_max = inf\n";
    let present = ["result of the user-defined function after", "u is not clipped"];
    holds(&with(own), Language::C, &present, &["u <= u_max"]);
    holds(&with(""), Language::C, &["no pointer is NULL"], &[]);
    holds(&with(""), Language::Python, &["t >= t0"], &["pointer"]);
}

#[test]
fn units_follow_from_that_of_x1() {
    let cases: [(&str, &[&str], &[&str]); 4] = [
        (
            "n = 3\nmu = \"exp\"",
            &["x1 in rad, x2 in rad/s, x3 in rad/s^2, u in rad/s^3.", "bound of |u| [rad/s^3]"],
            &["any unit", "unit of u"],
        ),
        (
            "n = 5\nmu = \"exp\"",
            &["x1 in rad, x2 in rad/s, ..., x5 in rad/s^4, u in rad/s^5."],
            &["U/s"],
        ),
        ("n = 1\nmu = \"exp\"\ng = 2", &["x1 in rad, g u in rad/s.", "[unit of u]"], &["U/s"]),
        (
            "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\npoles = [-4, -5]",
            &["x1 in rad, x2 in rad/s, u in rad/s^2.", "[rad/s^2]"],
            &["any unit", "unit of u"],
        ),
    ];
    for (text, present, absent) in cases {
        let text = format!("units = \"rad\"\n{text}\n");
        let in_samples = text.contains("samples");
        let has = |language| !in_samples || !matches!(language, Language::Matlab);
        for language in LANGUAGES.into_iter().filter(|language| has(*language)) {
            holds(&text, language, present, absent);
        }
    }
}

/// A refusal gives the legal range of a parameter, under its own name.
#[test]
fn a_refusal_names_what_is_legal() {
    let bounded = "n = 1\nmu = \"exp\"\nf = \"-c*x1\"\n[params]\nc = [0.5, 2]\n";
    let rates = "n = 1\nmu = \"exp_sum(2)\"\n";
    let period = "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\n";
    for language in [Language::Python, Language::Matlab] {
        holds(bounded, language, &["legal: from 0.5 to 2"], &[">= p_c"]);
        holds(rates, language, &["legal: from 1e-150 to 1e150"], &[">= a1"]);
    }
    holds(period, Language::Python, &[], &["legal: >= 1e-200"]);
}
