//! Any text as the value of each key that takes an expression: it is read or refused, and what is
//! read has a spelling that reads back as the same.

#![no_main]

#[path = "../../tests/support/command.rs"]
mod command;

use libfuzzer_sys::fuzz_target;
use ptc_codegen::diagnostic::Place;
use ptc_codegen::request::{Entry, read};
use ptc_codegen::syntax::{Node, parse};

fn node(key: &str, text: &str) -> Node {
    parse(key, text, &mut |_| Place(0)).expect("a legal value")
}

fuzz_target!(|bytes: &[u8]| {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    for key in ["mu", "kappa", "pi0", "g", "poles", "x_max"] {
        let mut inside = true;
        let mut place = |range: std::ops::Range<usize>| {
            inside &= text.get(range).is_some();
            Place(0)
        };
        let value = parse(key, text, &mut place);
        assert!(inside, "a place outside of the text");
        let Ok(value) = value else { return };
        let entry = |key: &str, value| Entry { key: key.to_owned(), place: Place(0), value };
        let mut entries = vec![entry("n", node("n", "3")), entry(key, value)];
        if !["mu", "kappa"].contains(&key) {
            entries.push(entry("mu", node("mu", "power")));
        }
        match read(&entries) {
            Ok(spec) => {
                let line = spec.command();
                assert_eq!(command::spec_of(&line).as_ref(), Ok(&spec), "{line}");
            }
            Err(found) => assert!(!found.is_empty()),
        }
    }
});
