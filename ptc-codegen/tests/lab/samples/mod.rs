//! The controller in samples against reference values of 50 digits, and in the loop with the exact
//! chain. What runs is the program that is emitted, in its own arithmetic.

mod calls;
mod feasible;
mod filter;
mod filter_in_c;
mod flight;
mod flight_axes;
mod flight_axes_in_c;
mod flight_in_c;
mod followed;
mod least_energy;
mod predicted;
mod reference;
mod refusals;
mod rest;
mod several_inputs;

use ptc_codegen::code::Code;
use ptc_codegen::diagnostic::Place;
use ptc_codegen::request::{self, Entry, Spec};
use ptc_codegen::samples;

/// Relative error of a gain in f64, a few roundings.
const GAIN: f64 = 1e-14;

fn read(keys: &[(&str, &str)]) -> Result<Spec, String> {
    let entry = |(key, text): &(&str, &str)| Entry {
        key: (*key).to_owned(),
        place: Place(0),
        value: ptc_codegen::syntax::parse(key, text, &mut |_| Place(0)).expect("a value"),
    };
    let entries: Vec<_> = keys.iter().map(entry).collect();
    request::read(&entries).map_err(|found| {
        found.iter().map(|d| format!("{}: {}; {}\n", d.key, d.message, d.help)).collect()
    })
}

/// The program of a design, with what every test leaves at the same values.
fn code(keys: &[(&str, &str)]) -> Code {
    emitted(&spec(keys))
}

/// The design itself.
fn spec(keys: &[(&str, &str)]) -> Spec {
    let mut all = vec![("mu", "exp(a=1)"), ("clock", "samples"), ("u_max", "inf")];
    let stands = |own: &str, key: &str| own == key || (own, key) == ("limits", "u_max");
    all.retain(|(key, _)| !keys.iter().any(|(own, _)| stands(own, key)));
    all.extend(keys);
    read(&all).expect("a legal design")
}

fn emitted(spec: &Spec) -> Code {
    let sampled = spec.sampled().expect("a clock in samples");
    let code = samples::controller(spec, sampled, Vec::new());
    code.check().expect("a program in order");
    code
}
