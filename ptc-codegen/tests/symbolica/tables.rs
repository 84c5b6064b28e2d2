//! Tables A1 and A2 of the letter, with the two entries that are misprinted in it corrected.

use serde_json::{Value, json};

/// R_{k,m} by k and m: terms as a coefficient and orders of derivatives with their powers.
type Terms = &'static [(&'static str, &'static [(u8, i8)])];

const A1: [(u8, u8, Terms); 15] = [
    (0, 0, &[("1", &[])]),
    (1, 0, &[]),
    (1, 1, &[("1", &[(2, 1)])]),
    (2, 0, &[]),
    (2, 1, &[("1", &[(3, 1)])]),
    (2, 2, &[("3", &[(2, 2)])]),
    (3, 0, &[]),
    (3, 1, &[("1", &[(4, 1)])]),
    (3, 2, &[("10", &[(2, 1), (3, 1)])]),
    (3, 3, &[("15", &[(2, 3)])]),
    (4, 0, &[]),
    (4, 1, &[("1", &[(5, 1)])]),
    (4, 2, &[("15", &[(2, 1), (4, 1)]), ("10", &[(3, 2)])]),
    (4, 3, &[("105", &[(2, 2), (3, 1)])]),
    (4, 4, &[("105", &[(2, 4)])]),
];

const A2: [(u8, Terms); 5] = [
    (1, &[("1", &[(1, -1)])]),
    (2, &[("-1", &[(1, -3), (2, 1)])]),
    (3, &[("3", &[(1, -5), (2, 2)]), ("-1", &[(1, -4), (3, 1)])]),
    (
        4,
        &[
            ("-15", &[(1, -7), (2, 3)]),
            ("10", &[(1, -6), (2, 1), (3, 1)]),
            ("-1", &[(1, -5), (4, 1)]),
        ],
    ),
    (
        5,
        &[
            ("105", &[(1, -9), (2, 4)]),
            ("-105", &[(1, -8), (2, 2), (3, 1)]),
            ("15", &[(1, -7), (2, 1), (4, 1)]),
            ("10", &[(1, -7), (3, 2)]),
            ("-1", &[(1, -6), (5, 1)]),
        ],
    ),
];

fn sorted(terms: &Value) -> Vec<String> {
    let terms = terms.as_array().expect("a list of terms");
    let mut terms: Vec<_> = terms.iter().map(ToString::to_string).collect();
    terms.sort();
    terms
}

fn terms(terms: Terms) -> Value {
    let term = |(coefficient, powers): &(&str, &[(u8, i8)])| {
        let powers = powers.iter().map(|(order, power)| (order.to_string(), json!(power)));
        let exponents: serde_json::Map<String, Value> = powers.collect();
        json!({ "coefficient": coefficient, "exponents": exponents })
    };
    terms.iter().map(term).collect()
}

#[test]
#[ignore = "needs the engine"]
fn the_published_tables() {
    let shown = super::stdout(&["show", "tables", "--n", "5", "--format", "json"]);
    let shown: Value = serde_json::from_str(&shown).expect("JSON");
    assert_eq!(shown["A1"].as_array().map(Vec::len), Some(A1.len()));
    for (entry, (k, m, wanted)) in shown["A1"].as_array().expect("a table").iter().zip(A1) {
        assert_eq!((&entry["k"], &entry["m"]), (&json!(k), &json!(m)));
        assert_eq!(sorted(&entry["terms"]), sorted(&terms(wanted)), "R_{{{k},{m}}}");
    }
    assert_eq!(shown["A2"].as_array().map(Vec::len), Some(A2.len()));
    for (entry, (k, wanted)) in shown["A2"].as_array().expect("a table").iter().zip(A2) {
        assert_eq!(entry["k"], json!(k));
        assert_eq!(sorted(&entry["terms"]), sorted(&terms(wanted)), "r_{k}");
    }
}

/// The Bell polynomials that every table of them holds, and those of the exponential mapping, which
/// are the Stirling numbers of the second kind.
#[test]
#[ignore = "needs the engine"]
fn bell_polynomials() {
    let shown = super::stdout(&["show", "bell", "--n", "4"]);
    for line in
        ["B_{3,2} = 3*r1*r2", "B_{4,2} = 4*r1*r3 + 3*r2^2", "B_{4,3} = 6*r1^2*r2", "B_{4,4} = r1^4"]
    {
        assert!(shown.lines().any(|shown| shown == line), "{line} is not in\n{shown}");
    }
    let shown = super::stdout(&["show", "bell", "--n", "5", "--mu", "exp(a=1)"]);
    for line in ["B_{5,1} = T", "B_{5,2} = -15*T^2", "B_{5,3} = 25*T^3", "B_{5,4} = -10*T^4"] {
        assert!(shown.lines().any(|shown| shown == line), "{line} is not in\n{shown}");
    }
}
