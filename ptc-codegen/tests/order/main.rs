//! The line is a line: no room of the library imports from a later one, in the order of the table in
//! ARCHITECTURE.md, and the files of the command import from each other in no circle.

mod imports;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use imports::{File, Imports};

const PAGE: &str = include_str!("../../../ARCHITECTURE.md");

/// The rooms in their order: the first column of the table under the heading `Order`.
fn rooms() -> Vec<String> {
    let (_, from) = PAGE.split_once("\n## Order\n").expect("a heading");
    let section = from.split("\n## ").next().unwrap_or(from);
    let name = |line: &str| Some(line.strip_prefix("| `")?.split_once('`')?.0.to_owned());
    section.lines().filter_map(name).collect()
}

/// The files under `src` but the roots of the two crates.
fn files() -> Vec<File> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let (mut files, mut folders) = (Vec::new(), vec![root.clone()]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            let name = path.strip_prefix(&root).expect("under src").to_string_lossy().into_owned();
            match path.is_dir() {
                true => folders.push(path),
                false if !name.ends_with(".rs") || ["lib.rs", "main.rs"].contains(&&*name) => {}
                false => files.push(File { name, text: fs::read_to_string(&path).expect("text") }),
            }
        }
    }
    files.sort_by(|a, b| a.name.cmp(&b.name));
    files
}

/// The files with what they import.
static CODE: LazyLock<Vec<(File, Imports)>> = LazyLock::new(|| {
    let files = files();
    let modules = files.iter().map(File::module).collect();
    files.into_iter().map(|file| (file.clone(), file.imports(&modules))).collect()
});

/// The same with `text` behind that of the file called `name`.
fn with(name: &str, text: &str) -> Vec<(File, Imports)> {
    let mut code = CODE.clone();
    let modules = code.iter().map(|(file, _)| file.module()).collect();
    let (file, imports) = code.iter_mut().find(|(file, _)| file.name == name).expect(name);
    file.text.push_str(text);
    *imports = file.imports(&modules);
    code
}

/// Without the files that are compiled for tests alone.
fn shipped(code: &[(File, Imports)]) -> Vec<(&File, &Imports)> {
    let tests: BTreeSet<_> = code.iter().flat_map(|(_, i)| i.for_tests.iter().cloned()).collect();
    let is_test = |file: &File| {
        let module = file.module();
        (1..=module.len()).any(|depth| tests.contains(&module[..depth]))
    };
    code.iter().filter(|(file, _)| !is_test(file)).map(|(file, imports)| (file, imports)).collect()
}

/// Every import from a later room, from the root, and every block of methods on a type of another
/// room: its callers would import nothing.
fn back_edges(code: &[(File, Imports)], order: &[String]) -> Vec<String> {
    let place = |room: &str| order.iter().position(|other| other == room);
    let mut found = Vec::new();
    for (file, imports) in shipped(code) {
        let module = file.module();
        let Some(own) = place(&module[0]) else {
            found.push(format!("{}: no row of the table", file.name));
            continue;
        };
        // The command is a crate of its own.
        let paths = imports.paths.iter().filter(|path| path.first() != module.first());
        for path in paths {
            match path.first().and_then(|room| place(room)) {
                Some(other) if other < own => {}
                Some(_) => found.push(format!("{}: {}", file.name, path.join("::"))),
                None => found.push(format!("{}: {} of the root", file.name, path.join("::"))),
            }
        }
        let elsewhere = |path: &&imports::Path| path.first() != module.first();
        for path in imports.extended.iter().filter(elsewhere) {
            found.push(format!("{}: methods of {}", file.name, path.join("::")));
        }
    }
    found
}

/// The files of the command that are in a circle.
fn in_circles(code: &[(File, Imports)]) -> BTreeSet<String> {
    let of_command = |(file, _): &(&File, &Imports)| file.name.starts_with("cli/");
    let own: Vec<_> = shipped(code).into_iter().filter(of_command).collect();
    let by_module: BTreeMap<_, _> =
        own.iter().map(|(file, _)| (file.module(), file.name.clone())).collect();
    // The file that holds what a path names: that of the longest module in it.
    let holder = |path: &imports::Path| {
        (1..=path.len()).rev().find_map(|depth| by_module.get(&path[..depth]))
    };
    let mut edges: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (file, imports) in &own {
        let to = imports.paths.iter().filter_map(holder).filter(|other| **other != file.name);
        edges.insert(file.name.clone(), to.cloned().collect());
    }
    // What imports from nothing that is left is in no circle, nor does what nothing left imports.
    loop {
        let before = edges.len();
        let names: BTreeSet<_> = edges.keys().cloned().collect();
        let used: BTreeSet<_> = edges.values().flatten().cloned().collect();
        edges.retain(|name, to| used.contains(name) && to.iter().any(|to| names.contains(to)));
        let names: BTreeSet<_> = edges.keys().cloned().collect();
        edges.values_mut().for_each(|to| to.retain(|to| names.contains(to)));
        if edges.len() == before {
            return names;
        }
    }
}

