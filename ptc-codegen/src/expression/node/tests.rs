//! Equal expressions are one node on any thread; they are ordered, and may be deep.

use super::*;
use crate::algebra::integer;

fn state(j: usize) -> Expression {
    Variable::State(j).into()
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
