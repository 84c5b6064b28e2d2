//! Shards, interrupted runs and scenarios that are run again.

use std::fs;
use std::process::Stdio;
use std::time::{Duration, Instant};

use super::{DRIVEN, UNCERTAIN, command, folder, objective, run, spending};

#[test]
fn parts_merge_to_the_bytes_of_one_run() {
    let folder = folder("parts", UNCERTAIN);
    let (code, whole, wrong) = run(&folder, &["stage.toml", "--out", "whole.parquet"]);
    assert_eq!((code, wrong.as_str()), (Some(0), ""), "{whole}");
    let bytes = fs::read(folder.join("whole.parquet")).expect("a file");
    assert_eq!(run(&folder, &["stage.toml"]), (Some(0), whole.clone(), String::new()));
    for count in [7, 64] {
        let mut arguments = vec!["stage.toml".to_owned(), "--merge".to_owned()];
        for part in (1..=count).rev() {
            let (shard, out) = (format!("{part}/{count}"), format!("part{part}.parquet"));
            let (code, told, wrong) =
                run(&folder, &["stage.toml", "--shard", &shard, "--out", &out]);
            assert_eq!((code, wrong.as_str()), (Some(0), ""), "{told}");
            arguments.push(out);
        }
        arguments.extend(["--out".to_owned(), "merged.parquet".to_owned()]);
        let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
        assert_eq!(run(&folder, &arguments), (Some(0), whole.clone(), String::new()));
        assert!(fs::read(folder.join("merged.parquet")).expect("a file") == bytes, "{count}");
        // A part that is missing, or there twice, is refused.
        let (first, rest) = (&arguments[..2], &arguments[2..arguments.len() - 2]);
        let lacking: Vec<_> = first.iter().chain(&rest[1..]).copied().collect();
        let (code, _, wrong) = run(&folder, &lacking);
        assert_eq!(code, Some(2), "{wrong}");
        assert!(wrong.contains("no part holds the scenarios"), "{wrong}");
        let twice: Vec<_> = first.iter().chain(rest).chain(&rest[..1]).copied().collect();
        let (code, _, wrong) = run(&folder, &twice);
        assert_eq!(code, Some(2), "{wrong}");
        assert!(wrong.contains("which another part holds too"), "{wrong}");
    }
    let names = fs::read_dir(&folder).expect("a folder").map(|entry| entry.expect("a file"));
    let left: Vec<_> = names.filter(|name| name.path().is_dir()).collect();
    assert!(left.is_empty(), "{left:?}");
    let other = run(&folder, &["stage.toml", "--seed", "12", "--merge", "whole.parquet"]);
    assert_eq!(other.0, Some(2));
    assert!(other.2.contains("another campaign") && other.2.contains("seed = 11"), "{}", other.2);
}

