//! The files in generated/: compared with those that the generator writes, or written anew.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Text of each golden by its path in generated/.
pub(crate) type Files = BTreeMap<PathBuf, String>;

const REFRESH: &str = "refresh with `UPDATE_GOLDEN=1 cargo test --test golden`";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("generated")
}

/// Every file in `folders` of generated/ and below them.
fn kept(folders: &[&str]) -> Files {
    let mut open: Vec<_> = folders.iter().map(PathBuf::from).collect();
    let mut kept = Files::new();
    while let Some(folder) = open.pop() {
        let Ok(entries) = fs::read_dir(root().join(&folder)) else { continue };
        for entry in entries {
            let entry = entry.expect("an entry");
            let path = folder.join(entry.file_name());
            if entry.path().is_dir() {
                open.push(path);
            } else {
                kept.insert(path, fs::read_to_string(entry.path()).expect("a text"));
            }
        }
    }
    kept
}

/// Holds the files in `folders` against `wanted`: the same paths, and the same bytes.
pub(crate) fn compare(folders: &[&str], wanted: &Files) {
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        update(folders, wanted);
    }
    let kept = kept(folders);
    let paths = |files: &Files| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(paths(&kept), paths(wanted), "the files in generated/; {REFRESH}");
    for (path, text) in wanted {
        let line = text.lines().zip(kept[path].lines()).position(|(a, b)| a != b);
        let same = kept[path] == *text;
        assert!(same, "{} differs, first in line index {line:?}; {REFRESH}", path.display());
    }
}

fn update(folders: &[&str], wanted: &Files) {
    for stale in kept(folders).keys().filter(|path| !wanted.contains_key(*path)) {
        fs::remove_file(root().join(stale)).expect("a stale file goes");
    }
    for (path, text) in wanted {
        let path = root().join(path);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, text).expect("a golden");
    }
}
