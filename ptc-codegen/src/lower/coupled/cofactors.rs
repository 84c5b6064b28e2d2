//! The inputs from a decoupling matrix of values, of at most three rows.

use super::over_determinant;
use crate::lower::builder::Builder;
use crate::lower::coefficients::Coefficient;
use crate::program::Value;

/// The inputs by the adjugate of the matrix, and the determinant that they are divided by, if it is no number.
pub(super) fn inputs(
    b: &mut Builder<'_>,
    matrix: &[Vec<Coefficient>],
    wanted: &[Value],
) -> (Vec<Value>, Option<Value>) {
    let m = matrix.len();
    let adjugate: Vec<Vec<_>> =
        (0..m).map(|i| (0..m).map(|j| cofactor(b, matrix, j, i)).collect()).collect();
    let determinant = (0..m).fold(Coefficient::integer(0), |sum, j| {
        let term = b.times(&matrix[0][j], &adjugate[j][0]);
        b.plus(&sum, &term)
    });
    let (over, divisor) = match &determinant {
        Coefficient::Exact(_) => (b.over(&Coefficient::integer(1), &determinant), None),
        Coefficient::Value(value) => {
            (Coefficient::Value(over_determinant(b, *value)), Some(*value))
        }
    };
    let mut input = |row: &Vec<Coefficient>| {
        let mut sum = Coefficient::integer(0);
        for (entry, wanted) in row.iter().zip(wanted) {
            let term = b.times(entry, &Coefficient::Value(*wanted));
            sum = b.plus(&sum, &term);
        }
        let input = b.times(&sum, &over);
        b.coefficient(&input)
    };
    (adjugate.iter().map(&mut input).collect(), divisor)
}

/// The determinant of the matrix without a row and a column, with its sign.
fn cofactor(
    b: &mut Builder<'_>,
    matrix: &[Vec<Coefficient>],
    row: usize,
    column: usize,
) -> Coefficient {
    let left: Vec<Vec<&Coefficient>> = (0..matrix.len())
        .filter(|i| *i != row)
        .map(|i| (0..matrix.len()).filter(|j| *j != column).map(|j| &matrix[i][j]).collect())
        .collect();
    let minor = match left.as_slice() {
        [] => Coefficient::integer(1),
        [one] => one[0].clone(),
        [first, second, ..] => {
            let ahead = b.times(first[0], second[1]);
            let back = b.times(first[1], second[0]);
            b.minus(&ahead, &back)
        }
    };
    if (row + column).is_multiple_of(2) { minor } else { b.negative(&minor) }
}
