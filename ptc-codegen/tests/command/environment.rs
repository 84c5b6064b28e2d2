//! The generated code does not depend on the environment of the process.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Both files of a controller as the program prints them, run in `folder`.
fn emitted(folder: &Path, environment: &[(&str, &str)]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_ptc-codegen"))
        .args(["emit", "--lang", "c", "--n", "4", "--mu", "tanh(a=0.1)", "-o", "-"])
        .current_dir(folder)
        .env_clear()
        .envs(environment.iter().copied())
        .output()
        .expect("the program runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8")
}

#[test]
fn the_environment_changes_no_byte() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("elsewhere, with a space");
    std::fs::create_dir_all(&folder).expect("a folder");
    let here = emitted(Path::new("."), &[]);
    assert!(here.contains("ptc_tanh4_step"));
    let elsewhere = [
        ("LC_ALL", "de_DE.UTF-8"),
        ("LANG", "tr_TR.UTF-8"),
        ("TZ", "Pacific/Auckland"),
        ("HOME", "/nonexistent"),
        ("USER", "somebody"),
        ("COLUMNS", "20"),
        ("SOURCE_DATE_EPOCH", "0"),
    ];
    assert_eq!(emitted(&folder, &elsewhere), here);
    assert_eq!(emitted(&folder, &[]), here);
}
