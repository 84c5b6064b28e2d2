//! Controllers in samples in Rust.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use ptc_codegen::code::{Access, Shape};
use ptc_codegen::parameter::Precision;

use super::super::{run, rustc};
use super::{Design, answers};

const RUST_MAIN: &str = r#"
fn number(words: &mut dyn Iterator<Item = &'static str>) -> f64 {
    f64::from_bits(u64::from_str_radix(words.next().unwrap(), 16).unwrap())
}
fn show(value: f64) {
    if value.is_nan() { print!(" nan") } else { print!(" {:016x}", value.to_bits()) }
}
trait Design {
    fn init(&mut self, words: &mut dyn Iterator<Item = &'static str>) -> i32;
    fn arm(&mut self, k: u32);
    fn step(&mut self, k: u32, words: &mut dyn Iterator<Item = &'static str>);
}
macro_rules! status {
    ($module:ident, $status:expr) => {{
        use $module::Status;
        match $status { Status::Ok => 0, Status::Hold => 1, Status::Saturated => 2, Status::After => 3, Status::Gated => 4, Status::Late => 5, Status::Infeasible => 6 }
    }};
}
macro_rules! outcome {
    ($module:ident, $call:expr) => {{
        use $module::Error;
        match $call {
            Ok(given) => Ok(given),
            Err(Error::Param) => Err(-1),
            Err(Error::Input) => Err(-2),
            Err(Error::Range) => Err(-3),
            Err(Error::Soon) => Err(-4),
        }
    }};
}
fn main() {
    let text: &'static str = std::io::read_to_string(std::io::stdin()).unwrap().leak();
    let mut words = text.split_whitespace();
    let mut designs = designs();
    let mut at = 0;
    while let Some(word) = words.next() {
        match word {
            "D" => at = words.next().unwrap().parse().unwrap(),
            "I" => println!("I {}", designs[at].init(&mut words)),
            _ => {
                let k = words.next().unwrap().parse().unwrap();
                if word == "A" { designs[at].arm(k) } else { designs[at].step(k, &mut words) }
            }
        }
    }
}
"#;

pub(crate) fn in_rust(folder: &Path, designs: &[Design]) -> Option<Vec<String>> {
    let mut text = RUST_MAIN.to_owned();
    let mut all = String::new();
    for (i, design) in designs.iter().enumerate() {
        let (name, kind, m) = (&design.code.name, design.kind(), design.measured());
        let real = if design.code.precision == Precision::F32 { "f32" } else { "f64" };
        let value = |_| format!("number(words) as {real}");
        let fields: String = design
            .parameters()
            .map(|(field, shape)| match shape {
                Shape::Gains | Shape::Lists(..) | Shape::Statuses(_) => {
                    unreachable!("no parameter")
                }
                Shape::Count => format!("{field}: number(words) as u32, "),
                Shape::Real => format!("{field}: {}, ", value(0)),
                Shape::Reals(n) => {
                    format!("{field}: [{}], ", (0..n).map(value).collect::<Vec<_>>().join(", "))
                }
            })
            .collect();
        let given: String = design
            .given()
            .map(|(function, length)| match length {
                Some(_) => format!("for e in this.{}() {{ show(f64::from(e)); }} ", function.name),
                None => format!("show(f64::from(this.{}())); ", function.name),
            })
            .collect();
        let values = |count| (0..count).map(value).collect::<Vec<_>>();
        let array = |count: usize, columns: Option<usize>| match columns {
            Some(columns) => {
                let rows = values(count)
                    .chunks(columns)
                    .map(|row| format!("[{}]", row.join(", ")))
                    .collect::<Vec<_>>();
                rows.join(", ")
            }
            None => values(count).join(", "),
        };
        let x = array(m, design.columns());
        let r = match design.references() {
            0 => String::new(),
            count => format!(", &[{}]", array(count, design.row())),
        };
        let step = match (design.observes(), design.code.axes()) {
            (true, _) => format!(
                "let y = [{x}]; let u = {}; let status = outcome!({name}, this.update(k, &y, u)).map_or_else(|e| e, |s| status!({name}, s)); print!(\"S {{status}}\");",
                value(0)
            ),
            (false, Some(_)) => format!(
                "let c = this.step(k, &[{x}]{r}); let number = |s| outcome!({name}, s).map_or_else(|e| e, |s| status!({name}, s)); \
                 print!(\"S {{}}\", number(c.status)); for u in c.u {{ show(f64::from(u)); }} for s in c.axes {{ print!(\" {{}}\", number(s)); }}"
            ),
            (false, None) => format!(
                "let (status, u) = outcome!({name}, this.step(k, &[{x}]{r})).map_or_else(|e| (e, 0.0), |c| (status!({name}, c.status), f64::from(c.u))); print!(\"S {{status}}\"); show(u);"
            ),
        };
        let path = design.folder.join(format!("{name}.rs"));
        write!(
            text,
            "#[path = \"{}\"]\n#[allow(dead_code)]\nmod {name};\nstruct D{i}(Option<{name}::{kind}>);\n\
             impl Design for D{i} {{\n\
             #[allow(unused_variables, clippy::all)]\n\
             fn init(&mut self, words: &mut dyn Iterator<Item = &'static str>) -> i32 {{\n\
             match {name}::{kind}::new({name}::{kind}Params {{ {fields}}}) {{ Ok(made) => {{ self.0 = Some(made); 0 }}, Err(_) => -1 }} }}\n\
             fn arm(&mut self, k: u32) {{ self.0.as_mut().unwrap().arm(k); }}\n\
             fn step(&mut self, k: u32, words: &mut dyn Iterator<Item = &'static str>) {{\n\
             let this = self.0.as_mut().unwrap(); {step}\n\
             {given}println!(); }} }}\n",
            path.display()
        )
        .expect("a string");
        write!(all, "Box::new(D{i}(None)), ").expect("a string");
    }
    writeln!(text, "fn designs() -> Vec<Box<dyn Design>> {{ vec![{all}] }}").expect("a string");
    let (source, program) = (folder.join("main.rs"), folder.join("in_rust"));
    fs::write(&source, text).expect("Rust");
    run(rustc().arg(&source).arg("-o").arg(&program));
    if Command::new("rustfmt").arg("--version").output().is_ok() {
        // As users format: without the options of this project.
        fs::write(folder.join("rustfmt.toml"), "").expect("options");
        let files = designs.iter().map(|d| d.folder.join(format!("{}.rs", d.code.name)));
        let options = ["--check", "--edition=2024", "--config-path"];
        run(Command::new("rustfmt").args(options).arg(folder).args(files));
    }
    Some(answers(&mut Command::new(program), folder))
}
