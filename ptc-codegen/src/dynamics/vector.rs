//! Vectors and matrices of terms.

use std::array::from_fn;

use super::tape::{Tape, Term};
use crate::urdf;

/// A vector.
pub(super) type Vector = [Term; 3];

/// A matrix, row by row.
pub(super) type Matrix = [Vector; 3];

/// Cosine and sine of the position of a joint that turns.
#[derive(Clone, Debug)]
pub(super) struct Turn {
    pub(super) cosine: Term,
    pub(super) sine: Term,
}

pub(super) fn zero() -> Vector {
    from_fn(|_| Term::zero())
}

/// A vector that is known.
pub(super) fn known(vector: &urdf::Vector) -> Vector {
    vector.each_ref().map(Term::from)
}

/// A matrix that is known.
pub(super) fn known_matrix(matrix: &urdf::Matrix) -> Matrix {
    matrix.each_ref().map(known)
}

impl Tape {
    pub(super) fn add_vectors(&mut self, a: &Vector, b: &Vector) -> Vector {
        from_fn(|i| self.add(&a[i], &b[i]))
    }

    /// matrix vector.
    pub(super) fn apply(&mut self, matrix: &Matrix, vector: &Vector) -> Vector {
        from_fn(|i| self.products(&[0, 1, 2].map(|j| (&matrix[i][j], &vector[j]))))
    }

    /// The transposed matrix times vector.
    pub(super) fn apply_transposed(&mut self, matrix: &Matrix, vector: &Vector) -> Vector {
        from_fn(|i| self.products(&[0, 1, 2].map(|j| (&matrix[j][i], &vector[j]))))
    }

    /// a x b.
    pub(super) fn cross(&mut self, a: &Vector, b: &Vector) -> Vector {
        from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            self.products(&[(&a[j], &b[k]), (&-a[k].clone(), &b[j])])
        })
    }

    /// A vector of a body that has turned about z, in the frame before the turn.
    pub(super) fn turn(&mut self, Turn { cosine, sine }: &Turn, [x, y, z]: &Vector) -> Vector {
        let first = self.products(&[(cosine, x), (&-sine.clone(), y)]);
        let second = self.products(&[(sine, x), (cosine, y)]);
        [first, second, z.clone()]
    }

    /// The same the other way.
    pub(super) fn turn_back(&mut self, Turn { cosine, sine }: &Turn, [x, y, z]: &Vector) -> Vector {
        let first = self.products(&[(cosine, x), (sine, y)]);
        let second = self.products(&[(cosine, y), (&-sine.clone(), x)]);
        [first, second, z.clone()]
    }
}
