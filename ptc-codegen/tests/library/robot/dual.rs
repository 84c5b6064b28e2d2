//! Numbers with a derivative, and vectors and matrices of them.

use std::ops::{Add, Mul, Neg, Sub};

#[derive(Clone, Copy, Default)]
pub(super) struct Dual(pub(super) f64, pub(super) f64);

impl Add for Dual {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Self(self.0 + b.0, self.1 + b.1)
    }
}
impl Sub for Dual {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        Self(self.0 - b.0, self.1 - b.1)
    }
}
impl Mul for Dual {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        Self(self.0 * b.0, self.0 * b.1 + self.1 * b.0)
    }
}
impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

pub(super) type Vector<T> = [T; 3];
pub(super) type Matrix<T> = [[T; 3]; 3];

pub(super) fn constant(values: Vector<f64>) -> Vector<Dual> {
    values.map(|value| Dual(value, 0.0))
}

pub(super) fn dot(a: &Vector<Dual>, b: &Vector<Dual>) -> Dual {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn add(a: &Vector<Dual>, b: &Vector<Dual>) -> Vector<Dual> {
    std::array::from_fn(|i| a[i] + b[i])
}

pub(super) fn cross(a: &Vector<Dual>, b: &Vector<Dual>) -> Vector<Dual> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn apply(m: &Matrix<Dual>, v: &Vector<Dual>) -> Vector<Dual> {
    m.map(|row| dot(&row, v))
}

pub(super) fn product(a: &Matrix<Dual>, b: &Matrix<Dual>) -> Matrix<Dual> {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j])
    })
}

/// Rodrigues' rotation about a unit vector.
pub(super) fn rotation(axis: &Vector<f64>, angle: Dual) -> Matrix<Dual> {
    let (c, s) = (
        Dual(angle.0.cos(), -angle.0.sin() * angle.1),
        Dual(angle.0.sin(), angle.0.cos() * angle.1),
    );
    let [x, y, z] = constant(*axis);
    let one = Dual(1.0, 0.0);
    let t = one - c;
    [
        [t * x * x + c, t * x * y - s * z, t * x * z + s * y],
        [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
        [t * x * z - s * y, t * y * z + s * x, t * z * z + c],
    ]
}
