//! Bounds against loops that are run.

use num_traits::ToPrimitive;

use super::{Horizon, Peak, Plan, Signal};
use crate::algebra::{BigRational, integer};
use crate::linear::Pair;

/// A double integrator or a longer chain with a period of 1, in flat coordinates.
struct Chain {
    drift: Vec<BigRational>,
    s: Vec<Vec<f64>>,
    back: Vec<Vec<BigRational>>,
}

impl Chain {
    fn new(n: usize, late: usize) -> Self {
        let one = integer(1);
        let pair = Pair::chain(n, &one, &one).delayed(late);
        let (s, drift) = pair.flat().expect("controllable");
        let back = s.inverse().expect("regular");
        let number = |row: &Vec<BigRational>| {
            row.iter().map(|own| own.to_f64().unwrap_or(f64::NAN)).collect()
        };
        Self { drift, s: s.rows().iter().map(number).collect(), back: back.rows().to_vec() }
    }

    fn plan(&self, least: u32, end: Option<(u32, u32)>, held: i64, states: &[usize]) -> Horizon {
        let states = states.iter().map(|i| (*i, self.back[*i].clone())).collect();
        let held = integer(held);
        Horizon::new(&Plan { drift: &self.drift, least, end, held: held.clone(), states })
            .unwrap_or_else(|| panic!("a plan {least} {end:?} {held} {:?}", self.drift))
    }

    fn coordinates(&self, x: &[f64]) -> Vec<f64> {
        self.s.iter().map(|row| row.iter().zip(x).map(|(a, b)| a * b).sum()).collect()
    }
}

/// The gains with `left` samples to go, of the coordinates.
fn gains(horizon: &Horizon, left: u32) -> Vec<f64> {
    let left = left.max(horizon.rest());
    let found = horizon.stretches.iter().find(|stretch| left > stretch.above);
    let course = &found.unwrap_or(&horizon.stretches[horizon.stretches.len() - 1]).course;
    let gains = super::gains(course, &integer(left.into())).expect("gains");
    gains.iter().map(|gain| gain.to_f64().unwrap_or(f64::NAN)).collect()
}

/// The greatest sizes of u and of a state in the loop that is run, and of the last coordinates.
fn run(chain: &Chain, horizon: &Horizon, x: &[f64], left: u32) -> ([f64; 2], f64) {
    let mut z = chain.coordinates(x);
    let order = z.len();
    let number = |own: &BigRational| own.to_f64().unwrap_or(f64::NAN);
    let [mut most, mut state] = [0.0_f64; 2];
    let last = gains(horizon, 0);
    for k in 0..left + 100 {
        let gains = match left.saturating_sub(k) {
            left if left > horizon.rest() => gains(horizon, left),
            _ => last.clone(),
        };
        let u: f64 = gains.iter().zip(&z).map(|(gain, z)| gain * z).sum();
        let second: f64 = chain.back[1].iter().zip(&z).map(|(own, z)| number(own) * z).sum();
        most = most.max(u.abs());
        state = state.max(second.abs());
        let drift: f64 = chain.drift.iter().zip(&z).map(|(a, z)| number(a) * z).sum();
        let last = z[order - 1] + drift + u;
        for i in 0..order - 1 {
            z[i] += z[i + 1];
        }
        z[order - 1] = last;
    }
    ([most, state], z.iter().fold(0.0, |most, z| most.max(z.abs())))
}

fn most(values: &[Peak], signal: Signal) -> f64 {
    let own = values.iter().filter(|own| own.signal == signal).map(|own| own.value.abs());
    own.fold(0.0, f64::max)
}

#[test]
fn bounds_hold_the_loops_that_are_run() {
    let states = [vec![1.0, 0.02, 0.003], vec![-0.4, 0.11, -0.01]];
    for n in 2..=3 {
        for weight in [0, 2] {
            for (end, held) in [(None, 0), (None, 8), (Some(20), 0), (Some(20), 8)] {
                for late in [0, 1] {
                    let order = u32::try_from(n + late).expect("small");
                    let chain = Chain::new(n, late);
                    let end = end.map(|samples| (samples, order + weight + 1));
                    let horizon = chain.plan(order + weight, end, held, &[1]);
                    assert!(horizon.slack < 1e9, "{n} {weight}: {}", horizon.slack);
                    for x in &states {
                        let mut x = x[..n].to_vec();
                        x.extend(vec![0.01; late]);
                        for left in [4, 9, 20, 21, 60] {
                            if left < order {
                                continue;
                            }
                            let z = chain.coordinates(&x);
                            let values = horizon.values(&z, left);
                            let ([u, state], rest) = run(&chain, &horizon, &x, left);
                            let bounds =
                                [most(&values, Signal::Input), most(&values, Signal::State(1))];
                            let about = format!("{n} {weight} {end:?} {held} {late} {x:?} {left}");
                            assert!(u <= bounds[0] * (1.0 + 1e-9), "u of {about}: {u} {bounds:?}");
                            assert!(
                                state <= bounds[1] * (1.0 + 1e-9),
                                "x2 of {about}: {state} {bounds:?}"
                            );
                            assert!(rest < 1e-3, "rest of {about}: {rest}");
                            let exact = n == 2 && weight == 0 && late == 0 && end.is_none();
                            if exact && left > horizon.rest() {
                                assert!(bounds[0] <= u * 1.021, "{about}: {u} {bounds:?}");
                            }
                            if left > 2 * horizon.rest() && late == 0 {
                                assert!(bounds[0] <= u * 1.6, "near {about}: {u} {bounds:?}");
                            }
                        }
                    }
                }
            }
        }
    }
}
