//! Walks over expressions, each of which comes by a node once.

use std::collections::{BTreeSet, HashSet};
use std::hash::BuildHasherDefault;

use super::node::Hashed;
use super::{Expression, Found, Node, Variable};
use crate::algebra::BigRational;
use crate::parameter::Parameter;

/// Sizes up to which a walk may come by a node again: to remember those of so few takes longer.
const SMALL: usize = 48;

/// Function applied to each operand, from the left.
type Each<'a> = &'a mut dyn FnMut(&Expression) -> Expression;

impl Expression {
    /// Returns true if a walk may visit parts repeatedly rather than remember them.
    pub(crate) fn is_small(&self) -> bool {
        self.size() <= SMALL
    }

    /// The same operation, its operands replaced by what `of` makes of them, from the left.
    pub(crate) fn rebuilt(&self, of: Each<'_>) -> Self {
        match self.node() {
            Node::Number(_) | Node::Pi | Node::Parameter(_) | Node::Variable(_) => self.clone(),
            Node::Neg(a) => of(a).neg(),
            Node::Call(function, a) => Self::call(*function, of(a)),
            Node::Add(a, b) => of(a).add(of(b)),
            Node::Sub(a, b) => of(a).sub(of(b)),
            Node::Mul(a, b) => of(a).mul(of(b)),
            Node::Div(a, b) => of(a).div(of(b)),
            Node::Power(a, b) => of(a).power(of(b)),
            Node::Min(a, b) => of(a).min(of(b)),
            Node::Max(a, b) => of(a).max(of(b)),
        }
    }

    /// The same expression with `to` in place of the parts for which it gives something.
    pub fn substitute(&self, to: &dyn Fn(&Self) -> Option<Self>) -> Self {
        self.substituted(to, Self::rebuilt, &mut Found::default())
    }

    /// The same with the numbers of the parameters that have one.
    pub fn known(&self, number: &dyn Fn(Parameter) -> Option<BigRational>) -> Self {
        self.substitute(&|e| number(e.parameter()?).map(Self::from))
    }

    /// The same, in which 0*e and e^0 stay, as the whole has no value where e has none.
    pub fn put(&self, to: &dyn Fn(&Self) -> Option<Self>) -> Self {
        self.substituted(to, Self::kept, &mut Found::default())
    }

    fn kept(&self, of: Each<'_>) -> Self {
        match self.node() {
            Node::Mul(a, b) => match (of(a), of(b)) {
                (a, b) if a.is(0) || b.is(0) => Node::Mul(a, b).into(),
                (a, b) => a.mul(b),
            },
            Node::Power(a, b) => match (of(a), of(b)) {
                (a, b) if b.is(0) => Node::Power(a, b).into(),
                (a, b) => a.power(b),
            },
            _ => self.rebuilt(of),
        }
    }

    fn substituted(
        &self,
        to: &dyn Fn(&Self) -> Option<Self>,
        rebuilt: fn(&Self, Each<'_>) -> Self,
        found: &mut Found<Self>,
    ) -> Self {
        if let Some(known) = found.get(self) {
            return known.clone();
        }
        let new =
            to(self).unwrap_or_else(|| rebuilt(self, &mut |e| e.substituted(to, rebuilt, found)));
        if self.height() > 0 {
            found.insert(self.clone(), new.clone());
        }
        new
    }

    /// Returns true if `wanted` holds for it or anything in it.
    pub fn any(&self, wanted: &dyn Fn(&Self) -> bool) -> bool {
        self.first(&mut |e| wanted(e).then_some(())).is_some()
    }

    /// Returns the first result of `find`, from the outside in and from the left.
    pub(crate) fn first<T>(&self, find: &mut dyn FnMut(&Self) -> Option<T>) -> Option<T> {
        if self.is_small() {
            return self.first_written(find);
        }
        let mut seen = Seen::default();
        let mut left = vec![self];
        while let Some(e) = left.pop() {
            if !seen.insert(e) {
                continue;
            }
            if let Some(found) = find(e) {
                return Some(found);
            }
            let from = left.len();
            left.extend(e.operands());
            left[from..].reverse();
        }
        None
    }

    fn first_written<T>(&self, find: &mut dyn FnMut(&Self) -> Option<T>) -> Option<T> {
        find(self).or_else(|| self.operands().find_map(|e| e.first_written(find)))
    }

    /// Does `visit` for it and everything in it, from the outside in, at least once for each.
    pub(crate) fn each(&self, visit: &mut dyn FnMut(&Self)) {
        self.first::<()>(&mut |e| {
            visit(e);
            None
        });
    }

    /// Returns true if anything in it varies while the controller runs.
    pub fn varies(&self) -> bool {
        self.any(&|part| part.variable().is_some())
    }

    /// Returns true if `variable` occurs in it.
    pub fn contains(&self, variable: Variable) -> bool {
        self.any(&|e| e.variable() == Some(variable))
    }

    /// Its parameters, in their own order, each once.
    pub fn parameters(&self) -> BTreeSet<Parameter> {
        let mut found = BTreeSet::new();
        self.each(&mut |e| found.extend(e.parameter()));
        found
    }

    /// Number of its operations and leaves, each counted once however often it occurs.
    pub(crate) fn nodes(&self) -> usize {
        let mut seen = Seen::default();
        let mut left = vec![self];
        while let Some(e) = left.pop() {
            if seen.insert(e) {
                left.extend(e.operands());
            }
        }
        seen.len()
    }
}

/// The expressions that a walk has come by.
type Seen<'a> = HashSet<&'a Expression, BuildHasherDefault<Hashed>>;
