//! Targets that move and kicks: a number of one chain, or one for each axis or input.

use std::collections::BTreeMap;

use num_traits::{Signed, ToPrimitive};

use super::{Change, Reader};
use crate::algebra::BigRational;
use crate::diagnostic::{counted, shorten};
use crate::syntax::{Node, Value};

impl Reader<'_> {
    /// The targets that move.
    pub(super) fn target(&mut self, table: &str, given: &BTreeMap<&str, &Node>) -> Vec<Change> {
        let Some(node) = given.get("move") else { return Vec::new() };
        let rows = self.spec.rows_of_axes();
        let chain = self.spec.sampled().is_none_or(|own| own.linear.is_none())
            && (rows.is_some() || !self.spec.has_model() && self.spec.axes.is_none())
            && self.spec.larger.is_none();
        let help = "a target moves along a chain, whose x1 counts from it";
        let moves = match rows {
            Some((count, _)) => self.each(table, "move", given, count),
            None => self.finite(table, "move", given).into_iter().collect(),
        };
        if moves.is_empty() || !self.needs(table, "move", node, chain, help) {
            return Vec::new();
        }
        let n = self.spec.n;
        let of_axis = |(axis, by)| Change::Target { state: axis * n, by };
        moves.into_iter().enumerate().map(of_axis).collect()
    }

    /// A finite number of a key.
    fn finite(&mut self, table: &str, key: &str, given: &BTreeMap<&str, &Node>) -> Option<f64> {
        self.number(table, key, given, |_| true, "a finite number")?.to_f64()
    }

    /// The numbers of a key for so many axes or inputs; empty where one is wrong.
    fn each(
        &mut self,
        table: &str,
        key: &'static str,
        given: &BTreeMap<&str, &Node>,
        count: usize,
    ) -> Vec<f64> {
        let Some(node) = given.get(key) else { return Vec::new() };
        let of = counted(&count, if key == "move" { "axis" } else { "input" });
        let Value::List(items) = &node.value else {
            let message = format!("{key} = {} for {of}", shorten(&node.value.to_string()));
            let zeros = vec!["0"; count.saturating_sub(1)];
            let help =
                format!("give a number for each of them: {key} = [0.05, {}]", zeros.join(", "));
            self.found.push("bad-value", format!("{table}.{key}"), Some(node.place), message, help);
            return Vec::new();
        };
        if items.len() != count {
            let found = counted(&items.len(), "number");
            let message = format!("{key}: {found} for {of}");
            let help = format!("give {count} numbers");
            self.found.push("bad-value", format!("{table}.{key}"), Some(node.place), message, help);
            return Vec::new();
        }
        let numbers =
            items.iter().filter_map(|item| self.finite(table, key, &BTreeMap::from([(key, item)])));
        let numbers: Vec<_> = numbers.collect();
        if numbers.len() == count { numbers } else { Vec::new() }
    }

    /// The forces of a kick.
    pub(super) fn force(&mut self, table: &str, given: &BTreeMap<&str, &Node>) -> Vec<Change> {
        let (kick, length) = (given.get("kick"), given.get("for"));
        let (node, key) = match (kick, length) {
            (Some(kick), Some(_)) => {
                let rows = self.spec.rows_of_axes();
                let inputs = rows.map_or(self.spec.input_names().len(), |(count, _)| count);
                let is_list = matches!(kick.value, Value::List(_));
                let sizes = match is_list && inputs > 1 {
                    true => self.each(table, "kick", given, inputs),
                    false => self.finite(table, "kick", given).into_iter().collect(),
                };
                let time = BigRational::is_positive;
                let length = self.number(table, "for", given, time, "a time > 0, in s");
                let Some(length) = length.and_then(|own| own.to_f64()) else { return Vec::new() };
                let of_input =
                    |(input, size)| Change::Force { input: is_list.then_some(input), size, length };
                return sizes.into_iter().enumerate().map(of_input).collect();
            }
            (Some(node), None) => (node, "kick"),
            (None, Some(node)) => (node, "for"),
            (None, None) => return Vec::new(),
        };
        let message = "`kick` and `for` belong together".to_owned();
        let help = "give both: kick = 2 and for = 0.01 add 2 to u for 10 ms".to_owned();
        self.found.push("conflict", format!("{table}.{key}"), Some(node.place), message, help);
        Vec::new()
    }
}
