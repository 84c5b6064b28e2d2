//! Expressions rewritten by identities: another spelling has the same verdicts, and bounds that are close.

use ptc_codegen::check::examine::Report;
use ptc_codegen::diagnostic::Place;
use ptc_codegen::syntax::{Argument, Operator, Value, parse};

use super::design::Design;
use crate::harness::random::Random;

/// Factor by which bounds of two spellings may differ, due to dependencies that enclosures lose.
const CLOSE: f64 = 4.0;

/// Functions of `#` by others.
const IDENTITIES: [(&str, &[&str]); 13] = [
    // Twice the sine of half the angle times its cosine has no sharp enclosure, and is another function to a reader of it.
    ("sin", &["cos((#) - pi/2)", "-sin(-(#))"]),
    ("cos", &["1 - 2*sin((#)/2)^2", "cos(-(#))"]),
    ("tan", &["sin(#)/cos(#)", "-tan(-(#))"]),
    ("sinh", &["(exp(#) - exp(-(#)))/2", "-sinh(-(#))"]),
    ("cosh", &["(exp(#) + exp(-(#)))/2"]),
    ("tanh", &["(1 - exp(-2*(#)))/(1 + exp(-2*(#)))", "sinh(#)/cosh(#)"]),
    ("exp", &["1/exp(-(#))", "exp((#)/2)^2"]),
    ("ln", &["-ln(1/(#))", "2*ln(sqrt(#))"]),
    ("sqrt", &["(#)^0.5", "exp(ln(#)/2)"]),
    ("atan", &["-atan(-(#))"]),
    ("asin", &["-asin(-(#))"]),
    ("atanh", &["0.5*ln((1 + (#))/(1 - (#)))"]),
    ("abs", &["max(#, -(#))", "abs(-(#))"]),
];

/// `text` rewritten at random.
pub(super) fn rewritten(text: &str, random: &mut Random) -> String {
    match parse("expression", text, &mut |_| Place(0)) {
        Ok(node) => spelled(&node.value, random),
        Err(_) => text.to_owned(),
    }
}

fn spelled(value: &Value, random: &mut Random) -> String {
    match value {
        Value::Negative(inner) => format!("-({})", spelled(&inner.value, random)),
        Value::Binary(operator, left, right) => {
            let [a, b] = [left, right].map(|side| spelled(&side.value, random));
            let form = form(*operator, &right.value, random);
            form.replace('A', "\u{1}").replace('B', &b).replace('\u{1}', &a)
        }
        Value::Call(name, arguments) => call(name, arguments, random),
        other => other.to_string(),
    }
}

/// Returns a form of A and B that equals A `operator` B.
fn form(operator: Operator, right: &Value, random: &mut Random) -> &'static str {
    let forms: &[&'static str] = match (operator, right) {
        (Operator::Add, _) => &["(A) + (B)", "(B) + (A)", "(A) - (-(B))"],
        (Operator::Sub, _) => &["(A) - (B)", "-(B) + (A)", "-((B) - (A))"],
        (Operator::Mul, _) => &["(A)*(B)", "(B)*(A)", "-((A)*(-(B)))"],
        (Operator::Div, _) => &["(A)/(B)", "(A)*(1/(B))", "1/(B)*(A)"],
        (Operator::Power, Value::Number(number)) if number.to_string() == "2" => {
            &["(A)^2", "(A)*(A)"]
        }
        (Operator::Power, Value::Number(number)) if number.to_string() == "3" => {
            &["(A)^3", "(A)*(A)^2"]
        }
        // A power that is not whole has a positive base.
        (Operator::Power, _) => &["(A)^(B)", "exp((B)*ln(A))"],
    };
    forms[random.below(forms.len() as u64) as usize]
}

fn call(name: &str, arguments: &[Argument], random: &mut Random) -> String {
    let all: Vec<_> =
        arguments.iter().map(|argument| spelled(&argument.value.value, random)).collect();
    let found = IDENTITIES.iter().find(|(of, _)| *of == name);
    match (found, all.as_slice()) {
        (Some((_, forms)), [one]) if random.below(4) > 0 => {
            let form = forms[random.below(forms.len() as u64) as usize];
            format!("({})", form.replace('#', one))
        }
        _ => format!("{name}({})", all.join(", ")),
    }
}

