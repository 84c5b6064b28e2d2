//! e^(A s) and its integral over s, in doubles: summed for a part of s in which ||A s|| is small, and doubled,
//! F(2 s) = (I + E) F, E(2 s) = E E.

/// A matrix, by rows.
pub(crate) type Rows = Vec<Vec<f64>>;

/// ||A s|| from which the series needs no more than [`TERMS`] for all digits.
const SMALL: f64 = 0.5;
const TERMS: u32 = 18;

/// Doublings above which the sum has lost too many digits.
const DOUBLINGS: i32 = 20;

/// E = e^(A s) and F, the integral of E from 0 to s, of a square A, whose rows may go on with what does not
/// count; `None` where ||A s|| is beyond what keeps its digits.
pub(crate) fn flow(a: &Rows, length: f64) -> Option<(Rows, Rows)> {
    let n = a.len();
    let norm = norm(a) * length;
    let doublings = (0..=DOUBLINGS).find(|k| norm * 0.5_f64.powi(*k) <= SMALL)?;
    let part = length * 0.5_f64.powi(doublings);
    let add_unit =
        |matrix: &mut Rows| matrix.iter_mut().enumerate().for_each(|(i, row)| row[i] += 1.0);
    // F = s (I + A s/2 (I + A s/3 (...))).
    let (mut sum, mut next) = (vec![vec![0.0; n]; n], vec![vec![0.0; n]; n]);
    add_unit(&mut sum);
    for term in (1..=TERMS).rev() {
        product(a, &sum, &mut next);
        let factor = part / f64::from(term);
        next.iter_mut().flatten().for_each(|value| *value *= factor);
        if term == 1 {
            break;
        }
        add_unit(&mut next);
        std::mem::swap(&mut sum, &mut next);
    }
    let (mut whole, mut integral) = (next, sum);
    integral.iter_mut().flatten().for_each(|value| *value *= part);
    add_unit(&mut whole);
    let mut more = vec![vec![0.0; n]; n];
    for _ in 0..doublings {
        product(&whole, &integral, &mut more);
        integral.iter_mut().flatten().zip(more.iter().flatten()).for_each(|(a, b)| *a += b);
        product(&whole, &whole, &mut more);
        std::mem::swap(&mut whole, &mut more);
    }
    Some((whole, integral))
}

/// ||A||, the largest row sum.
pub(crate) fn norm(a: &Rows) -> f64 {
    let row = |row: &Vec<f64>| row[..a.len()].iter().map(|a| a.abs()).sum::<f64>();
    a.iter().map(row).fold(0.0, f64::max)
}

/// The product with a matrix; columns of the left one beyond its rows do not count.
fn product(left: &Rows, right: &Rows, into: &mut Rows) {
    for (row, own) in left.iter().zip(into) {
        for (j, own) in own.iter_mut().enumerate() {
            *own = row.iter().zip(right).map(|(a, b)| a * b[j]).sum();
        }
    }
}
