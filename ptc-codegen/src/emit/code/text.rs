//! What the printers share: how an expression is written, by the words of a language.

use crate::code::{Expr, Operator, Shape, Test};
use crate::parameter::Precision;
use crate::program::number;

/// How tightly an expression holds together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::emit) enum Level {
    /// A choice between two.
    Choice,
    /// a + b, a - b.
    Sum,
    /// a * b, a / b.
    Product,
    /// -a.
    Sign,
    /// A name, a number or a call.
    Atom,
}

/// The words of a language.
pub(in crate::emit) trait Text {
    /// Precision of the numbers.
    fn precision(&self) -> Precision;

    /// A literal that is not negative.
    fn literal(&self, digits: &str) -> String {
        digits.to_owned()
    }

    /// A literal count.
    fn count(&self, count: u32) -> String;

    /// A field of the controller.
    fn field(&self, name: &str) -> String;

    /// A parameter of `init`.
    fn parameter(&self, name: &str) -> String;

    /// Element `index`, from 0, of an array.
    fn element(&self, array: &str, index: usize) -> String {
        format!("{array}[{index}]")
    }

    /// a - b of counts, modulo 2^32.
    fn count_sub(&self, a: &str, b: &str) -> (Level, String);

    /// a - b of counts, 0 where b is greater.
    fn count_left(&self, a: &str, b: &str) -> (Level, String);

    /// Half of a count, rounded down.
    fn count_half(&self, count: &str) -> (Level, String);

    /// A count as a floating-point number.
    fn real(&self, count: &str) -> (Level, String);

    /// One of two values.
    fn choose(&self, test: &str, yes: &str, no: &str) -> (Level, String);

    /// Whether a number is finite.
    fn finite(&self, value: &str) -> String;

    /// What stands between tests that must all hold.
    fn and(&self) -> &'static str;

    /// What compares for equality.
    fn equal(&self) -> &'static str {
        "=="
    }

    /// An expression and how tightly it holds together.
    fn print(&self, value: &Expr) -> (Level, String) {
        match value {
            Expr::Number(exact) => {
                let value = number::round(exact, self.precision());
                let digits = self.literal(&number::literal(value.abs(), self.precision()));
                match value.is_sign_negative() && value != 0.0 {
                    true => (Level::Sign, format!("-{digits}")),
                    false => (Level::Atom, digits),
                }
            }
            Expr::Count(count) => (Level::Atom, self.count(*count)),
            Expr::Local(name) => (Level::Atom, name.clone()),
            Expr::Element(name, index) => (Level::Atom, self.element(name, *index)),
            Expr::Field(name) => (Level::Atom, self.field(name)),
            Expr::Parameter(name) => (Level::Atom, self.parameter(name)),
            Expr::ParameterElement(name, index) => {
                (Level::Atom, self.element(&self.parameter(name), *index))
            }
            Expr::Neg(a) => (Level::Sign, format!("-{}", self.within(a, Level::Atom))),
            Expr::Binary(operator, a, b) => {
                let (sign, level, right) = match operator {
                    Operator::Add => ("+", Level::Sum, Level::Product),
                    Operator::Sub => ("-", Level::Sum, Level::Product),
                    Operator::Mul => ("*", Level::Product, Level::Sign),
                    Operator::Div => ("/", Level::Product, Level::Sign),
                };
                // What binds tighter is in brackets too, but for products in a sum and signs in
                // front, so that no rule of precedence has to be known.
                let text = format!("{} {sign} {}", self.within(a, level), self.within(b, right));
                (level, text)
            }
            Expr::CountSub(a, b) => {
                self.count_sub(&self.within(a, Level::Atom), &self.within(b, Level::Atom))
            }
            Expr::CountLeft(a, b) => {
                self.count_left(&self.within(a, Level::Atom), &self.within(b, Level::Atom))
            }
            Expr::CountHalf(a) => self.count_half(&self.within(a, Level::Atom)),
            Expr::Real(a) => self.real(&self.within(a, Level::Choice)),
            Expr::Choose(test, a, b) => self.choose(
                &self.test(test),
                &self.within(a, Level::Sum),
                &self.within(b, Level::Sum),
            ),
        }
    }

    /// An expression, in brackets where it holds together less tightly than `level`.
    fn within(&self, value: &Expr, level: Level) -> String {
        match self.print(value) {
            (own, text) if own < level => format!("({text})"),
            (_, text) => text,
        }
    }

    /// An expression that stands alone.
    fn alone(&self, value: &Expr) -> String {
        self.print(value).1
    }

    /// A test.
    fn test(&self, test: &Test) -> String {
        let two = |a: &Expr, sign: &str, b: &Expr| {
            format!("{} {sign} {}", self.within(a, Level::Sum), self.within(b, Level::Sum))
        };
        match test {
            Test::Less(a, b) | Test::CountLess(a, b) => two(a, "<", b),
            Test::AtMost(a, b) => two(a, "<=", b),
            Test::CountEqual(a, b) => two(a, self.equal(), b),
            Test::Finite(a) => self.finite(&self.within(a, Level::Atom)),
            Test::All(tests) => match tests.as_slice() {
                [only] => self.test(only),
                all => {
                    let each = all.iter().map(|test| match test {
                        Test::Finite(_) => self.test(test),
                        _ => format!("({})", self.test(test)),
                    });
                    each.collect::<Vec<_>>().join(&format!(" {} ", self.and()))
                }
            },
        }
    }
}

/// Lines that are indented as blocks open and close.
#[derive(Default)]
pub(in crate::emit) struct Lines {
    lines: Vec<String>,
    depth: usize,
}

impl Lines {
    /// A line at the present depth.
    pub(in crate::emit) fn line(&mut self, text: impl AsRef<str>) {
        let text = text.as_ref();
        let pad = if text.is_empty() { String::new() } else { "    ".repeat(self.depth) };
        self.lines.push(format!("{pad}{text}"));
    }

    /// A line behind which a block opens.
    pub(in crate::emit) fn open(&mut self, text: impl AsRef<str>) {
        self.line(text);
        self.depth += 1;
    }

    /// Ends a block with a line.
    pub(in crate::emit) fn close(&mut self, text: impl AsRef<str>) {
        self.depth = self.depth.saturating_sub(1);
        self.line(text);
    }

    /// Ends a block and opens the next one, with a line between them.
    pub(in crate::emit) fn turn(&mut self, text: impl AsRef<str>) {
        self.close(text);
        self.depth += 1;
    }

    /// The text.
    pub(in crate::emit) fn text(&self) -> String {
        super::super::tidy(&self.lines.join("\n"))
    }
}

/// The number of elements of an array; none for one value.
pub(in crate::emit) fn length(shape: Shape) -> Option<usize> {
    match shape {
        Shape::Reals(length) => Some(length),
        Shape::Real | Shape::Count => None,
    }
}
