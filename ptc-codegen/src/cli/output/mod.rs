//! Files that a command writes: planned and checked before its work, written at its end.
//!
//! A regular file is replaced as a whole and keeps its mode; a link, a device or a FIFO is written
//! through; `-` is the standard output.

mod beside;
mod content;
mod durable;
mod place;
mod signals;
#[cfg(feature = "lab")]
mod spool;
mod stale;
mod temporary;

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read, Write};
use std::path::Path;

pub(crate) use beside::holds;
#[cfg(feature = "lab")]
pub(crate) use beside::open_beside;
pub(crate) use content::Content;
#[cfg(feature = "lab")]
pub(crate) use durable::{nameless, sync_folder};
#[cfg(feature = "lab")]
pub(crate) use place::same_file;
pub(crate) use place::{Kind, Place};
#[cfg(feature = "lab")]
pub(crate) use signals::Interruption;
#[cfg(feature = "lab")]
pub(crate) use spool::Spool;
#[cfg(feature = "lab")]
pub(crate) use temporary::watch;
pub(crate) use temporary::{Folder, TemporaryFolder, commit};

use super::report::Failure;
#[cfg(feature = "lab")]
use super::write::to_stdout;
use super::write::{failed, shown, unprinted};

/// The files that a command reads and writes, each by the flag that names it.
#[derive(Default)]
pub(crate) struct Outputs {
    inputs: Vec<(String, Place)>,
    outputs: Vec<(String, Place)>,
}

impl Outputs {
    /// Notes a file that the command reads. Whoever reads it says what is wrong with it.
    pub(crate) fn reads(&mut self, name: &str, path: &Path) {
        if let Ok(mut place) = Place::of(path) {
            // A shell may have opened a file as the standard input.
            if let (Kind::Descriptor, Ok(there)) = (&place.kind, fs::metadata(path))
                && there.is_file()
            {
                place.kind = Kind::Regular(there);
            }
            self.inputs.push((name.to_owned(), place));
        }
    }

    /// Plans a file, if a flag gives one.
    #[cfg(feature = "lab")]
    pub(crate) fn optional(
        &mut self,
        name: &str,
        path: Option<&Path>,
    ) -> Result<Option<Place>, Failure> {
        path.map(|path| self.file(name, path)).transpose()
    }

    /// Plans a file.
    ///
    /// # Errors
    /// It cannot be written, is read by the command, or another output goes there.
    pub(crate) fn file(&mut self, name: &str, path: &Path) -> Result<Place, Failure> {
        let place = self.claim(name, path)?;
        match place.kind {
            Kind::Missing | Kind::Regular(_) => writable(name, &place)?,
            Kind::Folder => return Err(not_a_file(name, path, "a folder")),
            Kind::Other(what) => return Err(not_a_file(name, path, what)),
            _ => {}
        }
        Ok(place)
    }

    /// Plans a file that this module does not write.
    ///
    /// # Errors
    /// Another file goes there, or is there.
    #[cfg(feature = "lab")]
    pub(crate) fn reserve(&mut self, name: &str, path: &Path) -> Result<(), Failure> {
        self.claim(name, path).map(|_| ())
    }

    /// Prints the result: to the standard error if a file is written to the standard output.
    #[cfg(feature = "lab")]
    pub(crate) fn tell(&self, text: &str) -> Result<(), Failure> {
        if self.outputs.iter().any(|(_, place)| place.is_standard_output()) {
            // If it is closed, there is nowhere to report it.
            let _ = io::stderr().write_all(text.as_bytes());
            return Ok(());
        }
        to_stdout(text)
    }

    /// Plans a file that is compared first, and may need no writing.
    fn claim(&mut self, name: &str, path: &Path) -> Result<Place, Failure> {
        let place = Place::of(path).map_err(|error| unwritable(name, path, &error))?;
        let refused = |title: String, help: &str| Err(Failure::because(title, help));
        let shown = path.display();
        for (other, input) in &self.inputs {
            if place.is_same(input) {
                return refused(
                    format!("{name} {shown} is {other}, which would be replaced"),
                    "give another file to write to",
                );
            }
        }
        for (other, output) in &self.outputs {
            if place.is_same(output) {
                return refused(
                    format!("{name} {shown} and {other} are one file"),
                    "give each its own file",
                );
            }
            if place.is_within(output) {
                return refused(
                    format!("{name} {shown} and {other} are one inside the other"),
                    "a file cannot be a folder as well: give each its own file",
                );
            }
        }
        self.outputs.push((format!("{name} {shown}"), place.clone()));
        Ok(place)
    }

    /// Chooses the destination of the files of a folder: one that exists or can be made, or, for a path that is not a
    /// folder, all of them as one text.
    pub(crate) fn folder(&mut self, name: &str, path: &Path) -> Result<Place, Failure> {
        let error = |error: &io::Error| failed("cannot make the folder", path, error);
        let place = Place::of(path).map_err(|wrong| error(&wrong))?;
        let home = || place.home().is_dir();
        match place.kind {
            Kind::Folder => {}
            Kind::Missing if home() => {}
            _ if place.is_stream() => self.outputs.push((name.to_owned(), place.clone())),
            _ => return Err(error(&ErrorKind::NotADirectory.into())),
        }
        Ok(place)
    }

