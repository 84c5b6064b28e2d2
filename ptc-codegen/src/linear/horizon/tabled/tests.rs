//! The bounds against every row of the way, one by one.

use super::closed::Closed;
use super::hull::Hull;
use super::*;
use crate::linear::schedule::Demand;
use crate::linear::{Linear, Pair, Weights};

fn pair(a: &[&[i64]], b: &[i64], h: (i64, i64)) -> Pair {
    let number = |value: &i64| BigRational::from_integer((*value).into());
    let plant = Linear {
        a: a.iter().map(|row| row.iter().map(number).collect()).collect(),
        b: b.iter().map(number).collect(),
        c: Vec::new(),
    };
    let h = BigRational::new(h.0.into(), h.1.into());
    Pair::linear(&plant, &h, &BigRational::from_integer(1.into())).expect("a sampled plant")
}

fn plants() -> Vec<(&'static str, Pair)> {
    vec![
        ("double integrator", pair(&[&[0, 1], &[0, 0]], &[0, 1], (1, 100))),
        ("oscillator", pair(&[&[0, 1], &[-400, 0]], &[0, 1], (1, 100))),
        ("unstable", pair(&[&[0, 1], &[9, 1]], &[0, 1], (1, 100))),
    ]
}

#[test]
fn rows_bound_every_signal_on_the_way() {
    for (name, pair) in plants() {
        for (held, samples) in [(0, 64), (20, 104)] {
            let weights = Weights { law: 0, end: None };
            let demand =
                Demand { phi: &pair.phi, gamma: &pair.gamma, weights, samples, most: None };
            let schedule = demand.schedule().expect("gains");
            let plan = Plan {
                phi: &pair.phi,
                gamma: &pair.gamma,
                schedule: &schedule,
                held,
                signals: vec![Signal::Input, Signal::State(0)],
                precision: Precision::F64,
            };
            let table = Tabled::new(&plan).expect("bounds");
            assert!((1.0..4.0).contains(&table.growth), "{name} {held}: {}", table.growth);
            let closed = Closed::new((&pair.phi, &pair.gamma), &schedule, held, Precision::F64)
                .expect("a loop");
            for rows in &table.signals {
                let own = Span::new(
                    &closed.signal(rows.signal, closed.rest),
                    &closed.step(closed.rest),
                    f64::from(closed.rest),
                );
                let own = own.expect("a stable hold");
                let held: Vec<Row> = own.rows;
                for left in closed.rest + 1..=samples {
                    let kept: Vec<Row> = table.at(rows, left).collect();
                    let in_units: Vec<Row> = kept
                        .iter()
                        .map(|row| row.iter().zip(&closed.units).map(|(a, b)| a / b).collect())
                        .collect();
                    let hull = Hull::new(closed.order(), in_units.iter());
                    let future = closed.future(rows.signal, &held, left);
                    let mut basis = hull.basis();
                    for row in future.held.iter().chain(&future.rows) {
                        let found = hull.bound(row, &mut basis).sum;
                        assert!(found <= 1.0 + 1e-9, "{name} {left}: {found}");
                    }
                }
            }
        }
    }
}
