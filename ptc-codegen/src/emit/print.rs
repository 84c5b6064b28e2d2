//! From the values of one function to statements. Every language writes sums, differences, products
//! and quotients alike; all else stands in its [`Syntax`], one method for each operation.

use std::collections::BTreeMap;

use crate::controller::plan::{Plan, Routine};
use crate::expression::Function;
use crate::internal::fault;
use crate::parameter::Precision;
use crate::program::{Input, Op, Root, Stage, Value, number};

/// What differs between the languages: the names, the tests of the frame, and then the operations, one
/// method for each. None has a default but the name, so that a new operation is written for all.
pub(super) trait Syntax {
    /// The name under which a value is kept; two values never share one.
    fn name(&self, name: &str) -> String {
        name.to_owned()
    }
    /// A literal of the program's precision, without a sign, from its shortest decimal digits.
    fn literal(&self, text: &str) -> String;
    /// A field of the controller.
    fn field(&self, name: &str) -> String;
    /// A field of the controller that `init` is building.
    fn built(&self, name: &str) -> String;
    /// A field of the gains.
    fn gains_field(&self, name: &str) -> String;
    /// Whether a number is finite.
    fn finite(&self, name: &str) -> String;
    /// Whether a product keeps its digits, by the function of the emitted file that decides it.
    fn kept(&self, product: &str, factor: &str) -> String;
    /// A call of a function by its mathematical name: `sqrt`, `ln`, `pow`.
    fn call(&self, function: &str, arguments: &[String]) -> String;
    /// |a|.
    fn abs(&self, a: &str) -> String;
    /// 1 for a > 0, -1 for a < 0, else a.
    fn sign(&self, a: &str, zero: &str, one: &str) -> String;
    /// a / b, and NaN where b is 0 or NaN; both are operands already.
    fn quotient(&self, a: &str, b: &str, zero: &str) -> String;
    /// `yes` where the condition holds, else `no`.
    fn select(&self, condition: &str, yes: &str, no: &str) -> String;
    /// The call of the user's own law for the time after the deadline.
    fn after(&self) -> String;
    /// The user's own law: statements that prepare the call, and the call.
    fn law(&self, xi: &[String], time: &str) -> (Vec<String>, String);
    /// The greater one of a and b.
    fn max(&self, a: &str, b: &str) -> String;
    /// Definition of a constant.
    fn define(&self, name: &str, expression: &str) -> String;
    /// The smaller one of a and b.
    fn min(&self, a: &str, b: &str) -> String;
    /// An input, by its name.
    fn input(&self, input: Input, name: &str) -> String;
    /// The function of the loops of [`Op::Rows`], for so many weights.
    fn rows_function(&self, weights: usize) -> Vec<String>;
    /// An element of an array of the program or of the user's, from 0.
    fn element(&self, array: &str, index: usize) -> String;
    /// Its call: statements that leave the array in `name`.
    fn rows(&self, name: &str, tail: &[String], weights: &[String]) -> Vec<String>;
    /// The loop that finds a root; `body` computes one round.
    fn root(&self, root: &RootText<'_>) -> Vec<String>;
}

/// The parts of a root-finding loop, as text.
pub(super) struct RootText<'a> {
    pub(super) unknown: &'a str,
    pub(super) start: &'a str,
    pub(super) low: &'a str,
    pub(super) high: &'a str,
    pub(super) body: &'a [String],
    pub(super) residual: &'a str,
    pub(super) next: &'a str,
    pub(super) size: &'a str,
    pub(super) tolerance: &'a str,
    pub(super) half: &'a str,
    pub(super) zero: &'a str,
    pub(super) rounds: u32,
}

/// A literal of single precision for a language that reads all numbers as doubles: the same number in
/// the digits of a double, so that it is rounded once.
pub(super) fn through_double(text: &str) -> String {
    let single: f32 = text.parse().unwrap_or(f32::NAN);
    format!("{:?}", f64::from(single))
}

/// An expression under construction; a compound one needs parentheses as an operand.
#[derive(Clone)]
struct Expression {
    text: String,
    operator: Option<char>,
}

impl Expression {
    fn atom(text: String) -> Self {
        Self { text, operator: None }
    }

    fn operand(&self) -> String {
        if self.operator.is_some() { format!("({})", self.text) } else { self.text.clone() }
    }

    /// As the left operand of `operator`: a + b + c and a * b * c associate to the left anyway.
    fn left(&self, operator: char) -> String {
        if self.operator == Some(operator) && matches!(operator, '+' | '*') {
            self.text.clone()
        } else {
            self.operand()
        }
    }
}

