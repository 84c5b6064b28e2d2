//! The gate of an observer in a loop: whether every good reading is believed, and what one costs that is not.
//!
//! A sample in which the innovation v_l of a measurement is another one by w_l is a measurement error w_l in that sample
//! alone, as the law sees measurements by their innovations. A lost reading has v = 0 in place of the innovation of the
//! undisturbed loop; one that is wild and believed anything up to the gate. So |w| is at most the bound of the
//! innovations, and the gate more. The rows of the worst case give what w moves, at the worst sample. The loop is linear
//! only as long as the readings that follow are believed, so that these are bounded too.

use super::chain::{Near, Row, along};
use super::reach::Reach;
use super::trust::Trust;
use super::way::larger;
use super::worst::{Output, Sampled, earlier};
use crate::check::sampled::moved::real;

/// Operations that the bounds may take: seconds.
const OPERATIONS: f64 = 1e9;

/// Limits within which an observer believes a reading.
#[derive(Clone, Debug)]
pub(super) struct Gate {
    /// Bound of each |y|; infinite without.
    pub(super) range: Vec<f64>,
    /// Bound of each |y - predicted y|; infinite without.
    pub(super) innovation: Vec<f64>,
}

/// Behaviour of the gate of an observer until the deadline.
#[derive(Clone, Debug, PartialEq)]
pub struct Gating {
    /// Bound of each |y|.
    pub readings: Vec<f64>,
    /// Bound of each |y - predicted y|; empty for an observer that cannot predict alone.
    pub innovations: Vec<f64>,
    /// Cost of one lost reading; `None` for an observer that cannot predict alone.
    pub lost: Option<Cost>,
    /// Cost of one wild reading within the gate; `None` without a bound of the innovation.
    pub wild: Option<Cost>,
}

/// Upper bounds of the effect of one reading.
#[derive(Clone, Debug, PartialEq)]
pub struct Cost {
    /// To each |x_i| at the deadline.
    pub x: Vec<f64>,
    /// To |u| on the way.
    pub u: f64,
    /// Bounds of the later innovations, those of the undisturbed loop included.
    pub innovations: Vec<f64>,
}

impl Gating {
    /// The larger of two bounds.
    pub(super) fn most(self, other: &Self) -> Self {
        let both = |a: Option<Cost>, b: &Option<Cost>| Some(a?.most(b.as_ref()?));
        Self {
            readings: larger(self.readings, &other.readings),
            innovations: larger(self.innovations, &other.innovations),
            lost: both(self.lost, &other.lost),
            wild: both(self.wild, &other.wild),
        }
    }
}

impl Cost {
    fn most(self, other: &Self) -> Self {
        Self {
            x: larger(self.x, &other.x),
            u: self.u.max(other.u),
            innovations: larger(self.innovations, &other.innovations),
        }
    }
}

/// Effect of one lost and of one wild reading on a loop at each sample: bounds of its states, of the acting input and
/// of the errors.
#[derive(Default)]
struct Moved {
    states: Vec<[Vec<f64>; 2]>,
    acting: Vec<[f64; 2]>,
    inexact: Vec<[Vec<f64>; 2]>,
}

/// Largest change of the innovation of each measurement at each sample, by a lost and by a wild reading.
type Hits = [Vec<Vec<f64>>; 2];

