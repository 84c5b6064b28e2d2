//! The exact plant x' = A x + B (u + d), y = C x, sampled, whose input acts late.

use std::collections::VecDeque;

use num_traits::{FromPrimitive, One, ToPrimitive, Zero};
use ptc_codegen::algebra::{BigInt, BigRational};

/// Numbers are multiples of 2^-BITS: nothing beside what is asked for.
const BITS: usize = 400;

type Rows = Vec<Vec<BigInt>>;

#[derive(Clone, Debug)]
pub(crate) struct Plant {
    /// exp of ((A, B), (0, 0)) over the part of a sample before the next input takes over, and over
    /// the rest, where there is any.
    parts: Vec<Rows>,
    c: Rows,
    pub(crate) x: Vec<BigInt>,
    late: VecDeque<BigInt>,
    /// d, and what is known of the force in units of u.
    added: BigInt,
    /// The largest of each state so far.
    pub(crate) largest: Vec<f64>,
}

/// A decimal number, exact.
pub(crate) fn number(text: &str) -> BigRational {
    let (whole, part) = text.trim().split_once('.').unwrap_or((text.trim(), ""));
    let digits: BigInt = format!("{whole}{part}").parse().expect("digits");
    BigRational::new(digits, num_traits::pow(BigInt::from(10), part.len()))
}

fn fixed(value: &BigRational) -> BigInt {
    (value * BigRational::from_integer(BigInt::one() << BITS)).to_integer()
}

pub(crate) fn double(value: &BigInt) -> f64 {
    BigRational::new(value.clone(), BigInt::one() << BITS).to_f64().expect("a double")
}

fn product(a: &Rows, b: &Rows) -> Rows {
    let entry = |row: &Vec<BigInt>, j: usize| {
        let products = row.iter().zip(b).map(|(a, row)| a * &row[j]);
        products.fold(BigInt::zero(), |sum, product| sum + product) >> BITS
    };
    a.iter().map(|row| (0..b[0].len()).map(|j| entry(row, j)).collect()).collect()
}

/// exp of ((A, B), (0, 0)) h, by its series for 2^-12 h, squared.
fn exponential(a: &[Vec<BigRational>], b: &[Vec<BigRational>], h: &BigRational) -> Rows {
    let size = b.len() + b[0].len();
    let part = h / BigRational::from_integer(BigInt::one() << 12);
    let row = |(a, b): (&Vec<_>, &Vec<_>)| a.iter().chain(b).map(|e| fixed(&(e * &part))).collect();
    let mut all: Rows = a.iter().zip(b).map(row).collect();
    all.resize(size, vec![BigInt::zero(); size]);
    let one = || BigInt::one() << BITS;
    let unit = |i: usize, j: usize| if i == j { one() } else { BigInt::zero() };
    let mut sum: Rows = (0..size).map(|i| (0..size).map(|j| unit(i, j)).collect()).collect();
    let mut term = sum.clone();
    for k in 1..40 {
        term = product(&term, &all);
        term.iter_mut().flatten().for_each(|entry| *entry /= BigInt::from(k));
        for (sum, term) in sum.iter_mut().flatten().zip(term.iter().flatten()) {
            *sum += term;
        }
    }
    for _ in 0..12 {
        sum = product(&sum, &sum);
    }
    sum
}

impl Plant {
    /// The plant with rows of A, with B, rows of C, a period, a delay in samples and what is added to u.
    pub(crate) fn new(
        a: &[Vec<BigRational>],
        b: &[BigRational],
        c: &[Vec<BigRational>],
        h: &BigRational,
        delay: &str,
        added: &BigRational,
    ) -> Self {
        let n = b.len();
        let delay = number(delay);
        let inputs = delay.ceil();
        let first = &delay - &inputs + BigRational::one();
        let lengths = [&first * h, (BigRational::one() - &first) * h];
        let lengths = lengths.iter().filter(|length| !length.is_zero());
        let one = || BigInt::one() << BITS;
        let x: Vec<_> = (0..n).map(|i| one() / (i + 2)).collect();
        let b: Vec<_> = b.iter().map(|b| vec![b.clone()]).collect();
        Self {
            parts: lengths.map(|length| exponential(a, &b, length)).collect(),
            c: c.iter().map(|row| row.iter().map(fixed).collect()).collect(),
            largest: x.iter().map(double).collect(),
            x,
            late: vec![BigInt::zero(); inputs.to_usize().expect("few samples")].into(),
            added: fixed(added),
        }
    }

