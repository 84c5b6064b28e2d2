//! Statements of a batch: where a test holds for a part of it, the others keep what they have.

use super::super::block::{Around, Block};
use super::super::text::Text;
use super::Python;
use crate::code::{Expr, For, Place, Statement, Status, Subroutine, Test};
use crate::internal::fault;

/// Name of the mask of the elements of a batch that have left a loop.
const DONE: &str = "done";

impl Python<'_> {
    /// The function of a subroutine.
    pub(super) fn subroutine(&mut self, of: Subroutine) {
        let given = of.given();
        let list = given.map(|own| format!("given_{}: Sequence[ArrayLike]", own.name));
        self.out.open(format!("def _{}({}) -> list[Array]:", of.name(), list.join(", ")));
        self.out.words("", &format!("\"\"\"{}", of.about()));
        self.out.line("\"\"\"");
        for own in given.map(|own| own.name) {
            self.out.line(format!("{own} = [np.asarray(v, dtype=_R) for v in given_{own}]"));
        }
        self.batch = true;
        of.body(0).iter().for_each(|statement| self.chosen(statement));
        self.batch = false;
        self.out.line(format!("return {}", given[0].name));
        self.out.leave();
        self.out.line("\n");
    }

    /// Several inputs before statements set them in parts of a batch.
    pub(super) fn unset_inputs(&mut self) {
        let count = self.code.axes().unwrap_or_default();
        self.out.line(format!("u: list[Array] = [np.asarray(_R(0.0))] * {count}"));
        self.out.line(format!("axes = [np.asarray(Status.OK)] * {count}"));
    }

    /// Several inputs, which statements have set, for each element of a batch.
    pub(super) fn inputs(&mut self, legal: &[(&Test, Status)]) {
        for (test, status) in legal.iter().rev() {
            let (test, status) = (self.test(test), self.status(*status));
            self.out.line(format!(
                "legal = {test}
axes = [np.where(legal, each, {status}) for each in axes]
status = np.where(legal, status, {status})"
            ));
        }
        let count = self.code.axes().unwrap_or_default();
        self.out.line(format!(
            "every = np.broadcast_arrays(*u, *axes, status)
given = np.stack(every[:{count}], axis=-1)
return Axes(
    np.where((status < 0)[..., np.newaxis], _R(0.0), given),
    np.stack(every[{count}:-1], axis=-1).astype(np.int8),
    every[-1].astype(np.int8),
)"
        ));
    }

    /// The result of a call that is refused before any input is computed.
    pub(super) fn refused_inputs(&self, status: Status) -> String {
        let (count, status) = (self.code.axes().unwrap_or_default(), self.status(status));
        format!(
            "Axes(\n    np.zeros({count}, dtype=_R),\n    np.full({count}, {status}, dtype=np.int8),\n    np.asarray({status}, dtype=np.int8),\n)"
        )
    }

    /// A statement of a batch.
    pub(super) fn chosen(&mut self, statement: &Statement) {
        match (statement, self.mask.clone()) {
            (Statement::Set(..) | Statement::Settle(..), mask) => {
                let Some((place, value)) = self.sets(statement) else { return };
                self.out.line(match mask {
                    Some(mask) => format!("{place} = np.where({mask}, {value}, {place})"),
                    None => format!("{place} = {value}"),
                });
            }
            (Statement::If(test, yes, no), mask) => match (yes.as_slice(), no.as_slice()) {
                ([Statement::Leave], []) => {
                    let test = self.test(test);
                    self.leaves(&test);
                }
                _ if self.is_of_all(test) => {
                    let line = format!("if {}:", self.test(test));
                    self.out.open(line);
                    yes.iter().for_each(|statement| self.chosen(statement));
                    self.out.leave();
                    if !no.is_empty() {
                        self.out.open("else:");
                        no.iter().for_each(|statement| self.chosen(statement));
                        self.out.leave();
                    }
                }
                _ => match (self.sets_last(yes), self.sets_last(no)) {
                    (Some((place, a)), Some((same, b))) if place == same => {
                        let before = [yes, no].map(|way| &way[..way.len() - 1]);
                        self.one_of(&place, test, before, [&a, &b]);
                    }
                    _ => self.either(test, [yes, no], mask),
                },
            },
            (Statement::For(each), mask) => self.loops(each, mask),
            (Statement::Leave, Some(mask)) => self.leaves(&mask),
            (statement, _) => self.statement(statement),
        }
    }

    /// A value that is one of two; what stands before them is computed on both ways.
    fn one_of(&mut self, name: &str, test: &Test, before: [&[Statement]; 2], [yes, no]: [&str; 2]) {
        before.into_iter().flatten().for_each(|statement| self.chosen(statement));
        let test = self.test(test);
        if let Some(mask) = &self.mask {
            let lines = format!(
                "chosen = np.where({test}, {yes}, {no})\n{name} = np.where({mask}, chosen, {name})"
            );
            return self.out.line(lines);
        }
        self.out.line(format!("{name} = np.asarray({no})"));
        self.out.line(format!("chosen = np.asarray({test})"));
        self.out.line("if chosen.any():");
        self.out.line(format!("    {name} = np.where(chosen, {yes}, {name})"));
    }

    /// Statements for either outcome.
    fn either(&mut self, test: &Test, ways: [&[Statement]; 2], mask: Option<String>) {
        let depth = mask.as_ref().map_or(0, |mask| mask.matches("holds").count());
        let holds = format!("holds{}", if depth == 0 { String::new() } else { depth.to_string() });
        let test = self.test(test);
        self.out.line(format!("{holds} = np.asarray({test})"));
        // Most often all are as they should be.
        let rare = match ways {
            [[], _] if mask.is_none() => Some(format!("if not {holds}.all():")),
            [_, []] if mask.is_none() => Some(format!("if {holds}.any():")),
            _ => None,
        };
        if let Some(open) = &rare {
            self.out.open(open);
        }
        let own = [holds.clone(), format!("~{holds}")];
        for (own, way) in own.into_iter().zip(ways) {
            self.mask = Some(mask.as_ref().map_or(own.clone(), |outer| format!("{own} & {outer}")));
            way.iter().for_each(|statement| self.chosen(statement));
        }
        if rare.is_some() {
            self.out.leave();
        }
        self.mask = mask;
    }

    /// A loop; where elements leave it, those that have keep what they have.
    fn loops(&mut self, each: &For, mask: Option<String>) {
        if each.is_left() {
            let outer = mask.as_ref().map(|mask| format!(" & {mask}"));
            if outer.as_ref().is_some_and(|outer| outer.contains(DONE)) {
                fault("a loop that is left within another one");
            }
            self.out.line(format!("{DONE} = np.asarray(False)"));
            self.mask = Some(format!("~{DONE}{}", outer.unwrap_or_default()));
        }
        let Around { open, .. } = Block::each(self, each);
        self.out.open(open);
        self.indices.push(each.index.clone());
        each.body.iter().for_each(|statement| self.chosen(statement));
        self.indices.pop();
        self.out.leave();
        self.mask = mask;
    }

    /// Ends the loop for the elements for which the test holds.
    fn leaves(&mut self, test: &str) {
        self.out.line(format!("{DONE} = {DONE} | ({test})\nif {DONE}.all():\n    break"));
    }

    /// Returns true if a test has one outcome for all elements: it compares only loop indices.
    fn is_of_all(&self, test: &Test) -> bool {
        if matches!(test, Test::Stands(_) | Test::Fails(_)) {
            return false;
        }
        let mut all = true;
        test.visit(&mut |value| {
            all &= match value {
                Expr::Count(_) => true,
                Expr::Local(name) => self.indices.contains(name),
                _ => false,
            };
        });
        all
    }

    /// Returns the target of a statement, and its value.
    fn sets(&self, statement: &Statement) -> Option<(String, String)> {
        let (place, value) = match statement {
            Statement::Settle(whose, status) => {
                return Some((self.status_of(whose), self.standing(status)));
            }
            Statement::Set(place, value) => (place, value),
            _ => return None,
        };
        let is_of_list = matches!(place, Place::Element(..) | Place::Input(_));
        let place = match place {
            Place::Local(name) => self.local(name),
            Place::Element(name, index) => self.at(name, &self.place(index, self.first())),
            Place::Input(index) => self.input(index),
            Place::Field(name) => self.field(name),
        };
        let value = match (is_of_list, value) {
            (true, Expr::Number(_)) => format!("np.asarray({})", self.value(value)),
            _ => self.value(value),
        };
        Some((place, value))
    }

    /// Returns the target and value of the last statement of a branch, if it sets nothing else.
    fn sets_last(&self, branch: &[Statement]) -> Option<(String, String)> {
        let (last, before) = branch.split_last()?;
        before.iter().all(|statement| self.sets(statement).is_none()).then(|| self.sets(last))?
    }
}
