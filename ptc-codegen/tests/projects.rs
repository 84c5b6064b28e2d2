//! Projects as they are written: their files, the same bytes twice, folders of others, refusals; the
//! library and the sketch compiled and run here. `cargo assure projects` runs the firmware.
#![cfg(all(unix, feature = "cli"))]

mod support;

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use support::folder;

fn emit(kind: &str, arguments: &[&str], out: Option<&Path>, from: &Path) -> Output {
    let mut command = support::command(&["emit", "--project", kind]);
    command.args(arguments).current_dir(from);
    if let Some(out) = out {
        command.arg("-o").arg(out);
    }
    command.output().expect("the binary runs")
}

/// Makes a project that nothing is complained of; what is told of it.
fn made(kind: &str, arguments: &[&str], out: &Path) -> String {
    let output = emit(kind, arguments, Some(out), Path::new("/"));
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && told.is_empty(), "{kind} {arguments:?}: {told}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

fn told(output: &Output, code: i32) -> String {
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(code), "{text}");
    text
}

/// The files of a folder by their paths in it, with their contents.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_owned()];
    while let Some(next) = open.pop() {
        for entry in fs::read_dir(&next).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                open.push(path);
                continue;
            }
            let name = path.strip_prefix(folder).expect("within").display().to_string();
            found.push((name, fs::read(&path).expect("readable")));
        }
    }
    found.sort();
    found
}

fn run(command: &mut Command) -> String {
    let output = command.output().expect("it runs");
    let told = String::from_utf8_lossy(&output.stderr);
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{command:?}: {printed}{told}");
    assert_eq!(told, "", "{command:?}");
    printed
}

const DESIGN: [&str; 3] = ["--n=2", "--mu=exp", "--name=stage"];

const KINDS: [(&str, &[&str]); 4] = [
    (
        "arduino",
        &[
            "README.md",
            "examples/run/config.h",
            "examples/run/run.ino",
            "library.properties",
            "src/stage.c",
            "src/stage.h",
        ],
    ),
    (
        "cmake",
        &[
            "CMakeLists.txt",
            "README.md",
            "cmake/stageConfig.cmake.in",
            "example/config.h",
            "example/main.c",
            "include/stage.h",
            "src/stage.c",
        ],
    ),
    (
        "cortex-m",
        &[
            "Makefile",
            "README.md",
            "linker.ld",
            "src/config.h",
            "src/main.c",
            "src/stage.c",
            "src/stage.h",
            "src/startup.c",
        ],
    ),
    (
        "rust-embedded",
        &[
            ".cargo/config.toml",
            "Cargo.toml",
            "README.md",
            "build.rs",
            "memory.x",
            "src/config.rs",
            "src/main.rs",
            "src/stage.rs",
        ],
    ),
];

#[test]
fn each_kind_has_its_files_and_the_same_bytes_twice() {
    let folder = folder("projects_files");
    for (kind, wanted) in KINDS {
        let [a, b] = ["a", "b"].map(|name| folder.join(kind).join(name));
        made(kind, &DESIGN, &a);
        made(kind, &DESIGN, &b);
        let names: Vec<_> = files(&a).into_iter().map(|(name, _)| name).collect();
        assert_eq!(names, wanted, "{kind}");
        assert_eq!(files(&a), files(&b), "{kind}");
        let beside: Vec<_> = fs::read_dir(folder.join(kind)).expect("a folder").collect();
        assert_eq!(beside.len(), 2, "nothing is left beside the project");
    }
}

/// The controller in a project is what `--lang` writes.
#[test]
fn the_controller_is_the_emitted_one() {
    let folder = folder("projects_controller");
    let emitted = |lang: &str, name: &str| {
        let mut command = support::command(&["emit", "--lang", lang, "-o"]);
        run(command.arg(&folder).args(DESIGN));
        fs::read(folder.join(name)).expect("written")
    };
    let (header, source) = (emitted("c", "stage.h"), emitted("c", "stage.c"));
    let module = emitted("rust", "stage.rs");
    for (kind, _) in KINDS {
        let home = folder.join(kind);
        made(kind, &DESIGN, &home);
        for (name, content) in files(&home) {
            match Path::new(&name).file_name().and_then(|name| name.to_str()) {
                Some("stage.h") => assert!(content == header, "{kind}: {name}"),
                Some("stage.c") => assert!(content == source, "{kind}: {name}"),
                Some("stage.rs") => assert!(content == module, "{kind}: {name}"),
                _ => {}
            }
        }
    }
}

