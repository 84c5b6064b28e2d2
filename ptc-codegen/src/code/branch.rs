//! The branches of a program: each condition, taken either way.

use std::collections::BTreeSet;

use super::{Code, Expr, Finish, Statement, Subroutine, Test};

/// The branches that calls took; a condition is known by its place in the program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Taken(BTreeSet<(At, bool)>);

/// Kind of condition of a part of a program, or of the code that begins with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Asked {
    /// A test that is a part of its own.
    Test,
    /// The condition that a count is left.
    Left,
    /// The condition that a divisor is below 0.
    Negative,
    /// The condition that it is above 0, where it is not below.
    Positive,
    /// The condition that no pivot is 0.
    Regular,
}

/// Place of a condition: the address of the part of the program.
pub(super) type At = (usize, Asked);

/// The place of a condition of a part.
pub(super) fn at<T>(of: &T, asked: Asked) -> At {
    (std::ptr::from_ref(of).addr(), asked)
}

/// Condition that decides between two branches.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// A test.
    Test(Test),
    /// The condition that a divisor is above 0, where it is not below.
    Positive(Expr),
    /// The condition that no pivot of a system of so many unknowns is 0.
    Regular(usize),
}

/// One way out of a condition.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// The function in which it is.
    pub function: &'static str,
    /// The condition.
    pub condition: Condition,
    /// True if the condition holds on this branch.
    pub holds: bool,
    place: At,
}

impl Taken {
    #[cfg(feature = "files")]
    pub(super) fn insert(&mut self, place: At, holds: bool) {
        self.0.insert((place, holds));
    }

    /// Returns true if the condition at a place went this way.
    pub(super) fn went(&self, place: At, holds: bool) -> bool {
        self.0.contains(&(place, holds))
    }

    /// Returns true if a branch is among them.
    pub fn has(&self, branch: &Branch) -> bool {
        self.went(branch.place, branch.holds)
    }

    /// Returns true if one of them is not among `known`.
    pub fn adds_to(&self, known: &Self) -> bool {
        !self.0.is_subset(&known.0)
    }

    /// Takes in the `others`.
    pub fn extend(&mut self, others: &Self) {
        self.0.extend(&others.0);
    }
}

impl Code {
    /// Every branch of every function, in the order of the program. They are those of this very
    /// program: a copy has others.
    pub fn branches(&self) -> Vec<Branch> {
        let mut found = Vec::new();
        statements("init", &self.init, &mut found);
        for function in &self.functions {
            statements(function.name, &function.body, &mut found);
            finish(function.name, &function.finish, &mut found);
        }
        found
    }
}

fn statements(function: &'static str, all: &[Statement], found: &mut Vec<Branch>) {
    for statement in all {
        match statement {
            Statement::If(condition, yes, no) => {
                test(function, condition, found);
                statements(function, yes, found);
                statements(function, no, found);
            }
            Statement::Require(condition, _) => test(function, condition, found),
            other => {
                if let Statement::Apply { subroutine: Subroutine::Elimination(m), .. } = other {
                    both(function, Condition::Regular(*m), at(other, Asked::Regular), found);
                }
                other.visit(&mut |value| expression(function, value, found));
            }
        }
    }
}

fn finish(function: &'static str, end: &Finish, found: &mut Vec<Branch>) {
    if let Finish::If(condition, yes, no) = end {
        test(function, condition, found);
        finish(function, yes, found);
        finish(function, no, found);
    } else {
        end.visit(&mut |value| expression(function, value, found));
    }
}

fn test(function: &'static str, condition: &Test, found: &mut Vec<Branch>) {
    if let Test::All(tests) = condition {
        return tests.iter().for_each(|part| test(function, part, found));
    }
    both(function, Condition::Test(condition.clone()), at(condition, Asked::Test), found);
    condition.visit(&mut |value| expression(function, value, found));
}

/// The conditions of an expression itself; those in it are visited by themselves.
fn expression(function: &'static str, value: &Expr, found: &mut Vec<Branch>) {
    match value {
        Expr::Choose(condition, ..) => each(function, condition, found),
        Expr::CountLeft(a, b) => {
            let less = Test::CountLess((**b).clone(), (**a).clone());
            both(function, Condition::Test(less), at(value, Asked::Left), found);
        }
        Expr::Quotient(_, divisor) => {
            let divisor = (**divisor).clone();
            let negative = Test::Less(divisor.clone(), Expr::integer(0));
            both(function, Condition::Test(negative), at(value, Asked::Negative), found);
            both(function, Condition::Positive(divisor), at(value, Asked::Positive), found);
        }
        _ => {}
    }
}

/// The parts of a condition, the expressions in which are visited apart.
fn each(function: &'static str, condition: &Test, found: &mut Vec<Branch>) {
    match condition {
        Test::All(tests) => tests.iter().for_each(|part| each(function, part, found)),
        one => both(function, Condition::Test(one.clone()), at(one, Asked::Test), found),
    }
}

fn both(function: &'static str, condition: Condition, place: At, found: &mut Vec<Branch>) {
    for holds in [true, false] {
        found.push(Branch { function, condition: condition.clone(), holds, place });
    }
}
