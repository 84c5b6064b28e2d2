//! The events of a run as they happen.

use super::around::SAME;
use super::event::{Change, Event};
use super::{Control, Failure};
use crate::reference::Status;

/// The events that are left of a run, and the forces that act.
pub(super) struct EventQueue {
    /// Sorted by time.
    all: Vec<Event>,
    next: usize,
    forces: Vec<Force>,
}

/// A force that acts.
struct Force {
    /// The input, from 0; `None` for every one.
    input: Option<usize>,
    size: f64,
    /// The time at which it ends.
    until: f64,
}

/// The events of one sample.
pub(super) struct SampleEvents(Vec<Change>);

impl EventQueue {
    pub(super) fn new(all: &[Event]) -> Self {
        let mut all = all.to_vec();
        all.sort_by(|a, b| a.at.total_cmp(&b.at));
        Self { all, next: 0, forces: Vec::new() }
    }

    /// Takes the events of a sample.
    pub(super) fn at(&mut self, since: f64) -> SampleEvents {
        let mut now = Vec::new();
        while let Some(event) = self.all.get(self.next).filter(|e| since >= e.at * (1.0 - SAME)) {
            self.next += 1;
            match event.change {
                Change::Force { input, size, length } => {
                    self.forces.push(Force { input, size, until: since + length });
                }
                change => now.push(change),
            }
        }
        SampleEvents(now)
    }

    /// Forgets the forces that have ended at a sample.
    pub(super) fn end_forces(&mut self, since: f64) {
        self.forces.retain(|force| since < force.until * (1.0 - SAME));
    }

    /// The force that acts on an input.
    pub(super) fn force(&self, input: usize) -> f64 {
        let own = self.forces.iter().filter(|force| force.input.is_none_or(|own| own == input));
        own.map(|force| force.size).sum()
    }
}

impl SampleEvents {
    /// Returns true if nothing happens but forces.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Tells the controller that targets move, and counts the states from there.
    pub(super) fn move_targets(&self, control: &mut dyn Control, x: &mut [f64]) {
        for change in &self.0 {
            if let Change::Target { state, by } = change {
                control.call("move", &[&[*by]]);
                x[*state] -= by;
            }
        }
    }

    /// Arms the controller at `now`, its clock, which is `t` s: the time to the new deadline, none for that of the
    /// design; `None` where it is not armed.
    pub(super) fn arm(
        &self,
        control: &mut dyn Control,
        (now, t): (f64, f64),
        measured: &[f64],
        period: f64,
    ) -> Result<Option<Option<f64>>, Failure> {
        let mut armed = None;
        for change in &self.0 {
            match change {
                Change::Arm => {
                    if !control.arm(now, measured) {
                        return Err(Failure::not_armed(t));
                    }
                    armed = Some(None);
                }
                Change::Deadline(samples) => {
                    let asked = f64::from(*samples);
                    let status = control.call("arm_for", &[&[now], &[asked], measured]);
                    if status != Some(Status::Ok) {
                        return Err(refused(&format!("{samples} samples"), t, status));
                    }
                    armed = Some(Some(asked * period));
                }
                Change::Duration(tau) => {
                    let status = control.call("arm_for", &[&[now], &[*tau], measured]);
                    if status != Some(Status::Ok) {
                        return Err(refused(&format!("{tau} s"), t, status));
                    }
                    armed = Some(Some(*tau));
                }
                Change::Target { .. } | Change::Force { .. } => {}
            }
        }
        Ok(armed)
    }
}

fn refused(length: &str, t: f64, status: Option<Status>) -> Failure {
    let status = status.map_or("none", Status::c_name);
    Failure::input(
        format!("event at t = {t} s: arm_for refuses a deadline in {length}, {status}"),
        "give a later one: `explain PTC_E_SOON` and `explain PTC_E_PARAM` say what is legal",
    )
}
