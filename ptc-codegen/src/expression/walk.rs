//! Walks over expressions, each of which comes by a node once.

use std::collections::{BTreeSet, HashSet};
use std::hash::BuildHasherDefault;

use super::node::Hashed;
use super::{Expression, Found, Node, Variable};
use crate::parameter::Parameter;

/// Sizes up to which a walk may come by a node again: to remember those of so few takes longer.
const SMALL: usize = 48;

impl Expression {
    /// The same operation, its operands replaced by what `of` makes of them, from the left.
    pub(crate) fn rebuilt(&self, mut of: impl FnMut(&Self) -> Self) -> Self {
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
        self.substituted(to, &mut Found::default())
    }

    fn substituted(&self, to: &dyn Fn(&Self) -> Option<Self>, found: &mut Found<Self>) -> Self {
        if let Some(known) = found.get(self) {
            return known.clone();
        }
        let new = to(self).unwrap_or_else(|| self.rebuilt(|e| e.substituted(to, found)));
        if self.height() > 0 {
            found.insert(self.clone(), new.clone());
        }
        new
    }

    /// Whether `wanted` holds for it or anything in it.
    pub fn any(&self, wanted: &dyn Fn(&Self) -> bool) -> bool {
        self.first(&mut |e| wanted(e).then_some(())).is_some()
    }

    /// What `find` gives first, from the outside in and from the left.
    fn first<T>(&self, find: &mut dyn FnMut(&Self) -> Option<T>) -> Option<T> {
        if self.size() <= SMALL {
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

    /// Does `visit` for it and everything in it, at least once for each.
    fn each(&self, visit: &mut dyn FnMut(&Self)) {
        self.first::<()>(&mut |e| {
            visit(e);
            None
        });
    }

    /// Whether `variable` occurs in it.
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
    #[cfg_attr(not(test), allow(dead_code))]
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
