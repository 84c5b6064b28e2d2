//! One sample of a program, whose values are rows.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use super::super::chain::{Chain, Near, Row, centre};
use super::super::rounded::{Rounded, product, quotient, sum, unit_roundoff, units};
use super::repeats::Trace;
use super::{Held, is_rate};
use crate::algebra::BigRational;
use crate::code::{Code, Expr, Finish, Operator, Place, Shape, Statement, Table, Test};
use crate::expression::enclosure::Range;
use crate::parameter::Precision;
use crate::program::rounding::Units;
use crate::request::Sampled;

/// The numbers of a program as they are rounded, by their places in it.
type Numbers = Rc<RefCell<BTreeMap<*const BigRational, Rounded>>>;

/// One call of `step`.
#[derive(Clone)]
pub(super) struct Sample<'a> {
    precision: Precision,
    /// Numbers of what is kept and measured.
    terms: usize,
    kept: usize,
    pub(super) fields: BTreeMap<&'a str, Held>,
    pub(super) locals: BTreeMap<&'a str, Held>,
    measured: Vec<Held>,
    reference: Vec<Held>,
    numbers: Numbers,
    tables: &'a [Table],
    pub(super) trace: Trace<'a>,
}

impl<'a> Sample<'a> {
    pub(super) fn new(
        code: &'a Code,
        kept: &[&'a str],
        (sampled, references): (&Sampled, usize),
    ) -> Option<Self> {
        let (precision, known) = (code.precision, kept.len() + sampled.measured);
        let rates =
            code.fields.iter().map(|field| field.name.as_str()).filter(|name| is_rate(name));
        let rates: Vec<_> = rates.collect();
        let terms = known + references + rates.len();
        let nothing = Rounded::of(Range::from(0.0));
        let unit = |at: usize, error: f64| {
            let mut sum = vec![nothing; terms];
            sum[at] = Rounded { exact: Range::from(1.0), error };
            Held::Linear(sum)
        };
        // A measurement is rounded as it is handed over.
        let rounding = unit_roundoff(precision);
        let measured = (kept.len()..known).map(|at| unit(at, rounding)).collect();
        let reference = (known..known + references).map(|at| unit(at, 0.0)).collect();
        let mut fields = BTreeMap::new();
        for (at, name) in kept.iter().enumerate() {
            fields.insert(*name, unit(at, 0.0));
        }
        for (at, name) in (known + references..).zip(rates) {
            fields.insert(name, unit(at, 0.0));
        }
        fields.insert("seen", Held::Count(0));
        Some(Self {
            precision,
            terms,
            kept: kept.len(),
            fields,
            locals: BTreeMap::new(),
            measured,
            reference,
            numbers: Numbers::default(),
            tables: &code.tables,
            trace: Trace::default(),
        })
    }

    /// The same at sample `k`.
    pub(super) fn at(&self, k: usize) -> Option<Self> {
        let mut own = self.clone();
        own.locals.insert("k", Held::Count(u32::try_from(k).ok()?));
        own.fields.insert("seen", Held::Count(u32::from(k > 0)));
        Some(own)
    }

    /// The same with its counts alone.
    pub(super) fn counts(&self, k: usize) -> Option<Self> {
        let fields = self.fields.iter().filter(|(_, held)| matches!(held, Held::Count(_)));
        let fields = fields.map(|(name, held)| (*name, held.clone())).collect();
        let counts = Self {
            precision: self.precision,
            terms: self.terms,
            kept: self.kept,
            fields,
            locals: BTreeMap::new(),
            measured: Vec::new(),
            reference: Vec::new(),
            numbers: Rc::clone(&self.numbers),
            tables: self.tables,
            trace: Trace::default(),
        };
        counts.at(k)
    }

    /// A number of the program.
    fn number(&self, exact: &BigRational) -> Rounded {
        let mut numbers = self.numbers.borrow_mut();
        let place = std::ptr::from_ref(exact);
        *numbers.entry(place).or_insert_with(|| Rounded::number(exact, self.precision))
    }

    /// A value over the states x_1..x_n and what is kept, and over the causes.
    pub(super) fn row(&self, value: &Held, chain: &Chain, acts: bool) -> Option<Row> {
        let nothing = vec![Rounded::of(Range::from(0.0)); self.terms];
        let sum = match value {
            Held::Linear(sum) => sum,
            // What the first measurement does not show.
            Held::Known(known) if known.exact == Range::from(0.0) => &nothing,
            Held::Known(_) | Held::Count(_) => return None,
        };
        let near: Vec<Near> = sum.iter().map(|term| centre(term.exact, term.error)).collect();
        if near.iter().any(|(value, error)| !(value.is_finite() && error.is_finite())) {
            return None;
        }
        let measured = |j: usize| near.get(self.kept + j).copied().unwrap_or((0.0, 0.0));
        let states = chain.of_states(&near[self.kept..self.kept + self.measured.len()]);
        let of_state = states.into_iter().chain(near[..self.kept].iter().copied()).collect();
        let actuator = if acts { 1.0 } else { 0.0 };
        let of_cause = (0..chain.sensors()).map(measured).chain([(actuator, 0.0)]).collect();
        Some(Row { of_state, of_cause })
    }

    /// Returns the difference of each measurement from its prediction.
    pub(super) fn innovations(&self) -> Vec<Held> {
        let of = |name: &str| self.locals.get(name).cloned();
        match of("miss") {
            Some(only) => vec![only],
            None => (1..=self.measured.len()).map_while(|l| of(&format!("miss{l}"))).collect(),
        }
    }

    /// The value with which a call ends.
    pub(super) fn end(&self, finish: &'a Finish) -> Option<Held> {
        match finish {
            Finish::If(test, yes, no) => self.end(if self.test(test)? { yes } else { no }),
            Finish::Give(values, _) => self.real(values.first()?),
            Finish::Fail(_) | Finish::Stands => None,
        }
    }

    pub(super) fn block(&mut self, statements: &'a [Statement]) -> Option<()> {
        for statement in statements {
            match statement {
                Statement::Let(name, shape, value) => {
                    let value = match shape {
                        Shape::Count => self.counted(name, value)?,
                        _ => self.real(value)?,
                    };
                    self.locals.insert(name, value);
                }
                Statement::Set(Place::Local(name), value) => {
                    let is_count = matches!(self.locals.get(name.as_str()), Some(Held::Count(_)));
                    let value = match is_count {
                        true => self.counted(name, value)?,
                        false => self.real(value)?,
                    };
                    self.locals.insert(name, value);
                }
                Statement::Variable(name, Shape::Count) => {
                    self.locals.insert(name, Held::Count(0));
                }
                // What is kept from sample to sample, and what `init` leaves of it, is given.
                Statement::Set(Place::Field(name), value) => {
                    let given = matches!(value, Expr::Count(_) | Expr::Number(_));
                    if !(given && self.fields.contains_key(name.as_str())) {
                        let value = match value {
                            Expr::Count(count) => Held::Count(*count),
                            value => self.real(value)?,
                        };
                        self.fields.insert(name, value);
                    }
                }
                Statement::If(test, yes, no) => {
                    let block = if self.test(test)? { yes } else { no };
                    self.block(block)?;
                }
                Statement::Require(..) | Statement::Variable(..) | Statement::Note(_) => {}
                // No part of a controller in samples of a linear plant.
                Statement::Array(..)
                | Statement::Apply { .. }
                | Statement::Begin(..)
                | Statement::Call { .. }
                | Statement::For(_)
                | Statement::Leave
                | Statement::Root(..)
                | Statement::Set(Place::Element(..) | Place::Input(_), _)
                | Statement::Settle(..)
                | Statement::View { .. } => return None,
            }
        }
        Some(())
    }

    /// A count that gets a name.
    fn counted(&self, name: &'a str, value: &'a Expr) -> Option<Held> {
        self.trace.count(name, value);
        Some(Held::Count(self.count(value)?))
    }

    /// Evaluates a test; if it depends on the states it compares with a limit of u, which is not reached.
    pub(super) fn test(&self, test: &'a Test) -> Option<bool> {
        let counts = |outcome: bool| {
            self.trace.test(test, outcome);
            Some(outcome)
        };
        match test {
            Test::CountLess(a, b) => counts(self.count(a)? < self.count(b)?),
            Test::CountEqual(a, b) => counts(self.count(a)? == self.count(b)?),
            Test::Stands(_) | Test::Fails(_) => None,
            Test::Less(a, b) | Test::AtMost(a, b) => self.trace.compare(test, || {
                let (Held::Known(a), Held::Known(b)) = (self.real(a)?, self.real(b)?) else {
                    return Some(false);
                };
                let (a, b) = (a.emitted(), b.emitted());
                // If neither is below the other, both are the same number.
                Some(a.is_below(&b) || !b.is_below(&a) && matches!(test, Test::AtMost(..)))
            }),
            Test::Finite(_) => Some(true),
            Test::NotNumber(_) => Some(false),
            Test::All(tests) => {
                tests.iter().try_fold(true, |all, test| Some(all && self.test(test)?))
            }
        }
    }

    pub(super) fn count(&self, value: &Expr) -> Option<u32> {
        match value {
            Expr::Count(count) => Some(*count),
            Expr::Constant(own) => own.count(),
            Expr::CountSub(a, b) => Some(self.count(a)?.wrapping_sub(self.count(b)?)),
            Expr::CountLeft(a, b) => Some(self.count(a)?.saturating_sub(self.count(b)?)),
            Expr::CountOver(a, by) => Some(self.count(a)? / by),
            Expr::CountAdd(a, b) => self.count(a)?.checked_add(self.count(b)?),
            name => match self.held(name)? {
                Held::Count(count) => Some(*count),
                _ => None,
            },
        }
    }

    fn held(&self, name: &Expr) -> Option<&Held> {
        match name {
            Expr::Local(name) => self.locals.get(name.as_str()),
            Expr::Field(name) => self.fields.get(name.as_str()),
            Expr::Element(name, index) if name == "r" => self.reference.get(*index),
            Expr::Element(_, index) => self.measured.get(*index),
            _ => None,
        }
    }

    fn real(&self, value: &'a Expr) -> Option<Held> {
        let units = units(self.precision);
        match value {
            Expr::Number(exact) => Some(Held::Known(self.number(exact))),
            Expr::Neg(a) => Some(match self.real(a)? {
                Held::Known(a) => Held::Known(negative(a)),
                Held::Linear(sum) => Held::Linear(sum.into_iter().map(negative).collect()),
                Held::Count(_) => return None,
            }),
            Expr::Binary(operator, a, b) => {
                let (a, b) = (self.real(a)?, self.real(b)?);
                match operator {
                    Operator::Add => self.sum(a, b, units),
                    Operator::Sub => match b {
                        Held::Known(b) => self.sum(a, Held::Known(negative(b)), units),
                        Held::Linear(b) => {
                            let b = b.into_iter().map(negative).collect();
                            self.sum(a, Held::Linear(b), units)
                        }
                        Held::Count(_) => None,
                    },
                    Operator::Mul => times(a, b, units),
                    Operator::Div => match (a, b) {
                        (Held::Known(a), Held::Known(b)) => quotient(a, b, units).map(Held::Known),
                        (Held::Linear(sum), Held::Known(k)) => {
                            let each = sum.into_iter().map(|term| quotient(term, k, units));
                            each.collect::<Option<Vec<_>>>().map(Held::Linear)
                        }
                        _ => None,
                    },
                }
            }
            Expr::Fused(operands) => {
                let [a, b, c] = &**operands;
                let unrounded = times(self.real(a)?, self.real(b)?, Units::EXACT)?;
                self.sum(unrounded, self.real(c)?, units)
            }
            Expr::Real(a) => {
                let count = self.count(a)?;
                self.trace.number(a, count);
                let exact = Range::from(f64::from(count));
                let error = match self.precision {
                    Precision::F64 => 0.0,
                    Precision::F32 => units.roundoff * exact.high(),
                };
                Some(Held::Known(Rounded { exact, error }))
            }
            Expr::Constant(own) => Some(Held::Known(self.number(&own.value))),
            Expr::Tabulated(name, row, column) => {
                let place = self.count(row)?;
                self.trace.number(row, place);
                let numbers = self
                    .tables
                    .iter()
                    .find(|table| table.name == *name)?
                    .rows
                    .get(place as usize)?;
                Some(Held::Known(self.number(numbers.get(*column)?)))
            }
            Expr::Choose(test, a, b) => self.real(if self.test(test)? { a } else { b }),
            // A limit of u that is left to run time is not reached.
            Expr::Parameter(_) => Some(Held::Known(Rounded::of(Range::from(f64::INFINITY)))),
            name => self.held(name).cloned(),
        }
    }

    fn sum(&self, a: Held, b: Held, units: Units) -> Option<Held> {
        match (a, b) {
            (Held::Known(a), Held::Known(b)) => Some(Held::Known(sum(a, b, units))),
            (Held::Linear(a), Held::Linear(b)) => {
                let each = a.into_iter().zip(b).map(|(a, b)| sum(a, b, units));
                Some(Held::Linear(each.collect()))
            }
            // A nonzero constant makes the loop affine, which is not examined.
            (Held::Linear(a), Held::Known(k)) | (Held::Known(k), Held::Linear(a)) => {
                (k.exact == Range::from(0.0) && a.len() == self.terms).then_some(Held::Linear(a))
            }
            _ => None,
        }
    }
}

fn negative(a: Rounded) -> Rounded {
    Rounded { exact: -a.exact, ..a }
}

/// The product of two values, of which one at most depends on the states.
fn times(a: Held, b: Held, units: Units) -> Option<Held> {
    match (a, b) {
        (Held::Known(a), Held::Known(b)) => Some(Held::Known(product(a, b, units))),
        (Held::Known(k), Held::Linear(sum)) | (Held::Linear(sum), Held::Known(k)) => {
            let each = sum.into_iter().map(|term| product(k, term, units));
            Some(Held::Linear(each.collect()))
        }
        _ => None,
    }
}
