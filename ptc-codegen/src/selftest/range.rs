//! The calls of which u overflows or is no number.

use std::collections::BTreeSet;

use super::CANDIDATES;
use super::maker::{Maker, after};
use super::overflow::{extreme, least};
use super::{Call, Draw, Session, Wanted};
use crate::parameter::Parameter;
use crate::program::number::settle;
use crate::reference::Status;
use crate::request::After;

impl Maker<'_> {
    /// A u that is no number, or that overflows without a bound: found by trial, as it is the
    /// order of the operations that decides.
    pub(super) fn out_of_range(&mut self) -> Vec<Session> {
        let spec = self.spec();
        let mut draw = Draw(2);
        let largest = spec.precision.greatest();
        let all = self.chosen.at_run_time();
        let mut found = Vec::new();
        let mut kinds = vec![(true, true), (true, false)];
        let mut patterns = BTreeSet::new();
        for round in self.trials.rounds(2 * CANDIDATES) {
            let mut session = self.session(if round % 2 == 0 { 0.0625 } else { 1e-4 });
            if round < CANDIDATES {
                self.at_the_ends(&mut session, round);
            } else {
                // Each parameter alone at its ends, then all of them anywhere.
                let round = (round - CANDIDATES) % (8 * all.len().max(1));
                let usual = session.parameters;
                session.parameters = extreme(spec, self.chosen, &usual, round, &mut draw);
            }
            let tau = self.parameter(&session, Parameter::Tau);
            let mut t = self.time(&session, draw.of(&[0.0, 0.02, 0.5]) * tau);
            if spec.after != After::Hold && t >= self.time(&session, 0.0) {
                let start = self.parameter(&session, Parameter::StartTime);
                t = start.max(-after(-t, spec.precision));
            }
            let sizes = [largest, -largest, 0.75 * largest, 1.0, -1.0, 0.0];
            let x: Vec<_> =
                (0..spec.given()).map(|_| settle(draw.of(&sizes), spec.precision)).collect();
            let seen = self.trial(&session, t, &x);
            let range = |status: Status| status == Status::Range;
            let kind = (range(seen.step), seen.axis.is_some_and(range));
            // A bound says nothing of the digits: what stays in range is asked elsewhere.
            // A branch counts as taken where `tick`, which has its own code, takes it too.
            let whole = kind.1 || seen.axis.is_none();
            // Which of several inputs are no numbers, where one is not.
            let statuses: Vec<_> = seen.each.iter().map(|(status, _)| *status).collect();
            let is_new = kinds.contains(&kind)
                || (whole && !seen.decisions.is_subset(&self.taken))
                || (statuses.len() > 1 && !patterns.contains(&statuses));
            if !kind.0 || !is_new || !self.is_taken(&session) {
                continue;
            }
            let axis = seen.axis.filter(|status| range(*status));
            kinds.retain(|other| *other != kind);
            patterns.insert(statuses);
            if whole {
                self.taken.extend(seen.decisions);
            }
            let inputs = seen.each.iter().map(|(status, _)| Wanted::none(*status)).collect();
            session.calls.push(Call { t, x, status: Status::Range, inputs, axis });
            found.push(session);
        }
        found
    }

    /// Some run-time parameters at the ends of what they may be, by turns.
    fn at_the_ends(&self, session: &mut Session, round: usize) {
        let spec = self.spec();
        let largest = spec.precision.greatest();
        let all = self.chosen.at_run_time();
        for (at, parameter) in all.iter().enumerate() {
            let value = match parameter {
                Parameter::UMax if round % 3 == 1 => 1.0,
                // A time-to-go that has no reciprocal, and no share of tau.
                Parameter::Eps if round % 4 == 3 => least(spec),
                Parameter::Tau if round % 4 == 3 && round % 16 > 8 => largest / 8.0,
                Parameter::Tau if round % 4 == 3 && round % 16 > 4 => {
                    8.0 * self.chosen.legal(Parameter::Eps, least(spec))
                }
                Parameter::Gain(_) if round % 8 == 7 => 0.0,
                _ => continue,
            };
            session.parameters[at] = self.chosen.legal(*parameter, value);
        }
        // A deadline at 0, up to which time has all its digits.
        let at = all.iter().position(|p| *p == Parameter::StartTime);
        if let Some(at) = at.filter(|_| round % 4 == 3) {
            let start = -self.parameter(session, Parameter::Tau);
            session.parameters[at] = self.chosen.legal(Parameter::StartTime, start);
        }
    }
}
