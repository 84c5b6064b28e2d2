//! Campaigns by the compiled controller: the rows of the interpreter, and a clear end where a tool fails.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Stdio;
use std::time::{Duration, Instant};

use crate::support::{command_in, folder_with, run_in, told};
use crate::verify_code_lanes::{OBSERVER, chain, objectives};

const COMPILED: [&str; 2] = ["--runner", "compiled"];
const INTERPRETED: [&str; 2] = ["--runner", "interpreted"];

/// The design with a force that is not known, which most tests run.
fn design() -> String {
    chain(
        &format!("{OBSERVER}sensor_step = [1e-4, 0]\ndelay = 1\n"),
        "eps = 0.05\nu_max = 4\n",
        "f = \"gust\"\n",
        "",
    )
}

/// A run in a folder: its end, and what it prints.
fn verify(folder: &Path, arguments: &[&[&str]]) -> (Option<i32>, String, String) {
    run_in(folder, &[&["verify", "design.toml"], arguments.concat().as_slice()].concat())
}

fn rows(folder: &Path, name: &str) -> Vec<u8> {
    fs::read(folder.join(name)).expect("rows")
}

/// Asserts that a design has the same rows and verdicts both ways.
fn same_rows(test: &str, text: &str) {
    let folder = folder_with(test, "design.toml", text);
    let more = ["--scenarios", "150"];
    let (end, verdict, wrong) = verify(&folder, &[&more, &COMPILED, &["--out", "one.parquet"]]);
    assert!(wrong.starts_with("note: runner: compiled, "), "{wrong}\n{text}");
    assert!(wrong.contains("64 scenarios interpreted too, with the same bits"), "{wrong}\n{text}");
    let other = verify(&folder, &[&more, &INTERPRETED, &["--out", "other.parquet"]]);
    assert_eq!((end, verdict, String::new()), other, "{text}");
    assert!(rows(&folder, "one.parquet") == rows(&folder, "other.parquet"), "{text}");
}

#[test]
fn chains_in_samples_have_the_same_rows_compiled() {
    let keys = [
        "sensor_step = [1e-4, 0]\ndelay = 1\n",
        "noise = [1e-3, 1e-2]\nu_step = 1e-2\ng_error = [0.9, 1.1]\n",
        "delay = \"1/2\"\nnoise_rms = [1e-4, 1e-3]\n",
        "delay = \"5/2\"\nafter = \"zero\"\nprecision = \"f32\"\n",
        "innovation_max = 0.02\ncoast = 3\nnoise = [3e-2, 0]\n",
    ];
    let plants = [
        "f = \"gust\"\n",
        // Sines of time, beside those of the disturbance.
        "f = \"gust - damping*x2 - 0.3*sin(4*t)\"\ndamping = [0, 0.5]\n",
    ];
    for keys in keys {
        for plant in plants {
            let text = chain(
                &format!("{OBSERVER}{keys}"),
                "eps = 0.05\nu_max = 4\n",
                plant,
                "until = -0.3\n",
            );
            same_rows("runner_chain", &text);
        }
    }
}

#[test]
fn references_matrices_and_axes_have_the_same_rows_compiled() {
    same_rows(
        "runner_reference",
        &chain("reference = \"0.1*sin(3*t)\"\ndelay = 1\n", "eps = 0.05\n", "f = \"gust\"\n", ""),
    );
    for delay in ["", "delay = 2\n", "delay = \"1/2\"\n"] {
        let text = format!(
            "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.01\npoles = [-4, -5]\n\
             observer_poles = [-4, -5]\nsensor_step = 1e-4\n{delay}[params]\ntau = 0.5\neps = 0.05\nu_max = 20\n\
             [plant]\nA = [[0, 1], [-2, -0.5]]\nB = [0, 2]\nC = [[1, 0]]\n{}",
            objectives(&["x1", "x2"], "")
        );
        same_rows("runner_matrices", &text);
    }
    let states = ["x1_1", "x2_1", "x1_2", "x2_2"];
    for keys in [
        "clock = \"samples\"\nlimits = [3, 2]\nnoise = 1e-3\n",
        "limits = [3, 2]\nsensor_step = 1e-3\n",
        "precision = \"f32\"\n",
    ] {
        let text = format!(
            "n = 2\naxes = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nsample_time = 0.01\n{keys}[params]\ntau = 0.5\n\
             eps = 0.06\n{}",
            objectives(&states, "")
        );
        same_rows("runner_axes", &text);
    }
}

