//! Files and folders under way: each is gone when it is dropped, and when a signal ends the process,
//! unless it has taken its place. One that a kill leaves is removed by the next process that writes there. With them go the folders that were made to hold them, where nothing
//! is in them.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};

use tempfile::{Builder, NamedTempFile, TempDir};

use super::durable::{sync_folder, sync_tree};
use super::signals;
use super::stale::{self, PREFIX, RANDOM, SUFFIX, claim};

/// Files and folders under way. Code that makes or removes some of them holds the lock, and a signal keeps it, so that
/// nothing is made after the last look.
static UNDER_WAY: Mutex<UnderWay> = Mutex::new(UnderWay {
    temporary: BTreeSet::new(),
    made: BTreeSet::new(),
    clean: BTreeSet::new(),
});

struct UnderWay {
    /// Files and folders that are removed with all that is in them.
    temporary: BTreeSet<PathBuf>,
    /// Folders for outputs that were not there before.
    made: BTreeSet<PathBuf>,
    /// Folders in which nothing is left of a process that was killed.
    clean: BTreeSet<PathBuf>,
}

impl UnderWay {
    /// Removes from a folder, once, what a process left that was killed.
    fn clean(&mut self, folder: &Path) {
        if self.clean.insert(folder.to_owned()) {
            stale::remove_left(folder);
        }
    }

    /// Makes a folder, and those above it that are missing.
    fn make(&mut self, folder: &Path) -> io::Result<()> {
        let missing = folder.ancestors().filter(|path| !path.as_os_str().is_empty());
        let missing = missing.take_while(|path| !path.exists()).map(Path::to_owned);
        let missing: Vec<_> = missing.collect();
        self.made.extend(missing.iter().cloned());
        fs::create_dir_all(folder)?;
        // Outputs go by their paths without links.
        self.made.extend(missing.iter().filter_map(|path| path.canonicalize().ok()));
        Ok(())
    }

    /// The folders in which files at these paths have new names, and those in which folders for them have.
    fn changed<'a>(&self, paths: impl Iterator<Item = &'a Path>) -> BTreeSet<PathBuf> {
        let mut changed = BTreeSet::new();
        for folder in paths.filter_map(Path::parent) {
            changed.insert(folder.to_owned());
            let made = folder.ancestors().take_while(|above| self.made.contains(*above));
            changed.extend(made.filter_map(Path::parent).map(Path::to_owned));
        }
        changed
    }

    /// Removes the folders that were made and hold nothing, the inner ones first.
    fn remove_empty(&mut self) {
        for folder in self.made.iter().rev() {
            // One that holds a file has become an output.
            let _ = fs::remove_dir(folder);
        }
    }
}

fn under_way() -> MutexGuard<'static, UnderWay> {
    UNDER_WAY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A folder for outputs, which is removed again, with those that were made above it, when nothing is in
/// it in the end.
pub(crate) struct Folder(());

impl Folder {
    /// Makes it where it is missing.
    pub(crate) fn new(folder: &Path) -> io::Result<Self> {
        watch();
        let made = under_way().make(folder);
        // What was made before an error goes as well.
        let folder = Self(());
        made.map(|()| folder)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        under_way().remove_empty();
    }
}

/// A file beside the one it will become.
pub(crate) struct Temporary(Option<NamedTempFile>);

impl Temporary {
    /// An empty file in `folder`, which is made if it is missing, with the mode of a new file.
    pub(crate) fn new(folder: &Path) -> io::Result<Self> {
        watch();
        let mut all = under_way();
        all.clean(folder);
        loop {
            let made = all.make(folder).and_then(|()| builder(0o666).tempfile_in(folder));
            let file = made.inspect_err(|_| all.remove_empty())?;
            if claim(file.as_file(), file.path()) {
                all.temporary.insert(file.path().to_owned());
                return Ok(Self(Some(file)));
            }
        }
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
            all.temporary.remove(file.path());
            // Where it cannot be removed nothing better is to be done.
            drop(file);
            all.remove_empty();
        }
    }
}

