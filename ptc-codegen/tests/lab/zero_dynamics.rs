//! The check `zeros` of textbook plants, against the zeros of their linearisation by SymPy
//! (`tools/zero_dynamics.py`).

use crate::support::entries;

use ptc_codegen::check::examine::examine;
use ptc_codegen::check::{Outcome, Verdict};
use ptc_codegen::plant::read_design;
use serde_json::Value;

const PLANTS: &str = include_str!("../../../tests/data/zero_dynamics.json");

/// Real parts below this are those of roots on the imaginary axis.
const ON_AXIS: f64 = 1e-9;

fn text(value: &Value) -> &str {
    value.as_str().expect("text")
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|x| x.as_f64().expect("a number")).collect()
}

fn zeros(plant: &Value) -> Outcome {
    let design = &plant["design"];
    let poles: Vec<_> =
        (0..plant["degree"].as_u64().expect("a degree")).map(|i| -4.0 - i as f64).collect();
    let rates = design["dynamics"].as_object().expect("rates").iter();
    let rates: Vec<_> = rates.map(|(state, rate)| format!("{state} = {rate}")).collect();
    let text = format!(
        "mu = \"exp(a=1)\"\npoles = {poles:?}\nreference = {}\n[params]\ntau = 1\nt0 = 0\neps = 0.01\nu_max = inf\n\
         [model]\nstates = {}\ninput = \"u\"\noutput = {}\ndynamics = {{ {} }}\n",
        design["reference"],
        design["states"],
        design["output"],
        rates.join(", ")
    );
    let (spec, _) =
        read_design(&entries(&text)).unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"));
    let found = examine(&spec).outcomes.into_iter().find(|outcome| outcome.name == "zeros");
    found.expect("a model")
}

/// The real parts of the numbers behind a word, up to the next words.
fn after(text: &str, word: &str) -> Vec<f64> {
    let Some((_, rest)) = text.split_once(word) else { return Vec::new() };
    let end = rest.find(" 1/s").unwrap_or(rest.len());
    rest[..end].split(", ").filter_map(|part| real(part.split(' ').next()?)).collect()
}

/// The real part of `-0.05+3.162i`.
fn real(number: &str) -> Option<f64> {
    let Some(complex) = number.strip_suffix('i') else { return number.parse().ok() };
    let signs = complex.char_indices().skip(1).filter(|(_, c)| ['+', '-'].contains(c));
    let mut ends = signs.filter(|(at, _)| !complex[..*at].ends_with('e')).map(|(at, _)| at);
    ends.next().map_or(Some(0.0), |end| complex[..end].parse().ok())
}

/// The values of the states in `at the rest point x = 1, v = 0, u = 2`.
fn place(summary: &str, states: usize) -> Vec<f64> {
    let Some((_, rest)) = summary.split_once("rest point ") else { return vec![0.0; states] };
    let parts = rest.split(", ").take(states).filter_map(|part| part.split_once(" = "));
    parts.filter_map(|(_, value)| value.split([' ', ':']).next()?.parse().ok()).collect()
}

fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-3 * b.abs().max(1e-6)
}

/// The real parts of the roots and the verdict are those of the linearisation at the rest point.
#[test]
fn zeros_of_textbook_plants_match_their_linearisation() {
    let plants: Vec<Value> = serde_json::from_str(PLANTS).expect("JSON");
    assert!(plants.len() >= 24);
    for plant in &plants {
        let found = zeros(plant);
        let shown = format!("{}: {found:?}", text(&plant["name"]));
        let states = plant["design"]["states"].as_array().expect("states").len();
        let roots = plant["roots"].as_array().expect("roots").iter().map(numbers);
        let roots: Vec<_> = roots.map(|root| root[0]).collect();
        let most = roots.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let verdict = match plant["singular"].as_bool() {
            Some(true) => Verdict::Unsound,
            _ if most.abs() <= ON_AXIS => Verdict::Undecided,
            _ if most > 0.0 => Verdict::Unsound,
            _ => Verdict::Sound,
        };
        let degree = format!("the relative degree is {}", plant["degree"]);
        if plant["singular"] == true {
            assert_eq!(found.verdict, verdict, "{shown}");
            assert!(found.summary.contains("is 0 at"), "{shown}");
            continue;
        }
        assert!(found.summary.contains(&degree), "{shown}");
        if roots.is_empty() {
            assert!(found.verdict == verdict && found.summary.starts_with("none"), "{shown}");
            continue;
        }
        let rest = numbers(&plant["rest"]);
        let is_there = |words: &str| {
            let at = place(words, states);
            at.len() == states && at.iter().zip(&rest).all(|(a, b)| is_near(*a, *b))
        };
        let points = points(&found);
        let own = points.iter().find(|(_, words)| is_there(words));
        let (said, words) = own.unwrap_or_else(|| panic!("{rest:?} {shown}"));
        assert_eq!(*said, verdict, "{shown}");
        // One of several rest points decides alone only where it is the nearest one and stable, or none is.
        let others_are_stable = points.iter().any(|(said, _)| *said == Verdict::Sound);
        assert!(found.verdict == points[0].0 || others_are_stable, "{shown}");
        let told = after(words, "the roots ");
        assert!(!told.is_empty(), "{shown}");
        for root in &roots {
            assert!(told.iter().any(|told| is_near(*told, *root)), "{root} {shown}");
        }
    }
}

/// Returns the verdict and the text for each rest point.
fn points(found: &Outcome) -> Vec<(Verdict, &str)> {
    let first = match found.summary.contains("at another rest point they are stable") {
        true => Verdict::Unsound,
        false => found.verdict,
    };
    let verdicts = [
        ("sound: ", Verdict::Sound),
        ("unsound: ", Verdict::Unsound),
        ("undecided: ", Verdict::Undecided),
    ];
    let others = found.details.iter().filter_map(|detail| {
        verdicts.iter().find_map(|(word, said)| Some((*said, detail.strip_prefix(word)?)))
    });
    [(first, found.summary.as_str())].into_iter().chain(others).collect()
}
