//! The transitions of the loop from node to node, for a run of length tau_0.

use crate::linear::{Rows, flow, norm};
use crate::parameter::Parameter;
use crate::program::lanes::{LANES, Pack};
use crate::request::MAX_ORDER;
use crate::simulate::Values;
use crate::simulate::lanes::{At, LaneSide, StretchedLanes};

/// The transitions of a run of length tau_0 to its nodes.
#[derive(Debug)]
pub(super) struct Table {
    pub(super) n: usize,
    pub(super) steps: Vec<Step>,
}

/// From the node before to a node.
#[derive(Debug)]
pub(super) struct Step {
    /// T/tau of the node.
    pub(super) share: f64,
    /// The state is this times that of the node before, by rows, and `force` f.
    pub(super) transition: Vec<f64>,
    pub(super) force: Vec<f64>,
    /// u of the law is this times the state.
    pub(super) control: Vec<f64>,
}

/// Pieces over which the force is summed, for all nodes together.
const MOST: f64 = 4000.0;

/// ||A|| times the stretched time of a piece is at most this, and so long it is in sigma.
const SHORT: f64 = 1.0;
const SIGMA: f64 = 0.125;

/// Terms of e^(A s) v for ||A s|| up to 1, with room.
const TERMS: u32 = 24;

/// Gauss's quadrature over [-1, 1], the half of it that is positive: places and weights. It is exact for
/// polynomials of degree 15, so that what it leaves of a piece is below a rounding.
const GAUSS: [[f64; LANES / 2]; 2] = [
    [
        0.183_434_642_495_649_8,
        0.525_532_409_916_329,
        0.796_666_477_413_626_7,
        0.960_289_856_497_536_3,
    ],
    [
        0.362_683_783_378_362,
        0.313_706_645_877_887_3,
        0.222_381_034_453_374_5,
        0.101_228_536_290_376_3,
    ],
];

/// A node of the quadrature from the left: place in [0, 1] and weight.
fn gauss(node: usize) -> (f64, f64) {
    let half = LANES / 2;
    let (place, sign) = if node < half { (half - 1 - node, -1.0) } else { (node - half, 1.0) };
    (0.5 + 0.5 * sign * GAUSS[0][place], 0.5 * GAUSS[1][place])
}

/// A vector of as many entries as there may be states.
type Vector = [f64; MAX_ORDER];

/// The run of which the transitions are.
struct Run<'a> {
    side: &'a mut StretchedLanes,
    tau: Pack,
    t0: Pack,
    n: usize,
    /// A in units of stretched time in which its entries are about 1; xi_j is in powers of that unit.
    companion: Rows,
    rate: f64,
}

impl Table {
    /// The nodes descend from T/tau = 1. `None` where a transition is not known to its digits.
    pub(super) fn new(
        side: &mut StretchedLanes,
        (gains, rate): (&[f64], f64),
        (tau, values): (f64, &Values),
        nodes: &[f64],
        forced: bool,
    ) -> Option<Self> {
        let n = gains.len();
        let values = values.clone().with(Parameter::Tau, tau);
        for lane in 0..LANES {
            side.start(lane, &values, &vec![0.0; n]).ok()?;
        }
        side.settle();
        let scaled = |j: usize| gains[j] / rate.powi(exponent(n - j));
        let entry = |i: usize, j: usize| {
            if i + 1 == n {
                -scaled(j)
            } else if j == i + 1 {
                1.0
            } else {
                0.0
            }
        };
        let companion = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
        let t0 = Pack::all(values.get(Parameter::StartTime));
        let mut run = Run { side, tau: Pack::all(tau), t0, n, companion, rate };
        let mut left = MOST;
        let mut steps: Vec<Step> = Vec::with_capacity(nodes.len());
        for share in nodes {
            let before = steps.last().map_or(*share, |step| step.share);
            let step = run.step(before, *share, forced.then_some(&mut left))?;
            let all = step.transition.iter().chain(&step.force).chain(&step.control);
            if all.clone().any(|value| !value.is_finite()) {
                return None;
            }
            steps.push(step);
        }
        Some(Self { n, steps })
    }
}

