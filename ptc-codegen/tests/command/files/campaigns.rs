//! Rows of a campaign: interrupted, damaged, foreign, printed.

use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use super::support::{command_in, folder_with, run_in};
use super::{DESIGN, names, stage};

#[test]
fn an_interrupt_of_the_search_runs_no_scenario_again() {
    // Each objective has a search of its own.
    let objective = DESIGN.find("[[objective]]").map_or("", |at| &DESIGN[at..]);
    let design = format!("{DESIGN}{}", objective.repeat(60)).replace("search = 4", "search = 400");
    let folder = folder_with("files_searched", "stage.toml", design);
    let arguments = ["verify", "stage.toml", "--out", "rows.parquet"];
    let rows = || fs::read(folder.join("rows.parquet.chunks")).expect("the rows are kept");
    let mut kept: Option<Vec<u8>> = None;
    for _ in 0..2 {
        let mut child =
            command_in(&folder, &arguments).stdout(Stdio::null()).spawn().expect("runs");
        while !folder.join("rows.parquet").exists() {
            assert!(child.try_wait().expect("a state").is_none(), "it is still running");
            std::thread::sleep(Duration::from_millis(1));
        }
        child.kill().expect("killed");
        assert!(!child.wait().expect("ended").success(), "killed in its search");
        fs::remove_file(folder.join("rows.parquet")).expect("the rows were whole");
        // The first line names the process.
        let after: Vec<u8> = rows().splitn(2, |byte| *byte == b'\n').last().expect("rows").into();
        assert!(kept.is_none_or(|kept| kept == after));
        kept = Some(after);
    }
    assert_eq!(run_in(&folder, &arguments).0, Some(0));
    assert_eq!(names(&folder), ["rows.parquet", "stage.toml"]);
}

/// Starts a campaign and waits until several records of its rows are kept, 14 kB each: a last one may be half
/// there.
fn interrupted(folder: &Path, out: &str, signal: &str) {
    let arguments = ["verify", "stage.toml", "--scenarios=500000", "--out", out];
    let mut child = command_in(folder, &arguments).stdout(Stdio::null()).spawn().expect("runs");
    let journal = folder.join(format!("{out}.chunks"));
    let began = Instant::now();
    let size = || fs::metadata(&journal).map_or(0, |there| there.len());
    while size() < 100_000 && began.elapsed() < Duration::from_secs(120) {
        std::thread::sleep(Duration::from_millis(1));
    }
    let kill = Command::new("kill").args([signal, &child.id().to_string()]).status();
    assert!(kill.expect("runs").success());
    assert!(!child.wait().expect("ends").success());
    assert!(journal.exists() && !folder.join(out).exists());
}

#[test]
fn one_process_at_a_time_has_a_campaign() {
    let folder = stage("owned");
    let arguments = ["verify", "stage.toml", "--scenarios=20000", "--out", "rows.parquet"];
    let mut first = command_in(&folder, &arguments).stdout(Stdio::null()).spawn().expect("runs");
    let journal = folder.join("rows.parquet.chunks");
    while fs::metadata(&journal).map_or(0, |there| there.len()) < 1000 {
        assert!(first.try_wait().expect("a state").is_none(), "it is still running");
        std::thread::sleep(Duration::from_millis(1));
    }
    for more in [&["--seed=3"][..], &[]] {
        let (code, printed, wrong) = run_in(&folder, &[&arguments[..], more].concat());
        assert_eq!((code, printed.as_str()), (Some(2), ""));
        let owner = format!(
            "rows.parquet.chunks is in use by another run of verify, process {}",
            first.id()
        );
        assert!(wrong.contains(&owner), "{wrong}");
    }
    first.kill().expect("killed");
    first.wait().expect("ended");
    // Its lock has ended with it.
    let (code, _, wrong) = run_in(&folder, &[&arguments[..], &["--seed=3"]].concat());
    assert_eq!(code, Some(2));
    assert!(wrong.contains("another campaign") && wrong.contains("seed = 3"), "{wrong}");
}

