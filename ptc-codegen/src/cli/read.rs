//! Reading files of users, never more of them than they can sensibly hold.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use super::report::Failure;

/// The text of a file of at most `most` bytes.
pub(crate) fn text(path: &Path, most: u64) -> Result<String, Failure> {
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(most + 1).read_to_end(&mut bytes));
    let error = match read {
        Err(error) => error,
        Ok(read) if read as u64 > most => {
            io::Error::new(ErrorKind::FileTooLarge, format!("it is larger than {most} bytes"))
        }
        Ok(_) => match String::from_utf8(bytes) {
            Ok(text) => return Ok(text),
            Err(error) => io::Error::new(ErrorKind::InvalidData, error.utf8_error()),
        },
    };
    let title = format!("cannot read {}: {error}", path.display());
    Err(Failure::because(title, "give a text file that can be read"))
}

/// The first `most` bytes of a regular file.
pub(crate) fn start(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let what = fs::metadata(path)?;
    if !what.is_file() {
        return Err(match what.is_dir() {
            true => ErrorKind::IsADirectory.into(),
            false => io::Error::other("it is not a regular file"),
        });
    }
    let mut bytes = Vec::new();
    File::open(path)?.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
}
