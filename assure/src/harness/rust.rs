//! The Rust side of a program: a library of functions `drive_0`, `drive_1`, ... that the main
//! program in C calls, as it calls those of the C side.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use ptc_codegen::emit::Language;
use ptc_codegen::parameter::Parameter;
use ptc_codegen::request::{After, Feedback, Spec};

use super::machine::Machine;
use super::program::{has_gains, numbers, real};
use super::{in_pairs, run, rustc, write};

/// The static library of each batch of specs, in its folder of `homes`.
pub(super) fn libraries(
    machine: Machine,
    homes: &[PathBuf],
    batches: &[Vec<&Spec>],
) -> Vec<PathBuf> {
    for (home, batch) in homes.iter().zip(batches) {
        fs::write(home.join("lib.rs"), library(home, batch, machine)).expect("a library");
    }
    match machine.rust_target() {
        None => in_pairs(homes, |home| {
            let path = home.join("liball.a");
            run(rustc()
                .args(["-O", "-Ccodegen-units=1", "--crate-type=staticlib", "--crate-name=all"])
                .arg(home.join("lib.rs"))
                .arg("-o")
                .arg(&path));
            path
        }),
        Some((target, flags)) => cross_compiled(homes, target, flags),
    }
}

/// The libraries for a machine without `std`, as packages of one workspace: cargo brings `libm`.
fn cross_compiled(homes: &[PathBuf], target: &str, flags: &str) -> Vec<PathBuf> {
    let Some(root) = homes.first().and_then(|home| home.parent()) else { return Vec::new() };
    let name = |home: &Path| home.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let members: Vec<_> = homes.iter().map(|home| format!("{:?}", name(home))).collect();
    let workspace = format!(
        "[workspace]\nresolver = \"3\"\nmembers = [{}]\n\n[profile.release]\npanic = \"abort\"\n\
         codegen-units = 1\n",
        members.join(", ")
    );
    fs::write(root.join("Cargo.toml"), workspace).expect("a workspace");
    for home in homes {
        let package = format!(
            "[package]\nname = {:?}\nversion = \"0.0.0\"\nedition = \"2024\"\npublish = false\n\n\
             [lib]\ncrate-type = [\"staticlib\"]\npath = \"lib.rs\"\n\n[features]\nlibm = []\n\n\
             [dependencies]\nlibm = \"0.2.15\"\n",
            name(home)
        );
        fs::write(home.join("Cargo.toml"), package).expect("a package");
    }
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo
        .current_dir(root)
        .args(["build", "--quiet", "--release", "--features", "libm", "--target", target])
        .env("RUSTFLAGS", flags)
        .env("CARGO_TARGET_DIR", root.join("target"))
        .env_remove("CARGO_BUILD_TARGET")
        // As a user's compiler would, whatever wraps the one that builds this.
        .env_remove("RUSTC_WORKSPACE_WRAPPER");
    run(cargo.arg("--workspace"));
    let built = root.join("target").join(target).join("release");
    homes.iter().map(|home| built.join(format!("lib{}.a", name(home)))).collect()
}

/// The head of a library without `std`.
const BARE: &str = "#![no_std]\n#[panic_handler]\nfn panic(_: &core::panic::PanicInfo<'_>) -> ! {\n    loop {}\n}\n";

/// Flags that link a C program for `machine` with the addition of doubles of Rust's
/// compiler_builtins, which is that of IEEE 754, in place of libgcc's.
pub fn ieee_addition(machine: Machine, folder: &Path) -> Vec<String> {
    let Some((target, _)) = machine.rust_target() else { return Vec::new() };
    let (source, library) = (folder.join("addition.rs"), folder.join("libaddition.a"));
    fs::write(&source, BARE).expect("a library");
    let flags = ["-O", "-Cpanic=abort", "--crate-type=staticlib", "--target", target];
    run(rustc().args(flags).arg(&source).arg("-o").arg(&library));
    let wanted = "-Wl,--undefined=__aeabi_dadd,--undefined=__aeabi_dsub,--no-warn-execstack";
    vec![wanted.to_owned(), library.to_string_lossy().into_owned()]
}

/// The text of the library of the specs in `batch`, whose files go to `home`.
fn library(home: &Path, batch: &[&Spec], machine: Machine) -> String {
    let mut text = String::new();
    if machine != Machine::Host {
        text.push_str(BARE);
    }
    for (index, spec) in batch.iter().enumerate() {
        let folder = home.join(format!("r{index}"));
        fs::create_dir_all(&folder).expect("a folder");
        let file = write(&folder, spec, Language::Rust).remove(0);
        // A program uses less of each module than a crate would offer.
        let _ = writeln!(text, "#[allow(dead_code)]\n#[path = {file:?}]\nmod c{index};");
        text.push_str(&drive(index, spec));
    }
    text
}

