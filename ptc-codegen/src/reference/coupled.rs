//! The inputs of a plant with several of them: Theorem 1 for the chain of each output, and what moves these.

use astro_float_num::BigFloat;

use super::control::Chain;
use super::law::{Leaves, Term};
use super::long::{Arithmetic, below, double};
use super::mapping::Point;
use super::{Call, value_of};
use crate::expression::{Expression, Variable};
use crate::internal::fault;
use crate::model::{Coupled, Inverse};
use crate::parameter::Parameter;
use crate::request::Spec;

impl Arithmetic {
    /// Every u of a controller, of which `designs` are those of each chain.
    pub(super) fn controls(
        &mut self,
        (spec, designs): (&Spec, &[Spec]),
        (call, to_go): (&Call<'_>, &BigFloat),
        points: [&Point; 2],
    ) -> Option<Vec<Term>> {
        // What a call is given behind the state is a row for each output.
        let (states, row) = (spec.states(), spec.references());
        // An axis knows its own state alone.
        let (stride, length) = if spec.joins_axes() { (spec.n, spec.n) } else { (0, states) };
        let given = |index: usize| -> Vec<f64> {
            let behind = call.x.iter().skip(states + index * row).take(row);
            let own = call.x.iter().take(states).skip(index * stride).take(length);
            own.chain(behind).copied().collect()
        };
        let rows: Vec<_> = (0..designs.len()).map(given).collect();
        let call_of = |index: usize| {
            let laws = call.laws.get(index..).unwrap_or_default();
            Call { x: &rows[index], laws, ..*call }
        };
        let each = || designs.iter().enumerate();
        let chains: Vec<Chain> = each()
            .map(|(index, own)| {
                let parameter = |p| value_of(own, p, call.parameter);
                self.chain(own, &call_of(index), points[0], &parameter)
            })
            .collect();
        let all: Vec<Term> = chains.iter().flat_map(|chain| chain.xi.iter().cloned()).collect();
        let wanted: Option<Vec<Term>> = each()
            .map(|(index, own)| {
                let parameter = |p| value_of(own, p, call.parameter);
                let call = call_of(index);
                self.control(own, (&call, to_go), points, (&chains[index], &all), &parameter)
            })
            .collect();
        match spec.decoupled() {
            None => wanted,
            Some(coupled) => Some(self.inputs((spec, coupled), call, &wanted?)),
        }
    }

    /// The inputs that give each output the derivative that is wanted of it, without its drift: M w + bias, or
    /// D^-1 w by the adjugate.
    fn inputs(
        &mut self,
        (spec, coupled): (&Spec, &Coupled),
        call: &Call<'_>,
        wanted: &[Term],
    ) -> Vec<Term> {
        let bits = self.bits();
        let number = |p: Parameter| double(value_of(spec, p, call.parameter), bits);
        let variable = |v: Variable| match v {
            Variable::State(j) => Term::given(double(call.x[j - 1], bits)),
            // A plant is a function of its states alone.
            _ => Term::given(double(f64::NAN, bits)),
        };
        let leaves = Leaves { parameter: &number, variable: &variable };
        let mut product = |row: &[Expression]| {
            let zero = Term { value: self.integer(0), size: self.integer(0) };
            row.iter().zip(wanted).fold(zero, |sum, (entry, wanted)| {
                let entry = self.term(entry, &leaves);
                let sizes = [
                    self.mul(&entry.value, &wanted.size).abs(),
                    self.mul(&wanted.value, &entry.size).abs(),
                ];
                Term {
                    value: self.add(&sum.value, &self.mul(&entry.value, &wanted.value)),
                    size: self.add(&sum.size, &self.add(&sizes[0], &sizes[1])),
                }
            })
        };
        match &coupled.inverse {
            Inverse::Adjugate { determinant, adjugate, .. } => {
                let rows: Vec<_> = adjugate.iter().map(|row| product(row)).collect();
                let by = self.term(determinant, &leaves);
                rows.iter().map(|row| self.over(row, &by)).collect()
            }
            Inverse::Elimination { matrix, .. } => {
                let mut row = |row: &Vec<Expression>| -> Vec<Term> {
                    row.iter().map(|entry| self.term(entry, &leaves)).collect()
                };
                let matrix: Vec<_> = matrix.iter().map(&mut row).collect();
                self.solved(&matrix, wanted)
            }
            Inverse::Robot(_) => fault("a self-test of a robot"),
            Inverse::Inertia { inertia, bias } => {
                let rows: Vec<_> = inertia.iter().map(|row| product(row)).collect();
                let rows = rows.iter().zip(bias);
                rows.map(|(row, bias)| {
                    let bias = self.term(bias, &leaves);
                    self.less(row, &Term { value: bias.value.neg(), size: bias.size })
                })
                .collect()
            }
        }
    }

    /// u of D u = w. Its size is |D^-1| (|w| + 2 |D| |u|), by which elimination may be off.
    fn solved(&self, matrix: &[Vec<Term>], wanted: &[Term]) -> Vec<Term> {
        let m = wanted.len();
        let zero = || self.integer(0);
        let unit = |k: usize| (0..m).map(|i| self.integer(i64::from(i == k))).collect::<Vec<_>>();
        // Columns behind the matrix: w, and those of the inverse.
        let row = |i: usize| -> Vec<BigFloat> {
            let own = matrix[i].iter().map(|entry| entry.value.clone());
            own.chain([wanted[i].value.clone()]).chain(unit(i)).collect()
        };
        let mut rows: Vec<_> = (0..m).map(row).collect();
        for k in 0..m {
            let most = (k..m).reduce(|a, b| match below(&rows[a][k].abs(), &rows[b][k].abs()) {
                true => b,
                false => a,
            });
            rows.swap(k, most.unwrap_or(k));
            let pivot = rows[k].clone();
            for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
                let factor = self.div(&row[k], &pivot[k]);
                for (entry, own) in row.iter_mut().zip(&pivot) {
                    *entry = self.sub(entry, &self.mul(&factor, own));
                }
            }
        }
        let over = |i: usize, j: usize| self.div(&rows[i][j], &rows[i][i]);
        let u: Vec<_> = (0..m).map(|i| over(i, m)).collect();
        let off = |i: usize| {
            let entries = matrix[i].iter().zip(&u);
            entries.fold(wanted[i].size.clone(), |sum, (entry, u)| {
                let size = self.add(&entry.size, &entry.value.abs());
                self.add(&sum, &self.mul(&size, &u.abs()))
            })
        };
        let off: Vec<_> = (0..m).map(off).collect();
        let size = |i: usize| {
            let each = off.iter().enumerate();
            each.fold(zero(), |sum, (j, off)| {
                self.add(&sum, &self.mul(&over(i, m + 1 + j).abs(), off))
            })
        };
        (0..m).map(|i| Term { value: u[i].clone(), size: size(i) }).collect()
    }

    /// A term over another.
    pub(super) fn over(&self, a: &Term, by: &Term) -> Term {
        let value = self.div(&a.value, &by.value);
        let by_divisor = self.mul(&value, &by.size).abs();
        let size = self.div(&self.add(&a.size, &by_divisor), &by.value.abs());
        Term { value, size }
    }
}
