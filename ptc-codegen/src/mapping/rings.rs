//! The families as differential rings, in time-to-go form.

use super::{Evaluated, Evaluation, Mapping, Reciprocal};
use crate::algebra::{Kind, Monomial, Poly, Symbol, integer};
use crate::family::Family;

impl Mapping {
    /// The differential ring of a family; `rates` is the number of terms of `exp_sum`.
    pub fn of(family: Family, rates: usize) -> Self {
        match family {
            Family::Exp => exp(),
            Family::Rational => rational(),
            Family::Power => power(),
            Family::Tan => tan(),
            Family::Tanh => tanh(),
            Family::Algebraic => algebraic(),
            Family::ExpSum => exp_sum(rates),
            Family::Soft => soft(),
        }
    }
}

pub(super) const fn plain(kind: Kind) -> Symbol {
    Symbol::plain(kind)
}

/// `coefficient * product of powers`.
pub(super) fn term(coefficient: i64, powers: &[(Kind, i32)]) -> Poly {
    let monomial = powers
        .iter()
        .fold(Monomial::one(), |m, (kind, e)| m.times(&Monomial::power(plain(*kind), *e)));
    Poly::term(integer(coefficient), monomial)
}

fn inverse_time_to_go() -> Reciprocal {
    Reciprocal {
        atom: plain(Kind::TimeToGo),
        power: 1,
        by: Poly::symbol(plain(Kind::InverseTimeToGo)),
        expansion: None,
    }
}

/// kappa' = 1/(a T), so D T = -a T.
fn exp() -> Mapping {
    let r1 = term(1, &[(Kind::A, 1), (Kind::TimeToGo, 1)]);
    Mapping {
        derivations: vec![(plain(Kind::TimeToGo), r1.scaled(&integer(-1)))],
        r1,
        reciprocals: vec![inverse_time_to_go()],
        rate: term(1, &[(Kind::A, 1)]),
        evaluation: Evaluation::over(term(1, &[(Kind::TimeToGo, 1)]), Kind::InverseTimeToGo),
        short: None,
    }
}

/// kappa' = tau/(a T^2), so D T = -(a/tau) T^2. Over T^2 the rows are polynomials in T, whose constant
/// terms are what is left at the deadline.
fn rational() -> Mapping {
    let r1 = term(1, &[(Kind::A, 1), (Kind::Tau, -1), (Kind::TimeToGo, 2)]);
    Mapping {
        derivations: vec![(plain(Kind::TimeToGo), r1.scaled(&integer(-1)))],
        r1,
        reciprocals: Vec::new(),
        rate: term(1, &[(Kind::A, 1), (Kind::Tau, -1)]),
        evaluation: Evaluation::over(term(1, &[(Kind::TimeToGo, 2)]), Kind::InverseSquare),
        short: None,
    }
}

/// kappa' = 1/(a T P) with P = (T/tau)^m, so D T = -a T P and D P = -a m P^2.
fn power() -> Mapping {
    let r1 = term(1, &[(Kind::A, 1), (Kind::TimeToGo, 1), (Kind::PowerRatio, 1)]);
    Mapping {
        derivations: vec![
            (plain(Kind::TimeToGo), r1.scaled(&integer(-1))),
            (
                plain(Kind::PowerRatio),
                term(-1, &[(Kind::A, 1), (Kind::M, 1), (Kind::PowerRatio, 2)]),
            ),
        ],
        r1,
        reciprocals: vec![
            inverse_time_to_go(),
            Reciprocal {
                atom: plain(Kind::PowerRatio),
                power: 1,
                by: Poly::symbol(plain(Kind::InversePowerRatio)),
                expansion: None,
            },
        ],
        rate: term(1, &[(Kind::A, 1)]),
        evaluation: Evaluation::over(term(1, &[(Kind::TimeToGo, 1)]), Kind::InverseTimeToGo),
        short: None,
    }
}

/// With y = a t = cot(pi T/(2 tau)) and V = 1/(1 + y^2): r_1 = (2 tau/pi) a V.
fn tan() -> Mapping {
    let y = plain(Kind::StretchedAngle);
    Mapping {
        r1: term(2, &[(Kind::A, 1), (Kind::Tau, 1), (Kind::Pi, -1), (Kind::Lorentz, 1)]),
        derivations: vec![
            (y, term(1, &[(Kind::A, 1)])),
            (
                plain(Kind::Lorentz),
                term(-2, &[(Kind::A, 1), (Kind::StretchedAngle, 1), (Kind::Lorentz, 2)]),
            ),
        ],
        reciprocals: vec![Reciprocal {
            atom: plain(Kind::Lorentz),
            power: 1,
            by: term(2, &[(Kind::Tau, 1), (Kind::Pi, -1), (Kind::Slope, 1)]),
            expansion: Some(one_plus_square()),
        }],
        rate: term(1, &[(Kind::A, 1)]),
        evaluation: Evaluation {
            base: None,
            evaluated: vec![Evaluated::As(
                y,
                term(2, &[(Kind::Tau, 1), (Kind::Pi, -1), (Kind::CotangentRate, 1)]),
            )],
        },
        short: None,
    }
}

