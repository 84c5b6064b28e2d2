//! The exact plant, in long fixed-point numbers.

use std::collections::VecDeque;

use num_traits::{FromPrimitive, One, Signed, ToPrimitive, Zero};
use ptc_codegen::algebra::{BigInt, BigRational};

type Rows = Vec<Vec<BigRational>>;

/// The exact plant x' = A x + B u, y = C x.
pub(super) struct Plant {
    whole: Fixed,
    c: Fixed,
    pub(super) x: Fixed,
    late: VecDeque<BigInt>,
    largest: BigInt,
}

pub(super) fn number(text: &str) -> BigRational {
    let (whole, part) = text.trim().split_once('.').unwrap_or((text.trim(), ""));
    let digits: BigInt = format!("{whole}{part}").parse().expect("digits");
    BigRational::new(digits, num_traits::pow(BigInt::from(10), part.len()))
}

fn rows(text: &str) -> Rows {
    let row = |row: &str| row.split(',').map(number).collect();
    text.split(';').map(row).collect()
}

/// Numbers of the exact plant are multiples of 2^-BITS, far below any tolerance here.
const BITS: usize = 400;

type Fixed = Vec<Vec<BigInt>>;

fn fixed(value: &BigRational) -> BigInt {
    (value * BigRational::from_integer(BigInt::one() << BITS)).to_integer()
}

pub(super) fn double(value: &BigInt) -> f64 {
    BigRational::new(value.clone(), BigInt::one() << BITS).to_f64().expect("a double")
}

fn product(a: &Fixed, b: &Fixed) -> Fixed {
    let entry = |row: &Vec<BigInt>, j: usize| {
        let products = row.iter().zip(b).map(|(a, row)| a * &row[j]);
        products.fold(BigInt::zero(), |sum, product| sum + product) >> BITS
    };
    a.iter().map(|row| (0..b[0].len()).map(|j| entry(row, j)).collect()).collect()
}

impl Plant {
    pub(super) fn new(a: &str, b: &str, c: &str, h: &str, delay: usize) -> Self {
        let (a, b, h) = (rows(a), rows(b).swap_remove(0), number(h));
        let n = b.len();
        // exp by its series for 2^-12 h, squared.
        let h = h / (BigInt::one() << 12);
        let row = |i: usize| a[i].iter().chain([&b[i]]).map(|e| fixed(&(e * &h))).collect();
        let mut all: Fixed = (0..n).map(row).collect();
        all.push(vec![BigInt::zero(); n + 1]);
        let one = || BigInt::one() << BITS;
        let unit = |i: usize, j: usize| if i == j { one() } else { BigInt::zero() };
        let mut sum: Fixed = (0..=n).map(|i| (0..=n).map(|j| unit(i, j)).collect()).collect();
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
        let x = (0..n).map(|i| vec![one() / (i + 2)]).collect();
        let late = vec![BigInt::zero(); delay].into();
        let c = rows(c).iter().map(|row| row.iter().map(fixed).collect()).collect();
        Self { whole: sum, c, x, late, largest: one() }
    }

    pub(super) fn measured(&self) -> Vec<f64> {
        product(&self.c, &self.x).iter().map(|y| double(&y[0])).collect()
    }

    pub(super) fn step(&mut self, u: f64, disturbance: &BigRational) {
        self.late.push_back(fixed(&BigRational::from_f64(u).expect("a finite u")));
        let acting = self.late.pop_front().expect("an input") + fixed(disturbance);
        let mut given = self.x.clone();
        given.push(vec![acting]);
        self.x = product(&self.whole, &given);
        self.x.pop();
        self.largest = self.x.iter().map(|x| x[0].abs()).fold(self.largest.clone(), BigInt::max);
    }

    /// The largest state, in parts of the largest on the way.
    pub(super) fn left(&self) -> f64 {
        let most = self.x.iter().map(|x| x[0].abs()).max().expect("a state");
        BigRational::new(most, self.largest.clone()).to_f64().expect("a number")
    }
}
