//! Unknown disturbances of the input: w' = S w, of which d = w_1 is added to u.
//!
//! A constant has the state d alone, a ramp and a sine d and its rate: d'' = -omega^2 d. In the period as the unit of
//! time S^2 is -(omega h)^2, so every power of S is known, and a sum over them is what a function of S is.

use std::fmt;

use num_traits::{One, ToPrimitive, Zero};

use super::condition::rounded;
use super::exponential::exponential;
use super::matrix::Matrix;
use super::pair::{Pair, factorial};
use super::{Complex, Linear};
use crate::algebra::BigRational;
use crate::syntax::constant;

/// Most powers of S that a sum has: those of a sine that is sampled twice a period leave 1e-130.
const POWERS: usize = 120;

/// A disturbance that is added to u, and estimated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Disturbance {
    /// A constant.
    Constant,
    /// A ramp, d'' = 0.
    Ramp,
    /// A sine of this frequency in rad/s: d'' = -omega^2 d.
    Sine(BigRational),
}

impl Disturbance {
    /// Returns the names of its states.
    pub fn states(&self) -> &'static [&'static str] {
        match self {
            Self::Constant => &["d"],
            Self::Ramp | Self::Sine(_) => &["d", "d_rate"],
        }
    }

    /// Returns true if d changes within a sample, where no held input follows it.
    pub fn moves(&self) -> bool {
        *self != Self::Constant
    }

    /// Returns a description of d.
    pub fn about(&self) -> &'static str {
        match self {
            Self::Constant => "constant",
            Self::Ramp => "ramp",
            Self::Sine(_) => "sine",
        }
    }

    /// Returns the longest period of samples that tell it from a slower one; `None` for any.
    pub(crate) fn longest_period(&self) -> Option<BigRational> {
        match self {
            Self::Constant | Self::Ramp => None,
            // pi, rounded down.
            Self::Sine(omega) => Some(BigRational::new(314.into(), 100.into()) / omega),
        }
    }

    /// Returns the mode that it adds to a plant, by the part above the real axis.
    pub(crate) fn mode(&self) -> Complex {
        let im = match self {
            Self::Constant | Self::Ramp => 0.0,
            Self::Sine(omega) => omega.to_f64().unwrap_or(f64::NAN),
        };
        Complex { re: 0.0, im }
    }

    /// Returns its generator for a period `h`; `None` for a sine whose period is open.
    fn generator(&self, h: Option<&BigRational>) -> Option<Generator> {
        let square = match self {
            Self::Constant | Self::Ramp => BigRational::zero(),
            Self::Sine(omega) => {
                let angle = omega * h?;
                &angle * &angle
            }
        };
        Some(Generator { states: self.states().len(), square })
    }

    /// Returns the weights of its states in the mean of d from `from` to `to`, in periods from now, where d and its rate
    /// are in periods too; `None` for a sine whose period is open.
    pub(crate) fn mean(
        &self,
        h: Option<&BigRational>,
        [from, to]: [&BigRational; 2],
    ) -> Option<Vec<BigRational>> {
        let power = |value: &BigRational, k: usize| num_traits::pow(value.clone(), k);
        let length = to - from;
        let part =
            |k: usize| (power(to, k + 1) - power(from, k + 1)) / (factorial(k + 1) * &length);
        Some(self.generator(h)?.sum(0, &part))
    }
}

/// As a design gives it.
impl fmt::Display for Disturbance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Constant | Self::Ramp => f.write_str(self.about()),
            Self::Sine(omega) => write!(f, "sine(omega={})", constant::text(omega)),
        }
    }
}

/// S in the period as the unit of time.
struct Generator {
    states: usize,
    /// (omega h)^2.
    square: BigRational,
}

