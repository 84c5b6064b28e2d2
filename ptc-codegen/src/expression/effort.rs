//! The effort of symbolic work, counted where it is done, so that no expression takes unbounded
//! time or memory: what is left undone is unknown, and the form stays as it was written.

use std::cell::Cell;

use crate::limits::EFFORT;

thread_local! {
    /// Remaining effort of the current work; `None` if it is not bounded.
    static LEFT: Cell<Option<usize>> = const { Cell::new(None) };
}

/// Sets the effort back where the work ends, however it ends.
struct Outermost;

impl Outermost {
    /// Sets the effort, unless work goes on that has one.
    fn of_work() -> Option<Self> {
        LEFT.get().is_none().then(|| {
            LEFT.set(Some(EFFORT.size()));
            Self
        })
    }
}

impl Drop for Outermost {
    fn drop(&mut self) {
        LEFT.set(None);
    }
}

/// Does `work` within [`EFFORT`]. Work within work has the effort of the whole.
pub(crate) fn bounded<T>(work: impl FnOnce() -> T) -> T {
    completed(work).0
}

/// The same, and whether the effort was enough.
pub(crate) fn completed<T>(work: impl FnOnce() -> T) -> (T, bool) {
    let _outermost = Outermost::of_work();
    let result = work();
    (result, LEFT.get() != Some(0))
}

/// Takes `steps` of the effort; `None` where so many are not left, nor will any be again.
pub(crate) fn spend(steps: usize) -> Option<()> {
    let Some(left) = LEFT.get() else { return Some(()) };
    let rest = left.saturating_sub(steps);
    LEFT.set(Some(rest));
    (rest > 0).then_some(())
}

/// Steps of the effort that an operation or an operand takes that is copied, and kept until a normal
/// form of the whole is found: beside the time that is some 100 bytes, two or three times.
const KEPT: usize = 8;
/// Steps that a normal form takes beside those of its operations.
pub(super) const FORMED: usize = 60;
/// Steps that the comparison of two coefficients of a scale takes.
pub(super) const COMPARED: usize = 10;
/// Steps that an operation of a search for leading terms takes the time of.
pub(super) const WALKED: usize = 150;
/// Steps that an operation on long intervals takes the time of.
pub(super) const ENCLOSED: usize = 300;

/// Takes the effort of so many operations and operands; `None` where it is not left.
pub(crate) fn keep(size: usize) -> Option<()> {
    spend(size.saturating_mul(KEPT))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nested_work_shares_one_effort_limit() {
        let ((), enough) = completed(|| {
            assert!(bounded(|| spend(EFFORT.size() / 2)).is_some());
            assert!(bounded(|| spend(EFFORT.size() / 2)).is_none());
            assert!(spend(1).is_none());
        });
        assert!(!enough);
        assert!(completed(|| spend(1)).1);
        assert!(spend(usize::MAX).is_some());
    }
}