#[test]
fn every_row_is_a_room() {
    let modules: BTreeSet<_> = CODE.iter().map(|(file, _)| file.module()[0].clone()).collect();
    let order = rooms();
    assert_eq!(order.iter().cloned().collect::<BTreeSet<_>>(), modules);
    assert_eq!(order.len(), modules.len(), "a room has one row");
}

#[test]
fn no_room_imports_from_a_later_one() {
    let found = back_edges(&CODE, &rooms());
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn the_files_of_the_command_stand_in_no_circle() {
    let found = in_circles(&CODE);
    assert!(found.is_empty(), "{found:?}");
}

#[test]
fn a_back_edge_is_seen_however_it_is_written() {
    let order = rooms();
    for (name, text, seen) in [
        ("limits.rs", "use crate::emit::Language;", "crate::emit::Language"),
        ("limits.rs", "use super::emit::{self, Project as P};", "emit"),
        ("law.rs", "pub(crate) use crate::{check::{Verdict, examine}};", "check::Verdict"),
        ("law.rs", "use crate::{algebra::Poly as _, lower as l};", "lower"),
        ("program/rows.rs", "fn f() { let x = super::super::lower::lower; }", "lower::lower"),
        (
            "program/mod.rs",
            "mod deep { fn f() -> super::super::verify::Trial {} }",
            "verify::Trial",
        ),
        (
            "program/mod.rs",
            "fn f() { println!(\"{}\", crate::check::digits(1.0)) }",
            "check::digits",
        ),
        ("program/mod.rs", "#[doc(alias = crate::check::NAME)] fn f() {}", "check::NAME"),
        ("program/mod.rs", "fn f() { g::<crate::check::Outcome>() }", "check::Outcome"),
        ("lower/mod.rs", "use crate::family::Family as F; impl F { }", "methods of family::Family"),
        ("lower/mod.rs", "impl crate::request::Spec { }", "methods of request::Spec"),
        (
            "lower/mod.rs",
            "use crate::request::Spec as S; impl<F: for<'a> Fn(&'a u8) -> u8> S { }",
            "methods of request::Spec",
        ),
        ("check/mod.rs", "use crate::generate;", "generate of the root"),
        ("check/mod.rs", "#[cfg(feature = \"cli\")] use crate::emit::File;", "emit::File"),
    ] {
        let found = back_edges(&with(name, text), &order);
        let seen = seen.trim_start_matches("crate::");
        assert!(found.contains(&format!("{name}: {seen}")), "{text}: {found:?}");
    }
}

#[test]
fn what_is_no_import_is_none() {
    let order = rooms();
    for text in [
        "// use crate::emit::Language;",
        "/// See [`crate::emit`].\nfn f() {}",
        "const A: &str = \"crate::emit::Language\";",
        "#[cfg(test)] mod more { use crate::emit::Language; }",
        "#[cfg(test)] use crate::emit::Language;",
        "#[cfg(all(test, unix))] fn f() { crate::emit::emit() }",
        "use std::fmt::Debug as emit; fn f(x: impl emit) {}",
        "mod within { use super::TABLE; }",
        "struct Own<T>(T); impl<T: Into<u8>> Own<T> { fn f(x: impl Fn()) {} }",
        "use self::Limit as L; impl<T> From<T> for L { }",
    ] {
        let found = back_edges(&with("limits.rs", text), &order);
        assert!(found.is_empty(), "{text}: {found:?}");
    }
}

#[test]
fn a_room_out_of_its_order_and_a_circle_are_seen() {
    let mut order = rooms();
    let (law, lower) = ("law".to_owned(), "lower".to_owned());
    let place = |room: &String| order.iter().position(|other| other == room).expect("a room");
    let (a, b) = (place(&law), place(&lower));
    order.swap(a, b);
    let found = back_edges(&CODE, &order);
    assert!(
        found.iter().any(|edge| edge.starts_with("lower/") && edge.contains(": law::")),
        "{found:?}"
    );
    assert_eq!(
        in_circles(&with("cli/write.rs", "use super::emit::Emit;"))
            .iter()
            .filter(|name| ["cli/write.rs", "cli/emit/mod.rs"].contains(&name.as_str()))
            .count(),
        2
    );
}
