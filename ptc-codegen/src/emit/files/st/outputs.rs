//! Outputs of the block: u, the statuses, and the memory of the controller.

use super::super::text::Text as _;
use super::library::{Kind, Member};
use super::types::STATUS;
use super::{Gives, StructuredText};
use crate::code::{Finish, Function, Owner, Variable};
use crate::internal::fault;

impl StructuredText<'_> {
    /// The functions that give what the controller keeps: outputs of the function block.
    pub(super) fn outputs(&self) -> impl Iterator<Item = &Function> {
        let kept = |gives| matches!(gives, Gives::Array | Gives::Number);
        let outputs = self.code.functions.iter().filter(move |f| kept(Gives::of(f)));
        outputs.filter(|f| f.owner == Owner::Controller).inspect(|function| {
            if !function.body.is_empty() || !function.arguments.is_empty() {
                fault(format!("{} does more than to give what is kept", function.name));
            }
        })
    }

    /// The outputs.
    pub(super) fn given(&self) -> Vec<Member> {
        let status = Member::new("status", Kind::Elementary(STATUS), "see the head");
        let mut given = match self.several() {
            Some(_) => {
                let results = self.call().results.iter();
                let of = |result: &Variable| {
                    Member::new(result.name.clone(), self.kind(result.shape), &result.about)
                };
                let mut several: Vec<_> = results.map(of).collect();
                several.push(status);
                several
            }
            None if self.observes() => vec![status],
            None => {
                vec![Member::new("u", Kind::Elementary(self.real), "input of the plant"), status]
            }
        };
        given.extend(self.outputs().filter_map(|function| {
            let first = function.results.first()?;
            Some(Member::new(function.name, self.kind(first.shape), &function.about))
        }));
        given.extend(self.outputs_of_commands());
        given
    }

    /// Sets every u to 0, which it stays unless the call computes it.
    pub(super) fn no_input(&mut self) {
        let zero = self.literal("0.0");
        match self.several() {
            None if self.observes() => {}
            None => self.out.line(format!("u := {zero};")),
            Some(count) => (1..=count).for_each(|i| self.out.line(format!("u[{i}] := {zero};"))),
        }
    }

    /// Sets the status of the call, and that of every input, until the call computes it.
    pub(super) fn settle(&mut self, status: i32) {
        self.out.line(format!("status := {status};"));
        for index in 1..=self.several().unwrap_or(0) {
            self.out.line(format!("axes[{index}] := {status};"));
        }
    }

    /// Sets the outputs that show what is kept.
    pub(super) fn give_outputs(&mut self) {
        let outputs: Vec<_> = self.outputs().cloned().collect();
        for function in outputs {
            let (Some(given), Finish::Give(values, _)) =
                (function.results.first(), &function.finish)
            else {
                continue;
            };
            for (index, value) in values.iter().enumerate() {
                let place = match given.shape.length() {
                    Some(_) => self.element(function.name, index),
                    None => function.name.to_owned(),
                };
                let value = self.alone(value);
                self.out.line(format!("{place} := {value};"));
            }
        }
    }
}
