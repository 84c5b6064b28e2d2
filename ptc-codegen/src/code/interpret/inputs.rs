//! The end of a call that gives the inputs of one plant.

use super::Outcome;
use super::frame::Frame;
use crate::code::{Function, Inputs, Status};
use crate::collect::map;

impl<'b> Frame<'_, 'b> {
    /// Every u, each within its bound, and the status of each; of a call that has `ended` none.
    pub(super) fn inputs(
        &mut self,
        function: &Function,
        inputs: &'b Inputs,
        ended: Option<Status>,
    ) -> Outcome {
        let m = inputs.values.len();
        let given = |status: Status, u: Vec<f64>, each: Vec<Status>| {
            let each = each.into_iter().map(|status| f64::from(status.number())).collect();
            let names = function.results.iter().map(|result| result.name.clone());
            Outcome { status, results: map(names.zip([u, each])) }
        };
        if let Some(status) = ended {
            return given(status, vec![0.0; m], vec![status; m]);
        }
        let now = if self.test(&inputs.tracks) { Status::Ok } else { Status::Hold };
        let mut u: Vec<_> = inputs.values.iter().map(|value| self.real(value)).collect();
        let mut each = vec![now; m];
        let finite = inputs.finite_at();
        if !finite.iter().all(|(test, place)| self.test_at(test, *place)) {
            for (test, place) in inputs.finite_beside_at() {
                self.test_at(&test, place);
            }
            for (status, _) in each.iter_mut().zip(&u).filter(|(_, u)| !u.is_finite()) {
                *status = Status::Range;
            }
            return given(Status::Range, vec![0.0; m], each);
        }
        for index in 0..m {
            let clips = inputs.clips_at(index);
            let clip = clips.iter().find(|(test, _, place)| self.test_at(test, *place));
            if let Some((_, clipped, _)) = clip {
                (u[index], each[index]) = (self.real(clipped), Status::Saturated);
            }
        }
        let mut asked = inputs.saturated_at().into_iter();
        let clipped = asked.any(|(index, place)| {
            self.note(place, each[index] == Status::Saturated);
            each[index] == Status::Saturated
        });
        let status = if clipped { Status::Saturated } else { now };
        given(status, u, each)
    }
}
