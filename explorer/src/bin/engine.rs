//! Reads one request from the standard input and writes the answer to the standard output.
//!
//! The page runs it as a WASI command: an instance for each request, so that none can harm the next.

use std::io::{self, Read, Write};

fn main() -> io::Result<()> {
    let mut request = String::new();
    io::stdin().read_to_string(&mut request)?;
    io::stdout().write_all(ptc_explorer::answer(&request).as_bytes())
}