impl Generator {
    /// Row `i` of the sum of `coefficient`(k) S^k, where the coefficients fall as those of an exponential.
    fn sum(&self, i: usize, coefficient: &dyn Fn(usize) -> BigRational) -> Vec<BigRational> {
        let mut sum = vec![BigRational::zero(); self.states];
        if self.states == 1 {
            sum[0] = coefficient(0);
            return sum;
        }
        // (-(omega h)^2)^j.
        let mut even = BigRational::one();
        for k in (0..POWERS).step_by(2) {
            if even.is_zero() {
                break;
            }
            let (own, next) = (coefficient(k), coefficient(k + 1));
            let less = -&even * &self.square;
            let terms = match i {
                0 => [&own * &even, &next * &even],
                _ => [&next * &less, &own * &even],
            };
            sum.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
            even = less;
        }
        if self.square.is_zero() { sum } else { rounded(sum) }
    }

    /// Row `i` of e^S.
    fn row(&self, i: usize) -> Vec<BigRational> {
        self.sum(i, &|k| BigRational::one() / factorial(k))
    }
}

impl Pair {
    /// A chain with a disturbance as its last states, sampled with period `h`; `None` for a sine whose period is open.
    pub(crate) fn chain_with(
        disturbance: &Disturbance,
        n: usize,
        gain: &BigRational,
        part: &BigRational,
        h: Option<&BigRational>,
    ) -> Option<Self> {
        let generator = disturbance.generator(h)?;
        // Integrated n - i times more.
        let effect =
            |i: usize| generator.sum(0, &|k| gain / factorial(n - i + k)).into_iter().collect();
        let effects: Vec<Vec<_>> = (0..n).map(effect).collect();
        let own: Vec<_> = (0..generator.states).map(|i| generator.row(i)).collect();
        let powers = (0..generator.states).map(|i| if i == 0 { 0 } else { -1 });
        Some(Self::chain(n, gain, part).beside(&effects, &own, powers.collect()))
    }

    /// A linear plant with a disturbance as its last states; `None` if the period is too long for its modes.
    pub(crate) fn linear_with(
        disturbance: &Disturbance,
        plant: &Linear,
        h: &BigRational,
        part: &BigRational,
    ) -> Option<Self> {
        let pair = Self::linear(plant, h, part)?;
        if !disturbance.moves() {
            return Some(pair.with_constant());
        }
        let generator = disturbance.generator(Some(h))?;
        let n = pair.order();
        let entry = |i: usize, j: usize| match (i.checked_sub(n), j.checked_sub(n)) {
            (None, None) => &plant.a[i][j] * h,
            (None, Some(0)) => &plant.b[i] * h,
            (Some(0), Some(1)) => h.clone(),
            (Some(1), Some(0)) => -&generator.square / h,
            _ => BigRational::zero(),
        };
        let all = exponential(&Matrix::new(n + 2, n + 2, entry))?;
        let rows = |rows: std::ops::Range<usize>| {
            rows.map(|i| (n..n + 2).map(|j| all.at(i, j).clone()).collect())
                .collect::<Vec<Vec<_>>>()
        };
        Some(pair.beside(&rows(0..n), &rows(n..n + 2), vec![0; 2]))
    }

    fn with_constant(&self) -> Self {
        let effects: Vec<_> = self.gamma.iter().map(|entry| vec![entry.clone()]).collect();
        self.beside(&effects, &[vec![BigRational::one()]], vec![0])
    }

    /// The same with states that move by themselves as `own` says, and act on those before as `effects` say.
    fn beside(
        &self,
        effects: &[Vec<BigRational>],
        own: &[Vec<BigRational>],
        powers: Vec<i64>,
    ) -> Self {
        let (n, more) = (self.order(), own.len());
        let entry = |i: usize, j: usize| match (i.checked_sub(n), j.checked_sub(n)) {
            (None, None) => self.phi.at(i, j).clone(),
            (None, Some(j)) => effects[i][j].clone(),
            (Some(_), None) => BigRational::zero(),
            (Some(i), Some(j)) => own[i][j].clone(),
        };
        let with_none =
            |column: &[BigRational]| [column, &vec![BigRational::zero(); more]].concat();
        let (gamma, newer) = (with_none(&self.gamma), with_none(&self.newer));
        let powers = [self.powers.clone(), powers].concat();
        Self { phi: Matrix::new(n + more, n + more, entry), gamma, newer, powers }
    }
}
