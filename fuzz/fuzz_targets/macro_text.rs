//! Any Rust tokens between the parentheses of the macro. The macro's crate exports nothing but the
//! macro, so its reader is compiled here as a module.

#![no_main]
#![allow(dead_code)]

#[path = "../../ptc-macros/src/design.rs"]
mod design;
#[path = "../../ptc-macros/src/errors.rs"]
mod errors;
#[path = "../../ptc-macros/src/input.rs"]
mod input;

use libfuzzer_sys::fuzz_target;
use proc_macro2::TokenStream;
use ptc_codegen::request;

fuzz_target!(|bytes: &[u8]| {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let Ok(tokens) = text.parse::<TokenStream>() else { return };
    let input = input::read(tokens);
    // No file is to be read on the word of a random text.
    let found = request::read(&input.entries).err().unwrap_or_default();
    if !found.is_empty() || !input.wrong.is_empty() {
        assert!(!errors::tokens(&input, found).is_empty());
    }
});
