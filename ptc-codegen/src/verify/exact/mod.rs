//! Loops that are linear in stretched time: a scenario is a matrix for each instant, which all scenarios share.
//!
//! The law of gains on a chain with the gain that it divides by, beside an f that no state is in, is
//! xi' = A xi + mu'^n f. A mapping that scales with tau makes its x one function of T/tau: with
//! q = tau/tau_0, the states q^(j-1) x_j under q^n f are those of a run of length tau_0. So the transitions
//! from instant to instant are those of that one run. The state is that of the law, by one product of a
//! matrix an instant; u is the law's on one side, and on the other what the emitted program gives in the same
//! state. Where f is not constant between the instants, as under a sine, nothing is shared, and nothing is
//! run here.

mod lockstep;
mod table;
#[cfg(test)]
mod tests;

use std::sync::{Arc, OnceLock};

use num_traits::ToPrimitive;

use lockstep::{Job, Lockstep};
use table::Table;

use super::bound::{scales, unit_rate};
use super::course::{PIECES, share};
use super::linear::{LinearLoop, drift, values};
use super::observer::LaneObserver;
use super::{Campaign, Outcome, Setting, Signal};
use crate::expression::Expression;
use crate::lower;
use crate::parameter::{Fixed, Parameter, Precision};
use crate::program::lanes::LANES;
use crate::program::{Value, passes};
use crate::request::Spec;
use crate::simulate::lanes::{DirectLanes, StretchedLanes};
use crate::simulate::{Along, Piece};

/// The loop of a campaign, with its transitions once they are asked for.
#[derive(Clone, Debug)]
pub(super) struct Exact {
    table: Arc<OnceLock<Option<Table>>>,
    gains: Vec<f64>,
    /// Units of time in which A is about 1, in one second of stretched time.
    rate: f64,
    /// T/tau at which any run may be looked at, or f may jump.
    nodes: Arc<Vec<f64>>,
    /// tau_0.
    tau: f64,
    /// The size of each wave, which is 0 where f is constant.
    waves: Vec<Parameter>,
    /// f; `None` where it is 0.
    force: Option<(Along, Value)>,
}

impl Exact {
    /// `None` where the loop is not known to be linear in stretched time.
    pub(super) fn of(campaign: &Campaign) -> Option<Self> {
        let spec = &campaign.spec;
        let known = values(campaign);
        let LinearLoop { gains, .. } = LinearLoop::of(campaign, &known).ok()?;
        drift(campaign, &known).ok()?;
        let is_free = |parameter: &Parameter| {
            matches!(parameter, Parameter::Tau | Parameter::StartTime | Parameter::Eps)
                || parameter.is_limit()
        };
        let given = |parameter: &Parameter| spec.fixed.get(parameter).is_some_and(is_number);
        let settled = spec.parameters().iter().all(|own| is_free(own) || given(own));
        // The sums of f evaluate mu thousands of times, which costs more than the runs where it is iterated.
        let iterates = spec.is_iterated();
        // Between the instants u may come to a limit.
        let clips = spec.radius(0).is_some();
        if !settled || iterates || clips || campaign.drawn().is_some() || !scales(campaign) {
            return None;
        }
        let rate = unit_rate(&gains)?.to_f64()?;
        let gains = gains.iter().map(ToPrimitive::to_f64);
        let plant = campaign.disturbed();
        let force = (plant.f != Expression::integer(0)).then(|| {
            let spec = Spec { precision: Precision::F64, ..spec.clone() };
            let program = passes::optimise(lower::plant(&spec, &[plant.f]), &mut |_, _| {});
            let value = program.watched[0];
            (Along::new(&program, &program.watched, spec.variables()), value)
        });
        Some(Self {
            table: Arc::default(),
            gains: gains.collect::<Option<_>>()?,
            rate,
            nodes: Arc::new(nodes(campaign)),
            tau: campaign.tau.0,
            waves: campaign.waves().collect(),
            force,
        })
    }

    /// The outcomes of the scenarios that run here to their end.
    pub(super) fn run(
        &mut self,
        (stretched, direct): (&mut StretchedLanes, &mut DirectLanes),
        observer: &mut LaneObserver,
        settings: &[Setting],
    ) -> Vec<Option<Outcome>> {
        let mut found = vec![None; settings.len()];
        let Some(first) = settings.first() else { return found };
        let table = Arc::clone(&self.table);
        let table = table.get_or_init(|| {
            let run = (self.tau, &first.values);
            Table::new(stretched, (&self.gains, self.rate), run, &self.nodes, self.force.is_some())
        });
        let Some(table) = table else { return found };
        let jobs = settings.iter().enumerate().filter_map(|(index, setting)| {
            let forces = self.forces(setting)?;
            let q = setting.values.get(Parameter::Tau) / self.tau;
            Some(Job { index, setting, forces, q })
        });
        let jobs: Vec<_> = jobs.collect();
        for jobs in jobs.chunks(LANES) {
            let outcomes = Lockstep::new(table, jobs).run(direct, observer);
            jobs.iter().zip(outcomes).for_each(|(job, outcome)| found[job.index] = outcome);
        }
        found
    }

    /// f in each piece of a run; `None` where it is not constant there.
    fn forces(&mut self, setting: &Setting) -> Option<Vec<f64>> {
        let one = |(_, values): &Piece| {
            if self.waves.iter().any(|size| values.get(*size) != 0.0) {
                return None;
            }
            let Some((along, value)) = &mut self.force else { return Some(0.0) };
            along.give(values).ok()?;
            along.settle();
            along.at(0.0, &[], &[]);
            Some(along.machine.get(*value))
        };
        setting.pieces.iter().map(one).collect()
    }
}

fn is_number(value: &Fixed) -> bool {
    value.number().is_some()
}

/// T/tau of all instants of the draws of a campaign, and of the jumps that they may share.
fn nodes(campaign: &Campaign) -> Vec<f64> {
    let until = campaign.until;
    let mut nodes = campaign.grid();
    nodes.push(until);
    let jumps = |signals: &[Signal]| {
        signals.iter().any(|signal| matches!(signal, Signal::Random | Signal::Worst))
    };
    if campaign.disturbances.iter().any(|(_, _, signals)| jumps(signals)) {
        nodes.extend((1..PIECES).map(|piece| share(until, piece)));
    }
    nodes.retain(|share| (until..=1.0).contains(share));
    nodes.sort_by(|a, b| b.total_cmp(a));
    nodes.dedup();
    nodes
}
