//! One resonance beside the plant of the law: two inertias, motor and load, joined by a spring with a damper.
//!
//! ```toml
//! [plant]
//! f = "-coulomb*sign(x2)"
//! coulomb = [0, 3]
//! resonance = { frequency_hz = [34, 344], damping = [0.03, 0.3], inertia_ratio = 6, measured = "motor" }
//! ```
//!
//! The equations are those of [`crate::linear`]; the twist is the motor's x_(n-1) less the load's.

use num_traits::{Signed, Zero};

use super::read::{Given, value};
use super::spring::{Sides, Spring};
use super::{Plant, TABLE};
use crate::diagnostic::{Diagnostics, Place, near_miss, shorten};
use crate::expression::{Expression, Variable};
use crate::linear::{Joint, Side};
use crate::parameter::{Fixed, Name, Parameter};
use crate::request::{LargerPlant, MAX_ORDER, Resonance, Spec};
use crate::syntax::{Argument, Node, Value};

/// The key of the table.
pub(super) const KEY: &str = "resonance";

/// The states of the spring: the twist and its rate.
const TWIST: [&str; 2] = ["twist", "twist_rate"];

/// The numbers of a resonance, each a symbol of the plant by the name of the table, `_` and its own.
const NUMBERS: [&str; 3] = ["frequency_hz", "damping", "inertia_ratio"];

/// The sides that are chosen.
const SIDES: [&str; 2] = ["measured", "f"];

/// Help text on legal values.
const LEGAL: &str = "resonance = { frequency_hz = [30, 60], damping = 0.02, inertia_ratio = 3, measured = \"motor\", f = \"load\" }";

/// Help text on a resonance of an axis.
const AXIS_ALONE: &str = "check each axis as a design of its own, without `axes` and with its gains, limits, `g` and \
     resonance; give the largest eps of these designs to the one of all axes";

/// Puts the resonance of `[plant]` beside a chain, whose states are those of the measured side, or before the input of
/// a linear plant.
pub(super) fn put(plant: &mut Plant, given: &Given<'_>, spec: &Spec, found: &mut Diagnostics) {
    let Some((place, node)) = given.get(KEY) else { return };
    let wrong = |found: &mut Diagnostics, message: &str, help: &str| {
        found.push("conflict", format!("{TABLE}.{KEY}"), Some(*place), message, help);
    };
    if spec.has_model() {
        let help = "give the larger plant itself: `states`, `dynamics` and `outputs` under [plant]";
        return wrong(found, "`resonance` beside a model", help);
    }
    if spec.axes.is_some() {
        let message = "`resonance` beside several axes: it is joined to one chain, and an axis has no plant of its own";
        return wrong(found, message, AXIS_ALONE);
    }
    if spec.n + TWIST.len() > MAX_ORDER {
        let message = format!("`resonance` beside a chain of order {}", spec.n);
        return wrong(found, &message, &format!("a plant has at most {MAX_ORDER} states"));
    }
    let Value::Table(items) = &node.value else {
        return wrong(found, "`resonance` is not a table in braces", &format!("write {LEGAL}"));
    };
    let mut reader = Reader { plant, given, items, whole: true, found };
    reader.names();
    let [frequency, damping, inertia_ratio] = NUMBERS.map(|name| reader.number(name));
    let (measured, forced) = (reader.side("measured", None), reader.side("f", Some(Side::Load)));
    let whole = reader.whole;
    let (Some(measured), Some(forced), true) = (measured, forced, whole) else { return };
    let spring = Spring::new(spec.n, Joint { frequency, damping, inertia_ratio });
    let linear = spec.sampled().and_then(|own| own.linear.as_ref());
    plant.dynamics = match linear {
        Some(linear) => spring.before(linear, measured),
        None => {
            if let (true, Some(state)) = (measured != forced, hidden(&plant.f, spec.n)) {
                let message = format!(
                    "f of the {} uses x{state}, which is known of the {} alone",
                    forced.text(),
                    measured.text()
                );
                let help = "say `f = \"motor\"` or `f = \"load\"` in `resonance`: the side on which f acts";
                return wrong(found, &message, help);
            }
            spring.beside(plant, spec, Sides { measured, forced })
        }
    };
    let states = (1..=spec.n).map(|j| format!("x{j}")).chain(TWIST.map(str::to_owned));
    let states = states.filter_map(|name| Name::new(&name)).collect();
    let outputs = (1..=spec.n).map(|j| Variable::State(j).into()).collect();
    let larger = LargerPlant::new(spec, states, outputs);
    plant.larger = Some(LargerPlant { at_rest: TWIST.len(), ..larger });
    plant.resonance = Some(measured);
}

/// The symbol of a number of the table.
fn symbol(name: &str) -> Option<Parameter> {
    Name::new(&spelling(name)).map(Parameter::Named)
}

