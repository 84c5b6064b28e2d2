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
    forces: Vec<(f64, f64)>,
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
                Change::Force { size, length } => self.forces.push((size, since + length)),
                change => now.push(change),
            }
        }
        SampleEvents(now)
    }

    /// The force that acts from a sample on.
    pub(super) fn force(&mut self, since: f64) -> f64 {
        self.forces.retain(|(_, until)| since < until * (1.0 - SAME));
        self.forces.iter().map(|(size, _)| size).sum()
    }
}

impl SampleEvents {
    /// Tells the controller that the target moves, and returns by how much.
    pub(super) fn move_target(&self, control: &mut dyn Control) -> f64 {
        let by = |change: &Change| match change {
            Change::Target(by) => Some(*by),
            _ => None,
        };
        let moves: Vec<_> = self.0.iter().filter_map(by).collect();
        for by in &moves {
            control.call("move", &[&[*by]]);
        }
        moves.iter().sum()
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
                        return Err(refused(*samples, t, status));
                    }
                    armed = Some(Some(asked * period));
                }
                Change::Target(_) | Change::Force { .. } => {}
            }
        }
        Ok(armed)
    }
}

fn refused(samples: u32, t: f64, status: Option<Status>) -> Failure {
    let status = status.map_or("none", Status::c_name);
    Failure::input(
        format!("event at t = {t} s: arm_for refuses a deadline in {samples} samples, {status}"),
        "give a later one: `explain PTC_E_SOON` and `explain PTC_E_PARAM` say what is legal",
    )
}
