//! The gate of an observer: which readings correct the estimates.
//!
//! A reading is believed if it is finite, within the range of the sensor and within `innovation_max` of its
//! prediction. Otherwise the sample has no correction, as if the reading were the prediction. The field `trust` counts
//! the samples for which the estimates may be used: `coast` + 1 after a reading that is believed, one less after any
//! other. A call that finds it used up is refused. It begins at 1: without a first reading there is nothing to predict.

use crate::algebra::{BigRational, integer};
use crate::code::{Expr, Finish, Place, Shape, Statement, Status, Test};
use crate::expression::Function;
use crate::parameter::Precision;
use crate::request::Gate;

use super::controller::Builder;

/// Counts the samples for which the estimates may be used.
const TRUST: &str = "trust";

/// The sum of the sizes of the estimates.
const SIZE: &str = "size";

impl Builder<'_> {
    fn gate(&self) -> Option<&Gate> {
        self.sampled.observer.as_ref().map(|observer| &observer.gate)
    }

    /// The gate of an observer that can predict alone.
    fn coasting(&self) -> Option<&Gate> {
        self.gate().filter(|gate| gate.coasts())
    }

    /// The value of `trust` after a reading that is believed.
    fn full_trust(&self) -> Expr {
        Expr::Count(self.coasting().map_or(1, |gate| gate.coast + 1))
    }

    /// Tests of a measurement by itself: it is finite, and within the range of its sensor.
    pub(super) fn is_reading(&self, given: &str, l: usize) -> Vec<Test> {
        let y = || Expr::Element(given.to_owned(), l);
        let range = self.gate().and_then(|gate| gate.range(l));
        let range = range.map(|most| Test::AtMost(size(y()), Expr::Number(most.clone())));
        std::iter::once(Test::Finite(y())).chain(range).collect()
    }

    /// The local value of how far measurement `of` is from its prediction, before the gate: `miss` without one.
    pub(super) fn before_gate(&self, of: &str) -> String {
        format!("{}{of}", if self.sampled.coasts() { "gap" } else { "miss" })
    }

    /// Statements that set `miss` of each measurement, numbered from 0 and named behind its letter, to how far it is
    /// from its prediction if all readings are believed, else to 0. A call that may not use the estimates any longer is
    /// refused.
    pub(super) fn believe(&mut self, measurements: &[(usize, String)]) -> Vec<Statement> {
        let Some(gate) = self.coasting().cloned() else { return Vec::new() };
        let full = self.full_trust();
        let about = "samples for which the estimates may be used, the next one included";
        let trust = self.keep_count(TRUST, about, Expr::Count(1));
        let set = |name: &str, value| Statement::Set(Place::Local(name.to_owned()), value);
        let (mut tests, mut body) = (Vec::new(), Vec::new());
        let (mut believed, mut alone) = (Vec::new(), Vec::new());
        for (l, of) in measurements {
            let (gap, miss) = (Expr::local(self.before_gate(of)), format!("miss{of}"));
            tests.extend(self.is_reading("y", *l));
            let most = gate.innovation(*l).cloned().map(Expr::Number);
            tests.extend(most.map(|most| Test::AtMost(size(gap.clone()), most)));
            body.push(Statement::Variable(miss.clone(), Shape::Real));
            believed.push(set(&miss, gap));
            alone.push(set(&miss, Expr::integer(0)));
        }
        body.push(Statement::Variable(TRUST.to_owned(), Shape::Count));
        believed.push(set(TRUST, full));
        alone.push(set(TRUST, trust.count_left(Expr::Count(1))));
        body.push(Statement::If(Test::All(tests), believed, alone));
        let usable = Test::CountLess(Expr::Count(0), Expr::local(TRUST));
        body.push(Statement::Require(usable, Status::Input));
        body
    }

    /// Statements of `arm`: estimates that may not be used without a reading, or with which calls may overflow, are
    /// forgotten.
    pub(super) fn forget(&self) -> Vec<Statement> {
        if !self.sampled.observes() {
            return Vec::new();
        }
        let set = |name: &str, value| Statement::Set(Place::Field(name.to_owned()), value);
        let mut forgotten = vec![set("seen", Expr::Count(0))];
        let mut usable = Vec::new();
        if self.sampled.coasts() {
            usable.push(Test::CountLess(Expr::Count(1), Expr::field(TRUST)));
        }
        let mut sizes = Vec::new();
        for name in self.estimated() {
            let (hat, next) = (format!("{name}_hat"), format!("{name}_next"));
            forgotten.push(set(&hat, Expr::integer(0)));
            let kept = match self.sampled.linear.is_some() {
                true => {
                    forgotten.push(set(&next, Expr::integer(0)));
                    next
                }
                false => hat,
            };
            sizes.push(size(Expr::field(kept)));
        }
        let greatest = Expr::Number(greatest(self.spec.precision));
        usable.push(Test::AtMost(Expr::local(SIZE), greatest));
        let sum = Statement::Let(SIZE.to_owned(), Shape::Real, Expr::sum(sizes));
        vec![sum, Statement::If(Test::All(usable), Vec::new(), forgotten)]
    }

    /// The statement that keeps `trust` for the next call.
    pub(super) fn keep_trust(&self) -> Option<Statement> {
        let kept = Statement::Set(Place::Field(TRUST.to_owned()), Expr::local(TRUST));
        self.sampled.coasts().then_some(kept)
    }

    /// An end whose status is `Gated` where readings were not believed, with the same results.
    pub(super) fn gated(&self, results: Vec<Expr>, finish: Finish) -> Finish {
        if !self.sampled.coasts() {
            return finish;
        }
        let gated = Test::CountLess(Expr::local(TRUST), self.full_trust());
        Finish::choose(gated, Finish::give(results, Status::Gated), finish)
    }
}

/// The largest sum of the sizes of estimates that `arm` keeps: a product of it with a gain is finite.
fn greatest(precision: Precision) -> BigRational {
    let exponent = match precision {
        Precision::F64 => 150,
        Precision::F32 => 18,
    };
    integer(10).pow(exponent)
}

fn size(value: Expr) -> Expr {
    Expr::Call(Function::Abs, Box::new(value))
}
