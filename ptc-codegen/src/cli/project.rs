//! `emit --project`: a folder that is new, and there as a whole or not at all.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use ptc_codegen::emit::File;

use super::report::Failure;
use super::write::{failed, to_stdout};

/// Makes `folder` with the files in it. Where it is there with the same files, nothing is done;
/// whatever else is in a folder is another's, and left alone.
pub(crate) fn write(folder: &Path, files: &[File]) -> Result<(), Failure> {
    let told = |word: &str| {
        let line = |file: &File| format!("{word} {}\n", folder.join(&file.name).display());
        to_stdout(&files.iter().map(line).collect::<String>())
    };
    let same = |file: &File| {
        fs::read(folder.join(&file.name)).is_ok_and(|there| there == file.text.as_bytes())
    };
    if files.iter().all(same) {
        return told("unchanged");
    }
    refuse_what_is_there(folder)?;
    let Some(name) = folder.file_name() else {
        return Err(Failure::because(
            format!("{} names no folder to make", folder.display()),
            "give the name of a new folder with `-o`",
        ));
    };
    let parent = folder.parent().unwrap_or(Path::new(""));
    let wrong = |error: io::Error| failed("cannot make the folder", folder, &error);
    if !parent.as_os_str().is_empty() {
        fs::create_dir_all(parent).map_err(wrong)?;
    }
    let beside = format!(".{}.{}.tmp", name.to_string_lossy(), std::process::id());
    let temporary = Temporary(parent.join(beside));
    fs::create_dir(&temporary.0).map_err(wrong)?;
    for file in files {
        let path = temporary.0.join(&file.name);
        let home = path.parent().unwrap_or(&temporary.0);
        fs::create_dir_all(home).and_then(|()| fs::write(&path, &file.text)).map_err(wrong)?;
    }
    // An empty folder may be there, which not every system renames over.
    if folder.is_dir() {
        fs::remove_dir(folder).map_err(wrong)?;
    }
    fs::rename(&temporary.0, folder).map_err(wrong)?;
    told("wrote")
}

/// A folder with anything in it is not written to, nor is anything that is no folder.
fn refuse_what_is_there(folder: &Path) -> Result<(), Failure> {
    let help = "a project is written once and is yours from then on: give a new folder with `-o`, \
                or emit the controller alone into this one with `--lang`";
    if folder.symlink_metadata().is_err() {
        return Ok(());
    }
    let mut entries =
        fs::read_dir(folder).map_err(|error| failed("cannot write to", folder, &error))?;
    match entries.next() {
        None => Ok(()),
        Some(Ok(entry)) => Err(Failure::because(
            format!(
                "{} is not empty: it holds {}",
                folder.display(),
                entry.file_name().to_string_lossy()
            ),
            help,
        )),
        Some(Err(error)) => Err(failed("cannot read", folder, &error)),
    }
}

/// A folder beside the one it will become; removed when dropped, unless it was renamed.
struct Temporary(PathBuf);

impl Drop for Temporary {
    fn drop(&mut self) {
        // Not there after a rename; and where it cannot be removed nothing better is to be done.
        let _ = fs::remove_dir_all(&self.0);
    }
}
