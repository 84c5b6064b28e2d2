//! The formulas of a report, read as a reader reads them, against values known otherwise.

use std::collections::BTreeMap;

use roxmltree::Node;

use super::{folder, named, parse, report, section, text};

type Values = BTreeMap<String, f64>;

/// The value of a formula: products before sums, a minus before both.
fn value(node: Node<'_, '_>, known: &Values) -> f64 {
    let parts: Vec<_> = node.children().filter(Node::is_element).collect();
    let part = |i: usize| value(parts[i], known);
    let look = |name: String| *known.get(&name).unwrap_or_else(|| panic!("no value of {name}"));
    match node.tag_name().name() {
        "mn" => text(node).parse().expect("a number"),
        "mi" if text(node) == "e" => std::f64::consts::E,
        "mi" if text(node) == "\u{3c0}" => std::f64::consts::PI,
        "mi" => look(text(node)),
        "msub" => look(format!("{}_{}", text(parts[0]), text(parts[1]))),
        "msubsup" => look(format!("{}_{}", text(parts[0]), text(parts[1]))).powf(part(2)),
        "msup" => part(0).powf(part(1)),
        "mfrac" => part(0) / part(1),
        "msqrt" => part(0).sqrt(),
        "mrow" => row(&parts, known),
        other => panic!("{other} has no value"),
    }
}

fn sign(node: Node<'_, '_>) -> Option<String> {
    (node.tag_name().name() == "mo").then(|| text(node))
}

fn row(parts: &[Node<'_, '_>], known: &Values) -> f64 {
    let signs: Vec<_> = parts.iter().map(|part| sign(*part).unwrap_or_default()).collect();
    match (signs[0].as_str(), signs.get(1).map(String::as_str)) {
        ("(", _) => return row(&parts[1..parts.len() - 1], known),
        ("|", _) => return row(&parts[1..parts.len() - 1], known).abs(),
        (_, Some("\u{2061}")) => {
            let of = value(parts[2], known);
            return match text(parts[0]).as_str() {
                "ln" => of.ln(),
                "exp" => of.exp(),
                "atan" => of.atan(),
                "tan" => of.tan(),
                "sin" => of.sin(),
                "tanh" => of.tanh(),
                other => panic!("the function {other}"),
            };
        }
        _ => {}
    }
    // Δt is one variable of two letters.
    let word: String = parts.iter().map(|part| text(*part)).collect();
    if let Some(value) = known.get(&word) {
        return *value;
    }
    let (mut sum, mut term, mut minus) = (0.0, None::<f64>, false);
    for (part, sign) in parts.iter().zip(&signs) {
        match sign.as_str() {
            "+" | "\u{2212}" => {
                let done = term.take().unwrap_or(0.0);
                sum += if minus { -done } else { done };
                minus = sign == "\u{2212}";
            }
            "\u{22c5}" | "\u{2062}" => {}
            _ => term = Some(term.unwrap_or(1.0) * value(*part, known)),
        }
    }
    let last = term.expect("a term");
    sum + if minus { -last } else { last }
}

/// The value of the right side of the formula `left = right`.
fn value_of(page: &str, left: &str, known: &Values) -> f64 {
    let page = parse(page);
    for math in named(section(&page, "formulas"), "math") {
        for line in named(math, "mtr") {
            let cells: Vec<_> = line.children().collect();
            if text(cells[0]) == format!("{left}=") {
                return value(cells[1].first_element_child().expect("a formula"), known);
            }
        }
        let row = math.first_element_child().expect("a formula");
        let parts: Vec<_> = row.children().filter(Node::is_element).collect();
        if let [first, middle, right] = parts[..]
            && sign(middle).as_deref() == Some("=")
            && text(first).replace('\u{2061}', "") == left
        {
            return value(right, known);
        }
    }
    panic!("no formula of {left}")
}

fn values(pairs: &[(&str, f64)]) -> Values {
    pairs.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect()
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
}

