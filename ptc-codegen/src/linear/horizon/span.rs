//! Bounds of a signal of a loop whose gains are held, for all time.
//!
//! The signal of i samples later is r_i z with r_i = r Phi^i. A few of these rows span the others: each is a sum
//! of them whose factors add up to at most `share` in size, and that block by block: once Phi^i takes each of the few
//! into half of what they span, so does every later one.

use num_traits::ToPrimitive;

/// A row of numbers.
pub(super) type Row = Vec<f64>;

/// Rows whose bounds hold all later ones.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Span {
    /// The rows.
    pub(super) rows: Vec<Row>,
    /// The greatest sum of sizes of factors with which the rows give another one, at least 1.
    pub(super) share: f64,
    /// True if every other row is one of these or 0, as with deadbeat.
    pub(super) is_signed: bool,
}

/// Share at which no more rows are taken.
const ENOUGH: f64 = 1.02;

/// Rows beyond the order that are taken at most.
const MORE: usize = 4;

/// Part of the first row below which a later one is 0.
const ROUNDED: f64 = 1e-13;

/// Rows that are kept at most.
const LONGEST: usize = 1 << 20;

/// Operations after which a loop is given up that has not contracted, about a second.
const WORK: usize = 1 << 28;

impl Span {
    /// The span of `row` times the powers of `phi`; `None` where they do not contract.
    pub(super) fn new(row: &[f64], phi: &[Row], hint: f64) -> Option<Self> {
        let order = row.len();
        let mut all = vec![row.to_vec()];
        // A power for about each part of the time that the hold takes.
        let spacing = (hint / 4.0).ceil().max(1.0).to_usize()?;
        let first: Vec<_> = (0..order).map(|i| i * spacing).collect();
        let mut length = (first[order - 1] + 1).max(spacing * 4);
        let each = work(order);
        while length <= LONGEST && each.saturating_mul(length) <= WORK {
            later(&mut all, phi, length + first[order - 1]);
            let chosen = chosen(&all, &first, length);
            if chosen.is_empty() {
                return Some(Self { rows: Vec::new(), share: 1.0, is_signed: true });
            }
            let mut rows: Vec<_> = chosen.iter().map(|i| all[*i].clone()).collect();
            cleared(&mut rows);
            later(&mut all, phi, length + chosen.iter().max().copied().unwrap_or(0));
            let later = chosen.iter().map(|i| size(&rows, &all[i + length]));
            if later.fold(0.0, f64::max) <= 0.5 {
                let share = (0..length).map(|i| size(&rows, &all[i])).fold(1.0, f64::max);
                let is_zero = |i: usize| all[i].iter().all(|value| *value == 0.0);
                let ends = chosen.iter().all(|i| is_zero(i + length));
                let is_signed = ends && (0..length).all(|i| chosen.contains(&i) || is_zero(i));
                return share.is_finite().then_some(Self { rows, share, is_signed });
            }
            length *= 2;
        }
        None
    }
}

/// Operations for a row: with each choice of the rows a system is solved, in each round in which one is taken.
fn work(order: usize) -> usize {
    let choices = (1..=order).fold(1, |all, i| all * (order + MORE - i + 1) / i);
    choices.saturating_mul(order.pow(3)).saturating_mul(MORE + 2)
}

/// Adds rows up to number `last`. What deadbeat leaves of the first row is 0, but for rounding.
fn later(all: &mut Vec<Row>, phi: &[Row], last: usize) {
    let most = largest(&all[0]) * ROUNDED;
    while all.len() <= last {
        let mut next = times(&all[all.len() - 1], phi);
        if largest(&next) <= most {
            next.fill(0.0);
        }
        all.push(next);
    }
}

/// Rows without what rounding leaves beside other rows.
fn cleared(rows: &mut [Row]) {
    for j in 0..rows[0].len() {
        let most = rows.iter().map(|row| row[j].abs()).fold(0.0, f64::max) * ROUNDED;
        rows.iter_mut().filter(|row| row[j].abs() <= most).for_each(|row| row[j] = 0.0);
    }
}