#[test]
fn the_number_of_cores_and_an_interruption_change_nothing() {
    let folder = folder("resumed", UNCERTAIN);
    let one = command(&folder, &["stage.toml", "--out", "one.parquet"])
        .env("RAYON_NUM_THREADS", "1")
        .output()
        .expect("runs");
    let asked = ["stage.toml", "--out", "resumed.parquet"];
    let mut child = command(&folder, &asked).stdout(Stdio::null()).spawn().expect("runs");
    let rows = folder.join("resumed.parquet.chunks");
    let kept = || fs::metadata(&rows).map_or(0, |there| there.len());
    let began = Instant::now();
    // The header is shorter than one chunk of 64 rows.
    while kept() < 5000 && began.elapsed() < Duration::from_secs(120) {
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().expect("killed");
    child.wait().expect("ended");
    assert!(!folder.join("resumed.parquet").exists(), "nothing half");
    // What another campaign left is not taken for this one's.
    let (code, _, wrong) = run(&folder, &["stage.toml", "--seed=12", "--out=resumed.parquet"]);
    assert_eq!(code, Some(2));
    assert!(wrong.contains("another campaign") && wrong.contains("remove this file"), "{wrong}");
    let (code, told, _) = run(&folder, &asked);
    assert_eq!((code, told.as_bytes()), (Some(0), &one.stdout[..]));
    let read = |name: &str| fs::read(folder.join(name)).expect("a file");
    assert!(read("resumed.parquet") == read("one.parquet"));
    assert!(!rows.exists());
}

/// Start times, parameters and integrals are drawn and summed alike, whoever runs them.
#[test]
fn what_is_drawn_of_the_controller_depends_on_seed_and_index_alone() {
    let folder = folder("spending", &spending());
    let whole = command(&folder, &["stage.toml", "--out", "whole.parquet"])
        .env("RAYON_NUM_THREADS", "1")
        .output()
        .expect("runs");
    assert_eq!(whole.status.code(), Some(0), "{whole:?}");
    let told = String::from_utf8_lossy(&whole.stdout);
    assert!(told.contains("objective 3, integral(integral(u^2)) + x1 <= 30: holds"), "{told}");
    let mut parts = Vec::new();
    for part in 1..=3 {
        let (shard, out) = (format!("{part}/3"), format!("part{part}.parquet"));
        let (code, _, wrong) = run(&folder, &["stage.toml", "--shard", &shard, "--out", &out]);
        assert_eq!(code, Some(0), "{wrong}");
        parts.push(out);
    }
    let parts: Vec<_> = parts.iter().map(String::as_str).collect();
    let merge = [&["stage.toml", "--out", "merged.parquet", "--merge"], &parts[..]].concat();
    let (_, merged, wrong) = run(&folder, &merge);
    assert_eq!((merged.as_bytes(), wrong.as_str()), (&whole.stdout[..], ""));
    let read = |name: &str| fs::read(folder.join(name)).expect("a file");
    assert!(read("merged.parquet") == read("whole.parquet"));
    // The worst draw is run again as it is printed.
    let (_, worst) = told.split_once("worst trajectory, ").expect("a trajectory");
    let worst = worst.lines().next().expect("a scenario");
    assert!(["t0 = ", "a = ", "k1 = "].iter().all(|name| worst.contains(name)), "{worst}");
    let (code, csv, _) = run(&folder, &["stage.toml", "--scenario", worst]);
    assert_eq!(code, Some(0));
    assert!(csv.starts_with("t,time_to_go,x1,u,integral1,integral2,excess1,"), "{csv}");
    assert_eq!(run(&folder, &["stage.toml", "--scenario", worst]).1, csv);
}

#[test]
fn a_scenario_can_be_run_again() {
    let folder = folder("again", UNCERTAIN);
    let (code, csv, _) = run(&folder, &["stage.toml", "--scenario", "17"]);
    assert_eq!(code, Some(0));
    assert!(csv.starts_with("t,time_to_go,x1,u,excess1,excess2\n0.0,"), "{csv}");
    assert_eq!(run(&folder, &["stage.toml", "--scenario=17"]).1, csv);
    assert_ne!(run(&folder, &["stage.toml", "--scenario=18"]).1, csv);
    assert_ne!(run(&folder, &["stage.toml", "--scenario=17", "--seed=1"]).1, csv);
}

#[test]
fn a_worst_scenario_is_run_again_as_it_is_printed() {
    let within = "bound = \"within\"\nh = \"x1\"\nhigh = 0.2501";
    let folder = folder("replayed", &format!("{DRIVEN}{}", objective(within)));
    let (_, told, wrong) = run(&folder, &["stage.toml", "--worst", "worst.csv"]);
    let line = told.lines().find_map(|line| line.strip_prefix("worst trajectory, "));
    let scenario = line.unwrap_or_else(|| panic!("{told}{wrong}"));
    let (code, csv, wrong) = run(&folder, &["stage.toml", "--scenario", scenario]);
    assert_eq!((code, wrong.as_str()), (Some(0), ""));
    assert_eq!(fs::read_to_string(folder.join("worst.csv")).expect("a trajectory"), csv);
    let (code, csv, wrong) = run(&folder, &["stage.toml", "--scenario", "x1 = 0, d = 2"]);
    assert_eq!((code, csv.as_str()), (Some(2), ""), "{wrong}");
    assert!(wrong.contains("no legal d") && wrong.contains("in [-1, 1]"), "{wrong}");
}