/// Clocks in time, whose length does not consist of whole samples and whose parameters are drawn.
#[test]
fn clocks_in_time_have_the_same_rows_compiled() {
    for keys in ["", "precision = \"f32\"\n", "delay = 1\n"] {
        let text = format!(
            "n = 2\nmu = \"rational(a=1)\"\nsample_time = 0.01\npoles = [-4, -5]\n{keys}[params]\neps = 0.06\n\
             [plant]\nf = \"gust\"\ngust = [-0.1, 0.3]\n[disturbance]\ngust = \"any\"\n{}",
            objectives(&["x1", "x2"], "tau = [0.4, 0.7]\nt0 = [0, 5]\n")
        );
        same_rows("runner_time", &text);
    }
}

#[test]
fn parts_and_resumed_runs_of_both_ways_are_one_run() {
    let folder = folder_with("runner_parts", "design.toml", design());
    let more = ["--scenarios", "3000"];
    let whole = verify(&folder, &[&more, &INTERPRETED, &["--out", "whole.parquet"]]);
    let parts: [&[&str]; 3] = [&COMPILED, &INTERPRETED, &COMPILED];
    let mut merge = vec!["--merge"];
    let names = ["1.parquet", "2.parquet", "3.parquet"];
    for ((runner, name), part) in parts.iter().zip(names).zip(["1/3", "2/3", "3/3"]) {
        let (end, _, wrong) = verify(&folder, &[&more, runner, &["--shard", part, "--out", name]]);
        assert_eq!(end, Some(0), "{wrong}");
        merge.push(name);
    }
    let merged = verify(&folder, &[&more, &merge, &["--out", "merged.parquet"]]);
    assert_eq!(merged, whole);
    assert!(rows(&folder, "merged.parquet") == rows(&folder, "whole.parquet"));
    // Begun by one way, and ended by the other.
    let asked = [&["verify", "design.toml"][..], &more, &["--out", "rest.parquet"]].concat();
    let mut child = command_in(&folder, &[&asked[..], &INTERPRETED].concat())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("runs");
    let kept = || fs::metadata(folder.join("rest.parquet.chunks")).map_or(0, |own| own.len());
    let began = Instant::now();
    while kept() < 5000 && began.elapsed() < Duration::from_secs(120) {
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().expect("killed");
    child.wait().expect("ended");
    let (end, verdict, wrong) = run_in(&folder, &[&asked[..], &COMPILED].concat());
    assert!(wrong.starts_with("note: runner: compiled, "), "{wrong}");
    assert_eq!((end, verdict), (whole.0, whole.1));
    assert!(rows(&folder, "rest.parquet") == rows(&folder, "whole.parquet"));
}

/// Writes a program in place of a C compiler.
fn tool(folder: &Path, text: &str) -> String {
    let path = folder.join("compiler");
    fs::write(&path, format!("#!/bin/sh\n{text}\n")).expect("a file");
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).expect("a mode");
    path.to_str().expect("a path").to_owned()
}

/// A run whose compiler is another program: its end and what it prints, and its rows, if it wrote any.
fn with_compiler(
    folder: &Path,
    compiler: &str,
    runner: &[&str],
    scenarios: &str,
) -> ((Option<i32>, String, String), Option<Vec<u8>>) {
    let own = ["verify", "design.toml", "--scenarios", scenarios, "--out", "own.parquet"];
    let out = folder.join("own.parquet");
    let _ = fs::remove_file(&out);
    let mut command = command_in(folder, &[&own[..], runner].concat());
    let temporary = folder.join("temporary");
    fs::create_dir_all(&temporary).expect("a folder");
    let run = told(command.env("CC", compiler).env("TMPDIR", &temporary));
    let left: Vec<_> = fs::read_dir(&temporary).expect("a folder").collect();
    assert!(left.is_empty(), "{left:?}");
    (run, fs::read(out).ok())
}

/// Enough for a compiler to be asked for.
const LONG: &str = "42000";

