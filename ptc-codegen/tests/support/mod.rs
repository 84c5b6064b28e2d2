//! Helpers shared by the tests of the command and of its library.
// Each test file uses its own part of this module.
#![allow(dead_code)]

pub(crate) mod exact_plant;
pub(crate) mod runge_kutta;
#[cfg(feature = "cli")]
pub(crate) mod words;

use std::fs;
use std::panic::Location;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use ptc_codegen::diagnostic::Place;
use ptc_codegen::plant::{self, Plant};
use ptc_codegen::request::{Entry, Spec};
use ptc_codegen::syntax::Value;
use ptc_codegen::{design, request};

/// The entries of a design file's text.
pub(crate) fn entries(text: &str) -> Vec<Entry> {
    let (entries, found) = design::read(text, &mut |_| Place(0));
    assert_eq!(found, [], "{text}");
    entries
}

/// Entries whose key `urdf` has the text of a file.
pub(crate) fn with_urdf(mut entries: Vec<Entry>, text: &str) -> Vec<Entry> {
    for entry in entries.iter_mut().filter(|entry| entry.key == "urdf") {
        entry.value.value = Value::File(entry.value.value.to_string(), Ok(text.into()));
    }
    entries
}

/// The text of a design in examples/.
pub(crate) fn example(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples").join(name);
    fs::read_to_string(path).expect("an example")
}

/// The controller of a design file's text.
pub(crate) fn spec(text: &str) -> Spec {
    design(text).0
}

/// The controller and the plant of a design file's text.
pub(crate) fn design(text: &str) -> (Spec, Plant) {
    let entries = entries(text);
    let spec = request::read(&entries).unwrap_or_else(|found| panic!("{text}: {found:?}"));
    let plant = plant::read(&entries, &spec).expect("a plant").unwrap_or_default();
    (spec, plant)
}

/// An empty folder of a test's own, in one of the file that calls.
#[track_caller]
pub(crate) fn folder(test: &str) -> PathBuf {
    let file = Path::new(Location::caller().file()).with_extension("");
    let under = file.components().skip_while(|part| part.as_os_str() != "tests").skip(1);
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(under.collect::<PathBuf>()).join(test);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).expect("a folder for the test");
    path
}

/// An empty folder of a test's own that holds a file.
#[track_caller]
pub(crate) fn folder_with(test: &str, file: &str, text: impl AsRef<[u8]>) -> PathBuf {
    let folder = folder(test);
    fs::write(folder.join(file), text).expect("a file");
    folder
}

/// The command, with nothing to read.
#[cfg(feature = "cli")]
pub(crate) fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ptc-codegen"));
    command.args(arguments).stdin(Stdio::null());
    command
}

/// The command in a folder.
#[cfg(feature = "cli")]
pub(crate) fn command_in(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = command(arguments);
    command.current_dir(folder);
    command
}

/// The exit code, standard output and standard error of a run in a folder.
#[cfg(feature = "cli")]
pub(crate) fn run_in(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    told(&mut command_in(folder, arguments))
}

/// The exit code, standard output and standard error of a run.
pub(crate) fn told(command: &mut Command) -> (Option<i32>, String, String) {
    let Output { status, stdout, stderr } = command.output().expect("the binary runs");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (status.code(), text(stdout), text(stderr))
}

/// A standard error without the notes that name the design and what was open in it.
pub(crate) fn without_design(stderr: &str) -> String {
    let of_design = |line: &&str| {
        let note = line.strip_prefix("note: ").unwrap_or_default();
        ["design ", "chosen: ", "follows: "].iter().any(|word| note.starts_with(word))
    };
    stderr.lines().filter(|line| !of_design(line)).map(|line| format!("{line}\n")).collect()
}

/// The standard output of a run that succeeds without a warning.
pub(crate) fn stdout(command: &mut Command) -> String {
    let (code, stdout, stderr) = told(command);
    assert_eq!((code, without_design(&stderr).as_str()), (Some(0), ""), "{command:?}");
    stdout
}

/// The standard error of a run that fails with `code` and prints nothing else.
pub(crate) fn stderr(command: &mut Command, code: i32) -> String {
    let (found, stdout, stderr) = told(command);
    assert_eq!((found, stdout.as_str()), (Some(code), ""), "{command:?}: {stderr}");
    assert!(!stderr.contains("panicked"), "{command:?}: {stderr}");
    assert!(!stderr.contains('\u{1b}'), "colour off a terminal: {stderr}");
    stderr
}

/// `emit` refuses a design with one error, at a line of it (0 where it has none), that holds these texts.
pub(crate) fn refused_at(test: &str, text: &str, line: usize, told: [&str; 2]) {
    let folder = folder_with(test, "design.toml", text);
    let (code, stdout, stderr) = run_in(&folder, &["emit", "--lang", "c", "design.toml"]);
    assert_eq!((code, stdout.as_str()), (Some(2), ""), "{text}{stderr}");
    assert!(told.iter().all(|part| stderr.contains(part)), "{told:?}: {stderr}");
    let place = format!("design.toml:{line}:");
    assert!(line == 0 || stderr.contains(&place), "{text}, {place} {stderr}");
    assert_eq!(stderr.matches("error[").count(), 1, "{stderr}");
}

/// Height and Euler angles of a rigid body by thrust and moments: more outputs than have a closed form.
pub(crate) const QUADROTOR: &str = "name = \"quadrotor\"
mu = \"exp(a=1)\"
poles = [-4, -5]

[params]
tau = 2
eps = 0.02
u_max = inf
m = 1.2
jx = 0.02
jy = 0.025
jz = 0.04
grav = 9.81

[model]
states = [\"z\", \"vz\", \"roll\", \"pitch\", \"yaw\", \"p\", \"q\", \"r\"]
inputs = [\"T\", \"L\", \"M\", \"N\"]
outputs = [\"z\", \"roll\", \"pitch\", \"yaw\"]
dynamics = [
  \"vz\", \"(T + m*grav)*cos(roll)*cos(pitch)/m - grav\",
  \"p + sin(roll)*tan(pitch)*q + cos(roll)*tan(pitch)*r\",
  \"cos(roll)*q - sin(roll)*r\",
  \"(sin(roll)*q + cos(roll)*r)/cos(pitch)\",
  \"((jy - jz)*q*r + L)/jx\", \"((jz - jx)*p*r + M)/jy\", \"((jx - jy)*p*q + N)/jz\",
]
";

/// A point mass in the plane whose speed steers it: where it stands still its inputs do not decouple x and y.
pub(crate) const UNICYCLE: &str = "name = \"unicycle\"
mu = \"exp(a=1)\"
poles = [-4, -5]
allow = \"zeros\"
[params]
tau = 1
eps = 1e-2
u_max = inf
[model]
states = [\"x\", \"y\", \"s\", \"c\"]
inputs = [\"a\", \"w\"]
outputs = [\"x\", \"y\"]
dynamics = { x = \"s*cos(c)\", y = \"s*sin(c)\", s = \"a\", c = \"w\" }
";
