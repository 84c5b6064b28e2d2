//! A file beside the one that it will replace, and whether it has to.

use std::fs::{File, Metadata};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use super::place::{Kind, Place};
use super::temporary::Temporary;

/// An empty file beside the place where it goes, in a folder that is made if it is missing, with the
/// owner and the mode of the file that it will replace.
pub(crate) fn open_beside(place: &Place) -> io::Result<Temporary> {
    let folder = place.path.parent().unwrap_or(&place.path);
    let temporary = Temporary::new(folder)?;
    if let Kind::Regular(there) = &place.kind {
        if there.permissions().readonly() {
            return Err(io::Error::new(ErrorKind::PermissionDenied, "it is read-only"));
        }
        let file = temporary.file()?;
        keep_owner(file, there);
        file.set_permissions(there.permissions())?;
    }
    Ok(temporary)
}

/// Gives `file` the owner and the group of what is there, as far as this process may.
#[cfg(unix)]
fn keep_owner(file: &File, there: &Metadata) {
    use std::os::unix::fs::{MetadataExt, fchown};
    let (owner, group) = (Some(there.uid()), Some(there.gid()));
    let _ = fchown(file, owner, group).or_else(|_| fchown(file, None, group));
}

#[cfg(not(unix))]
fn keep_owner(_: &File, _: &Metadata) {}

/// Returns true if the regular file at `path` is `content`. Reads no more than that takes.
pub(crate) fn holds(path: &Path, there: &Metadata, content: &[u8]) -> bool {
    let length = content.len() as u64;
    if there.len() != length {
        return false;
    }
    let mut read = Vec::with_capacity(content.len());
    let file = File::open(path);
    file.and_then(|file| file.take(length + 1).read_to_end(&mut read)).is_ok() && read == content
}
