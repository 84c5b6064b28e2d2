//! The contracts of a controller in samples, or of an observer alone.

use std::collections::BTreeSet;

use super::{Pointer, comment, requires};
use crate::code::{
    Access, Code, Ending, Expr, Finish, Function, Place, Shape, Statement, Status, Test,
};
use crate::collect::set;
use crate::emit::files::c::{Notes, word};

/// The contracts by function.
pub(in crate::emit) fn notes(code: &Code) -> Notes {
    let name = &code.name;
    let set: Vec<_> = seen(code).into_iter().map(|f| format!("\\is_finite(c->{f})")).collect();
    let set = if set.is_empty() { "\\true".to_owned() } else { set.join("\n      && ") };
    let predicates = format!("/*@ predicate {name}_set({name} *c) =\n      {set};\n */");
    let mut init = vec![pointer("self", None, true)];
    if !code.parameters.is_empty() {
        init.push(pointer("params", None, false));
    }
    let built = format!(
        "ensures \\result == PTC_OK || \\result == PTC_E_PARAM;\n\
         ensures \\result == PTC_OK ==> {name}_set(self);"
    );
    let init = comment(&requires(&init, true), "*self", &built);
    let contracts = code.functions.iter().map(|function| (function.name, contract(name, function)));
    Notes {
        predicates,
        contracts: std::iter::once(("init", init)).chain(contracts).collect(),
        ..Notes::default()
    }
}

fn pointer(name: &str, count: Option<usize>, out: bool) -> Pointer {
    Pointer { name: name.to_owned(), count, out }
}

fn contract(name: &str, function: &Function) -> String {
    let changes = function.access == Access::Change;
    let mut pointers = vec![pointer("self", None, changes)];
    for argument in &function.arguments {
        if let Some(count) = argument.shape.length() {
            pointers.push(pointer(&argument.name, Some(count), false));
        }
    }
    for result in &function.results {
        pointers.push(pointer(&result.name, result.shape.length(), true));
    }
    let mut conditions = requires(&pointers, function.guarded);
    let missing = if function.guarded { "self == \\null || " } else { "" };
    conditions.push(format!("requires {missing}{name}_set(self);"));
    if !function.guarded {
        conditions.extend(trusted(function));
    }
    let written = function.results.iter().map(|result| match result.shape.length() {
        Some(count) => format!("{}[0 .. {}]", result.name, count - 1),
        None => format!("*{}", result.name),
    });
    let assigned: Vec<_> = changes.then(|| "*self".to_owned()).into_iter().chain(written).collect();
    let known = statuses(function);
    let known: Vec<_> = known.iter().map(|word| format!("\\result == {word}")).collect();
    let mut ensures = vec![format!("ensures {};", known.join(" || "))];
    if changes {
        ensures.push(format!("ensures \\result >= 0 ==> {name}_set(self);"));
    }
    comment(&conditions, &assigned.join(", "), &ensures.join("\n"))
}

/// Returns the finiteness preconditions of a function that checks nothing.
fn trusted(function: &Function) -> Vec<String> {
    let argument = |(name, shape): (&str, Shape)| match shape {
        Shape::Reals(count) => (0..count).map(|j| format!("{name}[{j}]")).collect(),
        Shape::Real => vec![name.to_owned()],
        Shape::Count | Shape::Gains | Shape::Lists(..) | Shape::Statuses(_) => Vec::new(),
    };
    let places = function.arguments.iter().flat_map(|a| argument((a.name.as_str(), a.shape)));
    places.map(|place| format!("requires \\is_finite({place});")).collect()
}

/// The statuses that a call can give, the lowest last.
fn statuses(function: &Function) -> Vec<&'static str> {
    let mut all: BTreeSet<i32> = BTreeSet::new();
    let mut words = Vec::new();
    let mut add = |status: Status| {
        if all.insert(status.number()) {
            words.push(word(status));
        }
    };
    function.finish.each(&mut |end| {
        if let Finish::Give(_, Ending::Known(status)) | Finish::Fail(status) = end {
            add(*status);
        }
    });
    if function.guarded {
        // Where it can fail by nothing else, by a NULL pointer.
        add(function.failures.first().copied().unwrap_or(Status::Input));
    }
    function.failures.iter().for_each(|status| add(*status));
    words
}

/// The fields of which `init` has seen that they are finite, and which no call changes.
fn seen(code: &Code) -> Vec<&str> {
    let changed = changed(code);
    let mut tested = BTreeSet::new();
    for statement in &code.init {
        let Statement::Require(test, _) = statement else { continue };
        let parts = if let Test::All(tests) = test { tests } else { std::slice::from_ref(test) };
        for part in parts {
            if let Test::Finite(Expr::Local(name)) = part {
                tested.insert(name.as_str());
            }
        }
    }
    let fields = code.fields.iter().map(|field| field.name.as_str());
    fields.filter(|field| tested.contains(field) && !changed.contains(field)).collect()
}

/// The fields that a call changes.
pub(in crate::emit) fn changed(code: &Code) -> BTreeSet<&str> {
    let changed = |statement| match statement {
        &Statement::Set(Place::Field(ref name), _) => Some(name.as_str()),
        _ => None,
    };
    set(code.functions.iter().flat_map(|function| function.body.iter().filter_map(changed)))
}
