//! Theorem 1: u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x).
//!
//! For the linear law pi0 = -sum k_i xi_i, with g = 1, u = sum_j gain_j x_j with gain_j = -kappa'^n sum_{i=j..n+1} k_i B_{i-1,j-1}, k_{n+1} = 1.
//! kappa'^n is multiplied in symbolically: entries of BB_n vanish at the deadline like powers of T
//! while kappa'^n blows up, and their product is a small power of 1/T with no cancellation.
//!
//! *Structure theorem.* With K_i = k_i rate^-(n+1-i), gain_j = base^-(n+1-j) row_j, where row_j is
//! a polynomial in one quantity that time decides, with coefficients that parameters decide; for the family
//! algebraic at low orders it is a(h^2) + y h^2 b(h^2).

use crate::algebra::{Kind, Poly, Symbol, integer};
use crate::expansion::{self, ClosedForms, Expanded};
use crate::expression::{Expression, Node};
use crate::mapping::{Atoms, Custom, Evaluation, Mapping, Reciprocal, expand};
use crate::parameter::Fixed;
use crate::request::{Feedback, Spec};

/// The form in which u is computed.
#[derive(Clone, Debug)]
pub enum Form {
    /// gain_j = base_inverse^(n+1-j) row_j with polynomial rows (see the module's doc).
    Rows {
        /// The tick quantity 1/base; `None` if it is part of the rows' coefficients.
        base_inverse: Option<Symbol>,
        /// `rows[j - 1]`, in the scaled gains, the parameters and at most one tick quantity; for algebraic
        /// in two, one of which stands alone at most.
        rows: Vec<Poly>,
        /// Values of the symbols of a user-defined mapping; those of a family are known.
        values: Vec<(Symbol, Expression)>,
    },
    /// gain_j = -r_1^-(n+1-j) (1/(j-1)!) sum_i k_i (i-1)! [z^(i-1)] p(z)^(j-1), where
    /// p(z) = sum_l r_l/(r_1 l!) z^l is the normalised Taylor series of mu: for mappings whose r_1
    /// is no single term. It needs r_1..r_n as numbers and no expansion at all.
    Series,
    /// u = (kappa'^n pi0(BB_n x, t_kappa) + sum_j h_j x_j)/g with h_j = -kappa'^n b_j: for a law that
    /// is not a sum of gains. BB_n and h come from the Taylor series of mu.
    State,
}

/// Theorem 1, specialised to one order, mapping and law.
#[derive(Clone, Debug)]
pub struct Law {
    /// Order n of the chain.
    pub n: usize,
    /// Rate of stretched time: K_i = k_i rate^-(n+1-i).
    pub rate: Poly,
    /// Form in which u is computed.
    pub form: Form,
    /// The closed forms from which it is computed, where another engine has made them.
    pub expanded: Option<Expanded>,
}

impl Law {
    /// The law of a spec.
    pub fn of(spec: &Spec) -> Self {
        Self::from(spec, None)
    }

    /// The same from the closed forms of another engine, where they are given.
    pub fn from(spec: &Spec, expanded: Option<&Expanded>) -> Self {
        let law = |form| Self { n: spec.n, rate: Poly::one(), form, expanded: None };
        let law = match (&spec.feedback, spec.ring()) {
            (Feedback::Linear, Some(ring)) => {
                Self::new(spec.n, &ring, expanded.and_then(Expanded::family))
            }
            (Feedback::Linear, None) => match spec.custom().filter(|_| expanded.is_none()) {
                Some(custom) => Self::of_custom(spec, custom).unwrap_or(law(Form::Series)),
                None => law(Form::Series),
            },
            _ => law(Form::State),
        };
        Self { expanded: expanded.cloned(), ..law }
    }

    /// The linear law with a user-defined mapping whose ring closes.
    fn of_custom(spec: &Spec, custom: &Custom) -> Option<Self> {
        let Atoms { ring, values: own } = custom.atoms(&|e| match e.node() {
            Node::Parameter(parameter) => {
                spec.fixed.get(parameter).and_then(Fixed::number).cloned().map(Expression::from)
            }
            _ => None,
        })?;
        let mut law = Self::new(spec.n, &ring, None);
        if let Form::Rows { values, .. } = &mut law.form {
            *values = own;
        }
        Some(law)
    }

    /// The linear law for order `n` and `mapping`, whose closed forms are `expanded` where they are
    /// given.
    pub fn new(n: usize, mapping: &Mapping, expanded: Option<&ClosedForms>) -> Self {
        let form = match mapping.r1.inverse() {
            Some(kappa_prime) => Form::Rows {
                base_inverse: mapping.evaluation(n).base.as_ref().map(|(_, inverse)| *inverse),
                rows: match expanded {
                    Some(forms) => rows(n, mapping, &kappa_prime, &forms.bell),
                    None => rows(n, mapping, &kappa_prime, &expansion::table(mapping, n)),
                },
                values: Vec::new(),
            },
            None => Form::Series,
        };
        Self { n, rate: mapping.rate.clone(), form, expanded: None }
    }
}

