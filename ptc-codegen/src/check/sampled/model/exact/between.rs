//! Bounds of the outputs with their derivatives between two samples, from those of the chains and of the inputs at
//! the first of them.
//!
//! They are x = E(s) x_k + H(s) u_k with u_k = G^-1 (v - F x_k) and an error, a row over xi and v at each s: what
//! u cancels of the plant is cancelled in the sum. Over a part of the sample a row is a convex combination of
//! control points, up to a rest.

use num_traits::Signed;

use super::maps::{Maps, both, summed};
use crate::algebra::BigRational;
use crate::linear::{Between, Matrix, Several};
use crate::request::Exact;

/// Bounds that hold at a sample.
pub(super) struct AtSample<'a> {
    /// Bounds of xi.
    pub(super) chains: &'a [BigRational],
    /// Bounds of v.
    pub(super) wanted: &'a [BigRational],
    /// Bounds of the difference of u from G^-1 (v - F x).
    pub(super) errors: &'a [BigRational],
    /// Bounds of u as it acts.
    pub(super) inputs: &'a [BigRational],
}

/// The bounds from one sample to the next; `None` where a mode is too fast for that.
pub(super) fn between(
    exact: &Exact,
    maps: &Maps,
    h: &BigRational,
    here: &AtSample<'_>,
) -> Option<Vec<BigRational>> {
    let plant = in_outputs(&exact.plant)?;
    let n = plant.a.len();
    let within = Between::of(&plant.moves(), n, h)?;
    let outputs = summed(&maps.outputs, here.chains);
    let parts: Vec<_> = within.parts.iter().collect();
    let count = BigRational::from_integer(parts.len().into());
    let time = |at: usize| h * BigRational::from_integer(at.into()) / &count;
    // How far the exponential is from the true one counts with all of x and u, and what follows grows with it.
    let all = [outputs.as_slice(), here.inputs].concat();
    let most = |off: Vec<BigRational>, at: usize| larger(off, &plant.off(&time(at)).on(&all));
    let off = (1..parts.len()).fold(vec![BigRational::default(); n], most);
    let grown = sizes_of(&plant).held(h)?.phi.on(&off);
    let off: Vec<_> = both(grown.clone(), &both(grown, &off));
    let seen = |row: &[BigRational]| seen(maps, here, row);
    let start = |at: usize| -> Vec<BigRational> {
        if at == 0 || at == parts.len() {
            return outputs.clone();
        }
        parts[at].start.rows().iter().zip(&off).map(|(row, off)| seen(row) + off).collect()
    };
    let ends: Vec<_> = (0..=parts.len()).map(start).collect();
    let mut most = outputs.clone();
    for (at, part) in parts.iter().enumerate() {
        let rest = within.rest.on(&[ends[at].as_slice(), here.inputs].concat());
        for i in 0..n {
            let inner = part.inner[i].iter().map(|row| seen(row) + &off[i]);
            let reached = inner.chain([ends[at][i].clone(), ends[at + 1][i].clone()]).max();
            // The last control point is off by the rest, too.
            let reached = reached.unwrap_or_default() + &rest[i] + &rest[i];
            most[i] = reached.max(most[i].clone());
        }
    }
    Some(most)
}

/// A sum over the outputs with their derivatives and u.
fn seen(maps: &Maps, here: &AtSample<'_>, row: &[BigRational]) -> BigRational {
    let (x, u) = row.split_at(maps.outputs.len());
    let (x, u) = (Matrix::of(vec![x.to_vec()]), Matrix::of(vec![u.to_vec()]));
    let one = BigRational::from_integer(1.into());
    let of_chains = x.times(&maps.outputs).plus(&one, &u.times(&maps.of_chains));
    let parts = [
        summed(&of_chains, here.chains),
        summed(&u.times(&maps.inverse), here.wanted),
        summed(&u, here.errors),
    ];
    parts.into_iter().flatten().sum()
}

/// The plant in its outputs and their derivatives.
fn in_outputs(plant: &Several) -> Option<Several> {
    let derivatives = plant.derivatives();
    let back = derivatives.inverse()?;
    let of = |rows: &[Vec<BigRational>]| Matrix::of(rows.to_vec());
    Some(Several {
        a: derivatives.times(&of(&plant.a)).times(&back).rows().to_vec(),
        b: derivatives.times(&of(&plant.b)).rows().to_vec(),
        c: of(&plant.c).times(&back).rows().to_vec(),
        orders: plant.orders.clone(),
    })
}

/// The plant of the sizes of its entries.
fn sizes_of(plant: &Several) -> Several {
    let sizes = |rows: &[Vec<BigRational>]| {
        rows.iter().map(|row| row.iter().map(Signed::abs).collect()).collect()
    };
    Several { a: sizes(&plant.a), b: sizes(&plant.b), ..plant.clone() }
}

fn larger(a: Vec<BigRational>, b: &[BigRational]) -> Vec<BigRational> {
    a.into_iter().zip(b).map(|(a, b)| a.max(b.clone())).collect()
}
