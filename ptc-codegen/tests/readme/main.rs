//! The commands and C of the README and of docs/: run, compiled, and compared
//! with the output beside them. Their Rust is a doctest of the crate `ptc`.

#![cfg(all(unix, feature = "lab"))]

mod benchmarks;
mod links;
mod sessions;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use sessions::printed;

const README: &str = include_str!("../../../README.md");

const START: &str = include_str!("../../../docs/start.md");

const FAMILIES: &str = include_str!("../../../docs/families.md");

const LIMITS: &str = include_str!("../../../docs/limits.md");

/// The pages of the book, in their order.
const SUMMARY: &str = include_str!("../../../docs/SUMMARY.md");

const EXPRESSIONS: &str = include_str!("../../../docs/expressions.md");

const SIMULATE: &str = include_str!("../../../docs/simulate.md");

const VERIFY: &str = include_str!("../../../docs/verify.md");

const DESIGN: &str = include_str!("../../../docs/design.md");

const TIME: &str = include_str!("../../../docs/time.md");

const SAMPLES: &str = include_str!("../../../docs/samples.md");

/// The design of the README, which docs/start.md and docs/samples.md use too.
const ENCODER: &str = include_str!("../../../examples/encoder.toml");

/// The designs of several axes of the guide.
const GANTRY: &str = include_str!("../../../examples/gantry.toml");

const QUADROTOR: &str = include_str!("../../../examples/quadrotor.toml");

/// The design of a linear plant, which docs/samples.md shows.
const MOTOR: &str = include_str!("../../../examples/motor.toml");

/// The design with a model that docs/guide/model.md shows, and the one that docs/models.md refuses.
const DRIVE: &str = include_str!("../../../examples/drive.toml");

const CART: &str = include_str!("../../../examples/cart.toml");

/// The plants with several inputs that docs/models.md shows.
const TANK: &str = include_str!("../../../examples/tank.toml");

const ROBOT: &str = include_str!("../../../examples/two_link.toml");

/// The robot with a law of both joints that docs/models.md runs.
const BARRIER: &str = include_str!("../../../examples/barrier_arm.toml");

/// The plant with uncertain numbers that docs/guide/uncertain.md verifies.
const PENDULUM: &str = include_str!("../../../examples/pendulum.toml");

/// The design that docs/guide/target.md shows.
const TRACK: &str = include_str!("../../../examples/track.toml");

const REFERENCES: &str = include_str!("../../../docs/references.md");

const MODELS: &str = include_str!("../../../docs/models.md");

/// The questions of users, the design of their answers, and the page with a program in C.
const GUIDE: &str = include_str!("../../../docs/guide/README.md");

const TABLE: &str = include_str!("../../../examples/table.toml");

/// A load that swings, the design of docs/guide/resonance.md.
const ELASTIC: &str = include_str!("../../../examples/elastic.toml");

const RESONANCE: &str = include_str!("../../../docs/guide/resonance.md");

/// A plant for the stage of docs/start.md.
const ROBUST: &str = include_str!("../../../docs/guide/robust.md");

/// Events of the same stage.
const FILTER: &str = include_str!("../../../docs/guide/filter.md");

/// The functions of a robot.
const ROBOTS: &str = include_str!("../../../docs/guide/robots.md");

const MOVES: &str = include_str!("../../../docs/guide/moves.md");

/// Several axes, and more on them.
const GUIDE_AXES: &str = include_str!("../../../docs/guide/axes.md");

const AXES: &str = include_str!("../../../docs/axes.md");

/// A timer interrupt, a model, a target that moves, and what is uncertain.
const GUIDE_SAMPLES: &str = include_str!("../../../docs/guide/samples.md");

const GUIDE_MODEL: &str = include_str!("../../../docs/guide/model.md");

const GUIDE_TARGET: &str = include_str!("../../../docs/guide/target.md");

const GUIDE_STATES: &str = include_str!("../../../docs/guide/states.md");

const GUIDE_QUADROTOR: &str = include_str!("../../../docs/guide/quadrotor.md");

const GUIDE_UNCERTAIN: &str = include_str!("../../../docs/guide/uncertain.md");

const GUIDE_VERIFY: &str = include_str!("../../../docs/guide/verify.md");

const SELFTEST: &str = include_str!("../../../docs/assurance/selftest.md");

/// Returns the pages of the book, each with its place in docs/ and its text.
fn pages() -> Vec<(String, String)> {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    let links = SUMMARY.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let page = |name: &str| {
        let text = fs::read_to_string(docs.join(name)).unwrap_or_else(|_| panic!("no docs/{name}"));
        (name.to_owned(), text)
    };
    links.map(page).collect()
}

