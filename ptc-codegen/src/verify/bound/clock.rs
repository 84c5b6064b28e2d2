//! Stretched time over a cell of the time-to-go, and the derivatives of kappa there.

use std::collections::BTreeMap;

use super::Campaign;
use super::flow::Rows;
use super::root::root;
use super::series::{Arithmetic, Series, power, product};
use crate::algebra::{BigInt, BigRational, integer};
use crate::expansion::bell::factorials;
use crate::expression::enclosure::{Interval, Range};
use crate::expression::evaluator::{Evaluator, Names};
use crate::expression::normal::normal;
use crate::expression::{Expression, Node, Variable};
use crate::mapping::{Form, Kappa, TimeMapping};
use crate::parameter::Parameter;
use crate::verify::linear::values;

/// A mapping in units of tau: its T is the T/tau of the run.
pub(super) struct Clock {
    form: Form,
    names: Names,
    evaluator: Evaluator,
    /// Derivatives that are asked for.
    order: usize,
    /// Units of stretched time in one second of it.
    rate: Interval,
    factorials: Vec<Range>,
    /// Stretched time at the T/tau that were asked for.
    known: BTreeMap<BigRational, Interval>,
}

/// Returns true if a run of a campaign is that of any other tau in units of tau, or has one tau.
pub(in crate::verify) fn scales(campaign: &Campaign) -> bool {
    Clock::new(campaign, 1, &integer(1)).is_some()
}

impl Clock {
    /// The mapping of a campaign; `None` where it does not scale with a tau that is not known.
    pub(super) fn new(campaign: &Campaign, order: usize, rate: &BigRational) -> Option<Self> {
        let values = values(campaign);
        let (low, high) = campaign.tau;
        let tau = Expression::from(BigRational::from_float(low)?);
        let with = |form: &Expression, tau: &Expression| {
            let share = Expression::from(Variable::TimeToGo).mul(tau.clone());
            normal(&form.substitute(&|e| match e.node() {
                Node::Variable(Variable::TimeToGo) => Some(share.clone()),
                Node::Parameter(Parameter::Tau) => Some(tau.clone()),
                Node::Parameter(name) => values.get(name).cloned().map(Expression::from),
                _ => None,
            }))
        };
        let unknown = Expression::from(Parameter::Tau);
        let scales = |form: &Expression| !form.parameters().contains(&Parameter::Tau);
        let of_family = matches!(campaign.spec.time_mapping, TimeMapping::Family { .. });
        // mu of a family is tau times a function of stretched time alone.
        let one = Expression::integer(1);
        let in_units = |form: &Expression, of_mu: bool| {
            let share = if of_mu { form.clone().div(unknown.clone()) } else { form.clone() };
            if of_family || scales(&with(&share, &unknown)) {
                Some(with(form, &one))
            } else if low == high && of_mu {
                Some(with(&share, &tau))
            } else if low == high {
                Some(with(form, &tau))
            } else {
                None
            }
        };
        let form = match campaign.spec.time_mapping.form() {
            Form::Kappa(kappa) => Form::Kappa(Kappa::new(&in_units(&kappa.form, false)?)),
            Form::Complement(form) => Form::Complement(in_units(&form, true)?),
        };
        let known = BTreeMap::from([(integer(1), Interval::integer(0))]);
        let (names, evaluator) = (Names::new(), Evaluator::new());
        let rate = Interval::exact(rate);
        let exact = |value: &BigInt| Range::from(&Interval::scaled(value, 0));
        let factorials = factorials(order).iter().map(exact).collect();
        Some(Self { form, names, evaluator, order, rate, factorials, known })
    }

    fn value(
        &mut self,
        expression: &Expression,
        name: Variable,
        at: &Interval,
    ) -> Option<Interval> {
        self.names.insert(name.into(), at.clone());
        self.evaluator.sound(expression, &self.names)
    }

    /// Stretched time in its units at one T/tau.
    pub(super) fn stretched(&mut self, share: &BigRational) -> Option<Interval> {
        if let Some(known) = self.known.get(share) {
            return Some(known.clone());
        }
        let at = Interval::exact(share);
        let seconds = match self.form.clone() {
            Form::Kappa(kappa) => self.value(&kappa.form, Variable::TimeToGo, &at)?,
            Form::Complement(form) => {
                root(|t: &Interval| self.value(&form, Variable::SinceStart, t), &at)?
            }
        };
        let stretched = seconds.times(&self.rate);
        self.known.insert(share.clone(), stretched.clone());
        Some(stretched)
    }

