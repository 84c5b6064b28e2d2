//! The deadline that a step puts off where a limit would be exceeded, or plans anew.

use super::super::controller::Builder;
use super::search::{KEPT, Search};
use super::{AHEAD, LAST, longest, rest};
use crate::code::{Expr, Place, Shape, Statement, Status, Test};
use crate::request::{After, Flight, MAX_SAMPLES};

/// The samples from the start to rest from this step on.
const NOW: &str = "last_now";

/// 1 if this step has put its deadline off, 2 if no deadline was found that keeps the limits.
const LATE: &str = "late";

/// Part of the time to go by which a step moves its deadline forward at most.
const FORWARD: u32 = 16;

impl Builder<'_> {
    /// Returns true if a step may change the deadline.
    pub(in crate::samples) fn replans(&self) -> bool {
        self.flight().is_some_and(Flight::replans)
    }

    /// The samples from the start to rest of a step, and statements that set them where it may change them.
    pub(in crate::samples) fn samples_now(&mut self, samples: &Expr) -> (Vec<Statement>, Expr) {
        match self.replans() {
            true => (self.replan(), Expr::local(NOW)),
            false => (Vec::new(), samples.clone()),
        }
    }

    /// Statements that set `last_now`, the samples from the start to rest.
    fn replan(&mut self) -> Vec<Statement> {
        let spare = self.spare();
        let field = || Expr::field(LAST);
        let elapsed = || Expr::local("elapsed");
        let mut body = vec![Statement::Note("The deadline that keeps the limits.".to_owned())];
        body.push(Statement::Begin(NOW.to_owned(), Shape::Count, field()));
        let count = |name: &str, value| Statement::Let(name.to_owned(), Shape::Count, value);
        let mut planned = vec![count("to_rest", field().count_left(elapsed()))];
        let ahead = Expr::local("to_rest").count_left(Expr::Count(spare));
        let (coordinates, chains) = self.planned_chains();
        if self.spec.schedule().is_some() {
            // A call of an earlier tick may have more of them than the table.
            let most = Expr::Count(longest(&chains, self.spec.precision));
            planned.push(Statement::Begin(AHEAD.to_owned(), Shape::Count, ahead));
            let beyond = Test::CountLess(most.clone(), Expr::local(AHEAD));
            let set = vec![Statement::Set(Place::Local(AHEAD.to_owned()), most)];
            planned.push(Statement::If(beyond, set, Vec::new()));
        } else {
            planned.push(count(AHEAD, ahead));
        }
        planned.extend(coordinates);
        let below = self.below(rest(&chains), &mut planned);
        let search = Search { first: Expr::local(AHEAD), below, held: true, keeps_first: true };
        planned.extend(self.search(&chains, search));
        let whole = elapsed().count_add(Expr::local(KEPT)).count_add(Expr::Count(spare));
        let set = vec![Statement::Set(Place::Local(NOW.to_owned()), whole)];
        let changes = match self.flight().is_some_and(|flight| flight.soonest) {
            true => Expr::Count(0),
            false => Expr::local(AHEAD),
        };
        // Beyond, the sum might wrap.
        let test = Test::CountLess(changes, Expr::local(KEPT));
        let test = test.and(Test::CountLess(elapsed(), Expr::Count(MAX_SAMPLES)));
        planned.push(Statement::If(test, set, Vec::new()));
        let judge =
            |number| vec![Statement::Set(Place::Local(LATE.to_owned()), Expr::Count(number))];
        let none = Test::CountEqual(Expr::local(KEPT), Expr::Count(0));
        let none = none.and(Test::CountLess(Expr::Count(0), Expr::local(AHEAD)));
        planned.push(Statement::If(none, judge(2), Vec::new()));
        // u is 0 then.
        if self.spec.after == After::Zero {
            let going = Test::CountLess(elapsed(), field());
            planned = vec![Statement::If(going, planned, Vec::new())];
        }
        body.push(Statement::Begin(LATE.to_owned(), Shape::Count, Expr::Count(0)));
        body.extend(planned);
        // The field is set before the end of the call asks.
        let later = Test::CountLess(field(), Expr::local(NOW));
        body.push(Statement::If(later, judge(1), Vec::new()));
        body
    }

    /// The samples to go above which a step plans.
    fn below(&self, rest: u32, body: &mut Vec<Statement>) -> Expr {
        let ahead = || Expr::local(AHEAD);
        if !self.flight().is_some_and(|flight| flight.soonest) {
            return ahead().count_left(Expr::Count(1));
        }
        let set = |value| vec![Statement::Set(Place::Local("below".to_owned()), value)];
        let forward = ahead().count_over(FORWARD);
        let from = ahead().count_left(Expr::Count(1)).count_left(forward);
        body.push(Statement::Begin("below".to_owned(), Shape::Count, from));
        // Gains that are held are planned no further.
        let held = Test::CountLess(Expr::Count(rest), ahead());
        let least = Test::CountLess(Expr::local("below"), Expr::Count(rest));
        let at_least = vec![Statement::If(least, set(Expr::Count(rest)), Vec::new())];
        body.push(Statement::If(held, at_least, set(ahead().count_left(Expr::Count(1)))));
        Expr::local("below")
    }

    /// The tests of a step that tracks, and its status where one holds.
    pub(in crate::samples) fn outcomes_of_plan(&self) -> Vec<(Test, Status)> {
        let is = |number| Test::CountEqual(Expr::local(LATE), Expr::Count(number));
        match self.replans() {
            true => vec![(is(1), Status::Late), (is(2), Status::Infeasible)],
            false => Vec::new(),
        }
    }
}
