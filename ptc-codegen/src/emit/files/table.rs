//! The table of operations and languages in CONTRIBUTING.md, from what the printers write.

use std::fs;
use std::path::Path;

use super::text::Text;
use super::{c, cpp, matlab, python, st};
use crate::algebra::BigRational;
use crate::code::{Cell, Code, Expr, Index, Operator, Owner, Test};
use crate::emit::code::rust::Rust;
use crate::expression::Function;
use crate::parameter::Precision;

fn table() -> String {
    let code = Code {
        name: "name".to_owned(),
        precision: Precision::F64,
        head: Vec::new(),
        parameters: Vec::new(),
        fields: Vec::new(),
        gains: Vec::new(),
        tables: Vec::new(),
        init: Vec::new(),
        start: None,
        functions: Vec::new(),
    };
    let [a, b, c] = ["a", "b", "c"].map(|name| move || Expr::local(name));
    let call = |function| Expr::Call(function, Box::new(a()));
    let less = || Test::Less(a(), b());
    let operations = [
        ("Number 1/2", Expr::Number(BigRational::new(1.into(), 2.into()))),
        ("Neg", Expr::Neg(Box::new(a()))),
        ("Binary(Add)", Expr::binary(Operator::Add, a(), b())),
        ("Binary(Mul)", Expr::binary(Operator::Mul, a(), b())),
        ("Fused", Expr::Fused(Box::new([a(), b(), c()]))),
        ("Quotient", Expr::Quotient(Box::new(a()), Box::new(b()))),
        ("Choose(Less)", Expr::choose(less(), a(), b())),
        ("Call(Abs)", call(Function::Abs)),
        ("Call(Sign)", call(Function::Sign)),
        ("Call(Sqrt)", call(Function::Sqrt)),
        ("Call(Ln)", call(Function::Ln)),
        ("Call(Atan)", call(Function::Atan)),
        ("Pow", Expr::Pow(Box::new(a()), Box::new(b()))),
        ("Callback", Expr::Callback("pi0", "xi".to_owned(), Box::new(Expr::local("t")))),
        ("Element", Expr::Element("row".to_owned(), 0)),
        (
            "Entry",
            Expr::Entry("r".to_owned(), Cell { row: Index::of("axis"), column: 1, columns: 2 }),
        ),
        ("At", Expr::At("p".to_owned(), Index::of("k") - Index::of("m") - Index::at(1))),
        ("Field", Expr::field("c1")),
        ("FieldElement", Expr::FieldElement("gain".to_owned(), 0)),
        ("CountSub", a().count_sub(b())),
        ("CountLeft", a().count_left(b())),
        ("Real", a().real()),
    ];
    let tests = [
        ("All(Less, Finite)", Test::All(vec![less(), Test::Finite(a())])),
        ("NotNumber", Test::NotNumber(a())),
        ("CountEqual", Test::CountEqual(a(), b())),
    ];
    let notes = c::Notes::default();
    let printers = texts(&code, &notes);
    let names: Vec<_> = printers.iter().map(|(name, _)| *name).collect();
    let mut lines = vec![
        format!("| operation | {} |", names.join(" | ")),
        format!("| --- |{}", " --- |".repeat(names.len())),
    ];
    let rows = operations.iter().map(|(name, e)| {
        let cells = printers.iter().map(|(_, text)| match e {
            Expr::Fused(_) => text.fused(&["a", "b", "c"].map(str::to_owned)),
            e => Some(text.alone(e)),
        });
        let cells: Vec<_> = cells.map(|cell| cell.unwrap_or("refused".to_owned())).collect();
        (name, cells)
    });
    let tests = tests.iter().map(|(name, test)| {
        let cells: Vec<_> = printers.iter().map(|(_, text)| text.test(test)).collect();
        (name, cells)
    });
    for (name, cells) in rows.chain(tests) {
        let cells: Vec<_> =
            cells.iter().map(|cell| format!("`{}`", cell.replace('|', "\\|"))).collect();
        lines.push(format!("| {name} | {} |", cells.join(" | ")));
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

/// Every language by name, and how it writes expressions.
fn texts<'a>(code: &'a Code, notes: &'a c::Notes) -> Vec<(&'static str, Box<dyn Text + 'a>)> {
    vec![
        ("C", Box::new(c::C::new(code, notes))),
        ("Rust", Box::new(Rust::new(code, ""))),
        ("C++", Box::new(cpp::Cpp::new(code))),
        ("MATLAB", Box::new(matlab::Matlab::new(code, Owner::Controller))),
        ("Python", Box::new(python::Python::new(code))),
        ("Structured Text", Box::new(st::StructuredText::new(code))),
    ]
}
