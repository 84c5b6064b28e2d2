//! Objectives that are proved: no scenario is needed where the loop is linear in stretched time.
//!
//! With the family `exp`, f = 0, a constant g and distinct real poles lambda_i, let sigma =
//! -ln(T/tau) = a t_kappa and z_j = T^(j-1) x_j. Theorem 1 makes the loop one of constant coefficients
//! in sigma, with the exponents lambda_i/a, and dz_j/dsigma = z_{j+1} - (j-1) z_j; so z is a sum of
//! modes V_i (T/tau)^p_i with p_i = -lambda_i/a and V_{j+1,i} = (j-1-p_i) V_{j,i}, from which
//!
//! x_j = sum_m tau^(m-j) x_m(t0) sum_i V_ji W_im (T/tau)^(p_i-j+1), W = V^-1, and
//! g u = sum_m tau^(m-1-n) x_m(t0) sum_i (n-1-p_i) V_ni W_im (T/tau)^(p_i-n).
//!
//! V and W are exact. What an objective leaves of its bound is enclosed by intervals over cells of T
//! and tau that cover all of them, which are halved until it is positive on each.

use std::collections::BTreeMap;

use num_traits::{One, ToPrimitive, Zero};

use super::{Campaign, Kind, Objective};
use crate::algebra::{BigRational, integer};
use crate::check::membership::enclosure::{Evaluator, Names};
use crate::expression::interval::Interval;
use crate::expression::normal::normal;
use crate::expression::{Expression, Function, Variable};
use crate::mapping::Family;
use crate::spec::{Feedback, Fixed, Parameter};

/// Cells for one objective, after which it is left to sampling.
const MOST: usize = 20_000;

/// For each objective whether it is proved, for the law in exact arithmetic and every state of the
/// box, every tau, and T/tau from 1 to the end of a run.
pub fn proved(campaign: &Campaign) -> Vec<bool> {
    let modes = Modes::of(campaign);
    let one = |objective: &Objective| {
        let margin = modes.as_ref().and_then(|modes| modes.margin(campaign, objective));
        margin.is_some_and(|(margin, at_end)| is_positive(campaign, &margin, at_end))
    };
    campaign.objectives.iter().map(one).collect()
}

/// The modes of a closed loop.
struct Modes {
    /// -lambda_i/a.
    powers: Vec<BigRational>,
    /// V, by row.
    vectors: Vec<Vec<BigRational>>,
    /// V^-1, by row.
    inverse: Vec<Vec<BigRational>>,
    gain: BigRational,
}

impl Modes {
    /// Those of a campaign; none where its loop is not of the kind that is proved.
    fn of(campaign: &Campaign) -> Option<Self> {
        let spec = &campaign.spec;
        let gain = match &spec.input_gain {
            None => integer(1),
            Some(gain) => gain.number()?.clone(),
        };
        let own = |g: &Expression| spec.input_gain.as_ref() == Some(g);
        let plain = spec.family() == Some(Family::Exp)
            && spec.feedback == Feedback::Linear
            && normal(&campaign.plant.f) == Expression::integer(0)
            && campaign.plant.g.as_ref().is_none_or(own)
            && spec.fixed.get(&Parameter::UMax).is_none_or(|limit| limit.number().is_none());
        let real = spec.poles.len() == spec.n && spec.poles.iter().all(|(_, im)| im.is_zero());
        if !plain || !real {
            return None;
        }
        let rate = spec.fixed.get(&Parameter::A).and_then(Fixed::number)?;
        let powers: Vec<_> = spec.poles.iter().map(|(re, _)| -(re / rate)).collect();
        let mut vectors = vec![vec![BigRational::one(); spec.n]];
        for j in 1..spec.n {
            let before = integer(i64::try_from(j - 1).ok()?);
            let last = &vectors[j - 1];
            vectors.push(last.iter().zip(&powers).map(|(v, p)| v * (&before - p)).collect());
        }
        // Poles that coincide have no inverse.
        let inverse = inverse(&vectors)?;
        Some(Self { powers, vectors, inverse, gain })
    }

    /// What an objective leaves of its bound, and whether only the end of a run counts.
    fn margin(&self, campaign: &Campaign, objective: &Objective) -> Option<(Expression, bool)> {
        let n = self.powers.len();
        let number = |value: f64| BigRational::from_float(value).map(Expression::Number);
        // |x_m(t0)| over the box.
        let most = |m: usize| {
            let (low, high) = campaign.x0[m];
            number(low.abs().max(high.abs()))
        };
        let sizes = (0..n).map(most).collect::<Option<Vec<_>>>()?;
        let sum = |terms: Vec<Expression>| {
            terms.into_iter().fold(Expression::integer(0), Expression::add)
        };
        let bounded = |row: Vec<Expression>| {
            let size = |(entry, size): (Expression, &Expression)| {
                Expression::call(Function::Abs, entry).mul(size.clone())
            };
            sum(row.into_iter().zip(&sizes).map(size).collect())
        };
        // A power of what may be 0 counts as a division by it.
        let square = |e: Expression| {
            let size = Expression::call(Function::Abs, e);
            size.clone().mul(size)
        };
        let row = |j: usize| (0..n).map(|m| self.state(j, m)).collect::<Vec<_>>();
        match &objective.kind {
            Kind::State { sigma, zeta } => {
                // The Frobenius norm is no less than the Euclidean one.
                let norm = sum((0..n).flat_map(row).map(square).collect());
                let bound = square(number(*sigma)?).mul(square(zeta.clone()));
                // A zeta below 0 bounds nothing, whatever its square is.
                let least = Expression::Min(Box::new(bound.sub(norm)), Box::new(zeta.clone()));
                Some((least, false))
            }
            Kind::Input { upsilon } => {
                let row = (0..n).map(|m| self.control(m)).collect();
                Some((upsilon.clone().sub(bounded(row)), false))
            }
            Kind::Attractive { error } => {
                let size = sum((0..n).map(|j| square(bounded(row(j)))).collect());
                Some((square(number(*error)?).sub(size), true))
            }
            Kind::Within { .. } => None,
        }
    }