#[test]
fn what_is_not_its_own_is_never_removed() {
    let folder = stage("foreign");
    let verify = ["verify", "stage.toml", "--out", "rows.parquet"];
    let journal = folder.join("rows.parquet.chunks");
    fs::create_dir(&journal).expect("a folder");
    fs::write(journal.join("mine"), "precious").expect("a file");
    let (code, _, wrong) = run_in(&folder, &verify);
    assert_eq!(code, Some(2));
    assert!(wrong.contains("rows.parquet.chunks is a folder"), "{wrong}");
    assert_eq!(fs::read_to_string(journal.join("mine")).expect("there"), "precious");
    fs::remove_dir_all(&journal).expect("removed");
    fs::write(&journal, "precious").expect("a file");
    let (code, _, wrong) = run_in(&folder, &verify);
    assert_eq!(code, Some(2));
    assert!(wrong.contains("rows.parquet.chunks is not a file of this program"), "{wrong}");
    assert_eq!(fs::read_to_string(&journal).expect("there"), "precious");
    assert_eq!(names(&folder), ["rows.parquet.chunks", "stage.toml"]);
}

#[test]
fn a_signal_keeps_the_rows_and_leaves_nothing_else() {
    let folder = stage("signals");
    for signal in ["-TERM", "-INT", "-HUP", "-KILL"] {
        interrupted(&folder, "rows.parquet", signal);
        assert_eq!(names(&folder), ["rows.parquet.chunks", "stage.toml"], "{signal}");
        fs::remove_file(folder.join("rows.parquet.chunks")).expect("removed");
    }
}

#[test]
fn damage_is_reported_by_name() {
    let folder = stage("damage");
    interrupted(&folder, "rows.parquet", "-KILL");
    let journal = folder.join("rows.parquet.chunks");
    let whole = fs::read(&journal).expect("rows");
    let resume = ["verify", "stage.toml", "--scenarios=500000", "--out", "rows.parquet"];
    let small = ["verify", "stage.toml", "--out", "part.parquet"];
    assert_eq!(run_in(&folder, &small).0, Some(0));
    let part = fs::read(folder.join("part.parquet")).expect("rows");
    let merge = ["verify", "stage.toml", "--merge", "part.parquet"];
    assert_eq!(run_in(&folder, &merge).0, Some(0));
    let header = header(&whole);
    // A few bits of each; `cargo assure attack` goes through more.
    for (file, bytes, end, arguments) in [
        ("rows.parquet.chunks", whole, header, &resume[..]),
        ("part.parquet", part.clone(), part.len(), &merge),
    ] {
        for place in 0..12 {
            let mut damaged = bytes.clone();
            let byte = place * end / 12;
            damaged[byte] ^= 1 << (place % 8);
            fs::write(folder.join(file), &damaged).expect("written");
            let (code, printed, wrong) = run_in(&folder, arguments);
            assert_eq!((code, printed.as_str()), (Some(2), ""), "byte {byte} of {file}: {wrong}");
            assert!(wrong.contains(file), "byte {byte} of {file}: {wrong}");
            assert!(fs::read(folder.join(file)).expect("there") == damaged, "it is left as it is");
        }
    }
}

/// Bytes before the first record of a journal: the owner, and a header that says how long its campaign is.
fn header(journal: &[u8]) -> usize {
    let mut lines = journal.split_inclusive(|byte| *byte == b'\n');
    let first: Vec<_> = lines.by_ref().take(4).collect();
    let design = String::from_utf8_lossy(first[3]);
    let bytes = design.trim().strip_suffix(" bytes").and_then(|line| line.rsplit(' ').next());
    let campaign: usize = bytes.and_then(|bytes| bytes.parse().ok()).expect("a length");
    first.concat().len() + campaign + "\n".len() + 64 + "\n".len()
}

