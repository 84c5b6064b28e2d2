//! Durability across a power cut: a file is on the disk before its name is, and then the name.

use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::Path;

/// Puts the names in a folder on the disk: those of files that were made, renamed or removed in it.
#[cfg(unix)]
pub(crate) fn sync_folder(folder: &Path) -> io::Result<()> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let open = match File::open(folder) {
        // A folder whose names may not be read cannot be synced.
        Err(error) if error.kind() == ErrorKind::PermissionDenied => return Ok(()),
        open => open?,
    };
    match open.sync_all() {
        // Not every file system does that.
        Err(error) if matches!(error.kind(), ErrorKind::InvalidInput | ErrorKind::Unsupported) => {
            Ok(())
        }
        done => done,
    }
}

/// Elsewhere a folder cannot be opened as a file.
#[cfg(not(unix))]
pub(crate) fn sync_folder(_: &Path) -> io::Result<()> {
    Ok(())
}

/// Puts a folder on the disk with all that is in it.
pub(super) fn sync_tree(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        match entry.file_type()?.is_dir() {
            true => sync_tree(&entry.path())?,
            false => File::open(entry.path())?.sync_all()?,
        }
    }
    sync_folder(folder)
}

/// A file without a name in the folder for temporary files, which an error names.
#[cfg(feature = "lab")]
pub(crate) fn nameless() -> io::Result<File> {
    tempfile::tempfile().map_err(|error| {
        let folder = std::env::temp_dir();
        let message = format!(
            "the folder for temporary files, {}, cannot be written: {error}; give another in TMPDIR",
            folder.display()
        );
        io::Error::new(error.kind(), message)
    })
}
