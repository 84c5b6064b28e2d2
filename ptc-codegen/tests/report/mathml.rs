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

/// The sides of the relations `left = right` that stand alone, the right ones with their values.
fn relations(page: &str, known: &Values) -> BTreeMap<String, f64> {
    let page = parse(page);
    let mut found = BTreeMap::new();
    for math in named(section(&page, "formulas"), "math") {
        let Some(row) = math.first_element_child() else { continue };
        for line in named(row, "mtr") {
            let cells: Vec<_> = line.children().collect();
            let right = cells[1].first_element_child().expect("a formula");
            if let Some(left) = text(cells[0]).strip_suffix('=') {
                let sum = value(right, known);
                found.insert(left.to_owned(), sum);
            }
        }
        let parts: Vec<_> = row.children().filter(Node::is_element).collect();
        let is_matrix = named(row, "mtable").next().is_some();
        if let [left, middle, right] = parts[..]
            && sign(middle).as_deref() == Some("=")
            && ["\u{3bc}(t)", "\u{3ba}(\u{394}t)", "f", "g"].contains(&&*plain(left))
            && !is_matrix
        {
            found.insert(plain(left), value(right, known));
        }
    }
    found
}

/// Text without the sign that is not seen.
fn plain(node: Node<'_, '_>) -> String {
    text(node).replace('\u{2061}', "")
}

fn values(pairs: &[(&str, f64)]) -> Values {
    pairs.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect()
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
}

#[test]
fn formulas_of_families_are_those_of_the_theory() {
    let factorial = |k: u32| f64::from((1..=k).product::<u32>());
    let sign = |k: u32| if k % 2 == 1 { 1.0 } else { -1.0 };
    let (tau, t, stretched) = (1.6, 0.7, 0.9);
    let known = values(&[
        ("\u{3c4}", tau),
        ("T", t),
        ("t", stretched),
        ("\u{394}t", tau - t),
        ("a", 0.5),
        ("m", 2.0),
        ("P", (t / tau).powi(2)),
        ("K_1", 6.0),
        ("K_2", 11.0),
        ("K_3", 6.0),
    ]);
    let (a, w) = (0.5_f64, t / tau);
    let exp = |k: u32| sign(k) * a.powi(i32::try_from(k).unwrap()) * t;
    let rational = |k: u32| {
        let k_i = i32::try_from(k).unwrap();
        sign(k) * factorial(k) * (a / tau).powi(k_i) * t.powi(k_i + 1)
    };
    let power = |k: u32| {
        let k_i = i32::try_from(k).unwrap();
        let product: f64 = (1..k).map(|i| 1.0 + 2.0 * f64::from(i)).product();
        sign(k) * product * a.powi(k_i) * tau * w.powi(1 + 2 * k_i)
    };
    let cases: [(&str, f64, f64, &dyn Fn(u32) -> f64); 3] = [
        ("exp(a=0.5)", tau * (1.0 - (-a * stretched).exp()), -w.ln() / a, &exp),
        (
            "rational(a=0.5)",
            tau * a * stretched / (1.0 + a * stretched),
            (tau - t) / (a * t),
            &rational,
        ),
        (
            "power(a=0.5, m=2)",
            tau * (1.0 - (1.0 + 2.0 * a * stretched).powf(-0.5)),
            (w.powi(-2) - 1.0) / (2.0 * a),
            &power,
        ),
    ];
    for (index, (mu, of_mu, of_kappa, r)) in cases.into_iter().enumerate() {
        let text = format!(
            "name = \"stage\"\nn = 3\nmu = \"{mu}\"\ngains = [6, 11, 6]\n[params]\ntau = 1.6\n\
             [plant]\nf = \"-(x1 - 2*x2)^2/(1 + abs(-x1)) - 2^-x2*(x1 - (x2 - 3))*sqrt(2 + x1)\"\n"
        );
        let folder = folder(&format!("formulas_{index}"), &text);
        let page = report(&folder, &["simulate", "stage.toml", "--x0", "0,0,0", "--at", "0"]);
        let (x1, x2) = (0.3_f64, -1.2_f64);
        let mut known = known.clone();
        known.extend(values(&[("x_1", x1), ("x_2", x2)]));
        let found = relations(&page, &known);
        let f = -(x1 - 2.0 * x2).powi(2) / (1.0 + x1.abs())
            - 2f64.powf(-x2) * (x1 - (x2 - 3.0)) * (2.0 + x1).sqrt();
        assert!(near(found["f"], f), "{mu}: {} {f}", found["f"]);
        assert!(near(found["\u{3bc}(t)"], of_mu), "{mu}: {found:?}");
        assert!(near(found["\u{3ba}(\u{394}t)"], of_kappa), "{mu}: {found:?}");
        for k in 1..=3 {
            assert!(near(found[&format!("r{k}")], r(k)), "{mu}: r_{k}, {found:?}");
        }
    }
}

/// u of the report's gains is u of the table, for a law of gains and a gain g of the plant.
#[test]
fn the_gains_give_the_control_of_the_table() {
    let text_of = "name = \"stage\"\nn = 2\nmu = \"exp(a=1)\"\ng = 2\ngains = [6, 5]\n[params]\n\
                   tau = 1\n[plant]\nf = 0\n";
    let folder = folder("gains", text_of);
    let page = report(&folder, &["simulate", "stage.toml", "--x0", "1,0", "--at", "0.5"]);
    // T = 1/2, x = (1/2, -3/2), u = 0 of the exact solution.
    let known = values(&[("\u{3c4}", 1.0), ("T", 0.5), ("t", 0.0), ("\u{394}t", 0.5), ("a", 1.0)]);
    let mut known = known;
    known.extend(values(&[("K_1", 6.0), ("K_2", 5.0)]));
    let found = relations(&page, &known);
    assert!(near(found["K1"], 6.0) && near(found["K2"], 5.0), "{found:?}");
    let gain = |j: i32| 0.5f64.powi(-(3 - j)) * found[&format!("row{j}")];
    let u = (gain(1) * 0.5 - gain(2) * 1.5) / found["g"];
    assert!(u.abs() < 1e-12 && gain(1) < -1.0, "{u}");
}
