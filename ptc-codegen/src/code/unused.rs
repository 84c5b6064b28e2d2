//! Local values that nothing reads: a function does not compute them.

use std::collections::BTreeSet;

use super::{Expr, Function, Statement};

impl Function {
    /// Returns it without the local values that nothing reads.
    #[must_use]
    pub fn without_unused(mut self) -> Self {
        loop {
            let mut read = BTreeSet::new();
            self.visit(&mut |value| read.extend(name(value)));
            self.body.iter().for_each(|statement| arrays(statement, &mut read));
            if !pruned(&mut self.body, &read) {
                return self;
            }
        }
    }
}

/// The local value that an expression reads.
fn name(value: &Expr) -> Option<String> {
    match value {
        Expr::Local(name)
        | Expr::Element(name, _)
        | Expr::At(name, _)
        | Expr::Entry(name, _)
        | Expr::Callback(_, name, _) => Some(name.clone()),
        _ => None,
    }
}

/// The arrays that statements read by their names.
fn arrays(statement: &Statement, read: &mut BTreeSet<String>) {
    match statement {
        Statement::View { array, .. } | Statement::Call { array, .. } => {
            read.insert(array.clone());
        }
        Statement::If(_, yes, no) => yes.iter().chain(no).for_each(|own| arrays(own, read)),
        Statement::For(each) => each.body.iter().for_each(|own| arrays(own, read)),
        _ => {}
    }
}

/// Removes values that are not read, and says whether there were any.
fn pruned(body: &mut Vec<Statement>, read: &BTreeSet<String>) -> bool {
    let count = body.len();
    body.retain(|statement| !matches!(statement, Statement::Let(name, ..) if !read.contains(name)));
    let mut changed = body.len() < count;
    for statement in body {
        changed |= match statement {
            Statement::If(_, yes, no) => pruned(yes, read) | pruned(no, read),
            Statement::For(each) => pruned(&mut each.body, read),
            _ => false,
        };
    }
    changed
}