    /// kappa^(k) w^k/k! for k = 1..order, w = T/tau over all of `share` and kappa in units of
    /// stretched time, of which all is in `stretched`.
    pub(super) fn derivatives(
        &mut self,
        share: &Interval,
        stretched: &Interval,
    ) -> Option<Vec<Range>> {
        let length = self.order + 1;
        let unit = |first: f64, second: f64| -> Vec<Range> {
            let of = |k: usize| {
                Range::from(match k {
                    0 => first,
                    1 => second,
                    _ => 0.0,
                })
            };
            (0..length).map(of).collect()
        };
        let form = self.form.clone();
        let terms: Vec<Range> = match form {
            Form::Kappa(kappa) => {
                let series = Series { scale: Range::from(share), terms: unit(1.0, -1.0) };
                let left = Series { scale: Range::from(1.0), terms: unit(1.0, -1.0) };
                let (names, evaluator) = (&self.names, &mut self.evaluator);
                let variable = Variable::TimeToGo;
                let rate = Arithmetic { variable, series, names, evaluator }.series(&kappa.rate)?;
                // w kappa' = 1/((1 - z) rate), with T (1 - z) in place of T.
                let slope = rate.times(&left).reciprocal().plain();
                let term = |(k, slope): (u32, &Range)| *slope / Range::from(f64::from(k));
                (1..).zip(&slope[..self.order]).map(term).collect()
            }
            Form::Complement(form) => {
                let fallen = self.fallen(&form, stretched)?;
                reversed(&fallen, &Range::from(share))
            }
        };
        let rate = Range::from(&self.rate);
        Some(terms.iter().map(|term| *term * rate).collect())
    }

    /// Coefficients of mu around a time, from that of the order 0 on, which is another.
    fn fallen(&mut self, form: &Expression, stretched: &Interval) -> Option<Vec<Range>> {
        let mut terms = vec![Range::from(0.0); self.order + 1];
        terms[0] = Range::from(&stretched.over(&self.rate));
        terms[1] = Range::from(1.0);
        let series = Series { scale: Range::from(1.0), terms };
        let (names, evaluator) = (&self.names, &mut self.evaluator);
        let variable = Variable::SinceStart;
        Some(Arithmetic { variable, series, names, evaluator }.series(form)?.neg().plain())
    }

    /// Returns true if the mapping is given by mu.
    pub(super) fn is_of_mu(&self) -> bool {
        matches!(self.form, Form::Complement(_))
    }

    /// mu'^n, and its Taylor coefficients by stretched time as parts of it, of the orders 0 to `order`:
    /// over all of `share` or, where mu is given, of `stretched`.
    pub(super) fn weight(
        &mut self,
        n: usize,
        order: usize,
        share: &Interval,
        stretched: &Interval,
    ) -> Option<(Range, Vec<Range>)> {
        let rate = Range::from(&self.rate);
        let one = Range::from(1.0);
        let (mut terms, scale) = match self.form.clone() {
            Form::Kappa(_) => {
                let mut kappa = vec![Range::from(0.0)];
                kappa.extend(self.derivatives(share, stretched)?);
                kappa.truncate(order + 2);
                (reversed(&kappa, &one), Range::from(share))
            }
            Form::Complement(form) => {
                let mut mu = self.fallen(&form, stretched)?.split_off(1);
                let mut unit = one;
                for term in &mut mu {
                    unit = unit / rate;
                    *term = *term * unit;
                }
                (mu, one)
            }
        };
        terms.truncate(order + 1);
        for (k, term) in (1_u32..).zip(&mut terms) {
            *term = *term * Range::from(f64::from(k));
        }
        let first = terms[0];
        if !first.is_positive() || !terms.iter().all(|term| term.is_bounded()) {
            return None;
        }
        terms.iter_mut().for_each(|term| *term = *term / first);
        terms[0] = one;
        let leading = (first * scale).whole_power(i32::try_from(n).ok()?);
        let exponent = Range::from(f64::from(u32::try_from(n).ok()?));
        Some((leading, power(&terms, exponent)))
    }

    /// B_{i,j}(kappa', kappa'', ...) w^i for 0 <= j <= i <= order, which BB\[mu\] is made of; none
    /// where kappa is not seen to grow.
    pub(super) fn bell(&mut self, share: &Interval, stretched: &Interval) -> Option<Rows> {
        let derivatives = self.derivatives(share, stretched)?;
        let mut series = vec![Range::from(0.0)];
        series.extend(derivatives);
        if !series[1].is_positive() || !series.iter().all(|entry| entry.is_bounded()) {
            return None;
        }
        let length = series.len();
        let mut power = vec![Range::from(0.0); length];
        power[0] = Range::from(1.0);
        let mut table = vec![Vec::new(); length];
        for j in 0..length {
            for (i, row) in table.iter_mut().enumerate().skip(j) {
                row.push(power[i] * self.factorials[i] / self.factorials[j]);
            }
            let term = |k: usize| (j..k).map(|i| power[i] * series[k - i]).sum();
            power = (0..length).map(term).collect();
        }
        Some(table)
    }
}

/// The series of q in z for which sum_l m_l q^l = w z, l >= 1, from the order 1 on.
fn reversed(m: &[Range], w: &Range) -> Vec<Range> {
    let zero = Range::from(0.0);
    let mut q = vec![zero; m.len()];
    q[1] = *w / m[1];
    for k in 2..m.len() {
        let (mut power, mut sum) = (q.clone(), zero);
        for m in &m[2..=k] {
            power = product(&power, &q);
            sum = sum + *m * power[k];
        }
        q[k] = -(sum / m[1]);
    }
    q.split_off(1)
}
