//! One worker at a time for each user, by a lock on a file.

use std::fs::{self, File, TryLockError};
use std::path::PathBuf;
use std::time::{Duration, Instant};

use super::child::Wrong;
use crate::cli::report::{self, Notice};

const FILE: &str = "ptc-codegen-symbolica.lock";

/// The variable of the environment with another file.
pub(super) const FILE_KEY: &str = "PTC_ENGINE_LOCK";

/// Time between two looks at the lock.
const PAUSE: Duration = Duration::from_millis(20);

/// Time after which a message says what is being waited for.
const SILENCE: Duration = Duration::from_secs(2);

/// The lock, which is given back when it is dropped, also by a process that is killed.
pub(super) fn take(patience: Duration) -> Result<File, Wrong> {
    let path = path();
    let wrong = |error| Wrong::Place(path.clone(), error);
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(wrong)?;
    }
    let file = File::options().create(true).append(true).open(&path).map_err(wrong)?;
    let began = Instant::now();
    let mut told = false;
    loop {
        match file.try_lock() {
            Ok(()) => return Ok(file),
            Err(TryLockError::Error(error)) => return Err(wrong(error)),
            Err(TryLockError::WouldBlock) if began.elapsed() >= patience => {
                return Err(Wrong::Busy(path, patience));
            }
            Err(TryLockError::WouldBlock) => {}
        }
        if !told && began.elapsed() >= SILENCE {
            told = true;
            let title = "waiting for another ptc-codegen that uses Symbolica".to_owned();
            report::print(&[Notice { warns: true, ..Notice::of(title) }]);
        }
        std::thread::sleep(PAUSE);
    }
}

/// The lock's file: the one that the environment names, or one in the user's own folder for what can
/// be made again.
fn path() -> PathBuf {
    let named = |key: &str| std::env::var_os(key).filter(|v| !v.is_empty()).map(PathBuf::from);
    if let Some(path) = named(FILE_KEY) {
        return path;
    }
    let folder = named("XDG_CACHE_HOME")
        .or_else(|| named("HOME").map(|home| home.join(".cache")))
        .or_else(|| named("LOCALAPPDATA"))
        .unwrap_or_else(std::env::temp_dir);
    folder.join(FILE)
}
