//! Writing to the standard output, and the error for a file that cannot be written.

use std::io::{self, ErrorKind, Write};
use std::path::Path;

use crate::diagnostic::visible_line;

use super::report::Failure;

/// Prints `text`. A reader that has gone away, such as `head`, has got what it wanted.
pub(crate) fn to_stdout(text: &(impl AsRef<[u8]> + ?Sized)) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_ref()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(unprinted(&error)),
        _ => Ok(()),
    }
}

/// The message of an error of the standard output.
pub(crate) fn unprinted(error: &io::Error) -> Failure {
    Failure::because(
        format!("cannot write the standard output: {error}"),
        "direct it to a file or a pipe that takes it",
    )
}

/// A path on a line of the standard output, where the terminal would take its control characters.
pub(crate) fn shown(path: &Path) -> String {
    visible_line(&path.display().to_string())
}

/// The message of an error of the file system.
pub(crate) fn failed(what: &str, path: &Path, error: &io::Error) -> Failure {
    Failure::because(
        format!("{what} {}: {error}", path.display()),
        "give a folder that can be written with `-o`, or `-o -` for the standard output",
    )
}