/// The largest size in a row.
fn largest(row: &[f64]) -> f64 {
    row.iter().map(|value| value.abs()).fold(0.0, f64::max)
}

/// The rows that span the first `length` of all, beginning with some of them that are not 0, as deadbeat leaves them.
fn chosen(all: &[Row], first: &[usize], length: usize) -> Vec<usize> {
    let alive = |i: &usize| all[*i].iter().any(|value| *value != 0.0);
    let mut chosen: Vec<_> = first.iter().copied().filter(alive).collect();
    for _ in 0..MORE {
        let rows: Vec<_> = chosen.iter().map(|i| all[*i].clone()).collect();
        let sizes = (0..length).map(|i| (i, size(&rows, &all[i])));
        let worst = sizes.max_by(|a, b| a.1.total_cmp(&b.1));
        match worst {
            Some((i, size)) if size > ENOUGH && !chosen.contains(&i) => chosen.push(i),
            _ => break,
        }
    }
    chosen
}

/// The least sum of the sizes of factors with which `rows` give `row`, by trying each choice of at most as many as they
/// have columns.
fn size(rows: &[Row], row: &[f64]) -> f64 {
    if row.iter().all(|value| *value == 0.0) {
        return 0.0;
    }
    let mut least = f64::INFINITY;
    // Fewer of them are needed where the rows do not span all columns.
    for count in (1..=row.len().min(rows.len())).rev() {
        choose(rows.len(), count, 0, &mut Vec::new(), &mut |choice| {
            if let Some(factors) = factors(rows, choice, row) {
                least = least.min(factors.iter().map(|factor| factor.abs()).sum());
            }
        });
        if least.is_finite() {
            break;
        }
    }
    least
}

/// Calls `look` with every choice of `left` more of so many.
fn choose(
    count: usize,
    left: usize,
    from: usize,
    choice: &mut Vec<usize>,
    look: &mut dyn FnMut(&[usize]),
) {
    if left == 0 {
        return look(choice);
    }
    for i in from..=count.saturating_sub(left) {
        choice.push(i);
        choose(count, left - 1, i + 1, choice, look);
        choice.pop();
    }
}

/// The factors with which the chosen rows give `row`, by elimination with the largest pivot; `None` where they do not.
fn factors(rows: &[Row], choice: &[usize], row: &[f64]) -> Option<Vec<f64>> {
    let columns = row.len();
    // One equation for each column.
    let mut system: Vec<Row> = (0..columns)
        .map(|j| choice.iter().map(|i| rows[*i][j]).chain([row[j]]).collect())
        .collect();
    let unknowns = choice.len();
    for pivot in 0..unknowns {
        let best = (pivot..columns)
            .max_by(|a, b| system[*a][pivot].abs().total_cmp(&system[*b][pivot].abs()))?;
        system.swap(pivot, best);
        let lead = system[pivot].clone();
        if lead[pivot] == 0.0 {
            return None;
        }
        for (i, equation) in system.iter_mut().enumerate() {
            if i != pivot {
                let factor = equation[pivot] / lead[pivot];
                equation.iter_mut().zip(&lead).for_each(|(own, above)| *own -= factor * above);
            }
        }
    }
    // Fewer rows than columns give some rows alone.
    let left = system[unknowns..].iter().map(|equation| equation[unknowns].abs());
    if left.fold(0.0, f64::max) > 1e-12 * largest(row) {
        return None;
    }
    Some((0..unknowns).map(|i| system[i][unknowns] / system[i][i]).collect())
}

/// `row` times a matrix.
pub(super) fn times(row: &[f64], matrix: &[Row]) -> Row {
    (0..row.len())
        .map(|j| row.iter().zip(matrix).map(|(own, other)| own * other[j]).sum())
        .collect()
}