/// The blocks of a page in `language`, without the indentation of the list around them.
fn blocks_of(page: &str, language: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut open: Option<(bool, usize, String)> = None;
    for line in page.lines() {
        let text = line.trim_start();
        match (&mut open, text.strip_prefix("```")) {
            (None, Some(name)) => {
                open = Some((name == language, line.len() - text.len(), String::new()));
            }
            (Some((wanted, _, block)), Some(_)) => {
                if *wanted {
                    found.push(std::mem::take(block));
                }
                open = None;
            }
            (Some((_, indent, block)), None) => {
                block.push_str(line.get(*indent..).unwrap_or_default());
                block.push('\n');
            }
            (None, None) => {}
        }
    }
    found
}

/// Runs a command of a page in `folder`, with the binary in place of `cargo run`.
fn shell(command: &str, folder: &Path) -> String {
    let binary = format!("'{}'", env!("CARGO_BIN_EXE_ptc-codegen"));
    let command = command.replace("cargo run --release -p ptc-codegen --features lab --", &binary);
    let command = command.replace("cargo run -p ptc-codegen --", &binary);
    let output = Command::new("sh").args(["-c", &command]).current_dir(folder).output();
    let output = output.expect("a shell");
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command}\n{told}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// The commands of a page that start with `start`.
fn commands(page: &str, start: &str) -> Vec<String> {
    let blocks = blocks_of(page, "sh");
    let lines = blocks.iter().flat_map(|block| block.lines());
    lines.filter(|line| line.starts_with(start)).map(ToOwned::to_owned).collect()
}

/// Returns the commands of a page that run the generator, with or without optimisation.
fn runs(page: &str) -> Vec<String> {
    let all = commands(page, "cargo run ");
    let found: Vec<_> = all.into_iter().filter(|line| line.contains(" -p ptc-codegen ")).collect();
    assert!(!found.is_empty(), "a page that runs nothing");
    found
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("removable");
    }
    fs::create_dir_all(&folder).expect("writable");
    folder
}

/// Runs the commands of a page in `folder`, and its program, which prints what the page shows.
fn walk(page: &str, folder: &Path) {
    for command in runs(page) {
        shell(&command, folder);
    }
    let [main] = &blocks_of(page, "c")[..] else { panic!("one program in C") };
    fs::write(folder.join("main.c"), main).expect("writable");
    let [compile] = &commands(page, "cc ")[..] else { panic!("one compilation") };
    let strict = "cc -Wall -Wextra -Wpedantic -Wconversion -Werror ";
    let found = shell(&compile.replacen("cc ", strict, 1), folder);
    let [expected] = &blocks_of(page, "text")[..] else { panic!("one output") };
    assert_eq!(&found, expected);
}

/// Makes a folder with the designs of the README and of docs/start.md.
fn folder_with_examples(name: &str) -> PathBuf {
    let folder = folder(name);
    fs::create_dir(folder.join("examples")).expect("writable");
    fs::write(folder.join("examples/encoder.toml"), ENCODER).expect("writable");
    fs::write(folder.join("examples/pendulum.toml"), PENDULUM).expect("writable");
    folder
}

#[test]
fn tutorial_runs_from_plant_to_firmware() {
    let folder = folder_with_examples("tutorial");
    assert!(blocks_of(START, "toml").is_empty(), "the README shows the design");
    walk(START, &folder);
    for file in ["out/stage.h", "out/stage.c"] {
        assert!(folder.join(file).is_file(), "{file}");
    }
}

#[test]
fn readme_shows_the_stage() {
    let folder = folder_with_examples("readme");
    assert_eq!(blocks_of(README, "toml"), [ENCODER]);
    let printed: String = runs(README).iter().map(|command| shell(command, &folder)).collect();
    for file in ["out/ptc_exp3.h", "out/ptc_exp3.c", "out/x.svg"] {
        assert!(folder.join(file).is_file(), "{file}");
    }
    let [shown] = &blocks_of(README, "text")[..] else { panic!("one output") };
    assert!(shown.lines().all(|line| printed.lines().any(|own| own == line)), "{shown}");
    let drawn = fs::read_to_string(folder.join("out/x.svg")).expect("a picture");
    let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/stage.svg");
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&kept, &drawn).expect("writable");
    }
    assert!(drawn == fs::read_to_string(kept).expect("a picture"), "docs/stage.svg");
}

#[test]
fn continuous_time_page_runs() {
    walk(TIME, &folder("time"));
}

/// The timer interrupts need a board: they are compiled, and not run.
#[test]
fn timer_interrupt_programs_compile() {
    let folder = folder("samples");
    fs::write(folder.join("encoder.toml"), ENCODER).expect("writable");
    let emit = "ptc-codegen emit encoder.toml --disturbance constant --lang c -o out";
    printed(emit, &folder);
    printed(&format!("{emit} --what observer"), &folder);
    let [control, observer] = [GUIDE_SAMPLES, SAMPLES].map(|page| blocks_of(page, "c"));
    assert_eq!([control.len(), observer.len()], [1, 1]);
    for program in control.iter().chain(&observer) {
        fs::write(folder.join("board.c"), program).expect("writable");
        let strict = "cc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror -Iout -c board.c";
        shell(strict, &folder);
    }
}

