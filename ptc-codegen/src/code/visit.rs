//! Walks over statements and ends.

use super::{Cell, Code, Expr, Finish, Index, Place, Statement, Subroutine, Whose};

impl Statement {
    /// Calls `look` on every expression of the statement, those in it included.
    pub fn visit(&self, look: &mut dyn FnMut(&Expr)) {
        match self {
            Self::Let(_, _, value)
            | Self::Begin(_, _, value)
            | Self::Set(_, value)
            | Self::Root(_, value) => value.visit(look),
            Self::Require(test, _) => test.visit(look),
            Self::If(test, yes, no) => {
                test.visit(look);
                yes.iter().chain(no).for_each(|statement| statement.visit(look));
            }
            Self::Array(_, values) => values.iter().for_each(|value| value.visit(look)),
            Self::For(each) => each.body.iter().for_each(|statement| statement.visit(look)),
            Self::Apply { given, .. } => given.iter().flatten().for_each(|value| value.visit(look)),
            Self::Call { times, .. } => times.iter().for_each(|value| value.visit(look)),
            Self::Leave
            | Self::Note(_)
            | Self::Settle(..)
            | Self::Variable(..)
            | Self::View { .. } => {}
        }
    }
}

impl Statement {
    /// Returns true if it reads a local value that is the index of a loop around it.
    pub fn reads(&self, index: &str) -> bool {
        let has = |place: &Index| place.terms.iter().any(|(_, name)| name == index);
        let mut found = false;
        self.visit(&mut |value| {
            found |= match value {
                Expr::Local(name) => name == index,
                Expr::At(_, place) | Expr::Entry(_, Cell { row: place, .. }) => has(place),
                _ => false,
            };
        });
        let within = |all: &[Self]| all.iter().any(|statement| statement.reads(index));
        found
            || match self {
                Self::Set(Place::Element(_, place) | Place::Input(place), _) => has(place),
                Self::Settle(Whose::Input(place), _) => has(place),
                Self::If(_, yes, no) => within(yes) || within(no),
                Self::For(each) => has(&each.from) || has(&each.to) || within(&each.body),
                _ => false,
            }
    }
}

impl Finish {
    /// Calls `look` on every expression.
    pub fn visit(&self, look: &mut dyn FnMut(&Expr)) {
        match self {
            Self::If(test, yes, no) => {
                test.visit(look);
                yes.visit(look);
                no.visit(look);
            }
            Self::Give(values, _) => values.iter().for_each(|value| value.visit(look)),
            Self::Fail(_) | Self::Stands => {}
        }
    }
}

impl super::Function {
    /// Calls `look` on every expression.
    pub fn visit(&self, look: &mut dyn FnMut(&Expr)) {
        self.body.iter().for_each(|statement| statement.visit(look));
        self.finish.visit(look);
    }

    /// Returns true if `is` holds for a statement of its body, not within another one.
    pub fn has(&self, is: impl Fn(&Statement) -> bool) -> bool {
        self.body.iter().any(is)
    }

    /// The subroutines that it applies.
    pub fn subroutines(&self) -> impl Iterator<Item = Subroutine> {
        self.body.iter().filter_map(|statement| match statement {
            Statement::Apply { subroutine, .. } => Some(*subroutine),
            _ => None,
        })
    }
}

impl Code {
    /// The subroutines that its functions apply, each once.
    pub fn subroutines(&self) -> Vec<Subroutine> {
        let mut all = Vec::new();
        for subroutine in self.functions.iter().flat_map(super::Function::subroutines) {
            if !all.contains(&subroutine) {
                all.push(subroutine);
            }
        }
        all
    }

    /// Returns true if a function counts the rounds of a loop.
    pub fn counts(&self) -> bool {
        let loops = |statement: &Statement| matches!(statement, Statement::For(_));
        self.functions.iter().any(|function| function.has(loops)) || !self.subroutines().is_empty()
    }

    /// Calls `look` on every expression.
    pub fn visit(&self, look: &mut dyn FnMut(&Expr)) {
        self.init.iter().for_each(|statement| statement.visit(look));
        self.functions.iter().for_each(|function| function.visit(look));
    }
}
