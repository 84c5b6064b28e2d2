//! A plant that is linear while its input is held, beside sines of time: from sample to sample by the matrix
//! exponential.
//!
//! x' = A x + B u + c has x(s) = E x + (F B u + F c), E = exp(A s) and F the integral of E. A sine of time is S of
//! S' = w C, C' = -w S, so that it is two states more of such a plant.

use super::Along;
use super::linear::SAME;
use super::method::State;
use super::terms::{Sum, Terms, needed};
use crate::expression::Function;
use crate::linear::{Rows, flow};
use crate::program::{Input, Op, Program, Stage, Value};

/// The rates x' = A x + B u + c + sines, with what they come to over some lengths of time.
#[derive(Clone, Debug)]
pub(super) struct Held {
    /// Composition of the rates, for a program all of whose values they are.
    sums: Vec<Sum>,
    /// The values that the rates are made of, operands first.
    needed: Vec<usize>,
    rates: Vec<usize>,
    /// The terms of all values.
    terms: Terms,
    /// The numbers of the rates.
    plant: Numbers,
    /// Lengths in s of this run, each with what the plant comes to over it.
    over: Vec<(f64, Over)>,
}

/// The numbers of a plant.
#[derive(Clone, Debug, Default)]
struct Numbers {
    /// A, and the columns of B behind it.
    rates: Rows,
    /// c.
    constant: Vec<f64>,
    /// Each sine that is not 0.
    waves: Vec<Wave>,
}

/// A sine or cosine with what it adds to the rates.
#[derive(Clone, Debug)]
struct Wave {
    /// Its angle, and the rate of that in rad/s.
    angle: Value,
    rate: f64,
    is_cosine: bool,
    column: Vec<f64>,
}

/// Effect of a length of time on a state: of the state, of a constant in the rates, of the inputs, and of the sine and
/// the cosine of each wave at its beginning.
#[derive(Clone, Debug)]
struct Over {
    whole: Rows,
    integral: Rows,
    of_inputs: Rows,
    waves: Vec<[Vec<f64>; 2]>,
}

/// Row of a plant without waves over a length of time: a row of E, one of F B, and a number of F c.
pub(super) type Row<'a> = (&'a [f64], &'a [f64], f64);

/// Effect of a length of time on a plant, and the length to which it belongs.
#[cfg(feature = "lab")]
#[derive(Clone, Debug)]
pub(super) struct Effect {
    pub(super) length: f64,
    /// True if it stands for all lengths that are the same within rounding.
    pub(super) is_kept: bool,
    /// Rows of E, F B and F c.
    pub(super) rows: Vec<(Vec<f64>, Vec<f64>, f64)>,
    /// Number of waves.
    pub(super) waves: usize,
}

/// Lengths that are kept: a sample, its parts and those beside a delay.
const KEPT: usize = 8;

impl Held {
    /// `None` where a rate of the plant is not such a sum.
    pub(super) fn of(program: &Program, rates: &[Value]) -> Option<Self> {
        let mut sums: Vec<Sum> = Vec::with_capacity(program.values.len());
        // Whether state or inputs, and whether time as such, are in each.
        let mut moves: Vec<[bool; 2]> = Vec::with_capacity(sums.capacity());
        for (place, definition) in program.values.iter().enumerate() {
            let is_constant = |value: &Value| matches!(sums[value.0], Sum::Constant(_));
            let is_sum = |value: &Value| !matches!(sums[value.0], Sum::Other);
            let sum = match &definition.op {
                _ if definition.stage <= Stage::Arm => Sum::Constant(Value(place)),
                Op::Input(Input::State(j)) => Sum::State(*j),
                Op::Input(Input::Control) => Sum::Control,
                Op::Input(Input::Time) => Sum::Time,
                op if !op.operands().iter().all(is_sum) => Sum::Other,
                Op::Neg(a) => Sum::Neg(a.0),
                Op::Add(a, b) => Sum::Add(a.0, b.0),
                Op::Sub(a, b) => Sum::Sub(a.0, b.0),
                Op::Mul(a, b) if is_constant(b) => Sum::Mul(a.0, b.0),
                Op::Mul(a, b) if is_constant(a) => Sum::Mul(b.0, a.0),
                Op::Fused(a, b, c) if is_constant(b) => Sum::Fused(a.0, b.0, c.0),
                Op::Fused(a, b, c) if is_constant(a) => Sum::Fused(b.0, a.0, c.0),
                Op::Div(a, b) if is_constant(b) => Sum::Div(a.0, b.0),
                Op::Call(function @ (Function::Sin | Function::Cos), a)
                    if moves[a.0] == [false, true] =>
                {
                    Sum::Wave(a.0, *function == Function::Cos)
                }
                _ => Sum::Other,
            };
            // A wave goes with time, and what a wave is in is no wave's argument.
            moves.push(match &sum {
                Sum::State(_) | Sum::Control | Sum::Wave(..) => [true, false],
                Sum::Time => [false, true],
                _ => definition.op.operands().iter().fold([false; 2], |all, value| {
                    let own = moves[value.0];
                    [all[0] || own[0], all[1] || own[1]]
                }),
            });
            sums.push(sum);
        }
        let legal = |rate: &Value| !matches!(sums[rate.0], Sum::Other) && !moves[rate.0][1];
        let rates: Option<Vec<_>> =
            rates.iter().map(|rate| legal(rate).then_some(rate.0)).collect();
        let rates = rates?;
        Some(Self {
            needed: needed(&sums, &rates),
            rates,
            sums,
            terms: Terms::default(),
            plant: Numbers::default(),
            over: Vec::new(),
        })
    }

