//! Expressions and tests in the words of a language.

use super::text::{Level, Text};
use crate::code::{Expr, Index, Operator, Test};
use crate::expression::Function;
use crate::internal::fault;
use crate::program::number;

/// An expression and how tightly it holds together.
pub(in crate::emit) fn print(text: &dyn Text, value: &Expr) -> (Level, String) {
    match value {
        Expr::Number(exact) => {
            let value = number::round(exact, text.precision());
            let digits = text.literal(&number::literal(value.abs(), text.precision()));
            match value.is_sign_negative() && value != 0.0 {
                true => (Level::Sign, format!("-{digits}")),
                false => (Level::Atom, digits),
            }
        }
        Expr::Constant(own) => (Level::Atom, text.constant(own)),
        Expr::Count(count) => (Level::Atom, text.count(*count)),
        Expr::Local(name) => (Level::Atom, text.local(name)),
        Expr::Element(name, index) => (Level::Atom, text.element(&text.local(name), *index)),
        Expr::Entry(name, cell) => {
            let row = text.place(&cell.row, text.first());
            (Level::Atom, text.entry(&text.local(name), &row, cell.column))
        }
        Expr::At(name, index) => {
            let place = text.place(index, text.first());
            (Level::Atom, text.at(&text.local(name), &place))
        }
        Expr::Field(name) => (Level::Atom, text.field(name)),
        Expr::FieldElement(name, index) => (Level::Atom, text.field_element(name, *index)),
        Expr::OfAxis(name, stride, index) => (Level::Atom, text.of_axis(name, *stride, *index)),
        Expr::Parameter(name) => (Level::Atom, text.parameter(name)),
        Expr::ParameterElement(name, index) => {
            (Level::Atom, text.element(&text.parameter(name), *index))
        }
        Expr::Neg(a) => (Level::Sign, format!("-{}", text.within(a, Level::Atom))),
        Expr::Binary(operator, a, b) => {
            let (sign, level) = match operator {
                Operator::Add => ("+", Level::Sum),
                Operator::Sub => ("-", Level::Sum),
                Operator::Mul => ("*", Level::Product),
                Operator::Div => ("/", Level::Product),
            };
            // Brackets around all but a + b + c and a * b * c, so that no rule of precedence has to
            // be known.
            let same = matches!(a.as_ref(), Expr::Binary(of, ..) if of == operator)
                && matches!(operator, Operator::Add | Operator::Mul);
            let left = if same { text.alone(a) } else { text.within(a, Level::Atom) };
            (level, format!("{left} {sign} {}", text.within(b, Level::Atom)))
        }
        Expr::Fused(operands) => {
            let text = text.fused(&operands.each_ref().map(|operand| text.alone(operand)));
            (Level::Atom, text.unwrap_or_else(|| fault("a language without fused operations")))
        }
        Expr::Call(Function::Abs, a) => (Level::Atom, text.abs(&text.alone(a))),
        Expr::Call(Function::Sign, a) => text.sign(&text.within(a, Level::Atom)),
        Expr::Call(function, a) => (Level::Atom, text.call(function.name(), &[text.alone(a)])),
        Expr::Pow(a, b) => (Level::Atom, text.call("pow", &[text.alone(a), text.alone(b)])),
        Expr::Quotient(a, b) => {
            text.quotient(&text.within(a, Level::Atom), &text.within(b, Level::Atom))
        }
        Expr::Divisor(a) => text.divisor(&text.within(a, Level::Atom)),
        Expr::Callback(name, array, time) => {
            (Level::Atom, text.callback(name, &text.local(array), &text.alone(time)))
        }
        Expr::CountSub(a, b) => {
            text.count_sub(&text.within(a, Level::Atom), &text.within(b, Level::Atom))
        }
        Expr::CountLeft(a, b) => {
            text.count_left(&text.within(a, Level::Atom), &text.within(b, Level::Atom))
        }
        Expr::CountOver(a, by) => text.count_over(&text.within(a, Level::Atom), *by),
        Expr::CountAdd(a, b) => {
            let [a, b] = [a, b].map(|count| text.within(count, Level::Atom));
            (Level::Sum, format!("{a} + {b}"))
        }
        Expr::Tabulated(name, row, column) => {
            (Level::Atom, text.tabulated(name, &text.alone(row), *column))
        }
        Expr::Real(a) => text.real(&text.within(a, Level::Choice)),
        Expr::Choose(test, a, b) => {
            text.choose(&text.test(test), &text.within(a, Level::Sum), &text.within(b, Level::Sum))
        }
    }
}

