//! Reads a module, packed by LZMA with its bytes sorted, from the standard input and writes it to the standard output.
//!
//! A browser unpacks gzip by itself, which leaves the generator a third larger. The page runs this first, as a WASI
//! command too.

use std::io::{self, Read, Write};
use std::process::ExitCode;

use lzma_rust2::LzmaReader;

/// The memory that a dictionary may take, in kibibytes.
const DICTIONARY: u32 = 1 << 16;

fn main() -> ExitCode {
    let written = unpacked().and_then(|module| io::stdout().write_all(&module).ok());
    ExitCode::from(u8::from(written.is_none()))
}

fn unpacked() -> Option<Vec<u8>> {
    let mut packed = Vec::new();
    io::stdin().read_to_end(&mut packed).ok()?;
    let mut sorted = Vec::new();
    let mut reader = LzmaReader::new_mem_limit(packed.as_slice(), DICTIONARY, None).ok()?;
    reader.read_to_end(&mut sorted).ok()?;
    ptc_explorer_unpack::restored(&sorted)
}
