//! Random calls of `arm`, `arm_for` and `step` of the emitted C, with odd numbers among their arguments. After each start
//! the controller has the bytes of a fresh one that `init` made of the same duration and `arm` started; where a start is
//! refused, it has the bytes of before. What a step gives is that of the design without the key.

use std::process::Command;

use ptc_codegen::emit::Language;
use ptc_codegen::generate;
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::plant::as_one;
use ptc_codegen::request::{After, Feedback, Spec};

use super::designs::{families, kinds};
use crate::support;

/// The driver, behind the definitions of one design.
const MAIN: &str = include_str!("main.c");

/// The definitions of a design for the driver.
fn definitions(spec: &Spec) -> String {
    let (one, _) = as_one(spec.clone(), None);
    let (inputs, states) = (one.input_names().len(), one.states());
    let several = spec.axes.is_some() || spec.coupled.is_some();
    let references = spec.references();
    let real = if spec.precision == Precision::F32 { "float" } else { "double" };
    let x = match spec.rows_of_axes() {
        Some((_, n)) => format!("(const real (*)[{n}])x"),
        None => "x".to_owned(),
    };
    let r = match several {
        true => format!("(const real (*)[{references}])r"),
        false => "r".to_owned(),
    };
    let mut arguments = vec![x];
    arguments.extend((references > 0).then_some(r));
    let calls = [
        (spec.feedback == Feedback::Extern).then_some("law"),
        (spec.after == After::Extern).then_some("rest"),
    ];
    let calls: Vec<_> = calls.into_iter().flatten().map(str::to_owned).collect();
    let context = (!calls.is_empty()).then(|| "NULL".to_owned());
    arguments.extend(calls.into_iter().chain(context));
    arguments.push(if several { "u, axes" } else { "u" }.to_owned());
    let mut fill = String::new();
    for (index, parameter) in spec.run_time_parameters().enumerate() {
        let value = match parameter {
            Parameter::Tau => "tau".to_owned(),
            Parameter::StartTime => "(real)0.3".to_owned(),
            Parameter::Eps => "(real)0.04".to_owned(),
            Parameter::UMax => "(real)7".to_owned(),
            Parameter::UMin => "(real)-5".to_owned(),
            Parameter::Start => "(real)0.25".to_owned(),
            _ => format!("(real){}", 0.75 + 0.125 * index as f64),
        };
        let place = match parameter.index() {
            Some(index) => format!("{}[{index}]", parameter.key()),
            None => parameter.key().to_owned(),
        };
        fill += &format!(" p->{place} = {value};");
    }
    let latched = if spec.latches() { ", x0" } else { "" };
    format!(
        "typedef {real} real;\n#define INPUTS {inputs}\n#define STATES {states}\n#define GIVEN {}\n\
         #define LATCHED {latched}\n#define STEP(call, c, t) call(c, t, {})\n#define FILL(p, tau) {fill}\n\
         #define TRUSTS {}\n",
        states + references * inputs + 1,
        arguments.join(", "),
        i32::from(spec.guard != ptc_codegen::request::Guard::Full),
    )
}

#[track_caller]
fn holds(name: &str, spec: &Spec) {
    let folder = support::folder(name);
    let plain = Spec { in_flight: false, name: Some("plain".to_owned()), ..spec.clone() };
    for file in [spec, &plain].into_iter().flat_map(|spec| {
        generate(spec, Language::C).unwrap_or_else(|found| panic!("{name}: {found:?}"))
    }) {
        std::fs::write(folder.join(file.name), file.text).expect("a file");
    }
    std::fs::write(folder.join("main.c"), definitions(spec) + MAIN).expect("a file");
    let built = Command::new("gcc")
        .args(["-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off"])
        .args(["-o", "run", "main.c", "own.c", "plain.c", "-lm"])
        .current_dir(&folder)
        .output()
        .expect("gcc");
    assert!(built.status.success(), "{name}: {}", String::from_utf8_lossy(&built.stderr));
    let ran = Command::new(folder.join("run")).output().expect("a program");
    let told = String::from_utf8_lossy(&ran.stdout);
    let counts: Vec<u32> = told.split_whitespace().filter_map(|n| n.parse().ok()).collect();
    let [armed, refused, steps] = counts[..] else { panic!("{name}: {told}") };
    assert!(ran.status.success(), "{name}: {told}");
    assert!(armed > 500 && refused > 500 && steps > 500, "{name}: {told}");
}

#[test]
fn families_start_as_fresh_ones() {
    families().iter().for_each(|(name, spec)| holds(name, spec));
}

#[test]
fn designs_of_each_kind_start_as_fresh_ones() {
    kinds().iter().for_each(|(name, spec)| holds(name, spec));
}