    /// The chain x_n' = f + g (u + d) of which x_1..x_m are measured.
    pub(crate) fn chain(
        (n, measured): (usize, usize),
        [g, f, d]: [&BigRational; 3],
        h: &BigRational,
        delay: &str,
    ) -> Self {
        let unit = |i: usize, j: usize| {
            if i == j { BigRational::one() } else { BigRational::zero() }
        };
        let rows = |from: usize, count: usize| -> Vec<Vec<_>> {
            (from..from + count).map(|i| (0..n).map(|j| unit(i, j)).collect()).collect()
        };
        let mut b = vec![BigRational::zero(); n];
        b[n - 1] = g.clone();
        Self::new(&rows(1, n), &b, &rows(0, measured), h, delay, &(d + f / g))
    }

    pub(crate) fn measured(&self) -> Vec<f64> {
        let x = self.x.iter().map(|x| vec![x.clone()]).collect();
        product(&self.c, &x).iter().map(|y| double(&y[0])).collect()
    }

    /// A sample later, with the input of this one.
    pub(crate) fn step(&mut self, u: f64) {
        self.late.push_back(fixed(&BigRational::from_f64(u).expect("a finite u")));
        let older = self.late.pop_front().expect("an input");
        let newer = self.late.front().unwrap_or(&older).clone();
        for (part, acting) in self.parts.iter().zip([older, newer]) {
            let acting = acting + &self.added;
            let given = self.x.iter().chain([&acting]).map(|x| vec![x.clone()]).collect();
            self.x = product(part, &given).into_iter().map(|mut row| row.remove(0)).collect();
            self.x.pop();
        }
        for (largest, x) in self.largest.iter_mut().zip(&self.x) {
            *largest = largest.max(double(x).abs());
        }
    }

    /// Returns the absolute error of an estimate of state `i`.
    pub(crate) fn off(&self, i: usize, estimate: f64) -> f64 {
        let estimate = fixed(&BigRational::from_f64(estimate).expect("a finite estimate"));
        double(&(estimate - &self.x[i])).abs()
    }

    /// The largest state, in parts of the largest on the way.
    pub(crate) fn left(&self) -> f64 {
        let most = self.x.iter().map(|x| double(x).abs()).fold(0.0, f64::max);
        most / self.largest.iter().copied().fold(0.0, f64::max)
    }
}

/// The exact plant x' = A x + B u of several inputs, sampled.
pub(crate) struct Several {
    whole: Rows,
    x: Vec<BigInt>,
    largest: f64,
}

impl Several {
    /// The plant with rows of A and B, a period, and a state at the start.
    pub(crate) fn new(
        a: &[Vec<BigRational>],
        b: &[Vec<BigRational>],
        h: &BigRational,
        x0: &[f64],
    ) -> Self {
        let exact = |x: &f64| fixed(&BigRational::from_f64(*x).expect("a finite state"));
        let x = x0.iter().map(exact).collect();
        Self { whole: exponential(a, b, h), x, largest: 0.0 }
    }

    pub(crate) fn x(&self) -> Vec<f64> {
        self.x.iter().map(double).collect()
    }

    /// A sample later, with these inputs.
    pub(crate) fn step(&mut self, u: &[f64]) {
        self.largest = self.x().iter().fold(self.largest, |most, x| most.max(x.abs()));
        let exact = |u: &f64| fixed(&BigRational::from_f64(*u).expect("a finite u"));
        let given = self.x.iter().cloned().chain(u.iter().map(exact));
        let given = given.map(|x| vec![x]).collect();
        let count = self.x.len();
        let after = product(&self.whole, &given).into_iter().take(count);
        self.x = after.map(|mut row| row.remove(0)).collect();
    }

    /// The largest state, in parts of the largest on the way.
    pub(crate) fn left(&self) -> f64 {
        self.x().iter().fold(0.0_f64, |most, x| most.max(x.abs())) / self.largest
    }
}
