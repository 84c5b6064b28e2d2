//! Any output can be pointed at anything, and nothing is lost that was not the tool's own.

mod campaigns;
mod limits;
mod outputs;
mod projects;
use crate::support;

use std::fs;
use std::path::{Path, PathBuf};

/// A design with a plant and an objective, all of it quick.
const DESIGN: &str = "n = 1\nmu = \"exp(a=1)\"\npoles = [-4]\neps = 1e-3\n[params]\ntau = 1\n\
                      [plant]\nf = \"-d*x1\"\nd = [0, 0.5]\n[verify]\nx1 = [-1, 1]\n\
                      scenarios = 130\nsearch = 4\n[[objective]]\nbound = \"attractive\"\n\
                      error = 1e-2\n";

fn stage(test: &str) -> PathBuf {
    support::folder_with(&format!("files_{test}"), "stage.toml", DESIGN)
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry"));
    let mut names: Vec<_> =
        entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}