#[test]
fn rows_that_are_whole_outlive_a_power_cut() {
    let folder = stage("power_cut");
    let arguments = |out| ["verify", "stage.toml", "--scenarios=640", "--out", out];
    let (code, verdict, _) = run_in(&folder, &arguments("whole.parquet"));
    assert_eq!(code, Some(0));
    let rows = fs::read(folder.join("whole.parquet")).expect("rows");
    let journal = folder.join("rows.parquet.chunks");
    let mut child = command_in(&folder, &arguments("rows.parquet"))
        .stdout(Stdio::null())
        .spawn()
        .expect("runs");
    while fs::metadata(&journal).map_or(0, |there| there.len()) < 12_000 {
        assert!(child.try_wait().expect("a state").is_none(), "it is still running");
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().expect("killed");
    child.wait().expect("ended");
    let kept = fs::read(&journal).expect("rows");
    let first = header(&kept);
    let zeroed = |range: std::ops::Range<usize>| {
        let mut bytes = kept.clone();
        bytes.resize(range.end.max(bytes.len()), 0);
        bytes[range].fill(0);
        bytes
    };
    let mut flipped = kept.clone();
    flipped[first + 100] ^= 4;
    for (damage, bytes, warns) in [
        ("zeros behind the last record", zeroed(kept.len()..kept.len() + 4096), true),
        ("zeros between records that are whole", zeroed(first + 2000..first + 6096), true),
        ("no record at all", zeroed(first..kept.len()), true),
        ("a bit of the first record", flipped, true),
        ("half a record", kept[..kept.len() - 1000].to_vec(), false),
    ] {
        fs::write(&journal, bytes).expect("written");
        let (code, printed, told) = run_in(&folder, &arguments("rows.parquet"));
        assert_eq!((code, &printed), (Some(0), &verdict), "{damage}: {told}");
        assert!(fs::read(folder.join("rows.parquet")).expect("rows") == rows, "{damage}");
        assert_eq!(told.contains("rows.parquet.chunks, which keeps"), warns, "{damage}: {told}");
        assert_eq!(told.contains("of 640 scenarios are kept"), warns, "{damage}: {told}");
        assert_eq!(names(&folder), ["rows.parquet", "stage.toml", "whole.parquet"], "{damage}");
        fs::remove_file(folder.join("rows.parquet")).expect("removed");
    }
}

#[cfg(unix)]
#[test]
fn files_that_a_kill_left_are_removed_and_others_stay() {
    let folder = stage("left");
    let left = folder.join("out");
    fs::create_dir_all(left.join(".ptc-AbCdEf.tmp/inner")).expect("a folder");
    fs::write(left.join(".ptc-123456.tmp"), "half").expect("a file");
    // Names that this program does not give, and a file under way of a process that is at work.
    fs::write(left.join(".ptc-mine.tmp"), "mine").expect("a file");
    let held = fs::File::create(left.join(".ptc-abcdef.tmp")).expect("a file");
    held.lock().expect("a lock");
    let emit = ["emit", "stage.toml", "--lang=c", "-o", "out"];
    assert_eq!(run_in(&folder, &emit).0, Some(0));
    let there = names(&left);
    assert!(there.contains(&".ptc-mine.tmp".to_owned()), "{there:?}");
    assert!(there.contains(&".ptc-abcdef.tmp".to_owned()), "{there:?}");
    assert_eq!(there.len(), 4, "{there:?}");
    drop(held);
    fs::write(folder.join("stage.toml"), DESIGN.replace("-4", "-5")).expect("written");
    assert_eq!(run_in(&folder, &emit).0, Some(0));
    assert!(!names(&left).contains(&".ptc-abcdef.tmp".to_owned()));
}

#[test]
fn rows_can_be_printed() {
    let folder = stage("printed");
    let verify = ["verify", "stage.toml", "--out"];
    let (code, verdict, _) = run_in(&folder, &[&verify[..], &["rows.parquet"]].concat());
    assert_eq!(code, Some(0));
    let mut child = command_in(&folder, &[&verify[..], &["-"]].concat())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("runs");
    let mut rows = Vec::new();
    child.stdout.take().expect("a pipe").read_to_end(&mut rows).expect("read");
    let told: Vec<_> = BufReader::new(child.stderr.take().expect("a pipe"))
        .lines()
        .map_while(Result::ok)
        .collect();
    assert!(rows == fs::read(folder.join("rows.parquet")).expect("there"));
    assert_eq!(format!("{}\n", told.join("\n")), verdict);
    assert!(child.wait().expect("ends").success());
    assert_eq!(names(&folder), ["rows.parquet", "stage.toml"]);
}
