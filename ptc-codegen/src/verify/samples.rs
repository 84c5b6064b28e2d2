//! Runs in samples: their time-to-go, and when the plant gets other values.

use super::Setting;
use crate::parameter::Parameter;
use crate::simulate::{SAME, Values};

/// Time-to-go at a sample: that of the deadline is 0, and not what rounding makes of it.
pub(super) fn of_sample(time_to_go: f64, tau: f64) -> f64 {
    if time_to_go.abs() <= SAME * tau { 0.0 } else { time_to_go }
}

/// The pieces of a run in samples.
pub(super) struct Changes<'a> {
    pieces: &'a [(Vec<f64>, Values)],
    tau: f64,
    /// The piece that holds.
    piece: usize,
}

impl<'a> Changes<'a> {
    pub(super) fn of(setting: &'a Setting) -> Self {
        let tau = setting.values.get(Parameter::Tau);
        Self { pieces: &setting.pieces, tau, piece: 0 }
    }

    /// The values of the piece that begins at a sample, if one does: from where the piece before ends on.
    pub(super) fn next(&mut self, since: f64) -> Option<&'a Values> {
        let before = self.piece;
        let ended = |(shares, _): &(Vec<f64>, Values)| {
            shares.last().is_some_and(|share| since >= self.tau * (1.0 - share))
        };
        while self.piece + 1 < self.pieces.len() && ended(&self.pieces[self.piece]) {
            self.piece += 1;
        }
        (self.piece != before).then(|| &self.pieces[self.piece].1)
    }
}
