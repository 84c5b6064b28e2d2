//! `emit --project`: a folder that is new, and there as a whole or not at all.

use std::fs;
use std::io;

use crate::emit::File;

use super::output::{Folder, Kind, Place, TemporaryFolder, holds};
use super::report::Failure;
use super::write::{self, failed, to_stdout};

/// Makes the folder with the files in it. Where it is there with the same files, nothing is done;
/// whatever else is in a folder is another's, and left alone.
pub(crate) fn write(place: &Place, files: &[File]) -> Result<(), Failure> {
    let (shown, folder) = (&place.shown, &place.path);
    let told = |word: &str| {
        let line = |file: &File| format!("{word} {}\n", write::shown(&shown.join(&file.name)));
        to_stdout(&files.iter().map(line).collect::<String>())
    };
    let same = |file: &File| {
        let path = folder.join(&file.name);
        let regular = fs::metadata(&path).ok().filter(fs::Metadata::is_file);
        regular.is_some_and(|there| holds(&path, &there, file.text.as_bytes()))
    };
    if files.iter().all(same) {
        return told("unchanged");
    }
    refuse_what_is_there(place)?;
    let wrong = |error: io::Error| failed("cannot make the folder", shown, &error);
    let parent = match (folder.parent(), std::env::current_dir()) {
        (Some(parent), Ok(here)) if here != *folder => parent,
        _ => {
            return Err(Failure::because(
                format!("{} names no folder to make", shown.display()),
                "give the name of a new folder with `-o`",
            ));
        }
    };
    let _made = Folder::new(parent).map_err(wrong)?;
    let temporary = TemporaryFolder::new(parent).map_err(wrong)?;
    for file in files {
        temporary.write(&file.name, file.text.as_bytes()).map_err(wrong)?;
    }
    if let Ok(there) = fs::metadata(folder) {
        fs::set_permissions(temporary.path(), there.permissions()).map_err(wrong)?;
    }
    temporary.commit(folder).map_err(wrong)?;
    told("wrote")
}

/// A folder with anything in it is not written to.
fn refuse_what_is_there(place: &Place) -> Result<(), Failure> {
    let help = "a project is written once and is yours from then on: give a new folder with `-o`, \
                or emit the controller alone into this one with `--lang`";
    if let Kind::Missing = place.kind {
        return Ok(());
    }
    let shown = &place.shown;
    let mut entries =
        fs::read_dir(&place.path).map_err(|error| failed("cannot write to", shown, &error))?;
    match entries.next() {
        None => Ok(()),
        Some(Ok(entry)) => Err(Failure::because(
            format!(
                "{} is not empty: it holds {}",
                shown.display(),
                entry.file_name().to_string_lossy()
            ),
            help,
        )),
        Some(Err(error)) => Err(failed("cannot read", shown, &error)),
    }
}
