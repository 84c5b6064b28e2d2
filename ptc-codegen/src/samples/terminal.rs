//! The last samples of a law: from when on another law takes its place, and which one.

use std::ops::{Add, Div, Sub};

use num_traits::ToPrimitive;

use super::controller::Builder;
use super::ends::{Ending, Terminal, end_of_law};
use super::feedback::Wanted;
use super::formula::{Flat, Now};
use super::rows::rows_of_least_energy;
use crate::algebra::{BigRational, integer};
use crate::code::{Expr, Shape, Statement, Test};
use crate::parameter::Parameter;
use crate::request::EndLaw;

/// The time from which on the terminal law holds.
pub(super) enum Takeover {
    Never,
    /// From the first sample on at which this test fails.
    Sample(Test),
    Start,
}

/// The samples to go as a formula counts them, with the statements that set them.
pub(super) struct Counted {
    pub(super) statements: Vec<Statement>,
    pub(super) now: Now,
}

/// The samples to go, of the law and of its end.
pub(super) struct Countdown {
    /// Statements before either.
    pub(super) before: Vec<Statement>,
    pub(super) takeover: Takeover,
    pub(super) law: Counted,
    last: Counted,
    /// A test that the gains of the end are not the last.
    goes_on: Test,
}

impl Ending {
    /// The samples to go to rest as it is planned, where those to sample N are a local value.
    pub(super) fn planned(&self) -> Expr {
        Expr::local("left").real().sub(Expr::integer(self.spare.into()))
    }
}

