//! Content of a file whose size is not known: it is written as it is made, and takes its place in the end.

use std::fs::File;
use std::io::{self, BufReader, Read, Seek, Write};
use std::path::Path;

use super::beside::open_beside;
use super::durable::nameless;
use super::place::{Kind, Place};
use super::temporary::Temporary;

/// Bytes that are kept in memory of what goes through a stream.
const IN_MEMORY: usize = 1 << 20;

/// Content under way.
pub(crate) enum Spool {
    /// A file beside the one that it will become.
    Beside(Temporary),
    /// The beginning of what goes to a stream.
    Memory(Vec<u8>),
    /// A long content that goes to a stream.
    Nameless(File),
}

impl Spool {
    /// Nothing as yet, of what goes to `place`.
    pub(crate) fn new(place: &Place) -> io::Result<Self> {
        match place.kind {
            Kind::Missing | Kind::Regular(_) => open_beside(place).map(Self::Beside),
            _ => Ok(Self::Memory(Vec::new())),
        }
    }

    /// Reads it from its beginning.
    pub(super) fn reader(&mut self) -> io::Result<Box<dyn Read + '_>> {
        Ok(match self {
            Self::Memory(kept) => Box::new(kept.as_slice()),
            Self::Nameless(file) => Box::new(rewound(file)?),
            Self::Beside(temporary) => Box::new(rewound(temporary.file()?)?),
        })
    }

    /// Returns true if the file at `path` has the same bytes.
    pub(super) fn equals(&mut self, path: &Path) -> io::Result<bool> {
        let mut own = self.reader()?;
        let mut there = BufReader::new(File::open(path)?);
        let [mut own_part, mut there_part] = [[0; 1 << 16]; 2];
        loop {
            let count = read_full(&mut own, &mut own_part)?;
            let other = read_full(&mut there, &mut there_part)?;
            if own_part[..count] != there_part[..other] {
                return Ok(false);
            }
            if count < own_part.len() {
                return Ok(true);
            }
        }
    }
}

impl Write for Spool {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if let Self::Memory(kept) = self {
            if kept.len() + bytes.len() <= IN_MEMORY {
                return kept.write(bytes);
            }
            let mut file = nameless()?;
            file.write_all(kept)?;
            *self = Self::Nameless(file);
        }
        match self {
            Self::Beside(temporary) => temporary.file()?.write(bytes),
            Self::Memory(kept) => kept.write(bytes),
            Self::Nameless(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn rewound(mut file: &File) -> io::Result<&File> {
    file.rewind().map(|()| file)
}

/// Fills `part`, or as much of it as there is.
fn read_full(from: &mut dyn Read, part: &mut [u8]) -> io::Result<usize> {
    let mut count = 0;
    while count < part.len() {
        match from.read(&mut part[count..])? {
            0 => break,
            more => count += more,
        }
    }
    Ok(count)
}