#[test]
fn compilers_that_are_missing_or_fail_leave_the_interpreter() {
    let folder = folder_with("runner_compilers", "design.toml", design());
    let (interpreted, whole) = with_compiler(&folder, "cc", &INTERPRETED, LONG);
    let failing = tool(&folder, "echo 'main.c:1: no' >&2\nexit 3");
    for (compiler, wanted) in [
        ("/nowhere/cc", "no C compiler: cannot run `/nowhere/cc`"),
        (failing.as_str(), "fails: exit status: 3"),
    ] {
        let ((end, verdict, wrong), rows) = with_compiler(&folder, compiler, &[], LONG);
        assert!(wrong.starts_with("note: runner: interpreted, as ") && wrong.contains(wanted));
        assert_eq!((end, &verdict), (interpreted.0, &interpreted.1));
        assert!(rows == whole);
        let ((end, _, wrong), rows) = with_compiler(&folder, compiler, &COMPILED, "100");
        assert_eq!((end, rows), (Some(2), None), "{wrong}");
        assert!(wrong.contains("--runner compiled: ") && wrong.contains(wanted), "{wrong}");
    }
}

/// A compiler of the program behind a script, which runs it where it says `run`; `here` is its folder.
fn behind(folder: &Path, script: &str) -> String {
    let script = format!("here=\"$(dirname \"$0\")\"\nrun() {{ exec \"$here/real\"; }}\n{script}");
    tool(
        folder,
        &format!(
            "cc \"$@\" || exit 1\nmv campaign real\ncat >campaign <<'END'\n#!/bin/sh\n{script}\nEND\n\
             chmod +x campaign"
        ),
    )
}

#[test]
fn processes_that_are_killed_lose_no_scenario() {
    let folder = folder_with("runner_killed", "design.toml", design());
    let (_, whole) = with_compiler(&folder, "cc", &INTERPRETED, "600");
    // The first process, and the third one in the midst of its work.
    let script = "n=$(ls \"$here\" | grep -c '^begun'); : >\"$here/begun$n\"\n\
                  case $n in 0) kill -9 $$ ;; 2) head -c 30000 | \"$here/real\"; kill -9 $$ ;; *) run ;; esac";
    let compiler = behind(&folder, script);
    let ((_, _, wrong), rows) = with_compiler(&folder, &compiler, &COMPILED, "600");
    assert!(wrong.starts_with("note: runner: compiled, ") && !wrong.contains("warning"), "{wrong}");
    assert!(rows == whole);
}

#[test]
fn programs_that_run_nothing_or_something_else_write_no_rows() {
    let folder = folder_with("runner_programs", "design.toml", design());
    let other = "head -c 16 >/dev/null; exit 0";
    let garbled = "printf 'this is no answer'; exit 0";
    for script in ["kill -11 $$", other, garbled] {
        let compiler = behind(&folder, script);
        let ((end, _, wrong), rows) = with_compiler(&folder, &compiler, &COMPILED, "600");
        assert_eq!((end, rows), (Some(2), None), "{script}: {wrong}");
        assert!(wrong.contains("the compiled program does not run: x0 = ["), "{script}: {wrong}");
    }
    // A controller that is not the emitted one.
    let wrong_gain = tool(&folder, "sed -i 's/[*]= gain/*= 1.0000001/' main.c\nexec cc \"$@\"");
    let ((end, _, wrong), rows) = with_compiler(&folder, &wrong_gain, &COMPILED, "600");
    assert_eq!((end, rows), (Some(70), None), "{wrong}");
    assert!(wrong.contains("compiled and interpreted runs differ by"), "{wrong}");
}

#[test]
fn loops_that_no_program_runs_say_why() {
    for (text, why) in [
        (
            design().replace("sensor_step", "jitter = 1e-3\nsensor_step"),
            "the times of its samples are drawn",
        ),
        (
            design().replace("\"gust\"\n", "\"gust - 0.2*sign(x2)\"\n"),
            "its plant is integrated between samples",
        ),
        (
            format!("{}[[event]]\nat = 0.2\nkick = 3\nfor = 0.1\n", design()),
            "events happen in its runs",
        ),
        (
            format!(
                "{}[[objective]]\nbound = \"within\"\nh = \"integral(u^2)\"\nhigh = 9\n",
                design()
            ),
            "an objective integrates over the run",
        ),
    ] {
        let folder = folder_with("runner_why", "design.toml", &text);
        let (end, _, wrong) = verify(&folder, &[&["--scenarios", "10"], &COMPILED]);
        assert_eq!(end, Some(2), "{wrong}\n{text}");
        assert!(wrong.contains(&format!("--runner compiled: {why}")), "{wrong}\n{text}");
    }
}
