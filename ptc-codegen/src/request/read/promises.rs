//! Bounds and periods that checks hold the design to.

use num_traits::{One, Signed};

use super::{Reader, items, shown, suggestion};
use crate::algebra::BigRational;
use crate::diagnostic::{counted, near_miss};
use crate::expression::constant::real;
use crate::keys::{CHECKS, KeyInfo};
use crate::linear::Delay;
use crate::parameter::Fixed;
use crate::request::Promises;
use crate::syntax::{Node, Value};

/// Most samples of delay.
const MAX_DELAY: usize = 16;

impl Reader<'_> {
    /// Bounds and periods that checks hold the design to.
    /// Bounds of the whole run are of the states of the plant, all others of the chain, or of those of `outputs`
    /// with these orders.
    pub(super) fn promises(
        &mut self,
        n: Option<usize>,
        states: Option<usize>,
        outputs: Option<&[usize]>,
    ) -> Promises {
        // A linear plant has as many sensors as C has rows; all states of a model are measured.
        let measured = self.rows_measured().or(states);
        Promises {
            sample_time: self.positive("sample_time"),
            error: self
                .of_chains("error", outputs)
                .unwrap_or_else(|| self.one_or_each("error", n, finite_positive, "finite and > 0")),
            noise: self.one_or_each("noise", measured, not_negative, "finite and >= 0"),
            noise_rms: self.one_or_each("noise_rms", measured, not_negative, "finite and >= 0"),
            sensor_step: self.one_or_each("sensor_step", measured, not_negative, "finite and >= 0"),
            u_step: self.keys.get("u_step").copied().and_then(|node| self.u_step(node)),
            delay: self.keys.get("delay").copied().and_then(|node| self.delay(node)),
            g_error: self.g_error(),
            margin_gain: self.margin("margin_gain", |value| *value >= BigRational::one()),
            margin_delay: self.margin("margin_delay", |value| {
                let most = BigRational::from_integer(MAX_DELAY.into());
                value.is_integer() && !value.is_negative() && *value <= most
            }),
            jitter: self.jitter(),
            x0_max: self.of_chains("x0_max", outputs).unwrap_or_else(|| self.bounds("x0_max", n)),
            x_max: self.bounds("x_max", states),
            allow: self.allowed(),
            // Read with the table [plant].
            plant: None,
            resonance: None,
        }
    }

    fn positive(&mut self, key: &'static str) -> Option<Fixed> {
        let node = self.keys.get(key).copied()?;
        let value = finite_positive(node);
        if value.is_none() {
            let message = format!("{key} = {} is not a finite number > 0", shown(&node.value));
            let legal = KeyInfo::find(key).map_or("", |info| info.legal);
            self.wrong(key, Some(node.place), message, format!("{key} is {legal}"));
        }
        value
    }

    /// Margin of a chosen eps.
    fn margin(&mut self, key: &'static str, legal: fn(&BigRational) -> bool) -> Option<Fixed> {
        let node = self.keys.get(key).copied()?;
        let value = real(node).filter(|value| value.number().is_some_and(legal));
        if value.is_none() {
            let message = format!("{key} = {} is outside its domain", shown(&node.value));
            let told = KeyInfo::find(key).map_or("", |info| info.legal);
            self.wrong(key, Some(node.place), message, format!("{key} is {told}"));
        }
        value
    }

    fn u_step(&mut self, node: &Node) -> Option<Fixed> {
        let value = not_negative(node);
        if value.is_none() {
            let message = format!("u_step = {} is not a finite number >= 0", shown(&node.value));
            let help = "give the step of the actuator, 0 for none".to_owned();
            self.wrong("u_step", Some(node.place), message, help);
        }
        value
    }

    fn delay(&mut self, node: &Node) -> Option<Delay> {
        let most = BigRational::from_integer(MAX_DELAY.into());
        let value = not_negative(node).and_then(|value| value.number().cloned());
        let value = value.filter(|value| *value <= most);
        if value.is_none() {
            let message = format!("delay = {} is not a number of samples", shown(&node.value));
            let help = format!("delay is a number from 0 to {MAX_DELAY}");
            self.wrong("delay", Some(node.place), message, help);
        }
        value.map(Delay::new)
    }

    /// Reads the largest deviation of a sample from its time: less than half a period, so that samples keep their
    /// order.
    fn jitter(&mut self) -> Option<Fixed> {
        let node = self.keys.get("jitter").copied()?;
        let value = not_negative(node);
        let period = self.keys.get("sample_time").and_then(|node| finite_positive(node));
        let half = period.and_then(|h| Some(h.number()? / BigRational::from_integer(2.into())));
        let late = value.as_ref().zip(half).is_some_and(|(j, half)| j.number() >= Some(&half));
        if value.is_none() || late {
            let message = format!("jitter = {} is not below half a period", shown(&node.value));
            let help =
                "give how early or late a sample may be, s: a number >= 0 and < sample_time/2";
            self.wrong("jitter", Some(node.place), message, help.to_owned());
        }
        value
    }

    /// The least and the greatest true input gain, in parts of the known one.
    fn g_error(&mut self) -> Vec<Fixed> {
        let Some(node) = self.keys.get("g_error").copied() else { return Vec::new() };
        let ends: Vec<_> = items(node).iter().filter_map(finite_positive).collect();
        match ends.as_slice() {
            [low, high] if items(node).len() == 2 && low.number() <= high.number() => ends,
            _ => {
                let message = format!("g_error = {} is not an interval", shown(&node.value));
                let help = "give the least and the greatest true input gain in parts of g, both > 0: 0.9,1.1".to_owned();
                self.wrong("g_error", Some(node.place), message, help);
                Vec::new()
            }
        }
    }

    /// One number for all states, or one for each.
    pub(in crate::request::read) fn one_or_each(
        &mut self,
        key: &'static str,
        n: Option<usize>,
        legal: fn(&Node) -> Option<Fixed>,
        told: &str,
    ) -> Vec<Fixed> {
        let Some(node) = self.keys.get(key).copied() else { return Vec::new() };
        self.one_or_each_of((key, node), n, legal, told)
    }

    /// The same of one value of the key.
    pub(in crate::request::read) fn one_or_each_of(
        &mut self,
        (key, node): (&'static str, &Node),
        n: Option<usize>,
        legal: fn(&Node) -> Option<Fixed>,
        told: &str,
    ) -> Vec<Fixed> {
        let items = items(node);
        if items.len() != 1 && n.is_some_and(|n| n != items.len()) {
            let n = n.unwrap_or_default();
            let message =
                format!("{key}: {} for {}", counted(&items.len(), "number"), counted(&n, "state"));
            let help = format!("give one number for all states, or one for each of x1..x{n}");
            self.wrong(key, Some(node.place), message, help);
            return Vec::new();
        }
        let mut numbers = Vec::with_capacity(items.len());
        for item in items {
            match legal(item) {
                Some(value) => numbers.push(value),
                None => {
                    let message = format!("{key} = {} is not {told}", shown(&item.value));
                    let help = KeyInfo::find(key).map_or("", |info| info.legal);
                    self.wrong(key, Some(item.place), message, format!("{key} is {help}"));
                }
            }
        }
        numbers
    }

    /// Bounds of the chain of each output, one after the other, where each has a list of its own.
    fn of_chains(&mut self, key: &'static str, outputs: Option<&[usize]>) -> Option<Vec<Fixed>> {
        let (node, orders) = (self.keys.get(key).copied()?, outputs?);
        let rows = items(node);
        let is_own = rows.iter().any(|row| matches!(row.value, Value::List(_)));
        // Outputs of one order may share a list, and all a number that is an error.
        let one = orders.iter().all(|order| *order == orders[0]);
        if !is_own && (one || key == "error" && rows.len() == 1) {
            return None;
        }
        let lengths = rows.iter().map(|row| items(row).len());
        if !is_own || !lengths.eq(orders.iter().copied()) {
            let all: Vec<_> = orders.iter().map(ToString::to_string).collect();
            let message =
                format!("`{key}` is no list for each output of the orders {}", all.join(", "));
            let help = format!("give a list for each output, of {} numbers", all.join(" and "));
            self.wrong(key, Some(node.place), message, help);
            return Some(Vec::new());
        }
        Some(rows.iter().flat_map(|row| self.row_of_bounds(key, items(row))).collect())
    }

    fn bounds(&mut self, key: &'static str, n: Option<usize>) -> Vec<Fixed> {
        let Some(node) = self.keys.get(key).copied() else { return Vec::new() };
        let items = items(node);
        if n.is_some_and(|n| n != items.len()) {
            let n = n.unwrap_or_default();
            let (of, each) = match key == "x_max" && self.has_model() {
                true => (format!("{} of the model", counted(&n, "state")), "its states".to_owned()),
                false => (format!("order n = {n}"), format!("x1..x{n}")),
            };
            let message = format!("{} for {of}", counted(&items.len(), "bound"));
            let help = format!("give one bound for each of {each}");
            self.wrong(key, Some(node.place), message, help);
            return Vec::new();
        }
        self.row_of_bounds(key, items)
    }

    fn row_of_bounds(&mut self, key: &'static str, items: &[Node]) -> Vec<Fixed> {
        let mut bounds = Vec::with_capacity(items.len());
        // A state may be at rest at the start, and nothing else is bounded by 0.
        let (legal, domain): (fn(&Node) -> Option<Fixed>, _) = match key {
            "x0_max" => (not_negative, ">= 0, 0 for a state that is at rest"),
            _ => (finite_positive, "> 0"),
        };
        for (index, item) in items.iter().enumerate() {
            match legal(item) {
                Some(value) => bounds.push(value),
                None => {
                    let message = format!("{key}[{index}] = {} is not a bound", shown(&item.value));
                    let help = format!("a bound is a finite number {domain}");
                    self.wrong(key, Some(item.place), message, help);
                }
            }
        }
        bounds
    }

    fn allowed(&mut self) -> Vec<String> {
        let Some(node) = self.keys.get("allow").copied() else { return Vec::new() };
        let mut allowed = Vec::new();
        for item in items(node) {
            match &item.value {
                Value::Word(word) if CHECKS.contains(&word.as_str()) => allowed.push(word.clone()),
                other => {
                    let word = if let Value::Word(word) = other { word } else { "" };
                    let message = format!("{} is not a check", shown(other));
                    let all = format!("the checks are {}", CHECKS.join(", "));
                    let help = suggestion(near_miss(word, CHECKS), &all);
                    self.wrong("allow", Some(item.place), message, help);
                }
            }
        }
        allowed
    }
}

pub(super) fn finite_positive(node: &Node) -> Option<Fixed> {
    real(node).filter(|value| value.number().is_some_and(Signed::is_positive))
}

fn not_negative(node: &Node) -> Option<Fixed> {
    real(node).filter(|value| value.number().is_some_and(|value| !value.is_negative()))
}