    /// Takes the numbers of a plant with so many `inputs`.
    pub(super) fn settle(&mut self, along: &Along, inputs: usize) {
        let Self { sums, needed, rates, terms, plant, .. } = self;
        terms.begin(sums.len(), rates.len() + inputs);
        for place in needed.iter().copied() {
            terms.sum(place, &sums[place], rates.len(), |value| along.machine.get(value));
        }
        plant.rates.resize(rates.len(), Vec::new());
        for (row, rate) in plant.rates.iter_mut().zip(&*rates) {
            row.clear();
            row.extend_from_slice(terms.slopes(*rate));
        }
        plant.constant.clear();
        plant.constant.extend(rates.iter().map(|rate| terms.constant[*rate]));
        plant.waves.clear();
        for place in needed.iter().copied() {
            let Sum::Wave(angle, is_cosine) = sums[place] else { continue };
            let column: Vec<f64> = rates.iter().map(|rate| terms.factor(*rate, place)).collect();
            if column.iter().any(|factor| *factor != 0.0) {
                let rate = terms.time[angle];
                plant.waves.push(Wave { angle: Value(angle), rate, is_cosine, column });
            }
        }
        // A length stands for all that differ from it by a rounding, so one of another run would change last digits.
        self.over.clear();
    }

    /// The state after `length` s from `t` on under u, of the program that is looked at; `None` where the exponential is beyond its numbers.
    pub(super) fn after(
        &mut self,
        along: &mut Along,
        (x, u): (&State, &[f64]),
        (t, length): (f64, f64),
    ) -> Option<State> {
        let place = self.place(length)?;
        let mut next = State::zeros();
        for (next, (whole, of_inputs, constant)) in next.iter_mut().zip(self.rows_at(place)) {
            *next = dot(whole, x.as_slice()) + (dot(of_inputs, u) + constant);
        }
        if !self.plant.waves.is_empty() {
            along.at(t, x.as_slice(), u);
        }
        for added in self.added(along, place) {
            next.iter_mut().zip(added).for_each(|(next, added)| *next += added);
        }
        Some(next)
    }

    /// Returns the rows over `length` s, and the length to which they belong, which may be a kept one that [`is_same`];
    /// `None` where there are waves, or the exponential is beyond its numbers.
    pub(super) fn rows(&mut self, length: f64) -> Option<(f64, impl Iterator<Item = Row<'_>>)> {
        let place = self.place(length)?;
        let is_whole = self.plant.waves.is_empty();
        is_whole.then(|| (self.over[place].0, self.rows_at(place)))
    }