/// The column of eps in the table of families, from the command below the table.
#[test]
fn families_table_shows_the_eps_set_by_check() {
    let folder = folder("families");
    let line = FAMILIES.lines().find_map(|line| {
        let command = line.split('`').find(|part| part.starts_with("ptc-codegen check "))?;
        line.starts_with("The eps is for n = 2").then(|| command.to_owned())
    });
    let line = line.expect("the command of the table");
    for family in &ptc_codegen::family::FAMILIES {
        let row = FAMILIES.lines().find(|line| line.starts_with(&format!("| `{}` |", family.name)));
        let cells: Vec<_> = row.expect("a row").split('|').map(str::trim).collect();
        let arguments = match family.name {
            "power" => "a=1,m=2",
            "exp_sum" => "rates=[0.5,1.5]",
            "soft" => "a=1,start=0.5",
            _ => "a=1",
        };
        let found =
            printed(&line.replace("exp(a=1)", &format!("{}({arguments})", family.name)), &folder);
        let set = format!("sampling    sound: eps = {} s ", cells[5]);
        assert!(found.contains(&set), "{}: {}\n{found}", family.name, cells[5]);
    }
}

#[test]
fn c_programs_of_the_expressions_page_run() {
    let folder = folder("extern");
    for command in blocks_of(EXPRESSIONS, "sh") {
        printed(command.trim_end(), &folder);
    }
    let programs = blocks_of(EXPRESSIONS, "c");
    let sources = ["stage.c", "stage_associated.c"];
    assert_eq!(programs.len(), sources.len());
    for (program, source) in programs.iter().zip(sources) {
        fs::write(folder.join("main.c"), program).expect("writable");
        let strict =
            "cc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror -ffp-contract=off -Iout";
        shell(&format!("{strict} -o demo main.c out/{source} -lm && ./demo"), &folder);
    }
}

#[test]
fn selftest_page_program_runs() {
    let folder = folder("selftest");
    for command in blocks_of(SELFTEST, "sh") {
        printed(command.trim_end(), &folder);
    }
    let [program] = &blocks_of(SELFTEST, "c")[..] else { panic!("one program") };
    fs::write(folder.join("main.c"), program).expect("writable");
    let strict =
        "cc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror -ffp-contract=off -Iout";
    let sources = "main.c out/stage.c out/stage_selftest.c";
    shell(&format!("{strict} -o demo {sources} -lm && ./demo"), &folder);
}

#[test]
fn law_with_a_state_runs_in_c() {
    let folder = folder("states");
    for command in blocks_of(GUIDE_STATES, "sh") {
        printed(command.trim_end(), &folder);
    }
    let [program] = &blocks_of(GUIDE_STATES, "c")[..] else { panic!("one program") };
    let [shown] = &blocks_of(GUIDE_STATES, "text")[..] else { panic!("one output") };
    fs::write(folder.join("main.c"), program).expect("writable");
    let strict = "cc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror -ffp-contract=off -Ilift main.c lift/lift.c -lm -o demo && ./demo";
    assert_eq!(&shell(strict, &folder), shown);
}

#[test]
fn summary_lists_each_page_once() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    // The paper is written for a journal.
    let folders = ["", "guide", "checks", "theory", "assurance", "benchmarks"];
    let found = folders.iter().flat_map(|folder| {
        let entries = fs::read_dir(docs.join(folder)).expect("a folder");
        entries.map(|entry| Path::new(folder).join(entry.expect("an entry").file_name()))
    });
    let is_page = |path: &PathBuf| {
        path.extension().is_some_and(|extension| extension == "md") && !path.ends_with("SUMMARY.md")
    };
    let mut found: Vec<_> = found.filter(is_page).collect();
    let mut listed: Vec<_> = pages().into_iter().map(|(name, _)| PathBuf::from(name)).collect();
    found.sort();
    listed.sort();
    assert_eq!(listed, found);
}

#[test]
fn links_and_reference_tables_are_complete() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for (name, page) in pages() {
        links::lead_somewhere(&root.join("docs").join(name), &page);
    }
    links::lead_somewhere(&root.join("README.md"), README);
    for (name, _) in ptc_codegen::expression::Function::ALL {
        let row = EXPRESSIONS.lines().find(|line| line.starts_with("| of one number"));
        assert!(row.is_some_and(|row| row.contains(name)), "{name}");
    }
    for family in &ptc_codegen::family::FAMILIES {
        let row = format!("\n| `{}` | ", family.name);
        assert!(FAMILIES.contains(&row), "{} has no row", family.name);
    }
    let orders = format!("1..={}", ptc_codegen::request::MAX_ORDER);
    assert!(LIMITS.contains(&orders), "{orders}");
}
