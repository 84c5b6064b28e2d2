//! Targets that move and kicks: a quantity of one chain, or one for each axis.

use super::super::{Action, Quantity};
use super::{ANY, Given, Reader, TABLE, TIME, Table};
use crate::diagnostic::{counted, shorten};
use crate::syntax::{Node, Value};

impl Reader<'_> {
    /// The targets that move.
    pub(super) fn target(&mut self, table: Table<'_>, given: &Given<'_>) -> Vec<Action> {
        let Some(node) = given.get("move") else { return Vec::new() };
        let axes = self.spec.rows_of_axes();
        let moves = match axes {
            Some((count, _)) => self.each(table, "move", node, count),
            None => self.quantity(table, "move", given, ANY).into_iter().collect(),
        };
        let chain = axes.is_some() || self.spec.is_one_chain();
        let chain = chain && self.spec.larger.is_none();
        let help = "a target moves along a chain, whose x1 counts from it";
        if moves.is_empty() || !self.needs(table.key, "move", node, chain, help) {
            return Vec::new();
        }
        let n = self.spec.n;
        let of_axis = |(axis, by)| Action::Target(axis * n, by);
        moves.into_iter().enumerate().map(of_axis).collect()
    }

    /// The quantities of a key for so many axes; empty where one is wrong.
    fn each(&mut self, table: Table<'_>, key: &str, node: &Node, count: usize) -> Vec<Quantity> {
        let of = counted(&count, "axis");
        let place = Some(node.place);
        let Value::List(items) = &node.value else {
            let message = format!("{key} = {} for {of}", shorten(&node.value.to_string()));
            let zeros = vec!["0"; count.saturating_sub(1)];
            let help = format!("give one for each of them: {key} = [0.05, {}]", zeros.join(", "));
            self.found.push("bad-value", format!("{}.{key}", table.key), place, message, help);
            return Vec::new();
        };
        if items.len() != count {
            let message = format!("{key}: {} for {of}", counted(&items.len(), "number"));
            let help = format!("give {count} of them");
            self.found.push("bad-value", format!("{}.{key}", table.key), place, message, help);
            return Vec::new();
        }
        let name = |axis: usize| format!("{TABLE}{}_{key}_{axis}", table.number);
        let all = (1..).zip(items);
        let all =
            all.filter_map(|(axis, item)| self.quantity_of(table, key, item, name(axis), ANY));
        let all: Vec<_> = all.collect();
        if all.len() == count { all } else { Vec::new() }
    }

    /// The forces of a kick.
    pub(super) fn force(&mut self, table: Table<'_>, given: &Given<'_>) -> Vec<Action> {
        let (kick, length) = (given.get("kick"), given.get("for"));
        let (node, key) = match (kick, length) {
            (Some(kick), Some(_)) => {
                let axes = self.spec.rows_of_axes();
                let of_axes = axes.filter(|_| matches!(kick.value, Value::List(_)));
                let sizes = match of_axes {
                    Some((count, _)) => self.each(table, "kick", kick, count),
                    None => self.quantity(table, "kick", given, ANY).into_iter().collect(),
                };
                let Some(length) = self.quantity(table, "for", given, TIME) else {
                    return Vec::new();
                };
                let of_input = |(input, size)| {
                    let input = of_axes.map(|_| input);
                    Action::Force { input, size, length: length.clone() }
                };
                return sizes.into_iter().enumerate().map(of_input).collect();
            }
            (Some(node), None) => (node, "kick"),
            (None, Some(node)) => (node, "for"),
            (None, None) => return Vec::new(),
        };
        let message = "`kick` and `for` belong together".to_owned();
        let help = "give both: kick = 2 and for = 0.01 add 2 to u for 10 ms".to_owned();
        let key = format!("{}.{key}", table.key);
        self.found.push("conflict", key, Some(node.place), message, help);
        Vec::new()
    }
}
