//! Numbers of all lanes, and the vectors of the processor that compute with them.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use fearless_simd::{Level, Simd};

/// Lanes of a pack.
pub const LANES: usize = 8;

/// A number for each lane.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Pack(pub [f64; LANES]);

impl Pack {
    /// The same number in all lanes.
    pub const fn all(value: f64) -> Self {
        Self([value; LANES])
    }

    /// A number for each lane, by a loop, as compilers leave calls in what the library makes arrays with.
    #[inline(always)]
    pub fn of(mut number: impl FnMut(usize) -> f64) -> Self {
        let mut all = [0.0; LANES];
        for lane in 0..LANES {
            all[lane] = number(lane);
        }
        Self(all)
    }

    /// A function of each number.
    #[inline(always)]
    #[must_use]
    pub fn map(&self, mut function: impl FnMut(f64) -> f64) -> Self {
        Self::of(|lane| function(self.0[lane]))
    }

    /// e^x in each lane, to a relative 2.2e-16, by vectors: libraries have it one by one, or by vectors that are chosen when they
    /// are compiled.
    #[must_use]
    pub fn exp(&self) -> Self {
        vectorized!(exponential(self))
    }

    /// Takes some lanes of another pack.
    #[inline]
    pub fn take(&mut self, from: &Self, lanes: &[bool; LANES]) {
        for lane in 0..LANES {
            self.0[lane] = if lanes[lane] { from.0[lane] } else { self.0[lane] };
        }
    }
}

/// Bound of |x| within which 2^k and all intermediate values are normal numbers.
const NORMAL: f64 = 700.0;

/// ln 2, of which k times the first part is exact.
#[allow(clippy::excessive_precision)]
const LN_2: [f64; 2] = [6.931_471_803_691_238_164_90e-1, 1.908_214_929_270_587_700_02e-10];

/// Constant whose addition rounds to integers, which are then the last bits of the sum.
const ROUNDS: f64 = 6_755_399_441_055_744.0;

/// Coefficients of e^r after 1 + r: 1/2!, 1/3!, ... The remainder is below r^14/14! = 4e-18 for |r| <= ln 2 / 2.
const TERMS: [f64; 12] = {
    let (mut terms, mut factorial, mut i) = ([0.0; 12], 1.0, 0);
    while i < terms.len() {
        factorial *= (i + 2) as f64;
        terms[i] = 1.0 / factorial;
        i += 1;
    }
    terms
};

/// e^x = 2^k e^r with x = k ln 2 + r.
#[inline(always)]
fn exponential(x: &Pack) -> Pack {
    let mut all = Pack::all(0.0);
    for lane in 0..LANES {
        let x = x.0[lane];
        let rounded = x * std::f64::consts::LOG2_E + ROUNDS;
        let k = rounded - ROUNDS;
        let r = (x - k * LN_2[0]) - k * LN_2[1];
        let mut sum = TERMS[TERMS.len() - 1];
        for i in (0..TERMS.len() - 1).rev() {
            sum = TERMS[i] + r * sum;
        }
        let power = f64::from_bits((rounded.to_bits() << 52).wrapping_add(1.0_f64.to_bits()));
        all.0[lane] = power * (1.0 + (r + r * r * sum));
    }
    for lane in 0..LANES {
        let is_normal = x.0[lane].abs() <= NORMAL;
        if !is_normal {
            all.0[lane] = x.0[lane].exp();
        }
    }
    all
}

/// Runs `kernel` with the vectors of AVX2 where the processor has them, as far as what it calls is inlined. No operation is
/// contracted or moved by that: the bits are those of any processor. The wider ones of AVX-512 made campaigns slower.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[inline(always)]
pub(crate) fn with_vectors<R>(kernel: impl FnOnce() -> R) -> R {
    match Level::new().as_avx2() {
        Some(avx2) => avx2.vectorize(kernel),
        None => kernel(),
    }
}

/// Runs `kernel` with the vectors that it is compiled for.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
#[inline(always)]
pub(crate) fn with_vectors<R>(kernel: impl FnOnce() -> R) -> R {
    kernel()
}

/// An expression by [`with_vectors`].
macro_rules! vectorized {
    ($kernel:expr) => {
        $crate::program::lanes::with_vectors(
            #[inline(always)]
            || $kernel,
        )
    };
}
pub(crate) use vectorized;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packed_exponentials_match_the_library() {
        let mut x = 0.37;
        let mut odd = [
            0.0,
            -0.0,
            700.0,
            -700.0,
            709.7,
            -745.0,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NAN,
            800.0,
            1e-300,
        ]
        .into_iter();
        for _ in 0..20_000 {
            let all = Pack::all(0.0).map(|_| {
                // The logistic map wanders all over [0, 1].
                x = 3.99 * x * (1.0 - x);
                odd.next().unwrap_or(1400.0 * x - 700.0)
            });
            // With and without vectors.
            let plain = exponential(&all);
            for ((own, plain), x) in all.exp().0.iter().zip(plain.0).zip(all.0) {
                assert!(own.to_bits() == plain.to_bits() || x.is_nan(), "{x}: {own} {plain}");
                let wanted = x.exp();
                let off = (own - wanted).abs();
                let same = own.to_bits() == wanted.to_bits() || wanted.is_nan() && own.is_nan();
                assert!(same || off <= f64::EPSILON * wanted, "{x}: {own} {wanted}");
            }
        }
    }
}
