//! A filter: the keys that it takes, those that it implies, and its bounds.

use num_traits::{Signed, ToPrimitive, Zero};

use super::least_energy::is_least_energy;
use super::{Entry, Reader, count, items, shown};
use crate::algebra::{BigRational, integer};
use crate::diagnostic::counted;
use crate::expression::constant::real;
use crate::expression::{Expression, Node as Known};
use crate::keys::KeyInfo;
use crate::parameter::{Fixed, Parameter};
use crate::request::{Clock, Edge, Keep, LeastEnergy, MAX_ORDER, Spec, What};
use crate::syntax::{Node, Value, parse};

/// The keys of the bounds.
const OWN: [&str; 4] = ["keep_below", "keep_above", "keep_poles", "keep_tolerance"];

/// The other keys that a filter takes.
const TAKEN: [&str; 16] = [
    "what",
    "clock",
    "n",
    "name",
    "units",
    "precision",
    "guard",
    "g",
    "f",
    "poles",
    "tau",
    "sample_time",
    "u_max",
    "u_min",
    "delay",
    "allow",
];

/// The values of the keys that a design of a filter need not give.
const IMPLIED: [(&str, &str); 3] =
    [("clock", "samples"), ("mu", "exp(a=1)"), ("poles", LeastEnergy::NAME)];

/// Greatest order of a chain whose bounds are kept.
const MOST_ORDER: usize = 4;

/// Returns true if a key is of a design, and a filter does not take it.
fn is_of_law(key: &str) -> bool {
    let name = key.rsplit('.').next().unwrap_or(key);
    let known =
        KeyInfo::find(name).filter(|info| key == name || key.split('.').next() == info.table());
    known.is_some_and(|info| !TAKEN.contains(&info.key) && !OWN.contains(&info.key))
}

impl<'a> Reader<'a> {
    /// Returns the entries of a filter with all that they imply, and without the keys of a law; `None` for another
    /// design.
    pub(super) fn as_filter(&self, entries: &[Entry]) -> Option<Vec<Entry>> {
        let what = self.keys.get("what")?;
        if !matches!(&what.value, Value::Word(word) if word == "filter") {
            return None;
        }
        let kept = |entry: &&Entry| !is_of_law(&entry.key) && entry.key != "clock";
        let kept = entries.iter().filter(kept).cloned();
        let implied = IMPLIED.into_iter();
        let implied = implied.filter(|(key, _)| *key != "poles" || !self.keys.contains_key(key));
        let implied = implied.filter_map(|(key, text)| {
            let value = parse(key, text, &mut |_| what.place).ok()?;
            Some(Entry { key: key.to_owned(), place: what.place, value })
        });
        Some(kept.chain(implied).collect())
    }

    /// Refuses the keys of a law.
    pub(super) fn refuse_law(&mut self, entries: &[Entry]) {
        for entry in entries.iter().filter(|entry| is_of_law(&entry.key)) {
            let message = format!("`{}` beside a filter, which has no law", entry.key);
            let help = "leave it out: a filter changes the u of any controller as little as its bounds require".to_owned();
            self.found.push("conflict", entry.key.as_str(), Some(entry.place), message, help);
        }
        let in_time = |entry: &&Entry| {
            entry.key == "clock"
                && !matches!(&entry.value.value, Value::Word(word) if word == "samples")
        };
        if let Some(entry) = entries.iter().find(in_time) {
            let message = format!("clock = {} of a filter", shown(&entry.value.value));
            let help = "leave it out: a filter counts samples".to_owned();
            self.wrong("clock", Some(entry.place), message, help);
        }
    }

    /// Refuses the keys of bounds without a filter.
    pub(super) fn refuse_bounds(&mut self) {
        for key in OWN {
            if let Some(node) = self.keys.get(key).copied() {
                let message = format!("`{key}` without a filter");
                let help = "give what = filter, whose function `step` takes the u of a controller";
                self.found.push("conflict", key, Some(node.place), message, help);
            }
        }
    }

    /// Completes the spec of a filter.
    pub(super) fn filter(&mut self, spec: &mut Spec) {
        if spec.what != What::Filter {
            return;
        }
        // Another order has been reported.
        let order = self.keys.get("n").and_then(|node| count(node, MAX_ORDER));
        let Some(n) = order else { return };
        if n > MOST_ORDER {
            let place = self.keys.get("n").map(|node| node.place);
            let message = format!("a filter of order {n}");
            let help = format!("a filter keeps the bounds of a chain of order 1..={MOST_ORDER}");
            return self.wrong("n", place, message, help);
        }
        let law = self.law_of_return(spec);
        let below = self.bounds_of("keep_below", n, Fixed::Infinite);
        let above = self.bounds_of("keep_above", n, Fixed::MinusInfinite);
        let poles = self.keep_poles(n);
        let tolerance = self.tolerances(n);
        for key in ["tau", "sample_time"] {
            if !self.keys.contains_key(key) {
                self.missing(key);
            }
        }
        self.force_is_known(spec);
        let keep = Keep { below, above, poles, tolerance, law };
        self.bounds_are_legal(&keep, n);
        spec.fixed.retain(|parameter, _| {
            !matches!(parameter, Parameter::Gain(_) | Parameter::A | Parameter::Eps)
        });
        spec.poles.clear();
        spec.written.remove("poles");
        if let Clock::Samples(sampled) = &mut spec.clock {
            sampled.keep = Some(keep);
        }
    }

