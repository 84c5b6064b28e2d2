//! Examples and sketches, compiled and run.

use std::fs;
use std::process::Command;

use super::support::folder;
use super::{DESIGN, made, run};

/// Designs with fixed values, bounds, a latched state, an input gain and what comes after; in samples
/// with all open, delay, observer, force, bound of u, and other plants; axes with either clock, alike and each with its
/// own gains, limits and g.
pub(super) const DESIGNS: [&[&str]; 18] = [
    &["--n=1", "--mu=exp"],
    &["--n=3", "--mu=tan", "--precision=f32"],
    &["--n=4", "--mu=exp_sum(rates=[0.5,1.5,3])", "--poles=-3.2,-6,-4,-2.5"],
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
    &["--n=2", "--mu=exp(a=1)", "--clock=samples", "--delay=1.25", "--poles=-4,-5,-6,-7"],
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
        "--delay=0.7",
        "--poles=-5,-6,-7,-8",
        "--observer-poles=-4,-5,-6",
        "--u-max=2",
    ],
    &["--n=1", "--axes=2", "--mu=exp", "--precision=f32"],
    &[
        "--n=2",
        "--axes=3",
        "--mu=exp(a=1)",
        "--poles=[[-4,-5],[-5,-6],[-6,-7]]",
        "--g=[1,-2,0.5]",
        "--sample-time=1e-3",
    ],
    &["--n=3", "--axes=2", "--mu=exp", "--clock=samples"],
    &[
        "--n=2",
        "--axes=2",
        "--mu=exp(a=1)",
        "--clock=samples",
        "--sample-time=1e-3",
        "--tau=0.8",
        "--poles=[[-4,-5],[-3,-6]]",
        "--limits=6,20",
        "--g=[0.5,2]",
    ],
];

const STRICT: [&str; 7] =
    ["-O2", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror", "-ffp-contract=off"];

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

/// A run of 1e9 samples is not tried, and the file of values says that the period is open. The page shows a run as the
/// firmware prints it (`cargo assure projects`).
#[test]
fn a_run_that_takes_long_is_not_tried() {
    let home = folder("projects_long");
    let poles = ["--poles=-3.2,-6,-4,-2.5", "--sample-time=1e-9"];
    made(
        "cmake",
        &[&["--n=4", "--mu=exp_sum(rates=[0.5,1.5,3])", "--name=stage"], &poles[..]].concat(),
        &home,
    );
    let config = fs::read_to_string(home.join("example/config.h")).expect("there");
    assert!(config.contains("Undecided: the run may end late"), "{config}");
}

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
    let page = include_str!("../../../../docs/targets.md");
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
        let sketch = fs::read_to_string(home.join("examples/run/run.ino")).expect("there");
        // An int has 16 bits on the smallest boards.
        assert!(!sketch.contains("int step"), "{sketch}");
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

/// The part of Arduino's core that the sketch uses. `delay` ends the program: the sketch has stopped.
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
