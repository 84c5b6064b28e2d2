//! Kind of file at the end of a path, found without opening it.

use std::ffi::OsStr;
use std::fs::{self, Metadata};
use std::io::{self, ErrorKind};
use std::path::{Component, Path, PathBuf};

/// Most links that are followed, as many as Linux follows.
const MAX_LINKS: usize = 40;

/// A path, and what is there.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    /// As the user wrote it.
    pub(crate) shown: PathBuf,
    /// The same without links, `.` and `..`.
    pub(crate) path: PathBuf,
    pub(crate) kind: Kind,
}

/// Kind of file at a path.
#[derive(Clone, Debug)]
pub(crate) enum Kind {
    Missing,
    /// A regular file.
    Regular(Metadata),
    Folder,
    /// A terminal, `/dev/null` and the like.
    Device,
    Fifo,
    /// A descriptor of a process, by a path such as `/dev/fd/3`.
    Descriptor,
    StandardOutput,
    /// A kind that takes no output, by its name.
    Other(&'static str),
}

impl Place {
    /// Looks up the file at `path`.
    ///
    /// # Errors
    /// It cannot be looked up.
    pub(crate) fn of(shown: &Path) -> io::Result<Self> {
        let shown = shown.to_owned();
        if shown.as_os_str() == "-" {
            return Ok(Self { path: shown.clone(), shown, kind: Kind::StandardOutput });
        }
        let path = resolved(&shown)?;
        let kind = match (descriptor(&path), path.symlink_metadata()) {
            (Some(true), _) => Kind::StandardOutput,
            (Some(false), Ok(_)) => Kind::Descriptor,
            (_, Ok(metadata)) => kind(metadata),
            (_, Err(error)) if error.kind() == ErrorKind::NotFound => Kind::Missing,
            (_, Err(error)) => return Err(error),
        };
        Ok(Self { shown, path, kind })
    }

    /// Returns true if it is printed.
    pub(crate) fn is_standard_output(&self) -> bool {
        matches!(self.kind, Kind::StandardOutput)
    }

    /// Returns true if it is written through: no existing file can be replaced.
    pub(crate) fn is_stream(&self) -> bool {
        use Kind::{Descriptor, Device, Fifo, StandardOutput};
        matches!(self.kind, Device | Fifo | Descriptor | StandardOutput)
    }

    /// Returns true if output to one replaces, or mixes with, the contents of the other.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        match (&self.kind, &other.kind) {
            (Kind::StandardOutput, Kind::StandardOutput) => true,
            // Any number of outputs may go to `/dev/null` or to a terminal.
            (Kind::Device, Kind::Device) => false,
            (Kind::Regular(one), Kind::Regular(two)) if same_file(one, two) => true,
            _ => folded(&self.path) == folded(&other.path),
        }
    }

    /// Returns true if one of the two would have to be a folder that holds the other.
    pub(crate) fn is_within(&self, other: &Self) -> bool {
        let (one, two) = (folded(&self.path), folded(&other.path));
        let file = |place: &Self| matches!(place.kind, Kind::Missing | Kind::Regular(_));
        file(self) && file(other) && one != two && (one.starts_with(&two) || two.starts_with(&one))
    }

    /// The nearest folder that is there, in which it is or will be made.
    pub(crate) fn home(&self) -> &Path {
        self.path.ancestors().skip(1).find(|folder| folder.exists()).unwrap_or(&self.path)
    }
}

/// Returns true if two files are the same, under whatever names.
#[cfg(unix)]
pub(crate) fn same_file(one: &Metadata, two: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    (one.dev(), one.ino()) == (two.dev(), two.ino())
}

/// Elsewhere a file is known by its path alone.
#[cfg(not(unix))]
pub(crate) fn same_file(_: &Metadata, _: &Metadata) -> bool {
    false
}

/// A path as its file system compares it.
fn folded(path: &Path) -> PathBuf {
    match path.to_str() {
        Some(text) if cfg!(any(windows, target_os = "macos")) => text.to_lowercase().into(),
        _ => path.to_owned(),
    }
}

/// The path without links, also where its end, or folders before it, are not there yet.
fn resolved(path: &Path) -> io::Result<PathBuf> {
    let mut path = std::path::absolute(path)?;
    for _ in 0..MAX_LINKS {
        let Some(name) = path.file_name() else { return real(&path) };
        let here = real(path.parent().unwrap_or(&path))?.join(name);
        if descriptor(&here).is_some() {
            return Ok(here);
        }
        match fs::read_link(&here) {
            Ok(link) => path = here.parent().unwrap_or(&here).join(link),
            // It is no link.
            Err(_) => return Ok(here),
        }
    }
    Err(io::Error::other("too many symbolic links"))
}

/// A folder without links, whose end need not be there.
fn real(folder: &Path) -> io::Result<PathBuf> {
    match folder.canonicalize() {
        Err(error) if error.kind() == ErrorKind::NotFound => {}
        found => return found,
    }
    let Some(parent) = folder.parent() else { return Ok(folder.to_owned()) };
    let parent = real(parent)?;
    Ok(match folder.components().next_back() {
        Some(Component::Normal(name)) => parent.join(name),
        Some(Component::ParentDir) => parent.parent().unwrap_or(&parent).to_owned(),
        _ => parent,
    })
}

/// Tests whether a path without links in its folder names a descriptor of a process; if so, returns true for the
/// standard output of this one.
fn descriptor(path: &Path) -> Option<bool> {
    let own = ["/proc/self/fd", "/dev/fd"];
    let folder = path.parent()?;
    let is_own = own.iter().any(|own| {
        folder == Path::new(own) || fs::canonicalize(own).is_ok_and(|own| folder == own)
    });
    let of_process = folder.starts_with("/proc") && folder.file_name() == Some(OsStr::new("fd"));
    (cfg!(unix) && (is_own || of_process))
        .then(|| is_own && path.file_name() == Some(OsStr::new("1")))
}

fn kind(metadata: Metadata) -> Kind {
    let what = metadata.file_type();
    if what.is_dir() {
        return Kind::Folder;
    }
    if what.is_file() {
        return Kind::Regular(metadata);
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        if what.is_char_device() {
            return Kind::Device;
        }
        if what.is_fifo() {
            return Kind::Fifo;
        }
        if what.is_socket() {
            return Kind::Other("a socket");
        }
        if what.is_block_device() {
            return Kind::Other("a disk");
        }
    }
    Kind::Other("no regular file")
}
