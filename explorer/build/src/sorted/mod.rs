//! A module of WebAssembly, its bytes sorted by what they are.
//!
//! Instructions differ in length, so a packer that sees opcodes, indices and addresses in turn finds less that repeats
//! than one that sees all opcodes, then all indices: the generator is a twelfth shorter. `page/restore.js` restores it.

mod instruction;

use instruction::{Stream, function};

/// Section of the functions.
const CODE: u8 = 10;

/// Sorts the bytes of a module into streams, behind the length of each; `None` if it has an instruction that is not known.
pub(crate) fn sorted(module: &[u8]) -> Option<Vec<u8>> {
    let mut sorter = Sorter { module: module.iter(), streams: Default::default() };
    sections(&mut sorter)?;
    let mut all = Vec::new();
    for stream in &sorter.streams {
        all.extend(u32::try_from(stream.len()).ok()?.to_le_bytes());
    }
    sorter.streams.iter().for_each(|stream| all.extend(stream));
    Some(all)
}

/// Visits a module from its magic number to its last section.
fn sections(visit: &mut Sorter<'_>) -> Option<()> {
    for _ in 0..8 {
        visit.byte(Stream::Outside)?;
    }
    while let Some(section) = visit.byte(Stream::Outside) {
        let size = visit.number(Stream::Outside)?;
        if section == CODE {
            for _ in 0..visit.number(Stream::Outside)? {
                visit.size()?;
                function(visit)?;
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

impl Sorter<'_> {
    /// The next byte of the module, which the stream gets changed by an exclusive or; `None` at the end.
    fn changed(&mut self, stream: Stream, by: u8) -> Option<u8> {
        let byte = *self.module.next()?;
        self.streams[stream as usize].push(byte ^ by);
        Some(byte)
    }

    /// The next byte.
    fn byte(&mut self, stream: Stream) -> Option<u8> {
        self.changed(stream, 0)
    }

    /// The next number, in groups of seven bits.
    fn number(&mut self, stream: Stream) -> Option<u64> {
        let (mut number, mut shift) = (0, 0);
        loop {
            let byte = self.byte(stream)?;
            number |= u64::from(byte & 0x7f).checked_shl(shift)?;
            shift += 7;
            if byte & 0x80 == 0 {
                return Some(number);
            }
        }
    }

    /// Passes over the size of a function, which follows from its instructions.
    fn size(&mut self) -> Option<()> {
        while self.module.next()? & 0x80 != 0 {}
        Some(())
    }
}

#[cfg(test)]
mod tests;
