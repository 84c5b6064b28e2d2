//! Printing of expressions, shared by the printers and parameterised by the words of a language.

mod lines;

pub(in crate::emit) use lines::Lines;

use super::expression;
use crate::algebra::BigRational;
use crate::code::{AXIS, Constant, Expr, Index, Standing, Status, Table, Test, Whose};
use crate::parameter::Precision;

/// Precedence of an expression.
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

    /// A literal that is not negative. What has a default is as C and C++ write it.
    fn literal(&self, digits: &str) -> String {
        match self.precision() {
            Precision::F32 => format!("{digits}f"),
            Precision::F64 => digits.to_owned(),
        }
    }

    /// A literal count.
    fn count(&self, count: u32) -> String {
        format!("{count}U")
    }

    /// A local value or an argument.
    fn local(&self, name: &str) -> String {
        name.to_owned()
    }

    /// A field of what the function belongs to.
    fn field(&self, name: &str) -> String;

    /// Element `index`, from 0, of such a field.
    fn field_element(&self, name: &str, index: usize) -> String {
        self.element(&self.field(name), index)
    }

    /// A parameter of `init`.
    fn parameter(&self, name: &str) -> String;

    /// Element `index`, from 0, of an array.
    fn element(&self, array: &str, index: usize) -> String {
        format!("{array}[{index}]")
    }

    /// The number of the first element of an array.
    fn first(&self) -> i32 {
        0
    }

    /// A whole number in what counts elements.
    fn whole(&self, count: u32) -> String {
        self.count(count)
    }

    /// An element of an array.
    fn at(&self, array: &str, place: &str) -> String {
        format!("{array}[{place}]")
    }

    /// An element of an array of arrays, both counted from 0.
    fn entry(&self, array: &str, row: &str, column: usize) -> String {
        format!("{array}[{row}][{column}]")
    }

    /// Element `index` of the `stride` elements of a field that belong to the axis of the argument.
    fn of_axis(&self, name: &str, stride: usize, index: usize) -> String {
        let place = match (stride, index) {
            (1, _) => AXIS.to_owned(),
            (stride, 0) => format!("{stride}U * {AXIS}"),
            (stride, index) => format!("({stride}U * {AXIS}) + {index}U"),
        };
        format!("{}[{place}]", self.field(name))
    }

    /// a - b of counts, modulo 2^32.
    fn count_sub(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Sum, format!("{a} - {b}"))
    }

    /// a - b of counts, 0 where b is greater.
    fn count_left(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Choice, format!("({b} < {a}) ? ({a} - {b}) : 0U"))
    }

    /// A count over a number, rounded down.
    fn count_over(&self, count: &str, by: u32) -> (Level, String) {
        (Level::Product, format!("{count} / {}", self.count(by)))
    }

    /// A number with a name.
    fn constant(&self, own: &Constant) -> String {
        self.table(&own.name)
    }

    /// The literal of such a number, with its sign.
    fn literal_of(&self, constant: &Constant) -> String {
        match constant.count() {
            Some(count) => self.count(count),
            None => self.alone(&Expr::Number(constant.value.clone())),
        }
    }

    /// The name of a constant table.
    fn table(&self, name: &str) -> String {
        name.to_owned()
    }

    /// An element of a constant table, its column counted from 0.
    fn tabulated(&self, name: &str, row: &str, column: usize) -> String {
        self.entry(&self.table(name), row, column)
    }

    /// The numbers of each row of a constant table.
    fn rows(&self, table: &Table) -> Vec<Vec<String>> {
        let number = |exact: &BigRational| self.alone(&Expr::Number(exact.clone()));
        table.rows.iter().map(|row| row.iter().map(number).collect()).collect()
    }

    /// A count as a floating-point number.
    fn real(&self, count: &str) -> (Level, String);

    /// One of two values.
    fn choose(&self, test: &str, yes: &str, no: &str) -> (Level, String) {
        (Level::Choice, format!("({test}) ? {} : {}", bracketed(yes), bracketed(no)))
    }

    /// A function of the mathematical library by its name in formulas: `sqrt`, `ln`, `pow`.
    fn call(&self, function: &str, arguments: &[String]) -> String;

    /// a * b + c, rounded once; none where the language has no word for it, and refuses such a design.
    fn fused(&self, operands: &[String; 3]) -> Option<String>;

    /// |a|.
    fn abs(&self, a: &str) -> String;

    /// 1 for a > 0, -1 for a < 0, else a.
    fn sign(&self, a: &str) -> (Level, String) {
        let (zero, one) = (self.literal("0.0"), self.literal("1.0"));
        (Level::Choice, format!("({a} > {zero}) ? {one} : (({a} < {zero}) ? -{one} : {a})"))
    }

    /// a / b, and no number where b is 0 or no number.
    fn quotient(&self, a: &str, b: &str) -> (Level, String);

    /// No number.
    fn nan(&self) -> String;

    /// a, and no number where it is 0 or no number.
    fn divisor(&self, a: &str) -> (Level, String) {
        self.choose(&self.not_zero(a), a, &self.nan())
    }

    /// Test that a number is neither 0 nor NaN.
    fn not_zero(&self, a: &str) -> String {
        let (zero, or) = (self.literal("0.0"), self.or());
        format!("({a} < {zero}) {or} ({a} > {zero})")
    }

    /// Call of the user's function `name` with an array and a time.
    fn callback(&self, name: &str, array: &str, time: &str) -> String {
        format!("{name}({array}, {time})")
    }

    /// Test that a number is finite.
    fn finite(&self, value: &str) -> String;

    /// Test that a number is NaN.
    fn not_number(&self, value: &str) -> String;

    /// A status.
    fn status(&self, status: Status) -> String;

    /// The variable that holds a status.
    fn status_of(&self, whose: &Whose) -> String {
        match whose {
            Whose::Call => "status".to_owned(),
            Whose::Input(index) => self.at("axes", &self.place(index, self.first())),
        }
    }

    /// A status that is assigned.
    fn standing(&self, standing: &Standing) -> String {
        match standing {
            Standing::Known(status) => self.status(*status),
            Standing::Of(whose) => self.status_of(whose),
        }
    }

    /// One of several inputs that a function gives.
    fn input(&self, index: &Index) -> String {
        self.at("u", &self.place(index, self.first()))
    }

    /// Test that a status is not negative.
    fn stands(&self, status: &str) -> String {
        format!("{status} >= {}", self.status(Status::Ok))
    }

    /// Test that a status is negative.
    fn fails(&self, status: &str) -> String {
        format!("{status} < {}", self.status(Status::Ok))
    }

    /// The operator between tests that must all hold.
    fn and(&self) -> &'static str {
        "&&"
    }

    /// The operator between tests one of which must hold.
    fn or(&self) -> &'static str {
        "||"
    }

    /// Operator that tests for equality.
    fn equal(&self) -> &'static str {
        "=="
    }

    /// The same as an object: what all languages share is compiled once.
    fn as_text(&self) -> &dyn Text;

    /// An expression and how tightly it holds together.
    fn print(&self, value: &Expr) -> (Level, String) {
        expression::print(self.as_text(), value)
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

    /// A place in an array whose first element has the number `first`.
    fn place(&self, index: &Index, first: i32) -> String {
        expression::place(self.as_text(), index, first)
    }

    /// An end of a loop, moved by `behind`.
    fn end(&self, index: &Index, behind: i32) -> String {
        match (index.terms.as_slice(), u32::try_from(index.constant + behind)) {
            ([], Ok(count)) => self.whole(count),
            _ => self.place(index, behind),
        }
    }

    /// A test.
    fn test(&self, test: &Test) -> String {
        self.parts(test).join(&format!(" {} ", self.and()))
    }

    /// The tests that must all hold, each as an operand of [`Text::and`] where there are several.
    fn parts(&self, test: &Test) -> Vec<String> {
        expression::parts(self.as_text(), test)
    }

    /// Several tests, each as an operand of [`Text::and`].
    fn all(&self, tests: &[Test]) -> Vec<String> {
        let next = tests.iter().skip(1).map(Some).chain([None]);
        tests.iter().zip(next).flat_map(|(test, next)| self.operands(test, next)).collect()
    }

    /// A test as an operand of [`Text::and`] and [`Text::or`], before the `next` one.
    fn operands(&self, test: &Test, next: Option<&Test>) -> Vec<String> {
        let lower = expression::lower_end(self.as_text(), test);
        if let Some(lower) = lower.filter(|_| test.opens_range(next)) {
            return vec![format!("({lower})")];
        }
        match test {
            Test::Finite(_) | Test::NotNumber(_) => self.parts(test),
            _ => vec![format!("({})", self.test(test))],
        }
    }
}

/// A word that begins a sentence.
pub(in crate::emit) fn capital(word: &str) -> String {
    let (first, rest) = word.split_at(word.len().min(1));
    format!("{}{rest}", first.to_ascii_uppercase())
}

/// Without the brackets around the whole, where those of a statement or a call are enough.
pub(in crate::emit) fn bare(test: String) -> String {
    let inner = test.strip_prefix('(').and_then(|inner| inner.strip_suffix(')'));
    let whole = |inner: &&str| {
        let mut depth = 0i32;
        inner.chars().all(|c| {
            depth += i32::from(c == '(') - i32::from(c == ')');
            depth >= 0
        })
    };
    inner.filter(whole).map_or(test.clone(), str::to_owned)
}

/// A text of several words in brackets.
pub(in crate::emit) fn bracketed(text: &str) -> String {
    if text.contains(' ') { format!("({text})") } else { text.to_owned() }
}
