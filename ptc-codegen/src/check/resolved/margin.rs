//! The margin of an eps that is chosen without the worst case of the loop.

use num_traits::ToPrimitive;

use super::Resolved;
use crate::check::sampled::{Tolerance, smallest_tolerant, tolerance};
use crate::expansion::Expanded;
use crate::parameter::{Fixed, Parameter};

impl Resolved {
    /// Adds to the reason of eps that it keeps the margin, or why it does not. Where it does not and a bound of the
    /// error is given, the best eps for the loop is taken; it weighs the margin against the error.
    pub(super) fn weigh_margin(&mut self, expanded: Option<&Expanded>) {
        if self.spec.promises.sample_time.is_none() {
            self.add_to_reason("; no margin is known without `sample_time`");
            return;
        }
        let found = match tolerance(&self.spec, expanded) {
            Ok(found) => found,
            Err(why) => {
                self.add_to_reason(&format!("; the margin is not known: {why}"));
                return;
            }
        };
        if found.is_kept {
            self.add_to_reason(&format!("; it keeps the margin: {}", found.wanted));
        } else if self.spec.promises.error.is_empty() {
            self.without_error(&found, expanded);
        } else if let Err(why) = self.choose_best_eps(expanded) {
            let lost = lost(&found);
            self.add_to_reason(&format!("; {lost}, and no other eps was compared: {why}"));
        }
    }

    /// In time the smallest eps that keeps the margin is taken. In samples rest at the deadline comes before it.
    fn without_error(&mut self, found: &Tolerance, expanded: Option<&Expanded>) {
        let lost = lost(found);
        if self.spec.sampled().is_some() {
            self.add_to_reason(&format!(
                "; rest at the last sample comes first, and {lost}; give `error` to weigh one against the other"
            ));
            return;
        }
        let eps = self.spec.fixed.get(&Parameter::Eps).and_then(Fixed::number);
        let least = eps.and_then(ToPrimitive::to_f64);
        match least.and_then(|least| smallest_tolerant(&self.spec, expanded, least)) {
            Some(eps) => {
                let reason = format!("the smallest found that keeps the margin: {}", found.wanted);
                self.choose_eps((eps, reason));
            }
            None => self.add_to_reason(&format!("; no larger eps keeps the margin, and {lost}")),
        }
    }

    /// Extends the reason of eps.
    pub(super) fn add_to_reason(&mut self, more: &str) {
        let of_eps = |choice: &&mut super::Choice| choice.key == Parameter::Eps.key();
        if let Some(choice) = self.choices.iter_mut().find(of_eps) {
            choice.reason.push_str(more);
        }
    }
}

fn lost(found: &Tolerance) -> String {
    format!("the margin, {}, is not kept: {}", found.wanted, found.found())
}
