//! Files and folders under way that a process left when it was killed.
//!
//! A process locks what it has under way, and the system ends the lock with the process. So what can be
//! locked belongs to nobody, also where processes share a folder from several machines.

use std::fs::{self, File};
use std::path::Path;

use super::place::same_file;

/// Prefix and suffix of the names of files and folders under way.
pub(super) const PREFIX: &str = ".ptc-";
pub(super) const SUFFIX: &str = ".tmp";

/// Random characters between the two.
pub(super) const RANDOM: usize = 6;

/// Locks what was just made at `path`; false if another process took it for left and removed it.
#[cfg(unix)]
pub(super) fn claim(file: &File, path: &Path) -> bool {
    // Where there are no locks nobody removes what is left.
    let _ = file.lock();
    is_at(file, path)
}

/// Elsewhere a lock would keep others from reading, and what is left stays.
#[cfg(not(unix))]
pub(super) fn claim(_: &File, _: &Path) -> bool {
    true
}

/// Removes from `folder` what a process left that is gone.
pub(super) fn remove_left(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        if cfg!(unix) && entry.file_name().to_str().is_some_and(is_name) {
            remove(&entry.path());
        }
    }
}

fn is_name(name: &str) -> bool {
    let middle = name.strip_prefix(PREFIX).and_then(|name| name.strip_suffix(SUFFIX));
    middle.is_some_and(|middle| {
        middle.len() == RANDOM && middle.bytes().all(|byte| byte.is_ascii_alphanumeric())
    })
}

/// Removes a file or folder unless its owner is at work. What cannot be removed stays.
fn remove(path: &Path) {
    let Ok(there) = path.symlink_metadata() else { return };
    if !there.is_file() && !there.is_dir() {
        return;
    }
    let Ok(file) = File::open(path) else { return };
    if file.try_lock().is_err() || !is_at(&file, path) {
        return;
    }
    let removed = if there.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
    drop(removed);
}

fn is_at(file: &File, path: &Path) -> bool {
    let there = path.symlink_metadata().and_then(|there| Ok((there, file.metadata()?)));
    there.is_ok_and(|(there, own)| same_file(&there, &own))
}