fn spelling(name: &str) -> String {
    format!("{KEY}_{name}")
}

/// The keys of `[plant]` that give a number of the table another value.
pub(super) fn keys() -> [String; 3] {
    NUMBERS.map(spelling)
}

/// The first state of which f of the other side knows nothing: the spring has a twist and its rate alone.
fn hidden(f: &Expression, n: usize) -> Option<usize> {
    (1..n.saturating_sub(1)).find(|j| {
        f.any(&|e| matches!(e.variable(), Some(Variable::State(i) | Variable::StateAtStart(i)) if i == *j))
    })
}

impl Plant {
    /// Returns the bounds of its resonance, if all of them are known.
    pub(super) fn promised_resonance(&self) -> Option<Resonance> {
        let measured = self.resonance?;
        let ends = |name: &str| {
            let symbol = symbol(name)?;
            let (low, high) = match self.fixed.get(&symbol) {
                Some(value) => (value, value),
                None => self.bounds.get(&symbol).map(|(low, high)| (low, high))?,
            };
            Some([low.number()?.clone(), high.number()?.clone()])
        };
        let [frequency, damping, inertia_ratio] = NUMBERS.map(ends);
        let (frequency, damping, inertia_ratio) = (frequency?, damping?, inertia_ratio?);
        Some(Resonance { frequency, damping, inertia_ratio, measured })
    }
}

struct Reader<'a> {
    plant: &'a mut Plant,
    given: &'a Given<'a>,
    items: &'a [Argument],
    whole: bool,
    found: &'a mut Diagnostics,
}

impl<'a> Reader<'a> {
    fn wrong(&mut self, key: &str, place: Place, message: String, help: &str) {
        self.whole = false;
        self.found.push("bad-value", format!("{TABLE}.{KEY}.{key}"), Some(place), message, help);
    }

    fn find(&self, name: &str) -> Option<&'a Node> {
        let own =
            self.items.iter().find(|item| item.name.as_ref().is_some_and(|(own, _)| own == name));
        own.map(|item| &item.value)
    }

    fn names(&mut self) {
        let all = || NUMBERS.into_iter().chain(SIDES);
        for item in self.items {
            let (name, place) = match &item.name {
                Some((name, place)) => (name.as_str(), *place),
                None => ("", item.value.place),
            };
            if all().any(|key| key == name) {
                continue;
            }
            let meant = near_miss(name, all()).map(|meant| format!("did you mean `{meant}`? "));
            let help = format!("{}write {LEGAL}", meant.unwrap_or_default());
            self.wrong(name, place, format!("unknown key `{}` of resonance", shorten(name)), &help);
        }
    }

    /// The symbol of a number, whose value or interval the plant takes.
    fn number(&mut self, name: &'static str) -> Expression {
        let table = self.given.get(KEY).map_or(Place(0), |(place, _)| *place);
        let over = self.given.get(spelling(name).as_str()).map(|(_, node)| *node);
        let (Some(symbol), Some(node)) = (symbol(name), over.or(self.find(name))) else {
            self.wrong(
                name,
                table,
                format!("resonance without `{name}`"),
                &format!("write {LEGAL}"),
            );
            return Expression::integer(1);
        };
        value(self.plant, &format!("{KEY}.{name}"), symbol, node, self.found);
        let least = self.plant.bounds.get(&symbol).map(|(low, _)| low);
        let least = least.or(self.plant.fixed.get(&symbol)).and_then(Fixed::number).cloned();
        match least {
            Some(least) if least.is_positive() || (name == "damping" && least.is_zero()) => {}
            Some(_) => {
                let positive = if name == "damping" { ">= 0" } else { "> 0" };
                let message = format!("{name} of resonance is not {positive}");
                self.wrong(name, node.place, message, &format!("write {LEGAL}"));
            }
            None => self.whole = false,
        }
        symbol.into()
    }

    fn side(&mut self, name: &'static str, default: Option<Side>) -> Option<Side> {
        let table = self.given.get(KEY).map_or(Place(0), |(place, _)| *place);
        let Some(node) = self.find(name) else {
            if default.is_none() {
                let message = format!("resonance without `{name}`");
                let help = "say which side the sensor is on: measured = \"motor\" or \"load\"";
                self.wrong(name, table, message, help);
            }
            return default;
        };
        let sides = [Side::Motor, Side::Load];
        let found = match &node.value {
            Value::Word(word) => sides.into_iter().find(|side| side.text() == word),
            _ => None,
        };
        if found.is_none() {
            let message = format!("{name} of resonance is neither \"motor\" nor \"load\"");
            self.wrong(
                name,
                node.place,
                message,
                "u acts on the motor, across the spring is the load",
            );
        }
        found
    }
}
