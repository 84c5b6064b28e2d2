//! The elements of formulas.

use std::fmt;

use askama::filters::HtmlSafe;

/// A piece of presentation MathML: one element, whose text is escaped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Math(String);

impl fmt::Display for Math {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Only the functions of this module make one.
impl HtmlSafe for Math {}

/// The product that is not seen.
pub(super) const TIMES: &str = "\u{2062}";

/// The invisible sign between a function and its argument.
pub(super) const APPLIED: &str = "\u{2061}";

fn element(name: &str, text: &str) -> Math {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '&' => escaped.push_str("&amp;"),
            c => escaped.push(c),
        }
    }
    Math(format!("<{name}>{escaped}</{name}>"))
}

fn around(name: &str, parts: &[Math]) -> Math {
    let inner: String = parts.iter().map(|part| part.0.as_str()).collect();
    Math(format!("<{name}>{inner}</{name}>"))
}

/// A name, such as x.
pub(crate) fn name(text: &str) -> Math {
    element("mi", text)
}

/// The letter of a matrix or a vector.
pub(crate) fn bold(letter: &str) -> Math {
    let Math(element) = name(letter);
    Math(element.replacen("<mi", "<mi class=\"bold\" mathvariant=\"normal\"", 1))
}

/// A number.
pub(crate) fn number(value: impl fmt::Display) -> Math {
    element("mn", &value.to_string())
}

/// An operator or a bracket.
pub(crate) fn operator(text: &str) -> Math {
    element("mo", text)
}

/// Words between formulas.
pub(crate) fn words(text: &str) -> Math {
    // Spaces at the ends of an element are not shown.
    element("mtext", &text.replace(' ', "\u{a0}"))
}

/// Parts one after the other.
pub(crate) fn row<const N: usize>(parts: [Math; N]) -> Math {
    sequence(&parts)
}

/// As many parts as there are, one after the other.
pub(crate) fn sequence(parts: &[Math]) -> Math {
    match parts {
        [only] => only.clone(),
        _ => around("mrow", parts),
    }
}

/// One side, a sign, the other side.
pub(crate) fn relation(left: Math, sign: &str, right: Math) -> Math {
    row([left, operator(sign), right])
}

/// left = right.
pub(crate) fn equal(left: Math, right: Math) -> Math {
    relation(left, "=", right)
}

/// A base with an index.
pub(crate) fn sub(base: Math, index: Math) -> Math {
    around("msub", &[base, index])
}

/// A base with an exponent.
pub(crate) fn sup(base: Math, exponent: Math) -> Math {
    around("msup", &[base, exponent])
}

/// A base with an index and an exponent.
pub(crate) fn sub_sup(base: Math, index: Math, exponent: Math) -> Math {
    around("msubsup", &[base, index, exponent])
}

/// A base with a prime, as a derivative has one.
pub(crate) fn prime(base: Math) -> Math {
    sup(base, mark("\u{2032}"))
}

/// A base with a dot, as a derivative with respect to time has one.
pub(crate) fn dot(base: Math) -> Math {
    Math(format!("<mover accent=\"true\">{base}{}</mover>", mark("\u{02d9}")))
}

/// A sign close to its base.
pub(crate) fn mark(sign: &str) -> Math {
    Math(format!("<mo lspace=\"0\" rspace=\"0\" stretchy=\"false\">{sign}</mo>"))
}

/// The sign of a transpose, which is no time-to-go.
pub(crate) fn transpose() -> Math {
    name("\u{22a4}")
}

/// A fraction.
pub(crate) fn fraction(over: Math, under: Math) -> Math {
    around("mfrac", &[over, under])
}

/// A square root.
pub(crate) fn root(of: Math) -> Math {
    around("msqrt", &[of])
}

/// A product whose sign is not seen.
pub(crate) fn product(left: Math, right: Math) -> Math {
    relation(left, TIMES, right)
}

/// A function and what it is of.
pub(crate) fn applied(function: Math, argument: Math) -> Math {
    row([function, operator(APPLIED), fenced("(", argument, ")")])
}

/// Something in brackets, which grow where it is higher than a line.
pub(crate) fn fenced(open: &str, inner: Math, close: &str) -> Math {
    let high = ["<mfrac>", "<mtable", "<munderover>", "<msqrt>"];
    let grows = high.iter().any(|element| inner.0.contains(element));
    let bracket = |sign: &str| Math(format!("<mo fence=\"true\" stretchy=\"{grows}\">{sign}</mo>"));
    row([bracket(open), inner, bracket(close)])
}

/// A sum over an index.
pub(crate) fn sum(from: Math, to: Math) -> Math {
    around("munderover", &[operator("\u{2211}"), from, to])
}

/// A matrix in its brackets.
pub(crate) fn matrix(rows: &[Vec<Math>]) -> Math {
    let cell = |cell: &Math| around("mtd", std::slice::from_ref(cell));
    let line = |line: &Vec<Math>| around("mtr", &line.iter().map(cell).collect::<Vec<_>>());
    fenced("(", around("mtable", &rows.iter().map(line).collect::<Vec<_>>()), ")")
}

/// Relations below each other, aligned at their signs: the left side with the sign, and the lines of
/// the right side.
pub(crate) fn lines(all: &[(Math, Vec<Math>)]) -> Math {
    let mut rows = String::new();
    for (left, right) in all {
        for (index, line) in right.iter().enumerate() {
            let left = if index == 0 { left.0.as_str() } else { "" };
            rows.push_str(&format!("<mtr><mtd>{left}</mtd><mtd>{line}</mtd></mtr>"));
        }
    }
    Math(format!("<mtable class=\"lines\">{rows}</mtable>"))
}

/// A formula on a line of its own.
pub(crate) fn display(formula: &Math) -> Math {
    Math(format!("<math display=\"block\">{formula}</math>"))
}

/// A formula among words.
pub(crate) fn inline(formula: &Math) -> Math {
    Math(format!("<math>{formula}</math>"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped() {
        assert_eq!(name("<a&b>").to_string(), "<mi>&lt;a&amp;b&gt;</mi>");
        let formula = display(&equal(name("x"), fraction(number(1), number(2))));
        assert_eq!(
            formula.to_string(),
            "<math display=\"block\"><mrow><mi>x</mi><mo>=</mo><mfrac><mn>1</mn><mn>2</mn></mfrac></mrow></math>"
        );
    }
}
