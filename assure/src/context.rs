//! Input of a layer: the controllers of the goldens, those of every family, and random ones.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use ptc_codegen::family::Family;
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Spec;

use crate::harness::random::Random;
use crate::harness::specs::{families, random, spec};
use crate::harness::{empty, goldens, in_samples};

/// The folder of the work and the seed of what is random.
#[derive(Clone, Debug)]
pub struct Context {
    target: PathBuf,
    /// The seed of random specs and records.
    pub seed: u64,
    /// Time for which random controllers are drawn.
    pub time: Duration,
    /// True if fewer controllers are examined.
    pub brief: bool,
    /// Part of the costly work that a brief run examines: a number of the commit, so that it finds the same on any day.
    pub turn: u64,
}

/// For which the fuzzer draws controllers by default.
pub const TIME: Duration = Duration::from_secs(20);

/// In how many parts a brief run divides what is costly.
const PARTS: u64 = 7;

/// The root of the workspace.
pub fn workspace() -> &'static Path {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().unwrap_or(here)
}

/// The first digits of the commit of the workspace; `None` outside a repository.
fn commit() -> Option<u64> {
    let git = Command::new("git").args(["rev-parse", "HEAD"]).current_dir(workspace()).output();
    let commit = String::from_utf8(git.ok()?.stdout).ok()?;
    u64::from_str_radix(commit.get(..8)?, 16).ok()
}

impl Context {
    /// The context that works in the folder `assure` of cargo's `target`.
    pub fn new(target: &Path, seed: u64) -> Self {
        let turn = commit().unwrap_or_default();
        Self { target: target.to_owned(), seed, time: TIME, brief: false, turn }
    }

    /// The greatest order of the families that a layer examines, `full` where the run is not brief.
    pub fn order(&self, full: usize) -> usize {
        if self.brief { full.min(2) } else { full }
    }

    /// In how many parts a run divides what is costly.
    pub fn parts(&self) -> u64 {
        if self.brief { PARTS } else { 1 }
    }

    /// The part of `all` whose turn it is in a brief run; else all. Never none of them.
    pub fn in_turn<T>(&self, all: Vec<T>) -> Vec<T> {
        let parts = self.parts().min(all.len() as u64);
        let due = |(index, _): &(u64, T)| index.is_multiple_of(parts);
        (self.turn..).zip(all).filter(due).map(|(_, one)| one).collect()
    }

    /// `full` records of each controller, a quarter of them in a brief run.
    pub fn records(&self, full: usize) -> usize {
        if self.brief { full / 4 } else { full }
    }

    /// An empty folder of a layer's own.
    pub fn scratch(&self, name: &str) -> PathBuf {
        empty(&self.target.join("assure").join(name))
    }

    /// A folder whose contents one run leaves to the next, for builds.
    pub fn shared(&self, name: &str) -> PathBuf {
        self.target.join("assure/builds").join(name)
    }

    /// Cargo's own folder, where what other builds compiled serves again.
    pub fn target(&self) -> &Path {
        &self.target
    }

    /// The controllers of generated/.
    pub fn goldens(&self) -> Vec<Spec> {
        goldens::controllers()
    }

    /// Every family, power with m = 2 beside power, of the orders 1 to `greatest` in both
    /// precisions, with a name of its own.
    pub fn families(&self, greatest: usize) -> Vec<Spec> {
        let mut all = Vec::new();
        for precision in [Precision::F64, Precision::F32] {
            for n in 1..=greatest {
                let suffix = if precision == Precision::F32 { "_f32" } else { "" };
                for family in families() {
                    let name = format!("ptc_{}{n}{suffix}", family.name());
                    all.push(Spec { precision, name: Some(name), ..Spec::new(n, family) });
                }
                let keys = [("n", &*n.to_string()), ("mu", "power(m=2)")];
                let name = format!("ptc_square{n}{suffix}");
                all.push(Spec { precision, name: Some(name), ..spec(&keys) });
            }
        }
        all
    }

    /// Controllers with a clock in samples, and observers alone, of every kind.
    pub fn in_samples(&self) -> Vec<Spec> {
        in_samples::controllers()
    }

    /// Infinite-time systems: with gains, with a user-defined law, with latched states.
    pub fn systems(&self) -> Vec<Spec> {
        let laws: [&[(&str, &str)]; 3] =
            [&[], &[("pi0", "extern")], &[("pi0", "-xi1 - 2*xi2*xi1_0")]];
        let named = |(index, law): (usize, &&[(&str, &str)])| {
            let name = format!("system{index}");
            let keys = [("n", "2"), ("mu", "tanh"), ("what", "associated"), ("name", &*name)];
            spec(&[&keys, *law].concat())
        };
        laws.iter().enumerate().map(named).collect()
    }

    /// `count` random controllers, the same for the same seed; a quarter of them in a brief run.
    pub fn random(&self, count: usize) -> Vec<Spec> {
        let mut source = Random(self.seed);
        let count = if self.brief { count / 4 } else { count };
        (0..count).map(|index| random(&mut source, &format!("random{index}"))).collect()
    }

    /// The controller by which a layer shows that it sees defects: a double integrator.
    pub fn example(&self) -> Spec {
        Spec::new(2, Family::Exp)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_item_gets_a_turn_within_seven_turns() {
        let mut context = Context { brief: true, ..Context::new(Path::new("target"), 1) };
        for length in 0..20 {
            let mut seen = vec![false; length];
            for _ in 0..PARTS {
                context.turn += 1;
                let due = context.in_turn((0..length).collect());
                assert_eq!(due.is_empty(), length == 0, "{length}");
                due.into_iter().for_each(|index| seen[index] = true);
            }
            assert!(seen.iter().all(|seen| *seen), "{length}: {seen:?}");
        }
    }
}
