//! Named intermediate values of a model. In expressions each is one shared node; a printed model shows its name.

use std::collections::BTreeSet;

use crate::expression::{Expression, Found, Variable};
use crate::parameter::{Name, Parameter};

/// The intermediate values of a model, in the order in which they are defined.
#[derive(Clone, Debug, Default)]
pub struct Intermediates(Vec<(Name, Expression)>);

impl PartialEq for Intermediates {
    /// Compares what is printed: a further name of a value, a number or a name changes nothing.
    fn eq(&self, other: &Self) -> bool {
        self.printed().eq(other.printed())
    }
}

impl Eq for Intermediates {}

impl Intermediates {
    /// No values.
    pub const fn none() -> Self {
        Self(Vec::new())
    }

    /// Adds a value, the earlier ones put in place.
    pub fn push(&mut self, name: Name, value: Expression) {
        self.0.push((name, value));
    }

    /// The name and the value of each.
    pub fn iter(&self) -> impl Iterator<Item = &(Name, Expression)> {
        self.0.iter()
    }

    /// The names as variables, which number them behind the first `behind` ones; [`Self::put`] puts the values in
    /// their places.
    pub fn variables(&self, behind: usize) -> impl Iterator<Item = (Name, Variable)> {
        (behind + 1..).map(Variable::State).zip(&self.0).map(|(place, (name, _))| (*name, place))
    }

    /// An expression with the values in place of their variables.
    pub fn put(&self, expression: &Expression, behind: usize) -> Expression {
        expression.substitute(&|e| match e.variable()? {
            Variable::State(j) => self.0.get(j.checked_sub(behind + 1)?).map(|(_, e)| e.clone()),
            _ => None,
        })
    }

    /// The name of an expression that is one of the first `count` values, and is no number or name itself.
    fn names(&self, count: usize) -> Found<Name> {
        let mut found = Found::default();
        for (name, value) in self.0.iter().take(count).filter(|(_, value)| value.height() > 0) {
            found.entry(value.clone()).or_insert(*name);
        }
        found
    }

    /// An expression in which the values have their names, and `leaf` gives those of the other parts.
    pub(crate) fn named(
        &self,
        expression: &Expression,
        leaf: &dyn Fn(&Expression) -> Option<Expression>,
    ) -> Expression {
        within(&self.names(self.0.len()), expression, leaf)
    }

    /// Returns true if a value is printed by its name.
    fn is_printed(&self, index: usize) -> bool {
        let value = &self.0[index].1;
        value.height() > 0 && self.0[..index].iter().all(|(_, other)| other != value)
    }

    /// The values that are printed by their names.
    fn printed(&self) -> impl Iterator<Item = &(Name, Expression)> {
        let own = self.0.iter().enumerate().filter(|(index, _)| self.is_printed(*index));
        own.map(|(_, value)| value)
    }

    /// The name of each value with its definition in terms of the earlier ones. A number or a name has no definition,
    /// and a value that is equal to an earlier one has the name of that.
    pub(crate) fn definitions(
        &self,
        leaf: &dyn Fn(&Expression) -> Option<Expression>,
    ) -> Vec<(Name, Expression)> {
        let printed = self.0.iter().enumerate().filter(|(index, _)| self.is_printed(*index));
        let named = |(index, (name, value)): (usize, &(Name, Expression))| {
            (*name, within(&self.names(index), value, leaf))
        };
        printed.map(named).collect()
    }
}

/// The definitions that `printed` expressions use, directly or through others.
pub(crate) fn used(
    mut definitions: Vec<(Name, Expression)>,
    printed: impl IntoIterator<Item = Expression>,
) -> Vec<(Name, Expression)> {
    let mut wanted: BTreeSet<_> = printed.into_iter().flat_map(|e| e.parameters()).collect();
    definitions.reverse();
    definitions.retain(|(name, value)| {
        let own = wanted.contains(&Parameter::Named(*name));
        if own {
            wanted.extend(value.parameters());
        }
        own
    });
    definitions.reverse();
    definitions
}

fn within(
    names: &Found<Name>,
    expression: &Expression,
    leaf: &dyn Fn(&Expression) -> Option<Expression>,
) -> Expression {
    expression.substitute(&|e| match names.get(e) {
        Some(name) => Some(Parameter::Named(*name).into()),
        None => leaf(e),
    })
}