/// Longest expression before it gets a name of its own.
const WIDTH: usize = 64;

/// The statements of one function and the expressions of its roots.
pub(super) struct Body {
    /// Statements, without indentation of their own.
    pub(super) lines: Vec<String>,
    /// One expression for each root, in order.
    pub(super) roots: Vec<String>,
}

/// Prints what `function` computes.
pub(super) fn print(plan: &Plan<'_>, function: Routine, syntax: &dyn Syntax) -> Body {
    print_with(plan, function, &[], syntax)
}

/// The same with further values of the function, whose expressions follow those of its roots.
pub(super) fn print_with(
    plan: &Plan<'_>,
    function: Routine,
    further: &[Value],
    syntax: &dyn Syntax,
) -> Body {
    let roots = [plan.roots(function).as_slice(), further].concat();
    let mut printer = Printer {
        plan,
        function,
        syntax,
        uses: uses(plan, function, &roots),
        known: BTreeMap::new(),
        lines: Vec::new(),
        temporaries: 0,
    };
    for value in plan.program.needed(&roots) {
        if !plan.program.get(value).looped && printer.uses.contains_key(&value) {
            printer.value(value);
        }
    }
    let roots = roots.iter().map(|v| printer.expression(*v).text).collect();
    Body { lines: printer.lines, roots }
}

/// How often each value is used in the function; values that only fields need are left out.
fn uses(plan: &Plan<'_>, function: Routine, roots: &[Value]) -> BTreeMap<Value, usize> {
    let mut uses: BTreeMap<Value, usize> = BTreeMap::new();
    for root in roots {
        *uses.entry(*root).or_default() += 1;
    }
    for value in plan.program.needed(roots).into_iter().rev() {
        if uses.contains_key(&value) && !plan.is_field(function, value) {
            let op = &plan.program.get(value).op;
            // The greater or smaller of two values is written with each of them twice.
            let times = match op {
                Op::Max(..) | Op::Min(..) | Op::Quotient(..) | Op::Call(Function::Sign, _) => 2,
                _ => 1,
            };
            for operand in op.operands() {
                *uses.entry(operand).or_default() += times;
            }
        }
    }
    uses
}

struct Printer<'a> {
    plan: &'a Plan<'a>,
    function: Routine,
    syntax: &'a dyn Syntax,
    uses: BTreeMap<Value, usize>,
    known: BTreeMap<Value, Expression>,
    lines: Vec<String>,
    temporaries: usize,
}