/// With E = e^{-2 a t} and L = 1/(1 + E): T = 2 tau E L, r_1 = 2 a T L.
fn tanh() -> Mapping {
    let r1 = term(2, &[(Kind::A, 1), (Kind::TimeToGo, 1), (Kind::Logistic, 1)]);
    Mapping {
        derivations: vec![
            (plain(Kind::TimeToGo), r1.scaled(&integer(-1))),
            (plain(Kind::Decay), term(-2, &[(Kind::A, 1), (Kind::Decay, 1)])),
            (
                plain(Kind::Logistic),
                term(2, &[(Kind::A, 1), (Kind::Decay, 1), (Kind::Logistic, 2)]),
            ),
        ],
        r1,
        reciprocals: vec![
            inverse_time_to_go(),
            Reciprocal {
                atom: plain(Kind::Logistic),
                power: 1,
                by: Poly::symbol(plain(Kind::OnePlusDecay)),
                expansion: Some(Poly::one().plus(&Poly::symbol(plain(Kind::Decay)))),
            },
        ],
        rate: term(2, &[(Kind::A, 1)]),
        evaluation: Evaluation::over(term(1, &[(Kind::TimeToGo, 1)]), Kind::InverseTimeToGo),
        short: Some(Evaluation::of_tanh()),
    }
}

/// With y = a t and h = 1/sqrt(1 + y^2): r_1 = tau a h^3.
fn algebraic() -> Mapping {
    Mapping {
        r1: term(1, &[(Kind::A, 1), (Kind::Tau, 1), (Kind::Cosine, 3)]),
        derivations: vec![
            (plain(Kind::StretchedAngle), term(1, &[(Kind::A, 1)])),
            (
                plain(Kind::Cosine),
                term(-1, &[(Kind::A, 1), (Kind::StretchedAngle, 1), (Kind::Cosine, 3)]),
            ),
        ],
        reciprocals: vec![Reciprocal {
            atom: plain(Kind::Cosine),
            power: 2,
            by: Poly::symbol(plain(Kind::OnePlusSquare)),
            expansion: Some(one_plus_square()),
        }],
        rate: term(1, &[(Kind::A, 1)]),
        evaluation: Evaluation::over(term(1, &[(Kind::Cosine, 1)]), Kind::Secant),
        short: Some(Evaluation::of_algebraic()),
    }
}

/// 1 + y^2.
fn one_plus_square() -> Poly {
    Poly::one().plus(&Poly::symbol(plain(Kind::StretchedAngle)).pow(2))
}

/// With e_i = e^{-a_i t}: r_1 = (tau/N) sum a_i e_i, D e_i = -a_i e_i.
fn exp_sum(rates: usize) -> Mapping {
    let rate = |i| Poly::symbol(Symbol::indexed(Kind::Rate, i));
    let mode = |i| Symbol::indexed(Kind::Mode, i);
    let count = integer(i64::try_from(rates).unwrap_or(i64::MAX));
    let sum =
        (1..=rates).fold(Poly::zero(), |sum, i| sum.plus(&rate(i).times(&Poly::symbol(mode(i)))));
    let r1 = sum.times(&Poly::symbol(plain(Kind::Tau))).scaled(&count.recip());
    Mapping {
        r1,
        derivations: (1..=rates)
            .map(|i| (mode(i), rate(i).times(&Poly::symbol(mode(i))).scaled(&integer(-1))))
            .collect(),
        reciprocals: Vec::new(),
        rate: Poly::one(),
        evaluation: Evaluation::default(),
        short: None,
    }
}

/// With E = e^{-a t} = w (1 + c (1 - w)), w = T/tau and c = 1 - start, the slope S = dE/dw has
/// S^2 = (1 + c)^2 - 4 c E. So H = tau E/S and y = c E/S^2 are closed under D: r_1 = a H,
/// D H = -a H (1 + 2 y) and D y = -a y (1 + 4 y).
///
/// For 0 < start <= 1 the mapping is of class K: E is 1 at w = 1 and 0 at w = 0, and
/// S = 1 + c - 2 c w >= start > 0 between, so that kappa = -ln(E)/a is 0 at the start, has
/// kappa' = S/(a tau E) > 0 and derivatives of every order, and tends to infinity.
fn soft() -> Mapping {
    let of = |kind| Poly::symbol(plain(kind));
    let minus_a = of(Kind::A).scaled(&integer(-1));
    let rate = |weight| Poly::one().plus(&of(Kind::Bend).scaled(&integer(weight)));
    let derived = |kind, weight| (plain(kind), minus_a.times(&of(kind)).times(&rate(weight)));
    Mapping {
        r1: term(1, &[(Kind::A, 1), (Kind::Lag, 1)]),
        derivations: vec![derived(Kind::Lag, 2), derived(Kind::Bend, 4)],
        reciprocals: vec![Reciprocal {
            atom: plain(Kind::Lag),
            power: 1,
            by: of(Kind::InverseLag),
            expansion: None,
        }],
        rate: term(1, &[(Kind::A, 1)]),
        evaluation: Evaluation::over(of(Kind::Lag), Kind::InverseLag),
        short: None,
    }
}