    /// dx_j/dx_m(t0), from 0.
    fn state(&self, j: usize, m: usize) -> Expression {
        let weight = |i: usize| &self.vectors[j][i] * &self.inverse[i][m];
        self.sum(weight, j, (m, j))
    }

    /// du/dx_m(t0), from 0.
    fn control(&self, m: usize) -> Expression {
        let n = self.powers.len();
        let last = integer(i64::try_from(n - 1).unwrap_or(i64::MAX));
        let weight = |i: usize| {
            (&last - &self.powers[i]) * &self.vectors[n - 1][i] * &self.inverse[i][m] / &self.gain
        };
        self.sum(weight, n, (m, n))
    }

    /// tau^(m-j) sum_i weight_i (T/tau)^(p_i - less).
    fn sum(
        &self,
        weight: impl Fn(usize) -> BigRational,
        less: usize,
        (m, j): (usize, usize),
    ) -> Expression {
        let whole = |count: usize| i64::try_from(count).unwrap_or(i64::MAX);
        let tau = Expression::from(Parameter::Tau);
        let share = Expression::from(Variable::TimeToGo).div(tau.clone());
        let term = |i: usize| {
            let exponent = Expression::Number(&self.powers[i] - integer(whole(less)));
            Expression::Number(weight(i)).mul(share.clone().power(exponent))
        };
        let sum = (0..self.powers.len()).map(term).fold(Expression::integer(0), Expression::add);
        tau.power(Expression::integer(whole(m) - whole(j))).mul(sum)
    }
}

/// The inverse of a square matrix, exactly; none of a singular one.
fn inverse(matrix: &[Vec<BigRational>]) -> Option<Vec<Vec<BigRational>>> {
    let n = matrix.len();
    let unit = |i: usize, j: usize| integer(i64::from(i == j));
    let mut rows: Vec<Vec<_>> = (0..n)
        .map(|i| matrix[i].iter().cloned().chain((0..n).map(|j| unit(i, j))).collect())
        .collect();
    for column in 0..n {
        let pivot = (column..n).find(|i| !rows[*i][column].is_zero())?;
        rows.swap(column, pivot);
        let scale = rows[column][column].recip();
        rows[column].iter_mut().for_each(|x| *x *= &scale);
        let own = rows[column].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != column) {
            let factor = row[column].clone();
            row.iter_mut().zip(&own).for_each(|(x, y)| *x -= &factor * y);
        }
    }
    Some(rows.into_iter().map(|row| row[n..].to_vec()).collect())
}

/// Whether `margin` is positive for every T/tau of a run, or at its end, and every tau.
fn is_positive(campaign: &Campaign, margin: &Expression, at_end: bool) -> bool {
    let exact = BigRational::from_float;
    let (Some(until), Some(low), Some(high)) =
        (exact(campaign.until), exact(campaign.tau.0), exact(campaign.tau.1))
    else {
        return false;
    };
    let fixed = campaign.spec.fixed.iter().chain(&campaign.plant.fixed);
    let mut names: Names = BTreeMap::from([(Parameter::StartTime.into(), Interval::integer(0))]);
    names.extend(fixed.filter_map(|(parameter, value)| {
        Some((Expression::from(*parameter), Interval::exact(value.number()?)))
    }));
    let start = names[&Expression::from(Parameter::StartTime)].clone();
    let last = if at_end { until.clone() } else { integer(1) };
    let mut cells = vec![([until, last], [low, high])];
    for _ in 0..MOST {
        let Some((share, tau)) = cells.pop() else { return true };
        let within = |[low, high]: &[BigRational; 2]| Interval::between(low, Some(high));
        let time_to_go = [&share[0] * &tau[0], &share[1] * &tau[1]];
        let one = integer(1);
        let elapsed = [(&one - &share[1]) * &tau[0], (&one - &share[0]) * &tau[1]];
        names.insert(Parameter::Tau.into(), within(&tau));
        names.insert(Variable::TimeToGo.into(), within(&time_to_go));
        names.insert(Variable::Elapsed.into(), within(&elapsed));
        names.insert(Variable::Time.into(), within(&elapsed).plus(&start));
        let value = Evaluator::new().value(margin, &names);
        let proved = value.is_some_and(|value| {
            value.interval.is_positive() && !value.is_undefined && !value.may_divide_by_zero
        });
        if proved {
            continue;
        }
        let width = |[low, high]: &[BigRational; 2]| (high / low).to_f64().unwrap_or(1.0);
        let halved = |[low, high]: &[BigRational; 2]| {
            let middle = (low + high) / integer(2);
            [[low.clone(), middle.clone()], [middle, high.clone()]]
        };
        if width(&share).max(width(&tau)) < 1.0 + 1e-6 {
            return false;
        }
        if width(&share) >= width(&tau) {
            cells.extend(halved(&share).map(|share| (share, tau.clone())));
        } else {
            cells.extend(halved(&tau).map(|tau| (share.clone(), tau)));
        }
    }
    cells.is_empty()
}
