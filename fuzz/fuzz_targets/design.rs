//! Any text as a design file: it is refused, or it is generated, twice with the same bytes, and the
//! command line in the head of the file gives the same design.

#![no_main]

#[path = "../../tests/support/command.rs"]
mod command;

use libfuzzer_sys::fuzz_target;
use ptc_codegen::check::examine::examine;
use ptc_codegen::diagnostic::Place;
use ptc_codegen::emit::Language;
use ptc_codegen::{design, generate, request};

/// Orders that are generated; the greater ones take the same steps, for longer.
const ORDERS: usize = 4;

fuzz_target!(|bytes: &[u8]| {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let mut inside = true;
    let (entries, found) = design::read(text, &mut |range| {
        inside &= text.get(range).is_some();
        Place(0)
    });
    assert!(inside, "a place outside of the text");
    let Ok(given) = request::read(&entries) else { return };
    if !found.is_empty() || given.n > ORDERS {
        return;
    }
    let report = examine(&given);
    for spec in [&given, &report.spec] {
        let line = spec.command();
        assert_eq!(command::spec_of(&line).as_ref(), Ok(spec), "{line}");
    }
    let refused = report.refusals().next().is_some();
    let c = generate(&given, Language::C);
    assert!(!(refused && c.is_ok()), "a design that a check refuses is generated");
    if let Ok(files) = c {
        assert_eq!(generate(&given, Language::C), Ok(files));
        assert!(generate(&given, Language::Rust).is_ok());
    }
});
