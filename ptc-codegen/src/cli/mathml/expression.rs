//! Expressions of users as MathML.

use crate::algebra::{BigRational, integer};
use crate::expression::{Expression, Function, Node, Variable};
use crate::parameter::Parameter;
use num_traits::{Signed, ToPrimitive};

use super::super::greek::GREEK;
use super::element::{
    APPLIED, Math, applied, fenced, fraction, name, number, operator, relation, root, row,
    sequence, sub, sup, words,
};

/// Digits of a decimal number; what has more is written as a fraction.
const DIGITS: u32 = 9;

/// The expression.
pub(crate) fn of_expression(expression: &Expression) -> Math {
    if !expression.is_written() {
        return words(&expression.to_string());
    }
    let tight = |e: &Expression, least: u8| operand(e, least);
    match expression.node() {
        Node::Number(value) => of_number(value),
        Node::Pi => named("pi"),
        Node::Parameter(parameter) => of_parameter(*parameter),
        Node::Variable(v) => variable(*v),
        Node::Neg(a) => row([operator("\u{2212}"), tight(a, 3)]),
        Node::Add(a, b) => relation(tight(a, 1), "+", tight(b, 2)),
        Node::Sub(a, b) => relation(tight(a, 1), "\u{2212}", tight(b, 2)),
        Node::Mul(a, b) => relation(tight(a, 2), "\u{22c5}", tight(b, 3)),
        Node::Div(a, b) => fraction(of_expression(a), of_expression(b)),
        Node::Power(a, b) => sup(tight(a, 6), of_expression(b)),
        Node::Min(..) | Node::Max(..) => several(expression),
        Node::Call(function, a) => call(*function, a),
    }
}

/// Returns the precedence of the outermost operation, as it is written here.
fn binding(expression: &Expression) -> u8 {
    match expression.node() {
        Node::Add(..) | Node::Sub(..) => 1,
        Node::Mul(..) => 2,
        Node::Neg(_) => 3,
        Node::Number(value) if value.is_negative() => 3,
        // A fraction takes an exponent in brackets alone.
        Node::Number(value) if !value.is_integer() => 4,
        Node::Div(..) | Node::Power(..) => 4,
        Node::Call(Function::Exp, _) => 4,
        Node::Call(..) | Node::Min(..) | Node::Max(..) => 5,
        _ => 6,
    }
}

fn operand(expression: &Expression, least: u8) -> Math {
    let written = of_expression(expression);
    if binding(expression) < least { fenced("(", written, ")") } else { written }
}

fn call(function: Function, argument: &Expression) -> Math {
    let inner = of_expression(argument);
    match function {
        Function::Abs => fenced("|", inner, "|"),
        Function::Sqrt => root(inner),
        // A fraction in an exponent is too small to be read.
        Function::Exp if !argument.any(&|e| matches!(e.node(), Node::Div(..))) => {
            sup(name("e"), inner)
        }
        Function::Sign => applied(name("sgn"), inner),
        _ => applied(name(function.name()), inner),
    }
}

/// The least or the greatest of several.
fn several(expression: &Expression) -> Math {
    let mut parts = Vec::new();
    let word = match expression.node() {
        Node::Min(..) => "min",
        _ => "max",
    };
    let mut left = vec![expression];
    while let Some(next) = left.pop() {
        match (next.node(), expression.node()) {
            (Node::Min(a, b), Node::Min(..)) | (Node::Max(a, b), Node::Max(..)) => {
                left.extend([b, a]);
            }
            _ => {
                if !parts.is_empty() {
                    parts.push(operator(","));
                }
                parts.push(of_expression(next));
            }
        }
    }
    row([name(word), operator(APPLIED), fenced("(", sequence(&parts), ")")])
}

/// An integer, a decimal number of a few digits, or a fraction.
fn of_number(value: &BigRational) -> Math {
    let size = value.abs();
    let decimal = (1..=DIGITS).find_map(|places| {
        let scaled = &size * integer(10_i64.pow(places));
        let digits = scaled.is_integer().then(|| scaled.numer().to_u64()).flatten()?;
        let one = 10_u64.pow(places);
        let width = usize::try_from(places).unwrap_or(0);
        Some(format!("{}.{:0width$}", digits / one, digits % one))
    });
    let written = match (size.is_integer(), decimal) {
        (true, _) => number(size.numer()),
        (false, Some(decimal)) => number(decimal),
        (false, None) => fraction(number(size.numer()), number(size.denom())),
    };
    if value.is_negative() { row([operator("\u{2212}"), written]) } else { written }
}

