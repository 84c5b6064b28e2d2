//! Time resolution of the emitted code: t and the deadline are numbers of its precision, whose spacing grows with their
//! size, while the other checks take time-to-go as exact.

use super::known::to_f64;
use crate::check::{Outcome, Verdict};
use crate::diagnostic::digits;
use crate::parameter::{Parameter, Precision};
use crate::request::Spec;

/// Spacing of times in a run from a fixed t0.
pub(super) struct Resolution {
    /// The greater one of the sizes of t0 and the deadline, s.
    at: f64,
    /// The spacing of numbers there, s.
    step: f64,
    tau: f64,
    precision: Precision,
}

impl Resolution {
    /// `None` where t0 or tau is left to run time.
    pub(super) fn new(spec: &Spec) -> Option<Self> {
        let number = |parameter| spec.fixed.get(&parameter).and_then(to_f64);
        let (start, tau) = (number(Parameter::StartTime)?, number(Parameter::Tau)?);
        let at = start.abs().max((start + tau).abs());
        #[allow(clippy::cast_possible_truncation)]
        let step = match spec.precision {
            Precision::F64 => at.next_up() - at,
            Precision::F32 => f64::from((at as f32).next_up()) - f64::from(at as f32),
        };
        // Beyond the range of the numbers there is no step.
        let step = if step.is_finite() { step } else { f64::INFINITY };
        Some(Self { at, step, tau, precision: spec.precision })
    }

    /// `outcome`, which takes time-to-go as exact, where times that are `needed` apart are the same
    /// number: undecided, and unsound where t stays at t0 until the deadline.
    pub(super) fn judge(&self, outcome: Outcome, needed: Option<f64>) -> Outcome {
        if outcome.verdict != Verdict::Sound || needed.is_none_or(|needed| self.step <= needed) {
            return outcome;
        }
        let precision = self.precision.name();
        let (at, step) = (digits(self.at), digits(self.step));
        let told = format!("near t = {at} s numbers of {precision} are {step} s apart");
        // A time is rounded to the nearer one of two.
        let (verdict, summary) = if self.step > 2.0 * self.tau {
            (Verdict::Unsound, format!("{told}: every call sees T = tau"))
        } else {
            let if_exact = format!("with exact time: {}", outcome.summary);
            (Verdict::Undecided, format!("{told}; {if_exact}"))
        };
        let wider = match self.precision {
            Precision::F64 => "",
            Precision::F32 => ", or take precision = \"f64\"",
        };
        let fix = Some(format!("count t from 0: t0 = 0{wider}"));
        Outcome { verdict, summary, fix, ..outcome }
    }
}
