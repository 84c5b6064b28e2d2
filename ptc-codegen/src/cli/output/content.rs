//! Content that a command writes to a place.

use std::fs::Metadata;
use std::io::{self, Read};
use std::path::Path;

use super::beside::{holds, open_beside};
use super::place::Place;
#[cfg(feature = "lab")]
use super::spool::Spool;
use super::temporary::Temporary;

/// Content of a file, or of what is printed.
pub(crate) enum Content<'a> {
    Bytes(&'a [u8]),
    #[cfg(feature = "lab")]
    Spooled(Spool),
}

impl Content<'_> {
    /// Reads it from its beginning.
    pub(super) fn reader(&mut self) -> io::Result<Box<dyn Read + '_>> {
        match self {
            Self::Bytes(bytes) => Ok(Box::new(*bytes)),
            #[cfg(feature = "lab")]
            Self::Spooled(spool) => spool.reader(),
        }
    }

    /// Returns true if the regular file at `path` holds it.
    pub(super) fn is_in(&mut self, path: &Path, there: &Metadata) -> bool {
        match self {
            Self::Bytes(bytes) => holds(path, there, bytes),
            #[cfg(feature = "lab")]
            Self::Spooled(spool) => spool.equals(path).is_ok_and(|equals| equals),
        }
    }

    /// Moves it to a file beside the place where it goes.
    pub(super) fn beside(mut self, place: &Place) -> io::Result<Temporary> {
        #[cfg(feature = "lab")]
        if let Self::Spooled(Spool::Beside(temporary)) = self {
            return Ok(temporary);
        }
        let temporary = open_beside(place)?;
        io::copy(&mut self.reader()?, &mut temporary.file()?)?;
        Ok(temporary)
    }
}
