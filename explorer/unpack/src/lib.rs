//! A module of WebAssembly, its bytes sorted by what they are.
//!
//! Instructions differ in length, so a packer that sees opcodes, indices and addresses in turn finds less that repeats
//! than one that sees all opcodes, then all indices: the generator is a thirteenth shorter. [`sorted`] is for what builds the
//! page, [`restored`] for the page.

mod instruction;

use instruction::{Stream, Visit, function};

/// Section of the functions.
const CODE: u8 = 10;

/// Sorts the bytes of a module; `None` if it has an instruction that is not known.
pub fn sorted(module: &[u8]) -> Option<Vec<u8>> {
    let mut sorter = Sorter { module: module.iter(), streams: Default::default() };
    sections(&mut sorter)?;
    let mut all = Vec::new();
    for stream in &sorter.streams {
        all.extend(u32::try_from(stream.len()).ok()?.to_le_bytes());
    }
    sorter.streams.iter().for_each(|stream| all.extend(stream));
    Some(all)
}

/// Restores a module from its sorted bytes; `None` if they are none.
pub fn restored(sorted: &[u8]) -> Option<Vec<u8>> {
    let (head, mut rest) = sorted.split_at_checked(4 * Stream::COUNT)?;
    let mut streams: [&[u8]; Stream::COUNT] = Default::default();
    for (stream, length) in streams.iter_mut().zip(head.chunks_exact(4)) {
        let length = u32::from_le_bytes(length.try_into().ok()?);
        (*stream, rest) = rest.split_at_checked(length.try_into().ok()?)?;
    }
    let mut restorer = Restorer { streams, module: Vec::new(), start: None };
    sections(&mut restorer)?;
    Some(restorer.module)
}

/// Visits a module from its magic number to its last section.
fn sections(visit: &mut impl Visit) -> Option<()> {
    for _ in 0..8 {
        visit.byte(Stream::Outside)?;
    }
    while let Some(section) = visit.byte(Stream::Outside) {
        let size = visit.number(Stream::Outside)?;
        if section == CODE {
            for _ in 0..visit.number(Stream::Outside)? {
                visit.open()?;
                function(visit)?;
                visit.close()?;
            }
        } else {
            for _ in 0..size {
                visit.byte(Stream::Outside)?;
            }
        }
    }
    Some(())
}

/// Takes a module apart.
struct Sorter<'a> {
    module: std::slice::Iter<'a, u8>,
    streams: [Vec<u8>; Stream::COUNT],
}

impl Visit for Sorter<'_> {
    fn changed(&mut self, stream: Stream, by: u8) -> Option<u8> {
        let byte = *self.module.next()?;
        self.streams[stream as usize].push(byte ^ by);
        Some(byte)
    }

    fn open(&mut self) -> Option<()> {
        // The size of a function follows from its instructions.
        while self.module.next()? & 0x80 != 0 {}
        Some(())
    }

    fn close(&mut self) -> Option<()> {
        Some(())
    }
}

/// Puts a module together.
struct Restorer<'a> {
    streams: [&'a [u8]; Stream::COUNT],
    module: Vec<u8>,
    /// Where the function that is visited starts.
    start: Option<usize>,
}

impl Visit for Restorer<'_> {
    fn changed(&mut self, stream: Stream, by: u8) -> Option<u8> {
        let (byte, rest) = self.streams[stream as usize].split_first()?;
        self.streams[stream as usize] = rest;
        self.module.push(byte ^ by);
        Some(byte ^ by)
    }

    fn open(&mut self) -> Option<()> {
        self.start = Some(self.module.len());
        Some(())
    }

    fn close(&mut self) -> Option<()> {
        let start = self.start.take()?;
        let mut size = self.module.len() - start;
        let mut number = Vec::new();
        while size >= 0x80 {
            number.push(u8::try_from(size & 0x7f).ok()? | 0x80);
            size >>= 7;
        }
        number.push(u8::try_from(size).ok()?);
        self.module.splice(start..start, number);
        Some(())
    }
}

#[cfg(test)]
mod tests;
