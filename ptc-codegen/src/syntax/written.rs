//! Values as text, as they were written up to blanks and brackets that change nothing.

use std::fmt::{self, Display};

use super::{Argument, Node, Operator, Value};
use crate::parameter::Fixed;

/// Precedence of an operator, weakest first.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Level {
    Sum,
    Product,
    Sign,
    Power,
    Operand,
}

impl Value {
    fn level(&self) -> Level {
        match self {
            Self::Binary(Operator::Add | Operator::Sub, ..) => Level::Sum,
            Self::Binary(Operator::Mul | Operator::Div, ..) => Level::Product,
            Self::Binary(Operator::Power, ..) => Level::Power,
            Self::Negative(_) => Level::Sign,
            Self::Number(Fixed::Number { text, .. }) if text.starts_with('-') => Level::Sign,
            _ => Level::Operand,
        }
    }
}

/// A value where operands of at least this level need no brackets.
struct Within<'a>(&'a Node, Level);

impl Display for Within<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(Node { value, .. }, level) = self;
        if value.level() >= *level { value.fmt(f) } else { write!(f, "({value})") }
    }
}

impl Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => number.fmt(f),
            Self::Imaginary(units) if *units == 1.into() => f.write_str("i"),
            Self::Imaginary(units) => write!(f, "{units}i"),
            Self::Word(word) | Self::File(word, _) => f.write_str(word),
            Self::List(items) => {
                f.write_str("[")?;
                separated(f, items, |f, item| item.value.fmt(f))?;
                f.write_str("]")
            }
            Self::Table(items) => {
                f.write_str("{")?;
                separated(f, items, Argument::write)?;
                f.write_str("}")
            }
            Self::Call(name, arguments) => {
                write!(f, "{name}(")?;
                separated(f, arguments, Argument::write)?;
                f.write_str(")")
            }
            Self::Negative(a) => write!(f, "-{}", Within(a, Level::Sign)),
            Self::Binary(operator, a, b) => {
                let (sign, left, right) = match operator {
                    Operator::Add => ("+", Level::Sum, Level::Product),
                    Operator::Sub => ("-", Level::Sum, Level::Product),
                    Operator::Mul => ("*", Level::Product, Level::Sign),
                    Operator::Div => ("/", Level::Product, Level::Sign),
                    Operator::Power => ("^", Level::Operand, Level::Sign),
                };
                write!(f, "{}{sign}{}", Within(a, left), Within(b, right))
            }
        }
    }
}

impl Argument {
    fn write(f: &mut fmt::Formatter<'_>, argument: &Self) -> fmt::Result {
        if let Some((name, _)) = &argument.name {
            write!(f, "{name}=")?;
        }
        argument.value.value.fmt(f)
    }
}

fn separated<T>(
    f: &mut fmt::Formatter<'_>,
    items: &[T],
    one: fn(&mut fmt::Formatter<'_>, &T) -> fmt::Result,
) -> fmt::Result {
    for (index, item) in items.iter().enumerate() {
        if index > 0 {
            f.write_str(", ")?;
        }
        one(f, item)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::diagnostic::Place;
    use crate::syntax::parse;

    #[test]
    fn written_values_round_trip() {
        for (text, shown) in [
            ("1/3.5", "1/3.5"),
            ("3*pi / 180", "3*pi/180"),
            ("0.010", "0.010"),
            ("1 - (2 - 3)", "1-(2-3)"),
            ("-(a + b)*c^-2", "-(a+b)*c^-2"),
            ("(-2)^2", "(-2)^2"),
            ("a/(b*c)", "a/(b*c)"),
            ("-1+2i, -1-i", "[-1+2i, -1-i]"),
            ("exp(a = 1/2)", "exp(a=1/2)"),
            ("[[0, 1], [-4, -0.2]]", "[[0, 1], [-4, -0.2]]"),
        ] {
            let read = |text: &str| parse("key", text, &mut |_| Place(0)).expect("a value").value;
            assert_eq!(read(text).to_string(), shown);
            assert_eq!(read(shown), read(text), "{text}");
        }
    }
}
