//! Reads a file packed by LZMA from the standard input and writes it to the standard output.
//!
//! A browser unpacks gzip by itself, which leaves the generator a third larger. The page runs this first, as a WASI
//! command too.

use std::io;
use std::process::ExitCode;

use lzma_rust2::LzmaReader;

/// The memory that a dictionary may take, in kibibytes.
const DICTIONARY: u32 = 1 << 16;

fn main() -> ExitCode {
    let unpacked = LzmaReader::new_mem_limit(io::stdin().lock(), DICTIONARY, None)
        .and_then(|mut reader| io::copy(&mut reader, &mut io::stdout().lock()));
    ExitCode::from(u8::from(unpacked.is_err()))
}
