//! A limit of the size of files.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::support::{folder, run_in, told};
use super::{names, stage};

/// A command under a limit of `ulimit`.
fn limited(folder: &Path, limit: &str, arguments: &[&str]) -> (Option<i32>, String, String) {
    let script = format!("{limit}; exec \"$0\" \"$@\"");
    let mut command = Command::new("sh");
    command.args(["-c", &script, env!("CARGO_BIN_EXE_ptc-codegen")]).args(arguments);
    told(command.current_dir(folder))
}

#[test]
fn a_limit_of_size_is_an_error_that_leaves_nothing() {
    let folder = stage("limit");
    let whole = ["simulate", "stage.toml", "--x0=1", "--plant=d=0", "-o", "run.csv"];
    let project = ["emit", "--project=cmake", "--n=2", "--mu=exp", "--name=roll", "-o", "q"];
    let verify = ["verify", "stage.toml", "--out", "rows.parquet"];
    fs::write(folder.join("run.csv"), "old").expect("a file");
    for arguments in [&whole[..], &project, &verify] {
        let (code, printed, wrong) = limited(&folder, "ulimit -f 2", arguments);
        assert_eq!((code, printed.as_str()), (Some(2), ""), "{wrong}");
        assert!(wrong.contains("File too large"), "{wrong}");
    }
    assert_eq!(fs::read_to_string(folder.join("run.csv")).expect("there"), "old");
    // The rows that were done are kept.
    assert_eq!(names(&folder), ["rows.parquet.chunks", "run.csv", "stage.toml"]);
    assert_eq!(run_in(&folder, &verify).0, Some(0));
    assert_eq!(names(&folder), ["rows.parquet", "run.csv", "stage.toml"]);
}

#[test]
fn a_limit_of_size_leaves_no_folder_that_was_made_for_an_output() {
    let folder = folder("files_limit_folders");
    for what in [&["--lang=c"][..], &["--lang=st"], &["--lang=fmu3"], &["--project=cmake"]] {
        for place in ["q", "a/b/q"] {
            let common = ["emit", "--n=2", "--mu=exp", "--name=roll", "-o", place];
            let arguments = [&common[..], what].concat();
            // 2: the first file of some fits, and a later one does not.
            for limit in ["ulimit -f 0", "ulimit -f 1", "ulimit -f 2"] {
                let (code, printed, wrong) = limited(&folder, limit, &arguments);
                assert_eq!((code, printed.as_str()), (Some(2), ""), "{arguments:?}: {wrong}");
                assert_eq!(names(&folder), [""; 0], "{arguments:?} under {limit}");
            }
        }
    }
    fs::create_dir(folder.join("a")).expect("a folder");
    let arguments = ["emit", "--n=2", "--mu=exp", "--name=roll", "--lang=c", "-o", "a/b"];
    assert_eq!(limited(&folder, "ulimit -f 2", &arguments).0, Some(2));
    assert_eq!(names(&folder), ["a"], "what was there before stays");
    assert_eq!(names(&folder.join("a")), [""; 0]);
    assert_eq!(run_in(&folder, &arguments).0, Some(0));
    assert_eq!(names(&folder.join("a/b")), ["roll.c", "roll.h"]);
}