/// A place in an array whose first element has the number `first`.
pub(in crate::emit) fn place(text: &dyn Text, index: &Index, first: i32) -> String {
    let constant = index.constant + first;
    let several = index.terms.len() > 1 || constant != 0;
    let mut out = String::new();
    let mut add = |negative: bool, part: &str| {
        out.push_str(match (out.is_empty(), negative) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        });
        out.push_str(part);
    };
    for (factor, name) in &index.terms {
        let name = text.local(name);
        let product = || format!("{} * {name}", text.whole(factor.unsigned_abs()));
        match factor.abs() {
            1 => add(*factor < 0, &name),
            _ if several => add(*factor < 0, &format!("({})", product())),
            _ => add(*factor < 0, &product()),
        }
    }
    match (index.terms.is_empty(), constant) {
        (true, constant) => constant.to_string(),
        (false, 0) => out,
        (false, constant) => {
            add(constant < 0, &text.whole(constant.unsigned_abs()));
            out
        }
    }
}

/// A comparison as it stands.
fn comparison(text: &dyn Text, a: &Expr, sign: &str, b: &Expr) -> String {
    format!("{} {sign} {}", text.within(a, Level::Sum), text.within(b, Level::Sum))
}

/// The lower end of a range, which stands on the left of what it bounds.
pub(in crate::emit) fn lower_end(text: &dyn Text, test: &Test) -> Option<String> {
    match test {
        Test::Less(a, b) => Some(comparison(text, a, "<", b)),
        Test::AtMost(a, b) => Some(comparison(text, a, "<=", b)),
        _ => None,
    }
}

/// Returns how often a value changes: never, from one start to the next, or from call to call. A comparison is read as a
/// statement on what changes more often, which stands on its left.
fn variability(value: &Expr) -> u8 {
    match value {
        Expr::Number(_) | Expr::Constant(_) | Expr::Count(_) => 0,
        Expr::Parameter(_)
        | Expr::ParameterElement(..)
        | Expr::Field(_)
        | Expr::FieldElement(..)
        | Expr::OfAxis(..) => 1,
        Expr::Neg(a) => variability(a),
        _ => 2,
    }
}

/// The tests that must all hold, each as an operand of [`Text::and`] where there are several.
pub(in crate::emit) fn parts(text: &dyn Text, test: &Test) -> Vec<String> {
    let two = |a: &Expr, sign: &str, b: &Expr| vec![comparison(text, a, sign, b)];
    let varies_behind = |a: &Expr, b: &Expr| variability(a) < variability(b);
    match test {
        Test::Less(a, b) | Test::CountLess(a, b) if varies_behind(a, b) => two(b, ">", a),
        Test::AtMost(a, b) if varies_behind(a, b) => two(b, ">=", a),
        Test::Less(a, b) | Test::CountLess(a, b) => two(a, "<", b),
        Test::AtMost(a, b) => two(a, "<=", b),
        Test::CountEqual(a, b) => two(a, text.equal(), b),
        Test::Finite(a) => vec![text.finite(&text.within(a, Level::Atom))],
        Test::NotNumber(a) => vec![text.not_number(&text.within(a, Level::Atom))],
        Test::Stands(whose) => vec![text.stands(&text.status_of(whose))],
        Test::Fails(whose) => vec![text.fails(&text.status_of(whose))],
        Test::All(tests) if tests.len() == 1 => text.parts(&tests[0]),
        Test::All(tests) => text.all(tests),
    }
}