/// The function of one controller.
fn drive(index: usize, spec: &Spec) -> String {
    let (real, n, count) = (real(spec.precision), spec.n, spec.run_time_parameters().count());
    let (type_name, length) = (spec.type_name(), numbers(spec));
    let start = length - spec.given() - 1;
    let latched = if spec.latches() { format!(", &array(record, {count})") } else { String::new() };
    let mut externs = String::new();
    if spec.feedback == Feedback::Extern {
        let _ = write!(
            externs,
            ", |xi: &[{real}; {n}], t: {real}| xi.iter().fold(0.0, |s, xi| s + -1.5 * xi) + 0.125 * t"
        );
    }
    if spec.after == After::Extern {
        let _ = write!(externs, ", |x: &[{real}; {n}], _t: {real}| -x[0]");
    }
    let (given, reference) = match spec.references() {
        0 => ("", String::new()),
        count => {
            let at = start + 1 + n;
            let array = format!("    let r: [{real}; {count}] = array(record, {at});\n");
            (", &r", array)
        }
    };
    let axis = if has_gains(spec) {
        format!(
            "        (status[2], u[1]) = code(own.tick(t).and_then(|gains| gains.axis(&x{given})));\n"
        )
    } else {
        String::new()
    };
    let again = if spec.latches() { ", &x" } else { "" };
    let (arm, again) = match spec.changes_duration() {
        true => ("arm_for", format!(", 0.75 * record[0]{again}")),
        false => ("arm", again.to_owned()),
    };
    format!(
        "
#[unsafe(no_mangle)]
pub extern \"C\" fn drive_{index}(record: *const {real}, status: *mut i32, u: *mut {real}) {{
    use c{index}::{{Control, Error, Status, {type_name}, {type_name}Params}};
    // SAFETY: the main program hands over a record, four statuses and three numbers.
    let (record, status, u) = unsafe {{
        (core::slice::from_raw_parts(record, {length}), &mut *status.cast::<[i32; 4]>(), &mut *u.cast::<[{real}; 3]>())
    }};
    fn array<const N: usize>(record: &[{real}], at: usize) -> [{real}; N] {{
        core::array::from_fn(|i| record[at + i])
    }}
    // The numbers that C gives the same outcomes.
    let code = |outcome: Result<Control<{real}>, Error>| match outcome {{
        Ok(control) => (match control.status {{
            Status::Ok => 0,
            Status::Hold => 1,
            Status::Saturated => 2,
            Status::After => 3,
            Status::Gated => 4,
            Status::Late => 5,
            Status::Infeasible => 6,
        }}, control.u),
        Err(Error::Param) => (-1, 0.0),
        Err(Error::Input) => (-2, 0.0),
        Err(Error::Range) => (-3, 0.0),
        Err(Error::Soon) => (-4, 0.0),
    }};
    let (t, x): (_, [{real}; {n}]) = (record[{start}], array(record, {start} + 1));
{reference}    *status = [0; 4];
    *u = [12345.0; 3];
    match {type_name}::new({type_name}Params {{ {} }}{latched}) {{
        Err(_) => status[0] = -1,
        Ok(mut own) => {{
        (status[0], (status[1], u[0])) = (0, code(own.step(t, &x{given}{externs})));
{axis}        match own.{arm}(t{again}) {{
            Ok(()) => (status[3], u[2]) = code(own.step(t, &x{given}{externs})),
            Err(_) => status[3] = -1,
        }}
        }}
    }}
}}
",
        fields(spec)
    )
}

/// The fields of the parameters, each from its place in the record.
fn fields(spec: &Spec) -> String {
    let free: Vec<_> = spec.run_time_parameters().collect();
    let mut fields = Vec::new();
    for (at, parameter) in free.iter().enumerate() {
        let key = parameter.key();
        let same = |p: &&Parameter| p.key() == key;
        match parameter.index() {
            None => fields.push(format!("{key}: record[{at}]")),
            Some(0) => {
                let places = (at..at + free.iter().filter(same).count())
                    .map(|at| format!("record[{at}]"))
                    .collect::<Vec<_>>();
                fields.push(format!("{key}: [{}]", places.join(", ")));
            }
            Some(_) => {}
        }
    }
    fields.join(", ")
}
