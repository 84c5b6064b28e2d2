//! Time past the deadline, time-to-go, and their shares of tau.

use super::builder::Builder;
use crate::parameter::Parameter;
use crate::program::{Input, Op, Value};

impl Builder<'_> {
    /// Time past the deadline, -T, held at -eps.
    pub(super) fn late(&mut self) -> Value {
        if self.plant.is_some() {
            let time_to_go = self.time_to_go();
            return self.push(Op::Neg(time_to_go));
        }
        let past = self.past();
        let hold_from = self.hold_from();
        let late = self.push(Op::Min(past, hold_from));
        self.name(late, "late", "-T: time past the deadline, held at -eps")
    }

    /// Time past the deadline, -T, as it goes on.
    ///
    /// The deadline is kept as the unevaluated sum `deadline + correction` = t0 + tau (two-sum).
    /// Near the deadline `t - deadline` is exact (Sterbenz: the two are within a factor of 2), so
    /// -T has one rounding for any t0, where tau - (t - t0) loses as many digits as t0/T has.
    pub(super) fn past(&mut self) -> Value {
        let start = self.push(Op::Input(Input::StartTime));
        let tau = self.parameter(Parameter::Tau);
        let high = self.add(start, tau);
        let high = self.name(high, "deadline", "t0 + tau, rounded");
        let virtual_tau = self.sub(high, start);
        let virtual_start = self.sub(high, virtual_tau);
        let start_error = self.sub(start, virtual_start);
        let tau_error = self.sub(tau, virtual_tau);
        let low = self.add(start_error, tau_error);
        let low = self.name(low, "correction", "low part of t0 + tau (compensated sum)");
        let time = self.push(Op::Input(Input::Time));
        let past = self.sub(time, high);
        let past = self.sub(past, low);
        self.name(past, "past", "time past the deadline, negative before it")
    }

    /// Elapsed time tau - T, where time is another than that of the plant.
    pub(super) fn elapsed_of_plant(&mut self) -> Value {
        let (tau, time_to_go) = (self.parameter(Parameter::Tau), self.time_to_go());
        self.sub(tau, time_to_go)
    }

    /// Time t, where time is another than that of the plant.
    pub(super) fn time_of_plant(&mut self) -> Value {
        let (start, elapsed) = (self.push(Op::Input(Input::StartTime)), self.elapsed_of_plant());
        self.add(start, elapsed)
    }

    /// -eps, where the hold begins.
    pub(super) fn hold_from(&mut self) -> Value {
        let eps = self.parameter(Parameter::Eps);
        let hold_from = self.push(Op::Neg(eps));
        self.name(hold_from, "hold_from", "-eps: later than this the gains are held")
    }

    /// Time-to-go T, held at eps.
    pub(super) fn time_to_go(&mut self) -> Value {
        if self.is_at_start() {
            return self.parameter(Parameter::Tau);
        }
        if let Some(complement) = self.followed().cloned() {
            return self.scalar(&complement);
        }
        if self.counts_down() {
            return self.push(Op::Input(Input::Time));
        }
        let late = self.late();
        let time_to_go = self.push(Op::Neg(late));
        self.name(time_to_go, "T", "time-to-go, held at eps")
    }

    /// 2 tau - T, between tau and 2 tau: nothing cancels.
    pub(super) fn rest(&mut self) -> Value {
        let (double, late) = (self.two_tau(), self.late());
        self.add(double, late)
    }

    /// T - 2 tau, by which the time past the deadline is divided without a change of sign.
    pub(super) fn minus_rest(&mut self) -> Value {
        let (double, late) = (self.two_tau(), self.late());
        let minus = self.push(Op::Neg(double));
        let minus = self.name(minus, "minus_two_tau", "-2*tau");
        self.sub(minus, late)
    }

    /// 2 tau.
    pub(super) fn two_tau(&mut self) -> Value {
        let (two, tau) = (self.integer(2), self.parameter(Parameter::Tau));
        let double = self.mul(two, tau);
        self.name(double, "two_tau", "2*tau")
    }

    /// T^2, as the square of -T.
    pub(super) fn late_squared(&mut self) -> Value {
        let late = self.late();
        self.mul(late, late)
    }

    /// tau/T with one rounding, for the power family raises it to the power m (n+1-j).
    pub(super) fn inverse_share(&mut self) -> Value {
        let (tau, late) = (self.parameter(Parameter::Tau), self.late());
        let minus_tau = self.push(Op::Neg(tau));
        let minus_tau = self.name(minus_tau, "minus_tau", "-tau");
        let ratio = self.div(minus_tau, late);
        self.name(ratio, "inv_w", "tau/T")
    }

    /// 1/tau.
    pub(super) fn inverse_tau(&mut self) -> Value {
        let (one, tau) = (self.integer(1), self.parameter(Parameter::Tau));
        let inverse_tau = self.div(one, tau);
        self.name(inverse_tau, "inv_tau", "1/tau")
    }

    /// -T/tau.
    pub(super) fn late_share(&mut self) -> Value {
        let (late, inverse_tau) = (self.late(), self.inverse_tau());
        self.mul(late, inverse_tau)
    }
}
