//! Vectors, rotations and placements with exact numbers.

use std::array::from_fn;

use num_traits::{One, Signed, Zero};

use super::angle::{Angle, square_root};
use super::{BITS, rounded};
use crate::algebra::{BigRational, integer};

/// A vector.
pub type Vector = [BigRational; 3];

/// A matrix, row by row.
pub type Matrix = [Vector; 3];

/// Position and orientation of a frame in another one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Placement {
    /// Rotation: the columns are the axes of the frame.
    pub rotation: Matrix,
    /// Origin of the frame.
    pub origin: Vector,
}

impl Placement {
    /// Two frames that coincide.
    pub(super) fn identity() -> Self {
        Self { rotation: unit(), origin: zero() }
    }

    /// The frame `inner` of this frame, in the outer one.
    #[must_use]
    pub(super) fn then(&self, inner: &Self) -> Self {
        let origin = sum(&self.origin, &times(&self.rotation, &inner.origin));
        Self { rotation: product(&self.rotation, &inner.rotation), origin }
    }
}

/// The rotation by fixed angles about x, y and z, one after the other.
pub(super) fn roll_pitch_yaw([roll, pitch, yaw]: &[Angle; 3]) -> Matrix {
    let about = |axis: usize, angle: &Angle| {
        let (cosine, sine) = angle.cosine_and_sine();
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut matrix = unit();
        matrix[next][next] = cosine.clone();
        matrix[last][last] = cosine;
        matrix[next][last] = -sine.clone();
        matrix[last][next] = sine;
        matrix
    };
    product(&about(2, yaw), &product(&about(1, pitch), &about(0, roll)))
}

/// A rotation that takes z to the direction of `axis`; `None` if it has no direction.
pub(super) fn toward(axis: &Vector) -> Option<Matrix> {
    let square: BigRational = axis.iter().map(|own| own * own).sum();
    if square.is_zero() {
        return None;
    }
    let is_unit = square == integer(1);
    let size = if is_unit { integer(1) } else { square_root(&square) };
    let z = axis.each_ref().map(|own| rounded_unless(own / &size, is_unit));
    // The axis of coordinates that is farthest from z.
    let x = from_fn(|i| if i == least(&z) { BigRational::one() } else { BigRational::zero() });
    let y = cross(&z, &x);
    let square: BigRational = y.iter().map(|own| own * own).sum();
    let is_unit = square == integer(1);
    let size = if is_unit { integer(1) } else { square_root(&square) };
    let y = y.map(|own| rounded_unless(own / &size, is_unit));
    let x = cross(&y, &z);
    Some(from_fn(|i| [x[i].clone(), y[i].clone(), z[i].clone()]))
}

fn rounded_unless(value: BigRational, exact: bool) -> BigRational {
    if exact { value } else { rounded(&value, BITS) }
}

fn least(vector: &Vector) -> usize {
    (0..3).min_by_key(|i| vector[*i].abs()).unwrap_or(0)
}

pub(super) fn zero() -> Vector {
    from_fn(|_| BigRational::zero())
}

pub(super) fn unit() -> Matrix {
    from_fn(|i| from_fn(|j| integer(i64::from(i == j))))
}

pub(super) fn transposed(matrix: &Matrix) -> Matrix {
    from_fn(|i| from_fn(|j| matrix[j][i].clone()))
}

pub(super) fn times(matrix: &Matrix, vector: &Vector) -> Vector {
    from_fn(|i| (0..3).map(|j| &matrix[i][j] * &vector[j]).sum())
}

pub(super) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    from_fn(|i| from_fn(|j| (0..3).map(|k| &a[i][k] * &b[k][j]).sum()))
}

pub(super) fn sum(a: &Vector, b: &Vector) -> Vector {
    from_fn(|i| &a[i] + &b[i])
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_toward_an_axis_are_rotations() {
        for axis in [[0, 0, 1], [0, 0, -1], [1, 0, 0], [0, -1, 0], [1, 2, -3]] {
            let matrix = toward(&axis.map(integer)).expect("a direction");
            let square = product(&transposed(&matrix), &matrix);
            for (i, row) in square.iter().enumerate() {
                for (j, value) in row.iter().enumerate() {
                    let off = (value - integer(i64::from(i == j))).abs();
                    assert!(off < integer(1) / integer(1 << 62), "{axis:?} {i} {j}");
                }
            }
            let z: Vector = from_fn(|i| matrix[i][2].clone());
            let along: BigRational = z.iter().zip(axis).map(|(z, own)| z * integer(own)).sum();
            assert!(
                along.is_positive()
                    && cross(&z, &axis.map(integer))
                        .iter()
                        .all(|own| { own.abs() < integer(1) / integer(1 << 60) })
            );
        }
        assert_eq!(toward(&zero()), None);
    }
}
