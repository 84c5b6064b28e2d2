//! Runs of pieces in which the plant has other values: when it gets them in the loop that runs.

use super::Values;

/// T/tau of the instants of a piece that are looked at, from the first to its end, with what holds in it.
pub type Piece = (Vec<f64>, Values);

/// The pieces of a run in samples.
#[derive(Clone, Debug)]
pub struct Changes<'a> {
    pieces: &'a [Piece],
    tau: f64,
    /// The piece that holds.
    piece: usize,
}

impl<'a> Changes<'a> {
    /// Returns the pieces of a run of length `tau`.
    pub fn of(pieces: &'a [Piece], tau: f64) -> Self {
        Self { pieces, tau, piece: 0 }
    }

    /// The time after t0 from which on the next piece holds; infinite in the last one.
    pub fn due(&self) -> f64 {
        let share = match self.pieces.get(self.piece..) {
            Some([(shares, _), _, ..]) => shares.last(),
            _ => None,
        };
        share.map_or(f64::INFINITY, |share| self.tau * (1.0 - share))
    }

    /// The values of the piece that begins at a sample, if one does: from where the piece before ends on.
    pub fn next(&mut self, since: f64) -> Option<&'a Values> {
        let before = self.piece;
        while since >= self.due() {
            self.piece += 1;
        }
        (self.piece != before).then(|| &self.pieces[self.piece].1)
    }
}
