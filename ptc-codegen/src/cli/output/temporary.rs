//! Files and folders under way: each is gone when it is dropped, and when a signal ends the process,
//! unless it has taken its place.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};

use tempfile::{Builder, NamedTempFile, TempDir};

/// What is there now. Whoever changes it holds the lock, and a signal keeps it, so that nothing is
/// made after the last look.
static UNDER_WAY: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn under_way() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNDER_WAY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A file beside the one it will become.
pub(crate) struct Temporary(Option<NamedTempFile>);

impl Temporary {
    /// An empty file in `folder`, with the mode of a new file.
    pub(crate) fn new(folder: &Path) -> io::Result<Self> {
        watch();
        let mut all = under_way();
        let file = builder(0o666).tempfile_in(folder)?;
        all.insert(file.path().to_owned());
        Ok(Self(Some(file)))
    }

    /// The open file.
    pub(crate) fn file(&self) -> io::Result<&File> {
        self.0.as_ref().map(NamedTempFile::as_file).ok_or_else(|| io::ErrorKind::NotFound.into())
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let mut all = under_way();
        if let Some(file) = self.0.take() {
            all.remove(file.path());
            // Where it cannot be removed nothing better is to be done.
            drop(file);
        }
    }
}

/// Puts each file in its place, all of them before a signal is heard.
///
/// # Errors
/// A file cannot be put in its place, which is returned with the error.
pub(crate) fn commit(mut files: Vec<(Temporary, PathBuf)>) -> Result<(), (PathBuf, io::Error)> {
    let mut all = under_way();
    let mut result = Ok(());
    for (temporary, path) in &mut files {
        let Some(file) = temporary.0.take() else { continue };
        let name = file.path().to_owned();
        match file.persist(&*path) {
            Ok(_) => {
                all.remove(&name);
            }
            Err(failed) => {
                temporary.0 = Some(failed.file);
                result = Err((path.clone(), failed.error));
                break;
            }
        }
    }
    // What is left is dropped, for which the lock is needed again.
    drop(all);
    result
}

/// A folder that is removed with all that is in it.
pub(crate) struct TemporaryFolder(Option<TempDir>);

impl TemporaryFolder {
    /// An empty folder in `folder`, with the mode of a new folder.
    pub(crate) fn new(folder: &Path) -> io::Result<Self> {
        watch();
        let mut all = under_way();
        let made = builder(0o777).tempdir_in(folder)?;
        all.insert(made.path().to_owned());
        Ok(Self(Some(made)))
    }

    /// Where it is.
    pub(crate) fn path(&self) -> &Path {
        self.0.as_ref().map_or(Path::new(""), TempDir::path)
    }

    /// Makes it the folder at `path`, where none is or an empty one.
    ///
    /// # Errors
    /// It cannot be renamed.
    pub(crate) fn commit(mut self, path: &Path) -> io::Result<()> {
        let mut all = under_way();
        let Some(made) = self.0.take() else { return Ok(()) };
        // Not every system renames a folder over an empty one.
        if cfg!(windows) && path.is_dir() {
            fs::remove_dir(path)?;
        }
        let renamed = fs::rename(made.path(), path);
        all.remove(made.path());
        if renamed.is_ok() {
            // Its name is another now.
            let _ = made.keep();
        }
        renamed
    }
}

impl Drop for TemporaryFolder {
    fn drop(&mut self) {
        let mut all = under_way();
        if let Some(folder) = self.0.take() {
            all.remove(folder.path());
            drop(folder);
        }
    }
}

/// A short name that no other file has, whatever the length of the name that is to come.
fn builder(mode: u32) -> Builder<'static, 'static> {
    let mut builder = Builder::new();
    builder.prefix(".ptc-").suffix(".tmp");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // Less the umask, as for any new file.
        builder.permissions(fs::Permissions::from_mode(mode));
    }
    #[cfg(not(unix))]
    let _ = mode;
    builder
}

/// From here on the signals that end a process remove what is under way first, and a file that
/// reaches the limit of its size is an error like a full disk.
pub(crate) fn watch() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        #[cfg(unix)]
        // Without a handler the process ends as it would anyway.
        let _ = signals::handle();
    });
}

#[cfg(unix)]
mod signals {
    use std::fs;
    use std::io;
    use std::sync::Arc;
    use std::thread;

    use signal_hook::consts::{SIGALRM, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU, SIGXFSZ};
    use signal_hook::iterator::Signals;
    use signal_hook::{flag, low_level};

    use super::under_way;

    pub(super) fn handle() -> io::Result<()> {
        // To be interrupted by it is not to be ended by it: the write then fails.
        flag::register(SIGXFSZ, Arc::default())?;
        let ignored = ignored();
        let all = [SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGALRM, SIGXCPU];
        let heard = all.into_iter().filter(|signal| ignored >> (signal - 1) & 1 == 0);
        let mut signals = Signals::new(heard)?;
        thread::Builder::new().name("signals".to_owned()).spawn(move || {
            if let Some(signal) = signals.forever().next() {
                let all = under_way();
                for path in all.iter() {
                    let removed = fs::remove_file(path).or_else(|_| fs::remove_dir_all(path));
                    // The process ends in any case.
                    drop(removed);
                }
                let _ = low_level::emulate_default_handler(signal);
                low_level::exit(128 + signal);
            }
        })?;
        Ok(())
    }

    /// The signals that whoever started the process wants ignored, as `nohup` does, one bit each.
    /// Where the system does not say so, that is taken of SIGHUP.
    fn ignored() -> u64 {
        let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
        mask.unwrap_or(1 << (SIGHUP - 1))
    }
}
