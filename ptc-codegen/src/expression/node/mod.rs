//! Expressions as handles of nodes, of which equal ones exist once: a copy costs a counter, a
//! comparison is one of addresses, and what occurs often is kept, and worked on, once.
//!
//! The table holds weak entries, so that it is as large as what is in use. Nothing is ordered by
//! hashes or addresses: the order of expressions is that of their structure.

mod table;
#[cfg(test)]
mod tests;

pub(crate) use table::{Found, Hashed};

use std::cmp::Ordering;
use std::fmt;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::mem::replace;
use std::sync::{Arc, PoisonError};

use super::{Function, Variable};
use crate::algebra::BigRational;
use crate::parameter::Parameter;
use table::{SHARDS, TABLE};

/// Outermost operation or operand of an expression.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Node {
    /// An exact number.
    Number(BigRational),
    /// The circle constant.
    Pi,
    /// A parameter: run-time, or fixed.
    Parameter(Parameter),
    /// A variable, given by time and state.
    Variable(Variable),
    /// -a.
    Neg(Expression),
    /// a + b.
    Add(Expression, Expression),
    /// a - b.
    Sub(Expression, Expression),
    /// a * b.
    Mul(Expression, Expression),
    /// a / b.
    Div(Expression, Expression),
    /// a ^ b.
    Power(Expression, Expression),
    /// The smaller one.
    Min(Expression, Expression),
    /// The greater one.
    Max(Expression, Expression),
    /// A function of one number.
    Call(Function, Expression),
}

impl Node {
    /// Its operands, from the left.
    fn operands(&self) -> [Option<&Expression>; 2] {
        match self {
            Self::Number(_) | Self::Pi | Self::Parameter(_) | Self::Variable(_) => [None, None],
            Self::Neg(a) | Self::Call(_, a) => [Some(a), None],
            Self::Add(a, b)
            | Self::Sub(a, b)
            | Self::Mul(a, b)
            | Self::Div(a, b)
            | Self::Power(a, b)
            | Self::Min(a, b)
            | Self::Max(a, b) => [Some(a), Some(b)],
        }
    }

    fn into_operands(self) -> [Option<Expression>; 2] {
        match self {
            Self::Number(_) | Self::Pi | Self::Parameter(_) | Self::Variable(_) => [None, None],
            Self::Neg(a) | Self::Call(_, a) => [Some(a), None],
            Self::Add(a, b)
            | Self::Sub(a, b)
            | Self::Mul(a, b)
            | Self::Div(a, b)
            | Self::Power(a, b)
            | Self::Min(a, b)
            | Self::Max(a, b) => [Some(a), Some(b)],
        }
    }
}

/// An expression: a handle of its outermost node. Its height is bounded by the parser, and by what
/// differentiates it, so that walking it may recurse.
#[derive(Clone)]
pub struct Expression(Arc<Shared>);

/// A node, and what is known of the expression below it.
struct Shared {
    node: Node,
    hash: u64,
    size: usize,
    height: usize,
}

impl Shared {
    fn of(node: Node, hash: u64) -> Self {
        let (mut size, mut height) = (1, 0);
        for operand in node.operands().into_iter().flatten() {
            size = operand.size().saturating_add(size);
            height = height.max(operand.height() + 1);
        }
        Self { node, hash, size, height }
    }
}

/// Takes operands that only this node holds apart in a loop: recursion to their height might overflow the stack.
impl Drop for Shared {
    fn drop(&mut self) {
        let mut alone = Vec::new();
        release(&mut self.node, &mut alone);
        while let Some(mut shared) = alone.pop() {
            release(&mut shared.node, &mut alone);
        }
    }
}

/// Takes the operands from a node, and keeps those that nothing else holds.
fn release(node: &mut Node, alone: &mut Vec<Shared>) {
    let operands = replace(node, Node::Pi).into_operands();
    alone.extend(operands.into_iter().flatten().filter_map(|operand| Arc::into_inner(operand.0)));
}

impl Expression {
    /// Returns the outermost node.
    pub fn node(&self) -> &Node {
        &self.0.node
    }

    /// Its operands, from the left.
    pub fn operands(&self) -> impl Iterator<Item = &Self> {
        self.0.node.operands().into_iter().flatten()
    }

    /// Number of its operations and leaves as it is written out, in which what occurs often counts
    /// as often.
    pub(crate) fn size(&self) -> usize {
        self.0.size
    }

    /// Operations on the longest way to a leaf.
    pub(crate) fn height(&self) -> usize {
        self.0.height
    }
}

impl From<Node> for Expression {
    fn from(node: Node) -> Self {
        let mut hasher = DefaultHasher::new();
        node.hash(&mut hasher);
        let hash = hasher.finish();
        let shard = &TABLE[usize::from((hash >> 32) as u8) % SHARDS];
        shard.lock().unwrap_or_else(PoisonError::into_inner).interned(node, hash)
    }
}

impl PartialEq for Expression {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for Expression {}

impl Hash for Expression {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_u64(self.0.hash);
    }
}

impl PartialOrd for Expression {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Expression {
    /// Compares by structure. The first operands that differ decide, so that this goes down one path.
    fn cmp(&self, other: &Self) -> Ordering {
        if self == other { Ordering::Equal } else { self.node().cmp(other.node()) }
    }
}

impl fmt::Debug for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{self}`")
    }
}