    /// The same with the number of waves, whose effect is added.
    #[cfg(feature = "lab")]
    pub(super) fn effect(&mut self, length: f64) -> Option<Effect> {
        let place = self.place(length)?;
        let waves = self.plant.waves.len();
        let rows = self.rows_at(place);
        let rows = rows.map(|(whole, of_inputs, own)| (whole.to_vec(), of_inputs.to_vec(), own));
        let (length, rows) = (self.over[place].0, rows.collect());
        // The rows of waves are looked up at each sample.
        Some(Effect { length, is_kept: waves == 0, rows, waves })
    }

    /// Forgets the effects of lengths that were asked for.
    #[cfg(feature = "lab")]
    pub(super) fn forget(&mut self) {
        self.over.clear();
    }

    /// Appends what each wave adds to each state in `length` s from `t` on.
    #[cfg(feature = "lab")]
    pub(super) fn waves(
        &mut self,
        along: &mut Along,
        (t, length): (f64, f64),
        into: &mut Vec<f64>,
    ) -> Option<()> {
        if self.plant.waves.is_empty() {
            return Some(());
        }
        let place = self.place(length)?;
        // An angle is a function of time alone.
        along.at(t, &[], &[]);
        for added in self.added(along, place) {
            into.extend(added);
        }
        Some(())
    }

    /// What each wave adds to each state, of a program that is looked at.
    fn added(
        &self,
        along: &Along,
        place: usize,
    ) -> impl Iterator<Item = impl Iterator<Item = f64>> {
        let waves = self.plant.waves.iter().zip(&self.over[place].1.waves);
        waves.map(|(wave, [of_sine, of_cosine])| {
            let (sine, cosine) = along.machine.get(wave.angle).sin_cos();
            let (sine, cosine) = if wave.is_cosine { (cosine, -sine) } else { (sine, cosine) };
            of_sine.iter().zip(of_cosine).map(move |(a, b)| a * sine + b * cosine)
        })
    }

    fn rows_at(&self, place: usize) -> impl Iterator<Item = Row<'_>> {
        let Over { whole, integral, of_inputs, .. } = &self.over[place].1;
        let constants = integral.iter().map(|row| dot(row, &self.plant.constant));
        let rows = whole.iter().zip(of_inputs).zip(constants);
        rows.map(|((whole, of_inputs), constant)| (&**whole, &**of_inputs, constant))
    }

    /// Returns the index at which the effect of a length is stored.
    fn place(&mut self, length: f64) -> Option<usize> {
        if let Some(place) = self.over.iter().position(|(own, _)| is_same(*own, length)) {
            return Some(place);
        }
        let over = self.plant.over(length)?;
        if self.over.len() == KEPT {
            self.over.clear();
        }
        self.over.push((length, over));
        Some(self.over.len() - 1)
    }
}

/// Returns true if a length equals another one except for the rounding of the times between which it is.
#[inline]
pub(super) fn is_same(own: f64, length: f64) -> bool {
    (own - length).abs() <= SAME * length
}

/// Summed from the first one on, as lanes do.
fn dot(row: &[f64], v: &[f64]) -> f64 {
    row.iter().zip(v).map(|(a, b)| a * b).sum()
}

impl Numbers {
    /// Computes the effect of a length on the plant.
    fn over(&self, length: f64) -> Option<Over> {
        let (whole, integral) = flow(&self.rates, length)?;
        let n = self.rates.len();
        let of_wave = |Wave { rate, column, .. }: &Wave| {
            let row = |i: usize| [&self.rates[i][..n], &[column[i], 0.0]].concat();
            let mut wide: Rows = (0..n).map(row).collect();
            let oscillator = [[0.0, *rate], [-rate, 0.0]];
            wide.extend(oscillator.map(|own| [vec![0.0; n], own.to_vec()].concat()));
            let (whole, _) = flow(&wide, length)?;
            Some([n, n + 1].map(|column| (0..n).map(|i| whole[i][column]).collect()))
        };
        let waves = self.waves.iter().map(of_wave).collect::<Option<_>>()?;
        let column = |input: usize| self.rates.iter().map(|row| row[input]).collect::<Vec<_>>();
        let columns: Vec<_> = (n..self.rates.first().map_or(n, Vec::len)).map(column).collect();
        let of_inputs = |row: &Vec<f64>| columns.iter().map(|column| dot(row, column)).collect();
        let of_inputs = integral.iter().map(of_inputs).collect();
        Some(Over { whole, integral, of_inputs, waves })
    }
}
