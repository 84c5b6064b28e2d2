//! The zero dynamics: what the plant does beside an output that is held at 0, at its rest point.

use num_traits::Zero;

use super::coupled::{Coupled, Inverse};
use super::decide::with;
use super::{Model, Values};
use crate::algebra::polynomial::Polynomial;
use crate::algebra::stability::{is_bounded, is_hurwitz};
use crate::algebra::{BigRational, integer};
use crate::expression::effort::bounded;
use crate::expression::evaluator::{Evaluator, Names};
use crate::expression::existence::{Condition, needs};
use crate::expression::normal::normal;
use crate::expression::{Expression, Variable};
use crate::linear::Matrix;

/// What is known of the zero dynamics at the origin.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Zeros {
    /// L_g L_f^(r-1) h is 0 there: the law divides by 0.
    Singular,
    /// There are none.
    None,
    /// The roots of their linearisation have negative real parts.
    Stable(Polynomial),
    /// One of its roots has a positive real part.
    Unstable(Polynomial),
    /// Roots on the imaginary axis and no others to the right: the linearisation does not decide.
    Critical(Polynomial),
    /// Why they are not known.
    Open(String),
}

/// The zero dynamics of `model` at the origin, with `gain` = L_g L_f^(r-1) h and the values of its
/// parameters as far as they are fixed.
pub(crate) fn zeros(model: &Model, gain: &Expression, values: &Values) -> Zeros {
    bounded(|| {
        let point = Point { model, values };
        if point.number(gain).is_ok_and(|gain| gain.is_zero()) {
            return Zeros::Singular;
        }
        if model.coordinates.len() == model.states.len() {
            return Zeros::None;
        }
        match point.polynomial() {
            Err(why) => Zeros::Open(why),
            Ok(p) if is_hurwitz(&p) => Zeros::Stable(p),
            Ok(p) if is_unstable(&p) => Zeros::Unstable(p),
            Ok(p) => Zeros::Critical(p),
        }
    })
}

/// The determinant that several inputs are divided by, where it is 0 at the origin.
pub(crate) fn singular_at_rest(coupled: &Coupled, values: &Values) -> Option<String> {
    let at_rest = |e: &Expression| bounded(|| normal(&at_origin(e, values)));
    match &coupled.inverse {
        Inverse::Adjugate { determinant, .. } => {
            let singular = at_rest(determinant).number().is_some_and(Zero::is_zero);
            singular.then(|| coupled.text(determinant))
        }
        Inverse::Elimination { matrix, .. } => {
            let row = |row: &Vec<Expression>| -> Option<Vec<_>> {
                row.iter().map(|entry| at_rest(entry).number().cloned()).collect()
            };
            let numbers = Matrix::of(matrix.iter().map(row).collect::<Option<_>>()?);
            let right = vec![BigRational::default(); matrix.len()];
            numbers.solve(&right).is_none().then(|| format!("det {}", coupled.matrix(matrix)))
        }
        Inverse::Inertia { .. } => None,
    }
}

/// The expression with all states at 0.
fn at_origin(expression: &Expression, values: &Values) -> Expression {
    with(expression, values).substitute(&|e| {
        matches!(e.variable(), Some(Variable::State(_))).then(|| Expression::integer(0))
    })
}

/// Whether a root has a positive real part: repeated ones on the axis are counted once.
fn is_unstable(p: &Polynomial) -> bool {
    !is_bounded(&p.radical())
}

/// The origin.
struct Point<'a> {
    model: &'a Model,
    values: &'a Values,
}

