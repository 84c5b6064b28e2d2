//! The key `in_flight` with a clock in time: its function, and refusals.

use ptc_codegen::request::{self, Spec};

use crate::support::entries;

const CHAIN: &str = "n = 2\nmu = \"exp\"\npoles = [-4, -5]\n";

fn read(text: &str) -> Result<Spec, Vec<String>> {
    let told = |found: Vec<ptc_codegen::diagnostic::Diagnostic>| {
        found.iter().map(ToString::to_string).collect()
    };
    request::read(&entries(text)).map_err(told)
}

#[test]
fn key_changes_the_duration_and_the_fingerprint() {
    let spec = read(&format!("{CHAIN}in_flight = true\n")).expect("a legal design");
    assert!(spec.changes_duration());
    assert!(spec.command().contains("--in-flight"), "{}", spec.command());
    let plain = read(&format!("{CHAIN}in_flight = false\n")).expect("a legal design");
    assert!(!plain.changes_duration());
    assert_eq!(plain.fingerprint(), read(CHAIN).expect("a legal design").fingerprint());
    assert_ne!(plain.fingerprint(), spec.fingerprint());
    assert_eq!(plain, read(CHAIN).expect("a legal design"));
}

#[test]
fn fixed_tau_is_refused() {
    let text = format!("{CHAIN}in_flight = true\n[params]\ntau = 1\n");
    let found = read(&text).expect_err("a fixed tau");
    let [one] = found.as_slice() else { panic!("{found:?}") };
    assert!(one.contains("`in_flight` = true beside a tau that is fixed in the code"), "{one}");
    assert!(one.contains("leave `tau` out"), "{one}");
    // A run has a value of it.
    let spec = request::read_run(&entries(&text)).expect("a run");
    assert!(spec.in_flight && !spec.changes_duration());
}

#[test]
fn keys_of_a_plan_are_refused_in_one_message() {
    for (keys, named) in [
        ("late = \"extend\"\n", "`late` needs a clock in samples"),
        ("pace = \"soonest\"\nreserve = 0.1\n", "`pace`, `reserve` need a clock in samples"),
        (
            "in_flight = true\nlate = \"clip\"\nstate_max = 1\nreserve = 0.1\n",
            "`late`, `state_max`, `reserve` need a clock in samples",
        ),
    ] {
        let found = read(&format!("{CHAIN}{keys}")).expect_err(keys);
        let [one] = found.as_slice() else { panic!("{found:?}") };
        assert!(one.contains(named), "{one}");
        assert!(one.contains("nothing is known of u between two calls"), "{one}");
    }
}

#[test]
fn contracts_are_refused_with_the_reason() {
    let spec = read(&format!("{CHAIN}in_flight = true\n")).expect("a legal design");
    let found = ptc_codegen::generate_with_proof(&spec).expect_err("no contracts");
    let text: Vec<_> = found.iter().map(ToString::to_string).collect();
    assert!(text.join("\n").contains("changes in flight has no contracts yet"), "{text:?}");
}
