//! State of a search: the scenarios that are run first, and every choice that was tried.

use std::collections::BTreeMap;
use std::ops::ControlFlow;

use super::choice::Choice;
use super::judge::{self, Assessment};
use super::probe::Probe;
use super::wish::Wish;
use super::{Ended, Outcome};
use crate::verify::Scenario;

/// State of a search after a try.
#[derive(Debug)]
pub struct Standing<'a> {
    /// Probe with the least excess so far.
    pub best: &'a Probe,
    /// Tries that were taken.
    pub tries: usize,
}

/// Receiver of the state after each try; it may end the search.
pub type Watch<'a> = &'a dyn Fn(&Standing<'_>) -> ControlFlow<()>;

/// Why a search ended before its last candidate.
pub(super) enum End {
    Met(Box<Choice>, Assessment),
    UsedUp,
    Interrupted,
}

/// State of the work on a wish.
pub(super) struct Search<'a> {
    pub(super) wish: &'a Wish<'a>,
    most: usize,
    watch: Watch<'a>,
    tries: usize,
    /// The scenarios that are run first: few that are drawn, and every counterexample.
    scenarios: Vec<Scenario>,
    probes: BTreeMap<Choice, Probe>,
    /// The law of least energy that was tried first.
    least_energy: Option<Choice>,
}

impl<'a> Search<'a> {
    pub(super) fn new(wish: &'a Wish<'a>, most: usize, watch: Watch<'a>) -> Self {
        let scenarios = judge::first(wish.campaign());
        let (probes, least_energy) = (BTreeMap::new(), None);
        Self { wish, most, watch, tries: 0, scenarios, probes, least_energy }
    }

    /// Number of the scenarios that are run first.
    pub(super) fn known(&self) -> usize {
        self.scenarios.len()
    }

    /// Takes the choice as the law of least energy beside which others are reported; false where the reader refuses it.
    pub(super) fn starts_with(&mut self, choice: &Choice) -> bool {
        let is_read = self.probes.get(choice).is_some_and(Probe::is_read);
        self.least_energy = is_read.then(|| choice.clone());
        is_read
    }

    /// The worst excess of a choice, infinite where it is refused; ends the search where every objective holds.
    pub(super) fn value(&mut self, choice: &Choice) -> ControlFlow<End, f64> {
        self.value_below(choice, f64::INFINITY)
    }

    /// The same of a choice that has to come below a limit: one that does not is left early.
    pub(super) fn value_below(&mut self, choice: &Choice, limit: f64) -> ControlFlow<End, f64> {
        self.screened(choice, limit)?;
        let Some(probe) = self.probes.get_mut(choice) else {
            return ControlFlow::Continue(f64::INFINITY);
        };
        if !probe.is_left() && probe.excess() <= 0.0 && !probe.is_assessed() && probe.may_keep() {
            self.verified(choice)?;
        }
        ControlFlow::Continue(self.probes.get(choice).map_or(f64::INFINITY, Probe::excess))
    }

    /// The worst excess of a choice that was run, and what decides where two of them have the same.
    pub(super) fn merit(&self, choice: &Choice) -> f64 {
        let run = self.probes.get(choice).filter(|probe| !probe.is_left());
        run.map_or(f64::INFINITY, Probe::merit)
    }

    /// Runs a choice on the scenarios that are run first, and where it holds in them asks its worst case.
    fn screened(&mut self, choice: &Choice, limit: f64) -> ControlFlow<End> {
        let is_new = !self.probes.contains_key(choice);
        if is_new {
            let probe = Probe::new(self.wish, choice);
            // A choice that the reader refuses is no try.
            if probe.is_read() {
                self.one_more()?;
            }
            self.probes.insert(choice.clone(), probe);
        }
        let hard = if limit < f64::INFINITY { self.hard() } else { Vec::new() };
        if let Some(probe) = self.probes.get_mut(choice) {
            probe.run(&self.scenarios, &hard, limit);
            if !probe.is_left() && probe.excess() <= 0.0 {
                probe.judge(self.wish);
            }
        }
        match is_new && self.probes.get(choice).is_some_and(Probe::is_read) {
            true => self.tell(),
            false => ControlFlow::Continue(()),
        }
    }

    /// Verifies a choice with all scenarios.
    fn verified(&mut self, choice: &Choice) -> ControlFlow<End> {
        self.one_more()?;
        let Some(found) = self.probes.get_mut(choice).and_then(Probe::assess) else {
            return ControlFlow::Continue(());
        };
        if found.holds() {
            return ControlFlow::Break(End::Met(Box::new(choice.clone()), found));
        }
        for scenario in found.counterexamples() {
            if !self.scenarios.contains(scenario) {
                self.scenarios.push(scenario.clone());
            }
        }
        self.tell()
    }

    fn one_more(&mut self) -> ControlFlow<End> {
        if self.tries == self.most {
            return ControlFlow::Break(End::UsedUp);
        }
        self.tries += 1;
        ControlFlow::Continue(())
    }

    fn tell(&self) -> ControlFlow<End> {
        let Some(best) = self.nearest() else { return ControlFlow::Continue(()) };
        match (self.watch)(&Standing { best, tries: self.tries }) {
            ControlFlow::Break(()) => ControlFlow::Break(End::Interrupted),
            ControlFlow::Continue(()) => ControlFlow::Continue(()),
        }
    }

    /// The worst scenarios of the best choice so far, each once.
    fn hard(&self) -> Vec<Scenario> {
        let mut hard: Vec<Scenario> = Vec::new();
        for (_, scenario) in self.nearest().iter().flat_map(|probe| &probe.worst) {
            if !hard.contains(scenario) {
                hard.push(scenario.clone());
            }
        }
        hard
    }

    /// The probe with the least excess. Those that are refused say nothing where any other is known.
    fn nearest(&self) -> Option<&Probe> {
        let rank = |probe: &Probe| {
            let is_refused = probe.refused().is_some();
            (!probe.is_read(), is_refused, probe.is_left(), probe.merit())
        };
        self.probes.values().reduce(|a, b| if rank(b) < rank(a) { b } else { a })
    }

    pub(super) fn outcome(mut self, met: ControlFlow<End>) -> Outcome {
        let nearest = |search: &Self| search.nearest().map(|probe| probe.choice.clone());
        let (best, assessment, ended) = match met {
            ControlFlow::Break(End::Met(choice, found)) => {
                (Some(*choice), Some(found), Ended::Through)
            }
            ControlFlow::Break(End::UsedUp) => (nearest(&self), None, Ended::UsedUp),
            ControlFlow::Break(End::Interrupted) => (nearest(&self), None, Ended::Interrupted),
            ControlFlow::Continue(()) => (nearest(&self), None, Ended::Through),
        };
        let best = best.and_then(|choice| self.probes.remove(&choice));
        Outcome {
            best,
            assessment,
            others: self.probes.into_values().collect(),
            least_energy: self.least_energy,
            tries: self.tries,
            ended,
        }
    }
}
