//! The reference that the output of a linear plant follows.

use super::super::Reader;
use crate::algebra::BigRational;
use crate::linear::{Following, Linear};
use crate::request::{Spec, What};

impl Reader<'_> {
    /// Reads the output that follows the reference, and computes state and input for it; `None` without a reference.
    pub(super) fn following(&mut self, spec: &Spec, plant: &Linear) -> Option<Following> {
        let given = self.keys.get("output").copied();
        // An observer alone refuses one.
        if spec.reference.is_none() || spec.what == What::Observer {
            let node = given.filter(|_| !self.keys.contains_key("reference"));
            if let Some(node) = node {
                let message = "`output` without a reference that it follows".to_owned();
                let help =
                    "leave it out: beside A and B it is a row, as those of C, for `reference`";
                self.found.push("conflict", "output", Some(node.place), message, help);
            }
            return None;
        }
        let output = match given {
            Some(node) => self.row("output", node, plant.b.len())?,
            None => self.only_row(plant)?,
        };
        let n = plant.b.len();
        let wrong = match plant.following(&output) {
            Ok(found) => return Some(found),
            Err(0) => "no input reaches the output".to_owned(),
            Err(degree) => format!(
                "the relative degree of the output is {degree}, and the plant has {n} states: where the output follows r, the others do not"
            ),
        };
        let help = format!(
            "in samples the output of a linear plant follows with relative degree {n}: take such a one, or leave `clock` out; in time any output of a model follows"
        );
        let key = if given.is_some() { "output" } else { "C" };
        let place = self.keys.get(key).map(|node| node.place);
        self.found.push("conflict", key, place, wrong, help);
        None
    }

    /// The row of C, where it has one.
    fn only_row(&mut self, plant: &Linear) -> Option<Vec<BigRational>> {
        let rows = plant.c.as_slice();
        if let ([row], true) = (rows, self.keys.contains_key("C")) {
            return Some(row.clone());
        }
        let place = self.keys.get("reference").map(|node| node.place);
        let message = "a reference, and no output of the plant that could follow it";
        let help = format!(
            "give `output`, {} as in a row of C; or the plant by `states`, `input`, `dynamics` and `output`",
            crate::diagnostic::counted(&plant.b.len(), "number")
        );
        self.found.push("conflict", "reference", place, message, help);
        None
    }
}
