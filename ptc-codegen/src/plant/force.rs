//! An f that is a sum of bounded symbols: within which numbers it stays, for a run and at any time.

use std::collections::BTreeMap;

use num_traits::Signed;

use super::Plant;
use crate::algebra::{BigRational, integer};
use crate::collect::map;
use crate::expression::normal::normal;
use crate::expression::{Expression, existence};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Entry, PlantBounds, Spec};
use crate::syntax::{Node, Value};

/// A symbol with its least and greatest value, and whether it is constant for all of a run.
pub(crate) type Bounded = (Parameter, [BigRational; 2], bool);

/// The middle of `f`, how far it may be from there for all of a run, and how far from that at any
/// time.
///
/// # Errors
/// That f is not a sum of bounded symbols.
pub(crate) fn force(
    f: &Expression,
    values: &BTreeMap<Parameter, BigRational>,
    bounded: &[Bounded],
) -> Result<[BigRational; 3], String> {
    let known = f.known(&|p| values.get(&p).cloned());
    let is = |e: &Expression, symbol: Parameter| *e == Expression::from(symbol);
    let other = || format!("f = {f} is not a sum of bounded symbols");
    // f with one of them 1, and the others 0.
    let with = |one: Option<Parameter>| {
        let value = |e: &Expression| {
            let (symbol, ..) = bounded.iter().find(|(symbol, ..)| is(e, *symbol))?;
            Some(Expression::integer(i64::from(one == Some(*symbol))))
        };
        let f = normal(&known.substitute(&value));
        f.number().cloned().ok_or_else(other)
    };
    let alone = with(None)?;
    let (mut middle, mut constant, mut varying) = (alone.clone(), integer(0), integer(0));
    let mut rest = known.clone().sub(Expression::from(alone.clone()));
    for (symbol, [low, high], is_constant) in bounded {
        let share = with(Some(*symbol))? - &alone;
        middle += &share * (low + high) / integer(2);
        let most = if *is_constant { &mut constant } else { &mut varying };
        *most += (&share * (high - low) / integer(2)).abs();
        rest = rest.sub(Expression::from(share).mul((*symbol).into()));
    }
    if normal(&rest) != Expression::integer(0) || !existence::needs(f).is_empty() {
        return Err(other());
    }
    Ok([middle, constant, varying])
}

impl Plant {
    /// Returns the bounds of the plant for the sampled loop of `spec`; `entries` hold the table `[disturbance]`.
    pub(super) fn bounds(&self, spec: &Spec, entries: &[Entry]) -> PlantBounds {
        if self.larger.is_some() && self.resonance.is_none() {
            let why = "the plant has states that the law does not know, and proofs are of the plant of the law";
            return PlantBounds::Unknown(why.to_owned());
        }
        // A resonance is beside the chain, and known apart from it.
        if !self.is_chain() && self.resonance.is_none() {
            return PlantBounds::Unknown(
                "the plant is a model, and proofs are of chains of integrators".to_owned(),
            );
        }
        let fixed = spec.fixed.iter().chain(&self.fixed);
        let values = map(fixed.filter_map(|(name, value)| Some((*name, value.number()?.clone()))));
        // A symbol that no signal moves is one number for all of a run.
        let moves = |symbol: &Parameter| {
            let own = format!("disturbance.{}", symbol.spelling());
            let mut given = entries.iter().filter(|entry| entry.key == own);
            given.any(|entry| !is_constant(&entry.value))
        };
        let bounded = self.bounds.iter().map(|(symbol, (low, high))| {
            let ends = [low, high].map(|end| Fixed::number(end).cloned());
            let [low, high] = ends.map(Option::unwrap_or_default);
            (*symbol, [low, high], !moves(symbol))
        });
        let bounded: Vec<_> = bounded.collect();
        // What the law does not cancel.
        let left = match &spec.drift {
            Some(own) if *own == self.f => Expression::integer(0),
            Some(own) => self.f.clone().sub(own.clone()),
            None => self.f.clone(),
        };
        let force = force(&left, &values, &bounded);
        let gain = self.g.as_ref().map(|g| between(g, &values, &bounded));
        match (force, gain.transpose()) {
            (Ok([middle, constant, varying]), Ok(gain)) => {
                PlantBounds::Bounded { middle, constant, varying, gain }
            }
            (Err(why), _) | (_, Err(why)) => PlantBounds::Unknown(why),
        }
    }
}

/// The least and the greatest value of the plant's g.
fn between(
    g: &Expression,
    values: &BTreeMap<Parameter, BigRational>,
    bounded: &[Bounded],
) -> Result<[BigRational; 2], String> {
    let Ok([middle, constant, varying]) = force(g, values, bounded) else {
        return Err(format!("the plant's g = {g} is not a sum of bounded constants"));
    };
    if varying != integer(0) {
        return Err(format!("the plant's g = {g} varies"));
    }
    let ends = [&middle - &constant, middle + constant];
    match ends.iter().all(Signed::is_positive) || ends.iter().all(Signed::is_negative) {
        true => Ok(ends),
        false => Err(format!("the plant's g = {g} may be 0")),
    }
}

/// Returns true if a value of `[disturbance]` is the word `constant` alone.
fn is_constant(node: &Node) -> bool {
    match &node.value {
        Value::Word(word) => word == "constant",
        Value::List(items) => items.iter().all(is_constant),
        _ => false,
    }
}