/// Lists the checks on which the verdicts of two spellings of a design differ.
pub(super) fn faults(design: &Design, other: &Design) -> Vec<String> {
    let (Some(one), report) = (design.report(), other.report()) else { return Vec::new() };
    let shown = |text: String| format!("{text}\n{}and\n{}", design.text(), other.text());
    let Some(two) = report else {
        let why = other.spec().err().unwrap_or_default();
        return vec![shown(format!("spelling: only one of two spellings is read: {why}"))];
    };
    let mut found = Vec::new();
    for (a, b) in one.outcomes.iter().zip(&two.outcomes) {
        if (a.name, a.verdict) != (b.name, b.verdict) {
            found.push(shown(format!(
                "spelling: {} is {} ({}) and {} ({})",
                a.name,
                a.verdict.text(),
                a.summary,
                b.verdict.text(),
                b.summary
            )));
        }
    }
    if found.is_empty() && !are_close(&one, &two) {
        found.push(shown("spelling: the bounds of `loop` differ".to_owned()));
    }
    found
}

/// Returns true if the worst cases of two reports are close.
fn are_close(one: &Report, two: &Report) -> bool {
    let last = |report: &Report| {
        let worst = report.worst.iter().flat_map(|worst| &worst.states);
        worst.map(|bound| bound.attained()).collect::<Vec<_>>()
    };
    let (one, two) = (last(one), last(two));
    let near = |(a, b): (&f64, &f64)| (*a <= CLOSE * b && *b <= CLOSE * a) || a.max(*b) < 1e-12;
    one.len() == two.len() && one.iter().zip(&two).all(near)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The value of a formula in one variable, computed here.
    fn value(value: &Value, at: f64) -> f64 {
        match value {
            Value::Number(number) => number.to_string().parse().expect("a number"),
            Value::Word(word) if word == "pi" => std::f64::consts::PI,
            Value::Word(_) => at,
            Value::Negative(inner) => -self::value(&inner.value, at),
            Value::Binary(operator, left, right) => {
                let [a, b] = [left, right].map(|side| self::value(&side.value, at));
                match operator {
                    Operator::Add => a + b,
                    Operator::Sub => a - b,
                    Operator::Mul => a * b,
                    Operator::Div => a / b,
                    Operator::Power => a.powf(b),
                }
            }
            Value::Call(name, arguments) => {
                let all: Vec<_> =
                    arguments.iter().map(|one| self::value(&one.value.value, at)).collect();
                match (name.as_str(), all.as_slice()) {
                    ("max", [a, b]) => a.max(*b),
                    (name, [x]) => of_one(name, *x),
                    other => panic!("{other:?}"),
                }
            }
            other => panic!("{other:?}"),
        }
    }

    fn of_one(name: &str, x: f64) -> f64 {
        match name {
            "sin" => x.sin(),
            "cos" => x.cos(),
            "tan" => x.tan(),
            "sinh" => x.sinh(),
            "cosh" => x.cosh(),
            "tanh" => x.tanh(),
            "exp" => x.exp(),
            "ln" => x.ln(),
            "sqrt" => x.sqrt(),
            "atan" => x.atan(),
            "asin" => x.asin(),
            "atanh" => x.atanh(),
            "abs" => x.abs(),
            other => panic!("{other}"),
        }
    }

    #[test]
    fn rewritten_expressions_keep_their_value() {
        let mut random = Random(3);
        let each = IDENTITIES.map(|(name, _)| format!("{name}(0.3 + 0.2*x)/(2 - x)^2"));
        let powers = ["(1.5 + x)^0.3 - x^3".to_owned(), "1/(-x - 2)".to_owned()];
        for text in each.iter().chain(&powers) {
            for _ in 0..20 {
                let other = rewritten(text, &mut random);
                for at in [-0.7, 0.3, 0.9] {
                    let [a, b] = [text, &other].map(|text| {
                        let node =
                            parse("expression", text, &mut |_| Place(0)).expect("an expression");
                        value(&node.value, at)
                    });
                    assert!((a - b).abs() < 1e-12, "{text} and {other} at {at}: {a} and {b}");
                }
            }
        }
    }
}