#[test]
fn a_folder_is_made_as_a_whole_and_never_over_another() {
    let folder = folder("projects_folders");
    // Without a folder it is that of the name.
    let output = emit("cmake", &DESIGN, None, &folder);
    assert!(output.status.success());
    let home = folder.join("stage");
    let first = files(&home);
    assert!(made("cmake", &DESIGN, &home).lines().all(|line| line.starts_with("unchanged ")));
    // A build beside the files is nothing to complain of, a changed file is.
    fs::create_dir(home.join("build")).expect("writable");
    made("cmake", &DESIGN, &home);
    let mine = home.join("example/config.h");
    fs::write(&mine, "mine").expect("writable");
    let text = told(&emit("cmake", &DESIGN, Some(&home), &folder), 2);
    assert!(text.contains("is not empty") && text.contains("give a new folder"), "{text}");
    assert_eq!(fs::read(&mine).expect("there"), b"mine");
    assert_eq!(files(&home).len(), first.len());

    let other = folder.join("other");
    fs::create_dir(&other).expect("writable");
    made("cmake", &DESIGN, &other);
    assert_eq!(files(&other), first, "an empty folder is taken");
    let text = told(&emit("arduino", &DESIGN, Some(&other), &folder), 2);
    assert!(text.contains("is not empty"), "{text}");
    assert_eq!(files(&other), first);
    let file = folder.join("file");
    fs::write(&file, "").expect("writable");
    told(&emit("arduino", &DESIGN, Some(&file), &folder), 2);
    told(&emit("arduino", &DESIGN, Some(&file.join("below")), &folder), 2);
    told(&emit("arduino", &DESIGN, Some(Path::new("-")), &folder), 2);
    told(&emit("arduino", &DESIGN, Some(Path::new(".")), &folder), 2);
    let left: Vec<_> =
        files(&folder).into_iter().filter(|(name, _)| name.contains("tmp")).collect();
    assert_eq!(left, []);
}

#[test]
fn check_tells_drift_and_writes_nothing() {
    let folder = folder("projects_check");
    let home = folder.join("stage");
    let check = [&DESIGN[..], &["--check"]].concat();
    assert!(told(&emit("cmake", &check, Some(&home), &folder), 1).contains("is missing"));
    assert!(!home.exists());
    made("cmake", &DESIGN, &home);
    assert_eq!(told(&emit("cmake", &check, Some(&home), &folder), 0), "");
    fs::write(home.join("src/stage.c"), "").expect("writable");
    let text = told(&emit("cmake", &check, Some(&home), &folder), 1);
    assert!(text.contains("src/stage.c differs"), "{text}");
}

#[test]
fn what_a_project_cannot_do_is_refused() {
    let folder = folder("projects_refused");
    for (flags, parts) in [
        (&["--n=2", "--mu=exp", "--pi0=extern"][..], &["pi0", "function of yours"][..]),
        (&["--n=2", "--mu=exp", "--after=extern"], &["after the deadline"]),
        (&["--n=2", "--mu=exp", "--what=associated"], &["infinite-time system"]),
        (&["--n=2", "--mu=exp", "--g=1+x1^2"], &["with a number for g"]),
        (&["--n=2", "--mu=exp", "--name=plant"], &["`plant`", "choose another name"]),
        (&["--n=2", "--mu=exp", "--lang=c"], &["--lang", "cannot be used with"]),
        (&["--n=2", "--mu=expp"], &["did you mean `exp`"]),
    ] {
        for (kind, _) in KINDS {
            let text = told(&emit(kind, flags, Some(&folder.join("new")), &folder), 2);
            for part in parts {
                assert!(text.contains(part), "{kind} {flags:?} lacks {part}: {text}");
            }
        }
    }
    assert!(told(&emit("avr", &DESIGN, None, &folder), 2).contains("arduino"));
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 0, "nothing is left behind");
}

