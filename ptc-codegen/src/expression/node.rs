//! Expressions as handles of nodes, of which equal ones exist once: a copy costs a counter, a
//! comparison is one of addresses, and what occurs often is kept, and worked on, once.
//!
//! The table holds weak entries, so that it is as large as what is in use. Nothing is ordered by
//! hashes or addresses: the order of expressions is that of their structure.

use std::cmp::Ordering;
use std::collections::HashMap;
use std::fmt;
use std::hash::{BuildHasherDefault, DefaultHasher, Hash, Hasher};
use std::mem::replace;
use std::sync::{Arc, Mutex, PoisonError, Weak};

use super::{Function, Variable};
use crate::algebra::BigRational;
use crate::parameter::Parameter;

/// What an expression is, outermost.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Node {
    /// An exact number.
    Number(BigRational),
    /// The circle constant.
    Pi,
    /// A parameter: run-time, or fixed.
    Parameter(Parameter),
    /// What time and state decide.
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

/// What a node alone held is taken apart in a loop, as its height may be that of the stack.
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
    /// What it is, outermost.
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
    /// By structure. The first operands that differ decide, so that this goes down one path.
    fn cmp(&self, other: &Self) -> Ordering {
        if self == other { Ordering::Equal } else { self.node().cmp(other.node()) }
    }
}

impl fmt::Debug for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{self}`")
    }
}

/// The hash of what has hashed itself.
#[derive(Default)]
pub(crate) struct Hashed(u64);

impl Hasher for Hashed {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = self.0.rotate_left(8) ^ u64::from(*byte);
        }
    }

    fn write_u64(&mut self, hash: u64) {
        self.0 = hash;
    }
}

/// What is found of each expression, to be looked up and never listed.
pub(crate) type Found<T> = HashMap<Expression, T, BuildHasherDefault<Hashed>>;

/// Parts of the table, so that threads seldom wait for each other.
const SHARDS: usize = 16;

/// Entries from which on a part of the table is rid of what is no longer in use.
const FEW: usize = 1024;

static TABLE: [Mutex<Table>; SHARDS] = [const { Mutex::new(Table::new()) }; SHARDS];

/// The nodes in use, by their hashes.
struct Table {
    entries: HashMap<u64, Entry, BuildHasherDefault<Hashed>>,
    /// Entries at which it is swept: twice those that were in use the last time.
    most: usize,
}

/// The nodes of one hash: almost always one.
struct Entry {
    first: Weak<Shared>,
    more: Vec<Weak<Shared>>,
}

impl Table {
    const fn new() -> Self {
        Self { entries: HashMap::with_hasher(BuildHasherDefault::new()), most: FEW }
    }

    /// The expression of a node, which is the one that is there.
    fn interned(&mut self, node: Node, hash: u64) -> Expression {
        if let Some(entry) = self.entries.get(&hash) {
            let all = std::iter::once(&entry.first).chain(&entry.more);
            if let Some(there) = all.filter_map(Weak::upgrade).find(|there| there.node == node) {
                return Expression(there);
            }
        }
        let shared = Arc::new(Shared::of(node, hash));
        self.insert(Arc::downgrade(&shared), hash);
        Expression(shared)
    }

    fn insert(&mut self, weak: Weak<Shared>, hash: u64) {
        if self.entries.len() >= self.most {
            self.entries.retain(|_, entry| entry.is_used());
            self.most = FEW.max(2 * self.entries.len());
        }
        match self.entries.get_mut(&hash) {
            Some(entry) if entry.first.strong_count() > 0 => entry.more.push(weak),
            Some(entry) => entry.first = weak,
            None => {
                self.entries.insert(hash, Entry { first: weak, more: Vec::new() });
            }
        }
    }
}

impl Entry {
    /// Whether one of its nodes is in use; the others are dropped.
    fn is_used(&mut self) -> bool {
        self.more.retain(|weak| weak.strong_count() > 0);
        self.first.strong_count() > 0 || !self.more.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::integer;

    fn state(j: usize) -> Expression {
        Variable::State(j).into()
    }

    /// Entries of the table that are in use or not yet swept.
    fn entries() -> usize {
        let len = |shard: &Mutex<Table>| {
            shard.lock().unwrap_or_else(PoisonError::into_inner).entries.len()
        };
        TABLE.iter().map(len).sum()
    }

    #[test]
    fn equal_expressions_are_one_on_all_threads() {
        let build = || {
            let sum = (1..200).map(|j| state(j).mul(integer(3).into())).reduce(Expression::add);
            Expression::call(Function::Sin, sum.expect("a sum"))
        };
        let workers: Vec<_> = (0..4).map(|_| std::thread::spawn(build)).collect();
        for worker in workers {
            assert!(Arc::ptr_eq(&worker.join().expect("a sum").0, &build().0));
        }
        assert_ne!(build(), build().neg());
    }

    #[test]
    fn what_is_deep_and_what_is_shared_is_dropped() {
        let deep = (0..1_000_000).fold(state(901), |e, _| Expression::call(Function::Sin, e));
        assert_eq!((deep.height(), deep.size()), (1_000_000, 1_000_001));
        drop(deep);
        let shared = (0..1000).fold(state(902), |e, _| e.clone().mul(e));
        assert_eq!((shared.height(), shared.size(), shared.nodes()), (1000, usize::MAX, 1001));
    }

    #[test]
    fn the_table_is_as_large_as_what_is_in_use() {
        let start = entries();
        for round in 0..200 {
            let kept: Vec<_> = (0..2000).map(|k| state(1000 + k + 2000 * round)).collect();
            assert_eq!(kept[7], state(1007 + 2000 * round));
        }
        // 400 000 nodes were made. Each part holds up to twice what it held in use, and other tests.
        assert!(entries() < start + 100_000, "{start}, {}", entries());
    }

    #[test]
    fn expressions_are_ordered_by_structure() {
        let (a, b) = (state(1), state(2));
        let sorted = [
            Expression::integer(2),
            Expression::pi(),
            a.clone(),
            b.clone(),
            a.clone().neg(),
            a.clone().add(b.clone()),
            b.clone().add(a.clone()),
            a.mul(b.clone()),
            Expression::call(Function::Sin, b),
        ];
        for (i, first) in sorted.iter().enumerate() {
            for (j, second) in sorted.iter().enumerate() {
                assert_eq!(first.cmp(second), i.cmp(&j), "{first} and {second}");
            }
        }
    }
}
