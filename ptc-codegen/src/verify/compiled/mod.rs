//! Scenarios of a sampled loop, run by a compiled program: the controller as it is emitted, with its plant.
//!
//! What decides a scenario is written by a [`Script`] here, and what the program gives, states and inputs at each
//! sample, is looked at as that of [lanes](crate::simulate::lanes). A process that fails harms its own scenarios alone:
//! they are run again one by one, and what fails then is left to the interpreter.

mod agreement;
mod pool;
mod replay;
mod worker;

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

pub use agreement::Agreement;
pub(super) use agreement::{Runner, agreement};

use crate::simulate::Script;
use crate::simulate::lanes::{Sampling, See};
use pool::Pool;
use replay::{Replay, Run};
use worker::{Ended, Request};

/// A program with its processes.
#[derive(Clone, Debug)]
pub(super) struct Compiled {
    script: Script,
    pool: Arc<Pool>,
    numbers: Vec<f64>,
    answer: Vec<f64>,
}

/// Most numbers of a batch in either direction, 32 MB.
const MOST: usize = 1 << 22;

/// Time within which any batch has to be answered, and what each sample adds: far more than either takes on a machine
/// that is busy.
const LIMIT: Duration = Duration::from_secs(30);
const OF_SAMPLE: Duration = Duration::from_millis(1);

/// Scenarios that are asked for together.
struct Batch {
    /// Each with its number of samples.
    jobs: Vec<(usize, usize)>,
    /// Most numbers of the answer.
    most: usize,
}

impl Compiled {
    pub(super) fn new(script: Script, program: PathBuf) -> Self {
        let pool = Arc::new(Pool::new(program));
        Self { script, pool, numbers: Vec::new(), answer: Vec::new() }
    }

    /// Returns how the processes of scenarios ended that ended them.
    pub(super) fn faults(&self) -> Vec<String> {
        self.pool.faults()
    }

    /// Runs the jobs, and hands over their samples, as lanes do. `None` where no process is to be had.
    pub(super) fn run(&mut self, jobs: &[Sampling<'_>], see: See<'_>) -> Option<Vec<bool>> {
        let mut done = vec![false; jobs.len()];
        let mut next = 0;
        while next < jobs.len() {
            if self.pool.has_given_up() {
                return None;
            }
            let (batch, after) = self.batch(jobs, next, usize::MAX);
            match self.ask(&batch) {
                Ok(()) => self.replay(jobs, &batch, see, &mut done),
                // Not one by one: each would be as late.
                Err(ended) if ended.is_late => self.pool.note(jobs[batch.jobs[0].0].x0, &ended),
                Err(_) => self.each(jobs, &batch, see, &mut done),
            }
            next = after;
        }
        (!self.pool.has_given_up()).then_some(done)
    }

    /// Runs the scenarios of a batch again, each by itself.
    fn each(&mut self, jobs: &[Sampling<'_>], batch: &Batch, see: See<'_>, done: &mut [bool]) {
        for (job, _) in &batch.jobs {
            if self.pool.has_given_up() {
                return;
            }
            let (own, _) = self.batch(jobs, *job, 1);
            match self.ask(&own) {
                Ok(()) => self.replay(jobs, &own, &mut *see, done),
                Err(ended) => self.pool.note(jobs[*job].x0, &ended),
            }
        }
    }

    /// Writes the numbers of at most so many jobs from one on, and returns them and the job after them.
    fn batch(&mut self, jobs: &[Sampling<'_>], first: usize, count: usize) -> (Batch, usize) {
        let mut batch = Batch { jobs: Vec::new(), most: 0 };
        self.numbers.clear();
        for (index, job) in jobs.iter().enumerate().skip(first) {
            let begin = self.numbers.len();
            self.numbers.push(f64::NAN);
            let Some(samples) = self.script.write(job, &mut self.numbers) else {
                self.numbers.truncate(begin);
                continue;
            };
            let answer = 1 + samples * self.columns();
            if self.numbers.len().max(batch.most + answer) > MOST && !batch.jobs.is_empty() {
                self.numbers.truncate(begin);
                return (batch, index);
            }
            #[allow(clippy::cast_precision_loss)]
            let own = (self.numbers.len() - begin) as f64;
            self.numbers[begin] = own;
            batch.jobs.push((index, samples));
            batch.most += answer;
            if batch.jobs.len() == count {
                return (batch, index + 1);
            }
        }
        (batch, jobs.len())
    }

    fn ask(&mut self, batch: &Batch) -> Result<(), Ended> {
        if batch.jobs.is_empty() {
            return Ok(());
        }
        let samples: usize = batch.jobs.iter().map(|(_, samples)| samples).sum();
        let samples = u32::try_from(samples).unwrap_or(u32::MAX);
        let limit = LIMIT + OF_SAMPLE * samples;
        let request = Request { numbers: &self.numbers, most: batch.most, limit };
        self.pool.ask(&request, &mut self.answer)
    }

    /// Hands over the samples of an answer.
    fn replay(&self, jobs: &[Sampling<'_>], batch: &Batch, see: See<'_>, done: &mut [bool]) {
        let mut answer = self.answer.as_slice();
        let mut runs = Vec::with_capacity(batch.jobs.len());
        for (index, samples) in &batch.jobs {
            let Some((finished, rest)) = answer.split_first() else { break };
            answer = rest;
            if *finished != 1.0 {
                continue;
            }
            let Some((own, rest)) = answer.split_at_checked(samples * self.columns()) else {
                break;
            };
            answer = rest;
            done[*index] = true;
            runs.push(Run { index: *index, job: &jobs[*index], samples: *samples, numbers: own });
        }
        Replay::new(self.script.sizes()).all(&runs, see);
    }

    /// Numbers of a sample: states and inputs.
    fn columns(&self) -> usize {
        self.script.sizes().states + self.script.sizes().inputs
    }
}