/// Designs with fixed values, bounds, a latched state, an input gain and what comes after; in samples
/// with all open, delay, observer, force, bound of u, and other plants.
const DESIGNS: [&[&str]; 12] = [
    &["--n=1", "--mu=exp"],
    &["--n=3", "--mu=tan", "--precision=f32"],
    &["--n=2", "--mu=exp_sum(3)", "--t0=5", "--after=zero"],
    &["--n=2", "--mu=exp(a=1)", "--gains=12,7", "--tau=0.8", "--eps=0.01", "--u-max=40", "--t0=-1"],
    &["--n=2", "--mu=power(m=2)", "--g=0-1/4", "--sample-time=1e-3"],
    &["--n=2", "--kappa=-ln(1-dt/tau)/b", "--param", "b=[0.5,2]"],
    &["--n=2", "--mu=exp(a=1)", "--pi0=-(12+0*xi1_0)*xi1-7*xi2"],
    &["--n=3", "--mu=exp", "--clock=samples"],
    &["--n=1", "--mu=exp", "--clock=samples", "--precision=f32", "--after=zero", "--f=2", "--g=-3"],
    &[
        "--n=2",
        "--mu=exp(a=1)",
        "--clock=samples",
        "--sample-time=1e-3",
        "--tau=0.8",
        "--delay=2",
        "--poles=-4,-5,-6,-7",
        "--measured=x1",
        "--observer-poles=-4,-5,-6",
        "--disturbance=constant",
        "--u-max=6",
    ],
    &[
        "--A=[[-2,1],[0,-30]]",
        "--B=[0,30]",
        "--mu=exp(a=1)",
        "--clock=samples",
        "--sample-time=2e-3",
        "--tau=0.5",
        "--poles=-4,-5",
    ],
    &[
        "--A=[[0,1,0],[0,-2,5],[0,-1,-40]]",
        "--B=[0,0,40]",
        "--C=[[1,0,0],[0,0,1]]",
        "--mu=exp(a=1)",
        "--clock=samples",
        "--sample-time=1e-3",
        "--tau=0.4",
        "--delay=1",
        "--poles=-5,-6,-7,-8",
        "--observer-poles=-4,-5,-6",
        "--u-max=2",
    ],
];