impl Sampled {
    /// Bounds the behaviour of the gate up to sample `last`; `None` without a gate, and where too much is to be bounded
    /// or the times of the samples are not known.
    pub(super) fn gating(&self, last: usize, reach: Option<&Reach>) -> Option<Gating> {
        let gate = self.gate.as_ref()?;
        let reach = reach.filter(|_| self.late.is_none())?;
        (2.0 * self.operations(last) <= OPERATIONS).then_some(())?;
        let sensors = 0..gate.range.len();
        let most = |of: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
            let over = |l: usize| (0..=last).map(|k| of(l, k)).fold(0.0, f64::max);
            sensors.clone().map(over).collect()
        };
        let readings = most(&|l, k| self.reading(l, k, reach));
        if self.walk(true).at(0).innovations.is_empty() {
            return Some(Gating { readings, innovations: Vec::new(), lost: None, wild: None });
        }
        let at: Vec<Vec<f64>> = (0..=last)
            .map(|k| sensors.clone().map(|l| self.innovation(l, k, reach)).collect())
            .collect();
        let innovations = most(&|l, k| at[k][l]);
        let beyond =
            |own: &Vec<f64>| own.iter().zip(&gate.innovation).map(|(m, g)| m + g).collect();
        let wild: Vec<Vec<f64>> = at.iter().map(beyond).collect();
        let is_bounded = wild[0].iter().all(|most| most.is_finite());
        let hits = [at.clone(), if is_bounded { wild } else { at.clone() }];
        let [lost, wild] = self.costs(last, &at, &hits);
        Some(Gating { readings, innovations, lost: Some(lost), wild: is_bounded.then_some(wild) })
    }

    /// Bound of |y_l| at sample `k`.
    fn reading(&self, l: usize, k: usize, reach: &Reach) -> f64 {
        let mut one = vec![(0.0, 0.0); self.noise.len()];
        one[l] = (1.0, 0.0);
        let of_state = self.chain.of_states(&one);
        self.value_of(&Row { of_state, of_cause: one }, 0.0, k, reach)
    }

    /// Bound of |y_l - predicted y_l| at sample `k`, where every reading is believed.
    fn innovation(&self, l: usize, k: usize, reach: &Reach) -> f64 {
        let mut walk = self.walk(true);
        let (row, lost) = &walk.at(k).innovations[l];
        self.value_of(row, *lost, k, reach)
    }

    /// Bounds a value over the states and the causes of sample `k`, plus its part `lost`.
    fn value_of(&self, row: &Row, lost: f64, k: usize, reach: &Reach) -> f64 {
        let output = self.output(row);
        let states = &reach.states[k];
        let off = row.of_state.iter().zip(states).map(|((_, error), x)| error * x).sum::<f64>();
        let limits = self.noise.iter().chain([&self.actuator]);
        let causes = row.of_cause.iter().zip(limits);
        let causes = causes.map(|((value, error), most)| (value.abs() + error) * most);
        let bound = self.bound(&output, k, Some(Trust::Reach(reach))).total();
        (bound + off + causes.sum::<f64>() + lost) * ROUNDED
    }

    /// The row of a value over the states, as an output.
    fn output(&self, row: &Row) -> Output {
        let mut values: Vec<_> = row.of_state.iter().map(|(value, _)| *value).collect();
        values.resize(self.size(), 0.0);
        Output { row: values, direct: 0.0, change: false }
    }

    /// Computes the cost of one reading after the first; `innovations` are those of the undisturbed loop.
    fn costs(&self, last: usize, innovations: &[Vec<f64>], hits: &Hits) -> [Cost; 2] {
        let mut moved = Moved::default();
        let mut walk = self.walk(true);
        let (mut u, mut reached) = ([0.0_f64; 2], [0, 1].map(|_| vec![0.0; innovations[0].len()]));
        for (k, good) in innovations.iter().enumerate() {
            let peak = |output: &Output, moved: &Moved| self.peak(output, k, hits, moved);
            let peaks: Vec<_> = (1..=self.size()).map(|i| peak(&self.state(i), &moved)).collect();
            moved.states.push([0, 1].map(|which| peaks.iter().map(|own| own[which]).collect()));
            for (l, (row, _)) in walk.at(k).innovations.iter().enumerate() {
                let echo = peak(&self.output(row), &moved);
                for (which, states) in moved.states[k].iter().enumerate() {
                    let off = row.of_state.iter().zip(states).map(|((_, error), x)| error * x);
                    let all = good[l] + echo[which] + off.sum::<f64>();
                    reached[which][l] = f64::max(reached[which][l], all * ROUNDED);
                }
            }
            if k < last {
                let own = peak(&self.control(), &moved);
                u = [u[0].max(own[0]), u[1].max(own[1])];
            }
            let acting = match self.gain_error > 0.0 {
                true => peak(&self.acts(), &moved),
                false => [0.0; 2],
            };
            let inexact = [0, 1]
                .map(|which| self.inexact(walk.at(k), &moved.states[k][which], acting[which]));
            moved.inexact.push(inexact);
            moved.acting.push(acting);
        }
        [0, 1].map(|which| Cost {
            x: moved.states[last][which][..self.chain.moved].to_vec(),
            u: u[which],
            innovations: std::mem::take(&mut reached[which]),
        })
    }

    /// The most by which one reading before sample `at`, or in it where the output has u in it, moves an output.
    fn peak(&self, output: &Output, at: usize, hits: &Hits, moved: &Moved) -> [f64; 2] {
        let mut row = self.row(output, at);
        let (mut room, mut most, mut off) = (vec![0.0; self.size()], [0.0_f64; 2], [0.0; 2]);
        let mut walk = self.walk(true);
        if output.direct != 0.0 && at > 0 {
            let (u, weight) = (&walk.at(at).u, output.direct.abs());
            for which in 0..2 {
                let errors = u.of_state.iter().zip(&moved.states[at][which]);
                off[which] += weight * errors.map(|((_, error), x)| error * x).sum::<f64>();
                let own = u.of_cause.iter().zip(&hits[which][at]);
                let own = own.map(|((value, error), w)| (value.abs() + error) * w);
                most[which] = weight * own.sum::<f64>();
            }
        }
        for k in (1..at).rev() {
            let step = walk.at(k);
            let input = size_of(&row, &self.chain.input) * self.gain_error;
            let mut hit = [0.0; 2];
            for (l, column) in step.columns[..hits[0][k].len()].iter().enumerate() {
                let seen = size_of(&row, column);
                hit = [0, 1].map(|which| hit[which] + seen * hits[which][k][l]);
            }
            for which in 0..2 {
                most[which] = most[which].max(hit[which]);
                let inexact = row.iter().zip(&moved.inexact[k][which]);
                off[which] += inexact.map(|(p, own)| p.abs() * own).sum::<f64>();
                if self.gain_error > 0.0 {
                    off[which] += input * moved.acting[k][which];
                }
            }
            earlier(&step.matrix, &mut row, &mut room);
        }
        [0, 1].map(|which| (most[which] + off[which]) * (ROUNDED + real(at + 64) * f64::EPSILON))
    }
}

/// The size of what a row sees of a column, whose entries are near the true ones.
fn size_of(row: &[f64], column: &[Near]) -> f64 {
    let off = row
        .iter()
        .zip(column)
        .map(|(p, (value, error))| p.abs() * (error + 16.0 * f64::EPSILON * value.abs()));
    along(row, column).abs() + off.sum::<f64>()
}

/// Factor above the rounding of a few thousand operations in doubles.
const ROUNDED: f64 = 1.0 + 1e-12;
