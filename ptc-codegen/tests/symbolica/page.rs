//! docs/engines.md shows what is printed.

use std::env;
use std::path::Path;
use std::process::Command;

const PAGE: &str = include_str!("../../../docs/engines.md");

#[test]
fn the_page_shows_what_is_printed() {
    let binary = Path::new(env!("CARGO_BIN_EXE_ptc-codegen"));
    let folder = binary.parent().expect("a folder").to_owned();
    let others = env::var_os("PATH").unwrap_or_default();
    let path = env::join_paths(std::iter::once(folder).chain(env::split_paths(&others)));
    let path = path.expect("folders without a colon");
    let mut count = 0;
    for block in PAGE.split("```console\n$ ").skip(1) {
        let (block, _) = block.split_once("```").expect("the end of a block");
        let (line, shown) = block.split_once('\n').expect("a command and its output");
        let output = Command::new("sh").args(["-c", line]).env("PATH", &path).output();
        let output = output.expect("a shell");
        assert_eq!(String::from_utf8_lossy(&output.stdout), shown, "{line}");
        count += 1;
    }
    assert_eq!(count, 2);
}