const STRICT: [&str; 7] =
    ["-O2", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror", "-ffp-contract=off"];

/// Names of CMake's own targets, of the library that is linked, of files and of crates.
#[test]
fn names_of_the_tools_are_refused() {
    let home = folder("projects_names");
    for kind in ["cmake", "cortex-m", "rust-embedded", "arduino"] {
        for name in ["test", "all", "install", "clean", "help", "ZERO_CHECK", "m", "startup"] {
            let arguments = [DESIGNS[3], &["--name", name]].concat();
            let output = emit(kind, &arguments, Some(Path::new("out")), &home);
            assert!(told(&output, 2).contains("error[reserved-name]"), "{kind} {name}");
            assert!(!home.join("out").exists());
        }
    }
}

/// The example of the CMake library, which is the firmware's main too.
#[test]
fn the_example_arrives() {
    let folder = folder("projects_example");
    for (index, design) in DESIGNS.iter().enumerate() {
        let home = folder.join(index.to_string());
        made("cmake", &[design, &["--name=stage"][..]].concat(), &home);
        let program = home.join("program");
        let mut compiler = Command::new("cc");
        compiler.arg("-std=c99").args(STRICT).current_dir(&home);
        run(compiler
            .args(["-Iinclude", "-Iexample", "example/main.c", "src/stage.c", "-lm", "-o"])
            .arg(&program));
        let printed = run(&mut Command::new(&program));
        let last = printed.lines().last().expect("a last line");
        assert!(last.starts_with("arrived: |x| = "), "{design:?}: {printed}");
        let clips = printed.contains("saturated") && design.contains(&"--clock=samples");
        assert!(!clips, "{design:?}: {printed}");
        assert!(printed.lines().count() > 20, "{design:?}: {printed}");
    }
}

/// What the page shows of a run; the firmware prints the same (`cargo assure projects`).
#[test]
fn the_page_shows_what_the_default_design_prints() {
    let home = folder("projects_page").join("stage");
    made("cmake", &DESIGN, &home);
    let mut compiler = Command::new("cc");
    compiler.arg("-std=c99").args(STRICT).current_dir(&home);
    run(compiler.args([
        "-Iinclude",
        "-Iexample",
        "example/main.c",
        "src/stage.c",
        "-lm",
        "-o",
        "run",
    ]));
    let printed = run(&mut Command::new(home.join("run")));
    let page = include_str!("../../docs/targets.md");
    let (_, rest) = page.split_once("```text\n").expect("a block");
    let (shown, _) = rest.split_once("```").expect("its end");
    assert!(printed.ends_with(shown), "{printed}");
}

/// There is no Arduino compiler to be had here: the sketch is compiled by g++ against a header in
/// place of Arduino's, with its loop called until it stops.
#[test]
fn the_sketch_arrives_with_a_stub_of_arduino() {
    let folder = folder("projects_sketch");
    for (index, design) in DESIGNS.iter().enumerate() {
        let home = folder.join(index.to_string());
        made("arduino", &[design, &["--name=stage"][..]].concat(), &home);
        let properties = fs::read_to_string(home.join("library.properties")).expect("there");
        for key in
            ["name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url"]
        {
            let line = properties.lines().find_map(|l| l.strip_prefix(&format!("{key}=")));
            assert!(line.is_some_and(|value| !value.is_empty()), "{key}: {properties}");
        }
        fs::write(home.join("Arduino.h"), ARDUINO).expect("writable");
        let sketch = home.join("examples/run");
        run(Command::new("cc")
            .arg("-std=c99")
            .args(STRICT)
            .args(["-c", "-o", "stage.o", "src/stage.c"])
            .current_dir(&home));
        let program = home.join("program");
        run(Command::new("g++")
            .args(["-std=gnu++11", "-O2", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off"])
            .args(["-I../..", "-I../../src", "-include", "Arduino.h", "-x", "c++", "run.ino"])
            .args(["-x", "none", "../../stage.o", "-o"])
            .arg(&program)
            .current_dir(&sketch));
        let printed = run(&mut Command::new(&program));
        assert!(printed.contains("arrived: |x| = "), "{design:?}: {printed}");
    }
}

/// What the sketch uses of Arduino's core. `delay` ends the program: the sketch has stopped.
const ARDUINO: &str = r#"
#include <cstdio>
#include <cstdlib>

struct Stream {
    void begin(long) {}
    void print(const char *text) { std::printf("%s", text); }
    void print(int number) { std::printf("%d", number); }
    void print(unsigned number) { std::printf("%u", number); }
    void print(double number, int digits) { std::printf("%.*f", digits, number); }
    void println(const char *text) { std::printf("%s\n", text); }
    void println(int number) { std::printf("%d\n", number); }
    void println(double number, int digits) { std::printf("%.*f\n", digits, number); }
};

static Stream Serial;
static inline void delay(unsigned long) { std::exit(0); }
static unsigned long now;
static inline unsigned long micros() { return now += 100; }
void setup();
void loop();

int main()
{
    setup();
    for (;;) {
        loop();
    }
}
"#;

#[test]
fn the_plant_is_told_for_every_order() {
    let folder = folder("told_plant");
    for (n, g, plant) in [
        ("1", None, "with its plant, x1' = u, up to"),
        ("2", None, "with its plant, x1' = x2, x2' = u, up to"),
        ("3", Some("2"), "with its plant, x1' = x2, ..., x3' = g u, g = 2, up to"),
    ] {
        let out = folder.join(n);
        let gain = g.map(|g| ["--g", g]);
        let own = ["--n", n, "--mu", "exp", "--name", "stage"];
        made("cmake", &[&own[..], gain.as_ref().map_or(&[], |g| &g[..])].concat(), &out);
        let main = fs::read_to_string(out.join("example/main.c")).expect("a program");
        assert!(main.contains(plant), "{main}");
    }
}