impl Builder<'_> {
    /// Statements of the law of the last samples.
    pub(super) fn terminal(
        &mut self,
        ending: &Ending,
        flat: &Flat,
        law: &Wanted,
        count: Countdown,
    ) -> Vec<Statement> {
        match &ending.terminal {
            Terminal::LeastEnergy(end) => self.least_energy(*end, flat, law, count),
            Terminal::Itself | Terminal::Deadbeat(_) => {
                vec![Statement::Note("Deadbeat.".to_owned()), law.is(self.deadbeat(flat))]
            }
        }
    }

    /// The law of least energy, whose gains of as many samples as the loop has states are the last.
    fn least_energy(
        &mut self,
        end: EndLaw,
        flat: &Flat,
        law: &Wanted,
        count: Countdown,
    ) -> Vec<Statement> {
        let own = rows_of_least_energy(end.law, flat.order()).into_iter().map(Expr::Number);
        let Counted { statements: mut softly, now } = count.last;
        let (before, value) =
            self.formula(flat, &own.collect::<Vec<_>>(), ["y", "end", "m1f"], &now);
        softly.extend(before);
        softly.push(law.is(value));
        let mut statements =
            vec![Statement::Note("The law of least energy to the end.".to_owned())];
        if self.closes() {
            let closing = vec![law.is(self.deadbeat(flat))];
            statements.push(Statement::If(count.goes_on, softly, closing));
        } else {
            statements.extend(softly);
        }
        statements
    }

    /// Returns true if the last gains, which are those of deadbeat, are written down: where a plant has fast modes its
    /// drift cancels in the formula of the law, and digits with it.
    fn closes(&self) -> bool {
        self.sampled.linear.is_some()
    }

    /// Returns the samples to go, and from when on the terminal law holds.
    pub(super) fn count_down(&mut self, ending: &Ending, samples: &Expr) -> Countdown {
        let hold = self.hold();
        let from = self.terminal_from(ending, hold.is_some());
        let whole_from = match &from {
            None => Some(None),
            Some(from) => from.number().and_then(ToPrimitive::to_u32).map(Some),
        };
        match (samples, hold, whole_from) {
            (Expr::Count(samples), None, Some(from)) => self.count_of(ending, *samples, from),
            (_, hold, _) => self.count_at_run_time(ending, samples, hold, from),
        }
    }

    /// Counts down from a known N to gains that are not held: whole numbers, of which a proof sees that no divisor is 0.
    fn count_of(&self, ending: &Ending, samples: u32, from: Option<u32>) -> Countdown {
        let order = self.spec.loop_order();
        let elapsed = || Expr::local("elapsed");
        let planned = samples.saturating_sub(ending.spare);
        let states = u32::try_from(order).unwrap_or(u32::MAX);
        let before =
            |last: u32| Test::CountLess(elapsed(), Expr::Count(planned.saturating_sub(last)));
        let left =
            |shift: u32| Expr::Count(planned.saturating_add(shift)).count_sub(elapsed()).real();
        // The gains of as many samples as there are states are the last.
        let left_to_last = |shift: u32| {
            let last = Expr::integer(i64::from(states) + i64::from(shift));
            Expr::choose(before(states), left(shift), last)
        };
        let set = |name: &str, value: Expr| {
            let name = self.named(name);
            let now = Now { left: Expr::local(&name), shift: 0 };
            Counted { statements: vec![Statement::Let(name, Shape::Real, value)], now }
        };
        let end = ending.terminal.shift(order);
        let last = set("m1", if self.closes() { left(end) } else { left_to_last(end) });
        let goes_on = before(states);
        let (takeover, law) = match from {
            None => (Takeover::Never, left_to_last(ending.shift)),
            // So few samples are those of the end from the first.
            Some(from) if planned <= from => (Takeover::Start, left(ending.shift)),
            Some(from) => (Takeover::Sample(before(from)), left(ending.shift)),
        };
        Countdown { before: Vec::new(), takeover, law: set("m0", law), last, goes_on }
    }

    /// Counts down where N is left to run time, or gains are held.
    fn count_at_run_time(
        &mut self,
        ending: &Ending,
        samples: &Expr,
        hold: Option<Expr>,
        from: Option<Expr>,
    ) -> Countdown {
        let order = self.spec.loop_order();
        let left = Self::counted(samples).count_left(Expr::local("elapsed"));
        let mut before = vec![Statement::Let("left".to_owned(), Shape::Count, left)];
        let planned = ending.planned();
        let known = hold.as_ref().and_then(Expr::number).cloned();
        let mut left = planned.clone();
        if let Some(hold) = hold {
            left = left.max(self.keep("hold", "samples to go at which the gains are held", hold));
        }
        if ending.terminal == Terminal::Itself && !self.closes() {
            // Held numbers are one of the two.
            left = match &known {
                Some(hold) if *hold >= BigRational::from_integer(order.into()) => left,
                Some(_) => planned.max(whole(order)),
                None => left.max(whole(order)),
            };
        }
        let [m0, m1] = ["m0", "m1"].map(|name| self.named(name));
        before.push(Statement::Let(m0.clone(), Shape::Real, left));
        let now = Expr::local(m0);
        let counted = |statements, left: &Expr, shift| Counted {
            statements,
            now: Now { left: left.clone(), shift },
        };
        let law = counted(Vec::new(), &now, ending.shift);
        let shift = ending.terminal.shift(order);
        let last = match self.closes() {
            true => counted(Vec::new(), &now, shift),
            false => {
                let least = Statement::Let(m1.clone(), Shape::Real, now.clone().max(whole(order)));
                counted(vec![least], &Expr::local(m1), shift)
            }
        };
        let goes_on = Test::Less(whole(order), now.clone());
        let always = known.as_ref().zip(from.as_ref().and_then(Expr::number));
        let takeover = match from {
            Some(from) if always.is_none_or(|(hold, from)| hold <= from) => {
                let (name, about) = match ending.terminal {
                    Terminal::LeastEnergy(_) => {
                        ("end_samples", "samples to go at which the law of the end takes over")
                    }
                    Terminal::Itself | Terminal::Deadbeat(_) => {
                        ("deadbeat", "samples to go at which deadbeat takes over")
                    }
                };
                let from = self.keep(&self.named(name), about, from);
                Takeover::Sample(Test::Less(from, now))
            }
            _ => Takeover::Never,
        };
        Countdown { before, takeover, law, last, goes_on }
    }

    /// Samples to go at which another law takes over, where one does.
    fn terminal_from(&self, ending: &Ending, held: bool) -> Option<Expr> {
        let order = self.spec.loop_order();
        let given = match &ending.terminal {
            Terminal::Itself => {
                return self.closes().then(|| whole(order));
            }
            Terminal::LeastEnergy(end) => return Some(Expr::integer(end.samples.into())),
            Terminal::Deadbeat(given) => given,
        };
        if held {
            // Held gains need no end, but below this the law does not exist.
            return Some(Expr::Number(end_of_law(order)));
        }
        if let Some(given) = given {
            return Some(Expr::Number(BigRational::from_integer(given.clone())));
        }
        // The exponents sum to k_m/a, and all but one of them are at least m - 1.
        let square = integer(i64::try_from((order - 1) * (order - 1)).unwrap_or(0));
        let sum = self.parameter(Parameter::Gain(order)).div(self.parameter(Parameter::A));
        let last = integer(i64::try_from(order).unwrap_or(0));
        let safe = sum.sub(Expr::Number(square)).add(Expr::Number(last.clone()));
        let safe = safe.max(Expr::Number(last * integer(2)));
        let given = Expr::Parameter(Parameter::Deadbeat.key().to_owned());
        Some(Expr::choose(Test::Less(Expr::integer(0), given.clone()), given, safe))
    }
}

fn whole(count: usize) -> Expr {
    Expr::Number(BigRational::from_integer(count.into()))
}
