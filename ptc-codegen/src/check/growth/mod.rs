//! Does the state vanish, and does u stay bounded, at the deadline?
//!
//! *Claim.* Let p be the characteristic polynomial of k_1..k_n and rho > 0 the decay rate of mu'. For
//! generic initial states
//! - x -> 0 iff all roots of p lie left of -(n-1) rho;
//! - u stays bounded iff, without the simple roots at -m rho for integers 0 <= m < n where these are
//!   harmless (below), none lies right of -n rho and those on that line are simple;
//! - u -> 0 iff, without the simple ones that add nothing, all lie left of -n rho.
//!
//! *Proof.* Time-to-go T falls like e^(-rho t) in stretched time t, so a mode t^q e^(lambda t) of xi_1
//! = x_1 is T^p (ln T)^q to leading order, p = -lambda/rho, and x_(i+1) is its i-th derivative in time,
//! p(p-1)...(p-i+1) T^(p-i) (ln T)^q to leading order, up to constants; u = x_n' is the one for i = n.
//! The product vanishes only for integer p = m < i. Where it does not, the derivative tends to 0 for
//! Re p > i, grows for Re p < i, and for Re p = i stays bounded without tending to 0 iff q = 0. Where
//! it does and q > 0, the next term T^(m-i) (ln T)^(q-1) grows. Where it does and q = 0, the mode is
//! simple and all depends on what follows the leading term, by [`Modes`]:
//! - `Polynomial` (exp): the mode is T^m, whose later derivatives are 0;
//! - `Analytic` (tanh): it is E^m with E = T/(2 tau - T), whose later derivatives are finite at T = 0;
//!   for m >= 1 they are not 0, as E is a series in T with positive coefficients;
//! - `Quadratic` (soft): the mode is E^m with E = w (1 + c (1 - w)), w = T/tau: a polynomial in T of
//!   degree at most 2m, whose later derivatives are finite, and 0 from the one of order 2m + 1 on;
//! - `Other` (sums of exponentials): T^m is followed by other, real powers of T. Undecided
//!   except for m = 0, where x_1 is constant for every mapping.
//!
//! In each case x_(m+1) -> a constant other than 0, so x -> 0 needs Re p > n-1 without exception. The
//! modes are independent, so for generic initial states none makes up for another. For rho = 0, T
//! falls more slowly than any exponential: every mode decides by the sign of Re lambda alone (on the
//! imaginary axis powers of 1/T grow), except that lambda = 0, if simple, still is a constant x_1.

mod report;
#[cfg(test)]
mod tests;

pub use self::report::{open, too_fast, without_rate};

use num_traits::{Signed, ToPrimitive, Zero};

use crate::algebra::polynomial::Polynomial;
use crate::algebra::stability::{is_bounded, is_hurwitz};
use crate::algebra::{BigInt, BigRational};
use crate::linear::{Complex, roots};

/// Name of the check.
pub(crate) const NAME: &str = "growth";

/// Mode of a simple pole at -m rho as a function of time-to-go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Modes {
    /// T^m, as for `exp`, where rho = a.
    Polynomial,
    /// A power series in T that begins with T^m, as for `tanh`, where rho = 2a.
    Analytic,
    /// A polynomial in T of degree at most 2m that begins with T^m, as for `soft`, where rho = a.
    Quadratic,
    /// Anything else, as for `exp_sum`, where rho = min a_i.
    Other,
    /// Unknown, as T e^(rho t) is not known to tend to a constant other than 0, as it does in all
    /// families with rho > 0: T = e^(-t)/(1+t) turns a mode at -rho into T ln T. Then what a pole on
    /// a line does is open.
    Open,
}

/// Behaviour of gains at the deadline.
#[derive(Clone, Debug, PartialEq)]
pub struct Growth {
    /// Order n.
    pub n: usize,
    /// Decay rate rho of mu'.
    pub rho: f64,
    /// rho as an expression, where its value is rounded.
    pub spelling: Option<String>,
    /// Origin of rho, in words.
    pub rate: &'static str,
    /// Modes of simple poles at -m rho.
    pub modes: Modes,
    /// True if x -> 0.
    pub x_to_zero: bool,
    /// True if u stays bounded; `None` if undecided.
    pub u_bounded: Option<bool>,
    /// True if u -> 0; `None` if undecided.
    pub u_to_zero: Option<bool>,
    /// The m < n for which a pole lies at -m rho and is simple.
    pub excepted: Vec<usize>,
    /// The poles as numbers, rightmost first; empty where they are not found.
    pub poles: Vec<Complex>,
    /// The largest decay rate, to three digits from below, at which x -> 0 and u -> 0 with these
    /// gains; none if there is none.
    pub largest_rho: Option<f64>,
}