/// Writes a variable as the formulas of the report do.
pub(crate) fn variable(variable: Variable) -> Math {
    let at_start = |stem: Math, j: usize| {
        let start = sub(name("t"), number(0));
        row([sub(stem, number(j)), operator(APPLIED), fenced("(", start, ")")])
    };
    match variable {
        Variable::SinceStart | Variable::Time => name("t"),
        Variable::StretchedTime => sub(name("t"), named("kappa")),
        Variable::Elapsed => row([name("\u{394}"), name("t")]),
        Variable::TimeToGo => name("T"),
        Variable::KappaRate => row([named("kappa"), operator("\u{2032}")]),
        Variable::R(k) => sub(name("r"), number(k)),
        Variable::Control => name("u"),
        Variable::State(j) => sub(name("x"), number(j)),
        Variable::Xi(j) => sub(named("xi"), number(j)),
        Variable::StateAtStart(j) => at_start(name("x"), j),
        Variable::XiAtStart(j) => at_start(named("xi"), j),
    }
}

fn of_parameter(parameter: Parameter) -> Math {
    match parameter {
        Parameter::StartTime => sub(name("t"), number(0)),
        Parameter::Gain(i) => sub(name("k"), number(i)),
        Parameter::Rate(i) => sub(name("a"), number(i)),
        Parameter::Eps => name("\u{3b5}"),
        Parameter::UMax => sub(name("u"), name("max")),
        Parameter::UMin => sub(name("u"), name("min")),
        _ => named(&parameter.spelling()),
    }
}

/// A name that users give, or a Greek letter by its name.
pub(crate) fn named(text: &str) -> Math {
    let letter = GREEK.iter().find(|(spelled, _)| *spelled == text);
    name(letter.map_or(text, |(_, letter)| letter))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number_of(numerator: i64, denominator: i64) -> Expression {
        Expression::from(integer(numerator) / integer(denominator))
    }

    #[test]
    fn numbers_are_written_as_decimals_or_fractions() {
        let text = |numerator, denominator| of_expression(&number_of(numerator, denominator));
        assert_eq!(text(-4, 1).to_string(), "<mrow><mo>\u{2212}</mo><mn>4</mn></mrow>");
        assert_eq!(text(1, 20).to_string(), "<mn>0.05</mn>");
        assert_eq!(text(5, 2).to_string(), "<mn>2.5</mn>");
        assert_eq!(text(1, 3).to_string(), "<mfrac><mn>1</mn><mn>3</mn></mfrac>");
    }

    #[test]
    fn brackets_appear_only_where_needed() {
        let x = Expression::from(Variable::State(1));
        let sum = x.clone().add(Expression::pi());
        let brackets =
            |e: &Expression| of_expression(e).to_string().matches("fence=\"true\"").count();
        assert_eq!(brackets(&sum.clone().mul(sum.clone())), 4);
        assert_eq!(brackets(&sum.clone().div(sum.clone())), 0);
        assert_eq!(brackets(&sum.clone().power(x.clone())), 2);
        assert_eq!(brackets(&x.clone().power(sum.clone())), 0);
        assert_eq!(brackets(&x.clone().sub(sum.clone())), 2);
        assert_eq!(brackets(&x.clone().div(sum.clone()).power(x.clone())), 2);
        assert_eq!(brackets(&Expression::call(Function::Abs, sum)), 2);
        assert_eq!(brackets(&number_of(-1, 2).power(x)), 2);
    }

    #[test]
    fn nested_min_is_written_as_one_min() {
        let x = |j| Expression::from(Variable::State(j));
        let written = of_expression(&x(1).min(x(2)).min(x(3))).to_string();
        assert_eq!(written.matches("<mi>min</mi>").count(), 1);
        let place = |j: usize| written.find(&format!("<mn>{j}</mn>")).expect("a state");
        assert!(place(1) < place(2) && place(2) < place(3), "{written}");
    }
}
