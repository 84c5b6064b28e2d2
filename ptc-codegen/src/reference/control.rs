//! u by Theorem 1.

use astro_float_num::BigFloat;

use super::Call;
use super::law::{Leaves, Term, larger};
use super::long::{Arithmetic, double};
use super::mapping::Point;
use crate::expression::{Expression, Variable};
use crate::parameter::Parameter;
use crate::request::{Feedback, Reference, Spec};

/// A chain of integrators: its coordinates, less the reference where there is one, that with its derivatives,
/// and xi.
pub(super) struct Chain {
    x: Vec<Term>,
    reference: Vec<Term>,
    pub(super) xi: Vec<Term>,
}

impl Arithmetic {
    /// The chain of a controller in the state of a call.
    pub(super) fn chain(
        &mut self,
        spec: &Spec,
        call: &Call<'_>,
        point: &Point,
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Chain {
        let mut x = self.coordinates(spec, call.x, parameter);
        let reference = self.followed(spec, call, parameter);
        for (x, wanted) in x.iter_mut().zip(&reference) {
            *x = self.less(x, wanted);
        }
        let xi = self.stretched_state(point, &x);
        Chain { x, reference, xi }
    }

    /// Theorem 1: u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x), with the mapping at the time of
    /// the call and, where a state is latched, at the start. Where there is a reference, x is the
    /// tracking error, and r^(n) is added to what the law gives. The law knows `xi`, of all chains.
    pub(super) fn control(
        &mut self,
        spec: &Spec,
        (call, to_go): (&Call<'_>, &BigFloat),
        [point, at_start]: [&Point; 2],
        (chain, xi): (&Chain, &[Term]),
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Option<Term> {
        let n = spec.n;
        // Gains are those of one chain.
        let xi = if spec.feedback == Feedback::Linear { &chain.xi } else { xi };
        let starts: Vec<_> = call.x0.iter().map(|x| Term::given(self.double(*x))).collect();
        let starts = self.stretched_state(at_start, &starts);
        let start = self.double(parameter(Parameter::StartTime));
        let stretched = Term {
            value: self.add(&point.stretched, &start),
            size: self.add(&point.stretched.abs(), &start.abs()),
        };
        let time = self.double(call.t);
        let elapsed = self.sub(&time, &start);
        let bits = self.bits();
        let states = |x: &[f64], j: usize| double(x[j - 1], bits);
        let number = |p| double(parameter(p), bits);
        let variable = |v: Variable| match v {
            Variable::SinceStart => Term::given(point.stretched.clone()),
            Variable::StretchedTime => stretched.clone(),
            Variable::Time => Term::given(time.clone()),
            Variable::Elapsed => Term::given(elapsed.clone()),
            Variable::TimeToGo => Term::given(to_go.clone()),
            Variable::KappaRate => Term::given(point.slope.clone()),
            Variable::R(k) => Term::given(point.r[k - 1].clone()),
            // No expression of a controller knows its own result.
            Variable::Control => Term::given(double(f64::NAN, bits)),
            Variable::State(j) => Term::given(states(call.x, j)),
            Variable::StateAtStart(j) => Term::given(states(call.x0, j)),
            Variable::Xi(j) => xi[j - 1].clone(),
            Variable::XiAtStart(j) => starts[j - 1].clone(),
        };
        let leaves = Leaves { parameter: &number, variable: &variable };
        let law = match &spec.feedback {
            Feedback::Linear => linear(n),
            Feedback::Expression(law) => law.clone(),
            Feedback::Extern => call.laws.first()?.clone(),
            // One in samples.
            Feedback::LeastEnergy(_) => return None,
        };
        let mut u = self.term(&law, &leaves);
        // A law that is a number alone is still a term of u.
        u.size = larger(&u.size, &u.value);
        for (entry, x) in point.bell[n].iter().zip(&chain.x) {
            u.value = self.sub(&u.value, &self.mul(entry, &x.value));
            u.size = self.add(&u.size, &self.mul(entry, &x.size).abs());
        }
        let factor = (0..n).fold(self.integer(1), |power, _| self.mul(&power, &point.slope));
        u = Term { value: self.mul(&factor, &u.value), size: self.mul(&factor, &u.size).abs() };
        if let Some(rate) = chain.reference.last() {
            u = self.less(&u, &Term { value: rate.value.neg(), size: rate.size.clone() });
        }
        if let Some(drift) = &spec.drift {
            let drift = self.term(drift, &leaves);
            u = self.less(&u, &drift);
        }
        if let Some(gain) = &spec.input_gain {
            let gain = self.term(gain, &leaves);
            u = self.over(&u, &gain);
        }
        Some(u)
    }

    /// x_1..x_n: the state of the call, or what the model of the plant makes of it.
    fn coordinates(
        &mut self,
        spec: &Spec,
        x: &[f64],
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Vec<Term> {
        let bits = self.bits();
        let Some(model) = &spec.model else {
            return x[..spec.n].iter().map(|x| Term::given(double(*x, bits))).collect();
        };
        let number = |p| double(parameter(p), bits);
        let variable = |v: Variable| match v {
            Variable::State(j) => Term::given(double(x[j - 1], bits)),
            // The coordinates are functions of the states alone.
            _ => Term::given(double(f64::NAN, bits)),
        };
        let leaves = Leaves { parameter: &number, variable: &variable };
        model.coordinates.iter().map(|coordinate| self.term(coordinate, &leaves)).collect()
    }

    /// a - b; a b that is a number alone is still a term.
    pub(super) fn less(&self, a: &Term, b: &Term) -> Term {
        let size = larger(&b.size, &b.value);
        Term { value: self.sub(&a.value, &b.value), size: self.add(&a.size, &size) }
    }

    /// The reference and its n derivatives at the time of the call; empty where there is none.
    fn followed(
        &mut self,
        spec: &Spec,
        call: &Call<'_>,
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Vec<Term> {
        let bits = self.bits();
        let Some(Reference::Known(derivatives)) = &spec.reference else {
            let given = call.x.iter().skip(spec.states()).take(spec.n + 1);
            return given.map(|r| Term::given(double(*r, bits))).collect();
        };
        let time = double(call.t, bits);
        let elapsed = self.sub(&time, &double(parameter(Parameter::StartTime), bits));
        let number = |p| double(parameter(p), bits);
        let variable = |v: Variable| match v {
            Variable::Time => Term::given(time.clone()),
            Variable::Elapsed => Term::given(elapsed.clone()),
            // A reference is a function of time alone.
            _ => Term::given(double(f64::NAN, bits)),
        };
        let leaves = Leaves { parameter: &number, variable: &variable };
        derivatives.iter().map(|e| self.term(e, &leaves)).collect()
    }

    /// xi = BB_n x.
    fn stretched_state(&self, point: &Point, x: &[Term]) -> Vec<Term> {
        let entry = |i: usize, j: usize| Term {
            value: self.mul(&point.bell[i][j], &x[j].value),
            size: self.mul(&point.bell[i][j], &x[j].size).abs(),
        };
        let zero = || Term { value: self.integer(0), size: self.integer(0) };
        let row = |i: usize| {
            (0..=i).map(|j| entry(i, j)).fold(zero(), |sum, term| Term {
                value: self.add(&sum.value, &term.value),
                size: self.add(&sum.size, &term.size),
            })
        };
        (0..x.len()).map(row).collect()
    }
}

/// pi0 = -(k_1 xi_1 + ... + k_n xi_n).
fn linear(n: usize) -> Expression {
    let term = |i| Expression::from(Parameter::Gain(i)).mul(Variable::Xi(i).into());
    (1..=n).map(term).reduce(Expression::add).unwrap_or(Expression::integer(0)).neg()
}