/// Puts each file in its place, all of them before a signal is heard, so that a power cut leaves the old
/// file or the new one.
///
/// # Errors
/// A file cannot be put in its place, which is returned with the error.
pub(crate) fn commit(mut files: Vec<(Temporary, PathBuf)>) -> Result<(), (PathBuf, io::Error)> {
    for (temporary, path) in &files {
        let synced = temporary.file().and_then(File::sync_all);
        synced.map_err(|error| (path.clone(), error))?;
    }
    let mut all = under_way();
    let mut result = Ok(());
    for (temporary, path) in &mut files {
        let Some(file) = temporary.0.take() else { continue };
        let name = file.path().to_owned();
        match file.persist(&*path) {
            Ok(_) => {
                all.temporary.remove(&name);
            }
            Err(failed) => {
                temporary.0 = Some(failed.file);
                result = Err((path.clone(), failed.error));
                break;
            }
        }
    }
    let folders = all.changed(files.iter().map(|(_, path)| path.as_path()));
    // What is left is dropped, for which the lock is needed again.
    drop(all);
    result?;
    folders
        .iter()
        .try_for_each(|folder| sync_folder(folder).map_err(|error| (folder.clone(), error)))
}

/// A folder that is removed with all that is in it.
pub(crate) struct TemporaryFolder(Option<TempDir>, Option<File>);

impl TemporaryFolder {
    /// An empty folder in `folder`, with the mode of a new folder.
    pub(crate) fn new(folder: &Path) -> io::Result<Self> {
        watch();
        let mut all = under_way();
        all.clean(folder);
        loop {
            let made = builder(0o777).tempdir_in(folder)?;
            let held = held(made.path())?;
            if held.as_ref().is_none_or(|held| claim(held, made.path())) {
                all.temporary.insert(made.path().to_owned());
                return Ok(Self(Some(made), held));
            }
        }
    }

    /// Writes a file in it, by its path in it. A signal waits for the end of that: what is removed would
    /// not be empty otherwise.
    pub(crate) fn write(&self, name: &str, content: &[u8]) -> io::Result<()> {
        let _all = under_way();
        let path = self.path().join(name);
        fs::create_dir_all(path.parent().unwrap_or(&path))?;
        fs::write(&path, content)
    }

    /// Returns its path.
    pub(crate) fn path(&self) -> &Path {
        self.0.as_ref().map_or(Path::new(""), TempDir::path)
    }

    /// Makes it the folder at `path`, where none is or an empty one.
    ///
    /// # Errors
    /// It cannot be renamed.
    pub(crate) fn commit(mut self, path: &Path) -> io::Result<()> {
        sync_tree(self.path())?;
        let mut all = under_way();
        let Some(made) = self.0.take() else { return Ok(()) };
        // Not every system renames a folder over an empty one.
        if cfg!(windows) && path.is_dir() {
            fs::remove_dir(path)?;
        }
        let renamed = fs::rename(made.path(), path);
        all.temporary.remove(made.path());
        if renamed.is_ok() {
            // Its name is another now.
            let _ = made.keep();
            self.1.take();
        }
        renamed.and_then(|()| path.parent().map_or(Ok(()), sync_folder))
    }
}

impl Drop for TemporaryFolder {
    fn drop(&mut self) {
        let mut all = under_way();
        if let Some(folder) = self.0.take() {
            all.temporary.remove(folder.path());
            drop(folder);
        }
    }
}

/// Opens the file handle that holds the lock on a folder.
#[cfg(unix)]
fn held(folder: &Path) -> io::Result<Option<File>> {
    File::open(folder).map(Some)
}

#[cfg(not(unix))]
fn held(_: &Path) -> io::Result<Option<File>> {
    Ok(None)
}

/// A short name that no other file has, whatever the length of the name that is to come.
fn builder(mode: u32) -> Builder<'static, 'static> {
    let mut builder = Builder::new();
    builder.prefix(PREFIX).rand_bytes(RANDOM).suffix(SUFFIX);
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
        // Without a handler the process ends as it would anyway.
        let _ = signals::handle(remove_all);
    });
}

/// Removes what is under way, and keeps the lock.
fn remove_all() {
    let mut all = under_way();
    for path in &all.temporary {
        let removed = fs::remove_file(path).or_else(|_| fs::remove_dir_all(path));
        // The process ends in any case.
        drop(removed);
    }
    all.remove_empty();
    std::mem::forget(all);
}
