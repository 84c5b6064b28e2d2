//! The check `growth` of a clock in samples: where the emitted loop ends.
//!
//! The gains of its last m samples are those of deadbeat, E^m y = 0 on the flat output: x = 0 at sample N from any
//! state, whatever the poles are, and u is a sum of the states with bounded gains. With the gains held at M samples to
//! go, counted with the shift of the law, the loop is D^m y = sum_j row_j D^(j-1) y/((M-j+1)..(M-m+1)) from there on,
//! D = E - 1: x ends near 0, and stays there if every root of D lies within 1 of -1. Poles decide what u does in the
//! limit of short periods, and no more.

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::growth::check_growth;
use super::known::fixed_gains;
use crate::algebra::BigRational;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::stability::is_hurwitz;
use crate::check::growth::NAME;
use crate::check::{Outcome, Verdict};
use crate::diagnostic::digits;
use crate::linear::{Matrix, Schedule, roots};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Clock, Reference, Sampled, Spec};
use crate::samples::{Ending, held_samples, rows_of_numbers};
use crate::syntax::constant::text;

/// Judges the emitted loop of `spec` at sample N, for a design whose eps is set.
pub(super) fn at_sample(spec: &Spec, own: &Sampled) -> Outcome {
    let continuous = Spec { n: spec.loop_order(), clock: Clock::Time, ..spec.clone() };
    let (limit, _) = check_growth(&continuous);
    let (verdict, summary, mut details) = match Held::of(spec) {
        None => {
            let off = off(spec, own).map(|off| format!(", but for {off}")).unwrap_or_default();
            let whatever = if spec.schedule().is_some() { "" } else { ", whatever the poles" };
            let rest = format!(
                "at rest at {} from any state{off}{whatever}, and |u| is bounded",
                last(spec)
            );
            (Verdict::Sound, rest, Vec::new())
        }
        Some(held) => held.judged(spec, off(spec, own)),
    };
    if limit.is_checked() {
        let advice = limit.fix.filter(|_| limit.verdict != Verdict::Sound);
        let advice = advice.map(|fix| format!("; for a u that is bounded there {fix}"));
        details.push(format!(
            "in continuous time, the limit of short periods, {}{}",
            limit.summary,
            advice.unwrap_or_default()
        ));
        details.extend(limit.details);
    }
    details.extend(late_estimates(spec, own));
    Outcome { name: NAME, verdict, summary, details, fix: None }
}

/// Says so if the exponents of an observer are too small for its gains alone: the error of its last estimate is the
/// (m-1)-th difference of the T^(p), which does not fall with p <= m - 1.
fn late_estimates(spec: &Spec, own: &Sampled) -> Option<String> {
    let round = own.observer.as_ref()?.round.as_ref()?;
    let a = spec.fixed.get(&Parameter::A)?.number()?;
    let mut poles = round.poles.iter();
    let all = [round.poles.len()];
    let blocks = if round.blocks.is_empty() { &all[..] } else { &round.blocks };
    let late = blocks.iter().find_map(|size| {
        let least = -a * BigRational::from_integer((*size).saturating_sub(1).into());
        let slow = poles.by_ref().take(*size).any(|(real, _)| *real >= least);
        slow.then_some(least)
    })?;
    let late = text(&late);
    Some(format!(
        "a pole of the observer is not left of {late}: an estimate keeps its error until deadbeat corrects it, which held gains never do; take poles left of {late}"
    ))
}

/// Sample N by its number, where that is known.
fn last(spec: &Spec) -> String {
    let number = |p: Parameter| spec.fixed.get(&p).and_then(Fixed::number);
    let count = number(Parameter::Tau).zip(number(Parameter::SampleTime));
    count.map_or_else(
        || "sample N".to_owned(),
        |(tau, h)| format!("sample {}", (tau / h).round().to_integer()),
    )
}

/// Names the error that the theorem leaves at sample N; `None` if it is 0.
fn off(spec: &Spec, own: &Sampled) -> Option<&'static str> {
    let is_held = |eps: &Fixed| eps.number().is_some_and(Signed::is_positive);
    match own.observer.as_ref().map(|observer| &observer.round) {
        Some(None) => return Some("what the stationary observer leaves of its error"),
        Some(Some(round)) if round.eps.as_ref().is_some_and(is_held) => {
            return Some("what the held observer leaves of its error");
        }
        _ => {}
    }
    let moves = spec.reference.as_ref().is_some_and(Reference::moves);
    match (spec.model_in_samples().is_some() && own.exact.is_none(), moves) {
        (true, true) => Some("what f + g u and r do between samples"),
        (true, false) => Some("what f + g u does between samples"),
        (false, true) => Some("what r does between samples"),
        (false, false) => own
            .disturbance
            .as_ref()
            .filter(|own| own.moves())
            .map(|_| "what d does between samples"),
    }
}

/// The loop with its gains held.
struct Held {
    /// Samples to go at which they are.
    left: BigRational,
    /// The characteristic polynomial of D; `None` if the gains are left to run time.
    loop_of: Option<Polynomial>,
}

impl Held {
    /// `None` if the loop ends in deadbeat.
    fn of(spec: &Spec) -> Option<Self> {
        let left = held_samples(spec).filter(BigRational::is_positive)?;
        let (ending, order) = (Ending::of(spec)?, spec.loop_order());
        if !ending.is_held(order, &left) {
            return None;
        }
        if let Some(schedule) = spec.schedule() {
            let loop_of = held_by(spec, schedule, &left);
            return Some(Self { left, loop_of });
        }
        let chain = Spec { n: order, ..spec.clone() };
        let rate = spec.fixed.get(&Parameter::A).and_then(Fixed::number);
        let own = fixed_gains(&chain).zip(rate).map(|(gains, a)| rows_of_numbers(&gains, a));
        let loop_of = own.map(|own| {
            let (rows, now) = ending.at(own, &left);
            held(&rows, &now)
        });
        Some(Self { left, loop_of })
    }

