//! Runge and Kutta's method of order 4, for closed loops by hand.

/// The rates of all states by time and state.
pub(crate) type Rates<'a> = &'a dyn Fn(f64, &[f64]) -> Vec<f64>;

/// The state a time `h` after `t`.
pub(crate) fn advance(rates: Rates<'_>, (t, h): (f64, f64), x: &[f64]) -> Vec<f64> {
    let (mut sum, mut slope) = (vec![0.0; x.len()], vec![0.0; x.len()]);
    for (part, weight) in [(0.0, 1.0), (0.5, 2.0), (0.5, 2.0), (1.0, 1.0)] {
        let at: Vec<_> = x.iter().zip(&slope).map(|(x, k)| x + part * h * k).collect();
        slope = rates(t + part * h, &at);
        sum.iter_mut().zip(&slope).for_each(|(sum, k)| *sum += weight * k);
    }
    x.iter().zip(&sum).map(|(x, sum)| x + h / 6.0 * sum).collect()
}

/// The states at the times of `grid`, the first of which is that of `x0`, in so many parts between two.
pub(crate) fn along(rates: Rates<'_>, (grid, parts): (&[f64], u32), x0: &[f64]) -> Vec<Vec<f64>> {
    let mut all = vec![x0.to_vec()];
    for pair in grid.windows(2) {
        let h = (pair[1] - pair[0]) / f64::from(parts);
        let step = |x: Vec<f64>, i: u32| advance(rates, (pair[0] + f64::from(i) * h, h), &x);
        let start = all[all.len() - 1].clone();
        all.push((0..parts).fold(start, step));
    }
    all
}
