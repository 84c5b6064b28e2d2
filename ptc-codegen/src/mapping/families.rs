//! The families of mappings, in time-to-go form.

use super::{Mapping, Reciprocal};
use crate::algebra::{Kind, Monomial, Poly, Symbol, integer};

/// A family of class K/M mappings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Family {
    /// mu = tau (1 - e^{-a t}).
    Exp,
    /// mu = tau a t / (1 + a t).
    Rational,
    /// mu = tau (1 - (1 + a m t)^{-1/m}).
    Power,
    /// mu = (2 tau/pi) atan(a t).
    Tan,
    /// mu = tau tanh(a t).
    Tanh,
    /// mu = tau a t / sqrt(1 + (a t)^2).
    Algebraic,
    /// mu = tau mean_i (1 - e^{-a_i t}).
    ExpSum,
}

/// What a user is told about a family.
#[derive(Clone, Copy, Debug)]
pub struct FamilyInfo {
    /// The family.
    pub family: Family,
    /// Name, in the spec and in file names.
    pub name: &'static str,
    /// mu(t), t the stretched time since t0.
    pub mu: &'static str,
    /// kappa(Dt), in time-to-go form; w = T/tau.
    pub kappa: &'static str,
    /// kappa as an expression in the time-to-go `T`; empty where there is none.
    pub kappa_in_time_to_go: &'static str,
    /// r_k in closed form.
    pub r: &'static str,
    /// The atoms in which the expansions are polynomials.
    pub atoms: &'static str,
    /// Decay rate of mu'.
    pub decay_rate: &'static str,
    /// Keys of its own parameters; [`Parameter`](crate::spec::Parameter) tells the rest of them.
    pub parameters: &'static [&'static str],
}

/// The families, in the order in which they are listed.
pub static FAMILIES: [FamilyInfo; 7] = [
    FamilyInfo {
        family: Family::Exp,
        name: "exp",
        mu: "tau*(1 - exp(-a*t))",
        kappa: "-ln(T/tau)/a",
        kappa_in_time_to_go: "-ln(T/tau)/a",
        r: "(-1)^(k-1) a^k T",
        atoms: "T = time-to-go",
        decay_rate: "a",
        parameters: &["a"],
    },
    FamilyInfo {
        family: Family::Rational,
        name: "rational",
        mu: "tau*a*t/(1 + a*t)",
        kappa: "Dt/(a*T)",
        kappa_in_time_to_go: "(tau/T - 1)/a",
        r: "(-1)^(k-1) k! (a/tau)^k T^(k+1)",
        atoms: "T = time-to-go",
        decay_rate: "0",
        parameters: &["a"],
    },
    FamilyInfo {
        family: Family::Power,
        name: "power",
        mu: "tau*(1 - (1 + a*m*t)^(-1/m))",
        kappa: "((T/tau)^-m - 1)/(a*m)",
        kappa_in_time_to_go: "((T/tau)^(-m) - 1)/(a*m)",
        r: "(-1)^(k-1) prod_{i<k}(1 + i*m) a^k T P^k",
        atoms: "T = time-to-go, P = (T/tau)^m",
        decay_rate: "0",
        parameters: &["a", "m"],
    },
    FamilyInfo {
        family: Family::Tan,
        name: "tan",
        mu: "(2*tau/pi)*atan(a*t)",
        kappa: "cot(th)/a, th = pi*T/(2*tau)",
        kappa_in_time_to_go: "1/(a*tan(pi*T/(2*tau)))",
        r: "(-1)^(k-1) (k-1)! (2*tau/pi) a^k sin(k*th) sin(th)^k",
        atoms: "y = cot(th), V = 1/(1 + y^2)",
        decay_rate: "0",
        parameters: &["a"],
    },
    FamilyInfo {
        family: Family::Tanh,
        name: "tanh",
        mu: "tau*tanh(a*t)",
        kappa: "-ln(E)/(2*a), E = T/(2*tau - T)",
        kappa_in_time_to_go: "-ln(T/(2*tau - T))/(2*a)",
        r: "2*tau*(-2*a)^k Li_{-k}(-E)",
        atoms: "T = time-to-go, E = exp(-2*a*t) = T/(2*tau - T), L = 1/(1 + E)",
        decay_rate: "2*a",
        parameters: &["a"],
    },
    FamilyInfo {
        family: Family::Algebraic,
        name: "algebraic",
        mu: "tau*a*t/sqrt(1 + (a*t)^2)",
        kappa: "y/a, y = (tau - T)/sqrt(T*(2*tau - T))",
        kappa_in_time_to_go: "(tau - T)/(a*sqrt(T*(2*tau - T)))",
        r: "tau a^k v^(1 + k/2) Q_k(s), s = 1 - T/tau, v = 1 - s^2, Q_1 = 1, Q_{k+1} = v Q_k' - (k+2) s Q_k",
        atoms: "y = a*t, h = 1/sqrt(1 + y^2)",
        decay_rate: "0",
        parameters: &["a"],
    },
    FamilyInfo {
        family: Family::ExpSum,
        name: "exp_sum",
        mu: "tau*mean_i(1 - exp(-a_i*t))",
        kappa: "the root t of mean_i(exp(-a_i*t)) = T/tau, by a bracketed iteration",
        kappa_in_time_to_go: "",
        r: "(-1)^(k-1) tau mean_i(a_i^k e_i)",
        atoms: "e_i = exp(-a_i*t)",
        decay_rate: "min_i a_i",
        parameters: &["rates"],
    },
];

