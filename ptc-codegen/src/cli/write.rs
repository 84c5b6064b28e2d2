//! Writing: to the standard output, and to files that are never half there.

use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use ptc_codegen::emit::File;

use super::report::Failure;

/// Prints `text`. A reader that has gone away, such as `head`, has got what it wanted.
pub(crate) fn to_stdout(text: &str) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(failed("cannot write", Path::new("the standard output"), &error))
        }
        _ => Ok(()),
    }
}

/// Writes the files into `folder` and tells what was done, one line a file. All of them are written
/// in full beside the old ones before the first takes its place.
pub(crate) fn files(folder: &Path, files: &[File]) -> Result<String, Failure> {
    let files: Vec<_> = files.iter().map(|f| (f.name.as_str(), f.text.as_bytes())).collect();
    bytes(folder, &files)
}

/// Writes files of any content, by their names, as [`files`] does.
pub(crate) fn bytes(folder: &Path, files: &[(&str, &[u8])]) -> Result<String, Failure> {
    let files: Vec<_> = files.iter().map(|(name, content)| (folder.join(name), *content)).collect();
    // Without a file too the folder is there.
    fs::create_dir_all(folder).map_err(|error| failed("cannot make the folder", folder, &error))?;
    paths(&files)
}

/// Writes files of any content to their paths, as [`files`] does.
pub(crate) fn paths(files: &[(PathBuf, &[u8])]) -> Result<String, Failure> {
    let mut pending = Vec::new();
    let mut told = String::new();
    for (path, content) in files {
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)
                .map_err(|error| failed("cannot make the folder", folder, &error))?;
        }
        // A file that keeps its time stamp is not built again.
        if fs::read(path).is_ok_and(|there| there == *content) {
            told.push_str(&format!("unchanged {}\n", path.display()));
            continue;
        }
        // Found before the first file is renamed, not at the second.
        if path.is_dir() {
            let error = io::Error::from(ErrorKind::IsADirectory);
            return Err(failed("cannot write", path, &error));
        }
        let temporary =
            Temporary::new(path, content).map_err(|error| failed("cannot write", path, &error))?;
        told.push_str(&format!("wrote {}\n", path.display()));
        pending.push((temporary, path));
    }
    for (temporary, path) in pending {
        fs::rename(&temporary.0, path).map_err(|error| failed("cannot write", path, &error))?;
    }
    Ok(told)
}

/// A file beside the one it will become; removed when dropped, unless it was renamed.
struct Temporary(PathBuf);

impl Temporary {
    fn new(path: &Path, content: &[u8]) -> io::Result<Self> {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let temporary = Self(path.with_file_name(format!(".{name}.{}.tmp", std::process::id())));
        let mut writer = fs::OpenOptions::new().write(true).create_new(true).open(&temporary.0)?;
        writer.write_all(content)?;
        writer.flush()?;
        Ok(temporary)
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        // Not there after a rename; and where it cannot be removed nothing better is to be done.
        let _ = fs::remove_file(&self.0);
    }
}

/// What is told of an error of the file system.
pub(crate) fn failed(what: &str, path: &Path, error: &io::Error) -> Failure {
    Failure::because(
        format!("{what} {}: {error}", path.display()),
        "give a folder that can be written with `-o`, or `-o -` for the standard output",
    )
}
