//! Points of a box.

use super::Expression;

/// Points that are tried beside the middle, the ends and the corners.
const POINTS: u32 = 96;
/// Names of which all corners are tried.
const CORNERS: usize = 6;

/// A name and the numbers that it may have.
pub(crate) type Free = (Expression, f64, f64);

/// The value of each name, in the order of the box.
pub(super) type Point = Vec<f64>;

/// The middle of a box, the ends of each name with the others in the middle, its corners where they are
/// few, and points that fill it evenly (Halton's).
pub(super) fn points(free: &[Free]) -> impl Iterator<Item = Point> {
    let at = move |share: &dyn Fn(usize) -> f64| -> Point {
        let place = |(j, (_, low, high)): (usize, &Free)| {
            (low + share(j) * (high - low)).clamp(*low, *high)
        };
        free.iter().enumerate().map(place).collect()
    };
    let middle = std::iter::once(at(&|_| 0.5));
    let ends = (0..free.len())
        .flat_map(move |name| [0.0, 1.0].map(|end| at(&|j| if j == name { end } else { 0.5 })));
    let corners = if free.len() <= CORNERS { 1_u32 << free.len() } else { 2 };
    let corners = (0..corners).map(move |corner| {
        at(&|j| f64::from(if free.len() <= CORNERS { corner >> j & 1 } else { corner }))
    });
    let filling = (1..=POINTS).map(move |index| at(&|j| radical_inverse(index, prime(j))));
    middle.chain(ends).chain(corners).chain(filling)
}

/// The prime with this index, from 0.
fn prime(index: usize) -> u32 {
    let is_prime = |n: &u32| (2..*n).take_while(|d| d * d <= *n).all(|d| !n.is_multiple_of(d));
    (2..).filter(is_prime).nth(index).unwrap_or(2)
}

/// The digits of `index` in `base`, behind the point in reverse.
fn radical_inverse(mut index: u32, base: u32) -> f64 {
    let (mut value, mut scale) = (0.0, 1.0);
    while index > 0 {
        scale /= f64::from(base);
        value += scale * f64::from(index % base);
        index /= base;
    }
    value
}

/// Half-way between two points.
pub(super) fn midpoint(a: &[f64], b: &[f64]) -> Point {
    a.iter().zip(b).map(|(a, b)| f64::midpoint(*a, *b)).collect()
}

/// Returns the squared distance between two points, each coordinate relative to the width of its range.
pub(super) fn distance(free: &[Free], a: &[f64], b: &[f64]) -> f64 {
    let part = |((_, low, high), (a, b)): (&Free, (&f64, &f64))| {
        let width = high - low;
        if width > 0.0 { ((a - b) / width).powi(2) } else { 0.0 }
    };
    free.iter().zip(a.iter().zip(b)).map(part).sum()
}