impl Point<'_> {
    /// An expression without the input at the origin.
    fn number(&self, expression: &Expression) -> Result<BigRational, String> {
        let form = normal(&self.at(expression));
        if let Some(open) = form.parameters().into_iter().next() {
            return Err(format!("`{}` is left to run time", open.spelling()));
        }
        let text = || format!("{} at the origin is no exact number", self.model.text(expression));
        let exists = |(e, condition): (Expression, Condition)| {
            let value = Evaluator::new().value(&self.at(&e), &Names::new());
            value.is_some_and(|value| condition.is_certain(&value.interval))
        };
        let known = needs(expression).into_iter().all(exists);
        form.number().filter(|_| known).cloned().ok_or_else(text)
    }

    /// The expression at the origin.
    fn at(&self, expression: &Expression) -> Expression {
        at_origin(expression, self.values)
    }

    /// The characteristic polynomial of the linearised zero dynamics. With the feedback that holds
    /// the output of z' = A z + B v, y = C z at 0, v = -C A^r z / (C A^(r-1) B), it is what is left
    /// of that of the loop without its r roots at 0.
    fn polynomial(&self) -> Result<Polynomial, String> {
        let (a, b, c) = self.linear()?;
        let r = self.model.coordinates.len();
        let mut row = c;
        for _ in 1..r {
            row = times(&row, &a);
        }
        let gain: BigRational = row.iter().zip(&b).map(|(c, b)| c * b).sum();
        if gain.is_zero() {
            return Err("the linearisation at the origin has another relative degree".to_owned());
        }
        let row = times(&row, &a);
        let closed = |i: usize| {
            let entry = |j: usize| &a[i][j] - &b[i] * &row[j] / &gain;
            (0..b.len()).map(entry).collect()
        };
        let closed: Vec<Vec<_>> = (0..b.len()).map(closed).collect();
        let all = characteristic(&closed);
        let (at_zero, own) = all.split_at(r);
        match at_zero.iter().all(Zero::is_zero) {
            true => Ok(Polynomial::new(own.to_vec())),
            false => Err("the linearisation at the origin has another relative degree".to_owned()),
        }
    }

    /// A, B and C of the plant at the origin, with the input that keeps it there.
    #[allow(clippy::type_complexity)]
    fn linear(
        &self,
    ) -> Result<(Vec<Vec<BigRational>>, Vec<BigRational>, Vec<BigRational>), String> {
        let Model { states, output, dynamics, .. } = self.model;
        if let Some(kink) = dynamics.iter().chain([output]).find(|e| e.any(&Expression::is_kink)) {
            return Err(format!("{} has a kink: it has no linearisation", self.model.text(kink)));
        }
        if !self.number(output)?.is_zero() {
            return Err("the output is not 0 at the origin".to_owned());
        }
        let control = Expression::from(Variable::Control);
        let applied = |e: &Expression, u: &BigRational| {
            e.substitute(&|leaf| (*leaf == control).then(|| Expression::from(u.clone())))
        };
        let at_rest = |e: &Expression| self.number(&applied(e, &BigRational::zero()));
        let slope = |e: &Expression| at_rest(&e.derivative(Variable::Control));
        let f = dynamics.iter().map(at_rest).collect::<Result<Vec<_>, _>>()?;
        let b = dynamics.iter().map(slope).collect::<Result<Vec<_>, _>>()?;
        let moved = f.iter().zip(&b).find(|(_, b)| !b.is_zero());
        let u = moved.map_or_else(BigRational::zero, |(f, b)| -f / b);
        if let Some(j) = (0..f.len()).find(|j| !(&f[*j] + &b[*j] * &u).is_zero()) {
            let name = states[j];
            return Err(format!("the origin is no rest point: {name}' is not 0 there"));
        }
        let row = |e: &Expression| {
            let entry = |j| self.number(&applied(e, &u).derivative(Variable::State(j)));
            (1..=states.len()).map(entry).collect::<Result<Vec<_>, _>>()
        };
        let a = dynamics.iter().map(row).collect::<Result<Vec<_>, _>>()?;
        Ok((a, b, row(output)?))
    }
}

fn times(row: &[BigRational], matrix: &[Vec<BigRational>]) -> Vec<BigRational> {
    let entry = |j: usize| row.iter().zip(matrix).map(|(c, row)| c * &row[j]).sum();
    (0..row.len()).map(entry).collect()
}

/// The coefficients of det(s - A) from the constant on, by Faddeev and LeVerrier.
fn characteristic(a: &[Vec<BigRational>]) -> Vec<BigRational> {
    let n = a.len();
    let mut coefficients = vec![integer(1)];
    let mut m = vec![vec![BigRational::zero(); n]; n];
    for k in (1i64..).take(n) {
        // M_k = A M_(k-1) + c_(n-k+1).
        let mut next: Vec<Vec<_>> = a.iter().map(|row| times(row, &m)).collect();
        let last = coefficients[0].clone();
        next.iter_mut().enumerate().for_each(|(i, row)| row[i] += &last);
        m = next;
        let trace: BigRational = (0..n).map(|i| times(&a[i], &m)[i].clone()).sum();
        coefficients.insert(0, -trace / integer(k));
    }
    coefficients
}