/// Decides, exactly, what gains k_1..k_n do for a mapping with decay rate `rho` >= 0 of mu'.
pub fn growth(gains: &[BigRational], rho: &BigRational, modes: Modes) -> Growth {
    let n = gains.len();
    let p = Polynomial::characteristic(gains);
    let line = |m: usize| -(rho * BigInt::from(m));
    let hurwitz_left_of = |p: &Polynomial, m| is_hurwitz(&p.shifted(&line(m)));

    let (mut rest, mut excepted) = (p.clone(), Vec::new());
    // For rho = 0 all -m rho are one pole, which counts as m = 0.
    let candidates = if rho.is_zero() || modes == Modes::Open { n.min(1) } else { n };
    for m in 0..candidates {
        let (multiplicity, without) = rest.without(&line(m));
        if multiplicity == 1 {
            excepted.push(m);
            rest = without;
        }
    }
    let rest_to_zero = hurwitz_left_of(&rest, n);
    let bounded = |p: &Polynomial| is_bounded(&p.shifted(&line(n)));
    let rest_bounded = rest_to_zero || (rho.is_positive() && bounded(&rest));
    let open = modes == Modes::Open && !rest_to_zero && {
        let (_, off_the_line) = rest.without(&line(n));
        hurwitz_left_of(&off_the_line, n) || bounded(&off_the_line)
    };
    let only_constant = excepted.iter().all(|m| *m == 0);
    let excepted_bounded = (only_constant || modes != Modes::Other).then_some(true);
    let excepted_to_zero = match modes {
        Modes::Polynomial => Some(true),
        Modes::Analytic => Some(only_constant),
        Modes::Quadratic => excepted.iter().all(|m| 2 * m < n).then_some(true),
        Modes::Other | Modes::Open => only_constant.then_some(true),
    };
    let open_or = |decided: Option<bool>| if open { None } else { decided };
    Growth {
        n,
        rho: rho.to_f64().unwrap_or(f64::NAN),
        spelling: None,
        rate: match modes {
            Modes::Polynomial | Modes::Quadratic => "a",
            Modes::Analytic => "2 a",
            Modes::Other | Modes::Open => "a least rate",
        },
        modes,
        x_to_zero: hurwitz_left_of(&p, n.saturating_sub(1)),
        u_bounded: open_or(if rest_bounded { excepted_bounded } else { Some(false) }),
        u_to_zero: open_or(if rest_to_zero { excepted_to_zero } else { Some(false) }),
        excepted,
        poles: roots(&p).unwrap_or_default(),
        largest_rho: largest_rho(gains, &p),
    }
}

/// Decides the same for a rate of which only bounds are known, such as a rounded ln 100. `None` where
/// they leave open whether x -> 0; what they leave open of u is `None` in the result.
///
/// All poles left of a line are left of every line further right, so that x and u go to 0 for all
/// rates up to one for which they do. What fails at both bounds fails between them, except for a simple
/// pole at -m rho: that one keeps u from growing, so the bounds decide u where p has no such root.
pub fn growth_between(
    gains: &[BigRational],
    [low, high]: [&BigRational; 2],
    modes: Modes,
) -> Option<Growth> {
    let (least, most) = (growth(gains, low, modes), growth(gains, high, modes));
    if most.x_to_zero && most.u_bounded == Some(true) {
        return Some(most);
    }
    if least.x_to_zero != most.x_to_zero {
        return None;
    }
    let p = Polynomial::characteristic(gains);
    let near = (1..gains.len())
        .map(BigInt::from)
        .any(|m| p.may_vanish_between(&-(high * &m), &-(low * &m)));
    let common = |a: Option<bool>, b: Option<bool>| if a == b && !near { a } else { None };
    Some(Growth {
        u_bounded: common(least.u_bounded, most.u_bounded),
        u_to_zero: common(least.u_to_zero, most.u_to_zero),
        excepted: Vec::new(),
        ..most
    })
}

/// Bisects, with exact decisions, for the largest rho with all poles left of -n rho.
fn largest_rho(gains: &[BigRational], p: &Polynomial) -> Option<f64> {
    if gains.is_empty() || !is_hurwitz(p) {
        return None;
    }
    let n = BigInt::from(gains.len());
    // The rightmost pole is not left of their mean, -k_n/n.
    let mut high = gains.last()? / (&n * &n);
    let mut low = BigRational::zero();
    while low.is_zero() || &high - &low > &low / BigInt::from(4096) {
        let middle = (&low + &high) / BigInt::from(2);
        if is_hurwitz(&p.shifted(&-(&middle * &n))) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let low = low.to_f64()?;
    let unit = 10f64.powf(low.log10().floor() - 2.0);
    Some((low / unit).floor() * unit)
}
