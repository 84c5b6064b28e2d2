//! The laws of several chains, one for each output of a plant.

use super::controller::Builder;
use crate::code::{Expr, Statement};

impl Builder<'_> {
    /// Returns the statements of the law of each output, which demands the last rate of its chain, from the coordinates
    /// of the chains. They count down together, and those that change to deadbeat at the same sample decide it once.
    pub(super) fn laws(&mut self, samples: &Expr) -> Vec<Statement> {
        let laws = self.of_each_law(|own| own.law(samples));
        let mut all = Vec::new();
        laws.into_iter().for_each(|law| join(&mut all, law));
        all
    }

    /// Returns the `part` of each law: that of the only one, or that of each output or axis.
    pub(super) fn of_each_law<T>(&mut self, mut part: impl FnMut(&mut Self) -> T) -> Vec<T> {
        if self.designs.is_empty() {
            return vec![part(self)];
        }
        let of_plant = (self.spec, self.sampled);
        let mut all = Vec::new();
        for (output, own) in (1..).zip(self.designs) {
            let Some(sampled) = own.sampled() else { continue };
            (self.spec, self.sampled, self.output) = (own, sampled, Some(output));
            all.push(part(self));
        }
        (self.spec, self.sampled) = of_plant;
        self.output = None;
        all
    }

    /// A name of the law that is put together.
    pub(super) fn named(&self, name: &str) -> String {
        match self.output {
            Some(output) => format!("{name}_{output}"),
            None => name.to_owned(),
        }
    }
}

/// Adds the statements of one more output: what is the same stands once, and what a test decides stands with
/// what the same test decides of other outputs, behind all else.
fn join(all: &mut Vec<Statement>, more: Vec<Statement>) {
    for statement in more {
        let is_test = |other: &Statement| matches!(other, Statement::If(..));
        match statement {
            Statement::If(test, yes, no) => {
                let same = |other: &&mut Statement| matches!(other, Statement::If(own, ..) if *own == test);
                match all.iter_mut().find(same) {
                    Some(Statement::If(_, own_yes, own_no)) => {
                        join(own_yes, yes);
                        join(own_no, no);
                    }
                    _ => all.push(Statement::If(test, yes, no)),
                }
            }
            other if all.contains(&other) => {}
            other => {
                let place = all.iter().position(is_test).unwrap_or(all.len());
                all.insert(place, other);
            }
        }
    }
}