impl Run<'_> {
    fn at(&self, share: &Pack) -> At {
        At::of((&self.tau, &self.t0), share)
    }

    /// Stretched time at some T/tau, in its units.
    fn stretched(&mut self, share: &Pack) -> Pack {
        let at = self.at(share);
        let rate = self.rate;
        self.side.stretched(&at).map(|stretched| stretched * rate)
    }

    fn step(&mut self, from: f64, to: f64, left: Option<&mut f64>) -> Option<Step> {
        let n = self.n;
        let [at, before] = [to, from].map(|share| self.at(&Pack::all(share)));
        let ends = Pack::of(|lane| if lane == 0 { from } else { to });
        let ends = self.stretched(&ends);
        let (whole, _) = flow(&self.companion, ends.0[1] - ends.0[0])?;
        let force = match left {
            Some(left) if from > to => self.force((from, to), ends.0[1] - ends.0[0], left)?,
            _ => vec![0.0; n],
        };
        let mut step = Step {
            share: to,
            transition: vec![0.0; n * n],
            force: vec![0.0; n],
            control: vec![0.0; n],
        };
        // Columns: those of the state, then that of the force.
        for first in (0..=n).step_by(LANES) {
            let unit = |i: usize| Pack::of(|lane| f64::from(u8::from(first + lane == i)));
            let units: Vec<_> = (0..n).map(unit).collect();
            let here = self.side.begin(&at, &units);
            let (_, control) = self.side.tell(&at, &here);
            let control = *control;
            let start = self.side.begin(&before, &units);
            let moved: Vec<_> = (0..n)
                .map(|i| {
                    let row: Vec<_> =
                        (0..n).map(|j| whole[i][j] * self.unit(i) / self.unit(j)).collect();
                    Pack::of(|lane| {
                        let own = row.iter().zip(&start).map(|(e, xi)| e * xi.0[lane]).sum::<f64>();
                        if first + lane == n { force[i] } else { own }
                    })
                })
                .collect();
            let (x, _) = self.side.tell(&at, &moved);
            for lane in 0..LANES {
                let column = first + lane;
                for (i, x) in x.iter().enumerate() {
                    match column {
                        column if column < n => step.transition[i * n + column] = x.0[lane],
                        column if column == n => step.force[i] = x.0[lane],
                        _ => {}
                    }
                }
                if column < n {
                    step.control[column] = control.0[lane];
                }
            }
        }
        Some(step)
    }

    /// Returns the unit of xi_(i+1), where time is in units of stretched time.
    fn unit(&self, i: usize) -> f64 {
        self.rate.powi(exponent(i))
    }

    /// xi at the end of a step of `length` that begins at rest under f = 1: the integral of
    /// e^(A (s_end - s)) e_n r_1^(n-1) over time.
    fn force(&mut self, (from, to): (f64, f64), length: f64, left: &mut f64) -> Option<Vec<f64>> {
        let n = self.n;
        let sigma = -(to / from).ln();
        let count = (norm(&self.companion) * length / SHORT).max(sigma / SIGMA).ceil();
        *left -= count;
        if left.is_nan() || *left < 0.0 {
            return None;
        }
        let unit: Vec<_> = (0..n).map(|i| Pack::all(if i + 1 == n { 1.0 } else { 0.0 })).collect();
        let mut end = self.stretched(&Pack::all(from)).0[0];
        let mut state: Vector = [0.0; MAX_ORDER];
        let mut piece = 0.0;
        while piece < count {
            let share = |part: f64| from * (-sigma * (piece + part) / count).exp();
            let inside = Pack::of(|node| share(gauss(node).0));
            let next = self.stretched(&Pack::all(share(1.0))).0[0];
            let places = self.stretched(&inside);
            let at = self.at(&inside);
            let weights = self.side.begin(&at, &unit)[n - 1];
            self.exponential(&mut state, next - end);
            for node in 0..LANES {
                let time = at.time_to_go.0[node] * gauss(node).1 * sigma / count;
                let mut moved: Vector = [0.0; MAX_ORDER];
                moved[n - 1] = weights.0[node] * time / self.unit(n - 1);
                self.exponential(&mut moved, next - places.0[node]);
                state.iter_mut().zip(moved).for_each(|(state, moved)| *state += moved);
            }
            (end, piece) = (next, piece + 1.0);
        }
        Some((0..n).map(|i| state[i] * self.unit(i)).collect())
    }

    /// e^(A s) v where ||A s|| is small; A v is v shifted by one entry, with the last row times v at its end.
    fn exponential(&self, v: &mut Vector, s: f64) {
        let n = self.n;
        let mut term = *v;
        for k in 1..=TERMS {
            let last: f64 = self.companion[n - 1].iter().zip(&term).map(|(a, v)| a * v).sum();
            term.copy_within(1..n, 0);
            term[n - 1] = last;
            let factor = s / f64::from(k);
            for (sum, term) in v[..n].iter_mut().zip(&mut term) {
                *term *= factor;
                *sum += *term;
            }
        }
    }
}

fn exponent(power: usize) -> i32 {
    i32::try_from(power).unwrap_or(i32::MAX)
}
