//! Emitted Rust: no path to a panic, no allocation, no unsafe code.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::Result;
use ptc_codegen::emit::Language;
use ptc_codegen::request::{Feedback, Spec};

use super::seeded::{Defect, with_defect};
use crate::context::Context;
use crate::harness::{empty, write};
use crate::layer::{Finding, Layer};
use crate::tool::{RUSTC, ShownBy, Source, Tool};

const TARGET: &str = "thumbv7em-none-eabihf";

const CORTEX_M: Tool = Tool {
    name: "Rust for thumbv7em-none-eabihf",
    shown_by: ShownBy::Command(&[
        "sh",
        "-c",
        "test -d \"$(rustc --print sysroot)/lib/rustlib/thumbv7em-none-eabihf/lib\"",
    ]),
    source: Source::Rustup(&["target", "add", TARGET]),
};

pub(super) const LAYER: Layer = Layer {
    name: "rust",
    claim: "Emitted Rust has no path to a panic, allocates nothing and holds no unsafe code.",
    tools: &[RUSTC, CORTEX_M],
    run,
};

/// Symbol that a panic would call: nothing defines it, so that a program with a path to a panic does not link.
const PANIC: &str = "a_path_to_a_panic_is_left";

fn run(context: &Context) -> Result<Finding> {
    let folder = context.scratch("rust");
    // One program holds them all, so that more of them cost little.
    let families = context.families(context.order(6).max(4));
    let mut specs = [context.goldens(), families, context.random(40)].concat();
    // The user's own functions may panic; this is about the code that is emitted.
    specs.retain(|spec| spec.feedback != Feedback::Extern);
    let mut finding = Finding::default();
    let home = folder.join("all");
    for (index, spec) in specs.iter().enumerate() {
        write(&empty(&home.join(format!("src/c{index}"))), spec, Language::Rust);
    }
    finding.failures.extend(link(&home, &specs)?);
    finding.summary = format!(
        "{} controllers in one program without std and alloc for {TARGET}: {}",
        specs.len(),
        if finding.failures.is_empty() { "links, no panic is reachable" } else { "does not link" }
    );
    finding.notes.push(format!(
        "The program calls `new`, `arm`, `step`, `tick` and `axis` of each controller with values \
         that the compiler cannot know, and its panic handler calls a function that does not exist \
         (`{PANIC}`): it links only where the compiler removed every path to a panic (release \
         profile, link-time optimisation). There is no allocator to link with, and each file is \
         compiled under `forbid(unsafe_code)`."
    ));
    for (index, (defect, sign)) in DEFECTS.into_iter().enumerate() {
        let spec = context.example();
        let home = folder.join(format!("seeded{index}"));
        with_defect(&home.join("src/c0"), &spec, Language::Rust, defect)?;
        let told = link(&home, &[spec])?;
        let seen = told.is_some_and(|told| told.contains(sign));
        finding.seed(defect.2, seen.then(|| sign.to_owned()));
    }
    Ok(finding)
}

/// Defects, and what the tools say of each.
const DEFECTS: [(Defect, &str); 3] = [
    (("self.c1 * x[0]", "self.c1 * x[self.t0 as usize]", "an index that is not checked"), PANIC),
    (("self.c1 * x[0]", "self.c1 * unsafe { *x.as_ptr() }", "an unsafe block"), "unsafe"),
    (
        (
            "let past = ",
            "extern crate alloc; let all = alloc::vec![x[0], t]; let t = all[1]; let past = ",
            "a vector",
        ),
        "allocator",
    ),
];

/// Links a program of the controllers in `home`; what went wrong, where it does not link.
fn link(home: &Path, specs: &[Spec]) -> Result<Option<String>> {
    let mut text = format!(
        "#![no_std]\n#![no_main]\nuse core::hint::black_box;\n\
         unsafe extern \"C\" {{\n    fn {PANIC}() -> !;\n}}\n#[panic_handler]\n\
         fn panic(_: &core::panic::PanicInfo<'_>) -> ! {{\n    unsafe {{ {PANIC}() }}\n}}\n\
         #[unsafe(no_mangle)]\npub extern \"C\" fn _start() {{\n"
    );
    let mut modules = String::new();
    for (index, spec) in specs.iter().enumerate() {
        let name = spec.name();
        let _ = writeln!(
            modules,
            "#[forbid(unsafe_code)]\n#[allow(dead_code)]\n#[path = \"c{index}/{name}.rs\"]\nmod c{index};"
        );
        text.push_str(&calls(index, spec));
    }
    let manifest = "[package]\nname = \"linked\"\nversion = \"0.0.0\"\nedition = \"2024\"\npublish = \
                    false\n\n[features]\nlibm = []\n\n[dependencies]\nlibm = \"0.2.15\"\n\n\
                    [profile.release]\npanic = \"abort\"\nlto = true\ncodegen-units = 1\n\n[workspace]\n";
    fs::write(home.join("Cargo.toml"), manifest)?;
    fs::write(home.join("src/main.rs"), format!("{text}}}\n{modules}"))?;
    let output = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .current_dir(home)
        .args(["build", "--quiet", "--release", "--features", "libm", "--target", TARGET])
        .env("CARGO_TARGET_DIR", home.join("target"))
        .env("RUSTFLAGS", "-Clink-arg=--gc-sections")
        .output()?;
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    Ok((!output.status.success()).then_some(told))
}

/// The calls of one controller, with values that the compiler cannot know.
fn calls(index: usize, spec: &Spec) -> String {
    let (type_name, n) = (spec.type_name(), spec.n);
    let real = crate::harness::program::real(spec.precision);
    let params = format!(
        "unsafe {{ core::ptr::read_volatile(black_box(8 as *const c{index}::{type_name}Params)) }}"
    );
    let states = format!("&black_box([1.0 as {real}; {n}])");
    let start = if spec.latches() { format!(", {states}") } else { String::new() };
    let after = if spec.after == ptc_codegen::request::After::Extern {
        format!(", |x: &[{real}; {n}], _t: {real}| -x[0]")
    } else {
        String::new()
    };
    let mut text = format!(
        "    if let Ok(mut own) = c{index}::{type_name}::new({params}{start}) {{\n        \
         let t = black_box(1.0 as {real});\n        let _ = black_box(own.arm(t{start}));\n        \
         let _ = black_box(own.step(t, {states}{after}));\n"
    );
    if crate::harness::program::has_gains(spec) {
        let _ = writeln!(
            text,
            "        if let Ok(gains) = own.tick(t) {{ let _ = black_box(gains.axis({states})); }}"
        );
    }
    text.push_str("    }\n");
    text
}