impl Family {
    /// Everything told about the family.
    pub fn info(self) -> &'static FamilyInfo {
        // The table is in the order of the enum; a test holds it there.
        &FAMILIES[self as usize]
    }

    /// The family's name.
    pub fn name(self) -> &'static str {
        self.info().name
    }

    /// Whether kappa needs an iteration at run time.
    pub fn is_iterated(self) -> bool {
        self == Self::ExpSum
    }

    /// The mapping as a differential ring; `rates` is the number of terms of `exp_sum`.
    pub fn mapping(self, rates: usize) -> Mapping {
        match self {
            Self::Exp => exp(),
            Self::Rational => rational(),
            Self::Power => power(),
            Self::Tan => tan(),
            Self::Tanh => tanh(),
            Self::Algebraic => algebraic(),
            Self::ExpSum => exp_sum(rates),
        }
    }
}

const fn plain(kind: Kind) -> Symbol {
    Symbol::plain(kind)
}

/// `coefficient * product of powers`.
fn term(coefficient: i64, powers: &[(Kind, i32)]) -> Poly {
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
        evaluated: Vec::new(),
        rate: term(1, &[(Kind::A, 1)]),
        base: Some((term(1, &[(Kind::TimeToGo, 1)]), plain(Kind::InverseTimeToGo))),
    }
}

/// kappa' = tau/(a T^2), so D T = -(a/tau) T^2.
fn rational() -> Mapping {
    let r1 = term(1, &[(Kind::A, 1), (Kind::Tau, -1), (Kind::TimeToGo, 2)]);
    Mapping {
        derivations: vec![(plain(Kind::TimeToGo), r1.scaled(&integer(-1)))],
        r1,
        reciprocals: vec![inverse_time_to_go()],
        evaluated: Vec::new(),
        rate: term(1, &[(Kind::A, 1), (Kind::Tau, -1)]),
        base: Some((term(1, &[(Kind::TimeToGo, 1)]), plain(Kind::InverseTimeToGo))),
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
        evaluated: Vec::new(),
        rate: term(1, &[(Kind::A, 1)]),
        base: Some((term(1, &[(Kind::TimeToGo, 1)]), plain(Kind::InverseTimeToGo))),
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
        evaluated: vec![(y, term(2, &[(Kind::Tau, 1), (Kind::Pi, -1), (Kind::CotangentRate, 1)]))],
        rate: term(1, &[(Kind::A, 1)]),
        base: None,
    }
}

/// With E = e^{-2 a t} and L = 1/(1 + E): T = 2 tau E g, r_1 = 2 a T g.
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
        evaluated: Vec::new(),
        rate: term(2, &[(Kind::A, 1)]),
        base: Some((term(1, &[(Kind::TimeToGo, 1)]), plain(Kind::InverseTimeToGo))),
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
        evaluated: Vec::new(),
        rate: term(1, &[(Kind::A, 1)]),
        base: Some((term(1, &[(Kind::Cosine, 1)]), plain(Kind::Secant))),
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
        base: None,
        r1,
        derivations: (1..=rates)
            .map(|i| (mode(i), rate(i).times(&Poly::symbol(mode(i))).scaled(&integer(-1))))
            .collect(),
        reciprocals: Vec::new(),
        evaluated: Vec::new(),
        rate: Poly::one(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_in_the_order_of_the_enum() {
        for (index, info) in FAMILIES.iter().enumerate() {
            assert_eq!(info.family as usize, index);
            assert!(std::ptr::eq(info.family.info(), info));
        }
    }
}