impl Printer<'_> {
    fn expression(&self, value: Value) -> Expression {
        let known = self.known.get(&value).cloned();
        known.unwrap_or_else(|| fault(format!("value {} is used before it is computed", value.0)))
    }

    fn name(&self, value: Value) -> &str {
        let name = self.plan.name(value);
        name.unwrap_or_else(|| fault(format!("value {} has no name", value.0)))
    }

    fn text(&self, value: Value) -> String {
        self.expression(value).text
    }

    fn operand(&self, value: Value) -> String {
        self.expression(value).operand()
    }

    /// Computes a value: as a statement where it has a name or several users, else in place.
    fn value(&mut self, value: Value) {
        let definition = self.plan.program.get(value);
        if self.plan.is_field(self.function, value) {
            let field = self.syntax.field(self.name(value));
            self.known.insert(value, Expression::atom(field));
            return;
        }
        match &definition.op {
            Op::Input(input) => {
                let name = self.plan.name(value).unwrap_or_default();
                let text = self.syntax.input(*input, name);
                if text.is_empty() {
                    fault(format!("{input:?} has no name"));
                }
                self.known.insert(value, Expression::atom(text));
            }
            Op::Root(root) => self.root(value, root),
            Op::Law(arguments) => {
                let mut texts: Vec<_> = arguments.iter().map(|v| self.text(*v)).collect();
                let time = texts.pop().unwrap_or_else(|| fault("a law without time"));
                let (lines, call) = self.syntax.law(&texts, &time);
                self.lines.extend(lines);
                let name = self.fresh(value);
                self.lines.push(self.syntax.define(&name, &call));
                self.known.insert(value, Expression::atom(name));
            }
            Op::Rows { tail, weights } => {
                let [tail, weights] =
                    [tail, weights].map(|v| v.iter().map(|v| self.text(*v)).collect::<Vec<_>>());
                let name = self.fresh(value);
                self.lines.extend(self.syntax.rows(&name, &tail, &weights));
                self.known.insert(value, Expression::atom(name));
            }
            Op::Element(array, index) => {
                let element = self.syntax.element(&self.text(*array), *index);
                self.known.insert(value, Expression::atom(element));
            }
            op => {
                let expression = self.operation(op);
                let shared = self.uses.get(&value).is_some_and(|uses| *uses > 1);
                let named = definition.name.is_some() && definition.stage >= Stage::Init;
                let literal = self.plan.is_literal(value);
                if !literal && (shared || named || expression.text.len() > WIDTH) {
                    let name = self.fresh(value);
                    self.lines.push(self.syntax.define(&name, &expression.text));
                    self.known.insert(value, Expression::atom(name));
                } else {
                    self.known.insert(value, expression);
                }
            }
        }
    }

    fn fresh(&mut self, value: Value) -> String {
        if let Some(name) = self.plan.name(value) {
            return name.to_owned();
        }
        self.temporaries += 1;
        format!("v{}", self.temporaries)
    }

    fn operation(&self, op: &Op) -> Expression {
        let operand = |v: &Value| self.expression(*v).operand();
        let binary = |operator: char, a: &Value, b: &Value| Expression {
            text: format!("{} {operator} {}", self.expression(*a).left(operator), operand(b)),
            operator: Some(operator),
        };
        let call = |function, arguments: &[Value]| {
            let arguments: Vec<_> = arguments.iter().map(|v| self.text(*v)).collect();
            Expression::atom(self.syntax.call(function, &arguments))
        };
        match op {
            Op::Number(value) => self.number(number::round(value, self.precision())),
            Op::Neg(a) => Expression { text: format!("-{}", operand(a)), operator: Some('-') },
            Op::Add(a, b) => binary('+', a, b),
            Op::Sub(a, b) => binary('-', a, b),
            Op::Mul(a, b) => binary('*', a, b),
            Op::Div(a, b) => binary('/', a, b),
            Op::Quotient(a, b) => {
                let zero = self.number(0.0).text;
                let text = self.syntax.quotient(&operand(a), &operand(b), &zero);
                Expression { text, operator: Some('?') }
            }
            Op::Max(a, b) => Expression {
                text: self.syntax.max(&self.text(*a), &self.text(*b)),
                operator: Some('?'),
            },
            Op::Min(a, b) => Expression {
                text: self.syntax.min(&self.text(*a), &self.text(*b)),
                operator: Some('?'),
            },
            Op::Call(Function::Abs, a) => Expression::atom(self.syntax.abs(&self.text(*a))),
            Op::Call(Function::Sign, a) => {
                let (zero, one) = (self.number(0.0).text, self.number(1.0).text);
                let text = self.syntax.sign(&self.operand(*a), &zero, &one);
                Expression { text, operator: Some('?') }
            }
            Op::Call(function, a) => call(function.name(), &[*a]),
            Op::Pow(a, b) => call("pow", &[*a, *b]),
            // The pass `chains` has written powers out, and the caller handles the rest.
            Op::Power(..)
            | Op::Input(_)
            | Op::Law(_)
            | Op::Rows { .. }
            | Op::Element(..)
            | Op::Unknown
            | Op::Root(_) => fault(format!("{op:?} is no part of an expression")),
        }
    }

    fn precision(&self) -> Precision {
        self.plan.program.precision
    }

    /// A literal; a negative one is an expression with a sign.
    fn number(&self, value: f64) -> Expression {
        let text = self.syntax.literal(&number::literal(value.abs(), self.precision()));
        if value.is_sign_negative() {
            Expression { text: format!("-{text}"), operator: Some('-') }
        } else {
            Expression::atom(text)
        }
    }

    fn root(&mut self, value: Value, root: &Root) {
        let unknown = self.name(root.unknown).to_owned();
        self.known.insert(root.unknown, Expression::atom(unknown.clone()));
        let outside = std::mem::take(&mut self.lines);
        for inner in self.plan.program.needed(&[root.residual, root.next, root.size]) {
            if self.plan.program.get(inner).looped && inner != root.unknown {
                self.value(inner);
            }
        }
        let body = std::mem::replace(&mut self.lines, outside);
        let (half, zero) = (self.number(0.5).text, self.number(0.0).text);
        let text = |v: Value| self.text(v);
        let lines = self.syntax.root(&RootText {
            unknown: &unknown,
            start: &text(root.start),
            low: &text(root.low),
            high: &text(root.high),
            body: &body,
            residual: &text(root.residual),
            next: &text(root.next),
            size: &text(root.size),
            tolerance: &text(root.tolerance),
            half: &half,
            zero: &zero,
            rounds: root.rounds,
        });
        self.lines.extend(lines);
        self.known.insert(value, Expression::atom(unknown));
    }
}
