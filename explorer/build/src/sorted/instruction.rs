//! Instructions of a function, and which of their bytes belong together.

use super::Sorter;

/// Kinds of the bytes of a module, in the order in which `page/restore.js` reads them.
#[derive(Clone, Copy, Debug)]
pub(super) enum Stream {
    /// Part of no function.
    Outside,
    Opcode,
    Block,
    Branch,
    Call,
    /// Index of a local that is read.
    Get,
    /// Index of a local that is written.
    Set,
    /// Alignment, less the one that the instruction has by default.
    Align,
    /// Offset of a load.
    Load,
    /// Offset of a store.
    Store,
    Int32,
    Int64,
    Float,
    Other,
}

impl Stream {
    pub(super) const COUNT: usize = Self::Other as usize + 1;
}

/// Visits a function: its locals, and its instructions up to the end of its block.
pub(super) fn function(visit: &mut Sorter<'_>) -> Option<()> {
    for _ in 0..visit.number(Stream::Other)? {
        visit.number(Stream::Other)?;
        visit.byte(Stream::Other)?;
    }
    let mut depth = 1_u32;
    while depth > 0 {
        match visit.byte(Stream::Opcode)? {
            0x02..=0x04 => {
                visit.number(Stream::Block)?;
                depth += 1;
            }
            0x0b => depth -= 1,
            opcode => operands(visit, opcode)?,
        }
    }
    Some(())
}

/// Visits what follows an opcode.
fn operands(visit: &mut Sorter<'_>, opcode: u8) -> Option<()> {
    let (stream, count) = match opcode {
        0x00 | 0x01 | 0x05 | 0x0f | 0x1a | 0x1b | 0x45..=0xc4 => return Some(()),
        0x0c | 0x0d => (Stream::Branch, 1),
        0x0e => (Stream::Branch, visit.number(Stream::Branch)? + 1),
        0x10 => (Stream::Call, 1),
        0x11 => (Stream::Other, 2),
        0x20 => (Stream::Get, 1),
        0x21 | 0x22 => (Stream::Set, 1),
        0x23..=0x26 | 0x3f | 0x40 | 0xd0 | 0xd2 => (Stream::Other, 1),
        0x28..=0x3e => {
            visit.changed(Stream::Align, alignment(opcode))?;
            (if opcode < 0x36 { Stream::Load } else { Stream::Store }, 1)
        }
        0x41 => (Stream::Int32, 1),
        0x42 => (Stream::Int64, 1),
        0x43 | 0x44 => {
            for _ in 0..if opcode == 0x43 { 4 } else { 8 } {
                visit.byte(Stream::Float)?;
            }
            return Some(());
        }
        0xfc => match visit.number(Stream::Other)? {
            0..=7 => return Some(()),
            9 | 11 | 13 | 15..=17 => (Stream::Other, 1),
            8 | 10 | 12 | 14 => (Stream::Other, 2),
            _ => return None,
        },
        _ => return None,
    };
    for _ in 0..count {
        visit.number(stream)?;
    }
    Some(())
}

/// The alignment of a load or a store by default, as a power of two.
fn alignment(opcode: u8) -> u8 {
    match opcode {
        0x29 | 0x2b | 0x37 | 0x39 => 3,
        0x28 | 0x2a | 0x34..=0x36 | 0x38 | 0x3e => 2,
        0x2e | 0x2f | 0x32 | 0x33 | 0x3b | 0x3d => 1,
        _ => 0,
    }
}
