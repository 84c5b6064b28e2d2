//! Gains from the Taylor series of mu, for mappings whose r_1 is no single term.

use super::builder::Builder;
use crate::algebra::BigRational;
use crate::expansion::bell::factorials;
use crate::program::Value;
use crate::spec::Parameter;

/// The normalised Taylor series p(z) = z + sum_{l>=2} c_l z^l of mu at stretched time.
pub(super) struct Taylor {
    /// 1/r_1.
    pub(super) base_inverse: Value,
    /// c_2, ..., c_n with c_l = r_l/(r_1 l!).
    pub(super) tail: Vec<Value>,
}

/// The rows of gain_j = r_1^-(n+1-j) rows[j - 1]: row_j is -1/(j-1)! times the sum over
/// i = j-1..n of k_{i+1} i! [z^i] p^(j-1), because B_{i,j-1}/r_1^(j-1) = i!/(j-1)! [z^i] p^(j-1).
pub(super) fn rows(b: &mut Builder<'_>, taylor: &Taylor) -> Vec<Option<Value>> {
    let n = b.spec.n;
    let factorial = factorials(n);
    let weights: Vec<Value> = (0..n)
        .map(|i| {
            let gain = b.parameter(Parameter::Gain(i + 1));
            let factor = b.number(BigRational::from_integer(-factorial[i].clone()));
            let weight = b.mul(factor, gain);
            b.name(weight, &format!("w{}", i + 1), &format!("weighted gain -{i}!*k{}", i + 1))
        })
        .collect();
    let last = b.number(BigRational::from_integer(-factorial[n].clone()));
    let weight = |i: usize| weights.get(i).copied().unwrap_or(last);
    let mut rows = vec![Some(weight(0))];
    // power[d] = [z^(j+d)] p^j for d >= 1; [z^j] p^j = 1.
    let mut power: Vec<Value> = Vec::new();
    for (j, factorial) in factorial.iter().enumerate().take(n).skip(1) {
        power = if j == 1 { taylor.tail.clone() } else { times_series(b, &power, &taylor.tail) };
        power.truncate(n - j);
        let mut sum = weight(j);
        for (d, coefficient) in power.iter().enumerate() {
            let term = b.mul(weight(j + d + 1), *coefficient);
            sum = b.add(sum, term);
        }
        let scale = b.number(BigRational::new(1.into(), factorial.clone()));
        let row = b.mul(sum, scale);
        let meaning = format!("gain of x{} without its power of 1/r1", j + 1);
        rows.push(Some(b.name(row, &format!("row{}", j + 1), &meaning)));
    }
    rows
}

/// (1 + sum_d a_d z^d)(1 + sum_d c_d z^d) without its 1, as long as `tail`.
fn times_series(b: &mut Builder<'_>, power: &[Value], tail: &[Value]) -> Vec<Value> {
    (0..power.len())
        .map(|d| {
            let mut sum = b.add(power[d], tail[d]);
            for e in 0..d {
                let term = b.mul(power[e], tail[d - 1 - e]);
                sum = b.add(sum, term);
            }
            sum
        })
        .collect()
}