    /// The law with which a state that is outside returns.
    fn law_of_return(&mut self, spec: &Spec) -> LeastEnergy {
        let node = self.keys.get("poles").copied();
        let Some(node) = node.filter(|node| !is_least_energy(node)) else {
            let exponents = spec.sampled().and_then(|own| own.exponents.as_ref());
            let weight =
                exponents.map(|own| &own.least - integer(i64::try_from(spec.n).unwrap_or(0)));
            let weight = weight.and_then(|weight| weight.to_integer().to_u32());
            return LeastEnergy { weight: weight.unwrap_or(0) };
        };
        let message = format!("poles = {} of a filter", shown(&node.value));
        let help = "a state outside its bounds returns by least-energy or least-energy(weight=W); `keep_poles` are the poles with which it approaches them".to_owned();
        self.wrong("poles", Some(node.place), message, help);
        LeastEnergy { weight: 0 }
    }

    /// Bounds of x1, x2, ...; none is `open`.
    fn bounds_of(&mut self, key: &'static str, n: usize, open: Fixed) -> Vec<Fixed> {
        let Some(node) = self.listed(key, n) else { return Vec::new() };
        let mut all = Vec::new();
        for item in items(node) {
            match real(item).filter(|value| value.number().is_some() || *value == open) {
                Some(value) => all.push(value),
                None => self.illegal(key, item),
            }
        }
        all
    }

    fn keep_poles(&mut self, n: usize) -> Vec<BigRational> {
        let Some(node) = self.keys.get("keep_poles").copied() else {
            self.missing("keep_poles");
            return Vec::new();
        };
        let number = |item: &Node| real(item)?.number().filter(|pole| pole.is_negative()).cloned();
        let mut poles: Vec<_> = items(node).iter().filter_map(number).collect();
        if poles.len() != n || items(node).len() != n {
            let message = format!("keep_poles = {}", shown(&node.value));
            let numbers = if n == 1 { "1 number" } else { &format!("{n} numbers") };
            let help = format!(
                "give {numbers} < 0, in 1/s: the slowest is that with which x1 approaches its bounds"
            );
            self.wrong("keep_poles", Some(node.place), message, help);
        }
        poles.sort_by(|a, b| b.cmp(a));
        poles
    }

    fn tolerances(&mut self, n: usize) -> Vec<Fixed> {
        let Some(node) = self.listed("keep_tolerance", n) else { return Vec::new() };
        let mut all = Vec::new();
        for item in items(node) {
            match super::promises::finite_positive(item) {
                Some(value) => all.push(value),
                None => self.illegal("keep_tolerance", item),
            }
        }
        all
    }

    /// A list of at most one value for each state.
    fn listed(&mut self, key: &'static str, n: usize) -> Option<&'a Node> {
        let node = self.keys.get(key).copied()?;
        let count = items(node).len();
        if count > n || count == 0 {
            let message =
                format!("{key}: {} for {}", counted(&count, "number"), counted(&n, "state"));
            let help =
                "give the values of x1, x2, ... in this order; those left out have none".to_owned();
            self.wrong(key, Some(node.place), message, help);
            return None;
        }
        Some(node)
    }

    fn illegal(&mut self, key: &'static str, item: &Node) {
        let message = format!("{key} has {}", shown(&item.value));
        let legal = KeyInfo::find(key).map_or("", |info| info.legal);
        self.wrong(key, Some(item.place), message, format!("{key} is {legal}"));
    }

    /// Refuses an f that is not a number, as bounds and limits of u are compared.
    fn force_is_known(&mut self, spec: &Spec) {
        let open = spec.drift.as_ref().map(Expression::node);
        if !matches!(open, None | Some(Known::Number(_))) {
            let place = self.keys.get("f").map(|node| node.place);
            let message = "f of a filter is not a number".to_owned();
            self.wrong("f", place, message, "give the known constant force as a number".to_owned());
        }
    }

    /// Refuses bounds in the wrong order, and those of speeds between which there is no rest.
    fn bounds_are_legal(&mut self, keep: &Keep, n: usize) {
        let key = ["keep_below", "keep_above"].into_iter().find(|key| self.keys.contains_key(key));
        let place = |key: &str| self.keys.get(key).map(|node| node.place);
        let Some(key) = key else {
            self.found.push("missing-key", "keep_below", None, "a filter without bounds", "give `keep_below` or `keep_above`: bounds of x1, x2, ..., as in keep_below = 0.5, inf");
            return;
        };
        if (0..n).all(|i| !keep.is_bounded(i)) {
            let place = place(key);
            let help = "give at least one of x1..xn a number".to_owned();
            return self.wrong(key, place, "every bound is infinite".to_owned(), help);
        }
        for i in 0..n {
            if let Some((key, message, help)) = illegal_bounds(keep, i) {
                let place = place(key);
                return self.wrong(key, place, message, help);
            }
        }
    }
}

/// Returns the mistake in the bounds of state `i`, from 0: its key, message and help.
fn illegal_bounds(keep: &Keep, i: usize) -> Option<(&'static str, String, String)> {
    let [above, below] = [Edge::Above, Edge::Below].map(|edge| keep.bound(i, edge));
    let state = i + 1;
    if above.zip(below).is_some_and(|(above, below)| above >= below) {
        let message = format!("the bounds of x{state} leave no room: keep_above >= keep_below");
        let help = "give a lower bound that is below the upper one".to_owned();
        return Some(("keep_above", message, help));
    }
    let excludes = |bound: Option<&BigRational>, negative: bool| {
        bound.is_some_and(|bound| !bound.is_zero() && bound.is_negative() == negative)
    };
    let key = match (i > 0, excludes(above, false), excludes(below, true)) {
        (true, true, _) => "keep_above",
        (true, _, true) => "keep_below",
        _ => return None,
    };
    let message = format!("{key} of x{state} excludes 0, where x{i} is at rest");
    let help = "give x2..xn bounds with 0 between them: the chain must be able to stop".to_owned();
    Some((key, message, help))
}
