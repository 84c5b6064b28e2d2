//! The end of a call that gives the inputs of one plant.

use super::Outcome;
use super::frame::Frame;
use crate::code::branch::Asked;
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
        let finite = |index: usize, asked| {
            self.test_at(&inputs.is_finite(index), inputs.place(index, asked))
        };
        if !(0..m).all(|index| finite(index, Asked::Finite)) {
            for index in 0..m {
                finite(index, Asked::Beside);
            }
            for (status, _) in each.iter_mut().zip(&u).filter(|(_, u)| !u.is_finite()) {
                *status = Status::Range;
            }
            return given(Status::Range, vec![0.0; m], each);
        }
        for index in 0..m {
            let mut clips = inputs.clips(index).into_iter().zip([Asked::Above, Asked::Below]);
            let clip =
                clips.find(|((test, _), asked)| self.test_at(test, inputs.place(index, *asked)));
            if let Some(((_, clipped), _)) = &clip {
                (u[index], each[index]) = (self.real(clipped), Status::Saturated);
            }
        }
        let mut limited = (0..m).filter(|index| inputs.limits[*index].is_some());
        let clipped = limited.any(|index| {
            let saturated = each[index] == Status::Saturated;
            self.note(inputs.place(index, Asked::Saturated), saturated);
            saturated
        });
        let status = if clipped { Status::Saturated } else { now };
        given(status, u, each)
    }
}
