//! Any text as a design file: what is generated for it, in every language and project, keeps it
//! inside of comments and texts, and the command line in the head has nothing that a shell reads.

#![no_main]

#[path = "../../tests/support/command.rs"]
mod command;
#[path = "../../assure/src/harness/inert.rs"]
mod inert;

use libfuzzer_sys::fuzz_target;
use ptc_codegen::diagnostic::Place;
use ptc_codegen::emit::{Language, Project};
use ptc_codegen::request::Spec;
use ptc_codegen::{design, generate, project, request};

/// Orders that are generated; the greater ones take the same steps, for longer.
const ORDERS: usize = 3;

fuzz_target!(|bytes: &[u8]| {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let (entries, found) = design::read(text, &mut |_| Place(0));
    let Ok(given) = request::read(&entries) else { return };
    if !found.is_empty() || given.n > ORDERS {
        return;
    }
    let line = given.command();
    assert_eq!(command::spec_of(&line).as_ref(), Ok(&given), "{line}");
    for language in Language::ALL {
        for file in generate(&given, language).unwrap_or_default() {
            assert_eq!(inert::breach(&file), None);
        }
    }
    let plain = Spec { name: Some("plain_design".to_owned()), ..given.clone() };
    for kind in Project::ALL {
        let (Ok(own), Ok(plain)) = (project(&given, kind), project(&plain, kind)) else { continue };
        for (own, plain) in own.iter().zip(&plain) {
            assert_eq!(inert::breach(own), None);
            if inert::is_of_a_tool(own) {
                assert_eq!(*own, inert::renamed(plain, "plain_design", &given.name()));
            }
        }
    }
});
