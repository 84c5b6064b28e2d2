//! Radau's nodes and what collocation at them is made of, by arithmetic alone: the same on any machine.

/// Nodes of a step, the last of which is its end. With them a step is L-stable, and of order 23 at its end.
pub(super) const NODES: usize = 12;

/// A number for each node.
type Row = [f64; NODES];

/// Collocation on a step of length 1.
#[derive(Clone, Debug)]
pub(super) struct Nodes {
    /// Places of the nodes.
    pub(super) places: Row,
    /// Integrals from 0 to each node, of the polynomial with these values at the nodes.
    pub(super) integrals: [Row; NODES],
    /// The same, column by column.
    pub(super) by_column: [Row; NODES],
    /// Its powers: the integrals of integrals, from the first on.
    pub(super) powers: Vec<[Row; NODES]>,
    /// The last two coefficients of that polynomial in Legendre's, the highest first.
    pub(super) tail: [Row; 2],
    /// Barycentric weights of 0 and the nodes.
    pub(super) weights: [f64; NODES + 1],
}

impl Nodes {
    /// With as many powers as a chain is long.
    pub(super) fn new(powers: usize) -> Self {
        let points = points();
        let order = number(NODES);
        let legendre = points.map(legendre);
        // Of Radau's quadrature over [-1, 1], which is exact up to degree 2 NODES - 2: the coefficients
        // of a polynomial are its products with Legendre's at the nodes.
        let quadrature: Row =
            std::array::from_fn(|l| (1.0 + points[l]) / (order * legendre[l][NODES - 1]).powi(2));
        let coefficients: [Row; NODES] = std::array::from_fn(|j| {
            let factor = number(j) + 0.5;
            std::array::from_fn(|l| factor * quadrature[l] * legendre[l][j])
        });
        let integral = |l: usize, j: usize| match j.checked_sub(1) {
            None => 0.5 * (1.0 + points[l]),
            Some(before) => (legendre[l][j + 1] - legendre[l][before]) / (4.0 * number(j) + 2.0),
        };
        let places = points.map(|point| 0.5 * (1.0 + point));
        let all: [f64; NODES + 1] =
            std::array::from_fn(|l| l.checked_sub(1).map_or(0.0, |l| places[l]));
        let integrals: [Row; NODES] = std::array::from_fn(|l| {
            std::array::from_fn(|m| (0..NODES).map(|j| integral(l, j) * coefficients[j][m]).sum())
        });
        let next = |power: &[Row; NODES]| -> [Row; NODES] {
            let entry = |row: &Row, m: usize| (0..NODES).map(|j| row[j] * integrals[j][m]).sum();
            power.map(|row| std::array::from_fn(|m| entry(&row, m)))
        };
        let powers = std::iter::successors(Some(integrals), |power| Some(next(power))).take(powers);
        Self {
            powers: powers.collect(),
            places,
            integrals,
            by_column: std::array::from_fn(|m| integrals.map(|row| row[m])),
            tail: [coefficients[NODES - 1], coefficients[NODES - 2]],
            weights: std::array::from_fn(|l| {
                let others = (0..=NODES).filter(|m| *m != l);
                1.0 / others.map(|m| all[l] - all[m]).product::<f64>()
            }),
        }
    }
}

/// The zeros of P_n - P_(n-1), n = NODES, in order: 1 and those that halving finds.
fn points() -> Row {
    const PARTS: u32 = 1000;
    let value = |x: f64| {
        let all = legendre(x);
        all[NODES] - all[NODES - 1]
    };
    let place = |part: u32| -1.0 + 2.0 * f64::from(part) / f64::from(PARTS);
    let mut points = [1.0; NODES];
    let mut found = 0;
    for part in 0..PARTS - 1 {
        let (mut low, mut high) = (place(part), place(part + 1));
        let below = value(low) < 0.0;
        if below == (value(high) < 0.0) {
            continue;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let bound = if (value(middle) < 0.0) == below { &mut low } else { &mut high };
            *bound = middle;
        }
        points[found] = 0.5 * (low + high);
        found += 1;
    }
    points
}

/// Legendre's polynomials P_0..P_NODES at a point.
fn legendre(x: f64) -> [f64; NODES + 1] {
    let mut all = [1.0; NODES + 1];
    all[1] = x;
    for j in 1..NODES {
        let order = number(j);
        all[j + 1] = ((2.0 * order + 1.0) * x * all[j] - order * all[j - 1]) / (order + 1.0);
    }
    all
}

#[allow(clippy::cast_precision_loss)]
fn number(count: usize) -> f64 {
    count as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A polynomial of degree NODES - 1 is integrated, to the end one of degree 2 NODES - 2, and the tail
    /// sees nothing of a degree below its own.
    #[test]
    fn polynomials_are_integrated_exactly() {
        let nodes = Nodes::new(1);
        let sum = |row: &Row, degree: i32| -> f64 {
            row.iter().zip(nodes.places).map(|(weight, place)| weight * place.powi(degree)).sum()
        };
        for degree in 0..23 {
            for (l, row) in nodes.integrals.iter().enumerate() {
                let exact = nodes.places[l].powi(degree + 1) / f64::from(degree + 1);
                let is_exact = (sum(row, degree) - exact).abs() < 1e-14;
                assert!(is_exact || (degree > 11 && l + 1 < NODES), "{degree}, {l}");
            }
        }
        for degree in 0..12 {
            let tail = [sum(&nodes.tail[0], degree), sum(&nodes.tail[1], degree)];
            assert_eq!(tail.map(|own| own.abs() > 1e-13), [degree >= 11, degree >= 10], "{tail:?}");
        }
    }
}
