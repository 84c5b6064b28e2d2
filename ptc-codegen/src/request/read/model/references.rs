//! References of the outputs of a plant with several, or of axes in samples: one for each.

use super::super::{Reader, items};
use super::names::word;
use crate::diagnostic::counted;
use crate::expression::Expression;
use crate::parameter::Parameter;
use crate::request::Reference;
use crate::syntax::Node;

impl Reader<'_> {
    /// The reference of the first output, and those of all where they are known. `each` is what has one, and
    /// an order.
    pub(in super::super) fn references(
        &mut self,
        (each, orders): (&str, &[Option<usize>]),
        known: &[Parameter],
    ) -> (Option<Reference>, Vec<Vec<Expression>>) {
        let nothing = (None, Vec::new());
        let Some(node) = self.keys.get("reference").copied() else { return nothing };
        if word(node) == Some("input") {
            return (Some(Reference::Input), Vec::new());
        }
        let (given, m) = (items(node), orders.len());
        if given.len() != m {
            let message =
                format!("{} for {}", counted(&given.len(), "reference"), counted(&m, each));
            let help = format!(
                "give an expression in t for each {each}, in their order, and 0 for one that is brought to 0; or `reference` = input, and r and its derivatives with each call"
            );
            self.wrong("reference", Some(node.place), message, help);
            return nothing;
        }
        let all: Vec<_> =
            given.iter().zip(orders).map(|(item, n)| self.followed(item, *n, known)).collect();
        let Some(all) = all.into_iter().collect::<Option<Vec<_>>>() else { return nothing };
        if all.iter().all(|r| r[0] == Expression::integer(0)) {
            return nothing;
        }
        (Some(Reference::Known(all[0].clone())), all)
    }

    /// Refuses a reference that uses a state or an input of the plant by its name.
    pub(in super::super) fn is_of_time(&mut self, node: &Node, given: &Expression) -> bool {
        let keys = ["states", "input", "inputs"].map(|key| self.keys.get(key).copied());
        let names: Vec<_> = keys.into_iter().flatten().flat_map(items).filter_map(word).collect();
        if !self.names_no_intermediate(("reference", node), &given.parameters()) {
            return false;
        }
        let of_plant = |p: &Parameter| names.contains(&p.spelling().as_str());
        let Some(name) = given.parameters().into_iter().find(of_plant) else { return true };
        let message = format!("`{}` is a state or an input of the plant", name.spelling());
        let help =
            "a reference is an expression in t, dt and parameters; a parameter needs another name";
        self.found.push("bad-expression", "reference", Some(node.place), message, help);
        false
    }
}