/// A family at a time-to-go, with the values of its letters.
struct Case {
    mu: &'static str,
    letters: Vec<(&'static str, f64)>,
    r: fn(i32) -> f64,
}

const TAU: f64 = 1.6;
const A: f64 = 0.5;
const T: f64 = 0.7;
const W: f64 = T / TAU;

/// pi T/(2 tau).
fn angle() -> f64 {
    std::f64::consts::FRAC_PI_2 * W
}

fn factorial(k: i32) -> f64 {
    (1..=k).map(f64::from).product()
}

fn sign_of(k: i32) -> f64 {
    (-1f64).powi(k - 1)
}

/// The closed forms of r_k as the field writes them.
fn cases() -> Vec<Case> {
    let y = 1.0 / angle().tan();
    let e = T / (2.0 * TAU - T);
    let slope = (TAU - T) / (T * (2.0 * TAU - T)).sqrt();
    vec![
        Case { mu: "exp(a=0.5)", letters: Vec::new(), r: |k| sign_of(k) * A.powi(k) * T },
        Case {
            mu: "rational(a=0.5)",
            letters: Vec::new(),
            r: |k| sign_of(k) * factorial(k) * (A / TAU).powi(k) * T.powi(k + 1),
        },
        Case {
            mu: "power(a=0.5, m=2)",
            letters: vec![("m", 2.0), ("P", W * W)],
            r: |k| {
                let product: f64 = (1..k).map(|i| 1.0 + 2.0 * f64::from(i)).product();
                sign_of(k) * product * A.powi(k) * TAU * W.powi(1 + 2 * k)
            },
        },
        Case {
            mu: "tan(a=0.5)",
            letters: vec![("y", y), ("V", 1.0 / (1.0 + y * y))],
            r: |k| {
                let sines = (f64::from(k) * angle()).sin() * angle().sin().powi(k);
                let size = factorial(k - 1) * 2.0 * TAU / std::f64::consts::PI * A.powi(k);
                sign_of(k) * size * sines
            },
        },
        Case {
            mu: "tanh(a=0.5)",
            letters: vec![("E", e), ("L", 1.0 / (1.0 + e))],
            // mu' = tau a (1 - s^2), and D s = a (1 - s^2).
            r: |k| {
                let s = 1.0 - W;
                let v = 1.0 - s * s;
                let inner = [1.0, -2.0 * s, -2.0 + 6.0 * s * s];
                TAU * A.powi(k) * v * inner[usize::try_from(k - 1).expect("an index")]
            },
        },
        Case {
            mu: "algebraic(a=0.5)",
            letters: vec![("y", slope), ("h", 1.0 / (1.0 + slope * slope).sqrt())],
            // Q_1 = 1, Q_2 = -3 s, Q_3 = -3 v + 12 s^2.
            r: |k| {
                let s = 1.0 - W;
                let v = 1.0 - s * s;
                let q = [1.0, -3.0 * s, -3.0 * v + 12.0 * s * s];
                let power = v.powf(1.0 + f64::from(k) / 2.0);
                TAU * A.powi(k) * power * q[usize::try_from(k - 1).expect("an index")]
            },
        },
    ]
}

#[test]
fn formulas_of_families_are_those_of_the_theory() {
    let (x1, x2) = (0.3_f64, -1.2_f64);
    let f = -(x1 - 2.0 * x2).powi(2) / (1.0 + x1.abs())
        - 2f64.powf(-x2) * (x1 - (x2 - 3.0)) * (2.0 + x1).sqrt();
    for (index, Case { mu, letters, r }) in cases().into_iter().enumerate() {
        let text = format!(
            "name = \"stage\"\nn = 3\nmu = \"{mu}\"\ngains = [6, 11, 6]\n[params]\ntau = 1.6\n\
             [plant]\nf = \"-(x1 - 2*x2)^2/(1 + abs(-x1)) - 2^-x2*(x1 - (x2 - 3))*sqrt(2 + x1)\"\n"
        );
        let folder = folder(&format!("formulas_{index}"), &text);
        let page = report(&folder, &["simulate", "stage.toml", "--x0", "0,0,0", "--at", "0"]);
        let mut known = values(&[("\u{3c4}", TAU), ("T", T), ("a", A), ("x_1", x1), ("x_2", x2)]);
        known.extend(values(&letters));
        let told = value_of(&page, "f", &known);
        assert!(near(told, f), "{mu}: f = {told}, {f}");
        // mu of stretched time is the time since the start.
        let stretched = value_of(&page, "\u{3ba}(\u{394}t)", &known);
        known.insert("t".to_owned(), stretched);
        let elapsed = value_of(&page, "\u{3bc}(t)", &known);
        assert!(near(elapsed, TAU - T), "{mu}: mu(kappa(Dt)) = {elapsed}");
        for k in 1..=3 {
            let told = value_of(&page, &format!("r{k}"), &known);
            assert!((told - r(k)).abs() < 1e-14, "{mu}: r_{k} = {told}, {}", r(k));
        }
    }
}

/// The gains of the report give u of the exact solution, with an input gain.
#[test]
fn the_gains_give_the_control() {
    let design = "name = \"stage\"\nn = 2\nmu = \"exp(a=1)\"\ng = 2\ngains = [6, 5]\n[params]\n\
                  tau = 1\n[plant]\nf = 0\n";
    let folder = folder("gains", design);
    let page = report(&folder, &["simulate", "stage.toml", "--x0", "1,0", "--at", "0.75"]);
    let mut known = values(&[("\u{3c4}", 1.0), ("T", 0.25), ("a", 1.0)]);
    for scaled in ["K1", "K2"] {
        let value = value_of(&page, scaled, &known);
        known.insert(scaled.replace('K', "K_"), value);
    }
    let gain = |j: i32| 0.25f64.powi(-(3 - j)) * value_of(&page, &format!("row{j}"), &known);
    // x = (3T^2 - 2T^3, -6T + 6T^2), u = 3 - 6T.
    let u = (gain(1) * 0.15625 - gain(2) * 1.125) / value_of(&page, "g", &known);
    assert!((u - 1.5).abs() < 1e-12, "{u}");
}
