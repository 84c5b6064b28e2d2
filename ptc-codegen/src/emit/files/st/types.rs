//! Types of variables, and those that are declared beside the block.

use super::super::text::Text as _;
use super::library::{Kind, Member, Structure, Vector};
use super::{StructuredText, helpers};
use crate::code::{Constant, Shape, Table, Variable};
use crate::internal::fault;

/// The type of a status.
pub(super) const STATUS: &str = "INT";

impl StructuredText<'_> {
    pub(super) fn kind(&self, shape: Shape) -> Kind {
        match shape {
            Shape::Count => Kind::Elementary("UDINT"),
            Shape::Real => Kind::Elementary(self.real),
            Shape::Reals(_) | Shape::Lists(..) | Shape::Statuses(_) => {
                self.arrays.borrow_mut().insert(shape);
                Kind::Derived(helpers::array(&self.code.name, shape))
            }
            Shape::Gains => fault("a function block gives no gains"),
        }
    }

    /// The types of the arrays.
    pub(super) fn vectors(&self) -> Vec<Vector> {
        let vector = |&shape: &Shape| {
            let (lengths, of) = match shape {
                Shape::Lists(rows, columns) => (vec![rows, columns], self.real),
                Shape::Statuses(count) => (vec![count], STATUS),
                shape => (shape.length().into_iter().collect(), self.real),
            };
            Vector { name: helpers::array(&self.code.name, shape), lengths, of }
        };
        self.arrays.borrow().iter().map(vector).collect()
    }

    pub(super) fn structure<'v>(
        &self,
        kind: &str,
        members: impl Iterator<Item = (String, &'v Variable)>,
    ) -> Structure {
        let member =
            |(name, v): (String, &Variable)| Member::new(name, self.kind(v.shape), &v.about);
        let name = format!("{}_{kind}", self.code.name);
        Structure { name, members: members.map(member).collect() }
    }

    /// The constants and the tables.
    pub(super) fn constants(&self) -> Vec<Member> {
        let constants = self.code.constants();
        let held = constants.iter().filter(|own| self.holds(own)).map(|own| self.number(own));
        held.chain(self.code.tables.iter().map(|table| self.table_of(table))).collect()
    }

    fn number(&self, own: &Constant) -> Member {
        let value = signed(self.literal_of(own));
        let kind = if own.count().is_some() { "UDINT" } else { self.real };
        Member::new(self.constant(own), Kind::Number(kind, value), own.described())
    }

    /// A table, row by row.
    fn table_of(&self, table: &Table) -> Member {
        let numbers = self.rows(table).into_iter().flatten().map(signed).collect();
        Member::new(self.named(&table.name), Kind::Table(self.real, numbers), &table.about)
    }
}

/// A literal whose sign stands behind its type, as a constant has it.
fn signed(number: String) -> String {
    match number.strip_prefix('-').and_then(|n| n.split_once('#')) {
        Some((kind, digits)) => format!("{kind}#-{digits}"),
        None => number,
    }
}
