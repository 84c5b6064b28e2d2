//! Comparison of `--check`: the existing files with those that would be written.

use std::io::{self, ErrorKind};
use std::path::Path;

use crate::emit::File;

use super::report::{Failure, Notice};
use super::write;

/// Compares the files with what `read` gives for them, which is in `folder`.
pub(crate) fn compare(
    folder: &Path,
    files: &[File],
    read: &mut dyn FnMut(&File) -> io::Result<Vec<u8>>,
) -> Result<(), Failure> {
    let mut notices = Vec::new();
    let mut same = String::new();
    for file in files {
        let path = folder.join(&file.name);
        match read(file) {
            Ok(there) if there == file.text.as_bytes() => {
                same.push_str(&format!("up to date: {}\n", write::shown(&path)));
            }
            Ok(there) => notices.push(difference(&path, &there, &file.text)),
            Err(error) if error.kind() == ErrorKind::NotFound => {
                notices.push(drift(format!("{} is missing", path.display()), Vec::new()));
            }
            Err(error) => return Err(write::failed("cannot read", &path, &error)),
        }
    }
    if notices.is_empty() { write::to_stdout(&same) } else { Err(Failure::drift(notices)) }
}

fn difference(path: &Path, there: &[u8], generated: &str) -> Notice {
    let there = String::from_utf8_lossy(there);
    // By `\n` alone, so that a changed line end or a missing last one is a difference too.
    let mut left = there.split('\n');
    let mut right = generated.split('\n');
    let mut number = 0;
    loop {
        number += 1;
        let (old, new) = (left.next(), right.next());
        if old != new || old.is_none() {
            let title = format!("{} differs from line {number} on", path.display());
            let notes = vec![format!("it has {}", shown(old)), format!("not  {}", shown(new))];
            return drift(title, notes);
        }
    }
}

fn shown(line: Option<&str>) -> String {
    match line {
        None => "the end of the file".to_owned(),
        Some(line) if line.chars().count() > 90 => {
            format!("{:?}...", line.chars().take(87).collect::<String>())
        }
        Some(line) => format!("{line:?}"),
    }
}

fn drift(title: String, notes: Vec<String>) -> Notice {
    let help = "run the same command without `--check` to write it".to_owned();
    Notice { code: Some("drift"), title, quote: None, notes, help: Some(help), ..Notice::default() }
}
