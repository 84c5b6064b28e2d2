//! One owner of a journal at a time, by a lock of the system on its file, which ends with the process.

use std::fs::{File, TryLockError};
use std::io::Read;
use std::path::Path;

use super::failure::{foreign, unusable};
use super::header::{OWNER, owner};
use crate::cli::output::same_file;
use crate::cli::report::Failure;

/// Number of attempts to open a file that its last owner is about to remove.
const TRIES: usize = 100;

/// The file at `path`, which no other process has.
pub(super) fn lock(path: &Path) -> Result<File, Failure> {
    for _ in 0..TRIES {
        if let Ok(there) = path.symlink_metadata() {
            if there.is_dir() {
                return Err(foreign(path, "is a folder, which this program did not make"));
            }
            if !there.is_file() {
                return Err(foreign(path, "is not a file of this program"));
            }
        }
        let options =
            File::options().read(true).write(true).create(true).truncate(false).open(path);
        let mut file = options.map_err(|error| unusable(path, &error.to_string()))?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                let mut line = [0; OWNER];
                let read = file.read_exact(&mut line);
                let process = read.ok().and_then(|()| owner(&line));
                let by = process.map_or(String::new(), |process| format!(", process {process}"));
                return Err(Failure::because(
                    format!("{} is in use by another run of verify{by}", path.display()),
                    "wait for it to end, or give another --out",
                ));
            }
            Err(TryLockError::Error(error)) => {
                return Err(unusable(path, &format!("it cannot be locked: {error}")));
            }
        }
        // Its last owner may have removed it after it was opened here.
        let there = path.symlink_metadata().and_then(|there| Ok((there, file.metadata()?)));
        if cfg!(not(unix)) || there.is_ok_and(|(there, own)| same_file(&there, &own)) {
            return Ok(file);
        }
    }
    Err(unusable(path, "it is removed again and again"))
}
