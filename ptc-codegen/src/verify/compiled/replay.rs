//! The samples of runs that are done, side by side, as an observer of lanes sees them.

use crate::emit::campaign::Sizes;
use crate::parameter::Parameter;
use crate::program::lanes::{LANES, Pack};
use crate::simulate::lanes::{Instants, Sampling, See};

/// A run that is done.
pub(super) struct Run<'a> {
    pub(super) index: usize,
    pub(super) job: &'a Sampling<'a>,
    pub(super) samples: usize,
    /// Its states and inputs, sample by sample.
    pub(super) numbers: &'a [f64],
}

/// States and inputs of all lanes at a sample.
pub(super) struct Replay {
    x: Vec<Pack>,
    u: Vec<Pack>,
}

/// Times of a run after t0, in s.
#[derive(Clone, Copy)]
struct Times {
    period: f64,
    end: f64,
    tau: f64,
}

impl Replay {
    pub(super) fn new(sizes: &Sizes) -> Self {
        let none = Pack::all(0.0);
        Self { x: vec![none; sizes.states], u: vec![none; sizes.inputs] }
    }

    /// Hands over all samples of the runs, of each in order.
    pub(super) fn all(&mut self, runs: &[Run<'_>], see: See<'_>) {
        for runs in runs.chunks(LANES) {
            self.some(runs, &mut *see);
        }
    }

    fn some(&mut self, runs: &[Run<'_>], see: See<'_>) {
        let times: Vec<_> = runs.iter().map(Run::times).collect();
        let columns = self.x.len() + self.u.len();
        let most = runs.iter().map(|run| run.samples).max().unwrap_or(0);
        let (mut jobs, mut last) = ([None; LANES], [false; LANES]);
        let mut time_to_go = Pack::all(1.0);
        for k in 0..most {
            #[allow(clippy::cast_precision_loss)]
            let index = k as f64;
            for (lane, (run, Times { period, end, tau })) in runs.iter().zip(&times).enumerate() {
                jobs[lane] = (k < run.samples).then_some(run.index);
                last[lane] = k + 1 == run.samples;
                if k >= run.samples {
                    continue;
                }
                time_to_go.0[lane] = tau - if last[lane] { *end } else { index * period };
                let sample = &run.numbers[k * columns..(k + 1) * columns];
                let packs = self.x.iter_mut().chain(&mut self.u);
                packs.zip(sample).for_each(|(pack, own)| pack.0[lane] = *own);
            }
            see(&Instants { jobs, last, time_to_go: &time_to_go, x: &self.x, u: &self.u });
        }
    }
}

impl Run<'_> {
    fn times(&self) -> Times {
        let Sampling { around, values, .. } = self.job;
        let tau = values.get(Parameter::Tau);
        Times { period: around.period, end: around.end(tau), tau }
    }
}
