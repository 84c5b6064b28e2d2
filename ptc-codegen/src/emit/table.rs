//! The table of operations and languages in CONTRIBUTING.md, from what the printers write.

use std::fs;
use std::path::Path;

use super::c::C;
use super::cpp::Cpp;
use super::matlab::Matlab;
use super::print::Syntax;
use super::python::Python;
use super::rust::Rust;
use super::st::StructuredText;
use crate::family::Family;
use crate::request::Spec;

/// How one operation, on operands called a and b, is written.
type Row = (&'static str, fn(&dyn Syntax) -> String);

const ROWS: [Row; 19] = [
    ("Number 0.5", |s| s.literal("0.5")),
    ("Neg, Add, Sub, Mul, Div", |_| "-a, a + b, a - b, a * b, a / b".to_owned()),
    ("Quotient", |s| s.quotient("a", "b", "zero")),
    ("Max", |s| s.max("a", "b")),
    ("Min", |s| s.min("a", "b")),
    ("Call(Abs)", |s| s.abs("a")),
    ("Call(Sign)", |s| s.sign("a", "zero", "one")),
    ("Call(Sqrt)", |s| call(s, "sqrt")),
    ("Call(Exp)", |s| call(s, "exp")),
    ("Call(Ln)", |s| call(s, "ln")),
    ("Call(Atan)", |s| call(s, "atan")),
    ("Pow", |s| s.call("pow", &["a".to_owned(), "b".to_owned()])),
    ("Law", |s| s.law(&["a".to_owned(), "b".to_owned()], "t").1),
    ("Element", |s| s.element("row", 0)),
    ("a definition", |s| s.define("v", "a")),
    ("a choice", |s| s.select("condition", "a", "b")),
    ("a field", |s| s.field("c1")),
    ("is a finite", |s| s.finite("a")),
    ("the law after the deadline", |s| s.after()),
];

fn call(syntax: &dyn Syntax, function: &str) -> String {
    syntax.call(function, &["a".to_owned()])
}

fn table() -> String {
    let spec = Spec::new(2, Family::Exp);
    let (c, rust, cpp) = (C::new(&spec), Rust::new(&spec, ""), Cpp::new(&spec));
    let (matlab, python, st) = (Matlab::new(&spec), Python::new(&spec), StructuredText::new(&spec));
    let languages: [&dyn Syntax; 6] = [&c, &rust, &cpp, &matlab, &python, &st];
    // An FMU is made of C.
    let printed = super::TARGETS.iter().take(languages.len());
    let names: Vec<_> = printed.map(|target| target.name).collect();
    let mut lines = vec![
        format!("| operation | {} |", names.join(" | ")),
        format!("| --- |{}", " --- |".repeat(names.len())),
    ];
    for (operation, write) in ROWS {
        let cells = languages.map(|language| format!("`{}`", write(language).replace('|', "\\|")));
        lines.push(format!("| {operation} | {} |", cells.join(" | ")));
    }
    lines.join("\n")
}

#[test]
fn contributing_shows_what_the_printers_write() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../CONTRIBUTING.md");
    let text = fs::read_to_string(&path).expect("CONTRIBUTING.md");
    let (open, close) = ("<!-- operations -->\n", "\n<!-- end of operations -->");
    let (before, rest) = text.split_once(open).expect("the place of the table");
    let (shown, after) = rest.split_once(close).expect("its end");
    let table = table();
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, format!("{before}{open}{table}{close}{after}")).expect("a page");
        return;
    }
    assert_eq!(
        shown, table,
        "refresh with `UPDATE_GOLDEN=1 cargo test -p ptc-codegen --lib table`"
    );
}
