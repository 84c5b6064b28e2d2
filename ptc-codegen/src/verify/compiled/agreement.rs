//! Runs of the compiled program beside those of the interpreter.

use crate::simulate::lanes::{Instants, Sampling, See};

/// Difference of scenarios that were run both ways.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// Number of scenarios that came to their end.
    pub scenarios: usize,
    /// Largest difference of a state or an input, as a part of its largest value in the run; 0 where all have the same
    /// bits, and infinite where one of two runs alone came to its end.
    pub difference: f64,
}

/// Runner of scenarios.
pub(in crate::verify) type Runner<'a> =
    &'a mut dyn FnMut(&[Sampling<'_>], See<'_>) -> Option<Vec<bool>>;

/// Runs scenarios both ways; `None` where one of these runs none.
pub(in crate::verify) fn agreement(
    jobs: &[Sampling<'_>],
    one: Runner<'_>,
    other: Runner<'_>,
) -> Option<Agreement> {
    let runs = recorded(jobs, one)?.into_iter().zip(recorded(jobs, other)?);
    let mut found = Agreement { scenarios: 0, difference: 0.0 };
    for (one, other) in runs {
        let (own, difference) = match (one, other) {
            (Some(one), Some(other)) => (1, difference(&one, &other)),
            (None, None) => (0, 0.0),
            _ => (0, f64::INFINITY),
        };
        found.scenarios += own;
        found.difference = found.difference.max(difference);
    }
    Some(found)
}

/// The samples of a run: times-to-go, states and inputs.
type Samples = Vec<Vec<f64>>;

fn recorded(jobs: &[Sampling<'_>], run: Runner<'_>) -> Option<Vec<Option<Samples>>> {
    let mut all: Vec<Samples> = vec![Vec::new(); jobs.len()];
    let done = run(jobs, &mut |instants: &Instants<'_>| {
        let Instants { jobs, time_to_go, x, u, .. } = instants;
        for (lane, job) in jobs.iter().enumerate() {
            if let Some(job) = *job {
                let packs = std::iter::once(*time_to_go).chain(*x).chain(*u);
                all[job].push(packs.map(|pack| pack.0[lane]).collect());
            }
        }
    })?;
    Some(all.into_iter().zip(done).map(|(own, done)| done.then_some(own)).collect())
}

/// Largest difference of two runs.
fn difference(one: &Samples, other: &Samples) -> f64 {
    if one.len() != other.len() {
        return f64::INFINITY;
    }
    let columns = one.first().map_or(0, Vec::len);
    let mut worst: f64 = 0.0;
    for column in 0..columns {
        let (mut apart, mut size): (f64, f64) = (0.0, f64::MIN_POSITIVE);
        for (a, b) in one.iter().zip(other).map(|(one, other)| (one[column], other[column])) {
            size = size.max(a.abs());
            if a.to_bits() != b.to_bits() {
                apart = apart.max((a - b).abs()).max(f64::MIN_POSITIVE);
            }
        }
        worst = worst.max(apart / size);
    }
    worst
}
