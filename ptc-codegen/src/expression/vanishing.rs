//! Forms that keep their digits at the deadline: a sum that is 0 there, `1 - (1 - T/tau)^1.5`, is the difference
//! from its own value there, which is formed operand by operand and rounds nothing away.

mod at_deadline;
mod difference;
mod terms;

use at_deadline::AtDeadline;
use terms::grouped;

use super::effort::{bounded, spend};
use super::normal::{normal, within};
use super::{Expression, Found, Function, Node, Variable};

/// The same function of `v`, each part that falls to 0 at the deadline formed from what falls with it: `v` is the
/// time-to-go T > 0, or stretched time, which grows without bound. Parameters are taken as positive.
pub(crate) fn vanishing(form: &Expression, v: Variable) -> Expression {
    let forms = Forms {
        ends: AtDeadline::of(v),
        kept: Found::default(),
        differences: Found::default(),
        rewritten: 0,
    };
    within(Some(bounded(|| { forms }.kept(form))), form)
}

/// The order to which a sum may be 0.
const MOST: usize = 6;

/// The forms of what was met so far.
struct Forms {
    ends: AtDeadline,
    kept: Found<Expression>,
    differences: Found<Option<Expression>>,
    /// Number of forms of forms within which this one is looked for.
    rewritten: usize,
}

impl Forms {
    /// The expression in a form that keeps its digits.
    fn kept(&mut self, e: &Expression) -> Expression {
        if e.height() == 0 || !self.ends.moves(e) || spend(1).is_none() {
            return e.clone();
        }
        if let Some(known) = self.kept.get(e) {
            return known.clone();
        }
        let cancels = self.cancels(e) && self.ends.vanishes(e);
        let difference = cancels.then(|| self.difference(e)).flatten();
        let kept = difference.unwrap_or_else(|| e.rebuilt(&mut |operand| self.kept(operand)));
        self.kept.insert(e.clone(), kept.clone());
        kept
    }

    /// Returns true if a value of 0 at the deadline is the difference of others, as in a sum, ln(1) or cos(pi/2).
    fn cancels(&mut self, e: &Expression) -> bool {
        match e.node() {
            Node::Add(..) | Node::Sub(..) => true,
            Node::Call(function, a) => {
                *function != Function::Exp && self.ends.value(a).is_some_and(|end| !end.is(0))
            }
            _ => false,
        }
    }

    /// The expression less its value at the deadline; `None` where no such form is known.
    fn difference(&mut self, e: &Expression) -> Option<Expression> {
        spend(1)?;
        if !self.ends.moves(e) {
            return Some(Expression::integer(0));
        }
        if !self.cancels(e) && self.ends.vanishes(e) {
            return Some(self.kept(e));
        }
        if let Some(known) = self.differences.get(e) {
            return known.clone();
        }
        let found = self.difference_of(e).or_else(|| self.normal_difference(e));
        let found = found.map(|difference| self.collected(difference));
        self.differences.insert(e.clone(), found.clone());
        found
    }

    /// A difference whose terms are collected by what falls to 0 in them, as the rest may fall to 0 too: 4 d x - 2 d
    /// is 4 d (x - 1/2).
    fn collected(&mut self, difference: Expression) -> Expression {
        let groups = grouped(&difference, &mut |e| self.ends.vanishes(e));
        let Some(groups) = groups.filter(|_| self.rewritten < MOST) else { return difference };
        self.rewritten += 1;
        let parts = groups.into_iter().map(|(factor, rest)| factor.mul(self.kept(&rest)));
        let sum = parts.reduce(Expression::add).unwrap_or(difference);
        self.rewritten -= 1;
        sum
    }

    /// The normal form of the difference where that is no sum: t/(1 + t) - 1 is -1/(1 + t).
    fn normal_difference(&mut self, e: &Expression) -> Option<Expression> {
        let end = self.ends.value(e)?;
        let form = normal(&e.clone().sub(end));
        (!self.cancels(&form) && self.rewritten < MOST).then(|| {
            self.rewritten += 1;
            let kept = self.kept(&form);
            self.rewritten -= 1;
            kept
        })
    }
}

#[cfg(test)]
mod tests;
