//! Any words on the command line: the parser of the flags refuses them, or the command runs or says
//! what is wrong. Each line of the input is a word. Nothing is read from a file or written to one.

#![no_main]
#![allow(dead_code)]

#[path = "../../ptc-codegen/src/cli/mod.rs"]
mod cli;

use clap::Parser;
use cli::args::{Command, CommandLine};
use libfuzzer_sys::fuzz_target;

/// Orders that are run; the greater ones take the same steps, for longer.
const ORDERS: usize = 4;

fuzz_target!(|bytes: &[u8]| {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let words = std::iter::once("ptc-codegen").chain(text.lines());
    let Ok(mut line) = CommandLine::try_parse_from(words) else { return };
    let (design, spec) = match &mut line.command {
        Command::Emit(request) => {
            request.out = Some("-".into());
            request.check = false;
            request.cost = None;
            // Its long arithmetic takes seconds.
            request.selftest = false;
            (&request.design.design, &request.spec.0)
        }
        Command::Check(request) => (&request.design.design, &request.spec.0),
        _ => return,
    };
    let small = spec.parse().read().is_ok_and(|spec| spec.n <= ORDERS);
    if design.is_none() && small {
        // A refusal is an answer too; the matter is that there is one.
        let _ = cli::execute(line.command);
    }
});