fn rows(n: usize, mapping: &Mapping, kappa_prime: &Poly, table: &[Vec<Poly>]) -> Vec<Poly> {
    let evaluation = mapping.evaluation(n);
    let kappa_prime_n = kappa_prime.pow(exponent(n));
    (0..n)
        .map(|j| {
            // Where time decides the base it is factored out; else its power joins the coefficients.
            let factored = match &evaluation.base {
                Some((base, _)) => base.pow(exponent(n - j)),
                None => Poly::one(),
            };
            let mut row = Poly::zero();
            for (i, bell) in table.iter().enumerate().skip(j) {
                let gain = if i == n { Poly::one() } else { scaled_gain(i + 1) };
                let bell = bell[j].times(&mapping.rate.pow(exponent(n - i)));
                row = row.plus(&gain.times(&kappa_prime_n).times(&bell));
            }
            in_tick_quantities(
                &row.times(&factored).scaled(&integer(-1)),
                &mapping.reciprocals,
                evaluation,
            )
        })
        .collect()
}

/// Writes negative powers of atoms in the quantities that are computed. A sum is expanded to a
/// polynomial in one of them; a single term stays a power, which is cheaper.
fn in_tick_quantities(row: &Poly, reciprocals: &[Reciprocal], evaluation: &Evaluation) -> Poly {
    let mut result = row.clone();
    for reciprocal in reciprocals {
        // A row over a power of all atoms has none of them below.
        if result.terms().all(|(m, _)| m.exponent(reciprocal.atom) >= 0) {
            continue;
        }
        if result.len() > 1 && reciprocal.expansion.is_some() {
            result = expand(&result, reciprocal);
            continue;
        }
        let mut named = Poly::zero();
        for (monomial, coefficient) in result.terms() {
            let e = exponent_of(-monomial.exponent(reciprocal.atom) / reciprocal.power);
            let rest = Poly::term(coefficient.clone(), monomial.without(reciprocal.atom));
            named = named.plus(&rest.times(&reciprocal.by.pow(e)));
        }
        result = named;
    }
    evaluation.evaluated.iter().fold(result, |row, atom| atom.apply(&row))
}

/// An exponent that the structure theorem shows to be non-negative.
fn exponent_of(value: i32) -> u32 {
    debug_assert!(value >= 0, "an atom is left in a positive power");
    value.unsigned_abs()
}

fn scaled_gain(i: usize) -> Poly {
    Poly::symbol(Symbol::indexed(Kind::ScaledGain, i))
}

fn exponent(value: usize) -> u32 {
    u32::try_from(value).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text;
    use crate::family::Family;

    fn rows_of(family: Family, n: usize) -> Vec<String> {
        match Law::new(n, &Mapping::of(family, 0), None).form {
            Form::Rows { rows, .. } => rows.iter().map(text).collect(),
            Form::Series | Form::State => Vec::new(),
        }
    }

    #[test]
    fn exp_rows_hold_no_time_at_all() {
        assert_eq!(rows_of(Family::Exp, 2), ["-K1", "1 - K2"]);
    }

    #[test]
    fn the_first_row_is_a_single_power() {
        assert_eq!(rows_of(Family::Rational, 3)[0], "-K1");
        assert_eq!(rows_of(Family::Tan, 3)[0], "-K1*slope^3");
        assert_eq!(rows_of(Family::Tanh, 2)[0], "-K1");
        assert_eq!(rows_of(Family::Tanh, 5)[0], "-K1*one_plus_E^5");
    }

    /// Rows where the ring of the mapping closes, else the Taylor series.
    #[test]
    fn the_form_of_a_custom_mapping_is_that_of_its_ring() {
        let form = |mu: &str| {
            let design = format!("n = 2\nmu = \"{mu}\"");
            let (entries, _) = crate::design::read(&design, &mut |_| crate::diagnostic::Place(0));
            Law::of(&crate::request::read(&entries).expect("a controller")).form
        };
        let Form::Rows { rows, .. } = form("tau*(1 - exp(-a*t))") else { panic!("it closes") };
        assert_eq!(rows.iter().map(text).collect::<Vec<_>>(), ["-K1", "1 - K2"]);
        assert!(matches!(form("tau*tanh(sinh(t))"), Form::Series));
    }

    #[test]
    fn a_sum_is_a_polynomial_in_one_quantity() {
        assert_eq!(rows_of(Family::Rational, 2)[1], "-K2 + 2*T");
        for family in [Family::Tan, Family::Tanh, Family::Algebraic, Family::Power] {
            let mapping = Mapping::of(family, 0);
            let rows = |n| match Law::new(n, &mapping, None).form {
                Form::Rows { rows, .. } => rows,
                _ => panic!("r_1 of {family:?} is a single term"),
            };
            for row in rows(4).into_iter().chain(rows(5)) {
                let tick = row.symbols().into_iter().filter(|s| {
                    !matches!(s.kind, Kind::Pi | Kind::Tau | Kind::M | Kind::ScaledGain)
                });
                let tick: Vec<_> = tick.map(Symbol::text).collect();
                let few = tick.len() <= 1 || tick == ["h2", "y_h2"];
                assert!(few, "{family:?}: {}", text(&row));
                assert!(
                    row.terms()
                        .all(|(m, _)| { m.exponent(Symbol::plain(Kind::AngleOverSquare)) <= 1 })
                );
                assert!(row.terms().all(|(m, _)| {
                    m.factors()
                        .iter()
                        .all(|(s, e)| *e > 0 || matches!(s.kind, Kind::Pi | Kind::Tau))
                }));
            }
        }
    }
}