    /// Writes files into a folder of [`Self::folder`], each by its name, and returns one line a file.
    /// All are written in full beside the old ones before the first takes its place.
    pub(crate) fn write_in<T: AsRef<[u8]>>(
        &mut self,
        folder: &Path,
        files: &[(&str, T)],
    ) -> Result<String, Failure> {
        let mut all = Vec::new();
        for (name, content) in files {
            all.push((self.claim("the output", &folder.join(name))?, content.as_ref()));
        }
        let _made = Folder::new(folder)
            .map_err(|error| failed("cannot make the folder", folder, &error))?;
        write(&all)
    }
}

/// Writes files to their places and returns one line a file.
pub(crate) fn write(files: &[(Place, &[u8])]) -> Result<String, Failure> {
    let all = files.iter().map(|(place, bytes)| (place.clone(), Content::Bytes(bytes)));
    write_all(all.collect())
}

/// Writes contents to their places and returns one line a file; what is printed has none. What is
/// there now counts, which may not be what was there when the place was planned.
pub(crate) fn write_all(files: Vec<(Place, Content<'_>)>) -> Result<String, Failure> {
    let mut told = String::new();
    let mut streams = Vec::new();
    let mut pending = Vec::new();
    for (planned, mut content) in files {
        let wrong = |error: &io::Error| failed("cannot write", &planned.shown, error);
        let place = Place::of(&planned.shown).map_err(|error| wrong(&error))?;
        let mut line = |word: &str| told.push_str(&format!("{word} {}\n", shown(&place.shown)));
        match &place.kind {
            Kind::StandardOutput => streams.push((place, content)),
            Kind::Device | Kind::Fifo | Kind::Descriptor => {
                line("wrote");
                streams.push((place, content));
            }
            // A file that keeps its time stamp is not built again.
            Kind::Regular(there) if content.is_in(&place.path, there) => line("unchanged"),
            Kind::Missing | Kind::Regular(_) => {
                line("wrote");
                let beside = content.beside(&place).map_err(|error| wrong(&error))?;
                pending.push((beside, place.path));
            }
            Kind::Folder => return Err(wrong(&ErrorKind::IsADirectory.into())),
            Kind::Other(what) => return Err(wrong(&io::Error::other(format!("it is {what}")))),
        }
    }
    for (place, mut content) in streams {
        let copied = content.reader().and_then(|mut reader| through(&place, &mut reader));
        copied.map_err(|error| match place.is_standard_output() {
            true => unprinted(&error),
            false => failed("cannot write", &place.shown, &error),
        })?;
    }
    commit(pending).map_err(|(path, error)| failed("cannot write", &path, &error))?;
    Ok(told)
}

/// Copies `content` through a device, a FIFO or a descriptor.
pub(crate) fn through(place: &Place, content: &mut dyn Read) -> io::Result<()> {
    let append = matches!(place.kind, Kind::Descriptor);
    let copied = if place.is_standard_output() {
        let mut stdout = io::stdout().lock();
        io::copy(content, &mut stdout).and_then(|count| stdout.flush().map(|()| count))
    } else {
        let file = File::options().write(true).append(append).open(&place.shown);
        file.and_then(|mut file| io::copy(content, &mut file))
    };
    match copied {
        // A reader that has gone away has got what it wanted.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        copied => copied.map(|_| ()),
    }
}

/// Finds before the work what would fail after it.
fn writable(name: &str, place: &Place) -> Result<(), Failure> {
    let wrong = |error: &io::Error| unwritable(name, &place.shown, error);
    match &place.kind {
        Kind::Regular(there) if there.permissions().readonly() => {
            return Err(wrong(&io::Error::new(ErrorKind::PermissionDenied, "it is read-only")));
        }
        _ => {}
    }
    let home = place.home();
    // A file without a name shows what no mode does: a file system that is read-only, a quota.
    match tempfile::tempfile_in(home) {
        Ok(_) => Ok(()),
        Err(error) => Err(wrong(&io::Error::new(
            error.kind(),
            format!("the folder {} cannot be written: {error}", home.display()),
        ))),
    }
}

fn not_a_file(name: &str, path: &Path, what: &str) -> Failure {
    Failure::because(
        format!("{name} {} is {what}", path.display()),
        "give the name of a file, or `-` for the standard output",
    )
}

fn unwritable(name: &str, path: &Path, error: &io::Error) -> Failure {
    Failure::because(
        format!("cannot write {name} {}: {error}", path.display()),
        "give a file in a folder that can be written",
    )
}

/// The path of a file beside another, whose name has `suffix` after it.
#[cfg(feature = "lab")]
pub(crate) fn with_suffix(path: &Path, suffix: &str) -> std::path::PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(suffix);
    path.with_file_name(name)
}