    fn judged(&self, spec: &Spec, off: Option<&str>) -> (Verdict, String, Vec<String>) {
        let left = digits(self.left.to_f64().unwrap_or(f64::NAN));
        let off = off.map(|off| format!("; so does {off}")).unwrap_or_default();
        let near = format!(
            "near rest at {}, not at rest: the gains are held from {left} samples to go, and |u| is bounded{off}",
            last(spec)
        );
        let Some(loop_of) = &self.loop_of else { return (Verdict::Sound, near, Vec::new()) };
        let size = roots(loop_of).map(|roots| {
            let sizes = roots.iter().map(|root| (1.0 + root.re).hypot(root.im));
            digits(sizes.fold(0.0, f64::max))
        });
        let size = size.map(|size| format!(" (largest eigenvalue {size})")).unwrap_or_default();
        match is_within_one(loop_of) {
            true => {
                let stays = format!("with the held gains the loop is stable{size}: x stays near 0");
                (Verdict::Sound, near, vec![stays])
            }
            false => (
                Verdict::Undecided,
                format!(
                    "the loop with its gains held from {left} samples to go is not stable{size}: x does not stay near 0 after {}, and `loop` decides how near it is there",
                    last(spec)
                ),
                vec![format!(
                    "without a hold, eps = 0, it is at rest at {} from any state",
                    last(spec)
                )],
            ),
        }
    }
}

/// The characteristic polynomial of D = E - 1 in the loop of a table of gains that are held at `left` samples to go.
fn held_by(spec: &Spec, schedule: &Schedule, left: &BigRational) -> Option<Polynomial> {
    let h = spec.fixed.get(&Parameter::SampleTime).and_then(Fixed::number);
    let pair = spec.sampled()?.planned(spec.n, h)?.pair;
    let gains = schedule.at(left.to_integer().to_u32()?);
    let step = pair.step();
    let entry = |i: usize, j: usize| step.at(i, j) - &pair.gamma[i] * &gains[j];
    let loop_of = Matrix::new(pair.order(), pair.order(), entry);
    Some(Polynomial::new(loop_of.characteristic()))
}

/// The characteristic polynomial of D = E - 1 in a loop of these rows, held where their formula counts `left` samples to
/// go.
fn held(rows: &[BigRational], left: &BigRational) -> Polynomial {
    let mut coefficients = vec![BigRational::one()];
    let mut below = BigRational::one();
    for (j, row) in rows.iter().enumerate().rev() {
        below *= left - BigRational::from_integer(j.into());
        coefficients.insert(0, -row / &below);
    }
    Polynomial::new(coefficients)
}

/// Returns true if every root lies within 1 of -1: with D = 2 w/(1 - w), where w has a negative real part.
fn is_within_one(p: &Polynomial) -> bool {
    let degree = p.degree().unwrap_or(0);
    let [up, down] = [[0, 2], [1, -1]].map(|line| {
        Polynomial::new(line.iter().map(|c| BigRational::from_integer((*c).into())).collect())
    });
    let mut sum = vec![BigRational::zero(); degree + 1];
    for (i, coefficient) in p.coefficients().iter().enumerate() {
        let mut term = Polynomial::new(vec![coefficient.clone()]);
        for k in 0..degree {
            term = term.times(if k < i { &up } else { &down });
        }
        sum.iter_mut().zip(term.coefficients()).for_each(|(sum, own)| *sum += own);
    }
    let turned = Polynomial::new(sum);
    // A root at D = -2 has gone to infinity.
    turned.degree() == Some(degree) && is_hurwitz(&turned)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(values: &[(i64, i64)]) -> Vec<BigRational> {
        values.iter().map(|(n, d)| BigRational::new((*n).into(), (*d).into())).collect()
    }

    /// Sizes of the eigenvalues of the sampled loop, from the sampled chain and the law of the theorem.
    #[test]
    fn held_loops_of_low_order_have_their_closed_forms() {
        let whole = |value: i64| BigRational::from_integer(value.into());
        // n = 1, pole -p: u = -p z/T, E = 1 - p/M.
        for (p, m, stable) in [(3, 1, false), (3, 2, true), (1, 1, true), (4, 2, false)] {
            let found = held(&rows_of_numbers(&[whole(p)], &whole(1)), &whole(m));
            let wanted = numbers(&[(p, m), (1, 1)]);
            assert_eq!(found.coefficients(), wanted);
            assert_eq!(is_within_one(&found), stable, "{p} {m}");
        }
        // n = 2, poles -p, -q with a rate a: D^2 y = -(p + q - 1) D y/(M - 1) - p q y/(M (M - 1)), p and q over a.
        for (p, q, a, m) in [(4, 5, 1, 10), (4, 6, 2, 3), (1, 9, 1, 40)] {
            let rows = rows_of_numbers(&[whole(p * q), whole(p + q)], &whole(a));
            let found = held(&rows, &whole(m));
            let (p, q) = (p / a, q / a);
            assert_eq!(
                found.coefficients(),
                numbers(&[(p * q, m * (m - 1)), (p + q - 1, m - 1), (1, 1)])
            );
        }
    }
}
