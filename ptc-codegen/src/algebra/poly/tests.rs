//! Inverses, derivatives and substitutions of small polynomials.

use super::*;
use crate::algebra::Kind;

fn t() -> Poly {
    Poly::symbol(Symbol::plain(Kind::TimeToGo))
}

#[test]
fn powers_cancel_to_nothing_left() {
    let inverse = t().inverse().expect("a single term");
    assert_eq!(t().times(&inverse), Poly::one());
    assert!(t().plus(&t().scaled(&integer(-1))).is_zero());
}

#[test]
fn derivation_follows_the_chain_rule() {
    // D T = -T, so D T^-3 = 3 T^-3.
    let cube = t().pow(3).inverse().expect("a single term");
    let derived = cube.derive(|_| Some(t().scaled(&integer(-1))));
    assert_eq!(derived, cube.scaled(&integer(3)));
}

#[test]
fn collect_and_substitute_agree() {
    let a = Symbol::plain(Kind::A);
    let p = t().plus(&Poly::symbol(a)).pow(2);
    let collected = p.collect(a);
    assert_eq!(collected.len(), 3);
    assert_eq!(collected[&1], t().scaled(&integer(2)));
    let at_one = p.substitute(|s| (s == a).then(Poly::one));
    assert_eq!(at_one, t().plus(&Poly::one()).pow(2));
}
